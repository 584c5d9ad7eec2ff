#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Forges the parts that `occlude --parts` keeps, and lets commands go on with them (--resume).

Usage: parts.py OCCLUDE [--files N] [--seed S] [--command NAME ...] [--forger NAME] [--keep FOLDER]

Two forge. A *stranger* may write where the parts are, but has not the key that seals them: whatever he writes is refused by name,
or changes nothing. The *user* has the key, and tries what stands behind the seal: what no run can have kept (numbers out of
range, counts that contradict each other, lists of other lengths, other kinds of files) is refused by name, and only a lie, which
some run could have kept, may be believed. Something is wrong with a signal, a report of a sanitizer, no end, an exit code
other than 0, 1 and 2, an error that is not one line of printable text and names the part, a file left behind, and another
answer than that of the honest run, unless the user lied. The folder is kept then (--keep), and the exit code is 1."""
import argparse
import hashlib
import json
import os
import pathlib
import random
import shutil
import socket
import struct
import subprocess
import sys
import tempfile

import ends

# No part takes longer to do again than seconds, and sanitizers and other work make it slower.
SECONDS = 120
SANITIZED = 99  # exit code of a sanitizer's report
MOST = 2**64 - 1
FORGERS = ["stranger", "user"]
EDGES = (0, 1, 2**31, 2**32 - 1, 2**32, 2**61, 2**63 - 1, 2**63, MOST - 1, MOST)


def seal(key, texts):
    """As render/parts' Seal."""
    data = b"".join(b"%016x" % len(text) + text for text in texts)
    return hashlib.blake2b(data, key=key, digest_size=32).hexdigest().encode()


class Forger:
    """Seals parts with the user's key, or as well as one can without."""

    def __init__(self, name, folder):
        self.is_user, self.key = name == "user", (folder / "state" / "occlude" / "parts.key").read_bytes()

    def sealed(self, numbers, name, head, job, result):
        """A part of this name with another result; `head` is the line before the true one, and `job` the file of that name."""
        of_input, honest = head.split()
        key = self.key if self.is_user else numbers.randbytes(32)
        made = seal(key, [job.split()[2], name.encode(), of_input, result])
        if not self.is_user:
            made = numbers.choice([made, made, honest, hashlib.blake2b(result, digest_size=32).hexdigest().encode(), b"", b"0" * 64])
        return of_input + b" " + made + b"\n" + result


class Part:
    """The result of a part as a list of fields [kind, name, value]."""

    def __init__(self, data):
        self.data, self.at, self.fields = data, 0, []

    def number(self, name, kind="u64"):
        layout = {"u8": "<B", "u32": "<I", "u64": "<Q", "f64": "<d"}[kind]
        value, = struct.unpack_from(layout, self.data, self.at)
        self.at += struct.calcsize(layout)
        self.fields.append([kind, name, value])
        return value

    def block(self, kind, name, size):
        """Bytes whose number stands before them; `size` is what the fields before say."""
        length, = struct.unpack_from("<Q", self.data, self.at)
        value = self.data[self.at + 8:self.at + 8 + length]
        self.at += 8 + length
        self.fields.append([kind, name, (size, value)])

    def text(self, name):
        self.block("text", name, None)

    def is_at_end(self):
        return self.at == len(self.data)


def encoded(fields):
    data = b""
    for kind, _, value in fields:
        if kind in ("u8", "u32", "u64", "f64"):
            data += struct.pack({"u8": "<B", "u32": "<I", "u64": "<Q", "f64": "<d"}[kind], value)
        elif kind == "raw":
            data += value
        else:
            size, content = value
            data += struct.pack("<Q", len(content) if size is None else size) + content
    return data


def read_proofs(part, _):
    while not part.is_at_end():
        is_unreadable = part.number("unreadable", "u8")
        part.text("fault")
        if not is_unreadable:
            for name in ("frame", "first", "count"):
                part.number(name)


COUNTS = ("frame", "in_view", "drawn", "visible", "false_culls", "hidden", "hidden_culled", "wrong_pixels")


