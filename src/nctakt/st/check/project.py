# SPDX-License-Identifier: MIT
"""All declared objects of a project -> a checked program (ST-401 … 407, ST-601 … 606, ST-803).

In: declarations of the project and the libraries that it refers to. Out: ``Program``. All mistakes
are reported; an object with mistakes leaves the others checked. Fixed addresses count bytes,
regardless of their letter: ``%IW2`` are the bytes 2 and 3, ``%IX2.7`` is the last bit of byte 2.
Afterwards single expressions, such as the questions of a debugger, are checked in any scope.
"""

from __future__ import annotations

import re
from collections.abc import Callable as CallableFunction
from collections.abc import Iterable, Iterator, Mapping
from operator import itemgetter
from typing import Protocol

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.messages.plcs.st_check import (
    ADDRESSES_OVERLAP,
    CONSTANT_EXPECTED,
    INTERFACE_MEMBER_MISSING,
    OVERRIDE_DIFFERS,
    OVERRIDE_OF_FINAL,
    PROGRAM_OF_TASK_UNKNOWN,
    RECURSION_REFUSED,
)
from nctakt.messages.plcs.st_text import NESTED_TOO_DEEP, UNEXPECTED_TOKEN
from nctakt.st.check.conversions import bases_of
from nctakt.st.check.names import Names, Namespace, Scope
from nctakt.st.check.resolver import Resolver
from nctakt.st.check.statements import StatementChecker
from nctakt.st.files.libraries import OwnLibrary
from nctakt.st.files.objects import parse_text
from nctakt.st.parse.lexer import END, Definitions, Lexer
from nctakt.st.parse.parser import MAX_DEPTH, ExpressionParser, SyntaxFaultError
from nctakt.st.program import Program, Task
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece
from nctakt.st.tree import (
    Declaration,
    GlobalListNode,
    Header,
    InterfaceNode,
    PouNode,
    StructNode,
    TaskNode,
    TypeDeclaration,
    VariableNode,
)
from nctakt.st.types import (
    Callable,
    EnumType,
    Expression,
    InterfaceType,
    Kind,
    Method,
    Pou,
    Property,
    StructType,
    Type,
    Variable,
    same_type,
)
from nctakt.st.vocabulary.elementary import UNTYPED, UNTYPED_REAL
from nctakt.st.vocabulary.libraries import BENEATH, SYSTEM, known, text_of

#: The task of a project that declares none (ST-803).
DEFAULT_TASK, DEFAULT_PROGRAM, DEFAULT_CYCLE_US = "PlcTask", "MAIN", 10_000


_ADDRESS = re.compile(r"%([IQM])(X?)[BWDL]?(\d+)(?:\.(\d+))?", re.ASCII)


