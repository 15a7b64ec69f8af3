# SPDX-License-Identifier: MIT
"""The kernel's record -> its listeners: sinks, histories of conditions, messages, diagnostics.

In: the record of a machine's ticks. Out: rows and events at the sinks of a run, messages of
programs, errors of the realtime part as diagnostics. Between runs only errors are reported. Which
signals the conditions of realtime cycles read is found in the programs; a variable whose index is
computed has none, since it can be a different element in each tick.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, cast

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.kernel import codes, rows
from nctakt.nc import tree
from nctakt.nc.check.cycles.branches import branch_outlines
from nctakt.nc.outline import ProgramText
from nctakt.nc.vocabulary.variables.resolution import indices_of, resolve, variables_in
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable
from nctakt.results.run import ProgramMessage
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event, EventDecoder
from nctakt.results.trace.recorded import EventList
from nctakt.results.trace.sinks import ExtentSink, RowSink, Signal, Sink, TraceHeader
from nctakt.results.user_errors import UserErrorReport, user_errors
from nctakt.run.causes import ended_motions, unheard_functions
from nctakt.run.causes.error_events import realtime_diagnostic
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.assembly import AssembledMachine

if TYPE_CHECKING:
    from nctakt.results.coverage import Coverage
    from nctakt.results.explained.why import WhyReport
    from nctakt.results.probe_log import ProbeLog

#: Events that become messages and diagnostics.
_WATCHED = frozenset(
    (
        rows.EVENT_MESSAGE,
        rows.EVENT_ERROR,
        rows.EVENT_NOTICE,
        rows.EVENT_USER_ERROR,
        rows.EVENT_USER_VALUE,
        rows.EVENT_USER_TEXT,
    )
)


#: Those, and the events of motions that end.
_ANY_WATCHED = _WATCHED | ended_motions.EVENTS

#: Those, and the events of functions that a PLC may not have got.
_WATCHED_BESIDE_PLC = _ANY_WATCHED | unheard_functions.EVENTS


class Recording:
    """The listeners of a machine.

    ``report`` takes the diagnostics of the realtime part, except for events of which
    ``is_reported`` is true. ``messages``: those of the programs since ``open``; ``on_message`` is
    called with each as it comes.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        report: Callable[[Diagnostic], None],
        is_reported: Callable[[Event], bool],
    ) -> None:
        self._machine = machine
        self._report = report
        self._is_reported = is_reported
        self._events = EventDecoder(machine.configuration.cycle_time_us, machine.registry)
        self._sinks: Sequence[Sink] = ()
        self._row_sinks: Sequence[RowSink] = ()
        self._extent_sinks: Sequence[ExtentSink] = ()
        self._steps: list[EventList] = []
        self._selected: Sequence[str] = ()
        self._header = TraceHeader(0, ())
        self._probes: ProbeLog | None = None
        self._noticed: set[tuple[str, Span | None]] = set()
        self._motions = ended_motions.EndedMotions(machine)
        self._functions = unheard_functions.UnheardFunctions(machine)
        self.messages: list[ProgramMessage] = []
        self.on_message: Callable[[ProgramMessage], None] | None = None
        machine.record.awaited_kinds = sum(1 << kind for kind in _ANY_WATCHED)

    def checked(self, names: Sequence[str] | None) -> Sequence[str]:
        """Return the signals of these names, by default those of the machine.

        Raises ``Failure`` for unknown signals.
        """
        machine = self._machine
        if names is None:
            return machine.default_signals()
        signals = machine.signals()
        unknown = [name for name in names if name not in signals]
        if unknown:
            raise Failure(*(machine.unknown_signal(name) for name in unknown))
        return names

    def open(
        self,
        sinks: Sequence[Sink],
        signals: Sequence[str],
        record_writes: bool,
        why: bool,
        answers: bool,
    ) -> None:
        """Begin to record these signals, which ``checked`` has returned, for these sinks.

        Without a ``RowSink`` there are no rows. ``record_writes`` records the writes of cycles,
        ``answers`` each acknowledgement of a function; ``why`` gathers the histories of conditions.
        """
        self._listen(sinks)
        header = self._select(signals if self._row_sinks else ())
        self._machine.record.records_writes = record_writes
        self._machine.record.records_answers = answers
        for sink in sinks:
            sink.open(header)
        self._probes = self._probe_log() if why else None
        self._machine.record.records_series = why
        self.messages = []
        self._noticed = set()
        self._motions = ended_motions.EndedMotions(self._machine)
        self._functions = unheard_functions.UnheardFunctions(self._machine)

    def leave_names(self) -> None:
        """Let the events so far keep their names; the registry is about to change."""
        self._events.names = self._machine.registry.with_own_files()

    def listen_anew(self, sinks: Sequence[Sink], signals: Sequence[str]) -> None:
        """Connect these sinks to the run's record from its start; nothing has been delivered yet.

        The signals are those of ``open``. Earlier listeners keep their names.
        """
        self._events = EventDecoder(
            self._machine.configuration.cycle_time_us, self._machine.registry
        )
        self._listen(sinks)
        names = signals if self._row_sinks else ()
        header = self._header if names == self._selected else self._select(names)
        for sink in sinks:
            sink.open(header)

    def close(self) -> None:
        """End the recording of a run."""
        for note in self._functions.last_notes():
            self._report(note)
        for sink in self._sinks:
            sink.close()
        self._listen(())
        self._machine.record.records_answers = False

    def add(self, sink: Sink) -> None:
        """Connect a further listener from now on; it is not opened."""
        self._listen((*self._sinks, sink))

    def record(self, sink: Sink, signals: Sequence[str]) -> None:
        """Record these signals, which ``checked`` has returned, for a further listener."""
        sink.open(self._select(signals))
        self.add(sink)

    def remove(self, sink: Sink) -> None:
        """Let a sink get nothing more."""
        self._listen([known for known in self._sinks if known is not sink])

    def reduce_to(self, sink: Sink) -> None:
        """Disconnect all other listeners from now on."""
        self._listen([sink])

    def begin_step(self, events: EventList) -> None:
        """Let a step have the events from now on, until ``end_step``."""
        self._steps.append(events)

    def end_step(self, events: EventList) -> None:
        """End a step."""
        self._steps.remove(events)

    def _listen(self, sinks: Sequence[Sink]) -> None:
        self._sinks = sinks
        # Asking the protocol takes longer than a short run's decoding.
        self._row_sinks = [cast(RowSink, sink) for sink in sinks if hasattr(sink, "rows")]
        self._extent_sinks = [cast(ExtentSink, one) for one in sinks if hasattr(one, "extent")]

    @property
    def is_empty(self) -> bool:
        """Whether nothing waits for the listeners."""
        record = self._machine.record
        return not (record.event_count or record.row_count or record.probe_count)

    def drain(self) -> None:
        """Empty the kernel's record into the listeners."""
        if self.is_empty:
            return
        record = self._machine.record
        rows_count = record.row_count
        first_tick = self._machine.kernel.tick - rows_count
        probes, event_rows = record.take_probes(), record.take_events()
        if self._probes is not None:
            self._probes.add(probes, event_rows)
        events = EventChunk(self._events, event_rows)
        values = record.take_extent() if record.is_reduced else record.take_rows()
        signals = memoryview(values).cast("d")
        if len(events):
            has_presences = bool(self._machine.access.presences)
            watched = _WATCHED_BESIDE_PLC if has_presences else _ANY_WATCHED
            if events.has_any(watched):
                self._watch(events.of_kinds(watched))
            for sink in (*self._sinks, *self._steps):
                sink.events(events)
        for note in self._functions.notes():
            self._report(note)
        if rows_count and record.is_reduced:
            for extent_sink in self._extent_sinks:
                extent_sink.extent(first_tick, rows_count, signals)
        elif rows_count:
            for row_sink in self._row_sinks:
                row_sink.rows(first_tick, signals, record.signal_count)

    def why(
        self, first_tick: int, texts: Sequence[ProgramText]
    ) -> tuple[WhyReport | None, Coverage | None]:
        """Return the histories of conditions since ``open``, and the coverage that they show.

        ``None`` for both if ``open`` was not asked to gather them.
        """
        log = self._probes
        if log is None:
            return None, None
        from nctakt.results.explained.why import WhyReport  # noqa: PLC0415 - few runs are asked why

        self._probes = None
        self._machine.record.records_series = False
        ticks = self._machine.kernel.tick - first_tick
        cycle_time_us = self._machine.configuration.cycle_time_us
        histories = log.histories(texts)
        report = WhyReport(cycle_time_us, first_tick, ticks, histories, log.left_out)
        return report, log.coverage(histories)

    def _probe_log(self) -> ProbeLog:
        """Return a log for the histories of conditions; living cycles are in it from now on."""
        from nctakt.results.probe_log import ProbeLog  # noqa: PLC0415 - as above

        machine = self._machine
        living = [
            (machine.registry.definition(cycle.serial), manager.state_of(cycle.slot))
            for manager in (channel.manager for channel in machine.channels)
            for cycle in manager.loaded
            if codes.DEFINED <= manager.state_of(cycle.slot) <= codes.HELD
        ]
        return ProbeLog(machine.registry, machine.kernel.tick, living)

    def _watch(self, events: EventChunk) -> None:
        """Keep messages, and turn errors of the realtime part into diagnostics."""
        machine = self._machine
        reports: Iterator[UserErrorReport] | None = None
        for number, (tick, kind, channel, _, subject, *_) in enumerate(events.cells()):
            if kind == rows.EVENT_MESSAGE:
                self._keep_message(int(tick), int(channel), int(subject))
            if kind == rows.EVENT_MESSAGE or kind not in _WATCHED:
                continue  # which would be decoded for nothing
            event = events[number]
            if event.kind == "user_error":
                reports = reports or iter(user_errors(events))
                report = next(reports)
                line = "" if report.span is None else machine.files.line_at(report.span)
                self._report(report.diagnostic(machine.configuration.user_texts, line))
            elif event.kind == "notice":
                self._report_notice(event)
            elif event.kind in ("error", "warning") and not self._is_reported(event):
                self._report(realtime_diagnostic(event, machine))
        if events.has_any(ended_motions.EVENTS):
            for note in self._motions.add(events):
                self._report(note)
        if machine.access.presences:
            self._functions.add(events)

    def _keep_message(self, tick: int, channel: int, number: int) -> None:
        """Keep a message of a program, by its number in the registry."""
        registry = self._machine.registry
        time_us = tick * self._machine.configuration.cycle_time_us
        style = registry.message_style(number)
        message = ProgramMessage(
            time_us, registry.message(number), *style[:2], channel=channel, file=style[2]
        )
        self.messages.append(message)
        if self.on_message is not None:
            self.on_message(message)

    def _report_notice(self, event: Event) -> None:
        """Report a notice of the realtime cycles, once for each place of the program."""
        notice = event.text, event.span
        if notice not in self._noticed:
            self._noticed.add(notice)
            self._report(realtime_diagnostic(event, self._machine))

    def _select(self, names: Sequence[str]) -> TraceHeader:
        """Choose the signals of the trace."""
        machine = self._machine
        signals = machine.signals()
        machine.record.select([signals[name][0] for name in names])
        chosen = [(name, signals[name]) for name in names]
        header = tuple(Signal(name, one.unit, one.is_whole, one.labels) for name, one in chosen)
        self._selected = names
        self._header = TraceHeader(machine.configuration.cycle_time_us, header)
        return self._header


