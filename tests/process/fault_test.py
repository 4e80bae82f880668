#!/usr/bin/python3
"""Faults of the bus and of the machine: what STATUS says, how long until all goes on, what is lost.

    tests/process/private_bus tests/process/fault_test.py --bin build/release/bin --seconds 10

Each process runs on a machine (network namespace) of its own, all joined by a switch that is made
faulty; or a process is stopped, its cable is pulled, its clock is set, a second robot speaks on the
bus. For each fault: the messages that did not arrive are known from the switch, and what each
component's STATUS counts has to be the same; and every channel has to be back at its normal rate
within a second of the fault's end.

Skipped (exit code 77) where no namespaces or tun devices can be had.
"""

import collections
import contextlib
import dataclasses
import json
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time

import bus_messages
import bus_record
import faulty_switch
import loss_accounts
from live_processes import (COMPONENTS, Processes, command_line, fail, read_options, verdict,
                            wait_for)
from loss_accounts import Said
from machines import Machine

ALL = ["bridge", *COMPONENTS, "record"]  # in the order of the data flow
BUS = "udpm://239.255.76.67:7667?ttl=1"  # LCM's default stays on one machine
LIMIT = 1.0  # [s] from a fault's end until every channel is back
AFTER = 2.0  # [s] that are watched from a fault's end
WINDOW = 0.5  # [s] in which a rate is normal or not
SHARE = 0.8  # of the usual messages in a window: it is normal
SLOWEST = 4.0  # [Hz] slower channels have no rate in such a window
FLOOD = 20  # times the normal rate
ROW = "{:<32} {:>8} {:>8} {:>13} {:>11} {:>8} {:>8} {:>8}  {}"
LOG_ROW = "{:<20} {:>6} {:>7} {:>8} {:>8} {:>9}"
SECOND = 1_000_000_000  # [ns]
SILENT = 1.5  # [s] without a STATUS, of which one comes each second


@dataclasses.dataclass
class Fault:
    name: str
    during: object  # a context manager, given the chain
    seconds: float


class Chain:
    """All components, the recorder and the robot: each on a machine of its own, or all on one."""

    def __init__(self, folder, record, machines):
        self.folder, self.record, self.machines = folder, record, machines
        self.log = folder / "faults.lcmlog"
        self.processes = Processes(folder)
        self.running = {}
        self.was_unplugged = False
        self.boots = {}  # of ours: a second one of the same name is a stranger
        self.decoded = []  # as many of the record's STATUS messages as were looked at
        self.environment = {"LCM_DEFAULT_URL": BUS, **self.clock()}

    @classmethod
    def on_a_switch(cls, folder):
        switch, machines = faulty_switch.Switch(), {}
        for name in (*ALL, "stranger"):
            machines[name] = Machine(name)
            switch.connect(machines[name])
        return cls(folder, switch, machines)

    @classmethod
    def on_one_machine(cls, folder):
        machine = Machine("robot")
        machine.alone()
        return cls(folder, bus_record.Listener(machine), collections.defaultdict(lambda: machine))

    def clock(self):
        """What makes programs see a wall clock that `set_clock` sets."""
        library, self.clock_file = self.folder / "stepped_clock.so", self.folder / "clock"
        source = pathlib.Path(__file__).with_name("stepped_clock.c")
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, source], check=True)
        self.clock_file.write_bytes(bytes(8))
        return {"LD_PRELOAD": library, "STEPPED_CLOCK": self.clock_file,
                "ASAN_OPTIONS": "verify_asan_link_order=0"}

    def set_clock(self, ahead):
        """[s] from now on, for all."""
        with open(self.clock_file, "r+b") as file:
            file.write(round(ahead * SECOND).to_bytes(8, "little", signed=True))

    def start_one(self, name, command):
        self.running[name] = self.processes.start(command, self.environment, self.machines[name])
        return self.running[name]

    def start(self):
        """The robot last: nobody misses anything. Gives the usual rates."""
        self.record.start()
        self.start_one("record", [options.bin / "pico-record", "--file", self.log, "--existing",
                                  "replace"])
        wait_for(lambda: "record" in self.said_since(0.0), 20, "the recorder is ready")
        for name in COMPONENTS:
            map_option = ["--map", "hospital"] if name in ("globalmap", "localize") else []
            self.start_one(name, [options.bin / f"pico-{name}", *map_option])
        wait_for(lambda: set(COMPONENTS) <= set(self.said_since(0.0)), 20, "all are ready")
        self.start_one("bridge", [options.bin / "pico-bridge"])
        time.sleep(1.5)
        began = time.monotonic()
        time.sleep(2.0)
        return self.rates(began, time.monotonic())

    def stop(self):
        """In the order of the data flow, so that what is under way drains."""
        for name in ALL:
            self.processes.stop(self.running[name])
        self.record.stop()

    def statuses(self):
        """(time, STATUS) of all, in order; the same list each time, grown."""
        for when, payload in self.record.statuses[len(self.decoded):]:
            status = TYPES.status_t.decode(payload)
            self.boots.setdefault(status.component, status.boot)
            self.decoded.append(Said(when, status))
        return self.decoded

    def own_statuses(self, began):
        return [said for said in self.statuses()
                if said.time >= began and said.status.boot == self.boots[said.status.component]]

    def said_since(self, began):
        """The first STATUS of each component since then."""
        return {said.status.component: said for said in reversed(self.own_statuses(began))}

    def wait_for_all(self, began):
        wait_for(lambda: set(ALL) <= set(self.said_since(began)), 10, "a STATUS of each")
        return self.said_since(began)

    def place(self):
        """Whether the robot knows where it is."""
        kind = TYPES.world_position_t
        names = {kind.SEARCHING: "searching", kind.TRACKING: "tracking", kind.LOST: "lost"}
        return names[kind.decode(self.record.payloads["WORLD_POSITION"]).state]

    def rates(self, began, ended):
        """[Hz] of the channels that have one."""
        counts = collections.Counter(message.channel for message in self.record.sent
                                     if began <= message.time < ended)
        rates = {channel: count / (ended - began) for channel, count in counts.items()}
        return {channel: rate for channel, rate in rates.items() if rate >= SLOWEST}


