# SPDX-License-Identifier: MIT
"""A checked program -> routines and memory, run by PLC tasks.

In: ``st.program.Program`` without errors. Out: ``Translation``: a context with its memory, the
routines that run before the first cycle and after the last one, and those of the programs. Only
code reached by a task is translated; code that cannot run there is refused by name.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st.calls import Call as CallNode
from nctakt.kernel.st.calls import Callee, Routine, callee_of
from nctakt.kernel.st.steps import Evaluate, Step, StepPair, Uncounted, steps_in_order
from nctakt.kernel.st.wholes import WholeConstant
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Callable,
    Expression,
    InterfaceType,
    Kind,
    Method,
    Pou,
    Section,
    Storage,
    StructType,
    Type,
    Variable,
)
from nctakt.st.vocabulary.libraries import AXIS_REFERENCE, WRITTEN_BY_NC
from nctakt.translation.body import CannotRunError
from nctakt.translation.initial_values import Images, put_scalar
from nctakt.translation.initialisation import Initialisation
from nctakt.translation.layout import Layout, lay_out_frame
from nctakt.translation.locations import Location, Origin
from nctakt.translation.observing.noting import NoteRows
from nctakt.translation.observing.probing import Probes
from nctakt.translation.observing.units import methods_of
from nctakt.translation.reflection import InstancePaths
from nctakt.translation.variables import instances_of

if TYPE_CHECKING:
    from nctakt.translation.body import Routines
    from nctakt.translation.locations import Location


_EXIT = "fb_exit"


@dataclass(slots=True, eq=False)
class Translation:
    """A program that can run; ``refused`` has the code that cannot, with its location.

    ``roots``: the pointers to the CNC's interface that it uses.
    """

    program: Program
    layout: Layout
    start: Step
    end: Step  # after the last cycle
    bodies: dict[str, Step]  # of the programs of the tasks, by their names in lower case
    before: Step  # values that the NC writes before each cycle of a task
    refused: list[CannotRunError]
    roots: set[str]


def translate(
    program: Program,
    counted: Mapping[int, int] | None = None,
    notes: NoteRows | None = None,
    probes: Probes | None = None,
) -> Translation:
    """Translate the code reached by the tasks of a checked program.

    ``counted``: the numbers of the conditions and bodies that are counted, by identity. ``notes``:
    the notes about the project's code, ``probes``: those of its statements.
    """
    project = _Project(program, counted or {}, notes, probes)
    start, end, before = project.start(), project.end(), project.before_cycles()
    bodies = {
        pou.name.lower(): project.body_of(pou) for task in program.tasks for pou in task.programs
    }
    project.complete()
    return Translation(
        program, project.layout, start, end, bodies, before, project.refused, project.roots
    )


class _Project:
    """The routines and the memory of a program while they are made."""

    def __init__(
        self,
        program: Program,
        counted: Mapping[int, int],
        notes: NoteRows | None,
        probes: Probes | None,
    ) -> None:
        self.program = program
        self.counted = counted
        self.notes = notes
        self.probes = probes
        self.layout = Layout(program.data_size)
        self.refused: list[CannotRunError] = []
        self.roots: set[str] = set()
        self._blocks = [one for one in program.pous.values() if one.type is not None]
        self._numbers = numbered(self._blocks)
        self._images = Images(self.number_of)
        self._routines: dict[int, Routine] = {}
        self._shared: dict[int, int] = {}
        self._starters: dict[int, Routine] = {}
        self._waiting: list[tuple[Routine, Callable, Pou | None, bool]] = []
        self._owners = _owners(self._blocks)
        self._names = _names(program, self._blocks)
        self._kept: list[object] = []

    # --- services for bodies

    def number_of(self, pou: Pou) -> int:
        """Return the number that an instance of a block begins with."""
        return self._numbers.get(id(pou), 0)

    def image_of_variable(self, variable: Variable) -> bytes:
        """Return the bytes of a variable as it begins."""
        return self._images.of_variable(variable)

    def routine(self, called: Callable) -> Routine:
        """Return the routine of a function, method or body."""
        found = self._routines.get(id(called))
        if found is None:
            found = self._routines[id(called)] = Routine()
            self._kept.append(called)
            self.shared_bytes(called)
            owner = self._owners.get(id(called))
            self._waiting.append((found, called, owner, False))
        return found

    def shared_bytes(self, called: Callable) -> int:
        """Return the bytes of its frame that the caller fills."""
        found = self._shared.get(id(called))
        if found is None:
            found = self._shared[id(called)] = lay_out_frame(called)
            self._kept.append(called)
        return found

    def own_function(self, name: str) -> Pou | None:
        """Return a function of the project by its name in lower case."""
        found = self.program.pous.get(name)
        is_own = found is not None and found.kind is Kind.FUNCTION and not found.library
        return found if is_own else None

    def starter(self, pou: Pou) -> Routine:
        """Return the routine that begins the members of an instance."""
        found = self._starters.get(id(pou))
        if found is None:
            found = self._starters[id(pou)] = Routine()
            self._waiting.append((found, Callable(pou.name, f"{pou.name}"), pou, True))
        return found

    def exact(self, called: Callable, declared: Pou) -> Callee:
        """Return the routine that instances of exactly this type have."""
        return self.routine(self._resolved(declared, called))

    def virtual(self, called: Callable, declared: Pou | InterfaceType) -> Callee:
        """Return the lookup of the routine by the type of the instance."""
        ranges: list[tuple[int, int, Callee]] = []
        for pou in self._candidates(declared):
            method = self._resolved(pou, called)
            if isinstance(method, Method) and method.is_abstract:
                continue
            number, routine = self.number_of(pou), self.routine(method)
            if ranges and ranges[-1][1] == number - 1 and ranges[-1][2] is routine:
                ranges[-1] = (ranges[-1][0], number, routine)
            else:
                ranges.append((number, number, routine))
        return callee_of(ranges)

    def types_of(self, declared: Pou | InterfaceType) -> list[tuple[int, int]]:
        """Return the ranges of the numbers of types that derive from it or implement it."""
        ranges: list[tuple[int, int]] = []
        for number in map(self.number_of, self._candidates(declared)):
            if ranges and ranges[-1][1] == number - 1:
                ranges[-1] = ranges[-1][0], number
            else:
                ranges.append((number, number))
        return ranges

    def _candidates(self, declared: Pou | InterfaceType) -> list[Pou]:
        if isinstance(declared, InterfaceType):
            found = [one for one in self._blocks if declared in _interfaces(one)]
        else:
            found = [one for one in self._blocks if declared in one.bases()]
        instances = [one for one in found if not one.is_abstract]
        return sorted(instances, key=self.number_of)

    def _resolved(self, pou: Pou, called: Callable) -> Callable:
        """Return the routines of a block's instances for the name of a method, or their body."""
        if isinstance(called, Pou):
            return pou
        name, accessor = self._names[id(called)]
        if not accessor:
            return pou.find_method(name) or called
        for one in pou.bases():
            found = one.properties.get(name)
            method = getattr(found, accessor) if found is not None else None
            if isinstance(method, Method):
                return method
        return called

    # --- the whole

    def body_of(self, pou: Pou) -> Step:
        """Return the statement that calls a program of a task."""
        instance = WholeConstant(self.layout.address(pou.instance))
        call = CallNode(self.routine(pou), instance, 0, Step(), Step(), True, pou.start)
        return Evaluate(call, pou.start, 1)

    def start(self) -> Step:
        """Put constant initial values into the data; return the code before the first cycle."""
        frame = Callable("start", "start")
        body = Initialisation(self, frame, None)
        steps: list[Step] = []
        for one in self._variables():
            self._put(one.offset, self._images.of_variable(one))
        for pou in self._blocks:
            if pou.kind is Kind.PROGRAM and pou.type is not None:
                self._put(pou.instance, self._images.of_type(pou.type))
        self._put_paths()
        for one in self._variables():
            steps += self._tried(body, one)
            body.frame.release()
        for pou in self._blocks:
            if pou.kind is Kind.PROGRAM:
                instance = WholeConstant(self.layout.address(pou.instance))
                call = CallNode(self.starter(pou), instance, 0, Step(), Step(), True, pou.start)
                steps.append(Evaluate(call, pou.start, 1))
        return _called_alone(steps, body.frame.size)

    def end(self) -> Step:
        """Return the code after the last cycle: FB_exit, in reverse order of the start (ST-405)."""
        steps: list[Step] = []
        for pou in reversed(self._blocks):
            if pou.kind is Kind.PROGRAM and pou.type is not None:
                location = Location(Origin.DATA, self.layout.address(pou.instance), pou.type)
                steps += exits_of(self, location, pou.type)
        for one in reversed(list(self._variables())):
            location = Location(Origin.DATA, self.layout.address(one.offset), one.type)
            steps += exits_of(self, location, one.type)
        return _called_alone(steps, 0)

    def _tried(self, body: Initialisation, variable: Variable) -> list[Step]:
        location = body.variable_location(variable, nowhere(variable.start))
        try:
            return body.start(location, variable, variable.start)
        except CannotRunError as error:
            self.refused.append(error)
            return []

    def _put(self, offset: int, image: bytes) -> None:
        self.layout.data[offset : offset + len(image)] = image

    def before_cycles(self) -> Step:
        """Return what the NC writes into the references of its axes before each cycle (ST-742)."""
        found = (one for one in self.program.blocks if one.name == AXIS_REFERENCE and one.library)
        block = next(found, None)
        method = None if block is None else block.methods.get(WRITTEN_BY_NC)
        if block is None or method is None:
            return Step()
        routine, shared = self.routine(method), self.shared_bytes(method)
        calls: list[Step] = [
            Evaluate(CallNode(routine, WholeConstant(at), shared, Step(), Step(), False, 0), 0, 0)
            for _, at, _ in instances_of(self.program, block)
        ]
        return Uncounted(steps_in_order(calls)) if calls else Step()

    def _put_paths(self) -> None:
        """Put the paths of instances into the variables that ask for them (ST-621)."""
        paths = InstancePaths(self.program.name)
        instances: list[tuple[int, Type, str]] = [
            (pou.instance, pou.type, pou.name)
            for pou in self._blocks
            if pou.kind is Kind.PROGRAM and pou.type is not None
        ]
        for group in self.program.lists:
            prefix = f"{group.name}." if group.name else ""
            instances += [
                (one.offset, one.type, f"{prefix}{one.name}")
                for one in group.variables.values()
                if one.storage is Storage.GLOBAL
            ]
        for offset, found, name in instances:
            for at, kind, path in paths.below(offset, found, name):
                put_scalar(self.layout.data, at, kind, path)

    def _variables(self) -> Iterator[Variable]:
        """Yield all variables of the data area but those of programs, in order of their begin."""
        seen = set()
        for one in self.program.initial_order:
            seen.add(id(one))
            yield one
        for group in self.program.lists:
            yield from (one for one in group.variables.values() if id(one) not in seen)
        for called in self._callables():
            for one in called.variables.values():
                if one.storage is Storage.GLOBAL and id(one) not in seen:
                    yield one

    def _callables(self) -> Iterator[Callable]:
        for pou in self.program.pous.values():
            yield pou
            yield from methods_of(pou)

    def complete(self) -> None:
        """Translate the bodies of all routines that are called."""
        while self._waiting:
            routine, called, owner, is_start = self._waiting.pop(0)
            if called.frame_size == 0:
                self.shared_bytes(called)
            body = Initialisation(self, called, owner)
            try:
                if is_start and owner is not None:
                    step = body.members(owner)
                else:
                    step = StepPair(body.prologue(), body.statements(called.body))
            except CannotRunError as error:
                self.refused.append(error)
                continue
            routine.complete(self.shared_bytes(called), body.frame.size, step)


