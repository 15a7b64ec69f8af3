# SPDX-License-Identifier: MIT
"""Explicit conversions -> nodes (ST-307, ST-308)."""

from __future__ import annotations

from nctakt.kernel.st import kinds
from nctakt.kernel.st.conversions import (
    RealOfString,
    StringOfReal,
    StringOfWhole,
    WholeOfString,
)
from nctakt.kernel.st.reals import Real, TruthOfReal, WholeOfReal
from nctakt.kernel.st.texts import StringPart
from nctakt.kernel.st.wholes import (
    CompareWhole,
    DivideWhole,
    MultiplyWhole,
    SelectWhole,
    SubtractWhole,
    Whole,
    WholeConstant,
    WrapWhole,
)
from nctakt.st.tree import Call
from nctakt.st.types import Elementary, EnumType, Expression, Family, StringType, Type
from nctakt.translation.body import CannotRunError, value_type
from nctakt.translation.layout import is_real, is_unsigned, kind_of
from nctakt.translation.values import Values

_FINE = 1000000
_DAY = 86400


def _is_length(found: Type) -> bool:
    return isinstance(found, Elementary) and found.family is Family.DURATION


def _date_name(found: Type) -> str:
    is_date = isinstance(found, Elementary) and found.family is Family.DATE
    return (
        {"DATE_AND_TIME": "DT", "TIME_OF_DAY": "TOD"}.get(found.name, found.name) if is_date else ""
    )


class Conversions(Values):
    """Values of one type as another one."""

    def conversion(self, call: Call) -> Whole | Real | StringPart:
        """Return the node of ``X_TO_Y``, ``TO_Y``, ``TRUNC`` or ``TRUNC_INT``."""
        operand, to = call.operands[0], value_type(call)
        found = value_type(operand)
        if isinstance(to, StringType):
            return self._to_text(operand, found)
        if isinstance(found, StringType):
            return self._from_text(operand, to)
        if is_real(to):
            return self.rounded(self.real(operand), to)
        if is_real(found):
            return self._from_real(call, operand, to)
        return self.cut(self._moment(self.whole(operand), found, to), to)

    @staticmethod
    def cut(node: Whole, to: Type) -> Whole:
        """Return a whole number cut to the width of a type."""
        kind = kind_of(to)
        return node if kind is None or to.size == 8 else WrapWhole(node, kind)

    @staticmethod
    def _moment(node: Whole, found: Type, to: Type) -> Whole:
        """Return lengths of time in the other's unit, days and times of day of dates."""
        if _is_length(found) and _is_length(to) and found.size != to.size:
            if to.size == 8:
                return MultiplyWhole(node, WholeConstant(_FINE))
            return DivideWhole(node, WholeConstant(_FINE), True, False)
        names = _date_name(found), _date_name(to)
        if names == ("DT", "DATE"):
            rest = DivideWhole(node, WholeConstant(_DAY), True, True)
            return SubtractWhole(node, rest)
        if names == ("DT", "TOD"):
            rest = DivideWhole(node, WholeConstant(_DAY), True, True)
            return MultiplyWhole(rest, WholeConstant(1000))
        return node

    def _from_real(self, call: Call, operand: Expression, to: Type) -> Whole:
        kind, node = kind_of(to), self.real(operand)
        if kind is None:
            raise CannotRunError(call, f"a real number as {to.name}")
        if kind == kinds.BOOL:
            return TruthOfReal(node)
        is_cut = call.function.startswith("TRUNC")
        return WholeOfReal(node, kind, kinds.TOWARDS_ZERO if is_cut else kinds.NEAREST)

    def _to_text(self, operand: Expression, found: Type) -> StringPart:
        if isinstance(found, StringType):
            return self.text(operand)
        if isinstance(found, EnumType) and found.has_text:
            return self._name_of_value(operand, found)
        kept = self.frame.take(kinds.TEXT_BYTES)
        if is_real(found):
            node: Whole = StringOfReal(self.real(operand), found.size == 4, kept)
        else:
            node = StringOfWhole(self.whole(operand), _form_of(found), 1, kept)
        return StringPart(node, kinds.MAX_TEXT)

    def _name_of_value(self, operand: Expression, found: EnumType) -> StringPart:
        """Return the name of an enumeration's value (``to_string``), else its number."""
        kept = self.frame.take(kinds.TEXT_BYTES)
        node: Whole = StringOfWhole(self.whole(operand), _form_of(found.base), 1, kept)
        for one in found.values.values():
            literal = WholeConstant(self.layout.literal(one.name.encode("latin-1") + bytes(256)))
            equal = CompareWhole(self.whole(operand), WholeConstant(one.number), kinds.EQUAL)
            node = SelectWhole(equal, node, literal)
        return StringPart(node, kinds.MAX_TEXT)

    def _from_text(self, operand: Expression, to: Type) -> Whole | Real:
        if is_real(to):
            return self.rounded(RealOfString(self.text(operand)), to)
        kind = kind_of(to)
        if kind is None or _date_name(to):
            raise CannotRunError(operand, f"a text as {to.name}")
        scale = _FINE if to.size == 8 else 1
        node = WholeOfString(self.text(operand), kind, _is_length(to), scale)
        return self.cut(node, to)


def _form_of(found: Type) -> int:
    """Return how a whole number of a type is written."""
    if _is_length(found):
        return kinds.FINE_LENGTH if found.size == 8 else kinds.LENGTH
    name = _date_name(found)
    if name:
        return {"TOD": kinds.CLOCK, "DATE": kinds.DAY}.get(name, kinds.MOMENT)
    if kind_of(found) == kinds.BOOL:
        return kinds.TRUTH
    return kinds.UNSIGNED if is_unsigned(found) else kinds.SIGNED
