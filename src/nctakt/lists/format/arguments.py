# SPDX-License-Identifier: MIT
"""Arguments of the public functions in Python, checked before anything begins.

In: a value and the name of its argument. Out: the value; a wrong type or a number below its minimum
is a ``Failure`` (901186) that names the argument and what it must be.
"""

from __future__ import annotations

import operator
import os
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any, NoReturn, SupportsIndex

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.plain_values import plain_number
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import ARGUMENT_OF_WRONG_TYPE

_WHOLE = Text("a whole number from {minimum} on", "eine ganze Zahl ab {minimum}")
_TEXT = Text("a text", "ein Text")
_NUMBER_OR_TEXT = Text("a number, a truth value or a text", "Zahl, Wahrheitswert oder Text")
_PATH = Text("the name of a file or folder", "der Name einer Datei oder eines Ordners")
_MAPPING = Text("a dictionary", "ein Wörterbuch (dict)")
_COLLECTION = Text("a list", "eine Liste")
_FUNCTION = Text("a function", "eine Funktion")


def whole_number(name: str, value: Any, minimum: int = 0) -> int:
    """Return a whole number; raises ``Failure`` for any other value and if it is too small."""
    if type(value) is int and value >= minimum:
        return value
    is_whole = isinstance(value, SupportsIndex) and not isinstance(value, bool)
    number = operator.index(value) if is_whole else minimum - 1
    if number < minimum:
        en, de = (_WHOLE.get(language).format(minimum=minimum) for language in ("en", "de"))
        refuse(name, value, Text(en, de))
    return number


def text(name: str, value: object) -> str:
    """Return a text; raises ``Failure`` for any other value."""
    if not isinstance(value, str):
        refuse(name, value, _TEXT)
    return value


def number_or_text(name: str, value: object) -> float | str:
    """Return the value of a variable; raises ``Failure`` for a value that no variable can have.

    A NumPy number becomes a Python number.
    """
    plain = plain_number(value)
    if not isinstance(plain, str | int | float):
        refuse(name, value, _NUMBER_OR_TEXT)
    return plain


def path(name: str, value: object) -> Path:
    """Return the path of a file or folder; raises ``Failure`` for any other value."""
    if not isinstance(value, str | os.PathLike):
        refuse(name, value, _PATH)
    return Path(value)


def mapping(name: str, value: object) -> None:
    """Check a dictionary; raises ``Failure`` for any other value."""
    if not isinstance(value, Mapping):
        refuse(name, value, _MAPPING)


def collection(name: str, value: object) -> None:
    """Check a list, a tuple or another collection, but no text; raises ``Failure`` otherwise."""
    if isinstance(value, str) or not isinstance(value, Collection):
        refuse(name, value, _COLLECTION)


def function(name: str, value: object) -> None:
    """Check a function or ``None``; raises ``Failure`` for any other value."""
    if value is not None and not callable(value):
        refuse(name, value, _FUNCTION)


def refuse(name: str, value: Any, expected: Text) -> NoReturn:
    """Raise ``Failure``: the argument ``name`` is not ``expected``."""
    raise Failure(
        diagnostic(ARGUMENT_OF_WRONG_TYPE, name=name, expected=expected, value=repr(value))
    )
