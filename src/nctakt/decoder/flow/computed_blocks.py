# SPDX-License-Identifier: MIT
"""Blocks that only the run shows: numbers of functions that are computed, texts of macros.

In: a block. Out: the block with its numbers, and statements checked as any others are. ``M[P1]``
counts as the function whose number P1 gives in this moment.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import overload

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.commands import Answer, Command
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.tools import Fail
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages import Collector
from nctakt.messages.checked_blocks import INVALID_FUNCTION_NUMBER
from nctakt.nc import tree
from nctakt.nc.check.checker import Checker, Role
from nctakt.nc.source import Source

#: Words whose number tells what they do.
NUMBERED = ("G", "H", "M")


def is_literal(block: tree.Block) -> bool:
    """Whether a block has neither computed numbers nor macros."""
    for word in block.words:
        if isinstance(word, tree.AxisWord):
            continue
        if isinstance(word, tree.StringWord):
            return False
        if isinstance(word, tree.Word) and word.name in NUMBERED:
            if not isinstance(word.value, tree.Number):
                return False
    return True


def check(
    environment: DecoderEnvironment,
    fail: Fail,
    statements: Sequence[tree.Statement],
    span: Span,
    line: Callable[[], str],
    role: Role = "either",
    named_programs: Iterable[str] = (),
) -> None:
    """Check statements that stand at ``span``; the first mistake gives the program up.

    ``line`` gives the text that they were read from, where a message shows a part of it.
    ``named_programs``: the words whose program ``#FILE NAME`` has named.
    """
    collector = Collector()
    source = Source(span.file, _OneLine(span.line, line))
    checker = Checker(source, environment.names, environment.parameters, collector, named_programs)
    checker.begin(role)
    for statement in statements:
        checker.statement(statement)
    errors = [
        diagnostic for diagnostic in collector.diagnostics if diagnostic.severity.name == "ERROR"
    ]
    if errors:
        fail(errors[0].message, span, **errors[0].values)


def with_computed_numbers(
    values: Values, block: tree.Block, number: int
) -> Generator[Command, Answer, tree.Block]:
    """The block with the numbers that its functions have now."""
    words: list[tree.BlockWord] = []
    for word in block.words:
        if isinstance(word, tree.Word) and word.name in NUMBERED and word.value is not None:
            value = yield from values.evaluate(word.value, number)
            whole = arithmetic.round_half_even(value)
            if whole < 0.0:
                values.fail(INVALID_FUNCTION_NUMBER, word.span, word=f"{word.name}{whole:.0f}")
            words.append(replace(word, value=tree.Number(word.value.span, whole)))
        else:
            words.append(word)
    meant = replace(block, words=tuple(words))
    is_main = len(values.state.call_stack.frames) == 1
    role: Role = "main" if is_main else "either"
    environment = values.environment
    line = partial(environment.line_text, block.span)
    named = values.state.named_programs
    check(environment, values.fail, [meant], block.span, line, role, named)
    return meant


class _OneLine(Sequence[str]):
    """A text of which only the line of this number matters, the last one."""

    def __init__(self, number: int, line: Callable[[], str]) -> None:
        self._number = number
        self._line = line

    def __len__(self) -> int:
        return self._number

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[str]: ...

    def __getitem__(self, index: int | slice) -> str | Sequence[str]:
        if isinstance(index, slice):
            return [self[position] for position in range(*index.indices(self._number))]
        return self._line() if index == self._number - 1 else ""
