# SPDX-License-Identifier: MIT
r"""The lines between ``#VAR`` and ``#ENDVAR`` -> declarations.

In: a block's text after its head. Out: ``V.L.NAME[3] : STRING[20] = value`` as a node. An initial
value in brackets may continue in the next lines, with or without ``\`` at their ends.
"""

from __future__ import annotations

import re

from nctakt.messages.programs.nc_text import NAME_EXPECTED, ONLY_DECLARATIONS_IN_VAR
from nctakt.nc.parse.expressions import (
    EQUALS,
    OPENING,
    expected,
    parse_expression,
    parse_list,
    parse_target,
    parse_variable,
    unreadable,
)
from nctakt.nc.parse.lexer import BlockError, BlockText, Lexer
from nctakt.nc.tree import PARAMETER_ARRAYS, Declaration, Expression, Head, Variable
from nctakt.nc.vocabulary.variables.resolution import as_array

_QUOTED = re.compile(r'"[^"]*"?')
_COLON = re.compile(r"\s*:")
_TYPE = re.compile(r"\s*([^\W\d]\w*)")


def whole_declaration(text: BlockText, lexer: Lexer) -> BlockText:
    """Return the text extended by the lines that its open brackets need."""
    while _is_open(text.text):
        longer = lexer.extend(text)
        if longer is None:
            return text
        longer.pos = text.pos
        text = longer
    return text


def _is_open(content: str) -> bool:
    without_texts = _QUOTED.sub("", content)
    return without_texts.count("[") > without_texts.count("]")


def parse_declaration(text: BlockText, head: Head) -> Declaration:
    """Return one declaration; raises ``BlockError`` 900116 for anything else."""
    start = text.skip_blanks()
    variable = parse_variable(text) or _parameter(text)
    if variable is None:
        raise _no_declaration(text)
    type_name: str | None = None
    size: Expression | None = None
    initial: Expression | None = None
    is_typed = variable.family != PARAMETER_ARRAYS
    if is_typed and text.match(_COLON) is not None:
        match = text.match(_TYPE)
        if match is None:
            raise expected(text, NAME_EXPECTED)
        type_name = match[1].upper()
        if text.looking_at(OPENING) is not None:
            size = parse_list(text)[0].node
    if text.match(EQUALS) is not None:
        initial = parse_expression(text)
    span = text.span(start, text.pos)
    if not text.at_end():
        raise unreadable(text)
    return Declaration(span, head, variable, type_name, size, initial)


def _parameter(text: BlockText) -> Variable | None:
    """Return ``P10`` or ``P10[3]`` as an array with these dimensions, ``None`` for another text."""
    target = parse_target(text)
    found = None if target is None else as_array(target)
    return found if isinstance(found, Variable) else None


def _no_declaration(text: BlockText) -> BlockError:
    start = text.pos
    end = start + len(text.text[start:].split("\n", 1)[0].rstrip())
    return BlockError(ONLY_DECLARATIONS_IN_VAR, start, max(end, start + 1))
