#!/usr/bin/python3
"""The robot on one machine, everything else on another: the same outputs as on one machine.

    tests/process/private_bus tests/process/two_machines_test.py --bin build/release/bin

Two network namespaces, joined by a cable with the MTU of Ethernet, so that a scan travels in
several IP fragments; LCM with ttl=1. The same simulated drive is recorded there and on one machine,
and all that was computed is compared byte for byte. A recording that is shown to lack messages
proves nothing and is made again.

Skipped (exit code 77) where no namespaces or cables between them can be had.
"""

import collections
import subprocess
import sys

import bus_messages
from live_processes import COMPONENTS, ENVIRONMENT, Processes, command_line, read_options
from machines import Machine, join

ALIKE = ["PICO_ODOMETRY", "PICO_LASER", "POSITION", "PROXIMITY", "CURRENT_MAP", "LOCAL_MAP",
         "IDENTIFIED_MAP", "ENTRANCE", "WORLD_POSITION", "COMBINED_MAP"]
BUS = "udpm://239.255.76.67:7667?ttl=1"
ATTEMPTS = 3
ROW = "{:<16} {:>8} {:>8} {:>12} {:>9} {:>8}"
MISSING = 1  # exit code of pico-logcheck


def drive(robot, rest, log):
    """Records a drive; whether pico-logcheck finds it complete."""
    environment = {"LCM_DEFAULT_URL": BUS}
    processes = Processes(options.out)

    def wait(*names):
        command = rest.command([options.bin / "pico-watch", "--wait", ",".join(names)])
        subprocess.run(command, check=True, env={**ENVIRONMENT, **environment})

    try:
        recorder = processes.start([options.bin / "pico-record", "--file", log, "--existing",
                                    "replace"], environment, rest)
        wait("record")
        components = []
        for name in COMPONENTS:
            map_option = ["--map", "hospital"] if name in ("globalmap", "localize") else []
            components.append(processes.start([options.bin / f"pico-{name}", *map_option],
                                              environment, rest))
        wait(*COMPONENTS)
        bridge = processes.start([options.bin / "pico-bridge", "--duration", options.seconds,
                                  "--set", "session=1", "--set", "seed=7"], environment, robot)
        bridge.wait(options.seconds + 30)
        for component in (*components, recorder):
            processes.stop(component)
    finally:
        processes.stop_all()
    check = subprocess.run([options.bin / "pico-logcheck", log], capture_output=True, text=True,
                           check=False)
    return check.returncode != MISSING


def payloads(log):
    result = collections.defaultdict(list)
    for channel, payload in bus_messages.events(log):
        result[channel].append(payload)
    return result


def recorded(name, robot, rest):
    """By channel, of a recording that lacks nothing."""
    for _ in range(ATTEMPTS):
        if drive(robot, rest, options.out / f"{name}.lcmlog"):
            return payloads(options.out / f"{name}.lcmlog")
        print(name + ": messages were lost on the way: recorded again", flush=True)
    return payloads(options.out / f"{name}.lcmlog")


def compare(channel, one, two):
    """A line of the table; whether they are the same."""
    numbers = [{bus_messages.stamp_of(payload).seq for payload in both} for both in (one, two)]
    differ = sum(a != b for a, b in zip(one, two))
    alike = one == two and len(one) > 0
    largest = max(map(len, one), default=0)
    row = ROW.format(channel, len(one), len(two), len(numbers[0] ^ numbers[1]), differ, largest)
    print(row, " alike" if alike else " DIFFERENT", flush=True)
    return alike


def main():
    alone = Machine("alone")
    alone.alone()
    robot, rest = Machine("robot"), Machine("rest")
    join(robot, rest)
    one = recorded("one_machine", alone, alone)
    two = recorded("two_machines", robot, rest)
    print(ROW.format("channel", "one", "two", "only in one", "different", "largest"))
    print(ROW.format("", "machine", "machines", "of them", "payloads", "[bytes]"))
    alike = [compare(channel, one[channel], two[channel]) for channel in ALIKE]
    fragments = rest.count_fragments()
    print(f"IP fragments: {robot.count_fragments()['FragCreates']} made at the robot; at the rest "
          f"{fragments['ReasmOKs']} datagrams put together, {fragments['ReasmFails']} not")
    return 0 if all(alike) else 1


if __name__ == "__main__":
    parser = command_line(__doc__)
    parser.add_argument("--seconds", type=float, default=8.0, help="that the robot drives")
    options = read_options(parser)
    sys.exit(main())
