# SPDX-License-Identifier: MIT
"""Objects in Python that carry out function blocks of a PLC in the tick, one for each instance.

In: a checked program, the stubs of its project. Out: ``PythonBlock``, whose object is called after
each tick with the variables of its instance: it reads their present values, and its writes count
from the next tick on (RC-002). A tape has its writes as inputs of a PLC in Python.
"""

from __future__ import annotations

import numbers
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Protocol, TypeAlias

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc_code import NO_NUMBER, PLC_VALUE_REFUSED
from nctakt.messages.plcs.stubs import STUB_FAILED, STUB_SETS_NO_OUTPUT, STUB_WITHOUT_OBJECT
from nctakt.plc.error import PlcError
from nctakt.plc.python.stubs import library_of
from nctakt.plc.python.user_modules import (
    load_error,
    load_module,
    reason_and_traceback,
    refused_in,
)
from nctakt.project.project_file import Project, Stub
from nctakt.project.run_settings import check_trusted
from nctakt.run.plcs.plc_view import PlcView
from nctakt.st.program import Program
from nctakt.st.types import ArrayType, Pou, Section, Storage, StringType
from nctakt.st.types import Callable as CalledUnit
from nctakt.translation.layout import kind_of
from nctakt.translation.variables import (
    PlacedVariable,
    instances_in,
    instances_of,
)

#: Variables of programs and blocks that have no path.
_WITHOUT_PATH = (Section.TEMP, Section.STAT, Section.INST)
#: A value of a variable.
Value: TypeAlias = float | bool | str
#: Sets a variable by its path from the next tick on.
WriteVariable: TypeAlias = Callable[[str, Value], None]


class BlockVariables(Protocol):
    """The variables of a PLC by their paths."""

    def find(self, name: str) -> PlacedVariable | None:
        """Return a variable; ``None`` if there is none."""

    def read(self, name: str) -> Value:
        """Return a value."""

    def check(self, name: str, value: Value) -> bytes:
        """Return the bytes of a value; raise ``Failure`` where the variable cannot hold it."""

    def holds(self, name: str, data: bytes) -> bool:
        """Return whether a variable has the bytes of a value."""


@dataclass(slots=True, eq=False)
class _Instance:
    """An instance of a block: its variables, and the values set by its object."""

    path: str
    pou: Pou
    plc: BlockVariables
    pending: dict[str, tuple[str, Value, bytes]]

    def find(self, name: str) -> PlacedVariable:
        """Return a variable; raises ``AttributeError`` for an unknown one."""
        found = self.plc.find(f"{self.path}.{name}") if name else None
        if found is None:
            near = nearest(name, (one.name for one in self.pou.members.values()))
            also = f"; did you mean {near}?" if near and near != name else ""
            raise AttributeError(f"{self.pou.name} has no {name} to use{also}", name=name)
        return found

    def value_of(self, name: str) -> Any:
        """Return a value, a list of those of an array."""
        found, path = self.find(name), f"{self.path}.{name}"
        elements = _elements(found, name)
        if elements is not None:
            return [self.value_of(one) for one in elements]
        if kind_of(found.type) is None and not isinstance(found.type, StringType):
            raise Failure(diagnostic(NO_NUMBER, name=path, type=found.type.name))
        pending = self.pending.get(name.lower())
        return self.plc.read(path) if pending is None else pending[1]

    def set(self, name: str, value: object) -> None:
        """Set an output, or all elements of one; raises ``Failure`` for a value out of range."""
        found, path = self.find(name), f"{self.path}.{name}"
        first = name.replace("[", ".").partition(".")[0].strip()
        member = self.pou.members.get(first.lower())
        if member is None or member.section is not Section.OUTPUT:
            raise Failure(diagnostic(STUB_SETS_NO_OUTPUT, name=path, block=self.pou.name))
        elements = _elements(found, name)
        if elements is not None and isinstance(value, list | tuple | bytes):
            if len(value) == len(elements):
                for one, part in zip(elements, value, strict=True):
                    self.set(one, part)
                return
        plain, shown = _plain(value), repr(value)[:40]
        if plain is None:
            kind = found.type.name
            raise Failure(
                diagnostic(PLC_VALUE_REFUSED, name=path, type=kind, value=shown, nearest=NOTHING)
            )
        self.pending[name.lower()] = path, plain, self.plc.check(path, plain)

    def take(self) -> list[tuple[str, Value, bytes]]:
        """Return paths and values that were set since the last time, with their bytes."""
        found = list(self.pending.values())
        self.pending.clear()
        return found


