# SPDX-License-Identifier: MIT
"""What a snapshot of the realtime part keeps: each field that the classes assign after building.

``kernel/state/`` names the fields; here they are found in the sources, so that a new field that is
not copied shows before a run differs. ``test_snapshot.py`` compares whole runs.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import nctakt
from nctakt.kernel.state import axes, control, path

SOURCES = Path(nctakt.__file__).parent
MODULES = (axes, control, path)

#: Fields that are assigned while the objects of a machine or of a cycle are built, and not later,
#: though a field of another class that has their name is.
BUILT = {
    "Channel": {"signals"},
    "ChannelLane": {"channel"},
    "AxisExchange": {"signals"},
    "CAxis": {"spindles"},
    "ChannelSignals": {"named"},
    "CommandSpindle": {"direction"},
    "CompareTexts": {"count"},
    "CommandExecutor": {"signals"},
    "Copy": {"count"},
    "Index": {"count"},
    "NumberValue": {"number"},
    "SingleBlock": {"only_motions"},
    "ToolLife": {"counts_rapid"},
    "ToolLives": {"omits_zero"},
}
#: Classes without a part in snapshots, which have neither a shared image nor stops.
LEFT_OUT = {
    "BecomesTrue", "BlockUpToDepth", "Changes", "InterfaceImage", "SectionUnits", "SpindleUnits",
    "Stop", "Stops",
}  # fmt: skip
#: Arrays of which nothing is read before it is written again.
UNREAD = {"Record": {"events", "probes", "rows"}, "PathAxes": {"history_rows"}}
#: Expressions and statements of cycles have no arrays that the tick writes.
TREES = "nctakt.kernel.cycles."
WITH_ARRAYS = {"Context", "CycleManager"}

#: A line of a .pxd that declares fields.
FIELD = re.compile(
    r"    cdef (?P<access>readonly |public |)(?P<kind>[\w.\[\]: ]+?) (?P<names>\w+(?:, \w+)*)"
)

Class = tuple[str, str]


def declared() -> dict[Class, tuple[Class | None, dict[str, tuple[str, bool]]]]:
    """Each class of the realtime part: its base, and its fields with type and whether public."""
    found: dict[Class, tuple[Class | None, dict[str, tuple[str, bool]]]] = {}
    for file in sorted((SOURCES / "kernel").rglob("*.pxd")):
        module = ".".join(file.relative_to(SOURCES.parent).with_suffix("").parts)
        origins: dict[str, str] = {}
        fields: dict[str, tuple[str, bool]] = {}
        for line in file.read_text("utf-8").splitlines():
            words = line.split()
            if line.startswith("from") and "cimport" in words:
                origins |= dict.fromkeys("".join(words[3:]).split(","), words[1])
            elif line.startswith("cdef class"):
                name, _, base = line.removeprefix("cdef class ").rstrip("):").partition("(")
                fields = {}
                found[module, name] = ((origins.get(base, module), base) if base else None), fields
            elif (field := FIELD.fullmatch(line)) is not None:
                for name in field["names"].split(", "):
                    fields[name] = field["kind"], field["access"] == "public "
    return found


CLASSES = declared()


def lineage(cls: Class | None) -> Iterator[Class]:
    """A class and its bases."""
    while cls is not None:
        yield cls
        cls = CLASSES[cls][0]


class Assignments:
    """Which fields are assigned after ``__init__``: by their own class, or from elsewhere."""

    def __init__(self) -> None:
        self.own: dict[Class, set[str]] = defaultdict(set)
        self.compiled: set[str] = set()
        self.anywhere: set[str] = set()
        for file in sorted(SOURCES.rglob("*.py")):
            module = ".".join(file.relative_to(SOURCES.parent).with_suffix("").parts)
            if not module.startswith("nctakt.kernel.state"):
                self._read(ast.parse(file.read_text("utf-8")), module, file)

    def _read(self, tree: ast.Module, module: str, file: Path) -> None:
        of_self = set()
        for cls in (node for node in tree.body if isinstance(node, ast.ClassDef)):
            for function in cls.body:
                for node in stores(function):
                    if isinstance(node.value, ast.Name) and node.value.id == "self":
                        of_self.add(node)
                        if getattr(function, "name", "") != "__init__":
                            self.own[module, cls.name].add(node.attr)
        others = {node.attr for node in stores(tree) if node not in of_self}
        self.anywhere |= others
        if file.with_suffix(".pxd").exists():
            self.compiled |= others


def stores(tree: ast.AST) -> Iterator[ast.Attribute]:
    """The attributes that are assigned."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store | ast.Del):
            yield node


