# SPDX-License-Identifier: MIT
"""The values that a condition compares: at its last evaluation, and now.

In: a condition's node in the realtime part. Out: ``Compared``, and its text such as
``100.25 > 100 && 0 == 1``.
"""

from __future__ import annotations

import operator
from collections.abc import Callable

from nctakt.base.dataclass import dataclass
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles import conditions
from nctakt.kernel.cycles.context import Context
from nctakt.results.compared_numbers import TRUE_FROM, comparison_text

#: Node of a condition -> the operator that the text shows.
OPERATORS: dict[type[conditions.Condition], str] = {
    conditions.IsLess: "<",
    conditions.IsLessCellConstant: "<",
    conditions.IsLessEqual: "<=",
    conditions.IsLessEqualCellConstant: "<=",
    conditions.IsGreater: ">",
    conditions.IsGreaterCellConstant: ">",
    conditions.IsGreaterEqual: ">=",
    conditions.IsGreaterEqualCellConstant: ">=",
    conditions.IsEqual: "==",
    conditions.IsEqualCellConstant: "==",
    conditions.IsNotEqual: "!=",
    conditions.IsNotEqualCellConstant: "!=",
    conditions.IsTextTrue: "text",
    conditions.Both: "&&",
    conditions.Either: "||",
}

_COMPARISONS: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}


@dataclass(frozen=True, slots=True)
class Compared:
    """Compared values of a condition, and the result; ``parts``: the operands of ``&&``, ``||``.

    ``operator`` is empty for a single value, ``text`` for a comparison of texts, whose sides are
    not recorded.
    """

    operator: str
    truth: bool
    left: float
    right: float
    parts: tuple[Compared, ...] = ()

    def __str__(self) -> str:
        """Return the values with the operator between them: ``100.25 > 100``."""
        if self.parts:
            texts = [
                f"({part})" if part.operator == "||" and self.operator == "&&" else str(part)
                for part in self.parts
            ]
            return f" {self.operator} ".join(texts)
        shown = self.operator if self.operator in _COMPARISONS else ""
        return comparison_text(shown, self.left, self.right)


def compared_last(node: conditions.Condition) -> Compared | None:
    """Return the values compared at a condition's last evaluation, ``None`` before the first."""
    if node.truth == codes.UNKNOWN:
        return None
    parts = tuple(compared_last(part) for part in _parts(node))
    if None in parts:
        return None
    return Compared(
        OPERATORS.get(type(node), ""),
        node.truth == codes.TRUE,
        node.seen_left,
        node.seen_right,
        tuple(part for part in parts if part is not None),
    )


def compared_now(node: conditions.Condition, context: Context) -> Compared | None:
    """Return the values that a condition would compare now, ``None`` if one is not defined."""
    kind = OPERATORS.get(type(node), "")
    parts = tuple(compared_now(part, context) for part in _parts(node))
    known = tuple(part for part in parts if part is not None)
    if len(known) < len(parts):
        return None
    if parts:
        truths = [part.truth for part in known]
        truth = all(truths) if kind == "&&" else any(truths)
        return Compared(kind, truth, float(truth), TRUE_FROM, known)
    left, right = node.sides(context)
    if context.fault:
        return None
    compare = _COMPARISONS.get(kind)
    truth = bool(arithmetic.is_true(left)) if compare is None else compare(left, right)
    return Compared(kind, truth, left, right)


def _parts(node: conditions.Condition) -> tuple[conditions.Condition, ...]:
    return (node.first, node.second) if isinstance(node, conditions.Combination) else ()
