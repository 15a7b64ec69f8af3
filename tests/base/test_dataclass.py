# SPDX-License-Identifier: MIT
"""Dataclasses with methods that are written late do what those of the standard library do."""

from __future__ import annotations

import ast
import copy
import dataclasses
import inspect
import pickle
from dataclasses import field
from pathlib import Path
from typing import Any

import pytest

import nctakt
from nctakt.base.dataclass import dataclass, write_initialisers

PACKAGE = Path(nctakt.__file__).parent


@dataclass(frozen=True, slots=True)
class Point:
    """A frozen one."""

    x: float
    y: float = 0.0
    names: dict[str, int] = field(default_factory=dict, compare=False)


@dataclass(frozen=True, slots=True)
class Named(Point):
    """A derived one."""

    name: str = ""


@dataclass(slots=True)
class Counter:
    """A mutable one, whose creation takes some work."""

    count: int = 0

    def __post_init__(self) -> None:
        self.count += 1


@dataclass(frozen=True, slots=True, order=True)
class Version:
    """One with an order."""

    major: int
    minor: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """One whose fields have to be named."""

    width: int
    height: int = 2


@dataclass(frozen=True, slots=True, repr=False, eq=False)
class Own:
    """One with its own methods."""

    x: int

    def __repr__(self) -> str:
        return "own"


@dataclass(frozen=True, slots=True)
class Node:
    """One that may contain itself."""

    inner: list[Any]


def test_fields_are_given_by_place_by_name_or_by_default() -> None:
    """Each object has its own default where a function makes it."""
    one, other = Point(1, y=2), Point(1)
    assert (one.x, one.y, other.y) == (1, 2, 0.0)
    assert one.names == {} and one.names is not other.names
    assert Named(1, 2, {}, "a").name == "a"
    assert Options(width=1).height == 2
    assert Counter(4).count == 5


def test_wrong_arguments_are_refused() -> None:
    """Those that are missing, unknown, or given by place where a name is due."""
    point: Any = Point
    options: Any = Options
    for call in (point, lambda: point(1, z=2), lambda: options(1)):
        with pytest.raises(TypeError):
            call()


def test_a_representation_shows_all_fields() -> None:
    """An own one stays; one within itself is shown as dots."""
    assert repr(Named(1, 2.5, {"a": 1}, "n")) == "Named(x=1, y=2.5, names={'a': 1}, name='n')"
    assert repr(Own(1)) == "own"
    node = Node([])
    node.inner.append(node)
    assert repr(node) == "Node(inner=[...])"


def test_equality_and_order_go_by_the_fields() -> None:
    """Of one class only, and without the fields that are not compared."""
    assert Point(1, 2, {"a": 1}) == Point(1, 2)
    assert Point(1) != Named(1)
    assert hash(Point(1, 2, {"a": 1})) == hash(Point(1, 2)) == hash((1, 2))
    assert Own(1) != Own(1)
    assert len({Own(1), Own(1)}) == 2
    assert Version(1, 2) < Version(1, 3) <= Version(1, 3)
    assert max(Version(2, 0), Version(1, 9)) == Version(2, 0) > Version(1, 9) >= Version(1, 8)
    with pytest.raises(TypeError):
        hash(Counter())


def test_frozen_ones_cannot_be_changed() -> None:
    """Neither set nor deleted, nor are there other attributes."""
    point: Any = Point(1)
    for name in ("x", "other"):
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            setattr(point, name, 2)
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            delattr(point, name)
    counter: Any = Counter()
    counter.count = 7
    with pytest.raises(AttributeError):
        counter.other = 1


def test_the_standard_library_knows_them() -> None:
    """Fields, replacement, dictionaries, copies, pickles, patterns, signatures."""
    named = Named(1, 2, {"a": 1}, "n")
    assert [one.name for one in dataclasses.fields(named)] == ["x", "y", "names", "name"]
    assert dataclasses.replace(named, x=5) == Named(5, 2, {}, "n")
    assert dataclasses.asdict(named) == {"x": 1, "y": 2, "names": {"a": 1}, "name": "n"}
    for again in (copy.copy(named), copy.deepcopy(named), pickle.loads(pickle.dumps(named))):
        assert again == named
        assert again.names == {"a": 1}
    match named:
        case Point(x, y):
            assert (x, y) == (1, 2)
    assert list(inspect.signature(Options).parameters) == ["width", "height"]
    assert str(inspect.signature(Version)) == "(major: 'int', minor: 'int')"


def test_methods_are_written_when_they_are_first_called() -> None:
    """Importing a class costs none of them."""

    @dataclass(frozen=True, slots=True)
    class Fresh:
        x: int

    def is_written(name: str) -> bool:
        return inspect.isfunction(Fresh.__dict__[name])

    assert not is_written("__init__")
    one = Fresh(1)
    assert is_written("__init__")
    assert not is_written("__hash__") and not is_written("__eq__")
    assert one in {Fresh(1)}
    assert is_written("__hash__") and is_written("__eq__")


def test_all_initialisers_are_written_at_once_where_that_is_wanted() -> None:
    """What is copied often has them then, and no copy writes its own; all else stays as it is."""

    @dataclass(slots=True)
    class Fresh:
        x: int

    write_initialisers()
    assert inspect.isfunction(Fresh.__dict__["__init__"])
    assert not inspect.isfunction(Fresh.__dict__["__eq__"])
    assert Fresh(1) == Fresh(1)


@pytest.mark.slow
def test_no_module_uses_those_of_the_standard_library() -> None:
    """They would take their time in each start of the command.

    A structure of OPC UA is one that its library reads.
    """
    found = {
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if "dataclass" in names(node) and getattr(node, "module", "") == "dataclasses"
    }
    assert found == {"base/dataclass.py", "servers/opcua/model/position.py"}


def names(node: ast.AST) -> list[str]:
    """Return what an import takes from its module."""
    return [one.name for one in getattr(node, "names", ()) if isinstance(one, ast.alias)]
