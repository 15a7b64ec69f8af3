# SPDX-License-Identifier: MIT
"""Why a PLC in Structured Text has changed its variables: its notes -> histories (ST-840).

In: the log of ``kernel.st.observing.notes`` and the rows of the program. Out: ``PlcHistory`` for
each watched variable that a statement has written. Watched are the scalars of the project's code,
except counters of FOR and pointers, and each place of the interface that a statement writes.
"""

from __future__ import annotations

import itertools
import struct
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.results.explained.plc_histories import Fact, PlcChange, PlcHistories, PlcHistory
from nctakt.results.trace.events import number_text
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    EnumType,
    Expression,
    InterfaceType,
    Kind,
    PointerType,
    ReferenceType,
    Section,
    Storage,
    StructType,
    Type,
    Variable,
)
from nctakt.translation.body import value_type
from nctakt.translation.layout import is_real, kind_of
from nctakt.translation.observing.noting import NoteRows

#: Elements of an array that are watched, at most.
_MAX_ELEMENTS = 256


#: The newest changes of watches by their numbers, each as its words of the log.
_Changes = dict[int, deque[Sequence[int]]]


@dataclass(frozen=True, slots=True)
class _Noted:
    """The notes at a moment: the log, changes already taken from it, watches."""

    log: memoryview
    taken: Mapping[int, Sequence[Sequence[int]]]
    address: Sequence[int]
    kind: Sequence[int]
    seen: Sequence[int]
    written_at: Sequence[int]
    written_by: Sequence[int]
    missed: Sequence[int]
    logged: Sequence[int]


@dataclass(frozen=True, slots=True)
class _Named:
    """The name of a watch, and the form of its value."""

    path: str
    is_interface: bool
    show: Callable[[int], str]


