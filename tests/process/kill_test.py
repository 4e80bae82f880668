#!/usr/bin/python3
"""Random processes are killed, again and again, under tools/launch, while the robot drives.

    tests/process/private_bus tests/process/kill_test.py --bin build/release/bin --kills 1000

Each has to be back, with a new STATUS, within a second of its death, and nobody else may die of it.
Some time after the last the map has to be as good as that of the same drive without a kill: both
are scored against the truth. And a process that stands still for 3 s is taken for hung and started
again; one that does for 2 s is not.
"""

import collections
import contextlib
import os
import pathlib
import random
import re
import signal
import statistics
import subprocess
import sys
import time

import bus_messages
import bus_record
import socket_filters
from live_processes import (ENVIRONMENT, Processes, command_line, fail, read_options, verdict,
                            wait_for)
from machines import Machine

ROOT = pathlib.Path(__file__).resolve().parents[2]
WAIT_FOR = "locate,proximity,scan,merge,identify,globalmap,localize"
LIMIT = 1.0  # [s] from a death to the new STATUS
HUNG, NOT_HUNG = 3.0, 2.0  # [s] that a process stands still
SCORED = 10.0  # [s] of robot time at the end
TOLERANCE = 3.0  # [%] by which a share may be lower than without kills
SHARES = ("walls", "right", "at one")  # columns of pico-eval map, of which more is better


class Set:
    """What tools/run starts, on a machine of its own, and what it says of itself."""

    def __init__(self):
        self.machine = Machine("robot")
        self.machine.alone()
        self.processes = Processes(options.out)
        self.listener = bus_record.Listener(self.machine, socket_filters.let_status_through)
        self.boots = collections.defaultdict(list)  # component -> (time, boot) of each start
        self.looked_at = 0

    def start(self):
        self.listener.start()
        LOG.unlink(missing_ok=True)
        values = {"source": "sim", "world": "hospital", "speed": 1, "duration": 0,
                  "map": "hospital", "wait": WAIT_FOR, "port": 8080, "log": LOG}
        settings = [word for name, value in values.items() for word in ("--set", f"{name}={value}")]
        run = ROOT / "config" / "launch" / "run.json"
        self.launcher = self.processes.start(
            [ROOT / "tools" / "launch", run, "--bin", options.bin, *settings],
            {"PATH": f"{options.bin}:{ENVIRONMENT['PATH']}"}, self.machine)
        wait_for(lambda: "bridge" in self.starts(), 30, "the set has started")
        time.sleep(3.0)

    def starts(self):
        for when, payload in self.listener.statuses[self.looked_at:]:
            self.looked_at += 1
            status = TYPES.status_t.decode(payload)
            known = self.boots[status.component]
            if not known or known[-1][1] != status.boot:
                known.append((when, status.boot))
        return self.boots

    def children(self):
        """Component -> process, of those that have a STATUS."""
        found = {}
        path = pathlib.Path(f"/proc/{self.launcher.pid}/task/{self.launcher.pid}/children")
        for pid in path.read_text(encoding="ascii").split():
            try:
                words = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
            except FileNotFoundError:
                continue
            name = pathlib.Path(words[0].decode()).name.removeprefix("pico-")
            if name in self.boots:
                found[name] = int(pid)
        return found

    def back_after(self, name, when, patience=10.0):
        """[s] until a component that was well has started anew."""
        count = len(self.boots[name])
        wait_for(lambda: len(self.starts()[name]) > count, patience, f"{name} is back")
        return self.boots[name][-1][0] - when

    def said(self):
        return self.processes.said_by("launch").read_text(errors="replace")


def kill_at_random(one):
    """Seconds that each took to be back, by component."""
    draw, back = random.Random(options.seed), collections.defaultdict(list)
    for number in range(options.kills):
        began = time.monotonic()
        name, pid = draw.choice(sorted(one.children().items()))
        when, clock = time.monotonic(), time.time()
        os.kill(pid, signal.SIGKILL)
        back[name].append(one.back_after(name, when))
        if back[name][-1] > LIMIT:
            began_after = one.boots[name][-1][1] * 1e-6 - clock  # a boot is the time of its start
            fail(f"kill {number + 1}: {name} was back only after {back[name][-1]:.2f} s; it began "
                 f"after {began_after:.2f} s")
        if options.kills > 50 and (number + 1) % 50 == 0:
            print(number + 1, "kills", flush=True)
        time.sleep(max(0.0, options.pause - (time.monotonic() - began)))
    return back


def print_kills(back):
    print(f"{'component':<12} {'kills':>6} {'back after [s]: median':>23} {'most':>6}")
    for name, seconds in sorted(back.items()):
        print(f"{name:<12} {len(seconds):6} {statistics.median(seconds):23.2f} {max(seconds):6.2f}")
    everything = [second for seconds in back.values() for second in seconds]
    print(f"{'all':<12} {len(everything):6} {statistics.median(everything):23.2f} "
          f"{max(everything):6.2f}", flush=True)


