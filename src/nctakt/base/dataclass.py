# SPDX-License-Identifier: MIT
"""Dataclasses whose methods are written when they are first called.

The standard library writes and compiles up to eight functions for each class as soon as its module
is imported: for some three hundred classes that took more than half of the time from the start of
the command to the first tick. Here importing a class costs a tenth, and only those that a run
uses get their methods. Otherwise they are the standard library's dataclasses with slots:
``fields``, ``replace``, ``match``, ``copy`` and ``pickle`` know them.
"""

from __future__ import annotations

import dataclasses
import reprlib
from collections.abc import Callable
from dataclasses import field
from typing import TYPE_CHECKING, Any, NoReturn

__all__ = ["dataclass", "field", "write_initialisers"]

_initialised: list[type[Any]] = []

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(
        *, slots, frozen=False, init=True, repr=True, eq=True, order=False, kw_only=False
    ):
        """Return a decorator that makes a class a dataclass; ``slots`` is ``True``."""
        assert slots
        bare = dataclasses.dataclass(init=False, repr=False, eq=False, slots=True, kw_only=kw_only)

        def decorate(written):
            cls = bare(written)
            methods = {}
            if init:
                _initialised.append(cls)
                methods["__init__"] = _Method(cls, "__init__", _frozen_init if frozen else _init)
            if repr:
                methods["__repr__"] = _repr
            if eq:
                methods["__eq__"] = _Method(cls, "__eq__", _comparison)
            if order:
                methods |= {name: _Method(cls, name, _comparison) for name in _SIGNS}
            if frozen:
                methods |= _FROZEN
                methods["__getstate__"] = _Method(cls, "__getstate__", _get_state)
                methods["__setstate__"] = _Method(cls, "__setstate__", _set_state)
            for name, method in methods.items():
                if name not in written.__dict__:
                    setattr(cls, name, method)
            # Python itself sets None if a class has __eq__ and no __hash__.
            if eq and written.__dict__.get("__hash__") is None:
                cls.__hash__ = _Method(cls, "__hash__", _hash) if frozen else None
            return cls

        return decorate


def write_initialisers() -> None:
    """Write ``__init__`` of all classes so far that has not been called yet: some 30 ms."""
    for cls in _initialised:
        _ = cls.__init__


_Class = type[Any]
_Function = Callable[..., Any]


class _Method:
    """A method that is written and takes this place when it is first looked up."""

    __slots__ = ("cls", "name", "write")

    def __init__(self, cls: _Class, name: str, write: Callable[[_Class, str], _Function]) -> None:
        self.cls = cls
        self.name = name
        self.write = write

    def __get__(self, instance: object, owner: _Class | None = None) -> _Function:
        method: Any = self.write(self.cls, self.name)
        setattr(self.cls, self.name, method)
        bound: _Function = method if instance is None else method.__get__(instance)
        return bound


_SIGNS = {"__eq__": "==", "__lt__": "<", "__le__": "<=", "__gt__": ">", "__ge__": ">="}


def _written(
    cls: _Class, name: str, parameters: list[str], lines: list[str], scope: dict[str, Any]
) -> _Function:
    """Return the function with this body."""
    text = f"def {name}({', '.join(parameters)}):\n " + "\n ".join(lines)
    exec(text, scope)
    function: _Function = scope[name]
    function.__module__ = cls.__module__
    function.__qualname__ = f"{cls.__qualname__}.{name}"
    return function


def _init(cls: _Class, name: str) -> _Function:
    return _initialiser(cls, name, "self.{0} = {1}")


def _frozen_init(cls: _Class, name: str) -> _Function:
    return _initialiser(cls, name, "_set_{0}(self, {1})")


def _initialiser(cls: _Class, name: str, assignment: str) -> _Function:
    """Return ``__init__``; that of a frozen class goes past ``__setattr__`` to the slots."""
    scope: dict[str, Any] = {"_missing": dataclasses.MISSING}
    lines: list[str] = []
    parameters = {False: ["self"], True: ["*"]}  # by whether they have to be named
    for member in dataclasses.fields(cls):
        parameter = value = member.name
        scope[f"_set_{member.name}"] = getattr(cls, member.name).__set__
        if member.default is not dataclasses.MISSING:
            scope[f"_default_{member.name}"] = member.default
            parameter = f"{member.name}=_default_{member.name}"
        elif member.default_factory is not dataclasses.MISSING:
            scope[f"_new_{member.name}"] = member.default_factory
            parameter = f"{member.name}=_missing"
            value = f"_new_{member.name}() if {member.name} is _missing else {member.name}"
        parameters[member.kw_only is True].append(parameter)
        lines.append(assignment.format(member.name, value))
    if hasattr(cls, "__post_init__"):
        lines.append("self.__post_init__()")
    keyword_only = parameters[True] if len(parameters[True]) > 1 else []
    method = _written(cls, name, [*parameters[False], *keyword_only], lines or ["pass"], scope)
    method.__annotations__ = {member.name: member.type for member in dataclasses.fields(cls)}
    return method


def _values(cls: _Class, owner: str) -> str:
    """Return the text of a tuple with the values of all fields that are compared."""
    names = [member.name for member in dataclasses.fields(cls) if member.compare]
    return f"({''.join(f'{owner}.{name}, ' for name in names)})"


def _comparison(cls: _Class, name: str) -> _Function:
    both = f"{_values(cls, 'self')} {_SIGNS[name]} {_values(cls, 'other')}"
    line = f"return {both} if other.__class__ is self.__class__ else NotImplemented"
    return _written(cls, name, ["self", "other"], [line], {})


def _hash(cls: _Class, name: str) -> _Function:
    return _written(cls, name, ["self"], [f"return hash({_values(cls, 'self')})"], {})


@reprlib.recursive_repr()
def _repr(self: Any) -> str:
    shown = (member.name for member in dataclasses.fields(self) if member.repr)
    values = ", ".join(f"{name}={getattr(self, name)!r}" for name in shown)
    return f"{type(self).__qualname__}({values})"


def _set(_self: object, name: str, _value: object) -> NoReturn:
    raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")


def _delete(_self: object, name: str) -> NoReturn:
    raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")


def _get_state(cls: _Class, name: str) -> _Function:
    names = "".join(f"self.{member.name}, " for member in dataclasses.fields(cls))
    return _written(cls, name, ["self"], [f"return ({names})"], {})


def _set_state(cls: _Class, name: str) -> _Function:
    """Return ``__setstate__``, which goes past ``__setattr__`` to the slots."""
    names = [member.name for member in dataclasses.fields(cls)]
    scope = {f"_set_{name}": getattr(cls, name).__set__ for name in names}
    lines = [f"{', '.join(names)}, = state"] if names else []
    lines += [f"_set_{name}(self, {name})" for name in names]
    return _written(cls, name, ["self", "state"], lines or ["pass"], scope)


_FROZEN = {
    "__setattr__": _set,
    "__delattr__": _delete,
}
