# SPDX-License-Identifier: MIT
"""The names that a program defines or uses itself, and the programs that it can call.

In: a document, the line of the cursor. Out: names of a kind, in the order of the text.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

from nctakt.editor.document import Document
from nctakt.editor.names import Kind, occurrences_in
from nctakt.nc.parse.lexer import without_comments
from nctakt.run.program_loader import search_folders
from nctakt.run.realtime.assembly import AssembledMachine

#: Lines of a program that are searched; a longer one is searched around the cursor.
SEARCHED_LINES = 20_000

_PROGRAMS = (".nc", ".sub", ".cyc", ".cnc")

_MARKS = {"cycle": "#", "label": "", "subprogram": "%", "parameter": "P", "variable": "V"}


def searched_lines(document: Document, line: int) -> range:
    """Return the lines around one that are searched for names."""
    count = len(document.lines)
    first = max(0, min(line - SEARCHED_LINES // 2, count - SEARCHED_LINES))
    return range(first, min(count, first + SEARCHED_LINES))


def names_of(
    document: Document,
    line: int,
    kind: Kind,
    within: range | None = None,
    *,
    any_use: bool = False,
) -> list[str]:
    """Return the names of a kind that the program defines, those of ``line`` itself left out."""
    names: dict[str, None] = {}
    for number in within or searched_lines(document, line):
        text = document.lines[number]
        if number == line or _MARKS[kind] not in text.upper():
            continue
        for item in occurrences_in(text, number, declares="#" not in text):
            if item.symbol.kind == kind and (item.is_definition or any_use):
                names[item.symbol.name] = None
    return list(names)


def values_written(document: Document, line: int, letter: str) -> list[tuple[str, int]]:
    """Return the numbers that a program writes after a letter, and how often, most often first."""
    pattern = re.compile(rf"(?<![\w.$#]){letter}(\d+(?:\.\d+)?)(?![\w.])", re.IGNORECASE)
    counts: Counter[str] = Counter()
    for number in searched_lines(document, line):
        if number != line:
            counts.update(pattern.findall(without_comments(document.lines[number])))
    return sorted(counts.items(), key=lambda item: -item[1])


def programs_to_call(document: Document, machine: AssembledMachine) -> list[str]:
    """Return the names of the programs in the folders in which calls of a program search."""
    own = Path(document.name).name
    names: dict[str, None] = {}
    folders = search_folders(document.name, machine.parameters, machine.configuration.folder)
    for folder in folders:
        if folder.is_dir():
            for path in sorted(folder.iterdir()):
                if path.is_file() and path.suffix.lower() in _PROGRAMS and path.name != own:
                    names[path.name] = None
    return list(names)
