# SPDX-License-Identifier: MIT
"""Queries of a test on a run: ``run.fired(cycle=17, line=5)``, ``run.m_function(100).at``.

In: a controller, a program, the inputs of its run. Out: ``NcRun``. Times are seconds of the run.
The answer to a query is true or false in an ``assert``, and shows the actual events if the
assertion fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol, TypeAlias, Unpack, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.fmu.coupled import fmu_of
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import RUN_NOT_ENDED
from nctakt.messages.commands.inputs import NO_BRANCH_IN_LINE
from nctakt.plc.loading import load_plc, load_plcs
from nctakt.project.run_settings import Named, RunSettings, run_settings
from nctakt.results.run import Run
from nctakt.results.trace.events import Event
from nctakt.run.controller import Controller, NcText
from nctakt.run.options import ProgramOptions, check_keywords, merged
from nctakt.run.plcs.plc_view import AnyPlc, GivenPlc
from nctakt.run.plcs.realtime_plc import plc_object
from nctakt.testing.language import rendered

#: The name of a program that a test has as text.
TEXT_NAME = "program.nc"

#: A PLC as a test names it: an object, a class, or a file.
PlcWord: TypeAlias = GivenPlc | str | Path

_CYCLE_KINDS = ("M", "H")

#: The kinds of events that are outputs of functions to the PLC.
FUNCTION_KINDS = (*_CYCLE_KINDS, "output")


class RunNc(Protocol):
    """The fixture ``run_nc`` of a test, for its annotation.

    >>> def test_x_arrives(run_nc: RunNc) -> None:
    ...     assert run_nc("part.nc").ended
    """

    def __call__(
        self,
        program: str | Path,
        *,
        plc: PlcWord | Sequence[PlcWord] | None = None,
        why: bool = False,
        limit_fails: bool | None = None,
        **options: Unpack[ProgramOptions],
    ) -> NcRun:
        """Run a program: a file next to the test, or a text of several lines."""


class Runner:
    """The fixture ``run_nc``: runs programs with one controller, and keeps what they reported.

    ``folder``: that of the test. ``note``: called with each run; ``why``: runs record why their
    reactions fired. ``errors``: a text for each run that ended with errors.
    """

    def __init__(
        self, controller: Controller, folder: Path, note: Callable[[Run], None], *, why: bool
    ) -> None:
        self._controller = controller
        self._folder = folder
        self._note = note
        self._why = why
        self.errors: list[str] = []

    def __call__(self, program: str | Path, **options: Any) -> NcRun:
        __tracebackhide__ = True
        if self._why:
            options["why"] = True
        done = run_program(self._controller, program, self._folder, **options)
        self._note(done.run)
        if done.errors:
            self.errors.append(rendered(done.run.errors))
        return done

    def __repr__(self) -> str:
        return "<run_nc>"


def run_program(
    controller: Controller,
    program: str | Path,
    folder: Path,
    *,
    plc: PlcWord | Sequence[PlcWord] | None = None,
    why: bool = False,
    limit_fails: bool | None = None,
    **options: Unpack[ProgramOptions],
) -> NcRun:
    """Run a program: a file (relative to ``folder``), or a text of several lines.

    ``plc``: an object, its file, ``default`` for the built-in one, or a list of several;
    ``signals`` are recorded in addition to positions, path speed, override, block and active
    cycles; ``options`` are those of ``Controller.run``. Other settings, except the machine, come
    from the project around ``folder``. A run that comes to its limit raises ``Failure`` (901016) if
    ``limit_fails``, which is so unless a limit is named.
    """
    check_keywords("run_nc", "test", options)
    until, ticks = options.get("until"), options.get("ticks")
    own_values = options.get("set") or {}
    arguments.mapping("set", own_values)
    if isinstance(program, str) and "\n" in program:
        source: Path | NcText = NcText(TEXT_NAME, program)
    else:
        source = folder / program
    named = Named(
        values=own_values, until=until, is_limited=ticks is not None, base=folder, fmu_use="run"
    )
    settings, own_plc = _settings_beside(named, plc)
    values = {**settings.values, **own_values}
    names = list(dict.fromkeys([*controller.default_signals, *(options.get("signals") or ())]))
    try:
        run = controller.run(
            source,
            **merged(
                options,
                {
                    "set": values,
                    "until": settings.until,
                    "plc": own_plc,
                    "fmu": None if settings.fmu is None else fmu_of(settings.fmu),
                    "signals": names,
                    "why": why,
                },
            ),
        )
    except Failure as failure:
        raise settings.placed(failure) from failure
    if limit_fails is None:
        limit_fails = until is None and ticks is None
    if limit_fails and run.state == "limit":
        message = diagnostic(RUN_NOT_ENDED, time=str(Time(run.virtual_time_us)))
        raise Failure(message, *run.diagnostics)
    return NcRun(run)


def _settings_beside(
    named: Named, plc: PlcWord | Sequence[PlcWord] | None
) -> tuple[RunSettings, AnyPlc | None]:
    """Return the settings of a run with the PLC that it names, and that PLC or the project's."""
    words: Sequence[PlcWord] = ()
    if isinstance(plc, list | tuple):
        words = plc
    elif plc is not None:
        words = (cast("PlcWord", plc),)
    files = tuple(one for one in words if isinstance(one, str | Path))
    settings = run_settings(
        [named.base],
        FileAccess(),
        replace(named, plcs=files, has_plc=bool(words)),
    )
    if len(files) == len(words):
        return settings, load_plcs(settings.plcs)
    given = [load_plc(named.base / one) if isinstance(one, str | Path) else one for one in words]
    return settings, plc_object(given)


