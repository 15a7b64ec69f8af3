# SPDX-License-Identifier: MIT
"""The declarations of a kind of list: a table, one parameter a line.

In: a file of tab-separated values, written and kept by hand. Out: ``Parameter`` records, each
created when it is needed. The columns:

============  ======================================================================================
``id``        the manuals' ID; empty where no source gives one
``entry``     the name with the ranges of its indices: ``getriebe[0..5].dynamik.a_max``; several
              with all else the same are joined by `` | ``
``type``      a ``ValueType``
``default``   as written in a list, or the ID of the parameter whose value it is
``range``     alternatives joined by `` | ``: ``LOW … HIGH``, where an end may be missing or name
              another parameter (``2*P-AXIS-00008``; ``<`` or ``>``: without it), single numbers,
              ``not 0``; for texts ``≤`` and the maximum length
``values``    names of a NAME or the flags of a FLAGS parameter, ``NAME=number`` where the number is
              known; ``…`` at the end: there are more; ``@name``: a set of names kept in code
``unit``      unit of the value
``options``   ``restart``: a change counts from the next start; ``old=NAME``: an old name,
              ``same=NAME``: a name that is as valid (``NAME:ID`` where it has an ID of its own);
              ``invalid=VALUE``: what replaces a defective value instead of the default
``effect``    ``used``; without effect: whether another value than the default would change a run,
              yes, maybe or no
``concern``   its subject, in one word
``page``      number of its page in the public help
``en, de``    its meaning
============  ======================================================================================
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message, Text
from nctakt.lists.format.parameter import (
    Alias,
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
#: Columns that only the line of a parameter with an effect has.
_USED = "\tused\t"
#: Columns of the line of a parameter with a further name.
_ALIAS = re.compile(r"[\t ](?:old|same)=")

NO_NAMES: Mapping[str, Mapping[str, int | None]] = MappingProxyType({})
NO_DEFECTS: Mapping[str, Message] = MappingProxyType({})


class ParameterTable:
    """The table of one kind of list; ``name`` is that of its file. It is read when needed.

    ``names``: the sets of names that the column ``values`` takes from code. ``defects``: the
    messages about defective values, by the name of their parameter.
    """

    def __init__(
        self,
        name: str,
        names: Mapping[str, Mapping[str, int | None]] = NO_NAMES,
        defects: Mapping[str, Message] = NO_DEFECTS,
    ) -> None:
        self._name = name
        self._names = names
        self._defects = defects
        self._parameters: dict[str, Parameter] = {}

    @cached_property
    def _lines(self) -> dict[str, tuple[str, str]]:
        """The entries and lines of the table by the name of their parameter."""
        text = (_FOLDER / self._name).read_text("utf-8")
        lines = text.splitlines()
        heading = next(index for index, line in enumerate(lines) if not line.startswith("#"))
        found: dict[str, tuple[str, str]] = {}
        for line in lines[heading + 1 :]:
            for entry in line.split("\t", 2)[1].split(" | "):
                pattern = pattern_of(entry)
                assert pattern not in found, pattern
                found[pattern] = entry, line
        return found

    @cached_property
    def used(self) -> tuple[Parameter, ...]:
        """The parameters that have an effect, in the order of the table."""
        return tuple(
            self._parameter(pattern) for pattern, (_, line) in self._lines.items() if _USED in line
        )

    @cached_property
    def _patterns_by_id(self) -> dict[str, list[str]]:
        by_id: dict[str, list[str]] = {}
        for pattern, (_, line) in self._lines.items():
            by_id.setdefault(line.split("\t", 1)[0], []).append(pattern)
        for parameter, alias in self._by_alias.values():
            if alias.id:
                by_id.setdefault(alias.id, []).append(parameter.pattern)
        by_id.pop("", None)
        return by_id

    @property
    def _with_aliases(self) -> Iterator[Parameter]:
        """The parameters that have further names, in the order of the table."""
        for pattern, (_, line) in self._lines.items():
            if _ALIAS.search(line):
                yield self._parameter(pattern)

    @cached_property
    def _by_alias(self) -> dict[str, tuple[Parameter, Alias]]:
        """The parameters that have further names, by these."""
        return {
            pattern_of(alias.path): (parameter, alias)
            for parameter in self._with_aliases
            for alias in parameter.aliases
        }

    def _parameter(self, pattern: str) -> Parameter:
        """Return the parameter of a name that the table has."""
        parameter = self._parameters.get(pattern)
        if parameter is None:
            entry, line = self._lines[pattern]
            parameter = parse_line(line, entry, self._names, self._defects.get(pattern))
            self._parameters[pattern] = parameter
        return parameter

    def find(self, pattern: str) -> tuple[Parameter, Alias | None] | None:
        """Return the parameter with this name, and the alias if it is a further name."""
        if pattern in self._lines:
            return self._parameter(pattern), None
        return self._by_alias.get(pattern)

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """Return the parameters with that ID: some IDs belong to several names."""
        return tuple(map(self._parameter, self._patterns_by_id.get(parameter_id, ())))

    def patterns(self) -> tuple[str, ...]:
        """Return all names, the further ones too."""
        return (*self._lines, *self._by_alias)

    def parameters(self) -> tuple[Parameter, ...]:
        """Return all parameters in the order of the table."""
        return tuple(map(self._parameter, self._lines))


@dataclass(frozen=True, slots=True)
class _Range:
    """The parts of the column ``range``; see ``Parameter``."""

    low: float | None = None
    high: float | None = None
    also: tuple[float, ...] = ()
    excluded: tuple[float, ...] = ()
    at_least: Limit | None = None
    at_most: Limit | None = None


def parse_line(
    line: str,
    entry: str,
    names: Mapping[str, Mapping[str, int | None]] = NO_NAMES,
    defect: Message | None = None,
) -> Parameter:
    """Return the parameter of a line of a table, with one of its entries."""
    id_, _, type_name, default, range_, values, unit, options, effect, concern, page, en, de = (
        line.split("\t")
    )
    type_ = ValueType(type_name)
    has_default = not _ID.fullmatch(default)
    allowed = _parse_range(range_)
    words = values.split()
    found = _parse_options(type_, options)
    return Parameter(
        id_,
        entry,
        type_,
        _default(type_, default) if has_default else None,
        Text(en, de),
        low=allowed.low,
        high=allowed.high,
        unit=unit,
        names=names[values[1:]] if values.startswith("@") else _numbers_of_names(words),
        aliases=found.aliases,
        restart=found.restart,
        effect=Effect.USED if effect == "used" else Effect.WITHOUT_EFFECT,
        invalid=found.invalid,
        invalid_message=defect,
        also=allowed.also,
        excluded=allowed.excluded,
        at_least=allowed.at_least,
        at_most=allowed.at_most,
        has_more_names=_MORE in words,
        default_id="" if has_default else default,
        relevance=Relevance.NO if effect == "used" else Relevance(effect),
        concern=concern,
        page=page,
    )


@dataclass(frozen=True, slots=True)
class _Options:
    """The parts of the column ``options``; see ``Parameter``."""

    aliases: tuple[Alias, ...] = ()
    restart: bool = False
    invalid: Value = None


_NO_OPTIONS = _Options()


def _parse_options(type_: ValueType, text: str) -> _Options:
    if not text:
        return _NO_OPTIONS
    aliases: list[Alias] = []
    restart, invalid = False, None
    for word in text.split():
        kind, _, value = word.partition("=")
        if kind == "restart":
            restart = True
        elif kind == "invalid":
            invalid = _default(type_, value)
        else:
            path, _, alias_id = value.partition(":")
            aliases.append(Alias(path, kind == "same", alias_id))
    return _Options(tuple(aliases), restart, invalid)


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
        # Single numbers only: the first is the range, the others are allowed in addition.
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
