# SPDX-License-Identifier: MIT
"""The assembly of a machine: memory, axes, channels, kernel.

In: ``Machine``. Out: ``AssembledMachine``, which the controller runs.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.misspelling import nearest
from nctakt.base.source_ids import SourceFiles
from nctakt.decoder.axis_limits import apply_axis_limits
from nctakt.decoder.kinematics.selection import ChannelKinematics
from nctakt.decoder.state.axis_places import AxisPlace, ChannelPlaces, ExchangeAxes, indices_of
from nctakt.decoder.state.controller_data import controller_data
from nctakt.decoder.state.environment import DecoderEnvironment, WatchedEnvironment
from nctakt.decoder.state.geometry.offsets import ActiveOffsets
from nctakt.decoder.state.geometry.transformation import ActiveTransformation
from nctakt.decoder.state.spindle_gears import SpindleGears
from nctakt.files.access import FileAccess
from nctakt.hli.layout import PanelValue
from nctakt.kernel import codes
from nctakt.kernel.cells import PANEL_TOOLS
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import ChannelConfiguration, Machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import MISSPELLED_SIGNAL, NAMES_OF_DEMO_MACHINE, UNKNOWN_SIGNAL
from nctakt.messages.plcs.plc import STALE_ACKNOWLEDGEMENT
from nctakt.nc.check.checker import first_mistake
from nctakt.nc.outline import ProgramText
from nctakt.nc.vocabulary.variables.variable_table import NameTable
from nctakt.run.access.input_words import API
from nctakt.run.access.inputs import Inputs
from nctakt.run.access.machine_names import channel_names, names_of_machine, prefix_of
from nctakt.run.access.named_values import SignalCell, scopes_text
from nctakt.run.access.variable_access import VariableAccess
from nctakt.run.realtime.event_registry import EventRegistry
from nctakt.run.realtime.realtime_part import NAMED_SIGNALS, RealtimePart
from nctakt.run.realtime.spindle_setup import all_names, at_start_up, follow_executed
from nctakt.run.realtime.waiting_entries import placed_entries

if TYPE_CHECKING:
    from nctakt.hli.function_units import Placed
    from nctakt.run.access.interface_access import InterfaceAccess


@dataclass(frozen=True, slots=True)
class AssembledChannel:
    """The parts of one channel; ``index`` counts from 0, ``members`` are indices of axes.

    ``panel`` are the operator's values by name, ``places`` its axes by their places, ``offsets``
    the active offsets of these, ``spindle_gears`` the gear steps of its spindles by their indices.
    """

    index: int
    configuration: ChannelConfiguration
    names: NameTable
    members: tuple[int, ...]
    panel: Mapping[str, PanelValue]
    places: ChannelPlaces
    offsets: ActiveOffsets
    spindle_gears: Mapping[int, SpindleGears]

    @property
    def parameters(self) -> ChannelParameters:
        """The parameters of its list."""
        return self.configuration.parameters

    @property
    def prefix(self) -> str:
        """The prefix of its names on a machine with several channels: ``CH2.``."""
        return prefix_of(self.index)


def _places_of(
    machine: Machine, channel: ChannelConfiguration, realtime: RealtimePart
) -> ChannelPlaces:
    listed = tuple(AxisPlace(axis.name, axis.index) for axis in channel.axes)
    kernel = realtime.channels[channel.number - 1]
    return ChannelPlaces(
        machine.axes,
        realtime.path_axes,
        realtime.spindles,
        listed,
        listed,
        kernel.path.room,
        kernel.exchange.holder,
        realtime.c_axes,
        kernel.executor.context.spindles.without_axis,
        machine.c_axis_of(channel),
    )


def _offsets_of(
    channel: ChannelConfiguration, places: ChannelPlaces, realtime: RealtimePart
) -> ActiveOffsets:
    listed_axes = places.own_axes(places.listed)
    kinematics = ChannelKinematics(channel.parameters, listed_axes)
    transformation = ActiveTransformation(kinematics, realtime.axes.transformations)
    return ActiveOffsets(
        listed_axes.members, channel.zero_offsets, channel.clamp_offsets, transformation
    )


def _default_signals(channel: AssembledChannel) -> list[str]:
    names = [
        f"{axis.name}.ACS.{position}"
        for position in ("ACT_POS", "CUR_POS")
        for axis in channel.configuration.axes
    ]
    return [*names, "PATH.SPEED", "OVERRIDE.VEL.TOTAL", "BLOCK", "CYCLES.ACTIVE"]


def _in_axis_system(name: str, signals: Mapping[str, SignalCell]) -> str:
    """Return ``X.ACS.ACT_POS`` for ``X.ACT_POS`` if it is a signal, else an empty text."""
    axis, _, position = name.upper().rpartition(".")
    meant = f"{axis}.ACS.{position}"
    return meant if meant in signals else ""


def do_nothing() -> None:
    """Do nothing: the default of ``poll``."""


def _ignore(_diagnostic: Diagnostic) -> None:
    """Do nothing: the default of ``report``."""


class AssembledMachine:
    """One machine's realtime part with its names.

    ``names``, ``parameters`` and ``members`` are those of the first channel. ``report`` receives
    the diagnostics of a run; by default it does nothing. ``file_access`` reads the programs.
    ``poll`` is called between ticks, and repeatedly while programs are read and decoded.
    ``realtime``: a realtime part of this machine as it is at start-up; by default a new one, where
    nothing will run without the path's history (``has_history``), the memory that lists ask for.
    """

    #: Whether decoders note that they use the memory (``WatchedEnvironment``).
    watches_decoder = False

    def __init__(
        self,
        configuration: Machine,
        access: FileAccess | None = None,
        realtime: RealtimePart | None = None,
        *,
        has_history: bool = True,
    ) -> None:
        self.configuration = configuration
        self.file_access = access or FileAccess()
        self._names = names_of_machine(configuration)
        self.layout = layout = self._names.layout
        self.realtime = realtime = realtime or RealtimePart(
            configuration, layout, has_history=has_history
        )
        self.memory = realtime.memory
        self.cells = realtime.cells
        self.record = realtime.record
        self.axes = realtime.axes
        self.single_axes = realtime.single_axes
        self.channels = realtime.channels
        self.kernel = realtime.kernel
        self.assembled = tuple(
            AssembledChannel(
                index,
                channel,
                names,
                tuple(axis.index for axis in channel.axes),
                panel,
                places := _places_of(configuration, channel, realtime),
                _offsets_of(channel, places, self.realtime),
                at_start_up(realtime.gear_steps[index]),
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
            configuration, self.channels, lambda: self.kernel.tick, self.single_axes
        )
        self.access = VariableAccess(
            layout.tables,
            [channel.panel for channel in self.assembled],
            self.memory,
            self.kernel,
            (diagnostic(NAMES_OF_DEMO_MACHINE),) if configuration.is_demo else (),
        )
        self.access.interface = lambda: self.interface
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
        """Return the names of the axes in their channel, else in their list; else their numbers."""
        names = [axis.name or str(axis.logical_number) for axis in self.configuration.axes]
        for channel in self.configuration.channels:
            for axis in channel.axes:
                names[axis.index] = axis.name
        return names

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

    def has_path_stopped(self, channel: int = 0) -> bool:
        """Return whether the channel's path is at rest."""
        return bool(self.channels[channel].path.has_stopped())

    def has_stopped(self) -> bool:
        """Return whether all but endless motions of axes and spindles have stopped (RC-006)."""
        ending = sum(channel.context.spindles.ending_count() for channel in self.channels)
        ending += self.single_axes.ending_count()
        return ending == 0 and all(
            self.has_path_stopped(channel.index) for channel in self.assembled
        )

    def environment(
        self,
        subprogram: Callable[[str, str, Span], ProgramText],
        notice: Callable[[Diagnostic], None],
        skip_levels: frozenset[int],
        channel: int,
        marks_blocks: bool,
        names: NameTable | None = None,
    ) -> DecoderEnvironment:
        """Return the environment of the decoder of a program of this channel.

        ``names``: those of a program that fetches axes.
        """
        assembled = self.assembled[channel]
        environment = DecoderEnvironment(
            names or assembled.names,
            assembled.parameters,
            indices_of(assembled.places.present),
            tuple(map(assembled.places.axis_of, assembled.places.present)),
            assembled.offsets,
            assembled.configuration.tools,
            self.cells,
            self.layout.panel_cell(channel) + PANEL_TOOLS,
            memoryview(self.memory),
            self.configuration.cycle_time_us,
            self.files.number,
            self.files.line_at,
            partial(first_mistake, names or assembled.names, assembled.parameters),
            self.registry.add_user_text,
            self.registry.add_path,
            self.registry.add_modal,
            assembled.spindle_gears,
            notice,
            subprogram,
            skip_levels,
            marks_blocks,
            self.controller_data[channel],
            self.registry.left_in(self.channels[channel].manager),
            lambda: self._moving_axes(channel),
            self.channels[channel].path.history_size,
            SignalsOfChannel(self.kernel, self.channels, channel),
            self.poll,
            assembled.places,
            self.realtime.kept_cycles if names is None else None,
        )
        return WatchedEnvironment(environment) if self.watches_decoder else environment

    # --- axes that change their channel ---------------------------------------------------------

    def begin_program(self, channel: int) -> None:
        """Let the decoder of a channel begin with the axes of its list (P-CHAN-00460)."""
        assembled = self.assembled[channel]
        spindles = self.channels[channel].executor.context.spindles
        follow_executed(assembled.spindle_gears, spindles)
        factors = self.channels[channel].path.life.factors()
        self.controller_data[channel].follow_tool_life(*factors)
        if assembled.places.is_exchanged:
            assembled.places.present = assembled.places.listed
            assembled.offsets.exchange(assembled.places.own_axes(assembled.places.listed))

    def members_of(self, channel: int) -> list[int]:
        """Return the axes that the path of a channel has now (``Path.set_axes``)."""
        return list(self.channels[channel].path.own_axes())

    def exchange(self, channel: int, command: ExchangeAxes) -> tuple[float, ...]:
        """Let a channel have the axes of a command; return their positions."""
        realtime = self.channels[channel]
        before = self.members_of(channel)
        realtime.exchange.exchange(self.kernel.tick, command.source, list(command.members))
        count = len(self.configuration.axes)
        axes = [self.configuration.axes[i if i < count else 0] for i in command.members]
        apply_axis_limits(realtime.queue.look_ahead.limits, axes)
        for axis in {*before, *command.members} - {*before}.intersection(command.members):
            for kind in range(codes.OFFSET_KINDS) if axis < count else ():
                self.axes.shift(axis, kind, 0.0)
        return tuple(self.present_positions(channel))

    def present_positions(self, channel: int) -> list[float]:
        """Return the command positions at the places of a channel, 0 at a free one."""
        positions = [*self.axes.positions(), 0.0]
        return [positions[index] for index in self.members_of(channel)]

    def _moving_axes(self, channel: int) -> tuple[str, ...]:
        """Return the channel's axes in independent motion, held or running."""
        axes = self.configuration.channels[channel].axes
        return tuple(axis.name for axis in axes if self.single_axes.moves(axis.index))

    # --- variables by name ----------------------------------------------------------------------

    @cached_property
    def interface(self) -> InterfaceAccess:
        """The interface by the controller's paths, made when it is first used."""
        from nctakt.run.access.interface_access import InterfaceAccess  # noqa: PLC0415 - few need it

        return InterfaceAccess(self, len(self.channels))

    def waiting_functions(self, channel: int) -> list[Placed]:
        """Return entries waiting for the PLC of a channel, each with its unit of the interface."""
        part, parameters = self.channels[channel], self.assembled[channel].parameters
        cycle_time_us = self.configuration.cycle_time_us
        spindles = part.context.spindles
        return placed_entries(part.hli, spindles, parameters, self.registry, cycle_time_us)

    def lock_axis(self, index: int, is_locked: bool) -> None:
        """Take an axis its releases from the next tick on, or give them to it."""
        self.axes.lock(index, is_locked)

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
        """Return all signals by their names.

        ``CH2.BLOCK`` is a signal of the second channel, a name without a prefix belongs to the
        first.
        """
        signals, named = self._names.signals(), self.access.named_signals
        return {**signals, **named} if named else signals

    def show_named(self, names: Sequence[str]) -> None:
        """Make those names signals that are variables of a PLC in the tick."""
        self.access.named_signals = {}
        named = self.access.named
        for name in names if named is not None else ():
            found = named.signal(name) if named is not None else None
            if found is not None:
                self.access.named_signals[name] = found

    def free_signal_cell(self) -> int | None:
        """Return a cell for a signal that the machine does not have itself, if one is free."""
        used = len(self.access.named_signals)
        return self.layout.size + used if used < NAMED_SIGNALS else None

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
        signals, named = self.signals(), self.access.named
        mistake = None if named is None else named.mistake(name)
        if mistake is not None:
            return mistake
        near = _in_axis_system(name, signals) or nearest(name, signals)
        if not near and named is not None:
            near = nearest(name, named.names(are_numbers=True))
        if near:
            return diagnostic(MISSPELLED_SIGNAL, name=name, nearest=near)
        return diagnostic(UNKNOWN_SIGNAL, name=name, plc=scopes_text(named))


class SignalsOfChannel:
    """The signals of the channel with this index, from 0 (``DecoderSignals``)."""

    def __init__(self, kernel: Kernel, channels: Sequence[Channel], index: int) -> None:
        self._kernel = kernel
        self._signals = channels[index].signals
        self.channel_count = len(channels)

    def send(
        self,
        source: int,
        signal: int,
        receivers: int,
        count: int,
        mask: int,
        values: Sequence[float],
    ) -> bool:
        """Send a signal; return whether there was room for it."""
        data = bytearray(struct.pack(f"={len(values)}d", *values))
        return self._signals.send(source, self._kernel.tick, signal, receivers, count, mask, data)

    def remove(self, low: int, high: int, receivers: int, *, is_range: bool) -> None:
        """Remove the oldest signal of this number, or all of a range."""
        self._signals.remove(low, high, receivers, is_range)

    def read(self, source: int, signal: int, senders: int) -> tuple[float, ...]:
        """Take a signal: the mask of its values and the values; empty if it is not there."""
        return self._signals.read(source, self._kernel.tick, signal, senders, False)
