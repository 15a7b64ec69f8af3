# SPDX-License-Identifier: MIT
"""The kinds of values that run options have, each with its forms.

A value is checked as Python gives it, read from the words of a command line and from data (JSON,
TOML, comments), and kept on a tape. Wrong data raise ``UnfitDataError``, and the reader adds their
place; everything else raises ``Failure``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeVar

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import INVALID_SKIP_OPTION, OPTION_REPEATED
from nctakt.nc.parse.block_head import SKIP_LEVELS
from nctakt.run.access.stimuli import (
    Stimulus,
    assignment_text,
    parse_assignment,
    parse_stimulus,
    read_stimulus,
)

_Value = TypeVar("_Value")


def _same(text: str) -> Text:
    """Return a text that is the same in both languages."""
    return Text(text, text)


_NUMBER_OR_TEXT = Text("a number or a text", "eine Zahl oder ein Text")
_PAIRS = _same('[["20 ms", "V.E.X=1"], …]')


class UnfitDataError(Exception):
    """Data that are not of an option's kind; ``path``: the part, below the option's name."""

    def __init__(self, expected: Text, path: str = "") -> None:
        super().__init__(expected.en)
        self.expected = expected
        self.path = path


class Kind:
    """A kind of value; this one accepts everything, for Python objects."""

    #: How help and messages name the value.
    metavar = ""

    def check(self, name: str, value: Any) -> None:
        """Check a value that Python gives; raises ``Failure``."""

    def from_words(self, words: Any) -> Any:
        """Return the value of the words of a command line; raises ``Failure``."""
        return words

    def from_data(self, value: Any) -> Any:
        """Return the value of data; raises ``UnfitDataError`` and ``Failure``."""
        return value

    def to_words(self, value: Any) -> Any:
        """Return the words for a value, as a tape keeps them."""
        return value

    def has_form_of_words(self, words: Any) -> bool:
        """Return whether data of a tape may be the words of this kind."""
        return True


@dataclass(frozen=True, slots=True)
class Whole(Kind):
    """A whole number from ``minimum`` on, or none; ``checked_from``: from where Python has it."""

    minimum: int = 1
    checked_from: int = 1
    metavar = "N"

    def check(self, name: str, value: Any) -> None:
        if value is not None:
            arguments.whole_number(name, value, self.checked_from)

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, int) or isinstance(value, bool) or abs(value) >= 1 << 53:
            raise UnfitDataError(Text("a whole number", "eine ganze Zahl"))
        return value or None

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, int | None) and not isinstance(words, bool)


class Flag(Kind):
    """Yes or no."""

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, bool):
            raise UnfitDataError(Text("true or false", "true oder false"))
        return value

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, bool)


@dataclass(frozen=True, slots=True)
class Words(Kind):
    """A text: the name of a file or a folder, or one of ``choices`` if there are any."""

    metavar: str = "TEXT"
    choices: tuple[str, ...] = ()

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, str):
            raise UnfitDataError(Text("a text", "ein Text"))
        if self.choices and value not in self.choices:
            raise UnfitDataError(_same(", ".join(self.choices)))
        return value

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, str | None)


class Folders(Kind):
    """Names of folders; the option may be repeated."""

    metavar = "FOLDER"

    def has_form_of_words(self, words: Any) -> bool:
        return _is_list_of(words, str)


@dataclass(frozen=True, slots=True)
class Moment(Kind):
    """A time with a unit; ``is_optional``: it may be missing."""

    is_optional: bool = False
    metavar = "TIME"

    def from_words(self, words: Any) -> Any:
        return None if words is None else read_time(words)

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, str):
            raise UnfitDataError(Text("a text", "ein Text"))
        return read_time(value)

    def to_words(self, value: Any) -> Any:
        return None if value is None else str(read_time(value))

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, str) or (self.is_optional and words is None)


class Assignments(Kind):
    """Values of variables by name."""

    metavar = "NAME=VALUE"

    def check(self, name: str, value: Any) -> None:
        if value is not None:
            arguments.mapping(name, value)

    def from_words(self, words: Sequence[str]) -> dict[str, float | str]:
        return by_name("--set", _each(words, parse_assignment))

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, dict):
            raise UnfitDataError(Text("an object", "ein Objekt"))
        for name, one in value.items():
            if not isinstance(one, str | int | float):
                raise UnfitDataError(_NUMBER_OR_TEXT, f".{name}")
        return {name: one if isinstance(one, str) else float(one) for name, one in value.items()}

    def to_words(self, value: Any) -> Any:
        return [assignment_text(*one) for one in (value or {}).items()]

    def has_form_of_words(self, words: Any) -> bool:
        return _is_list_of(words, str)


class Stimuli(Kind):
    """Values of variables at times of the run."""

    metavar = "TIME NAME=VALUE"

    def check(self, name: str, value: Any) -> None:
        arguments.collection(name, value)

    def from_words(self, words: Sequence[tuple[str, str]]) -> tuple[Stimulus, ...]:
        return tuple(_each(words, lambda pair: parse_stimulus(*pair)))

    def from_data(self, value: Any) -> Any:
        if not isinstance(value, list):
            raise UnfitDataError(Text("a list", "eine Liste"))
        for item in value:
            if not (_is_list_of(item, str) and len(item) == 2):
                raise UnfitDataError(_PAIRS)
        return [parse_stimulus(*item) for item in value]

    def to_words(self, value: Any) -> Any:
        stimuli = [read_stimulus(one) for one in value]
        return [[str(one.time), assignment_text(one.name, one.value)] for one in stimuli]


class SkipLevels(Kind):
    """Skip levels of blocks, 1 … 10."""

    metavar = "N,..."

    def check(self, name: str, value: Any) -> None:
        arguments.collection(name, value)
        for level in value:
            arguments.whole_number(name, level)

    def from_words(self, words: str) -> tuple[int, ...]:
        levels = [word.strip() for word in words.split(",") if word.strip()]
        wrong = [one for one in levels if not one.isdecimal() or not 1 <= int(one) <= SKIP_LEVELS]
        if wrong:
            raise Failure(diagnostic(INVALID_SKIP_OPTION, found=wrong[0], maximum=SKIP_LEVELS))
        return tuple(int(one) for one in levels)

    def from_data(self, value: Any) -> Any:
        is_list = isinstance(value, list)
        if not is_list or not all(type(one) is int and 1 <= one <= SKIP_LEVELS for one in value):
            raise UnfitDataError(_same(f"[1, …, {SKIP_LEVELS}]"))
        return tuple(value)

    def to_words(self, value: Any) -> Any:
        return ",".join(map(str, value))

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, str)


class Names(Kind):
    """Names, separated by commas; commas in brackets belong to a name."""

    metavar = "NAME,..."

    def check(self, name: str, value: Any) -> None:
        if value is not None:
            arguments.collection(name, value)

    def from_words(self, words: str | None) -> tuple[str, ...] | None:
        return None if words is None else split_names(words)

    def from_data(self, value: Any) -> Any:
        if not _is_list_of(value, str):
            raise UnfitDataError(Text("a list of texts", "eine Liste von Texten"))
        return tuple(value)


@dataclass(frozen=True, slots=True)
class Instance(Kind):
    """A Python object that has ``attribute``, or none."""

    attribute: str
    expected: Text

    def check(self, name: str, value: Any) -> None:
        if value is not None and not hasattr(value, self.attribute):
            arguments.refuse(name, value, self.expected)


class Instances(Instance):
    """One such object or several; the option may be repeated."""

    def check(self, name: str, value: Any) -> None:
        for one in value if isinstance(value, list | tuple) else [value]:
            super().check(name, one)


class Callback(Kind):
    """A Python function, or none."""

    def check(self, name: str, value: Any) -> None:
        arguments.function(name, value)


class Objects(Kind):
    """A collection of objects of Python."""

    def check(self, name: str, value: Any) -> None:
        arguments.collection(name, value)


class Programs(Kind):
    """The names of programs."""

    metavar = "PROGRAM"

    def has_form_of_words(self, words: Any) -> bool:
        return _is_list_of(words, str)


class ChannelPrograms(Kind):
    """Pairs of a channel's number and a program; the option may be repeated."""

    metavar = "N PROGRAM"

    def has_form_of_words(self, words: Any) -> bool:
        return isinstance(words, list) and all(
            _is_list_of(one, str) and len(one) == 2 for one in words
        )


