# SPDX-License-Identifier: MIT
"""Declared types, variables and POUs -> resolved ones with their layout (ST-301 … 330, ST-401).

In: nodes of the tree, in any order: the requirements of a declaration are resolved first. Out:
``Type``, ``Variable`` and ``Pou`` objects. Circles are reported where they close.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Protocol

from nctakt.base.diagnostics import Message
from nctakt.messages.plcs.st_check import (
    ARRAY_BOUNDS_REVERSED,
    BASE_OF_WRONG_KIND,
    BIT_MISPLACED,
    BLOCK_BY_VALUE,
    DATA_CONTAIN_THEMSELVES,
    DATA_TOO_LARGE,
    ELEMENT_ARGUMENTS,
    EXTENDS_ITSELF,
    INTERFACE_UNKNOWN,
    MEMBER_REPEATED_IN_DERIVED,
    NAME_TWICE,
    OPEN_ARRAY_MISPLACED,
    OVERRIDE_OF_FINAL,
    REFERENCE_MISPLACED,
    TYPE_IS_ABSTRACT,
    TYPE_UNKNOWN,
)
from nctakt.messages.plcs.st_text import VARIABLES_EXPECTED
from nctakt.st.check.names import Declared, Names, Namespace, PendingVariable, Scope
from nctakt.st.reporting import Reporter
from nctakt.st.tree import (
    ArrayNode,
    EnumNode,
    GlobalList,
    GlobalListNode,
    Header,
    InterfaceNode,
    MethodNode,
    NamedType,
    PointerNode,
    PouNode,
    PropertyNode,
    StringNode,
    StructNode,
    SubrangeNode,
    Target,
    TypeDeclaration,
    TypeNode,
    VariableBlock,
    VariableNode,
)
from nctakt.st.types import (
    DEFAULT_LENGTH,
    MAX_ALIGN,
    POINTER_SIZE,
    AnyType,
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    EnumValue,
    Expression,
    InterfaceType,
    Kind,
    Method,
    Node,
    PointerType,
    Pou,
    Property,
    ReferenceType,
    Section,
    Storage,
    StructType,
    Type,
    Variable,
)
from nctakt.st.types import (
    Callable as CallableUnit,
)
from nctakt.st.vocabulary.elementary import BYTE, ELEMENTARY, INT, string
from nctakt.st.vocabulary.libraries import SYSTEM

#: Maximum size of a type in bytes; how much data a run may have is its own setting (ST-407).
MAX_DATA = 1 << 30
#: Maximum length of a STRING, and number of elements of an array.
MAX_LENGTH = 1 << 24

_SECTIONS = {
    "VAR": Section.VAR,
    "VAR_INPUT": Section.INPUT,
    "VAR_OUTPUT": Section.OUTPUT,
    "VAR_IN_OUT": Section.IN_OUT,
    "VAR_TEMP": Section.TEMP,
    "VAR_STAT": Section.STAT,
    "VAR_INST": Section.INST,
    "VAR_GLOBAL": Section.GLOBAL,
    "VAR_EXTERNAL": Section.EXTERNAL,
}
_PARAMETERS = frozenset((Section.INPUT, Section.OUTPUT, Section.IN_OUT))
_ANY = frozenset("ANY ANY_NUM ANY_INT ANY_REAL ANY_BIT ANY_STRING ANY_DATE".split())


class Evaluator(Protocol):
    """Requests of the resolver to the checker of expressions."""

    def constant(self, node: Expression, scope: Scope) -> int | None:
        """Return the value of a whole constant; ``None`` with a report for anything else."""

    def constant_of(self, variable: Variable, scope: Scope) -> None:
        """Set the value of a constant variable from its initial expression."""

    def enumeration_value(self, node: Expression, scope: Scope, kind: EnumType) -> int | None:
        """Return the value of an item of an enumeration."""

    def unknown(self, message: Message, name: str, start: int, end: int, scope: Scope) -> None:
        """Report a name that nothing declares."""


class Resolver:
    """Resolves the declarations of a project."""

    def __init__(self, names: Names, reporter: Reporter) -> None:
        self.names = names
        self.reporter = reporter
        self.evaluator: Evaluator
        self.blocks: list[Pou] = []
        self.pous: dict[str, Pou] = {}
        self.library_pous: list[Pou] = []
        #: Blocks and structures whose base is not known: missing members may be there.
        self._incomplete: set[Pou | StructType] = set()
        self.nodes: dict[Pou | Method, tuple[Header, Scope]] = {}
        self.data_size = POINTER_SIZE
        self.globals: list[Variable] = []
        #: Variables whose declarations are being read: they have no values yet.
        self.open_variables: set[Variable] = set()
        self._pending: dict[Variable, PendingVariable] = {}
        self._layouts: dict[Type, Callable[[], None]] = {}
        self._open_layouts: set[Type] = set()
        self._scopes: dict[Pou, Scope] = {}

    # --- looking up -------------------------------------------------------------------------------

    def complete(self, variable: Variable) -> None:
        """Resolve the type of a variable whose declaration has not been read yet."""
        pending = self._pending.pop(variable, None)
        if pending is not None:
            self.open_variables.add(variable)
            self._complete(variable, pending)
            self.open_variables.discard(variable)

    def pending(self) -> list[Variable]:
        """Return the variables whose declarations have not been read yet, in their order."""
        return list(self._pending)

    def target_of(self, declared: Declared) -> Type | Pou | None:
        """Return the type or POU of a declaration, resolving that declaration if necessary."""
        if declared.target is None and not declared.is_open:
            declared.is_open = True  # stays so if it is nested too deep
            self._resolve(declared)
            declared.is_open = False
        return declared.target

    def _report(self, message: Message, node: Node, **values: object) -> None:
        self.reporter.report(message, node.start, node.end, **values)

    # --- types ------------------------------------------------------------------------------------

    def type_of(self, node: TypeNode, scope: Scope) -> Type | None:
        """Return the type of a node; ``None`` with a report if there is none."""
        match node:
            case NamedType():
                return self._named(node, scope)
            case StringNode():
                return self._string(node, scope)
            case ArrayNode():
                return self._array(node, scope)
            case PointerNode():
                return self._pointer(node, scope)
            case SubrangeNode():
                return self._subrange(node, scope)
            case EnumNode():
                return self._enumeration(node, "", scope, {})
            case StructNode():
                return self._structure(node, "", None, scope, {})
        return None

    def _named(self, node: NamedType, scope: Scope) -> Type | None:
        upper = node.name.upper()
        if upper in ELEMENTARY:
            return ELEMENTARY[upper]
        if upper in _ANY:
            return self._any(upper)
        declared = self._declared(node.name.lower(), scope)
        if declared is None:
            self.evaluator.unknown(TYPE_UNKNOWN, node.name, node.start, node.end, scope)
            return None
        target = self.target_of(declared)
        return target.type if isinstance(target, Pou) else target

    def _any(self, name: str) -> AnyType:
        """Return ANY and the like: their form is declared in the text of the system (ST-620)."""
        self.names.read(self.names.libraries[SYSTEM.lower()])
        declared = self.names.find_type("anytype", SYSTEM)
        form = None if declared is None else self.target_of(declared)
        assert isinstance(form, StructType)
        self.layout(form, None)
        return AnyType(name, form.size, MAX_ALIGN, form)

    def _declared(self, name: str, scope: Scope) -> Declared | None:
        """Return the declaration of a type name, which may have its library before it."""
        declared = self.names.find_type(name, scope.library)
        if declared is None and "." in name:
            first, _, rest = name.rpartition(".")
            space = self.names.libraries.get(first.removeprefix("__"))
            if space is not None:
                self.names.read(space)
            declared = None if space is None else space.declared.get(rest)
            if declared is None and space is None:
                declared = self.names.find_type(rest, scope.library)
        return declared

    def initial_of(self, node: TypeNode, scope: Scope) -> Expression | None:
        """Return the initial value that a named type gives to its variables."""
        if isinstance(node, NamedType) and node.name.upper() not in ELEMENTARY:
            declared = self._declared(node.name.lower(), scope)
            return None if declared is None else declared.initial
        return None

    def _string(self, node: StringNode, scope: Scope) -> Type | None:
        length = DEFAULT_LENGTH
        if node.length is not None:
            found = self.evaluator.constant(node.length, scope)
            if found is None:
                return None
            length = found
            if not 0 < length <= MAX_LENGTH:
                self._report(DATA_TOO_LARGE, node, limit=MAX_LENGTH)
                return None
        return string(length, is_wide=node.is_wide)

    def _array(self, node: ArrayNode, scope: Scope) -> Type | None:
        element = self.type_of(node.element, scope)
        bounds: list[tuple[int, int]] = []
        count = 1
        for pair in node.bounds:
            if pair is None:
                continue
            low = self.evaluator.constant(pair[0], scope)
            high = self.evaluator.constant(pair[1], scope)
            if low is None or high is None:
                return None
            if high < low:
                self.reporter.report(
                    ARRAY_BOUNDS_REVERSED, pair[0].start, pair[1].end, low=low, high=high
                )
                return None
            count *= high - low + 1
            bounds.append((low, high))
        if element is None:
            return None
        if isinstance(element, ReferenceType) or (_is_bit(element)):
            self._report(REFERENCE_MISPLACED, node, kind=element.name)
            return None
        self.layout(element, node)
        size = count * element.size
        if size > MAX_DATA:
            self._report(DATA_TOO_LARGE, node, limit=MAX_DATA)
            return None
        shown = ", ".join(f"{low}..{high}" for low, high in bounds)
        shown = shown or ", ".join("*" for _ in node.bounds)
        name = f"ARRAY[{shown}] OF {element.name}"
        if not bounds:
            size = POINTER_SIZE * (1 + len(node.bounds))
        align = element.align if bounds else POINTER_SIZE
        return ArrayType(name, size, align, element, tuple(bounds), len(node.bounds))

    def _pointer(self, node: PointerNode, scope: Scope) -> Type | None:
        target = self.type_of(node.target, scope)
        if target is None:
            return None
        is_bit = _is_bit(target)
        if node.is_reference:
            if isinstance(target, ReferenceType) or is_bit:
                self._report(REFERENCE_MISPLACED, node, kind=target.name)
                return None
            name = f"REFERENCE TO {target.name}"
            return ReferenceType(name, POINTER_SIZE, POINTER_SIZE, target)
        if is_bit:
            self._report(REFERENCE_MISPLACED, node, kind=target.name)
            return None
        return PointerType(f"POINTER TO {target.name}", POINTER_SIZE, POINTER_SIZE, target)

    def _subrange(self, node: SubrangeNode, scope: Scope) -> Type | None:
        base = self.type_of(node.base, scope)
        low = self.evaluator.constant(node.low, scope)
        high = self.evaluator.constant(node.high, scope)
        if not isinstance(base, Elementary) or low is None or high is None:
            return base
        if not base.low <= low <= high <= base.high:
            self._report(ARRAY_BOUNDS_REVERSED, node, low=low, high=high)
            return base
        name = f"{base.name}({low}..{high})"
        return Elementary(name, base.size, base.align, base.family, low, high, is_subrange=True)

    def _enumeration(
        self, node: EnumNode, name: str, scope: Scope, attributes: Mapping[str, str]
    ) -> EnumType:
        base = None if node.base is None else self.type_of(node.base, scope)
        if not isinstance(base, Elementary) or base.high == base.low:
            base = INT
        shown = name or f"({', '.join(item.name for item in node.items)})"
        kind = EnumType(
            shown,
            base.size,
            base.align,
            base,
            is_strict="strict" in attributes,
            is_qualified_only="qualified_only" in attributes,
            has_text="to_string" in attributes,
        )
        self._fill_enumeration(kind, node, scope)
        return kind

    def _fill_enumeration(self, kind: EnumType, node: EnumNode, scope: Scope) -> None:
        number = 0
        inner = Scope(scope.library, {**scope.local_names}, scope.members, scope.pou, scope.title)
        names: dict[str, Target] = {**scope.local_names}
        inner.local_names = names
        for item in node.items:
            key = item.name.lower()
            if item.value is not None:
                found = self.evaluator.enumeration_value(item.value, inner, kind)
                number = number if found is None else found
            if key in kind.values:
                self.reporter.report(NAME_TWICE, item.start, item.end, name=item.name)
            value = EnumValue(item.name, number, kind)
            kind.values[key] = value
            names[key] = value
            number += 1
        kind.initial = next((value.number for value in kind.values.values()), 0)

    def _structure(
        self,
        node: StructNode,
        name: str,
        base: StructType | None,
        scope: Scope,
        attributes: Mapping[str, str],
        kind: StructType | None = None,
    ) -> StructType:
        if kind is None:
            kind = StructType(name or "STRUCT", 0, 1, base, {}, node.is_union)
        members = kind.members
        if base is not None:
            members.update(base.members)
        for member in node.members:
            key = member.name.lower()
            if key in members:
                message = MEMBER_REPEATED_IN_DERIVED if base and key in base.members else NAME_TWICE
                self._report(message, member, name=member.name)
                continue
            variable = Variable(
                member.name,
                BYTE,
                Section.MEMBER,
                Storage.MEMBER,
                start=member.start,
                owner=kind.name,
                address=member.address,
                attributes=member.attributes,
            )
            self._pending[variable] = PendingVariable(member, scope)
            members[key] = variable
        pack = attributes.get("pack_mode", "")
        limit = max(1, int(pack)) if pack in ("0", "1", "2", "4", "8") else MAX_ALIGN
        own = [
            member
            for member in members.values()
            if base is None or member not in base.members.values()
        ]
        self._layouts[kind] = lambda: self._lay_out_structure(kind, own, limit)
        return kind

    def _lay_out_structure(self, kind: StructType, own: list[Variable], limit: int) -> None:
        """Give the members their offsets (ST-312, ST-314, ST-330)."""
        offset, align, bit = 0, 1, 0
        if kind.base is not None:
            self.layout(kind.base, None)
            offset, align = kind.base.size, kind.base.align
        size = offset
        for member in own:
            self.complete(member)
            if _is_bit(member.type):
                end = _put_bit(member, 0, 0) if kind.is_union else _put_bit(member, size, bit)
                size, bit = max(size, end), bit + 1
                continue
            bit = 0
            self.layout(member.type, None, member.start)
            step = min(member.type.align, limit)
            align = max(align, step)
            member.offset = 0 if kind.is_union else _aligned(size, step)
            size = max(size, member.offset + member.type.size)
        kind.align = align
        kind.size = _aligned(size, align)
        if kind.size > MAX_DATA:
            kind.size = align

    def layout(self, kind: Type, node: TypeNode | VariableNode | None, start: int = 0) -> None:
        """Compute size and offsets of a type, once; report a circle at ``node`` or ``start``."""
        if kind in self._open_layouts:
            begin = start if node is None else node.start
            if begin:
                end = begin + 1 if node is None else node.end
                self.reporter.report(DATA_CONTAIN_THEMSELVES, begin, end, name=kind.name)
            return
        lay_out = self._layouts.pop(kind, None)
        if lay_out is not None:
            self._open_layouts.add(kind)
            lay_out()
            self._open_layouts.discard(kind)

    # --- declared types ---------------------------------------------------------------------------

    def declare(self, space: Namespace, nodes: Iterable[object]) -> None:
        """Enter the objects of the project or of a library."""
        for node in nodes:
            if isinstance(node, GlobalListNode):
                self._declare_list(space, node)
            elif isinstance(node, TypeDeclaration | PouNode | InterfaceNode):
                key = node.name.lower()
                if key in space.declared:
                    self.reporter.report(NAME_TWICE, node.start, node.end, name=node.name)
                    continue
                space.declared[key] = Declared(node, space.library)

    def declare_values(self, space: Namespace) -> None:
        """Enter the values of enumerations that need no qualifier."""
        for declared in list(space.declared.values()):
            if isinstance(declared.node, TypeDeclaration) and isinstance(
                declared.node.type, EnumNode
            ):
                kind = self.target_of(declared)
                if isinstance(kind, EnumType) and not kind.is_qualified_only:
                    for key, value in kind.values.items():
                        space.values.setdefault(key, value)
        for found in space.lists.values():
            for variable in found.variables.values():
                pending = self._pending.get(variable)
                if pending is not None and isinstance(pending.node.type, EnumNode):
                    self.complete(variable)

    def _declare_list(self, space: Namespace, node: GlobalListNode) -> None:
        title = node.attributes.get("list", node.name)
        key = title.lower()
        found = space.lists.get(key)
        if found is None or key:
            found = GlobalList(title, library=space.library)
            found.is_qualified_only = "qualified_only" in node.attributes
            if key or "" not in space.lists:
                space.lists[key] = found
        scope = Scope(space.library, found.variables, title=title)
        for block in node.blocks:
            for variable in block.variables:
                name = variable.name.lower()
                if name in found.variables:
                    self._report(NAME_TWICE, variable, name=variable.name)
                    continue
                created = self._variable(variable, block, Section.GLOBAL, title)
                self._pending[created] = PendingVariable(variable, scope)
                found.variables[name] = created
                self.globals.append(created)
                if not found.is_qualified_only:
                    space.variables.setdefault(name, []).append((found, created))

    def _variable(
        self, node: VariableNode, block: VariableBlock, section: Section, owner: str
    ) -> Variable:
        return Variable(
            node.name,
            BYTE,
            section,
            Storage.GLOBAL,
            start=node.start,
            owner=owner,
            address=node.address,
            is_constant="CONSTANT" in block.qualifiers,
            is_retain="RETAIN" in block.qualifiers,
            is_persistent="PERSISTENT" in block.qualifiers,
            attributes=node.attributes,
        )

    def _resolve(self, declared: Declared) -> None:
        node = declared.node
        scope = Scope(declared.library, title=node.name)
        if isinstance(node, PouNode):
            self._pou(declared, node, scope)
        elif isinstance(node, InterfaceNode):
            self._interface(declared, node, scope)
        elif isinstance(node.type, StructNode):
            self._declared_structure(declared, node, node.type, scope)
        elif isinstance(node.type, EnumNode):
            kind = self._enumeration(node.type, node.name, scope, node.attributes)
            declared.target = kind
            if node.initial is not None:
                inner = Scope(declared.library, dict(kind.values), title=node.name)
                found = self.evaluator.enumeration_value(node.initial, inner, kind)
                kind.initial = kind.initial if found is None else found
        else:
            declared.target = self.type_of(node.type, scope)
            declared.initial = node.initial or self.initial_of(node.type, scope)

    def _declared_structure(
        self, declared: Declared, node: TypeDeclaration, struct: StructNode, scope: Scope
    ) -> None:
        kind = StructType(node.name, 0, 1, None, {}, struct.is_union)
        declared.target = kind
        if node.base is not None:
            base = self.type_of(node.base, scope)
            if base is kind or (isinstance(base, StructType) and _extends(base, kind)):
                self._report(EXTENDS_ITSELF, node.base, name=node.name)
            elif isinstance(base, StructType):
                kind.base = base
            elif base is not None:
                self._report(BASE_OF_WRONG_KIND, node.base, name=node.base.name)
            if base is None or base in self._incomplete:
                self._incomplete.add(kind)
        self._structure(struct, node.name, kind.base, scope, node.attributes, kind)

    # --- POUs -------------------------------------------------------------------------------------

    def _interface(self, declared: Declared, node: InterfaceNode, scope: Scope) -> None:
        kind = InterfaceType(node.name, POINTER_SIZE, POINTER_SIZE)
        declared.target = kind
        for name in node.bases:
            base = self._declared(name.name.lower(), scope)
            target = None if base is None else self.target_of(base)
            if isinstance(target, InterfaceType) and target is not kind:
                if kind in _all_interfaces(target):
                    self._report(EXTENDS_ITSELF, name, name=node.name)
                    continue
                kind.bases.append(target)
            elif target is kind:
                self._report(EXTENDS_ITSELF, name, name=node.name)
            else:
                self.evaluator.unknown(INTERFACE_UNKNOWN, name.name, name.start, name.end, scope)
        for member in node.methods:
            method = self._method(member, None, scope, node.name)
            method.is_abstract = True
            kind.methods.setdefault(member.name.lower(), method)
        for item in node.properties:
            kind.properties.setdefault(
                item.name.lower(), self._property(item, None, scope, node.name)
            )

    def _pou(self, declared: Declared, node: PouNode, scope: Scope) -> None:
        pou = Pou(
            node.name,
            node.name,
            kind=node.kind,
            start=node.start,
            access=node.access,
            is_abstract=node.is_abstract,
            is_final=node.is_final,
            library=declared.library,
            is_native="native" in node.attributes,
            is_refused=node.language != "ST",
            attributes=node.attributes,
            body=node.body,
        )
        declared.target = pou
        self.pous.setdefault(node.name.lower(), pou)
        if declared.library:
            self.library_pous.append(pou)
        if node.kind is not Kind.FUNCTION:
            self.blocks.append(pou)
            pou.number = len(self.blocks)
            pou.type = BlockType(node.name, 0, MAX_ALIGN, pou)
            self._layouts[pou.type] = lambda: self._lay_out_block(pou)
        self._base(pou, node, scope)
        for name in node.interfaces:
            base = self._declared(name.name.lower(), scope)
            target = None if base is None else self.target_of(base)
            if isinstance(target, InterfaceType):
                pou.interfaces.append(target)
            else:
                self.evaluator.unknown(INTERFACE_UNKNOWN, name.name, name.start, name.end, scope)
        self._own_variables(pou, node, scope)
        for member in node.methods:
            key = member.name.lower()
            if key in pou.methods:
                self._report(NAME_TWICE, member, name=member.name)
                continue
            if member.is_action and key in pou.variables:
                self._report(NAME_TWICE, member, name=member.name)
            pou.methods[key] = self._method(member, pou, self._scopes[pou], node.name)
        for item in node.properties:
            key = item.name.lower()
            if key in pou.properties or key in pou.methods:
                self._report(NAME_TWICE, item, name=item.name)
                continue
            pou.properties[key] = self._property(item, pou, self._scopes[pou], node.name)
        self._enter_members(pou)
        self.nodes[pou] = (node, self._scopes[pou])

    def _base(self, pou: Pou, node: PouNode, scope: Scope) -> None:
        """Resolve the base of a block."""
        if node.base is None:
            return
        declared = self._declared(node.base.name.lower(), scope)
        if declared is None:
            self.evaluator.unknown(
                TYPE_UNKNOWN, node.base.name, node.base.start, node.base.end, scope
            )
            pou.is_refused = True
            self._incomplete.add(pou)
            return
        base = self.target_of(declared)
        if not isinstance(base, Pou) or base.kind is Kind.FUNCTION:
            self._report(BASE_OF_WRONG_KIND, node.base, name=node.base.name)
        elif pou in base.bases() or declared.is_open:
            self._report(EXTENDS_ITSELF, node.base, name=node.name)
        else:
            if base.is_final:
                self._report(OVERRIDE_OF_FINAL, node.base, name=base.name)
            pou.base = base

    def _own_variables(self, pou: Pou, node: PouNode, scope: Scope) -> None:
        """Make the variables of a POU; a function's are in its frame."""
        is_function = node.kind is Kind.FUNCTION
        members: dict[str, Target] = {}
        if pou.base is not None:
            pou.members.update(pou.base.members)
            pou.parameters += pou.base.parameters
            members.update(self.scope_of(pou.base).members)
        local_names: dict[str, Target] = {}
        inner = Scope(scope.library, local_names, members, pou, node.name)
        self._scopes[pou] = inner
        if node.result is not None:
            self._result(pou, node.result, node, inner)
            if pou.result is not None:
                local_names[node.name.lower()] = pou.result
        for block in node.variables:
            section = _SECTIONS.get(block.keyword)
            if section is None or section is Section.INST:
                self.reporter.report(
                    VARIABLES_EXPECTED, block.start, block.end, found=block.keyword
                )
                continue
            for variable in block.variables:
                self._own_variable(pou, variable, block, section, inner, is_function=is_function)
        for name, found in pou.variables.items():
            if is_function or found.section in (Section.TEMP, Section.EXTERNAL):
                local_names[name] = found
            else:
                members[name] = found

    def _own_variable(
        self,
        pou: Pou,
        node: VariableNode,
        block: VariableBlock,
        section: Section,
        scope: Scope,
        *,
        is_function: bool,
    ) -> None:
        key = node.name.lower()
        if key in pou.variables or key in pou.members:
            is_inherited = pou.base is not None and key in pou.base.members
            message = MEMBER_REPEATED_IN_DERIVED if is_inherited else NAME_TWICE
            self._report(message, node, name=node.name)
            return
        if section is Section.EXTERNAL:
            found = self.names.find(key, scope.library)
            if isinstance(found, Variable):
                pou.variables[key] = found
            else:
                self.evaluator.unknown(TYPE_UNKNOWN, node.name, node.start, node.end, scope)
            return
        variable = self._variable(node, block, section, pou.name)
        pou.variables[key] = variable
        self._pending[variable] = PendingVariable(node, scope)
        if section is Section.STAT or section is Section.GLOBAL:
            self.globals.append(variable)
        elif is_function or section is Section.TEMP:
            variable.storage = Storage.FRAME
        else:
            variable.storage = Storage.INSTANCE
            pou.members[key] = variable
        if section in _PARAMETERS:
            pou.parameters.append(variable)

    def _enter_members(self, pou: Pou) -> None:
        """Enter methods and properties into the names of the block."""
        members = self._scopes[pou].members
        assert isinstance(members, dict)
        members.update(pou.methods)
        members.update(pou.properties)

    def _result(self, unit: CallableUnit, node: TypeNode, header: Header, scope: Scope) -> None:
        unit.result = Variable(
            header.name,
            self.type_of(node, scope) or _UNKNOWN,
            Section.RESULT,
            Storage.FRAME,
            start=header.start,
            owner=unit.path,
            initial=self.initial_of(node, scope),
        )

    def _method(self, node: MethodNode, owner: Pou | None, scope: Scope, owner_name: str) -> Method:
        path = f"{owner_name}.{node.name}"
        method = Method(
            node.name,
            path,
            owner=owner,
            access=node.access,
            is_abstract=node.is_abstract,
            is_final=node.is_final,
            is_action=node.is_action,
            start=node.start,
            body=node.body,
            is_native=owner is not None and owner.is_native,
            attributes=node.attributes,
        )
        local_names: dict[str, Target] = {}
        if node.is_action:
            local_names.update(scope.local_names)
        inner = Scope(scope.library, local_names, scope.members, owner, path)
        if node.result is not None:
            self._result(method, node.result, node, inner)
            if method.result is not None:
                local_names[node.name.lower()] = method.result
        self._method_variables(method, node, inner, local_names)
        self.nodes[method] = (node, inner)
        return method

    def _method_variables(
        self, method: Method, node: MethodNode, scope: Scope, local_names: dict[str, Target]
    ) -> None:
        for block in node.variables:
            section = _SECTIONS.get(block.keyword, Section.VAR)
            for item in block.variables:
                key = item.name.lower()
                if key in method.variables:
                    self._report(NAME_TWICE, item, name=item.name)
                    continue
                if section is Section.EXTERNAL:
                    found = self.names.find(key, scope.library)
                    if isinstance(found, Variable):
                        local_names[key] = found
                    continue
                variable = self._variable(item, block, section, method.path)
                variable.storage = Storage.FRAME
                if section is Section.STAT:
                    variable.storage = Storage.GLOBAL
                    self.globals.append(variable)
                elif section is Section.INST and method.owner is not None:
                    variable.storage = Storage.INSTANCE
                    method.owner.members[f"{method.name}.{item.name}".lower()] = variable
                self._pending[variable] = PendingVariable(item, scope)
                method.variables[key] = variable
                local_names[key] = variable
                if section in _PARAMETERS:
                    method.parameters.append(variable)

    def _property(
        self, node: PropertyNode, owner: Pou | None, scope: Scope, owner_name: str
    ) -> Property:
        kind = None if node.result is None else self.type_of(node.result, scope)
        found = Property(
            node.name, kind or _UNKNOWN, owner=owner, access=node.access, start=node.start
        )
        for accessor, name in ((node.get, "Get"), (node.set, "Set")):
            if accessor is None:
                continue
            method = self._accessor(
                accessor, node, found, scope, f"{owner_name}.{node.name}.{name}"
            )
            method.is_abstract = owner is None or node.is_abstract
            if name == "Get":
                found.get = method
            else:
                found.set = method
        return found

    def _accessor(
        self,
        node: MethodNode,
        owner: PropertyNode,
        found: Property,
        scope: Scope,
        path: str,
    ) -> Method:
        method = Method(
            node.name,
            path,
            owner=found.owner,
            access=found.access if node.access.value == "PUBLIC" else node.access,
            is_final=owner.is_final,
            start=owner.start,
            body=node.body,
        )
        method.result = Variable(
            owner.name,
            found.type,
            Section.RESULT,
            Storage.FRAME,
            start=owner.start,
            owner=path,
            initial=None if owner.result is None else self.initial_of(owner.result, scope),
        )
        local_names: dict[str, Target] = {owner.name.lower(): method.result}
        inner = Scope(scope.library, local_names, scope.members, found.owner, path)
        self._method_variables(method, node, inner, local_names)
        self.nodes[method] = (node, inner)
        return method

    def _lay_out_block(self, pou: Pou) -> None:
        """Give the variables of an instance their offsets."""
        assert pou.type is not None
        offset, bit = POINTER_SIZE, 0
        inherited: set[Variable] = set()
        if pou.base is not None and pou.base.type is not None:
            self.layout(pou.base.type, None)
            offset = pou.base.type.size
            inherited.update(pou.base.members.values())
        for variable in pou.members.values():
            if variable in inherited:
                continue
            self.complete(variable)
            if _is_bit(variable.type):
                offset, bit = _put_bit(variable, offset, bit), bit + 1
                continue
            bit = 0
            size, align = self._slot(variable)
            variable.offset = _aligned(offset, align)
            offset = variable.offset + size
        pou.type.size = _aligned(offset, MAX_ALIGN)
        if pou.type.size > MAX_DATA:
            pou.type.size = MAX_ALIGN

    def _slot(self, variable: Variable) -> tuple[int, int]:
        """Return size and alignment of a variable where it is declared."""
        kind = variable.type
        if variable.section is Section.IN_OUT:
            is_open = isinstance(kind, ArrayType) and kind.is_open
            return (kind.size if is_open else POINTER_SIZE), POINTER_SIZE
        self.layout(kind, None, variable.start)
        return kind.size, max(1, kind.align)

    def lay_out_frame(self, unit: CallableUnit) -> None:
        """Give the variables of a call's frame their offsets: the result first."""
        offset = 0
        frame = [unit.result] if unit.result is not None else []
        frame += [one for one in unit.variables.values() if one.storage is Storage.FRAME]
        for variable in frame:
            self.complete(variable)
            size, align = self._slot(variable)
            variable.offset = _aligned(offset, align)
            offset = variable.offset + size
        unit.frame_size = _aligned(offset, MAX_ALIGN)

    def lay_out_globals(self) -> None:
        """Give global variables and programs their offsets in the data area."""
        for variable in self.globals:
            self.complete(variable)
            size, align = self._slot(variable)
            variable.offset = self._allocate(size, align, variable.start)
        for pou in self.blocks:
            if pou.type is not None:
                self.layout(pou.type, None)
                if pou.kind is Kind.PROGRAM:
                    pou.instance = self._allocate(pou.type.size, MAX_ALIGN, pou.start)

    def _allocate(self, size: int, align: int, start: int) -> int:
        offset = _aligned(self.data_size, align)
        if offset + size > MAX_DATA:
            self.reporter.report(DATA_TOO_LARGE, start, start + 1, limit=MAX_DATA)
            return POINTER_SIZE
        self.data_size = offset + size
        return offset

    # --- variables --------------------------------------------------------------------------------

    def _complete(self, variable: Variable, pending: PendingVariable) -> None:
        node, scope = pending.node, pending.scope
        kind = self.type_of(node.type, scope)
        if isinstance(node.type, EnumNode) and isinstance(kind, EnumType):
            if variable.section is Section.GLOBAL:
                names: object = self.names.of_library(scope.library).values
            else:
                names = scope.local_names if scope.pou is None else scope.members
            if isinstance(names, dict):
                for key, value in kind.values.items():
                    names.setdefault(key, value)
        if kind is None:
            variable.type = _UNKNOWN
            return
        if isinstance(kind, ArrayType) and kind.is_open and variable.section is not Section.IN_OUT:
            self._report(OPEN_ARRAY_MISPLACED, node)
            variable.type = _UNKNOWN
            return
        is_packed = variable.storage in (Storage.MEMBER, Storage.INSTANCE)
        if _is_bit(kind) and (not is_packed or variable.section is Section.IN_OUT):
            self._report(BIT_MISPLACED, node)
            variable.type = _UNKNOWN
            return
        variable.type = kind
        variable.initial = node.initial or self.initial_of(node.type, scope)
        if isinstance(kind, BlockType):
            self._check_instance(variable, kind, node)
        if variable.section is not Section.IN_OUT:
            self.layout(kind, node)
        if variable.is_constant and variable.initial is not None:
            self.evaluator.constant_of(variable, scope)
        groups = [node.arguments] if node.arguments else node.element_arguments
        number = variable.type.element_count if isinstance(variable.type, ArrayType) else 1
        if len(groups) > 1 and len(groups) != number:
            self._report(ELEMENT_ARGUMENTS, node, name=node.name, number=number, count=len(groups))
        variable.arguments = [
            [(one.name, one.value) for one in group if one.value is not None] for group in groups
        ]

    def _check_instance(self, variable: Variable, kind: BlockType, node: VariableNode) -> None:
        if variable.section is Section.INPUT:
            self._report(BLOCK_BY_VALUE, node, name=node.name)
        if kind.pou.is_abstract and variable.section is not Section.IN_OUT:
            self._report(TYPE_IS_ABSTRACT, node, name=kind.name)

    def is_incomplete(self, kind: Pou | Type | None) -> bool:
        """Whether a block or structure has a base that is not known."""
        if isinstance(kind, BlockType):
            kind = kind.pou
        if isinstance(kind, Pou):
            return any(one in self._incomplete for one in kind.bases())
        return isinstance(kind, StructType) and kind in self._incomplete

    def scope_of(self, pou: Pou) -> Scope:
        """Return the names that bodies and members of a block see."""
        return self._scopes.get(pou) or Scope()


#: The type of a declaration with a mistake: nothing is reported about it again.
_UNKNOWN = Type("?", 1, 1)


def is_unknown(kind: Type | None) -> bool:
    """Whether a type is not known because of a mistake elsewhere."""
    return kind is None or kind is _UNKNOWN


def _aligned(offset: int, align: int) -> int:
    return (offset + align - 1) // align * align if align > 1 else offset


def _is_bit(kind: Type) -> bool:
    return isinstance(kind, Elementary) and kind.is_bit


def _put_bit(variable: Variable, end: int, bit: int) -> int:
    """Give a bit its position after others, eight in a byte (ST-312); return the end."""
    if bit % 8 == 0:
        end += 1
    variable.offset, variable.bit = end - 1, bit % 8
    return end


def _extends(kind: StructType, base: StructType) -> bool:
    """Whether a structure is or extends another one."""
    found: StructType | None = kind
    while found is not None:
        if found is base:
            return True
        found = found.base
    return False


def _all_interfaces(kind: InterfaceType) -> list[InterfaceType]:
    """Return an interface with all that it extends."""
    found = [kind]
    for base in found:
        found += [one for one in base.bases if one not in found]
    return found
