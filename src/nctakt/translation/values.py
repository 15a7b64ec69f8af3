# SPDX-License-Identifier: MIT
"""Expressions -> nodes of whole numbers, real numbers and texts (ST-302 … ST-305, ST-501 …)."""

from __future__ import annotations

from nctakt.kernel.st import chains, kinds
from nctakt.kernel.st.kept import RealAfter, WholeAfter
from nctakt.kernel.st.observing.counting import ComparedTruth, CountedTruth, SeenReal, SeenWhole
from nctakt.kernel.st.observing.noted import NotedReal, NotedWhole
from nctakt.kernel.st.reals import (
    CompareReal,
    DivideReal,
    FunctionOfTwo,
    NegateReal,
    Real,
    RealConstant,
    RealOfWhole,
)
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.text.texts import CompareStrings, StringPart
from nctakt.kernel.st.wholes import (
    AddWhole,
    AndBits,
    AndThen,
    CompareUnsigned,
    CompareWhole,
    DivideWhole,
    MultiplyWhole,
    NegateWhole,
    NotBits,
    NotTruth,
    OrBits,
    OrElse,
    SubtractWhole,
    Whole,
    WholeConstant,
    XorBits,
)
from nctakt.st.tree import (
    AssignmentExpression,
    Binary,
    Call,
    Dereference,
    Member,
    Name,
    Operator,
    Super,
    This,
    Unary,
)
from nctakt.st.types import (
    BlockType,
    EnumValue,
    Expression,
    InterfaceType,
    Property,
    ReferenceType,
    StringType,
    Type,
)
from nctakt.translation.body import CannotRunError, is_standard, value_type
from nctakt.translation.designators import Designators
from nctakt.translation.layout import as_word, is_real, is_unsigned, kind_of
from nctakt.translation.locations import Location
from nctakt.translation.observing.compared import is_compared

_REAL = {
    Operator.ADD: kinds.LINK_ADD,
    Operator.SUBTRACT: kinds.LINK_SUBTRACT,
    Operator.MULTIPLY: kinds.LINK_MULTIPLY,
}
_WHOLE = {
    Operator.ADD: AddWhole,
    Operator.SUBTRACT: SubtractWhole,
    Operator.MULTIPLY: MultiplyWhole,
    Operator.AND: AndBits,
    Operator.OR: OrBits,
    Operator.XOR: XorBits,
    Operator.AND_THEN: AndThen,
    Operator.OR_ELSE: OrElse,
}
_RELATIONS = {
    Operator.EQUAL: kinds.EQUAL,
    Operator.UNEQUAL: kinds.NOT_EQUAL,
    Operator.LESS: kinds.LESS,
    Operator.LESS_EQUAL: kinds.LESS_EQUAL,
    Operator.GREATER: kinds.GREATER,
    Operator.GREATER_EQUAL: kinds.GREATER_EQUAL,
}


