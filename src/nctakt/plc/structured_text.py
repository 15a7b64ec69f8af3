# SPDX-License-Identifier: MIT
"""A PLC in Structured Text as the PLC of a run (ST-560, ST-801 … ST-805).

In: a ``.plcproj``, or a file with Structured Text. Out: a PLC whose tasks run in the tick. It is
translated again for each run, so that each run begins with its initial values.
"""

from __future__ import annotations

import re
import struct
import sys
from collections.abc import Callable as CallableFunction
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import NOTHING, Diagnostic, Severity, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest_item
from nctakt.base.mode import is_compiled
from nctakt.files.access import FileAccess
from nctakt.hli.table import SINGLE_ROOTS
from nctakt.kernel import rows
from nctakt.kernel.st import kinds
from nctakt.kernel.st.outside import Connection
from nctakt.kernel.st.steps import Step, steps_in_order
from nctakt.kernel.st.tasks import CyclicTask, PlcSide, PlcTask, PlcTasks, TaskInfo
from nctakt.messages import Collector, diagnostic
from nctakt.messages.plc_debugging import POINTER_FROM_OUTSIDE
from nctakt.messages.plcs.plc import INVALID_AXIS_COMMAND
from nctakt.messages.plcs.plc_code import (
    AXIS_NOT_RELEASED,
    CONSTANT_FROM_OUTSIDE,
    CONVERSION_OUTSIDE,
    CYCLE_TOO_LONG,
    DIVISION_BY_ZERO,
    EXCEPTION_RAISED,
    IGNORED_EXECUTE,
    INVALID_OPERATION,
    NO_NUMBER,
    NO_PART,
    NO_TASK,
    NOT_TRANSLATED,
    PLC_INDEX_OUTSIDE,
    PLC_VALUE_REFUSED,
    POINTER_OUTSIDE,
    SEVERAL_PLC_PROJECTS,
    STACK_FULL,
    STEP_ZERO,
    TOO_MANY_INSTRUCTIONS,
)
from nctakt.plc.axis_references import bound_axes
from nctakt.plc.error import PlcError
from nctakt.plc.python.blocks import (
    PythonBlock,
    PythonBlocks,
    WriteVariable,
    python_blocks,
    without_objects,
)
from nctakt.plc.python.stubs import libraries_of
from nctakt.plc.st_coverage import Counts, coverage_of
from nctakt.plc.st_interface import StInterface, connect, lay_out, names_of
from nctakt.plc.st_reasons import StReasons
from nctakt.project.project_file import Project, find_project
from nctakt.run.access.named_values import SignalCell
from nctakt.run.plcs.plc_view import AnyPlc, PlcView
from nctakt.run.plcs.realtime_plc import PlcGroup, RealtimePlc, is_structured, parts_of
from nctakt.st.inspection import inspect_paths
from nctakt.st.program import Program, Task
from nctakt.st.types import (
    BlockType,
    Callable,
    EnumType,
    InterfaceType,
    Kind,
    PointerType,
    Pou,
    ReferenceType,
    StringType,
    StructType,
    Type,
)
from nctakt.st.vocabulary.elementary import NUMBERS
from nctakt.translation.layout import as_word, is_real, kind_of
from nctakt.translation.observing.branches import BranchNumbers
from nctakt.translation.observing.noting import NoteRows
from nctakt.translation.observing.probing import Probes
from nctakt.translation.project import Translation, translate
from nctakt.translation.variables import (
    PlacedVariable,
    find_variable,
    instances_of,
    own_values,
    retained_paths,
)

if TYPE_CHECKING:
    from nctakt.results.coverage import Coverage
    from nctakt.results.explained.plc_histories import PlcHistory
    from nctakt.run.realtime.assembly import AssembledMachine

