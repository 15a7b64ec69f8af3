# SPDX-License-Identifier: MIT
"""Explicit conversions -> nodes (ST-307, ST-308)."""

from __future__ import annotations

from nctakt.kernel.st import kinds
from nctakt.kernel.st.kept import KeptWhole
from nctakt.kernel.st.reals import Real, TruthOfReal, WholeOfReal
from nctakt.kernel.st.text.conversions import (
    MomentOfString,
    RealOfString,
    StringOfReal,
    StringOfWhole,
    WholeOfString,
)
from nctakt.kernel.st.text.texts import ResizedText, StringPart
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
from nctakt.st.vocabulary.elementary import LINT
from nctakt.translation.body import CannotRunError, value_type
from nctakt.translation.layout import is_real, is_unsigned, kind_of
from nctakt.translation.locations import Location, Origin
from nctakt.translation.values import Values

_FINE = 1000000
_DAY = 86400
_MOMENTS = {"TOD": kinds.TIME_OF_DAY, "DATE": kinds.DATE, "DT": kinds.DATE_AND_TIME}


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
            return self.resized(self._to_text(operand, found), to.is_wide)
        if isinstance(found, StringType):
            return self._from_text(self.resized(self.text(operand), False), operand, to)
        if is_real(to):
            return self.rounded(self.real(operand), to)
        if is_real(found):
            return self._from_real(call, operand, to)
        return self.cut(self._moment(self.whole(operand), found, to), to)

    def resized(self, text: StringPart, is_wide: bool) -> StringPart:
        """Return a text with characters of one or of two bytes."""
        unit = 2 if is_wide else 1
        if text.unit == unit:
            return text
        kept = self.frame.take(unit * kinds.TEXT_BYTES)
        return StringPart(ResizedText(text, kept), kinds.MAX_TEXT, unit)

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
        first, again = self.kept_number(self.whole(operand))
        node: Whole = StringOfWhole(
            again, _form_of(found.base), 1, self.frame.take(kinds.TEXT_BYTES)
        )
        for number, one in enumerate(reversed(found.values.values()), 1):
            literal = WholeConstant(self.layout.literal(one.name.encode("latin-1") + bytes(256)))
            asked = first if number == len(found.values) else again
            node = SelectWhole(
                CompareWhole(asked, WholeConstant(one.number), kinds.EQUAL), node, literal
            )
        return StringPart(node, kinds.MAX_TEXT)

    def kept_number(self, node: Whole) -> tuple[Whole, Whole]:
        """Return a number that the frame keeps, and the node that reads it afterwards."""
        kept = self.frame.take(8)
        return KeptWhole(node, kept), Location(Origin.FRAME, kept, LINT).load(self.layout.data_end)

    def _from_text(self, text: StringPart, operand: Expression, to: Type) -> Whole | Real:
        if is_real(to):
            return self.rounded(RealOfString(text), to)
        kind, name = kind_of(to), _date_name(to)
        if kind is None:
            raise CannotRunError(operand, f"a text as {to.name}")
        if name:
            return self.cut(MomentOfString(text, _MOMENTS[name]), to)
        scale = _FINE if to.size == 8 else 1
        return self.cut(WholeOfString(text, kind, _is_length(to), scale), to)


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
