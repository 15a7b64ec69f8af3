# SPDX-License-Identifier: MIT
"""Event rows made by hand, and the names that their numbers represent."""

import struct

from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import SourceFiles, pack
from nctakt.kernel import rows


class Names:
    """Two cycles, one variable, one text, one program, one file."""

    def __init__(self) -> None:
        self.files = SourceFiles()
        self.files.add("part.nc", ["M30"] * 9)

    def cycle(self, serial: int) -> str:
        return {1: "17", 2: "#1"}[serial]

    def variable(self, cell: int) -> str:
        return {40: "V.E.VALUE"}[cell]

    def message(self, number: int) -> str:
        return {3: "tool; worn <out>"}[number]

    def axis(self, index: int) -> str:
        return {2: "Z"}[index]

    def variable_text(self, number: int) -> str:
        return {4: "V.E.ASYNC"}[number]

    def spindle(self, number: int) -> str:
        return f"S{number + 1}"

    def user_text(self, number: int) -> str:
        return {6: "worn"}[number]

    def thread(self, number: int) -> str:
        """The name of a thread."""
        return f"thread {number}"

    def program(self, number: int) -> str:
        return {0: "part.nc"}[number]

    def span(self, source: int) -> Span | None:
        return self.files.span(source)


def row(kind: int, subject: int = 0, *arguments: float, tick: int = 7, channel: int = 0) -> bytes:
    """An event row from line 5, column 3."""
    head = (tick, kind, channel, pack(0, 5, 3), subject)
    rest = (0.0,) * (rows.EVENT_WIDTH - len(head) - len(arguments))
    return struct.pack(f"={rows.EVENT_WIDTH}d", *head, *arguments, *rest)
