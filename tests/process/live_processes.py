"""Real processes, on the bus of the namespace that a test runs in: see private_bus."""

import argparse
import contextlib
import ctypes
import os
import pathlib
import signal
import subprocess
import tempfile
import time

from machines import LIBC, check

COMPONENTS = ["locate", "scan", "merge", "identify", "proximity", "globalmap", "localize"]

FAILURES = []

ENVIRONMENT = {name: value for name, value in os.environ.items()
               if name not in ("CLASSPATH", "DISPLAY", "LCM_DEFAULT_URL")}

PTRACE_DETACH, PTRACE_SEIZE, PTRACE_INTERRUPT = 17, 0x4206, 0x4207  # <sys/ptrace.h>
WALL = 0x40000000  # <sys/wait.h>


def command_line(description):
    """What every script here is told: where the programs are, and where its files may stay."""
    summary, _, details = description.partition("\n\n")
    parser = argparse.ArgumentParser(description=summary, epilog=details,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--out", type=pathlib.Path, help="where logs stay")
    parser.add_argument("--sanitized", action="store_true", help="a sanitizer watches the "
                        "programs: their size and speed tell nothing")
    return parser


def read_options(parser):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # children can be interrupted
    options = parser.parse_args()
    options.bin = options.bin.resolve()
    options.out = (options.out or pathlib.Path(tempfile.mkdtemp(prefix=parser.prog))).resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    return options


def fail(text):
    """The script goes on, so that all is seen; `verdict` tells it once more."""
    print("   WRONG:", text, flush=True)
    FAILURES.append(text)


def verdict():
    """The exit code."""
    for failure in FAILURES:
        print("FAILED:", failure)
    return 1 if FAILURES else 0


def wait_for(condition, seconds, what):
    """The first true value of condition()."""
    give_up = time.monotonic() + seconds
    while time.monotonic() < give_up:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise AssertionError(f"not within {seconds} s: {what}")


def _trace(request, process):
    check(LIBC.ptrace(ctypes.c_long(request), ctypes.c_int(process.pid), None, None))


@contextlib.contextmanager
def main_threads_held(processes):
    """Children of this one; their other threads, LCM's that receives among them, go on."""
    for process in processes:
        _trace(PTRACE_SEIZE, process)
        _trace(PTRACE_INTERRUPT, process)
        os.waitpid(process.pid, WALL)
    try:
        yield
    finally:
        for process in processes:
            _trace(PTRACE_DETACH, process)


class Processes:
    """Stopped in the opposite order of their start. What they say stays in the folder."""

    def __init__(self, folder):
        self.folder = folder
        self.running = []
        self.heard = set()  # programs that said something in this run: the file goes on

    def said_by(self, program):
        return self.folder / f"{program}.log"

    def start(self, command, environment=None, machine=None, **options):
        """On another machine (machines.py) where one is given."""
        program = pathlib.Path(command[0]).name
        mode = "ab" if program in self.heard else "wb"
        self.heard.add(program)
        with open(self.said_by(program), mode) as said:
            words = machine.command(command) if machine else list(map(str, command))
            process = subprocess.Popen(words, stdout=said, stderr=said,
                                       env={**ENVIRONMENT, **(environment or {})}, **options)
        self.running.append(process)
        return process

    def stop(self, process, number=signal.SIGINT):
        self.running.remove(process)
        process.send_signal(number)
        try:
            return process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            return process.wait()

    def start_components(self, bin_folder):
        """All that perceive, in the hospital; each ready."""
        for name in COMPONENTS:
            map_option = ["--map", "hospital"] if name in ("globalmap", "localize") else []
            self.start([bin_folder / f"pico-{name}", *map_option])
        subprocess.run([bin_folder / "pico-watch", "--wait", ",".join(COMPONENTS)], check=True)

    def stop_all(self):
        while self.running:
            self.stop(self.running[-1], signal.SIGTERM)
