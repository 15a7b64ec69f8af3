# SPDX-License-Identifier: MIT
"""Decides whether the check of a statement depends on its shape only.

In: the tree of a shape, and which of its numbers vary. Out: whether all statements of the shape are
valid if one is, and affect no other check: no labels and jumps, no calls, no cycles, no ends.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Binary,
    Block,
    BlockWord,
    Break,
    Call,
    Case,
    Constant,
    Continue,
    Do,
    ElseIf,
    Expression,
    For,
    Head,
    If,
    Number,
    Repeat,
    Statement,
    Switch,
    Unary,
    While,
    Word,
)
from nctakt.nc.vocabulary.functions import ENDS, MIRRORING_OF_AXES
from nctakt.nc.vocabulary.operators import FUNCTIONS

#: Words whose number may be any but 0.
VALUE_WORDS = ("F", "I", "J", "K", "R")

#: Structures that ``$BREAK`` leaves.
_LEFT = (For, While, Do, Repeat, Switch)


class _UndecidedError(Exception):
    """The check needs more than the shape."""


def is_decided_by_shape(statement: Statement, numbers: Container[Span], count: int) -> bool:
    """Return whether the ``count`` varying numbers, at these spans, are all free of checks.

    The statements inside have their own shapes.
    """
    try:
        return sum(number.span in numbers for number in _free(statement, ())) == count
    except _UndecidedError:
        return False


def _free(
    statement: Statement | ElseIf | Case, around: tuple[type[Statement], ...]
) -> Iterator[Number]:
    """Yield the numbers of a statement and of all inside it that may have any value.

    ``around``: the kinds of the enclosing structures, as far as they are known.
    """
    yield from _of_head(statement.head)
    if isinstance(statement, Statement):
        around = (*around, type(statement))
    match statement:
        case Block():
            for word in statement.words:
                yield from _of_word(word)
        case Assignment():
            yield from _of_value(statement.value)
        case If() if not statement.preprocessor:
            yield from _of_condition(statement.condition)
            yield from _inside(statement.body, around)
            yield from _inside(statement.elseifs, around)
            yield from _inside(statement.else_body or (), around)
        case ElseIf() | While() | Do() | Repeat():
            yield from _of_condition(statement.condition)
            yield from _inside(statement.body, around)
        case For():
            for bound in (statement.start, statement.end, statement.step):
                yield from _of_value(bound)
            yield from _inside(statement.body, around)
        case Switch():
            yield from _of_value(statement.subject)
            yield from _inside(statement.cases, around)
        case Case():
            if statement.value is not None:
                yield from _of_value(statement.value)
            yield from _inside(statement.body, around)
        case Break() if any(structure in _LEFT for structure in around):
            pass
        case Continue() if any(
            structure in _LEFT and structure is not Switch for structure in around
        ):
            pass
        case _:
            raise _UndecidedError


def _inside(
    parts: Sequence[Statement | ElseIf | Case], around: tuple[type[Statement], ...]
) -> Iterator[Number]:
    for part in parts:
        yield from _free(part, around)


def _of_head(head: Head) -> Iterator[Number]:
    if head.label is not None:
        raise _UndecidedError
    if head.number is not None:
        yield from _of_value(head.number)


def _of_word(word: BlockWord) -> Iterator[Number]:
    match word:
        case AxisWord():
            if word.value is not None:
                yield from _of_value(word.value)
        case Word(name="M"):
            if not isinstance(word.value, Number) or word.value.value in ENDS:
                raise _UndecidedError
        case Word(name="G", value=Number() as number) if number.value == MIRRORING_OF_AXES:
            raise _UndecidedError
        case Word():
            if word.name in VALUE_WORDS and word.value is not None:
                yield from _of_value(word.value)
        case _:
            raise _UndecidedError


def _of_condition(condition: Expression) -> Iterator[Number]:
    """Yield the free numbers of a condition; a constant one decides whether its body is checked."""
    if isinstance(condition, Number | Constant):
        raise _UndecidedError
    yield from _of_value(condition)


def _of_value(expression: Expression) -> Iterator[Number]:
    """Yield the numbers of an expression, without indices; raises for functions of texts."""
    match expression:
        case Number():
            yield expression
        case Unary():
            yield from _of_value(expression.operand)
        case Binary():
            yield from _of_value(expression.left)
            yield from _of_value(expression.right)
        case Call():
            function = FUNCTIONS.get(expression.function)
            if function is None or function.decoder_only:
                raise _UndecidedError
            for argument in expression.arguments:
                yield from _of_value(argument)
