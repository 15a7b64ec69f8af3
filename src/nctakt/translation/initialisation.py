# SPDX-License-Identifier: MIT
"""Code that runs before the first cycle, and at the start of each call (ST-403, ST-404)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.kernel.st.calls import Call as CallNode
from nctakt.kernel.st.steps import CopyBytes, Evaluate, Step, steps_in_order
from nctakt.kernel.st.wholes import WholeConstant
from nctakt.st import tree
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Expression,
    Method,
    Pou,
    ReferenceType,
    Section,
    Storage,
    StructType,
    Type,
    Variable,
)
from nctakt.st.vocabulary.elementary import PVOID
from nctakt.translation.calls import passed_location
from nctakt.translation.designators import UNSIGNED
from nctakt.translation.initial_values import is_constant, items_in_order
from nctakt.translation.layout import kind_of
from nctakt.translation.locations import Location
from nctakt.translation.statements import Statements

#: Arguments of FB_init of an instance: name or "", and expression.
Arguments = Sequence[tuple[str, Expression]]

_INIT, _LATE = "fb_init", "call_after_init"


def own_init(pou: Pou) -> Method | None:
    """Return the FB_init that a block declares itself."""
    return pou.methods.get(_INIT)


def late_methods(pou: Pou) -> list[Method]:
    """Return the methods of a block that are called after its initial values are set."""
    return [one for one in pou.methods.values() if _LATE in one.attributes]


def needs_start(sought: Type) -> bool:
    """Return whether code runs when a variable of a type begins."""
    if isinstance(sought, ArrayType):
        return needs_start(sought.element)
    if isinstance(sought, StructType):
        return any(_member_needs_start(one) for one in sought.members.values())
    if not isinstance(sought, BlockType):
        return False
    if any(own_init(pou) is not None or late_methods(pou) for pou in sought.pou.bases()):
        return True
    return any(
        _member_needs_start(one)
        for one in sought.pou.members.values()
        if one.storage is Storage.INSTANCE
    )


def _member_needs_start(variable: Variable) -> bool:
    if variable.section is Section.IN_OUT:
        return False
    if variable.initial is not None and not is_constant(variable.initial):
        return True
    return needs_start(variable.type)


class Initialisation(Statements):
    """The statements that begin variables."""

    def prologue(self) -> Step:
        """Return the initialization of a call's variables."""
        shared = {id(one) for one in self.called.parameters}
        steps: list[Step] = []
        variables = list(self.called.variables.values())
        if self.called.result is not None and self.called.result not in variables:
            variables.insert(0, self.called.result)
        for one in variables:
            if one.storage is Storage.FRAME and id(one) not in shared:
                if not (one is self.called.result and self.called.name.lower().endswith("set")):
                    steps += self.begin(self.variable_location(one, _anywhere(one)), one, one.start)
                self.frame.release()
        return steps_in_order(steps)

    def begin(self, location: Location, variable: Variable, source: int) -> list[Step]:
        steps: list[Step] = []
        image = self.project.image_of_variable(variable)
        if any(image):
            steps.append(self._image(location, image, source))
        steps += self.start(location, variable, source)
        return steps

    def _image(self, location: Location, image: bytes, source: int) -> Step:
        kind = kind_of(location.type)
        if kind is not None and location.bit < 0:
            literal = Location(
                location.origin, location.offset, UNSIGNED[len(image)], location.node
            )
            word = int.from_bytes(image, "little", signed=True)
            return literal.store(WholeConstant(word), source, 1, self.layout.data_end)
        origin = WholeConstant(self.layout.literal(image))
        return CopyBytes(location.address(), origin, len(image), source, 1)

    def start(self, location: Location, variable: Variable, source: int) -> list[Step]:
        """Return the code that initializes a variable, after its constant parts are set."""
        sought, initial = variable.type, variable.initial
        if isinstance(sought, ReferenceType) and initial is not None:
            slot = Location(location.origin, location.offset, PVOID, location.node)
            address = self.address_or_null(initial)
            return [slot.store(address, source, self.take_cost(), self.layout.data_end)]
        steps = list(self.start_of(location, sought, variable.arguments, source))
        if initial is not None and (not is_constant(initial) or needs_start(sought)):
            steps.append(self.assign(location, initial, initial.start))
            self.frame.release()
        return [*steps, *self._late_calls(location, sought, source)]

    def _late_calls(self, location: Location, sought: Type, source: int) -> Iterator[Step]:
        """Yield the calls of methods with ``call_after_init``, those of the base first."""
        if isinstance(sought, ArrayType) and needs_start(sought):
            for number in range(sought.size // max(sought.element.size, 1)):
                part = location.member(number * sought.element.size, sought.element)
                yield from self._late_calls(part, sought.element, source)
        elif isinstance(sought, BlockType):
            methods = [
                one for pou in reversed(list(sought.pou.bases())) for one in late_methods(pou)
            ]
            for name in dict.fromkeys(one.name.lower() for one in methods):
                method = sought.pou.find_method(name)
                assert method is not None
                shared = self.project.shared_bytes(method)
                routine = self.project.routine(method)
                yield Evaluate(
                    CallNode(routine, location.address(), shared, Step(), Step(), False, source),
                    source,
                    1,
                )

    def start_of(
        self, location: Location, sought: Type, arguments: Sequence[Arguments], source: int
    ) -> Iterator[Step]:
        """Yield the code of instances: their members', then FB_init, that of the base first.

        ``arguments``: a group for each instance, or one for all of them.
        """
        if not needs_start(sought):
            return
        if isinstance(sought, ArrayType):
            count = sought.size // max(sought.element.size, 1)
            share = len(arguments) // count if len(arguments) > 1 else 0
            for number in range(count):
                part = location.member(number * sought.element.size, sought.element)
                groups = arguments[number * share : (number + 1) * share] if share else arguments
                yield from self.start_of(part, sought.element, groups, source)
        elif isinstance(sought, StructType):
            for one in sought.members.values():
                yield from self.start(location.member(one.offset, one.type, one.bit), one, source)
        elif isinstance(sought, BlockType):
            starter = self.project.starter(sought.pou)
            yield Evaluate(
                CallNode(starter, location.address(), 0, Step(), Step(), True, source), source, 1
            )
            for pou in reversed(list(sought.pou.bases())):
                method = own_init(pou)
                if method is not None:
                    given = arguments[0] if arguments else ()
                    yield self._call_init(location, sought.pou, method, given, source)
                    self.frame.release()

    def _call_init(
        self,
        location: Location,
        pou: Pou,
        method: Method,
        arguments: Arguments,
        source: int,
    ) -> Step:
        outermost = next(one for one in map(own_init, pou.bases()) if one is not None)
        named = {}
        locations = iter(outermost.inputs[2:])
        for name, value in arguments:
            parameter = next(locations, None)
            if name or parameter is not None:
                named[(name or (parameter.name if parameter is not None else "")).lower()] = value
        steps: list[Step] = []
        for number, parameter in enumerate(method.inputs):
            given = named.get(parameter.name.lower())
            if number == 0:
                truth = tree.Literal(source, source, "TRUE", type=parameter.type, value=True)
                steps.append(self.hand_over(parameter, truth))
            elif given is not None:
                steps.append(self.hand_over(parameter, given))
            elif number > 1:
                steps += self.begin(passed_location(parameter), parameter, source)
        node = CallNode(
            self.project.routine(method),
            location.address(),
            self.project.shared_bytes(method),
            steps_in_order(steps),
            Step(),
            False,
            source,
        )
        return Evaluate(node, source, self.take_cost())

    def members(self, pou: Pou) -> Step:
        """Return the initialization of an instance's members, those of the base first."""
        steps: list[Step] = []
        for one in pou.members.values():
            if one.storage is Storage.INSTANCE and one.section is not Section.IN_OUT:
                steps += self.start(self.variable_location(one, _anywhere(one)), one, one.start)
                self.frame.release()
        return steps_in_order(steps)

    def fill_parts(
        self, target: Location, value: tree.ArrayInitial | tree.StructInitial, source: int
    ) -> Step:
        steps: list[Step] = []
        if isinstance(value, tree.StructInitial):
            for member, part in value.bound:
                location = target.member(member.offset, member.type, member.bit)
                steps.append(self.assign(location, part, source))
        elif isinstance(target.type, ArrayType):
            element = target.type.element
            for number, part in items_in_order(value):
                location = target.member(number * element.size, element)
                steps.append(self.assign(location, part, source))
        return steps_in_order(steps)


def _anywhere(variable: Variable) -> Expression:
    return Expression(variable.start, variable.start)
