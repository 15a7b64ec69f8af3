# SPDX-License-Identifier: MIT
"""G301, G302, ``#CHR``, ``#CHF``, ``#RND``, ``#FRC`` of a block -> chamfer or rounding (MO-4)."""

from __future__ import annotations

from collections.abc import Collection

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.shape_commands import InsertCorner
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.feed import FEED_NOT_POSITIVE
from nctakt.messages.path.shapes import (
    CORNER_FEED_WITHOUT_G94,
    CORNER_OFF,
    CORNER_SIZE_INVALID,
    CORNER_SIZE_MISSING,
)
from nctakt.nc import tree
from nctakt.nc.meaning.path import CORNER_FEED_WORD, CORNER_SIZE_WORDS
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import FEED_PER_MINUTE, INSERTIONS, members

#: Functions and words that change the contour of the tool between two motions.
_CONTOUR_FUNCTIONS = frozenset(
    number
    for group in (
        Group.PLANE,
        Group.COMPENSATION,
        Group.APPROACH,
        Group.TRANSITION,
        Group.MASKING,
        Group.FEED_ADAPTATION,
    )
    for number in members(group)
)


def changes_contour(block: tree.Block) -> bool:
    """Return whether a block changes the plane or the contour of the tool."""
    return any(
        isinstance(word, tree.Word)
        and (
            word.name == "D"
            or (
                word.name == "G"
                and isinstance(word.value, tree.Number)
                and word.value.value in _CONTOUR_FUNCTIONS
            )
        )
        for word in block.words
    )


class CornerWords:
    """The words for chamfers and roundings of one program, block by block."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._sizes: dict[str, tuple[Span, float]] = {}

    def word(self, name: str, span: Span, value: float) -> bool:
        """Keep a word of this kind for ``take``; return false for any other."""
        if name not in CORNER_SIZE_WORDS and name != CORNER_FEED_WORD:
            return False
        self._sizes[name] = (span, value)
        return True

    def take(
        self,
        functions: Collection[int],
        centre: dict[str, tuple[Span, float]],
        span: Span,
        number: int,
    ) -> InsertCorner | None:
        """Return the chamfer or rounding; takes I of G301 and G302 out of ``centre``."""
        if not self._sizes and not functions:
            return None
        name, size = "", 0.0
        source = self._environment.source_id(span)
        sizes, self._sizes = self._sizes, {}
        for function in INSERTIONS:
            if function in functions:
                name, size = f"G{function}", self._stored(centre)
                span = centre.pop("I", (span, 0.0))[0]
        for word in CORNER_SIZE_WORDS:
            if word in sizes:
                name = word
                span, size = sizes[word]
        if not name:
            return None
        if not self._environment.parameters.allows_corners:
            self._values.fail(CORNER_OFF, span, word=name)
        if size < 0.0:
            self._values.fail(CORNER_SIZE_INVALID, span, word=name, value=size)
        if size == 0.0:
            self._values.fail(CORNER_SIZE_MISSING, span, word=name)
        size_mm = size * self._state.length_unit_mm
        if name not in CORNER_SIZE_WORDS:
            self._state.shapes.corner_size = size_mm
        own = sizes.get(CORNER_FEED_WORD)
        feed = self._state.feed_mm_s if self._is_per_minute else 0.0
        if own is not None:
            feed = self._own_feed(*own)
        of_block = name in CORNER_SIZE_WORDS
        return InsertCorner(source, number, span, name, size_mm, feed, own is not None, of_block)

    def _stored(self, centre: dict[str, tuple[Span, float]]) -> float:
        """Return the size of G301 or G302 in the active unit: I, or the last one."""
        if "I" in centre:
            return centre["I"][1]
        return self._state.shapes.corner_size / self._state.length_unit_mm

    @property
    def _is_per_minute(self) -> bool:
        return self._state.feed.feed_mode == FEED_PER_MINUTE

    def _own_feed(self, span: Span, value: float) -> float:
        """Return ``#FRC`` in mm/s."""
        if not self._is_per_minute:
            self._values.fail(CORNER_FEED_WITHOUT_G94, span, mode=self._state.feed.feed_mode)
        if value <= 0.0:
            self._values.fail(FEED_NOT_POSITIVE, span, value=value)
        unit = self._environment.parameters.program_start.feed_unit_mm_min
        return value * (self._state.length_unit_mm if self._state.inch else unit) / 60.0
