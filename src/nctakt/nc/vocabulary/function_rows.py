# SPDX-License-Identifier: MIT
"""Rows of the table of G and M functions (``functions.py``): their fields and constructors."""

from __future__ import annotations

import enum
from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.nc.vocabulary.entries import (
    ACCEPTED,
    NOTHING_INSTEAD,
    REFUSED,
    SIMULATED,
    Entry,
    Kind,
)


class Group(enum.Enum):
    """Modal groups: one function of each is active, and only one may appear in a block."""

    MOTION = "motion"
    FEED_ADAPTATION = "feed adaptation"
    PLANE = "plane"
    MIRROR = "mirror"
    ROTATION = "rotation"
    TRANSITION = "transition"
    COMPENSATION = "compensation"
    ZERO_OFFSET = "zero offset"
    UNIT = "unit"
    DIMENSION = "dimension"
    FEED = "feed"
    CUTTING = "cutting"
    DIAMETER = "diameter"
    EDGE_BANDING = "edge banding"
    APPROACH = "approach"
    MASKING = "masking"
    ARC_CENTRE = "arc centre"
    CENTRE_CORRECTION = "centre correction"
    SPLINE = "spline"
    CONTOURING = "contouring"
    EXACT_STOP = "exact stop"
    AXIS_VALUES = "values of axes"
    DECELERATION = "deceleration"
    CORNER_DECELERATION = "deceleration at corners"
    FEED_FORWARD = "feed-forward"


class Form(enum.Enum):
    """How a G function is written, by an example."""

    ALONE = "G90"
    TIME = "G04 X0.5"
    MOTION = "G60 X10"
    OFFSETS = "G92 X10"
    ZERO_OFFSET = "G159=2"
    RADIUS = "G163=5"
    SUBPROGRAM = "G80 [1, 2]"
    CORNER = "G301 I5"
    AXIS_WEIGHTS = "G130 X100"
    WEIGHT = "G131=100"
    MEASURING = "G100 X10"
    AXIS_VALUES = "G101 X1"
    MIRRORED_AXES = "G351 X-1"


#: Forms that need axis words.
WITH_AXES = frozenset((Form.AXIS_WEIGHTS, Form.AXIS_VALUES, Form.MEASURING, Form.MIRRORED_AXES))


class Role(enum.Enum):
    """The effect of an M function of the controller on the program."""

    PROGRAM_STOP = "program stop"
    OPTIONAL_STOP = "optional stop"
    PROGRAM_END = "program end"
    SUBPROGRAM_END = "end of a subprogram"
    SPINDLE = "spindle"


@dataclass(frozen=True, slots=True)
class GFunction(Entry):
    """A row of a G function.

    Functions of one ``group`` are modal and exclude each other in a block; those without a group
    act in their block only. ``plain``: the fast paths know the function. In the group ``MOTION`` it
    may appear in a plain line (``nc/fast/plain_lines.py``); in any other group plain lines may be
    decoded while it is active (``decoder/fast``). ``neutral``: the value with which a
    function that is not simulated changes nothing and is therefore accepted: ``G52=0``.
    """

    number: int = -1
    group: Group | None = None
    form: Form = Form.ALONE
    plain: bool = False
    neutral: float | None = None


@dataclass(frozen=True, slots=True)
class MFunction(Entry):
    """A row of an M function of the controller."""

    number: int = -1
    role: Role = Role.PROGRAM_STOP


def simulated(
    number: int, en: str, de: str, form: Form = Form.ALONE, *, plain: bool = False
) -> GFunction:
    """Return the row of a simulated function."""
    meaning = Text(en, de)
    row = GFunction(Kind.G_FUNCTION, f"G{number:02}", SIMULATED, meaning, number=number)
    return replace(row, form=form, plain=plain)


def plain(number: int, en: str, de: str, form: Form = Form.ALONE) -> GFunction:
    """Return the row of a simulated function that the fast paths know."""
    return simulated(number, en, de, form, plain=True)


def accepted(
    number: int, en: str, de: str, *, plain: bool = False, neutral: float | None = None
) -> GFunction:
    """Return the row of a function that is checked and has no effect."""
    row = simulated(number, en, de, plain=plain)
    return replace(row, support=ACCEPTED, neutral=neutral)


def refused(number: int, en: str, de: str, instead: Text = NOTHING_INSTEAD) -> GFunction:
    """Return the row of a refused function; ``instead``: what to use in its place."""
    return replace(simulated(number, en, de), support=REFUSED, instead=instead)


def simplified(number: int, en: str, de: str, how: Text, *, plain: bool = True) -> GFunction:
    """Return the row of a function without a source; ``how``: nctakt's way, reported once."""
    return replace(simulated(number, en, de, plain=plain), instead=how)


def weight(number: int, en: str, de: str, *, accepted: bool = False) -> GFunction:
    """Return the row of a function that weights the limits of all axes in per cent."""
    row = simulated(number, en, de, Form.WEIGHT, plain=True)
    return replace(row, support=ACCEPTED) if accepted else row


def axis_weights(number: int, en: str, de: str, *, accepted: bool = False) -> GFunction:
    """Return the row of a function whose axis words weight their axes in per cent."""
    row = weight(number, en, de, accepted=accepted)
    return replace(row, form=Form.AXIS_WEIGHTS, group=Group.AXIS_VALUES)


def axis_values(number: int, en: str, de: str) -> GFunction:
    """Return the row of a function whose axis words are values and not targets."""
    row = simulated(number, en, de, Form.AXIS_VALUES, plain=True)
    return replace(row, group=Group.AXIS_VALUES)


def group(group: Group | None, *rows: GFunction) -> Iterator[GFunction]:
    """Yield the rows of a modal group; ``None``: functions that act in their block only."""
    return (replace(row, group=row.group or group) for row in rows)


def subprograms(first: int, last: int) -> Iterator[GFunction]:
    """Yield the rows of functions that call a program which the channel list names for them."""
    en, de = "call of a program of the channel list", "Aufruf eines Programms der Kanalliste"
    return (simulated(number, en, de, Form.SUBPROGRAM) for number in range(first, last + 1))


def by_number(*groups: Iterator[GFunction]) -> Mapping[int, GFunction]:
    """Return the rows of all groups by number."""
    return MappingProxyType({row.number: row for group in groups for row in group})


def m_function(number: int, en: str, de: str, role: Role) -> MFunction:
    """Return the row of an M function; all of them are simulated."""
    meaning = Text(en, de)
    return MFunction(Kind.M_FUNCTION, f"M{number:02}", SIMULATED, meaning, number=number, role=role)
