#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ends ranks and mpirun at random times while `occlude` works on several processes, and goes on with what was kept.

Usage: kills.py OCCLUDE [--trials N] [--seed S] [--ranks N] [--seconds T]

Something is wrong with a rank that still runs T seconds later, an exit code that is not that of the end, a temporary file
or a part of a result left behind, a finished part that is lost, and another result when the command goes on (--resume). The
exit code is 1 then; it is 77 where there are no ranks."""
import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ALLOW = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
MARK = "OCCLUDE_TRIAL"  # in the environment of every process of a trial
# What mpirun itself does after a signal takes a second: it asks its ranks to end, and then ends them.
SIGNALS = {"SIGKILL": signal.SIGKILL, "SIGTERM": signal.SIGTERM, "SIGINT": signal.SIGINT}
# Once its ranks have ended, mpirun 4.1 now and then waits for ever for itself (in PMIx_server_finalize), or crashes.
OWN_FAULTS = (None, -signal.SIGSEGV)
VICTIMS = ("mpirun", "first rank", "helper")


def commands(city):
    """The arguments of each command, and the file that it writes."""
    return {
        "fuzz": (["fuzz", "--family", "lattice", "--cases", "400000", "--jobs", "1", "--findings", "", "--out", "result"],
                 "result"),
        "validate": (["validate", city, "--path", city + ".json", "--frames", "0:200:10", "--size", "160x90", "--json"], ""),
        "bake": (["bake", city, "--cells", "corridor", "--path", city + ".json", "--cell-size", "60", "--piece", "60",
                  "--reach", "0", "--heights", "1:3", "--out", "result", "--quiet"], "result"),
        "preprocess": (["preprocess", city, "--out", "result", "--region-count", "64", "--samples", "2", "--quiet"],
                       "result"),
    }


def environment_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
    except OSError:
        return []


def is_running(process):
    """Whether a process lives. One that nobody has waited for yet does not."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def processes_of(mark):
    wanted = f"{MARK}={mark}".encode()
    return [int(name) for name in os.listdir("/proc")
            if name.isdigit() and wanted in environment_of(name) and is_running(name)]


def rank_of(process):
    ranks = [word for word in environment_of(process) if word.startswith(b"OMPI_COMM_WORLD_RANK=")]
    return int(ranks[0].partition(b"=")[2]) if ranks else None


def ranks_of(mark):
    return [process for process in processes_of(mark) if rank_of(process) is not None]


def end_of(mpirun):
    """Its exit code, and None where it does not end. It takes its own time."""
    try:
        return mpirun.wait(60)
    except subprocess.TimeoutExpired:
        mpirun.kill()
        mpirun.wait()
        return None


def result_of(folder, out, file):
    """What a command has written, without times."""
    content = (folder / file).read_bytes() if file else out
    return [line for line in content.split(b"\n") if b"seconds" not in line]


def parts_of(folder):
    kept = list(folder.glob("occlude_*_parts"))
    return {file.name for file in kept[0].glob("part-*")} if kept else set()


