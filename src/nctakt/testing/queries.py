# SPDX-License-Identifier: MIT
"""A run as a test asks about it: ``run.fired(cycle=17, line=5)``, ``run.m_function(100).at``.

In: a controller, a program, what is given with it. Out: ``NcRun``. Times are seconds of the run.
What is asked for answers as true or false in an ``assert``, and shows what has happened instead
where the assertion fails.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.inputs import NO_BRANCH_IN_LINE
from nctakt.plc import AnyPlc, load_plc
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.stimuli import StimulusLike
from nctakt.trace.events import Event, number_text

if TYPE_CHECKING:
    import pytest

#: What a program is called that a test gives as text.
TEXT_NAME = "program.nc"

_CYCLE_KINDS = ("M", "H")


def configured_machine(config: pytest.Config) -> Machine:
    """The machine of ``nctakt_machine``, relative to the root of the tests."""
    folder = config.getini("nctakt_machine")
    return load_machine(config.rootpath / folder if folder else None)


def run_program(
    controller: Controller,
    program: str | Path,
    folder: Path,
    *,
    set: Mapping[str, float | str] | None = None,
    at: Sequence[StimulusLike] = (),
    until: TimeLike | None = None,
    ticks: int | None = None,
    after: TimeLike = 0,
    plc: AnyPlc | str | Path | None = None,
    wait_for_start: bool = False,
    signals: Iterable[str] = (),
    why: bool = False,
) -> NcRun:
    """Run a program: a file (relative to ``folder``), or a text of several lines.

    ``plc``: an object, or the file of one; ``signals`` are recorded beside positions, path speed,
    override, block and active cycles; all else as for ``Controller.run``.
    """
    if isinstance(program, str) and "\n" in program:
        source: Path | NcText = NcText(TEXT_NAME, program)
    else:
        source = folder / program
    if isinstance(plc, str | Path):
        plc = load_plc(folder / plc)
    names = list(dict.fromkeys([*controller.default_signals, *signals]))
    start = values_before(controller, names, set or {})
    run = controller.run(
        source,
        set=set,
        at=at,
        until=until,
        ticks=ticks,
        after=after,
        plc=plc,
        wait_for_start=wait_for_start,
        signals=names,
        why=why,
    )
    return NcRun(run, start)


def values_before(
    controller: Controller, names: Iterable[str], assignments: Mapping[str, float | str]
) -> dict[str, float]:
    """Return the signals' values before the first tick, the assigned ones among them."""
    return {
        name: float(assignments[name]) if name in assignments else controller.signal(name)
        for name in names
    }


@dataclass(frozen=True, slots=True)
class Occurrence:
    """Once that something has happened: tick, seconds of the run, line of the program."""

    tick: int
    at: float
    line: int | None
    text: str

    def __str__(self) -> str:
        place = "" if self.line is None else f" (line {self.line})"
        return f"{self.text} at {number_text(self.at)} s, tick {self.tick}{place}"


class Occurrences:
    """All times that something has happened; true if it has."""

    def __init__(self, asked: str, found: Sequence[Occurrence], others: Sequence[Occurrence]):
        self._asked = asked
        self._found = found
        self._others = others

    def __len__(self) -> int:
        return len(self._found)

    def __iter__(self) -> Iterator[Occurrence]:
        return iter(self._found)

    def __getitem__(self, index: int) -> Occurrence:
        return self._found[index]

    @property
    def at(self) -> float:
        """The seconds of the first time; fails where it has never happened."""
        assert self._found, repr(self)
        return self._found[0].at

    @property
    def tick(self) -> int:
        """The tick of the first time."""
        assert self._found, repr(self)
        return self._found[0].tick

    @property
    def times(self) -> list[float]:
        """The seconds of each time."""
        return [one.at for one in self._found]

    @property
    def count(self) -> int:
        """How often."""
        return len(self._found)

    def __repr__(self) -> str:
        if self._found:
            return f"<{self._asked}: {'; '.join(map(str, self._found))}>"
        instead = "; ".join(map(str, self._others[:5])) or "nothing of its kind"
        return f"<{self._asked}: never; but {instead}>"


class Ending:
    """How a run has ended; true if it came to the end of its programs without an error."""

    def __init__(self, run: Run) -> None:
        self._run = run

    def __bool__(self) -> bool:
        return self._run.state == "ended" and not self._run.errors

    def __repr__(self) -> str:
        errors = "".join(f"\n{found.render()}" for found in self._run.errors)
        return f"<{self._run.state} after {Time(self._run.virtual_time_us)}{errors}>"


class AxisTrace:
    """One axis of a run; positions in mm or degrees, command positions in ACS."""

    def __init__(self, run: NcRun, name: str) -> None:
        self._run = run
        self.name = name

    def position_at(self, time: TimeLike) -> float:
        """Return the position that a realtime cycle reads at this time."""
        return self._run.value_at(f"{self.name}.ACS.ACT_POS", time)

    def actual_position_at(self, time: TimeLike) -> float:
        """Return the actual position at this time."""
        return self._run.value_at(f"{self.name}.ACS.CUR_POS", time)

    @property
    def end_position(self) -> float:
        """The position at the end of the run."""
        return self._run.value_at(f"{self.name}.ACS.ACT_POS", self._run.duration)


