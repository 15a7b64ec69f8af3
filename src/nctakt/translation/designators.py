# SPDX-License-Identifier: MIT
"""Variables, members, elements and targets of pointers -> locations (ST-311, ST-315 … ST-317)."""

from __future__ import annotations

from abc import abstractmethod

from nctakt.hli.table import LIST_NAME, ROOTS
from nctakt.kernel.st import kinds
from nctakt.kernel.st.wholes import (
    AddWhole,
    ElementPlace,
    LoadAt,
    MemberPlace,
    MultiplyWhole,
    OpenElementPlace,
    PointedPlace,
    SubtractWhole,
    Whole,
    WholeConstant,
)
from nctakt.st.tree import (
    Bit,
    Call,
    Dereference,
    Index,
    Member,
    Name,
    Super,
    This,
)
from nctakt.st.types import (
    ArrayType,
    Expression,
    Kind,
    PointerType,
    Property,
    ReferenceType,
    Section,
    Storage,
    StringType,
    Type,
    Variable,
)
from nctakt.st.vocabulary.elementary import BYTE, DINT, PVOID, UDINT, ULINT, WORD, string
from nctakt.translation.body import CannotRunError, value_type
from nctakt.translation.checks import CheckFunctions
from nctakt.translation.locations import Location, Origin

#: Unsigned types by their size: bytes and units of texts, and initial values as bits.
UNSIGNED = {one.size: one for one in (BYTE, WORD, UDINT, ULINT)}


