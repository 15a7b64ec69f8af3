# SPDX-License-Identifier: MIT
"""Commands for the stage that shapes motions (``shapes/shaping.py``), which takes them itself."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.commands import Command


@dataclass(frozen=True, slots=True)
class ShapeCommand(Command):
    """A command that ends in the stage; ``span``: its block."""

    span: Span


@dataclass(frozen=True, slots=True)
class InsertCorner(ShapeCommand):
    """A chamfer or rounding between the motion before and the next one.

    ``word``: G301, G302, ``#CHR``, ``#CHF`` or ``#RND``; ``size`` in mm. ``feed`` in mm/s, 0: that
    of the motion before. ``has_own_feed``: it is given by ``#FRC``. ``of_block``: it belongs to the
    block of the motion before.
    """

    word: str
    size: float
    feed: float
    has_own_feed: bool
    of_block: bool

    @property
    def is_rounding(self) -> bool:
        """Whether it is a rounding, not a chamfer."""
        return self.word in ("G302", "#RND")


@dataclass(frozen=True, slots=True)
class ReleaseMotions(ShapeCommand):
    """The plane or the compensated contour changes: no motion waits for the next one.

    ``forgets``: no spline fits the motion before.
    """

    forgets: bool = False


#: Kinds of splines.
AKIMA, BSPLINE = "AKIMA", "BSPLINE"
#: How a spline begins and ends: by its vertices, as the neighbouring motion, by a vector.
AUTO, TANGENTIAL, USER = TRANSITIONS = ("AUTO", "TANGENTIAL", "USER")
#: Axes with their components of a vector.
Vector = tuple[tuple[int, float], ...]


@dataclass(frozen=True, slots=True)
class SplineBegin(ShapeCommand):
    """``#SPLINE ON``: the motions after it are vertices of a spline of this ``kind``.

    ``start``: how it begins, ``vector``: with which direction.
    """

    kind: str
    start: str
    vector: Vector


@dataclass(frozen=True, slots=True)
class SplineEnd(ShapeCommand):
    """``#SPLINE OFF``; ``end`` and ``vector`` as in ``SplineBegin``."""

    end: str
    vector: Vector


@dataclass(slots=True)
class SplineState:
    """The programmed state of splines; ``start_vector`` and ``end_vector`` by axis."""

    is_on: bool = False
    kind: str = AKIMA
    start: str = AUTO
    end: str = AUTO
    start_vector: Vector = ()
    end_vector: Vector = ()


@dataclass(slots=True)
class ShapeState:
    """The programmed state of shapes.

    ``waits_for_next``: a text of the program may insert chamfers or roundings, or splines that
    begin like the motion before. ``corner_size``: the last I of G301 or G302 in mm, 0 before the
    first. ``open_line``: the block of ``#ANG`` whose line the next block ends.
    """

    waits_for_next: bool = False
    corner_size: float = 0.0
    open_line: Span | None = None
    spline: SplineState = field(default_factory=SplineState)

    @property
    def holds_motions(self) -> bool:
        """Whether motions wait for the next one."""
        return self.waits_for_next or self.spline.is_on
