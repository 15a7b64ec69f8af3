# SPDX-License-Identifier: MIT
"""Blocks that only the run shows: numbers of functions that are computed, texts of macros.

In: a block. Out: the block with its numbers, and statements checked like any others. ``M[P1]``
counts as the function whose number is the present value of P1.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import replace
from functools import partial

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.tools import Fail
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.programs.checked_blocks import INVALID_FUNCTION_NUMBER
from nctakt.nc import tree

#: Words whose number determines their effect.
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
    *,
    is_main: bool = False,
    named_programs: Iterable[str] = (),
) -> None:
    """Check statements that are at ``span``; the first mistake gives the program up."""
    mistake = environment.first_mistake(statements, span, line, is_main, named_programs)
    if mistake is not None:
        fail(mistake.message, span, **mistake.values)


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
    environment = values.environment
    line = partial(environment.line_text, block.span)
    named = values.state.named_programs
    check(
        environment, values.fail, [meant], block.span, line, is_main=is_main, named_programs=named
    )
    return meant
