# SPDX-License-Identifier: MIT
"""The names of a project: their meaning, and the order of lookup (ST-203).

In: declared objects of the project and of libraries. Out: the target of a name. Names of the
project come before those of libraries, libraries in the order of their reference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from nctakt.base.dataclass import dataclass, field
from nctakt.st.files.libraries import OwnLibrary
from nctakt.st.tree import (
    GlobalList,
    InterfaceNode,
    Library,
    PouNode,
    Target,
    TypeDeclaration,
    VariableNode,
)
from nctakt.st.types import EnumValue, Expression, Pou, Type, Variable
from nctakt.st.vocabulary.libraries import declared_names, known, seen_words


@dataclass(slots=True, eq=False)
class Declared:
    """A declared type, POU or interface; ``target`` is set when it is looked up first.

    ``initial``: the initial value of a type, for variables that have none.
    """

    node: TypeDeclaration | PouNode | InterfaceNode
    library: str
    target: Type | Pou | None = None
    is_open: bool = False  # being resolved
    initial: Expression | None = None

    @property
    def name(self) -> str:
        """Its name as declared."""
        return self.node.name


@dataclass(slots=True, eq=False)
class Namespace:
    """The names of the project ("") or of one library; keys are in lower case."""

    library: str
    declared: dict[str, Declared] = field(default_factory=dict)
    lists: dict[str, GlobalList] = field(default_factory=dict)
    variables: dict[str, list[tuple[GlobalList, Variable]]] = field(default_factory=dict)
    values: dict[str, EnumValue] = field(default_factory=dict)
    is_read: bool = False


@dataclass(slots=True, eq=False)
class Ambiguous:
    """A name of variables in several lists."""

    found: list[tuple[GlobalList, Variable]]


@dataclass(slots=True, eq=False)
class Scope:
    """Where a body or declaration looks names up first; keys are in lower case.

    ``members`` are those of the instance: variables, methods, properties of the block and its
    bases. ``pou`` is the block, ``library`` the library that it is from.
    """

    library: str = ""
    local_names: Mapping[str, Target] = field(default_factory=dict)
    members: Mapping[str, Target] = field(default_factory=dict)
    pou: Pou | None = None
    title: str = ""


@dataclass(slots=True, eq=False)
class PendingVariable:
    """A variable whose type is resolved when it is first needed."""

    node: VariableNode
    scope: Scope


class Names:
    """All namespaces of a project."""

    def __init__(
        self, libraries: list[str], own: Mapping[str, OwnLibrary], beneath: Iterable[str] = ()
    ) -> None:
        self.project = Namespace("")
        self.own = own
        self.libraries = {name.lower(): Namespace(name) for name in libraries}
        for key, library in own.items():
            self.libraries.setdefault(key, Namespace(known(library.name) or library.name))
        #: Libraries that only libraries use.
        self.beneath = {
            name.lower(): Namespace(name) for name in beneath if name.lower() not in self.libraries
        }
        self._known: dict[str, Declared | Target | Ambiguous | None] = {}
        #: Enters the declarations of a library.
        self.load: Callable[[Namespace], None] = lambda space: None

    def spaces(self, library: str = "", name: str = "") -> Iterator[Namespace]:
        """Yield the namespaces in the order in which names are looked up.

        ``name``: only libraries that may have this name, which are read now.
        """
        if library:
            yield self.of_library(library)
        else:
            yield self.project
        beneath = self.beneath if library else {}
        for key, space in (*self.libraries.items(), *beneath.items()):
            if key == library.lower() or (name and name not in self._words(key, space)):
                continue
            self.read(space)
            yield space

    def of_library(self, name: str) -> Namespace:
        """Return the namespace of a library, "" for the project; ``KeyError`` if there is none."""
        if not name:
            return self.project
        return self.libraries.get(name.lower()) or self.beneath[name.lower()]

    def _words(self, key: str, space: Namespace) -> frozenset[str]:
        """Return words of a library's texts: all names that others see are among them."""
        own = self.own.get(key)
        text = self.text_of(space)
        words = seen_words(text) if text else frozenset()
        return words if own is None else own.words | words

    def text_of(self, space: Namespace) -> str:
        """Return the name of the known text that a library has; "" if it has none."""
        own = self.own.get(space.library.lower())
        return "" if own is not None and own.is_whole else known(space.library)

    def declared_names(self, space: Namespace) -> tuple[str, ...]:
        """Return the names of a library's objects, without reading it."""
        own, text = self.own.get(space.library.lower()), self.text_of(space)
        names = declared_names(text) if text else ()
        return names if own is None else (*own.declared_names, *names)

    def all_spaces(self) -> Iterator[Namespace]:
        """Yield the namespaces of the project and of all libraries."""
        yield from (self.project, *self.libraries.values(), *self.beneath.values())

    def read(self, space: Namespace) -> None:
        """Read a library, once."""
        if not space.is_read:
            space.is_read = True
            self.load(space)

    def find(self, name: str, library: str = "") -> Declared | Target | Ambiguous | None:
        """Return the meaning of a name in lower case outside POUs."""
        key = f"{library}\0{name}" if library else name
        try:
            return self._known[key]
        except KeyError:
            found = self._known[key] = self._find(name, library)
            return found

    def _find(self, name: str, library: str) -> Declared | Target | Ambiguous | None:
        for space in self.spaces(library, name):
            if (variables := space.variables.get(name)) is not None:
                return variables[0][1] if len(variables) == 1 else Ambiguous(variables)
            if (value := space.values.get(name)) is not None and name not in space.declared:
                return value
            if (declared := space.declared.get(name)) is not None:
                return declared
            if (found := space.lists.get(name)) is not None:
                return found
        prefix = name.removeprefix("__")
        seen = prefix in self.libraries or (library and prefix in self.beneath)
        return Library(self.of_library(prefix).library) if seen else None

    def find_type(self, name: str, library: str = "") -> Declared | None:
        """Return the declared type, POU or interface of a name in lower case."""
        for space in self.spaces(library, name):
            if (declared := space.declared.get(name)) is not None:
                return declared
        return None

    def all_names(self) -> Iterator[str]:
        """Yield all names that may come without a prefix; of libraries those of their objects."""
        for space in (self.project, *self.libraries.values()):
            if not space.is_read and space.library:
                yield from self.declared_names(space)
            yield from (declared.name for declared in space.declared.values())
            yield from (found[0][1].name for found in space.variables.values())
            yield from (value.name for value in space.values.values())
            yield from (one.name for one in space.lists.values() if one.name)
