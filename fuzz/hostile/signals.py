#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sends signals to every command of `occlude` at random times, and looks at how it ends.

Usage: signals.py OCCLUDE [--trials N] [--seed S] [--command NAME ...] [--jobs N] [--seconds S]

Something is wrong with an exit code that is not that of the signal or of what was done, an end later than stated, more or
less than one line on stderr, temporary files and processes left behind, and outputs that are neither those of the run nor
those of an earlier one. The exit code is 1 then."""
import argparse
import collections
import concurrent.futures
import fcntl
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import formats

# The arguments of each command, and the outputs that an earlier run has left. All is small, so that the signals reach every
# step of the work.
COMMANDS = {
    "generate city": ("--polygons 20000 --out city.ply --path city.json", "city.ply city.json"),
    "preprocess": ("{city} --region-count 64 --out city.store --inner-boxes boxes.ply --occluders few.ply",
                   "city.store boxes.ply few.ply"),
    "walk": ("{walls} --path {path} --frames 0:8 --size 64x36 --out out --witness out/witness.jsonl",
             "out/summary.json out/frames.csv out/report.html out/witness.jsonl"),
    "render": ("{walls} --path {path} --frames 0:8 --size 64x36 --out walls.png", "walls.png"),
    "inspect": ("{city} --page {page} --out city.html", "city.html"),
    "compare": ("{walked} {walked} --out compared.html", "compared.html"),
    "why": ("{walls} --path {path} --frame 8 --polygon 7 --size 64x36 --out out", "out/why.json out/view.png"),
    "classify": ("{cases}", ""),
    "validate": ("{walls} --path {path} --size 64x36 --exact-up-to 0 --out out", "out/failures.jsonl"),
    "validate --witness": ("{walls} --path {path} --size 64x36 --witness {walked}/witness.jsonl", ""),
    "audit": ("{walls} --log {walked}/log.jsonl --out out", "out/summary.json out/frames.jsonl out/false_culls.jsonl"),
    "bake": ("{walls} --cells grid --cell-size 2 --out walls.pvs --map walls.png", "walls.pvs walls.png"),
    "fuzz": ("--cases 1000 --findings found.jsonl --out fuzz.json", "fuzz.json"),
    "bench kernel": ("--boxes 256 --repetitions 2", ""),
    "bench culler": ("{walls} --path {path} --frames 0:8 --size 64x36 --region-count 64 --repetitions 1 --out out",
                     "out/culler.json out/culler.html"),
    "bench scene": ("--objects 2000 --streamed 1000 --moving 100 --moving-occluders 10 --frames 20 --settling 4 "
                    "--check-every 4", ""),
    "bench town": ("--houses 2000 --walls 1800 --repetitions 3 --frames 50", ""),
    "bench rivals": ("{walls} --path {path} --frames 0:8 --size 64x36 --leaf 1 --rays 32x18 --repetitions 3 --out out",
                     "out/rivals.json out/rivals.html"),
    "bench all": ("{walls} --path {path} --frames 0:1 --size 64x36 --quick --out out", "out/bench.json out/bench.html"),
    "help": ("--man", ""),
}
EARLIER = b"of an earlier run\n"
# What ends a command, and what it does not heed.
ENDING = ("SIGINT", "SIGTERM", "SIGHUP", "SIGXCPU")
IGNORED = ("SIGPIPE", "SIGXFSZ")
# Nobody reads standard output any more, or does not read and SIGINT comes.
CLOSED, STALLED = "closed", "stalled"
KINDS = 4 * ENDING + 2 * IGNORED + 4 * (CLOSED, STALLED)
DONE, BAD, INTERRUPTED = 0, 2, 130
# Far more than any of the commands takes.
END = 300


def make_inputs(occlude, folder):
    """A wall and a row of squares behind it, and what other commands make of them."""
    def run(*words):
        subprocess.run([occlude, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)

    (folder / "walls.ply").write_bytes(formats.ply_ascii())
    (folder / "path.json").write_text(json.dumps({**formats.PATH, "frames": 40}))
    run("generate", "city", "--polygons", "20000", "--out", "city.ply", "--path", "city.json")
    run("walk", "walls.ply", "--path", "path.json", "--size", "64x36", "--out", "walked", "--witness",
        "walked/witness.jsonl", "--log", "walked/log.jsonl")
    case = ('{"id":"%d","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"near":"surface",'
            '"box":{"min":[4,2,0],"max":[4,3,1]}}\n')
    (folder / "cases.jsonl").write_text("".join(case % i for i in range(5000)))
    (folder / "page.html").write_text("<!-- The model of `occlude inspect` -->\n")
    return {"city": folder / "city.ply", "walls": folder / "walls.ply", "path": folder / "path.json",
            "walked": folder / "walked", "cases": folder / "cases.jsonl", "page": folder / "page.html"}


def is_handled(pid, number):
    """Whether the process has done something about the signal. Before that the system ends it."""
    handled = 0
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith(("SigCgt:", "SigIgn:")):
            handled |= int(line.split()[1], 16)
    return handled >> number - 1 & 1 != 0


def session_of(pid):
    """The processes that run in the session of this one."""
    members = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[3]) == pid and fields[0] != "Z":
            members.append(int(stat.parent.name))
    return members


def files_in(folder):
    """The files and their sizes."""
    return {str(file.relative_to(folder)): file.stat().st_size for file in folder.rglob("*") if file.is_file()}


def standard_output(kind):
    """Where it is read, if that is a pipe, and where it is written."""
    if kind not in (CLOSED, STALLED):
        return None, os.open(os.devnull, os.O_WRONLY)
    reader, writer = os.pipe()
    if kind == STALLED:
        os.write(writer, bytes(fcntl.fcntl(writer, fcntl.F_SETPIPE_SZ, 4096)))  # it is full
    return reader, writer


def number_of(kind):
    return signal.SIGINT if kind == STALLED else signal.Signals[kind]


class Trial:
    """What came of a command."""

    def __init__(self, command, earlier, kind, seconds):
        self.kind = kind
        self.was_ready = True
        self.was_over = False
        with tempfile.TemporaryDirectory() as name, tempfile.TemporaryFile() as errors:
            folder = pathlib.Path(name)
            for file in earlier:
                (folder / file).parent.mkdir(exist_ok=True)
                (folder / file).write_bytes(EARLIER)
            reader, writer = standard_output(kind)
            process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=writer, stderr=errors,
                                       start_new_session=True)
            os.close(writer)
            self.disturb(process, reader, seconds)
            if kind == STALLED:
                os.close(reader)
            self.left = self.leave_none(process.pid)
            errors.seek(0)
            self.errors = errors.read(1 << 16)
            self.files = files_in(folder)
        self.code = process.returncode

    def disturb(self, process, reader, seconds):
        started = time.monotonic()
        try:
            process.wait(seconds)
            self.was_over = True
        except subprocess.TimeoutExpired:
            if self.kind != CLOSED:
                number = number_of(self.kind)
                self.was_ready = is_handled(process.pid, number)
                process.send_signal(number)
        if self.kind == CLOSED:
            os.close(reader)
        sent = time.monotonic()
        try:
            process.wait(END)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        self.seconds = time.monotonic() - sent
        self.all_seconds = time.monotonic() - started

    @staticmethod
    def leave_none(pid):
        """Ends the processes that the command has left, and returns how many there were after a second."""
        deadline = time.monotonic() + 1
        while session_of(pid) and time.monotonic() < deadline:
            time.sleep(0.01)
        left = session_of(pid)
        for member in left:
            os.kill(member, signal.SIGKILL)
        return len(left)


def fault(trial, whole, earlier, most_seconds):
    """What is wrong, in a word that the table counts and in more; nothing if nothing is."""
    is_old = trial.files == dict.fromkeys(earlier, len(EARLIER))
    # Measured times do not make a file half as long.
    is_new = trial.files.keys() == whole.files.keys() and all(
        2 * size >= whole.files[file] and (size == len(EARLIER)) == (whole.files[file] == len(EARLIER))
        for file, size in trial.files.items())
    if trial.left:
        return "left", f"{trial.left} processes left"
    if not is_old and not is_new:
        return "left", f"files left: {sorted(trial.files)}"
    if not trial.was_ready:  # the system has ended it, unless it became ready just then
        if trial.code == -number_of(trial.kind) and is_old:
            return None
    allowed = {DONE}
    if not trial.was_over and trial.kind in (*ENDING, STALLED):
        allowed.add(INTERRUPTED)
        if trial.seconds > most_seconds and trial.code == INTERRUPTED:
            return "late", f"{trial.seconds:.1f} s"
    if not trial.was_over and trial.kind == CLOSED:
        allowed.add(BAD)
    if trial.code not in allowed:
        return "code", f"exit code {trial.code}"
    lines = len(trial.errors.splitlines())
    if lines != (0 if trial.code == DONE else 1):
        return "code", f"exit code {trial.code} with {lines} lines on stderr"
    # Outputs come first; then there may be nobody to print to.
    if trial.code == DONE and not is_new or trial.code == INTERRUPTED and not is_old and trial.kind != STALLED:
        return "left", f"exit code {trial.code} with the outputs of {'the earlier' if is_old else 'this'} run"
    return None


def try_command(arguments, occlude, name, inputs, runners):
    words, earlier = COMMANDS[name]
    command = [occlude, *name.removesuffix(" --witness").split(),
               *(word.format(**inputs) for word in words.split())]
    earlier = earlier.split()
    whole = Trial(command, earlier, "SIGPIPE", END)
    if whole.code != DONE or whole.errors:
        sys.exit(f"{name}: exit code {whole.code}: {whole.errors.decode(errors='replace')}")

    def one(index):
        random_numbers = random.Random(f"{arguments.seed} {name} {index}")
        kind = random_numbers.choice(KINDS)
        seconds = random_numbers.uniform(0, 1.1) * whole.all_seconds
        trial = Trial(command, earlier, kind, seconds)
        return kind, seconds, trial, fault(trial, whole, earlier, arguments.seconds)

    counts, codes, slowest = collections.Counter(), collections.Counter(), 0
    for index, (kind, seconds, trial, wrong) in enumerate(runners.map(one, range(arguments.trials))):
        if trial.kind in (*ENDING, STALLED) and not trial.was_over:
            slowest = max(slowest, trial.seconds)
        if not trial.was_ready:
            counts["early"] += 1
        codes[trial.code] += 1
        if wrong:
            counts[wrong[0]] += 1
            print(f"{name} {index} ({kind} after {seconds:.3f} s): {wrong[1]}\n    {trial.errors[:300]!r}", flush=True)
    ended = " ".join(f"{code}:{count}" for code, count in sorted(codes.items()))
    print(f"| {name} | {whole.all_seconds:.1f} | {arguments.trials} | {ended} | {counts['early']} | {slowest:.1f} | "
          f"{counts['code']} | {counts['late']} | {counts['left']} |", flush=True)
    return counts["code"] + counts["late"] + counts["left"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("occlude", help="the command")
    parser.add_argument("--trials", type=int, default=500, help="of each command (500)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--command", nargs="+", choices=COMMANDS, default=list(COMMANDS))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=2, help="in which a signal must end a command (2)")
    arguments = parser.parse_args()
    for kind in ENDING:  # nohup, or a shell that starts this in the background, may have it ignored, by the commands too
        signal.signal(signal.Signals[kind], signal.SIG_DFL)
    occlude = os.path.abspath(arguments.occlude)
    print("| command | takes, s | trials | exit codes: trials | before main() | slowest end, s | wrong code | late | "
          "left behind |\n" + "|---" * 9 + "|")
    faults = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as runners:
        inputs = make_inputs(occlude, pathlib.Path(folder))
        for name in arguments.command:
            faults += try_command(arguments, occlude, name, inputs, runners)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
