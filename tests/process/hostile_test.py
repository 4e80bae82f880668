#!/usr/bin/python3
"""A hostile sender: structured random datagrams from this machine and from another one.

    tests/process/private_bus tests/process/hostile_test.py --bin build/release/bin --seconds 60

First at a pace that everybody can follow: what was sent has to be what STATUS counts, to the one.
Then as fast as it goes: no process dies, each good message arrives or is counted as missed, memory
is flat once every queue has been full.

Skipped (exit code 77) where no namespaces or cables between them can be had.
"""

import collections
import itertools
import multiprocessing
import random
import struct
import sys
import time

import bus_messages
import bus_record
import socket_filters
from live_processes import (COMPONENTS, Processes, command_line, fail, main_threads_held,
                            read_options, verdict, wait_for)
from machines import GROUP, PORT, Machine, join, listening_socket, sending_socket

BUS = "udpm://239.255.76.67:7667?ttl=1"
KEPT_OUT = ("bus", "no whole message, or no room for it")
BATCH = 10  # datagrams between two looks at the clock
POOL = 3000  # different datagrams of each sender
PACE = 1000  # datagrams a second of each sender, when all have to be counted
TO_ONE = "to one socket"
TOO_SLOW = "too slow for all that comes"
LATER = ("its scan or CURRENT_MAP never came", "before the first position",
         "after the last position", "positions around it too far apart",
         "waited too long for a position", TOO_SLOW)
ROUNDS, ROUND = 8, 1.0  # [s] in which every queue is filled
GROWTH = 1.1  # of resident memory: more is not flat
COUNTS = (-1, -2**31, 2**31 - 1, 0x10000000, 0x20000000, 10**8)
OURS = {"PICO_LASER": "laser_scan_t", "PICO_ODOMETRY": "odometry_t", "POSITION": "position_t",
        "CURRENT_MAP": "map_t", "LOCAL_MAP": "map_t", "GLOBAL_MAP": "map_t",
        "CMD_VELOCITY": "velocity_t", "CMD_OPEN_DOOR": "open_door_t", "CMD_SPEAK": "speak_t",
        "STATUS_X": "status_t"}


class Hostile:
    """Makes datagrams, each with the channel on which somebody will turn it down; "": the kernel
    keeps it out; None: nobody has to do with it."""

    def __init__(self, seed, good):
        self.random, self.good = random.Random(seed), good

    def one(self):
        kinds = (self.noise, self.fragment, self.fragment_that_wraps, self.nameless, self.stranger,
                 self.mutated, self.mutated, self.miscounted, self.of_another_type)
        return self.random.choice(kinds)()

    def bytes(self, most):
        return self.random.randbytes(self.random.randrange(most))

    def noise(self):
        return "", b"\0" + self.bytes(1400)

    def fragment(self):
        header = struct.pack(">4sIIIHH", b"LC03", *(self.random.getrandbits(32) for _ in range(3)),
                             self.random.randrange(3), self.random.randrange(1, 4))
        return "", header + self.bytes(1400)

    def fragment_that_wraps(self):
        """The end of its content, offset + size, is a small number again: crashes liblcm 1.3.1."""
        first = struct.pack(">4sIIIHH", b"LC03", 1, 100, 0, 0, 2) + b"PICO_LASER".ljust(60, b"\0")
        second = struct.pack(">4sIIIHH", b"LC03", 1, 100, 0xFFFFFF00, 1, 2) + bytes(0x140)
        return "", self.random.choice((first, second))

    def nameless(self):
        """Whole, but the channel's name has no end, or is too long for one."""
        name = self.random.choice((b"PICO_LASER", b"POSITION", b"", b"x" * 200,
                                   b"x" * 200 + b"\0x"))
        whole = bus_messages.MAGIC + self.random.randbytes(4) + name
        return "", whole[:self.random.choice((4, 6, 1000, 1000))]

    def stranger(self):
        """A whole message on a channel that is none of ours."""
        name = "".join(self.random.choices("ABCXYZ_", k=self.random.randrange(1, 60)))
        return None, bus_messages.datagram("Q" + name, self.bytes(1400))

    def mutated(self):
        """A good message with noise on top, and something in it that cannot be."""
        channel, payload = self.random.choice(list(self.good.items()))
        payload = bytearray(payload)
        for _ in range(self.random.randrange(3)):
            payload[self.random.randrange(8, len(payload))] ^= self.random.randrange(1, 256)
        fault = self.random.randrange(3)
        if fault == 0:  # another fingerprint
            payload[self.random.randrange(8)] ^= 1 << self.random.randrange(8)
        elif fault == 1:
            del payload[self.random.randrange(len(payload)):]
        else:
            payload += self.random.randbytes(self.random.randrange(1, 100))
        return channel, bus_messages.datagram(channel, bytes(payload))

    def miscounted(self):
        """An empty message ends with its two counts: they promise what does not come."""
        channel = self.random.choice(("PICO_LASER", "CURRENT_MAP", "LOCAL_MAP", "GLOBAL_MAP"))
        message = getattr(TYPES, OURS[channel])()
        for field in ("laser_in_robot", "robot_in_zero", "robot_in_local"):
            if hasattr(message, field):
                setattr(message, field, TYPES.pose_t())
        counts = struct.pack(">ii", *self.random.choices(COUNTS, k=2))
        payload = message.encode()[:-8] + counts + self.bytes(800)
        return channel, bus_messages.datagram(channel, payload)

    def of_another_type(self):
        channel, other = self.random.sample(list(self.good), 2)
        same = OURS[channel] == OURS[other]
        return channel, bus_messages.datagram(channel, b"" if same else self.good[other])


