# SPDX-License-Identifier: MIT
"""Zero offsets by name, for HMIs and PLCs: ``V.G.NP[1].V.X``, with ``CH2.`` of channel 2.

In: names, values in mm and degrees. Out: the offsets that the decoder works with. A write counts
when the decoder next selects the group (G54 is group 1), as if a program had assigned it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Protocol

from nctakt.base.failure import Failure
from nctakt.decoder.state.axis_places import ChannelPlaces
from nctakt.decoder.state.geometry.offsets import ActiveOffsets
from nctakt.hli.checked_values import number_of, split_channel
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import VALUE_NOT_OF_TYPE
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.messages.programs.checked_values import UNKNOWN_AXIS_OF_VARIABLE
from nctakt.messages.programs.offsets import UNKNOWN_ZERO_OFFSET

Scalar = float | bool | str

_NAME = re.compile(r"V\.G\.NP\[\s*(\d{1,9})\s*\]\.V\.(\w+)", re.IGNORECASE)


class ChannelOffsets(Protocol):
    """A channel with its offsets (``AssembledChannel``)."""

    @property
    def offsets(self) -> ActiveOffsets:
        """Its offsets."""

    @property
    def places(self) -> ChannelPlaces:
        """Its axes by their places."""


def is_zero_offset(name: str) -> bool:
    """Return whether a name is meant for a numbered zero offset of an axis."""
    return _NAME.fullmatch(split_channel(name)[2].strip()) is not None


class ZeroOffsetAccess:
    """The zero offsets of all channels of a machine; each call raises ``Failure``."""

    def __init__(self, channels: Mapping[int, ChannelOffsets]) -> None:
        self._channels = channels

    def _find(self, name: str) -> tuple[dict[int, dict[int, float]], int, int]:
        """Return the groups of the channel, the group, and the place of the axis."""
        _, number, path = split_channel(name)
        channel = self._channels.get(number)
        if channel is None:
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=len(self._channels)))
        match = _NAME.fullmatch(path.strip())
        assert match is not None
        group, axis = int(match[1]), match[2].upper()
        if group >= MAX_GROUPS:
            raise Failure(diagnostic(UNKNOWN_ZERO_OFFSET, group=group, highest=MAX_GROUPS - 1))
        names = channel.places.names
        if axis not in names:
            shown = ", ".join(names)
            raise Failure(diagnostic(UNKNOWN_AXIS_OF_VARIABLE, name=name, axis=axis, axes=shown))
        return channel.offsets.zero_groups, group, names.index(axis)

    def read(self, name: str) -> float:
        """Return an offset in mm or degrees."""
        groups, group, slot = self._find(name)
        return groups.get(group, {}).get(slot, 0.0)

    def check(self, name: str, value: Scalar) -> float:
        """Return the number that would be written."""
        self._find(name)
        if isinstance(value, str):
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type="REAL64", value=value))
        return number_of(name, "REAL64", float(value))

    def write(self, name: str, value: Scalar) -> None:
        """Set an offset."""
        number = self.check(name, value)
        groups, group, slot = self._find(name)
        groups.setdefault(group, {})[slot] = number
