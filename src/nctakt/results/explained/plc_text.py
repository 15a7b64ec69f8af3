# SPDX-License-Identifier: MIT
"""Why a PLC in Structured Text has given variables their values, as text.

In: histories of variables. Out: lines: the variable; each change with its statement; below it what
led to it, from the task's program on, each condition with the values that it compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Span, Text
from nctakt.results.explained.plc_histories import Fact, PlcChange, PlcHistory
from nctakt.results.explained.why_words import Words

_HEADLINE = Text("PLC: {path}", "SPS: {path}")
_BEGAN = Text("began as {value}", "zu Beginn {value}")
_OLDER = Text("{count} older changes are left out", "{count} ältere Änderungen fehlen hier")
_MISSED = Text(
    "{count} changes are missing: their ticks had too many",
    "{count} Änderungen fehlen: In ihren Takten waren es zu viele",
)
_CHANGED = Text(
    "{before} -> {value} at {tick}: {statement}", "{before} -> {value} in {tick}: {statement}"
)
_FIRST = Text(
    "{value} at {tick}, written first: {statement}",
    "{value} in {tick}, zum ersten Mal geschrieben: {statement}",
)
_OUTSIDE = Text(
    "{before} -> {value} at {tick}, not by a statement: by the CNC, an input or a copy of bytes",
    "{before} -> {value} in {tick}, nicht durch eine Anweisung: durch CNC, Eingabe oder Kopie von "
    "Bytes",
)
_VALUE = Text("is {value}", "ist {value}")
_NEVER = Text("has not changed up to here", "hat sich bis hierher nicht geändert")
_WRITTEN = Text("written last at {tick}: {statement}", "zuletzt geschrieben in {tick}: {statement}")
_CUT = Text("further conditions are not kept", "weitere Bedingungen sind nicht aufgezeichnet")
_CALLED = Text("called in {statement}", "aufgerufen in {statement}")
_SAW = Text("{text} was {value}", "{text} war {value}")
_FROM = Text("{text} was {value}, since", "{text} war {value}, denn")
_HOLDS = {"TRUE": Text("true", "wahr"), "FALSE": Text("false", "falsch")}
_RETURNED = Text("the call returned from {statement}", "der Aufruf ergab es in {statement}")


def render_plc(histories: Sequence[PlcHistory], words: Words) -> str:
    """Return the histories as text."""
    found: list[str] = []
    writer = _Writer(words)
    for one in histories:
        found += ["", words.get(_HEADLINE, path=one.path)]
        found += [f"  {line}" for line in writer.history(one)]
    return "".join(f"{line}\n" for line in found)


def render_plc_at(histories: Sequence[PlcHistory], tick: int, words: Words) -> str:
    """Return why variables had their values in a tick."""
    found: list[str] = []
    writer = _Writer(words)
    for one in histories:
        found += ["", words.get(_HEADLINE, path=one.path)]
        found += [f"  {line}" for line in writer.state(one, tick)]
    return "".join(f"{line}\n" for line in found)


class _Writer:
    def __init__(self, words: Words) -> None:
        self._words = words

    def history(self, one: PlcHistory) -> Iterator[str]:
        words = self._words
        if one.begin:
            yield words.get(_BEGAN, value=one.begin)
        if one.left_out:
            yield words.get(_OLDER, count=one.left_out)
        if one.missed:
            yield words.get(_MISSED, count=one.missed)
        for change in one.changes:
            yield from self.change(change)
        yield from self._last(one)

    def state(self, one: PlcHistory, tick: int) -> Iterator[str]:
        """Yield why a variable had its value in a tick."""
        words, change = self._words, one.change_at(tick)
        if one.missed:  # the change that gave the value may be among them
            yield words.get(_MISSED, count=one.missed)
        elif change is not None:
            yield words.get(_VALUE, value=change.value)
            yield from self.change(change)
        elif one.left_out:
            yield words.get(_OLDER, count=one.left_out)
        elif one.begin:
            yield words.get(_VALUE, value=one.begin)
            yield words.get(_NEVER)
        if one.written is not None and one.written <= tick:
            yield from self._last(one)

    def _last(self, one: PlcHistory) -> Iterator[str]:
        last = one.changes[-1] if one.changes else None
        if one.written is not None and (last is None or one.written != last.tick):
            statement, tick = (
                _located(one.writer, one.writer_statement),
                self._words.tick(one.written),
            )
            yield self._words.get(_WRITTEN, tick=tick, statement=statement)

    def change(self, change: PlcChange) -> Iterator[str]:
        """Yield a change and what led to it."""
        words, tick = self._words, self._words.tick(change.tick)
        if change.span is None:
            yield words.get(_OUTSIDE, before=change.before, value=change.value, tick=tick)
            return
        statement = _located(change.span, change.statement)
        yield words.get(
            _CHANGED if change.before else _FIRST,
            before=change.before,
            value=change.value,
            tick=tick,
            statement=statement,
        )
        yield from self.facts(change.facts, "  ")
        if change.is_cut:
            yield f"  {words.get(_CUT)}"

    def facts(self, facts: Sequence[Fact], indent: str) -> Iterator[str]:
        """Yield what led to a change; operands come below their condition."""
        words = self._words
        waiting: list[Fact] = []
        for fact in facts:
            if fact.kind in ("operand",) or fact.inside:
                waiting.append(fact)
                continue
            if fact.kind == "call":
                yield f"{indent}{words.get(_CALLED, statement=_located(fact.span, fact.text))}"
            elif fact.kind == "result":
                yield from self._operands(waiting, indent)
                statement = _located(fact.span, fact.text)
                yield f"{indent}{words.get(_RETURNED, statement=statement)}"
                waiting = []
            else:
                truth = _HOLDS.get(fact.value) if fact.kind == "condition" else None
                shown = fact.value if truth is None else words.get(truth)
                yield f"{indent}{_located(fact.span, fact.text)}: {shown}"
                yield from self._operands(waiting, f"{indent}  ")
                waiting = []
        yield from self._operands(waiting, indent)

    def _operands(self, facts: Sequence[Fact], indent: str) -> Iterator[str]:
        for number, fact in enumerate(facts):
            if fact.kind == "call":
                continue
            calls = [one for one in facts[:number] if one.inside] if number else []
            call = calls[-1] if calls and facts[number - 1] is calls[-1] else None
            form = _SAW if call is None else _FROM
            yield f"{indent}{self._words.get(form, text=fact.text, value=fact.value)}"
            if call is not None:
                yield from self.facts(call.inside, f"{indent}  ")


def _located(span: Span | None, text: str) -> str:
    """Return file, line and text of a statement."""
    return text if span is None else f"{span.file}:{span.line} {text}".rstrip()
