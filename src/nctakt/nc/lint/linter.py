# SPDX-License-Identifier: MIT
"""Tree -> findings beyond errors: programs that run but probably not as intended.

In: the statements of a program, the variables of its channel, the limits of a tick. Out: warnings
and notes, and the use of GLOBAL realtime cycles, because only a set of programs shows whether one
of them ends a cycle. Used by ``nctakt check``, not by a run. Two findings are errors: flushes
between G41 and G40 (``channel_flush.py``), and a D without a tool in the channel's list.

A finding that depends on the path through the program is reported only if every path leads to it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isfinite

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span, number_text
from nctakt.base.line_shift import LineShift
from nctakt.lists.declared.tools import Tool
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.tool_selection import ToolSelection
from nctakt.messages import Collector
from nctakt.messages.path.tools import (
    TOOL_NOT_IN_LIST,
    TOOL_NOT_VALID,
    UNKNOWN_TOOL,
)
from nctakt.messages.programs.lints import (
    ARC_LIKELY_WITHOUT_CENTRE,
    GLOBAL_CYCLE_NEVER_DELETED,
    VARIABLE_WRITTEN_BY_SEVERAL_CYCLES,
)
from nctakt.messages.programs.realtime import CYCLE_ID_IN_USE
from nctakt.nc.check.calls import may_call
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.motion_words import check_feed, has_radius, lacks_centre, leaves_arc
from nctakt.nc.lint.channel_flush import FlushChecker
from nctakt.nc.lint.conditions import check_condition
from nctakt.nc.lint.constants import check_constant, check_overrides, check_value, constant
from nctakt.nc.lint.cycle_uses import CycleUse
from nctakt.nc.lint.realtime_cycles import CycleLinter, KnownValue, StepLimits
from nctakt.nc.lint.uses import element_name, integer_value, operand_key
from nctakt.nc.meaning.path import command_name, keywords
from nctakt.nc.parse.open_structures import is_false
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    Assignment,
    Block,
    BracketCommand,
    CycleControl,
    Do,
    Expression,
    For,
    HashCommand,
    If,
    Keyword,
    Name,
    Number,
    Parameter,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    StringLiteral,
    StringWord,
    SubprogramCall,
    Switch,
    Variable,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary.functions import (
    COMPENSATION_OFF,
    COMPENSATIONS,
    INCH,
    MILLIMETRES,
)
from nctakt.nc.vocabulary.variables.resolution import indices_of, path_text, resolve
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable


@dataclass(frozen=True, slots=True)
class GlobalCycle:
    """A GLOBAL cycle that a program defines."""

    identity: int
    span: Span
    line: str

    def shifted(self, shift: LineShift) -> GlobalCycle:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        return replace(self, span=shift.span(self.span))


@dataclass(frozen=True, slots=True)
class GlobalCycles:
    """The GLOBAL cycles of one program; ``deletes_any``: it deletes by a computed ID."""

    defined: tuple[GlobalCycle, ...] = ()
    deleted: tuple[int, ...] = ()
    deletes_any: bool = False


def never_deleted(programs: Sequence[GlobalCycles], collector: Collector) -> None:
    """Report the GLOBAL cycles that none of these programs deletes."""
    if any(program.deletes_any for program in programs):
        return
    deleted = {identity for program in programs for identity in program.deleted}
    for program in programs:
        for cycle in program.defined:
            if cycle.identity not in deleted:
                collector.report(
                    GLOBAL_CYCLE_NEVER_DELETED, cycle.span, cycle.line, id=cycle.identity
                )


@dataclass(slots=True)
class _State:
    """Facts that are certain at a point of the program.

    The active compensation (``G41``, ``G42``), values that were set, whether no radius of arcs has
    been set, whether G02 or G03 is active, whether lengths are in inch, the IDs of the realtime
    cycles that live.
    """

    compensation: str = ""
    values: dict[str, KnownValue] = field(default_factory=dict)
    lacks_radius: bool = False
    is_arc: bool = False
    is_inch: bool = False
    living: frozenset[int] = frozenset()

    def shifted(self, shift: LineShift) -> _State:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        values = {
            name: KnownValue(value.value, shift.line(value.line))
            for name, value in self.values.items()
        }
        return replace(self, values=values)

    def copy(self) -> _State:
        return replace(self, values=dict(self.values))

    def join(self, *others: _State) -> None:
        """Keep only the facts that also hold in the other states."""
        for other in others:
            if not other.compensation:
                self.compensation = ""
            self.lacks_radius = self.lacks_radius and other.lacks_radius
            self.is_arc = self.is_arc and other.is_arc
            self.is_inch = self.is_inch and other.is_inch
            self.living &= other.living
            self.values = {
                number: value
                for number, value in self.values.items()
                if other.values.get(number) == value
            }


@dataclass(frozen=True, slots=True)
class _Writer:
    """A cycle that writes a variable."""

    line: int
    scope: str
    identity: int | None


@dataclass(frozen=True, slots=True)
class LinterState:
    """The state of a linter between two statements.

    ``certain``: the facts that hold there; ``writers``: the cycles that write variables; ``types``:
    those of the program's variables.
    """

    certain: _State
    writers: Mapping[str, _Writer]
    types: Mapping[str, str]

    @property
    def size(self) -> int:
        """How many values are in it."""
        certain = len(self.certain.values) + len(self.certain.living)
        return certain + len(self.writers) + len(self.types)

    def shifted(self, shift: LineShift) -> LinterState:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        writers = {
            name: replace(writer, line=shift.line(writer.line))
            for name, writer in self.writers.items()
        }
        return LinterState(self.certain.shifted(shift), writers, self.types)


class Linter:
    """Visits the statements of one program in the order of execution, each once.

    The caller announces each section (main program, local subprogram) and passes its statements one
    by one, so that the program need not be in memory. ``tools``: those of the channel's list.
    ``selection``: the effects of T and D in this channel.
    """

    def __init__(
        self,
        source: Source,
        names: NameTable,
        limits: StepLimits,
        collector: Collector,
        tools: Mapping[int, Tool],
        selection: ToolSelection,
    ) -> None:
        self._source = source
        self._tools = tools
        self._selection = selection
        self._names = names
        self._findings = Findings(source, collector)
        self._cycles = CycleLinter(names, self._findings, limits)
        self._channel = FlushChecker(names, self._findings)
        self._state = _State()
        self._writers: dict[str, _Writer] = {}
        self._types: dict[str, str] = {}
        #: GLOBAL cycles in the order of the text, and IDs of deleted ones, ``None``: a computed ID.
        self.defined: list[GlobalCycle] = []
        self.deleted: list[int | None] = []
        #: Cycles defined and started, in the order of the text.
        self.cycle_uses: list[CycleUse] = []

    @property
    def state(self) -> LinterState:
        """State that later statements depend on."""
        return LinterState(self._state.copy(), dict(self._writers), dict(self._types))

    def resume(self, state: LinterState) -> None:
        """Continue from a state."""
        self._state = state.certain.copy()
        self._writers = dict(state.writers)
        self._types = dict(state.types)

    @property
    def sees_next_block(self) -> bool:
        """Whether a block of axis words alone may have a finding, or change the certain facts.

        Any other plain block has been judged by its shape.
        """
        return self._state.is_arc and self._state.lacks_radius

    def section(self) -> None:
        """Begin a main program or subprogram; nothing is certain, except that no radius is set."""
        self._state = _State(lacks_radius=True)
        self._types = {}

    @property
    def global_cycles(self) -> GlobalCycles:
        """The GLOBAL cycles that the statements so far define and delete."""
        deleted = tuple(identity for identity in self.deleted if identity is not None)
        return GlobalCycles(tuple(self.defined), deleted, None in self.deleted)

    def _all(self, statements: Sequence[Statement]) -> None:
        for statement in statements:
            self.statement(statement)

    def statement(self, statement: Statement) -> None:
        """Visit one statement with all statements inside it."""
        if statement.head.label is not None:
            self._state = _State()  # a jump may lead here from anywhere
        if self._state.compensation:
            self._channel.check(statement, self._state.compensation)
        match statement:
            case Block():
                self._block(statement)
            case Assignment():
                self._assignment(statement)
            case RealtimeCycle():
                self._definition(statement)
            case CycleControl():
                self._control(statement)
            case If():
                self._if(statement)
            case Switch():
                self._switch(statement)
            case For() | While() | Do() | Repeat() | RealtimeLoop():
                self._loop(statement)
            case VariableDeclarations():
                self._declarations(statement)
            case HashCommand():
                if command_name(statement) == "OVERRIDE":
                    check_overrides(keywords(statement), self._findings)
            case SubprogramCall():
                if not isinstance(statement.name, StringLiteral):
                    self._use(statement.span, None, is_definition=True, is_start=True)
                self._state.values.clear()
                self._state.lacks_radius = False
                self._state.is_arc = False
                self._state.is_inch = False
                self._state.living = frozenset()

    # --- states through the program
    # ----------------------------------------------------------------

    def _if(self, statement: If) -> None:
        before = self._state
        states: list[_State] = []
        bodies = [(statement.condition, statement.body)]
        bodies += [(branch.condition, branch.body) for branch in statement.elseifs]
        for condition, body in bodies:
            self._condition(condition)
            if not is_false(condition):
                states.append(self._state_after(before, body))
        states.append(self._state_after(before, statement.else_body or ()))
        self._state = states[0]
        self._state.join(*states[1:])

    def _switch(self, switch: Switch) -> None:
        before = self._state
        states = [self._state_after(before, case.body) for case in switch.cases]
        self._state = before.copy()
        self._state.join(*states)

    def _state_after(self, before: _State, body: Sequence[Statement]) -> _State:
        self._state = before.copy()
        self._all(body)
        return self._state

    def _loop(self, loop: For | While | Do | Repeat | RealtimeLoop) -> None:
        """Visit a loop: an earlier pass may have changed values, and the body may not run at
        all.
        """
        if isinstance(loop, While) and is_false(loop.condition):
            return
        if isinstance(loop, While | Do | Repeat):
            self._condition(loop.condition)
        self._state.values.clear()
        self._state.is_arc = False
        self._state.is_inch = False
        self._state.living = frozenset()
        before = self._state.copy()
        self._all(loop.body)
        self._state.values.clear()
        self._state.living = frozenset()
        if isinstance(loop, For | While | RealtimeLoop):
            self._state.join(before)

    def _condition(self, condition: Expression) -> None:
        check_condition(condition, self._names, self._findings, is_inch=self._state.is_inch)

    # --- values ----------------------------------------------------------------------------------

    def _declarations(self, block: VariableDeclarations) -> None:
        """Note the types of a program's variables; check their initial constants."""
        for declaration in block.declarations:
            type_ = declaration.type_name or "REAL64"
            is_text = isinstance(declaration.initial, StringLiteral)
            if is_text or type_ not in SCALARS or type_ in ("STRING", "VSTRING"):
                continue
            name = path_text(declaration.variable)
            # A name that is declared again with another type is not followed.
            self._types[name] = type_ if self._types.get(name, type_) == type_ else ""
            if declaration.initial is not None:
                check_value(declaration.variable, type_, declaration.initial, self._findings)
            if not any(indices_of(declaration.variable)):
                self._set(declaration.variable, declaration.initial, declaration.span.line)

    def _assignment(self, statement: Assignment) -> None:
        """Forget the values of the target and its parts; note a constant that is assigned."""
        target = statement.target
        check_constant(statement, self._names, self._findings, in_cycle=False)
        if isinstance(target, Parameter) and target.call:
            return
        if isinstance(target, Variable) and (type_ := self._types.get(path_text(target))):
            is_added = statement.operator != "="
            if statement.operator in ("=", "+=", "-="):
                check_value(target, type_, statement.value, self._findings, is_added=is_added)
        value = statement.value if statement.operator == "=" else None
        self._set(target, value, statement.span.line)

    def _set(self, target: Variable | Parameter, expression: Expression | None, line: int) -> None:
        """Forget the values of a variable and its parts; note one that is certain."""
        key = operand_key(target)
        root = key.split("[]")[0]
        values = {
            name: value
            for name, value in self._state.values.items()
            if name != root and not name.startswith((f"{root}.", f"{root}["))
        }
        value = None if expression is None else constant(expression)
        if value is not None and root == key and self._holds(target, value):
            values[key] = KnownValue(value, line)
        self._state.values = values

    def _holds(self, target: Variable | Parameter, value: float) -> bool:
        """Return whether a variable certainly has this value once it is assigned (RC-307).

        Other programs may have written V.S by the time that it is read.
        """
        if isinstance(target, Parameter):
            return True
        if target.family == "S":
            return False
        location = resolve(target, self._names)
        listed = location.type if isinstance(location, Location) else ""
        scalar = SCALARS.get(listed or self._types.get(path_text(target), ""))
        if scalar is None or not scalar.is_integer:
            return scalar is not None
        return value == round(value) and scalar.low <= value <= scalar.high

    # --- realtime cycles -------------------------------------------------------------------------

    def _definition(self, cycle: RealtimeCycle) -> None:
        keywords = {item.name: item.value for item in cycle.keywords if isinstance(item, Keyword)}
        identity = self._identity(keywords.get("ID"))
        scope = keywords.get("SCOPE")
        name = scope.name if isinstance(scope, Name) else "PROG"
        writes = self._cycles.cycle(cycle, self._state.values, is_inch=self._state.is_inch)
        self._writes(writes, _Writer(cycle.span.line, name, identity))
        if "ID" in keywords:
            self._use(
                cycle.span, identity, name, is_definition=True, is_deferred=cycle.definition_only
            )
        if identity is not None and name != "BLOCK":
            self._lives(identity, cycle)
        if name == "GLOBAL" and identity is not None and identity > 0:
            line = self._source.line_of(cycle.span)
            self.defined.append(GlobalCycle(identity, cycle.span, line))

    def _use(
        self,
        span: Span,
        identity: int | None,
        scope: str = "",
        *,
        is_definition: bool = False,
        is_start: bool = False,
        is_deferred: bool = False,
    ) -> None:
        """Note cycles defined or started."""
        line = self._source.line_of(span)
        use = CycleUse(identity, span, line, scope, is_definition, is_start, is_deferred)
        self.cycle_uses.append(use)

    def _lives(self, identity: int, cycle: RealtimeCycle) -> None:
        """Note that a cycle exists; report an ID that certainly exists already."""
        if identity in self._state.living:
            self._findings.report(CYCLE_ID_IN_USE, cycle.span, id=identity)
        self._state.living |= {identity}

    def _writes(self, writes: dict[str, Variable], writer: _Writer) -> None:
        """Report variables written by two cycles that may live at the same time, once for both."""
        common: dict[_Writer, list[Variable]] = {}
        for name, target in writes.items():
            first = self._writers.setdefault(name, writer)
            if first is writer or first.scope == writer.scope == "BLOCK":
                continue
            if first.identity is None or first.identity != writer.identity:
                common.setdefault(first, []).append(target)
        for first, targets in common.items():
            names = ", ".join(element_name(target) for target in targets)
            self._findings.report(
                VARIABLE_WRITTEN_BY_SEVERAL_CYCLES, targets[0].span, names=names, line=first.line
            )

    def _control(self, control: CycleControl) -> None:
        if control.action not in ("DELETE", "START"):
            return
        values = [item.value for item in control.keywords if isinstance(item, Keyword)]
        identity = self._identity(values[0]) if values else 0
        if control.action == "START":
            self._use(control.span, identity, is_start=True)
        elif identity is None:
            self.deleted.append(None)
            self._state.living = frozenset()
        else:
            self._state.living -= {identity}
            self.deleted.append(identity)
            self._writers = {
                name: writer
                for name, writer in self._writers.items()
                if writer.identity is None or writer.identity != identity
            }

    def _identity(self, value: Expression | None) -> int | None:
        """Return the value of an ID if it is known, else ``None``."""
        if isinstance(value, Parameter):
            number = self._state.values.get(operand_key(value))
            return None if number is None or not isfinite(number.value) else int(number.value)
        return integer_value(value)

    # --- tool radius compensation ----------------------------------------------------------------

    def _block(self, block: Block) -> None:
        check_feed(block, self._findings)
        if may_call(block):
            self._state.living = frozenset()
            self._use(block.span, None, is_definition=True, is_start=True)
        if has_radius(block) or any(isinstance(word, StringWord) for word in block.words):
            self._state.lacks_radius = False
        elif self._state.lacks_radius and lacks_centre(block, is_modal=self._state.is_arc):
            self._findings.report(ARC_LIKELY_WITHOUT_CENTRE, block.span)
        self._state.is_arc = leaves_arc(block, before=self._state.is_arc)
        for word in block.words:
            if isinstance(word, Word) and word.name == "G" and isinstance(word.value, Number):
                if word.value.value in COMPENSATIONS:
                    self._state.compensation = f"G{number_text(word.value.value)}"
                elif word.value.value == COMPENSATION_OFF:
                    self._state.compensation = ""
                elif word.value.value in (INCH, MILLIMETRES):
                    self._state.is_inch = word.value.value == INCH
            elif isinstance(word, Word) and word.name in ("D", "T") and self._tools:
                self._tool(word, block)
            elif isinstance(word, BracketCommand):
                check_overrides(word.items, self._findings)

    def _tool(self, word: Word, block: Block) -> None:
        """Check that D names a valid tool, or none (D0), and that T names a tool of the list.

        T that selects offsets (P-CHAN-00014) counts like D; together with a D it does not select
        them. An external tool management (P-CHAN-00016) has its own tools.
        """
        if self._selection.is_external:
            return
        if not isinstance(word.value, Number) or not word.value.value.is_integer():
            return
        number = int(word.value.value)
        has_d = any(isinstance(other, Word) and other.name == "D" for other in block.words)
        is_selected = word.name == "D" or (self._selection.by_t and not has_d)
        if number > 0 and number not in self._tools:
            message = UNKNOWN_TOOL if word.name == "D" else TOOL_NOT_IN_LIST
            self._findings.report(message, word.span, tool=number)
        elif number > 0 and is_selected and not self._tools[number].valid:
            self._findings.report(TOOL_NOT_VALID, word.span, tool=number)
        elif number > 0 and is_selected:
            for message, values in self._selection.mistakes(self._tools[number]):
                self._findings.report(message, word.span, tool=number, **values)