def send(machine, addresses, seed, good, pace, seconds, tell):
    """A process of its own; tells how many went out to the group, by what has to become of them,
    and how many to the machine's own address, where one socket gets each."""
    with machine.inside():
        sender = sending_socket()
    hostile, sent = Hostile(seed, good), collections.Counter()
    pool = itertools.cycle([hostile.one() for _ in range(POOL)])
    began = time.monotonic()
    while (now := time.monotonic() - began) < seconds:
        if pace and sent.total() > pace * now:
            time.sleep(0.001)
            continue
        for address, (channel, datagram) in zip(addresses * BATCH, pool):
            sender.sendto(datagram, address)
            sent[channel if address[0] == GROUP else (TO_ONE, channel)] += 1
    tell.put(sent)


class Attack:
    """The chain on one machine, hostile senders on that one and on another."""

    def __init__(self):
        self.robot, self.outside = Machine("robot"), Machine("outside")
        join(self.robot, self.outside)
        self.processes = Processes(options.out)
        self.programs = {}
        self.listener = bus_record.Listener(self.robot, socket_filters.let_status_through)
        with self.robot.inside():
            self.counter = listening_socket()
        socket_filters.let_nothing_through(self.counter)

    def start_one(self, name, *arguments):
        self.programs[name] = self.processes.start(
            [options.bin / f"pico-{name}", *arguments], {"LCM_DEFAULT_URL": BUS}, self.robot)

    def start(self):
        """The robot last. Gives a good message of each channel, and the first number on each."""
        everything = bus_record.Listener(self.robot)
        everything.start()
        self.listener.start()
        for name in (*COMPONENTS, "viewer", "watch"):
            map_option = ["--map", "hospital"] if name in ("globalmap", "localize") else []
            self.start_one(name, *map_option)
        self.start_one("record", "--file", LOG, "--existing", "replace")
        wait_for(lambda: {*COMPONENTS, "viewer", "record"} <= set(self.said_since(0.0)), 20,
                 "all are ready")
        self.start_one("bridge")
        time.sleep(4.0)
        everything.stop()
        good = {channel: payload for channel, payload in everything.payloads.items()
                if channel in OURS}
        good |= {channel: getattr(TYPES, OURS[channel])().encode() for channel in OURS
                 if channel.startswith("CMD_")}
        good["STATUS_X"] = everything.payloads["STATUS_SCAN"]
        first = {message.channel: message.stamp.seq for message in reversed(everything.sent)}
        return good, first

    def said_since(self, began):
        """The first STATUS of each component since then."""
        said = [TYPES.status_t.decode(payload) for when, payload in list(self.listener.statuses)
                if when >= began]
        return {status.component: status for status in reversed(said)}

    def most_memory(self, began):
        """[bytes] of each component since then."""
        most = collections.Counter()
        for when, payload in list(self.listener.statuses):
            if when >= began:
                status = TYPES.status_t.decode(payload)
                most[status.component] = max(most[status.component], status.rss_bytes)
        return most

    def said_now(self):
        """Of all, when what is under way has been handled."""
        began = time.monotonic() + 1.0
        names = {"bridge", *COMPONENTS, "viewer", "record"}
        wait_for(lambda: names <= set(self.said_since(began)), 10, "a STATUS of each")
        return self.said_since(began)

    def send(self, good, pace, seconds, meanwhile=lambda: None):
        """From both machines; gives what was sent, by what has to become of it. At full speed the
        other machine sends to the robot's own address as well."""
        group, robot = (GROUP, PORT), ("10.9.0.1", PORT)
        places = [(self.robot, [group]), (self.outside, [group] if pace else [group, robot])]
        tell = multiprocessing.Queue()
        senders = [multiprocessing.Process(target=send, daemon=True,
                                           args=[*place, seed, good, pace, seconds, tell])
                   for seed, place in enumerate(places)]
        for sender in senders:
            sender.start()
        meanwhile()
        sent = sum((tell.get() for _ in senders), collections.Counter())
        for sender in senders:
            sender.join()
        return sent

    def fill_queues(self):
        """Nothing is checked for a while, so that all waits that can. LCM makes room for that in
        steps and keeps the last; part waits in the room that there was before: hence the rounds."""
        for _ in range(ROUNDS):
            with main_threads_held(self.programs.values()):
                time.sleep(ROUND / 2)
            time.sleep(ROUND / 2)

    def check_alive(self, when):
        for name, program in self.programs.items():
            if program.poll() is not None:
                fail(f"{name} died {when}: exit code {program.returncode}")

    def stop(self):
        """In the order of the data flow; gives the last words."""
        for name, program in self.programs.items():
            if name == "bridge" and self.processes.stop(program) != 0:
                fail("bridge did not end cleanly")
        time.sleep(1.0)
        for name in (*COMPONENTS, "viewer", "record"):
            if self.processes.stop(self.programs[name]) != 0:
                fail(f"{name} did not end cleanly")
        said = [TYPES.status_t.decode(payload) for _, payload in self.listener.statuses]
        return {status.component: status for status in said}


