"""Kernel filters (classic BPF) on a test's own sockets: they count, or keep out, unread."""

import ctypes
import socket
import struct

SO_ATTACH_FILTER, SO_MEMINFO = 26, 55  # <asm/socket.h>
DROPS = 8  # SK_MEMINFO_DROPS, <linux/sock_diag.h>
LOAD, JUMP_EQUAL, RETURN = 0x20, 0x15, 0x06  # <linux/filter.h>: a word at k; == k; k bytes
CHANNEL_AT = 16  # [bytes] behind the headers of UDP and LCM
ALL = 0xFFFFFFFF


def attach(sock, *instructions):
    code = b"".join(struct.pack("HBBI", *one) for one in instructions)
    buffer = ctypes.create_string_buffer(code)
    program = struct.pack("HxxxxxxP", len(instructions), ctypes.addressof(buffer))
    sock.setsockopt(socket.SOL_SOCKET, SO_ATTACH_FILTER, program)


def _word(text):
    return struct.unpack(">I", text)[0]


def let_nothing_through(sock):
    """What arrives is only counted: see drops."""
    attach(sock, (RETURN, 0, 0, 0))


def let_status_through(sock):
    """Messages on STATUS_*, but not those that a hostile sender calls STATUS_X."""
    attach(sock, (LOAD, 0, 0, CHANNEL_AT), (JUMP_EQUAL, 0, 3, _word(b"STAT")),
           (LOAD, 0, 0, CHANNEL_AT + 4), (JUMP_EQUAL, 1, 0, _word(b"US_X")),
           (RETURN, 0, 0, ALL), (RETURN, 0, 0, 0))


def drops(sock):
    """Datagrams kept out since it was opened, or for which there was no room."""
    words = sock.getsockopt(socket.SOL_SOCKET, SO_MEMINFO, 64)
    return struct.unpack_from("I", words, 4 * DROPS)[0]
