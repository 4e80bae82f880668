#!/usr/bin/python3
"""What the viewer costs: its processor time, and the latency of the chain beside it.

    tests/process/private_bus tests/process/viewer_load.py --bin build/release/bin

The chain runs in the hospital, in real time, once for each number of clients, in turn, so that what
else the machine does falls on all alike; each client takes every scene. No assertion: figures.
"""

import argparse
import multiprocessing
import os
import pathlib
import re
import selectors
import signal
import socket
import subprocess
import tempfile
import time

from live_processes import Processes, wait_for

PORT = 8080
CLOCK_TICKS = 100  # a second, of /proc/PID/stat
CASES = [None, 0, 1, 10]  # clients; None: no viewer


def look(clients, received):
    """All clients in one process that only takes what comes: they sit at other machines, and should
    not take the chain's cores here."""
    os.nice(19)
    selector = selectors.DefaultSelector()
    for _ in range(clients):
        connection = socket.create_connection(("127.0.0.1", PORT))
        connection.sendall(b"GET /scenes HTTP/1.1\r\nHost: viewer\r\n\r\n")
        selector.register(connection, selectors.EVENT_READ)
    while True:
        for key, _ in selector.select():
            received.value += len(key.fileobj.recv(1 << 20))
        time.sleep(0.05)  # some at a time, as they come over a network


def processor_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / CLOCK_TICKS


def measure(bin_folder, folder, clients, seconds):
    """Latency line of pico-eval, share of a core, bytes a second to each client."""
    processes = Processes(folder)
    received = multiprocessing.Value("q", 0)
    looking = []
    log = folder / "drive.lcmlog"
    try:
        viewer = clients is not None and processes.start(
            ["nice", bin_folder / "pico-viewer", "--port", PORT])  # as tools/run starts it
        processes.start_components(bin_folder)
        logger = processes.start(["lcm-logger", "-q", "-f", "-v", "-c", "LCM_SELF_TEST", log])
        bridge = processes.start([bin_folder / "pico-bridge"])
        if clients:
            looking.append(multiprocessing.Process(target=look, args=[clients, received],
                                                   daemon=True))
            looking[-1].start()
        wait_for(lambda: not clients or received.value > 0, 10, "scenes")
        spent, taken, began = viewer and processor_seconds(viewer), received.value, time.monotonic()
        time.sleep(seconds)
        passed = time.monotonic() - began
        share = (processor_seconds(viewer) - spent) / passed if viewer else 0.0
        rate = (received.value - taken) / passed / max(1, clients or 0)
        processes.stop(bridge)
        processes.stop(logger)
    finally:
        for process in looking:
            process.kill()
        processes.stop_all()
    report = subprocess.run([bin_folder / "pico-eval", "run", log], capture_output=True, text=True,
                            check=False).stdout
    return re.search(r"in all +(.*)", report)[1], share, rate


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--seconds", type=float, default=30.0, help="for each measurement")
    parser.add_argument("--rounds", type=int, default=3, help="how often each is measured")
    options = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # children can be interrupted
    print("clients  viewer's CPU  kB/s to each  latency from laser to identified map [ms]")
    with tempfile.TemporaryDirectory(prefix="viewer_load-") as scratch:
        for case in CASES * options.rounds:
            latency, cpu, bandwidth = measure(options.bin, pathlib.Path(scratch), case,
                                              options.seconds)
            name = "none" if case is None else str(case)
            print(f"{name:>7} {100 * cpu:11.1f} % {bandwidth / 1000:12.1f}   {latency}", flush=True)