class ProjectChecker(StatementChecker):
    """Checks one project; it also evaluates constants for the resolver."""

    def __init__(self, names: Names, resolver: Resolver, reporter: Reporter) -> None:
        super().__init__(names, resolver, reporter)
        #: Libraries that have been read, whose variables have not been checked yet.
        self.libraries_read: list[tuple[Namespace, list[Declaration]]] = []
        #: Memory of an editor for unchanged units; without it all are checked.
        self.memory: UnitMemory | None = None
        #: Constants whose initial values were checked when they were evaluated.
        self._evaluated: set[Variable] = set()

    # --- requests of the resolver -----------------------------------------------------------------

    def constant(self, node: Expression, scope: Scope) -> int | None:
        """Return the value of a whole constant; ``None`` with a report for anything else."""
        outer, self.scope = self.scope, scope
        kind = self.expression(node)
        self.scope = outer
        if isinstance(node.value, int) and not isinstance(node.value, bool):
            return node.value
        if kind is not None:
            self.report(CONSTANT_EXPECTED, node)
        return None

    def constant_of(self, variable: Variable, scope: Scope) -> None:
        """Set the value of a constant variable."""
        assert variable.initial is not None
        outer, self.scope = self.scope, scope
        self.initial(variable.initial, variable.type)
        self.scope = outer
        variable.value = variable.initial.value
        self._evaluated.add(variable)

    def enumeration_value(self, node: Expression, scope: Scope, kind: EnumType) -> int | None:
        """Return the value of an item of an enumeration."""
        outer, self.scope = self.scope, scope
        found = self.operand(node)
        if found in (UNTYPED, UNTYPED_REAL):
            self._settle_into(node, kind.base)
        self.scope = outer
        value = node.value
        if isinstance(value, int) and kind.base.low <= value <= kind.base.high:
            return int(value)
        if found is not None:
            self.report(CONSTANT_EXPECTED, node)
        return None

    # --- the walk ---------------------------------------------------------------------------------

    def check(self, declarations: list[Declaration]) -> None:
        """Check all objects of the project."""
        resolver = self.resolver
        for declared in self.names.project.declared.values():
            self._guarded(declared.node, lambda one=declared: resolver.target_of(one))
        for variable in resolver.pending():
            self._guarded(variable, lambda one=variable: resolver.complete(one))
        for node in declarations:
            if not isinstance(node, TaskNode):
                self._guarded(node, lambda one=node: self._object(one))
        self._finish_layout()
        self._report_recursion()

    def _guarded(self, node: object, action: object) -> None:
        """Run a check; nesting beyond what Python can walk is reported at its object."""
        try:
            action()  # type: ignore[operator]
        except RecursionError:
            start = getattr(node, "start", 1)
            self.reporter.report(NESTED_TOO_DEEP, start, start + 1, limit=MAX_DEPTH)

    def _object(self, node: Declaration) -> None:
        declared = self.names.project.declared.get(getattr(node, "name", "").lower())
        target = None if declared is None or declared.node is not node else declared.target
        if isinstance(node, PouNode) and isinstance(target, Pou) and target in self.resolver.nodes:
            self._pou(node, target)
        elif isinstance(node, GlobalListNode):
            self._list(node)
        elif isinstance(node, TypeDeclaration) and isinstance(target, StructType):
            self._structure(node, target)
        elif isinstance(node, TypeDeclaration) and isinstance(target, Type):
            if node.initial is not None and not isinstance(target, EnumType):
                self.scope = Scope(title=node.name)
                self.initial(node.initial, target)
        elif isinstance(node, InterfaceNode) and isinstance(target, InterfaceType):
            self._interface(target)

    def _list(self, node: GlobalListNode) -> None:
        name = node.attributes.get("list", node.name)
        found = self.names.project.lists.get(name.lower())
        self.scope = Scope("", {} if found is None else found.variables, title=name)
        for block in node.blocks:
            for item in block.variables:
                variable = None if found is None else found.variables.get(item.name.lower())
                if variable is not None and variable.start == item.start:
                    self._variable(item, variable)

    def _structure(self, node: TypeDeclaration, kind: StructType) -> None:
        self.scope = Scope(title=kind.name)
        self.resolver.layout(kind, None)
        if isinstance(node.type, StructNode):
            for item in node.type.members:
                variable = kind.members.get(item.name.lower())
                if variable is not None and variable.start == item.start:
                    self._variable(item, variable)

    def _interface(self, kind: InterfaceType) -> None:
        for method in kind.methods.values():
            for variable in method.variables.values():
                self.resolver.complete(variable)
            self.resolver.lay_out_frame(method)
        for found in kind.properties.values():
            for accessor in (found.get, found.set):
                if accessor is not None:
                    self.resolver.lay_out_frame(accessor)

    def _variable(self, node: VariableNode, variable: Variable) -> None:
        """Check the declaration of a variable: its type, initial value and arguments."""
        self.resolver.complete(variable)
        if node.initial is not None and variable not in self._evaluated:
            if node.is_bound:
                self.expression(node.initial)
            else:
                self.initial(node.initial, variable.type)
        for group in (node.arguments or [], *node.element_arguments):
            self.init_arguments(group, variable.type)

    def _pou(self, node: PouNode, pou: Pou) -> None:
        errors = self.reporter.error_count
        self._check_units(node, pou)
        self._overrides(pou)
        self._required(node, pou)
        if self.reporter.error_count > errors:
            pou.is_refused = True

    def _check_units(self, node: PouNode, pou: Pou) -> None:
        """Check the body of a POU, its methods and the accessors of its properties."""
        self._check_unit(node, pou)
        properties = pou.properties.values()
        accessors = [one for found in properties for one in (found.get, found.set)]
        for unit in (*pou.methods.values(), *accessors):
            if unit is not None:
                self._check_unit(self.resolver.nodes[unit][0], unit)

    def _check_unit(self, node: Header, unit: Callable) -> None:
        """Check the variables and the body of a POU, method, action or accessor."""
        assert isinstance(unit, Pou | Method)
        self.resolver.lay_out_frame(unit)
        if self.memory is None:
            self.unit_inside(node, unit)
        else:
            self.memory.check(node, unit, self)

    def unit_inside(self, node: Header, unit: Pou | Method) -> None:
        """Check the initial values and the statements of a unit, in its own scope."""
        self.scope = self.resolver.nodes[unit][1]
        self.unit = unit
        for block in node.variables:
            for item in block.variables:
                variable = unit.variables.get(item.name.lower())
                if variable is not None and variable.start == item.start:
                    self._variable(item, variable)
        self.body(unit.body)
        self.unit = None

    # --- inheritance ------------------------------------------------------------------------------

    def _overrides(self, pou: Pou) -> None:
        """Compare methods and properties with those of the base that they override (ST-601)."""
        if pou.base is None:
            return
        for key, method in pou.methods.items():
            other = pou.base.find_method(key)
            if other is None:
                continue
            if other.is_final:
                self.reporter.report(
                    OVERRIDE_OF_FINAL,
                    method.start,
                    method.start + len(method.name),
                    name=other.path,
                )
            elif key not in ("fb_init", "fb_exit", "fb_reinit") and not _same_shape(method, other):
                self._report_shape(method, other.path)

    def _report_shape(self, method: Method, other: str) -> None:
        end = method.start + len(method.name)
        self.reporter.report(OVERRIDE_DIFFERS, method.start, end, name=method.path, base=other)

    def _required(self, node: PouNode, pou: Pou) -> None:
        """Report members of interfaces and abstract members that a block lacks (C0087, ST-605)."""
        if pou.is_abstract or self.resolver.is_incomplete(pou):
            return
        for one in pou.bases():
            for member in one.methods.values():
                found = pou.find_method(member.name.lower())
                if member.is_abstract and found is not None and found.is_abstract:
                    self.reporter.report(
                        INTERFACE_MEMBER_MISSING, node.start, node.end, name=member.path
                    )
        interfaces: list[InterfaceType] = []
        for one in pou.bases():
            for interface in one.interfaces:
                interfaces += [kind for kind in bases_of(interface) if kind not in interfaces]
        for interface in interfaces:
            self._implemented(node, pou, interface)

    def _implemented(self, node: PouNode, pou: Pou, interface: InterfaceType) -> None:
        for key, method in interface.methods.items():
            found = pou.find_method(key)
            if found is None:
                name = f"{interface.name}.{method.name}"
                self.reporter.report(INTERFACE_MEMBER_MISSING, node.start, node.end, name=name)
            elif found.owner is pou and not _same_shape(found, method):
                self._report_shape(found, method.path)
        for key, required in interface.properties.items():
            property_ = pou.find_property(key)
            name = f"{interface.name}.{required.name}"
            if property_ is None or _lacks(property_, required):
                self.reporter.report(INTERFACE_MEMBER_MISSING, node.start, node.end, name=name)

    # --- the whole --------------------------------------------------------------------------------

    def _finish_layout(self) -> None:
        checked = 0
        while self.libraries_read or checked < len(self.resolver.library_pous):
            # Each may need further ones.
            if self.libraries_read:
                self._initial_values(*self.libraries_read.pop())
            else:
                self._library_pou(self.resolver.library_pous[checked])
                checked += 1
        for space in self.names.all_spaces():
            for declared in space.declared.values():
                if isinstance(declared.target, Type):
                    self._guarded(
                        declared.node, lambda kind=declared.target: self.resolver.layout(kind, None)
                    )
        self._guarded(None, self.resolver.lay_out_globals)

    def _initial_values(self, space: Namespace, nodes: list[Declaration]) -> None:
        """Check the initial values of variables in a library's lists and structures."""
        for node in nodes:
            if isinstance(node, GlobalListNode):
                title = node.attributes.get("list", node.name)
                variables = space.lists[title.lower()].variables
                items = [item for block in node.blocks for item in block.variables]
            elif isinstance(node, TypeDeclaration) and isinstance(node.type, StructNode):
                target = space.declared[node.name.lower()].target
                variables = target.members if isinstance(target, StructType) else {}
                items = node.type.members
            else:
                continue
            self.scope = Scope(space.library, variables, title=node.name)
            for item in items:
                variable = variables.get(item.name.lower())
                is_begun = item.initial is not None or item.arguments
                if is_begun and variable is not None and variable.start == item.start:
                    self._variable(item, variable)

    def _library_pou(self, pou: Pou) -> None:
        """Check a POU of a library whose bodies run as written."""
        node, _ = self.resolver.nodes[pou]
        assert isinstance(node, PouNode)
        self._check_units(node, pou)

    def _report_recursion(self) -> None:
        """Report units that call themselves, by others too (ST-407)."""
        state: dict[Callable, int] = {}
        for root in list(self.callers):
            if root in state:
                continue
            stack: list[tuple[Callable, Iterator[Callable]]] = [(root, iter(self.callers[root]))]
            state[root] = 1
            while stack:
                unit, rest = stack[-1]
                target = next(rest, None)
                if target is None:
                    state[unit] = 2
                    stack.pop()
                elif state.get(target) == 1:
                    call = self.callers[unit][target]
                    if call.is_virtual and isinstance(target, Method) and call.instance is not None:
                        continue  # another instance may be meant: its depth is bounded at run time
                    if isinstance(target, Pou) and target.kind is Kind.FUNCTION_BLOCK:
                        continue
                    self.report(RECURSION_REFUSED, call, name=target.path)
                elif target not in state:
                    state[target] = 1
                    stack.append((target, iter(self.callers.get(target, {}))))

    def tasks(self, nodes: list[TaskNode]) -> list[Task]:
        """Return the tasks with their programs; the usual one if none is declared."""
        tasks = []
        for node in nodes:
            programs = []
            for name in node.programs:
                pou = self.resolver.pous.get(name.rpartition(".")[2].lower())
                if pou is None or pou.kind is not Kind.PROGRAM:
                    self.reporter.report(
                        PROGRAM_OF_TASK_UNKNOWN,
                        node.start,
                        node.start + 1,
                        name=name,
                        task=node.name,
                    )
                else:
                    programs.append(pou)
            cycle = node.cycle_us or DEFAULT_CYCLE_US
            tasks.append(Task(node.name, cycle, node.priority, programs))
        own = [one for one in self.resolver.blocks if one.kind is Kind.PROGRAM and not one.library]
        main = [one for one in own if one.name.upper() == DEFAULT_PROGRAM]
        if not tasks and (main or len(own) == 1):
            tasks.append(Task(DEFAULT_TASK, DEFAULT_CYCLE_US, 0, main or own))
        return tasks


