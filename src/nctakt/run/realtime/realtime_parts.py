# SPDX-License-Identifier: MIT
"""Realtime parts of machines, used by one run after another.

In: a machine. Out: a realtime part as at start-up: a new one, or one that a run has given back,
put back to its snapshot. Only the machines used last keep theirs.
"""

from __future__ import annotations

from collections import OrderedDict

from nctakt.decoder.state.kept_trees import KeptTrees
from nctakt.lists.machine.machine import Machine
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.snapshot import Snapshot

#: Machines whose realtime parts are kept, of some eight megabytes each.
MACHINES = 16


class LentPart:
    """A realtime part for one run; no one else has it until it is given back."""

    def __init__(self, part: RealtimePart, shelf: list[LentPart]) -> None:
        self.part = part
        part.kept_cycles = KeptTrees()
        self._start_up = Snapshot(part)
        self._shelf = shelf

    def put_back(self) -> None:
        """Put it back to start-up."""
        self._start_up.put_back()

    def give_back(self) -> None:
        """Give it back; what its run has made must not be read from it any more."""
        self._shelf.append(self)


class RealtimeParts:
    """The realtime parts that are free, by machine."""

    def __init__(self) -> None:
        self._shelves: OrderedDict[int, tuple[Machine, list[LentPart]]] = OrderedDict()

    def lend(self, machine: Machine) -> LentPart:
        """Return a realtime part of a machine as it is at start-up."""
        key = id(machine)  # the machine is kept, so that no other one gets its id
        shelves = self._shelves
        shelf = shelves.setdefault(key, (machine, []))[1]
        shelves.move_to_end(key)
        if len(shelves) > MACHINES:
            shelves.popitem(last=False)
        if shelf:
            lent = shelf.pop()
            lent.put_back()
            return lent
        return LentPart(RealtimePart(machine, names_of_machine(machine).layout), shelf)
