# SPDX-License-Identifier: MIT
"""Realtime cycles as text: ``nctakt list`` (RC-302, RC-501).

In: definitions in the order in which the decoder met them. Out: lines: for each cycle its counts
and what was frozen into it, then its statements, each with its elementary instructions below it.
A definition that the decoder meets again is listed once; what was frozen into it is told each time.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.results.instruction_tree import ListedCycle, ListedStatement, list_cycle
from nctakt.trace.events import number_text

_HEAD = Text("Realtime cycle {name}, {place}", "Echtzeit-Zyklus {name}, {place}")
_SIZE = Text(
    "elementary instructions: {count}, in one run-through at most {most}; memory: {bytes} bytes",
    "Elementar-Anweisungen: {count}, in einem Durchlauf höchstens {most}; Speicher: {bytes} Byte",
)
_FROZEN = Text("frozen when it was decoded: {values}", "beim Dekodieren eingefroren: {values}")
_FROZEN_VALUE = Text("{name} = {value} (line {line})", "{name} = {value} (Zeile {line})")
_AGAIN = Text("the instructions of cycle {first}", "die Anweisungen von Zyklus {first}")
_FREEZES = Text("frozen", "eingefroren")
_COLUMNS = (Text("line", "Zeile"), Text("count", "Anzahl"))
_STEP = "  "


class Listing:
    """Makes the lines of one definition after another."""

    def __init__(self, language: Language) -> None:
        self._language = language
        self._listed: dict[Span, str] = {}

    def lines(self, name: str, definition: CycleDefinition, memory_bytes: int) -> Iterator[str]:
        """The lines of a cycle; ``memory_bytes`` is what it takes of P-CHAN-00407."""
        cycle = list_cycle(definition)
        place = f"{cycle.span.file}:{cycle.span.line}"
        yield self._text(_HEAD, name=name, place=place)
        counts = {"count": cycle.count, "most": cycle.most, "bytes": memory_bytes}
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
                _FROZEN_VALUE, name=one.name, value=number_text(one.value), line=one.span.line
            )
            for one in cycle.frozen
        )

    def _table(self, cycle: ListedCycle) -> Iterator[str]:
        """Line, count of the statement, count of the node, text."""
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
        """The nodes of a statement; none where it is a single one itself."""
        if len(statement.instructions) < 2 and not any(
            one.is_frozen for one in statement.instructions
        ):
            return
        for one in statement.instructions:
            mark = f", {_FREEZES.get(self._language)}" if one.is_frozen else ""
            yield f"{one.count}  {_STEP * one.depth}{one.text}{mark}"
