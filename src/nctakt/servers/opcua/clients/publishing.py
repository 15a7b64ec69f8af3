# SPDX-License-Identifier: MIT
"""The encoded messages with changes for clients.

A value is written once for all clients that monitor it; here it is put after its handle.
"""

from __future__ import annotations

import struct
import time
from collections.abc import Sequence

from nctakt.servers.clock import FILETIME_1970

#: Numbers of the binary encodings of messages and notifications.
_PUBLISH_RESPONSE, _DATA, _EVENTS, _STATUS = 829, 811, 916, 820


def now_units() -> int:
    """Return the time in units of OPC UA."""
    return time.time_ns() // 100 + FILETIME_1970


def _type(number: int) -> bytes:
    return struct.pack("<BBH", 1, 0, number)


def _extension(number: int, body: bytes) -> bytes:
    return _type(number) + struct.pack("<Bi", 1, len(body)) + body


def data_notification(contents: Sequence[bytes]) -> bytes:
    """Return a notification of data changes; ``contents``: handles with their values."""
    body = struct.pack("<i", len(contents)) + b"".join(contents) + struct.pack("<i", -1)
    return _extension(_DATA, body)


def event_notification(contents: Sequence[bytes]) -> bytes:
    """Return a notification of events; ``contents``: handles with their fields."""
    return _extension(_EVENTS, struct.pack("<i", len(contents)) + b"".join(contents))


def status_notification(status: int) -> bytes:
    """Return a notification that a subscription has ended."""
    return _extension(_STATUS, struct.pack("<IB", status, 0))


def notification_message(sequence: int, parts: Sequence[bytes]) -> bytes:
    """Return a message with notifications; without any it says that the server is alive."""
    head = struct.pack("<Iqi", sequence, now_units(), len(parts))
    return head + b"".join(parts)


def publish_response(
    request_handle: int,
    subscription: int,
    available: Sequence[int],
    message: bytes,
    results: Sequence[int],
    *,
    is_more: bool,
) -> bytes:
    """Return a publish response."""
    header = struct.pack("<qIIBi", now_units(), request_handle, 0, 0, -1) + b"\0\0\0"
    listed = struct.pack(f"<i{len(available)}I", len(available), *available)
    answers = struct.pack(f"<i{len(results)}I", len(results), *results)
    return b"".join(
        (
            _type(_PUBLISH_RESPONSE),
            header,
            struct.pack("<I", subscription),
            listed,
            struct.pack("<?", is_more),
            message,
            answers,
            struct.pack("<i", -1),
        )
    )
