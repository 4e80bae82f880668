"""Machines for tests: network namespaces that this process makes, enters, and joins by cables.

A program is started on one by putting `command` before its words; a socket that is opened `inside`
stays there. Everything is gone with this process.
"""

import contextlib
import ctypes
import os
import socket
import struct
import subprocess
import sys

SKIPPED = 77  # exit code, for ctest
GROUP, PORT = "239.255.76.67", 7667  # LCM's own defaults
SO_RCVBUFFORCE = 33  # <asm/socket.h>
ROOM = 64 * 1024 * 1024  # [bytes] for seconds of all messages
CLONE_NEWNET = 0x40000000  # <sched.h>
LIBC = ctypes.CDLL(None, use_errno=True)


def skip(why):
    print("[  SKIPPED ]", why, flush=True)
    sys.exit(SKIPPED)


def check(result):
    """Of a call of LIBC."""
    if result != 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))


class Machine:
    """One network namespace."""

    def __init__(self, name):
        self.name = name
        with open("/proc/thread-self/ns/net", "rb") as home:
            try:
                check(LIBC.unshare(CLONE_NEWNET))
            except OSError as error:
                skip(f"no network namespace can be had: {error}")
            self.namespace = open("/proc/thread-self/ns/net", "rb")
            check(LIBC.setns(home.fileno(), CLONE_NEWNET))
        self.ip("link set lo up")

    @contextlib.contextmanager
    def inside(self):
        """What this thread opens in here belongs to the machine."""
        with open("/proc/thread-self/ns/net", "rb") as home:
            check(LIBC.setns(self.namespace.fileno(), CLONE_NEWNET))
            try:
                yield
            finally:
                check(LIBC.setns(home.fileno(), CLONE_NEWNET))

    @property
    def path(self):
        return f"/proc/{os.getpid()}/fd/{self.namespace.fileno()}"

    def alone(self):
        """Its bus is within it."""
        self.ip("link set lo multicast on")
        self.ip("route add 224.0.0.0/4 dev lo")

    def command(self, words):
        return ["nsenter", f"--net={self.path}", *map(str, words)]

    def ip(self, arguments):
        subprocess.run(self.command(["ip", *arguments.split()]), check=True)

    def count_fragments(self):
        """The kernel's counts of IP fragments: made, put together again, and given up."""
        with self.inside(), open("/proc/thread-self/net/snmp", encoding="ascii") as file:
            names, values = [line.split()[1:] for line in file if line.startswith("Ip:")]
        counts = dict(zip(names, map(int, values)))
        return {name: counts[name] for name in ("FragCreates", "ReasmOKs", "ReasmFails")}


def join(first, second, mtu=1500):
    """A cable between two machines, 10.9.0.1 and 10.9.0.2, on which all multicast goes."""
    first.ip(f"link add name cable mtu {mtu} type veth peer name cable mtu {mtu} "
             f"netns {second.path}")
    for number, machine in enumerate((first, second), 1):
        machine.ip(f"address add 10.9.0.{number}/24 dev cable")
        machine.ip("link set cable up")
        machine.ip("route add 224.0.0.0/4 dev cable")


def sending_socket():
    """Not connected; what it sends to the group stays in the network."""
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
    return sender


def listening_socket():
    """On the bus, beside others, with room for seconds of everything."""
    listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
    try:
        listener.setsockopt(socket.SOL_SOCKET, SO_RCVBUFFORCE, ROOM)
    except PermissionError:  # not root: as much as is allowed
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, ROOM)
    listener.bind(("", PORT))
    listener.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP,
                        struct.pack("4sI", socket.inet_aton(GROUP), socket.INADDR_ANY))
    return listener
