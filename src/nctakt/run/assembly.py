# SPDX-License-Identifier: MIT
"""The assembly of a machine: memory, axes, channels, kernel.

In: ``Machine``. Out: ``AssembledMachine``, which the controller runs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.source_ids import SourceFiles
from nctakt.base.text import nearest
from nctakt.decoder.axis_limits import history_blocks, look_ahead, single_axes
from nctakt.decoder.state.controller_data import controller_data
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.offsets import ActiveOffsets
from nctakt.files.access import FileAccess
from nctakt.hli.layout import PanelValue
from nctakt.kernel import cells
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.path.path import Path as KernelPath
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import ChannelConfiguration, Machine
from nctakt.messages import diagnostic
from nctakt.messages.inputs import MISSPELLED_SIGNAL, NAMES_OF_DEMO_MACHINE, UNKNOWN_SIGNAL
from nctakt.messages.plc import STALE_ACKNOWLEDGEMENT
from nctakt.nc.outline import ProgramText
from nctakt.nc.vocabulary.variable_table import Layout, Location, NameTable
from nctakt.run.event_registry import EventRegistry
from nctakt.run.inputs import API, Inputs
from nctakt.run.machine_names import SignalCell, channel_names, names_of_machine, prefix_of
from nctakt.run.spindle_setup import all_names, channel_spindles, max_speeds
from nctakt.run.variable_access import VariableAccess

#: The assumed execution time of an elementary instruction, in ns (RC-503).
INSTRUCTION_COST_NS = 10

#: Owners of independent motions in a channel: one for each slot of a cycle.
CYCLE_OWNERS = 1024

#: V.RTG.CYCLES.DIAG_LEVEL at start-up (RC-603).
DEFAULT_DIAGNOSIS_LEVEL = 3.0


@dataclass(frozen=True, slots=True)
class AssembledChannel:
    """The parts of one channel; ``index`` counts from 0, ``members`` are indices of axes.

    ``panel`` are the operator's values by name, ``offsets`` the active offsets of its axes.
    """

    index: int
    configuration: ChannelConfiguration
    names: NameTable
    members: tuple[int, ...]
    panel: Mapping[str, PanelValue]
    offsets: ActiveOffsets

    @property
    def parameters(self) -> ChannelParameters:
        """The parameters of its list."""
        return self.configuration.parameters

    @property
    def prefix(self) -> str:
        """The prefix of its names on a machine with several channels: ``CH2.``."""
        return prefix_of(self.index)


def _offsets_of(channel: ChannelConfiguration) -> ActiveOffsets:
    members = [axis.index for axis in channel.axes]
    return ActiveOffsets(members, channel.zero_offsets, channel.clamp_offsets)


def _default_signals(channel: AssembledChannel) -> list[str]:
    names = [
        f"{axis.name}.ACS.{position}"
        for position in ("ACT_POS", "CUR_POS")
        for axis in channel.configuration.axes
    ]
    return [*names, "PATH.SPEED", "OVERRIDE.VEL.TOTAL", "BLOCK", "CYCLES.ACTIVE"]


def do_nothing() -> None:
    """Do nothing: the default of ``poll``."""


def _ignore(_diagnostic: Diagnostic) -> None:
    """Do nothing: the default of ``report``."""


class AssembledMachine:
    """One machine's realtime part with its names.

    ``names``, ``parameters`` and ``members`` are those of the first channel. ``report`` receives
    the diagnostics of a run; by default it does nothing. ``file_access`` reads the programs.
    ``poll`` is called between ticks, and repeatedly while programs are read and decoded.
    """

    def __init__(self, configuration: Machine, access: FileAccess | None = None) -> None:
        self.configuration = configuration
        self.file_access = access or FileAccess()
        self._names = names_of_machine(configuration)
        self.layout = layout = self._names.layout
        self.memory = bytearray(8 * layout.size)
        self.cells = memoryview(self.memory).cast("d")
        self.record = Record(self.memory)
        self.axes = Axes(self.memory, layout.axis_cell(0), len(configuration.axes))
        self.single_axes = single_axes(configuration, self.axes, self.record)
        self.channels = [
            self._channel(index, layout) for index in range(len(configuration.channels))
        ]
        self.kernel = Kernel(self.memory, self.axes, self.channels, self.record, self.single_axes)
        self.assembled = tuple(
            AssembledChannel(
                index,
                channel,
                names,
                tuple(axis.index for axis in channel.axes),
                panel,
                _offsets_of(channel),
            )
            for index, (channel, names, panel) in enumerate(
                channel_names(configuration, self._names)
            )
        )
        self.names = self.assembled[0].names
        self.parameters = self.assembled[0].parameters
        self.members = self.assembled[0].members
        self.files = SourceFiles()
        spindles = all_names(configuration)
        self.registry = EventRegistry(
            self.files, self._names.name_of_cell, self._axis_names(), spindles
        )
        self.controller_data = controller_data(
            configuration, self.channels, lambda: self.kernel.tick
        )
        self.access = VariableAccess(
            layout.tables,
            [channel.panel for channel in self.assembled],
            self.memory,
            self.kernel,
            (diagnostic(NAMES_OF_DEMO_MACHINE),) if configuration.is_demo else (),
        )
        self.inputs = Inputs(self.kernel, self.channels, self.access, self.report_stale)
        self._stale_names: dict[str, None] = {}
        self.report: Callable[[Diagnostic], None] = _ignore
        self.poll: Callable[[], None] = do_nothing

    def report_stale(self, name: str) -> None:
        """Report, once for each name, an acknowledgement of an entry that has gone (900671)."""
        if name not in self._stale_names:
            self._stale_names[name] = None
            self.report(diagnostic(STALE_ACKNOWLEDGEMENT, name=name, tick=self.kernel.tick - 1))

    def _axis_names(self) -> list[str]:
        """Return the names of the axes in their channel, else in their list."""
        names = [axis.name for axis in self.configuration.axes]
        for channel in self.configuration.channels:
            for axis in channel.axes:
                names[axis.index] = axis.name
        return names

    def _channel(self, index: int, layout: Layout) -> Channel:
        configuration = self.configuration.channels[index]
        parameters = configuration.parameters
        members = [axis.index for axis in configuration.axes]
        first = layout.channel_cell(index)
        timers = layout.tables[index].resolve("RTG", (("TIMER", 1),))
        assert isinstance(timers, Location)
        channel = Channel(
            self.memory,
            first,
            self.record,
            Hli(Panel(self.memory, layout.panel_cell(index))),
            CycleManager(self.record, self.single_axes, CYCLE_OWNERS * index + 1),
            KernelPath(
                self.axes,
                members,
                self.configuration.cycle_time_us,
                history_blocks(configuration.startup.backward_memory_bytes, len(members)),
            ),
            Timers(self.memory, timers.cell, self.configuration.cycle_time_us),
            parameters.max_override_pct,
            look_ahead(
                [self.configuration.axes[i] for i in members],
                self.configuration.cycle_time_us,
                configuration.startup.look_ahead_blocks,
                parameters.max_override_pct,
            ),
            self.single_axes,
        )
        limits = parameters.realtime_cycles
        spindles = channel_spindles(self.configuration, index, layout, self.memory, self.record)
        channel.executor.set_spindles(spindles, limits.buffers)
        channel.panel.show_size(channel.path.history_size)
        context = channel.context
        context.max_steps = limits.max_steps
        context.cont_steps = limits.cont_steps
        budget_ns = 10 * self.configuration.cycle_time_us * limits.max_duration_pct
        channel.manager.memory_limit = limits.memory_bytes
        context.budget_steps = budget_ns // INSTRUCTION_COST_NS
        self.cells[first + cells.CHANNEL_OVERRIDE_VEL_CYCLE] = 100.0
        self.cells[first + cells.CHANNEL_OVERRIDE_VEL_TOTAL] = 100.0
        self.cells[first + cells.CHANNEL_CYCLES_DIAG_LEVEL] = DEFAULT_DIAGNOSIS_LEVEL
        return channel

    # --- running --------------------------------------------------------------------------------

    def reserve(self) -> None:
        """Reserve memory in the record for a tick of the present load."""
        self.kernel.reserve()

    def number_in_names(self, channel: int) -> int:
        """Return the channel's number in names of cycles and events; 0 for a single channel."""
        return channel + 1 if len(self.assembled) > 1 else 0

    def positions(self, channel: int = 0) -> list[float]:
        """Return the command positions of a channel's axes, in the order of its list."""
        return list(map(self.axes.positions().__getitem__, self.assembled[channel].members))

    def path_stands(self, channel: int = 0) -> bool:
        """Return whether the channel's path stands."""
        return bool(self.channels[channel].path.has_stopped())

    def stands(self) -> bool:
        """Return whether all but endless motions of axes and spindles has stopped (RC-006)."""
        ending = sum(channel.context.spindles.ending_count() for channel in self.channels)
        ending += self.single_axes.ending_count()
        return ending == 0 and all(self.path_stands(channel.index) for channel in self.assembled)

    def environment(
        self,
        subprogram: Callable[[str, str, Span], ProgramText],
        notice: Callable[[Diagnostic], None],
        skip_levels: frozenset[int],
        channel: int,
        marks_blocks: bool,
    ) -> DecoderEnvironment:
        """Return the environment of the decoder of a program of this channel."""
        own = self.assembled[channel]
        axes = tuple(self.configuration.axes[i] for i in own.members)
        return DecoderEnvironment(
            own.names,
            own.parameters,
            {axis.name: index for index, axis in enumerate(own.configuration.axes)},
            axes,
            own.offsets,
            own.configuration.tools,
            self.cells,
            memoryview(self.memory),
            self.configuration.cycle_time_us,
            self.files.number,
            self.files.line_at,
            self.registry.add_user_text,
            self.registry.add_path,
            max_speeds(self.configuration, channel),
            notice,
            subprogram,
            skip_levels,
            marks_blocks,
            self.controller_data[channel],
            self.registry.left_in(self.channels[channel].manager),
            lambda: self._moving_axes(channel),
            self.channels[channel].path.history_size,
            self.poll,
        )

    def _moving_axes(self, channel: int) -> tuple[str, ...]:
        """Return the channel's axes in independent motion, held or running."""
        axes = self.configuration.channels[channel].axes
        return tuple(axis.name for axis in axes if self.single_axes.moves(axis.index))

    # --- variables by name ----------------------------------------------------------------------

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable; a written value is returned before it is latched."""
        return self.access.read(name)

    def write(self, name: str, value: float | bool | str, source: str = API) -> None:
        """Write a variable with effect from the next tick."""
        self.inputs.write(name, value, source)

    @property
    def channel_axes(self) -> tuple[AxisConfiguration, ...]:
        """The axes of the first channel with the names that its list gives them."""
        configuration = self.configuration
        return tuple(
            replace(configuration.axes[axis.index], name=axis.name)
            for axis in configuration.channels[0].axes
        )

    # --- signals --------------------------------------------------------------------------------

    def signals(self) -> Mapping[str, SignalCell]:
        """Return all signals: name -> cell, unit, whether it is an integer.

        ``CH2.BLOCK`` is a signal of the second channel, a name without a prefix one of the first.
        """
        return self._names.signals()

    def default_signals(self) -> list[str]:
        """Return the positions of all axes, path speed, override, block number, active cycles."""
        if len(self.assembled) == 1:
            return _default_signals(self.assembled[0])
        return [
            f"{channel.prefix}{name}"
            for channel in self.assembled
            for name in _default_signals(channel)
        ]

    def unknown_signal(self, name: str) -> Diagnostic:
        """Return the diagnostic of an unknown signal."""
        near = nearest(name, self.signals())
        if near:
            return diagnostic(MISSPELLED_SIGNAL, name=name, nearest=near)
        return diagnostic(UNKNOWN_SIGNAL, name=name)
