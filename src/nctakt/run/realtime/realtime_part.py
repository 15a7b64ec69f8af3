# SPDX-License-Identifier: MIT
"""The realtime part of a machine: memory, axes, channels, kernel.

In: ``Machine`` and the layout of its memory. Out: ``RealtimePart``. It knows no names and no texts;
``run/realtime/assembly.py`` puts those around it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.decoder.axis_limits import history_blocks, listed_limits, look_ahead, single_axes
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.kernel import cells, codes
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.path.path import Path as KernelPath
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.channel import Channel
from nctakt.kernel.tick.command_execution import CommandExecutor
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.lists.machine.axes_by_number import c_axes, path_axes, spindle_numbers
from nctakt.lists.machine.channel_configuration import ONLY_MOTIONS
from nctakt.lists.machine.gantries import gantries
from nctakt.lists.machine.machine import ChannelConfiguration, Machine
from nctakt.nc.vocabulary.variables.variable_table import Layout, Location
from nctakt.run.realtime.spindle_setup import channel_spindles, gear_steps
from nctakt.run.technology_tables import axes_of

if TYPE_CHECKING:
    from nctakt.decoder.state.kept_trees import KeptTrees
    from nctakt.kernel.cycles.expressions import Expression

#: The assumed execution time of an elementary instruction, in ns (RC-503).
INSTRUCTION_COST_NS = 10

#: Cells after those of the machine, for variables of a PLC that are signals.
NAMED_SIGNALS = 256

#: How long a PLC that is watched may show no sign of life, in microseconds.
SILENCE_US = 100_000

#: V.RTG.CYCLES.DIAG_LEVEL at start-up (RC-603).
DEFAULT_DIAGNOSIS_LEVEL = 3.0


class RealtimePart:
    """Memory, axes, channels and kernel of one machine, in their state at start-up.

    ``kept_cycles``: cycles of earlier runs on it, if runs follow each other; ``conditions``: those
    that PLCs of earlier runs wait for, by their texts. ``listed_limits``: the limits of each
    channel's axes with which its programs start. ``path_axes`` and ``spindles``: those of the
    machine by logical number. ``gear_steps``: of each channel's spindles. ``has_history``: whether
    the paths get the memory of backward motion (P-STUP-00033).
    """

    def __init__(self, configuration: Machine, layout: Layout, *, has_history: bool = True) -> None:
        self._configuration = configuration
        self._has_history = has_history
        self.kept_cycles: KeptTrees | None = None
        self.conditions: dict[str, Expression] = {}
        self.memory = bytearray(8 * (layout.size + NAMED_SIGNALS))
        self.cells = memoryview(self.memory).cast("d")
        self.record = Record(self.memory)
        self.axes = Axes(self.memory, layout.axis_cell(0), len(configuration.axes))
        for slave, master, gantry in gantries(configuration.axes):
            self.axes.set_gantry(slave, master, gantry.allowed_d, gantry.offset)
        self.single_axes = single_axes(configuration, self.axes, self.record)
        self.path_axes = path_axes(configuration)
        self.spindles = spindle_numbers(configuration)
        self.c_axes = c_axes(configuration)
        self._room = len(self.path_axes)
        self.gear_steps = [
            gear_steps(configuration, index) for index in range(len(configuration.channels))
        ]
        self.channels = [
            self._channel(index, layout) for index in range(len(configuration.channels))
        ]
        for one in self.channels:
            others = [other.exchange.c_axis for other in self.channels if other is not one]
            one.exchange.share([c_axis for c_axis in others if c_axis.axis >= 0])
        self.listed_limits = [
            listed_limits([configuration.axes[axis.index] for axis in channel.axes])
            for channel in configuration.channels
        ]
        self.kernel = Kernel(self.memory, self.axes, self.channels, self.record, self.single_axes)

    def _channel(self, index: int, layout: Layout) -> Channel:
        configuration = self._configuration
        channel_lists = configuration.channels[index]
        parameters = channel_lists.parameters
        members = [axis.index for axis in channel_lists.axes]
        first = layout.channel_cell(index)
        room = max(len(members), self._room) if {*self.path_axes.values()} - {*members} else 0
        c_axis = configuration.c_axis_of(channel_lists)
        if self.c_axes:
            room = max(len(members), room, MAIN_AXES) + len(self.c_axes)
        executor = self._executor(index, layout, room)
        channel = Channel(executor, parameters.max_override_pct)
        _set_functions(channel, channel_lists)
        limits = parameters.realtime_cycles
        spindles = channel_spindles(configuration, index, layout, self.memory, self.record)
        channel.executor.set_spindles(spindles, limits.buffers)
        channel.executor.single_block.stop_at_motions(parameters.single_block == ONLY_MOTIONS)
        life = parameters.tool_selection.life
        channel.path.life.count_rapid(life.counts_rapid)
        channel.executor.tool_lives.omit_zero(life.omits_zero)
        if c_axis >= 0:
            main = [spindle.is_main for spindle in parameters.spindles].index(True)
            channel.exchange.c_axis.configure(c_axis, spindles, main, channel_lists.number)
        channel.silence_ticks = SILENCE_US // configuration.cycle_time_us
        channel.panel.show_size(channel.path.history_size)
        context = channel.context
        context.max_steps = limits.max_steps
        context.cont_steps = limits.cont_steps
        budget_ns = 10 * configuration.cycle_time_us * limits.max_duration_pct
        channel.manager.memory_limit = limits.memory_bytes
        context.budget_steps = budget_ns // INSTRUCTION_COST_NS
        self.cells[first + cells.CHANNEL_OVERRIDE_VEL_CYCLE] = 100.0
        self.cells[first + cells.CHANNEL_OVERRIDE_VEL_TOTAL] = 100.0
        self.cells[first + cells.CHANNEL_CYCLES_DIAG_LEVEL] = DEFAULT_DIAGNOSIS_LEVEL
        return channel

    def _executor(self, index: int, layout: Layout, room: int) -> CommandExecutor:
        """Return the execution of a channel's commands; ``room``: places of its path for axes."""
        configuration = self._configuration
        channel_lists = configuration.channels[index]
        parameters = channel_lists.parameters
        members = [axis.index for axis in channel_lists.axes]
        first = layout.channel_cell(index)
        history_bytes = channel_lists.startup.backward_memory_bytes if self._has_history else 0
        timers = layout.tables[index].resolve("RTG", (("TIMER", 1),))
        assert isinstance(timers, Location)
        path = KernelPath(
            self.axes,
            members,
            configuration.cycle_time_us,
            history_blocks(history_bytes, len(members)),
            room,
        )
        prepared = look_ahead(
            [configuration.axes[i] for i in members],
            configuration.cycle_time_us,
            channel_lists.startup.look_ahead_blocks,
            parameters.max_override_pct,
            room,
        )
        return CommandExecutor(
            self.memory,
            first,
            self.record,
            Hli(Panel(self.memory, layout.panel_cell(index))),
            CycleManager(self.record, self.single_axes, codes.CYCLE_OWNERS * index + 1),
            Timers(self.memory, timers.cell, configuration.cycle_time_us),
            self.single_axes,
            CommandQueue(path, prepared),
        )


def _set_functions(channel: Channel, configuration: ChannelConfiguration) -> None:
    """Set the axis of each function of a channel, and how far ahead functions are output."""
    parameters = configuration.parameters
    for section in (channel.hli.program, channel.hli.realtime):
        section.set_areas(
            axes_of(parameters.m_functions, configuration),
            axes_of(parameters.h_functions, configuration),
        )
    channel.feed.low_water = max(channel.feed.low_water, parameters.blocks_ahead)
