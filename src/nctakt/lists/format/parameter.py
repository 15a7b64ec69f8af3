# SPDX-License-Identifier: MIT
"""The declaration of a parameter: once, for reading, checking, explaining and documenting it.

In: what the manuals' parameter tables say. Out: ``Parameter`` records, gathered per kind of list
in a ``Schema``, which finds them by their name.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches

from nctakt.base.diagnostics import Message, Text
from nctakt.lists.format.reader import ListDialect

#: A value of a parameter: flag sets are tuples of names, ``None`` is the default of a parameter
#: for which the manuals print none.
Value = bool | int | float | str | tuple[str, ...] | None

MAX_UNS16 = 2**16 - 1
MAX_UNS32 = 2**32 - 1

_INDEX_RANGE = re.compile(r"\[([0-9]+)\.\.([0-9]+)\]")


class ValueType(enum.Enum):
    """The type of a parameter's value; integers carry the bounds of their type."""

    BOOLEAN = "BOOLEAN"
    SGN08 = "SGN08"
    UNS08 = "UNS08"
    SGN16 = "SGN16"
    UNS16 = "UNS16"
    SGN32 = "SGN32"
    UNS32 = "UNS32"
    REAL64 = "REAL64"
    STRING = "STRING"
    NAME = "NAME"
    FLAGS = "FLAGS"


class Effect(enum.Enum):
    """What nctakt does with a parameter's value.

    Whoever makes a parameter effective sets ``TAKEN`` in its declaration: nothing else says so.
    """

    #: It changes what a run does, or what the machine consists of.
    TAKEN = "taken"
    #: It is read and checked, and changes nothing in a run.
    CHECKED = "checked"
    #: Any value is accepted, none is looked at.
    ACCEPTED = "accepted"


_BITS = {"08": 8, "16": 16, "32": 32}


def integer_bounds(type_: ValueType) -> tuple[int, int]:
    """The least and the greatest value of an integer type."""
    bits = _BITS[type_.value[3:]]
    if type_.value.startswith("U"):
        return 0, 2**bits - 1
    return -(2 ** (bits - 1)), 2 ** (bits - 1) - 1


@dataclass(frozen=True, slots=True)
class Alias:
    """An old name of a parameter; ``silent``: it is still as good as the present one."""

    path: str
    silent: bool = False


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of a list.

    ``id`` is the manuals' ID, empty where no source gives one. ``path`` is the name with the
    ranges of its indices: ``thread[0..6].function[0..6].name``. ``low`` and ``high`` are inclusive,
    ``None`` stands for the bound of the type; for a STRING ``high`` is the greatest length.
    ``names`` are the values of a NAME or the flags of a FLAGS parameter with their numbers, where
    a number is known. ``restart``: a change counts from the next start of the controller.
    ``effect``: what nctakt does with it.
    ``invalid`` replaces a defective value where that is not the default, and ``invalid_message``
    reports it.
    """

    id: str
    path: str
    type: ValueType
    default: Value
    text: Text
    low: int | float | None = None
    high: int | float | None = None
    unit: str = ""
    names: Mapping[str, int | None] = field(default_factory=dict)
    aliases: tuple[Alias, ...] = ()
    restart: bool = False
    effect: Effect = Effect.TAKEN
    invalid: Value = None
    invalid_message: Message | None = None

    @property
    def pattern(self) -> str:
        """The name with empty brackets, as entries carry it."""
        return pattern_of(self.path)

    @property
    def index_ranges(self) -> tuple[tuple[int, int], ...]:
        """Lowest and highest value of each index."""
        return tuple((int(low), int(high)) for low, high in _INDEX_RANGE.findall(self.path))

    @property
    def bounds(self) -> tuple[int | float, int | float]:
        """The range that a number has to keep, both ends included."""
        if self.type is ValueType.REAL64:
            least: int | float = float("-inf")
            greatest: int | float = float("inf")
        else:
            least, greatest = integer_bounds(self.type)
        low = least if self.low is None else self.low
        return low, greatest if self.high is None else self.high


def pattern_of(path: str) -> str:
    """``thread[0..6].name`` -> ``thread[].name``."""
    return _INDEX_RANGE.sub("[]", path)


def with_indices(pattern: str, indices: tuple[int, ...]) -> str:
    """``thread[].name`` and ``(3,)`` -> ``thread[3].name``."""
    for index in indices:
        pattern = pattern.replace("[]", f"[{index}]", 1)
    return pattern


def shown(value: Value) -> str:
    """A value as a list would write it; ``–`` where there is none."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, tuple):
        return " | ".join(value)
    return str(value) if value != "" else '""'


@dataclass(frozen=True, slots=True)
class ForeignName:
    """A name that users look for in the wrong list: where it belongs, under which ID."""

    pattern: str
    kind: str
    id: str


@dataclass(frozen=True, slots=True)
class Schema:
    """All parameters of one kind of list.

    ``kind`` is its short name (``channel``), ``title`` what it holds.
    """

    kind: str
    title: Text
    dialect: ListDialect
    parameters: tuple[Parameter, ...]
    foreign: tuple[ForeignName, ...] = ()
    _by_pattern: dict[str, tuple[Parameter, Alias | None]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        for parameter in self.parameters:
            self._add(parameter.pattern, parameter, None)
            for alias in parameter.aliases:
                self._add(pattern_of(alias.path), parameter, alias)

    def _add(self, pattern: str, parameter: Parameter, alias: Alias | None) -> None:
        assert pattern not in self._by_pattern, pattern
        assert pattern.count("[]") == len(parameter.index_ranges), pattern
        self._by_pattern[pattern] = (parameter, alias)

    def find(self, pattern: str) -> tuple[Parameter, Alias | None] | None:
        """The parameter of that name, and the alias if the name is an old one."""
        return self._by_pattern.get(pattern)

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """The parameters with that ID: some IDs stand for several names."""
        return tuple(found for found in self.parameters if found.id == parameter_id)

    def nearest(self, pattern: str) -> str | None:
        """The known name that is most like an unknown one, if any is."""
        close = get_close_matches(pattern, self._by_pattern, n=1)
        return close[0] if close else None
