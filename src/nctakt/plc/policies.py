# SPDX-License-Identifier: MIT
"""When a PLC acknowledges functions, and jobs of spindles that it turns: as small objects.

``ALL`` at once, ``NONE`` never, ``after("20 ms")`` late, ``only("M100", "H7")`` some of them;
``run_up(rpm_per_s)`` spindles alone, when they have the speed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.times import Time, TimeLike, read_time

if TYPE_CHECKING:
    from nctakt.run.plc_view import PlcView, SpindleEntry, TechnologyEntry


class Policy(Protocol):
    """Says whether a function, or a spindle's job, is acknowledged after this tick."""

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Asked after each tick for each one that waits."""


class SpindlePolicy(Protocol):
    """Says whether a spindle's job is acknowledged after this tick."""

    def answers(self, job: SpindleEntry, hli: PlcView, /) -> bool:
        """Asked after each tick for each job that waits."""


@dataclass(frozen=True, slots=True)
class Always:
    """Acknowledges or not, whatever waits."""

    answer: bool

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return the same for all."""
        return self.answer


#: M19 of a spindle.
_POSITION = 19

ALL = Always(True)
NONE = Always(False)


@dataclass(frozen=True, slots=True)
class After:
    """Acknowledges once a function has waited for this time; 0: behind its own tick."""

    time: Time

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return whether its time has come."""
        return hli.time_us - function.time_us >= self.time.us(hli.cycle_time_us)


@dataclass(frozen=True, slots=True)
class Only:
    """Acknowledges the functions or spindles of these names as ``then`` says, all others never."""

    names: frozenset[str]
    then: Policy = ALL

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return whether it is one of them, and ``then`` answers."""
        return function.name in self.names and self.then.answers(function, hli)


@dataclass(frozen=True, slots=True)
class RunUp:
    """Acknowledges a job when the spindle can have its speed, from that of its last job on.

    M19 turns up to its speed and down to a stand.
    """

    rpm_per_s: float

    def answers(self, job: SpindleEntry, hli: PlcView) -> bool:
        """Return whether the time of the change of speed is over with this tick."""
        speed = {3: job.speed, 4: -job.speed, 19: job.speed}.get(job.function, 0.0)
        change = abs(speed - job.speed_before)
        if job.function == _POSITION:
            change += job.speed
        over_us = hli.time_us + hli.cycle_time_us - job.time_us
        return over_us * self.rpm_per_s >= change * 1e6 * (1 - 1e-9)


def after(time: TimeLike) -> After:
    """Acknowledge each function this time after the tick in which it appeared.

    ``after("20 ticks")``, ``after("5 ms")``; a number alone means seconds. Raises ``Failure`` for
    what is not a time.
    """
    return After(read_time(time))


def run_up(rpm_per_s: float) -> RunUp:
    """Acknowledge a spindle's job when its speed, which changes so fast, is reached."""
    if not 0.0 < rpm_per_s < float("inf"):
        raise ValueError(f"a spindle cannot change its speed by {rpm_per_s} per second")
    return RunUp(rpm_per_s)


def only(*names: str, then: Policy = ALL) -> Only:
    """Acknowledge ``M100``, ``H7``, ``S3`` … alone; ``then`` says when."""
    return Only(frozenset(name.upper() for name in names), then)
