"""Real processes on the bus of the namespace that a test runs in; see private_bus."""

import contextlib
import pathlib
import subprocess
import time

PERCEIVING = ["locate", "proximity", "scan", "merge", "identify"]


def wait_until(what, condition, at_most=20.0, pause=0.05):
    """Gives what the condition gives as soon as that is true; fails where it never is."""
    end = time.monotonic() + at_most
    while True:
        found = condition()
        if found:
            return found
        if time.monotonic() > end:
            raise AssertionError(f"not within {at_most:g} s: {what}")
        time.sleep(pause)


class Chain(contextlib.ExitStack):
    """Starts programs; what still runs at the end is ended in the order in which it was started
    last."""

    def __init__(self, bin_folder):
        super().__init__()
        self.bin = pathlib.Path(bin_folder)

    def start(self, name, *arguments, **popen):
        process = subprocess.Popen([self.bin / f"pico-{name}", *arguments],
                                   stdout=subprocess.DEVNULL, **popen)
        self.callback(end, process)
        return process

    def perceive(self, map_name=None):
        """All processes but the source, each ready."""
        names = list(PERCEIVING)
        for name in PERCEIVING:
            self.start(name)
        if map_name:
            names += ["globalmap", "localize"]
            self.start("globalmap", "--map", map_name)
            self.start("localize", "--map", map_name)
        subprocess.run([self.bin / "pico-watch", "--wait", ",".join(names)], check=True)


def end(process, at_most=10.0):
    if process.poll() is None:
        process.terminate()
        try:
            process.wait(at_most)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
    return process.returncode
