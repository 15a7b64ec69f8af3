# SPDX-License-Identifier: MIT
"""The bytes of a connection <-> the frames of AMS, whole ones only (AD-1).

In: bytes in pieces of any length. Out: frames; ``FrameError`` for other bytes, after which nothing
on the connection can be understood any more. A frame that announces more than allowed is refused on
its announcement; nothing is kept for it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from struct import Struct
from typing import NamedTuple

#: The longest frame, with its header, in bytes.
MAX_FRAME = 4 * 1024 * 1024

#: Flags of a request and of its answer; bit 1 marks the answer.
REQUEST, RESPONSE = 0x0004, 0x0005
_RESPONSE_BIT = 0x0001

#: Reserved, length; NetId and port of target and source, command, flags, length, error, invoke ID.
HEADER = Struct("<HI6sH6sHHHIII")
_AMS_HEADER_BYTES = HEADER.size - 6

_NET_ID = re.compile(r"\d{1,3}(\.\d{1,3}){5}", re.ASCII)


class FrameError(Exception):
    """Bytes that are no frame of AMS."""


class Frame(NamedTuple):
    """A frame: its addresses as NetId and port, its numbers, its data."""

    target_id: bytes
    target_port: int
    source_id: bytes
    source_port: int
    command: int
    flags: int
    error: int
    invoke_id: int
    data: bytes

    @property
    def is_request(self) -> bool:
        """Whether it asks for an answer."""
        return not self.flags & _RESPONSE_BIT

    def encode(self) -> bytes:
        """Return its bytes."""
        size = len(self.data)
        head = HEADER.pack(0, _AMS_HEADER_BYTES + size, *self[:6], size, self.error, self.invoke_id)
        return head + self.data

    def answer(self, data: bytes, error: int = 0) -> bytes:
        """Return the bytes of the answer to it."""
        size = len(data)
        return (
            HEADER.pack(
                0,
                _AMS_HEADER_BYTES + size,
                self.source_id,
                self.source_port,
                self.target_id,
                self.target_port,
                self.command,
                RESPONSE,
                size,
                error,
                self.invoke_id,
            )
            + data
        )


class FrameReader:
    """Cuts the bytes of a connection into frames."""

    def __init__(self, max_frame: int = MAX_FRAME) -> None:
        self._max_frame = max_frame
        self._rest = b""

    @property
    def pending(self) -> int:
        """The number of bytes that are no whole frame yet."""
        return len(self._rest)

    def feed(self, data: bytes) -> Iterator[Frame]:
        """Yield the frames that are whole with these bytes; raises ``FrameError``."""
        if self._rest:
            data = self._rest + data
        at, end = 0, len(data)
        while end - at >= HEADER.size:
            words = HEADER.unpack_from(data, at)
            reserved, length, size = words[0], words[1], words[8]
            if reserved:
                raise FrameError(f"reserved bytes {reserved:#06x}")
            if length != _AMS_HEADER_BYTES + size:
                raise FrameError(f"a frame of {length} bytes with {size} bytes of data")
            if length + 6 > self._max_frame:
                raise FrameError(f"a frame of {length} bytes, more than {self._max_frame}")
            if end - at < length + 6:
                break
            first = at + HEADER.size
            at += length + 6
            yield Frame._make((*words[2:8], words[9], words[10], data[first:at]))
        else:
            if end - at >= 6:
                reserved, length = _FIRST.unpack_from(data, at)
                if reserved or length < _AMS_HEADER_BYTES:
                    raise FrameError(f"reserved {reserved:#06x}, {length} bytes")
        self._rest = data[at:]


_FIRST = Struct("<HI")


def read_net_id(text: str) -> bytes | None:
    """Return the NetId ``5.1.204.160.1.1`` as bytes; ``None`` for another text."""
    if _NET_ID.fullmatch(text) is None:
        return None
    numbers = [int(number) for number in text.split(".")]
    return bytes(numbers) if max(numbers) < 256 else None


def shown_net_id(net_id: bytes) -> str:
    """Return a NetId as text."""
    return ".".join(map(str, net_id))