class Block:
    """The variables of an instance: ``block.bExecute``, ``block["stPar.aData[3]"]``.

    Arrays of one dimension are lists. Only outputs can be set; names are not case-sensitive.
    """

    __slots__ = ("__instance",)

    def __init__(self, instance: _Instance) -> None:
        object.__setattr__(self, "_Block__instance", instance)

    def __str__(self) -> str:
        return f"{self.__instance.path}"

    def __getattr__(self, name: str) -> Any:
        return self.__instance.value_of(name)

    def __setattr__(self, name: str, value: object) -> None:
        self.__instance.set(name, value)

    def __getitem__(self, name: str) -> Any:
        return self.__instance.value_of(name)

    def __setitem__(self, name: str, value: object) -> None:
        self.__instance.set(name, value)


class PythonBlock:
    """An instance of a block with its object."""

    def __init__(self, own: object, file: Path, path: str, pou: Pou) -> None:
        self._cycle = getattr(own, "cycle", None)
        self._file = file
        self._path = path
        self._pou = pou
        self._instance: _Instance | None = None

    def after_tick(self, plc: BlockVariables, hli: PlcView, write: WriteVariable) -> None:
        """Call the object; its exceptions become ``PlcError`` (902978)."""
        instance = self._instance
        if instance is None:
            instance = self._instance = _Instance(self._path, self._pou, plc, {})
        try:
            self._cycle(Block(instance), hli)  # type: ignore[misc] # others are reported, too
            for path, value, data in instance.take():
                if not plc.holds(path, data):
                    write(path, value)
        except (Exception, SystemExit) as error:  # the user's code may raise what it likes
            reason, text = reason_and_traceback(error, self._file)
            message = diagnostic(
                STUB_FAILED, path=self._path, tick=hli.tick, reason=reason, traceback=text
            )
            raise PlcError(message, *refused_in(error)) from error


@dataclass(slots=True, eq=False)
class PythonBlocks:
    """The blocks of a program that classes in Python carry out."""

    program: Program
    project: Project
    blocks: Sequence[tuple[Stub, Pou]]

    def begin(self) -> Sequence[PythonBlock]:
        """Make the objects of all instances; exceptions of the classes become ``PlcError``.

        Raises ``Failure`` for a project that is not trusted (902025).
        """
        modules: dict[Path, Any] = {}
        found = []
        for stub, pou in self.blocks:
            instances = list(instances_of(self.program, pou))
            if instances and stub.file not in modules:
                check_trusted(self.project, f"plc.stubs.{stub.block}", stub.file, stub.location)
                modules[stub.file], _ = load_module(stub.file, None)
            for path, _, kind in instances:
                own = _object(stub, modules[stub.file])
                found.append(PythonBlock(own, stub.file, path, kind))
        return found


def without_objects(blocks: PythonBlocks) -> Iterator[Diagnostic]:
    """Yield a warning for each variable with blocks that no object carries out (902980)."""
    program = blocks.program
    for called in (one for pou in program.pous.values() for one in _parts_of(pou)):
        for variable in called.variables.values():
            is_apart = variable.section in _WITHOUT_PATH or variable.storage is Storage.FRAME
            if not is_apart or variable.section is Section.IN_OUT:
                continue
            for stub, pou in blocks.blocks:
                if next(instances_in("", variable.type, 0, pou, {}), None) is not None:
                    span = program.sources.span(variable.start, variable.start + len(variable.name))
                    path = f"{called.path}.{variable.name}"
                    yield diagnostic(STUB_WITHOUT_OBJECT, span, path=path, name=stub.class_name)


def _parts_of(pou: Pou) -> Iterator[CalledUnit]:
    """Yield a POU of the project, its methods and the accessors of its properties."""
    if not pou.library:
        accessors = [one for part in pou.properties.values() for one in (part.get, part.set)]
        yield from (pou, *pou.methods.values(), *(one for one in accessors if one is not None))


def python_blocks(program: Program, project: Project) -> PythonBlocks | None:
    """Return the blocks that a project has classes for; ``None`` if its code uses none."""
    found = []
    for stub in project.stubs:
        name, library = stub.block.lower(), library_of(stub).lower()
        for pou in program.pous.values():
            if pou.name.lower() == name and pou.library.lower() == library:
                found.append((stub, pou))
    return PythonBlocks(program, project, found) if found else None


def _object(stub: Stub, module: Any) -> object:
    try:
        return getattr(module, stub.class_name)()
    except (Exception, SystemExit) as error:  # the user's code may raise what it likes
        raise load_error(error, stub.file) from error


def _elements(found: PlacedVariable, name: str) -> list[str] | None:
    """Return the elements of an array of one dimension; ``None`` for anything else."""
    if not isinstance(found.type, ArrayType) or len(found.type.bounds) != 1:
        return None
    ((low, high),) = found.type.bounds
    return [f"{name}[{index}]" for index in range(low, high + 1)]


def _plain(value: object) -> Value | None:
    """Return a value as a built-in Python type; ``None`` for any other."""
    if isinstance(value, bool | str):
        return value
    if isinstance(value, numbers.Integral):
        return int(value)
    return float(value) if isinstance(value, numbers.Real) else None
