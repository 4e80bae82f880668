"""A switch between machines that loses, repeats and delays what it is told to, and remembers.

Each machine's only cable ends in this process (a tun device). What a program sends is copied to
all other machines: so every pair of programs has a line of its own that can be bad, and what was
sent and what arrived is known exactly, which a queueing discipline of the kernel (netem) does not
tell.
"""

import errno
import fcntl
import heapq
import itertools
import os
import random
import selectors
import struct
import threading
import time

import bus_messages
import bus_record
from machines import skip

TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 0x0001, 0x1000  # <linux/if_tun.h>
MTU = 65535  # a message is one packet
QUEUE = 10000  # packets that may wait in a machine's device
UDP = 17

# What becomes of one packet on one line: the delays of its copies [s]; none: it is lost.
ARRIVES = (0.0,)
LOST = ()


def loss(share, seed=1):
    draw = random.Random(seed).random
    return lambda now: LOST if draw() < share else ARRIVES


def duplicates(share, seed=1):
    """A copy follows at once, or after others."""
    draw = random.Random(seed).random
    return lambda now: (0.0, draw() * 0.06) if draw() < share else ARRIVES


def reordering(share, seed=1):
    """Some come so late that the next two or three of their channel overtake them."""
    draw = random.Random(seed).random
    return lambda now: (0.06 + 0.03 * draw(),) if draw() < share else ARRIVES


def stalls(length, period):
    """In the middle of each period nothing arrives for a while; then all of it does, in order."""
    began = time.monotonic() + 0.5 * (period - length)
    def fate(now):
        into = (now - began) % period
        return (length - into,) if into < length else ARRIVES
    return fate


class Switch(bus_record.Record):
    """Works in a thread of its own. `fate`: of each packet, on each line; None: all arrive."""

    def __init__(self):
        super().__init__()
        self.fate = None
        self.ends = {}  # machine's name -> descriptor of our end of its cable
        self.waiting = []  # a heap of (when, number, machine's name, packet)
        self.numbers = itertools.count()
        self.selector = selectors.DefaultSelector()
        self.stopping = False
        self.thread = threading.Thread(target=self._run, daemon=True)

    def connect(self, machine):
        number = len(self.ends) + 1
        try:
            with machine.inside():
                end = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
                fcntl.ioctl(end, TUNSETIFF, struct.pack("16sH22x", b"cable", IFF_TUN | IFF_NO_PI))
        except OSError as error:
            skip(f"no tun device can be had: {error}")
        machine.ip(f"link set cable mtu {MTU} txqueuelen {QUEUE}")
        machine.ip(f"address add 10.9.0.{number}/24 dev cable")
        self.ends[machine.name] = end
        self.plug(machine)
        self.selector.register(end, selectors.EVENT_READ, machine.name)

    @staticmethod
    def plug(machine):
        machine.ip("link set cable up")
        machine.ip("route add 224.0.0.0/4 dev cable")

    @staticmethod
    def pull(machine):
        """Takes the machine off the bus: neither link nor route."""
        machine.ip("link set cable down")

    def start(self):
        self.thread.start()

    def stop(self):
        self.stopping = True
        self.thread.join()

    def _run(self):
        while not self.stopping:
            wait = self.waiting[0][0] - time.monotonic() if self.waiting else 0.1
            for key, _ in self.selector.select(min(max(wait, 0.0), 0.1)):
                self._read(key.fd, key.data)
            self._deliver_what_is_due(time.monotonic())

    def _deliver_what_is_due(self, now):
        while self.waiting and self.waiting[0][0] <= now:
            _, _, name, packet = heapq.heappop(self.waiting)
            self._deliver(name, packet)

    def _read(self, end, sender):
        for _ in range(50):  # others have their turn
            try:
                packet = os.read(end, MTU)
            except BlockingIOError:
                return
            except OSError as error:
                if error.errno in (errno.EIO, errno.EBADFD):  # the link is down
                    return
                raise
            self._pass_on(sender, packet)

    def _pass_on(self, sender, packet):
        header = 4 * (packet[0] & 15)
        if packet[0] >> 4 != 4 or packet[9] != UDP:
            return
        message = bus_messages.parse(packet[header + 8:])
        now, fate, fates = time.monotonic(), self.fate, {}
        self._deliver_what_is_due(now)  # a stall's last is not overtaken
        if message:
            self.take(sender, message, fates)
        for name in self.ends:
            if name == sender:
                continue
            delays = ARRIVES if fate is None else fate(now)
            if delays != ARRIVES:
                fates[name] = delays
            for delay in delays:
                if delay > 0.0:
                    heapq.heappush(self.waiting, (now + delay, next(self.numbers), name, packet))
                elif not self._deliver(name, packet):
                    fates[name] = LOST

    def _deliver(self, name, packet):
        try:
            os.write(self.ends[name], packet)
            return True
        except OSError as error:
            if error.errno != errno.EIO:  # the link is down
                raise
            return False