class UnitMemory(Protocol):
    """State kept between checks of a changing project (``editor.structured_text``)."""

    def check(self, node: Header, unit: Pou | Method, checker: ProjectChecker) -> None:
        """Check a unit, or repeat the findings of its last check."""

    def library(
        self, name: str, parse: CallableFunction[[], list[Declaration]]
    ) -> list[Declaration]:
        """Return the declarations of a known library, parsed once."""


def check_project(
    name: str,
    declarations: list[Declaration],
    libraries: list[str],
    reporter: Reporter,
    own: Mapping[str, OwnLibrary] | None = None,
) -> Program:
    """Check the objects of a project that refers to ``libraries``; mistakes are reported.

    ``own``: the libraries whose sources the user gives, by their names in lower case.
    """
    return checked(name, declarations, checker_of(libraries, reporter, own))


def checker_of(
    libraries: list[str],
    reporter: Reporter,
    own: Mapping[str, OwnLibrary] | None = None,
    memory: UnitMemory | None = None,
) -> ProjectChecker:
    """Return a checker with all names of libraries, which are read when they are used."""
    own = {(known(one.name) or one.name).lower(): one for one in (own or {}).values()}
    found = [known(library) for library in libraries]
    references = [known(name) for one in own.values() for name in one.references]
    beneath = [*BENEATH, *(name for name in references if name)]
    names = Names(list(dict.fromkeys([one for one in found if one] + [SYSTEM])), own, beneath)
    resolver = Resolver(names, reporter)
    checker = ProjectChecker(names, resolver, reporter)
    checker.memory, checker.reports_in_each_unit = memory, memory is not None
    resolver.evaluator = checker
    references = [library.partition(",")[0] for library in libraries]
    checker.foreign_libraries = [
        one for one in references if not known(one) and one.strip().lower() not in own
    ]

    def parsed(name: str) -> list[Declaration]:
        return parse_text(name, text_of(name), reporter)

    def load(space: Namespace) -> None:
        """Enter the declarations of a library when one of its names is used."""
        library, text = own.get(space.library.lower()), names.text_of(space)
        nodes = [] if library is None else [*library.declarations]
        if text:
            texts = parsed(text) if memory is None else memory.library(text, lambda: parsed(text))
            given = set() if library is None else {name.lower() for name in library.declared_names}
            nodes += [node for node in texts if getattr(node, "name", "").lower() not in given]
        resolver.declare(space, nodes)
        resolver.declare_values(space)
        checker.libraries_read.append((space, nodes))

    names.load = load
    return checker


