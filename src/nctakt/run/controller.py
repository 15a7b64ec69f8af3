# SPDX-License-Identifier: MIT
"""The virtual controller: assembles a machine and runs NC programs on it.

In: a machine (a folder, a loaded one or the demo machine), programs, values of variables at times,
a PLC. Out: a ``Run``. ``run`` does everything; ``start`` and ``step`` go tick by tick. Controllers
are independent of each other; any number of them can live in one process.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Literal, Self, Unpack, overload

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.plain_values import plain_number
from nctakt.files.access import FileAccess
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.controller import REUSE_WITH_SCHEDULE
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.messages.path.backward import BACKWARD_WITHOUT_HISTORY
from nctakt.results.run import ExplainedRun, RecordedRun, Run, Step
from nctakt.results.trace.recorded import EventList
from nctakt.results.trace.sinks import Signal
from nctakt.run import program_loader
from nctakt.run.access.bound_values import BoundValue
from nctakt.run.access.inputs import IMAGE
from nctakt.run.access.shared_image import SharedImage
from nctakt.run.access.stimuli import StimulusLike, as_inputs, read_stimulus
from nctakt.run.one_at_a_time import OneAtATime, alone
from nctakt.run.options import (
    KeywordsOfAnyResult,
    RunKeywords,
    check_keywords,
    completed,
    with_keywords,
)
from nctakt.run.plcs.plc_view import AnyPlc, GivenPlc, PlcView, WatchedPlc
from nctakt.run.plcs.realtime_plc import plc_object
from nctakt.run.program_loader import AnyProgram, LoadedProgram, NcText
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.tick_loop import TickLoop

if TYPE_CHECKING:
    from nctakt.run.access.inputs import Input
    from nctakt.run.realtime.realtime_part import RealtimePart
    from nctakt.run.reusable import ReusableController
    from nctakt.schedule.open_schedule import RunSchedule

__all__ = ["Controller", "NcText"]


class Controller:
    """One machine with its channels, from start-up on.

    ``machine``: a folder with lists, a loaded ``Machine``, or ``None`` for the built-in demo
    machine. ``schedule`` (of ``open_schedule``) sets the length of a tick and the time that
    decoder, interpolation and PLC get. ``access`` limits the files that may be read
    (``FileAccess([folder])``: only those in a folder). ``realtime``: the realtime part of an
    earlier controller of this machine, restored to its start-up state; by default a new one. Raises
    ``Failure`` if no machine results.

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
        realtime: RealtimePart | None = None,
    ) -> None:
        access = access or FileAccess()
        if not isinstance(machine, Machine):
            machine = load_machine(machine, access=access)
        roles = None
        if schedule is not None:
            from nctakt.run.scheduled.scheduled_run import ScheduledRun, scheduled  # noqa: PLC0415 - rare

            machine, roles = scheduled(machine, schedule)
        self.machine = machine
        self.cycle_time_us = machine.cycle_time_us
        self.diagnostics: list[Diagnostic] = list(machine.diagnostics)
        self._machine = AssembledMachine(machine, access, realtime)
        self._machine.report = self.diagnostics.append
        self.turn = OneAtATime()
        scheduled_run = None
        if schedule is not None and roles is not None:
            scheduled_run = ScheduledRun(self._machine, schedule, roles)
        self._loop = TickLoop(self._machine, self.diagnostics.append, scheduled_run)
        self._image: SharedImage | None = None
        self._hli = PlcView(self._machine)

    def __repr__(self) -> str:
        count, axes = len(self._loop.channels), len(self.machine.axes)
        size = f"{count} channel{'s'[: count != 1]}, {axes} axes"
        return f"<Controller of {self.machine.name}: {size}, {self.state} at tick {self.tick}>"

    def close(self) -> None:
        """Close the interface image, if there is one; the controller itself holds nothing open."""
        if self._image is not None and not self._image.is_closed:
            self._image.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    # --- state and variables --------------------------------------------------------------------

    @property
    def tick(self) -> int:
        """The number of ticks since start-up."""
        return self._loop.tick

    @property
    def channel_count(self) -> int:
        """The number of channels; they count from 1."""
        return len(self._loop.channels)

    @property
    def state(self) -> str:
        """``error`` if a channel has one, ``running`` during a program, otherwise ``ready``."""
        return self._loop.state

    @property
    def hli(self) -> PlcView:
        """The interface to the PLC (HLI): a PLC's view of the first channel, operator's panel."""
        return self._hli

    @property
    def default_signals(self) -> tuple[str, ...]:
        """The signals recorded by default: axes, path speed, override, block, active cycles."""
        return tuple(self._machine.default_signals())

    @property
    def channel_axes(self) -> tuple[AxisConfiguration, ...]:
        """The axes of the first channel, in the order of its list."""
        return self._machine.channel_axes

    @property
    def motion_signals(self) -> tuple[str, ...]:
        """The signals that a picture of these axes needs."""
        from nctakt.plots import motion  # noqa: PLC0415 - loads numpy

        steps = self.machine.channels[0].parameters.transformations.steps
        names = [axis.name for axis in self.channel_axes]
        return motion.signals(names, has_transformations=any(steps))

    @property
    def has_limited_jerk(self) -> bool:
        """Whether any block of the first channel so far had the jerk-limited slope."""
        return self._machine.channels[0].queue.look_ahead.limits.has_jerk_limit

    @property
    def instructions_in_tick(self) -> int:
        """The elementary instructions that realtime cycles ran in the latest tick (RC-501)."""
        return sum(channel.channel.context.steps for channel in self._loop.channels)

    def read(self, name: str) -> float | bool | str:
        """Return the value of a V. variable, such as ``V.E.LIST[3]`` or ``V.RTA.ACS.ACT_POS.X``.

        A name without a channel means the first one; ``CH2.V.CH.COUNT`` is that of the second. A
        value set by ``write`` is returned at once. Raises ``Failure`` for an unknown name.
        """
        return self._machine.read(name)

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a V.E or V.CH variable or an operator's value (``HLI.OVERRIDE``) from the next tick.

        Raises ``Failure`` for an unknown name and for a value that the variable cannot hold.
        """
        self._machine.write(name, value)

    def bind(self, name: str) -> BoundValue:
        """Return a variable or an operator's value, bound by its name for many accesses.

        Its ``value`` is what ``read`` returns and, when it is set, what ``write`` writes; raises
        ``Failure`` for an unknown name.
        """
        return self._machine.access.bind(name)

    def signal(self, name: str) -> float:
        """Return the present value of a signal; raises ``Failure`` for an unknown name."""
        signals = self._machine.signals()
        if arguments.text("name", name) not in signals:
            raise Failure(self._machine.unknown_signal(name))
        return self._machine.cells[signals[name][0]]

    def unit(self, name: str) -> str:
        """Return the unit of a signal, empty without one; raises ``Failure`` as ``signal``."""
        signals = self._machine.signals()
        if arguments.text("name", name) not in signals:
            raise Failure(self._machine.unknown_signal(name))
        return signals[name][1]

    def attach(self, plc: AnyPlc | None, signals: Sequence[str] = ()) -> None:
        """Make the variables of a PLC in the realtime part known before any run.

        ``signals``: names of which those of its variables are signals, too. Raises ``Failure`` for
        a fault in its FB_init.
        """
        self._loop.attach(plc)
        self._machine.show_named(signals)

    def signals(self) -> list[Signal]:
        """Return all signals that a run can record, with their units."""
        found = self._machine.signals().items()
        return [Signal(name, one.unit, one.is_whole, one.labels) for name, one in found]

    def interface_image(self, name: str | None = None) -> SharedImage:
        """Return the HLI as bytes, live until it is closed, and shared under ``name`` if given.

        Raises ``Failure`` if there is one already, or if the shared memory is not available.
        """
        if name is not None:
            arguments.text("name", name)
        machine = self._machine
        self._image = SharedImage(
            self.machine, machine.kernel, machine.channels, machine.layout, name
        )
        machine.inputs.attach(self._image)
        return self._image

    # --- tick by tick ---------------------------------------------------------------------------

    @alone
    def start(
        self,
        program: str | Path | NcText,
        channel: int = 1,
        *,
        plc: GivenPlc | Sequence[GivenPlc] | None = None,
        set: Mapping[str, float | str] | None = None,
        at: Sequence[StimulusLike] = (),
    ) -> None:
        """Start a program in a channel; ``step`` runs it.

        An error of the previous program, or the program itself if it still runs, is reset first.
        ``set`` gives variables values before the next tick, ``at`` at times from now on. ``plc``,
        a new object if it is a class, runs after each tick from now on; without it, that of the
        latest run stays.
        Raises ``Failure`` with the program's errors, and for an invalid name, value or time.
        """
        channel_run = self._loop.channels[self._index(channel)]
        plc = plc_object(plc)
        loaded = program_loader.load(program, self._machine, self.diagnostics, channel - 1)
        if plc is not None:
            self._loop.attach(plc)
        stimuli = [read_stimulus(stimulus) for stimulus in at]
        for stimulus in stimuli:
            self._machine.access.check(stimulus.name, stimulus.value)
        self._loop.make_ready([channel_run])
        for name, value in (set or {}).items():
            self._machine.write(name, value)
        if plc is not None:
            if isinstance(plc, WatchedPlc):
                plc.begin_run(self.hli)
                self.diagnostics += plc.notes()
            self._loop.connect(plc, has_plc=False)
        if stimuli:
            self._machine.inputs.plan(as_inputs(stimuli, self.tick, self.cycle_time_us))
        channel_run.begin(loaded)

    @alone
    def select(self, program: str | Path | NcText, channel: int = 1) -> None:
        """Select a program, which START on the HLI begins; raises ``Failure`` with its errors."""
        self._loop.channels[self._index(channel)].select(
            program_loader.load(program, self._machine, self.diagnostics, channel - 1)
        )

    @alone
    def step(self, ticks: TimeLike = 1) -> Step:
        """Run this number of ticks, or as many as a time such as ``"20 ms"`` needs.

        In any state; returns their results. A plain number counts ticks. Raises ``Failure`` for
        anything that is neither a whole number of ticks nor a time.
        """
        if type(ticks) is not int or ticks < 0:
            ticks = self._tick_count(ticks)
        loop, recording, kernel = self._loop, self._loop.recording, self._machine.kernel
        first_tick = kernel.tick
        end = first_tick + ticks
        reason = loop.run_alone(ticks)
        if not reason and kernel.tick == end and recording.is_empty:
            return Step(first_tick, ticks, loop.state, (), (), ())
        first_message, first_diagnostic = len(recording.messages), len(self.diagnostics)
        happened = EventList()
        recording.begin_step(happened)
        try:
            if reason is not None:
                loop.settle(reason)
            while loop.tick < end:
                loop.advance(end)
        finally:
            recording.end_step(happened)
        return Step(
            first_tick,
            ticks,
            loop.state,
            tuple(happened.take()),
            tuple(recording.messages[first_message:]),
            tuple(self.diagnostics[first_diagnostic:]),
        )

    def _tick_count(self, ticks: TimeLike) -> int:
        """Return the number of ticks of a time; a whole number is returned unchanged.

        A text without a unit could mean seconds or ticks, and is refused.
        """
        ticks = plain_number(ticks)
        has_unit = isinstance(ticks, str) and ticks[-1:].isalpha()
        if has_unit or isinstance(ticks, Time) or hasattr(ticks, "total_seconds"):
            return read_time(ticks).ticks(self.cycle_time_us)
        return arguments.whole_number("ticks", ticks)

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
        """Reset one channel or all of them (RC-007); run until at rest, at least one tick."""
        channels = self._loop.channels
        self._loop.reset(channels if channel is None else [channels[self._index(channel)]])

    def _index(self, channel: int) -> int:
        """Return the index of a channel, from 0; raises ``Failure`` if there is none."""
        count = len(self._loop.channels)
        if not 0 < arguments.whole_number("channel", channel) <= count:
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=channel, count=count))
        return channel - 1

    # --- whole programs -------------------------------------------------------------------------

    @overload
    def run(
        self,
        /,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        memory_trace: Literal[True] = True,
        why: Literal[True],
        **options: Unpack[KeywordsOfAnyResult],
    ) -> ExplainedRun: ...

    @overload
    def run(
        self,
        /,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        memory_trace: Literal[True] = True,
        why: bool = False,
        **options: Unpack[KeywordsOfAnyResult],
    ) -> RecordedRun: ...

    @overload
    def run(
        self,
        /,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        memory_trace: bool,
        why: bool = False,
        **options: Unpack[KeywordsOfAnyResult],
    ) -> Run: ...

    @alone
    @with_keywords("python", RunKeywords)
    def run(
        self,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        **options: Unpack[RunKeywords],
    ) -> Run:
        """Run programs in turn and return the result.

        GLOBAL cycles, V.E and V.CH variables live on from program to program and from run to run.
        ``programs`` are files or ``NcText`` of channel 1, ``channels`` those of the others by
        number. All channels begin together; an error stops only its channel.

        ``set`` gives variables values before the first tick, ``at`` at times of the run:
        ``at=[("20 ms", "V.E.DOOR", 1)]``. ``until`` and ``ticks`` limit the run (10 minutes unless
        given). With ``wait_for_start`` START on the HLI begins each program, again after a RESET.
        ``sinks`` receive the trace of ``signals`` (by default ``default_signals``), which
        ``memory_trace`` keeps in the result. ``why`` gives ``Run.why`` and ``Run.coverage``.
        ``blocks``: events for decoding and execution of blocks, for each flush of the channel, and
        for the acknowledgement of each function. ``from_line`` or ``from_block``: where the first
        program of channel 1 begins by block search.

        Raises ``Failure`` for a program that cannot be read and for an invalid name, value or time,
        ``TypeError`` for an unknown option; mistakes in the programs are in the result.
        """
        check_keywords("Controller.run", "python", options)
        if channels is not None:
            arguments.mapping("channels", channels)
        by_channel = {1: programs, **(channels or {})}
        run = self.begin(by_channel, **options)
        try:
            run.advance()
        except KeyboardInterrupt:
            run.interrupt()
        finally:
            run.close()
        return run.result()

    def reusable(self) -> ReusableController:
        """Return an object that makes many runs of this machine, each from start-up, faster.

        Nothing is carried over from one run to the next; this controller itself is not changed.
        Raises ``Failure`` (902536) for a controller with a schedule.

        >>> part = NcText("part.nc", "G01 X[V.E.VALUE] F6000 M30")
        >>> with Controller().reusable() as controller:
        ...     [controller.run(part, set={"V.E.VALUE": x}).ticks for x in (50, 100)]
        [526, 1026]
        """
        from nctakt.run.reusable import ReusableController  # noqa: PLC0415 - few have loops

        if self._loop.scheduled_run is not None:
            raise Failure(diagnostic(REUSE_WITH_SCHEDULE))
        machine, access = self.machine, self._machine.file_access
        return ReusableController(machine, lambda part: type(self)(machine, None, access, part))

    def load(self, program: str | Path | NcText, channel: int = 1) -> LoadedProgram:
        """Read and check a program, for runs on this controller and others of its machine.

        Raises ``Failure`` with its errors.
        """
        return program_loader.load(program, self._machine, self.diagnostics, self._index(channel))

    def plan(self, inputs: Sequence[Input]) -> None:
        """Plan further inputs of a run that has begun, after those of their ticks."""
        self._machine.inputs.add(inputs)

    def begin(
        self,
        programs: Mapping[int, Sequence[AnyProgram]],
        *,
        statistics: bool = True,
        **given: Unpack[RunKeywords],
    ) -> ProgramRun:
        """Return a run of the programs of each channel before its first tick.

        ``statistics``: with the counts of cycles, functions and effects of a schedule in the
        result. Raises ``Failure`` as ``run``.
        """
        for channel, own in programs.items():
            self._index(channel)
            arguments.collection(f"channels[{channel}]", own)
        options = completed(given)
        replay = options["replay"]
        inputs = () if replay is None else replay.inputs
        scheduled = self._loop.scheduled_run
        if scheduled is not None:
            from nctakt.run.scheduled import recorded_schedule  # noqa: PLC0415 - rare

            if recorded_schedule.is_recorded(inputs):
                shares = recorded_schedule.RecordedSchedule(self._machine, scheduled.schedule)
                self._loop.follow(shares)
        has_image = self._image is not None and not self._image.is_closed
        if not has_image and any(one.kind == IMAGE for one in inputs):
            self.interface_image()
        return ProgramRun(
            self._loop, self.diagnostics, programs, options, with_statistics=statistics
        )
