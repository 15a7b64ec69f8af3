# SPDX-License-Identifier: MIT
"""Statements -> trees that run themselves (ST-510 … ST-514)."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence

from nctakt.kernel.st import branching, kinds
from nctakt.kernel.st.calls import Call as CallNode
from nctakt.kernel.st.observing.counting import CountedStep, SeenSelector
from nctakt.kernel.st.observing.noted import NotedLoop, NotedPass, NotedResult, NotedScope
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.steps import (
    CopyBytes,
    Evaluate,
    EvaluateReal,
    Leave,
    Step,
    StoreBit,
    steps_in_order,
)
from nctakt.kernel.st.text.texts import AssignString, StringPart
from nctakt.kernel.st.updates import updated
from nctakt.kernel.st.wholes import (
    AddWhole,
    AndBits,
    BinaryWhole,
    OrBits,
    SubtractWhole,
    Whole,
    WholeConstant,
)
from nctakt.st import tree
from nctakt.st.tree import Case
from nctakt.st.types import (
    Elementary,
    EnumType,
    Expression,
    InterfaceType,
    PointerType,
    Property,
    ReferenceType,
    Statement,
    StringType,
    Variable,
)
from nctakt.translation.body import CannotRunError, is_standard, value_type
from nctakt.translation.calls import Calls
from nctakt.translation.checks import written_pointer
from nctakt.translation.layout import as_word, is_real, is_unsigned, kind_of
from nctakt.translation.locations import Location
from nctakt.translation.observing.noting import leaves_early

_UPDATES: dict[type[Whole], int] = {
    AddWhole: kinds.ADD,
    SubtractWhole: kinds.SUBTRACT,
    AndBits: kinds.AND,
    OrBits: kinds.OR,
}


#: Lowest and highest label, and the number of their target.
LabelRange = tuple[int, int, int]

_GREATEST = (1 << 63) - 1


class Statements(Calls):
    """The statements of a body."""

    def statements(self, written: Sequence[Statement]) -> Step:
        """Return statements in order."""
        step = steps_in_order([self.statement(one) for one in written])
        number = self.project.counted.get(id(written))
        return step if number is None else CountedStep(step, number)

    def statement(self, written: Statement) -> Step:
        """Return a statement; its temporary room is free after it."""
        step = self._scoped(self._statement(written), written)
        self.frame.release()
        return step if self.probes is None else self.probes.probed(step, written)

    def _scoped(self, step: Step, written: Statement) -> Step:
        if self.notes is None or leaves_early(written):
            return step
        if isinstance(written, tree.Assignment) and self._is_result(written.target):
            return NotedResult(step, self.notes.add("result", written))
        return NotedScope(step)

    def _is_result(self, target: Expression) -> bool:
        result = self.called.result
        return isinstance(target, tree.Name) and result is not None and target.target is result

    def _loop_condition(self, condition: Expression) -> Whole:
        node = self.whole(condition)
        return node if self.notes is None else NotedLoop(node)

    def _statement(self, written: Statement) -> Step:
        source = written.start
        match written:
            case tree.Assignment():
                return self._assignment(written)
            case tree.CallStatement(call=call):
                return self._call_statement(call, source)
            case tree.If():
                return self._if(written)
            case tree.Case():
                return self._case(written)
            case tree.For():
                return self._for(written)
            case tree.While(condition=condition, body=body):
                truth, cost = self._loop_condition(condition), self.take_cost()
                return branching.While(truth, self.statements(body), source, cost)
            case tree.Repeat(condition=condition, body=body):
                inner = self.statements(body)
                truth = self._loop_condition(condition)
                return branching.Repeat(truth, inner, source, self.take_cost())
            case tree.Exit():
                return Leave(kinds.EXITS, source)
            case tree.Continue():
                return Leave(kinds.CONTINUES, source)
            case tree.Return():
                return Leave(kinds.RETURNS, source)
        raise CannotRunError(written, "such a statement")

    def _assignment(self, written: tree.Assignment) -> Step:
        value, source = written.value, written.start
        if isinstance(value, tree.AssignmentExpression):
            inner = tree.Assignment(value.start, value.end, value.target, ":=", value.assigned)
            outer = tree.Assignment(
                written.start, written.end, written.target, written.operator, value.target
            )
            return steps_in_order([self._assignment(inner), self._assignment(outer)])
        target = written.target
        if isinstance(target, tree.Name | tree.Member) and isinstance(target.target, Property):
            return self.set_property(target, value, source)
        if written.operator == "REF=":
            address = self.address_or_null(value)
            return self.slot(target).store(address, source, self.take_cost(), self.layout.data_end)
        if written.operator in ("S=", "R="):
            truth = self.whole(value)
            location, cost = self.location(target), self.take_cost()
            constant = WholeConstant(1 if written.operator == "S=" else 0)
            store = self.store(location, constant, source, 1)
            return branching.Alternative(truth, store, source, cost)
        self.written = written_pointer(target)
        location = self.location(target)
        self.written = None
        value = self.checked_range(value, location.type)
        if self._is_changed_alone(target, value):
            return self._update(location, value, source)
        return self.assign(location, value, source)

    def _is_changed_alone(self, target: Expression, value: Expression) -> bool:
        """Return whether a value is computed from the target, whose index calls nothing."""
        return (
            isinstance(value, tree.Binary)
            and value.value is None
            and is_same_variable(target, value.left)
            and self.check_function("checkbounds") is None
            and self.check_function("checkpointer") is None
        )

    def _update(self, target: Location, value: Expression, source: int) -> Step:
        """Return ``x := x + y``, which evaluates the address of x once where a node can."""
        if is_real(target.type) or kind_of(target.type) is None or target.bit >= 0:
            return self.assign(target, value, source)
        node = self.whole(value)
        operator = _UPDATES.get(type(node))
        if operator is None or not isinstance(node, BinaryWhole):
            return self.store(target, node, source, self.take_cost())
        address, cost = target.address(), self.take_cost()
        return updated(address, target.kind, operator, node.right, source, cost)

    def store(self, location: Location, value: Whole, source: int, cost: int) -> Step:
        """Return the assignment of a whole number, or of a bit."""
        if location.bit >= 0:
            return StoreBit(location.address(), location.kind, location.bit, value, source, cost)
        return location.store(value, source, cost, self.layout.data_end)

    def assign(self, target: Location, value: Expression, source: int) -> Step:
        found = target.type
        if isinstance(found, StringType):
            address, text = target.address(), self.text(value)
            return AssignString(address, found.length, text, source, self.take_cost())
        if is_real(found):
            number = self.real(value)
            return target.store_real(number, source, self.take_cost(), self.layout.data_end)
        if isinstance(found, InterfaceType):
            address = self.address_or_null(value)
            return self.store(target, address, source, self.take_cost())
        if kind_of(found) is not None:
            node = self.whole(value)
            return self.store(target, node, source, self.take_cost())
        if isinstance(value, tree.ArrayInitial | tree.StructInitial):
            return self.fill_parts(target, value, source)
        origin = self.location(value).address()
        return CopyBytes(target.address(), origin, found.size, source, self.take_cost())

    @abstractmethod
    def fill_parts(
        self, target: Location, value: tree.ArrayInitial | tree.StructInitial, source: int
    ) -> Step:
        """Return the statements that give a structure or an array its initial values."""

    def evaluated(self, node: Whole, source: int) -> Step:
        return Evaluate(node, source, self.take_cost())

    def address_or_null(self, value: Expression) -> Whole:
        """Return the address of an instance or variable; 0 and null stay."""
        if value.value is not None and not isinstance(value.value, bytes):
            return WholeConstant(int(value.value))
        if isinstance(value.type, InterfaceType):
            return self.whole(value)
        if isinstance(value, tree.Dereference) and isinstance(value.base.type, PointerType):
            return self.whole(value.base)  # nothing is read there yet
        if isinstance(value, tree.Call) and value.target is not None and not is_standard(value):
            result = value.target.result
            if result is not None and isinstance(result.type, ReferenceType):
                return self.reference_of(self.call(value), result)
        return self.pointer_of(value)

    def _call_statement(self, call: tree.Call, source: int) -> Step:
        if is_standard(call):
            node = self.built_in(call)
            if isinstance(node, StringPart):
                return Evaluate(node.address, source, self.take_cost())
            if isinstance(node, Real):
                return EvaluateReal(node, source, self.take_cost())
            return Evaluate(node, source, self.take_cost())
        called: CallNode = self.call(call)
        return Evaluate(called, source, self.take_cost())

    def _if(self, written: tree.If) -> Step:
        branches = []
        for one in written.branches:
            truth, cost = self.whole(one.condition), self.take_cost()
            self.frame.release()
            body = self.statements(one.body)
            branches.append((truth, body, one.condition.start, cost))
        otherwise = self.statements(written.otherwise)
        if len(branches) == 1:
            truth, body, source, cost = branches[0]
            if not written.otherwise:
                return branching.Alternative(truth, body, source, cost)
            return branching.EitherOr(truth, body, otherwise, source, cost)
        tied = branching.alternatives([branching.Alternative(*one) for one in branches])
        return branching.Alternatives(tied, otherwise)

    def _case(self, written: tree.Case) -> Step:
        selector, cost = self.whole(written.selector), self.take_cost()
        self.frame.release()
        ranges = labels_of(written)
        kind = value_type(written.selector)
        if isinstance(kind, Elementary | EnumType):
            seen = seen_labels(written, ranges, kind, self.project.counted)
            if seen:
                selector = SeenSelector(selector, is_unsigned(kind), seen)
        bodies = [self.statements(branch.body) for branch in written.branches]
        otherwise = self.statements(written.otherwise)
        labels = branching.choices(
            [
                (first, last, bodies[number])
                for one in ranges
                for first, last, number in as_signed(one)
            ]
        )
        return branching.Case(selector, labels, otherwise, written.start, cost)

    def _for(self, written: tree.For) -> Step:
        counter = self.location(written.counter)
        first, last = self.whole(written.first), self.whole(written.last)
        step = WholeConstant(1) if written.step is None else self.whole(written.step)
        cost = self.take_cost()
        self.frame.release()
        body = self.statements(written.body)
        if self.notes is not None:
            row = self.notes.add("pass", written)
            body = NotedPass(body, counter.address(), counter.kind, row)
        return branching.For(
            counter.address(), counter.kind, first, last, step, body, written.start, cost
        )


def is_same_variable(one: Expression, other: Expression) -> bool:
    """Return whether two expressions surely name the same variable and call nothing.

    Indices are variables and constants; dereferenced pointers may differ.
    """
    if isinstance(one.value, int):
        return one.value == other.value
    match one, other:
        case tree.Name(target=Variable() as left), tree.Name(target=right):
            return left is right
        case tree.Member(target=Variable() as left), tree.Member(target=right):
            return left is right and is_same_variable(one.base, other.base)
        case tree.Index(), tree.Index():
            if len(one.indices) != len(other.indices) or not is_same_variable(one.base, other.base):
                return False
            return all(map(is_same_variable, one.indices, other.indices))
    return False


def labels_of(written: Case) -> list[LabelRange]:
    """Return the labels by branches, without those that an earlier one covers (ST-511)."""
    kept: list[LabelRange] = []
    for number, branch in enumerate(written.branches):
        for label in branch.labels:
            left = _without(label.first, label.last, kept)
            kept += [(first, last, number) for first, last in left]
    return kept


def _without(low: int, high: int, ranges: list[LabelRange]) -> list[tuple[int, int]]:
    """Return the parts of a range that lie in none of the others."""
    pieces = [(low, high)]
    for first, last, _ in ranges:
        rest: list[tuple[int, int]] = []
        for begin, end in pieces:
            if end < first or begin > last:
                rest.append((begin, end))
                continue
            if begin < first:
                rest.append((begin, first - 1))
            if end > last:
                rest.append((last + 1, end))
        pieces = rest
    return pieces


def as_signed(label: LabelRange) -> Iterator[LabelRange]:
    """Yield a range as signed words of 64 bits: from 2⁶³ on labels of ULINT are negative there."""
    first, last, number = label
    if first <= _GREATEST:
        yield first, min(last, _GREATEST), number
    if last > _GREATEST:
        yield as_word(max(first, _GREATEST + 1)), as_word(last), number


def seen_labels(
    written: Case, ranges: list[LabelRange], kind: Elementary | EnumType, counted: Mapping[int, int]
) -> list[tuple[float, float, int]]:
    """Return ranges of the selector with the number that counts the body to which they lead."""
    numbers = [counted.get(id(branch.body)) for branch in written.branches]
    found = [(first, last, numbers[index]) for first, last, index in ranges]
    otherwise = counted.get(id(written.otherwise))
    if otherwise is not None:
        base = kind.base if isinstance(kind, EnumType) else kind
        left = _without(base.low, base.high, ranges)
        found += [(first, last, otherwise) for first, last in left]
    return [
        (float(first), float(last), number) for first, last, number in found if number is not None
    ]
