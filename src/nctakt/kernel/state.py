# SPDX-License-Identifier: MIT
"""What copies the state of the realtime part's objects, and what returns their arrays.

In: the fields that ``state_fields`` finds in the C types. Out: ``COPIERS`` (class -> a function
that copies from one object to another), ``ARRAYS`` (class -> a function that returns the arrays
whose content is kept) and ``ArrayCopies``, which keeps that content; what a base class declares,
its own entries copy. Compiled, they are in ``_state``, which the build writes; plain, they are
made here.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

from nctakt.base.mode import is_compiled
from nctakt.kernel.state_fields import TypedClass, typed_classes

Copier = Callable[[Any, Any], None]
Arrays = Callable[[Any], tuple[Any, ...]]


class KeptArrays(Protocol):
    """The content of arrays at some moment."""

    def take(self) -> None:
        """Take the present content."""

    def put_back(self) -> None:
        """Put the content back as it was when it was taken."""


class PlainArrayCopies:
    """The content of arrays, taken when it is made."""

    def __init__(self, arrays: list[bytearray]) -> None:
        self._pairs = [(memoryview(one), memoryview(bytearray(one))) for one in arrays]

    def take(self) -> None:
        """Take the present content."""
        for live, kept in self._pairs:
            kept[:] = live

    def put_back(self) -> None:
        """Put the content back as it was when it was taken."""
        for live, kept in self._pairs:
            live[:] = kept


def _copier(found: TypedClass) -> Copier:
    """Return what copies the fields of a class in plain Python."""
    names = tuple(found.copied)

    def copy(source: Any, target: Any) -> None:
        for name in names:
            value = getattr(source, name)
            setattr(target, name, list(value) if type(value) is list else value)

    return copy


def _arrays(found: TypedClass) -> Arrays:
    """Return what returns the arrays of an object of a class in plain Python."""
    names = tuple(found.arrays)
    return lambda part: tuple(getattr(part, name) for name in names)


def _plain() -> tuple[dict[type, Copier], dict[type, Arrays], Callable[..., KeptArrays]]:
    """Return ``COPIERS``, ``ARRAYS`` and ``ArrayCopies`` of the plain classes."""
    copiers, arrays = {}, {}
    for found in typed_classes(Path(__file__).parent):
        if found.copied or found.arrays:
            cls = getattr(importlib.import_module(found.module), found.name)
            if found.copied:
                copiers[cls] = _copier(found)
            if found.arrays:
                arrays[cls] = _arrays(found)
    return copiers, arrays, PlainArrayCopies


def _compiled() -> tuple[dict[type, Copier], dict[type, Arrays], Callable[..., KeptArrays]]:
    """Return ``COPIERS``, ``ARRAYS`` and ``ArrayCopies`` of the compiled classes."""
    module = importlib.import_module("nctakt.kernel._state")
    return module.COPIERS, module.ARRAYS, module.ArrayCopies


_FOUND = _compiled() if is_compiled() else _plain()
COPIERS = MappingProxyType(_FOUND[0])
ARRAYS = MappingProxyType(_FOUND[1])
ArrayCopies = _FOUND[2]
