# SPDX-License-Identifier: MIT
"""The places of a program where a breakpoint can be: blocks, and parts of realtime cycles.

In: the lines of a text, the realtime cycles in it. Out: for a line the place there, or the next one
after it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.messages import Collector
from nctakt.nc import tree
from nctakt.nc.outline import bodies_of
from nctakt.nc.parse.parser import StatementReader
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.source import Source

#: Lines that are looked through for places at most, for those of a stretch.
MAX_LINES = 2000

#: Lines before a block that are read, since it may have begun there.
MAX_LINES_BEFORE = 100

PlaceKind = Literal["block", "branch", "otherwise", "cycle", "statement"]


@dataclass(frozen=True, slots=True)
class Place:
    """A place in a line.

    ``kind``: a ``block`` of a program; something in the body of a ``branch`` of a realtime cycle,
    or its condition; the same of an $ELSE, ``otherwise``; a statement of a ``cycle`` outside any
    branch; a ``statement`` of a PLC in Structured Text. ``owner``: the line of the branch, or of
    the cycle. ``target``: the variable to which the statement assigns, as text. ``statement``: the
    line of the statement of a cycle there, of a branch that of the first one in its body; 0: none.
    """

    line: int
    kind: PlaceKind
    owner: int
    target: str = ""
    statement: int = 0


class StatementPlaces:
    """The places of one text in Structured Text; ``lines``: where statements begin, ascending."""

    def __init__(self, lines: Sequence[int]) -> None:
        self._lines = lines

    def at_or_after(self, line: int) -> Place | None:
        """Return the place in a line, else the first one after it; ``None`` without any."""
        found = next((one for one in self._lines if one >= line), None)
        return None if found is None else Place(found, "statement", found)

    def between(self, first: int, last: int) -> list[Place]:
        """Return the places of a stretch of lines."""
        return [Place(one, "statement", one) for one in self._lines if first <= one <= last]


class Places:
    """The places of one text; ``cycles``: the realtime cycles of all texts."""

    def __init__(
        self, file: str, lines: Sequence[str], cycles: Sequence[tree.RealtimeCycle]
    ) -> None:
        self._source = Source(file, lines if isinstance(lines, list) else list(lines))
        self._cycles = [cycle for cycle in cycles if cycle.span.file == file]

    def at_or_after(self, line: int) -> Place | None:
        """Return the place in a line, else the first one after it; ``None`` without any."""
        while 1 <= line <= len(self._source.lines):
            around = self._cycle_around(line)
            if around is None:
                return self._block_from(line)
            inside = (location for location in _of_cycle(around) if location.line >= line)
            first = min(inside, key=lambda location: location.line, default=None)
            if first is not None:
                return first
            line = around.end_span.line + 1
        return None

    def between(self, first: int, last: int) -> list[Place]:
        """Return the places of a stretch of lines, of at most ``MAX_LINES``."""
        found: list[Place] = []
        line = max(1, first)
        last = min(last, line + MAX_LINES)
        while line <= last:
            location = self.at_or_after(line)
            if location is None or location.line > last:
                break
            found.append(location)
            line = location.line + 1
        return found

    def _cycle_around(self, line: int) -> tree.RealtimeCycle | None:
        """Return the realtime cycle in whose body a line is."""
        for cycle in self._cycles:
            if cycle.span.line < line <= cycle.end_span.line:
                return cycle
        return None

    def _block_from(self, line: int) -> Place | None:
        """Return the block that begins in a line or after it."""
        begin = max(1, line - MAX_LINES_BEFORE)
        for _, statement in StatementReader(self._source, Collector(), begin):
            for own in _statements_in(statement):
                if own.span.line >= line:
                    return Place(own.span.line, "block", own.span.line)
        return None


def _statements_in(statement: tree.Statement) -> Iterator[tree.Statement]:
    """Yield the statements that are blocks of the program: itself, and those of its bodies."""
    if isinstance(statement, tree.ProgramStart | tree.Unreadable):
        return
    yield statement
    for body in bodies_of(statement):
        for inner in body:
            yield from _statements_in(inner)


def _of_cycle(cycle: tree.RealtimeCycle) -> Iterator[Place]:
    """Yield the places in the body of a realtime cycle."""
    yield from _of_body(cycle.body, "cycle", cycle.span.line)


def _of_body(body: Sequence[tree.Statement], kind: PlaceKind, owner: int) -> Iterator[Place]:
    for statement in body:
        line = statement.span.line
        if isinstance(statement, tree.If):
            yield Place(line, "branch", line, statement=_first(statement.body))
            yield from _of_body(statement.body, "branch", line)
            for branch in statement.elseifs:
                at = branch.span.line
                yield Place(at, "branch", at, statement=_first(branch.body))
                yield from _of_body(branch.body, "branch", branch.span.line)
            if statement.else_body is not None and statement.else_span is not None:
                begin = statement.else_span.line
                yield Place(begin, "otherwise", begin, statement=_first(statement.else_body))
                yield from _of_body(statement.else_body, "otherwise", begin)
            continue
        target = ""
        if isinstance(statement, tree.Assignment):
            target = format_expression(statement.target)
        yield Place(line, kind, owner, target, line)


def _first(body: Sequence[tree.Statement]) -> int:
    """Return the line of the first statement of a body; 0 where that is a branch, or none."""
    return 0 if not body or isinstance(body[0], tree.If) else body[0].span.line
