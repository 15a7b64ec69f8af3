# SPDX-License-Identifier: MIT
"""The time of a run as data: stretches of ticks with their purposes and limits.

In each channel each tick of the run belongs to exactly one stretch, so that all sums are whole
ticks and equal those of the run.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING, Literal, TypeVar

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text

if TYPE_CHECKING:
    from nctakt.results.run import Run

#: Activities of a channel in a tick. ``commands``: the path rests between two blocks, for commands
#: or for the decoder; ``idle``: its program has not begun or is over.
TimeKind = Literal["rapid", "feed", "dwell", "wait", "commands", "backward", "idle"]

#: How the speed on the path changes in a tick.
Phase = Literal["accelerating", "constant", "braking", "standing"]

#: Limits of the path in a tick; ``wait``: the reason why the program waits.
Cause = Literal[
    "feed",
    "override operator",
    "override cycle",
    "override both",
    "override program",
    "speed",
    "acceleration",
    "jerk",
    "curvature",
    "rounding",
    "corner",
    "next feed",
    "next limit",
    "exact stop",
    "standstill",
    "horizon",
    "spindle",
    "hold",
    "stop",
    "tick",
    "wait",
    "programmed",
    "none",
    "unknown",
]

_Key = TypeVar("_Key", bound=Hashable)

NOTHING = Text("", "")


@dataclass(frozen=True, slots=True)
class Limit:
    """A cause with its details: an axis, a line, a realtime cycle, the awaited event."""

    cause: Cause
    detail: Text = NOTHING


@dataclass(frozen=True, slots=True)
class Purpose:
    """The purpose of ticks.

    ``calls``: the programs that are open, the main program first. ``span``: the block or command;
    ``number``: its N number, 0 without one. ``tool``: the latest T word, 0 without one.
    """

    channel: int
    calls: tuple[str, ...]
    span: Span | None
    number: int
    tool: int
    kind: TimeKind
    phase: Phase
    limit: Limit


@dataclass(frozen=True, slots=True)
class Stretch:
    """Successive ticks of a channel with one purpose."""

    purpose: Purpose
    first_tick: int
    ticks: int


@dataclass(frozen=True, slots=True)
class Times:
    """The stretches of the first ``ticks`` ticks of a run, by channel, then in the order of time.

    ``lines``: the source lines of the blocks by their spans.
    """

    ticks: int
    cycle_time_us: int
    channels: int
    stretches: tuple[Stretch, ...]
    lines: dict[Span, str]

    def by(self, key: Callable[[Purpose], _Key], channel: int | None = None) -> dict[_Key, int]:
        """Return the ticks for each key, in order of appearance; ``None``: of all channels."""
        found: dict[_Key, int] = {}
        for stretch in self.stretches:
            if channel in (None, stretch.purpose.channel):
                one = key(stretch.purpose)
                found[one] = found.get(one, 0) + stretch.ticks
        return found

    def us(self, ticks: int) -> int:
        """Return the length of ticks in microseconds."""
        return ticks * self.cycle_time_us


@dataclass(frozen=True, slots=True)
class TimeAccount(Times):
    """A run and its times."""

    run: Run
