#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts hostile files of every format that `occlude` reads to the command that reads it, and measures what they cost.

Usage: hostile.py OCCLUDE [--files N] [--seed S] [--format NAME ...] [--jobs N] [--keep FOLDER] [--no-limits]

Something is wrong with a signal, an exit code other than 0, 1 and 2, an error that is not one line of printable text and
names the file, files left behind after an error, and more memory or time than stated. The file is kept then (--keep), and
the exit code is 1."""
import argparse
import concurrent.futures
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import ends
import formats

MIB = 1 << 20
# Whatever the file: the libraries that the command is linked with, and what culling a few hundred polygons needs.
FLOOR = 256 * MIB
# What docs/formats.md states: memory for each byte of an input, and the import library's own limits. For the library zeros and
# blanks do not count, and what a model refers to does.
JSON_FACTOR, MODEL_FACTOR = 60, 40
IMPORT_MEMORY, IMPORT_FACTOR = 256 * MIB, 128
# A run takes less, whatever the file: the import library's 20 s of processor time and 10 us a byte are the most that is
# stated of files as small as these. Others work on the same machine, so by the clock it is three times as much.
SECONDS = 90


def content_of(file):
    """The bytes that are neither zero nor blank. Holes are passed over."""
    content = 0
    with open(file, "rb") as data:
        end = data.seek(0, os.SEEK_END)
        at = 0
        while at < end:
            try:
                at = os.lseek(data.fileno(), at, os.SEEK_DATA)
            except OSError:  # nothing but a hole is left
                break
            data.seek(at)
            piece = data.read(MIB)
            content += len(piece.translate(None, b"\0\t\n\v\f\r "))
            at += len(piece)
    return content


def most_memory(name, folder):
    size = (folder / formats.FILES[name]).stat().st_size
    if name in formats.IMPORTED:
        # The library works in a process of its own; this one then holds the model.
        return FLOOR + IMPORT_MEMORY + IMPORT_FACTOR * sum(content_of(file) for file in folder.iterdir() if file.is_file())
    return FLOOR + (JSON_FACTOR if name in formats.JSON else MODEL_FACTOR) * size


def run(command, folder):
    """Exit code (negative: signal; None: no end), seconds, peak memory in bytes, and stderr. Not in the process that makes
    the files: a new process is counted with the memory of the one that started it."""
    with tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=errors)
        timer = threading.Timer(2 * SECONDS, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        is_over = not timer.is_alive()
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        return None if is_over else process.returncode, seconds, usage.ru_maxrss * 1024, errors.read(1 << 20)


def fault(name, kind, outcome, folder, with_limits):
    """What is wrong with how the command took the file, or nothing."""
    code, seconds, memory, errors = outcome
    if kind == formats.SOUND and code != 0:
        return "a sound file is refused"
    if wrong := ends.fault(code, 2 * SECONDS, errors):
        return wrong
    lines = errors.splitlines()
    # A damaged model or path has what is worth warnings.
    while lines and lines[0].startswith(b"occlude: warning: "):
        del lines[0]
    # What a check has found, exit code 1, may take a line for each kind.
    if len(lines) not in {0: (0,), 1: (0, 1, 2), 2: (1,)}[code]:
        return f"exit code {code} with {len(lines)} lines on stderr"
    if code == 2 and formats.FILES[name].encode() not in errors:
        return "an error that does not name the file"
    if code == 2 and b"std::" in errors:
        return "an error in the words of a library"
    if code == 2 and (folder / "out").exists():
        return "files left behind"
    if with_limits and memory > most_memory(name, folder):
        return f"{memory // MIB} MiB, where {most_memory(name, folder) // MIB} are the most"
    if with_limits and seconds > SECONDS:
        return f"{seconds:.1f} s"
    return None


class Trial:
    """All files of one format."""

    def __init__(self, name, arguments, seeds, scratch):
        self.name, self.arguments, self.scratch = name, arguments, scratch
        self.maker = formats.Maker(name, seeds, scratch, arguments.forger)
        self.codes, self.faults = {}, 0
        self.memory = self.seconds = (0, "")
        self.largest = 0

    def prepare(self, index):
        """The folder of a file, made: the same for the same seed, however many are asked for."""
        folder = self.scratch / f"{self.name}_{index}"
        folder.mkdir()
        if index == 0:  # that a sound file is taken shows that damage is met where it is
            (folder / formats.FILES[self.name]).write_bytes(self.maker.seeds[self.name][0])
            return folder, formats.SOUND
        random_numbers = random.Random(f"{self.arguments.seed} {self.name} {index}")
        kind = self.maker.write(random_numbers, folder / formats.FILES[self.name])
        return folder, kind

    def take(self, index, kind, folder, outcome):
        file = folder / formats.FILES[self.name]
        size = file.stat().st_size
        code, seconds, memory, errors = outcome
        self.codes[code] = self.codes.get(code, 0) + 1
        self.memory, self.seconds = max(self.memory, (memory, kind)), max(self.seconds, (seconds, kind))
        self.largest = max(self.largest, size)
        wrong = fault(self.name, kind, outcome, folder, not self.arguments.no_limits)
        if wrong:
            self.faults += 1
            print(f"{self.name} {index} ({kind}, {size} bytes): {wrong}\n    {errors[:300]!r}", flush=True)
            if self.arguments.keep:
                os.makedirs(self.arguments.keep, exist_ok=True)
                shutil.move(folder, pathlib.Path(self.arguments.keep) / folder.name.replace(" ", "_"))
                return
        shutil.rmtree(folder)

    def row(self):
        codes = " ".join(f"{code}:{count}" for code, count in sorted(self.codes.items(), key=str))
        return (f"| {self.name} | {self.largest / MIB:.1f} | {self.memory[0] / MIB:.0f} ({self.memory[1]}) | "
                f"{self.seconds[0]:.1f} ({self.seconds[1]}) | {codes} | {self.faults} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("occlude", help="the command")
    parser.add_argument("--files", type=int, default=1000, help="of each format (1000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--format", nargs="+", choices=formats.FILES, default=list(formats.FILES))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", help="folder for those that something is wrong with, each in one of its own")
    parser.add_argument("--forger", help="fuzz/harness/forged_stores (fuzz/forged_stores beside the command)")
    parser.add_argument("--no-limits", action="store_true",
                        help="no limits of memory and time, for builds that need more")
    arguments = parser.parse_args()
    occlude = os.path.abspath(arguments.occlude)
    arguments.forger = os.path.abspath(arguments.forger or os.path.join(os.path.dirname(occlude), "fuzz", "forged_stores"))
    print("| format | largest file, MiB | most memory, MiB | longest, s | exit codes: files | wrong |\n" + "|---" * 6 + "|")
    faults = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ProcessPoolExecutor(arguments.jobs) as runners:
        runners.submit(int).result()  # they start now, while this process is small
        scratch = pathlib.Path(folder)
        seeds = formats.make_seeds(occlude, scratch)
        for name in arguments.format:
            trial = Trial(name, arguments, seeds, scratch)
            waiting = {}
            for index in range(arguments.files + 1):
                place, kind = trial.prepare(index)
                command = [occlude, *formats.command(name, scratch)]
                waiting[runners.submit(run, command, place)] = index, kind, place
                if len(waiting) > arguments.jobs:
                    done, _ = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
                    for future in done:
                        trial.take(*waiting.pop(future), future.result())
            for future, about in waiting.items():
                trial.take(*about, future.result())
            print(trial.row(), flush=True)
            faults += trial.faults
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
