# SPDX-License-Identifier: MIT
"""For which channels of which machine a program is checked.

In: the machine that the user means, those whose folders are checked as well, and where a program
lies. Out: ``Target``. A program in the folder of a machine is for that machine, unless the user
names one; there it is for the channels whose lists search programs in its folder (P-CHAN-00401),
else for the first one.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import Machine
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.vocabulary.variable_table import NameTable
from nctakt.run.assembly import AssembledMachine
from nctakt.run.program_loader import program_folder


class Target:
    """One channel, by its number, as a check needs it; ``folder`` is that of its machine."""

    def __init__(self, machine: AssembledMachine, channel: int) -> None:
        one = machine.assembled[channel]
        self.channel = channel + 1
        context = machine.channels[channel].context
        self.names: NameTable = one.names
        self.parameters: ChannelParameters = one.parameters
        self.tools = one.configuration.tools
        self.limits = StepLimits(context.max_steps, context.budget_steps)
        self.folder = machine.configuration.folder

    def searches(self, folder: Path) -> bool:
        """Return whether the channel's list names this folder of programs."""
        paths = self.parameters.program_paths
        return any(program_folder(path.folder, self.folder).resolve() == folder for path in paths)


class Targets:
    """The channels of ``default``, and of the machines that are found on the way.

    ``for_all``: programs are for ``default`` wherever they lie. ``taken``: the folders of the other
    machines that programs were for.
    """

    def __init__(self, default: AssembledMachine, for_all: bool) -> None:
        self._default = _channels(default)
        self._for_all = for_all
        self._found: list[Sequence[Target]] = []
        self.took_default = False
        self.taken: dict[Path, None] = {}

    def add(self, configuration: Machine) -> None:
        """A machine whose folder is checked."""
        if not self._for_all:
            self._found.append(_channels(AssembledMachine(configuration)))

    def of(self, program: Path | None) -> Sequence[Target]:
        """Return the channels that a program is for; ``None``: a text that lies nowhere."""
        folder = None if program is None else program.resolve().parent
        channels = self._default if folder is None else self._machine_of(folder)
        if channels is self._default:
            self.took_default = True
        else:
            self.taken[channels[0].folder] = None
        named = [one for one in channels if folder is not None and one.searches(folder)]
        return named or channels[:1]

    def _machine_of(self, folder: Path) -> Sequence[Target]:
        """The machine that the folder is in, the innermost one, else one that names the folder."""
        around = [one for one in self._found if folder.is_relative_to(one[0].folder.resolve())]
        if around:
            return max(around, key=lambda one: len(one[0].folder.resolve().parts))
        for channels in self._found:
            if any(one.searches(folder) for one in channels):
                return channels
        return self._default


def _channels(machine: AssembledMachine) -> Sequence[Target]:
    return tuple(Target(machine, index) for index in range(len(machine.assembled)))