class StReasons:
    """The notes of one running PLC."""

    def __init__(
        self,
        program: Program,
        rows: NoteRows,
        context: PlcContext,
        names: Mapping[int, str],
        tick_ns: int,
        first_tick: int,
    ) -> None:
        self._program = program
        self._rows = rows
        self._context = context
        self._notes = context.keep_notes()
        self._tick_ns = tick_ns
        self._first_tick = first_tick
        self._names = names
        self._own: dict[int, _Named] = {}
        self._taken: _Changes = {}
        self._facts_seen: dict[tuple[int, int], Fact] = {}
        for path, address, found in _own_variables(program, rows.counters):
            kind = kind_of(found)
            number = 0 if kind is None else self._watch(address, kind)
            if number and kind is not None:
                self._own[number] = _Named(path, False, _shower(found, kind))
        self._notes.interface_from = self._notes.count + 1

    def _watch(self, address: int, kind: int) -> int:
        return self._notes.watch(self._context.memory, address, kind)

    def take(self) -> None:
        """Empty the log if it is nearly full."""
        if self._notes.is_crowded:
            _add(self._taken, self._notes.take_log())

    def histories(self) -> PlcHistories:
        """Return the histories of variables written by statements, in the order of their names.

        They are made on request, from the present notes.
        """
        notes = self._notes
        notes.drop_old()
        watches = slice(0, notes.count + 1)
        noted = _Noted(
            _words(notes.log[: notes.log_end]),
            {number: tuple(changes) for number, changes in self._taken.items()},
            _words(notes.address[watches]),
            _words(notes.kind[watches]),
            _words(notes.seen[watches]),
            _words(notes.written_at[watches]),
            _words(notes.written_by[watches]),
            _words(notes.missed[watches]),
            _words(notes.logged[watches]),
        )
        return PlcHistories(lambda: self._histories(noted))

    def _histories(self, noted: _Noted) -> tuple[PlcHistory, ...]:
        kept = {number: deque(changes, kinds.NOTES_KEPT) for number, changes in noted.taken.items()}
        _add(kept, noted.log)
        found = [
            self._history(number, noted, kept.get(number, ()))
            for number in range(1, len(noted.address))
            if noted.written_at[number] >= 0 or number in kept
        ]
        return tuple(sorted(found, key=lambda one: (not one.is_interface, one.path)))

    def _history(self, number: int, noted: _Noted, kept: Sequence[Sequence[int]]) -> PlcHistory:
        named = self._named(number, noted)
        changes = tuple(self._change(words, named) for words in kept)
        written, writer = noted.written_at[number], noted.written_by[number]
        begin = named.show(kept[0][3] if kept else noted.seen[number])
        missed = noted.missed[number]
        if missed or (changes and not changes[0].before):
            begin = ""
        return PlcHistory(
            named.path,
            named.is_interface,
            begin,
            changes,
            noted.logged[number] - len(changes),
            missed,
            self._tick(written) if written >= 0 else None,
            self._span(writer) if written >= 0 else None,
            self._statement(writer) if written >= 0 else "",
        )

    def _named(self, number: int, noted: _Noted) -> _Named:
        found = self._own.get(number)
        if found is not None:
            return found
        address, kind = noted.address[number], noted.kind[number]
        name = self._names.get(address, f"%{address}")
        return _Named(name, True, _shower(None, kind))

    def _tick(self, now: int) -> int:
        return int(now // self._tick_ns) + self._first_tick

    def _span(self, source: int) -> Span | None:
        return self._program.sources.span(source, source + 1) if source > 0 else None

    def _statement(self, source: int) -> str:
        """Return the text of a statement, of other sources the rest of their line."""
        span, end = self._span(source), self._rows.ends.get(source)
        if span is None:
            return ""
        if end is not None:
            return self._program.sources.text(source, end)
        return self._program.sources.line(span.file, span.line)[span.column - 1 :].strip()

    def _change(self, words: Sequence[int], named: _Named) -> PlcChange:
        _, now, source, before, value, count, flags, _ = words[: kinds.NOTE_HEAD]
        rows = words[kinds.NOTE_HEAD :]
        pairs = [(rows[2 * i], rows[2 * i + 1]) for i in range(count)]
        return PlcChange(
            self._tick(now),
            self._span(source),
            "" if flags & kinds.NOTES_FIRST else named.show(before),
            named.show(value),
            self._statement(source),
            self._facts(pairs),
            bool(flags & kinds.NOTES_CUT),
        )

    def _facts(self, pairs: list[tuple[int, int]]) -> tuple[Fact, ...]:
        """Return what led to a change, without finished statements that led to no result."""
        open_facts: list[tuple[int, Fact]] = []
        result: tuple[int, list[tuple[int, Fact]]] = (-1, [])
        for index, (row, value) in enumerate(pairs):
            if row == kinds.NOTE_CLOSED:
                open_facts = [one for one in open_facts if one[0] < value]
            elif row == kinds.NOTE_RETURNED:
                call = next((fact for at, fact in open_facts if at == value), None)
                inside = [fact for at, fact in result[1] if at > value] if result[0] > value else []
                open_facts = [one for one in open_facts if one[0] < value]
                if call is not None and inside:
                    returned = Fact("call", call.span, call.text, "", tuple(inside))
                    open_facts.append((value, returned))
            else:
                fact = self._fact(row, value)
                open_facts.append((index, fact))
                if fact.kind == "result":
                    result = (index, list(open_facts))
        return tuple(fact for _, fact in open_facts)

    def _fact(self, row: int, value: int) -> Fact:
        fact = self._facts_seen.get((row, value))
        if fact is None:
            fact = self._facts_seen[row, value] = self._new_fact(row, value)
        return fact

    def _new_fact(self, row: int, value: int) -> Fact:
        found = self._rows.rows[row]
        node, sources = found.node, self._program.sources
        text = sources.text(node.start, node.end)
        shown = ""
        if found.kind == "pass":
            shown = str(value)
        elif found.kind in ("condition", "operand", "selector") and isinstance(node, Expression):
            sought = value_type(node)
            kind = kind_of(sought)
            if is_real(sought):
                kind = kinds.F64
            shown = "" if kind is None else _shower(sought, kind)(value)
        return Fact(found.kind, sources.span(node.start, node.start + 1), text, shown)


def _words(noted: Sequence[int]) -> memoryview:
    """Return the present words."""
    return memoryview(bytes(noted)).cast("q")


def _add(kept: _Changes, log: memoryview) -> None:
    """Add the changes of a log to those of their watches."""
    at = 0
    while at < len(log):
        end = at + kinds.NOTE_HEAD + 2 * log[at + kinds.NOTE_ROW_COUNT]
        kept.setdefault(log[at], deque(maxlen=kinds.NOTES_KEPT)).append(log[at:end])
        at = end


def _shower(found: Type | None, kind: int) -> Callable[[int], str]:
    """Return a formatter for the bits of a value."""
    labels: dict[int, str] = {}
    if isinstance(found, EnumType):
        for one in found.values.values():
            labels.setdefault(one.number, f"{found.name}.{one.name}")

    def show(bits: int) -> str:
        if kind == kinds.BOOL:
            return "TRUE" if bits else "FALSE"
        if kind == kinds.F32:
            return number_text(struct.unpack("<f", struct.pack("<q", bits)[:4])[0])
        if kind == kinds.F64:
            return number_text(struct.unpack("<d", struct.pack("<q", bits))[0])
        if kind == kinds.U64:
            bits &= (1 << 64) - 1
        return labels.get(bits, str(bits))

    return show


def _own_variables(program: Program, counters: set[int]) -> Iterator[tuple[str, int, Type]]:
    """Yield path, address and type of the scalars of a project's own code."""
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for one in group.variables.values():
            if one.storage is Storage.GLOBAL and id(one) not in counters:
                address = kinds.NULL_BYTES + one.offset
                yield from _scalars(f"{prefix}{one.name}", one.type, address, counters)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and pou.type is not None and not pou.library:
            address = kinds.NULL_BYTES + pou.instance
            yield from _scalars(pou.name, pou.type, address, counters)


def _scalars(
    path: str, found: Type, address: int, counters: set[int]
) -> Iterator[tuple[str, int, Type]]:
    if isinstance(found, BlockType | StructType):
        for one in _members(found):
            if id(one) not in counters:
                at = address + one.offset
                yield from _scalars(f"{path}.{one.name}", one.type, at, counters)
    elif isinstance(found, ArrayType):
        ranges = [range(low, high + 1) for low, high in found.bounds]
        elements = itertools.islice(itertools.product(*ranges), _MAX_ELEMENTS)
        for number, indices in enumerate(elements):
            name = f"{path}[{','.join(map(str, indices))}]"
            at = address + number * found.element.size
            yield from _scalars(name, found.element, at, counters)
    elif kind_of(found) is not None:
        if not isinstance(found, PointerType | ReferenceType | InterfaceType):
            yield path, address, found


def _members(found: BlockType | StructType) -> Iterator[Variable]:
    if isinstance(found, BlockType) and found.pou.library:
        return
    members = found.pou.members if isinstance(found, BlockType) else found.members
    for one in members.values():
        is_here = one.section is not Section.IN_OUT and one.storage is not Storage.GLOBAL
        if is_here and one.bit < 0:
            yield one
