# SPDX-License-Identifier: MIT
"""The branches of a PLC program, numbered for counting: conditions, their parts, and bodies.

In: a checked program. Out: the project's functions, methods and bodies with their branches in the
order of the text. A condition has two numbers (true, false), a body one; they are found by the
identity of the expression or of the list of statements in the tree.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from nctakt.base.dataclass import dataclass, field
from nctakt.st import tree
from nctakt.st.program import Program
from nctakt.st.types import Callable, Expression, Node, Statement
from nctakt.translation.observing.units import own_units

BranchKind = Literal["IF", "ELSIF", "ELSE", "CASE", "FOR", "WHILE", "REPEAT"]
_JOINING = (tree.Operator.AND, tree.Operator.AND_THEN, tree.Operator.OR, tree.Operator.OR_ELSE)


@dataclass(slots=True, eq=False)
class NumberedBranch:
    """A branch; ``number`` is that of its condition, of a branch without one that of its body.

    ``outer``: the index of the branch around it; ``starts``: where the statements directly in its
    body begin; ``parts``: the operands of AND and OR with their numbers; ``is_label``: the value of
    a CASE leads to it.
    """

    kind: BranchKind
    start: int
    outer: int | None
    number: int
    condition: Expression | None
    starts: list[int]
    parts: list[tuple[Expression, int]] = field(default_factory=list)
    is_label: bool = False


@dataclass(slots=True, eq=False)
class NumberedUnit:
    """A function, method or body with its branches; ``number`` counts its calls.

    ``starts``: where the statements outside of its branches begin; ``end``: where the last ends.
    """

    called: Callable
    title: str
    number: int
    starts: list[int]
    end: int
    branches: list[NumberedBranch] = field(default_factory=list)


class BranchNumbers:
    """All branches of a project's code, by unit, and their numbers by identity."""

    def __init__(self, program: Program) -> None:
        self.by_identity: dict[int, int] = {}
        self.size = 0
        self.units = [self._unit(called, title) for called, title in own_units(program)]

    def _take(self, key: object, count: int) -> int:
        number = self.by_identity[id(key)] = self.size
        self.size += count
        return number

    def _unit(self, called: Callable, title: str) -> NumberedUnit:
        number = self._take(called.body, 1)
        end = max((one.end for one in called.body), default=called.start + 1)
        unit = NumberedUnit(called, title, number, _starts(called.body), end)
        self._walk(called.body, None, unit)
        return unit

    def _walk(self, body: Sequence[Statement], outer: int | None, unit: NumberedUnit) -> None:
        for one in body:
            match one:
                case tree.If():
                    for i, branch in enumerate(one.branches):
                        kind: BranchKind = "ELSIF" if i else "IF"
                        self._conditional(kind, branch.condition, branch.body, outer, unit)
                    self._plain("ELSE", one.otherwise, outer, unit)
                case tree.Case():
                    for label in one.branches:
                        self._plain("CASE", label.body, outer, unit, label, is_label=True)
                    self._plain("ELSE", one.otherwise, outer, unit, is_label=True)
                case tree.For():
                    self._plain("FOR", one.body, outer, unit, one)
                case tree.While():
                    self._conditional("WHILE", one.condition, one.body, outer, unit)
                case tree.Repeat():
                    self._conditional("REPEAT", one.condition, one.body, outer, unit)

    def _conditional(
        self,
        kind: BranchKind,
        condition: Expression,
        body: list[Statement],
        outer: int | None,
        unit: NumberedUnit,
    ) -> None:
        if condition.value is not None:  # it has no false, or no true
            return self._plain(kind, body, outer, unit, condition)
        number = self._take(condition, 2)
        branch = NumberedBranch(kind, condition.start, outer, number, condition, _starts(body))
        parts = _parts(condition)
        branch.parts = [(part, self._take(part, 2)) for part in parts if part is not condition]
        self._add(branch, body, unit)
        return None

    def _plain(
        self,
        kind: BranchKind,
        body: list[Statement],
        outer: int | None,
        unit: NumberedUnit,
        node: Node | None = None,
        *,
        is_label: bool = False,
    ) -> None:
        if not body:
            return
        start = body[0].start if node is None else node.start
        number = self._take(body, 1)
        branch = NumberedBranch(kind, start, outer, number, None, _starts(body), is_label=is_label)
        self._add(branch, body, unit)

    def _add(self, branch: NumberedBranch, body: list[Statement], unit: NumberedUnit) -> None:
        unit.branches.append(branch)
        self._walk(body, len(unit.branches) - 1, unit)


def _starts(body: Sequence[Statement]) -> list[int]:
    return [one.start for one in body]


def _parts(condition: Expression) -> list[Expression]:
    """Return the operands that AND and OR join, without constants."""
    if isinstance(condition, tree.Binary) and condition.operator in _JOINING:
        return [*_parts(condition.left), *_parts(condition.right)]
    return [] if condition.value is not None else [condition]
