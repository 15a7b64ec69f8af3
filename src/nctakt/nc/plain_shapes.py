# SPDX-License-Identifier: MIT
"""Plain blocks by their shape: the letters and G functions that all a check of them depends on.

In: blocks. Out: their shapes, and which of them have been found to be without mistakes.
"""

from __future__ import annotations

from nctakt.nc.fast.plain_lines import shape_code
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.functions import PLAIN_MOTIONS

#: Words whose values do not matter for the check.
_FREE_WORDS = ("F",)

PlainShape = tuple[str | float, ...]


class PlainShapes:
    """Shapes of plain blocks without mistakes; they hold for all texts of a channel."""

    def __init__(self) -> None:
        self._shapes: dict[PlainShape, None] = {}
        self.codes: set[int] = set()

    def add(self, shape: PlainShape) -> None:
        """Add the shape of a block that was checked."""
        self._shapes[shape] = None
        self.codes.add(shape_code(shape))

    def __contains__(self, shape: PlainShape | None) -> bool:
        return shape in self._shapes


def plain_shape(block: Block) -> PlainShape | None:
    """Return everything that the check of a plain block depends on; ``None`` if it depends on more.

    G functions change the meaning of later blocks, M functions may end the program, and a block
    number may be computed: only blocks of axis words, F above 0, G00 and G01 have a shape.
    """
    if block.head.number is not None and not isinstance(block.head.number, Number):
        return None
    shape: list[str | float] = []
    for word in block.words:
        if not isinstance(word, AxisWord | Word) or not isinstance(word.value, Number):
            return None
        shape.append(word.name)
        if isinstance(word, AxisWord):
            continue
        if word.additional is not None or word.arguments:
            return None
        if word.name == "F" and word.value.value <= 0.0:
            return None
        if word.name not in _FREE_WORDS:
            if word.name != "G" or word.value.value not in PLAIN_MOTIONS:
                return None
            shape.append(word.value.value)
    return tuple(shape)
