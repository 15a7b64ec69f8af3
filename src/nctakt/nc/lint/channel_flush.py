# SPDX-License-Identifier: MIT
"""Commands that empty the channel during tool radius compensation (RC-308, 20651).

In: statements between G41 or G42 and G40. Out: an error for each realtime variable that the decoder
reads or writes, each synchronous variable that it reads, and each ``#FLUSH``. Realtime cycles read
theirs in the tick and are not affected.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import NOTHING
from nctakt.messages.programs.lints import FLUSH_DURING_COMPENSATION
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import (
    Assignment,
    Block,
    BracketCommand,
    CycleControl,
    Do,
    Expression,
    Flush,
    For,
    HashCommand,
    If,
    Keyword,
    Number,
    RealtimeCycle,
    Repeat,
    Statement,
    Switch,
    Time,
    Timer,
    UserMessage,
    Variable,
    VariableBlock,
    While,
    Word,
)
from nctakt.nc.vocabulary.commands import INITS
from nctakt.nc.vocabulary.functions import COMPENSATION_OFF
from nctakt.nc.vocabulary.variables.resolution import indices_of, path_text, resolve, variables_in
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable


class FlushChecker:
    """Reports statements that empty the channel."""

    def __init__(self, names: NameTable, findings: Findings) -> None:
        self._names = names
        self._findings = findings

    def check(self, statement: Statement, active: str) -> None:
        """Check one statement without those inside it; ``active`` is G41 or G42."""
        if _waits(statement):
            command = self._findings.written(statement.span)
            self._findings.report(
                FLUSH_DURING_COMPENSATION,
                statement.span,
                command=command,
                word=active,
                variable=NOTHING,
            )
            return
        if isinstance(statement, Block) and _ends_compensation(statement):
            return
        if isinstance(statement, Assignment) and isinstance(statement.target, Variable):
            # Writing V.E and V.CH goes through the queue like a command.
            if statement.target.family in ("RTG", "RTA") or statement.operator != "=":
                self._access(statement.target, active)
        for expression in _expressions(statement):
            for variable in variables_in(expression):
                self._access(variable, active)

    def _access(self, variable: Variable, active: str) -> None:
        location = resolve(variable, self._names)
        if isinstance(location, Location) and (location.synchronous or variable.synchronous):
            name = path_text(variable)
            self._findings.report(
                FLUSH_DURING_COMPENSATION,
                variable.span,
                command=name,
                word=active,
                variable=name,
            )


def _waits(statement: Statement) -> bool:
    """Return whether the command itself waits until the path has stopped."""
    match statement:
        case Flush():
            return True
        case CycleControl():
            return statement.action == "DELETE"
        case Timer():
            return statement.action == "READ" and bool(statement.options)
        case HashCommand():
            return tuple(word.name for word in statement.words) in INITS
    return False


def _ends_compensation(block: Block) -> bool:
    return any(
        isinstance(word, Word)
        and word.name == "G"
        and isinstance(word.value, Number)
        and word.value.value == COMPENSATION_OFF
        for word in block.words
    )


def _expressions(statement: Statement) -> Iterator[Expression]:
    """Yield the expressions that the decoder evaluates for this statement, without those inside
    it.
    """
    if statement.head.number is not None:
        yield statement.head.number
    match statement:
        case Block():
            for word in statement.words:
                if isinstance(word, BracketCommand):
                    yield from _values(word.items)
                else:
                    yield from (value for value in _word_values(word) if value is not None)
        case Assignment():
            if isinstance(statement.target, Variable):
                yield from indices_of(statement.target)
            else:
                yield statement.target
            yield statement.value
        case VariableBlock():
            yield statement.variable
        case Time():
            yield statement.seconds
        case UserMessage():
            yield from statement.arguments
        case RealtimeCycle() | CycleControl() | Timer():
            yield from _values(statement.keywords)
        case If():
            yield statement.condition
            yield from (branch.condition for branch in statement.elseifs)
        case For():
            yield from (statement.start, statement.end, statement.step)
        case While() | Do() | Repeat():
            yield statement.condition
        case Switch():
            yield statement.subject
            yield from (case.value for case in statement.cases if case.value is not None)


def _word_values(word: object) -> Iterator[Expression | None]:
    if isinstance(word, Word):
        yield from (word.value, word.additional, *word.arguments)
    else:
        yield getattr(word, "value", None)


def _values(items: Sequence[Keyword | Expression]) -> Iterator[Expression]:
    for item in items:
        if not isinstance(item, Keyword):
            yield item
            continue
        if item.value is not None:
            yield item.value
        yield from _values(item.arguments)