@dataclass(frozen=True, slots=True)
class Occurrence:
    """An occurrence of an event: tick, time of the run in microseconds, line of the program."""

    tick: int
    at_us: int
    line: int | None
    text: str

    @property
    def at(self) -> float:
        """The time in seconds."""
        return self.at_us / 1e6

    def __str__(self) -> str:
        position = "" if self.line is None else f" (line {self.line})"
        return f"{self.text} at {Time(self.at_us)}, tick {self.tick}{position}"


class Occurrences:
    """All occurrences of an event; true if there is one."""

    def __init__(
        self, question: str, occurrences: Sequence[Occurrence], others: Sequence[Occurrence]
    ):
        self._question = question
        self._occurrences = occurrences
        self._others = others

    def __len__(self) -> int:
        return len(self._occurrences)

    def __iter__(self) -> Iterator[Occurrence]:
        return iter(self._occurrences)

    def __getitem__(self, index: int) -> Occurrence:
        return self._occurrences[index]

    @property
    def at(self) -> float:
        """The time of the first occurrence in seconds; raises ``AssertionError`` without one."""
        __tracebackhide__ = True
        assert self._occurrences, repr(self)
        return self._occurrences[0].at

    @property
    def tick(self) -> int:
        """The tick of the first occurrence; raises ``AssertionError`` without one."""
        __tracebackhide__ = True
        assert self._occurrences, repr(self)
        return self._occurrences[0].tick

    @property
    def times(self) -> list[float]:
        """The time of each occurrence in seconds."""
        return [occurrence.at for occurrence in self._occurrences]

    @property
    def count(self) -> int:
        """The number of occurrences."""
        return len(self._occurrences)

    def __repr__(self) -> str:
        if self._occurrences:
            return f"<{self._question}: {'; '.join(map(str, self._occurrences))}>"
        instead = "; ".join(map(str, self._others[:5])) or "nothing of its kind"
        return f"<{self._question}: never; but {instead}>"


class Ending:
    """The end of a run; true if its programs ended without an error."""

    def __init__(self, run: Run) -> None:
        self._run = run

    def __bool__(self) -> bool:
        return self._run.state == "ended" and not self._run.errors

    def __str__(self) -> str:
        ending = f"{self._run.state} after {Time(self._run.virtual_time_us)}"
        errors = "; ".join(diagnostic.headline() for diagnostic in self._run.errors)
        return f"{ending}: {errors}" if errors else ending

    def __repr__(self) -> str:
        return f"<{self}>"


class AxisTrace:
    """One axis of a run; positions in mm or degrees, command positions in ACS."""

    def __init__(self, run: NcRun, name: str) -> None:
        self._run = run
        self.name = name

    def position_at(self, time: TimeLike) -> float:
        """Return the command position that a realtime cycle reads at this time."""
        __tracebackhide__ = True
        return self._run.value_at(f"{self.name}.ACS.ACT_POS", time)

    def actual_position_at(self, time: TimeLike) -> float:
        """Return the actual position at this time."""
        __tracebackhide__ = True
        return self._run.value_at(f"{self.name}.ACS.CUR_POS", time)

    @property
    def end_position(self) -> float:
        """The command position at the end of the run."""
        return self._run.value_at(f"{self.name}.ACS.ACT_POS", Time(self._run.run.virtual_time_us))


