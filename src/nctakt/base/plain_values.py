# SPDX-License-Identifier: MIT
"""Numbers of numpy and of packages like it -> numbers of Python, without loading any of them.

In: a value from a caller. Out: the same value as data of the standard library; other values are
unchanged.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import timedelta
from typing import Any

#: The types of scalars by their kind: truth values, whole numbers with and without sign, others.
_TYPES: dict[str, Callable[[Any], Any]] = {"b": bool, "i": int, "u": int, "f": float}


def plain_number(value: Any) -> Any:
    """Return a scalar of numpy as a number of Python or a ``timedelta``, else the value itself.

    A part of a microsecond is rounded up, as in each length of time.
    """
    if type(value) in (float, int, str, bool):
        return value
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    if getattr(value, "shape", None) != ():
        return value
    if kind == "m":
        whole = value.astype("timedelta64[us]")
        length = whole.item()
        if isinstance(length, timedelta):
            return length + timedelta(microseconds=1) if bool(whole < value) else length
    return _TYPES[kind](value) if kind in _TYPES else value


def plain_data(value: Any) -> Any:
    """Return tables, lists and arrays, at any depth, with plain numbers."""
    if isinstance(value, Mapping):
        return {key: plain_data(one) for key, one in value.items()}
    if isinstance(value, list | tuple | range):
        return [plain_data(one) for one in value]
    if getattr(value, "shape", ()) and hasattr(value, "tolist"):
        return value.tolist()
    return plain_number(value)
