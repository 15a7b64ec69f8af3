# SPDX-License-Identifier: MIT
"""The program texts of a run as sources of the protocol, and back.

In: the texts of a session by the names that the user gave them. Out: sources with absolute paths;
a text that is no file has a number instead, by which the client asks for it.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.debugger.arguments import Arguments


class Sources:
    """The texts of a run: file -> its lines."""

    def __init__(self, texts: Mapping[str, Sequence[str]]) -> None:
        self._texts = texts
        self._names = list(texts)
        self._paths = {name: _real_path(name) for name in self._names}

    @property
    def all(self) -> list[dict[str, Any]]:
        """All sources."""
        return [self.source(name) for name in self._names]

    def lines(self, name: str) -> Sequence[str]:
        """Return the lines of a text, none of an unknown one."""
        return self._texts.get(name, ())

    def line(self, name: str, number: int) -> str:
        """Return a line of a text without the blanks around it; empty outside."""
        lines = self.lines(name)
        return lines[number - 1].strip() if 0 < number <= len(lines) else ""

    def source(self, name: str) -> dict[str, Any]:
        """Return the source of a text."""
        path = self._paths.get(name) or _real_path(name)
        if path is not None:
            return {"name": Path(path).name, "path": path}
        number = self._names.index(name) + 1 if name in self._texts else 0
        return {"name": name, "sourceReference": number}

    def name_of(self, source: Arguments) -> str | None:
        """Return the name of the text that a client means, ``None`` for none of this run."""
        number = source.number("sourceReference", 0)
        if 0 < number <= len(self._names):
            return self._names[number - 1]
        asked = source.optional_text("path") or source.optional_text("name")
        if not asked:
            return None
        if asked in self._texts:
            return asked
        real = _real_path(asked)
        if real is None:
            return None
        for name, path in self._paths.items():
            if path is not None and os.path.normcase(path) == os.path.normcase(real):
                return name
        return None


def _real_path(name: str) -> str | None:
    """Return the absolute path of a file without links, ``None`` where there is no such file."""
    try:
        path = Path(name).resolve()
        return str(path) if path.is_file() else None
    except (OSError, ValueError):
        return None
