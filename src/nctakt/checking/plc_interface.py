# SPDX-License-Identifier: MIT
"""Checks of a PLC's code against the machine's lists.

In: a checked PLC program that uses the interface, and a machine. Out: warnings for channels and
axes that the machine lacks, functions of the channel lists that the code does not acknowledge or
that only the code knows, handshakes that nothing completes, V.E variables of another layout, tasks
too slow for realtime cycles.
Computed values may be anything, and are left out.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message
from nctakt.checking.plc_variables import Pointed, differing, pointed
from nctakt.hli.table import LIST_NAME
from nctakt.lists.machine.machine import Machine
from nctakt.messages import Collector
from nctakt.messages.plcs.plc_interface import (
    CODE_KNOWS_UNLISTED_FUNCTION,
    FUNCTION_NOT_ACKNOWLEDGED,
    INTERFACE_INDEX_OUTSIDE,
    LATE_UNITS_SEEN_LATE,
    NOTHING_ACKNOWLEDGES,
    SEMAPHORE_NEVER_SET,
    VARIABLE_DIFFERS,
)
from nctakt.st import tree
from nctakt.st.program import Program
from nctakt.st.types import ArrayType, Callable, Expression, Node, Statement, StructType, Variable

_UNIT, _PROCESS, _SEMAPHORE = "TECHNO_UNIT_CH", "HLI_M_H_PROZESS", "command_semaphor_rw"
_LATE = "techno_unit_late_sync"
#: Functions with these synchronisations wait for the PLC's answer.
_ANSWERED = frozenset(("MVS_SVS", "MVS_SNS", "MNS_SNS", "MNE_SNS", "MEP_SVS", "MET_SVS"))

#: The numbers for which a statement runs; ``None``: any.
Numbers = frozenset[int] | None


@dataclass(slots=True)
class _Facts:
    """Uses of the interface in the bodies of a program."""

    indices: list[tuple[str, tree.Index, int]]
    announced: list[Node]
    #: Where ``done_w`` is set, for which numbers.
    acknowledged: list[tuple[Node, Numbers]]
    #: Commands of units with a semaphore, and the units whose semaphore is set, by their types.
    commands: list[tuple[str, Node]]
    semaphores: set[str]
    known: dict[int, Node]
    #: Assignments to pointers to structures.
    pointed: list[Pointed]
    #: The units of functions that realtime cycles output.
    late: list[Node]
    #: Parts of the interface are reached by addresses: other code may write them.
    has_addresses: bool = False


def report_interface_uses(program: Program, machine: Machine, collector: Collector) -> None:
    """Report where the code of a PLC does not fit the lists of its machine."""
    if program.has_errors or not any(
        group.name == LIST_NAME.rstrip(".") and group.variables for group in program.lists
    ):
        return
    facts = _Facts([], [], [], [], set(), {}, [], [])
    for called in _bodies(program):
        _statements(called.body, None, facts)
    report = _Report(program, collector)
    counts = {"gpCh": len(machine.channels), "gpVECh": len(machine.channels)}
    counts["gpAx"] = len(machine.axes)
    for root, index, number in facts.indices:
        if not 0 <= number < counts.get(root, number + 1):
            report(INTERFACE_INDEX_OUTSIDE, index, name=root, index=number, count=counts[root])
    for node, values in differing(facts.pointed, machine):
        report(VARIABLE_DIFFERS, node, **values)
    fastest = min((task.cycle_us for task in program.tasks if task.programs), default=0)
    if facts.late and fastest > machine.cycle_time_us:
        first = min(facts.late, key=lambda node: node.start)
        cycle, tick = (f"{one / 1000:g} ms" for one in (fastest, machine.cycle_time_us))
        report(LATE_UNITS_SEEN_LATE, first, cycle=cycle, tick=tick)
    if facts.has_addresses:
        return
    _report_functions(facts, machine, report)
    for kind, node in facts.commands:
        if kind not in facts.semaphores:
            report(SEMAPHORE_NEVER_SET, node, kind=kind)


class _Report:
    """Reports at nodes of a program."""

    def __init__(self, program: Program, collector: Collector) -> None:
        self._sources = program.sources
        self._collector = collector

    def __call__(self, message: Message, node: Node, **values: object) -> None:
        span = self._sources.span(node.start, node.end)
        line = "" if span is None else self._sources.line(span.file, span.line)
        self._collector.report(message, span, line, **values)


def _report_functions(facts: _Facts, machine: Machine, report: _Report) -> None:
    listed: dict[int, set[str]] = {}
    waiting: dict[int, str] = {}
    for channel in machine.channels:
        groups = {"M": channel.parameters.m_functions, "H": channel.parameters.h_functions}
        for letter, functions in groups.items():
            for number, function in functions.items():
                listed.setdefault(number, set()).add(letter)
                if function.synchronisation in _ANSWERED and not function.axis_name:
                    waiting.setdefault(number, f"{letter}{number}")
    if not facts.acknowledged:
        if facts.announced and waiting:
            report(NOTHING_ACKNOWLEDGES, facts.announced[0])
        return
    numbers = [one for _, one in facts.acknowledged]
    if all(one is not None for one in numbers):
        handled = frozenset().union(*(one for one in numbers if one is not None))
        missing = [name for number, name in sorted(waiting.items()) if number not in handled]
        if missing:
            report(
                FUNCTION_NOT_ACKNOWLEDGED, facts.acknowledged[0][0], functions=", ".join(missing)
            )
    for number, node in facts.known.items():
        if listed and number not in listed:
            report(CODE_KNOWS_UNLISTED_FUNCTION, node, number=number)


def _bodies(program: Program) -> Iterator[Callable]:
    for pou in program.pous.values():
        if pou.library:
            continue
        yield pou
        yield from pou.methods.values()
        for one in pou.properties.values():
            yield from (part for part in (one.get, one.set) if part is not None)


def _statements(body: Sequence[Statement], numbers: Numbers, facts: _Facts) -> None:
    for statement in body:
        match statement:
            case tree.If(branches=branches, otherwise=otherwise):
                for branch in branches:
                    _expressions(branch.condition, facts)
                    _statements(branch.body, _compared(branch.condition, numbers, facts), facts)
                _statements(otherwise, numbers, facts)
            case tree.Case(selector=selector, branches=labelled, otherwise=otherwise):
                _expressions(selector, facts)
                for one in labelled:
                    _statements(one.body, _labelled(selector, one, numbers, facts), facts)
                _statements(otherwise, numbers, facts)
            case tree.For(body=inner) | tree.While(body=inner) | tree.Repeat(body=inner):
                _expressions(statement, facts)
                _statements(inner, numbers, facts)
            case tree.Assignment(target=target, value=value):
                _expressions(statement, facts)
                _assignment(target, value, numbers, facts)
            case _:
                _expressions(statement, facts)


def _labelled(
    selector: Expression, branch: tree.CaseBranch, numbers: Numbers, facts: _Facts
) -> Numbers:
    """Return the numbers of functions for which a branch of ``CASE`` runs."""
    if not _is_number_of_function(selector):
        return numbers
    found: set[int] = set()
    for label in branch.labels:
        found.update(range(label.first, min(label.last, label.first + 9999) + 1))
        if label.first == label.last:
            facts.known.setdefault(label.first, label)
    return frozenset(found)


def _compared(condition: Expression, numbers: Numbers, facts: _Facts) -> Numbers:
    """Return the numbers for which ``IF p^.nr = 100 THEN`` runs."""
    if isinstance(condition, tree.Binary) and condition.operator is tree.Operator.EQUAL:
        for one, other in ((condition.left, condition.right), (condition.right, condition.left)):
            if _is_number_of_function(one) and isinstance(other.value, int):
                facts.known.setdefault(other.value, other)
                return frozenset((other.value,))
    return numbers


def _is_number_of_function(node: Expression) -> bool:
    """Return whether an expression is the number of a function, converted or not."""
    while isinstance(node, tree.Call) and node.kind is tree.CallKind.CONVERSION and node.operands:
        node = node.operands[0]
    is_number = isinstance(node, tree.Member) and node.name.lower() == "nr"
    return is_number and _owner(node) == _PROCESS


def _owner(node: Expression) -> str:
    """Return the name of the structure that a path names a member of."""
    kind = node.base.type if isinstance(node, tree.Member) else None
    return kind.name if isinstance(kind, StructType) else ""


def _assignment(target: Expression, value: Expression, numbers: Numbers, facts: _Facts) -> None:
    pointer = pointed(target, value)
    if pointer is not None:
        facts.pointed.append(pointer)
    if not isinstance(target, tree.Member) or value.value is False:
        return
    name, owner = target.name.lower(), _owner(target)
    if name == "done_w" and owner == _UNIT:
        facts.acknowledged.append((target, numbers))
    elif name == "plc_present_w" and _root(target) == "gpCh":
        facts.announced.append(target)
    elif name == _SEMAPHORE:
        facts.semaphores.add(owner)
    part: Expression = target
    while isinstance(part, tree.Member | tree.Index):
        kind = part.base.type
        if isinstance(part, tree.Member) and part.name.lower() == "command_w":
            if isinstance(kind, StructType) and _SEMAPHORE in kind.members:
                facts.commands.append((kind.name, target))
        part = part.base


def _root(node: Expression) -> str:
    """Return the name that a path begins with."""
    part: Expression = node
    while isinstance(part, tree.Member | tree.Index | tree.Dereference):
        part = part.base
    is_list = isinstance(part, tree.Name) and isinstance(part.target, Variable)
    return part.name if is_list and isinstance(part, tree.Name) else ""


def _is_of_interface(node: Expression) -> bool:
    """Return whether an address is one of a channel with its units, not of a function's data."""
    kind = node.type.element if isinstance(node.type, ArrayType) else node.type
    is_outer = isinstance(kind, StructType) and kind.name in (_UNIT, "HIGH_LEVEL_INTERFACE_CH")
    return is_outer and _root(node) == "gpCh"


def _expressions(node: Node, facts: _Facts) -> None:
    """Find the elements of the interface in the expressions of a statement."""
    waiting: list[object] = [node]
    while waiting:
        one = waiting.pop()
        if isinstance(one, list):
            waiting += one
        if not isinstance(one, Node) or (isinstance(one, Statement) and one is not node):
            continue
        if isinstance(one, tree.Index) and len(one.indices) == 1:
            base, number = one.base, one.indices[0].value
            target = getattr(base, "target", None)
            is_list = isinstance(target, Variable) and target.owner == LIST_NAME.rstrip(".")
            if is_list and isinstance(number, int) and isinstance(target, Variable):
                facts.indices.append((target.name, one, number))
        if isinstance(one, tree.Member) and one.name.lower() == _LATE and _root(one) == "gpCh":
            facts.late.append(one)
        if isinstance(one, tree.Call) and one.function == "ADR":
            facts.has_addresses |= any(_is_of_interface(part) for part in one.operands)
        for field in dataclasses.fields(one):
            if field.name != "instance":  # it is part of the callee
                waiting.append(getattr(one, field.name))
