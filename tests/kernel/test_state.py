# SPDX-License-Identifier: MIT
"""What a snapshot of the realtime part keeps: each field that the classes assign after building.

``kernel/state_fields.py`` finds numbers and arrays in the C types and names the other fields; here
it is compared with the assignments in the sources, so that a new field that is not copied shows
before a run differs. ``test_snapshot.py`` compares whole runs.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import nctakt
from nctakt.kernel import state_fields
from nctakt.kernel.state import ARRAYS, COPIED, EXCHANGED

SOURCES = Path(nctakt.__file__).parent

#: Fields that are assigned while the objects of a machine or of a cycle are built, and not later,
#: though a field of another class that has their name is.
BUILT = {
    "Channel": {"signals"},
    "ChannelLane": {"channel"},
    "AxisExchange": {"signals"},
    "SpindleExchange": {"signals"},
    "CAxis": {"spindles"},
    "CommandSpindle": {"direction"},
    "CompareTexts": {"count"},
    "CommandExecutor": {"signals"},
    "Copy": {"count"},
    "Kernel": {"plc"},
    "Index": {"count"},
    "NumberValue": {"number"},
    "PlcContext": {"counts", "distances", "near_left", "near_right", "notes"},
    "Routine": {"shared", "size", "body"},
}

Class = tuple[str, str]


CLASSES = {
    (found.module, found.name): found for found in state_fields.typed_classes(SOURCES / "kernel")
}


def lineage(cls: Class | None) -> Iterator[Class]:
    """A class and its bases."""
    while cls is not None:
        yield cls
        cls = CLASSES[cls].base


class Assignments:
    """Which fields are assigned after ``__init__``: by their own class, or from elsewhere."""

    def __init__(self) -> None:
        self.own: dict[Class, set[str]] = defaultdict(set)
        self.compiled: set[str] = set()
        self.anywhere: set[str] = set()
        for file in sorted(SOURCES.rglob("*.py")):
            module = ".".join(file.relative_to(SOURCES.parent).with_suffix("").parts)
            self._read(ast.parse(file.read_text("utf-8")), module, file)

    def _read(self, tree: ast.Module, module: str, file: Path) -> None:
        of_self = set()
        for cls in (node for node in tree.body if isinstance(node, ast.ClassDef)):
            building = {"__init__", *parts_of_init(cls)}
            for function in cls.body:
                for node in stores(function):
                    if isinstance(node.value, ast.Name) and node.value.id == "self":
                        of_self.add(node)
                        if getattr(function, "name", "") not in building:
                            self.own[module, cls.name].add(node.attr)
        others = {node.attr for node in stores(tree) if node not in of_self}
        self.anywhere |= others
        if file.with_suffix(".pxd").exists():
            self.compiled |= others


def parts_of_init(cls: ast.ClassDef) -> set[str]:
    """The methods of a class that only its ``__init__`` calls."""
    calls: dict[str, set[str]] = defaultdict(set)
    for function in cls.body:
        for node in ast.walk(function):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                if node.value.id == "self":
                    calls[node.attr].add(getattr(function, "name", ""))
    return {name for name, callers in calls.items() if callers == {"__init__"}}


def stores(tree: ast.AST) -> Iterator[ast.Attribute]:
    """The attributes that are assigned."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store | ast.Del):
            yield node


def test_each_field_that_changes_is_copied() -> None:
    """What a method other than ``__init__`` assigns, or somebody else, is in a copy."""
    assignments = Assignments()
    missing = []
    for cls, found in CLASSES.items():
        if found.name in state_fields.LEFT_OUT or found.module == state_fields.LEFT_OUT_MODULE:
            continue
        relatives = {other for other in CLASSES if cls in lineage(other)} | set(lineage(cls))
        own = set().union(*(assignments.own[relative] for relative in relatives))
        for name, typed in found.fields.items():
            holds_number = typed.kind in state_fields.NUMBERS
            is_foreign = name in assignments.compiled or (
                typed.is_public and name in assignments.anywhere
            )
            # Its translation builds the tree of a PLC; only what is kept changes later.
            is_foreign &= found.is_kept or not found.module.startswith("nctakt.kernel.st.")
            if name in own or (holds_number and is_foreign):
                if name not in {*found.copied, *BUILT.get(found.name, ())}:
                    missing.append(f"{found.name}.{name}")
    assert missing == []


def test_each_name_of_a_table_is_a_field() -> None:
    """The tables name classes and fields that there are: references, and arrays that are unread."""
    named = {**state_fields.REFERENCES, **state_fields.UNREAD}
    fields = {found.name: found.fields for found in CLASSES.values()}
    assert [name for name in named if not set(named[name]) <= set(fields[name])] == []
    others = {*state_fields.CHANGING_IN_TREES, *state_fields.LEFT_OUT}
    assert others <= fields.keys()


def test_both_forms_have_the_same_classes() -> None:
    """The compiled tables and the plain ones are for the classes that the C types name."""
    for table, kind in ((COPIED, "copied"), (ARRAYS, "arrays"), (EXCHANGED, "exchanged")):
        names = {(cls.__module__, cls.__name__) for cls in table}
        assert names == {key for key, found in CLASSES.items() if getattr(found, kind)}
