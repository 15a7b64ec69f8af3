# SPDX-License-Identifier: MIT
"""Texts at decode time: their functions, and ``#MSG``, formatted with ``%d``, ``%f`` … and values.

A function returns a number or a text, ``None`` if there is no result. Positions count from 1.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from nctakt.kernel.base import arithmetic

_CONVERSION = re.compile(r"%([-+ 0]*)(\d*)((?:\.\d+)?)([A-Za-z%]?)")
_WHOLE = "diuxXoc"
_REAL = "feEgG"


Value = float | str


class FormatError(ValueError):
    """The format does not fit its values."""


def format_text(text: str, values: Sequence[float | str]) -> str:
    """Return the text with its values filled in; raises ``FormatError``.

    Any conversion accepts a number: ``%d`` shows it rounded, ``%f`` with its fraction.
    """
    left = list(values)

    def fill(match: re.Match[str]) -> str:
        flags, width, precision, conversion = match.groups()
        if conversion == "%":
            return "%"
        if not left:
            raise FormatError(match[0])
        value = left.pop(0)
        return _convert(match[0], flags + width + precision, conversion, value)

    result = _CONVERSION.sub(fill, text)
    if left:
        raise FormatError(str(left[0]))
    return result


def _convert(written: str, layout: str, conversion: str, value: float | str) -> str:
    if conversion == "s":
        shown = value if isinstance(value, str) else repr(value).removesuffix(".0")
        return f"%{layout}s" % shown
    if isinstance(value, str) or not conversion or conversion not in _WHOLE + _REAL:
        raise FormatError(written)
    if conversion in _WHOLE:
        whole = int(arithmetic.round_half_even(value))
        return f"%{layout}{conversion if conversion in 'xXo' else 'd'}" % whole
    return f"%{layout}{conversion}" % value


def _left(values: Sequence[Value]) -> Value | None:
    text, count = _text(values[0]), _whole(values[1])
    return text[:count] if count >= 0 else None


def _right(values: Sequence[Value]) -> Value | None:
    text, count = _text(values[0]), _whole(values[1])
    return text[max(0, len(text) - count) :] if count >= 0 else None


def _mid(values: Sequence[Value]) -> Value | None:
    text, count, position = _text(values[0]), _whole(values[1]), _whole(values[2])
    return text[position - 1 : position - 1 + count] if count >= 0 and position >= 1 else None


def _delete(values: Sequence[Value]) -> Value | None:
    text, count, position = _text(values[0]), _whole(values[1]), _whole(values[2])
    if count < 0 or not 1 <= position <= len(text) + 1:
        return None
    return text[: position - 1] + text[position - 1 + count :]


def _insert(values: Sequence[Value]) -> Value | None:
    text, other, position = _text(values[0]), _text(values[1]), _whole(values[2])
    if not 0 <= position <= len(text):
        return None
    return text[:position] + other + text[position:]


def _replace(values: Sequence[Value]) -> Value | None:
    text, other = _text(values[0]), _text(values[1])
    count, position = _whole(values[2]), _whole(values[3])
    if count < 0 or not 1 <= position <= len(text) + 1:
        return None
    return text[: position - 1] + other + text[position - 1 + count :]


def _character(values: Sequence[Value]) -> Value | None:
    text = _text(values[0])
    position = _whole(values[1]) if len(values) > 1 else 1
    return float(ord(text[position - 1])) if 1 <= position <= len(text) else None


def _number(values: Sequence[Value]) -> Value | None:
    try:
        return float(_text(values[0]).strip())
    except ValueError:
        return None


def _whole_number(values: Sequence[Value]) -> Value | None:
    number = _number(values)
    return number if isinstance(number, float) and number.is_integer() else None


def _text(value: Value) -> str:
    assert isinstance(value, str)
    return value


def _whole(value: Value) -> int:
    assert isinstance(value, float)
    return round(value)


_FUNCTIONS: dict[str, Callable[[Sequence[Value]], Value | None]] = {
    "LEFT": _left,
    "RIGHT": _right,
    "MID": _mid,
    "DELETE": _delete,
    "INSERT": _insert,
    "REPLACE": _replace,
    "LEN": lambda values: float(len(_text(values[0]))),
    "FIND": lambda values: float(_text(values[0]).find(_text(values[1])) + 1),
    "ORD": _character,
    "REAL_TO_STR": lambda values: f"{values[0]:.6f}",
    "INT_TO_STR": lambda values: str(_whole(values[0])),
    "STR_TO_REAL": _number,
    "STR_TO_INT": _whole_number,
}


def compute(function: str, values: Sequence[Value]) -> Value | None:
    """Return the result of a function, ``None`` for invalid arguments."""
    return _FUNCTIONS[function](values)