# What is done to the chain. Each is over when its context ends.

@contextlib.contextmanager
def on_the_lines(chain, fate):
    chain.record.fate = fate
    try:
        yield
    finally:
        chain.record.fate = None


@contextlib.contextmanager
def clock_ahead(chain, ahead):
    """Stays set: only the step is the fault."""
    chain.set_clock(ahead)
    yield


@contextlib.contextmanager
def stopped(chain, name):
    chain.running[name].send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        chain.running[name].send_signal(signal.SIGCONT)


@contextlib.contextmanager
def stuttering(chain, length, period):
    """Every component stands still for a while in each period, one after the other."""
    done = threading.Event()

    def stutter():
        while not done.is_set():
            for name in COMPONENTS:
                chain.running[name].send_signal(signal.SIGSTOP)
                done.wait(length)
                chain.running[name].send_signal(signal.SIGCONT)
            done.wait(period)
    thread = threading.Thread(target=stutter)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


@contextlib.contextmanager
def unplugged(chain):
    """Nobody has a link, or a route for multicast."""
    chain.was_unplugged = True
    for machine in chain.machines.values():
        chain.record.pull(machine)
    try:
        yield
    finally:
        for machine in chain.machines.values():
            chain.record.plug(machine)


@contextlib.contextmanager
def second_robot(chain):
    """Another simulator on the same bus."""
    bridge = chain.start_one("stranger", [options.bin / "pico-bridge", "--set", "session=2"])
    try:
        yield
    finally:
        chain.processes.stop(bridge)


@contextlib.contextmanager
def flood(chain):
    """The robot gives way to one that lives many times as fast."""
    with stopped(chain, "bridge"):
        fast = chain.start_one("stranger", [options.bin / "pico-bridge", "--set", "session=3",
                                            "--speed", str(FLOOD)])
        try:
            yield
        finally:
            chain.processes.stop(fast)


def faults(seconds, victims):
    lines = [("1 % lost", faulty_switch.loss(0.01)), ("5 % lost", faulty_switch.loss(0.05)),
             ("20 % lost", faulty_switch.loss(0.20)),
             ("20 % twice", faulty_switch.duplicates(0.2)),
             ("10 % out of order", faulty_switch.reordering(0.1)),
             ("lines stall 200 ms each 1 s", faulty_switch.stalls(0.2, 1.0))]
    for name, fate in lines:
        yield Fault(name, lambda chain, fate=fate: on_the_lines(chain, fate), seconds)
    yield Fault("processes stall 200 ms in turn", lambda chain: stuttering(chain, 0.2, 0.2),
                seconds)
    for name, ahead in (("clock 1 h forward", 3600.0), ("clock 1 h back", 0.0),
                        ("clock 1.5 s back", -1.5)):
        yield Fault(name, lambda chain, ahead=ahead: clock_ahead(chain, ahead), 0.5)
    for name in victims:
        yield Fault(f"{name} stopped 2 s", lambda chain, name=name: stopped(chain, name), 2.0)
    yield Fault("no link and no route", unplugged, seconds)
    yield Fault("a second robot", second_robot, seconds)


