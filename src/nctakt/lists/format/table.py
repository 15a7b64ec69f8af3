# SPDX-License-Identifier: MIT
"""Declarations in a table: known parameters without an effect.

In: a file of tab-separated values beside the declarations in code, one parameter a line, written
and kept by hand. Out: ``Parameter`` records, each created when it is needed. The columns:

============  ======================================================================================
``id``        the manuals' ID; empty where no source gives one
``entry``     the name with the ranges of its indices: ``getriebe[0..5].dynamik.a_max``
``type``      a ``ValueType``
``default``   as written in a list, or the ID of the parameter whose value it is
``range``     alternatives joined by `` | ``: ``LOW … HIGH``, where an end may be missing or name
              another parameter (``2*P-AXIS-00008``; ``<`` or ``>``: without it), single numbers,
              ``not 0``; for texts ``≤`` and the maximum length
``values``    names of a NAME or the flags of a FLAGS parameter, ``NAME=number`` where the number is
              known; ``…`` at the end: there are more
``unit``      unit of the value
``relevance`` whether another value than the default would change a run: yes, maybe, no
``concern``   its subject, in one word
``page``      number of its page in the public help
``en, de``    its meaning
============  ======================================================================================
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cached_property
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import (
    Effect,
    Limit,
    Parameter,
    Relevance,
    Value,
    ValueType,
    pattern_of,
)
from nctakt.lists.format.value_text import parse_integer, parse_real

_FOLDER = Path(__file__).parent.parent / "declared"
_LIMIT = re.compile(r"([<>]?)(?:([0-9]+)\*)?(P-[A-Z]{4}-[0-9]{5})(?:/([0-9]+))?")
_MORE = "…"
_ID = re.compile(r"P-[A-Z]{4}-[0-9]{5}")


class ParameterTable:
    """The table of one kind of list; ``name`` is that of its file. It is read when needed."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._parameters: dict[str, Parameter] = {}

    @cached_property
    def _lines(self) -> dict[str, str]:
        """The lines of the table by the name of their parameter."""
        text = (_FOLDER / self._name).read_text("utf-8")
        lines = text.splitlines()
        heading = next(index for index, line in enumerate(lines) if not line.startswith("#"))
        return {pattern_of(line.split("\t", 2)[1]): line for line in lines[heading + 1 :]}

    @cached_property
    def _patterns_by_id(self) -> dict[str, list[str]]:
        by_id: dict[str, list[str]] = {}
        for pattern, line in self._lines.items():
            by_id.setdefault(line.split("\t", 1)[0], []).append(pattern)
        by_id.pop("", None)
        return by_id

    def find(self, pattern: str) -> Parameter | None:
        """Return the parameter with that name."""
        parameter = self._parameters.get(pattern)
        if parameter is None and (line := self._lines.get(pattern)) is not None:
            parameter = self._parameters[pattern] = parse_line(line)
        return parameter

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """Return the parameters with that ID."""
        patterns = self._patterns_by_id.get(parameter_id, ())
        return tuple(
            parameter for pattern in patterns if (parameter := self.find(pattern)) is not None
        )

    def patterns(self) -> tuple[str, ...]:
        """Return all names."""
        return tuple(self._lines)

    def parameters(self) -> tuple[Parameter, ...]:
        """Return all parameters in the order of the table."""
        return tuple(
            parameter for pattern in self._lines if (parameter := self.find(pattern)) is not None
        )


@dataclass(frozen=True, slots=True)
class _Range:
    """The parts of the column ``range``; see ``Parameter``."""

    low: float | None = None
    high: float | None = None
    also: tuple[float, ...] = ()
    excluded: tuple[float, ...] = ()
    at_least: Limit | None = None
    at_most: Limit | None = None


def parse_line(line: str) -> Parameter:
    """Return the parameter of a line of a table."""
    id_, entry, type_name, default, range_, words, unit, relevance, concern, page, en, de = (
        line.split("\t")
    )
    type_ = ValueType(type_name)
    has_default = not _ID.fullmatch(default)
    allowed = _parse_range(range_)
    names = words.split()
    return Parameter(
        id_,
        entry,
        type_,
        _default(type_, default) if has_default else None,
        Text(en, de),
        low=allowed.low,
        high=allowed.high,
        unit=unit,
        names=_numbers_of_names(names),
        effect=Effect.WITHOUT_EFFECT,
        also=allowed.also,
        excluded=allowed.excluded,
        at_least=allowed.at_least,
        at_most=allowed.at_most,
        has_more_names=_MORE in names,
        default_id="" if has_default else default,
        relevance=Relevance(relevance),
        concern=concern,
        page=page,
    )


def _numbers_of_names(words: list[str]) -> dict[str, int | None]:
    names: dict[str, int | None] = {}
    for word in words:
        name, _, number = word.partition("=")
        if name != _MORE:
            names[name] = parse_integer(number, hexadecimal=True)
    return names


def _default(type_: ValueType, text: str) -> Value:
    match type_:
        case ValueType.STRING | ValueType.NAME:
            return text
        case ValueType.FLAGS:
            return (text,) if text else ()
        case ValueType.BOOLEAN:
            return text == "1"
        case ValueType.REAL64:
            return parse_real(text, hexadecimal=False)
    return parse_integer(text, hexadecimal=True)


def _parse_range(text: str) -> _Range:
    allowed = _Range()
    singles: list[float] = []
    has_range = False
    for alternative in text.split(" | ") if text else ():
        if alternative.startswith("≤ "):
            allowed = replace(allowed, high=_number(alternative[2:]))
        elif alternative.startswith("not "):
            allowed = replace(allowed, excluded=(*allowed.excluded, _number(alternative[4:])))
        elif "…" in alternative:
            allowed = _with_ends(allowed, *(end.strip() for end in alternative.split("…")))
            has_range = True
        else:
            singles.append(_number(alternative))
    if singles and not has_range:
        # Single numbers only: the first one is the range, the others are allowed beside it.
        allowed = replace(allowed, low=singles[0], high=singles[0])
    return replace(allowed, also=tuple(singles))


def _with_ends(allowed: _Range, low: str, high: str) -> _Range:
    if _LIMIT.fullmatch(low):
        allowed = replace(allowed, at_least=_limit(low))
    elif low:
        allowed = replace(allowed, low=_number(low))
    if _LIMIT.fullmatch(high):
        return replace(allowed, at_most=_limit(high))
    return replace(allowed, high=_number(high)) if high else allowed


def _number(text: str) -> float:
    """Return a number, an integer as such: bounds of 64 bit have more digits than a float."""
    integer = parse_integer(text, hexadecimal=True)
    return float(text) if integer is None else integer


def _limit(text: str) -> Limit:
    match = _LIMIT.fullmatch(text)
    assert match is not None, text
    return Limit(match[3], int(match[2] or 1) / int(match[4] or 1), bool(match[1]))
