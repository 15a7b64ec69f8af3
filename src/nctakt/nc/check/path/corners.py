# SPDX-License-Identifier: MIT
"""Chamfers and roundings of a block: G301, G302, ``#CHR``, ``#CHF``, ``#RND``, ``#FRC`` (MO-4).

In: a block. Out: diagnostics, and whether the block may insert a chamfer or rounding.
"""

from __future__ import annotations

from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.path.feed import FEED_NOT_POSITIVE
from nctakt.messages.path.shapes import (
    CORNER_BESIDE_MOTION,
    CORNER_FEED_WITHOUT_CORNER,
    CORNER_OFF,
    CORNER_SIZE_INVALID,
    CORNER_SIZE_MISSING,
)
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.path import CORNER_FEED_WORD, CORNER_SIZE_WORDS
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.functions import INSERTIONS


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
