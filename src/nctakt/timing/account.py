# SPDX-License-Identifier: MIT
"""A run whose time is accounted for: programs on a controller -> ``TimeAccount``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.kernel import rows
from nctakt.results.trace.chunks import EventChunk, of_kinds
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader
from nctakt.run.channel_run import ChannelRun
from nctakt.run.controller import Controller
from nctakt.run.program_loader import AnyProgram
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.timing.clock import ChannelClock, TickPurpose
from nctakt.timing.entries import NOTHING, Purpose, Stretch, TimeAccount, Times

if TYPE_CHECKING:
    from typing import Unpack

    from nctakt.run.options import RunKeywords

_BLOCKS = frozenset((rows.EVENT_BLOCK,))


@dataclass(frozen=True, slots=True)
class _Begun:
    """A block that the queue has given: its line, when, and the number of its open programs."""

    location: tuple[str, int]
    tick: int
    calls: int


class BlockSink:
    """A sink that keeps which blocks have begun, by channel."""

    def __init__(self) -> None:
        self.begun: dict[int, list[_Begun]] = {}

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def close(self) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Keep the begins of blocks."""
        begun = of_kinds(events, _BLOCKS)
        if isinstance(begun, EventChunk):
            for event, calls in zip(begun, begun.column(rows.EVENT_B), strict=True):
                if event.span is not None:
                    location = event.span.file, event.span.line
                    one = _Begun(location, event.tick, int(calls))
                    self.begun.setdefault(max(event.channel, 1), []).append(one)


class RunningAccount:
    """The clocks of the channels of a run, from before its first tick on.

    ``blocks``: a sink of the same run.
    """

    def __init__(
        self, machine: AssembledMachine, channels: Sequence[ChannelRun], blocks: BlockSink
    ) -> None:
        self._blocks = blocks
        self._machine = machine
        self._clocks = [
            ChannelClock(machine, index, channel, lambda source: _line(machine, source))
            for index, channel in enumerate(channels)
        ]

    def end_tick(self, tick: int) -> None:
        """Note the purpose of a tick that has just ended, in each channel."""
        for clock in self._clocks:
            clock.end_tick(tick)

    def times(self, ticks: int) -> Times:
        """Return the times so far; ``ticks``: how many there have been."""
        machine, begun = self._machine, self._blocks.begun
        stretches = [
            stretch
            for number, clock in enumerate(self._clocks, 1)
            for stretch in _stretches(machine, number, clock, begun.get(number, []))
        ]
        spans = dict.fromkeys(one.purpose.span for one in stretches)
        lines = {span: machine.files.line_at(span).strip() for span in spans if span is not None}
        cycle_us = machine.configuration.cycle_time_us
        return Times(ticks, cycle_us, len(self._clocks), tuple(stretches), lines)


def account_for(
    controller: Controller,
    programs: Mapping[int, Sequence[AnyProgram]],
    **options: Unpack[RunKeywords],
) -> TimeAccount:
    """Run the programs of each channel and return where the time went.

    ``options`` and ``Failure`` are those of ``Controller.run``. Each tick is run by itself, which
    changes nothing in the run.
    """
    blocks = BlockSink()
    recorded: RunKeywords = {
        **options,
        "blocks": True,
        "memory_trace": False,
        "sinks": (*options.get("sinks", ()), blocks),
    }
    run = controller.begin(programs, **recorded)
    account = RunningAccount(run.machine, run.channel_runs, blocks)
    try:
        _tick_by_tick(controller, run, account)
    except KeyboardInterrupt:
        run.interrupt()
    finally:
        run.close()
    result = run.result()
    times = account.times(result.ticks)
    return TimeAccount(
        times.ticks, times.cycle_time_us, times.channels, times.stretches, times.lines, result
    )


def _tick_by_tick(controller: Controller, run: ProgramRun, account: RunningAccount) -> None:
    """Run to the end, and account for each tick."""
    run.load()
    tick = controller.tick
    while run.state is None:
        run.advance(tick + 1)
        if controller.tick > tick:
            account.end_tick(tick)
            tick = controller.tick


def _line(machine: AssembledMachine, source: int) -> Text:
    span = machine.files.span(source)
    if span is None:
        return NOTHING
    return Text(f"line {span.line}", f"Zeile {span.line}")


def _stretches(
    machine: AssembledMachine, number: int, clock: ChannelClock, begun: Sequence[_Begun]
) -> list[Stretch]:
    """Return the intervals of a channel with the programs that were open in each of them.

    Blocks begin in the order in which their marks come, which is at most a tick later than the path
    enters them.
    """
    found: list[Stretch] = []
    at, calls = 0, 0
    for interval in clock.intervals:
        span = machine.files.span(interval.purpose.source)
        end = interval.first_tick + interval.ticks
        if span is not None:
            location = span.file, span.line
            for ahead in range(at, len(begun)):
                if begun[ahead].tick > end:
                    break
                if begun[ahead].location == location:
                    at, calls = ahead, begun[ahead].calls
                    break
        names = () if interval.purpose.kind == "idle" else _names(machine, calls)
        purpose = _purpose(number, names, span, interval.purpose)
        found.append(Stretch(purpose, interval.first_tick, interval.ticks))
    return found


def _names(machine: AssembledMachine, calls: int) -> tuple[str, ...]:
    return tuple(call.name for call in machine.registry.path(calls))


def _purpose(channel: int, names: tuple[str, ...], span: Span | None, own: TickPurpose) -> Purpose:
    return Purpose(channel, names, span, own.number, own.tool, own.kind, own.phase, own.limit)