class Trial:
    def __init__(self, arguments, occlude, command, file, honest, scratch):
        self.arguments, self.occlude, self.command, self.file = arguments, occlude, command, file
        self.honest, self.scratch = honest, scratch

    def run(self, index, numbers, victim, name, length):
        """What went wrong, seconds until all ranks had ended, and the exit code of mpirun."""
        folder = self.scratch / f"trial_{index}"
        folder.mkdir()
        (folder / "tmp").mkdir()
        mark = f"{os.getpid()}.{index}"
        environment = dict(os.environ, **ALLOW, **{MARK: mark, "TMPDIR": str(folder / "tmp")})
        with open(folder / "tmp" / "out", "wb") as out, open(folder / "tmp" / "errors", "wb") as errors:
            mpirun = subprocess.Popen(["mpirun", "--oversubscribe", "-n", str(self.arguments.ranks), self.occlude,
                                       *self.command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=out,
                                      stderr=errors, start_new_session=True)
        # One in three in the first moments: before, while and after MPI is initialised.
        time.sleep(numbers.uniform(0, 0.6) if numbers.random() < 0.33 else numbers.uniform(0, length))
        process = self.find(mpirun, mark, victim, numbers)
        before = parts_of(folder)
        if process is not None:
            os.kill(process, SIGNALS[name])
        seconds, late = self.wait_for_ranks(mark)
        for process in ranks_of(mark):
            os.kill(process, signal.SIGKILL)
        code = end_of(mpirun)
        faults = [late] if late else []
        faults += self.faults(folder, before, code, victim, name)
        if not faults:
            shutil.rmtree(folder)
        return faults, seconds, code

    def find(self, mpirun, mark, victim, numbers):
        """The process to be ended; none if all are done."""
        wanted = 0 if victim == "first rank" else numbers.randrange(1, self.arguments.ranks)
        while mpirun.poll() is None:
            if victim == "mpirun":
                return mpirun.pid
            for process in processes_of(mark):
                if rank_of(process) == wanted:
                    return process
            time.sleep(0.01)
        return None

    def wait_for_ranks(self, mark):
        """The seconds that it takes, and what still runs when the time is over."""
        begun = time.monotonic()
        while running := ranks_of(mark):
            seconds = time.monotonic() - begun
            if seconds > self.arguments.seconds:
                return seconds, "still running: " + ", ".join(f"rank {rank_of(process)}" for process in running)
            time.sleep(0.02)
        return time.monotonic() - begun, None

    def faults(self, folder, before, code, victim, name):
        faults = []
        if code not in OWN_FAULTS + expected_codes(victim, name):
            errors = (folder / "tmp" / "errors").read_text(errors="replace")
            faults.append(f"exit code {code}: {errors[-500:]!r}")
        left = [file for file in folder.rglob(".occlude.tmp*")]
        if left:
            faults.append(f"left behind: {', '.join(file.name for file in left)}")
        out = (folder / "tmp" / "out").read_bytes()
        is_done = (folder / self.file).exists() if self.file else code == 0
        if is_done and result_of(folder, out, self.file) != self.honest:
            faults.append("another result")
        if not is_done and code == 0:
            faults.append("no result, and exit code 0")
        if not is_done and not before <= parts_of(folder):
            faults.append("a finished part is lost")
        if parts_of(folder):
            faults += self.resume(folder)
        return faults

    def resume(self, folder):
        done = subprocess.run([self.occlude, *self.command, "--resume"], cwd=folder, capture_output=True, check=False)
        if done.returncode != 0:
            return [f"--resume: exit code {done.returncode}: {done.stderr.decode(errors='replace')}"]
        if result_of(folder, done.stdout, self.file) != self.honest:
            return ["--resume: another result"]
        return [] if not parts_of(folder) else ["--resume leaves parts"]


def expected_codes(victim, name):
    """Exit codes of mpirun. It may be done before the signal comes. Of a rank that is ended, or stops when it is told to, it
    gives the code; told to stop itself, it gives 1."""
    number = int(SIGNALS[name])
    if victim == "mpirun":
        return (0, -number) if name == "SIGKILL" else (0, 1, 130, -number)
    return (0, 128 + number) if name == "SIGKILL" else (0, 130, 128 + number)


def works_in_ranks(occlude):
    if shutil.which("mpirun") is None:
        return False
    one = ["mpirun", "--oversubscribe", "-n", "2", occlude, "fuzz", "--cases", "1", "--family", "lattice", "--findings", ""]
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(one, cwd=folder, env=dict(os.environ, **ALLOW), stdin=subprocess.DEVNULL, capture_output=True,
                              check=False).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("occlude", help="the command")
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--ranks", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=2, help="until all must have ended (2)")
    arguments = parser.parse_args()
    occlude = os.path.abspath(arguments.occlude)
    if not works_in_ranks(occlude):
        print("No mpirun, or built without MPI: nothing is tried")
        return 77
    table, wrong = {}, 0
    with tempfile.TemporaryDirectory() as place:
        scratch = pathlib.Path(place)
        os.environ["XDG_STATE_HOME"] = str(scratch / "state")  # for the key that seals parts
        city = str(scratch / "city.ply")
        subprocess.run([occlude, "generate", "city", "--polygons", "20000", "--seed", "5", "--out", city, "--path",
                        city + ".json", "--quiet"], check=True)
        trials = []
        for name, (command, file) in commands(city).items():
            one = subprocess.run([occlude, *command], cwd=scratch, capture_output=True, check=True)
            honest = result_of(scratch, one.stdout, file)
            begun = time.monotonic()
            subprocess.run(["mpirun", "--oversubscribe", "-n", str(arguments.ranks), occlude, *command], cwd=scratch,
                           env=dict(os.environ, **ALLOW), capture_output=True, stdin=subprocess.DEVNULL, check=True)
            length = time.monotonic() - begun
            trials.append((name, Trial(arguments, occlude, command, file, honest, scratch), length))
        for index in range(arguments.trials):
            numbers = random.Random(f"{arguments.seed} {index}")
            command, trial, length = trials[index % len(trials)]
            victim, name = numbers.choice(VICTIMS), numbers.choice(list(SIGNALS))
            faults, seconds, code = trial.run(index, numbers, victim, name, length)
            row = table.setdefault((victim, name), {"trials": 0, "seconds": [], "codes": {}, "wrong": 0})
            row["trials"] += 1
            row["seconds"].append(seconds)
            row["codes"][code] = row["codes"].get(code, 0) + 1
            if faults:
                row["wrong"] += 1
                wrong += 1
                print(f"{index}: {command}, {name} to {victim}: {'; '.join(faults)}", flush=True)
    print("| ended | by | trials | exit codes: trials | seconds till all ranks had ended: median, most | wrong |")
    print("|---" * 6 + "|")
    for (victim, name), row in sorted(table.items()):
        codes = " ".join(f"{code}:{count}" for code, count in sorted(row["codes"].items(), key=str))
        seconds = sorted(row["seconds"])
        print(f"| {victim} | {name} | {row['trials']} | {codes} | {seconds[len(seconds) // 2]:.1f}, {seconds[-1]:.1f} | "
              f"{row['wrong']} |")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
