# SPDX-License-Identifier: MIT
"""Copies of the state of the realtime part's objects, and access to their arrays.

In: the fields that ``state_fields`` finds in the C types. Out: ``ObjectCopies``, which keeps the
numbers of objects; ``ARRAYS`` (class -> a function that returns the arrays whose content is kept)
and ``ArrayCopies``, which keeps that content; ``COPIED`` and ``EXCHANGED``, the classes that have
numbers to keep, and arrays that may be exchanged for others. Fields of a base class are copied by
its own entries. Compiled, they are in ``_state``, which the build writes; plain, they are made
here.
"""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

from nctakt.base.mode import is_compiled
from nctakt.kernel.state_fields import TypedClass, typed_classes

Arrays = Callable[[Any], tuple[Any, ...]]


class Kept(Protocol):
    """Numbers of objects, or the content of arrays, at some moment."""

    def take(self) -> None:
        """Take the present ones."""

    def put_back(self) -> None:
        """Restore them."""


class KeptNumbers(Kept, Protocol):
    """Numbers of objects, and which arrays they had."""

    def have_same_arrays(self) -> bool:
        """Return whether all arrays are still those that they were."""


class Tables(NamedTuple):
    """Functions for each class, and objects that keep numbers of objects and content of arrays."""

    copied: Collection[type]
    arrays: dict[type, Arrays]
    exchanged: Collection[type]
    object_copies: Callable[[list[object]], KeptNumbers]
    array_copies: Callable[[list[bytearray]], Kept]


class PlainObjectCopies:
    """The numbers of objects, taken when it is made; ``copied``, ``exchanged``: fields by class."""

    def __init__(
        self,
        copied: Mapping[type, Sequence[str]],
        exchanged: Mapping[type, Sequence[str]],
        parts: list[object],
    ) -> None:
        self._triples: list[tuple[Any, dict[str, Any], Sequence[str]]] = []
        self._exchanged: list[tuple[Any, dict[str, Any], Sequence[str]]] = []
        for part in parts:
            kept: dict[str, Any] = {}
            for cls in type(part).__mro__:
                if cls in copied:
                    self._triples.append((part, kept, copied[cls]))
                    self._exchanged.append((part, kept, exchanged.get(cls, ())))
        self.take()

    def take(self) -> None:
        """Take the present numbers."""
        for part, kept, names in self._triples:
            for name in names:
                kept[name] = _separate(getattr(part, name))

    def put_back(self) -> None:
        """Restore the numbers."""
        for part, kept, names in self._triples:
            for name in names:
                setattr(part, name, _separate(kept[name]))

    def have_same_arrays(self) -> bool:
        """Return whether all arrays are still those that they were."""
        return all(
            getattr(part, name) is kept[name]
            for part, kept, names in self._exchanged
            for name in names
        )


def _separate(value: Any) -> Any:
    """Return a number unchanged, a list copied."""
    return list(value) if type(value) is list else value


class PlainArrayCopies:
    """The content of arrays, taken when it is made."""

    def __init__(self, arrays: list[bytearray]) -> None:
        self._pairs = [(memoryview(one), memoryview(bytearray(one))) for one in arrays]

    def take(self) -> None:
        """Take the present content."""
        for live, kept in self._pairs:
            kept[:] = live

    def put_back(self) -> None:
        """Restore the content."""
        for live, kept in self._pairs:
            live[:] = kept


def _arrays(found: TypedClass) -> Arrays:
    """Return the function that returns the arrays of an object of a class in plain Python."""
    names = tuple(found.arrays)
    return lambda part: tuple(getattr(part, name) for name in names)


def _plain() -> Tables:
    """Return the tables of the plain classes."""
    copied: dict[type, Sequence[str]] = {}
    arrays: dict[type, Arrays] = {}
    exchanged: dict[type, Sequence[str]] = {}
    for found in typed_classes(Path(__file__).parent):
        if found.copied or found.arrays:
            cls = getattr(importlib.import_module(found.module), found.name)
            if found.copied:
                copied[cls] = found.copied
            if found.arrays:
                arrays[cls] = _arrays(found)
            if found.exchanged:
                exchanged[cls] = found.exchanged
    object_copies = functools.partial(PlainObjectCopies, copied, exchanged)
    return Tables(copied, arrays, exchanged, object_copies, PlainArrayCopies)


def _compiled() -> Tables:
    """Return the tables of the compiled classes."""
    module = importlib.import_module("nctakt.kernel._state")
    return Tables(
        module.COPIED, module.ARRAYS, module.EXCHANGED, module.ObjectCopies, module.ArrayCopies
    )


_FOUND = _compiled() if is_compiled() else _plain()
COPIED = frozenset(_FOUND.copied)
ARRAYS = MappingProxyType(_FOUND.arrays)
EXCHANGED = frozenset(_FOUND.exchanged)
ObjectCopies = _FOUND.object_copies
ArrayCopies = _FOUND.array_copies
