# SPDX-License-Identifier: MIT
"""The house's own rules, checked in its files: what no compiler and no linter sees.

The realtime part is Python with C types in a ``.pxd`` beside each module. A class or a method that
is missing there compiles without a word and is never called from the tick; these tests compare the
two files. Others hold the direction of imports, and keep clocks and chance out.
"""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "src" / "nctakt"
KERNEL = PACKAGE / "kernel"
MODULES = sorted(path.stem for path in KERNEL.glob("*.py") if path.stem != "__init__")
SOURCES = sorted(PACKAGE.rglob("*.py"))
PXD = sorted(PACKAGE.rglob("*.pxd"))

#: Who may import whom: only what stands in an earlier line. Modules of one line do not see another.
STAGES = (
    ("mode", "diagnostics"),
    ("messages",),
    ("failure", "text", "sources", "options"),
    ("long_text",),
    ("lists",),
    ("schedule",),
    ("machines",),
    ("nc",),
    ("kernel",),
    ("decoder",),
    ("trace",),
    ("reference", "results", "plots"),
    ("hli",),
    ("access", "image", "spindles"),
    ("budget", "registry"),
    ("assembly",),
    ("awaited", "interface", "loading", "runtime_errors", "stimuli"),
    ("checking", "feed", "plc", "recording"),
    ("channelrun",),
    ("pace",),
    ("controller",),
    ("linux",),
    ("cli", "testing"),
    ("__main__",),
)

#: Longer than a file should be, with the reason.
LONG_FILES = {
    "kernel/expressions.py": "one small class for each operator and function",
    "nc/syntax.py": "one small class for each node of the tree",
}

#: The only remainders outside ``arithmetic``: places in rings, of numbers that are never negative.
RING_SIZES = ("self.capacity", "self.ring_size")

DIRECTIVES = (
    "language_level=3",
    "boundscheck=False",
    "wraparound=False",
    "cdivision=True",
    "initializedcheck=False",
    "nonecheck=False",
    "annotation_typing=False",
)

NOT_DETERMINISTIC = ("time", "datetime", "random", "threading", "secrets", "uuid")


# --- reading .py and .pxd ----------------------------------------------------------------------


@dataclass
class Declared:
    """What a .pxd says of one class; the class ``""`` holds the module's functions."""

    base: str
    methods: set[str] = field(default_factory=set)
    fields: set[str] = field(default_factory=set)


def declarations(module: str) -> dict[str, Declared]:
    """The classes of a .pxd file."""
    found = {"": Declared("")}
    current = found[""]
    for line in (KERNEL / f"{module}.pxd").read_text("utf-8").splitlines():
        if match := re.match(r"cdef class (\w+)(?:\((\w+)\))?:", line):
            current = found.setdefault(match[1], Declared(match[2] or "object"))
        elif match := re.match(r"(\s*)cp?def [\w\[:\], ]*?\b(\w+)\(", line):
            owner = current if match[1] else found[""]
            owner.methods.add(match[2])
        elif match := re.match(r"(\s*)cdef [\w\[:\]. ]*?\b(\w+)$", line):
            owner = current if match[1] else found[""]
            owner.fields.add(match[2])
    return found


def tree_of(path: Path) -> ast.Module:
    """The syntax tree of a Python file."""
    return ast.parse(path.read_text("utf-8"))


def classes(module: str) -> dict[str, ast.ClassDef]:
    """The classes of a realtime module."""
    tree = tree_of(KERNEL / f"{module}.py")
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


