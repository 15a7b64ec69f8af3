# SPDX-License-Identifier: MIT
"""The branches of a realtime cycle as a list, with their nesting (RC-201, RC-203).

In: the tree of a program. Out: its realtime cycles, and for each of them its branches in the order
of the text, with the enclosing branch and the earlier ones of the same ``$IF``. The span identifies
a branch in the realtime part.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.nc import tree
from nctakt.nc.parse.printer import print_statement

BranchWord = Literal["$IF", "$ELSEIF", "$ELSE"]


@dataclass(frozen=True, slots=True)
class BranchOutline:
    """One branch; ``outer`` and ``earlier`` are positions in the list of the cycle's branches.

    ``frequency``: ``ONCE``, ``EDGE``, ``ALWAYS`` or empty; ``condition``: ``None`` for ``$ELSE``.
    ``lines``: those of the branch itself and of the statements directly in its body; ``commands``:
    the texts of those statements.
    """

    span: Span
    word: BranchWord
    frequency: str
    condition: tree.Expression | None
    outer: int | None
    earlier: tuple[int, ...]
    lines: tuple[int, ...]
    commands: tuple[str, ...]


def branch_outlines(statement: tree.RealtimeCycle) -> list[BranchOutline]:
    """Return the branches of a cycle in the order of the text."""
    outlines: list[BranchOutline] = []
    _walk(statement.body, None, outlines)
    return outlines


def combined(condition: tree.Expression) -> list[tree.Expression]:
    """Return the conditions combined by ``&&`` and ``||``, or the condition itself."""
    if isinstance(condition, tree.Binary) and condition.operator in ("&&", "||"):
        return [*combined(condition.left), *combined(condition.right)]
    return [condition]


def accesses_in(expression: tree.Expression) -> Iterator[tree.Variable | tree.Parameter]:
    """Yield the variables and parameters in an expression, including those in indices."""
    match expression:
        case tree.Variable():
            yield expression
            for part in expression.parts:
                for index in part.indices:
                    yield from accesses_in(index)
        case tree.Parameter():
            yield expression
            yield from accesses_in(expression.index)
        case tree.Unary():
            yield from accesses_in(expression.operand)
        case tree.Binary():
            yield from accesses_in(expression.left)
            yield from accesses_in(expression.right)
        case tree.Call():
            for argument in expression.arguments:
                yield from accesses_in(argument)


def lines_without_branch(statement: tree.RealtimeCycle) -> list[int]:
    """Return the lines of the definition and of its statements outside of any branch."""
    return [statement.span.line, *_own_lines(statement.body)]


def _own_lines(body: Sequence[tree.Statement]) -> list[int]:
    return [statement.span.line for statement in body if not isinstance(statement, tree.If)]


def _commands(body: Sequence[tree.Statement]) -> tuple[str, ...]:
    """Return the statements directly in a body as text, without block numbers."""
    bare = (
        replace(statement, head=tree.NO_HEAD)
        for statement in body
        if not isinstance(statement, tree.If)
    )
    return tuple(
        " ".join(line.strip() for line in print_statement(statement)) for statement in bare
    )


def _walk(body: Sequence[tree.Statement], outer: int | None, outlines: list[BranchOutline]) -> None:
    for statement in body:
        if isinstance(statement, tree.If):
            _branches(statement, outer, outlines)


def _branches(statement: tree.If, outer: int | None, outlines: list[BranchOutline]) -> None:
    """Append the branches of one ``$IF`` and of its bodies."""
    earlier: list[int] = []

    def add(
        span: Span,
        word: BranchWord,
        condition: tree.Expression | None,
        body: Sequence[tree.Statement],
    ) -> None:
        frequency = (statement.frequency or "") if word == "$IF" else ""
        lines = (span.line, *_own_lines(body))
        position = len(outlines)
        outlines.append(
            BranchOutline(
                span, word, frequency, condition, outer, tuple(earlier), lines, _commands(body)
            )
        )
        earlier.append(position)
        _walk(body, position, outlines)

    add(statement.span, "$IF", statement.condition, statement.body)
    for elseif in statement.elseifs:
        add(elseif.span, "$ELSEIF", elseif.condition, elseif.body)
    if statement.else_body is not None and statement.else_span is not None:
        add(statement.else_span, "$ELSE", None, statement.else_body)


def realtime_cycles(statements: Sequence[tree.Statement]) -> Iterator[tree.RealtimeCycle]:
    """Yield the definitions of realtime cycles in statements and in structures among them."""
    for statement in statements:
        match statement:
            case tree.RealtimeCycle():
                yield statement
            case tree.If():
                yield from realtime_cycles(statement.body)
                for elseif in statement.elseifs:
                    yield from realtime_cycles(elseif.body)
                yield from realtime_cycles(statement.else_body or ())
            case tree.For() | tree.While() | tree.Do() | tree.Repeat():
                yield from realtime_cycles(statement.body)
            case tree.Switch():
                for case in statement.cases:
                    yield from realtime_cycles(case.body)
