# SPDX-License-Identifier: MIT
"""Slips in a PLC's class when its run begins, wherever the class was written.

In: the class, in a notebook, in a test's function or made by ``exec``; the compiled methods are
enough. Out: mistakes by member. ``inspection.py`` reads the text of a PLC's file, and finds more:
types of values, keys, names in functions outside the class.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from types import FunctionType
from typing import Any

from nctakt.base.diagnostics import NOTHING, Message
from nctakt.base.misspelling import KnownNames, nearest
from nctakt.hli.operator_panel import SETTABLE
from nctakt.messages.plcs.plc import (
    PLC_NAME_NOT_SETTABLE,
    UNKNOWN_PLC_NAME,
    WRONG_HANDLER_PARAMETERS,
)
from nctakt.run.plcs.plc_view import PlcView, public_names

#: A message, the member that it concerns, a word in that, the message's values.
Slip = tuple[Message, str, str, dict[str, Any]]


def class_slips(
    kind: type,
    base: type,
    members: tuple[str, ...],
    needed: Callable[[str, FunctionType], tuple[str, ...]],
) -> Iterator[Slip]:
    """Yield the slips of a class that derives from ``base``.

    ``members``: the names that ``base`` calls or reads; ``needed``: the parameters with which a
    method is called, none if it is not.
    """
    own: dict[str, object] = {}
    for part in reversed(kind.__mro__):
        if issubclass(part, base) and part is not base:
            own |= vars(part)
    methods = {name: value for name, value in own.items() if isinstance(value, FunctionType)}
    used = {word for method in methods.values() for word in method.__code__.co_names}
    known = KnownNames(members)
    for name, value in own.items():
        is_called = name in methods and bool(needed(name, methods[name]))
        near = None if is_called or name in (*members, *used) else known.nearest(name)
        if near is not None and not name.startswith("__") and not isinstance(value, property):
            values = {"owner": kind.__name__, "name": name, "nearest": near}
            yield UNKNOWN_PLC_NAME, name, name, values
    for name, method in methods.items():
        parameters = needed(name, method)
        if parameters:
            yield from _method_slips(name, method, parameters)


def _method_slips(name: str, method: FunctionType, needed: tuple[str, ...]) -> Iterator[Slip]:
    """Yield wrong parameters of a method, else the names that the HLI does not have."""
    import inspect  # noqa: PLC0415 - a run without PLC needs none

    try:
        inspect.signature(method).bind(*needed)
    except TypeError:
        yield WRONG_HANDLER_PARAMETERS, name, name, {"name": name, "expected": ", ".join(needed)}
        return
    if method.__code__.co_argcount < len(needed[:2]):
        return  # it takes them all together
    view = tuple(public_names(PlcView))
    for word, is_set in _names_of(method, method.__code__.co_varnames[1]):
        if word not in view:
            near = nearest(word, SETTABLE if is_set else view) or NOTHING
            yield UNKNOWN_PLC_NAME, name, word, {"owner": "hli", "name": word, "nearest": near}
        elif is_set and word not in SETTABLE:
            settable = ", ".join(SETTABLE)
            yield PLC_NAME_NOT_SETTABLE, name, word, {"name": word, "settable": settable}


def _names_of(method: FunctionType, variable: str) -> Iterator[tuple[str, bool]]:
    """Yield the attributes of a variable in a method, and whether each is set.

    Nothing where the variable gets another value.
    """
    import dis  # noqa: PLC0415 - a run without PLC needs none

    instructions = list(dis.get_instructions(method))
    stores = (one for one in instructions if one.opname.startswith(("STORE_FAST", "DELETE_FAST")))
    if any(variable in _words(one.argval) for one in stores):
        return
    for before, one in pairwise(instructions):
        is_loaded = before.opname.startswith("LOAD_FAST") and _words(before.argval)[-1:] == (
            variable,
        )
        if is_loaded and one.opname in ("LOAD_ATTR", "LOAD_METHOD", "STORE_ATTR"):
            word = str(one.argval)
            if not word.startswith("_"):
                yield word, one.opname == "STORE_ATTR"


def _words(value: object) -> tuple[object, ...]:
    """Return the variables of an instruction: one, or two where Python joins instructions."""
    return value if isinstance(value, tuple) else (value,)
