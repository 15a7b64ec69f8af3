# SPDX-License-Identifier: MIT
"""Nodes that note what leads to a change (``notes.py``): they wrap the working nodes.

They cost no elementary instructions, so that a run that is explained does the same as another one.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.calls import Call, Callee
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.wholes import Whole


class NotedWhole(Whole):
    """An operand, a condition or a selector: its value becomes a row."""

    def __init__(self, operand: Whole, row: int) -> None:
        check_range(row, 0, kinds.MAX_COUNTS - 1, "row")
        self.operand = operand
        self.row = row

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        context.notes.push(self.row, value)
        return value


class NotedReal(Real):
    """A real operand: its bits become a row."""

    def __init__(self, operand: Real, row: int) -> None:
        check_range(row, 0, kinds.MAX_COUNTS - 1, "row")
        self.operand = operand
        self.row = row

    def number(self, context: PlcContext) -> float:
        number = self.operand.number(context)
        context.notes.push_real(self.row, number)
        return number


class NotedLoop(Whole):
    """The condition of a loop: notes of an earlier pass leave the stack first."""

    def __init__(self, operand: Whole) -> None:
        self.operand = operand

    def value(self, context: PlcContext) -> int:
        context.notes.leave(context.notes.loop)
        return self.operand.value(context)


class NotedPass(Step):
    """A pass of ``FOR`` with the value of its counter."""

    def __init__(self, body: Step, address: Whole, kind: int, row: int) -> None:
        check_range(kind, kinds.BOOL, kinds.U64, "kind")
        check_range(row, 0, kinds.MAX_COUNTS - 1, "row")
        self.body = body
        self.address = address
        self.kind = kind
        self.row = row

    def run(self, context: PlcContext) -> int:
        context.notes.leave(context.notes.loop)
        at = context.checked(self.address.value(context), 1)
        context.notes.push(self.row, words.load(context.memory, at, self.kind))
        return self.body.run(context)


class NotedScope(Step):
    """A statement: its notes leave the stack after it."""

    def __init__(self, body: Step) -> None:
        self.body = body

    def run(self, context: PlcContext) -> int:
        begin = context.notes.top
        outer = context.notes.loop
        context.notes.loop = begin
        end = self.body.run(context)
        context.notes.loop = outer
        context.notes.leave(begin)
        return end


class NotedResult(Step):
    """An assignment to the result of a call: its notes stay until the caller has used it."""

    def __init__(self, body: Step, row: int) -> None:
        check_range(row, 0, kinds.MAX_COUNTS - 1, "row")
        self.body = body
        self.row = row

    def run(self, context: PlcContext) -> int:
        end = self.body.run(context)
        context.notes.push(self.row, 0)
        context.notes.kept = context.notes.top
        return end


class NotedCall(Call):
    """A call: its instance becomes a row; the notes for its result stay."""

    def __init__(self, call: Call, row: int) -> None:
        check_range(row, 0, kinds.MAX_COUNTS - 1, "row")
        super().__init__(Callee(), Whole(), 0, Step(), Step(), False, 0)
        self.row = row
        self.call = call

    def value(self, context: PlcContext) -> int:
        begin = context.notes.top
        kept = context.notes.kept
        context.notes.kept = 0
        context.notes.push(self.row, 0)
        address = self.call.value(context)
        if context.notes.kept > begin:
            context.notes.push(kinds.NOTE_RETURNED, begin)
        else:
            context.notes.top = begin
        context.notes.kept = kept
        return address
