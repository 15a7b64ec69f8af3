# SPDX-License-Identifier: MIT
"""The project's own rules, checked in its files: what no compiler and no linter sees.

The realtime part is Python with C types in a ``.pxd`` beside each module. A class or a method that
is missing there compiles without a word and is never called from the tick; these tests compare the
two files. Others hold the direction of imports, and keep clocks and chance out.
"""

from __future__ import annotations

import ast
import functools
import re
import runpy
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from nctakt.nc.vocabulary.functions import G_FUNCTIONS, M_FUNCTIONS

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "src" / "nctakt"
KERNEL = PACKAGE / "kernel"
#: Modules of numbers: constants of C in what is compiled, and not compiled themselves.
NUMBERS = (
    "decoder/contour/rows",
    "kernel/axes/plan_rows",
    "kernel/cells",
    "kernel/codes",
    "kernel/kinematics/map_rows",
    "kernel/rows",
    "kernel/st/text/characters",
    "kernel/st/kinds",
)
#: What copies the realtime part's state between ticks: made from the types of all others.
WITHOUT_TYPES = ("kernel/state", "kernel/state_fields")
#: What compiled modules have as C functions in line, instead of the Python functions beside them.
IN_LINE = ("kernel/st/leaves", "kernel/st/real_leaves", "kernel/st/words")
#: The modules of the realtime part, relative to its folder and without an ending: ``path/path``.
MODULES = sorted(
    path.relative_to(KERNEL).with_suffix("").as_posix()
    for path in KERNEL.rglob("*.py")
    if path.stem != "__init__"
    and path.relative_to(PACKAGE).with_suffix("").as_posix()
    not in (*NUMBERS, *WITHOUT_TYPES, *IN_LINE)
)
SOURCES = sorted(PACKAGE.rglob("*.py"))
PXD = sorted(
    path
    for path in PACKAGE.rglob("*.pxd")
    if path.relative_to(PACKAGE).with_suffix("").as_posix() not in (*NUMBERS, *IN_LINE)
)

#: The only remainders outside ``arithmetic``: places in rings, of numbers that are never negative.
RING_SIZES = ("self.capacity", "self.queue.capacity", "self.ring_size")

NOT_DETERMINISTIC = ("time", "datetime", "random", "threading", "secrets", "uuid")


# --- reading .py and .pxd ----------------------------------------------------------------------


@dataclass
class Declared:
    """What a .pxd says of one class; the class ``""`` holds the module's functions.

    ``entrances``: those of the methods that Python calls between ticks, and that may raise.
    """

    base: str
    methods: set[str] = field(default_factory=set)
    entrances: set[str] = field(default_factory=set)
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
            if re.match(r"\s*cpdef \w+\(", line) or ") except " in line:
                owner.entrances.add(match[2])
        elif match := re.match(r"(\s*)cdef [\w\[:\]. ]*?\b(\w+)$", line):
            owner = current if match[1] else found[""]
            owner.fields.add(match[2])
    return found


def tree_of(path: Path) -> ast.Module:
    """The syntax tree of a Python file; those of the realtime part are kept for all tests."""
    return kept_tree(path) if KERNEL in path.parents else ast.parse(path.read_text("utf-8"))


@functools.cache
def kept_tree(path: Path) -> ast.Module:
    """The syntax tree of a Python file of the realtime part."""
    return ast.parse(path.read_text("utf-8"))


def classes(module: str) -> dict[str, ast.ClassDef]:
    """The classes of a realtime module."""
    tree = tree_of(KERNEL / f"{module}.py")
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


