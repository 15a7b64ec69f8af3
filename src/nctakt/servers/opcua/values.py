# SPDX-License-Identifier: MIT
"""Values of a machine's nodes: values of the session -> values on the wire.

In: moments, which are the values of a session that belong to one tick. Out: for each node a sample,
made once for a moment, however many clients read it.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from typing import Any

from asyncua import ua

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.servers.clock import MachineClock
from nctakt.servers.opcua.library import variant_to_binary
from nctakt.servers.store import Scalar
from nctakt.session.engine import StateView

#: A value of Python, of the type of its node.
Value = Any

#: Units of the times of OPC UA in a second.
UNITS_S = 10_000_000

#: The parts of a data value: value, status, source's and server's time.
_HAS_ALL, _HAS_STATUS = 0x0F, 0x0E

#: How scalars of these types are on the wire, after the number of their type.
_FORMATS = {
    ua.VariantType.Boolean: "<B?",
    ua.VariantType.SByte: "<Bb",
    ua.VariantType.Byte: "<BB",
    ua.VariantType.Int16: "<Bh",
    ua.VariantType.UInt16: "<BH",
    ua.VariantType.Int32: "<Bi",
    ua.VariantType.UInt32: "<BI",
    ua.VariantType.Int64: "<Bq",
    ua.VariantType.UInt64: "<BQ",
    ua.VariantType.Double: "<Bd",
}


#: Conversions of Python values to these types.
_CASTS: dict[Any, Callable[[Any], Any]] = {
    ua.VariantType.Boolean: bool,
    ua.VariantType.Double: float,
    **{
        kind: int
        for kind in _FORMATS
        if kind not in (ua.VariantType.Boolean, ua.VariantType.Double)
    },
}


class NotSupported(Exception):
    """There is no such value here now, or never; ``status``: the code of OPC UA."""

    def __init__(self, status: int = ua.StatusCodes.BadNotSupported) -> None:
        super().__init__(status)
        self.status = status


@dataclass(frozen=True, slots=True)
class ValueSnapshot:
    """A session at a single tick.

    ``blocks``: the place of the current block of each channel. ``state_view``: cycles and channels,
    where somebody wants them.
    """

    tick: int
    values: Mapping[str, Scalar]
    blocks: Mapping[int, Span]
    state_view: StateView | None = None

    def number(self, name: str) -> float:
        """Return a value that is a number."""
        return float(self.values[name])


@dataclass(frozen=True, slots=True)
class Sample:
    """A value at a moment: its variant with the status, and as a whole, on the wire."""

    value: Value
    status: int
    content: bytes
    wire: bytes


@dataclass(slots=True, eq=False)
class Live:
    """A node whose value is that of the session.

    ``names``: values of the session that ``read`` needs. ``write_name``: the one that a client
    writes; empty if it cannot. ``signal``: the one whose history it has, times ``factor``.
    ``range``: of its unit, for deadbands in percent.
    """

    kind: ua.VariantType
    read: Callable[[ValueSnapshot], Value]
    names: tuple[str, ...] = ()
    is_array: bool = False
    needs_state_view: bool = False
    write_name: str = ""
    to_session: Callable[[Value], Scalar] | None = None
    signal: str = ""
    factor: float = 1.0
    range: tuple[float, float] | None = None
    _moment: ValueSnapshot | None = field(default=None, init=False)
    _sample: Sample | None = field(default=None, init=False)

    def sample(self, moment: ValueSnapshot, clock: MachineClock, now_units: int) -> Sample:
        """Return its value at a moment; the same object for the same moment."""
        if moment is self._moment and self._sample is not None:
            return self._sample
        last = self._sample
        value, status, content = self._content(moment)
        if last is not None and last.content == content and last.status == status:
            value = last.value
        times = struct.pack("<qq", clock.filetime(moment.tick), now_units)
        if content:
            wire = bytes((_HAS_ALL,)) + content + struct.pack("<I", status) + times
        else:
            wire = bytes((_HAS_STATUS,)) + struct.pack("<I", status) + times
        self._moment, self._sample = moment, Sample(value, status, content, wire)
        return self._sample

    def _content(self, moment: ValueSnapshot) -> tuple[Value, int, bytes]:
        try:
            value = self.read(moment)
        except NotSupported as reason:
            return None, reason.status, b""
        except (KeyError, IndexError):
            return None, int(ua.StatusCodes.BadNoData), b""
        value = self.cast(value)
        return value, 0, self._variant(value)

    def cast(self, value: Value) -> Value:
        """Return a value of the session as one of the node's type."""
        cast = None if self.is_array else _CASTS.get(self.kind)
        return value if cast is None else cast(value)

    def _variant(self, value: Value) -> bytes:
        """Return a value as a variant on the wire."""
        pattern = None if self.is_array else _FORMATS.get(self.kind)
        if pattern is not None:
            return struct.pack(pattern, int(self.kind), value)
        variant = ua.Variant(value, self.kind, is_array=self.is_array)
        return bytes(variant_to_binary(variant))

    def data_value(self, moment: ValueSnapshot, clock: MachineClock) -> ua.DataValue:
        """Return its value at a moment as the library shows it."""
        value, status, _ = self._content(moment)
        variant = ua.Variant(value, self.kind, is_array=self.is_array) if status == 0 else None
        return ua.DataValue(
            Value=variant,
            StatusCode=ua.StatusCode(status),
            SourceTimestamp=clock.time(moment.tick),
            ServerTimestamp=datetime.now(UTC),
        )
