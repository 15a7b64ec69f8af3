# SPDX-License-Identifier: MIT
"""Places of variables while code is translated, and the nodes that read and write them."""

from __future__ import annotations

import enum
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st import kinds
from nctakt.kernel.st.reals import (
    LoadRealAt,
    LoadRealFixed,
    LoadRealFrame,
    LoadRealInstance,
    Real,
)
from nctakt.kernel.st.steps import (
    Step,
    StoreAt,
    StoreFixed,
    StoreFrame,
    StoreInstance,
    StoreRealAt,
    StoreRealFixed,
    StoreRealFrame,
    StoreRealInstance,
)
from nctakt.kernel.st.wholes import (
    AndBits,
    FramePlace,
    InstancePlace,
    LoadAt,
    LoadElement,
    LoadFixed,
    LoadFrame,
    LoadInstance,
    MemberPlace,
    MoveBits,
    Whole,
    WholeConstant,
)
from nctakt.st.types import Type
from nctakt.translation.layout import kind_of


class Origin(enum.Enum):
    """From where the offset of a location counts."""

    DATA = "data"
    FRAME = "frame"
    INSTANCE = "instance"
    COMPUTED = "computed"


@dataclass(frozen=True, slots=True)
class Location:
    """Where a value of a type lies; ``node`` computes the begin if it is not fixed.

    ``bit`` is the number of a bit in a whole number, or -1; ``element`` has the parts of ``node``
    if it computes the start of an element of an array.
    """

    origin: Origin
    offset: int
    type: Type
    node: Whole | None = None
    bit: int = -1
    element: tuple[Whole, Whole, int, int, int] | None = None

    def member(self, offset: int, member_type: Type, bit: int = -1) -> Location:
        """Return the location of a part of it."""
        return replace(self, offset=self.offset + offset, type=member_type, bit=bit)

    @property
    def kind(self) -> int:
        """How the value lies in memory."""
        kind = kind_of(self.type)
        if kind is None:
            raise TypeError(self.type.name)
        return kind

    @property
    def is_near(self) -> bool:
        """Whether it is read and written without a check: its offset is small."""
        return 0 <= self.offset <= kinds.SLACK - 8

    def address(self) -> Whole:
        """Return the node that computes the address."""
        match self.origin:
            case Origin.DATA:
                return WholeConstant(self.offset)
            case Origin.FRAME:
                return FramePlace(self.offset)
            case Origin.INSTANCE:
                return InstancePlace(self.offset)
        node = self.node or Whole()
        return MemberPlace(node, self.offset) if self.offset else node

    def load(self, data_end: int) -> Whole:
        """Return the node that reads a whole number, a truth or an address."""
        if self.bit >= 0:
            whole = replace(self, bit=-1).load(data_end)
            moved = MoveBits(whole, WholeConstant(self.bit), kinds.SHIFT_RIGHT, 64)
            return AndBits(moved, WholeConstant(1))
        if self.origin is Origin.DATA:
            return LoadFixed(self.offset, self.kind, data_end)
        if self.origin is Origin.FRAME and self.is_near:
            return LoadFrame(self.offset, self.kind)
        if self.origin is Origin.INSTANCE and self.is_near:
            return LoadInstance(self.offset, self.kind)
        if self.element is not None:
            return LoadElement(*self.element, self.offset, self.kind)
        if self.origin is Origin.COMPUTED and self.node is not None:
            return LoadAt(self.node, self.offset, self.kind)
        return LoadAt(self.address(), 0, self.kind)

    def load_real(self, data_end: int) -> Real:
        """Return the node that reads a real number."""
        if self.origin is Origin.DATA:
            return LoadRealFixed(self.offset, self.kind, data_end)
        if self.origin is Origin.FRAME and self.is_near:
            return LoadRealFrame(self.offset, self.kind)
        if self.origin is Origin.INSTANCE and self.is_near:
            return LoadRealInstance(self.offset, self.kind)
        if self.origin is Origin.COMPUTED and self.node is not None:
            return LoadRealAt(self.node, self.offset, self.kind)
        return LoadRealAt(self.address(), 0, self.kind)

    def store(self, value: Whole, source: int, cost: int, data_end: int) -> Step:
        """Return the statement that writes a whole number, a truth or an address."""
        if self.origin is Origin.DATA:
            return StoreFixed(self.offset, self.kind, value, source, cost, data_end)
        if self.origin is Origin.FRAME and self.is_near:
            return StoreFrame(self.offset, self.kind, value, source, cost)
        if self.origin is Origin.INSTANCE and self.is_near:
            return StoreInstance(self.offset, self.kind, value, source, cost)
        return StoreAt(self.address(), self.kind, value, source, cost)

    def store_real(self, value: Real, source: int, cost: int, data_end: int) -> Step:
        """Return the statement that writes a real number."""
        if self.origin is Origin.DATA:
            return StoreRealFixed(self.offset, self.kind, value, source, cost, data_end)
        if self.origin is Origin.FRAME and self.is_near:
            return StoreRealFrame(self.offset, self.kind, value, source, cost)
        if self.origin is Origin.INSTANCE and self.is_near:
            return StoreRealInstance(self.offset, self.kind, value, source, cost)
        return StoreRealAt(self.address(), self.kind, value, source, cost)
