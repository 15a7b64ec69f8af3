# SPDX-License-Identifier: MIT
"""The objects around a realtime part at some moment, restored in place.

In: an object that leads to all others. Out: ``KeptObjects``, which puts back the attributes of each
object and the content of each container. Memory and objects of the realtime part are not among
them: a ``Snapshot`` has these.
"""

from __future__ import annotations

import array
import functools
import types
from collections import deque
from collections.abc import Iterable, Iterator
from decimal import Decimal
from fractions import Fraction
from os import stat_result
from pathlib import Path
from typing import Any

from nctakt.base.mode import is_compiled
from nctakt.run.kept_content import KeptContent

#: Types that never change, regardless of content.
_UNCHANGING = (
    bool, bytes, complex, float, frozenset, int, range, str, type, types.BuiltinFunctionType,
    types.ModuleType, types.NoneType, Decimal, Fraction, Path, property, stat_result,
)  # fmt: skip
#: Packages whose objects never change, and those of the realtime part.
_LEFT_OUT = tuple(
    f"nctakt.{name}."
    for name in ("files", "hli", "kernel", "lists", "messages", "nc.tree", "nc.vocabulary")
)
#: Objects shared by runs: programs and cycles, and how expressions are evaluated.
_SHARED = (
    "Diagnostic",
    "KeptTrees",
    "MachineNames",
    "Message",
    "Plans",
    "ProgramText",
    "RealtimePart",
    "Section",
)
#: Attributes of compiled classes that change. Their other attributes are written before they are
#: read.
_COMPILED = {
    "BoundValue": (),
    "InputNotes": ("cells", "is_listening"),
    "TemplateEvaluator": (),
    "TransformedTravel": ("number",),
}


class NotKeptError(Exception):
    """An object whose content is unknown, or that cannot be restored."""


class KeptObjects:
    """The objects reachable from ``root``, in their present state.

    ``replaced``: attributes that get new values on restoring, such as iterators; ``without``:
    objects that are left alone. Containers in objects of the classes ``renewed`` become new ones,
    so that a copy of such an object keeps the old ones. Raises ``NotKeptError``.
    """

    def __init__(
        self,
        root: object,
        replaced: Iterable[str] = (),
        renewed: tuple[type, ...] = (),
        without: Iterable[object] = (),
    ) -> None:
        self._replaced = frozenset(replaced)
        self._renewed = renewed
        self._without = list(without)
        self._content = KeptContent(self._replaced)
        self._held: list[object] = []
        self._walk(root)

    def put_back(self) -> None:
        """Restore everything."""
        self._content.put_back()

    # --- finding them ---------------------------------------------------------------------------

    def _walk(self, root: object) -> None:
        waiting, known = [root], {id(root), *map(id, self._without)}
        while waiting:
            one = waiting.pop()
            self._held.append(one)  # so that no other object gets its number
            for held in self._reached(one):
                if id(held) not in known and not isinstance(held, _UNCHANGING):
                    known.add(id(held))
                    waiting.append(held)

    def _reached(self, one: Any) -> Iterable[object]:
        """Note the kept part of an object; return the objects that it refers to."""
        kind = type(one)
        if isinstance(one, tuple):
            return iter(one)
        if kind is list or isinstance(one, dict | set | deque):
            self._content.keep_container(one)
            return [*one, *one.values()] if isinstance(one, dict) else list(one)
        if kind is memoryview:
            return (one.obj,)
        if kind is bytearray:
            self._content.keep_container(one)
            return ()
        if isinstance(one, array.array):
            raise NotKeptError(kind)
        if kind is types.MappingProxyType:
            return list(one.values())
        return self._of_function(one) if callable(one) else self._of_object(one)

    def _of_function(self, one: Any) -> Iterable[object]:
        if isinstance(one, types.MethodType | types.MethodWrapperType):
            return (one.__self__,)
        if isinstance(one, functools.partial):
            return (one.func, *one.args, *one.keywords.values())
        if isinstance(one, types.FunctionType):
            return [cell.cell_contents for cell in one.__closure__ or ()]
        if type(one).__name__ in ("cython_function_or_method", "builtin_function_or_method"):
            return (getattr(one, "__self__", None),)
        return self._of_object(one)

    def _of_object(self, one: Any) -> Iterable[object]:
        kind = type(one)
        module = kind.__module__
        if not module.startswith("nctakt."):
            raise NotKeptError(f"{module}.{kind.__qualname__}")
        if module.startswith(_LEFT_OUT) or kind.__name__ in _SHARED:
            return ()
        kept = {}
        values = []
        for name in _attributes(one):
            if name in self._replaced:
                continue
            if not hasattr(one, name):
                self._content.keep_empty(one, name)
                continue
            value = getattr(one, name)
            if isinstance(one, self._renewed) and type(value) in (list, dict, set):
                self._content.keep_new(one, name, value)
                values += [*value, *(value.values() if isinstance(value, dict) else ())]
            else:
                kept[name] = value
        if not any(map(_is_frozen, kind.__mro__)):
            self._keep(one, kept)
        return [*values, *kept.values()]

    def _keep(self, one: object, kept: dict[str, Any]) -> None:
        attributes = getattr(one, "__dict__", None)
        if attributes is not None and attributes.keys() >= kept.keys():
            self._content.keep_attributes(attributes, kept)
        else:
            for name, value in kept.items():
                self._content.keep_slot(one, name, value)


def _attributes(one: object) -> Iterator[str]:
    """Yield the names of an object's attributes; raises ``NotKeptError`` if they do not show."""
    kind = type(one)
    yield from getattr(one, "__dict__", ())
    slots = [vars(cls)["__slots__"] for cls in kind.__mro__ if "__slots__" in vars(cls)]
    for names in slots:
        yield from (names,) if isinstance(names, str) else names
    if slots or hasattr(one, "__dict__"):
        return
    if not is_compiled() or kind.__name__ not in _COMPILED:
        raise NotKeptError(f"{kind.__module__}.{kind.__qualname__}")
    yield from _COMPILED[kind.__name__]


@functools.cache
def _is_frozen(kind: type[Any]) -> bool:
    """Return whether a class redefines assignment, as frozen dataclasses do to refuse it."""
    return kind is not object and "__setattr__" in vars(kind)
