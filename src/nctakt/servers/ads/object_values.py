# SPDX-License-Identifier: MIT
"""The values of CNC objects by their numbers: values shown, asked for, kept (AD-4)."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from struct import Struct, calcsize, iter_unpack, pack, unpack

from nctakt.hli.interface_memory import ASKED, AreaShape
from nctakt.lists.declared.variables import SCALARS
from nctakt.nc.vocabulary.variables import strings
from nctakt.run.access.interface_access import ASK, JOB, KEPT
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import NUMERIC
from nctakt.servers.store import Scalar

#: How many units of 0.1 µm and 0.0001° a mm or a degree is.
INCREMENTS = 10_000.0

#: Prefixes of the names of values without a signal: the session is asked at each read.
STATE_VIEW = ASKED
#: The name of the tick in the values that are asked.
TICK = f"{STATE_VIEW}tick"


def number_bytes(type_: str, number: float) -> bytes:
    """Return a number as a type has it, within its bounds."""
    code = "q" if type_ == "SGN64" else NUMERIC[type_][0]
    if code == "d":
        return pack("<d", number)
    if type_ == "BOOLEAN":
        return pack("<B", number != 0.0)
    if not math.isfinite(number):
        return bytes(calcsize(f"<{code}"))
    low, high = SCALARS[type_].low, SCALARS[type_].high
    return pack(f"<{code}", int(min(max(round(number), low), high)))


class _Value:
    """A value that is only read, where nothing else is said."""

    names: tuple[str, ...] = ()
    size_bytes = 0

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Raise ``AdsError``: it cannot be written."""
        raise AdsError(Error.ACCESS, "it cannot be written")


class Shown(_Value):
    """A number that shows a value of the session."""

    def __init__(self, name: str, type_: str, shown: Callable[[float], float]) -> None:
        self.names = (name,)
        self.size_bytes = calcsize(f"<{NUMERIC[type_][0]}")
        self._type = type_
        self._shown = shown

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where the value is missing."""
        return number_bytes(self._type, self._shown(float(values[self.names[0]])))


class Viewed(_Value):
    """Values without a signal that the session knows: the feed of a channel, its zero offset."""

    def __init__(self, word: str, channel: int, type_: str) -> None:
        self.names = (f"{STATE_VIEW}{channel}.{word}",)
        self.size_bytes = calcsize(f"<{NUMERIC[type_][0]}")
        self._type = type_

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where the value is missing."""
        return number_bytes(self._type, float(values[self.names[0]]))


class Ticks(_Value):
    """The number of ticks that have been run."""

    names: tuple[str, ...] = (TICK,)
    size_bytes = 4

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where the value is missing."""
        return pack("<I", int(values[TICK]) & 0xFFFFFFFF)


class Asked(_Value):
    """An element of the interface; ``is_unit``: a request of the HMI to a control unit."""

    def __init__(self, area: AreaShape, path: str, type_: str, *, is_unit: bool) -> None:
        name = f"{area.name}.{path}"
        self.names = (f"{ASK}{name}" if is_unit else name,)
        self._is_unit = is_unit
        self._type = type_
        self.size_bytes = calcsize(f"<{NUMERIC[type_][0]}")

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where a value is missing."""
        return number_bytes(self._type, float(values[self.names[0]]))

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the request to the control unit; raises ``AdsError``."""
        if not self._is_unit:
            raise AdsError(Error.ACCESS, "it cannot be written")
        if len(data) != self.size_bytes:
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        (number,) = unpack(f"<{NUMERIC[self._type][0]}", data)
        return {self.names[0]: float(number)}


class Pressed(Asked):
    """A key of a control unit: any write presses it."""

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the key that is pressed; raises ``AdsError``."""
        super().write(data)
        return {self.names[0]: 1.0}


class Job(_Value):
    """The order to a channel to work through a program file; it reads as an empty text."""

    def __init__(self, area: AreaShape, size: int) -> None:
        self.names = (f"{JOB}{area.name}",)
        self.size_bytes = size

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return zeros; raises ``KeyError`` where the value is missing."""
        return bytes(self.size_bytes) if values[self.names[0]] == "" else b""

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the program that is begun; raises ``AdsError``."""
        if len(data) > self.size_bytes:
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        program = strings.decode(data).strip()
        if not program:
            raise AdsError(Error.PARAMETER, "no program is named")
        return {self.names[0]: program}


class Kept(_Value):
    """Bytes without an effect, which are read back; ``key``: those with the same one are one."""

    def __init__(self, key: str, size: int, is_writable: bool) -> None:
        self.names = (f"{KEPT}{key}",)
        self.size_bytes = size
        self._is_writable = is_writable

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where they are missing."""
        data = bytes.fromhex(str(values[self.names[0]]))
        return data[: self.size_bytes].ljust(self.size_bytes, b"\0")

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the bytes that are kept; raises ``AdsError``."""
        if not self._is_writable:
            raise AdsError(Error.ACCESS, "it cannot be written")
        if len(data) > self.size_bytes or (len(data) < self.size_bytes and self.size_bytes < 16):
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        return {self.names[0]: data.hex()}


class ZeroOffsets(_Value):
    """A zero offset of all axes of a channel (``V.G.NP[1].V``), an SGN32 of 0.1 µm each."""

    def __init__(self, names: Sequence[str]) -> None:
        self.names = tuple(names)
        self._format = Struct(f"<{len(self.names)}i")
        self.size_bytes = self._format.size

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return their bytes; raises ``KeyError`` where a value is missing."""
        return b"".join(
            number_bytes("SGN32", float(values[name]) * INCREMENTS) for name in self.names
        )

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the offsets in mm and degrees, of the first axes as well; raises ``AdsError``."""
        if not data or len(data) > self.size_bytes or len(data) % 4:
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        numbers = (number for (number,) in iter_unpack("<i", data))
        return {name: n / INCREMENTS for name, n in zip(self.names, numbers, strict=False)}
