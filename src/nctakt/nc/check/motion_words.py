# SPDX-License-Identifier: MIT
"""What is likely wrong with a motion by the words of its block alone: F0, arcs.

In: a block. Out: warnings; whether a motion comes of its words only the run tells.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.messages.lints import FEED_NOT_POSITIVE
from nctakt.messages.motion import ARC_WITH_CENTRE_AND_RADIUS
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ARC_RADIUS,
    ARCS,
    CONTOURING_ONCE,
    EXACT_STOP_ONCE,
    FEED_PER_MINUTE,
    members,
)

CENTRE_WORDS = ("I", "J", "K")
RADIUS_WORD = "R"
FEED_WORD = "F"
#: G functions beside which axis words are targets, and which leave the kind of motion as it is.
_BESIDE_TARGETS = (
    *members(Group.PLANE),
    *members(Group.DIMENSION),
    *members(Group.ARC_CENTRE),
    FEED_PER_MINUTE,
    EXACT_STOP_ONCE,
    CONTOURING_ONCE,
)


def check_feed(block: Block, findings: Findings) -> None:
    """A feed of 0 or below is no feed."""
    for word in _words(block, FEED_WORD):
        if isinstance(word.value, Number) and word.value.value <= 0.0:
            findings.report(FEED_NOT_POSITIVE, word.span, value=word.value.value)


def check_arc(block: Block, findings: Findings) -> None:
    """Centre and radius in one block."""
    radius = list(_radii(block))
    if radius and any(list(_words(block, name)) for name in CENTRE_WORDS):
        findings.report(ARC_WITH_CENTRE_AND_RADIUS, radius[0].span)


def lacks_centre(block: Block, *, is_modal: bool) -> bool:
    """Whether it is an arc (G02, G03) with a target, without centre and radius.

    ``is_modal``: an arc is active; then a block whose axis words may mean something else is none.
    """
    functions = _functions(block)
    is_arc = any(function in ARCS for function in functions)
    if not is_arc:
        is_arc = is_modal and all(function in _BESIDE_TARGETS for function in functions)
    return (
        is_arc
        and any(isinstance(word, AxisWord) for word in block.words)
        and not any(list(_words(block, name)) for name in CENTRE_WORDS)
        and not has_radius(block)
    )


def leaves_arc(block: Block, *, before: bool) -> bool:
    """Whether G02 or G03 is certainly active behind a block."""
    functions = _functions(block)
    if any(function in ARCS for function in functions):
        return True
    others = any(not isinstance(word, AxisWord | Word) for word in block.words)
    return before and not others and all(function in _BESIDE_TARGETS for function in functions)


def _functions(block: Block) -> list[float | None]:
    """The numbers of the G functions, and ``None`` for what only the run shows or may call."""
    numbers: list[float | None] = [
        word.value.value if isinstance(word.value, Number) else None for word in _words(block, "G")
    ]
    return numbers + [None for _ in _words(block, "M")]


def has_radius(block: Block) -> bool:
    """Whether a radius stands in it, for this arc or a later one."""
    return any(True for _ in _radii(block))


def _radii(block: Block) -> Iterator[AxisWord | Word]:
    """``R5``, ``G163=5``."""
    yield from _words(block, RADIUS_WORD)
    for word in _words(block, "G"):
        if isinstance(word.value, Number) and word.value.value == ARC_RADIUS:
            yield word


def _words(block: Block, name: str) -> Iterator[AxisWord | Word]:
    """The words of a block with this name."""
    return (word for word in block.words if isinstance(word, AxisWord | Word) and word.name == name)
