# SPDX-License-Identifier: MIT
"""Statements of a body (ST-510 … 514).

In: the statements of the tree, in the scope of their POU. Out: their expressions checked; mistakes
in the statements themselves are reported.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.messages.plcs.st_check import (
    CASE_LABEL_TWICE,
    CASE_OF_WRONG_TYPE,
    CONDITION_NOT_BOOL,
    CONSTANT_EXPECTED,
    COPY_OF_BLOCK,
    COPY_REFUSED,
    EXIT_OUTSIDE_LOOP,
    FOR_NEVER_ENDS,
    FOR_VARIABLE_WRITTEN,
    REFERENCE_EXPECTED,
    SIGN_MAY_CHANGE,
    STEP_IS_ZERO,
    TYPE_MISMATCH,
)
from nctakt.messages.plcs.st_text import LONE_EXPRESSION, NESTED_TOO_DEEP
from nctakt.st.check.calls import CallChecker, _fits_in_out
from nctakt.st.check.expressions import _is_bool, _is_whole, _shown
from nctakt.st.parse.parser import MAX_DEPTH
from nctakt.st.tree import (
    Assignment,
    Call,
    CallStatement,
    Case,
    CaseBranch,
    Continue,
    Evaluation,
    Exit,
    For,
    If,
    Member,
    Name,
    Repeat,
    Return,
    While,
)
from nctakt.st.types import (
    BlockType,
    Elementary,
    EnumType,
    Expression,
    Family,
    Property,
    ReferenceType,
    Statement,
    StringType,
    Type,
    Variable,
)
from nctakt.st.vocabulary.elementary import BOOL, UNTYPED, UNTYPED_REAL


class StatementChecker(CallChecker):
    """Checks bodies."""

    def __init__(self, *parts: object) -> None:
        super().__init__(*parts)
        self._loops = 0
        self._counters: list[Variable] = []
        self._statement_checks: dict[type[Statement], Callable[..., None]] = {
            Assignment: self._assignment,
            CallStatement: self._call_statement,
            Evaluation: self._evaluation,
            If: self._if,
            Case: self._case,
            For: self._for,
            While: self._while,
            Repeat: self._repeat,
            Exit: self._exit,
            Continue: self._exit,
            Return: lambda _: None,
        }

    def body(self, statements: list[Statement]) -> None:
        """Check the statements of a body or of a part of it."""
        checks = self._statement_checks
        for statement in statements:
            try:
                checks[type(statement)](statement)
            except RecursionError:
                self.reporter.report(
                    NESTED_TOO_DEEP, statement.start, statement.start + 1, limit=MAX_DEPTH
                )

    def _assignment(self, node: Assignment) -> None:
        target, operator = node.target, node.operator
        if operator == "REF=":
            self._binding(node)
            return
        kind = self.operand(target)
        if kind in (UNTYPED, UNTYPED_REAL):
            self.expression(target)
        self.check_target(target)
        if operator != ":=":
            self._boolean(target, "S=/R=")
            self._condition(node.value)
            return
        if isinstance(target, Name | Member):
            found = target.target
            if isinstance(found, Variable) and found in self._counters:
                self.report(FOR_VARIABLE_WRITTEN, target, name=found.name)
        source = self.converted(node.value, kind)
        if isinstance(kind, BlockType) and isinstance(source, BlockType):
            is_refused = {"no_copy", "no_assign"} & set(kind.pou.attributes)
            self.report(COPY_REFUSED if is_refused else COPY_OF_BLOCK, target, name=kind.name)

    def _binding(self, node: Assignment) -> None:
        """Check ``r REF= x`` (ST-316)."""
        kind = self.operand(node.target)
        found = node.target.target if isinstance(node.target, Name | Member) else None
        is_reference = isinstance(found, Variable | Property) and isinstance(
            found.type, ReferenceType
        )
        if kind is not None and not is_reference:
            self.report(REFERENCE_EXPECTED, node.target)
            kind = None
        source = self.expression(node.value)
        if kind is None or source is None or node.value.value == 0:
            return
        self.check_target(node.value, is_handed_over=True)
        if not _fits_in_out(source, kind):
            self.report(TYPE_MISMATCH, node.value, source=_shown(source), target=_shown(kind))

    def _boolean(self, node: Expression, _: str) -> None:
        if node.type is not None and not _is_bool(node.type):
            self.report(CONDITION_NOT_BOOL, node, kind=_shown(node.type))

    def _call_statement(self, node: CallStatement) -> None:
        call = node.call
        call.type = self._call(call)
        if call.type is UNTYPED or call.type is UNTYPED_REAL:
            self.expression(call)

    def _evaluation(self, node: Evaluation) -> None:
        kind = self.expression(node.expression)
        if kind is None:
            return
        part: object = node.expression
        while isinstance(part, Member):
            if isinstance(part.target, Property) or isinstance(part.base, Call):
                return
            part = part.base
        self.report(LONE_EXPRESSION, node.expression)

    def _condition(self, node: Expression) -> None:
        kind = self.operand(node)
        if kind is UNTYPED and node.value in (0, 1):
            self._settle_into(node, BOOL)
        elif kind is not None and not _is_bool(kind):
            self.expression(node)
            self.report(CONDITION_NOT_BOOL, node, kind=_shown(kind))

    def _if(self, node: If) -> None:
        for branch in node.branches:
            self._condition(branch.condition)
            self.body(branch.body)
        self.body(node.otherwise)

    def _while(self, node: While) -> None:
        self._condition(node.condition)
        self._loop(node.body)

    def _repeat(self, node: Repeat) -> None:
        self._loop(node.body)
        self._condition(node.condition)

    def _loop(self, body: list[Statement]) -> None:
        self._loops += 1
        self.body(body)
        self._loops -= 1

    def _exit(self, node: Exit | Continue) -> None:
        if not self._loops:
            word = "EXIT" if isinstance(node, Exit) else "CONTINUE"
            self.reporter.report(EXIT_OUTSIDE_LOOP, node.start, node.end, word=word)

    # --- CASE -------------------------------------------------------------------------------------

    def _case(self, node: Case) -> None:
        kind = self.expression(node.selector)
        if kind is not None and not _is_whole(kind):
            is_text = isinstance(kind, StringType)
            if is_text or not _is_bool(kind):
                self.report(CASE_OF_WRONG_TYPE, node.selector, kind=_shown(kind))
                kind = None
        known: list[tuple[int, int]] = []
        single: set[int] = set()
        for branch in node.branches:
            self._labels(branch, kind, known, single)
            self.body(branch.body)
        self.body(node.otherwise)

    def _labels(
        self,
        branch: CaseBranch,
        kind: Type | None,
        known: list[tuple[int, int]],
        single: set[int],
    ) -> None:
        for label in branch.labels:
            first = self._label(label.low, kind)
            last = first if label.high is None else self._label(label.high, kind)
            if first is None or last is None:
                continue
            label.first, label.last = first, last
            if last < first:
                self.reporter.report(CASE_LABEL_TWICE, label.start, label.end, number=first)
            is_known = first in single if first == last else False
            if is_known or any(low <= last and first <= high for low, high in known):
                self.reporter.report(CASE_LABEL_TWICE, label.start, label.end, number=first)
            elif first == last:
                single.add(first)
            else:
                known.append((first, last))
                if any(first <= number <= last for number in single):
                    self.reporter.report(CASE_LABEL_TWICE, label.start, label.end, number=first)

    def _label(self, node: Expression, kind: Type | None) -> int | None:
        found = self.operand(node)
        if found is None:
            return None
        if not isinstance(node.value, int):
            self.expression(node)
            self.report(CONSTANT_EXPECTED, node)
            return None
        if found is UNTYPED:
            self._settle_into(node, kind) if kind is not None else self.expression(node)
        elif kind is not None and isinstance(found, EnumType) and isinstance(kind, EnumType):
            if found is not kind and kind.is_strict:
                self.report(TYPE_MISMATCH, node, source=_shown(found), target=_shown(kind))
        return int(node.value)

    # --- FOR --------------------------------------------------------------------------------------

    def _for(self, node: For) -> None:
        kind = self.operand(node.counter)
        self.check_target(node.counter)
        for limit in (node.first, node.last):
            self.converted(limit, kind)
        if node.step is not None:
            self._step(node, node.step, kind)
        if kind is not None and not _is_whole(kind):
            self.report(TYPE_MISMATCH, node.counter, source=_shown(kind), target="DINT")
            kind = None
        base = kind.base if isinstance(kind, EnumType) else kind
        if isinstance(base, Elementary):
            is_up = node.step is None or not isinstance(node.step.value, int) or node.step.value > 0
            bound = base.high if is_up else base.low
            if not base.is_subrange and node.last.value == bound and type(node.last.value) is int:
                self.report(FOR_NEVER_ENDS, node.last, number=bound, kind=base.name)
        counter = node.counter
        variable = counter.target if isinstance(counter, Name | Member) else None
        if isinstance(variable, Variable):
            self._counters.append(variable)
        self._loop(node.body)
        if isinstance(variable, Variable):
            self._counters.pop()

    def _step(self, node: For, step: Expression, kind: Type | None) -> None:
        found = self.operand(step)
        value = step.value
        if value == 0 and found is not None:
            self.report(STEP_IS_ZERO, step)
        base = kind.base if isinstance(kind, EnumType) else kind
        is_unsigned = isinstance(base, Elementary) and base.family in (Family.UNSIGNED, Family.BITS)
        if is_unsigned and isinstance(value, int) and value < 0:
            self.expression(step)
            self.report(SIGN_MAY_CHANGE, step, source=f"{value}", target=base.name if base else "")
        elif found is not None and kind is not None:
            self.convert(step, found, kind)
        elif found in (UNTYPED, UNTYPED_REAL):
            self.expression(step)