def _called_alone(steps: list[Step], frame_size: int) -> Step:
    """Return the call of steps with a separate frame."""
    routine = Routine()
    routine.complete(0, frame_size, steps_in_order(steps))
    return Evaluate(CallNode(routine, WholeConstant(0), 0, Step(), Step(), False, 0), 0, 1)


def nowhere(start: int) -> Expression:
    """Return an expression that only has a position."""
    return Expression(start, start)


def _owners(blocks: list[Pou]) -> dict[int, Pou]:
    """Return whose variables each body and each method of a block sees."""
    found = {id(pou): pou for pou in blocks}
    for pou in blocks:
        found |= {id(method): pou for method in methods_of(pou)}
    return found


def numbered(blocks: list[Pou]) -> dict[int, int]:
    """Number blocks from 1 so that those derived from one follow it directly."""
    numbers: dict[int, int] = {}
    derived: dict[int, list[Pou]] = {}
    for pou in blocks:
        derived.setdefault(id(pou.base), []).append(pou)
    waiting = list(reversed(derived.get(id(None), [])))
    while waiting:
        pou = waiting.pop()
        numbers[id(pou)] = len(numbers) + 1
        waiting += reversed(derived.get(id(pou), []))
    return numbers


def _names(program: Program, blocks: list[Pou]) -> dict[int, tuple[str, str]]:
    """Return for each method its lower-case name and, of a property, which accessor it is."""
    found: dict[int, tuple[str, str]] = {}
    owners: list[Pou | InterfaceType] = [*blocks, *program.interfaces]
    for owner in owners:
        found |= {id(method): (name, "") for name, method in owner.methods.items()}
        for name, one in owner.properties.items():
            found |= {id(one.get): (name, "get"), id(one.set): (name, "set")}
    return found