def module_text(module: ModuleType) -> str:
    """The source of a module of ``kernel/state``, compiled or not."""
    return (SOURCES / "kernel" / "state" / f"{module.__name__.split('.')[-1]}.py").read_text(
        "utf-8"
    )


def copied() -> dict[str, set[str]]:
    """The fields that are copied, by class."""
    found = defaultdict(set)
    for module in MODULES:
        for function in ast.parse(module_text(module)).body:
            if isinstance(function, ast.FunctionDef) and function.name.startswith("copy_"):
                assert isinstance(function.args.args[1].annotation, ast.Name)
                cls = function.args.args[1].annotation.id
                found[cls] |= {node.attr for node in stores(function)}
    return found


def with_arrays() -> dict[str, set[str]]:
    """The fields whose memory is kept, by class."""
    found = defaultdict(set)
    for module in MODULES:
        for function in ast.parse(module_text(module)).body:
            if isinstance(function, ast.FunctionDef) and function.name.startswith("arrays_of_"):
                assert isinstance(function.args.args[0].annotation, ast.Name)
                cls = function.args.args[0].annotation.id
                found[cls] |= {
                    node.attr for node in ast.walk(function) if isinstance(node, ast.Attribute)
                }
    return found


def is_built(cls: Class) -> bool:
    """Whether a class has a part in snapshots."""
    return cls[1] not in LEFT_OUT and not cls[0].endswith("tick.stops")


def test_each_field_that_changes_is_copied() -> None:
    """What a method other than ``__init__`` assigns, or somebody else, stands in a copy."""
    assignments, kept = Assignments(), copied()
    missing = []
    for cls, (_, fields) in CLASSES.items():
        if not is_built(cls):
            continue
        relatives = {other for other in CLASSES if cls in lineage(other)} | set(lineage(cls))
        own = set().union(*(assignments.own[relative] for relative in relatives))
        for name, (kind, is_public) in fields.items():
            holds_number = kind in {"bint", "double", "int", "long long", "Py_ssize_t"}
            is_foreign = name in assignments.compiled or (
                is_public and name in assignments.anywhere
            )
            if name in own or (holds_number and is_foreign):
                if name not in kept[cls[1]] | BUILT.get(cls[1], set()):
                    missing.append(f"{cls[1]}.{name}")
    assert missing == []


def test_each_array_is_kept() -> None:
    """The memory of each array of a machine's objects is kept, as long as it is read again."""
    kept = with_arrays()
    missing = []
    for cls, (_, fields) in CLASSES.items():
        if not is_built(cls) or (cls[0].startswith(TREES) and cls[1] not in WITH_ARRAYS):
            continue
        for name, (kind, _) in fields.items():
            if kind.endswith("[::1]") and name not in kept[cls[1]] | UNREAD.get(cls[1], set()):
                missing.append(f"{cls[1]}.{name}")
    assert missing == []


def test_each_function_is_used() -> None:
    """The tables hold all functions, each for its class."""
    for module in MODULES:
        functions = {name for name in vars(module) if name.startswith(("copy_", "arrays_of_"))}
        used = {one.__name__ for one in [*module.COPIERS.values(), *module.ARRAYS.values()]}
        assert functions == used
