# SPDX-License-Identifier: MIT
"""The program texts of a run as sources of the protocol, and back.

In: the texts of a session by the names that the user gave them. Out: sources with absolute paths;
a text that is no file has a number instead, by which the client asks for it.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Span
from nctakt.base.text import decode_text, split_lines
from nctakt.debugger.arguments import Arguments

#: Files of more bytes are not read to see whether they are still as in the run.
_LONG_BYTES = 4_000_000


class Sources:
    """The texts of a run: file -> its lines."""

    def __init__(self, texts: Mapping[str, Sequence[str]]) -> None:
        self._texts = texts
        self._names = list(texts)
        self._paths = {name: _real_path(name) for name in self._names}
        self._states: dict[str, tuple[int, int] | None] = {}

    def newly_changed(self) -> Iterator[Span]:
        """Yield the first line that differs in each file that has changed since the last look.

        A long file is not read at the first look.
        """
        for name, path in self._paths.items():
            state = _state(path)
            before, self._states[name] = self._states.get(name), state
            if path is None or state is None or state == before:
                continue
            if before is None and state[1] > _LONG_BYTES:
                continue
            try:
                lines = split_lines(decode_text(Path(path).read_bytes()).text)
            except OSError:
                continue
            both = zip_longest(self._texts[name], lines)
            line = next((i for i, (own, now) in enumerate(both, 1) if own != now), 0)
            if line:
                yield Span(name, line, 1, 1)

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
        """Return the name of the text that a client means, ``None`` if it is not in this run."""
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


def _state(path: str | None) -> tuple[int, int] | None:
    """Return time and length of a regular file; ``None`` for anything else, which may never end."""
    try:
        state = None if path is None else Path(path).stat()
    except OSError:
        return None
    if state is None or not stat.S_ISREG(state.st_mode):
        return None
    return state.st_mtime_ns, state.st_size


def _real_path(name: str) -> str | None:
    """Return the absolute path of a file without links, ``None`` where there is no such file."""
    try:
        path = Path(name).resolve()
        return str(path) if path.is_file() else None
    except (OSError, ValueError):
        return None
