# SPDX-License-Identifier: MIT
"""Calls of functions, blocks, methods and properties -> nodes (ST-520, ST-601 … ST-604)."""

from __future__ import annotations

from abc import abstractmethod

from nctakt.kernel.st.calls import Call as CallNode
from nctakt.kernel.st.calls import Callee, NoteCaller, ResultPlace
from nctakt.kernel.st.observing.noted import NotedCall
from nctakt.kernel.st.reals import RealOfWhole
from nctakt.kernel.st.steps import CopyBytes, Step, steps_in_order
from nctakt.kernel.st.text.texts import AssignString
from nctakt.kernel.st.wholes import PassingPlace, Whole, WholeConstant
from nctakt.st import tree
from nctakt.st.types import (
    AnyType,
    ArrayType,
    BlockType,
    Callable,
    Expression,
    InterfaceType,
    Kind,
    Method,
    PointerType,
    Pou,
    Property,
    ReferenceType,
    Section,
    StringType,
    StructType,
    Type,
    Variable,
    same_type,
)
from nctakt.st.vocabulary.elementary import DINT, PVOID, string
from nctakt.st.vocabulary.libraries import TEST_LIBRARY
from nctakt.translation.body import CannotRunError, block_of, is_standard, value_type
from nctakt.translation.built_ins import BuiltIns
from nctakt.translation.layout import is_real, is_unsigned, kind_of
from nctakt.translation.locations import Location, Origin
from nctakt.translation.reflection import class_number, information
from nctakt.translation.values import text_part

#: Libraries whose functions need the place of their call.
_ASKING = (TEST_LIBRARY, "Tc2_System")


