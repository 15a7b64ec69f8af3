# SPDX-License-Identifier: MIT
"""A run of programs on a controller, from its begin to its result, in parts of any length.

In: programs, run options and a machine's loop of ticks. Out: ``ProgramRun``, which continues up to
a tick any number of times, and then closes with the ``Run``. Where it is interrupted never changes
a result.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.base.notebook_progress import NotebookProgress, notebook_progress
from nctakt.base.source_ids import SourceFiles
from nctakt.decoder.state.queued.start_block import StartBlock
from nctakt.lists.format.times import Time, read_time
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import PROGRAM_NOT_SELECTED
from nctakt.nc import tree
from nctakt.nc.outline import ProgramText
from nctakt.results.run import ExplainedRun, RecordedRun, Run, RunDrawer, RunState
from nctakt.results.run_statistics import RunStatistics
from nctakt.results.trace.recorded import MemorySink
from nctakt.results.trace.sinks import Sink
from nctakt.run import program_loader
from nctakt.run.access.inputs import NEVER
from nctakt.run.access.stimuli import as_inputs, not_reached, read_stimulus
from nctakt.run.causes.axis_waits import never_given
from nctakt.run.causes.deadlocks import deadlock, never_sent
from nctakt.run.causes.wait_reasons import wait_reasons
from nctakt.run.channel_run import ChannelRun, worst_state
from nctakt.run.options import RunKeywords
from nctakt.run.plcs.plc_view import PlcView, WatchedPlc
from nctakt.run.plcs.realtime_plc import parts_of, plc_object
from nctakt.run.program_loader import AnyProgram, LoadedProgram, ProgramErrors
from nctakt.run.realtime.assembly import AssembledMachine, do_nothing
from nctakt.run.recording import with_condition_signals
from nctakt.run.tick_loop import TickLoop, TickShares

if TYPE_CHECKING:
    pass

#: Virtual time after which a run ends if neither ``until`` nor ``ticks`` limits it.
DEFAULT_LIMIT_US = 600_000_000

#: How long a run that an error has stopped waits for axes and spindles to come to a standstill.
REST_US = 60_000_000

#: Ticks between two calls of a progress function.
PROGRESS_TICKS = 100_000


class ProgramRun:
    """A started run; ``state`` is ``None`` until it is over.

    ``programs``: number of the channel, from 1 -> its programs, in order. ``options``: all of
    ``Controller.run``, checked. Raises ``Failure`` as ``Controller.run``.
    """

    _notebook: NotebookProgress | None = None

    def __init__(
        self,
        loop: TickLoop,
        diagnostics: list[Diagnostic],
        programs: Mapping[int, Sequence[AnyProgram]],
        options: RunKeywords,
        *,
        with_statistics: bool = True,
    ) -> None:
        machine = loop.machine
        self._programs = programs
        self._loop = loop
        self._machine = machine
        self._diagnostics = diagnostics
        self._options = options
        self._cycle_time_us = machine.configuration.cycle_time_us
        self._first_tick = first_tick = loop.tick
        self._end = first_tick + self._limit()
        self._stimuli = [read_stimulus(stimulus) for stimulus in options["at"]]
        _set_up(loop.channels, options)
        self._plc = plc = plc_object(options["plc"])
        self._attach_plc()
        self._first_diagnostic = len(diagnostics) if first_tick else 0
        self._notes_at = len(diagnostics)
        if isinstance(plc, WatchedPlc):
            diagnostics += plc.notes()
        self._memory = MemorySink() if options["memory_trace"] else None
        machine.registry.on_cycle = options["on_cycle"]
        self._with_statistics = with_statistics
        self._statistics = RunStatistics(machine.registry.reactions_of, machine.registry.frozen_in)
        self._runs_before = machine.registry.runs()
        self._bodies_before = machine.registry.bodies()
        machine.show_named(options["signals"] or ())
        self._signals = loop.recording.checked(options["signals"])
        known = machine.signals()
        #: The values of its signals before the first tick.
        self.before = {name: machine.cells[known[name].cell] for name in self._signals}
        replay = options["replay"]
        loop.connect(plc, has_plc=replay is not None and replay.has_plc)
        loop.recording.messages = []
        loop.recording.on_message = options["on_message"]
        machine.inputs.plan(
            as_inputs(self._stimuli, first_tick, self._cycle_time_us)
            if replay is None
            else replay.inputs
        )
        machine.poll = functools.partial(
            self._report_progress, options["on_progress"], _notebook_of(options)
        )
        machine.inputs.on_select = self._select
        self._parts: Iterator[int] | None = None
        self._loaded: list[LoadedProgram] = []
        self.state: RunState | None = None

    def _attach_plc(self) -> None:
        """Start the PLC on the machine; set the values that apply before the first tick."""
        machine, options, plc = self._machine, self._options, self._plc
        for one in parts_of(plc)[0]:
            one.is_replayed = one.is_replayed or options["replay"] is not None
            if options["why"]:
                one.explain()
        self._loop.attach(plc)
        for name, value in (options["set"] or {}).items():
            machine.write(name, value)
        machine.access.apply_writes()
        machine.inputs.listen(options["record"])
        for stimulus in self._stimuli:
            machine.access.check(stimulus.name, stimulus.value)
        if isinstance(plc, WatchedPlc):
            plc.begin_run(PlcView(machine))

    @property
    def options(self) -> RunKeywords:
        """All options of the run."""
        return self._options

    @property
    def machine(self) -> AssembledMachine:
        """The machine that it runs on."""
        return self._machine

    @property
    def channel_runs(self) -> Sequence[ChannelRun]:
        """The programs of each channel."""
        return self._loop.channels

    @property
    def end(self) -> int:
        """The tick at which its limit ends it."""
        return self._end

    def _limit(self) -> int:
        """Return the maximum number of ticks of the run."""
        ticks, until = self._options["ticks"], self._options["until"]
        limits = [ticks] if ticks is not None else []
        if until is not None:
            limits.append(read_time(until).ticks(self._cycle_time_us))
        if self._options["stays"] and not limits:
            return NEVER
        return min(limits) if limits else DEFAULT_LIMIT_US // self._cycle_time_us

    def _default_limit(self) -> Text | None:
        """Return the limit of runs without one, ``None`` if somebody has set a limit."""
        if self._options["ticks"] is not None or self._options["until"] is not None:
            return None
        limit = str(Time(DEFAULT_LIMIT_US))
        return Text(limit, limit)

    def _report_progress(
        self,
        on_progress: Callable[[int, int | None], None] | None,
        notebook: NotebookProgress | None,
    ) -> None:
        if on_progress is not None:
            on_progress(self._loop.tick, self._end)
        elif notebook is not None:
            self._notebook = notebook
            done = self._loop.tick - self._first_tick
            notebook.show(done, None if self._default_limit() else self._limit())

    # --- beginning again ------------------------------------------------------------------------

    def pause(self, pauses_before: Callable[[tree.Statement], bool]) -> bool:
        """Let the first channel decode up to a pause before a statement, before the first tick.

        Returns whether it has paused (``QueueFeeder.pause``).
        """
        if self._parts is None:
            self.load()
        assert self._parts is not None
        if next(self._parts, None) is None:
            return False
        feeder = self._loop.channels[0].feeder
        return feeder is not None and feeder.pause(pauses_before)

    def leave_names(self) -> None:
        """Let the results so far keep their names: their source will be restored."""
        self._loop.recording.leave_names()

    def begin_again(self, options: RunKeywords) -> None:
        """Begin as another run from the pause before a statement, in which all objects are again.

        ``options`` are those of the run that begins: with other values, times and sinks. Raises
        ``Failure`` for those that the machine does not take.
        """
        machine, loop = self._machine, self._loop
        self._options = options
        self._stimuli = [read_stimulus(stimulus) for stimulus in options["at"]]
        self._plc = plc = plc_object(options["plc"])
        self._attach_plc()
        if isinstance(plc, WatchedPlc):
            self._diagnostics[self._notes_at : self._notes_at] = plc.notes()
        known = machine.signals()
        self.before = {name: machine.cells[known[name].cell] for name in self._signals}
        loop.connect(plc, has_plc=False)
        machine.inputs.plan(as_inputs(self._stimuli, self._first_tick, self._cycle_time_us))
        self._memory = MemorySink() if options["memory_trace"] else None
        loop.recording.listen_anew(self._sinks(), self._signals)
        self._parts = self._run_channels([loop.channels[0]])

    def record(self, signals: Sequence[str] | None) -> None:
        """Let the result have a trace of the ticks from here on, by default of the usual signals.

        Raises ``Failure`` for unknown signals.
        """
        recording = self._loop.recording
        names = recording.checked(signals)
        self._memory = MemorySink()
        recording.record(self._memory, names)

    # --- going on -------------------------------------------------------------------------------

    def load(self) -> None:
        """Read and check the programs, before the first tick."""
        loaded: dict[int, list[LoadedProgram]] = {}
        has_errors = False
        for number, programs in self._programs.items():
            own = loaded.setdefault(number, [])
            for program in programs:
                try:
                    own.append(
                        program_loader.load(program, self._machine, self._diagnostics, number - 1)
                    )
                except ProgramErrors:
                    has_errors = True
        self._loaded = [program for own in loaded.values() for program in own]
        if not self._options["stays"] and not has_errors:
            self._diagnostics += never_sent(self._machine, self._loaded)
            self._diagnostics += never_given(self._machine, self._loaded)
        self._open_recording(loaded)
        if not has_errors:
            self._loop.couple(self._options["fmu"])
        self._parts = iter(()) if has_errors else self._run_programs(loaded)
        self.state = "error" if has_errors else None

    def _open_recording(self, programs: Mapping[int, Sequence[LoadedProgram]]) -> None:
        options, signals = self._options, self._signals
        if options["condition_signals"]:
            signals = with_condition_signals(signals, programs, self._machine)
        self._loop.recording.open(
            self._sinks(),
            signals,
            options["record_writes"] and (bool(options["sinks"]) or options["memory_trace"]),
            options["why"],
            options["blocks"],
        )

    def _sinks(self) -> list[Sink]:
        """Return who listens to the trace."""
        memory = (self._memory,) if self._memory else ()
        statistics = (self._statistics,) if self._with_statistics else ()
        return [*self._options["sinks"], *memory, *statistics]

    @property
    def texts(self) -> list[ProgramText]:
        """The texts of its programs, with the subprograms that have been called so far."""
        return [text for program in self._loaded for text in program.texts]

    @property
    def scheduled_run(self) -> TickShares | None:
        """The schedule that gives decoder, interpolation and PLC their time, if there is one."""
        return self._loop.scheduled_run

    def advance(self, end: int | None = None) -> bool:
        """Continue up to tick ``end``, by default to the end of the run.

        Returns whether a stop of the kernel has ended it before. Once ``state`` has a value the run
        is over.
        """
        if self._parts is None:
            self.load()
        assert self._parts is not None
        is_stopped = False
        while self.state is None and (end is None or self._loop.tick < end):
            bound = next(self._parts, None)
            if bound is None:
                break
            is_stopped = self._loop.advance(bound if end is None else min(bound, end))
            self._machine.poll()
            if is_stopped:
                break
        self._machine.inputs.hand_over()
        return is_stopped

    def _run_programs(self, programs: Mapping[int, Sequence[LoadedProgram]]) -> Iterator[int]:
        """Yield up to which tick the loop may go next; set the state at the end."""
        loop = self._loop
        waits, stays = self._options["wait_for_start"], self._options["stays"]
        channels = [loop.channels[number - 1] for number, own in programs.items() if own or stays]
        if not waits:
            loop.make_ready(channels)
        for number, own in programs.items():
            loop.channels[number - 1].queue(own, waits_for_start=waits)
        loop.ends_deadlock = not waits and not stays
        yield from self._run_channels(channels)

    def _run_channels(self, channels: Sequence[ChannelRun]) -> Iterator[int]:
        """Yield up to which tick the loop may go next, from the begin of the programs on."""
        loop, end, stays = self._loop, self._end, self._options["stays"]
        while self._proceed(channels) or stays:
            if loop.is_deadlocked:
                self._diagnostics += deadlock(self._machine, self._loaded)
                self.state = "error"
                return
            if loop.tick >= end:
                self._diagnostics += wait_reasons(
                    self._machine, loop.channels, self._default_limit()
                )
                self.state = worst_state(channels, "limit")
                return
            # A path that brakes ends the run in the tick in which it comes to rest.
            count = 1 if any(channel.is_braking for channel in channels) else PROGRESS_TICKS
            yield min(end, loop.tick + count)
        state = worst_state(channels, "ended")
        stop = loop.tick + read_time(self._options["after"]).ticks(self._cycle_time_us)
        while loop.tick < min(stop, end):
            yield min(stop, end, loop.tick + PROGRESS_TICKS)
        count = REST_US // self._cycle_time_us if state == "error" else end
        rest = min(end, loop.tick + count)
        while loop.tick < rest and not self._machine.has_stopped():
            yield loop.tick + 1
        if loop.state == "error":
            self.state = "error"
        else:
            self.state = "limit" if loop.tick < stop else state

    def _select(self, index: int, name: str) -> None:
        """Let a channel that is ready have this program next, or report why it cannot."""
        channel = self._loop.channels[index]
        if channel.is_running or channel.is_stopped:
            state = "error" if channel.is_stopped else "running"
            found = diagnostic(PROGRAM_NOT_SELECTED, program=name, channel=index + 1, state=state)
            self._diagnostics.append(found)
            return
        try:
            loaded = program_loader.load(name, self._machine, self._diagnostics, index)
        except ProgramErrors:
            return
        except Failure as failure:
            self._diagnostics += failure.diagnostics
            return
        self._loaded.append(loaded)
        channel.queue([loaded], waits_for_start=self._options["wait_for_start"])
        channel.proceed()

    def _proceed(self, channels: Sequence[ChannelRun]) -> bool:
        """Let each channel begin the program that is due; return whether any is still at work."""
        for channel in channels:
            channel.proceed()
        return None in [channel.result for channel in channels]

    # --- the result -----------------------------------------------------------------------------

    def interrupt(self) -> None:
        """End the run where it is."""
        self._loop.recording.drain()
        self.state = "interrupted"

    def close(self) -> None:
        """Let the PLC end and close the listeners; no program waits for START any more."""
        if self._notebook is not None:
            self._notebook.close()
        for plc in parts_of(self._plc)[0]:
            self._diagnostics += plc.end()
            plc.is_replayed = plc.is_replayed and self._options["replay"] is None
        self._loop.recording.close()
        self._loop.ends_deadlock = False
        for channel in self._loop.channels:
            channel.close()
        self._machine.registry.on_cycle = self._machine.inputs.on_select = None
        self._machine.inputs.listen(None)
        self._machine.poll = do_nothing
        self._loop.couple(None)

    def _counts(self) -> dict[str, Any]:
        """Return the counts of the result by their names, none in a run without them.

        Among them are the realtime cycles, with their and their branches' run-throughs in this run.
        """
        if not self._with_statistics:
            return {}
        registry, statistics = self._machine.registry, self._statistics
        runs, bodies = registry.runs(), registry.bodies()
        runs.subtract(self._runs_before)
        bodies.subtract(self._bodies_before)
        return {
            "cycles": statistics.cycles(runs, bodies),
            "outputs": statistics.outputs(),
            "motions": statistics.motions(),
            "spindle_jobs": statistics.spindle_jobs(),
            "starved": statistics.schedule.starved(self._loop.tick),
            "overflows": statistics.schedule.overflows(),
        }

    def _drawer(self) -> Callable[[], RunDrawer]:
        """Return the maker of this run's drawer; the machine may run again before it is called."""
        machine = self._machine
        limits_jerk = machine.channels[0].queue.look_ahead.limits.has_jerk_limit
        return functools.partial(_drawer, machine, machine.files.copy(), limits_jerk)

    def result(self) -> Run:
        """Return the result of a run that is over and closed."""
        assert self.state is not None
        machine, loop, plc = self._machine, self._loop, self._plc
        if self.state not in ("error", "interrupted"):
            end_us = (loop.tick - self._first_tick) * self._cycle_time_us
            self._diagnostics += not_reached(self._stimuli, end_us, self._cycle_time_us)
            if isinstance(plc, WatchedPlc):
                self._diagnostics += plc.unused_handlers(PlcView(machine))
        scheduled = loop.scheduled_run
        if scheduled is not None:
            self._diagnostics += scheduled.findings()
        report, coverage = loop.recording.why(self._first_tick, self.texts)
        for one in parts_of(plc)[0]:
            counted = one.coverage()
            if coverage is not None and counted is not None:
                coverage = coverage.plus(counted)
            if report is not None:
                report = report.with_plc(one.changes())
        kind: type[Run] = Run
        if self._memory is not None:
            kind = RecordedRun if report is None or coverage is None else ExplainedRun
        return kind(
            programs=tuple(
                program_loader.name_of(program)
                for own in self._programs.values()
                for program in own
            ),
            cycle_time_us=self._cycle_time_us,
            first_tick=self._first_tick,
            ticks=loop.tick - self._first_tick,
            state=self.state,
            trace=None if self._memory is None else self._memory.trace,
            diagnostics=tuple(self._diagnostics[self._first_diagnostic :]),
            messages=tuple(loop.recording.messages),
            **self._counts(),
            schedule=None if scheduled is None else scheduled.schedule,
            why=report,
            coverage=coverage,
            drawer=None if self._memory is None else self._drawer(),
            before=self.before,
        )


def _drawer(machine: AssembledMachine, files: SourceFiles, limits_jerk: bool) -> RunDrawer:
    """Return the drawer of a machine's runs; ``files``: the texts of its programs."""
    from nctakt.plots.drawer import Drawer  # noqa: PLC0415 - few runs are drawn

    return Drawer(machine.channel_axes, files.line_at, limits_jerk=limits_jerk)


def _notebook_of(options: RunKeywords) -> NotebookProgress | None:
    """Return the progress display of a run in a notebook, unless there is another."""
    is_shown = options["on_progress"] is None and not options["stays"]
    return notebook_progress("Run") if is_shown else None


def _set_up(channels: Sequence[ChannelRun], options: RunKeywords) -> None:
    """Give the channels their options."""
    for channel in channels:
        channel.skip_levels = frozenset(options["skip"])
        channel.marks_blocks = options["blocks"]
        channel.start = None
    channels[0].start = _start_of(options)


def _start_of(options: RunKeywords) -> StartBlock | None:
    """Return the block where the first program of channel 1 begins by block search."""
    line, number = options["from_line"], options["from_block"]
    return None if line is None and number is None else StartBlock(line or 0, number or 0)