def checked(name: str, declarations: list[Declaration], checker: ProjectChecker) -> Program:
    """Check the objects of a project with a new checker; return them as a program."""
    resolver, names = checker.resolver, checker.names
    resolver.declare(names.project, declarations)
    resolver.declare_values(names.project)
    for library in names.own.values():
        library.report_taken(names, checker.reporter)
    checker.check(declarations)
    tasks = checker.tasks([node for node in declarations if isinstance(node, TaskNode)])
    program = _program(name, resolver, names, tasks)
    program.single = SingleExpressions(checker)
    report_overlaps(program, resolver.reporter)
    return program


def _program(name: str, resolver: Resolver, names: Names, tasks: list[Task]) -> Program:
    """Return the checked program."""
    reporter = resolver.reporter
    return Program(
        name,
        reporter.sources,
        resolver.pous,
        [
            one.target
            for space in names.all_spaces()
            for one in space.declared.values()
            if isinstance(one.target, InterfaceType)
        ],
        {
            key: one.target
            for key, one in names.project.declared.items()
            if isinstance(one.target, Type) and not isinstance(one.target, InterfaceType)
        },
        [one for space in names.all_spaces() for one in space.lists.values()],
        tasks,
        resolver.data_size,
        resolver.globals,
        resolver.blocks,
        reporter.error_count > 0,
    )