def floods(seconds):
    """The switch would be too slow for it."""
    yield Fault(f"flood of {FLOOD} times the rate", flood, seconds)


def back_after(sent, rates, ended):
    """[s] from the fault's end until each channel has its rate for good; the slowest, its name."""
    times = collections.defaultdict(list)
    for message in sent:
        if ended <= message.time < ended + AFTER and message.machine != "stranger":
            times[message.channel].append(message.time - ended)
    slowest = (0.0, "")
    for channel, rate in rates.items():
        needed = int(SHARE * rate * WINDOW)
        starts = [0.01 * i for i in range(int((AFTER - WINDOW) / 0.01))]
        bad = [start for start in starts
               if sum(start <= t < start + WINDOW for t in times[channel]) < needed]
        slowest = max(slowest, (bad[-1] + 0.01 if bad else 0.0, channel))
    return slowest


def counted(then, now):
    """What grew from one STATUS to another."""
    old, reasons = bus_messages.inputs(then), bus_messages.rejects(then)
    for channel, entry in bus_messages.inputs(now).items():
        for field in ("missed", "restarts"):
            grown = getattr(entry, field) - getattr(old.get(channel), field, 0)
            if grown:
                yield f"{channel} {field} {grown}"
    for (channel, reason), count in bus_messages.rejects(now).items():
        grown = count - reasons.get((channel, reason), 0)
        if grown:
            yield f"{channel} {grown} x \"{reason}\""


def said_on_the_way(stream):
    """What one component's STATUS messages say beside counts: states, notes, and when they come."""
    for before, now in zip(stream, stream[1:]):
        for entry in now.status.inputs:
            if entry.state == entry.STALE:
                yield f"{entry.channel} stale"
        if now.status.component in COMPONENTS and now.status.note not in ("", before.status.note):
            yield f"\"{now.status.note}\"" + (", degraded" if now.status.degraded else "")
        if now.time - before.time > SILENT:
            yield f"no STATUS for {now.time - before.time:.0f} s"
        step = (now.status.utime - before.status.utime) * 1e-6 - (now.time - before.time)
        if abs(step) > 0.5:
            yield f"the time of STATUS steps by {step:+.1f} s"


def quotation(before, stream, after):
    """What a user sees in STATUS, in the order of the data flow; what all say, once."""
    who = collections.defaultdict(list)
    for name in ALL:
        own = [said for said in stream if said.status.component == name]
        lines = [*counted(before[name].status, after[name].status), *said_on_the_way(own)]
        for line in dict.fromkeys(lines):
            who[line].append(name)
    for line, names in who.items():
        yield ("all" if len(names) == len(after) else ", ".join(names)) + ": " + line


class Report:
    """A line for each fault, and what is wrong."""

    def __init__(self):
        print(ROW.format("fault", "back [s]", "lost on", "numbers that", "dropped at", "STATUS:",
                         "", "", ""))
        print(ROW.format("", "", "the way", "never came", "the machine", "missed", "rejected",
                         "restarts", "place"), flush=True)

    def add(self, fault, back, channel, accounts, words, place):
        total = sum((account for inputs in accounts.values() for account in inputs.values()),
                    loss_accounts.Account())
        print(ROW.format(fault.name, f"{back:.2f}", total.lost, total.not_arrived, total.dropped,
                         total.missed, total.rejected, total.restarts, place))
        for line in words:
            print("      ", line)
        for name, inputs in accounts.items():
            for channel, account in inputs.items():
                if account.is_right and account.untold:
                    print(f"       {name}: {channel}: the last {account.untold} of a session are "
                          "told by nobody: dropped from a full queue")
        began_anew = accounts["localize"]["PICO_LASER"].restarts > 0
        if place != "tracking" and not began_anew:
            fail(f"{fault.name}: the robot no longer knows where it is")
        if back > LIMIT and not options.sanitized:
            fail(f"{fault.name}: {channel} was back only after {back:.2f} s")
        for name, inputs in accounts.items():
            for channel, account in inputs.items():
                if not account.is_right:
                    fail(f"{fault.name}: {name}, {channel}: {account}")
        sys.stdout.flush()