def functions(module: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """All functions of a realtime module with the class that they stand in, "" for none."""
    for node in tree_of(KERNEL / f"{module}.py").body:
        if isinstance(node, ast.FunctionDef):
            yield "", node
        elif isinstance(node, ast.ClassDef):
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield node.name, member


ALL_DECLARED = {module: declarations(module) for module in MODULES}
BY_CLASS = {name: found for part in ALL_DECLARED.values() for name, found in part.items() if name}


def ancestors(name: str) -> Iterator[Declared]:
    """The declared classes above a class."""
    while name in BY_CLASS:
        name = BY_CLASS[name].base
        if name in BY_CLASS:
            yield BY_CLASS[name]


def tick_functions(module: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """The functions of a module that its .pxd declares: they run without Python objects."""
    for owner, function in functions(module):
        if function.name in ALL_DECLARED[module][owner].methods:
            yield owner, function


# --- .py against .pxd --------------------------------------------------------------------------


def test_each_realtime_module_has_its_types() -> None:
    """Each module of the realtime part has a .pxd of the same name, and no .pxd is alone."""
    assert sorted(path.stem for path in KERNEL.glob("*.pxd")) == MODULES


@pytest.mark.parametrize("module", MODULES)
def test_every_class_is_declared_with_its_base(module: str) -> None:
    """A class missing in the .pxd would compile as a Python class whose methods no tick calls."""
    written = {
        name: ast.unparse(node.bases[0]) if node.bases else "object"
        for name, node in classes(module).items()
    }
    declared = {name: found.base for name, found in ALL_DECLARED[module].items() if name}
    assert declared == written


@pytest.mark.parametrize("module", MODULES)
def test_every_declared_method_is_written(module: str) -> None:
    """The .pxd declares nothing that the module lacks."""
    written: dict[str, set[str]] = {name: set() for name in ("", *classes(module))}
    for owner, function in functions(module):
        written[owner].add(function.name)
    missing = {
        name: found.methods - written[name]
        for name, found in ALL_DECLARED[module].items()
        if found.methods - written[name]
    }
    assert missing == {}


@pytest.mark.parametrize("module", MODULES)
def test_overriding_methods_are_declared_again(module: str) -> None:
    """A method that a class above declares is declared in each class that overrides it."""
    undeclared = [
        f"{owner}.{function.name}"
        for owner, function in functions(module)
        if owner
        and function.name not in ALL_DECLARED[module][owner].methods
        and any(function.name in above.methods for above in ancestors(owner))
    ]
    assert undeclared == []


@pytest.mark.parametrize("module", MODULES)
def test_every_field_is_declared(module: str) -> None:
    """Each attribute that a class gives itself stands in its .pxd or in that of a class above."""
    undeclared = []
    for name, node in classes(module).items():
        known = set(ALL_DECLARED[module][name].fields)
        for above in ancestors(name):
            known |= above.fields
        undeclared += [
            f"{name}.{target.attr}"
            for target in ast.walk(node)
            if isinstance(target, ast.Attribute)
            and isinstance(target.ctx, ast.Store)
            and ast.unparse(target.value) == "self"
            and target.attr not in known
        ]
    assert undeclared == []


@pytest.mark.parametrize("module", MODULES)
def test_the_tick_calls_only_declared_functions(module: str) -> None:
    """A function of the tick calls nothing that only Python's side knows."""
    declared = {
        name for part in ALL_DECLARED.values() for cls in part.values() for name in cls.methods
    }
    library = {"min", "max", "int", "sqrt", "fmod", "fabs", "log", "log10", "exp", "pow", "floor"}
    library |= {"asin", "acos", "atan", "atan2", "range"}
    unknown = []
    for owner, function in tick_functions(module):
        for call in ast.walk(function):
            if isinstance(call, ast.Call):
                name = ast.unparse(call.func).rsplit(".", 1)[-1]
                if name not in declared | library and not name[0].isupper():
                    unknown.append(f"{owner}.{function.name}: {name}")
    assert unknown == []


# --- what compiled and plain do differently -----------------------------------------------------


@pytest.mark.parametrize("module", MODULES)
def test_nothing_is_asserted_in_the_tick(module: str) -> None:
    """An assert in code without Python objects is printed and ignored: a fault code instead."""
    found = [
        f"{owner}.{function.name}"
        for owner, function in tick_functions(module)
        if any(isinstance(node, ast.Assert | ast.Raise | ast.Try) for node in ast.walk(function))
    ]
    assert found == []


def is_ring_place(node: ast.BinOp) -> bool:
    """A remainder by a ring's size."""
    return isinstance(node.op, ast.Mod) and ast.unparse(node.right) in RING_SIZES


@pytest.mark.parametrize("module", [one for one in MODULES if one != "arithmetic"])
def test_delicate_arithmetic_stands_in_one_module(module: str) -> None:
    """What differs between compiled and plain (``%``, ``**``, ``hypot``) is in ``arithmetic``."""
    found = []
    for owner, function in tick_functions(module):
        for node in ast.walk(function):
            operation = getattr(node, "op", None)
            if isinstance(operation, ast.Mod | ast.FloorDiv | ast.Pow):
                if not (isinstance(node, ast.BinOp) and is_ring_place(node)):
                    found.append(f"{owner}.{function.name}: {ast.unparse(node)}")
            if isinstance(node, ast.Attribute) and node.attr in ("hypot", "floor", "ceil", "trunc"):
                if ast.unparse(node.value) == "math":
                    found.append(f"{owner}.{function.name}: {ast.unparse(node)}")
    assert found == []


@pytest.mark.parametrize("module", MODULES)
def test_the_compilers_directives_are_those_of_all(module: str) -> None:
    """Each realtime module carries the same directives behind its licence."""
    directives = directives_of(module)
    assert directives == directives_of("arithmetic")
    assert set(DIRECTIVES) <= set(directives)


def directives_of(module: str) -> list[str]:
    """The compiler's directives in a module's second and third line."""
    lines = (KERNEL / f"{module}.py").read_text("utf-8").splitlines()[1:3]
    assert all(line.startswith("# cython: ") for line in lines), lines
    return [one for line in lines for one in line.removeprefix("# cython: ").split(", ")]


def test_exactly_the_realtime_modules_are_built() -> None:
    """pyproject.toml builds each module that has a .pxd, and the part that runs schedules."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    built = project["tool"]["setuptools"]["ext-modules"]
    names = {one["name"]: one for one in built}
    assert list(names) == sorted(names)
    runner = names.pop("nctakt.linux.processes")
    written = sorted(path.relative_to(ROOT).as_posix() for path in PACKAGE.glob("linux/*.c"))
    assert (runner["sources"], runner["optional"]) == (written, True)
    # A .pxd of C functions alone stands in for its module wherever it is cimported.
    with_code = [path for path in PXD if "cdef extern" not in path.read_text("utf-8")]
    typed = sorted(path.relative_to(PACKAGE.parent).with_suffix("") for path in with_code)
    assert list(names) == [".".join(path.parts) for path in typed]
    for name, one in names.items():
        assert one["sources"] == [f"src/{name.replace('.', '/')}.py"]
        assert one["optional"] is True
        if name.startswith("nctakt.kernel."):
            assert "-ffp-contract=off" in one["extra-compile-args"]


@pytest.mark.parametrize(
    "path", [one for one in PXD if one.parent != KERNEL], ids=lambda one: one.stem
)
def test_types_fit_the_module(path: Path) -> None:
    """Outside of the realtime part, too, a .pxd fits the classes and methods of its module."""
    text = path.read_text("utf-8")
    tree = tree_of(path.with_suffix(".py"))
    found = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    assert sorted(re.findall(r"cdef class (\w+)", text)) == sorted(found)
    methods = [
        member.name
        for node in found.values()
        for member in node.body
        if isinstance(member, ast.FunctionDef)
    ]
    assert set(re.findall(r"^    cp?def [\w ]*?(\w+)\(", text, re.MULTILINE)) <= set(methods)
    fields = re.findall(r"^    cdef (?:readonly )?[\w\[:\] ]*?(\w+)$", text, re.MULTILINE)
    given = {
        target.attr
        for target in ast.walk(tree)
        if isinstance(target, ast.Attribute)
        and isinstance(target.ctx, ast.Store)
        and ast.unparse(target.value) == "self"
    }
    assert set(fields) == given


# --- determinism --------------------------------------------------------------------------------


def imports(path: Path) -> Iterator[str]:
    """The modules that a file imports, those of ``from package import module`` too."""
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def test_nobody_but_the_command_line_reads_a_clock() -> None:
    """Clocks, chance and threads stand in no module that a run depends on."""
    found = [
        f"{path.relative_to(PACKAGE)}: {name}"
        for path in SOURCES
        if path.relative_to(PACKAGE).parts[0] not in ("cli", "linux", "schedule")
        for name in imports(path)
        if name.split(".")[0] in NOT_DETERMINISTIC
    ]
    assert found == []


def iterables(tree: ast.Module) -> Iterator[ast.expr]:
    """What loops and comprehensions walk through."""
    for node in ast.walk(tree):
        if isinstance(node, ast.For):
            yield node.iter
        elif isinstance(node, ast.comprehension):
            yield node.iter


def is_set(node: ast.expr, names: set[str]) -> bool:
    """Whether an expression is a set, as far as the text tells."""
    if isinstance(node, ast.Set | ast.SetComp):
        return True
    if isinstance(node, ast.Call):
        return ast.unparse(node.func) in ("set", "frozenset")
    return isinstance(node, ast.Name) and node.id in names


@pytest.mark.parametrize("folder", ["kernel", "decoder"])
def test_nobody_walks_through_a_set(folder: str) -> None:
    """The order of a set changes from run to run, so none is walked through."""
    found = []
    for path in sorted((PACKAGE / folder).glob("*.py")):
        tree = tree_of(path)
        names = {
            ast.unparse(target)
            for node in ast.walk(tree)
            if isinstance(node, ast.Assign) and is_set(node.value, set())
            for target in node.targets
        }
        found += [
            f"{path.name}: {ast.unparse(one)}" for one in iterables(tree) if is_set(one, names)
        ]
    assert found == []


# --- the house ----------------------------------------------------------------------------------


def stage_of(module: str) -> int:
    """The number of the line in ``STAGES`` that holds a module of the package."""
    first = module.split(".")[1] if "." in module else ""
    for number, names in enumerate(STAGES):
        if first in names:
            return number
    raise AssertionError(f"{module} has no place in STAGES")


def test_imports_go_in_one_direction() -> None:
    """A stage imports only stages above it, and the realtime part nothing but itself."""
    wrong = []
    for path in SOURCES:
        parts = path.relative_to(PACKAGE).with_suffix("").parts
        own = parts[0]
        if own in ("__init__", "machines"):
            continue
        for name in imports(path):
            if not name.startswith("nctakt."):
                continue
            other = name.split(".")[1]
            if not (PACKAGE / other).is_dir() and not (PACKAGE / f"{other}.py").exists():
                continue
            allowed = other == own or stage_of(name) < stage_of(f"nctakt.{own}")
            if own == "kernel":
                allowed = other in (own, "mode")
            if not allowed and not under_type_checking(path, name):
                wrong.append(f"{'.'.join(parts)} -> {name}")
    assert wrong == []


def under_type_checking(path: Path, module: str) -> bool:
    """Whether a module is imported for its types only."""
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            return any(
                isinstance(one, ast.ImportFrom) and one.module == module for one in node.body
            )
    return False


def test_every_file_names_its_licence() -> None:
    """The first line of each source and test file is its licence."""
    files = [*SOURCES, *PACKAGE.rglob("*.pxd"), *(ROOT / "tests").rglob("*.py")]
    files += [*PACKAGE.glob("linux/*.[ch]"), *(ROOT / "examples").rglob("*.c")]
    line = "# SPDX-License-Identifier: MIT\n"
    missing = [
        str(path.relative_to(ROOT))
        for path in files
        if not path.read_text("utf-8").startswith((line, line.replace("#", "/*")[:-1] + " */\n"))
    ]
    assert missing == []


def test_every_module_says_what_it_is_for() -> None:
    """Each module opens with a docstring."""
    missing = [
        str(path.relative_to(PACKAGE))
        for path in SOURCES
        if tree_of(path).body and not ast.get_docstring(tree_of(path))
    ]
    assert missing == []


def test_files_stay_short() -> None:
    """No file but the named ones has 500 lines."""
    long = {
        path.relative_to(PACKAGE).as_posix(): count
        for path in SOURCES
        if (count := len(path.read_text("utf-8").splitlines())) >= 500
    }
    assert {name: count for name, count in long.items() if name not in LONG_FILES} == {}


def test_numbers_of_the_queue_have_names() -> None:
    """The bounds of queue, record, interface, slots and ring are named where they stand."""
    bounds = {
        "kernel/channel.py": ("LOW_WATER",),
        "kernel/ring.py": ("TIMED_KINDS",),
        "feed.py": ("HIGH_WATER",),
        "kernel/hli.py": ("SLOT_COUNT",),
        "lists/startup.py": ("LEAST_BACKWARD_MEMORY",),
        "kernel/record.py": ("EVENT_WIDTH", "PROBE_WIDTH"),
        "nc/expressions.py": ("EXPRESSION_DEPTH",),
        "decoder/program.py": ("MOST_BLOCKS_WITHOUT_TIME",),
        "controller.py": ("DEFAULT_LIMIT_US", "PROGRESS_TICKS"),
    }
    for file, names in bounds.items():
        tree = tree_of(PACKAGE / file)
        assigned = {
            ast.unparse(target)
            for node in tree.body
            if isinstance(node, ast.Assign)
            for target in node.targets
        }
        assert set(names) <= assigned, file
