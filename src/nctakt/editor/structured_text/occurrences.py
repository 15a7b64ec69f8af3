# SPDX-License-Identifier: MIT
"""All names in the objects of a file, each with its target.

In: declarations whose expressions a checker has resolved. Out: ``Occurrence`` for each name: where
it is, its target (``nctakt.st.tree``), whether it is declared there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.st import tree
from nctakt.st.check.names import Scope
from nctakt.st.check.project import ProjectChecker
from nctakt.st.tree import Header, PouNode, Target, TypeNode, VariableNode
from nctakt.st.types import (
    EnumType,
    InterfaceType,
    Method,
    Node,
    Pou,
    Section,
    StructType,
    Type,
    Variable,
)

#: Fields with parts of a node, in the order of the text; the checker's notes are no parts.
_PARTS: dict[type[Node], tuple[str, ...]] = {
    tree.Bit: ("base",),
    tree.Index: ("base", "indices"),
    tree.Dereference: ("base",),
    tree.Unary: ("operand",),
    tree.Binary: ("left", "right"),
    tree.AssignmentExpression: ("target", "assigned"),
    tree.Repetition: ("count", "values"),
    tree.ArrayInitial: ("items",),
    tree.Assignment: ("target", "value"),
    tree.CallStatement: ("call",),
    tree.Evaluation: ("expression",),
    tree.Branch: ("condition", "body"),
    tree.If: ("branches", "otherwise"),
    tree.Label: ("low", "high"),
    tree.CaseBranch: ("labels", "body"),
    tree.Case: ("selector", "branches", "otherwise"),
    tree.For: ("counter", "first", "last", "step", "body"),
    tree.While: ("condition", "body"),
    tree.Repeat: ("body", "condition"),
}


@dataclass(frozen=True, slots=True, eq=False)
class Occurrence:
    """A name at a position; ``unit``: the path of the POU or member that it is in."""

    name: str
    start: int
    target: Target
    unit: str = ""
    is_definition: bool = False
    is_member: bool = False

    @property
    def end(self) -> int:
        """The position after it."""
        return self.start + len(self.name)


class OccurrenceReader:
    """Reads the names of objects; ``checker`` has resolved them."""

    def __init__(self, checker: ProjectChecker) -> None:
        self._checker = checker
        self._declared = checker.names.project.declared
        self._unit = ""
        self._scope = Scope()

    def of(self, nodes: Iterable[tree.Declaration]) -> list[Occurrence]:
        """Return all names of objects, by position."""
        found = [one for node in nodes for one in self._object(node)]
        return sorted(found, key=lambda one: one.start)

    def _object(self, node: tree.Declaration) -> Iterator[Occurrence]:
        name = getattr(node, "name", "")
        declared = self._declared.get(name.lower())
        target = declared.target if declared is not None and declared.node is node else None
        self._unit, self._scope = name, Scope(title=name)
        if isinstance(node, PouNode) and isinstance(target, Pou):
            yield self._defined(node, target)
            yield from self._pou(node, target)
        elif isinstance(node, tree.InterfaceNode) and isinstance(target, InterfaceType):
            yield self._defined(node, target)
            for base in node.bases:
                yield from self._type(base)
            yield from self._members(node, target)
        elif isinstance(node, tree.TypeDeclaration):
            if isinstance(target, Type):
                yield from self._declared_type(node, target)
        elif isinstance(node, tree.GlobalListNode):
            title = node.attributes.get("list", node.name)
            group = self._checker.names.project.lists.get(title.lower())
            variables = {} if group is None else group.variables
            self._scope = Scope("", variables, title=title)
            for block in node.blocks:
                yield from self._variables(block.variables, variables)

    def _defined(self, node: Header | tree.TypeDeclaration, target: Target) -> Occurrence:
        return Occurrence(node.name, node.start, target, self._unit, True)

    # --- declarations -----------------------------------------------------------------------------

    def _pou(self, node: PouNode, pou: Pou) -> Iterator[Occurrence]:
        for named in (*([node.base] if node.base else ()), *node.interfaces):
            yield from self._type(named)
        yield from self._inside(node, pou)
        yield from self._members(node, pou)

    def _members(
        self, node: PouNode | tree.InterfaceNode, owner: Pou | InterfaceType
    ) -> Iterator[Occurrence]:
        for member in node.methods:
            method = owner.methods.get(member.name.lower())
            if method is not None and method.start == member.start:
                self._unit = method.path
                yield self._defined(member, method)
                yield from self._inside(member, method)
        for item in node.properties:
            found = owner.properties.get(item.name.lower())
            if found is None or found.start != item.start:
                continue
            self._unit = f"{node.name}.{item.name}"
            yield self._defined(item, found)
            if item.result is not None:
                yield from self._type(item.result)
            for accessor, unit in ((item.get, found.get), (item.set, found.set)):
                if accessor is not None and unit is not None:
                    self._unit = unit.path
                    yield from self._inside(accessor, unit)

    def _inside(self, node: Header, unit: Pou | Method) -> Iterator[Occurrence]:
        """Yield the names of result, variables and statements."""
        entry = self._checker.resolver.nodes.get(unit)
        self._scope = Scope() if entry is None else entry[1]
        if node.result is not None:
            yield from self._type(node.result)
        for block in node.variables:
            yield from self._variables(block.variables, unit.variables, block.keyword)
        yield from self._all(node.body)

    def _variables(
        self, nodes: Iterable[VariableNode], variables: dict[str, Variable], keyword: str = ""
    ) -> Iterator[Occurrence]:
        last: TypeNode | None = None
        for node in nodes:
            variable = variables.get(node.name.lower())
            if variable is not None:
                is_external = keyword == "VAR_EXTERNAL"
                if is_external or variable.start == node.start:
                    yield Occurrence(node.name, node.start, variable, self._unit, not is_external)
            if node.type is last:
                continue  # a, b : INT
            last = node.type
            kind = None if variable is None else variable.type
            yield from self._type(node.type, kind)
            if node.initial is not None:
                yield from self._part(node.initial)
            for group in (node.arguments or (), *node.element_arguments):
                for argument in group:
                    yield from self._argument(argument, self._initializer(kind))

    def _initializer(self, kind: Type | None) -> dict[str, Variable]:
        while kind is not None and hasattr(kind, "element"):
            kind = kind.element
        pou = getattr(kind, "pou", None)
        method = pou.find_method("fb_init") if isinstance(pou, Pou) else None
        return {} if method is None else method.variables

    def _declared_type(self, node: tree.TypeDeclaration, target: Type) -> Iterator[Occurrence]:
        yield self._defined(node, target)
        if node.base is not None:
            yield from self._type(node.base)
        if isinstance(node.type, tree.StructNode) and isinstance(target, StructType):
            yield from self._variables(node.type.members, target.members)
        else:
            yield from self._type(node.type, target)
        if node.initial is not None:
            yield from self._part(node.initial)

    def _type(self, node: TypeNode, kind: Type | None = None) -> Iterator[Occurrence]:
        """Yield the names in a type; ``kind``: the resolved type."""
        match node:
            case tree.NamedType():
                target = self._named(node.name)
                if target is not None:
                    name = node.name.rpartition(".")[2]
                    yield Occurrence(name, node.end - len(name), target, self._unit)
            case tree.StringNode():
                yield from () if node.length is None else self._part(node.length)
            case tree.ArrayNode():
                for pair in node.bounds:
                    yield from () if pair is None else self._all(pair)
                yield from self._type(node.element, getattr(kind, "element", None))
            case tree.PointerNode():
                yield from self._type(node.target, getattr(kind, "target", None))
            case tree.SubrangeNode():
                yield from self._all((node.low, node.high))
            case tree.StructNode() if isinstance(kind, StructType):
                yield from self._variables(node.members, kind.members)
            case tree.EnumNode():
                yield from self._enumeration(node, kind)

    def _enumeration(self, node: tree.EnumNode, kind: Type | None) -> Iterator[Occurrence]:
        for item in node.items:
            value = kind.values.get(item.name.lower()) if isinstance(kind, EnumType) else None
            if value is not None:
                yield Occurrence(item.name, item.start, value, self._unit, True)
            if item.value is not None:
                yield from self._part(item.value)

    def _named(self, name: str) -> Target | None:
        """Return the declared type or POU of a name, with its library or without."""
        names, key = self._checker.names, name.lower()
        found = names.find_type(key, self._scope.library)
        if found is None and "." in key:
            found = names.find_type(key.rpartition(".")[2], self._scope.library)
        return None if found is None else self._checker.resolver.target_of(found)

    # --- statements and expressions ---------------------------------------------------------------

    def _all(self, nodes: Iterable[Node]) -> Iterator[Occurrence]:
        for node in nodes:
            yield from self._part(node)

    def _part(self, node: Node) -> Iterator[Occurrence]:
        """Yield the names in a statement or expression."""
        match node:
            case tree.Name():
                if node.target is not None:
                    start = node.end - len(node.name)
                    yield Occurrence(node.name, start, node.target, self._unit)
            case tree.Member():
                yield from self._part(node.base)
                if node.target is not None:
                    start = node.end - len(node.name)
                    yield Occurrence(node.name, start, node.target, self._unit, False, True)
            case tree.Call():
                yield from self._call(node)
            case tree.StructInitial():
                members = {one.name.lower(): one for one, _ in node.bound}
                for argument in node.arguments:
                    yield from self._argument(argument, members)
            case tree.TypeExpression():
                yield from self._type(node.node)
            case _:
                yield from self._all(parts_of(node))

    def _call(self, node: tree.Call) -> Iterator[Occurrence]:
        yield from self._part(node.callee)
        target = node.target
        parameters = {} if target is None else {one.name.lower(): one for one in target.parameters}
        if isinstance(target, Method) and target.is_action and target.owner is not None:
            parameters = {one.name.lower(): one for one in target.owner.parameters}
        if target is not None and target.result is not None:
            parameters.setdefault(target.result.name.lower(), target.result)
        for argument in node.arguments:
            yield from self._argument(argument, parameters)

    def _argument(
        self, node: tree.Argument, parameters: dict[str, Variable]
    ) -> Iterator[Occurrence]:
        found = parameters.get(node.name.lower()) if node.name else None
        if found is not None:
            yield Occurrence(node.name, node.start, found, self._unit, False, True)
        if node.value is not None:
            yield from self._part(node.value)


def parts_of(node: Node) -> Iterator[Node]:
    """Yield the statements and expressions in one, without their targets."""
    match node:
        case tree.Member():
            yield node.base
        case tree.Call():
            yield node.callee
            yield from (one.value for one in node.arguments if one.value is not None)
        case tree.StructInitial():
            yield from (one.value for one in node.arguments if one.value is not None)
    for name in _PARTS.get(type(node), ()):
        part = getattr(node, name)
        if isinstance(part, list):
            yield from part
        elif part is not None:
            yield part


def key_of(target: Target) -> object:
    """Return a key that all names of one target share.

    Within a function its name is that of the result, in a property that of the value.
    """
    start = getattr(target, "start", 0)
    return start or target


def is_parameter(target: object) -> bool:
    """Whether a target is a parameter of a call."""
    return isinstance(target, Variable) and target.section in (
        Section.INPUT,
        Section.OUTPUT,
        Section.IN_OUT,
    )
