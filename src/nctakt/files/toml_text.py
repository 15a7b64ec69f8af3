# SPDX-License-Identifier: MIT
"""TOML that users write -> its tables; for a text that is not TOML the place of the mistake."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from nctakt.base.diagnostics import Span, whole_file

_POSITION = re.compile(r" ?\(at line (\d+), column (\d+)\)")


class TomlError(Exception):
    """A text that is not TOML: the reason, its place, and the line there."""

    def __init__(self, file: str, text: str, reason: str) -> None:
        super().__init__(_POSITION.sub("", reason))
        found, lines = _POSITION.search(reason), text.splitlines()
        self.span, self.line = whole_file(file), ""
        if found is not None and int(found[1]) <= len(lines):
            number, column = int(found[1]), int(found[2])
            self.span, self.line = Span(file, number, column, column + 1), lines[number - 1]


def read_toml(file: str, text: str) -> dict[str, Any]:
    """Return the tables of a text; raises ``TomlError``."""
    import tomllib  # noqa: PLC0415 - most commands read no TOML

    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # not TOML; an impossible date; too deep
        raise TomlError(file, text, str(error)) from error


def entry_place(file: str, text: str, keys: Sequence[str]) -> tuple[Span, str]:
    """Return where an entry is written, by its table and keys, and its line.

    What is not found by its key is where its table is, else the whole file.
    """
    lines = text.splitlines()
    span, shown, begin = whole_file(file), "", 0
    for key in keys:
        entry = re.compile(rf"""(?:^|[\s\[.,{{])(?P<key>["']?{re.escape(key)}["']?)\s*[=\].]""")
        for number in range(begin, len(lines)):
            found = entry.search(lines[number])
            if found is not None:
                begin, shown = number, lines[number]
                span = Span(file, number + 1, found.start("key") + 1, found.end("key") + 1)
                break
    return span, shown
