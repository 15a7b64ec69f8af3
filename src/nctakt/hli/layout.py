# SPDX-License-Identifier: MIT
"""What stands in the HLI: one declaration of each value, from which all else is made.

``PANEL`` are the operator's commands and ``LAMPS`` what the channel shows for them; each has a cell
in the memory, in this order (``kernel/panel.py``). From outside they are called ``HLI.OVERRIDE``,
``HLI.STATE`` …
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

#: What stands in front of the names of operator's values: ``HLI.FEED_HOLD``.
PREFIX = "HLI."


@dataclass(frozen=True, slots=True)
class Entry:
    """A value of the HLI: name, type as in variables lists, unit, meaning."""

    name: str
    type: str
    unit: str
    meaning: str


#: What the operator commands; the PLC writes it.
PANEL = (
    Entry("override", "REAL64", "%", "the operator's override of the path"),
    Entry("feed_hold", "BOOLEAN", "", "1: the path brakes to a stand and stays there"),
    Entry("single_block", "BOOLEAN", "", "1: the channel stops in front of each block"),
    Entry("start", "BOOLEAN", "", "START: the PLC writes 1, the CNC takes it and writes 0"),
    Entry("reset", "BOOLEAN", "", "RESET: the PLC writes 1, the CNC takes it and writes 0"),
)

#: What the channel shows; the CNC writes it.
LAMPS = (
    Entry("state", "UNS08", "", "0 ready, 1 a program runs, 2 error, 3 reset"),
    Entry("paused", "BOOLEAN", "", "1: single block waits for START"),
    Entry("armed", "BOOLEAN", "", "1: a selected program waits for START"),
    Entry("error", "UNS32", "", "number of the error that has stopped the channel, else 0"),
)

#: Cells of a channel's panel.
PANEL_CELLS = len(PANEL) + len(LAMPS)


@dataclass(frozen=True, slots=True)
class PanelValue:
    """A value of the panel by its name from outside: its cell, whether the PLC may write it."""

    name: str
    entry: Entry
    cell: int
    is_command: bool


def panel_values(first_cell: int) -> Iterator[PanelValue]:
    """The operator's values of a channel whose panel begins at ``first_cell``."""
    for offset, entry in enumerate((*PANEL, *LAMPS)):
        name = PREFIX + entry.name.upper()
        yield PanelValue(name, entry, first_cell + offset, entry in PANEL)