#: No time, the default of options that add one.
NO_TIME = Time(0)


def split_names(text: str) -> tuple[str, ...]:
    """Return the names in a list separated by commas; commas in brackets belong to names."""
    names = [""]
    depth = 0
    for character in text:
        depth += (character == "[") - (character == "]")
        if character == "," and depth <= 0:
            names.append("")
        else:
            names[-1] += character
    return tuple(name.strip() for name in names if name.strip())


def by_name(option: str, pairs: Iterable[tuple[str, _Value]]) -> dict[str, _Value]:
    """Return a repeated option's values, by name; raises ``Failure`` for a second value (902953).

    A name may be empty: then the option says it of all others.
    """
    values: dict[str, _Value] = {}
    for name, value in pairs:
        if name in values:
            raise Failure(diagnostic(OPTION_REPEATED, option=f"{option} {name}".rstrip()))
        values[name] = value
    return values


def _is_list_of(value: object, kind: type) -> bool:
    return isinstance(value, list) and all(isinstance(one, kind) for one in value)


def _each(items: Sequence[Any], function: Any) -> list[Any]:
    """Return a function's result for each item; raises one ``Failure`` with all mistakes."""
    values: list[Any] = []
    found: list[Diagnostic] = []
    for item in items:
        try:
            values.append(function(item))
        except Failure as failure:
            found += failure.diagnostics
    if found:
        raise Failure(*found)
    return values
