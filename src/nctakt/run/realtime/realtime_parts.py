# SPDX-License-Identifier: MIT
"""Realtime parts of machines, reused from run to run.

In: a machine. Out: a realtime part in its start-up state: a new one, or one returned by a run and
restored to its snapshot. Only the machines used last keep theirs.
"""

from __future__ import annotations

from collections import OrderedDict

from nctakt.decoder.state.kept_trees import KeptTrees
from nctakt.lists.machine.machine import Machine
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.snapshot import Snapshot

#: Number of machines whose realtime parts are kept, some eight megabytes each.
MACHINES = 16


class LentPart:
    """A realtime part lent exclusively to one run until it is returned."""

    def __init__(self, part: RealtimePart, shelf: list[LentPart]) -> None:
        self.part = part
        part.kept_cycles = KeptTrees()
        self._start_up = Snapshot(part)
        self._shelf = shelf

    def put_back(self) -> None:
        """Put it back to start-up."""
        self._start_up.put_back()

    def give_back(self) -> None:
        """Return it; the results of its run must not be read from it any more."""
        self._shelf.append(self)


class RealtimeParts:
    """The realtime parts that are free, by machine."""

    def __init__(self) -> None:
        self._shelves: OrderedDict[int, tuple[Machine, list[LentPart]]] = OrderedDict()

    def lend(self, machine: Machine) -> LentPart:
        """Return a realtime part of a machine in its start-up state."""
        key = id(machine)  # the machine is kept, so that no other gets its id
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