def read_visibility(part, _):
    while not part.is_at_end():
        false_culls = [part.number(name) for name in COUNTS][COUNTS.index("false_culls")]
        part.number("shows")
        part.block("bits", "shown", None)
        for _ in range(min(false_culls, 64)):
            part.number("polygon", "u32")


def read_reasons(part, _):
    part.number("missed")
    for reason in range(10):
        part.number(f"reason {reason}")


TALLY = ("cases", "refused", "inside", "partial", "outside", "filter", "exact", "judged_twice", "lines", "disagreements", "asked",
         "undecided", "others_asked", "plain culls", "plain draws", "float32 culls", "float32 draws", "fused culls",
         "fused draws")


def read_reports(part, _):
    while not part.is_at_end():
        for name in TALLY:
            part.number(name)
        part.number("seconds", "f64")
        for _ in range(part.number("findings")):
            for name in ("kind", "what", "expect", "family"):
                part.text(name)
            part.number("seed")
            part.text("question")


def read_hidden(part, _):
    part.block("floats", "hidden", None)


def read_sets(part, _):
    while not part.is_at_end():
        part.block("changes", "items", None)
        part.block("changes", "cells", None)


class Command:
    """A command that keeps parts: how each stage packs its results, and what no run can have kept."""

    def __init__(self, arguments, stages, frames=0, polygons=0, triangles=0):
        self.arguments, self.stages = arguments, stages
        self.frames, self.polygons, self.triangles = frames, polygons, triangles


def commands():
    proofs = [read_proofs, read_visibility]
    walls = {"frames": 4, "polygons": 64, "triangles": 128}
    model = ["model.ply", "--path", "path.json", "--json"]
    return {
        "validate anew": Command(["validate", *model], [*proofs, read_reasons], **walls),
        "validate rendered": Command(["validate", *model, "--exact-up-to", "0", "--size", "32x18"],
                                     [*proofs, read_reasons], **walls),
        "validate by cover": Command(["validate", *model, "--method", "cover"], [*proofs, read_reasons], **walls),
        "validate a file": Command(["validate", *model, "--witness", "witness.jsonl"], proofs, **walls),
        "validate a lie": Command(["validate", *model, "--witness", "lie.jsonl"], proofs, **walls),
        "fuzz": Command(["fuzz", "--cases", "64", "--family", "lattice", "--family", "culler", "--seed", "5", "--json",
                         "--findings", "", "--jobs", "1"], [read_reports]),
        "bake": Command(["bake", "model.ply", "--cells", "cells.json", "--quiet"], [read_sets]),
        "preprocess": Command(["preprocess", "model.ply", "--samples", "1", "--region-count", "8", "--quiet"],
                              [read_hidden], polygons=64),
    }


def run(occlude, arguments, folder, timeout=SECONDS):
    """Exit code (negative: signal; None: no end), stdout and stderr."""
    environment = dict(os.environ, XDG_STATE_HOME=str(folder / "state"), ASAN_OPTIONS=f"exitcode={SANITIZED}:detect_leaks=0:allocator_may_return_null=0",
                       UBSAN_OPTIONS=f"exitcode={SANITIZED}:halt_on_error=1:print_stacktrace=1")
    try:
        done = subprocess.run([occlude, *arguments], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=timeout, env=environment, check=False)
    except subprocess.TimeoutExpired:
        return None, b"", b""
    return done.returncode, done.stdout, done.stderr


