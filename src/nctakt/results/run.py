# SPDX-License-Identifier: MIT
"""The result of a run or of some of its ticks: its end, its realtime cycles, its outputs.

Plain records, the same for the same inputs: they hold no wall-clock time.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Literal, NamedTuple, Protocol, overload

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Language, Severity, Span
from nctakt.base.failure import Failure
from nctakt.base.notebook import html_picture, html_table
from nctakt.files.output import OutputFile
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.pictures import RUN_NOT_RECORDED
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import Trace
from nctakt.results.user_errors import UserErrorReport, user_errors

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow
    from matplotlib.figure import Figure

    from nctakt.results.coverage import Coverage
    from nctakt.results.explained.why import WhyReport
    from nctakt.results.starving import OverflowCount, Starvation
    from nctakt.schedule.open_schedule import RunSchedule

#: ``ended``: all programs ran to their end. ``error``: an NC error stopped the run. ``limit``: the
#: time limit was reached. ``reset``: RESET on the HLI. ``interrupted``: the user interrupted it.
RunState = Literal["ended", "error", "limit", "reset", "interrupted"]

#: Maximum number of messages and of errors in the table for notebooks.
MAX_ROWS = 20

#: The frequency of a branch without one (a plain ``$IF``, ``$ELSEIF``, ``$ELSE``).
NO_FREQUENCY = ""


@dataclass(frozen=True, slots=True, repr=False)
class ProgramMessage:
    """A message of a program (``#MSG``): its time and its text.

    ``channel``: the channel's number on a machine with several, or 0. In a message file it
    appears without its time stamp if ``is_exclusive``, without a line end if ``is_unbroken``.
    ``file``: the message file that the program has chosen (#FILENAME), empty without one.
    """

    time_us: int
    text: str
    is_exclusive: bool = False
    is_unbroken: bool = False
    channel: int = 0
    file: str = ""

    def __repr__(self) -> str:
        channel = f" CH{self.channel}" if self.channel else ""
        return f"<{Time(self.time_us)}{channel}: {self.text!r}>"

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Reaction:
    """A branch of a realtime cycle: its span and ``ONCE``, ``EDGE``, ``ALWAYS`` or empty."""

    span: Span
    frequency: str = NO_FREQUENCY


@dataclass(frozen=True, slots=True)
class FrozenValue:
    """An asynchronous variable of a realtime cycle: its name, its value, its span in the cycle.

    The value was read when the definition was decoded and stays the same in the cycle (RC-302).
    """

    name: str
    value: float | str
    span: Span


@dataclass(frozen=True, slots=True)
class ReactionResult:
    """Results of a branch: how often it became true, and in how many run-throughs its body ran.

    It becomes true when its body runs and did not in the previous run-through (``fired``).
    ``first_tick`` and ``last_tick`` are the first and last ticks in which that happened, ``None``
    if never.
    """

    span: Span | None
    frequency: str
    became_true: int
    ran: int
    first_tick: int | None
    last_tick: int | None


@dataclass(frozen=True, slots=True)
class CycleResult:
    """A realtime cycle: ID (``#1`` without one), scope, span of its definition, reactions.

    ``instances``: how often the definition was executed. ``runs``: its run-throughs in this run,
    ``None`` if another definition shares their count. ``frozen``: the asynchronous values
    of its latest instance.
    """

    name: str
    scope: str
    span: Span | None
    reactions: tuple[ReactionResult, ...]
    instances: int = 1
    runs: int | None = None
    frozen: tuple[FrozenValue, ...] = ()


@dataclass(frozen=True, slots=True)
class OutputCount:
    """The number of outputs of a function; ``is_realtime``: by a realtime cycle.

    ``letter``: ``M``, ``H`` or ``T``.
    """

    letter: str
    number: int
    is_realtime: bool
    count: int
    first_tick: int

    @property
    def name(self) -> str:
        """The function as in a program: ``M100``."""
        return f"{self.letter}{self.number}"


@dataclass(frozen=True, slots=True)
class MotionCount:
    """The independent motions of an axis; ``is_realtime``: by a realtime cycle.

    ``is_of_program``: by the program; with neither by the PLC. ``count``: how many have begun.
    ``done``: how many have come to their target.
    """

    axis: str
    is_realtime: bool
    count: int
    done: int
    first_tick: int
    is_of_program: bool = False


@dataclass(frozen=True, slots=True)
class SpindleJobCount:
    """The jobs of a spindle with one function (``M3`` …); ``is_realtime``: by a realtime cycle."""

    spindle: str
    function: str
    is_realtime: bool
    count: int
    first_tick: int


@dataclass(frozen=True, slots=True, repr=False)
class TechnologyOutput:
    """The output of an M, H or T function; ``letter``: ``M``, ``H`` or ``T``.

    ``sequence``: its number within the tick in the realtime section (RC-403), 0 for a function of
    the main program. ``cycle``: the realtime cycle that put it out, empty for the main program.
    """

    tick: int
    time_us: int
    letter: str
    number: int
    sequence: int
    span: Span | None
    cycle: str

    @property
    def name(self) -> str:
        """The function as in a program: ``M100``."""
        return f"{self.letter}{self.number}"

    def __repr__(self) -> str:
        origin = f" of cycle {self.cycle}" if self.cycle else ""
        span = "" if self.span is None else f", {self.span}"
        return f"<{Time(self.time_us)}: {self.name}{origin}{span}>"

    def __str__(self) -> str:
        return self.name


class RunDrawer(Protocol):
    """Draws runs of a machine; writes raise ``OSError``, checks ``Failure``."""

    def check_file(self, kind: str, file: str) -> None:
        """Raise ``Failure`` for a file that cannot be of this kind: ``plot``, ``vcd`` …"""

    def check_run(self, run: Run, signals: Sequence[str] | None = None) -> None:
        """Raise ``Failure`` for a run without a trace, and for signals that it lacks."""

    def plot(self, run: Run, path: Path, signals: Sequence[str] | None, language: Language) -> None:
        """Draw a picture."""

    def figure(self, run: Run, signals: Sequence[str] | None, language: Language) -> Figure:
        """Return a picture as a figure of matplotlib."""

    def png(self, run: Run, language: Language = "en") -> bytes | None:
        """Return a picture as the bytes of a file; ``None`` without matplotlib."""

    def write_vcd(self, run: Run, path: Path) -> None:
        """Write a VCD file."""

    def write_fst(self, run: Run, path: Path) -> None:
        """Write an FST file."""

    def write_perfetto(self, run: Run, path: Path, language: Language) -> None:
        """Write a file for Perfetto."""

    def detached(self, run: Run) -> Callable[[], RunDrawer]:
        """Return a maker of this run's drawer that needs no controller, in any process."""


@dataclass(frozen=True, slots=True, repr=False)
class Run:
    """The result of ``Controller.run``.

    ``state``: ``ended``, ``error``, ``limit``, ``reset`` or ``interrupted``. The run has ``ticks``
    ticks from tick ``first_tick`` of the controller on. ``trace`` and ``events`` are those of the
    trace in memory (``None`` and empty without one); messages and counts are always there. ``why``
    has the history of each condition, ``coverage`` the counts, if the run recorded them.
    ``before``: the values of the recorded signals before the first tick. ``schedule``: the
    scheduling list of the run; ``starved``, ``overflows``: its effects. ``drawer`` makes the object
    that draws the run (``plot``), ``None`` without a trace in memory.

    Runs can be pickled; the copy is equal and can be drawn as well. Runs with the same inputs are
    equal.

    >>> run = Controller().run(NcText("part.nc", "M100 G01 X100 F6000 M30"))
    >>> run.state, run.ticks
    ('ended', 1026)
    >>> run.technology
    [<0 s: M100, part.nc:1:1>]
    >>> run.trace.at(1025, "X.ACS.ACT_POS")
    100.0
    """

    programs: tuple[str, ...]
    cycle_time_us: int
    first_tick: int
    ticks: int
    state: RunState
    trace: Trace | None = None
    diagnostics: tuple[Diagnostic, ...] = ()
    messages: tuple[ProgramMessage, ...] = ()
    cycles: tuple[CycleResult, ...] = ()
    outputs: tuple[OutputCount, ...] = ()
    motions: tuple[MotionCount, ...] = ()
    spindle_jobs: tuple[SpindleJobCount, ...] = ()
    why: WhyReport | None = None
    schedule: RunSchedule | None = None
    starved: tuple[Starvation, ...] = ()
    overflows: tuple[OverflowCount, ...] = ()
    coverage: Coverage | None = None
    drawer: Callable[[], RunDrawer] | None = field(default=None, compare=False)
    before: Mapping[str, float] = field(default_factory=dict)

    def __reduce__(self) -> tuple[Callable[[], Run], tuple[()]]:
        values = {member.name: getattr(self, member.name) for member in fields(self)}
        if self.drawer is not None:
            values["drawer"] = self.drawer().detached(self)
        return functools.partial(type(self), **values), ()

    @property
    def virtual_time_us(self) -> int:
        """The time of the run on the machine, in microseconds."""
        return self.ticks * self.cycle_time_us

    @property
    def events(self) -> Sequence[Event]:
        """All events in the order of their occurrence."""
        return () if self.trace is None else self.trace.events

    def to_arrow(self) -> pyarrow.Table:
        """Return the trace as an Arrow table: ``tick``, ``time_us``, the signals, ``events``.

        Each field has its ``unit`` as metadata. Raises ``Failure``: no pyarrow (901311), a run
        without a trace (901350).
        """
        from nctakt.messages.commands.studies import RUN_WITHOUT_TRACE  # noqa: PLC0415 - few runs need it
        from nctakt.results.trace.arrow import trace_table  # noqa: PLC0415 - an extra

        if self.trace is None:
            raise Failure(diagnostic(RUN_WITHOUT_TRACE))
        return trace_table(self.trace)

    def to_pandas(self) -> pandas.DataFrame:
        """Return the trace as a pandas frame, units in ``attrs``; raises as ``to_arrow``."""
        from nctakt.results.trace.arrow import pandas_frame  # noqa: PLC0415 - an extra

        return pandas_frame(self.to_arrow())

    def to_polars(self) -> polars.DataFrame:
        """Return the trace as a polars frame, which has no units; raises as ``to_arrow``."""
        import polars  # noqa: PLC0415 - an extra

        return polars.DataFrame(self.to_arrow())

    @property
    def technology(self) -> list[TechnologyOutput]:
        """The outputs of M and H functions, in their order."""
        return [technology_output(event) for event in self.events if event.kind in TECHNOLOGY_KINDS]

    @property
    def user_errors(self) -> list[UserErrorReport]:
        """The errors and warnings that programs and realtime cycles raised with ``#ERROR``."""
        return user_errors(self.events)

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        """The diagnostics that are errors."""
        return self._of(Severity.ERROR)

    def _of(self, severity: Severity) -> tuple[Diagnostic, ...]:
        return tuple(
            diagnostic for diagnostic in self.diagnostics if diagnostic.severity is severity
        )

    def __repr__(self) -> str:
        counts = ", ".join(
            f"{count} {name.removesuffix('s') if count == 1 else name}"
            for name, count in self._counts()
        )
        programs = ", ".join(self.programs)
        time = Time(self.virtual_time_us)
        return f"<Run of {programs}: {self.state} after {time}, {self.ticks} ticks; {counts}>"

    def _counts(self) -> list[tuple[str, int]]:
        return [
            ("messages", len(self.messages)),
            ("errors", len(self.errors)),
            ("warnings", len(self._of(Severity.WARNING))),
        ]

    # --- pictures -------------------------------------------------------------------------------

    @overload
    def plot(
        self,
        file: None = None,
        *,
        signals: Sequence[str] | None = None,
        language: Language = "en",
    ) -> Figure: ...

    @overload
    def plot(
        self, file: str | Path, *, signals: Sequence[str] | None = None, language: Language = "en"
    ) -> None: ...

    def plot(
        self,
        file: str | Path | None = None,
        *,
        signals: Sequence[str] | None = None,
        language: Language = "en",
    ) -> Figure | None:
        """Draw the run: ``.html`` (interactive), ``.svg`` or ``.png``; without a file return it.

        Returns a figure of matplotlib, which a notebook shows. It shows the data recorded by the
        run: path and motion of the axes, or ``signals`` instead of the motion; reactions as long as
        they lasted and conditions with ``why``, blocks and acknowledgements with ``blocks``,
        signals read by conditions with ``condition_signals`` (``Controller.run``). Raises
        ``Failure`` without a trace in memory (901091), for a signal missing from it (901092),
        another suffix (900635), a missing library (900634), and for a file that cannot be written
        (900507).
        """
        drawer = self._drawer("plot", "run.png" if file is None else file, signals)
        if file is None:
            return drawer.figure(self, signals, language)
        with OutputFile(file) as output:
            output.fill(lambda path: drawer.plot(self, path, signals, language))
        return None

    def write_vcd(self, file: str | Path) -> None:
        """Write signals, blocks, cycles and functions as VCD, for GTKWave; raises as ``plot``."""
        drawer = self._drawer("vcd", file)
        with OutputFile(file) as output:
            output.fill(lambda path: drawer.write_vcd(self, path))

    def write_perfetto(self, file: str | Path, *, language: Language = "en") -> None:
        """Write the same as ``.json`` for Perfetto (ui.perfetto.dev); raises as ``plot``."""
        drawer = self._drawer("perfetto", file)
        with OutputFile(file) as output:
            output.fill(lambda path: drawer.write_perfetto(self, path, language))

    def _drawer(
        self, kind: str, file: str | Path, signals: Sequence[str] | None = None
    ) -> RunDrawer:
        if self.drawer is None:
            raise Failure(diagnostic(RUN_NOT_RECORDED))
        drawer = self.drawer()
        drawer.check_file(kind, str(file))
        drawer.check_run(self, signals)
        return drawer

    # --- shown ----------------------------------------------------------------------------------

    def _repr_html_(self) -> str:
        """Return a small table for notebooks: state, time, counts, messages, errors; a picture."""
        rows = [
            ("state", self.state),
            ("time", f"{Time(self.virtual_time_us)}, {self.ticks} ticks"),
            *((name, str(count)) for name, count in self._counts()),
            *((str(Time(item.time_us)), item.text) for item in self.messages[:MAX_ROWS]),
            *((f"error {item.id}", item.headline()) for item in self.errors[:MAX_ROWS]),
        ]
        return html_table(", ".join(self.programs), rows) + self.html_picture()

    def html_picture(self) -> str:
        """Return the picture of ``plot`` for notebooks; empty without a trace or matplotlib."""
        if self.drawer is None or not self.ticks or self.trace is None:
            return ""
        png = self.drawer().png(self)
        return "" if png is None else html_picture(png)


@dataclass(frozen=True, slots=True, repr=False)
class RecordedRun(Run):
    """The result of a run with its trace in memory, as by default (``memory_trace``)."""

    trace: Trace


@dataclass(frozen=True, slots=True, repr=False)
class ExplainedRun(RecordedRun):
    """The result of a run with the histories and counts of its conditions (``why``)."""

    why: WhyReport = field(kw_only=True)
    coverage: Coverage = field(kw_only=True)


#: The kinds of events for outputs of functions: of realtime cycles, and of the main program.
TECHNOLOGY_KINDS = ("M", "H", "output")


def technology_output(event: Event) -> TechnologyOutput:
    """Return the output of an event of ``TECHNOLOGY_KINDS``."""
    words = event.text.split()
    if event.kind == "output":
        letter, number, sequence = words[0], int(words[1]), 0
    else:
        letter, number, sequence = event.kind, int(words[0]), int(words[1])
    span, cycle = event.span, event.cycle
    return TechnologyOutput(event.tick, event.time_us, letter, number, sequence, span, cycle)


class Step(NamedTuple):
    """The ticks from ``first_tick`` on.

    ``state`` is that of the controller after them. ``events``, ``messages`` and ``diagnostics``
    are those of these ticks only.
    """

    first_tick: int
    ticks: int
    state: str
    events: tuple[Event, ...]
    messages: tuple[ProgramMessage, ...]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def technology(self) -> list[TechnologyOutput]:
        """The M and H functions that went out, in their order."""
        return [technology_output(event) for event in self.events if event.kind in TECHNOLOGY_KINDS]

    def __repr__(self) -> str:
        what = ", ".join(map(str, self.events)) or "nothing"
        return f"<{self.ticks} ticks from {self.first_tick}, {self.state}: {what}>"
