# SPDX-License-Identifier: MIT
"""Probable mistakes in the motion words of a single block: F0, arcs.

In: a block. Out: warnings; whether the block moves at all is known only at run time.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.messages.path.feed import FEED_NOT_POSITIVE
from nctakt.messages.path.motion import ARC_WITH_CENTRE_AND_RADIUS
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ARC_RADIUS,
    ARCS,
    CONTOURING_ONCE,
    EXACT_STOP_ONCE,
    FEED_PER_MINUTE,
    FEED_RAMPS,
    FEED_STEPS,
    members,
)

CENTRE_WORDS = ("I", "J", "K")
RADIUS_WORD = "R"
FEED_WORD = "F"
#: G functions that leave axis words targets and the kind of motion unchanged.
_BESIDE_TARGETS = (
    *members(Group.PLANE),
    *members(Group.DIMENSION),
    *members(Group.ARC_CENTRE),
    FEED_PER_MINUTE,
    EXACT_STOP_ONCE,
    CONTOURING_ONCE,
)


def check_feed(block: Block, findings: Findings) -> None:
    """Report a feed of 0 or below."""
    for word in _words(block, FEED_WORD):
        if isinstance(word.value, Number) and word.value.value <= 0.0:
            findings.report(FEED_NOT_POSITIVE, word.span, value=word.value.value)


def check_arc(block: Block, findings: Findings) -> None:
    """Report centre and radius in one block."""
    radius = list(_radii(block))
    if radius and any(list(_words(block, name)) for name in CENTRE_WORDS):
        findings.report(ARC_WITH_CENTRE_AND_RADIUS, radius[0].span)


def lacks_centre(block: Block, *, is_modal: bool) -> bool:
    """Return whether the block is an arc (G02, G03) with a target, but without centre and radius.

    ``is_modal``: an arc is active; a block whose axis words may mean something else is then not an
    arc.
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
    """Return whether G02 or G03 is certainly active after a block."""
    functions = _functions(block)
    if any(function in ARCS for function in functions):
        return True
    others = any(not isinstance(word, AxisWord | Word) for word in block.words)
    return before and not others and all(function in _BESIDE_TARGETS for function in functions)


def functions_of(block: Block) -> dict[int, AxisWord | Word]:
    """Return the words of the G functions whose numbers are constants."""
    return {
        round(word.value.value): word
        for word in _words(block, "G")
        if isinstance(word.value, Number)
    }


def check_feed_ramps(block: Block, findings: Findings) -> None:
    """Report ramps of the feed that exclude each other: G193, G293, and either of G08 and G09."""
    functions = functions_of(block)
    ramps = [number for number in functions if number in FEED_RAMPS]
    others = ramps[1:] + [step for step in FEED_STEPS if step in functions]
    for number in others if ramps else ():
        word = functions[number]
        written = findings.written(word.span)
        findings.report(EXCLUSIVE_WORDS, word.span, word=written, other=f"G{ramps[0]}")


def _functions(block: Block) -> list[float | None]:
    """Return the numbers of the G functions; ``None`` for computed ones and for M functions."""
    numbers: list[float | None] = [
        word.value.value if isinstance(word.value, Number) else None for word in _words(block, "G")
    ]
    return numbers + [None for _ in _words(block, "M")]


def has_radius(block: Block) -> bool:
    """Return whether the block sets a radius, for this arc or a later one."""
    return any(True for _ in _radii(block))


def _radii(block: Block) -> Iterator[AxisWord | Word]:
    """Yield the words ``R5``, ``G163=5``."""
    yield from _words(block, RADIUS_WORD)
    for word in _words(block, "G"):
        if isinstance(word.value, Number) and word.value.value == ARC_RADIUS:
            yield word


def _words(block: Block, name: str) -> Iterator[AxisWord | Word]:
    """Return the words of a block with this name."""
    return (word for word in block.words if isinstance(word, AxisWord | Word) and word.name == name)
