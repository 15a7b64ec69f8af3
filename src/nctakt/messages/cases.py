# SPDX-License-Identifier: MIT
"""Messages that the controller numbers by case: which number a finding has.

In: the values of a finding's parameters. Out: ``Cases`` for the declaration of its message; the
number 0 if the controller has none for the case, so that the message's own number leads.
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


#: The number of two functions of a group in a block, and the functions of the group.
_GROUPS = {
    number: frozenset(words.split())
    for number, words in {
        20108: "G00 G01 G02 G03 G33 G63 G303 G331 G332",
        20110: "G10 G11",
        20111: "G17 G18 G19",
        20112: "G20 G21 G22 G23 G351",
        20113: "G25 G26",
        20114: "G40 G41 G42",
        20116: "G53 G54 G55 G56 G57 G58 G59 G159",
        20117: "G60 G61 G260 G261 G359 G360",
        20118: "G70 G71",
        20120: "G90 G91",
        20121: "G93 G94 G95 G194",
        20122: "G96 G97 G196",
        20126: "G138 G139 G236 G237 G238 G239",
        20127: "G161 G162",
        20128: "G164 G165",
        20130: "G301 G302 #CHR #CHF #RND",
        20794: "G12 G13",
        20158: "M02 M30 M17 M29",
    }.items()
}


def by_group() -> Cases:
    """Choose the number by the group that the functions ``word`` and ``other`` belong to."""
    return Cases(
        tuple(_GROUPS), lambda values: _group_number(str(values["word"]), str(values["other"]))
    )


def by_word_or_group(numbers: Mapping[str, int]) -> Cases:
    """Choose the number of ``word`` by its letters, that of a G function by its group."""
    by_letters = by_word("word", numbers)
    return Cases(
        (*by_letters.numbers, *_GROUPS),
        lambda values: by_letters.number_of(values) or _group_number(str(values["word"])),
    )


def _group_number(*functions: str) -> int:
    """Return the number of the group that has all these functions, 0 if none has."""
    return next((one for one, group in _GROUPS.items() if group.issuperset(functions)), 0)


#: The highest number of a G, M or H function that its format holds, UNS16.
_HIGHEST_FUNCTION = 65_535


def unknown_functions(values: Values) -> int:
    """Return the number of a function outside its format, or of a G function that is unknown."""
    word = str(values["word"])
    if word[0] != "G":
        return {"M": 20154, "H": 20161}.get(word[0], 0)
    written = word[1:]
    is_possible = written.isdecimal() and int(written) <= _HIGHEST_FUNCTION
    return 20131 if is_possible else 20107


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
