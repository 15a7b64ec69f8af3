# SPDX-License-Identifier: MIT
"""Commands for single axes of the machine, by their numbers: homing, software limits."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class Home(Command):
    """An axis begins to move to its zero pulse, by ``distance`` mm or degrees; ``speed``: per s."""

    packed_as = rows.HOME

    axis: int
    distance: float
    speed: float


@dataclass(frozen=True, slots=True)
class Refer(Command):
    """The place where an axis is now is this position, in mm or degrees."""

    packed_as = rows.REFER

    axis: int
    position: float


@dataclass(frozen=True, slots=True)
class FeedForward(Command):
    """Another share of the command speed of an axis bypasses its position control."""

    packed_as = rows.FEED_FORWARD

    axis: int
    share: float


@dataclass(frozen=True, slots=True)
class MoveAlone(Command):
    """An axis begins an independent motion: to a position, or by a distance, mm or degrees."""

    packed_as = rows.MOVE_ALONE

    axis: int
    value: float
    speed: float
    is_relative: bool


@dataclass(frozen=True, slots=True)
class Oscillate(Command):
    """An axis begins to move to and fro between two positions, mm or degrees.

    ``stroke``: the distance from the first to the second. ``count``: how often it reaches the
    second, -1 until it is ended.
    """

    packed_as = rows.OSCILLATE

    axis: int
    first: float
    second: float
    stroke: float
    speed: float
    first_ticks: int
    second_ticks: int
    count: int


@dataclass(frozen=True, slots=True)
class EndOscillation(Command):
    """The oscillation of an axis ends; ``how``: ``codes.FINISHES`` …, ``speed`` of RETURNS."""

    packed_as = rows.END_OSCILLATION

    axis: int
    how: int
    speed: float


@dataclass(frozen=True, slots=True)
class SetSoftwareLimits(Command):
    """The software limits of the independent motions of an axis, in mm or degrees."""

    packed_as = rows.SOFTWARE_LIMITS

    axis: int
    low: float
    high: float
