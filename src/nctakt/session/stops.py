# SPDX-License-Identifier: MIT
"""Stops as a person names them: a line, a branch, a condition, a function.

In: a ``StopAt``, or its text. Out: the kernel's stop for it, in a machine with its cycles.
"""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.base.source_ids import LAST_COLUMN, LAST_LINE, pack
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.hli.function_codes import code_of
from nctakt.kernel import codes, rows
from nctakt.kernel.cycles.context import context_of
from nctakt.kernel.cycles.expressions import Constant, Expression
from nctakt.kernel.cycles.instructions import Watch
from nctakt.kernel.tick.stops import (
    BecomesTrue,
    BeforeStatement,
    BlockUpToDepth,
    Changes,
    Happens,
    Runs,
    RunsStatement,
    RunsThrough,
    Stop,
    Turns,
)
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import NOT_A_STOP, TOO_MANY_STOPS
from nctakt.run.conditions import read_expression
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.session.statements import Statements, names_file

#: Stops that a session watches at most.
MAX_STOPS = 1000

Kind = Literal[
    "block", "fires", "runs", "turns", "false", "cycle", "condition", "changes", "written",
    "function", "message", "error", "notice", "handed", "paused", "statement", "fault",
]  # fmt: skip

_EVENTS: dict[Kind, tuple[int, ...]] = {
    "block": (rows.EVENT_BLOCK,),
    "fires": (rows.EVENT_FIRED,),
    "written": (rows.EVENT_WRITTEN, rows.EVENT_WRITTEN_TEXT),
    "function": (rows.EVENT_TECHNOLOGY, rows.EVENT_TECHNOLOGY_RT),
    "message": (rows.EVENT_MESSAGE,),
    "error": (rows.EVENT_ERROR, rows.EVENT_USER_ERROR),
    "handed": (rows.EVENT_TECHNOLOGY, rows.EVENT_TECHNOLOGY_RT, rows.EVENT_SPINDLE),
    "notice": (rows.EVENT_NOTICE,),
    "paused": (rows.EVENT_PAUSED,),
}

#: The kinds that watch the nodes of realtime cycles.
_OF_CYCLES: tuple[Kind, ...] = ("runs", "turns", "false", "cycle")

_LINE = re.compile(r"(?:(?P<file>\S.*?):)?(?P<line>\d{1,9})")
_WORDS: dict[str, Kind] = {
    "line": "block", "fires": "fires", "runs": "runs", "turns": "turns", "cycle": "cycle",
    "statement": "statement",
}  # fmt: skip
_NAMED: dict[str, Kind] = {"changes": "changes", "written": "written"}
_ALONE: dict[str, Kind] = {
    "message": "message", "error": "error", "notice": "notice", "fault": "fault",
}  # fmt: skip

#: A serial number that no cycle reaches.
_ANY_SERIAL = 1 << 53

#: Number of kinds of parts of a written text: the only one, first, last, in between.
_TEXT_PARTS = 4

