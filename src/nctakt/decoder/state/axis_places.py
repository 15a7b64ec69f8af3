# SPDX-License-Identifier: MIT
"""The places of a channel, and the axes at them: by their lists, and as exchanged.

A place is an index into the positions of the path; 0 … 2 are those of the main axes. A place
without an axis has a name that no program can write, and an axis that never moves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import inf

from nctakt.base.dataclass import dataclass
from nctakt.decoder.kinematics.selection import ChannelAxes
from nctakt.decoder.state.queued.commands import DecoderWait
from nctakt.lists.machine.axis_configuration import AxisConfiguration


@dataclass(frozen=True, slots=True)
class AxisPlace:
    """An axis of a channel: its name in programs, its number in the machine."""

    name: str
    index: int


#: The axes at the places of a channel, ``None`` at a free one.
Places = tuple[AxisPlace | None, ...]


@dataclass(frozen=True, slots=True)
class ExchangeAxes(DecoderWait):
    """The channel has these axes from here on, which then answer with their positions.

    ``members`` as ``Path.set_axes`` takes them. ``awaited``: the axes among them that the channel
    must get first; numbers in the machine.
    """

    members: tuple[int, ...]
    awaited: tuple[int, ...]


class AxisNotInChannelError(Exception):
    """A program names an axis that its channel does not have at this moment."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class AxisIndices(dict[str, int]):
    """Axis name -> its place; raises ``AxisNotInChannelError`` for another name."""

    def __missing__(self, name: str) -> int:
        raise AxisNotInChannelError(name)


def indices_of(places: Places) -> AxisIndices:
    """Return the places by the names of their axes; a free one has its own name."""
    return AxisIndices(
        (f"#{index}" if slot is None else slot.name, index) for index, slot in enumerate(places)
    )


def trimmed(places: Sequence[AxisPlace | None]) -> Places:
    """Return the places up to the last one with an axis."""
    last = max((index for index, slot in enumerate(places) if slot is not None), default=-1)
    return tuple(places[: last + 1])


@dataclass(slots=True)
class ChannelPlaces:
    """The axes of one channel.

    ``machine_axes``: all of the machine. ``by_number``: logical number -> number in the machine of
    those that can be fetched. ``spindles``: logical number -> spindle and channel that it turns.
    ``listed``: the places of the list, ``present`` those at this point of decoding. ``room``: how
    many places there can be. ``holder``: returns the channel that has an axis, 0 for none.
    ``c_axes``: as ``by_number``, of main spindles that can be axes of a path. ``without_axis``:
    returns the spindles of the channel that have given their axes away. ``c_axis``: number in the
    machine of the main spindle's axis, -1 where ``#CAX`` is not possible.
    """

    machine_axes: tuple[AxisConfiguration, ...]
    by_number: Mapping[int, int]
    spindles: Mapping[int, tuple[str, int]]
    listed: Places
    present: Places
    room: int
    holder: Callable[[int], int]
    c_axes: Mapping[int, int]
    without_axis: Callable[[], list[int]]
    c_axis: int = -1

    @property
    def is_exchanged(self) -> bool:
        """Whether the axes are not those of the list."""
        return self.present is not self.listed and self.present != self.listed

    @property
    def c_axis_name(self) -> str:
        """The name of the axis that the main spindle is (``#CAX``); empty: it is a spindle."""
        if self.c_axis >= 0:
            for slot in self.present:
                if slot is not None and slot.index == self.c_axis:
                    return slot.name
        return ""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the places, as in ``indices_of``."""
        return tuple(indices_of(self.present))

    def name(self, slot: int) -> str:
        """Return the name of the axis at a place, as in programs; that in its list may differ."""
        return self.names[slot]

    def is_free(self, slot: int) -> bool:
        """Return whether no axis is at a place at this moment of decoding."""
        return self.present[slot] is None

    def lacks_any(self, indices: Iterable[int]) -> bool:
        """Return whether one of these places has no axis at this point of decoding."""
        present = self.present
        for index in indices:  # no generator: each arc asks
            if index >= len(present) or present[index] is None:
                return True
        return False

    def axis_of(self, slot: AxisPlace | None) -> AxisConfiguration:
        """Return the axis at a place; some axis for a free one, which never moves."""
        return self.machine_axes[0 if slot is None else slot.index]

    def members(self, places: Places) -> list[int]:
        """Return the numbers of the axes as ``Path.set_axes`` takes them."""
        free = len(self.machine_axes)
        return [free if slot is None else slot.index for slot in places]

    def own_axes(self, places: Places) -> ChannelAxes:
        """Return the axes at these places as transformations and offsets take them."""
        axes = [self.axis_of(slot) for slot in places]
        return ChannelAxes(
            tuple(indices_of(places)),
            tuple(-1 if slot is None else slot.index for slot in places),
            tuple(not axis.is_linear for axis in axes),
            tuple(
                (-inf, inf)
                if axis.is_modulo
                else (axis.software_limit_low, axis.software_limit_high)
                for axis in axes
            ),
        )

    def logical(self, index: int) -> int:
        """Return the logical number of an axis of the machine."""
        return self.machine_axes[index].logical_number
