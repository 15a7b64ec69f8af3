# SPDX-License-Identifier: MIT
"""Completion at a place of Structured Text.

In: the names of a project, the surroundings of the cursor. Out: members after a point; types after
a colon; otherwise names visible in the scope, the nearest first, preceded by the parameters of an
open call. Nothing in comments, pragmas and texts.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lsprotocol.types import CompletionItem, CompletionItemKind, Position, TextEdit

from nctakt.editor.document import Document
from nctakt.editor.structured_text.descriptions import declaration_of, signature_of
from nctakt.editor.structured_text.positions import position_at
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.editor.structured_text.surroundings import Surroundings, surroundings
from nctakt.st.check.names import Namespace, Scope
from nctakt.st.tree import Call, Dereference, GlobalList, Library, Super, This
from nctakt.st.types import (
    Access,
    AnyType,
    BlockType,
    Callable,
    EnumType,
    EnumValue,
    Expression,
    InterfaceType,
    Kind,
    Method,
    PointerType,
    Pou,
    Property,
    Section,
    StructType,
    Type,
    Variable,
)
from nctakt.st.vocabulary.elementary import ELEMENTARY
from nctakt.st.vocabulary.functions import BUILT_INS

#: Maximum number of items; a longer list is no help.
MAX_ITEMS = 1500

_STATEMENTS = (
    "IF THEN ELSIF ELSE END_IF CASE OF END_CASE FOR TO BY DO END_FOR WHILE END_WHILE REPEAT UNTIL "
    "END_REPEAT EXIT CONTINUE RETURN AND OR XOR NOT MOD AND_THEN OR_ELSE TRUE FALSE THIS SUPER"
).split()
_OBJECTS = (
    "PROGRAM END_PROGRAM FUNCTION END_FUNCTION FUNCTION_BLOCK END_FUNCTION_BLOCK INTERFACE "
    "END_INTERFACE TYPE END_TYPE METHOD END_METHOD PROPERTY END_PROPERTY ACTION END_ACTION EXTENDS "
    "IMPLEMENTS ABSTRACT FINAL PUBLIC PRIVATE PROTECTED INTERNAL VAR VAR_INPUT VAR_OUTPUT "
    "VAR_IN_OUT VAR_TEMP VAR_STAT VAR_INST VAR_GLOBAL END_VAR CONSTANT RETAIN PERSISTENT"
).split()
_NAMES = "END_VAR END_STRUCT END_UNION CONSTANT RETAIN PERSISTENT".split()
_TYPES = "ARRAY OF POINTER REFERENCE TO STRING WSTRING STRUCT UNION AT".split()
_VALUES = ("TRUE", "FALSE", "NOT")

_Items = Iterator[tuple[str, CompletionItemKind, str]]


def complete(names: ProjectNames, document: Document, position: Position) -> list[CompletionItem]:
    """Return the completions at a position, the best first."""
    file = names.project.file_named(document.name)
    spot = None if file is None else position_at(document, position, file)
    if spot is None:
        return []
    piece, offset = spot
    around = surroundings(piece.text, offset, piece.title, is_declaration=piece.is_declaration)
    if around.part == "nothing":
        return []
    found = _items(names, around)
    index = document.index(position)
    area = document.range(position.line, index - len(around.word), index)
    items: dict[str, CompletionItem] = {}
    word = around.word.lower()
    for label, kind, detail in found:
        if not label.lower().startswith(word[:1]) or label.lower() in items:
            continue
        items[label.lower()] = CompletionItem(
            label,
            kind=kind,
            detail=detail or None,
            text_edit=TextEdit(area, label),
            filter_text=label,
            sort_text=f"{len(items):05}",
        )
        if len(items) >= MAX_ITEMS:
            break
    return list(items.values())


def _items(names: ProjectNames, around: Surroundings) -> _Items:
    scope = names.scope_of(around.unit)
    if around.path:
        yield from _after_point(names, around, scope)
    elif around.part == "name":
        yield from _words(_NAMES)
    elif around.part == "object":
        yield from _words(_OBJECTS)
    elif around.part == "type":
        yield from _types(names, scope)
    else:
        if around.callee:
            yield from _parameters(names, around, scope)
        if around.part == "initial":
            yield from _words(_VALUES)
        yield from _scope(scope)
        yield from _globals(names)
        if around.part == "statement":
            yield from _words(_STATEMENTS)
        yield from _functions(names)


def _words(words: Iterable[str]) -> _Items:
    for word in words:
        yield word, CompletionItemKind.Keyword, ""


def item_of(target: object) -> tuple[str, CompletionItemKind, str] | None:
    """Return name, kind and detail of a target, ``None`` for one without a name."""
    match target:
        case Variable():
            kind = (
                CompletionItemKind.Constant if target.is_constant else CompletionItemKind.Variable
            )
            if target.section is Section.MEMBER:
                kind = CompletionItemKind.Field
            return target.name, kind, target.type.name
        case Property():
            return target.name, CompletionItemKind.Property, target.type.name
        case EnumValue():
            return target.name, CompletionItemKind.EnumMember, f"{target.type.name} {target.number}"
        case Pou(kind=Kind.FUNCTION_BLOCK):
            return target.name, CompletionItemKind.Class, target.kind.value
        case Pou(kind=Kind.PROGRAM):
            return target.name, CompletionItemKind.Module, target.kind.value
        case Callable():
            is_method = isinstance(target, Method)
            kind = CompletionItemKind.Method if is_method else CompletionItemKind.Function
            return target.name, kind, signature_of(target)
        case EnumType():
            return target.name, CompletionItemKind.Enum, declaration_of(target)[:120]
        case InterfaceType():
            return target.name, CompletionItemKind.Interface, ""
        case Type():
            return target.name, CompletionItemKind.Struct, ""
        case GlobalList():
            return target.name, CompletionItemKind.Module, "VAR_GLOBAL"
    return None


def _shown(targets: Iterable[object]) -> _Items:
    for target in targets:
        found = item_of(target)
        if found is not None and found[0]:
            yield found


def _scope(scope: Scope) -> _Items:
    """Yield the names of the unit itself, then those of its block."""
    yield from _shown(scope.local_names.values())
    yield from _shown(scope.members.values())


def _globals(names: ProjectNames) -> _Items:
    """Yield global variables, values of enumerations, programs, lists, types of the project."""
    space = names.checker.names.project
    yield from _shown(found[0][1] for found in space.variables.values())
    yield from _shown(one for key, one in space.lists.items() if key)
    yield from _shown(space.values.values())
    yield from _shown(
        names.target_of(declared)
        for declared in space.declared.values()
        if not isinstance(declared.target, InterfaceType)
    )


def _functions(names: ProjectNames) -> _Items:
    """Yield the functions for many types, and the names of libraries."""
    for name in BUILT_INS:
        yield name, CompletionItemKind.Function, ""
    for space in names.checker.names.libraries.values():
        yield from _of_library(names, space)


def _of_library(names: ProjectNames, space: Namespace) -> _Items:
    for name in names.checker.names.declared_names(space):
        if not name.startswith("__"):
            yield name, CompletionItemKind.Function, space.library


def _types(names: ProjectNames, scope: Scope) -> _Items:
    """Yield possible types of a variable."""
    for declared in names.checker.names.project.declared.values():
        target = names.target_of(declared)
        if not (isinstance(target, Pou) and target.kind is not Kind.FUNCTION_BLOCK):
            yield from _shown((target,))
    for name in ELEMENTARY:
        yield name, CompletionItemKind.Keyword, ""
    yield from _words(_TYPES)
    for space in names.checker.names.libraries.values():
        for label, _, detail in _of_library(names, space):
            yield label, CompletionItemKind.Class, detail
    yield from _shown(one for one in scope.local_names.values() if _is_constant(one))


def _is_constant(target: object) -> bool:
    return isinstance(target, Variable) and target.is_constant


def _parameters(names: ProjectNames, around: Surroundings, scope: Scope) -> _Items:
    """Yield the parameters of the open call, written with their sign."""
    called = called_unit(names, around.callee, scope)
    if called is None or around.named:
        return
    for one in called.parameters:
        sign = "=>" if one.section is Section.OUTPUT else ":="
        yield f"{one.name} {sign} ", CompletionItemKind.Field, one.type.name


def called_unit(names: ProjectNames, callee: str, scope: Scope) -> Callable | None:
    """Return the callee of a written expression."""
    node = names.expression(f"{callee}()", scope)
    target = node.target if isinstance(node, Call) else None
    if isinstance(target, Method) and target.is_action:
        return target.owner
    return target


# --- after a point -------------------------------------------------------------------------------


def _after_point(names: ProjectNames, around: Surroundings, scope: Scope) -> _Items:
    node = names.expression(around.path, scope)
    if node is None:
        return
    qualifier = names.qualifier(node, scope)
    if isinstance(qualifier, GlobalList):
        yield from _shown(qualifier.variables.values())
    elif isinstance(qualifier, EnumType):
        yield from _shown(qualifier.values.values())
    elif isinstance(qualifier, Library):
        space = names.checker.names.libraries.get(qualifier.name.lower())
        if space is not None:
            yield from _of_library(names, space)
    elif node.type is not None:
        is_own = isinstance(node, Dereference) and isinstance(node.base, This | Super)
        yield from _members(names, node.type, scope, is_own=is_own, node=node)
    elif isinstance(qualifier, Pou):
        yield from _shown(one for one in qualifier.variables.values() if one.is_constant)


def _members(
    names: ProjectNames, kind: Type, scope: Scope, *, is_own: bool, node: Expression
) -> _Items:
    """Yield the members of a type that may be used in a scope."""
    if isinstance(kind, StructType | AnyType):
        members = kind.form.members if isinstance(kind, AnyType) else kind.members
        yield from _shown(members.values())
    elif isinstance(kind, BlockType):
        for target in names.checker.resolver.scope_of(kind.pou).members.values():
            if is_own or _is_accessible(target, kind.pou, scope):
                yield from _shown((target,))
    elif isinstance(kind, InterfaceType):
        waiting = [kind]
        for one in waiting:
            waiting += [base for base in one.bases if base not in waiting]
            yield from _shown((*one.methods.values(), *one.properties.values()))
    elif isinstance(kind, PointerType) and kind.target is not None and isinstance(node, This):
        yield from _members(names, kind.target, scope, is_own=True, node=node)


def _is_accessible(target: object, owner: Pou, scope: Scope) -> bool:
    own = scope.pou
    is_related = own is not None and (owner in own.bases() or own in owner.bases())
    if isinstance(target, Method | Property):
        return target.access in (Access.PUBLIC, Access.INTERNAL) or is_related
    if isinstance(target, Variable):
        return "." not in target.owner and target.section not in (Section.TEMP, Section.INST)
    return not isinstance(target, EnumValue)