class Calls(BuiltIns):
    """Calls, with their arguments and results."""

    def call(self, call: tree.Call) -> CallNode:
        """Return the node of a call of a function, a block, a program or a method."""
        called = call.target
        if called is None:
            raise CannotRunError(call, "a call of nothing")
        if called.is_native:
            raise CannotRunError(call, called.path)
        if isinstance(called, Pou) and called.is_refused:
            raise CannotRunError(call, called.path)
        # An action has no parameters: those of its block are written to the instance.
        is_action = isinstance(called, Method) and called.is_action
        fills_instance = is_action or call.kind is tree.CallKind.BLOCK
        callee: Callee = self.project.routine(called)
        instance: Whole = Whole()
        if call.instance is not None:
            instance, callee = self.callee(call.instance, called, call.is_virtual)
        elif isinstance(called, Pou) and called.kind is Kind.PROGRAM:
            instance = WholeConstant(self.layout.address(called.instance))
        shared = 0 if fills_instance else self.project.shared_bytes(called)
        arguments, outputs = self._arguments(call, called, fills_instance)
        library = _library_of(called)
        if library in _ASKING and library != _library_of(self.called):
            arguments = steps_in_order([arguments, NoteCaller(call.start)])
        node = CallNode(callee, instance, shared, arguments, outputs, fills_instance, call.start)
        return self._noted(node, call)

    def _noted(self, node: CallNode, call: Expression) -> CallNode:
        return node if self.notes is None else NotedCall(node, self.notes.add_call(call))

    def callee(
        self, instance: Expression, called: Callable, is_virtual: bool
    ) -> tuple[Whole, Callee]:
        """Return the instance of a call, and the lookup of its type's routine."""
        bare = instance.base if isinstance(instance, tree.Dereference) else instance
        if isinstance(bare, tree.This | tree.Super):
            node = self.own_instance(instance).address()
            if not is_virtual or self.pou is None or self.pou.kind is Kind.PROGRAM:
                return node, self.project.routine(called)
            return node, self.project.virtual(called, self.pou)
        found = instance.type
        if isinstance(found, ReferenceType | PointerType):
            found = found.target
        declared = block_of(found) if found is not None else None
        if declared is None:
            raise CannotRunError(instance, f"a call of {called.path}")
        if isinstance(declared, InterfaceType):
            pointer = self.pointed(self.whole(instance), BlockType(declared.name, 8, 8, _NO_POU))
            return pointer.address(), self.project.virtual(called, declared)
        node = self.instance_location(instance).address()
        if is_virtual and not _is_exact(bare):
            return node, self.project.virtual(called, declared)
        return node, self.project.exact(called, declared)

    def _arguments(
        self, call: tree.Call, called: Callable, fills_instance: bool
    ) -> tuple[Step, Step]:
        steps: list[Step] = []
        outputs: list[Step] = []
        given = set()
        for parameter, argument in call.bound:
            given.add(id(parameter))
            if parameter.section is Section.OUTPUT:
                outputs.append(self._take(parameter, argument))
            else:
                steps.append(self.hand_over(parameter, argument))
        if not fills_instance:
            for one in called.parameters:
                if one.section is Section.INPUT and id(one) not in given:
                    steps += self.begin(passed_location(one), one, call.start)
        return steps_in_order(steps), steps_in_order(outputs)

    @abstractmethod
    def begin(self, location: Location, variable: Variable, source: int) -> list[Step]:
        """Return the statements that give a cleared variable its initial value."""

    def hand_over(self, parameter: Variable, argument: Expression) -> Step:
        """Return the statement that hands over an argument."""
        location, source = passed_location(parameter), argument.start
        if isinstance(parameter.type, AnyType):
            return self._hand_over_any(location, parameter.type, argument)
        if parameter.section is Section.IN_OUT:
            return self._hand_over_address(parameter, argument)
        if isinstance(parameter.type, ReferenceType):
            address = self.address_or_null(argument)
            return location.store(address, source, self.take_cost(), self.layout.data_end)
        return self.assign(location, argument, source)

    def _hand_over_any(self, location: Location, form: AnyType, argument: Expression) -> Step:
        """Return the statements that hand over class, address and size of a value (ST-620)."""
        found, source, end = value_type(argument), argument.start, self.layout.data_end
        if isinstance(found, AnyType):
            origin = self.location(argument).address()
            return CopyBytes(location.address(), origin, form.size, source, self.take_cost())
        if isinstance(found, ArrayType) and found.is_open:
            raise CannotRunError(argument, "an ARRAY[*] as ANY")
        before, address = self.addressed(argument, found)
        members = form.form.members
        values = {
            "pvalue": address,
            "typeclass": WholeConstant(class_number(found, form.form)),
            "disize": WholeConstant(found.size),
        }
        steps = [
            location.member(members[name].offset, members[name].type).store(
                value, source, self.take_cost(), end
            )
            for name, value in values.items()
        ]
        return steps_in_order([before, *steps])

    def addressed(self, value: Expression, found: Type) -> tuple[Step, Whole]:
        """Return the address of a value, and the node that keeps it in the frame if it has none."""
        if has_address(value) and same_type(value_type(value), found):
            return Step(), self.pointer_of(value)
        kept = Location(Origin.FRAME, self.frame.take(found.size), found)
        return self.assign(kept, value, value.start), kept.address()

    def _hand_over_address(self, parameter: Variable, argument: Expression) -> Step:
        source, found = argument.start, parameter.type
        slot = Location(Origin.COMPUTED, 0, PVOID, PassingPlace(parameter.offset))
        end = self.layout.data_end
        given = value_type(argument)
        if parameter.is_constant and (kind_of(found) is not None or isinstance(found, StringType)):
            before, address = self.addressed(argument, found)
            return steps_in_order([before, slot.store(address, source, self.take_cost(), end)])
        if isinstance(found, ArrayType) and found.is_open and isinstance(given, ArrayType):
            if given.is_open:
                address = self.open_slot(argument).load(end)
            else:
                address = self.pointer_of(argument)
            steps = [slot.store(address, source, self.take_cost(), end)]
            for number in range(found.dimensions):
                for is_upper in (False, True):
                    offset = parameter.offset + 8 + 8 * number + (4 if is_upper else 0)
                    bound = Location(Origin.COMPUTED, 0, DINT, PassingPlace(offset))
                    if given.is_open:
                        value = self.open_bound(argument, number, is_upper)
                    else:
                        value = WholeConstant(given.bounds[number][is_upper])
                    steps.append(bound.store(value, source, 1, end))
            return steps_in_order(steps)
        return slot.store(self.pointer_of(argument), source, self.take_cost(), end)

    @abstractmethod
    def address_or_null(self, value: Expression) -> Whole:
        """Return the address of an instance or variable; 0 and null stay."""

    def _take(self, parameter: Variable, target: Expression) -> Step:
        """Return the statement that takes an output."""
        if isinstance(target, tree.Name | tree.Member) and isinstance(target.target, Property):
            raise CannotRunError(target, "a property as the target of an output")
        origin = passed_location(parameter)
        return self.transfer(self.location(target), origin, target.start)

    def transfer(self, target: Location, origin: Location, source: int) -> Step:
        """Return the statement that copies a value between locations, converted where it widens."""
        end = self.layout.data_end
        if isinstance(target.type, StringType) and isinstance(origin.type, StringType):
            text = text_part(origin.address(), origin.type)
            address, length = target.address(), target.type.length
            return AssignString(address, length, text, source, self.take_cost())
        if is_real(target.type):
            if is_real(origin.type):
                number = origin.load_real(end)
            else:
                number = RealOfWhole(origin.load(end), is_unsigned(origin.type))
            return target.store_real(number, source, self.take_cost(), end)
        if kind_of(target.type) is not None:
            return self.store(target, origin.load(end), source, self.take_cost())
        size = target.type.size
        return CopyBytes(target.address(), origin.address(), size, source, self.take_cost())

    @abstractmethod
    def store(self, location: Location, value: Whole, source: int, cost: int) -> Step:
        """Return the assignment of a whole number, or of a bit."""

    def call_location(self, call: tree.Call) -> Location:
        found = value_type(call)
        if call.function == "__VARINFO" and isinstance(found, StructType):
            at = self.layout.literal(information(call.operands[0], found))
            return Location(Origin.COMPUTED, 0, found, WholeConstant(at))
        if is_standard(call):
            text = self.text(call)
            found = string(text.capacity, is_wide=text.unit > 1)
            return Location(Origin.COMPUTED, 0, found, text.address)
        if call.target is None or call.target.result is None:
            raise CannotRunError(call, "the value of a call without a result")
        return self.result_location(self.call(call), call.target.result)

    def result_location(self, node: CallNode, result: Variable) -> Location:
        """Return where the result of a call lies; texts and structures are kept in the frame."""
        found = result.type
        if isinstance(found, ReferenceType):
            return self.pointed(self.reference_of(node, result), found.target)
        if kind_of(found) is not None:
            return Location(Origin.COMPUTED, result.offset, found, node)
        kept = self.frame.take(found.size)
        location = ResultPlace(node, result.offset, found.size, kept)
        return Location(Origin.COMPUTED, 0, found, location)

    def reference_of(self, node: CallNode, result: Variable) -> Whole:
        """Return the address in a reference that a call returns; 0 if it is not bound."""
        pointer = Location(Origin.COMPUTED, result.offset, PVOID, node)
        return pointer.load(self.layout.data_end)

    def property_location(self, expression: tree.Name | tree.Member) -> Location:
        found = expression.target
        if not isinstance(found, Property) or found.get is None or found.get.result is None:
            raise CannotRunError(expression, "a property without Get")
        node = self.accessor(found.get, expression, Step())
        return self.result_location(node, found.get.result)

    def accessor(
        self, method: Method, expression: tree.Name | tree.Member, arguments: Step
    ) -> CallNode:
        """Return the call of a property's Get or Set."""
        base: Expression
        if isinstance(expression, tree.Member):
            base = expression.base
        else:
            base = tree.This(expression.start, expression.end)
        is_super = isinstance(base, tree.Dereference) and isinstance(base.base, tree.Super)
        instance, callee = self.callee(base, method, not is_super)
        shared = self.project.shared_bytes(method)
        node = CallNode(callee, instance, shared, arguments, Step(), False, expression.start)
        return self._noted(node, expression)

    def set_property(self, target: tree.Name | tree.Member, value: Expression, source: int) -> Step:
        """Return the call of Set with a value; of a reference that Get returns, its assignment."""
        found = target.target
        if not isinstance(found, Property):
            raise CannotRunError(target, "an assignment to this")
        if found.set is None or found.set.result is None:
            return self.assign(self.property_location(target), value, source)
        argument = self.hand_over(found.set.result, value)
        node = self.accessor(found.set, target, argument)
        return self.evaluated(node, source)

    @abstractmethod
    def evaluated(self, node: Whole, source: int) -> Step:
        """Return a statement that evaluates a node."""


