# SPDX-License-Identifier: MIT
"""Misspelt words that open, divide or close a structure: reported, and taken as intended.

In: the word of a ``$`` line or ``#`` command that is unknown, the known ones. Out: the known one;
without it each later line of the structure would be wrong as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import NOTHING
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.checked_blocks import UNKNOWN_COMMAND
from nctakt.messages.programs.nc_text import UNKNOWN_CONTROL_WORD
from nctakt.nc.parse.expressions import shown
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.parse.structure_stack import StructureStack
from nctakt.nc.tree import Name

#: A second word, as in ``$ELSE IF``; not that of a jump, which has a ``$`` itself.
_SECOND_PART = re.compile(r"\s+(IF|FOR|WHILE|DO|SWITCH)(?!\w)", re.IGNORECASE)
_DIVIDED = ("$ELSE", "$END")
#: Words of other languages.
_OTHER_WORDS = {
    "$ELIF": "$ELSEIF",
    "$FI": "$ENDIF",
    "$NEXT": "$ENDFOR",
    "$WEND": "$ENDWHILE",
    "$ESAC": "$ENDSWITCH",
}
#: Ends of ``#`` structures, without blanks and ``_``.
_OTHER_ENDS = {
    **dict.fromkeys(
        ("ENDRTCYCLE", "RTCYCLEEND", "RTENDCYCLE", "ENDCYCLE", "ENDRT"), ("RT", "CYCLE", "END")
    ),
    "ENDVAR": ("ENDVAR",),
    "VAREND": ("ENDVAR",),
    "ENDCOMMENT": ("COMMENT", "END"),
}


def control_word(
    text: BlockText, start: int, word: str, known: Iterable[str], structures: StructureStack
) -> str:
    """Return the known control word, begun at ``start``, that ``word`` is or is meant for.

    Raises ``BlockError`` for any other word.
    """
    names = tuple(known)
    second = text.looking_at(_SECOND_PART) if word in _DIVIDED else None
    if second is None and word in names:
        return word
    if second is not None:
        text.pos = second.end()
        word += second[1].upper()
    suggestion = _OTHER_WORDS.get(word) or nearest(word, names) or NOTHING
    written = shown(text.text[start : text.pos])
    error = BlockError(UNKNOWN_CONTROL_WORD, start, text.pos, word=written, suggestion=suggestion)
    if suggestion == NOTHING:
        raise error
    structures.block_error(text, error)
    return suggestion


def structure_command(
    text: BlockText,
    words: Sequence[Name],
    known: Iterable[tuple[str, ...]],
    structures: StructureStack,
) -> tuple[Name, ...]:
    """Return the words of a command, with misspelt words of a structure corrected."""
    end = _OTHER_ENDS.get("".join(word.name for word in words).replace("_", ""))
    if end is not None:
        return _meant(text, words, end, structures)
    for meant in known:
        written = words[: len(meant)]
        if nearest(" ".join(word.name for word in written), (" ".join(meant),)):
            return (*_meant(text, written, meant, structures), *words[len(meant) :])
    return tuple(words)


def _meant(
    text: BlockText, written: Sequence[Name], meant: tuple[str, ...], structures: StructureStack
) -> tuple[Name, ...]:
    """Report words of a command; return those that are meant, at the same places."""
    start = text.text.index("#")
    span = replace(text.span(start, start + 1), end_column=written[-1].span.end_column)
    nearest = "#" + " ".join(meant)
    error = BlockError(UNKNOWN_COMMAND, 0, 0, span, word=shown(text.text_of(span)), nearest=nearest)
    structures.block_error(text, error)
    last = len(written) - 1
    return tuple(replace(written[min(n, last)], name=name) for n, name in enumerate(meant))