def suffer(chain, fault, rates, before, report):
    """One fault, from before it to after it; gives the STATUS of all after it."""
    with fault.during(chain):
        begun = time.monotonic()
        time.sleep(fault.seconds)
        during = chain.rates(begun, time.monotonic())
    ended = time.monotonic()
    time.sleep(AFTER)
    after = chain.wait_for_all(time.monotonic())
    began = min(said.time for said in before.values())
    sent = [message for message in list(chain.record.sent) if message.time > began - 5.0]
    accounts = {name: loss_accounts.settle(sent, name, before[name], after[name])
                for name in after}
    report.add(fault, *back_after(sent, rates, ended), accounts,
               quotation(before, chain.own_statuses(began), after), chain.place())
    times = during.get("PICO_LASER", 0.0) / rates["PICO_LASER"]
    if times > 2.5:
        print(f"       PICO_LASER came at {times:.0f} times its usual rate")
    return after


def suffer_all(chain, faults_in_turn, report):
    try:
        rates = chain.start()
        print("Usual rates [Hz]:", ", ".join(f"{channel} {rate:.1f}"
                                             for channel, rate in sorted(rates.items())))
        before = chain.wait_for_all(time.monotonic())
        for fault in faults_in_turn:
            if re.search(options.only, fault.name):
                before = suffer(chain, fault, rates, before, report)
        chain.stop()
        check_log(chain, published_unheard(chain))
    finally:
        chain.processes.stop_all()


def published_unheard(chain):
    """By channel, what was published and not heard: a link that goes takes what waits for it."""
    heard = collections.Counter(message.channel for message in chain.record.sent)
    last_words = {(said.status.component, said.status.boot): said.status
                  for said in chain.statuses()}
    published = collections.Counter()
    for status in last_words.values():
        for channel, entry in bus_messages.outputs(status).items():
            published[channel] += entry.published
    unheard = collections.Counter({channel: count - heard[channel]
                                   for channel, count in published.items()})
    for channel, count in unheard.items():
        if count < 0 or (count > 0 and not chain.was_unplugged):
            fail(f"{channel}: of what was published {count} were not heard")
    return unheard


def is_source(channel):
    """Counts its numbers without a gap."""
    return channel.startswith(("PICO_", "SIM_", "STATUS_"))


def check_log(chain, unheard):
    """What the log lacks, as logcheck counts it, is what was sent and is not in it, and what could
    not be sent: of a source the numbers that it gave."""
    sent, arrived, kept = (collections.defaultdict(set) for _ in range(3))
    numbers = collections.defaultdict(dict)
    for message in chain.record.sent:
        sent[message.channel].add(message.stamp)
        numbers[message.channel][message.stamp.session] = message.stamp.seq + 1
        if message.fates.get("record") != faulty_switch.LOST:
            arrived[message.channel].add(message.stamp)
    for channel, payload in bus_messages.events(chain.log):
        kept[channel].add(bus_messages.stamp_of(payload))
    check = subprocess.run([options.bin / "pico-logcheck", "--json", chain.log],
                           capture_output=True, text=True, check=False)
    print("\n" + LOG_ROW.format("recorded", "sent", "could", "lost on", "not in", "logcheck:"))
    print(LOG_ROW.format("", "", "not be", "the way", "the log", "missing"))
    wrong, unrecorded = [], 0
    for said in json.loads(check.stdout)["channels"]:
        channel, missing = said["channel"], said["missing"]
        if channel not in sent:
            continue
        lost = len(sent[channel]) - len(arrived[channel])
        absent = len(sent[channel] - kept[channel])
        unsent = unheard[channel]
        if is_source(channel):
            unsent = sum(numbers[channel].values()) - len(sent[channel])
        print(LOG_ROW.format(channel, len(sent[channel]), unsent, lost, absent, missing))
        wrong += [channel] if missing != absent + unsent else []
        unrecorded += absent - lost
    if wrong:
        fail("logcheck's count is wrong: " + ", ".join(wrong))
    if unrecorded:
        fail(f"{unrecorded} messages arrived and were not recorded")


def main():
    chain = Chain.on_a_switch(options.out)
    report = Report()
    suffer_all(chain, faults(options.seconds, options.stop), report)
    suffer_all(Chain.on_one_machine(options.out), floods(options.seconds), report)
    return verdict()


if __name__ == "__main__":
    parser = command_line(__doc__)
    parser.add_argument("--seconds", type=float, default=2.0, help="that a fault lasts")
    parser.add_argument("--stop", default="bridge,scan,localize,record",
                        help="processes that are stopped for two seconds")
    parser.add_argument("--only", default="", help="faults whose name matches this expression")
    options = read_options(parser)
    options.stop = [name for name in options.stop.split(",") if name]
    TYPES = bus_messages.generated_types(options.out)
    sys.exit(main())