def functions(module: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """All functions of a realtime module with the class that they are in, "" for none."""
    for node in tree_of(KERNEL / f"{module}.py").body:
        if isinstance(node, ast.FunctionDef):
            yield "", node
        elif isinstance(node, ast.ClassDef):
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield node.name, member


ALL_DECLARED = {
    module: declarations(module)
    for module in (*MODULES, *(one.removeprefix("kernel/") for one in IN_LINE))
}
BY_CLASS = {name: found for part in ALL_DECLARED.values() for name, found in part.items() if name}


def ancestors(name: str) -> Iterator[Declared]:
    """The declared classes above a class."""
    while name in BY_CLASS:
        name = BY_CLASS[name].base
        if name in BY_CLASS:
            yield BY_CLASS[name]


def tick_functions(module: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """The functions of a module that run without Python objects, by its .pxd."""
    for owner, function in functions(module):
        declared = ALL_DECLARED[module][owner]
        if function.name in declared.methods - declared.entrances:
            yield owner, function


# --- .py against .pxd --------------------------------------------------------------------------


def test_each_realtime_module_has_its_types() -> None:
    """Each module of the realtime part has a .pxd of the same name, and no .pxd is alone."""
    typed = (path.relative_to(KERNEL).with_suffix("") for path in PXD if KERNEL in path.parents)
    assert sorted(path.as_posix() for path in typed) == MODULES


def test_numbers_are_the_same_in_c() -> None:
    """The ``.pxd`` of each module of numbers is what ``scripts/constants`` writes."""
    script = runpy.run_path(str(ROOT / "scripts" / "constants"))
    assert script["MODULES"] == NUMBERS
    for module in NUMBERS:
        path = PACKAGE / f"{module}.py"
        assert path.with_suffix(".pxd").read_text("utf-8") == script["text_of"](path), module


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
    """Each attribute that a class gives itself is in its .pxd or in that of a class above."""
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
    rows = (KERNEL / "rows.pxd").read_text("utf-8")
    declared.update(re.findall(r"^cdef inline bint (\w+)\(", rows, re.MULTILINE))
    library = {"min", "max", "int", "sqrt", "fmod", "fabs", "log", "log10", "exp", "pow", "floor"}
    library |= {"asin", "acos", "atan", "atan2", "range", "sin", "cos", "tan", "copysign"}
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


@pytest.mark.parametrize("package", ["kernel", "plc", "hli"])
def test_no_assert_replaces_a_check(package: str) -> None:
    """What comes from outside is checked and refused: ``python -O`` leaves asserts out."""
    found = [
        f"{path.relative_to(PACKAGE)}:{node.lineno}"
        for path in SOURCES
        if PACKAGE / package in path.parents
        for node in ast.walk(tree_of(path))
        if isinstance(node, ast.Assert)
    ]
    assert found == []


def test_asserts_of_the_run_only_tell_types() -> None:
    """In ``run/`` an assert says of which type a value is, and never which value it has."""
    found = []
    for path in SOURCES:
        if PACKAGE / "run" in path.parents:
            for node in ast.walk(tree_of(path)):
                if isinstance(node, ast.Assert):
                    text = ast.unparse(node.test)
                    if not (text.startswith("isinstance(") or text.endswith(" is not None")):
                        found.append(f"{path.relative_to(PACKAGE)}:{node.lineno}: {text}")
    assert found == []


def is_ring_place(node: ast.BinOp) -> bool:
    """A remainder by a ring's size."""
    return isinstance(node.op, ast.Mod) and ast.unparse(node.right) in RING_SIZES


@pytest.mark.parametrize("module", [one for one in MODULES if one != "base/arithmetic"])
def test_delicate_arithmetic_is_in_one_module(module: str) -> None:
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


def test_the_compilers_directives_are_in_one_place() -> None:
    """Only ``setup.py`` says how modules are translated, but for those that hold Python objects."""
    saying = {path.parent.name for path in SOURCES if "\n# cython:" in path.read_text("utf-8")}
    assert saying == {"simulation"}


#: A line of a ``.pxd`` that declares one field.
DECLARED_FIELD = re.compile(r"^    cdef (?:readonly )?[\w\[:\] ]*?(\w+)$", re.MULTILINE)


@pytest.mark.parametrize(
    "path", [one for one in PXD if KERNEL not in one.parents], ids=lambda one: one.stem
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
    fields = set(DECLARED_FIELD.findall(text))
    # A base class has its types in a file next to this one.
    beside = "".join(one.read_text("utf-8") for one in path.parent.glob("*.pxd"))
    given = {
        target.attr
        for target in ast.walk(tree)
        if isinstance(target, ast.Attribute)
        and isinstance(target.ctx, ast.Store)
        and ast.unparse(target.value) == "self"
    }
    assert fields <= given <= {*fields, *DECLARED_FIELD.findall(beside)}


# --- processes ----------------------------------------------------------------------------------

#: Functions that start another program; ``webbrowser`` starts none that imports modules.
STARTING = re.compile(r"\b(?:Popen|create_subprocess_\w+|check_(?:call|output)|exec[lv]p?e?|spawn[lv]p?e?|posix_spawnp?|system|popen|startfile|subprocess\.run)\b")  # fmt: skip # noqa: E501


@pytest.mark.nightly
def test_python_is_started_without_the_working_directory() -> None:
    """Only ``base.python_process`` names the interpreter; each start of a program goes by it."""
    for path in SOURCES:
        if path == PACKAGE / "base" / "python_process.py":
            continue
        text = path.read_text("utf-8")
        assert "sys.executable" not in text, path
        assert not {"multiprocessing.Process", "concurrent.futures.ProcessPoolExecutor"} & set(
            imports(path)
        ), path
        if not STARTING.search(text):
            continue
        for node in ast.walk(tree_of(path)):
            if not isinstance(node, ast.Call):
                continue
            called = ast.unparse(node.func)
            if STARTING.fullmatch(called.rpartition(".")[2]) or called == "subprocess.run":
                command = ast.unparse(node.args[0])
                assert command.lstrip("*").startswith("python_command("), (path, command)
                environment = [ast.unparse(one.value) for one in node.keywords if one.arg == "env"]
                assert "python_environment()" in "".join(environment), (path, command)


# --- determinism --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Facts:
    """What tests ask of every file, collected once: reading the whole package takes seconds.

    ``functions``: each with its number of lines. ``names``: the vague ones with their lines.
    ``uneven``: lines of texts whose German has fewer values than its English.
    ``looks``: where a value is looked for in a range.
    """

    imports: tuple[str, ...]
    functions: tuple[tuple[str, int], ...]
    names: tuple[tuple[str, int], ...]
    uneven: tuple[int, ...]
    looks: tuple[str, ...]
    has_docstring: bool


@functools.cache
def facts_of(path: Path) -> Facts:
    """What a file holds; its imports include those of ``from package import module``."""
    text = path.read_text("utf-8")
    tree = ast.parse(text)
    imported: list[str] = []
    functions: list[tuple[str, int]] = []
    uneven: list[int] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            imported += (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            imported += (node.module, *(f"{node.module}.{alias.name}" for alias in node.names))
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            functions.append((node.name, (node.end_lineno or 0) - node.lineno + 1))
        elif isinstance(node, ast.Call) and is_uneven(node):
            uneven.append(node.lineno)
    names = tuple(one for one in identifiers(tree) if is_vague(one[0]))
    looks = tuple(looks_in_ranges(tree)) if "range(" in text else ()
    has_docstring = not tree.body or bool(ast.get_docstring(tree))
    return Facts(tuple(imported), tuple(functions), names, tuple(uneven), looks, has_docstring)


def is_uneven(call: ast.Call) -> bool:
    """Whether a call makes a text in both languages of which the German lacks a value."""
    if len(call.args) != 2 or getattr(call.func, "id", "") != "Text":
        return False
    english, german = (
        {ast.unparse(one.value) for one in ast.walk(text) if isinstance(one, ast.FormattedValue)}
        for text in call.args
    )
    return len(german) < len(english)


def imports(path: Path) -> tuple[str, ...]:
    """The modules that a file imports."""
    return facts_of(path).imports


#: The files of a session that pace and show what others decide; none of them makes a result.
PACING = (
    "session/session.py", "session/process/thread.py", "session/listening.py",
    "session/process/process_pool.py",
    "session/history/past_runs.py",  # whoever asks about the past does so in its own thread
    "session/history/trail.py",  # where ticks are marked to be compared, which changes none of them
    "session/process/worker.py",  # how long a request took, by which slices get their length
)  # fmt: skip

#: The files that hand out runs, of a study or suites; what they yield does not depend on who does.
HANDING_OUT = (
    "studies/runs/blocks.py", "studies/workers/cluster.py", "studies/workers/processes.py",
    "studies/runs/shared_beginning.py", "studies/workers/worker_process.py",
    "testing/suite_processes.py",  # suites of files, each of which runs as a whole
)  # fmt: skip


#: The PLC of a user in its own process, of which the CNC sees nothing but its answers; and what an
#: editor sends, by its own streams.
OUTSIDE = (
    "fmu/call_watch.py",
    "editor/entrance.py",
    "editor/incoming.py",
    "editor/structured_text/plc_project.py",  # asked while it is checked in another thread
    "hli/connection.py",
)

#: What notebooks show while something lasts.
SHOWING = ("base/notebook_progress.py",)

#: What writes one fixed date into a file whose format wants one.
FIXED_DATES = ("results/trace/measurement.py",)

#: The files that read or write a length of time as a ``timedelta``, and no clock.
LENGTHS = ("lists/format/times.py", "base/plain_values.py")


def test_only_the_command_line_reads_a_clock() -> None:
    """No module that a run depends on uses clocks, chance or threads."""
    found = [
        f"{path.relative_to(PACKAGE)}: {name}"
        for path in SOURCES
        if path.relative_to(PACKAGE).parts[0]
        not in ("cli", "debugger", "live", "ports", "schedule", "servers")
        and path.name != "one_at_a_time.py"  # refuses a second thread, and makes none
        for name in imports(path)
        if name.split(".")[0] in NOT_DETERMINISTIC
        and path.relative_to(PACKAGE).as_posix()
        not in (*LENGTHS, *PACING, *HANDING_OUT, *OUTSIDE, *SHOWING, *FIXED_DATES)
    ]
    for path in LENGTHS:
        lengths = [name for name in imports(PACKAGE / path) if "datetime" in name]
        assert lengths == ["datetime", "datetime.timedelta"]
    assert found == []


def iterables(tree: ast.Module) -> Iterator[ast.expr]:
    """What loops and comprehensions walk through."""
    for node in ast.walk(tree):
        if isinstance(node, ast.For):
            yield node.iter
        elif isinstance(node, ast.comprehension):
            yield node.iter


def is_set(node: ast.expr, names: set[str]) -> bool:
    """Whether an expression is a set, as far as the text shows."""
    if isinstance(node, ast.Set | ast.SetComp):
        return True
    if isinstance(node, ast.Call):
        return ast.unparse(node.func) in ("set", "frozenset")
    return isinstance(node, ast.Name) and node.id in names


@pytest.mark.parametrize("folder", ["kernel", "decoder"])
def test_no_loop_iterates_over_a_set(folder: str) -> None:
    """The order of a set changes from run to run, so none is walked through."""
    found = []
    for path in sorted((PACKAGE / folder).rglob("*.py")):
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


def names_of_ranges(tree: ast.Module) -> set[str]:
    """The last parts of the names that a module gives to ranges."""
    return {
        ast.unparse(target).split(".")[-1]
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("range(")
        for target in node.targets
    }


#: Ranges that are asked for numbers that come from other ranges or from ``int``.
ASKED_FOR_INTEGERS = ("_channels", "CYCLE_FUNCTIONS", "own")


def looks_in_ranges(tree: ast.Module) -> Iterator[str]:
    """The comparisons that look for a value in a range."""
    ranges = names_of_ranges(tree).difference(ASKED_FOR_INTEGERS)
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare) and isinstance(node.ops[-1], ast.In | ast.NotIn):
            asked = ast.unparse(node.comparators[-1])
            if asked.startswith("range(") or asked.split(".")[-1] in ranges:
                yield ast.unparse(node)


def test_no_value_is_looked_for_in_a_range() -> None:
    """``0.5 in range(…)`` walks through all of it and holds Ctrl-C up: ``is_whole`` instead."""
    found = [
        f"{path.relative_to(PACKAGE)}: {look}" for path in SOURCES for look in facts_of(path).looks
    ]
    assert found == []


# --- packages and layers ------------------------------------------------------------------------


def layers() -> list[str]:
    """The packages and subpackages of ``docs/architecture.md``, in the order of imports."""
    text = (ROOT / "docs" / "architecture.md").read_text("utf-8")
    tree = text.split("```\nsrc/nctakt/\n")[1].split("```")[0]
    found: list[str] = []
    around: list[str] = []
    for line in tree.splitlines():
        depth = (len(line) - len(line.lstrip())) // STEP
        around = [*around[: depth - 1], line.split()[0].rstrip("/")]
        found.append("/".join(around))
    return found


#: How much further a package inside another one is indented in ``docs/architecture.md``.
STEP = 2

LAYERS = layers()


@functools.cache
def layer_of(module: str) -> str:
    """The package or subpackage in ``LAYERS`` that a module (``nctakt.nc.tree``) is in."""
    path = "/".join(module.split(".")[1:])
    inside = [layer for layer in LAYERS if path.startswith(f"{layer}/")]
    assert inside, f"{module} has no place in docs/architecture.md"
    return max(inside, key=len)


def may_import(importer: str, module: str) -> bool:
    """Whether the module's package comes first, or both are in one package.

    The modules of a divided package that are in none of its subpackages are below some of them
    and above others: that no files import each other is all that holds for them.
    """
    below, above = layer_of(module).split("/"), layer_of(importer).split("/")
    common = min(len(below), len(above))
    return LAYERS.index("/".join(below[:common])) <= LAYERS.index("/".join(above[:common]))


@functools.cache
def module_of(name: str) -> str | None:
    """The module that an imported name leads to: itself, or the one that holds the object."""
    parts = name.split(".")
    for count in range(len(parts), 1, -1):
        path = PACKAGE.joinpath(*parts[1:count])
        if path.with_suffix(".py").exists():
            return ".".join(parts[:count])
        if (path / "__init__.py").exists():
            return ".".join((*parts[:count], "__init__"))
    return None


def imported_modules(path: Path) -> set[str]:
    """The modules of the package that a file imports, also for its types only."""
    return {
        module
        for name in imports(path)
        if name.startswith("nctakt.") and (module := module_of(name)) is not None
    }


def own_name(path: Path) -> str:
    """The dotted name of a file of the package."""
    return ".".join(("nctakt", *path.relative_to(PACKAGE).with_suffix("").parts))


#: The packages that only say which form of their modules is imported.
FORM_CHOICE = ("kernel", "decoder", "nc")


def test_imports_go_in_one_direction() -> None:
    """A package imports only packages above it, and the realtime part nothing but itself."""
    wrong = []
    for path in SOURCES:
        own = own_name(path)
        if own.count(".") == 1 or (path.parent.name in FORM_CHOICE and path.stem == "__init__"):
            continue
        for module in sorted(imported_modules(path)):
            if module.removesuffix(".__init__") == "nctakt.base.mode":
                continue
            if module.startswith(tuple(f"nctakt.{one}.__init__" for one in FORM_CHOICE)):
                continue
            allowed = may_import(own, module)
            if own.startswith("nctakt.kernel."):
                allowed &= module.startswith("nctakt.kernel.")
            if not allowed and not under_type_checking(path, module):
                wrong.append(f"{own} -> {module}")
    assert wrong == []


def test_the_decoder_knows_no_checker() -> None:
    """What both read in a statement is in ``nc/meaning``; a run gives it what checks statements."""
    found = [
        f"{own_name(path)} -> {module}"
        for path in SOURCES
        for module in sorted(imported_modules(path))
        if own_name(path).startswith("nctakt.decoder.") and module.startswith("nctakt.nc.check.")
    ]
    assert found == []


def test_nothing_inside_imports_the_public_names() -> None:
    """``nctakt`` itself is above all its packages: they import what they need where it is."""
    found = [own_name(path) for path in SOURCES if "nctakt" in imports(path)]
    assert found == []


def test_no_files_import_each_other() -> None:
    """No circle of files, not even for types only."""
    left = {own_name(path): imported_modules(path) - {own_name(path)} for path in SOURCES}
    while free := [name for name, needed in left.items() if not needed & left.keys()]:
        for name in free:
            del left[name]
    assert sorted(left) == []


def under_type_checking(path: Path, module: str) -> bool:
    """Whether a module is imported for its types only."""
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            return any(
                isinstance(one, ast.ImportFrom) and one.module == module for one in node.body
            )
    return False


def test_benchmarks_import_what_there_is() -> None:
    """No test runs them: a renamed module or name shows here."""
    missing = []
    for path in sorted((ROOT / "benchmarks").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("nctakt"):
                try:
                    exec(ast.unparse(node), {})
                except ImportError as error:
                    missing.append(f"{path.name}: {error}")
    assert missing == []


def test_every_file_names_its_licence() -> None:
    """The first line of each source and test file is its licence."""
    files = [*SOURCES, *PACKAGE.rglob("*.pxd"), *(ROOT / "tests").rglob("*.py")]
    files += [*PACKAGE.rglob("*.[ch]"), *(ROOT / "examples").rglob("*.c")]
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
        str(path.relative_to(PACKAGE)) for path in SOURCES if not facts_of(path).has_docstring
    ]
    assert missing == []


#: A function that is longer does not fit into a reader's head; a file may have any length.
LONGEST_FUNCTION = 60


def test_functions_stay_short() -> None:
    """No function has more than 60 lines."""
    long = [
        f"{path.relative_to(PACKAGE).as_posix()}: {name}"
        for path in SOURCES
        for name, length in facts_of(path).functions
        if length > LONGEST_FUNCTION
    ]
    assert long == []


#: A folder with more modules has no subject that one line says.
MOST_MODULES = 20


def test_folders_stay_small() -> None:
    """No folder has more than 20 modules next to ``__init__``."""
    modules = Counter(path.parent for path in SOURCES if path.stem != "__init__")
    large = [
        f"{folder.relative_to(PACKAGE).as_posix()}: {count}"
        for folder, count in modules.items()
        if count > MOST_MODULES
    ]
    assert large == []


def test_lines_of_types_and_scripts_stay_short() -> None:
    """At most 100 columns where no linter measures: C types, C, scripts."""
    files = [*PACKAGE.rglob("*.pxd"), *PACKAGE.rglob("*.[ch]"), *(ROOT / "scripts").iterdir()]
    long = [
        f"{path.relative_to(ROOT)}:{number}"
        for path in files
        if path.is_file()
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1)
        if len(line) > 100
    ]
    assert long == []


def test_numbers_of_the_queue_have_names() -> None:
    """The bounds of queue, record, interface, slots and ring are named where they are defined."""
    bounds = {
        "kernel/tick/channel.py": ("LOW_WATER",),
        "run/queue_feeder.py": ("HIGH_WATER",),
        "kernel/plc/technology_slots.py": ("SLOT_COUNT",),
        "lists/declared/startup.py": ("MIN_BACKWARD_MEMORY",),
        "nc/parse/expressions.py": ("EXPRESSION_DEPTH",),
        "decoder/program.py": ("MAX_BLOCKS_WITHOUT_TIME",),
        "run/program_run.py": ("DEFAULT_LIMIT_US", "PROGRESS_TICKS"),
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


# --- facts with a single declaration --------------------------------------------------------------

#: Where the numbers of G and M functions are in ``nc`` and ``decoder``.
FUNCTION_TABLE = PACKAGE / "nc" / "vocabulary" / "functions.py"
#: How values are called that are the number of a function.
FUNCTION_WORDS = ("function", "motion", "mode", "feed_mode", "number", "value")


def literals(node: ast.expr) -> list[object]:
    """The items of a tuple, list, set or of the keys of a dictionary, if all are constants."""
    if isinstance(node, ast.Call) and len(node.args) == 1:
        return literals(node.args[0])
    items = node.keys if isinstance(node, ast.Dict) else getattr(node, "elts", [])
    values = [item.value for item in items if isinstance(item, ast.Constant)]
    return values if len(values) == len(items) else []


def function_numbers(tree: ast.Module) -> Iterator[ast.AST]:
    """Comparisons with numbers of functions, and constants that are collections of them."""
    numbers: set[object] = {*G_FUNCTIONS, *M_FUNCTIONS} - {0, 1}
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare):
            name = ast.unparse(node.left).split(".")[-1]
            for other in node.comparators:
                values = literals(other) or [getattr(other, "value", None)]
                if name in FUNCTION_WORDS and numbers.intersection(values):
                    yield node
        elif isinstance(node, ast.Assign):
            values = literals(node.value)
            if isinstance(node.value, ast.Dict) and not numbers.difference(range(10)) & {*values}:
                continue  # small numbers that are keys mean other things
            if numbers & {*values} and {0, 1, *numbers}.issuperset(values):
                yield node


@pytest.mark.parametrize("folder", ["nc", "decoder"])
def test_numbers_of_functions_are_in_one_table(folder: str) -> None:
    """Ends of programs, modal groups and motions: by their names, from the table of functions."""
    found = [
        f"{path.relative_to(PACKAGE)}: {ast.unparse(node)}"
        for path in sorted((PACKAGE / folder).rglob("*.py"))
        if path != FUNCTION_TABLE
        for node in function_numbers(tree_of(path))
    ]
    assert found == []


#: What the realtime part counts or measures, and therefore compares with numbers.
COUNTED = ("count", "rest", "degrees")
#: Attributes whose numbers are names of ``kernel/codes.py`` or ``kernel/rows.py``.
CODED = re.compile(r"(kind|state|stage|phase|mode|reason|scope|action|owner)$")
#: Calls that take such a number, with its position.
CODED_ARGUMENTS = {"event": 0, "enter": 1, "show_state": 1, "clamp": 2}
#: From here on a number is a message's, by which users and manuals know it.
FIRST_MESSAGE = 1000


def number_of(node: ast.AST) -> float:
    """The number of a literal, 0 for anything else, for a message's and for a negative one."""
    value = node.value if isinstance(node, ast.Constant) else 0
    if isinstance(value, bool) or not isinstance(value, int | float) or value >= FIRST_MESSAGE:
        return 0
    return value


def nameless_numbers(tree: ast.AST) -> Iterator[ast.expr | ast.stmt]:
    """Literal columns, and literal numbers that represent a kind, a state or a reason."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and not isinstance(node.slice, ast.Slice):
            before = {
                part.right
                for part in ast.walk(node.slice)
                if isinstance(part, ast.BinOp) and isinstance(part.op, ast.Sub)
            }
            if any(number_of(part) for part in ast.walk(node.slice) if part not in before):
                yield node
        elif isinstance(node, ast.Compare):
            named = ast.unparse(node.left).split(".")[-1] in COUNTED
            for operation, other in zip(node.ops, node.comparators, strict=True):
                if isinstance(operation, ast.Eq | ast.NotEq | ast.In | ast.NotIn) and not named:
                    if any(map(number_of, [node.left, other, *getattr(other, "elts", [])])):
                        yield node
        elif isinstance(node, ast.Assign) and number_of(node.value) > 1:
            owners = [getattr(target, "value", target) for target in node.targets]
            names = [ast.unparse(part).split("[")[0] for part in (*node.targets, *owners)]
            if any(CODED.search(name) for name in names):
                yield node
        elif isinstance(node, ast.Call):
            position = CODED_ARGUMENTS.get(ast.unparse(node.func).split(".")[-1])
            if position is not None and any(map(number_of, node.args[position : position + 1])):
                yield node


@pytest.mark.parametrize(
    "path",
    [
        *(KERNEL / f"{module}.py" for module in MODULES if module != "base/arithmetic"),
        *sorted((PACKAGE / "decoder" / "contour").glob("*.py")),
    ],
    ids=lambda path: path.relative_to(PACKAGE).as_posix(),
)
def test_columns_and_codes_are_named(path: Path) -> None:
    """``kernel/rows.py``, ``cells.py`` and ``codes.py`` name what rows, cells and arrays hold."""
    found = [f"{node.lineno}: {ast.unparse(node)}" for node in nameless_numbers(tree_of(path))]
    assert found == []


# --- names ----------------------------------------------------------------------------------------

#: Words with too many meanings to be a name: position, slot, source, length, path; reported …
VAGUE_NAMES = {"place", "way", "told", "made", "wanted", "here", "there"}
#: Names of bounds that begin with ``max`` or ``min`` instead.
SUPERLATIVE = re.compile(r"_*(most|least)(_|$)", re.IGNORECASE)


def is_vague(name: str) -> bool:
    """Whether a name may mean anything, or is a bound by another word than ``max`` or ``min``."""
    return name.strip("_") in VAGUE_NAMES or SUPERLATIVE.match(name) is not None


def identifiers(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """The names of variables, parameters, arguments, attributes, functions and classes."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            yield node.id, node.lineno
        elif isinstance(node, ast.Attribute):
            yield node.attr, node.lineno
        elif isinstance(node, ast.arg | ast.keyword) and node.arg is not None:
            yield node.arg, node.lineno
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name, node.lineno


def test_german_texts_have_the_values_of_english_ones() -> None:
    """Nothing was lost when a text was edited."""
    found = [
        f"{path.relative_to(PACKAGE)}:{line}" for path in SOURCES for line in facts_of(path).uneven
    ]
    assert found == []


def test_names_say_what_they_hold() -> None:
    """No name is one of the words that may mean anything; bounds are ``max`` and ``min``."""
    found = [
        f"{path.relative_to(PACKAGE)}:{line}: {name}"
        for path in SOURCES
        for name, line in facts_of(path).names
    ]
    assert found == []