# --- the signals of conditions --------------------------------------------------------------------


def with_condition_signals(
    names: Sequence[str],
    programs: Mapping[int, Sequence[LoadedProgram]],
    machine: AssembledMachine,
) -> list[str]:
    """Return ``names`` followed by the further signals that conditions of programs read."""
    of_cell: dict[int, str] = {}
    for name, (cell, *_) in machine.signals().items():
        of_cell.setdefault(cell, name)
    further = (
        of_cell[cell]
        for number, loaded in programs.items()
        for program in loaded
        for cell in _cells(program, machine.assembled[number - 1].names)
        if cell in of_cell
    )
    return list(dict.fromkeys((*names, *further)))


def _cells(program: LoadedProgram, names: NameTable) -> Iterator[int]:
    """Yield the cells of the variables in conditions, in the order of the text."""
    for text in program.texts:
        for cycle in text.cycles:
            for branch in branch_outlines(cycle):
                if branch.condition is None:
                    continue
                for variable in variables_in(branch.condition):
                    cell = _cell(variable, names)
                    if cell is not None:
                        yield cell


def _cell(variable: tree.Variable, names: NameTable) -> int | None:
    """Return the cell of a number with constant indices, else ``None``."""
    location = resolve(variable, names)
    if not isinstance(location, Location) or not location.is_numeric:
        return None
    cell = location.cell
    for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
        if not isinstance(index, tree.Number):
            return None
        cell += int(index.value) * dimension.stride
    return cell
