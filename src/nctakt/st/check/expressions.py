# SPDX-License-Identifier: MIT
"""Types, targets and constant values of expressions (ST-203, ST-206, ST-302 … 317, ST-501 … 503).

In: an expression of the tree, the names that it sees, the type that its context wants. Out: the
expression with ``type``, ``value`` and ``target``. After a mistake its type is ``None``, and no
expression around it is reported again (ST-1001).
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import NOTHING, Message
from nctakt.base.misspelling import KnownNames
from nctakt.messages.plcs.st_check import (
    BIT_OUTSIDE,
    CALL_WITHOUT_BRACKETS,
    CHARACTER_NOT_IN_STRING,
    CONSTANT_EXPECTED,
    CONSTANT_TOO_LARGE,
    DEREFERENCE_OF_NO_POINTER,
    DIGITS_MAY_GET_LOST,
    DIVISION_BY_CONSTANT_ZERO,
    FIXED_ADDRESS,
    INDEX_OF_NO_ARRAY,
    INDEX_OUTSIDE,
    INDICES_COUNT,
    LIBRARY_MEMBER_UNKNOWN,
    LITERAL_WRONG,
    MEMBER_NOT_ACCESSIBLE,
    MEMBER_UNKNOWN,
    NAME_AMBIGUOUS,
    NAME_NEEDS_QUALIFIER,
    NAME_UNKNOWN,
    NOT_FILLED_HERE,
    OPERATOR_ON_WRONG_TYPES,
    POINTER_CONVERTED,
    POWER_REFUSED,
    PRECEDENCE_UNCLEAR,
    SIGN_MAY_CHANGE,
    STRING_CONSTANT_TOO_LONG,
    THIS_OUTSIDE,
    TYPE_MISMATCH,
    TYPE_UNKNOWN,
    TYPES_NOT_COMPARABLE,
    VALUE_EXPECTED_NOT_TYPE,
)
from nctakt.messages.plcs.st_text import EXPRESSION_EXPECTED
from nctakt.st.check.conversions import Verdict, bases_of, conversion, round_real
from nctakt.st.check.names import Ambiguous, Declared, Names, Scope
from nctakt.st.check.resolver import Resolver, is_unknown
from nctakt.st.parse.literals import (
    LITERAL_KINDS,
    date_s,
    duration_ns,
    integer,
    real,
    time_of_day_ms,
)
from nctakt.st.parse.literals import (
    string as string_value,
)
from nctakt.st.reporting import Reporter
from nctakt.st.tree import (
    Address,
    ArrayInitial,
    AssignmentExpression,
    Binary,
    Bit,
    Call,
    Dereference,
    GlobalList,
    Index,
    Library,
    Literal,
    Member,
    Name,
    Operator,
    Repetition,
    StructInitial,
    Super,
    Target,
    This,
    TypeExpression,
    Unary,
)
from nctakt.st.types import (
    Access,
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
    same_type,
)
from nctakt.st.vocabulary.elementary import (
    BOOL,
    BYTE,
    DATE,
    DATE_AND_TIME,
    DINT,
    ELEMENTARY,
    INTEGERS,
    LINT,
    LITERAL_PREFIXES,
    LREAL,
    NUMBERS,
    REAL,
    TIME,
    TIME_OF_DAY,
    UNTYPED,
    UNTYPED_REAL,
    WORD,
    nearest_type,
    signed,
    smallest,
    smallest_bits,
    string,
    wider,
)
from nctakt.st.vocabulary.libraries import FILLED, NC_AXES

_COMPARISONS = frozenset(
    (
        Operator.EQUAL,
        Operator.UNEQUAL,
        Operator.LESS,
        Operator.GREATER,
        Operator.LESS_EQUAL,
        Operator.GREATER_EQUAL,
    )
)
_LOGICAL = frozenset((Operator.AND, Operator.OR, Operator.XOR))
_SHORT = frozenset((Operator.AND_THEN, Operator.OR_ELSE))
_EQUALITY = frozenset((Operator.EQUAL, Operator.UNEQUAL))

_FOLDED: dict[Operator, Callable[[int, int], int]] = {
    Operator.ADD: lambda first, second: first + second,
    Operator.SUBTRACT: lambda first, second: first - second,
    Operator.MULTIPLY: lambda first, second: first * second,
    Operator.AND: lambda first, second: first & second,
    Operator.OR: lambda first, second: first | second,
    Operator.XOR: lambda first, second: first ^ second,
}
_COMPARED: dict[Operator, Callable[[float, float], bool]] = {
    Operator.EQUAL: lambda first, second: first == second,
    Operator.UNEQUAL: lambda first, second: first != second,
    Operator.LESS: lambda first, second: first < second,
    Operator.GREATER: lambda first, second: first > second,
    Operator.LESS_EQUAL: lambda first, second: first <= second,
    Operator.GREATER_EQUAL: lambda first, second: first >= second,
}
_WARNINGS = {
    Verdict.SIGN_MAY_CHANGE: SIGN_MAY_CHANGE,
    Verdict.DIGITS_MAY_GET_LOST: DIGITS_MAY_GET_LOST,
    Verdict.POINTER_CHANGES: POINTER_CONVERTED,
}
#: Bits of the largest whole number.
_MAX_BITS = 64


class ExpressionChecker:
    """Checks the expressions of one scope at a time: the caller sets ``scope``."""

    def __init__(self, names: Names, resolver: Resolver, reporter: Reporter) -> None:
        self.names = names
        self.resolver = resolver
        self.reporter = reporter
        self.scope = Scope()
        self.foreign_libraries: list[str] = []
        self._known_names: KnownNames | None = None
        self._reported_foreign: set[str] = set()
        #: Names of libraries without sources are reported in each unit, not once for the project.
        self.reports_in_each_unit = False
        self._checks: dict[type[Expression], Callable[..., Type | None]] = {
            Name: self._name,
            Literal: self._literal,
            Member: self._member,
            Binary: self._binary,
            Unary: self._unary,
            Call: self._call,
            Index: self._index,
            Dereference: self._dereference,
            This: self._this,
            Super: self._this,
            Bit: self._bit,
            Address: self._address,
            AssignmentExpression: self._assignment_expression,
            TypeExpression: self._type_expression,
            ArrayInitial: self._misplaced,
            StructInitial: self._misplaced,
        }

    # --- entrances --------------------------------------------------------------------------------

    def operand(self, node: Expression) -> Type | None:
        """Check an expression and return its type, ``UNTYPED`` for a literal."""
        node.value = None  # an editor checks a tree again after other files have changed
        kind = self._checks[type(node)](node)
        node.type = kind
        return kind

    def expression(self, node: Expression) -> Type | None:
        """Check an expression whose context requires no particular type."""
        kind = self.operand(node)
        if kind is UNTYPED:
            self.settle(node, smallest(node.value) if isinstance(node.value, int) else LINT)
        elif kind is UNTYPED_REAL:
            self.settle(node, LREAL)
        return node.type

    def converted(self, node: Expression, target: Type | None) -> Type | None:
        """Check an expression that is converted into ``target``; report if it cannot be."""
        if isinstance(node, ArrayInitial | StructInitial):
            return self.initial(node, target)
        kind = self.operand(node)
        if kind is None or target is None or is_unknown(target):
            if kind in (UNTYPED, UNTYPED_REAL):
                self.settle(node, LINT if kind is UNTYPED else LREAL)
            return kind
        self.convert(node, kind, target)
        return kind

    def convert(self, node: Expression, source: Type, target: Type) -> None:
        """Report where a checked value does not convert into ``target``; settle literals."""
        verdict = conversion(source, target, node)
        if source in (UNTYPED, UNTYPED_REAL):
            self._settle_into(node, target)
        if verdict is Verdict.FITS:
            if isinstance(target, StringType) and isinstance(node, Literal):
                length = len(node.value) if isinstance(node.value, bytes) else 0
                if length > target.length * (2 if target.is_wide else 1):
                    self.report(STRING_CONSTANT_TOO_LONG, node, length=target.length)
            return
        values = {"source": _shown(source), "target": _shown(target)}
        if verdict is Verdict.IMPOSSIBLE:
            if source is UNTYPED and isinstance(target, Elementary) and target.family in INTEGERS:
                low, high = target.low, target.high
                value = node.value if isinstance(node.value, int) else 0
                self.report(
                    CONSTANT_TOO_LARGE, node, number=value, low=low, high=high, kind=target.name
                )
            else:
                self.report(TYPE_MISMATCH, node, **values)
            return
        self.report(_WARNINGS[verdict], node, **values)

    def _settle_into(self, node: Expression, target: Type) -> None:
        while isinstance(target, ReferenceType):
            target = target.target
        if isinstance(target, EnumType):
            target = target.base
        if isinstance(target, Elementary):
            if target.family in NUMBERS:
                self.settle(node, target)
                return
            if target.family is Family.BOOL and node.value in (0, 1):
                node.type, node.value = BOOL, bool(node.value)
                return
        value = node.value
        whole = smallest(value) if isinstance(value, int) else LINT
        self.settle(node, LREAL if node.type is UNTYPED_REAL else whole)

    def settle(self, node: Expression, kind: Elementary) -> None:
        """Give the literals of an expression, and all that is made of them, a type."""
        stack = [node]
        while stack:
            part = stack.pop()
            if part.type not in (UNTYPED, UNTYPED_REAL):
                continue
            part.type = kind
            if kind.family is Family.REAL and isinstance(part.value, int | float):
                value = float(part.value)
                part.value = round_real(value) if kind.size < LREAL.size else value
            if isinstance(part, Unary):
                stack.append(part.operand)
            elif isinstance(part, Binary):
                part.operand_type = kind
                stack += (part.left, part.right)
            elif isinstance(part, Call):
                stack += part.operands

    def report(self, message: Message, node: Expression, **values: object) -> None:
        """Report a message at an expression."""
        self.reporter.report(message, node.start, node.end, **values)

    # --- names ------------------------------------------------------------------------------------

    def unknown(self, message: Message, name: str, start: int, end: int, scope: Scope) -> None:
        """Report an unknown name, with the nearest known one, or its libraries."""
        if any(name.lower() in library.faulty for library in self.names.own.values()):
            return
        if self.foreign_libraries and not scope.library:
            key = f"{scope.title if self.reports_in_each_unit else ''}\0{name.lower()}"
            if key in self._reported_foreign:
                return
            self._reported_foreign.add(key)
        if self._known_names is None:
            self._known_names = KnownNames(self.names.all_names())
        nearest = nearest_type(name) if message is TYPE_UNKNOWN else None
        nearest = nearest or self._known_names.nearest(name)
        if nearest is None:
            nearest = KnownNames(
                [
                    one.name
                    for one in (*scope.local_names.values(), *scope.members.values())
                    if hasattr(one, "name")
                ]
            ).nearest(name)
        libraries = ", ".join(self.foreign_libraries) or NOTHING
        self.reporter.report(
            message, start, end, name=name, nearest=nearest or NOTHING, libraries=libraries
        )

    def _lookup(self, node: Name) -> Target | None:
        """Return the object of a name; report if it is unknown or ambiguous."""
        key = node.name.lower()
        scope = self.scope
        if not node.is_global:
            target = scope.local_names.get(key) or scope.members.get(key)
            if target is not None:
                return target
        found = self.names.find(key, scope.library)
        if isinstance(found, Declared):
            return self.resolver.target_of(found)
        if isinstance(found, Ambiguous):
            lists = ", ".join(one.name for one, _ in found.found)
            self.report(NAME_AMBIGUOUS, node, name=node.name, lists=lists)
            return found.found[0][1]
        if found is None:
            upper = node.name.upper()
            if upper in ELEMENTARY:
                return ELEMENTARY[upper]
            self._report_unknown(node)
        return found

    def _report_unknown(self, node: Name) -> None:
        """Report an unknown name; a list or enumeration may hold it under a qualified name."""
        if self.resolver.is_incomplete(self.scope.pou):
            return
        key = node.name.lower()
        for space in self.names.spaces(self.scope.library, key):
            for found in space.lists.values():
                if found.is_qualified_only and key in found.variables:
                    qualified = f"{found.name}.{node.name}"
                    self.report(NAME_NEEDS_QUALIFIER, node, name=node.name, qualified=qualified)
                    return
            for declared in space.declared.values():
                kind = declared.target
                if isinstance(kind, EnumType) and key in kind.values:
                    qualified = f"{kind.name}.{node.name}"
                    self.report(NAME_NEEDS_QUALIFIER, node, name=node.name, qualified=qualified)
                    return
        self.unknown(NAME_UNKNOWN, node.name, node.start, node.end, self.scope)

    def _name(self, node: Name) -> Type | None:
        target = node.target = self._lookup(node)
        return None if target is None else self._value_of(node, target)

    def _value_of(self, node: Name | Member, target: Target) -> Type | None:
        """Return the type of a name's object, as a value."""
        if isinstance(target, Variable):
            if target in self.resolver.open_variables:
                self.report(CONSTANT_EXPECTED, node)
                return None
            self.resolver.complete(target)
            if target.value is not None:
                node.value = target.value
            kind = target.type
            if isinstance(kind, ReferenceType):
                return kind.target
            return None if is_unknown(kind) else kind
        if isinstance(target, EnumValue):
            node.value = target.number
            return target.type
        if isinstance(target, Property):
            kind = target.type
            return (
                kind.target
                if isinstance(kind, ReferenceType)
                else (None if is_unknown(kind) else kind)
            )
        if isinstance(target, Pou):
            if target.kind is Kind.PROGRAM:
                return target.type
            self.report(CALL_WITHOUT_BRACKETS, node, name=target.name)
            return None
        if isinstance(target, Method):
            self.report(CALL_WITHOUT_BRACKETS, node, name=target.name)
            return None
        self.report(VALUE_EXPECTED_NOT_TYPE, node, name=node.name)
        return None

    def qualifier(self, node: Expression) -> Target | None:
        """Return the list, type, library or POU that an expression names; ``None`` for values."""
        if isinstance(node, Name) and not node.is_global:
            key = node.name.lower()
            scope = self.scope
            if key in scope.local_names or key in scope.members:
                return None
            found = self.names.find(key, scope.library)
            target = self.resolver.target_of(found) if isinstance(found, Declared) else found
            if isinstance(target, GlobalList | Library | EnumType | StructType | Pou):
                return target
            if isinstance(target, Variable | EnumValue):
                # A list may have the name of a variable elsewhere: GVL.x, and x.
                return None
            return None
        if isinstance(node, Member):
            outer = self.qualifier(node.base)
            if isinstance(outer, Library):
                return self._in_library(outer, node.name)
        return None

    def _in_library(self, library: Library, name: str) -> Target | None:
        space = self.names.of_library(library.name)
        self.names.read(space)
        key = name.lower()
        if key in space.lists:
            return space.lists[key]
        if key in space.declared:
            return self.resolver.target_of(space.declared[key])
        if key in space.variables:
            return space.variables[key][0][1]
        if key in space.values:
            return space.values[key]
        # A library that this one refers to.
        inner = self.names.libraries.get(key)
        return None if inner is None else Library(inner.library)

    # --- members ----------------------------------------------------------------------------------

    def _member(self, node: Member) -> Type | None:
        node.target, node.bit = None, -1
        qualifier = self.qualifier(node.base)
        key = node.name.lower()
        if isinstance(qualifier, GlobalList):
            found: Target | None = qualifier.variables.get(key)
            return self._qualified(node, qualifier, qualifier.name, found, qualifier.variables)
        if isinstance(qualifier, EnumType):
            return self._qualified(
                node, qualifier, qualifier.name, qualifier.values.get(key), qualifier.values
            )
        if isinstance(qualifier, Library):
            found = self._in_library(qualifier, node.name)
            space = self.names.of_library(qualifier.name)
            return self._qualified(node, qualifier, qualifier.name, found, space.declared)
        if isinstance(qualifier, Pou) and qualifier.kind is Kind.FUNCTION_BLOCK:
            constant = qualifier.variables.get(key)
            if constant is not None and (constant.is_constant or constant.section is Section.STAT):
                return self._qualified(node, qualifier, qualifier.name, constant, {})
        kind = self.operand(node.base)
        if kind is None:
            return None
        target = self.member_of(kind, key)
        if target is None:
            return self._bit_by_name(node, kind)
        node.target = target
        if isinstance(kind, BlockType | StructType):
            self.check_filled(kind, key, node.end - len(node.name), node.end)
        self._check_access(node, target)
        return self._value_of(node, target)

    def check_filled(self, owner: BlockType | StructType, key: str, start: int, end: int) -> None:
        """Warn about a member that the NC fills on the machine, but nothing fills here."""
        filled = FILLED.get(owner.name)
        space = self.names.libraries.get(NC_AXES.lower())
        if filled is None or key in filled or space is None or self.scope.library:
            return
        own = owner.pou if isinstance(owner, BlockType) else owner
        known, declared = own.members.get(key), space.declared.get(own.name.lower())
        if known is not None and declared is not None and declared.target is own:
            self.reporter.report(NOT_FILLED_HERE, start, end, name=known.name, owner=owner.name)

    def _qualified(
        self, node: Member, qualifier: Target, name: str, found: Target | None, known: object
    ) -> Type | None:
        assert isinstance(node.base, Name | Member)
        node.base.target = qualifier
        if found is None:
            names = [one.name for one in known.values()] if isinstance(known, dict) else []
            if isinstance(qualifier, Library):
                nearest = KnownNames(names).nearest(node.name) or NOTHING
                start = node.end - len(node.name)
                self.reporter.report(
                    LIBRARY_MEMBER_UNKNOWN,
                    start,
                    node.end,
                    name=node.name,
                    owner=name,
                    nearest=nearest,
                )
            else:
                self._report_member(node, name, names)
            return None
        node.target = found
        return self._value_of(node, found)

    def _report_member(self, node: Member, owner: str, names: list[str]) -> None:
        nearest = KnownNames(names).nearest(node.name) or NOTHING
        self.reporter.report(
            MEMBER_UNKNOWN,
            node.end - len(node.name),
            node.end,
            name=node.name,
            owner=owner,
            nearest=nearest,
        )

    def member_of(self, kind: Type, key: str) -> Target | None:
        """Return the member of a type: variable, property or method."""
        if isinstance(kind, StructType):
            self.resolver.layout(kind, None)
            return kind.members.get(key)
        if isinstance(kind, BlockType):
            return self.resolver.scope_of(kind.pou).members.get(key) or kind.pou.variables.get(key)
        if isinstance(kind, InterfaceType):
            for interface in bases_of(kind):
                found = interface.methods.get(key) or interface.properties.get(key)
                if found is not None:
                    return found
        if isinstance(kind, AnyType):
            return kind.form.members.get(key)
        return None

    def _bit_by_name(self, node: Member, kind: Type) -> Type | None:
        """Return BOOL for ``x.cBit``, whose bit is a constant; report other members."""
        base = kind.base if isinstance(kind, EnumType) else kind
        if isinstance(base, Elementary) and base.family in INTEGERS:
            found = self.scope.local_names.get(node.name.lower()) or self.scope.members.get(
                node.name.lower()
            )
            found = found or self.names.find(node.name.lower(), self.scope.library)  # type: ignore[assignment]
            if isinstance(found, Variable):
                self.resolver.complete(found)
                if isinstance(found.value, int):
                    node.bit = found.value
                    return self._bit_type(node, base, found.value)
        names: list[str] = []
        if self.resolver.is_incomplete(kind):
            return None
        if isinstance(kind, StructType):
            names = [member.name for member in kind.members.values()]
        elif isinstance(kind, BlockType):
            members = self.resolver.scope_of(kind.pou).members
            names = [one.name for one in members.values() if hasattr(one, "name")]
        elif isinstance(kind, InterfaceType):
            names = [one.name for base_ in bases_of(kind) for one in base_.methods.values()]
        self._report_member(node, _shown(kind), names)
        return None

    def _check_access(self, node: Member, target: Target) -> None:
        """Report a member that may not be used from outside (ST-401, ST-605)."""
        own = self.scope.pou
        if isinstance(target, Method | Property):
            owner = target.owner
            if owner is None or target.access in (Access.PUBLIC, Access.INTERNAL):
                if target.access is not Access.INTERNAL or owner is None:
                    return
                is_allowed = owner.library == self.scope.library
            elif target.access is Access.PRIVATE:
                is_allowed = own is owner
            else:
                is_allowed = own is not None and owner in own.bases()
            if not is_allowed:
                self.report(
                    MEMBER_NOT_ACCESSIBLE,
                    node,
                    name=node.name,
                    access=target.access.value,
                    owner=owner.name,
                )
        elif isinstance(target, Variable) and target.section in (Section.TEMP, Section.INST):
            if own is None or target.owner.split(".")[0].lower() != own.name.lower():
                self.report(
                    MEMBER_NOT_ACCESSIBLE,
                    node,
                    name=node.name,
                    access=target.section.value,
                    owner=target.owner,
                )

    def _bit(self, node: Bit) -> Type | None:
        kind = self.operand(node.base)
        if kind is None:
            return None
        base = kind.base if isinstance(kind, EnumType) else kind
        if not isinstance(base, Elementary) or base.family not in INTEGERS:
            self.report(
                MEMBER_UNKNOWN, node, name=str(node.number), owner=_shown(kind), nearest=NOTHING
            )
            return None
        return self._bit_type(node, base, node.number)

    def _bit_type(self, node: Expression, base: Elementary, number: int) -> Type | None:
        if not 0 <= number < 8 * base.size:
            self.report(BIT_OUTSIDE, node, number=number, kind=base.name, high=8 * base.size - 1)
            return None
        return BOOL

    def _this(self, node: This | Super) -> Type | None:
        pou = self.scope.pou
        if pou is None or pou.type is None or pou.kind is Kind.FUNCTION:
            self.report(THIS_OUTSIDE, node, word="THIS" if isinstance(node, This) else "SUPER")
            return None
        if isinstance(node, Super):
            if pou.base is None:
                if not self.resolver.is_incomplete(pou):
                    self.report(THIS_OUTSIDE, node, word="SUPER")
                return None
            pou = pou.base
        assert pou.type is not None
        return PointerType(f"POINTER TO {pou.name}", 8, 8, pou.type)

    def _dereference(self, node: Dereference) -> Type | None:
        kind = self.operand(node.base)
        if kind is None:
            return None
        if not isinstance(kind, PointerType) or kind.target is None:
            self.report(DEREFERENCE_OF_NO_POINTER, node, kind=_shown(kind))
            return None
        return kind.target

    def _address(self, node: Address) -> Type | None:
        self.report(FIXED_ADDRESS, node, text=node.text)
        return None

    def _type_expression(self, node: TypeExpression) -> Type | None:
        return self.resolver.type_of(node.node, self.scope)

    def _misplaced(self, node: Expression) -> Type | None:
        self.report(EXPRESSION_EXPECTED, node, found="(…)")
        return None

    def _assignment_expression(self, node: AssignmentExpression) -> Type | None:
        target = self.operand(node.target)
        self.converted(node.assigned, target)
        return target

    def _call(self, node: Call) -> Type | None:
        raise NotImplementedError

    # --- elements ---------------------------------------------------------------------------------

    def _index(self, node: Index) -> Type | None:
        kind = self.operand(node.base)
        for index in node.indices:
            found = self.expression(index)
            if found is not None and not _is_whole(found):
                self.report(TYPE_MISMATCH, index, source=_shown(found), target="DINT")
        if kind is None:
            return None
        if isinstance(kind, PointerType) and kind.target is not None:
            return kind.target
        if isinstance(kind, StringType):
            return WORD if kind.is_wide else BYTE
        if not isinstance(kind, ArrayType):
            self.report(INDEX_OF_NO_ARRAY, node, kind=_shown(kind))
            return None
        return self._element(node, kind)

    def _element(self, node: Index, kind: ArrayType) -> Type | None:
        """Return the type of an element; constant indices are compared with the bounds."""
        rest = node.indices
        if len(rest) != kind.dimensions:
            self.report(INDICES_COUNT, node, count=len(rest), expected=kind.dimensions)
            return None
        for index, (low, high) in zip(rest, kind.bounds, strict=False):
            value = index.value
            if isinstance(value, int) and not low <= value <= high:
                self.report(INDEX_OUTSIDE, index, index=value, low=low, high=high)
        element = kind.element
        return element.target if isinstance(element, ReferenceType) else element

    # --- literals ---------------------------------------------------------------------------------

    def _literal(self, node: Literal) -> Type | None:
        text = node.text
        if node.prefix:
            return self._typed_literal(node)
        first = text[0]
        if first.isdigit():
            value = integer(text)
            if value is not None:
                node.value = value
                if value >= 1 << _MAX_BITS:
                    self._too_large(node, value)
                    return None
                return UNTYPED
            number = real(text)
            if number is None:
                return self._wrong(node, "number")
            node.value = number
            return UNTYPED_REAL
        if first in "'\"":
            return self._string_literal(node, text)
        node.value = text.upper() == "TRUE"
        return BOOL

    def _too_large(self, node: Expression, value: int) -> None:
        self.report(
            CONSTANT_TOO_LARGE, node, number=value, low=LINT.low, high=UNTYPED.high, kind="LINT"
        )

    def _wrong(self, node: Literal, kind: str) -> Type | None:
        shown = f"{node.prefix}#{node.text}" if node.prefix else node.text
        self.report(LITERAL_WRONG, node, text=shown, kind=LITERAL_KINDS[kind])
        return None

    def _string_literal(self, node: Literal, text: str) -> Type | None:
        characters = string_value(text)
        if characters is None:
            return self._wrong(node, "string")
        if text[0] == '"':
            node.value = characters.encode("utf-16-le", errors="surrogatepass")
            return string(max(1, len(node.value) // 2), is_wide=True)
        if node.prefix == "UTF8":
            node.value = characters.encode("utf-8", errors="replace")
        else:
            try:
                node.value = characters.encode("latin-1")
            except UnicodeEncodeError:
                wrong = next(one for one in characters if ord(one) > 255)
                self.report(CHARACTER_NOT_IN_STRING, node, character=wrong)
                node.value = characters.encode("latin-1", errors="replace")
        return string(max(1, len(node.value)))

    def _typed_literal(self, node: Literal) -> Type | None:
        text, prefix = node.text, node.prefix
        if text[0] in "'\"":
            return self._string_literal(node, text)
        kind = LITERAL_PREFIXES.get(prefix)
        if kind is None:
            return self._enumeration_literal(node)
        value: int | float | None
        if kind.family is Family.DURATION:
            value = duration_ns(text)
            if value is not None and kind is TIME:
                value //= 1_000_000
        elif kind is TIME_OF_DAY:
            value = time_of_day_ms(text)
        elif kind in (DATE, DATE_AND_TIME):
            value = date_s(text, with_time=kind is DATE_AND_TIME)
        elif kind.family is Family.REAL:
            value = real(text)
        elif kind.family is Family.BOOL:
            value = {"0": 0, "1": 1, "TRUE": 1, "FALSE": 0}.get(text.upper())
        else:
            value = integer(text)
        if value is None:
            name = {Family.DURATION: "time", Family.DATE: "date"}.get(kind.family, "number")
            return self._wrong(node, name)
        if kind.family is Family.REAL:
            node.value = round_real(value) if kind is REAL else float(value)
            return kind
        if not kind.low <= value <= kind.high:
            self.report(
                CONSTANT_TOO_LARGE, node, number=value, low=kind.low, high=kind.high, kind=kind.name
            )
            return None
        node.value = bool(value) if kind is BOOL else int(value)
        return kind

    def _enumeration_literal(self, node: Literal) -> Type | None:
        """Return the enumeration of ``E_Color#Red``."""
        declared = self.names.find_type(node.prefix.lower(), self.scope.library)
        kind = None if declared is None else self.resolver.target_of(declared)
        if not isinstance(kind, EnumType) or node.text.lower() not in kind.values:
            return self._wrong(node, "number")
        node.value = kind.values[node.text.lower()].number
        return kind

    # --- operators --------------------------------------------------------------------------------

    def _unary(self, node: Unary) -> Type | None:
        kind = self.operand(node.operand)
        if kind is None:
            return None
        value = node.operand.value
        base = kind.base if isinstance(kind, EnumType) else kind
        family = base.family if isinstance(base, Elementary) else None
        if node.operator is Operator.NOT:
            if family is Family.BOOL or family in INTEGERS:
                assert isinstance(base, Elementary)
                if family is Family.BOOL:
                    node.value = None if value is None else not value
                    return BOOL
                if isinstance(value, int) and base is not UNTYPED:
                    node.value = ~value if base.is_signed else value ^ base.high
                elif isinstance(value, int):
                    base = smallest_bits(value)
                    self.settle(node.operand, base)
                    node.value = value ^ base.high
                return base
        elif family in NUMBERS or (family is Family.DURATION and node.operator is Operator.PLUS):
            assert isinstance(base, Elementary)
            if node.operator is Operator.PLUS:
                node.value = value
                return base
            if isinstance(value, int | float):
                node.value = -value
                if isinstance(node.value, int) and node.value < LINT.low:
                    self._too_large(node, node.value)
                    return None
            if base in (UNTYPED, UNTYPED_REAL) or family is Family.REAL:
                return base
            return signed(base)
        self.report(
            OPERATOR_ON_WRONG_TYPES,
            node,
            operator=node.operator.value.removeprefix("unary "),
            types=_shown(kind),
        )
        return None

    def _binary(self, node: Binary) -> Type | None:
        """Check a chain of operators from its innermost operand on, without recursion."""
        chain = [node]
        while isinstance(chain[-1].left, Binary):
            chain.append(chain[-1].left)
        left = self.operand(chain[-1].left)
        kind: Type | None = left
        for part in reversed(chain):
            part.value = None
            left = kind
            right = self.operand(part.right)
            kind = None if left is None or right is None else self._operation(part, left, right)
            part.type = kind
        return kind

    def _operation(self, node: Binary, left: Type, right: Type) -> Type | None:
        operator = node.operator
        if operator in _COMPARISONS:
            return self._comparison(node, left, right)
        if operator in _LOGICAL or operator in _SHORT:
            return self._logical(node, left, right)
        if operator is Operator.POWER and not self._is_plain_text(node):
            self.report(POWER_REFUSED, node)
            return None
        return self._arithmetic(node, left, right)

    def _is_plain_text(self, node: Expression) -> bool:
        piece = self.reporter.sources.piece_of(node.start)
        return piece is None or not piece.title

    def _common(self, node: Binary, left: Type, right: Type) -> Elementary | None:
        """Return the type in which two numbers meet, and settle literals into it."""
        first = left.base if isinstance(left, EnumType) else left
        second = right.base if isinstance(right, EnumType) else right
        if not (isinstance(first, Elementary) and isinstance(second, Elementary)):
            return None
        if first.family not in NUMBERS or second.family not in NUMBERS:
            return None
        kind = common_number(first, second, node.left.value, node.right.value)
        if kind not in (UNTYPED, UNTYPED_REAL):
            self._settle_into(node.left, kind) if first in (UNTYPED, UNTYPED_REAL) else None
            self._settle_into(node.right, kind) if second in (UNTYPED, UNTYPED_REAL) else None
        node.operand_type = kind
        return kind

    def _arithmetic(self, node: Binary, left: Type, right: Type) -> Type | None:
        kind = self._common(node, left, right)
        if kind is not None:
            if node.operator is Operator.MOD and kind.family is Family.REAL:
                return self._wrong_types(node, left, right)
            return self._fold(node, kind)
        other = self._moment(node, left, right) or self._pointer_sum(node, left, right)
        if other is None:
            return self._wrong_types(node, left, right)
        for side in (node.left, node.right):
            if side.type in (UNTYPED, UNTYPED_REAL):
                self._settle_into(side, DINT)
        node.operand_type = other
        if isinstance(node.left.value, int) and isinstance(node.right.value, int):
            if isinstance(other, Elementary) and node.operator in _FOLDED:
                node.value = _FOLDED[node.operator](node.left.value, node.right.value)
        return other

    def _wrong_types(self, node: Binary, left: Type, right: Type) -> Type | None:
        types = f"{_shown(left)}, {_shown(right)}"
        self.report(OPERATOR_ON_WRONG_TYPES, node, operator=node.operator.value, types=types)
        return None

    def _moment(self, node: Binary, left: Type, right: Type) -> Type | None:
        """Return the type of arithmetic with times: TIME ± TIME, DT − DT, TIME × number …"""
        if not isinstance(left, Elementary) or not isinstance(right, Elementary):
            return None
        operator, first, second = node.operator, left.family, right.family
        times = (Family.DURATION, Family.DATE)
        if first is Family.DURATION and second is Family.DURATION:
            return left if left.size >= right.size else right
        if first is Family.DATE and second is Family.DURATION:
            return left if operator in (Operator.ADD, Operator.SUBTRACT) else None
        if first is Family.DURATION and second is Family.DATE:
            return right if operator is Operator.ADD else None
        if first is Family.DATE and second is Family.DATE:
            return TIME if operator is Operator.SUBTRACT else None
        if first in times and second in NUMBERS:
            return left
        if first in NUMBERS and second in times:
            return right if operator in (Operator.MULTIPLY, Operator.ADD) else None
        return None

    def _pointer_sum(self, node: Binary, left: Type, right: Type) -> Type | None:
        """Return the type of pointer arithmetic: ``p + n``, ``p − q`` in bytes (ST-315)."""
        if node.operator not in (Operator.ADD, Operator.SUBTRACT):
            return None
        if isinstance(left, PointerType) and isinstance(right, PointerType):
            return LINT if node.operator is Operator.SUBTRACT else left
        if isinstance(left, PointerType) and _is_whole(right):
            return left
        if isinstance(right, PointerType) and _is_whole(left):
            return right
        return None

    def _fold(self, node: Binary, kind: Elementary) -> Type | None:
        """Compute a constant operation; report a division by zero, and an overflow."""
        first, second, operator = node.left.value, node.right.value, node.operator
        is_division = operator in (Operator.DIVIDE, Operator.MOD)
        if is_division and second == 0 and not isinstance(second, bytes | None):
            self.report(DIVISION_BY_CONSTANT_ZERO, node)
            return None
        if operator is Operator.POWER:
            return LREAL
        if not isinstance(first, int | float) or not isinstance(second, int | float):
            return kind
        if kind.family is Family.REAL:
            node.value = _real_result(operator, float(first), float(second), kind)
            return kind
        assert isinstance(first, int) and isinstance(second, int)
        if operator in _FOLDED:
            value = _FOLDED[operator](first, second)
        else:
            quotient = abs(first) // abs(second)
            quotient = quotient if (first < 0) is (second < 0) else -quotient
            value = quotient if operator is Operator.DIVIDE else first - quotient * second
        if not LINT.low <= value <= UNTYPED.high:
            self._too_large(node, value)
            return None
        node.value = value
        return kind

    def _logical(self, node: Binary, left: Type, right: Type) -> Type | None:
        if node.operator in _LOGICAL:
            self._check_brackets(node)
        for side, other in ((node.left, right), (node.right, left)):
            if side.type is UNTYPED and other is BOOL:
                self._settle_into(side, BOOL)
        first, second = node.left.type, node.right.type
        if _is_bool(first) and _is_bool(second):
            node.operand_type = BOOL
            one, two = node.left.value, node.right.value
            if isinstance(one, bool) and isinstance(two, bool):
                if node.operator in (Operator.AND, Operator.AND_THEN):
                    node.value = one and two
                elif node.operator is Operator.XOR:
                    node.value = one is not two
                else:
                    node.value = one or two
            return BOOL
        if node.operator in _LOGICAL:
            kind = self._common(node, left, right)
            if kind is not None and kind.family in INTEGERS:
                return self._fold(node, kind)
        return self._wrong_types(node, left, right)

    def _check_brackets(self, node: Binary) -> None:
        """Warn where XOR and OR meet without brackets (ST-501)."""
        pair = {Operator.OR: Operator.XOR, Operator.XOR: Operator.OR}.get(node.operator)
        for side in (node.left, node.right):
            if pair and isinstance(side, Binary) and side.operator is pair:
                piece = self.reporter.sources.piece_of(node.start)
                if piece is not None:
                    text = piece.text[: side.end - piece.base].rstrip()
                    closing = piece.text[side.end - piece.base : side.end - piece.base + 8].lstrip()
                    if not closing.startswith(")") and not text.endswith(")"):
                        self.report(PRECEDENCE_UNCLEAR, node)

    def _comparison(self, node: Binary, left: Type, right: Type) -> Type | None:
        if not self._are_comparable(node, left, right):
            for side in (node.left, node.right):
                if side.type in (UNTYPED, UNTYPED_REAL):
                    self._settle_into(side, DINT)
            self.report(TYPES_NOT_COMPARABLE, node, first=_shown(left), second=_shown(right))
            return None
        first, second = node.left.value, node.right.value
        if isinstance(first, int | float) and isinstance(second, int | float):
            node.value = _COMPARED[node.operator](first, second)
        elif isinstance(first, bytes) and isinstance(second, bytes):
            if node.operator in _EQUALITY:
                node.value = (first == second) is (node.operator is Operator.EQUAL)
        return BOOL

    def _are_comparable(self, node: Binary, left: Type, right: Type) -> bool:
        kind = self._common(node, left, right)
        if kind is not None:
            if kind is UNTYPED:
                self.settle(node.left, LINT)
                self.settle(node.right, LINT)
            elif kind is UNTYPED_REAL:
                self.settle(node.left, LREAL)
                self.settle(node.right, LREAL)
            families = {
                side.type.family
                for side in (node.left, node.right)
                if isinstance(side.type, Elementary)
            }
            if kind.family in INTEGERS and len(families) > 1 and Family.SIGNED in families:
                node.operand_type = None
            return True
        node.operand_type = left
        for side, kind_, other in ((node.left, left, right), (node.right, right, left)):
            if kind_ in (UNTYPED, UNTYPED_REAL):
                self._settle_into(side, other)
                node.operand_type = other
        match left, right:
            case Elementary(), Elementary():
                first, second = node.left.type, node.right.type
                assert isinstance(first, Elementary) and isinstance(second, Elementary)
                return first.family is second.family or {first.family, second.family} <= (
                    INTEGERS | {Family.DURATION, Family.DATE}
                )
            case StringType(), StringType():
                return left.is_wide == right.is_wide
            case EnumType(), EnumType():
                return True
        if isinstance(left, PointerType | InterfaceType) or isinstance(
            right, PointerType | InterfaceType
        ):
            return all(
                isinstance(one, PointerType | InterfaceType | BlockType) or _is_whole(one)
                for one in (left, right)
            )
        return node.operator in _EQUALITY and same_type(left, right)

    # --- initial values ---------------------------------------------------------------------------

    def initial(self, node: Expression, target: Type | None) -> Type | None:
        """Check an initial value: of an array, a structure, or any other (ST-403)."""
        if isinstance(target, ReferenceType):
            target = target.target
        if isinstance(node, ArrayInitial):
            node.type = target
            if target is None or is_unknown(target):
                for item in node.items:
                    self._loose(item)
            elif not isinstance(target, ArrayType):
                self.report(TYPE_MISMATCH, node, source="[…]", target=_shown(target))
            else:
                self._array_initial(node, target)
            return target
        if isinstance(node, StructInitial):
            node.type = target
            self._struct_initial(node, target)
            return target
        return self.converted(node, target)

    def _loose(self, item: Expression | Repetition) -> None:
        for value in item.values if isinstance(item, Repetition) else (item,):
            self.initial(value, None)

    def _array_initial(self, node: ArrayInitial, target: ArrayType) -> None:
        count = 0
        element: Type = target.element
        total = 1
        for low, high in target.bounds:
            total *= high - low + 1
        for index, written in enumerate(node.items):
            item = written
            if isinstance(item, Call):
                created = self._repetition(item)
                if created is not None:
                    node.items[index] = item = created
            if isinstance(item, Repetition):
                item.number = self._count(item.count)
                count += item.number * max(1, len(item.values))
                for value in item.values:
                    self.initial(value, element)
            else:
                count += 1
                self.initial(item, element)
        if target.bounds and count > total:
            self.report(INDEX_OUTSIDE, node, index=count, low=1, high=total)

    def _repetition(self, call: Call) -> Repetition | None:
        """Return ``N(0)`` with a constant N as a repetition."""
        callee = call.callee
        found: object = None
        if isinstance(callee, Name):
            key = callee.name.lower()
            found = self.scope.local_names.get(key) or self.scope.members.get(key)
            found = found or self.names.find(key, self.scope.library)
        elif isinstance(callee, Member):
            qualifier = self.qualifier(callee.base)
            if isinstance(qualifier, GlobalList):
                found = qualifier.variables.get(callee.name.lower())
        if not isinstance(found, Variable):
            return None
        values = [one.value for one in call.arguments if one.value is not None]
        return Repetition(call.start, call.end, call.callee, values)

    def _count(self, node: Expression) -> int:
        self.expression(node)
        if isinstance(node.value, int) and node.value >= 0:
            return node.value
        self.report(CONSTANT_EXPECTED, node)
        return 0

    def _struct_initial(self, node: StructInitial, target: Type | None) -> None:
        node.bound.clear()
        for argument in node.arguments:
            if argument.value is None:
                continue
            if target is None or is_unknown(target):
                self.initial(argument.value, None)
                continue
            found = self.member_of(target, argument.name.lower()) if argument.name else None
            if isinstance(found, Variable):
                self.resolver.complete(found)
                node.bound.append((found, argument.value))
                self.initial(argument.value, found.type)
            elif isinstance(found, Property):
                self.initial(argument.value, found.type)
            else:
                self.initial(argument.value, None)
                if self.resolver.is_incomplete(target):
                    continue
                names: list[str] = []
                if isinstance(target, StructType):
                    names = [one.name for one in target.members.values()]
                nearest = KnownNames(names).nearest(argument.name) or NOTHING
                self.reporter.report(
                    MEMBER_UNKNOWN,
                    argument.start,
                    argument.end,
                    name=argument.name or "–",
                    owner=_shown(target),
                    nearest=nearest,
                )


def common_number(
    first: Elementary, second: Elementary, one: object = None, two: object = None
) -> Elementary:
    """Return the type of an operation of two numbers; ``one``, ``two``: values of literals."""
    reals = [kind for kind in (first, second) if kind.family is Family.REAL]
    if reals:
        typed = [kind for kind in reals if kind is not UNTYPED_REAL]
        if not typed:
            is_typed = UNTYPED not in (first, second) and first is not second
            return LREAL if is_typed else UNTYPED_REAL
        return max(typed, key=lambda kind: kind.size)
    if first is UNTYPED and second is UNTYPED:
        return UNTYPED
    if UNTYPED in (first, second):
        typed_, value = (second, one) if first is UNTYPED else (first, two)
        if isinstance(value, int) and not typed_.low <= value <= typed_.high:
            return wider(typed_, smallest(value))
        return typed_
    return wider(first, second)


def _real_result(operator: Operator, first: float, second: float, kind: Elementary) -> float | None:
    if operator is Operator.DIVIDE:
        value = first / second
    elif operator is Operator.ADD:
        value = first + second
    elif operator is Operator.SUBTRACT:
        value = first - second
    elif operator is Operator.MULTIPLY:
        value = first * second
    else:
        return None
    return round_real(value) if kind is REAL else value


def _is_bool(kind: Type | None) -> bool:
    return isinstance(kind, Elementary) and kind.family is Family.BOOL


def _is_whole(kind: Type) -> bool:
    base = kind.base if isinstance(kind, EnumType) else kind
    return isinstance(base, Elementary) and base.family in INTEGERS


def _shown(kind: Type) -> str:
    return kind.name