_FUNCTION = re.compile(r"(?P<letter>[MHT])(?P<number>\d{1,9})", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class StopAt:
    """Where a session stops.

    ``kind``: a ``block`` of a line becomes current; a branch in a line ``fires``, that is begins a
    series of runs, or ``runs``, in any tick; its condition ``turns`` true, or turns ``false``; the
    realtime ``cycle`` that begins in a line runs; a ``condition`` becomes true; the value of an
    expression ``changes``; a cycle has ``written`` another value into a variable; a ``function``
    goes out; a ``message``; an ``error``; a ``notice`` about a cycle; anything is ``handed`` to the
    PLC, a function or a spindle's job; a channel has ``paused`` at single block or M00; a PLC in
    Structured Text passes a ``statement`` of a line, 0: any, or stops by a ``fault``. ``text``: the
    expression, variable or function, of a fault its number, empty: any. ``file``: empty for any
    file. ``only_if``: an expression that must be true as well, before a statement of the PLC in its
    own language. ``count``: how often it must hold, in different ticks. ``channel``: the one whose
    variables the expressions name, from 1; with ``is_of_channel`` a block or event holds in no
    other. ``max_depth``: at most this many programs are open in the last block of the tick, or
    calls at a statement of the PLC, 0: any number. ``statement``: the line of a statement in the
    branch or cycle, before which ``only_if`` is judged; 0: after the tick.
    """

    kind: Kind
    text: str = ""
    file: str = ""
    line: int = 0
    only_if: str = ""
    count: int = 1
    channel: int = 1
    is_of_channel: bool = False
    max_depth: int = 0
    statement: int = 0


def read_stop(text: str) -> StopAt:
    """Return the stop of a text.

    ``line 12`` or ``line part.nc:12``, ``fires 6``, ``runs 6``, ``turns 6``, ``cycle 5``,
    ``statement cell.st:12``, ``changes V.E.X``, ``written V.E.X``, ``M100``, ``message``,
    ``error``, ``notice``, ``fault``; anything else is a condition. ``… if CONDITION`` and
    ``… 3 times`` may follow. Raises ``Failure`` (901150).
    """
    text, count = _divided(text.strip(), re.compile(r"(.*\S)\s+(\d{1,9})\s+times", re.IGNORECASE))
    text, only_if = _divided(text, re.compile(r"(.*\S)\s+if\s+(\S.*)", re.IGNORECASE))
    options: dict[str, Any] = {"only_if": only_if, "count": int(count or 1)}
    if not text or options["count"] < 1:
        raise Failure(diagnostic(NOT_A_STOP, text=text))
    word, _, rest = text.partition(" ")
    line = _LINE.fullmatch(rest.strip())
    if word.lower() in _WORDS:
        if line is None:
            raise Failure(diagnostic(NOT_A_STOP, text=text))
        file = line["file"] or ""
        return StopAt(_WORDS[word.lower()], file=file, line=int(line["line"]), **options)
    if word.lower() in _NAMED and rest:
        return StopAt(_NAMED[word.lower()], rest.strip(), **options)
    if _FUNCTION.fullmatch(text):
        return StopAt("function", text.upper(), **options)
    if text.lower() in _ALONE:
        return StopAt(_ALONE[text.lower()], **options)
    return StopAt("condition", text, **options)


def _divided(text: str, pattern: re.Pattern[str]) -> tuple[str, str]:
    match = pattern.fullmatch(text)
    return (text, "") if match is None else (match[1], match[2])


@dataclass(frozen=True, slots=True)
class EventFilter:
    """Events of some ``kinds``, a set of bits, each of whose columns lies within its bounds.

    ``max_depth``: the last block of a tick, and only that, with at most this many open programs.
    """

    kinds: int
    lowest: tuple[float, ...]
    highest: tuple[float, ...]
    max_depth: int = 0

    def stop(self, guard: Expression, count: int) -> Stop:
        """Return the kernel's stop for such events."""
        if self.max_depth:
            channel = max(0.0, self.lowest[rows.EVENT_CHANNEL])
            return BlockUpToDepth(int(channel), self.max_depth, guard, count)
        return Happens(self.kinds, array("d", self.lowest), array("d", self.highest), guard, count)

    def takes_write(self, kind: float, channel: float, cell: float) -> bool:
        """Return whether it takes the writes of realtime cycles into a cell."""
        return bool(self.kinds >> int(kind) & 1) and all(
            self.lowest[column] <= value <= self.highest[column]
            for column, value in ((rows.EVENT_CHANNEL, channel), (rows.EVENT_A, cell))
        )

    def rows(self, events: NDArray[np.float64]) -> NDArray[np.int64]:
        """Return the indexes of those rows of events that it takes."""
        kinds = events[:, rows.EVENT_KIND].astype(np.int64)
        taken = (self.kinds >> kinds & 1).astype(bool)
        for column, (low, high) in enumerate(zip(self.lowest, self.highest, strict=True)):
            if low > -math.inf or high < math.inf:
                values = events[:, column]
                taken &= ~((values < low) | (values > high))
        found = np.flatnonzero(taken)
        if self.max_depth:
            ticks = events[found, rows.EVENT_TICK]
            is_last = np.append(ticks[1:] != ticks[:-1], [True] if len(ticks) else [])
            found = found[is_last.astype(bool)]
            found = found[events[found, rows.EVENT_C] <= self.max_depth]
        return found


#: Any block that becomes current.
BLOCKS = EventFilter(
    1 << rows.EVENT_BLOCK, (-math.inf,) * rows.EVENT_WIDTH, (math.inf,) * rows.EVENT_WIDTH
)


class _Bounds:
    """The lowest and the highest value of each column of an event; without limits at first."""

    def __init__(self) -> None:
        self._lowest = array("d", [-math.inf] * rows.EVENT_WIDTH)
        self._highest = array("d", [math.inf] * rows.EVENT_WIDTH)

    def limit(self, column: int, low: float, high: float) -> None:
        """Limit a column."""
        self._lowest[column] = low
        self._highest[column] = high

    def filter(self, kinds: int) -> EventFilter:
        """Return a filter for events of these kinds within the present bounds."""
        return EventFilter(kinds, tuple(self._lowest), tuple(self._highest))


class StopBuilder:
    """Makes the kernel's stops for a machine; ``add_cycle`` makes it know each new cycle."""

    def __init__(self, machine: AssembledMachine) -> None:
        self._machine = machine
        self.statements = Statements()
        self._definitions: list[CycleDefinition] = []
        self._conditions: dict[tuple[int, str], Expression] = {}
        self._watched: list[tuple[Stop, int]] = []
        self._stops: Sequence[StopAt] = ()

    def check(self, stops: Sequence[StopAt]) -> None:
        """Raise ``Failure`` with the mistakes of stops."""
        self._built(stops)

    def watch(self, stops: Sequence[StopAt]) -> None:
        """Let the kernel watch these stops from now on."""
        for definition in self._definitions:
            for _, watched in definition.watched:
                watched.put(Watch())
        self.statements.begin()
        self._watched = self._built(stops, is_watched=True)
        self._stops = stops
        self._machine.kernel.stops.watch([stop for stop, _ in self._watched])

    def last_hit(self) -> int:
        """Return the last tick in which one of the stops has held, -1 if none has."""
        return max((stop.last_tick for stop, _ in self._watched), default=-1)

    def watch_pauses(self, stop: StopAt | None) -> None:
        """Watch one more stop after the others, or none; the others keep their counts."""
        number = len(self._stops)
        own = [pair for pair in self._watched if pair[1] < number]
        if (stop is None) == (len(own) == len(self._watched)):
            return
        if stop is not None:
            own += [(node, number) for node in self._nodes(stop, is_watched=True)]
        self._watched = own
        self._machine.kernel.stops.watch([node for node, _ in own])

    def hits(self, tick: int) -> list[int]:
        """Return which of the stops have held in a tick, in their order."""
        return sorted({number for stop, number in self._watched if stop.last_tick == tick})

    def add_cycle(self, definition: CycleDefinition) -> None:
        """Take a realtime cycle; stops that name its lines are watched in it, too."""
        self._definitions.append(definition)
        for number, stop in enumerate(self._stops):
            for node in self._in_cycles(stop, [definition], is_watched=True):
                self._watched.append((node, number))
                self._machine.kernel.stops.add(node)

    def _built(
        self, stops: Sequence[StopAt], *, is_watched: bool = False
    ) -> list[tuple[Stop, int]]:
        if len(stops) > MAX_STOPS:
            raise Failure(diagnostic(TOO_MANY_STOPS, count=len(stops), limit=MAX_STOPS))
        return [
            (node, number)
            for number, stop in enumerate(stops)
            for node in self._nodes(stop, is_watched=is_watched)
        ]

    def _nodes(self, stop: StopAt, *, is_watched: bool) -> Iterable[Stop]:
        guard = Constant(1.0) if stop.kind == "statement" else self._guard(stop)
        match stop.kind:
            case "statement" | "fault":
                return self.statements.nodes(stop, guard, is_watched=is_watched)
            case "condition":
                return (BecomesTrue(self._condition(stop, stop.text), 1, guard, stop.count),)
            case "changes":
                return (Changes(self._condition(stop, stop.text), guard, stop.count),)
        if stop.kind in _OF_CYCLES:
            return self._in_cycles(stop, self._definitions, is_watched=is_watched)
        return tuple(one.stop(guard, stop.count) for one in self._filters(stop))

    def filters(self, stop: StopAt) -> tuple[EventFilter, ...] | None:
        """Return the events at which a stop holds; ``None`` if the record does not show them."""
        is_recorded = stop.kind in _EVENTS and not stop.only_if
        return tuple(self._filters(stop)) if is_recorded else None

    def _filters(self, stop: StopAt) -> Iterable[EventFilter]:
        kinds = sum(1 << kind for kind in _EVENTS[stop.kind])
        bounds = _Bounds()
        channel = stop.channel if stop.is_of_channel and len(self._machine.assembled) > 1 else 0
        if channel:
            bounds.limit(rows.EVENT_CHANNEL, channel, channel)
        if stop.max_depth:
            yield replace(bounds.filter(kinds), max_depth=stop.max_depth)
            return
        if stop.kind == "function":
            match = _FUNCTION.fullmatch(stop.text)
            if match is None:
                raise Failure(diagnostic(NOT_A_STOP, text=stop.text))
            code = code_of(match["letter"].upper(), int(match["number"]))
            bounds.limit(rows.EVENT_A, code, code)
        if stop.kind == "written":
            bounds.limit(rows.EVENT_SUBJECT, 1, _ANY_SERIAL)
            yield from self._writes(stop, bounds)
            return
        for first, last in self._sources(stop):
            bounds.limit(rows.EVENT_SOURCE, first, last)
            yield bounds.filter(kinds)

    def _writes(self, stop: StopAt, bounds: _Bounds) -> Iterable[EventFilter]:
        """Yield the filters for writes of cycles into a variable, for a text one per part."""
        prefix = f"CH{stop.channel}." if stop.channel > 1 else ""
        cell, is_text = self._machine.access.cell_of(f"{prefix}{stop.text}")
        kind = rows.EVENT_WRITTEN_TEXT if is_text else rows.EVENT_WRITTEN
        for part in range(_TEXT_PARTS if is_text else 1):
            number = part * rows.TEXT_PART + cell
            bounds.limit(rows.EVENT_A, number, number)
            yield bounds.filter(1 << kind)

    def _sources(self, stop: StopAt) -> Iterable[tuple[float, float]]:
        """Yield the source ids of the line of a stop, in each file that it may mean."""
        if not stop.line:
            yield -math.inf, math.inf
            return
        line = min(stop.line, LAST_LINE)
        for index, name in enumerate(self._machine.files.names):
            if names_file(stop.file, name):
                first = pack(index, line, 1)
                yield first, first | LAST_COLUMN

    def _in_cycles(
        self, stop: StopAt, definitions: Iterable[CycleDefinition], *, is_watched: bool
    ) -> list[Stop]:
        """Return the stops in the nodes of realtime cycles; ``is_watched``: they are watched."""
        if stop.kind not in _OF_CYCLES:
            return []
        guard = self._guard(stop)
        if stop.statement and stop.only_if:
            return self._at_statement(stop, guard, definitions) if is_watched else []
        found: list[Stop] = []
        for definition in definitions:
            begin = definition.span
            if stop.kind == "cycle":
                if begin.line == stop.line and names_file(stop.file, begin.file):
                    found.append(RunsThrough(definition.cycle, guard, stop.count))
                continue
            for branch in definition.reactions:
                if branch.span.line != stop.line or not names_file(stop.file, branch.span.file):
                    continue
                if stop.kind == "runs":
                    found.append(Runs(branch.node, guard, stop.count))
                else:
                    truth = codes.TRUE if stop.kind == "turns" else codes.FALSE
                    found.append(Turns(branch.node.condition, truth, guard, stop.count))
        return found

    def _at_statement(
        self, stop: StopAt, guard: Expression, definitions: Iterable[CycleDefinition]
    ) -> list[Stop]:
        """Return the stops at a statement whose guard is judged before it."""
        found: list[Stop] = []
        context = context_of(self._machine.memory)
        for definition in definitions:
            for span, watched in definition.watched:
                if span.line == stop.statement and names_file(stop.file, span.file):
                    before = BeforeStatement(guard, context, watched.watch)
                    watched.put(before)
                    found.append(RunsStatement(before, Constant(1.0), stop.count))
        return found

    def _guard(self, stop: StopAt) -> Expression:
        return self._condition(stop, stop.only_if) if stop.only_if else Constant(1.0)

    def _condition(self, stop: StopAt, text: str) -> Expression:
        """Return the expression of a text, read once."""
        key = stop.channel, text
        if key not in self._conditions:
            self._conditions[key] = self.read(text, stop.channel)
        return self._conditions[key]

    def read(self, text: str, channel: int = 1) -> Expression:
        """Return the expression of a text in the controller's language; raises ``Failure``."""
        return read_expression(self._machine, text, channel)