def stop_some(one):
    """Stands still for two seconds: nothing happens; for three or more: hung."""
    for name in options.stop:
        for seconds in (NOT_HUNG, HUNG):
            pid, when, boots = one.children()[name], time.monotonic(), len(one.starts()[name])
            os.kill(pid, signal.SIGSTOP)
            time.sleep(seconds)
            with contextlib.suppress(ProcessLookupError):  # killed
                os.kill(pid, signal.SIGCONT)
            time.sleep(when + HUNG + LIMIT - time.monotonic())
            anew = one.starts()[name][boots:]
            told = f"started again after {anew[0][0] - when:.2f} s" if anew else "goes on"
            print(f"{name} stopped for {seconds:g} s: {told}", flush=True)
            if bool(anew) != (seconds >= HUNG):
                fail(f"{name} stopped for {seconds:g} s: {told}")


def record_tail(one):
    """A log from now on, some time long."""
    log = options.out / "tail.lcmlog"
    recorder = one.processes.start([options.bin / "pico-record", "--file", log, "--existing",
                                    "replace"], machine=one.machine)
    time.sleep(options.settle)
    one.processes.stop(recorder)
    return list(bus_messages.events(log))


def drive_without_kills(duration):
    """The same drive from its beginning, replayed: the same measurements."""
    drive, replayed = options.out / "drive.lcmlog", options.out / "replayed.lcmlog"
    for program, *arguments in (
            ["pico-bridge", "--speed", "0", "--duration", f"{duration:.1f}", "--lcm-url",
             f"file://{drive}?mode=w"],
            ["pico-replay", drive, replayed, "--map", "hospital"]):
        subprocess.run([options.bin / program, *map(str, arguments)], check=True, env=ENVIRONMENT,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return list(bus_messages.events(replayed))


def score(name, events, begin, end):
    """Columns of pico-eval map, of a stretch of robot time [us]."""
    log = options.out / f"{name}.lcmlog"
    bus_messages.write_events(log, [
        (channel, payload) for channel, payload in events
        if re.match("PICO|SIM|.*_MAP|POSITION", channel) and channel != "GLOBAL_MAP"
        and begin <= bus_messages.stamp_of(payload).utime <= end])
    table = subprocess.run([options.bin / "pico-eval", "map", log], check=True, capture_output=True,
                           text=True).stdout
    row = table.splitlines()[-1].split()[1:]
    return dict(zip(("maps", "walls", "sides", "right", "doubles", "corners", "at one", "type",
                     "doors", "found", "standing"), row))


def compare_maps(tail):
    scans = [bus_messages.stamp_of(payload).utime for channel, payload in tail
             if channel == "PICO_LASER"]
    begin, end = scans[-1] - SCORED * 1e6, scans[-1]
    with_kills = score("with_kills", tail, begin, end)
    without = score("without_kills", drive_without_kills(end * 1e-6 + 0.1), begin, end)
    print(f"the map in the last {SCORED:g} s, {options.settle:g} s after the last kill, the robot "
          f"having driven {end * 1e-6:.0f} s since its own")
    print(f"{'':<16}" + "".join(f"{column:>9}" for column in without))
    for name, columns in (("after the kills", with_kills), ("without kills", without)):
        print(f"{name:<16}" + "".join(f"{value:>9}" for value in columns.values()))
    for column in SHARES:
        if not float(with_kills[column]) >= float(without[column]) - TOLERANCE:
            fail(f"{column}: {with_kills[column]} %, without kills {without[column]} %")


def main():
    one = Set()
    try:
        one.start()
        back = kill_at_random(one)
        print_kills(back)
        tail = record_tail(one)
        stop_some(one)
        died = len(re.findall(r" died \(killed by SIGKILL\)", one.said()))
        stops = len(re.findall(r" hangs: ", one.said()))
        others = len(re.findall(r" died \(", one.said())) - died
        print(f"the launcher says: {died} killed, of them {stops} because they hung; "
              f"{others} others died")
        if died != options.kills + len(options.stop) or others:
            fail("not all deaths are ours")
        if one.processes.stop(one.launcher) != 0:
            fail("the set did not end cleanly")
        compare_maps(tail)  # which would take the cores from a set that still ran
    finally:
        one.processes.stop_all()
        one.listener.stop()
        LOG.unlink(missing_ok=True)
    return verdict()


if __name__ == "__main__":
    parser = command_line(__doc__)
    parser.add_argument("--kills", type=int, default=5, help="how many")
    parser.add_argument("--pause", type=float, default=3.0, help="[s] from one to the next")
    parser.add_argument("--settle", type=float, default=15.0, help="[s] from the last to the score")
    parser.add_argument("--stop", default="bridge,merge,localize", help="who stands still")
    parser.add_argument("--seed", type=int, default=1, help="of who is killed, and when")
    options = read_options(parser)
    options.stop = options.stop.split(",")
    TYPES = bus_messages.generated_types(options.out)
    LOG = options.out / "killed.lcmlog"
    sys.exit(main())
