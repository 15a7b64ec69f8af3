# SPDX-License-Identifier: MIT
"""A program without private parts: no comments, no texts, neutral names for its own.

In: the lines of programs, the names of their files, the names of axes and spindles. Out: lines of
the same numbers that run alike. Numbers, words, commands and the controller's variables stay;
anything not known to be one of these gets a neutral name, the same everywhere.
"""

from __future__ import annotations

import importlib
import pkgutil
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import PureWindowsPath

from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import Collector
from nctakt.nc import vocabulary
from nctakt.nc.parse.controls import CONTROL_WORDS
from nctakt.nc.parse.lexer import Lexer
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.message_formats import conversions
from nctakt.nc.vocabulary.variables.realtime_variables import AXIS_VARIABLES, CHANNEL_VARIABLES
from nctakt.nc.vocabulary.variables.system_variables import known_paths

#: Words that are in no table of the vocabulary.
_FURTHER = (*CONTROL_WORDS, "ENDVAR", "HLI", "RT", "SYN")
#: Families whose names are those of the user.
_OWN_FAMILIES = frozenset(("E", "CH", "P", "L", "S", "CYC"))
_WORD = re.compile(r"[A-Za-z_]\w*")
_PART = re.compile(
    r"""
    "(?P<string>[^"]*)"?
  | (?P<start>^\s*%\s*(?:L\s+)?)(?P<program>\S.*)
  | (?P<call>\bLL?\s+)(?!CYCLE\b)(?P<called>[A-Za-z_][^\s\[=]*)
  | (?P<named>\bNAME\s*=\s*)(?P<cycle>[A-Za-z_][^\s\],"]*)
  | (?P<label>(?:^\s*(?:/\d*\s*)?(?:N\s*\d+\s*)?|\$GOTO\s*)\[\s*)(?P<labelled>[A-Za-z_]\w*)(?=\s*\])
  | (?P<family>(?<![^\W\d_][^\W\d_])Vs?\.\s*[A-Za-z]+)(?P<path>(?:\.\w+)*)
  | (?P<member>\.[^\W\d]\w*)
  | (?P<word>\#?\$?[^\W\d]\w*)
    """,
    re.IGNORECASE | re.VERBOSE,
)
#: Words of a block written without blanks: ``G01X100F6000``.
_GLUED = re.compile(r"(?:[A-Z]\d+)*(?:[A-Z]\d*)", re.IGNORECASE)


class NeutralNames:
    """Gives names; ``programs``: file of a program -> its neutral name; ``kept``: axes, spindles.

    >>> names = NeutralNames({"shaft.nc": "part1.nc"}, ["X", "Y"])
    >>> names.lines(["G01 X5 F100 (for Miller)", 'V.E.MILLER = 1 #MSG ["at %d", 7]'])
    ['G01 X5 F100', 'V.E.NAME1 = 1 #MSG ["%d", 7]']
    """

    def __init__(self, programs: Mapping[str, str], kept: Iterable[str]) -> None:
        self._programs = {
            PureWindowsPath(name).name.casefold(): new for name, new in programs.items()
        }
        self._known = _vocabulary() | {name.upper() for name in kept}
        self._given: dict[str, str] = {}

    @property
    def count(self) -> int:
        """How many names were replaced."""
        return len(self._given)

    def name(self, text: str) -> str:
        """Return the neutral name of a name of the user."""
        return self._given.setdefault(text, f"NAME{len(self._given) + 1}")

    def file(self, text: str) -> str:
        """Return the neutral name of a file: that of a program, else a name."""
        file_name = PureWindowsPath(text).name.casefold()
        for name, new in self._programs.items():
            if file_name in (name, name.rpartition(".")[0]):
                return new
        return self.name(text.upper())

    def lines(self, lines: Sequence[str]) -> list[str]:
        """Return the lines of a program; the numbers of its lines stay."""
        found = [""] * len(lines)
        for block in Lexer(Source("", lines), Collector()).blocks():
            text = " ".join(block.text.split())
            found[block.line_number - 1] = self.text(text)
        while found and not found[-1]:
            found.pop()
        return found

    def text(self, text: str) -> str:
        """Return a block, an expression or the name of a signal."""
        macro = re.fullmatch(r'((?:N\s*\d+\s*)?)"([^"]*)"\s*=\s*"((?:[^"\\]|\\.)*)"\s*', text)
        if macro is not None:
            content = self.text(macro[3].replace('\\"', '"')).replace('"', '\\"')
            return f'{macro[1]}"{self.name(macro[2].upper())}" = "{content}"'
        is_message = re.search(r"#\s*MSG\b", text, re.IGNORECASE) is not None
        return _PART.sub(lambda match: self._part(match, is_message=is_message), text)

    def _part(self, match: re.Match[str], *, is_message: bool) -> str:
        kind = match.lastgroup
        if kind == "string":
            return f'"{self._string(match["string"], is_message=is_message)}"'
        if kind == "program":
            return match["start"] + self.file(match["program"].strip())
        if kind == "called":
            return match["call"] + self.file(match["called"])
        if kind == "cycle":
            return match["named"] + self.file(match["cycle"])
        if kind == "labelled":
            return match["label"] + self.name(match["labelled"].upper())
        if kind == "path":
            return match["family"] + self._path(match["family"], match["path"])
        if kind == "member":
            own = match["member"][1:]
            is_own = own in self._given or own.upper() not in self._known
            return f".{self.name(own)}" if is_own else match["member"]
        return self._word(match["word"])

    def _path(self, family: str, path: str) -> str:
        if family.rpartition(".")[2].strip().upper() in _OWN_FAMILIES:
            return re.sub(r"\w+", lambda part: self.name(part[0]), path)
        return re.sub(
            r"[^\W\d]\w*",
            lambda part: part[0] if part[0].upper() in self._known else self.name(part[0]),
            path,
        )

    def _string(self, text: str, *, is_message: bool) -> str:
        if is_message:
            return " ".join(one.text for one in conversions(text))
        return self.file(text) if text else text

    def _word(self, word: str) -> str:
        plain = word.lstrip("#$").upper()
        if plain in self._known or _GLUED.fullmatch(plain):
            return word
        return word[: len(word) - len(plain)] + self.name(plain)


@cache
def _vocabulary() -> frozenset[str]:
    """Return all words of the language and of its variables, in upper case."""
    paths = [row.path for row in (*AXIS_VARIABLES, *CHANNEL_VARIABLES)]
    texts = [*_FURTHER, *SCALARS, *known_paths((), ()), *paths]
    for module in pkgutil.walk_packages(vocabulary.__path__, f"{vocabulary.__name__}."):
        for value in vars(importlib.import_module(module.name)).values():
            texts += _strings(value)
    return frozenset(word.upper() for text in texts for word in _WORD.findall(text))


def _strings(value: object) -> Iterator[str]:
    """Yield the texts in upper case of a table."""
    if isinstance(value, str):
        if value.isupper():
            yield value
    elif isinstance(value, tuple | frozenset | Mapping):
        for one in value:
            yield from _strings(one)
        if isinstance(value, Mapping):
            yield from _strings(tuple(value.values()))
