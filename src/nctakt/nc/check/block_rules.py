# SPDX-License-Identifier: MIT
"""Combinations of words that a block may not have (nc-programs).

In: a block whose words are checked one by one. Out: diagnostics about several of them, and whether
the block may insert a chamfer or rounding (MO-4).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.path.contour_lines import ANGLE_DURING_ARC
from nctakt.messages.path.feed import FEED_NOT_POSITIVE
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.path.shapes import (
    CORNER_BESIDE_MOTION,
    CORNER_FEED_WITHOUT_CORNER,
    CORNER_OFF,
    CORNER_SIZE_INVALID,
    CORNER_SIZE_MISSING,
)
from nctakt.messages.path.tools import TANGENTIAL_ALONE
from nctakt.messages.programs.checked_blocks import (
    EXCLUSIVE_WORDS,
    G60_WITHOUT_MOTION,
    INVALID_COMMAND_FORM,
)
from nctakt.messages.programs.offsets import COMMAND_WITHOUT_AXIS, MOTION_WORD_WITH_OFFSETS
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.frames import check_mirrored_axes, check_rotation_block
from nctakt.nc.check.path.measuring import check_measuring_block
from nctakt.nc.check.path.motion_words import RADIUS_WORD, check_arc, check_feed_ramps, functions_of
from nctakt.nc.check.path.splines import check_spline_words
from nctakt.nc.meaning.path import (
    ANGLE_WORD,
    CORNER_FEED_WORD,
    CORNER_SIZE_WORDS,
    SWITCHES,
    VECTORS,
)
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.functions import (
    ANY_ARCS,
    ARC_RADIUS,
    COMPENSATION_OFF,
    COMPENSATIONS,
    EXACT_STOP_ONCE,
    FEED_RAMPS,
    GEAR_STEP,
    INSERTIONS,
    INTERRUPTIBLE,
    MEASURING,
    MEASURING_CONTINUES,
    MIRRORING_OF_AXES,
    MOTIONS,
    NO_SPINDLE_OVERRIDE,
    REFERENCE_OFFSET,
    ROTATION_ON,
    TANGENTIAL_APPROACH,
)

_CORNER_WORDS = frozenset((*CORNER_SIZE_WORDS, CORNER_FEED_WORD))
_CORNER_FUNCTIONS = frozenset(INSERTIONS)
_SPLINE_WORDS = frozenset((*SWITCHES, *VECTORS))
_RULED = frozenset(
    (
        EXACT_STOP_ONCE,
        GEAR_STEP,
        NO_SPINDLE_OVERRIDE,
        MEASURING,
        MEASURING_CONTINUES,
        INTERRUPTIBLE,
        MIRRORING_OF_AXES,
        REFERENCE_OFFSET,
        ROTATION_ON,
        TANGENTIAL_APPROACH,
        *FEED_RAMPS,
    )
)


class GivenWords(NamedTuple):
    """The names of a block's words, and its G functions with constant numbers."""

    names: set[str]
    functions: set[float]