def _same_shape(first: Method, second: Method) -> bool:
    """Whether an override has the inputs, outputs and result of the overridden method."""
    one = None if first.result is None else first.result.type
    two = None if second.result is None else second.result.type
    if first.is_action or second.is_action:
        return first.is_action is second.is_action
    if len(first.parameters) != len(second.parameters) or (one is None) is not (two is None):
        return False
    if one is not None and not same_type(one, two):
        return False
    for left, right in zip(first.parameters, second.parameters, strict=True):
        if left.name.lower() != right.name.lower() or left.section is not right.section:
            return False
    return True


def _lacks(found: Property, required: Property) -> bool:
    return (required.get is not None and found.get is None) or (
        required.set is not None and found.set is None
    )


def report_overlaps(program: Program, reporter: Reporter) -> None:
    """Report variables that share bits on a controller, and have separate memory here."""
    owners = [group.variables for group in program.lists]
    owners += [pou.members for pou in program.pous.values() if pou.kind is Kind.PROGRAM]
    found = [one for variables in owners for one in variables.values() if one.address]
    for variable, other in _overlapping(found):
        end = variable.start + len(variable.name)
        reporter.report(
            ADDRESSES_OVERLAP, variable.start, end, name=variable.name, other=other.name
        )


def _overlapping(variables: Iterable[Variable]) -> Iterator[tuple[Variable, Variable]]:
    """Yield each variable that shares bits with one that begins before it, and that one."""
    areas: dict[str, list[tuple[int, int, int, Variable]]] = {}
    for variable in variables:
        parts = _ADDRESS.fullmatch(variable.address)
        if parts is not None:
            area, is_bit, byte, bit = parts.groups()
            begin = 8 * int(byte) + int(bit or 0)
            size = 1 if is_bit or bit else 8 * variable.type.size
            areas.setdefault(area, []).append((begin, begin + size, variable.start, variable))
    for entries in areas.values():
        reach, last = 0, None
        for begin, end, _, variable in sorted(entries, key=itemgetter(0, 1, 2)):
            if last is not None and begin < reach:
                yield variable, last
            if end > reach:
                reach, last = end, variable


