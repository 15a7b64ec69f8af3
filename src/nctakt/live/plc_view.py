# SPDX-License-Identifier: MIT
"""A file of the session's PLC as shown on the page: lines, colours, values next to them.

In: the lines of the file, where statements begin, stops, values. Out: plain values that the page
hands to its elements. Nothing here knows a browser, a thread or a clock.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import PurePath

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.session.statements import PlcPlace, names_file
from nctakt.st.files.shown_text import ShownLine, shown_lines
from nctakt.st.parse.colouring import TOKEN, kind_of_word

#: Maximum number of values next to a line, and of their characters.
_MAX_VALUES, _MAX_CHARACTERS = 6, 100

#: A path named in a line: members, elements by number or name, the target of a pointer.
_PATH = re.compile(r"[^\W\d]\w*(?:\.\w+|\[[\w, .-]*\]|\^)*")
#: Text after the name of a called object; in brackets, also that of an argument.
_FOLLOWING = re.compile(r"\s*(\(|=>|:=)")
_STOP = re.compile(r"statement (?:(?P<file>.*):)?(?P<line>\d+)\b", re.IGNORECASE)

#: A row of the page: its number, 0 for a heading, and its text in parts with classes.
Row = tuple[int, list[tuple[str, str]]]


@dataclass(frozen=True, slots=True)
class WordPlace:
    """Where a word begins in its file: a line, from 1, a column in units of UTF-16, from 0."""

    line: int
    column: int


#: Where a token is in its row, and its class.
_Token = tuple[int, int, str]


class PlcText:
    """One file of a PLC; ``statements``: the lines of the file in which statements begin."""

    def __init__(
        self, file: str, lines: Sequence[str], statements: Sequence[int], language: Language
    ) -> None:
        self.file = file
        self._language: Language = language
        self._lines = shown_lines(file, lines)
        self._file_lines = lines
        self._statements = statements
        self._indices = {one.line: index for index, one in enumerate(self._lines) if one.line}
        self._tokens, self._paths, self._words = _read(self._lines)

    def rows(self) -> list[Row]:
        """Return the rows of the page."""
        return [
            (0, [(one.heading.get(self._language), "")])
            if one.heading is not None
            else (one.number, _parts(one.text, tokens))
            for one, tokens in zip(self._lines, self._tokens, strict=True)
        ]

    def index_of(self, line: int) -> int:
        """Return the row of a line of the file, -1 if it is not shown."""
        return self._indices.get(line, -1)

    def statement_at(self, index: int) -> int:
        """Return the line of the file of the first statement from a row on, 0 without one."""
        if not 0 <= index < len(self._lines):
            return 0
        line = next((one.line for one in self._lines[index:] if one.line), 0)
        return next((one for one in self._statements if one >= line > 0), 0)

    def text_at(self, index: int) -> int:
        """Return the number of the text that a row is of, in the order of the file."""
        begun = sum(one.heading is not None for one in self._lines[: index + 1])
        return max(0, begun - 1)

    def named(self, first: int, last: int) -> list[tuple[int, tuple[str, ...]]]:
        """Return the lines of the file in some rows that name something, with their paths."""
        rows = range(max(first, 0), min(last + 1, len(self._lines)))
        found = []
        for index in rows:
            paths = tuple(path for path, is_called in self._paths[index].items() if not is_called)
            if paths and self._lines[index].line:
                found.append((self._lines[index].line, paths))
        return found

    def named_at(self, index: int) -> tuple[int, tuple[str, ...]]:
        """Return the line of the file in a row and all paths named in it, including calls."""
        if not 0 <= index < len(self._lines):
            return 0, ()
        return self._lines[index].line, tuple(self._paths[index])

    def words_at(self, index: int, column: int | None) -> list[WordPlace]:
        """Return the names in a row as places of the file: at a column, or without one all.

        A column counts in units of UTF-16, as browsers do.
        """
        if not 0 <= index < len(self._lines) or not self._lines[index].line:
            return []
        one = self._lines[index]
        line = self._file_lines[one.line - 1]
        prefix = line[: one.column - 1]
        if not line[len(prefix) :].startswith(one.text):
            return []  # written with entities: the columns are others
        return [
            WordPlace(one.line, _units(prefix + one.text[:start]))
            for start, end in self._words[index]
            if column is None or _units(one.text[:start]) <= column < _units(one.text[:end])
        ]

    def beside(
        self, named: Sequence[tuple[int, Sequence[str]]], values: Sequence[Sequence[str]]
    ) -> dict[int, str]:
        """Return the texts next to rows: the variables named in each line, with their values."""
        found = {}
        for (line, paths), texts in zip(named, values, strict=True):
            pairs = [f"{path} = {text}" for path, text in zip(paths, texts, strict=True) if text]
            joined = " · ".join(pairs[:_MAX_VALUES])
            if len(joined) > _MAX_CHARACTERS:
                joined = joined[: _MAX_CHARACTERS - 1] + "…"
            if joined:
                found[self.index_of(line)] = joined
        return found

    def marks(self, halt: PlcPlace | None, stops: Sequence[str]) -> dict[int, list[str]]:
        """Return the classes of rows: position of the session, its open calls, stops."""
        found: dict[int, list[str]] = {}
        for level, frame in enumerate(() if halt is None else halt.frames):
            if frame.span is not None and frame.span.file == self.file:
                name = "nc-fault" if level == 0 and halt and halt.fault else "nc-block"
                row = found.setdefault(self.index_of(frame.span.line), [])
                row.append(name if level == 0 else "nc-caller")
        for line in statement_stops(stops, self.file):
            found.setdefault(self.index_of(line), []).append("nc-stopped")
        return {row: classes for row, classes in found.items() if row >= 0}


def statement_stops(stops: Sequence[str], file: str) -> list[int]:
    """Return the lines of a file at whose statements stops are."""
    matches = (_STOP.match(stop) for stop in stops)
    return [
        int(match["line"])
        for match in matches
        if match is not None and (match["file"] is None or names_file(match["file"], file))
    ]


def statement_stop(file: str, line: int) -> str:
    """Return the stop before the statement of a line."""
    return f"statement {file}:{line}"


def file_names(files: Sequence[str]) -> dict[str, str]:
    """Return names that distinguish the files: file names, or paths if these agree."""
    names = [PurePath(one).name for one in files]
    return {
        file: name if names.count(name) == 1 else file
        for file, name in zip(files, names, strict=True)
    }


def places_in(text: str, files: Mapping[str, Sequence[str]]) -> list[tuple[str, int]]:
    """Return the places in files of the PLC that a text names as ``file:line``, each once."""
    found: dict[tuple[str, int], None] = {}
    for match in re.finditer(r"([^\s(),;:\"']+):(\d+)", text):
        for file in files:
            if names_file(match[1], file):
                found[file, int(match[2])] = None
                break
    return list(found)


def _units(text: str) -> int:
    """Return how many units of UTF-16 a text has."""
    return len(text) + sum(one > "\uffff" for one in text)


def _parts(text: str, tokens: Sequence[_Token]) -> list[tuple[str, str]]:
    """Return a line in parts, each with its class; "" for a part without colour."""
    found, end = [], 0
    for start, last, name in tokens:
        if start > end:
            found.append((text[end:start], ""))
        found.append((text[start:last], name))
        end = last
    if end < len(text):
        found.append((text[end:], ""))
    return found


def _read(
    lines: Sequence[ShownLine],
) -> tuple[list[list[_Token]], list[dict[str, bool]], list[list[tuple[int, int]]]]:
    """Return of lines the tokens, the paths with whether they are only called, and the names."""
    text = "\n".join(one.text for one in lines)
    begins = [0]
    for one in lines:
        begins.append(begins[-1] + len(one.text) + 1)
    tokens: list[list[_Token]] = [[] for _ in lines]
    names: list[dict[str, bool]] = [{} for _ in lines]
    words: list[list[tuple[int, int]]] = [[] for _ in lines]
    row = end_of_path = depth = end = 0
    is_type = False
    for match in TOKEN.finditer(text):
        depth += text.count("(", end, match.start()) - text.count(")", end, match.start())
        end = match.end()
        while begins[row + 1] <= match.start():
            row += 1
        kind = match.lastgroup or ""
        if kind == "word":
            kind = kind_of_word(match[0])
            is_type = (is_type or match[0].upper() == "TYPE") and match[0].upper() != "END_TYPE"
            if not kind:
                words[row].append((match.start() - begins[row], end - begins[row]))
            if not kind and not is_type and match.start() >= end_of_path:
                path = _PATH.match(text, match.start())
                assert path is not None
                end_of_path = path.end()
                follows = _FOLLOWING.match(text, end_of_path)
                if follows is None or (follows[1] == ":=" and depth <= 0):
                    names[row][path[0]] = False
                elif follows[1] == "(":
                    names[row].setdefault(path[0], True)
        if kind:
            _add(tokens, begins, row, match.start(), match.end(), kind)
    return tokens, names, words


def _add(
    tokens: list[list[_Token]], begins: Sequence[int], row: int, start: int, end: int, kind: str
) -> None:
    """Add a token to its rows."""
    while start < end:
        last = min(end, begins[row + 1] - 1)
        if last > start:
            tokens[row].append((start - begins[row], last - begins[row], f"nc-t-{kind}"))
        start, row = begins[row + 1], row + 1
