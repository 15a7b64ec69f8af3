# SPDX-License-Identifier: MIT
"""The common base of all parts of a translated body: the project, the frame, the division of work.

The classes that translate locations, values, calls and statements derive from each other in that
order; methods of a later one that an earlier one needs are declared here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Protocol

from nctakt.kernel.st.calls import Callee, Routine
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.text.texts import StringPart
from nctakt.kernel.st.wholes import Whole
from nctakt.st.tree import Call, CallKind
from nctakt.st.types import (
    BlockType,
    Callable,
    Expression,
    InterfaceType,
    Node,
    Pou,
    ReferenceType,
    Type,
    Variable,
)
from nctakt.translation.layout import Layout, aligned
from nctakt.translation.locations import Location
from nctakt.translation.observing.noting import NoteRows
from nctakt.translation.observing.probing import Probes


class Frame:
    """Bytes of a frame that follow its variables; those of a statement are free after it."""

    def __init__(self, size: int) -> None:
        self._begin = aligned(size, 8)
        self._next = self._begin
        self.size = self._begin

    def take(self, count: int) -> int:
        """Return the offset of ``count`` bytes."""
        offset = self._next
        self._next += aligned(count, 8)
        self.size = max(self.size, self._next)
        return offset

    def release(self) -> None:
        """Free what the last statement has taken."""
        self._next = self._begin


class CannotRunError(Exception):
    """Valid code that does not run here: its place and its name."""

    def __init__(self, node: Node, what: str) -> None:
        super().__init__(what)
        self.node = node
        self.what = what


class Routines(Protocol):
    """The project as seen by a body: the routines of callees, and its memory."""

    layout: Layout
    #: The pointers to the CNC's interface that code uses.
    roots: set[str]
    #: The numbers of conditions and bodies that are counted, by identity.
    counted: Mapping[int, int]
    #: The notes about the project's code, if somebody wants to know why it acted.
    notes: NoteRows | None
    #: The probes of the project's code, while somebody debugs.
    probes: Probes | None

    def routine(self, called: Callable) -> Routine:
        """Return the routine of a function, method or body."""

    def shared_bytes(self, called: Callable) -> int:
        """Return the bytes of its frame that the caller fills."""

    def virtual(self, called: Callable, declared: Pou | InterfaceType) -> Callee:
        """Return the lookup of the routine by the type of the instance."""

    def types_of(self, declared: Pou | InterfaceType) -> list[tuple[int, int]]:
        """Return the ranges of the numbers of types that derive from it or implement it."""

    def exact(self, called: Callable, declared: Pou) -> Callee:
        """Return the routine that instances of exactly this type have."""

    def image_of_variable(self, variable: Variable) -> bytes:
        """Return the bytes of a variable as it begins."""

    def own_function(self, name: str) -> Pou | None:
        """Return a function of the project by its name in lower case."""

    def starter(self, pou: Pou) -> Routine:
        """Return the routine that begins the members of an instance."""

    def number_of(self, pou: Pou) -> int:
        """Return the number that an instance of a block begins with."""


class Body(ABC):
    """The state of a translation, and the services of its parts for each other."""

    def __init__(self, project: Routines, called: Callable, pou: Pou | None) -> None:
        self.project = project
        self.layout = project.layout
        self.called = called
        #: The block or program whose variables are seen; ``None`` in functions.
        self.pou = pou
        self.frame = Frame(called.frame_size)
        #: The notes about this code.
        known = project.notes
        self.notes = known if known is not None and id(called) in known.units else None
        #: The probes of this code, while somebody debugs it.
        probes = project.probes
        self.probes = probes if probes is not None and id(called) in probes.units else None
        #: The dereference that the assignment at work writes through.
        self.written: Expression | None = None
        #: Nodes of the statement at work: its cost.
        self.cost = 0

    @abstractmethod
    def whole(self, expression: Expression) -> Whole:
        """Return the node of a whole number, a truth or an address."""

    @abstractmethod
    def real(self, expression: Expression) -> Real:
        """Return the node of a real number; of a whole one converted."""

    @abstractmethod
    def text(self, expression: Expression) -> StringPart:
        """Return a text."""

    @abstractmethod
    def location(self, expression: Expression) -> Location:
        """Return where a variable, or a result that is kept, lies."""

    @abstractmethod
    def call_location(self, call: Call) -> Location:
        """Return where the result of a call is kept."""

    @abstractmethod
    def built_in(self, call: Call) -> Whole | Real | StringPart:
        """Return the node of a standard function."""

    @abstractmethod
    def assign(self, target: Location, value: Expression, source: int) -> Step:
        """Return the statement that assigns a value, converted where it widens."""

    def take_cost(self) -> int:
        """Return the number of nodes since the last statement, and restart counting."""
        cost, self.cost = max(self.cost, 1), 0
        return cost


def value_type(expression: Expression) -> Type:
    """Return the type of a value; for a reference that of its target."""
    found = expression.type
    if isinstance(found, ReferenceType):
        found = found.target
    if found is None:
        raise CannotRunError(expression, "an expression without a type")
    return found


def block_of(found: Type) -> Pou | InterfaceType | None:
    """Return the block or the interface that a type is."""
    if isinstance(found, BlockType):
        return found.pou
    return found if isinstance(found, InterfaceType) else None


def is_standard(call: Call) -> bool:
    """Return whether a call is one of a standard function or a conversion."""
    if call.kind is CallKind.FUNCTION:
        return call.target is not None and call.target.is_native
    return call.kind in (CallKind.BUILT_IN, CallKind.CONVERSION)