class NcRun:
    """The queries of a test on a run; ``run`` is its complete result."""

    def __init__(self, run: Run) -> None:
        self.run = run

    def __repr__(self) -> str:
        return f"<run of {', '.join(self.run.programs)}: {self.ended}>"

    @property
    def ended(self) -> Ending:
        """The end of the run; true if the programs ended without an error."""
        return Ending(self.run)

    @property
    def duration(self) -> float:
        """The duration of the run in seconds."""
        return self.run.virtual_time_us / 1e6

    @property
    def errors(self) -> list[int]:
        """The numbers of the errors."""
        return [diagnostic.id for diagnostic in self.run.errors]

    @property
    def messages(self) -> list[str]:
        """The texts of the programs' messages (``#MSG``)."""
        return [message.text for message in self.run.messages]

    def fired(self, *, cycle: int | str | None = None, line: int | None = None) -> Occurrences:
        """Return the firings of the branch in a line, of a cycle's branches, or of all branches.

        Raises ``Failure`` (900663) if no cycle of the run has a branch in the line.
        """
        spans = [
            reaction.span for cycle_result in self.run.cycles for reaction in cycle_result.reactions
        ]
        lines = sorted({span.line for span in spans if span is not None})
        if line is not None and line not in lines:
            known_lines = ", ".join(map(str, lines)) or NOTHING
            raise Failure(diagnostic(NO_BRANCH_IN_LINE, line=line, known=known_lines))
        asked = "fired"
        asked += "" if cycle is None else f" cycle {cycle}"
        asked += "" if line is None else f" line {line}"
        return self.find(asked, ("fired",), "", line=line, cycle=cycle)

    def m_function(self, number: int, *, line: int | None = None) -> Occurrences:
        """Return the outputs of an M function to the PLC, of a cycle or of the program."""
        return self.function(f"M{number}", line=line)

    def h_function(self, number: int, *, line: int | None = None) -> Occurrences:
        """Return the outputs of an H function to the PLC."""
        return self.function(f"H{number}", line=line)

    def function(self, name: str, *, line: int | None = None) -> Occurrences:
        """Return the outputs of ``M100`` or ``H7`` to the PLC."""
        return self.find(name, FUNCTION_KINDS, name, line=line)

    def message(self, text: str) -> Occurrences:
        """Return the program's messages with this text."""
        return self.find(f'message "{text}"', ("message",), text)

    def find(
        self,
        question: str,
        kinds: Sequence[str],
        text: str,
        *,
        line: int | None = None,
        cycle: int | str | None = None,
    ) -> Occurrences:
        """Return events of these kinds with this text (any if empty), line and cycle."""
        alike = self._alike(kinds)
        matching = _matching(alike, text, line, cycle)
        return Occurrences(question, self._occurrences(matching), self._occurrences(alike))

    def times_us(
        self,
        kinds: Sequence[str],
        text: str,
        *,
        line: int | None = None,
        cycle: int | str | None = None,
    ) -> list[int]:
        """Return the times of such events in microseconds of the run."""
        first_us = self.run.first_tick * self.run.cycle_time_us
        found = _matching(self._alike(kinds), text, line, cycle)
        return [event.time_us - first_us for event in found]

    def _alike(self, kinds: Sequence[str]) -> list[Event]:
        """Return the events of these kinds."""
        trace = self.run.trace
        return [] if trace is None else trace.events_of(kinds)

    def _occurrences(self, events: Sequence[Event]) -> list[Occurrence]:
        first_us = self.run.first_tick * self.run.cycle_time_us
        return [
            Occurrence(
                event.tick - self.run.first_tick,
                event.time_us - first_us,
                _line(event),
                _text(event),
            )
            for event in events
        ]

    def axis(self, name: str) -> AxisTrace:
        """Return the axis with this name."""
        __tracebackhide__ = True
        if not self.has_axis(name):
            raise KeyError(f"there is no axis {name}")
        return AxisTrace(self, name)

    def has_axis(self, name: str) -> bool:
        """Return whether it is the name of an axis."""
        return f"{name}.ACS.ACT_POS" in self.run.before

    def value_at(self, name: str, time: TimeLike) -> float:
        """Return the value of a signal at a time, as a realtime cycle reads it then.

        The result of a tick counts from the start of the next one on. Raises ``Failure`` for an
        invalid time.
        """
        __tracebackhide__ = True
        trace = self.run.trace
        assert trace is not None
        if name not in self.run.before:
            raise KeyError(f"{name} is not recorded: name it in signals")
        ticks = read_time(time).ticks(self.run.cycle_time_us)
        if ticks <= 0 or self.run.ticks == 0:
            return self.run.before[name]
        last = self.run.first_tick + min(ticks, self.run.ticks) - 1
        return trace.at(last, name)

    def labels(self, name: str) -> Mapping[int, str]:
        """Return the names of an enumeration's items by their numbers, none for another signal."""
        trace = self.run.trace
        signals = () if trace is None else trace.signals
        return dict(next((one.labels for one in signals if one.name == name), ()))


def _line(event: Event) -> int | None:
    return None if event.span is None else event.span.line


def _matching(
    events: Sequence[Event], text: str, line: int | None, cycle: int | str | None
) -> list[Event]:
    """Return the events with this text (any if empty), line and cycle."""
    return [
        event
        for event in events
        if text in ("", _text(event))
        and (line is None or _line(event) == line)
        and (cycle is None or event.cycle == str(cycle))
    ]


def _text(event: Event) -> str:
    """Return the short text of an event: ``M100`` for functions."""
    if event.kind == "output":
        return "".join(event.text.split()[:2])
    if event.kind in _CYCLE_KINDS:
        return f"{event.kind}{event.text.split()[0]}"
    return f"cycle {event.cycle}" if event.kind == "fired" else event.text
