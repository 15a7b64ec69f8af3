# SPDX-License-Identifier: MIT
"""Policies of a PLC for the acknowledgement of functions, and of jobs of its spindles.

``ALL`` at once, ``NONE`` never, ``after("20 ms")`` later, ``only("M100", "H7")`` some of them;
``run_up(rpm_per_s)`` spindles only, when they have reached their speed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.hli.function_codes import LETTERS, code_of, function_name
from nctakt.kernel.tick.plc_calls import Delays
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, TimeLike, read_time

if TYPE_CHECKING:
    from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
    from nctakt.run.plcs.plc_view import PlcView


#: A tick, or a number of ticks, that no run reaches.
NEVER = 1 << 62

#: Digits of the longest number of a function.
_MAX_DIGITS = 10


class Policy(Protocol):
    """Decides whether a function, or a spindle's job, is acknowledged after this tick."""

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return whether to acknowledge it; called after each tick for each waiting one."""


class SpindlePolicy(Protocol):
    """Decides whether a spindle's job is acknowledged after this tick."""

    def answers(self, job: SpindleEntry, hli: PlcView, /) -> bool:
        """Return whether to acknowledge it; called after each tick for each waiting job."""


@dataclass(frozen=True, slots=True)
class Always:
    """Acknowledges everything, or nothing.

    >>> class Silent(Plc):
    ...     acknowledge = NONE
    >>> program = NcText("clamp.nc", "M111\\nG01 X1 F600\\nM30")
    >>> Controller().run(program, plc=Silent(), until="1 s").state
    'limit'
    >>> Controller().run(program).state
    'ended'
    """

    answer: bool

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return the same answer for all."""
        return self.answer

    def delays(self, cycle_time_us: int) -> Delays:
        """Return the delays that give the same acknowledgements in the realtime part."""
        return Delays(0 if self.answer else NEVER, [], [])


#: M19 of a spindle.
_POSITION = 19

ALL = Always(True)
NONE = Always(False)


@dataclass(frozen=True, slots=True)
class After:
    """Acknowledges a function when it has waited for this time; 0: after its own tick."""

    time: Time

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return whether the time has passed."""
        return hli.time_us - function.time_us >= self.time.us(hli.cycle_time_us)

    def delays(self, cycle_time_us: int) -> Delays:
        """Return the delays that give the same acknowledgements in the realtime part."""
        return Delays(self.time.ticks(cycle_time_us), [], [])


@dataclass(frozen=True, slots=True)
class Only:
    """Acknowledges functions or spindles of these names by the policy ``then``, no others."""

    names: frozenset[str]
    then: Policy = ALL

    def answers(self, function: TechnologyEntry | SpindleEntry, hli: PlcView) -> bool:
        """Return whether it has one of the names and ``then`` acknowledges it."""
        return function.name in self.names and self.then.answers(function, hli)

    def delays(self, cycle_time_us: int) -> Delays | None:
        """Return the delays that give the same acknowledgements, ``None`` if there are none."""
        then = delays_of(self.then, cycle_time_us)
        if then is None:
            return None
        functions = [code for name in sorted(self.names) if (code := _code_of(name)) is not None]
        return Delays(NEVER, functions, [then.delay_of(function) for function in functions])


@dataclass(frozen=True, slots=True)
class RunUp:
    """Acknowledges a job after the time that the spindle needs for its change of speed.

    M19 runs up to its speed and down to a standstill.
    """

    rpm_per_s: float

    def answers(self, job: SpindleEntry, hli: PlcView) -> bool:
        """Return whether the time for the change of speed is over after this tick."""
        over_us = hli.time_us + hli.cycle_time_us - job.time_us
        return over_us * self.rpm_per_s >= self._change(job) * 1e6 * (1 - 1e-9)

    def needed_us(self, job: SpindleEntry) -> float:
        """Return the time for the change of speed in microseconds."""
        return self._change(job) * 1e6 / self.rpm_per_s

    def _change(self, job: SpindleEntry) -> float:
        """Return the change of speed in rpm."""
        speed = {3: job.speed, 4: -job.speed, 19: job.speed}.get(job.function, 0.0)
        change = abs(speed - job.speed_before)
        return change + job.speed if job.function == _POSITION else change


def delays_of(policy: Policy, cycle_time_us: int) -> Delays | None:
    """Return the delays that acknowledge functions as ``policy``; ``None`` if there are none."""
    if isinstance(policy, Always | After | Only) and type(policy) in (Always, After, Only):
        return policy.delays(cycle_time_us)
    return None


def earliest(policy: SpindlePolicy, job: SpindleEntry, hli: PlcView) -> int:
    """Return a tick before which ``policy`` does not acknowledge a job that waits."""
    cycle_time_us = hli.cycle_time_us
    if type(policy) is Only:
        return earliest(policy.then, job, hli) if job.name in policy.names else NEVER
    if type(policy) is Always:
        return hli.tick + 1 if policy.answer else NEVER
    if type(policy) is After:
        return job.time_us // cycle_time_us + policy.time.ticks(cycle_time_us)
    if type(policy) is RunUp:
        return int((job.time_us + policy.needed_us(job) * (1.0 - 1e-6)) / cycle_time_us) - 1
    return hli.tick + 1


def _code_of(name: str) -> int | None:
    """Return the code of a function such as ``M100``; ``None`` for a spindle or another word."""
    letter, number = name[:1], name[1:]
    if letter not in LETTERS or not (number.isascii() and number.isdigit()):
        return None
    code = code_of(letter, int(number[:_MAX_DIGITS]))
    return code if function_name(code) == name else None


def after(time: TimeLike) -> After:
    r"""Acknowledge each function this time after the tick in which it appeared.

    ``after("20 ticks")``, ``after("5 ms")``; a plain number means seconds. Raises ``Failure`` for
    an invalid time (900510).

    >>> class Cell(Plc):
    ...     acknowledge = after("20 ms")
    >>> Controller().run(NcText("clamp.nc", "M100\nG01 X10 F6000\nM30"), plc=Cell()).ticks
    126
    """
    return After(read_time(time))


def run_up(rpm_per_s: float) -> RunUp:
    r"""Acknowledge a spindle's job when its speed is reached at this change in rpm per second.

    >>> class Cell(Plc):
    ...     spindles = run_up(2500)
    >>> Controller().run(NcText("turn.nc", "S3[M3 REV=500]\nG01 X10 F6000\nM30"), plc=Cell()).state
    'ended'
    """
    if not 0.0 < rpm_per_s < float("inf"):
        raise ValueError(f"a spindle cannot change its speed by {rpm_per_s} per second")
    return RunUp(rpm_per_s)


def only(*names: str, then: Policy = ALL) -> Only:
    r"""Acknowledge only ``M100``, ``H7``, ``S3`` …, by the policy ``then``.

    >>> class Cell(Plc):
    ...     acknowledge = only("M100", then=after("20 ms"))
    >>> Controller().run(NcText("clamp.nc", "M100\nG01 X10 F6000\nM30"), plc=Cell()).ticks
    126
    """
    return Only(frozenset(arguments.text("name", name).upper() for name in names), then)