def _interfaces(pou: Pou) -> list[InterfaceType]:
    """Return all interfaces that a block implements, also by its bases and theirs."""
    waiting = [one for block in pou.bases() for one in block.interfaces]
    found: list[InterfaceType] = []
    while waiting:
        one = waiting.pop()
        if one not in found:
            found.append(one)
            waiting += one.bases
    return found


def exits_of(project: Routines, location: Location, sought: Type) -> Iterator[Step]:
    """Yield the calls of FB_exit for a variable's instances, in the reverse order of its start.

    An instance: the derived block's, its base's, then those of its members, the last one first.
    """
    if isinstance(sought, ArrayType):
        count = sought.size // max(sought.element.size, 1) if _has_exit(sought.element) else 0
        for number in reversed(range(count)):
            part = location.member(number * sought.element.size, sought.element)
            yield from exits_of(project, part, sought.element)
    elif isinstance(sought, StructType):
        for one in reversed(sought.members.values()):
            part = location.member(one.offset, one.type, one.bit)
            yield from exits_of(project, part, one.type)
    elif isinstance(sought, BlockType):
        yield from _exits_of_instance(project, location, sought.pou)


def _exits_of_instance(project: Routines, location: Location, block: Pou) -> Iterator[Step]:
    for pou in block.bases():
        method = pou.methods.get(_EXIT)
        if method is not None:
            routine, shared = project.routine(method), project.shared_bytes(method)
            call = CallNode(
                routine, location.address(), shared, Step(), Step(), False, method.start
            )
            yield Evaluate(call, method.start, 1)
    for one in reversed(block.members.values()):
        if _is_held(one):
            yield from exits_of(project, location.member(one.offset, one.type), one.type)


def _has_exit(sought: Type) -> bool:
    if isinstance(sought, ArrayType):
        return _has_exit(sought.element)
    if isinstance(sought, StructType):
        return any(_has_exit(one.type) for one in sought.members.values())
    if not isinstance(sought, BlockType):
        return False
    return any(_EXIT in pou.methods for pou in sought.pou.bases()) or any(
        _is_held(one) and _has_exit(one.type) for one in sought.pou.members.values()
    )


def _is_held(variable: Variable) -> bool:
    return variable.storage is Storage.INSTANCE and variable.section is not Section.IN_OUT