# --- single expressions ---------------------------------------------------------------------------


#: The name of such a text in messages.
FILE = "expression"
#: Maximum length of such a text, and number of different texts kept.
MAX_CHARACTERS = 1000
MAX_KEPT = 10_000


class SingleExpressions:
    """Reads expressions in the scopes of a project that has been checked."""

    def __init__(self, checker: StatementChecker) -> None:
        self._checker = checker
        self._known: dict[tuple[str, int], Expression] = {}

    def read(self, text: str, unit: Callable | None) -> Expression:
        """Return an expression in the scope of a unit, ``None``: that of global names.

        Raises ``Failure`` with its mistakes.
        """
        key = text, id(unit)
        found = self._known.get(key)
        if found is None:
            found = self._read(text, unit)
            if len(self._known) < MAX_KEPT:
                self._known[key] = found
        return found

    def _read(self, text: str, unit: Callable | None) -> Expression:
        checker = self._checker
        reporter = checker.reporter
        with reporter.apart() as collector:
            piece = reporter.sources.add(Piece(FILE, text, [0], [1], [1]))
            reporter.sources.lines[FILE] = [text]
            expression: Expression | None = None
            try:
                parser = ExpressionParser(Lexer(piece, Definitions(), reporter).read(), reporter)
                expression = parser.expression()
                if parser.kinds[parser.index] != END:
                    parser.report(UNEXPECTED_TOKEN, found=parser.texts[parser.index])
                self._check(expression, unit)
            except SyntaxFaultError:
                pass  # it is reported
        errors = [one for one in collector.diagnostics if one.severity is Severity.ERROR]
        if errors or expression is None:
            raise Failure(*errors)
        return expression

    def _check(self, expression: Expression, unit: Callable | None) -> None:
        checker = self._checker
        scope, checker.scope = checker.scope, Scope()
        try:
            if isinstance(unit, Pou | Method) and unit in checker.resolver.nodes:
                checker.scope = checker.resolver.nodes[unit][1]
            checker.expression(expression)
        finally:
            checker.scope = scope