#: The block that follows a command of an axis for those of the libraries.
_AXIS_MOTION = "__axis_motion"
#: The list of the system's variables.
_SYSTEM = "TwinCAT_SystemInfoVarList"
#: The list of reports by code, and its capacity per tick.
_REPORTED, _MAX_MESSAGES = "__Messages", 16
#: Counters of a task in the list of tasks.
_COUNTED = ("CycleCount", "FirstCycle", "LastExecTime", "CycleTimeExceeded")
#: Paths that are kept found; there are as many spellings of them as one likes.
_MAX_FOUND = 10_000
#: Where a part of a path begins.
_PART_BEGINS = re.compile(r"[.\[]")
#: Elementary instructions per µs of a task's cycle (ST-830).
_STEPS_PER_US = 1000
_MESSAGES = {
    kinds.DIVISION: DIVISION_BY_ZERO,
    kinds.INDEX: PLC_INDEX_OUTSIDE,
    kinds.PLACE: POINTER_OUTSIDE,
    kinds.STACK: STACK_FULL,
    kinds.BUDGET: TOO_MANY_INSTRUCTIONS,
    kinds.CONVERSION: CONVERSION_OUTSIDE,
    kinds.STEP: STEP_ZERO,
    kinds.INVALID: INVALID_OPERATION,
    kinds.RAISED: EXCEPTION_RAISED,
}


def load_structured(path: str | Path, axes: Mapping[str, str] | None = None) -> StructuredPlc:
    """Return the PLC of a project or a file; raises ``PlcError`` with all its mistakes.

    ``axes``: names of axes by paths of variables of the type AXIS_REF, before those of the project
    file.
    """
    programs, findings, project = inspected(path)
    if len(programs) > 1:
        names = ", ".join(one.name for one in programs)
        raise PlcError(diagnostic(SEVERAL_PLC_PROJECTS, file=str(path), names=names))
    return plc_of(programs[0], path, findings, project, axes)


class StructuredFile:
    """A PLC's file, read and checked once, for any number of PLCs; raises as ``load_structured``.

    Of a system with several projects each PLC is all of them together.
    """

    def __init__(self, path: str | Path) -> None:
        self._path = path
        self._programs, self._findings, self._project = inspected(path)

    def plc(self) -> AnyPlc:
        """Return a new PLC."""
        plcs = [
            plc_of(one, self._path, () if i else self._findings, self._project)
            for i, one in enumerate(self._programs)
        ]
        return plcs[0] if len(plcs) == 1 else PlcGroup(plcs)


def structured_programs(path: str | Path | None) -> list[Program]:
    """Return the programs of a PLC's file as run; none without a file in Structured Text.

    Raises as ``load_structured``.
    """
    if path is None or not is_structured(path):
        return []
    realtime, _ = parts_of(StructuredFile(path).plc())
    return [one.program for one in realtime if isinstance(one, StructuredPlc)]


def inspected(
    path: str | Path, *others: Path
) -> tuple[list[Program], Sequence[Diagnostic], Project | None]:
    """Return the projects of a file, the warnings, and the project file around it.

    ``others``: further files of the same project. Raises ``PlcError`` with all mistakes.
    """
    collector, access = Collector(), FileAccess()
    project = find_project(Path(path), access)
    files = [] if project is None else [project.file.as_posix()]

    def read(file: Path) -> bytes | None:
        files.append(file.as_posix())
        try:
            return access.read_bytes(file)
        except Failure as failure:
            collector.diagnostics += failure.diagnostics
            return None

    own = libraries_of(project)
    programs = inspect_paths([Path(path), *others], read, collector, own.read)
    for program in programs:
        program.read_files = files
    errors = [one for one in collector.diagnostics if one.severity is Severity.ERROR]
    if errors:
        raise PlcError(*errors)
    if not programs:
        raise PlcError(diagnostic(NO_TASK, file=str(path)))
    return programs, collector.diagnostics, project


