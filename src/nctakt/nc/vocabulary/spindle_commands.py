# SPDX-License-Identifier: MIT
"""Commands to spindles in a block: words of the main spindle, and ``S2[M3 REV=1000]`` (RC-404).

In: the words of a block. Out: one ``SpindleCommand`` for all words of the main spindle and one for
each bracket, and the remaining words. Shared by checker and decoder.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.nc.tree import (
    AxisWord,
    BlockWord,
    BracketCommand,
    Expression,
    Keyword,
    Number,
    Word,
)
from nctakt.nc.vocabulary.functions import NO_SPINDLE_OVERRIDE, SPINDLE_FUNCTIONS

_SPEED = ("S", "REV")
_POSITION = ("S.POS", "POS")
#: A spindle takes its axis, or gives it away.
CALLAX, PUTAX = "CALLAX", "PUTAX"


@dataclass(slots=True)
class SpindleCommand:
    """The part of a block for one spindle; ``name`` is empty for the main spindle.

    ``doubled``: duplicate words; ``wrong``: words that a spindle command cannot have. ``override``:
    the factor of ``S[OVERRIDE SPEED_FACT=50]`` in per cent, which has no other words.
    ``ignores_override``: ``S[G167]``. ``exchanges``: ``CALLAX``, ``PUTAX``.
    """

    name: str
    span: Span
    functions: list[int]
    speed: Expression | None
    position: Expression | None
    doubled: list[Word | Keyword]
    wrong: list[BlockWord | Keyword | Expression]
    override: Keyword | None = None
    ignores_override: bool = False
    exchanges: list[str] = field(default_factory=list)


def split(
    words: Sequence[BlockWord], spindles: Sequence[str]
) -> tuple[list[SpindleCommand], list[BlockWord]]:
    """Return the spindle commands among the words of a block, and the other words."""
    commands: list[SpindleCommand] = []
    others: list[BlockWord] = []
    main: SpindleCommand | None = None
    for word in words:
        if isinstance(word, AxisWord):
            others.append(word)
        elif isinstance(word, BracketCommand) and word.name in spindles:
            commands.append(_bracket(word))
        elif isinstance(word, Word) and _is_main(word):
            if main is None:
                main = SpindleCommand("", word.span, [], None, None, [], [])
                commands.append(main)
            _add(main, word)
        else:
            others.append(word)
    return commands, others


def _is_main(word: Word) -> bool:
    """Return whether a word is for the main spindle."""
    return word.name in ("S", "S.POS") or (word.name == "M" and _function(word) is not None)


def _function(word: Word | Keyword) -> int | None:
    """Return the number of a spindle function, ``None`` for any other word."""
    value = word.value
    if isinstance(value, Number) and value.value in SPINDLE_FUNCTIONS:
        return int(value.value)
    return None


def _is_without_override(word: Word | Keyword) -> bool:
    """Return whether a word is G167."""
    value = word.value
    return word.name == "G" and isinstance(value, Number) and value.value == NO_SPINDLE_OVERRIDE


def _bracket(command: BracketCommand) -> SpindleCommand:
    parsed = SpindleCommand(command.name, command.span, [], None, None, [], [])
    match command.items:
        case [Keyword(name="OVERRIDE", value=None), Keyword(name="SPEED_FACT") as factor]:
            if factor.value is not None and not factor.arguments:
                parsed.override = factor
                return parsed
    for item in command.items:
        if isinstance(item, Keyword):
            _add(parsed, item)
        else:
            parsed.wrong.append(item)
    return parsed


def _add(command: SpindleCommand, word: Word | Keyword) -> None:
    """Add a word to a command."""
    function = _function(word) if word.name == "M" else None
    if word.arguments or (isinstance(word, Word) and word.additional is not None):
        command.wrong.append(word)
    elif function is not None:
        if function in command.functions:
            command.doubled.append(word)
        else:
            command.functions.append(function)
    elif _is_without_override(word):
        if command.ignores_override:
            command.doubled.append(word)
        command.ignores_override = True
    elif word.value is None and word.name in (CALLAX, PUTAX):
        command.exchanges.append(word.name)
    elif word.value is None or word.name not in (*_SPEED, *_POSITION):
        command.wrong.append(word)
    elif word.name in _SPEED:
        if command.speed is not None:
            command.doubled.append(word)
        command.speed = word.value
    else:
        if command.position is not None:
            command.doubled.append(word)
        command.position = word.value
