# SPDX-License-Identifier: MIT
"""One entry -> the value of one parameter, by the parameter's type.

In: an entry, the declaration of its parameter, the default that replaces a defective value. Out:
the value, or ``None`` after a report with the reason.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.diagnostics import Message
from nctakt.lists.format.controller_numbers import bound_number, range_number
from nctakt.lists.format.parameter import Effect, Parameter, Value, ValueType, range_text, shown
from nctakt.lists.format.reader import Entry, ListDialect
from nctakt.lists.format.value_text import (
    Word,
    parse_integer,
    parse_real,
    read_flags,
    read_string,
    read_word,
)
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    NOT_A_BOOLEAN,
    NOT_A_NUMBER,
    NOT_A_WHOLE_NUMBER,
    PARAMETER_OUT_OF_RANGE,
    PARAMETER_TEXT_TOO_LONG,
    QUOTED_NUMBER,
    UNKNOWN_PARAMETER_VALUE,
    VALUE_MISSING,
)

_TRUTH = {"TRUE": True, "FALSE": False}


def convert(
    parameter: Parameter,
    entry: Entry,
    dialect: ListDialect,
    default: Value,
    collector: Collector,
    limits: Mapping[str, str] = MappingProxyType({}),
) -> Value:
    """Return the value of ``entry``, ``None`` after a report if it is missing or defective.

    ``limits``: entries and values of other parameters that are bounds, by their IDs.
    """
    report = _Report(parameter, entry, default, collector, limits)
    if parameter.type is ValueType.STRING:
        return _string(parameter, entry, report)
    if parameter.type is ValueType.FLAGS:
        return _flags(parameter, entry, dialect, report)
    word = read_word(entry, collector)
    if word is None:
        return report.no_value()
    if parameter.type is ValueType.NAME:
        return _name(parameter, word, dialect, report)
    if parameter.type is ValueType.BOOLEAN:
        return _boolean(parameter, word, dialect, report)
    return _number(parameter, word, dialect, report)


class _Report:
    """Reports on one entry; each method returns ``None`` so that it can end a conversion."""

    def __init__(
        self,
        parameter: Parameter,
        entry: Entry,
        default: Value,
        collector: Collector,
        limits: Mapping[str, str],
    ) -> None:
        self.parameter = parameter
        self.entry = entry
        self.default = default
        self.collector = collector
        self.limits = limits

    def no_value(self) -> Value:
        entry = self.entry
        self.collector.report(
            VALUE_MISSING, entry.key_span, entry.line, key=entry.path, default=shown(self.default)
        )
        return None

    def defect(self, message: Message, word: Word, leading: int = 0, /, **values: object) -> Value:
        self.collector.report_as(
            leading,
            message,
            word.span,
            self.entry.line,
            key=self.entry.path,
            default=shown(self.default),
            **values,
        )
        return None

    def quoted_number(self, word: Word) -> None:
        if word.quoted:
            self.collector.report(QUOTED_NUMBER, word.span, self.entry.line, key=self.entry.path)


def _string(parameter: Parameter, entry: Entry, report: _Report) -> Value:
    word = read_string(entry, report.collector)
    if word is None:
        return report.no_value()
    limit = parameter.high
    if limit is not None and len(word.text) > limit:
        return report.defect(PARAMETER_TEXT_TOO_LONG, word, length=len(word.text), limit=limit)
    return word.text


def _boolean(parameter: Parameter, word: Word, dialect: ListDialect, report: _Report) -> Value:
    if dialect.boolean_words and word.text.upper() in _TRUTH:
        return _TRUTH[word.text.upper()]
    if word.text in parameter.names:
        number = parameter.names[word.text]
        # A name without a number means "no value".
        return None if number is None else number == 1
    number = parse_integer(word.text, hexadecimal=dialect.hexadecimal)
    if number is None:
        return report.defect(
            NOT_A_BOOLEAN if dialect.boolean_words else NOT_A_NUMBER, word, value=word.text
        )
    if number not in (0, 1):
        return report.defect(
            PARAMETER_OUT_OF_RANGE,
            word,
            bound_number(parameter.id, number, is_above=number > 1),
            value=word.text,
            range="0 … 1",
        )
    report.quoted_number(word)
    return number == 1


def _name(parameter: Parameter, word: Word, dialect: ListDialect, report: _Report) -> Value:
    if word.text in parameter.names:
        return word.text
    number = parse_integer(word.text, hexadecimal=dialect.hexadecimal)
    if number is not None:
        for name, value in parameter.names.items():
            if value == number:
                return name
    if parameter.has_more_names or (number is not None and _may_have(parameter, number)):
        # If no source has the numbers of the names, 0 is the number of the default.
        return parameter.default if number == 0 else word.text
    return _bad_name(parameter, word, report)


def _may_have(parameter: Parameter, number: int) -> bool:
    """Return whether a number may belong to a name whose number is unknown."""
    is_used = parameter.effect is Effect.USED
    return number >= 0 and not is_used and None in parameter.names.values()


def _number(parameter: Parameter, word: Word, dialect: ListDialect, report: _Report) -> Value:
    number: int | float | None
    if parameter.type is ValueType.REAL64:
        number = parse_real(word.text, hexadecimal=dialect.hexadecimal)
    else:
        number = parse_integer(word.text, hexadecimal=dialect.hexadecimal)
    if number is None:
        is_real = parse_real(word.text, hexadecimal=dialect.hexadecimal) is not None
        return report.defect(NOT_A_WHOLE_NUMBER if is_real else NOT_A_NUMBER, word, value=word.text)
    report.quoted_number(word)
    if not parameter.allows(number):
        return report.defect(
            PARAMETER_OUT_OF_RANGE,
            word,
            range_number(parameter, number),
            value=word.text,
            range=range_text(parameter, report.limits),
        )
    return number


def _flags(parameter: Parameter, entry: Entry, dialect: ListDialect, report: _Report) -> Value:
    words = read_flags(entry, report.collector)
    if not words:
        return report.no_value()
    chosen: list[str] = []
    for word in words:
        number = parse_integer(word.text, hexadecimal=dialect.hexadecimal)
        names = (word.text,) if number is None else flags_of(parameter, number)
        if number == 0 and not names:
            continue
        is_open = parameter.has_more_names or (number is not None and _may_have(parameter, number))
        if is_open and not names:
            names = (word.text,)
        elif not is_open and (not names or any(name not in parameter.names for name in names)):
            return _bad_name(parameter, word, report)
        chosen.extend(names)
    listed = tuple(name for name in parameter.names if name in chosen)
    return (*listed, *(name for name in dict.fromkeys(chosen) if name not in listed))


def flags_of(parameter: Parameter, number: int) -> tuple[str, ...]:
    """Return the flags with the bits of ``number``; empty if a bit has no flag."""
    exact = tuple(name for name, value in parameter.names.items() if value == number)
    if exact:
        return exact[:1]
    rest = number
    names: list[str] = []
    for name, value in parameter.names.items():
        if value and rest & value == value:
            names.append(name)
            rest &= ~value
    return tuple(names) if rest == 0 else ()


def _bad_name(parameter: Parameter, word: Word, report: _Report) -> Value:
    if parameter.invalid_message is None:
        return report.defect(
            UNKNOWN_PARAMETER_VALUE, word, value=word.text, names=", ".join(parameter.names)
        )
    report.collector.report(
        parameter.invalid_message,
        word.span,
        report.entry.line,
        key=report.entry.path,
        value=word.text,
        default=shown(parameter.invalid),
    )
    return parameter.invalid
