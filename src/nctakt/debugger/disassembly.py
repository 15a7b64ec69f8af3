# SPDX-License-Identifier: MIT
"""Realtime cycles as elementary instructions, with the addresses that the protocol asks for.

In: the listings of the living cycles (RC-501). Out: an address for each instruction of a cycle, in
the order of its text, and the instructions around an address. A statement of a single instruction
is one row, others have a row for each of their instructions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.sources import Sources
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import NO_INSTRUCTIONS, WRONG_ARGUMENT
from nctakt.results.instruction_tree import ListedCycle

#: Addresses of one cycle; no cycle has as many instructions.
SPACE = 0x100_0000
#: Instructions that one request can ask for.
MAX_INSTRUCTIONS = 4096

#: The listing of each living cycle by its thread, counted from 1.
Listings = Callable[[], Mapping[int, ListedCycle]]


@dataclass(frozen=True, slots=True)
class _Row:
    """An instruction: its text, the line of its statement, whether that begins here."""

    text: str
    line: int
    is_first: bool


def address_of(number: int, row: int) -> str:
    """Return the address of an instruction of the cycle with a number, from 1."""
    return f"0x{number * SPACE + row:08x}"


class Disassembly:
    """The instructions of a session's cycles at its tick; ``forget`` when it has gone on."""

    def __init__(self, sources: Sources, listings: Listings) -> None:
        self._sources = sources
        self._listings = listings
        self._rows: dict[int, tuple[str, list[_Row]]] | None = None

    def forget(self) -> None:
        """Forget the listings."""
        self._rows = None

    def pointer(self, number: int, line: int) -> str:
        """Return the address of the first instruction of a line, else of the cycle."""
        _, rows = self._known().get(number, ("", []))
        found = (index for index, row in enumerate(rows) if row.line == line)
        return address_of(number, next(found, 0))

    def answer(self, arguments: Arguments) -> dict[str, Any]:
        """Return as many instructions as a request asks for; missing ones say so."""
        reference = arguments.text("memoryReference")
        try:
            address = int(reference, 0) + arguments.number("offset", 0)
        except ValueError:
            address = -1
        number, row = divmod(address, SPACE)
        if number not in self._known():
            raise Failure(diagnostic(NO_INSTRUCTIONS, reference=reference))
        count = arguments.number("instructionCount")
        if not 0 <= count <= MAX_INSTRUCTIONS:
            expected = f"0 … {MAX_INSTRUCTIONS}"
            raise Failure(diagnostic(WRONG_ARGUMENT, name="instructionCount", expected=expected))
        first = row + arguments.number("instructionOffset", 0)
        return {"instructions": [self._shown(number, first + index) for index in range(count)]}

    def _shown(self, number: int, index: int) -> dict[str, Any]:
        file, rows = self._known()[number]
        address = f"0x{max(0, number * SPACE + index):08x}"
        if not 0 <= index < len(rows):
            return {"address": address, "instruction": "–", "presentationHint": "invalid"}
        row = rows[index]
        shown: dict[str, Any] = {"address": address, "instruction": row.text}
        if row.is_first:
            shown |= {"location": self._sources.source(file), "line": row.line, "column": 1}
        return shown

    def _known(self) -> dict[int, tuple[str, list[_Row]]]:
        if self._rows is None:
            self._rows = {
                number: (cycle.span.file, _rows_of(cycle))
                for number, cycle in self._listings().items()
            }
        return self._rows


def _rows_of(cycle: ListedCycle) -> list[_Row]:
    """Return the rows of a cycle: statements, and below those with several their instructions."""
    rows = [_Row(cycle.text, cycle.span.line, True)]
    for statement in cycle.statements:
        indent = "  " * (statement.depth + 1)
        parts: Sequence[str] = [
            f"{'  ' * one.depth}{one.text} ({one.count})" for one in statement.instructions
        ]
        counted = f" ({statement.count})" if statement.count else ""
        rows.append(_Row(f"{indent}{statement.text}{counted}", statement.line, True))
        if len(parts) > 1:
            rows += [_Row(f"{indent}  {part}", statement.line, False) for part in parts]
    return rows
