# SPDX-License-Identifier: MIT
"""The virtual controller: assembles a machine and runs NC programs on it.

In: a machine (a folder, a loaded one or the demo machine), programs, values of variables at times,
a PLC. Out: a ``Run``. ``run`` does it all; ``start`` and ``step`` go tick by tick. Controllers are
independent of each other; any number of them can live in one process.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.files.access import FileAccess
from nctakt.kernel import codes
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.backward import BACKWARD_WITHOUT_HISTORY
from nctakt.messages.folders import UNKNOWN_CHANNEL
from nctakt.nc.outline import ProgramText
from nctakt.results.run import ProgramMessage, Run, RunState
from nctakt.results.run_statistics import RunStatistics
from nctakt.run import program_loader
from nctakt.run.assembly import AssembledMachine, do_nothing
from nctakt.run.channel_run import ChannelRun, is_reported, worst_state
from nctakt.run.one_at_a_time import OneAtATime, alone
from nctakt.run.plc_view import AnyPlc, PlcView, WatchedPlc
from nctakt.run.program_loader import LoadedProgram, NcText, ProgramErrors
from nctakt.run.recording import Recording
from nctakt.run.shared_image import SharedImage
from nctakt.run.stimuli import StimulusLike, as_inputs, not_reached, read_stimulus
from nctakt.run.wait_reasons import wait_reasons
from nctakt.trace.recorded import MemorySink
from nctakt.trace.sinks import Sink

if TYPE_CHECKING:
    from nctakt.run.inputs import Input
    from nctakt.run.tape import Tape
    from nctakt.schedule.open_schedule import RunSchedule

__all__ = ["DEFAULT_LIMIT_US", "Controller", "NcText"]

#: Virtual time after which a run ends if neither ``until`` nor ``ticks`` limits it.
DEFAULT_LIMIT_US = 600_000_000

#: How long a run that an error has stopped waits for axes and spindles to come to a stand.
REST_US = 60_000_000

#: Ticks between two calls of a progress function.
PROGRESS_TICKS = 100_000


class Controller:
    """One machine with its channels, from start-up on.

    ``machine``: a folder with lists, a loaded ``Machine``, or ``None`` for the built-in demo
    machine. ``schedule`` (of ``open_schedule``) sets the length of a tick and the time that
    decoder, interpolation and PLC get. ``access`` limits the files that may be read
    (``FileAccess([folder])``: only those in a folder). Raises ``Failure`` if no machine results.

    Times are texts with a unit (us, ms, s, min, h, ticks), seconds or ``datetime.timedelta``.
    ``diagnostics``: findings in the machine's lists and in all programs so far.

    >>> controller = Controller()
    >>> controller.run(NcText("move.nc", "G01 X100 F6000 M30"))
    <Run of move.nc: ended after 1.026 s, 1026 ticks; 0 messages, 0 errors, 0 warnings>
    >>> controller.read("V.RTA.ACS.ACT_POS.X")
    100.0
    """

    def __init__(
        self,
        machine: Machine | str | Path | None = None,
        schedule: RunSchedule | None = None,
        access: FileAccess | None = None,
    ) -> None:
        access = access or FileAccess()
        if not isinstance(machine, Machine):
            machine = load_machine(machine, access=access)
        roles = None
        if schedule is not None:
            from nctakt.run.scheduled_run import ScheduledRun, scheduled  # noqa: PLC0415 - rare

            machine, roles = scheduled(machine, schedule)
        self.machine = machine
        self.cycle_time_us = machine.cycle_time_us
        self.diagnostics: list[Diagnostic] = list(machine.diagnostics)
        self._machine = AssembledMachine(machine, access)
        self._machine.report = self.diagnostics.append
        self.turn = OneAtATime()
        self._channels = [
            ChannelRun(self._machine, index, self.diagnostics.append)
            for index in range(len(self._machine.channels))
        ]
        self._scheduled_run = None
        if schedule is not None and roles is not None:
            self._scheduled_run = ScheduledRun(self._machine, schedule, roles)
            for index, channel in enumerate(self._channels):
                channel.budget = self._scheduled_run.budget(index)
        self._kernel = self._machine.kernel
        self._recording = Recording(
            self._machine, self.diagnostics.append, functools.partial(is_reported, self._channels)
        )
        self._has_plc = False
        self._plc: AnyPlc | None = None
        self._image: SharedImage | None = None
        self._loaded: list[LoadedProgram] = []

    def __repr__(self) -> str:
        count, axes = len(self._channels), len(self.machine.axes)
        size = f"{count} channel{'s'[: count != 1]}, {axes} axes"
        return f"<Controller of {self.machine.name}: {size}, {self.state} at tick {self.tick}>"

    # --- state and variables --------------------------------------------------------------------

    @property
    def tick(self) -> int:
        """The number of ticks since start-up."""
        return self._kernel.tick

    @property
    def channel_count(self) -> int:
        """The number of channels; they count from 1."""
        return len(self._channels)

    @property
    def state(self) -> str:
        """``error`` if a channel has one, else ``running`` during a program, else ``ready``."""
        if any(channel.is_stopped for channel in self._channels):
            return "error"
        return "running" if any(channel.is_running for channel in self._channels) else "ready"

    @property
    def hli(self) -> PlcView:
        """The interface to the PLC (HLI): a PLC's view of the first channel, operator's panel."""
        return PlcView(self._machine)

    @property
    def default_signals(self) -> tuple[str, ...]:
        """The signals recorded by default: axes, path speed, override, block, active cycles."""
        return tuple(self._machine.default_signals())

    @property
    def channel_axes(self) -> tuple[AxisConfiguration, ...]:
        """The axes of the first channel, in the order of its list."""
        return tuple(self.machine.axes[index] for index in self._machine.members)

    @property
    def has_limited_jerk(self) -> bool:
        """Whether any block of the first channel so far had the jerk-limited slope."""
        return self._machine.channels[0].queue.look_ahead.limits.has_jerk_limit

    @property
    def instructions_in_tick(self) -> int:
        """The elementary instructions that realtime cycles ran in the latest tick (RC-501)."""
        return sum(channel.channel.context.steps for channel in self._channels)

    def read(self, name: str) -> float | bool | str:
        """Return the value of a V. variable, such as ``V.E.LIST[3]`` or ``V.RTA.ACS.ACT_POS.X``.

        A name without a channel means the first one; ``CH2.V.CH.COUNT`` is that of the second.
        A value that ``write`` has set is returned at once. Raises ``Failure`` for an unknown name.
        """
        return self._machine.read(name)

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a V.E or V.CH variable or an operator's value (``HLI.OVERRIDE``) from the next tick.

        Raises ``Failure`` for an unknown name and for a value that the variable cannot hold.
        """
        self._machine.write(name, value)

    def signal(self, name: str) -> float:
        """Return the present value of a signal; raises ``Failure`` for an unknown name."""
        signals = self._machine.signals()
        if name not in signals:
            raise Failure(self._machine.unknown_signal(name))
        return self._machine.cells[signals[name][0]]

    def interface_image(self, name: str | None = None) -> SharedImage:
        """Return the HLI as bytes, live until it is closed, and shared under ``name`` if given.

        Raises ``Failure`` if there is one already, or if the shared memory is not available.
        """
        machine = self._machine
        self._image = SharedImage(
            self.machine, machine.kernel, machine.channels, machine.layout, name
        )
        return self._image

    # --- tick by tick ---------------------------------------------------------------------------

    @alone
    def start(self, program: str | Path | NcText, channel: int = 1) -> None:
        """Start a program in a channel; ``step`` runs it.

        An error of the previous program, or the program itself if it still runs, is reset first.
        Raises ``Failure`` with the program's errors.
        """
        channel_run = self._channels[self._index(channel)]
        loaded = program_loader.load(program, self._machine, self.diagnostics, channel - 1)
        self._make_ready([channel_run])
        channel_run.begin(loaded)

    @alone
    def select(self, program: str | Path | NcText, channel: int = 1) -> None:
        """Select a program, which START on the HLI begins; raises ``Failure`` with its errors."""
        self._channels[self._index(channel)].select(
            program_loader.load(program, self._machine, self.diagnostics, channel - 1)
        )

    @alone
    def step(self, ticks: int = 1) -> None:
        """Run this number of ticks, whatever the state."""
        end = self.tick + ticks
        while self.tick < end:
            self._advance(end)

    def backward(self, channel: int = 1) -> None:
        """Move backward on the path from the next tick on (MO-7); ``forward`` ends it.

        Raises ``Failure`` (50453) if the machine keeps no history of the path.
        """
        index = self._index(channel)
        if self._machine.channels[index].path.history_size == 0:
            raise Failure(diagnostic(BACKWARD_WITHOUT_HISTORY))
        self._command_motion(index, backward=True)

    def forward(self, channel: int = 1) -> None:
        """Move forward on the path again from the next tick on."""
        self._command_motion(self._index(channel), backward=False)

    def _command_motion(self, index: int, *, backward: bool) -> None:
        prefix = self._machine.assembled[index].prefix if index else ""
        self._machine.write(f"{prefix}HLI.BACKWARD_MOTION", backward)

    @alone
    def reset(self, channel: int | None = None) -> None:
        """Reset one channel or all of them (RC-007); run until they stand, at least one tick."""
        channels = self._channels if channel is None else [self._channels[self._index(channel)]]
        self._reset(channels)

    def _reset(self, channels: Sequence[ChannelRun]) -> None:
        for channel in channels:
            channel.request_reset()
        while any(channel.channel.executor.is_resetting for channel in channels):
            self._advance(self.tick + 1)

    def _index(self, channel: int) -> int:
        """Return the index of a channel, from 0; raises ``Failure`` if there is none."""
        if not 0 < channel <= len(self._channels):
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=channel, count=len(self._channels)))
        return channel - 1

    # --- whole programs -------------------------------------------------------------------------

    @alone
    def run(
        self,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        set: Mapping[str, float | str] | None = None,
        at: Sequence[StimulusLike] = (),
        until: TimeLike | None = None,
        ticks: int | None = None,
        after: TimeLike = 0,
        plc: AnyPlc | None = None,
        wait_for_start: bool = False,
        skip: Collection[int] = (),
        signals: Sequence[str] | None = None,
        sinks: Sequence[Sink] = (),
        memory_trace: bool = True,
        record_writes: bool = True,
        why: bool = False,
        on_message: Callable[[ProgramMessage], None] | None = None,
        on_progress: Callable[[int, int | None], None] | None = None,
        on_cycle: Callable[[str, CycleDefinition], None] | None = None,
        blocks: bool = False,
        record: Callable[[Input], None] | None = None,
        replay: Tape | None = None,
    ) -> Run:
        """Run programs one after another and return the result.

        GLOBAL cycles, V.E and V.CH variables live on from program to program and from run to run.
        ``programs`` are files or ``NcText`` of channel 1, ``channels`` those of the others by
        number. All channels begin together; an error stops its own channel only.

        ``set`` gives variables values before the first tick, ``at`` at times of the run:
        ``at=[("20 ms", "V.E.DOOR", 1)]``. ``until`` and ``ticks`` limit the run (10 minutes unless
        given), ``after`` is the time that the machine goes on after the last program. With
        ``wait_for_start`` START on the HLI begins each program, again after a RESET. Blocks of the
        levels ``skip``, 1 … 10, are skipped. ``sinks`` receive the trace of ``signals`` (by default
        ``default_signals``), which ``memory_trace`` keeps in the result; with ``record_writes``
        each new value that a cycle assigns to a variable is an event in it. ``why`` records the
        history of each condition of the realtime cycles (``Run.why``) and counts it
        (``Run.coverage``). ``blocks``: events for decoding and execution of blocks, and for each
        flush of the channel. ``on_message`` is called with each message of a program,
        ``on_progress`` with the ticks so far and of the whole run, ``on_cycle`` with the name and
        the definition of each realtime cycle when it is decoded, ``record`` with each input from
        outside behind ``set``. ``replay``: the inputs of a recorded run instead of ``at`` and
        ``plc``.

        Raises ``Failure`` for a program that cannot be read and for an invalid name, value or time;
        mistakes in the programs are in the result.
        """
        limit = self._limit(None if until is None else read_time(until), ticks)
        rest_ticks = read_time(after).ticks(self.cycle_time_us)
        stimuli = [read_stimulus(stimulus) for stimulus in at]
        by_channel = {1: programs, **(channels or {})}
        for number in by_channel:
            self._index(number)
        for channel in self._channels:
            channel.skip_levels = frozenset(skip)
            channel.marks_blocks = blocks
        first_tick = self.tick
        for name, value in (set or {}).items():
            self._machine.write(name, value)
        self._machine.access.apply_writes()
        self._machine.inputs.listener = record
        for stimulus in stimuli:
            self._machine.access.check(stimulus.name, stimulus.value)
        if isinstance(plc, WatchedPlc):
            plc.begin_run(self.hli)
        first_diagnostic = len(self.diagnostics) if first_tick else 0
        memory = MemorySink() if memory_trace else None
        registry = self._machine.registry
        registry.on_cycle = on_cycle
        statistics = RunStatistics(registry.reactions_of, registry.frozen_in)
        listeners = [*sinks, *((memory,) if memory else ()), statistics]
        self._recording.open(listeners, signals, bool(sinks) or memory_trace, record_writes, why)
        self._plc = plc
        self._has_plc = plc is not None or (replay is not None and replay.has_plc)
        for channel in self._channels:
            channel.channel.hli.acknowledges_itself = not self._has_plc
        self._recording.on_message = on_message
        planned = as_inputs(stimuli, first_tick, self.cycle_time_us)
        self._machine.inputs.plan(planned if replay is None else replay.inputs)
        end = first_tick + limit
        self._machine.poll = functools.partial(self._report_progress, on_progress, end)
        try:
            state = self._run_programs(by_channel, end, rest_ticks, wait_for_start)
        except KeyboardInterrupt:
            self._recording.drain()
            state = "interrupted"
        finally:
            self._recording.close()
            for channel in self._channels:
                channel.close()
            registry.on_cycle = self._machine.inputs.listener = None
            self._machine.poll = do_nothing
        if state not in ("error", "interrupted"):
            end_us = (self.tick - first_tick) * self.cycle_time_us
            self.diagnostics += not_reached(stimuli, end_us, self.cycle_time_us)
            if isinstance(plc, WatchedPlc):
                self.diagnostics += plc.unused_handlers(self.hli)
        if self._scheduled_run is not None:
            self.diagnostics += self._scheduled_run.findings()
        report, coverage = self._recording.why(first_tick, self._loaded_texts())
        return Run(
            programs=tuple(
                program_loader.name_of(program) for own in by_channel.values() for program in own
            ),
            cycle_time_us=self.cycle_time_us,
            first_tick=first_tick,
            ticks=self.tick - first_tick,
            state=state,
            trace=None if memory is None else memory.trace,
            diagnostics=tuple(self.diagnostics[first_diagnostic:]),
            messages=tuple(self._recording.messages),
            cycles=statistics.cycles(self._machine.registry.runs()),
            outputs=statistics.outputs(),
            schedule=None if self._scheduled_run is None else self._scheduled_run.schedule,
            starved=statistics.schedule.starved(self.tick),
            overflows=statistics.schedule.overflows(),
            why=report,
            coverage=coverage,
        )

    def _loaded_texts(self) -> list[ProgramText]:
        """Return the texts of the programs of this run."""
        programs, self._loaded = self._loaded, []
        return [text for program in programs for text in program.texts]

    def _limit(self, until: Time | None, ticks: int | None) -> int:
        """Return the maximum number of ticks of a run."""
        limits = [ticks] if ticks is not None else []
        if until is not None:
            limits.append(until.ticks(self.cycle_time_us))
        return min(limits) if limits else DEFAULT_LIMIT_US // self.cycle_time_us

    def _run_programs(
        self,
        programs: Mapping[int, Sequence[str | Path | NcText]],
        end: int,
        rest_ticks: int,
        wait_for_start: bool,
    ) -> RunState:
        loaded = self._load(programs)
        if loaded is None:
            return "error"
        channels = [self._channels[number - 1] for number, own in loaded.items() if own]
        if not wait_for_start:
            self._make_ready(channels)
        for number, own in loaded.items():
            self._channels[number - 1].queue(own, waits_for_start=wait_for_start)
        while self._proceed(channels):
            if self.tick >= end:
                self.diagnostics += wait_reasons(self._machine, self._channels)
                return worst_state(channels, "limit")
            # A path that brakes ends the run in the tick in which it stands.
            count = 1 if any(channel.is_braking for channel in channels) else PROGRESS_TICKS
            self._advance(min(end, self.tick + count))
            self._machine.poll()
        state = worst_state(channels, "ended")
        stop = self.tick + rest_ticks
        while self.tick < min(stop, end):
            self._advance(min(stop, end, self.tick + PROGRESS_TICKS))
            self._machine.poll()
        count = REST_US // self.cycle_time_us if state == "error" else end
        rest = min(end, self.tick + count)
        while self.tick < rest and not self._machine.stands():
            self._advance(self.tick + 1)
        if self.state == "error":
            return "error"
        return "limit" if self.tick < stop else state

    def _proceed(self, channels: Sequence[ChannelRun]) -> bool:
        """Let each channel begin the program that is due; return whether any is still at work."""
        for channel in channels:
            channel.proceed()
        return any(channel.result is None for channel in channels)

    def _load(
        self, programs: Mapping[int, Sequence[str | Path | NcText]]
    ) -> dict[int, list[LoadedProgram]] | None:
        """Return the checked programs of each channel; ``None`` if one of them has errors."""
        loaded: dict[int, list[LoadedProgram]] = {number: [] for number in programs}
        self._loaded = []
        has_errors = False
        for number, own in programs.items():
            for program in own:
                try:
                    tree = program_loader.load(program, self._machine, self.diagnostics, number - 1)
                except ProgramErrors:
                    has_errors = True
                    continue
                loaded[number].append(tree)
                self._loaded.append(tree)
        return None if has_errors else loaded

    def _make_ready(self, channels: Sequence[ChannelRun]) -> None:
        """Reset those of the channels that an earlier run has left stopped or running."""
        busy = [channel for channel in channels if channel.is_stopped or channel.is_running]
        if busy:
            self._reset(busy)

    def _report_progress(
        self, on_progress: Callable[[int, int | None], None] | None, end: int
    ) -> None:
        if on_progress is not None:
            on_progress(self.tick, end)

    # --- the loop decoder <-> kernel ------------------------------------------------------------

    def _advance(self, end: int) -> None:
        """Run up to tick ``end``, or until the decoder, a stimulus or the PLC is due."""
        due = min(end, self._machine.inputs.apply_due())
        if self._plc is not None:
            due = min(due, self.tick + 1)
        plc_calls = 1
        is_lost = False
        if self._scheduled_run is not None:
            due = min(due, self.tick + 1)
            share = self._scheduled_run.prepare(self._channels, has_plc=self._has_plc)
            plc_calls, is_lost = share.plc_calls, share.is_lost
        self._machine.access.post_writes()
        self._machine.reserve()
        reason = self._kernel.lose_tick() if is_lost else self._kernel.run(due - self.tick)
        self._recording.drain()
        if reason not in (codes.DONE, codes.FULL):
            for channel in self._channels:
                channel.serve()
        if self._plc is not None and self._kernel.tick == due and reason != codes.FULL:
            for _ in range(plc_calls):
                self._plc.cycle(PlcView(self._machine))