class Values(Designators):
    """Nodes of expressions."""

    def whole(self, expression: Expression) -> Whole:
        node = self._whole(expression)
        number = self.project.counted.get(id(expression))
        if number is not None:
            counted = ComparedTruth if is_compared(expression) else CountedTruth
            node = counted(node, number)
        row = None if self.notes is None else self.notes.by_identity.get(id(expression))
        return node if row is None else NotedWhole(node, row)

    def _whole(self, expression: Expression) -> Whole:
        self.cost += 1
        if expression.value is not None and not isinstance(expression.value, bytes):
            return WholeConstant(as_word(int(expression.value)))
        match expression:
            case Name(target=EnumValue() as found) | Member(target=EnumValue() as found):
                return WholeConstant(found.number)
            case This() | Super():
                return self.own_instance(expression).address()
            case Dereference(base=This() | Super()):
                return self.own_instance(expression).address()
            case Unary():
                return self._unary(expression)
            case Binary():
                return self._binary(expression)
            case AssignmentExpression():
                before, target = self.assigned(expression)
                return WholeAfter(before, target.load(self.layout.data_end))
        if isinstance(expression, Call) and is_standard(expression):
            node = self.built_in(expression)
            if isinstance(node, Whole):
                return node
            raise CannotRunError(expression, f"{expression.function} as a whole number")
        found_type = expression.type
        if isinstance(found_type, BlockType):
            return self.instance_location(expression).address()
        return self.load(expression)

    def load(self, expression: Expression) -> Whole:
        """Return the node that reads a variable or a result."""
        return self.location(expression).load(self.layout.data_end)

    def real(self, expression: Expression) -> Real:
        node = self._real(expression)
        row = None if self.notes is None else self.notes.by_identity.get(id(expression))
        if row is None or not is_real(value_type(expression)):
            return node
        return NotedReal(node, row)

    def _real(self, expression: Expression) -> Real:
        self.cost += 1
        if expression.value is not None and not isinstance(expression.value, bytes):
            return RealConstant(float(expression.value))
        found = value_type(expression)
        if not is_real(found):
            return RealOfWhole(self.whole(expression), is_unsigned(found))
        match expression:
            case Unary(operator=operator, operand=operand):
                node = self.real(operand)
                return NegateReal(node) if operator is Operator.NEGATE else node
            case Binary(operator=Operator.POWER, left=left, right=right):
                return FunctionOfTwo(kinds.EXPT, self.real(left), self.real(right))
            case Binary(operator=Operator.DIVIDE, left=left, right=right):
                right = self.checked_divisor(right, found)
                return self.rounded(DivideReal(self.real(left), self.real(right)), found)
            case Binary(operator=operator, left=left, right=right) if operator in _REAL:
                node = chains.joined(_REAL[operator], self.real(left), self.real(right))
                return self.rounded(node, found)
            case AssignmentExpression():
                before, target = self.assigned(expression)
                return RealAfter(before, target.load_real(self.layout.data_end))
        if isinstance(expression, Call) and is_standard(expression):
            result = self.built_in(expression)
            if isinstance(result, Real):
                return result
            raise CannotRunError(expression, f"{expression.function} as a real number")
        return self.location(expression).load_real(self.layout.data_end)

    def assigned(self, expression: AssignmentExpression) -> tuple[Step, Location]:
        """Return an assignment within an expression, and the value read after it."""
        target = self.location(expression.target)
        return self.assign(target, expression.assigned, expression.start), target

    @staticmethod
    def rounded(node: Real, found: Type) -> Real:
        """Return a result rounded to REAL, if that is its type (ST-304)."""
        return chains.rounded(node) if found.size == 4 else node

    def text(self, expression: Expression) -> StringPart:
        is_computed = not isinstance(expression.value, bytes)
        if is_computed and isinstance(expression, Call) and is_standard(expression):
            result = self.built_in(expression)
            if isinstance(result, StringPart):
                return result
            raise CannotRunError(expression, f"{expression.function} as a text")
        if isinstance(expression, AssignmentExpression):
            before, target = self.assigned(expression)
            part = self.text_at(target, expression)
            return StringPart(WholeAfter(before, part.address), part.capacity, part.unit)
        return self.text_at(self.location(expression), expression)

    def text_at(self, location: Location, expression: Expression) -> StringPart:
        """Return the text of a variable."""
        if not isinstance(location.type, StringType):
            raise CannotRunError(expression, f"{location.type.name} as a text")
        return text_part(location.address(), location.type)

    def _unary(self, expression: Unary) -> Whole:
        operand = self.whole(expression.operand)
        if expression.operator is Operator.NEGATE:
            return NegateWhole(operand)
        if expression.operator is Operator.PLUS:
            return operand
        kind = kind_of(value_type(expression.operand))
        if kind is None:
            raise CannotRunError(expression, "NOT of such a value")
        return NotTruth(operand) if kind == kinds.BOOL else NotBits(operand, kind)

    def _binary(self, expression: Binary) -> Whole:
        operator = expression.operator
        if operator in _RELATIONS:
            return self._comparison(expression, _RELATIONS[operator])
        left = self.whole(expression.left)
        if operator in (Operator.DIVIDE, Operator.MOD):
            found = expression.operand_type or value_type(expression)
            right = self.whole(self.checked_divisor(expression.right, found))
            return DivideWhole(left, right, is_unsigned(found), operator is Operator.MOD)
        right = self.whole(expression.right)
        return _WHOLE[operator](left, right)

    def _comparison(self, expression: Binary, relation: int) -> Whole:
        left, right = expression.left, expression.right
        left_type, right_type = _shown(left), _shown(right)
        if isinstance(left_type, StringType) or isinstance(right_type, StringType):
            return CompareStrings(self.text(left), self.text(right), relation)
        is_seen = id(expression) in self.project.counted and is_compared(expression)
        if is_real(left_type) or is_real(right_type):
            reals = self.real(left), self.real(right)
            if is_seen:
                reals = SeenReal(reals[0], True), SeenReal(reals[1], False)
            return CompareReal(*reals, relation)
        node, other = self.bound(left), self.bound(right)
        if is_seen:
            node = SeenWhole(node, True, is_unsigned(left_type))
            other = SeenWhole(other, False, is_unsigned(right_type))
        if _fits_signed(left) and _fits_signed(right):
            return CompareWhole(node, other, relation)
        unsigned = is_unsigned(left_type) or _is_natural(left)
        other_unsigned = is_unsigned(right_type) or _is_natural(right)
        return CompareUnsigned(node, other, relation, unsigned, other_unsigned)

    def bound(self, expression: Expression) -> Whole:
        """Return a value, of an interface or a block its address."""
        return self.whole(expression)


def text_part(address: Whole, found: StringType) -> StringPart:
    """Return the text at an address."""
    return StringPart(address, found.length, 2 if found.is_wide else 1)


def _shown(expression: Expression) -> Type | None:
    found = expression.type
    return found.target if isinstance(found, ReferenceType) else found


def _is_natural(expression: Expression) -> bool:
    """Return whether an expression is a constant that is not negative."""
    value = expression.value
    return isinstance(value, int) and value >= 0


def _fits_signed(expression: Expression) -> bool:
    """Return whether a value is certainly the same as a signed number of 64 bits."""
    value = expression.value
    if isinstance(value, int):
        return value < 1 << 63
    found = _shown(expression)
    if isinstance(found, InterfaceType | BlockType):
        return True
    if not is_unsigned(found):
        return True
    is_variable = isinstance(expression, Name | Member) and not isinstance(
        expression.target, Property
    )
    return is_variable and found is not None and found.size < 8
