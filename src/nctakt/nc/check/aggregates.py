# SPDX-License-Identifier: MIT
"""Assignments of structures and whole arrays, checked before the run (RC-208, RC-310).

In: assignments with an aggregate on the right side. Out: diagnostics. An aggregate may be assigned
to another of the same type, in a realtime cycle to a synchronous one (RC-301). Where a single value
is needed, the message suggests the member that was probably meant.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from nctakt.base.diagnostics import Message
from nctakt.messages.machines.memory import AGGREGATE_TYPE_MISMATCH
from nctakt.messages.programs.checked_cycles import ASYNCHRONOUS_WRITE_IN_CYCLE
from nctakt.messages.programs.checked_values import (
    ASYNCHRONOUS_INDEX,
    STRUCTURE_USED_AS_VALUE,
    VARIABLE_READ_ONLY,
    VARIABLE_WRITE_ONLY,
)
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Assignment, Expression, Parameter, Variable
from nctakt.nc.vocabulary.variables.cells import leaf_cells, same_type
from nctakt.nc.vocabulary.variables.realtime_variables import Access
from nctakt.nc.vocabulary.variables.resolution import (
    indices_of,
    path_text,
    resolve,
    resolve_aggregate,
    variables_in,
)
from nctakt.nc.vocabulary.variables.variable_table import (
    RIGHTS,
    Aggregate,
    Location,
    NameTable,
    NotFound,
    Problem,
)


class AssignmentChecks(Protocol):
    """The checks of expressions and targets that an assignment of an aggregate needs, too."""

    def value(self, expression: Expression) -> None:
        """Check an expression whose value is needed."""

    def write(
        self, target: Variable | Parameter, *, compound: bool = False, text: bool = False
    ) -> None:
        """Check the target of an assignment; ``compound``: it is read as well, as in ``+=``."""

    def not_found(self, variable: Variable, missing: NotFound) -> None:
        """Report why a variable does not exist."""

    def indices_fit(self, variable: Variable, location: Location | Aggregate) -> bool:
        """Return whether the constant indices are inside the array; report those that are not."""


class AggregateChecker:
    """Checks assignments of aggregates; ``values`` checks everything else."""

    def __init__(
        self, values: AssignmentChecks, names: NameTable, findings: Findings, *, in_cycle: bool
    ) -> None:
        self._values = values
        self._names = names
        self._findings = findings
        self._in_cycle = in_cycle

    def is_aggregate(self, variable: Variable) -> bool:
        """Return whether a variable names a structure or a whole array."""
        return self._find(variable) is not None

    def _find(self, expression: Expression) -> Aggregate | None:
        if not isinstance(expression, Variable):
            return None
        aggregate = resolve_aggregate(expression, self._names)
        return aggregate if isinstance(aggregate, Aggregate) else None

    def copy(self, statement: Assignment, value: Variable) -> None:
        """Check ``target = value``: both must be aggregates of one type, with the rights needed."""
        target = statement.target
        source, destination = self._find(value), self._find(target)
        assert source is not None
        if destination is None or statement.operator != "=":
            self._values.write(target, compound=statement.operator != "=")
            self._no_value(target, value)
            return
        assert isinstance(target, Variable)
        name, member = path_text(target), _first_member(source)
        for index in (*indices_of(target), *indices_of(value)):
            self._values.value(index)
        if not same_type(source.node, destination.node):
            other = path_text(value)
            self._findings.report(
                AGGREGATE_TYPE_MISMATCH, value.span, name=name, value=other, member=member
            )
            return
        fits = [
            self._values.indices_fit(target, destination),
            self._values.indices_fit(value, source),
        ]
        if all(fits):
            self._may(target, destination, Access.WRITE, VARIABLE_READ_ONLY)
            self._may(value, source, Access.READ, VARIABLE_WRITE_ONLY)
            if self._in_cycle:
                self._synchronous(target, destination, value, source)

    def _synchronous(
        self, target: Variable, destination: Aggregate, value: Variable, source: Aggregate
    ) -> None:
        """Report an asynchronous member that a cycle would write, or find by a live index."""
        members = leaf_cells(replace(destination.node, array_elements=0), destination.name, 0)
        late = [name for name, leaf, _ in members if not leaf.synchronous]
        if late and not target.synchronous:
            self._findings.report(ASYNCHRONOUS_WRITE_IN_CYCLE, target.span, name=late[0])
        is_live = value.synchronous or all(
            leaf.synchronous for _, leaf, _ in leaf_cells(source.node, "", 0)
        )
        indices = [each for index in indices_of(value) for each in variables_in(index)]
        if not is_live and any(self._is_live(each) for each in indices):
            self._findings.report(ASYNCHRONOUS_INDEX, value.span, name=source.name)

    def _is_live(self, variable: Variable) -> bool:
        location = resolve(variable, self._names)
        return isinstance(location, Location) and (location.synchronous or variable.synchronous)

    def _may(self, variable: Variable, whole: Aggregate, access: Access, message: Message) -> None:
        """Report the first member that may not be written or read."""
        element = replace(whole.node, array_elements=0)
        for name, leaf, _ in leaf_cells(element, whole.name, 0):
            if access not in RIGHTS[leaf.rights]:
                self._findings.report(message, variable.span, name=name)
                return

    def _no_value(self, target: Variable | Parameter, value: Variable) -> None:
        """Report a structure or array where a single value is needed."""
        missing = resolve(value, self._names)
        assert isinstance(missing, NotFound)
        if missing.reason is Problem.STRUCTURE:
            member = self._member_like(target, value) or missing.nearest
            self._findings.report(
                STRUCTURE_USED_AS_VALUE, value.span, name=missing.name, member=member
            )
        else:
            self._values.not_found(value, missing)

    def _member_like(self, target: Variable | Parameter, value: Variable) -> str:
        """Return the member of ``value`` with the name of ``target``'s last part; empty if there
        is none.
        """
        if not isinstance(target, Variable) or not target.parts:
            return ""
        name = target.parts[-1].name
        parts = [(part.name, len(part.indices)) for part in value.parts]
        member = self._names.resolve(value.family, [*parts, (name, 0)])
        exists = isinstance(member, Location)
        return f"{self._findings.written(value.span)}.{name}" if exists else ""


def _first_member(whole: Aggregate) -> str:
    """Return an example of a part that can be assigned instead."""
    if whole.node.array_elements:
        return f"{whole.name}[0]"
    return f"{whole.name}.{whole.node.members[0].name}"