def bad(status, entry):
    """Messages of an input that were turned down for what they are."""
    return entry.rejected - turned_down_later(status, entry.channel)


def grown(before, after):
    """(component, channel) -> how much was turned down in between; KEPT_OUT for the kernel."""
    for name, now in after.items():
        then, old = before[name], bus_messages.inputs(before[name])
        yield name, "", (bus_messages.rejects(now).get(KEPT_OUT, 0)
                         - bus_messages.rejects(then).get(KEPT_OUT, 0))
        for channel, entry in bus_messages.inputs(now).items():
            yield name, channel, (bad(now, entry) - bad(then, old[channel]) if channel in old
                                  else bad(now, entry))


def check_counts(sent, before, after, exactly):
    """What each component says that it turned down, beside what was sent of that."""
    print(f"{'component':<12} {'channel':<16} {'sent':>9} {'turned down':>12}")
    said = collections.defaultdict(dict)
    for name, channel, turned_down in grown(before, after):
        if name in ("viewer", "globalmap") or (name == "record" and channel):
            continue  # takes what the others say as well; does not listen; takes everything
        print(f"{name:<12} {channel or '(the kernel)':<16} {sent[channel]:9} {turned_down:12}")
        said[name][channel] = turned_down
    to_one = {channel: sent[channel] + sent[TO_ONE, channel] for channel in OURS | {"": ""}}
    for name, counts in said.items():
        if not any(is_right(counts, all_that_came, exactly) for all_that_came in (sent, to_one)):
            fail(f"{name}: not everything is counted")


