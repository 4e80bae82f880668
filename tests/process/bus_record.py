"""What is said on a bus, taken down by a thread without LCM."""

import select
import threading
import time
import typing

import bus_messages
from machines import listening_socket


class Sent(typing.NamedTuple):
    """One message, and what became of it on the way to others."""
    time: float  # [s] monotonic, when it was heard
    machine: str  # whence; "": not known
    channel: str
    stamp: bus_messages.Stamp
    fates: dict  # machine -> delays of its copies [s], none: lost. Not listed: it arrived at once.


class Record:
    """The lists only grow, so that other threads may read them."""

    def __init__(self):
        self.sent = []  # of Sent
        self.statuses = []  # (time, payload)
        self.payloads = {}  # channel -> the last one

    def take(self, machine, message, fates):
        now, (channel, payload) = time.monotonic(), message
        self.payloads[channel] = payload
        self.sent.append(Sent(now, machine, channel, bus_messages.stamp_of(payload), fates))
        if channel.startswith("STATUS_"):
            self.statuses.append((now, payload))


class Listener(Record):
    """Hears all on one machine, or what the filter lets through (socket_filters)."""

    def __init__(self, machine, let_through=None):
        super().__init__()
        with machine.inside():
            self.socket = listening_socket()
        if let_through:
            let_through(self.socket)
        self.stopping = False
        self.thread = threading.Thread(target=self._run, daemon=True)

    def start(self):
        self.thread.start()

    def stop(self):
        self.stopping = True
        self.thread.join()
        self.socket.close()

    def _run(self):
        while not self.stopping:
            if not select.select([self.socket], [], [], 0.1)[0]:
                continue
            message = bus_messages.parse(self.socket.recv(65536))
            if message:
                self.take("", message, {})
