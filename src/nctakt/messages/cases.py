# SPDX-License-Identifier: MIT
"""Messages that the controller numbers by case: which number a finding has.

In: the values of a finding's parameters. Out: ``Cases`` for the declaration of its message; the
number 0 where the controller has none for the case, so that the message's own one leads.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from nctakt.base.diagnostics import Cases

Values = Mapping[str, object]

_HEAD = re.compile(r"[#$%]?[^\W\d]*")
_AXIS_NAME = re.compile(r"[ABCQU-Z]\w*", re.ASCII)
_IDENTIFIER = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def by_word(parameter: str, numbers: Mapping[str, int]) -> Cases:
    """Choose the number by the letters that a value begins with: ``M`` of ``M100``, in any case."""

    def number_of(values: Values) -> int:
        match = _HEAD.match(str(values[parameter]))
        return numbers.get(match[0].upper(), 0) if match else 0

    return Cases(_distinct(numbers), number_of)


def by_beginning(parameter: str, numbers: Mapping[str, int]) -> Cases:
    """Choose the number by the text that a value begins with; the first that fits."""

    def number_of(values: Values) -> int:
        text = str(values[parameter]).upper()
        return next((one for begin, one in numbers.items() if text.startswith(begin)), 0)

    return Cases(_distinct(numbers), number_of)


def by_end(parameter: str, numbers: Mapping[str, int]) -> Cases:
    """Choose the number by the text that a value ends with."""

    def number_of(values: Values) -> int:
        text = str(values[parameter])
        return next((one for end, one in numbers.items() if text.endswith(end)), 0)

    return Cases(_distinct(numbers), number_of)


def by_sign(parameter: str, *, negative: int, other: int = 0) -> Cases:
    """Choose the number of a value below 0, or that of any other."""

    def number_of(values: Values) -> int:
        return negative if number(values[parameter]) < 0 else other

    return Cases(tuple(one for one in (negative, other) if one), number_of)


def by_limit(value: str, *, above: int, below: int) -> Cases:
    """Choose the number of a value above ``high``, or that of one below ``low``."""

    def number_of(values: Values) -> int:
        return above if number(values[value]) > number(values["high"]) else below

    return Cases((above, below), number_of)


def by_counts(*, few: int, many: int, none: int = 0) -> Cases:
    """Choose the number of too ``few`` values, too ``many``, or any where ``none`` are expected."""

    def number_of(values: Values) -> int:
        given = number(values["given"])
        expected = number(values["expected"])
        if none and expected == 0:
            return none
        return few if given < expected else many

    return Cases(tuple(one for one in (few, many, none) if one), number_of)


def in_case(only: int, applies: Callable[[Values], bool]) -> Cases:
    """Give the number ``only`` to values for which ``applies`` is true."""
    return Cases((only,), lambda values: only if applies(values) else 0)


#: The G functions of a group, and the number of two of them in a block.
_GROUPS = (
    (frozenset(("G17", "G18", "G19")), 20111),
    (frozenset(("G40", "G41", "G42")), 20114),
    (frozenset(("G53", "G54", "G55", "G56", "G57", "G58", "G59")), 20116),
    (frozenset(("M02", "M30", "M17", "M29")), 20158),
)


def by_group() -> Cases:
    """Choose the number by the group that the functions ``word`` and ``other`` belong to."""

    def number_of(values: Values) -> int:
        words = {str(values["word"]), str(values["other"])}
        return next((one for group, one in _GROUPS if words <= group), 0)

    return Cases(tuple(one for _, one in _GROUPS), number_of)


def feed_factor(values: Values) -> int:
    """Return the number of a feed factor; other overrides have the message's own."""
    if values["word"] != "FEED_FACT":
        return 0
    return 21826 if number(values["value"]) < 0 else 21987


def names_of_axes(values: Values) -> int:
    """Return the number of an invalid name of an axis or spindle, or of one used twice."""
    key, name = str(values["key"]), str(values["value"])
    if not key.startswith(("spindel", "main_spindle")):
        return 20424 if _AXIS_NAME.fullmatch(name) else 20425
    if not name.startswith("S"):
        return 20971
    return 21045 if key.startswith("main_spindle") else 20419


def names_of_variables(values: Values) -> int:
    """Return the number of a variable name that is too long, invalid or already used."""
    key, name = str(values["key"]), str(values["value"])
    is_structure = key.startswith("struct")
    is_element = is_structure and ".element" in key
    if len(name) > number(values["limit"]):
        return 21432 if is_element else 21429 if is_structure else 21182
    if not _IDENTIFIER.fullmatch(name):
        return 21433 if is_element else 21430 if is_structure else 20788
    return 0 if is_structure else 21485


def number(value: object) -> float:
    """Return the number that a shown value begins with; the first one of ``2 to 3``."""
    match = re.match(r"[+-]?[\d.]+(?:e[+-]?\d+)?", str(value))
    return float(match[0]) if match else 0.0


def _distinct(numbers: Mapping[str, int]) -> tuple[int, ...]:
    return tuple(dict.fromkeys(numbers.values()))
