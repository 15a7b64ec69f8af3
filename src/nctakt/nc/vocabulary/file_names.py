# SPDX-License-Identifier: MIT
"""The files that ``#FILE NAME`` names: that of saved messages, the programs of M6, G80 … G839.

``#FILE NAME [MSG="report.txt" M6="change.nc" G80="drill.nc"]``; the equals sign may be left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.nc.tree import Expression, Keyword, Name, Number, StringLiteral
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.function_rows import Form
from nctakt.nc.vocabulary.functions import TOOL_CHANGE

#: The file of saved messages.
MESSAGES = "MSG"
#: The program of the tool change.
CHANGE = f"M{TOOL_CHANGE}"
#: Names that a message lists as possible.
NAMED_FILES = (MESSAGES, CHANGE, "G80 … G89", "G800 … G839")

#: The named program, the file, and the node where it begins.
NamedFile = tuple[str, Expression | None, Keyword | Expression]


def is_file_name(words: Sequence[str]) -> bool:
    """Return whether these words are ``#FILE NAME`` or ``#FILENAME``."""
    return tuple(words) in (("FILENAME",), ("FILE", "NAME"))


def program_key(letter: str, number: float) -> str:
    """Return the name that ``#FILE NAME`` uses for the program of a G or M function."""
    return f"{letter}{number:g}"


def names_program(key: str) -> bool:
    """Return whether a program belongs to this word: M6, or a G function that calls one."""
    if key == CHANGE:
        return True
    row = support_level.g_function(float(key[1:])) if _is_function(key) else None
    return row is not None and row.form is Form.SUBPROGRAM


def named_files(items: Sequence[Keyword | Expression]) -> Iterator[NamedFile]:
    """Yield each named program with its file; ``None`` without a file."""
    waiting: NamedFile | None = None
    for item in items:
        if waiting is not None:
            if isinstance(item, StringLiteral):
                yield waiting[0], item, waiting[2]
                waiting = None
                continue
            yield waiting
        waiting = None
        if isinstance(item, Name):
            waiting = item.name, None, item
        elif not isinstance(item, Keyword):
            yield "", None, item
        elif item.name in ("G", "M") and isinstance(item.value, Number):
            waiting = program_key(item.name, item.value.value), None, item
        elif item.value is None:
            waiting = item.name, None, item
        else:
            yield item.name, item.value, item
    if waiting is not None:
        yield waiting


def _is_function(key: str) -> bool:
    return key[:1] == "G" and key[1:].isdigit()