class NcRun:
    """A run and the questions of a test; ``run`` is the result with everything in it."""

    def __init__(self, run: Run, start: Mapping[str, float]) -> None:
        self.run = run
        self._start = start

    def __repr__(self) -> str:
        return f"<run of {', '.join(self.run.programs)}: {self.ended!r}>"

    @property
    def ended(self) -> Ending:
        """Whether the programs have ended without an error."""
        return Ending(self.run)

    @property
    def duration(self) -> float:
        """Seconds of the run."""
        return self.run.virtual_time_us / 1e6

    @property
    def errors(self) -> list[int]:
        """The numbers of the errors."""
        return [found.id for found in self.run.errors]

    @property
    def messages(self) -> list[str]:
        """What the programs have said."""
        return [message.text for message in self.run.messages]

    def fired(self, *, cycle: int | str | None = None, line: int | None = None) -> Occurrences:
        """Return when a branch of a realtime cycle fired: that of a line, of a cycle, or any.

        Raises ``Failure`` (900663) if no cycle of the run has a branch in the line.
        """
        spans = [reaction.span for one in self.run.cycles for reaction in one.reactions]
        lines = sorted({span.line for span in spans if span is not None})
        if line is not None and line not in lines:
            known = ", ".join(map(str, lines)) or NOTHING
            raise Failure(diagnostic(NO_BRANCH_IN_LINE, line=line, known=known))
        asked = "fired"
        asked += "" if cycle is None else f" cycle {cycle}"
        asked += "" if line is None else f" line {line}"
        return self.find(asked, ("fired",), "", line=line, cycle=cycle)

    def m_function(self, number: int, *, line: int | None = None) -> Occurrences:
        """When an M function went to the PLC, of a cycle or of the program."""
        return self.function(f"M{number}", line=line)

    def h_function(self, number: int, *, line: int | None = None) -> Occurrences:
        """When an H function went to the PLC."""
        return self.function(f"H{number}", line=line)

    def function(self, name: str, *, line: int | None = None) -> Occurrences:
        """When ``M100`` or ``H7`` went to the PLC."""
        return self.find(name, ("M", "H", "output"), name, line=line)

    def message(self, text: str) -> Occurrences:
        """When the program said this."""
        return self.find(f'message "{text}"', ("message",), text)

    def find(
        self,
        asked: str,
        kinds: Sequence[str],
        text: str,
        *,
        line: int | None = None,
        cycle: int | str | None = None,
    ) -> Occurrences:
        """Events of these kinds with this text (any if empty), place and cycle."""
        alike = [event for event in self.run.events if event.kind in kinds]
        found = [
            event
            for event in alike
            if text in ("", _text(event))
            and (line is None or _line(event) == line)
            and (cycle is None or event.cycle == str(cycle))
        ]
        return Occurrences(asked, self._occurrences(found), self._occurrences(alike))

    def _occurrences(self, events: Sequence[Event]) -> list[Occurrence]:
        first_us = self.run.first_tick * self.run.cycle_time_us
        return [
            Occurrence(
                event.tick - self.run.first_tick,
                (event.time_us - first_us) / 1e6,
                _line(event),
                _text(event),
            )
            for event in events
        ]

    def axis(self, name: str) -> AxisTrace:
        """An axis by its name."""
        if not self.has_axis(name):
            raise KeyError(f"there is no axis {name}")
        return AxisTrace(self, name)

    def has_axis(self, name: str) -> bool:
        """Whether it is the name of an axis."""
        return f"{name}.ACS.ACT_POS" in self._start

    def value_at(self, name: str, time: TimeLike) -> float:
        """Return the value of a signal at a time, as a realtime cycle reads it then.

        What a tick has done counts from the begin of the next one on. Raises ``Failure`` for what
        is not a time.
        """
        trace = self.run.trace
        assert trace is not None
        if name not in self._start:
            raise KeyError(f"{name} is not recorded: name it in signals")
        ticks = read_time(time).ticks(self.run.cycle_time_us)
        if ticks <= 0 or self.run.ticks == 0:
            return self._start[name]
        last = self.run.first_tick + min(ticks, self.run.ticks) - 1
        return trace.at(last, name)


def _line(event: Event) -> int | None:
    return None if event.span is None else event.span.line


def _text(event: Event) -> str:
    """What has happened, in a word or two: ``M100`` for functions."""
    if event.kind == "output":
        return "".join(event.text.split()[:2])
    if event.kind in _CYCLE_KINDS:
        return f"{event.kind}{event.text.split()[0]}"
    return f"cycle {event.cycle}" if event.kind == "fired" else event.text
