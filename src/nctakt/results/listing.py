# SPDX-License-Identifier: MIT
"""Realtime cycles as text: ``nctakt disassemble`` (RC-302, RC-501).

In: definitions in the order in which the decoder reached them. Out: lines: for each cycle its
counts and its frozen values, then its statements, each with its elementary instructions below it.
A definition that is reached again is listed once; its frozen values are listed each time.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.results.instruction_tree import ListedCycle, ListedStatement, list_cycle
from nctakt.results.trace.events import value_text

_HEAD = Text("Realtime cycle {name}, {position}", "Echtzeit-Zyklus {name}, {position}")
_SIZE = Text(
    "elementary instructions: {count}, in one run-through at most {maximum}; memory: {bytes} bytes",
    "Elementar-Anweisungen: {count}, in einem Durchlauf höchstens {maximum}; Speicher: {bytes} "
    "Byte",
)
_FROZEN = Text("frozen when it was decoded: {values}", "beim Dekodieren eingefroren: {values}")
_FROZEN_VALUE = Text("{name} = {value} (line {line})", "{name} = {value} (Zeile {line})")
_AGAIN = Text("the instructions of cycle {first}", "die Anweisungen von Zyklus {first}")
_FREEZES = Text("frozen", "eingefroren")
_COLUMNS = (Text("line", "Zeile"), Text("count", "Anzahl"))
_STEP = "  "


class Listing:
    """Lists one definition after another."""

    def __init__(self, language: Language) -> None:
        self._language = language
        self._listed: dict[Span, str] = {}

    def lines(self, name: str, definition: CycleDefinition, memory_bytes: int) -> Iterator[str]:
        """Yield the lines of a cycle; ``memory_bytes`` is its share of P-CHAN-00407."""
        cycle = list_cycle(definition)
        position = f"{cycle.span.file}:{cycle.span.line}"
        yield self._text(_HEAD, name=name, position=position)
        counts = {"count": cycle.count, "maximum": cycle.max_count, "bytes": memory_bytes}
        yield _STEP + self._text(_SIZE, **counts)
        if cycle.frozen:
            yield _STEP + self._text(_FROZEN, values=self._frozen(cycle))
        first = self._listed.setdefault(cycle.span, name)
        if first != name:
            yield _STEP + self._text(_AGAIN, first=first)
            return
        yield ""
        yield from self._table(cycle)

    def _text(self, text: Text, **values: object) -> str:
        return text.get(self._language).format_map(values)

    def _frozen(self, cycle: ListedCycle) -> str:
        return ", ".join(
            self._text(
                _FROZEN_VALUE, name=value.name, value=value_text(value.value), line=value.span.line
            )
            for value in cycle.frozen
        )

    def _table(self, cycle: ListedCycle) -> Iterator[str]:
        """Yield the rows: line, count of the statement, count of the node, text."""
        line_head, count_head = (head.get(self._language) for head in _COLUMNS)
        widths = (max(6, len(line_head)), max(6, len(count_head)))
        yield f"{line_head:>{widths[0]}}  {count_head:>{widths[1]}}"
        yield f"{cycle.span.line:>{widths[0]}}  {'':>{widths[1]}}  {cycle.text}"
        for statement in cycle.statements:
            indent = _STEP * (statement.depth + 1)
            yield (
                f"{statement.line:>{widths[0]}}  {statement.count:>{widths[1]}}  "
                f"{indent}{statement.text}"
            )
            for line in self._nodes(statement):
                yield f"{'':>{widths[0]}}  {'':>{widths[1]}}  {indent}{_STEP}{line}"

    def _nodes(self, statement: ListedStatement) -> Iterator[str]:
        """Yield the nodes of a statement; none for a statement of a single node."""
        if len(statement.instructions) < 2 and not any(
            instruction.is_frozen for instruction in statement.instructions
        ):
            return
        for instruction in statement.instructions:
            mark = f", {_FREEZES.get(self._language)}" if instruction.is_frozen else ""
            yield f"{instruction.count}  {_STEP * instruction.depth}{instruction.text}{mark}"
