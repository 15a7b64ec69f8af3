# SPDX-License-Identifier: MIT
"""Calls: the called object, and its arguments (ST-307, ST-520, ST-604, ST-712 … 715).

In: a call of the tree. Out: its kind, target, instance and bound arguments; each argument is
converted into its parameter, or reported.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import NOTHING
from nctakt.base.misspelling import KnownNames
from nctakt.messages.plcs.st_check import (
    ARGUMENT_TWICE,
    ARGUMENTS_COUNT,
    CALL_OF_ABSTRACT,
    CALL_OF_NO_UNIT,
    CONSTRUCT_REFUSED,
    IN_OUT_NOT_ASSIGNED,
    INSTANCE_NEEDED,
    NO_ADDRESS,
    NOT_ASSIGNABLE,
    OUTPUT_UNKNOWN,
    PARAMETER_UNKNOWN,
    TYPE_MISMATCH,
    VALUE_NEEDED,
)
from nctakt.st.check.conversions import Verdict, conversion
from nctakt.st.check.expressions import ExpressionChecker, _is_whole, _shown, common_number
from nctakt.st.check.names import Declared
from nctakt.st.check.resolver import is_unknown
from nctakt.st.tree import (
    Argument,
    Bit,
    Call,
    CallKind,
    Dereference,
    GlobalList,
    Index,
    Library,
    Member,
    Name,
    Super,
    Target,
    This,
)
from nctakt.st.types import (
    AnyType,
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    EnumValue,
    Expression,
    Family,
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
)
from nctakt.st.types import (
    Callable as CallableUnit,
)
from nctakt.st.vocabulary.elementary import (
    BIT,
    BOOL,
    DINT,
    ELEMENTARY,
    INT,
    INTEGERS,
    LREAL,
    LTIME,
    NUMBERS,
    REAL,
    TIME,
    UDINT,
    ULINT,
    UNTYPED,
    UNTYPED_REAL,
    string,
)
from nctakt.st.vocabulary.functions import BUILT_INS, REFUSED, BuiltIn
from nctakt.st.vocabulary.functions import conversion as conversion_of

#: Inputs of FB_init that the system gives.
_SYSTEM_INPUTS = ("binitretains", "bincopycode")


class CallChecker(ExpressionChecker):
    """Checks calls."""

    #: Methods that each body calls statically: for recursion.
    def __init__(self, *parts: object) -> None:
        super().__init__(*parts)  # type: ignore[arg-type]
        self._rules: dict[str, Callable[[Call, BuiltIn], Type | None]] = {
            "number": self._number,
            "real": self._real,
            "power": self._power,
            "truncation": self._truncation,
            "common": self._common_type,
            "selection": self._selection,
            "shift": self._shift,
            "address": self._address_of,
            "size": self._size,
            "bound": self._bound,
            "clock": self._clock,
            "valid": self._valid,
            "query": self._query,
            "text": self._text,
            "information": self._information,
        }
        self.callers: dict[CallableUnit, dict[CallableUnit, Call]] = {}
        self.unit: CallableUnit | None = None

    def _call(self, node: Call) -> Type | None:
        node.target, node.instance, node.is_virtual = None, None, True
        target, instance = self._callee(node)
        if isinstance(target, str):
            return self._built_in(node, target)
        if target is None:
            for argument in node.arguments:
                if argument.value is not None:
                    self.initial(argument.value, None)
            return None
        node.target, node.instance = target, instance
        if isinstance(target, Pou):
            node.kind = CallKind.FUNCTION if target.kind is Kind.FUNCTION else CallKind.BLOCK
        else:
            node.kind = CallKind.METHOD
        self._note(node, target)
        self._bind(node, target)
        if target.result is None:
            return None
        kind = target.result.type
        kind = kind.target if isinstance(kind, ReferenceType) else kind
        return None if is_unknown(kind) else kind

    def _note(self, node: Call, target: CallableUnit) -> None:
        """Note who calls whom, where the target is fixed (ST-407)."""
        if self.unit is not None:
            self.callers.setdefault(self.unit, {}).setdefault(target, node)

    # --- called objects ---------------------------------------------------------------------------

    def _callee(self, node: Call) -> tuple[CallableUnit | str | None, Expression | None]:
        """Return the called object, or the upper-case name of a built-in; and the instance."""
        callee = node.callee
        if isinstance(callee, Name):
            return self._by_name(node, callee)
        if isinstance(callee, Member):
            return self._by_member(node, callee)
        if isinstance(callee, Dereference) and isinstance(callee.base, Super | This):
            kind = self.operand(callee)
            if isinstance(kind, BlockType):
                node.is_virtual = isinstance(callee.base, This)
                return kind.pou, callee
            return None, None
        return self._by_value(node, self.operand(callee)), callee

    def _by_name(
        self, node: Call, callee: Name
    ) -> tuple[CallableUnit | str | None, Expression | None]:
        key, upper = callee.name.lower(), callee.name.upper()
        scope = self.scope
        target: Target | None = None
        if not callee.is_global:
            # Within a function its name is its result, and the function itself if it is called.
            target = scope.local_names.get(key)
            if isinstance(target, Variable) and target.section is Section.RESULT:
                target = None
            target = target or scope.members.get(key)
        if target is None:
            found = self.names.find(key, scope.library)
            if isinstance(found, Declared):
                target = self.resolver.target_of(found)
            elif found is None or isinstance(found, Library | EnumValue):
                if upper in BUILT_INS or upper in REFUSED or conversion_of(upper) is not None:
                    return upper, None
                if "_TO_" in upper or upper.startswith("TO_"):
                    enumeration = self._enumeration_conversion(node, upper)
                    if enumeration:
                        return enumeration, None
        if target is None:
            target = self._lookup(callee)
        callee.target = target
        if isinstance(target, Method):
            this = This(callee.start, callee.start)
            this.type = self._this(this)
            return target, this
        if isinstance(target, Pou):
            return self._unit(node, target), None
        if isinstance(target, Variable | Property):
            callee.type = self._value_of(callee, target)
            return self._by_value(node, callee.type), callee
        if target is not None:
            self.report(CALL_OF_NO_UNIT, callee, name=callee.name)
        return None, None

    def _enumeration_conversion(self, node: Call, upper: str) -> str:
        """Return the function for ``E_Color_TO_INT`` and the like."""
        source, _, target = upper.rpartition("_TO_")
        if conversion_of(f"TO_{target}") is not None and source:
            declared = self.names.find_type(source.lower(), self.scope.library)
            if declared is not None:
                return f"TO_{target}"
        return ""

    def _unit(self, node: Call, pou: Pou) -> CallableUnit | None:
        """Return a function or program; a block needs an instance."""
        if pou.kind is Kind.FUNCTION_BLOCK:
            self.report(INSTANCE_NEEDED, node.callee, name=pou.name)
            return None
        return pou

    def _by_member(
        self, node: Call, callee: Member
    ) -> tuple[CallableUnit | None, Expression | None]:
        qualifier = self.qualifier(callee.base)
        key = callee.name.lower()
        if isinstance(qualifier, Library | GlobalList | EnumType):
            kind = None
            if isinstance(qualifier, Library):
                found = self._in_library(qualifier, callee.name)
                if isinstance(found, Pou):
                    callee.target = found
                    return self._unit(node, found), None
            kind = self.operand(callee)
            return self._by_value(node, kind), callee
        if isinstance(qualifier, Pou) and qualifier.kind is Kind.PROGRAM:
            method = qualifier.find_method(key)
            if method is not None:
                callee.target = method
                self.operand(callee.base)
                return method, callee.base
        kind = self.operand(callee.base)
        if kind is None:
            return None, None
        target = self.member_of(kind, key)
        if isinstance(target, Method):
            callee.target = target
            self._check_access(callee, target)
            base = callee.base
            if isinstance(base, Dereference) and isinstance(base.base, Super):
                node.is_virtual = False
                if target.is_abstract:
                    self.report(CALL_OF_ABSTRACT, callee, name=target.path)
            return target, base
        callee.type = self._member(callee)
        return self._by_value(node, callee.type), callee

    def _by_value(self, node: Call, kind: Type | None) -> CallableUnit | None:
        """Return the body of an instance; report objects that cannot be called."""
        if isinstance(kind, BlockType):
            return kind.pou
        if kind is not None:
            self.report(CALL_OF_NO_UNIT, node.callee, name=_shown(kind))
        return None

    # --- arguments --------------------------------------------------------------------------------

    def _bind(self, node: Call, target: CallableUnit) -> None:
        """Bind the arguments of a call to the parameters (ST-520)."""
        node.bound.clear()
        parameters = target.parameters
        if isinstance(target, Method) and target.is_action and target.owner is not None:
            parameters = target.owner.parameters
        by_name = {one.name.lower(): one for one in parameters}
        given: set[Variable] = set()
        for position, argument in enumerate(node.arguments):
            parameter = self._parameter(argument, position, parameters, by_name, target)
            if parameter is None:
                if argument.value is not None:
                    self.initial(argument.value, None)
                continue
            if parameter in given:
                self.reporter.report(
                    ARGUMENT_TWICE, argument.start, argument.end, name=parameter.name
                )
                continue
            given.add(parameter)
            self.resolver.complete(parameter)
            if argument.value is not None:
                self._argument(parameter, argument.value, argument)
                node.bound.append((parameter, argument.value))
        missing = [one for one in target.in_outs if one not in given]
        is_block = isinstance(target, Pou) and target.kind is not Kind.FUNCTION
        if missing and not (is_block and not node.arguments and target.is_native):
            names = ", ".join(one.name for one in missing)
            self.report(IN_OUT_NOT_ASSIGNED, node, names=names, name=target.name)

    def _parameter(
        self,
        argument: Argument,
        position: int,
        parameters: list[Variable],
        by_name: dict[str, Variable],
        target: CallableUnit,
    ) -> Variable | None:
        """Return the parameter of an argument; report if there is none."""
        if not argument.name:
            if position < len(parameters):
                return parameters[position]
            if isinstance(target, Pou) and self.resolver.is_incomplete(target):
                return None
            self.reporter.report(
                ARGUMENTS_COUNT,
                argument.start,
                argument.end,
                name=target.name,
                high=len(parameters),
            )
            return None
        found = by_name.get(argument.name.lower())
        if found is not None and (found.section is Section.OUTPUT) is argument.is_output:
            return found
        if argument.is_output and target.result is not None:
            if argument.name.lower() == target.result.name.lower():
                return target.result
        owner = target.owner if isinstance(target, Method) else target
        if isinstance(owner, Pou) and self.resolver.is_incomplete(owner):
            return None
        nearest = KnownNames(
            [
                one.name
                for one in parameters
                if (one.section is Section.OUTPUT) is argument.is_output
            ]
        ).nearest(argument.name)
        message = OUTPUT_UNKNOWN if argument.is_output else PARAMETER_UNKNOWN
        self.reporter.report(
            message,
            argument.start,
            argument.end,
            name=argument.name,
            owner=target.name,
            nearest=nearest or NOTHING,
        )
        return None

    def _argument(self, parameter: Variable, value: Expression, argument: Argument) -> None:
        """Check the value of a parameter by its section."""
        kind = parameter.type
        if parameter.section in (Section.OUTPUT, Section.RESULT):
            found = self.operand(value)
            if found is not None and not is_unknown(kind):
                self.check_target(value)
                if conversion(kind, found) is Verdict.IMPOSSIBLE:
                    self.report(TYPE_MISMATCH, value, source=_shown(kind), target=_shown(found))
            return
        if parameter.section is Section.IN_OUT:
            self._in_out(parameter, value)
            return
        if isinstance(kind, ReferenceType):
            self._reference(kind, value)
            return
        if isinstance(kind, AnyType):
            found = self.expression(value)
            if found is not None and not is_any_of(found, kind.name):
                self.report(TYPE_MISMATCH, value, source=_shown(found), target=kind.name)
            return
        self.converted(value, kind)

    def _in_out(self, parameter: Variable, value: Expression) -> None:
        """Check the argument of a VAR_IN_OUT: a variable of exactly its type."""
        found = self.expression(value)
        kind = parameter.type
        if found is None or is_unknown(kind):
            return
        if parameter.is_constant:
            if conversion(found, kind, value) is Verdict.IMPOSSIBLE:
                self.report(TYPE_MISMATCH, value, source=_shown(found), target=_shown(kind))
            return
        errors = self.reporter.error_count
        self.check_target(value, is_handed_over=True)
        if self.reporter.error_count == errors and not _fits_in_out(found, kind):
            self.report(TYPE_MISMATCH, value, source=_shown(found), target=_shown(kind))

    def _reference(self, kind: ReferenceType, value: Expression) -> None:
        found = self.expression(value)
        if found is None or value.value == 0:
            return
        if not _fits_in_out(found, kind.target):
            self.report(TYPE_MISMATCH, value, source=_shown(found), target=_shown(kind))

    def check_target(self, node: Expression, *, is_handed_over: bool = False) -> None:
        """Report expressions that cannot be written to (C0018), or passed by address."""
        match node:
            case Name(target=Variable() as variable) | Member(target=Variable() as variable):
                if variable.is_constant and variable.section is not Section.IN_OUT:
                    self.report(NOT_ASSIGNABLE, node, name=variable.name)
                elif isinstance(node, Member) and not is_handed_over:
                    self._check_foreign(node, variable)
            case Name(target=Property() as found) | Member(target=Property() as found):
                if is_handed_over:
                    if not isinstance(found.type, ReferenceType):
                        self.report(NOT_ASSIGNABLE, node, name=found.name)
                elif found.set is None and not isinstance(found.type, ReferenceType):
                    self.report(NOT_ASSIGNABLE, node, name=found.name)
            case Name() | Member():
                if node.type is not None and not (isinstance(node, Member) and node.bit >= 0):
                    self.report(NOT_ASSIGNABLE, node, name=node.name)
            case Bit() | Index() | Dereference():
                return
            case Call():
                kind = None if node.target is None else node.target.result
                if kind is None or not isinstance(kind.type, ReferenceType):
                    if node.type is not None:
                        self.report(NOT_ASSIGNABLE, node, name="()")
            case _:
                if node.type is not None:
                    self.report(NOT_ASSIGNABLE, node, name="–")

    def _check_foreign(self, node: Member, variable: Variable) -> None:
        """Report a write to a VAR of another block (ST-401)."""
        if variable.section is not Section.VAR or not isinstance(node.base.type, BlockType):
            return
        own = self.scope.pou
        pou = node.base.type.pou
        if own is not None and (pou in own.bases() or own in pou.bases()):
            return
        self.report(NOT_ASSIGNABLE, node, name=f"{pou.name}.{variable.name}")

    def init_arguments(self, arguments: list[Argument], kind: Type) -> None:
        """Check the arguments of FB_init in a declaration (ST-403)."""
        element = kind.innermost if isinstance(kind, ArrayType) else kind
        method = element.pou.find_method("fb_init") if isinstance(element, BlockType) else None
        parameters: list[Variable] = []
        if method is not None:
            parameters = [
                one for one in method.parameters if one.name.lower() not in _SYSTEM_INPUTS
            ]
        by_name = {one.name.lower(): one for one in parameters}
        for position, argument in enumerate(arguments):
            parameter = None
            if method is not None:
                parameter = self._parameter(argument, position, parameters, by_name, method)
            elif isinstance(element, BlockType) and not self.resolver.is_incomplete(element.pou):
                self.reporter.report(
                    PARAMETER_UNKNOWN,
                    argument.start,
                    argument.end,
                    name=argument.name or "–",
                    owner=f"{element.name}.FB_init",
                    nearest=NOTHING,
                )
            if argument.value is None:
                continue
            if parameter is None:
                self.initial(argument.value, None)
                continue
            self.resolver.complete(parameter)
            self._argument(parameter, argument.value, argument)

    # --- built-in functions -----------------------------------------------------------------------

    def _built_in(self, node: Call, upper: str) -> Type | None:
        """Check a built-in function or a conversion."""
        node.function = upper
        for argument in node.arguments:
            if argument.name and not upper.startswith(("SEL", "MUX", "LIMIT", "MIN", "MAX")):
                if argument.name.upper() in ("EN", "ENO"):
                    self.reporter.report(
                        CONSTRUCT_REFUSED,
                        argument.start,
                        argument.end,
                        name="EN/ENO",
                        advice=_EN_ENO,
                    )
        operands = node.operands = [one.value for one in node.arguments if one.value is not None]
        if upper in REFUSED:
            for operand in operands[1:] if upper == "__NEW" else operands:
                self.expression(operand)
            self.report(CONSTRUCT_REFUSED, node.callee, name=upper, advice=REFUSED[upper])
            return None
        found = BUILT_INS.get(upper)
        if found is None:
            node.kind = CallKind.CONVERSION
            return self._conversion(node, upper)
        node.kind = CallKind.BUILT_IN
        if not found.low <= len(operands) <= found.high:
            for operand in operands:
                self.expression(operand)
            self.report(ARGUMENTS_COUNT, node, name=upper, high=found.high)
            return None
        return self._rules[found.rule](node, found)

    def _conversion(self, node: Call, upper: str) -> Type | None:
        """Check ``X_TO_Y`` (ST-307)."""
        pair = conversion_of(upper)
        assert pair is not None
        source, target = pair
        node.function = "TO"
        if len(node.operands) != 1:
            for operand in node.operands:
                self.expression(operand)
            self.report(ARGUMENTS_COUNT, node, name=upper, high=1)
            return target
        operand = node.operands[0]
        if source is not None and not isinstance(source, StringType):
            found = self.operand(operand)
            if found is not None:
                if found in (UNTYPED, UNTYPED_REAL):
                    fits = isinstance(source, Elementary) and source.family in NUMBERS
                    self.convert(operand, found, source if fits else found)
                elif not _converts_by_function(found):
                    self.report(TYPE_MISMATCH, operand, source=_shown(found), target=_shown(source))
                elif conversion(found, source, operand) is Verdict.IMPOSSIBLE:
                    if not _is_near(found, source):
                        self.report(
                            TYPE_MISMATCH, operand, source=_shown(found), target=_shown(source)
                        )
        else:
            found = self.expression(operand)
        if found is not None and not _converts_by_function(found):
            self.report(TYPE_MISMATCH, node, source=_shown(found), target=_shown(target))
        self._fold_conversion(node, operand, target)
        return target

    def _fold_conversion(self, node: Call, operand: Expression, target: Type) -> None:
        """Compute the conversion of a whole constant between whole numbers and reals."""
        value = operand.value
        if not isinstance(target, Elementary) or not isinstance(value, int | float):
            return
        if isinstance(operand.type, Elementary) and operand.type.family not in NUMBERS:
            return
        if target.family is Family.REAL:
            node.value = float(value)
        elif target.family in INTEGERS and isinstance(value, int):
            number = value & (1 << 8 * target.size) - 1
            is_negative = target.family is Family.SIGNED and number > target.high
            node.value = number - (1 << 8 * target.size) if is_negative else number

    def _numbers(self, node: Call) -> Elementary | None:
        """Check operands that are numbers; return the type in which they meet."""
        kind: Elementary | None = None
        value: object = None
        is_known = True
        for operand in node.operands:
            found = self.operand(operand)
            base = found.base if isinstance(found, EnumType) else found
            if found is None:
                is_known = False
            elif not isinstance(base, Elementary) or base.family not in NUMBERS:
                self.report(VALUE_NEEDED, operand, name=node.function, kind=_shown(found))
                is_known = False
            elif kind is None:
                kind, value = base, operand.value
            else:
                kind = common_number(kind, base, value, operand.value)
                value = operand.value
        if kind is not None and kind not in (UNTYPED, UNTYPED_REAL):
            for operand in node.operands:
                if operand.type in (UNTYPED, UNTYPED_REAL):
                    self._settle_into(operand, kind)
        return kind if is_known else None

    def _number(self, node: Call, _: BuiltIn) -> Type | None:
        return self._numbers(node)

    def _real(self, node: Call, _: BuiltIn) -> Type | None:
        kind = self._numbers(node)
        if kind in (UNTYPED, UNTYPED_REAL):
            for operand in node.operands:
                self.settle(operand, LREAL)
        if kind is None:
            return None
        return REAL if kind is REAL else LREAL

    def _power(self, node: Call, _: BuiltIn) -> Type | None:
        for operand in node.operands:
            if self.operand(operand) in (UNTYPED, UNTYPED_REAL):
                self.settle(operand, LREAL if operand.type is UNTYPED_REAL else DINT)
        return LREAL

    def _truncation(self, node: Call, found: BuiltIn) -> Type | None:
        node.kind = CallKind.CONVERSION
        self._real(node, found)
        return DINT if found.name == "TRUNC" else INT

    def _common_type(self, node: Call, found: BuiltIn) -> Type | None:
        """Type MIN, MAX, LIMIT: numbers meet, other types must be the same."""
        kinds = [self.operand(operand) for operand in node.operands]
        if any(kind is None for kind in kinds):
            self._settle_all(node, None)
            return None
        if isinstance(kinds[0], EnumType) and all(kind is kinds[0] for kind in kinds):
            return kinds[0]
        if all(_is_number(kind) for kind in kinds):
            return self._numbers(node)
        first = next(kind for kind in kinds if kind not in (UNTYPED, UNTYPED_REAL))
        self._settle_all(node, first)
        for operand, kind_ in zip(node.operands, kinds, strict=True):
            assert kind_ is not None and first is not None
            if kind_ not in (UNTYPED, UNTYPED_REAL):
                if conversion(kind_, first, operand) is Verdict.IMPOSSIBLE:
                    self.report(TYPE_MISMATCH, operand, source=_shown(kind_), target=_shown(first))
        return first

    def _settle_all(self, node: Call, kind: Type | None) -> None:
        for operand in node.operands:
            if operand.type in (UNTYPED, UNTYPED_REAL):
                if kind is None:
                    self.settle(operand, LREAL if operand.type is UNTYPED_REAL else DINT)
                else:
                    self._settle_into(operand, kind)

    def _selection(self, node: Call, found: BuiltIn) -> Type | None:
        """Type SEL and MUX: the selector first, then values of one type."""
        selector = node.operands[0]
        self.converted(selector, BOOL if found.name == "SEL" else None)
        all_operands = node.operands
        node.operands = all_operands[1:]
        kind = self._common_type(node, found)
        node.operands = all_operands
        return kind

    def _shift(self, node: Call, found: BuiltIn) -> Type | None:
        kind = self.operand(node.operands[0])
        self.expression(node.operands[1])
        if kind is None:
            return None
        if kind is UNTYPED:
            self.expression(node.operands[0])
            return node.operands[0].type
        if not _is_whole(kind):
            self.report(VALUE_NEEDED, node.operands[0], name=found.name, kind=_shown(kind))
            return None
        return kind.base if isinstance(kind, EnumType) else kind

    def _address_of(self, node: Call, _: BuiltIn) -> Type | None:
        """Type ADR: of a variable, not of a bit, a constant or a POU."""
        operand = node.operands[0]
        if isinstance(self.qualifier(operand), Pou):
            pou = self.qualifier(operand)
            assert isinstance(pou, Pou)
            if pou.kind is not Kind.PROGRAM:
                self.report(NO_ADDRESS, operand, name=pou.name)
                return None
        kind = self.expression(operand)
        if kind is None:
            return None
        is_bit = isinstance(operand, Bit)
        if isinstance(kind, Elementary) and kind.is_bit and isinstance(operand, Name | Member):
            # The first bit of a byte has that byte's address, as in a union.
            is_bit = isinstance(operand.target, Variable) and operand.target.bit > 0
        is_value = isinstance(operand, Call) or (
            isinstance(operand, Name | Member) and isinstance(operand.target, Property)
        )
        if isinstance(operand, Call) and operand.target is not None and operand.target.result:
            is_value = not isinstance(operand.target.result.type, ReferenceType)
        if isinstance(operand, Name | Member) and isinstance(operand.target, Property):
            is_value = not isinstance(operand.target.type, ReferenceType)
        if (
            is_bit
            or is_value
            or not isinstance(operand, Name | Member | Index | Dereference | Call | This)
        ):
            if not (isinstance(kind, StringType) and operand.value is not None):
                self.report(NO_ADDRESS, operand, name=_shown(kind))
                return None
        return PointerType(f"POINTER TO {kind.name}", 8, 8, kind)

    def _size(self, node: Call, found: BuiltIn) -> Type | None:
        """Type SIZEOF: of a variable or a type; it is constant but for ARRAY[*]."""
        operand = node.operands[0]
        kind: Type | None = None
        if isinstance(operand, Name):
            kind = self._type_named(operand)
        if kind is None and isinstance(operand, Call) and isinstance(operand.callee, Name):
            if operand.callee.name.upper() in ("STRING", "WSTRING") and operand.operands == []:
                length = operand.arguments[0].value if operand.arguments else None
                if length is not None:
                    self.expression(length)
                    if isinstance(length.value, int):
                        kind = string(
                            length.value, is_wide=operand.callee.name.upper() == "WSTRING"
                        )
        if kind is None:
            kind = self.expression(operand)
        if kind is None:
            return UDINT if found.name == "SIZEOF" else ULINT
        self.resolver.layout(kind, None)
        size = 1 if kind is BIT else kind.size
        if not (isinstance(kind, ArrayType) and kind.is_open) and size:
            node.value = size
        return UDINT if found.name == "SIZEOF" else ULINT

    def _type_named(self, node: Name) -> Type | None:
        """Return the type denoted by a name that is not a variable."""
        if node.name.upper() in ("STRING", "WSTRING"):
            kind: Type = string(80, is_wide=node.name.upper() == "WSTRING")
            node.target = node.type = kind
            return kind
        key = node.name.lower()
        if key in self.scope.local_names or key in self.scope.members:
            return None
        found = self.names.find(key, self.scope.library)
        target = self.resolver.target_of(found) if isinstance(found, Declared) else found
        if target is None and found is None:
            target = ELEMENTARY.get(node.name.upper())
        if isinstance(target, Pou):
            target = target.type
        if isinstance(target, Type):
            node.target = node.type = target
            return target
        return None

    def _bound(self, node: Call, found: BuiltIn) -> Type | None:
        kind = self.operand(node.operands[0])
        self.expression(node.operands[1])
        if kind is not None and not isinstance(kind, ArrayType):
            self.report(VALUE_NEEDED, node.operands[0], name=found.name, kind=_shown(kind))
        elif isinstance(kind, ArrayType):
            dimension = node.operands[1].value
            if isinstance(dimension, int) and 1 <= dimension <= len(kind.bounds):
                node.value = kind.bounds[dimension - 1][found.name == "UPPER_BOUND"]
        return DINT

    def _clock(self, node: Call, found: BuiltIn) -> Type | None:
        return TIME if found.name == "TIME" else LTIME

    def _valid(self, node: Call, _: BuiltIn) -> Type | None:
        self.expression(node.operands[0])
        return BOOL

    def _query(self, node: Call, found: BuiltIn) -> Type | None:
        source = self.operand(node.operands[0])
        self.operand(node.operands[1])
        if source is not None and not isinstance(source, InterfaceType | BlockType):
            self.report(VALUE_NEEDED, node.operands[0], name=found.name, kind=_shown(source))
        return BOOL

    def _text(self, node: Call, found: BuiltIn) -> Type | None:
        """Type ``__POUNAME`` and ``__POSITION``: constant texts (ST-621)."""
        text = "" if self.unit is None else self.unit.path
        piece = self.reporter.sources.piece_of(node.start)
        if found.name == "__POSITION" and piece is not None:
            before = piece.text[: node.start - piece.base]
            line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
            part = "Decl" if piece.is_declaration else "Impl"
            text = f"Line {line}, Column {column} ({part})"
        node.value = text.encode("latin-1", "replace")
        return string(255)

    def _information(self, node: Call, _: BuiltIn) -> Type | None:
        self.expression(node.operands[0])
        declared = self.names.find_type("var_info")
        target = None if declared is None else self.resolver.target_of(declared)
        return target if isinstance(target, StructType) else None


_ANY_FAMILIES = {
    "ANY_NUM": NUMBERS,
    "ANY_INT": INTEGERS,
    "ANY_REAL": NUMBERS - INTEGERS,
    "ANY_BIT": frozenset((Family.BITS, Family.BOOL)),
    "ANY_DATE": frozenset((Family.DATE,)),
}


def is_any_of(kind: Type, name: str) -> bool:
    """Return whether a type is covered by ``ANY``, ``ANY_NUM`` … (ST-620)."""
    if isinstance(kind, AnyType) or name == "ANY":
        return name in ("ANY", kind.name)
    if name == "ANY_STRING":
        return isinstance(kind, StringType)
    base = kind.base if isinstance(kind, EnumType) else kind
    return isinstance(base, Elementary) and base.family in _ANY_FAMILIES[name]


def _is_number(kind: Type | None) -> bool:
    base = kind.base if isinstance(kind, EnumType) else kind
    return isinstance(base, Elementary) and base.family in NUMBERS


def _converts_by_function(kind: Type) -> bool:
    """Whether a value of a type can be the operand of a conversion."""
    return isinstance(kind, Elementary | StringType | EnumType | PointerType | InterfaceType)


def _is_near(found: Type, source: Type) -> bool:
    """Whether a conversion function takes a wider number of the kind that it names."""
    first = found.base if isinstance(found, EnumType) else found
    if isinstance(first, PointerType):
        return True
    return (
        isinstance(first, Elementary)
        and isinstance(source, Elementary)
        and first.family in NUMBERS
        and source.family in NUMBERS
    )


def _fits_in_out(found: Type, kind: Type) -> bool:
    """Whether a variable can be handed over as VAR_IN_OUT or bound to a reference."""
    if isinstance(kind, ReferenceType):
        kind = kind.target
    if isinstance(kind, StringType):
        return isinstance(found, StringType) and found.is_wide == kind.is_wide
    if isinstance(kind, Elementary | EnumType):
        first = found.base if isinstance(found, EnumType) else found
        second = kind.base if isinstance(kind, EnumType) else kind
        if not isinstance(first, Elementary) or not isinstance(second, Elementary):
            return False
        is_same = first.family is second.family or {first.family, second.family} <= INTEGERS
        return is_same and first.size == second.size
    if isinstance(kind, PointerType):
        return isinstance(found, PointerType)
    return conversion(found, kind) is not Verdict.IMPOSSIBLE


_EN_ENO = REFUSED["INI"]
