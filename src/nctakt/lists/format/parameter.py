# SPDX-License-Identifier: MIT
"""The declaration of a parameter: once, for reading, checking, explaining and documenting it.

In: the manuals' parameter tables. Out: ``Parameter`` records; ``Schema`` gathers those of one kind
of list.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message, Text

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
    SGN64 = "SGN64"
    UNS64 = "UNS64"
    REAL64 = "REAL64"
    STRING = "STRING"
    NAME = "NAME"
    FLAGS = "FLAGS"

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers."""
        return self.value.startswith(("UNS", "SGN", "REAL"))

    @property
    def is_signed(self) -> bool:
        """Whether its numbers may be negative."""
        return self.value.startswith(("SGN", "REAL"))


class Effect(enum.Enum):
    """The effect of a parameter's value in nctakt."""

    #: It changes a run, the machine, or the reports.
    USED = "used"
    #: It is read and checked, and changes nothing in a run.
    WITHOUT_EFFECT = "without effect"


class Relevance(enum.Enum):
    """Whether a value other than the default would change positions, times or program flow."""

    YES = "yes"
    MAYBE = "maybe"
    NO = "no"


_BITS = {"08": 8, "16": 16, "32": 32, "64": 64}


@cache
def integer_bounds(type_: ValueType) -> tuple[int, int]:
    """Return the minimum and the maximum of an integer type."""
    bits = _BITS[type_.value[3:]]
    if type_.value.startswith("U"):
        return 0, 2**bits - 1
    return -(2 ** (bits - 1)), 2 ** (bits - 1) - 1


@dataclass(frozen=True, slots=True)
class Alias:
    """An old name of a parameter; ``silent``: it is as valid as the present name.

    ``id``: the manuals' ID of the old name, if it has one.
    """

    path: str
    silent: bool = False
    id: str = ""


@dataclass(frozen=True, slots=True)
class Limit:
    """Another parameter of the same list as a bound: ``2*P-AXIS-00008``, at the same indices.

    ``is_exclusive``: the bound itself lies outside the range.
    """

    id: str
    factor: float = 1.0
    is_exclusive: bool = False


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of a list.

    ``id`` is the manuals' ID, empty where no source gives one. ``path`` is the name with the ranges
    of its indices: ``thread[0..6].function[0..6].name``. ``low`` and ``high`` are inclusive,
    ``None`` means the bound of the type; for a STRING ``high`` is the greatest length. The numbers
    ``also`` are allowed outside this range, ``excluded`` are not allowed within it; ``at_least``
    and ``at_most`` are bounds that other parameters set. ``names`` are the values of a NAME or the
    flags of a FLAGS parameter with their numbers, where a number is known; ``has_more_names``: the
    sources do not list all of them. ``default_id``: the parameter whose value is the default.
    ``restart``: a change counts from the next start of the controller. ``relevance`` matters where
    ``effect`` is ``WITHOUT_EFFECT``. ``concern``: its subject, ``page``: the number of its page in
    the public help. ``invalid`` replaces a defective value where that is not the default, and
    ``invalid_message`` reports it.
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
    effect: Effect = Effect.USED
    invalid: Value = None
    invalid_message: Message | None = None
    also: tuple[float, ...] = ()
    excluded: tuple[float, ...] = ()
    at_least: Limit | None = None
    at_most: Limit | None = None
    has_more_names: bool = False
    default_id: str = ""
    relevance: Relevance = Relevance.NO
    concern: str = ""
    page: str = ""

    @property
    def pattern(self) -> str:
        """The name with empty brackets, as in entries."""
        return pattern_of(self.path)

    @property
    def index_ranges(self) -> tuple[tuple[int, int], ...]:
        """The minimum and maximum of each index."""
        return _index_ranges(self.path)

    @property
    def bounds(self) -> tuple[int | float, int | float]:
        """The range of a number, both ends included."""
        if self.type is ValueType.REAL64:
            minimum: int | float = float("-inf")
            greatest: int | float = float("inf")
        else:
            minimum, greatest = integer_bounds(self.type)
        low = minimum if self.low is None else self.low
        return low, greatest if self.high is None else self.high

    def allows(self, number: int | float) -> bool:
        """Return whether a number lies in the range, without ``at_least`` and ``at_most``."""
        if number in self.also:
            return True
        low, high = self.bounds
        return low <= number <= high and number not in self.excluded


_INFINITE = float("inf")


def range_text(parameter: Parameter, limits: Mapping[str, str] = MappingProxyType({})) -> str:
    """Return the range of a parameter as text, empty without one.

    ``1 … P-AXIS-00008``, ``0 | 512 … ∞``, ``> 0 … 1``; for a text ``≤`` and its maximum length.
    ``limits``: texts for other parameters that are bounds, by their IDs.
    """
    if parameter.type is ValueType.STRING:
        return "" if parameter.high is None else f"≤ {parameter.high}"
    if not parameter.type.is_number:
        return ""
    low, high = parameter.bounds
    excluded = set(parameter.excluded)
    if parameter.type is not ValueType.REAL64 and low in excluded:
        excluded.remove(low)
        low += 1
    ends = (
        _end(low, parameter.at_least, ">", low in excluded, limits),
        _end(high, parameter.at_most, "<", high in excluded, limits),
    )
    excluded -= {low, high}
    alternatives = [_number_text(number) for number in parameter.also]
    if low != high and ends != ("−∞", "∞"):
        alternatives.append(" … ".join(ends))
    without = [f"≠ {_number_text(number)}" for number in parameter.excluded if number in excluded]
    return " | ".join((*alternatives, *without))


def _end(
    bound: float, limit: Limit | None, sign: str, is_excluded: bool, limits: Mapping[str, str]
) -> str:
    if limit is None:
        return f"{sign + ' ' if is_excluded else ''}{_number_text(bound)}"
    factor = "" if limit.factor == 1 else f"{limit.factor:g} · "
    known = f" ({limits[limit.id]})" if limit.id in limits else ""
    return f"{sign + ' ' if limit.is_exclusive else ''}{factor}{limit.id}{known}"


def _number_text(number: float) -> str:
    if number in (_INFINITE, -_INFINITE):
        return "∞" if number > 0 else "−∞"
    return str(int(number) if number == int(number) else number)


@cache
def _index_ranges(path: str) -> tuple[tuple[int, int], ...]:
    return tuple((int(low), int(high)) for low, high in _INDEX_RANGE.findall(path))


@cache
def pattern_of(path: str) -> str:
    """Return the pattern of a path: ``thread[].name`` for ``thread[0..6].name``."""
    return _INDEX_RANGE.sub("[]", path)


def with_indices(pattern: str, indices: tuple[int, ...]) -> str:
    """Return the name with its indices: ``thread[3].name`` for ``thread[].name`` and ``(3,)``."""
    for index in indices:
        pattern = pattern.replace("[]", f"[{index}]", 1)
    return pattern


def shown(value: Value) -> str:
    """Return a value as written in a list; ``–`` without one."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, tuple):
        return " | ".join(value) or "–"
    return str(value) if value != "" else '""'
