# SPDX-License-Identifier: MIT
"""Reads entries of a plan and reports their mistakes, each with its line."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from nctakt.base.diagnostics import NOTHING, Diagnostic, Message, Span, Text, whole_file
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.files.access import is_file_or_folder
from nctakt.lists.format.times import Time, read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import (
    INVALID_PLAN_VALUE,
    PLAN_ENTRY_MISSING,
    UNKNOWN_PLAN_ENTRY,
)
from nctakt.run.options import refused

_ENTRY = re.compile(r"""\s*(?:\[|[\w.-]+\s*=|(?:"[^"]*"|'[^']*')\s*=)""")
_HEADER = re.compile(r"\s*\[+\s*([\w.]+)\s*\]+")
NUMBER = Text("a number", "eine Zahl")
NUMBER_OR_TEXT = Text("a number or a text", "eine Zahl oder ein Text")
WHOLE = Text("a whole number", "eine ganze Zahl")
TRUTH = Text("true or false", "true oder false")
TEXT = Text("a text", "ein Text")
TABLE = Text("a table", "eine Tabelle")
LIST = Text("a list", "eine Liste")
THE_PLAN = Text("the plan", "dem Plan")
NAME = Text("a name in one line", "ein Name in einer Zeile")
FILE = Text("an existing file or folder", "eine vorhandene Datei oder ein vorhandener Ordner")
LENGTH = Text("a time above 0", "eine Zeit über 0")

#: Seeds and counts beyond this are mistakes: no file has as many rows.
LARGEST = 1 << 62
COUNT = Text(f"a whole number from 1 to {LARGEST}", f"eine ganze Zahl von 1 bis {LARGEST}")
SEED = Text(f"a whole number from 0 to {LARGEST}", f"eine ganze Zahl von 0 bis {LARGEST}")

_T = TypeVar("_T")


def is_number(value: object) -> bool:
    """Return whether a value is a finite number, and not a truth value."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) <= LARGEST if isinstance(value, int) else math.isfinite(value)


def is_name(text: str) -> bool:
    """Return whether a text can be a name: not empty, in one line."""
    return bool(text.strip()) and text.isprintable()


def is_value(value: object) -> bool:
    """Return whether a value can be that of a variable: a finite number, or a text."""
    return isinstance(value, str) or is_number(value)


def one_of(names: Sequence[str]) -> Text:
    """Return the words for a value that must be one of these names."""
    words = ", ".join(names)
    return Text(f"one of {words}", f"eins von {words}") if words else Text("a name", "ein Name")


class PlanReader:
    """Reads the entries of one plan; ``folder``: where the paths in it begin.

    ``file`` and ``lines``: where it is, for messages. ``diagnostics``: its mistakes.
    """

    def __init__(self, folder: Path, file: str = "", lines: Sequence[str] = ()) -> None:
        self.folder = folder
        self._file = file
        self._lines = lines
        self.diagnostics: list[Diagnostic] = []

    def location(self, key: str, table: str, number: int) -> tuple[Span | None, str]:
        """Return the place of an entry of the ``number``-th table of a name."""
        if not self._file:
            return None, ""
        header, count = "", -1
        entry = re.compile(rf"""\s*["']?{re.escape(key)}["']?\s*=""")
        inline = re.compile(
            rf"""\s*{re.escape(table)}\s*[.=](?:.*[\s"'{{,.])??(?P<key>{re.escape(key)})["']?\s*="""
        )
        fallback: tuple[Span | None, str] = (whole_file(self._file), "")
        for line_number, line in enumerate(self._lines, 1):
            match = _HEADER.match(line)
            if match is not None and "=" not in line:
                header = match[1]
                count += header == table
                if header == table and count == number:
                    fallback = Span(self._file, line_number, 1, len(line) + 1), line
                continue
            if header == table and (not table or count == number) and entry.match(line):
                begin = len(line) - len(line.lstrip()) + 1
                return Span(self._file, line_number, begin, begin + len(key)), line
            found = inline.match(line) if table and not header else None
            if found is not None:
                begin, end = found.span("key")
                return Span(self._file, line_number, begin + 1, end + 1), line
        return fallback

    def location_of_text(self, text: str, key: str, table: str) -> tuple[Span | None, str]:
        """Return the place of a text in the value of an entry, else that of the entry."""
        found = self.location(key, table, 0)
        first = 0 if found[0] is None else found[0].line
        for number, line in enumerate(self._lines[first - 1 :] if first else (), first):
            if number > first and _ENTRY.match(line):
                break
            begin = line.find(text)
            if begin >= 0:
                return Span(self._file, number, begin + 1, begin + len(text) + 1), line
        return found

    def report(self, found: Diagnostic, location: tuple[Span | None, str]) -> None:
        """Note a mistake at a place."""
        span, line = location
        self.diagnostics.append(replace(found, span=span, source_line=line) if span else found)

    def wrong(
        self, key: str, value: object, expected: Text, table: str = "", number: int = 0
    ) -> None:
        """Note that an entry has a value of another kind (901302)."""
        message: Message = INVALID_PLAN_VALUE
        found = diagnostic(message, key=key, value=_shown(value), expected=expected)
        self.report(found, self.location(key, table, number))

    def missing(self, key: str, shown: str | Text, number: int = 0, table: str = "") -> None:
        """Note that an entry is missing (901303); ``shown``: the table, as the message has it."""
        found = diagnostic(PLAN_ENTRY_MISSING, key=key, table=shown)
        self.report(found, self.location(key, table, number))

    def check_keys(
        self, table: dict[str, Any], names: Sequence[str], header: str, number: int
    ) -> None:
        """Note each entry that is unknown (901301)."""
        for key in table:
            if key not in names:
                near = nearest(key, names) or NOTHING
                found = (None if header else refused(key, "plan")) or diagnostic(
                    UNKNOWN_PLAN_ENTRY, key=key, nearest=near, names=", ".join(names)
                )
                self.report(found, self.location(key, header, number))

    def tried(
        self, key: str, table: str, number: int, function: Callable[..., _T], *words: object
    ) -> _T | None:
        """Return the result of a function; ``None`` after a ``Failure``, which is noted."""
        return self._noted(lambda: self.location(key, table, number), function, *words)

    def read(
        self, text: str, key: str, table: str, function: Callable[..., _T], *words: object
    ) -> _T | None:
        """Return a function's result for a text, ``None`` after a ``Failure``, as ``tried``."""
        return self._noted(lambda: self.location_of_text(text, key, table), function, *words)

    def _noted(
        self,
        location: Callable[[], tuple[Span | None, str]],
        function: Callable[..., _T],
        *words: object,
    ) -> _T | None:
        try:
            return function(*words)
        except Failure as failure:
            for found in failure.diagnostics:
                self.report(found, location())
            return None

    # --- entries ---------------------------------------------------------------------------------

    def text(
        self, table: dict[str, Any], key: str, default: str, header: str = "", number: int = 0
    ) -> str:
        """Return a text."""
        value = table.get(key, default)
        if isinstance(value, str):
            return value
        self.wrong(key, value, TEXT, header, number)
        return default

    def choice(self, table: dict[str, Any], key: str, names: Sequence[_T]) -> _T:
        """Return one of these words, by default the first."""
        value = table.get(key, names[0])
        if isinstance(value, str) and value in names:
            return names[names.index(value)]
        self.wrong(key, value, one_of([str(name) for name in names]))
        return names[0]

    def truth(self, table: dict[str, Any], key: str, header: str, number: int) -> bool:
        """Return true or false; false without an entry."""
        value = table.get(key, False)
        if not isinstance(value, bool):
            self.wrong(key, value, TRUTH, header, number)
        return value is True

    def whole(
        self,
        table: dict[str, Any],
        key: str,
        default: int,
        low: int = 1,
        header: str = "",
        number: int = 0,
    ) -> int:
        """Return a whole number from ``low`` on."""
        value = table.get(key, default)
        is_default = key not in table
        is_whole = isinstance(value, int) and not isinstance(value, bool)
        if not is_whole or not (is_default or low <= value <= LARGEST):
            self.wrong(key, value, COUNT if low else SEED, header, number)
            return default
        return int(value)

    def value(self, table: dict[str, Any], key: str, header: str, number: int) -> float | str:
        """Return a number or a text, 0 without an entry."""
        value = table.get(key, 0.0)
        if not is_value(value):
            self.wrong(key, value, NUMBER_OR_TEXT, header, number)
            return 0.0
        found: float | str = value
        return found

    def number(self, table: dict[str, Any], key: str, header: str, number: int) -> float:
        """Return a number, 0 without an entry."""
        value = table.get(key, 0.0)
        if not is_number(value):
            self.wrong(key, value, NUMBER, header, number)
            return 0.0
        return float(value)

    def time(
        self, table: dict[str, Any], key: str, header: str = "", number: int = 0
    ) -> Time | None:
        """Return a time, ``None`` without an entry."""
        if key not in table:
            return None
        return self.tried(key, header, number, read_time, table[key])

    def length(
        self, table: dict[str, Any], key: str, header: str = "", number: int = 0
    ) -> Time | None:
        """Return a time above 0, ``None`` without an entry."""
        time = self.time(table, key, header, number)
        if time is not None and time.count == 0:
            self.wrong(key, table[key], LENGTH, header, number)
        return time

    def tables(self, entries: Any, key: str) -> list[dict[str, Any]]:
        """Return a table or a list of tables as a list."""
        entries = [entries] if isinstance(entries, dict) else entries
        if isinstance(entries, list | tuple) and all(isinstance(one, dict) for one in entries):
            return list(entries)
        tables = f"[[{key}]]"
        words = Text(f"a list of tables ({tables})", f"eine Liste von Tabellen ({tables})")
        self.wrong(key, entries, words)
        return []

    def existing(self, value: object, key: str, header: str = "", number: int = 0) -> Path | None:
        """Return the path of an existing file or folder, ``None`` after a mistake."""
        if not isinstance(value, str | Path) or not str(value):
            self.wrong(key, value, TEXT, header, number)
            return None
        path = self.folder / value
        if not is_file_or_folder(path):
            self.wrong(key, str(value), FILE, header, number)
            return None
        return path


def _shown(value: object) -> str:
    """Return a value as a message shows it, not longer than a line has room for."""
    shown = repr(value)
    return shown if len(shown) <= 60 else f"{shown[:57]}…"