class Designators(CheckFunctions):
    """Places that can be read or assigned."""

    def location(self, expression: Expression) -> Location:
        self.cost += 1
        if isinstance(expression.value, bytes):
            return self.literal_location(expression.value, value_type(expression))
        match expression:
            case Name(target=Variable() as variable):
                return self.followed(self.variable_location(variable, expression), variable)
            case Member(target=Variable() as variable, base=base):
                return self.followed(self.member_location(expression, variable, base), variable)
            case Member(bit=bit, base=base) if bit >= 0:
                return self.bit_location(base, bit)
            case Bit(base=base, number=number):
                return self.bit_location(base, number)
            case Index(base=base, indices=indices):
                return self.element_location(expression, base, indices)
            case Dereference(base=This() | Super()):
                return self.own_instance(expression)
            case Dereference(base=base):
                found = value_type(expression)
                pointer = self.checked_pointer(base, expression is self.written)
                return self.pointed(self.whole(pointer), found)
            case Call():
                return self.call_location(expression)
        if isinstance(expression, Name | Member) and isinstance(expression.target, Property):
            return self.property_location(expression)
        raise CannotRunError(expression, "an expression without a location")

    @abstractmethod
    def property_location(self, expression: Name | Member) -> Location:
        """Return where the value of a property is kept."""

    def literal_location(self, content: bytes, found: Type) -> Location:
        """Return where a literal text lies."""
        is_wide = isinstance(found, StringType) and found.is_wide
        text = string(len(content) // (2 if is_wide else 1), is_wide=is_wide)
        at = self.layout.literal(content.ljust(text.size, b"\0"))
        return Location(Origin.COMPUTED, 0, text, WholeConstant(at))

    def own_instance(self, expression: Expression) -> Location:
        """Return the location of THIS^; of a program its fixed one."""
        if self.pou is None or self.pou.type is None:
            raise CannotRunError(expression, "THIS outside of a block")
        if self.pou.kind is Kind.PROGRAM:
            return Location(Origin.DATA, self.layout.address(self.pou.instance), self.pou.type)
        return Location(Origin.INSTANCE, 0, self.pou.type)

    def variable_location(self, variable: Variable, expression: Expression) -> Location:
        """Return the slot of a variable that is named alone."""
        found = variable.type
        if variable.storage is Storage.GLOBAL:
            return self._global_location(variable)
        if variable.storage is Storage.FRAME:
            return Location(Origin.FRAME, variable.offset, found)
        return self.own_instance(expression).member(variable.offset, found, variable.bit)

    def _global_location(self, variable: Variable) -> Location:
        """Return the slot of a global variable; note the pointers to the CNC's interface."""
        if variable.name in ROOTS and variable.owner == LIST_NAME.rstrip("."):
            self.project.roots.add(variable.name)
        return Location(Origin.DATA, self.layout.address(variable.offset), variable.type)

    def member_location(self, expression: Member, variable: Variable, base: Expression) -> Location:
        """Return the slot of a member; of a list or program that only qualifies, the variable's."""
        if variable.storage is Storage.GLOBAL:
            return self._global_location(variable)
        owner = self.instance_location(base)
        return owner.member(variable.offset, variable.type, variable.bit)

    def instance_location(self, expression: Expression) -> Location:
        """Return the location of a structure or an instance; a program's name is its instance."""
        target = expression.target if isinstance(expression, Name | Member) else None
        instance = getattr(target, "instance", None)
        program_type = getattr(target, "type", None)
        if isinstance(instance, int) and program_type is not None:
            return Location(Origin.DATA, self.layout.address(instance), program_type)
        if isinstance(expression, This | Super):
            return self.own_instance(expression)
        return self.location(expression)

    def followed(self, slot: Location, variable: Variable) -> Location:
        """Return the target of a reference's or VAR_IN_OUT's slot; others unchanged."""
        if variable.section is Section.IN_OUT:
            slot = self._referred(slot, variable.type)
        if isinstance(slot.type, ReferenceType):
            slot = self._referred(slot, slot.type.target)
        return slot

    def _referred(self, slot: Location, found: Type) -> Location:
        address = Location(slot.origin, slot.offset, PVOID, slot.node)
        return self.pointed(address.load(self.layout.data_end), found)

    def pointed(self, pointer: Whole, found: Type) -> Location:
        """Return where an address points: as many bytes as ``found`` has, within the memory."""
        return Location(Origin.COMPUTED, 0, found, PointedPlace(pointer, found.size))

    def slot(self, expression: Expression) -> Location:
        """Return the slot of a reference or of an interface variable, as bound."""
        match expression:
            case Name(target=Variable() as variable):
                return self.variable_location(variable, expression)
            case Member(target=Variable() as variable, base=base):
                return self.member_location(expression, variable, base)
        return self.location(expression)

    def bit_location(self, base: Expression, number: int) -> Location:
        """Return the location of a bit of a whole number (ST-317)."""
        whole = self.location(base)
        return Location(whole.origin, whole.offset, whole.type, whole.node, number)

    def element_location(
        self, expression: Expression, base: Expression, indices: list[Expression]
    ) -> Location:
        """Return the location of an element of an array, a text or a pointer's target."""
        found = value_type(base)
        if isinstance(found, StringType):
            size, unit = (2, WORD) if found.is_wide else (1, BYTE)
            node = ElementPlace(
                self.location(base).address(), self.whole(indices[0]), 0, found.length + 1, size
            )
            return Location(Origin.COMPUTED, 0, unit, node)
        if isinstance(found, PointerType):
            target = value_type(expression)
            distance = MultiplyWhole(self.whole(indices[0]), WholeConstant(target.size))
            return self.pointed(AddWhole(self.whole(base), distance), target)
        if not isinstance(found, ArrayType):
            raise CannotRunError(expression, f"an index of {found.name}")
        if found.is_open:
            return self.open_element(base, found, indices)
        location = self.location(base)
        sizes = [high - low + 1 for low, high in found.bounds]
        stride = found.element.size
        for size in sizes:
            stride *= size
        for (low, _), size, index in zip(found.bounds, sizes, indices, strict=True):
            stride //= max(size, 1)
            location = self.element(location, index, low, size, stride)
        return location.member(0, found.element)

    def element(
        self, location: Location, index: Expression, lowest: int, count: int, stride: int
    ) -> Location:
        """Return the location of an element; a constant index within the bounds is an offset."""
        if isinstance(index.value, int) and 0 <= index.value - lowest < count:
            return location.member((index.value - lowest) * stride, location.type)
        checked = self.checked_value("checkbounds", index, lowest, lowest + count - 1)
        parts = (location.address(), self.whole(checked), lowest, count, stride)
        return Location(Origin.COMPUTED, 0, location.type, ElementPlace(*parts), element=parts)

    def open_slot(self, base: Expression) -> Location:
        """Return the slot of an ARRAY[*]: address, then the bounds of each dimension."""
        slot = self.slot(base)
        return Location(slot.origin, slot.offset, PVOID, slot.node)

    def open_bound(self, base: Expression, dimension: int, is_upper: bool) -> Whole:
        """Return a bound of an ARRAY[*]; dimensions count from 0."""
        offset = 8 + 8 * dimension + (4 if is_upper else 0)
        return self.open_slot(base).member(offset, DINT).load(self.layout.data_end)

    def open_element(
        self, base: Expression, found: ArrayType, indices: list[Expression]
    ) -> Location:
        """Return the location of an element of an ARRAY[*]."""
        slot = self.open_slot(base)
        node: Whole = PointedPlace(slot.load(self.layout.data_end), found.element.size)
        for number, index in enumerate(indices):
            stride: Whole = WholeConstant(found.element.size)
            for inner in range(number + 1, found.dimensions):
                last = self.open_bound(base, inner, True)
                count = SubtractWhole(last, self.open_bound(base, inner, False))
                stride = MultiplyWhole(stride, AddWhole(count, WholeConstant(1)))
            bounds = MemberPlace(slot.address(), 8 + 8 * number)
            node = OpenElementPlace(node, bounds, self.whole(index), stride)
        return Location(Origin.COMPUTED, 0, found.element, node)

    def pointer_of(self, expression: Expression) -> Whole:
        """Return the address of a variable: ADR, REF= and arguments passed by address."""
        target = expression.target if isinstance(expression, Name | Member) else None
        if isinstance(target, Variable) and isinstance(target.type, ReferenceType):
            slot = self.slot(expression)
            if target.section is Section.IN_OUT:
                slot = self._referred(slot, target.type)
            return LoadAt(slot.address(), 0, kinds.U64)
        return self.instance_location(expression).address()