def write_inputs(occlude, folder):
    """A wall, 63 squares behind it, and a path towards them; the witnesses of a walk, and one that is not true."""
    vertices = "".join(f"{2 + i} {y} {z}\n" for i in range(64) for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    faces = "".join(f"4 {4 * i} {4 * i + 1} {4 * i + 2} {4 * i + 3}\n" for i in range(64))
    (folder / "model.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 256\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face 64\nproperty list uchar int vertex_indices\nend_header\n{vertices}{faces}")
    (folder / "path.json").write_text('{"frames":4,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},'
                                      '{"eye":[0.5,0,0],"target":[1.5,0,0]}]}')
    (folder / "cells.json").write_text(json.dumps({"cells": [{"min": [x, 0, 0], "max": [x + 0.5, 0.5, 0.5]} for x in range(40)]}))
    arguments = ["walk", "model.ply", "--path", "path.json", "--no-render", "--out", "walked", "--witness", "witness.jsonl",
                 "--quiet"]
    code, _, errors = run(occlude, arguments, folder)
    if code != 0:
        sys.exit(f"walk: {code} {errors!r}")
    lines = (folder / "witness.jsonl").read_text().splitlines(True)
    lines[1] = lines[1].replace('"triangles":[', '"triangles":[0,1],"was":[', 1)
    (folder / "lie.jsonl").write_text("".join(lines))
    shutil.rmtree(folder / "walked")


def answer(outcome, folder):
    """What must not change: the exit code, what is printed, and the file that is written; not times."""
    code, out, errors = outcome
    lines = [line for line in out.splitlines() if b"seconds" not in line]
    store = folder / "out.pre"
    return code, lines, errors, store.read_bytes() if store.exists() else None


def with_output(command, name):
    return [*command.arguments, "--out", name] if command.arguments[0] in ("bake", "preprocess") else command.arguments


def keep_all(occlude, command, folder):
    """The folder of all parts of a run that could not write its results."""
    shutil.rmtree(folder / "kept", ignore_errors=True)
    with open("/dev/full", "wb") as full:
        done = subprocess.run([occlude, *with_output(command, "/dev/full"), "--parts", "kept"], cwd=folder, stdout=full,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False,
                              env=dict(os.environ, XDG_STATE_HOME=str(folder / "state")))
    if b"No space left on device" not in done.stderr:
        sys.exit(f"no parts are kept of {command.arguments}: {done.stderr!r}")
    return {file.name: file.read_bytes() for file in (folder / "kept").iterdir()}


def impossible_numbers(command, kind, name, value):
    """Values of a field that no run can have kept."""
    if kind == "u8":
        return [2, 255]
    if kind == "f64":
        return [float("nan"), float("inf"), -1.0]
    if kind == "u32":
        return [command.polygons, 2**32 - 1]
    if name == "frame":
        return [command.frames, *EDGES[2:]]
    if name in ("first", "count"):
        return [command.triangles + 1, *EDGES[2:]]
    if name in COUNTS or name == "missed" or name.startswith("reason"):
        return [command.polygons + 1, *EDGES[2:]]
    if name == "shows":
        return [value + 1, value + 8, *EDGES[1:]]
    if name == "findings":
        return [value + 1, 4, *EDGES[2:]]
    if name in TALLY:
        return EDGES[4:]
    return []


def blocks(field):
    kind, _, (_, content) = field
    result = [(size, content) for size in (len(content) + 1, *EDGES[3:])]
    if kind == "floats":
        numbers = [struct.pack("<f", x) for x in (float("nan"), float("inf"), -1, 65)]
        result += [(None, content[:-4] + number) for number in numbers]
        result += [(None, content + b"\0" * 4), (None, content[:-4]), (None, content[:-1])]
    if kind == "changes":  # more than there are, not ascending, without an end
        numbers = [struct.pack("<2I", *x) for x in ((0, 2**32 - 1), (5, 5), (7, 3))]
        result += [(None, number) for number in numbers] + [(None, content[:-4]), (None, content[:-1])]
    if kind == "bits":
        result += [(None, content + b"\0"), (None, content[:-1])] if content else [(None, b"\0")]
    return result


FINDING = [["text", "kind", (None, b"overlap")], ["text", "what", (None, b"\x1b]0;owned\x07\x1b[2J\r\n" + b"\xff" * 5)],
           ["text", "expect", (None, b"inside")], ["text", "family", (None, b"lattice")], ["u64", "seed", 5],
           ["text", "question", (None, b"")]]


def finding_with(**changes):
    return [[kind, name, changes.get(name, value)] for kind, name, value in FINDING]


def with_finding(fields, finding):
    """The reports with a finding in the first of them."""
    at = next(i for i, field in enumerate(fields) if field[1] == "findings")
    changed = [list(field) for field in fields]
    changed[at][2] = 1
    for field in changed[:at]:
        if field[1] == "disagreements":
            field[2] = 1
    return changed[:at + 1] + finding + changed[at + 1:]


def impossible(numbers, command, fields, reader):
    """Fields that no run can have kept."""
    kinds = ["value", "value", "value", "cut", "repeat", "more", "drop"]
    if reader is read_reports:
        kinds += ["finding", "contradiction"]
    if reader in (read_visibility, read_reasons):
        kinds += ["contradiction"]
    if reader is read_proofs:
        kinds += ["no reason"]
    kind = numbers.choice(kinds)
    changed = [list(field) for field in fields]
    at = numbers.randrange(len(changed))
    if kind == "value":
        field = changed[at]
        if field[0] in ("text", "bits", "changes", "floats"):
            field[2] = numbers.choice(blocks(field))
        else:
            field[2] = numbers.choice(impossible_numbers(command, *field))
        return f"{kind} of {field[1]}", encoded(changed)
    if kind == "cut":
        data = encoded(changed)
        return kind, data[:numbers.randrange(len(data))]
    if kind == "repeat":
        return kind, encoded(changed) + encoded(changed[:numbers.randrange(1, len(changed) + 1)])
    if kind == "more":
        return kind, encoded(changed) + bytes(numbers.randrange(256) for _ in range(numbers.choice((1, 7, 8, 1000))))
    if kind == "drop":
        del changed[at]
        return kind, encoded(changed)
    if kind == "finding":
        wrong = numbers.choice([{"family": (None, b"other")}, {"family": (None, b"\x1b[2J")}, {"seed": 5 + 2**32},
                                {"question": (None, b"{")}, {"question": (None, b'{"eye":[0,0,0]}')},
                                {"question": (None, b"[" * 100000)}, {"question": (2**62, b"{}")},
                                {"what": (MOST, b"what")}])
        return f"finding with {next(iter(wrong))}", encoded(with_finding(changed, finding_with(**wrong)))
    if kind == "no reason":
        at = next(i for i, field in enumerate(changed) if field[1] == "unreadable")
        return kind, encoded(changed[:at] + [["u8", "unreadable", 1], ["text", "fault", (None, b"")]])
    return contradiction(numbers, changed)


def contradiction(numbers, changed):
    """Counts of which each is possible, but not all together."""
    by_name = {}
    for field in changed:
        by_name.setdefault(field[1], field)
    if "visible" in by_name:
        name, value = numbers.choice([("hidden", by_name["in_view"][2] + 1), ("hidden_culled", by_name["hidden"][2] + 1),
                                      ("false_culls", by_name["visible"][2] + 1), ("wrong_pixels", 1),
                                      ("drawn", 0), ("in_view", 0)])
    elif "missed" in by_name:
        name, value = numbers.choice([("missed", 64), ("reason 0", by_name["missed"][2] + 1)])
    else:
        name, value = numbers.choice([("refused", by_name["cases"][2] + 1), ("cases", 0), ("disagreements", 1),
                                      ("undecided", by_name["asked"][2] + 1),
                                      ("plain culls", by_name["others_asked"][2] + 1)])
    if by_name[name][2] == value:
        value = MOST
    by_name[name][2] = value
    return f"contradiction of {name}", encoded(changed)


def lie(numbers, fields):
    """Bytes of which nothing is known but that they are not those that were kept."""
    changed = [list(field) for field in fields]
    at = numbers.randrange(len(changed))
    if numbers.random() < 0.5 and changed[at][0] in ("u8", "u32", "u64"):
        most = {"u8": 255, "u32": 2**32 - 1, "u64": MOST}[changed[at][0]]
        changed[at][2] = min(most, max(0, changed[at][2] + numbers.choice((-1, 1, 2))))
        return encoded(changed)
    if numbers.random() < 0.5 and any(field[1] == "findings" for field in fields):
        return encoded(with_finding(changed, finding_with()))
    if numbers.random() < 0.5 and changed[at][1] == "fault":
        changed[at][2] = (None, b"\x1b]0;owned\x07\x1b[2J\r\n\0" + bytes(numbers.randrange(256) for _ in range(20)))
        return encoded(changed)
    data = bytearray(encoded(fields))
    for _ in range(numbers.choice((1, 1, 8, 100))):
        data[numbers.randrange(len(data))] = numbers.randrange(256)
    return bytes(data)


def damage(numbers, data):
    changed = bytearray(data)
    kind = numbers.choice(("bit", "cut", "more", "empty", "head"))
    if kind == "bit":
        at = numbers.randrange(len(changed))
        changed[at] ^= 1 << numbers.randrange(8)
    elif kind == "cut":
        del changed[numbers.randrange(len(changed)):]
    elif kind == "more":
        changed += b"\n\0"
    elif kind == "empty":
        changed.clear()
    else:
        changed[:34] = bytes(numbers.choice(b"0123456789abcdef \n") for _ in range(34))
    return bytes(changed)


def other_file(numbers, file):
    """Something else than a regular file of a few bytes. The sockets and pipes have nobody at their other end."""
    kind = numbers.choice(("folder", "pipe", "device", "nothing", "itself", "huge", "socket"))
    file.unlink()
    if kind == "folder":
        file.mkdir()
    elif kind == "pipe":
        os.mkfifo(file)
    elif kind == "device":
        file.symlink_to("/dev/zero")
    elif kind == "nothing":
        file.symlink_to("missing")
    elif kind == "itself":
        file.symlink_to(file.name)
    elif kind == "huge":
        with open(file, "wb") as made:
            made.truncate(numbers.choice((257 << 20, 3 << 30, 5 << 30)))
    else:
        here = os.getcwd()
        os.chdir(file.parent)  # the name of a socket is short
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(file.name)
        os.chdir(here)
    return f"a {kind} as a file"


def write_parts(kept, folder):
    folder.mkdir()
    for name, data in kept.items():
        (folder / name).write_bytes(data)


def forge(numbers, forger, command, kept, folder):
    """Writes the parts, one of them forged. Returns what was done, and whether it is a lie that may be believed."""
    write_parts(kept, folder)
    kind = numbers.choices(("impossible", "lie", "damage", "other file", "job", "exchange"), (60, 15, 8, 8, 3, 6))[0]
    names = [name for name in kept if name.startswith("part-")]
    name = numbers.choice(names)
    stage = int(name.split("-")[1])
    head, _, result = kept[name].partition(b"\n")
    if kind == "other file":
        name = numbers.choice(list(kept))
        return f"{name}: {other_file(numbers, folder / name)}", False
    if kind == "damage":
        (folder / name).write_bytes(damage(numbers, kept[name]))
        return f"{name}: damage", False
    if kind == "job":
        (folder / "job").write_bytes(damage(numbers, kept["job"]) if numbers.random() < 0.7 else b"\x1b[2J" * 10)
        return "job: damage", False
    if kind == "exchange":  # with the result of another part; of the same stage it may be a lie
        other = numbers.choice(names)
        forged, what, is_lie = kept[other].partition(b"\n")[2], f"that of {other}", other.split("-")[1] == name.split("-")[1]
    else:
        part = Part(result)
        command.stages[stage](part, command)
        if not part.fields:
            forged, what, is_lie = b"\0", "a byte", False
        elif kind == "lie":
            forged, what, is_lie = lie(numbers, part.fields), "a lie", True
        else:
            what, forged = impossible(numbers, command, part.fields, command.stages[stage])
            is_lie = False
    (folder / name).write_bytes(forger.sealed(numbers, name, head, kept["job"], forged))
    return f"{name}: {what}", forger.is_user and is_lie


def is_refused(outcome):
    """Whether the last line is an error. What a check has found before stands, and so does its exit code."""
    code, _, errors = outcome
    lines = errors.splitlines()
    return code in (1, 2) and len(lines) == (1 if code == 2 else 2) and lines[-1].startswith(b"occlude: ")


def fault(outcome, is_lie, is_same, folder):
    """What is wrong with how the command took the parts, or nothing."""
    code, out, errors = outcome
    if code == SANITIZED or b"Sanitizer" in errors or b"runtime error" in errors:
        return "a report of a sanitizer"
    if wrong := ends.fault(code, SECONDS, errors, out):
        return wrong
    if is_refused(outcome):
        if b"occlude: kept" not in errors and not is_lie:
            return "an error that does not name the part"
        if any(name.startswith(".occlude") or name == "out.pre" for name in os.listdir(folder)):
            return "files left behind"
    elif code == 2:
        return "not one line"
    elif not is_same and not is_lie:
        return "another answer, and no word about it"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("occlude", help="the command")
    parser.add_argument("--files", type=int, default=300, help="of each command and forger (300)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--forger", nargs="+", choices=FORGERS, default=FORGERS)
    parser.add_argument("--command", nargs="+", choices=commands(), default=list(commands()))
    parser.add_argument("--keep", help="folder for what something is wrong with")
    arguments = parser.parse_args()
    occlude = os.path.abspath(arguments.occlude)
    print("| command | forger | forged | refused | the same answer | a lie believed | wrong |\n" + "|---" * 7 + "|")
    faults = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        write_inputs(occlude, folder)
        for name in arguments.command:
            faults += try_command(arguments, occlude, name, folder)
    return 1 if faults else 0


def try_command(arguments, occlude, name, folder):
    """Forges parts of a command, prints what came of it, and returns with how many something was wrong."""
    command = commands()[name]
    (folder / "out.pre").unlink(missing_ok=True)
    kept = keep_all(occlude, command, folder)
    honest = answer(run(occlude, with_output(command, "out.pre"), folder), folder)
    go_on = [*with_output(command, "out.pre"), "--parts", "kept", "--resume"]
    if answer(run(occlude, go_on, folder), folder) != honest:
        sys.exit(f"{name}: it does not go on with its own parts")
    faults = 0
    for forger in arguments.forger:
        row = {"refused": 0, "same": 0, "lie": 0, "wrong": 0}
        for index in range(arguments.files):
            shutil.rmtree(folder / "kept", ignore_errors=True)
            (folder / "out.pre").unlink(missing_ok=True)
            numbers = random.Random(f"{arguments.seed} {forger} {name} {index}")
            what, is_lie = forge(numbers, Forger(forger, folder), command, kept, folder / "kept")
            shutil.copytree(folder / "kept", folder / "forged", symlinks=True, ignore_dangling_symlinks=True,
                            ignore=lambda place, names: [n for n in names if not is_plain(place, n)])
            outcome = run(occlude, go_on, folder)
            is_same = answer(outcome, folder) == honest
            wrong = fault(outcome, is_lie, is_same, folder)
            row["wrong" if wrong else "same" if is_same else "refused" if is_refused(outcome) else "lie"] += 1
            if wrong:
                print(f"{name} {forger} {index} ({what}): {wrong}\n    {outcome[2][:400]!r}", flush=True)
                if arguments.keep:
                    place = pathlib.Path(arguments.keep) / f"{name} {forger} {index}"
                    shutil.copytree(folder / "forged", place, dirs_exist_ok=True)
            shutil.rmtree(folder / "forged")
        print("|", " | ".join(map(str, (name, forger, arguments.files, *row.values()))), "|", flush=True)
        faults += row["wrong"]
    return faults


def is_plain(place, name):
    """Whether a file may be copied: it is regular and not huge."""
    file = pathlib.Path(place) / name
    return file.is_file() and not file.is_symlink() and file.stat().st_size < 1 << 20


if __name__ == "__main__":
    sys.exit(main())