class BlockChecker:
    """Checks whole blocks of one channel; ``main_axes``: names of its first three axes."""

    def __init__(
        self, channel: ChannelParameters, main_axes: Sequence[str], findings: Findings
    ) -> None:
        self._channel = channel
        self._main_axes = main_axes
        self._findings = findings

    def check(self, block: Block, given: GivenWords) -> bool:
        """Check a block; return whether its words insert a chamfer or rounding."""
        inserts = False
        names, functions = given
        if not (_CORNER_WORDS.isdisjoint(names) and _CORNER_FUNCTIONS.isdisjoint(functions)):
            inserts = check_corners(block, self._channel, self._findings)
        if ANGLE_WORD in names:
            check_contour_line(block, functions, self._channel, self._findings)
        if not _SPLINE_WORDS.isdisjoint(names):
            check_spline_words(block, self._main_axes, self._findings)
        if RADIUS_WORD in names or ARC_RADIUS in functions:
            check_arc(block, self._findings)
        if not _RULED.isdisjoint(functions):
            check_measuring_block(block, self._findings)
            check_mirrored_axes(block, self._findings)
            check_rotation_block(block, self._findings)
            check_feed_ramps(block, self._findings)
            self._exact_stop(block)
            self._tangential(block)
            self._reference(block)
            self._gear_step(block)
            self._spindle_word(block, NO_SPINDLE_OVERRIDE, "G167 S1000")
        return inserts

    def _gear_step(self, block: Block) -> None:
        """Check that G112 has a spindle, and no axis: their gear steps do not change."""
        word = functions_of(block).get(GEAR_STEP)
        if word is None:
            return
        self._spindle_word(block, GEAR_STEP, "G112 S2")
        for other in block.words:
            if isinstance(other, AxisWord):
                self._findings.report(
                    COMMAND_WORD_NOT_SIMULATED,
                    other.span,
                    command="G112",
                    word=other.name,
                    names=", ".join(self._channel.spindle_names),
                )

    def _spindle_word(self, block: Block, function: int, form: str) -> None:
        """Check that a G function comes with a spindle."""
        word = functions_of(block).get(function)
        spindles = ("S", *self._channel.spindle_names)
        if word is None or any(getattr(other, "name", "") in spindles for other in block.words):
            return
        name = f"G{function}"
        self._findings.report(INVALID_COMMAND_FORM, word.span, command=name, forms=form)

    def _exact_stop(self, block: Block) -> None:
        stop = functions_of(block).get(EXACT_STOP_ONCE)
        if stop is not None and not any(isinstance(word, AxisWord) for word in block.words):
            self._findings.report(G60_WITHOUT_MOTION, stop.span)

    def _tangential(self, block: Block) -> None:
        functions = functions_of(block)
        word = functions.get(TANGENTIAL_APPROACH)
        if word is not None and functions.keys().isdisjoint((COMPENSATION_OFF, *COMPENSATIONS)):
            self._findings.report(TANGENTIAL_ALONE, word.span)

    def _reference(self, block: Block) -> None:
        """Check that G92 has axis words, whose values are offsets, and does not move."""
        functions = functions_of(block)
        reference = functions.get(REFERENCE_OFFSET)
        if reference is None:
            return
        if not any(isinstance(word, AxisWord) for word in block.words):
            self._findings.report(COMMAND_WITHOUT_AXIS, reference.span, command="G92")
        for function, word in functions.items():
            if function in MOTIONS:
                written = self._findings.written(word.span)
                self._findings.report(
                    MOTION_WORD_WITH_OFFSETS, word.span, word=written, command="G92"
                )


def check_contour_line(
    block: Block, functions: Collection[float], channel: ChannelParameters, findings: Findings
) -> None:
    """Check the word of an angle against the G functions of its block."""
    span = next(
        word.span for word in block.words if isinstance(word, Word) and word.name == ANGLE_WORD
    )
    if not channel.allows_corners:
        findings.report(CORNER_OFF, span, word=ANGLE_WORD)
    for function in ANY_ARCS:
        if function in functions:
            findings.report(ANGLE_DURING_ARC, span, function=function)


def check_corners(block: Block, channel: ChannelParameters, findings: Findings) -> bool:
    """Check these words; return whether the block inserts a chamfer or rounding."""
    words = [word for word in block.words if isinstance(word, Word)]
    corners = [word for word in words if word.name in CORNER_SIZE_WORDS or _inserts(word)]
    for word in words:
        if word.name != CORNER_FEED_WORD:
            continue
        if not corners:
            findings.report(CORNER_FEED_WITHOUT_CORNER, word.span)
        if isinstance(word.value, Number) and word.value.value <= 0.0:
            findings.report(FEED_NOT_POSITIVE, word.span, value=word.value.value)
    if not corners:
        return False
    first = corners[0]
    name = findings.written(first.span)
    if not channel.allows_corners:
        findings.report(CORNER_OFF, first.span, word=name)
    if len(corners) > 1:
        findings.report(
            EXCLUSIVE_WORDS, corners[1].span, word=_name(corners[1]), other=_name(first)
        )
        return True
    size: Word | None = first
    if first.name == "G":
        size = next(
            (word for word in block.words if isinstance(word, Word) and word.name == "I"), None
        )
        moved = next((word for word in block.words if isinstance(word, AxisWord)), None)
        if moved is not None:
            written = findings.written(moved.span)
            findings.report(CORNER_BESIDE_MOTION, moved.span, word=written, corner=name)
    if size is not None and isinstance(size.value, Number) and size.value.value <= 0.0:
        if size.value.value < 0.0:
            findings.report(CORNER_SIZE_INVALID, size.span, word=name, value=size.value.value)
        else:
            findings.report(CORNER_SIZE_MISSING, size.span, word=name)
    return True


def _inserts(word: Word) -> bool:
    return word.name == "G" and isinstance(word.value, Number) and word.value.value in INSERTIONS


def _name(word: Word) -> str:
    """Return the name of one of these words, without its value."""
    if word.name == "G" and isinstance(word.value, Number):
        return f"G{round(word.value.value)}"
    return word.name
