"""LCM's datagrams and our messages, for tests: no LCM library, only what lcm-gen makes."""

import importlib
import pathlib
import struct
import subprocess
import sys
import typing

TYPES = pathlib.Path(__file__).resolve().parents[2] / "lcmtypes"
MAGIC = b"LC02"  # a message in one datagram

# What a component counts although no message was turned down.
ONLY_COUNTED = ("beam", "ignored in the file")


def datagram(channel, payload, number=0):
    return MAGIC + struct.pack(">I", number) + channel.encode() + b"\0" + payload


def parse(data):
    """Channel and payload; none where it is no whole message."""
    if data[:4] != MAGIC:
        return None
    end = data.find(b"\0", 8)
    return None if end < 0 else (data[8:end].decode("ascii", "replace"), data[end + 1:])


class Stamp(typing.NamedTuple):
    """What each data message begins with; of a STATUS the session is the boot."""
    utime: int
    session: int
    seq: int


def stamp_of(payload):
    return Stamp(*struct.unpack_from(">qqq", payload, 8)) if len(payload) >= 32 else Stamp(0, 0, -1)


def generated_types(folder):
    """The package `pico` as lcm-gen makes it for Python."""
    files = map(str, sorted(TYPES.glob("*.lcm")))
    subprocess.run(["lcm-gen", "-p", "--ppath", str(folder), *files], check=True)
    sys.path.insert(0, str(folder))
    return importlib.import_module("pico")


def inputs(status):
    return {entry.channel: entry for entry in status.inputs}


def outputs(status):
    return {entry.channel: entry for entry in status.outputs}


def rejects(status):
    """How often something was turned down or lost, by channel and reason."""
    return {(entry.channel, entry.reason): entry.count for entry in status.rejects
            if not entry.reason.startswith(ONLY_COUNTED)}


def events(log):
    """Channel and payload of each event of an undamaged LCM log."""
    with open(log, "rb") as file:
        while len(header := file.read(28)) == 28:
            *_, name, data = struct.unpack(">IqqII", header)
            yield file.read(name).decode(), file.read(data)


def write_events(log, events):
    """An LCM log of channels and payloads, stamped with each message's own time."""
    with open(log, "wb") as file:
        for number, (channel, payload) in enumerate(events):
            file.write(struct.pack(">IqqII", 0xEDA1DA01, number, stamp_of(payload).utime,
                                   len(channel), len(payload)) + channel.encode() + payload)