def is_right(turned_down, sent, exactly):
    """Each is counted where it was turned down; at full speed, or by the kernel: no room for it."""
    if exactly:
        return all(count == sent[channel] for channel, count in turned_down.items())
    no_room = turned_down[""] - sent[""]
    uncounted = [sent[channel] - count for channel, count in turned_down.items() if channel]
    return min(uncounted, default=0) >= 0 and sum(uncounted) <= no_room


def turned_down_later(status, channel):
    """Good messages that were taken, and then had no place."""
    return sum(count for (where, reason), count in bus_messages.rejects(status).items()
               if where == channel and reason in LATER)


def check_good(first, last_words):
    """Each good message was taken or is counted as missed."""
    print(f"\n{'component':<12} {'channel':<16} {'numbers':>9} {'taken':>9} {'missed':>9}")
    numbers = {channel: entry.last_seq - first[channel] + 1 for status in last_words.values()
               for channel, entry in bus_messages.outputs(status).items() if channel in first}
    for name in COMPONENTS:
        for channel, entry in bus_messages.inputs(last_words[name]).items():
            if channel == "GLOBAL_MAP":  # began before localize did
                continue
            taken = entry.received - entry.rejected + turned_down_later(last_words[name], channel)
            print(f"{name:<12} {channel:<16} {numbers[channel]:9} {taken:9} {entry.missed:9}")
            if taken + entry.missed != numbers[channel] or entry.restarts:
                fail(f"{name}: {channel}: {numbers[channel]} numbers, {taken} taken and "
                     f"{entry.missed} missed; {entry.restarts} restarts")


def check_memory(quiet, full, most):
    """The sanitizers' own is not ours."""
    print(f"\n{'component':<12} {'MB quiet':>12} {'queues full':>12} {'at most':>12}")
    for name, grown_to in most.items():
        sizes = [size / 1e6 for size in (quiet[name].rss_bytes, full[name].rss_bytes, grown_to)]
        print(f"{name:<12}", *(f"{size:12.1f}" for size in sizes))
        if grown_to > GROWTH * full[name].rss_bytes and not options.sanitized:
            fail(f"{name} grew from {sizes[1]:.1f} MB to {sizes[2]:.1f} MB")


def check_rates(before, after):
    """Who published goes on publishing as before: once more the time between two STATUS."""
    for name, status in after.items():
        for channel, entry in bus_messages.outputs(status).items():
            was = bus_messages.outputs(before[name])[channel].published
            if entry.published == was:
                fail(f"{name} publishes nothing on {channel} after the attack")


def main():
    attack = Attack()
    try:
        good, first = attack.start()
        quiet = attack.said_now()
        print("At", 2 * PACE, "datagrams a second:")
        sent = attack.send(good, PACE, min(4.0, options.seconds / 2))
        attack.check_alive("at a slow pace")
        counted = attack.said_now()
        check_counts(sent, quiet, counted, exactly=True)

        attack.send(good, 0, ROUNDS * ROUND, attack.fill_queues)
        full = attack.said_now()
        before, began = socket_filters.drops(attack.counter), time.monotonic()
        sent = attack.send(good, 0, options.seconds)
        seconds = time.monotonic() - began
        attack.check_alive("at full speed")
        arrived = socket_filters.drops(attack.counter) - before
        after = attack.said_now()
        to_one = sum(count for key, count in sent.items() if isinstance(key, tuple))
        print(f"\nAt full speed: {sent.total() / seconds:.0f} a second for {seconds:.0f} s: "
              f"{sent.total() - to_one} to all sockets, {to_one} to one of them; {arrived} came to "
              "each, good ones among them")
        check_counts(sent, full, after, exactly=False)
        check_rates(after, attack.said_now())
        check_memory(quiet, full, attack.most_memory(began))
        check_good(first, attack.stop())
    finally:
        attack.processes.stop_all()
        LOG.unlink(missing_ok=True)
    return verdict()


if __name__ == "__main__":
    parser = command_line(__doc__)
    parser.add_argument("--seconds", type=float, default=8.0, help="at full speed")
    options = read_options(parser)
    TYPES = bus_messages.generated_types(options.out)
    LOG = options.out / "hostile.lcmlog"
    sys.exit(main())
