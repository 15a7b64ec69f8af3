# SPDX-License-Identifier: MIT
"""The text of a ``#MSG``, formatted with ``%d``, ``%f`` … and its values."""

from __future__ import annotations

import re
from collections.abc import Sequence

from nctakt.kernel.base import arithmetic

_CONVERSION = re.compile(r"%([-+ 0]*)(\d*)((?:\.\d+)?)([A-Za-z%]?)")
_WHOLE = "diuxXoc"
_REAL = "feEgG"


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
