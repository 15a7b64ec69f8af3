# SPDX-License-Identifier: MIT
"""The channels for which a program is checked.

In: the default machine, the machines whose folders are checked as well, and a program's folder.
Out: ``Target``. A program in the folder of a machine is for that machine, unless the user names
one; there it is for the channels whose lists search programs in its folder (P-CHAN-00401), else for
the first one.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.checking.program_pass import ProgramChannel
from nctakt.decoder.blocks.axes.spindles import DEGREES_PER_S
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import Machine
from nctakt.nc.check.blocks import Role
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.vocabulary.variables.variable_table import NameTable
from nctakt.run.program_loader import program_folder
from nctakt.run.realtime.assembly import AssembledMachine


class Target:
    """A channel, by its number, with the data for a check; ``folder`` is that of its machine."""

    def __init__(self, machine: AssembledMachine, channel: int) -> None:
        self.machine = machine
        assembled = machine.assembled[channel]
        self.channel = channel + 1
        context = machine.channels[channel].context
        self.names: NameTable = assembled.names
        self.parameters: ChannelParameters = assembled.parameters
        configuration = assembled.configuration
        self.tools = configuration.tools
        axes = machine.configuration.axes
        self.axes = {axis.name: axes[axis.index] for axis in configuration.axes}
        #: Spindle -> its highest speed in 1/min, where it has one gear step.
        self.speed_limits = {
            spindle.name: next(iter(gears.steps.values())).speed_v / DEGREES_PER_S
            for index, spindle in enumerate(self.parameters.spindles)
            if (gears := assembled.spindle_gears.get(index)) is not None and len(gears.steps) == 1
        }
        self.is_shifted = configuration.is_shifted
        self.limits = StepLimits(context.max_steps, context.budget_steps)
        self.folder = machine.configuration.folder
        self.channel_count = len(machine.assembled)
        #: Logical number of an axis -> the channel whose list has it, as an axis or a spindle.
        self.owners: dict[int, int] = {}
        for number, other in enumerate(machine.configuration.channels, 1):
            own = [axis.logical_number for axis in other.axes]
            own += [one.spindle.logical_number for one in other.spindles if one.index is not None]
            for logical in own:
                self.owners.setdefault(logical, number)

    def for_program(self, role: Role) -> ProgramChannel:
        """Return the data for the check of a program with this part in the run."""
        return ProgramChannel(
            self.names,
            self.parameters,
            self.limits,
            self.tools,
            role,
            self.axes,
            self.is_shifted,
            self.channel,
            self.speed_limits,
        )

    def searches(self, folder: Path) -> bool:
        """Return whether the channel's list names this folder of programs."""
        paths = self.parameters.program_paths
        return any(program_folder(path.folder, self.folder).resolve() == folder for path in paths)


class Targets:
    """The channels of ``default``, and of the machines that are added.

    ``for_all``: all programs are for ``default``. ``folders``: the folders of other machines that
    have programs. ``uses_default``: ``default`` has programs. ``assigned``: the machines that
    settings name, by their path.
    """

    def __init__(self, default: AssembledMachine, for_all: bool) -> None:
        self._default = _channels(default)
        self._for_all = for_all
        self._machines: list[Sequence[Target]] = []
        self.uses_default = False
        self.folders: dict[Path, None] = {}
        self.assigned: dict[Path, Sequence[Target]] = {}
        self._assigned_to: dict[Path | None, Path] = {}

    def add(self, configuration: Machine) -> None:
        """Add a machine whose folder is checked."""
        if not self._for_all:
            self._machines.append(_channels(AssembledMachine(configuration, has_history=False)))

    def of(self, program: Path | None) -> Sequence[Target]:
        """Return the channels of a program; ``None``: a text without a folder."""
        folder = None if program is None else program.resolve().parent
        channels = self._machine_of(folder)
        if channels is self._default:
            self.uses_default = True
        else:
            self.folders[channels[0].folder] = None
        searching = [
            target for target in channels if folder is not None and target.searches(folder)
        ]
        return searching or channels[:1]

    def assign(self, path: Path, configuration: Machine) -> None:
        """Add a machine that a setting names by ``path``; ``use`` says for which programs."""
        self.assigned[path] = _channels(AssembledMachine(configuration, has_history=False))

    def use(self, path: Path, folder: Path | None) -> None:
        """Assign the programs of a folder (``None``: texts) to the machine assigned to ``path``.

        A machine that could not be loaded leaves them to the others.
        """
        if path in self.assigned:
            self._assigned_to[folder] = path

    def _machine_of(self, folder: Path | None) -> Sequence[Target]:
        """Return the machine of a folder's programs.

        The assigned machine, else the innermost one around it, else one that searches the folder.
        """
        if folder in self._assigned_to:
            return self.assigned[self._assigned_to[folder]]
        if folder is None:
            return self._default
        candidates = [
            channels
            for channels in self._machines
            if folder.is_relative_to(channels[0].folder.resolve())
        ]
        if candidates:
            return max(candidates, key=lambda channels: len(channels[0].folder.resolve().parts))
        for channels in self._machines:
            if any(target.searches(folder) for target in channels):
                return channels
        return self._default


def _channels(machine: AssembledMachine) -> Sequence[Target]:
    return tuple(Target(machine, index) for index in range(len(machine.assembled)))
