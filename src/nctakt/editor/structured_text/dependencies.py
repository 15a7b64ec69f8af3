# SPDX-License-Identifier: MIT
"""Dependencies between files: names visible to others, and files affected by a change.

In: the declarations of files. Out: ``FileFacts``: the words of a file, and how each of its names is
declared, as text; the names that differ between two states; and all names whose meaning may have
changed with these. A member of an object counts where it is used as a member or argument, and in
objects that extend it; any other name counts wherever it occurs, whatever its meaning there. So
sometimes too much is rechecked, never too little.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.st.sources import Piece, Sources
from nctakt.st.tree import (
    Declaration,
    EnumNode,
    GlobalListNode,
    Header,
    InterfaceNode,
    MethodNode,
    PouNode,
    PropertyNode,
    StructNode,
    TypeDeclaration,
    VariableBlock,
    VariableNode,
)
from nctakt.st.types import Kind

WORD = re.compile(r"[^\W\d]\w*")
#: A word that can be a member, or the name of an argument.
_MEMBER = re.compile(r"[.(,]\s*([^\W\d]\w*)")
_COMMENT = re.compile(
    r"'(?:[^'$\n]|\$.)*'|\"(?:[^\"$\n]|\$.)*\"|//[^\n]*|\(\*.*?\*\)|/\*.*?\*/", re.DOTALL
)
#: Words whose value depends on the layout of a type, whose members need not be named.
_SIZES = ("sizeof", "xsizeof")
_PARAMETERS = ("VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT")

#: A name in lower case, and the object of which it is a member; "" for names of the project.
OwnedName = tuple[str, str]


@dataclass(frozen=True, slots=True)
class FileFacts:
    """The facts of a file: all in lower case.

    ``members``: words that can be members or arguments. ``declared``: how each name is declared;
    several objects may declare it. ``bases``: what each object extends.
    """

    words: frozenset[str]
    members: frozenset[str]
    declared: Mapping[OwnedName, tuple[str, ...]]
    bases: Mapping[str, tuple[str, ...]]


def facts_of(nodes: Sequence[Declaration], pieces: Iterable[Piece], sources: Sources) -> FileFacts:
    """Return the facts of a file."""
    text = _COMMENT.sub(" ", "\n".join(piece.text for piece in pieces).lower())
    found: dict[OwnedName, list[str]] = {}
    reader = _Reader(sources)
    for node in nodes:
        owner = "" if isinstance(node, GlobalListNode) else getattr(node, "name", "").lower()
        for name, declared, is_member in reader.names_of(node):
            key = (owner if is_member else "", name.lower())
            found.setdefault(key, []).append(declared.lower())
    return FileFacts(
        frozenset(WORD.findall(text)),
        frozenset(_MEMBER.findall(text)),
        {key: tuple(texts) for key, texts in found.items()},
        dict(_bases(node) for node in nodes if not isinstance(node, GlobalListNode)),
    )


def changed_names(before: FileFacts, now: FileFacts) -> set[OwnedName]:
    """Return the names that two states of a file declare otherwise."""
    first, second = before.declared, now.declared
    return {name for name in (*first, *second) if first.get(name) != second.get(name)}


class Concerned:
    """The files that a change of names concerns."""

    def __init__(self, changed: set[OwnedName], files: Sequence[FileFacts]) -> None:
        self._bases: dict[str, tuple[str, ...]] = {}
        for file in files:
            self._bases.update(file.bases)
        self._names: dict[str, set[str]] = {}
        waiting = [*changed, *(("", word) for word in _SIZES)] if changed else []
        users = self._users(files) if changed else {}
        while waiting:
            owner, name = waiting.pop()
            if owner in self._names.get(name, ()):
                continue
            self._names.setdefault(name, set()).add(owner)
            for key, is_member in users.get(name, ()):
                if not owner or is_member or owner in self._kin(key[0] or key[1]):
                    waiting.append(key)

    def _users(self, files: Iterable[FileFacts]) -> dict[str, set[tuple[OwnedName, bool]]]:
        """Return which names are declared by means of a word, and whether as of a member."""
        users: dict[str, set[tuple[OwnedName, bool]]] = {}
        for file in files:
            for key, texts in file.declared.items():
                for text in texts:
                    members = frozenset(_MEMBER.findall(text))
                    for word in WORD.findall(text):
                        users.setdefault(word, set()).add((key, word in members))
        return users

    def _kin(self, name: str) -> set[str]:
        """Return an object and all that it extends."""
        found = {name}
        waiting = [name]
        while waiting:
            for base in self._bases.get(waiting.pop(), ()):
                if base not in found:
                    found.add(base)
                    waiting.append(base)
        return found

    def __contains__(self, file: FileFacts) -> bool:
        """Whether a file uses a name that the change concerns."""
        for name in file.words & self._names.keys():
            owners = self._names[name]
            if "" in owners or name in file.members:
                return True
            if any(not owners.isdisjoint(self._kin(one)) for one in file.bases):
                return True
        return False


def _bases(node: Declaration) -> tuple[str, tuple[str, ...]]:
    bases = []
    if isinstance(node, PouNode):
        bases = [*node.interfaces, *([node.base] if node.base is not None else [])]
    elif isinstance(node, InterfaceNode):
        bases = node.bases
    elif isinstance(node, TypeDeclaration) and node.base is not None:
        bases = [node.base]
    name = getattr(node, "name", "").lower()
    return name, tuple(one.name.rpartition(".")[2].lower() for one in bases)


class _Reader:
    """Reads declarations as text: the text after a name, and its container."""

    def __init__(self, sources: Sources) -> None:
        self._sources = sources

    def names_of(self, node: Declaration) -> Iterator[tuple[str, str, bool]]:
        """Yield each name that an object declares, its text, and whether it is a member."""
        if isinstance(node, PouNode):
            yield node.name, f"{self._header(node)} {self._pou(node)}", False
            is_function = node.kind is Kind.FUNCTION
            yield from self._variables(node.variables, is_hidden=is_function)
            yield from self._members(node.methods, node.properties)
        elif isinstance(node, InterfaceNode):
            bases = " ".join(one.name for one in node.bases)
            yield node.name, f"INTERFACE {bases} {_member_names(node)}", False
            yield from self._members(node.methods, node.properties)
        elif isinstance(node, TypeDeclaration):
            yield from self._type(node)
        elif isinstance(node, GlobalListNode):
            title = f"{node.attributes.get('list', node.name)} {_attributes(node.attributes)}"
            yield title.partition(" ")[0], title, False
            for name, text, _ in self._variables(node.blocks):
                yield name, f"{title} {text}", False

    def _text(self, node: object) -> str:
        start, end = getattr(node, "start", 0), getattr(node, "end", 0)
        return self._sources.text(start, end) if start else ""

    def _header(self, node: Header) -> str:
        words = f"{node.access.value} {node.is_abstract} {node.is_final}"
        return f"{words} {_attributes(node.attributes)} {self._text(node.result)}"

    def _pou(self, node: PouNode) -> str:
        base = "" if node.base is None else node.base.name
        interfaces = " ".join(one.name for one in node.interfaces)
        parameters = " ".join(
            f"{block.keyword} {one.name}"
            for block in node.variables
            if block.keyword in _PARAMETERS
            for one in block.variables
        )
        kind = f"{node.kind.value} {node.language}"
        return f"{kind} EXTENDS {base} {interfaces} {parameters} {_member_names(node)}"

    def _variables(
        self, blocks: Iterable[VariableBlock], *, is_hidden: bool = False
    ) -> Iterator[tuple[str, str, bool]]:
        """Yield the variables of blocks; ``is_hidden``: those alone that a caller names."""
        for block in blocks:
            if is_hidden and block.keyword not in _PARAMETERS:
                continue
            keyword = f"{block.keyword} {' '.join(sorted(block.qualifiers))}"
            for one in block.variables:
                yield one.name, f"{keyword} {self._variable(one)}", True
                if isinstance(one.type, EnumNode):
                    yield from ((item.name, self._text(one.type), True) for item in one.type.items)

    def _variable(self, node: VariableNode) -> str:
        groups = (node.arguments or (), *node.element_arguments)
        arguments = " ".join(self._text(one) for group in groups for one in group)
        initial = self._text(node.initial)
        return (
            f"{self._text(node.type)} {initial} {arguments} {node.address} {node.is_bound} "
            f"{_attributes(node.attributes)}"
        )

    def _members(
        self, methods: Iterable[MethodNode], properties: Iterable[PropertyNode]
    ) -> Iterator[tuple[str, str, bool]]:
        for method in methods:
            parameters = list(self._variables(method.variables, is_hidden=True))
            listed = " ".join(f"{name} {text}" for name, text, _ in parameters)
            yield method.name, f"{self._header(method)} {method.is_action} {listed}", True
            yield from parameters
        for one in properties:
            accessors = f"{one.get is not None} {one.set is not None}"
            yield one.name, f"{self._header(one)} {accessors}", True

    def _type(self, node: TypeDeclaration) -> Iterator[tuple[str, str, bool]]:
        base = "" if node.base is None else node.base.name
        kind = node.type
        head = f"{type(kind).__name__} {base} {_attributes(node.attributes)}"
        if isinstance(kind, StructNode):
            yield node.name, f"{head} {kind.is_union}", False
            for member in kind.members:
                yield member.name, self._variable(member), True
            return
        text = f"{head} {self._text(kind)} {self._text(node.initial)}"
        yield node.name, text, False
        if isinstance(kind, EnumNode):
            for number, item in enumerate(kind.items):
                yield item.name, f"{node.name} {number} {text}", False


def _attributes(attributes: Mapping[str, str]) -> str:
    return " ".join(f"{key}={value}" for key, value in sorted(attributes.items()))


def _member_names(node: PouNode | InterfaceNode) -> str:
    methods = " ".join(f"{one.name} {one.is_abstract}" for one in node.methods)
    return f"{methods} {' '.join(one.name for one in node.properties)}"