_NO_POU = Pou("", "")


def _library_of(called: Callable) -> str:
    """Return the library that declares a function, a block or its method, "" for the project."""
    owner = called.owner if isinstance(called, Method) else called
    return owner.library if isinstance(owner, Pou) else ""


def has_address(value: Expression) -> bool:
    """Return whether a value is a variable, or a part of one that has an address."""
    match value:
        case tree.Name(target=Variable() as variable) | tree.Member(target=Variable() as variable):
            return variable.bit < 0
        case tree.Index() | tree.Dereference():
            return True
    return False


def passed_location(parameter: Variable) -> Location:
    """Return where a parameter's value goes."""
    return Location(Origin.COMPUTED, 0, parameter.type, PassingPlace(parameter.offset))


def _is_exact(expression: Expression) -> bool:
    """Return whether an instance is certainly of its declared type."""
    match expression:
        case tree.Name(target=Variable() as variable) | tree.Member(target=Variable() as variable):
            return variable.section is not Section.IN_OUT and _is_block(variable.type)
        case tree.Index(base=base):
            found: Type | None = base.type
            return isinstance(found, ArrayType) and _is_exact_array(base)
        case tree.Name() | tree.Member():
            return True
    return False


def _is_exact_array(base: Expression) -> bool:
    target = base.target if isinstance(base, tree.Name | tree.Member) else None
    return (
        isinstance(target, Variable)
        and target.section is not Section.IN_OUT
        and isinstance(target.type, ArrayType)
    )


def _is_block(found: Type) -> bool:
    return isinstance(found, BlockType)