def plc_of(
    program: Program,
    path: str | Path,
    findings: Sequence[Diagnostic],
    project: Project | None,
    axes: Mapping[str, str] | None = None,
) -> StructuredPlc:
    """Return the PLC of a checked program with the settings of its project file.

    ``axes``: further ones. Raises ``PlcError`` for code that does not run here.
    """
    if not any(task.programs for task in program.tasks):
        raise PlcError(diagnostic(NO_TASK, file=str(path)))
    named = {} if project is None else project.axes
    blocks = None if project is None else python_blocks(program, project)
    found = [*findings, *(() if blocks is None else without_objects(blocks))]
    plc = StructuredPlc(program, found, {**named, **(axes or {})})
    plc.instruction_ns = 0 if project is None else project.instruction_ns
    plc.blocks = blocks
    refused = [_refusal(program, one.node.start, one.what) for one in plc.translated.refused]
    if refused:
        raise PlcError(*refused)
    return plc


def _refusal(program: Program, start: int, what: str) -> Diagnostic:
    return diagnostic(NOT_TRANSLATED, _span(program, start), what=what)


def _span(program: Program, start: int) -> Span | None:
    return program.sources.span(start, start + 1)


class StructuredPlc(RealtimePlc):
    """A PLC in Structured Text, and its variables by their paths."""

    def __init__(
        self,
        program: Program,
        findings: Sequence[Diagnostic],
        axes: Mapping[str, str] | None = None,
    ) -> None:
        self.program = program
        #: The axes that variables of the type AXIS_REF mean, by their paths.
        self.axes = axes or {}
        #: How long an elementary instruction takes in ns; 0: cycles take no time (ST-830).
        self.instruction_ns = 0
        #: The blocks that Python carries out, if there are any.
        self.blocks: PythonBlocks | None = None
        #: The variables that were found by their paths.
        self._found: dict[str, PlacedVariable] = {}
        self._block_calls: Sequence[PythonBlock] | None = None
        self._overrun_tasks: set[int] = set()
        self._findings = findings
        self.translated: Translation = translate(program)
        #: The numbers of its branches, if they are counted.
        self._numbers: BranchNumbers | None = None
        #: The notes about it, if somebody wants to know why it acts.
        self._rows: NoteRows | None = None
        self._reasons: StReasons | None = None
        self._tasks: PlcTasks | None = None
        self._cyclic: list[tuple[Task, CyclicTask]] = []
        self._machine: AssembledMachine | None = None
        self._first_tick = 0
        self._has_ended = False
        self._message_at = 0
        self._interface: StInterface | None = None
        self.context = self.translated.layout.context(self.translated.layout.memory())

    @property
    def name(self) -> str:
        """The name of its project."""
        return self.program.name

    def notes(self) -> Sequence[Diagnostic]:
        """Return the warnings about its text."""
        return self._findings

    def attach(self, machine: AssembledMachine) -> StructuredPlc:
        """Restart on a machine: initial values, FB_init, then the tasks from its next tick."""
        if not is_compiled():
            _allow_depth()
        layout, kernel = self.translated.layout, machine.kernel
        interface = lay_out(machine, layout.interface, self.translated.roots)
        memory = layout.memory(bytes(interface.content))
        self.context = context = layout.context(memory)
        context.instruction_ns = self.instruction_ns
        context.source_base = machine.registry.add_plc(self.program.sources)
        self._overrun_tasks = set()
        self._interface = interface
        cnc = connect(machine, interface, context, memory)
        context.outside = outside = self._outside(machine, interface)
        if self._numbers is not None:
            context.keep_counts(self._numbers.size)
        self._bind_axes(machine, outside)
        number = len(self.program.tasks)
        self._fill_in(f"{_SYSTEM}._AppInfo", ProjectName=self.program.name, TaskCnt=number)
        tasks = PlcTask()
        self._cyclic = []
        for task in sorted(self.program.tasks, key=_priority, reverse=True):
            body = _body_of(task, self.translated)
            limit = task.cycle_us * _STEPS_PER_US
            number, info = self._task_info(task)
            tasks = CyclicTask(body, 1000 * task.cycle_us, limit, tasks, number, info)
            self._cyclic.append((task, tasks))
        tick_ns = 1000 * machine.configuration.cycle_time_us
        self._tasks = PlcTasks(context, tasks, tick_ns, kernel.tick, machine.memory, cnc)
        counted = find_variable(self.program, f"{_REPORTED}.nCount")
        self._message_at = 0 if counted is None else counted.address
        if counted is not None:
            self._tasks.watch_messages(counted.address)
        self._machine = machine
        self._has_ended = False
        self._block_calls = None
        self._first_tick = kernel.tick
        context.begin(0)
        self.translated.start.execute(context)
        if context.fault:
            raise PlcError(self._fault())
        if self._rows is not None:
            names = names_of(machine, interface)
            tick = kernel.tick
            self._reasons = StReasons(self.program, self._rows, context, names, tick_ns, tick)
        return self

    def blocks_in_python(self, write: WriteVariable) -> CallableFunction[[PlcView], None] | None:
        """Return the calls of the objects for its blocks; a fault of the PLC ends them (ST-560)."""
        if self.blocks is None:
            return None
        if self._block_calls is None:
            self._block_calls = self.blocks.begin()
        calls = self._block_calls

        def call(hli: PlcView) -> None:
            if not self.context.fault:
                for one in calls:
                    one.after_tick(self, hli, write)

        return call

    def count_branches(self) -> None:
        """Count the runs of its branches from the next ``attach`` on."""
        if self._numbers is None:
            self._numbers = BranchNumbers(self.program)
            self.translated = translate(self.program, self._numbers.by_identity)

    def explain(self) -> None:
        """Count its branches and note its changes from the next ``attach`` on."""
        self._numbers = self._numbers or BranchNumbers(self.program)
        self._rows = self._rows or NoteRows(self.program)
        self.translated = translate(self.program, self._numbers.by_identity, self._rows)

    def probe(self, probes: Probes) -> Translation:
        """Run the same programs with probes from the next cycle on; return their translation.

        The memory stays: a translation gives everything the same address each time.
        """
        counted = None if self._numbers is None else self._numbers.by_identity
        probed = translate(self.program, counted, self._rows, probes)
        for task, cyclic in self._cyclic:
            cyclic.exchange(_body_of(task, probed))
        return probed

    def changes(self) -> Sequence[PlcHistory]:
        """Return its changes since it was attached, and why, if that is noted."""
        return () if self._reasons is None else self._reasons.histories()

    def coverage(self) -> Coverage | None:
        """Return which branches have run since it was attached; ``None`` if not counted."""
        if self._numbers is None:
            return None
        own = self.context
        counts = Counts(own.counts, own.near_left, own.near_right, own.distances)
        return coverage_of(self.program, self._numbers, counts)

    def side(self) -> PlcSide:
        """Return its tasks on the machine that it is attached to."""
        return PlcSide() if self._tasks is None else self._tasks

    def data(self) -> memoryview:
        """Return its data, without the stack of calls, on the machine that it is attached to."""
        return memoryview(self.context.memory)[kinds.NULL_BYTES : self.context.stack]

    @property
    def files(self) -> Sequence[str]:
        """The files that it was read from, those of libraries and stubs among them."""
        return self.program.read_files

    def span_of(self, start: int) -> Span | None:
        """Return where a statement is, by its number in events."""
        return _span(self.program, start)

    def _bind_axes(self, machine: AssembledMachine, outside: Connection) -> None:
        """Assign each AXIS_REF its axis; raises ``PlcError`` for those without one (ST-742)."""
        found, missing = bound_axes(self.program, machine.configuration, self.axes)
        if missing:
            raise PlcError(*missing)
        if found:
            outside.watch(1e6 / machine.configuration.cycle_time_us)
        for one in found:
            for path, value in one.values:
                variable = find_variable(self.program, path)
                if variable is not None:
                    self.context.poke(variable.address, self.check(path, value))

    def _task_info(self, task: Task) -> tuple[int, TaskInfo]:
        """Fill in the task data read by code (ST-721); return its number and its counters."""
        number = self.program.tasks.index(task) + 1
        path = f"{_SYSTEM}._TaskInfo[{number}]"
        self._fill_in(
            path, CycleTime=10 * task.cycle_us, Priority=task.priority, TaskName=task.name
        )
        counted = (find_variable(self.program, f"{path}.{name}") for name in _COUNTED)
        return number, TaskInfo(*(0 if one is None else one.address for one in counted))

    def _fill_in(self, path: str, **values: int | str) -> None:
        """Set members of a structure of the system's, if the project uses it."""
        for name, value in values.items():
            variable = find_variable(self.program, f"{path}.{name}")
            if variable is not None:
                self.context.poke(variable.address, self.check(f"{path}.{name}", value))

    def _outside(self, machine: AssembledMachine, interface: StInterface) -> Connection:
        """Return the access of calls to the machine."""
        pointers = []
        for (root, index), value in interface.pointers.items():
            suffix = "" if root in SINGLE_ROOTS else f"[{index}]"
            pointer = find_variable(self.program, f"{root}{suffix}")
            if pointer is not None:
                pointers.append((pointer.address, value))
        axes = machine.configuration.axes
        measures = [
            machine.layout.axis_value(index, source)
            for index in range(len(axes))
            for source in ("ACS.ACT_POS", "ACS.CUR_POS", "ACS.CMD_POS")
        ]
        return Connection(
            machine.kernel.requests,
            pointers,
            [axis.logical_number for axis in axes],
            measures,
            machine.memory,
            (INVALID_AXIS_COMMAND.id, AXIS_NOT_RELEASED.id),
        )

    def record_messages(self) -> None:
        """Record the texts that its code has reported in the latest tick (ST-721)."""
        at, machine = self._message_at, self._machine
        if not at or machine is None or self._tasks is None or not self._tasks.has_news:
            return
        count = int.from_bytes(self.context.peek(at, 4), "little")
        self.context.poke(at, bytes(4))
        texts = [
            (str(self.read(f"{row}.sText")), int(self.read(f"{row}.nSource")))
            for row in (f"{_REPORTED}.aRows[{i}]" for i in range(1, min(count, _MAX_MESSAGES) + 1))
        ]
        if count > _MAX_MESSAGES:
            texts.append((f"{count - _MAX_MESSAGES} more messages of this tick", 0))
        base = self.context.source_base
        for text, source in texts:
            number = machine.registry.add_text(text)
            source_id = -(base + source) if source else 0
            machine.record.event_between_ticks(rows.EVENT_MESSAGE, source_id, number, 0.0, 0.0, 0.0)

    def news(self) -> Sequence[Diagnostic]:
        """Return the fault that has stopped it, once; execute its commands that need Python."""
        if self._tasks is None or not self._tasks.has_news:
            return ()
        self._tasks.has_news = False
        if self._reasons is not None:
            self._reasons.take()
        if self.context.fault == kinds.HALTED:
            return ()
        if self.context.fault:
            return [self._fault()]
        overruns = self._overrun()
        if self._interface is None or self._machine is None:
            return overruns
        return [*overruns, *self._interface.go_on(self._machine, self.context)]

    def _overrun(self) -> list[Diagnostic]:
        """Return a warning about a task whose cycle took too long, for each task once (ST-830)."""
        number, self.context.overrun_task = self.context.overrun_task, 0
        if not number or number in self._overrun_tasks:
            return []
        self._overrun_tasks.add(number)
        task = self.program.tasks[number - 1]
        return [
            diagnostic(
                CYCLE_TOO_LONG,
                task=task.name,
                time=f"{self.context.now / 1e6:g} ms",
                length=f"{self.context.overrun_ns / 1e6:g} ms",
                cycle=f"{task.cycle_us / 1e3:g} ms",
            )
        ]

    def end(self) -> Sequence[Diagnostic]:
        """Call FB_exit of its instances, once (ST-405); return the fault in that.

        Commands of axes that were not followed are warnings. A PLC that a fault has stopped does
        nothing more (ST-560).
        """
        context = self.context
        if self._has_ended or self._tasks is None or context.fault:
            return ()
        self._has_ended = True
        context.begin(context.now)
        self.translated.end.execute(context)
        return [*self._ignored_commands(), *([self._fault()] if context.fault else ())]

    def _ignored_commands(self) -> Iterator[Diagnostic]:
        """Yield a warning for each block whose Execute rose while it was Busy (ST-743)."""
        motion = self.program.pous.get(_AXIS_MOTION)
        if motion is None:
            return
        for path, _, _ in instances_of(self.program, motion):
            count = self.read(f"{path}.nIgnored")
            if count:
                block = path.rpartition(".")[0]
                yield diagnostic(IGNORED_EXECUTE, block=block, count=str(count))

    def fault(self) -> Diagnostic | None:
        """Return the fault that has stopped it, ``None`` while it runs or is halted."""
        return self._fault() if self.context.fault not in (0, kinds.HALTED) else None

    def _fault(self) -> Diagnostic:
        context = self.context
        message = _MESSAGES[context.fault]
        words: dict[str, str | Text] = {"time": f"{context.now / 1e6:g} ms", "calls": self._calls()}
        if context.fault == kinds.INDEX:
            words["index"] = str(context.fault_a)
            lowest, count = divmod(context.fault_b, kinds.BOUND)
            words["bounds"] = f"{lowest}..{lowest + count - 1}"
        if context.fault == kinds.BUDGET:
            words["limit"] = str(context.fault_a)
        if context.fault == kinds.RAISED:
            words["code"] = str(context.fault_a)
        if context.fault == kinds.STACK:
            words["depth"] = str(context.fault_a)
        else:
            words["values"] = self._values(context.fault_source)
        return diagnostic(message, _span(self.program, context.fault_source), "", **words)

    def _calls(self) -> str | Text:
        """Return the calls that led to a fault, for its text, the innermost first."""
        context = self.context
        shown = []
        for source in context.trail[: context.trail_length : kinds.TRAIL_WIDTH]:
            span = _span(self.program, source)
            if span is not None:
                shown.append(f"{span.file}:{span.line}")
        calls = ", ".join(shown[:-1])
        return Text(f"; called from {calls}", f"; aufgerufen aus {calls}") if calls else ""

    def _values(self, start: int) -> str:
        """Return the variables in the line of a program's statement, for a fault's text.

        Elsewhere a name may mean a variable of an instance or of a call, which is not known here.
        """
        span, owner = _span(self.program, start), self._owner(start)
        if span is None or not isinstance(owner, Pou) or owner.kind is not Kind.PROGRAM:
            return ""
        line = self.program.sources.line(span.file, span.line)
        found = dict(self._shown(owner, line))
        values = ", ".join(f"{name} = {value}" for name, value in found.items())
        return f"; {values}" if values else ""

    def _owner(self, start: int) -> Callable | None:
        """Return the unit whose text holds a position: the last that begins before it."""
        called: list[Callable] = []
        for pou in self.program.pous.values():
            called += (pou, *pou.methods.values())
            called += (
                one for part in pou.properties.values() for one in (part.get, part.set) if one
            )
        before = [one for one in called if one.start <= start]
        return max(before, key=lambda one: one.start, default=None)

    def _shown(self, program: Pou, line: str) -> Iterator[tuple[str, object]]:
        for name in _words(line):
            for path in (f"{program.name}.{name}", name):
                variable = find_variable(self.program, path)
                if variable is not None and kind_of(variable.type) is not None:
                    yield name, self._value(variable)
                    break

    # --- variables by their paths

    def find(self, name: str) -> PlacedVariable | None:
        """Return the variable of a path; ``None`` if there is none."""
        found = self._found.get(name)
        if found is None:
            found = find_variable(self.program, name)
            if found is not None and len(self._found) < _MAX_FOUND:
                self._found[name] = found
        return found

    def knows(self, name: str) -> bool:
        """Return whether a name is the path of a variable."""
        return self.find(name) is not None

    def mistake(self, name: str) -> Diagnostic | None:
        """Return the mistake in a missing element or member, or in one that is not a signal."""
        found = find_variable(self.program, name)
        if found is not None:
            is_number = kind_of(found.type) is not None
            return None if is_number else diagnostic(NO_NUMBER, name=name, type=found.type.name)
        for end in reversed([found.start() for found in _PART_BEGINS.finditer(name)]):
            part = find_variable(self.program, name[:end].strip())
            if part is None:
                continue
            if name[end] == "." and isinstance(part.type, BlockType | StructType):
                return None  # it may be misspelt
            whole = name[:end].strip()
            return diagnostic(NO_PART, name=name, part=whole, type=part.type.name)
        return None

    def names(self, *, are_numbers: bool) -> Iterator[str]:
        """Yield the paths of its values, without elements of arrays; if so, only of numbers."""
        for path, sought in own_values(self.program):
            if not are_numbers or kind_of(sought) is not None:
                yield path

    def retained_paths(self) -> Iterator[str]:
        """Yield the paths of RETAIN or PERSISTENT variables."""
        return retained_paths(self.program)

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable; raises ``KeyError`` for an unknown one."""
        variable = self.find(name)
        if variable is None:
            raise KeyError(name)
        return self._value(variable)

    def _value(self, variable: PlacedVariable) -> float | bool | str:
        context, sought = self.context, variable.type
        data = context.peek(variable.address, max(sought.size, 1))
        if isinstance(sought, StringType) and sought.is_wide:
            return data.decode("utf-16-le", "replace").partition("\0")[0]
        if isinstance(sought, StringType):
            return data.split(b"\0")[0].decode("latin-1")
        kind = kind_of(sought)
        if kind is None:
            return data.hex(" ")
        number = self._number(variable, kind)
        if isinstance(sought, EnumType):
            return dict(_labels(sought)).get(int(number), number)
        return bool(number) if kind == kinds.BOOL or variable.bit >= 0 else number

    def _number(self, variable: PlacedVariable, kind: int) -> float:
        """Return the value of a variable that is a number or a truth."""
        sought = variable.type
        data = self.context.peek(variable.address, max(sought.size, 1))
        if is_real(sought):
            number: float = struct.unpack("<f" if sought.size == 4 else "<d", data)[0]
            return number
        whole = int.from_bytes(data, "little", signed=kinds.I8 <= kind <= kinds.I64)
        return whole if variable.bit < 0 else whole >> variable.bit & 1

    def check(self, name: str, value: float | bool | str) -> bytes:
        """Return the bytes of a value; raises ``Failure`` where the variable cannot hold it."""
        variable = self.find(name)
        if variable is None:
            raise KeyError(name)
        if variable.is_constant:
            raise Failure(diagnostic(CONSTANT_FROM_OUTSIDE, name=name))
        sought, kind = variable.type, kind_of(variable.type)
        refused = _refused(name, sought, value)
        if isinstance(sought, StringType) and isinstance(value, str):
            try:
                data = value.encode("utf-16-le" if sought.is_wide else "latin-1")
            except UnicodeEncodeError:
                raise Failure(refused) from None
            unit = 2 if sought.is_wide else 1
            if len(data) > unit * sought.length or "\0" in value:
                raise Failure(refused)
            return data + bytes(unit)
        if isinstance(sought, EnumType) and isinstance(value, str) and "#" not in value:
            value = _enumeration_value(sought, value, name)
        elif isinstance(value, str):
            value = self._literal(sought, value, refused)
        if kind is None or isinstance(value, str) or variable.bit >= 0:
            raise Failure(refused)
        if isinstance(sought, PointerType | ReferenceType | InterfaceType) and value != 0:
            raise Failure(diagnostic(POINTER_FROM_OUTSIDE, name=name, type=sought.name))
        if is_real(sought):
            try:
                return struct.pack("<f" if sought.size == 4 else "<d", float(value))
            except OverflowError:
                raise Failure(refused) from None
        low, high = getattr(sought, "low", 0), getattr(sought, "high", (1 << 8 * sought.size) - 1)
        if not low <= value <= high or value != int(value):
            raise Failure(refused)
        return struct.pack("<q", as_word(int(value)))[: sought.size]

    def _literal(self, sought: Type, text: str, refused: Diagnostic) -> float:
        """Return the value of a literal with its type or base: ``T#2s``, ``16#FF`` (ST-206)."""
        single = self.program.single
        if single is None or "#" not in text:
            raise Failure(refused)
        try:
            literal = single.read(text, None)
        except Failure:
            raise Failure(refused) from None
        kinds_of_both = {getattr(one, "family", None) for one in (literal.type, sought)}
        is_same = literal.type is not None and literal.type.name == sought.name
        if not isinstance(literal.value, int | float) or not (is_same or kinds_of_both <= NUMBERS):
            raise Failure(refused)
        return literal.value

    def holds(self, name: str, data: bytes) -> bool:
        """Return whether a variable has the bytes of a value, as ``check`` gives them."""
        variable = self.find(name)
        return variable is not None and self.context.peek(variable.address, len(data)) == data

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a variable from the next cycle on."""
        data = self.check(name, value)
        variable, tasks = self.find(name), self._tasks
        if variable is None or tasks is None or self._machine is None:
            return
        if self._machine.kernel.tick == self._first_tick:  # it has not run: no bound on how much
            self.context.poke(variable.address, data)
        else:
            tasks.post(variable.address, data)

    def signal(self, name: str) -> SignalCell | None:
        """Return where a variable is shown in each tick; ``None`` if it is not a number."""
        variable = find_variable(self.program, name)
        kind = None if variable is None else kind_of(variable.type)
        if variable is None or kind is None or self._tasks is None or self._machine is None:
            return None
        cell = self._machine.free_signal_cell()
        if cell is None:
            return None
        self._tasks.show(variable.address, kind, cell)
        value = self._number(variable, kind)
        self._machine.cells[cell] = value
        return SignalCell(cell, "", not is_real(variable.type), _labels(variable.type))


def _body_of(task: Task, translated: Translation) -> Step:
    """Return the programs that a task runs in each cycle, in order."""
    bodies = [translated.bodies[pou.name.lower()] for pou in task.programs]
    return steps_in_order([translated.before, *bodies])


def _labels(sought: Type) -> tuple[tuple[int, str], ...]:
    """Return number and name of each item of an enumeration, the first name of each number."""
    if not isinstance(sought, EnumType):
        return ()
    found: dict[int, str] = {}
    for one in sought.values.values():
        found.setdefault(one.number, f"{sought.name}.{one.name}")
    return tuple(found.items())


def _refused(name: str, sought: Type, value: object, near: str = "") -> Diagnostic:
    """Return the diagnostic of a value that a variable cannot hold; ``near``: what is meant."""
    nearest = near or NOTHING
    return diagnostic(PLC_VALUE_REFUSED, name=name, type=sought.name, value=value, nearest=nearest)


def _enumeration_value(sought: EnumType, text: str, variable: str) -> int:
    """Return the number of an enumeration's item, with or without the type before its name."""
    kind, _, name = text.lower().rpartition(".")
    found = sought.values.get(name)
    if found is None or kind not in ("", sought.name.lower()):
        near = nearest_item(text, dict(_labels(sought)).values())
        raise Failure(_refused(variable, sought, text, near))
    return found.number


def _priority(task: object) -> int:
    return int(getattr(task, "priority", 0))


def _words(line: str) -> list[str]:
    word, found = "", []
    for character in f"{line} ":
        if character.isalnum() or character in "_.":
            word += character
        else:
            if word[:1].isalpha() or word[:1] == "_":
                found.append(word.strip("."))
            word = ""
    return found


#: Calls of Python for the deepest calls of a PLC (ST-407).
_PYTHON_DEPTH = 20_000


def _allow_depth() -> None:
    """Let trees that run as plain Python nest as deep as compiled ones."""
    sys.setrecursionlimit(max(sys.getrecursionlimit(), _PYTHON_DEPTH))
