# SPDX-License-Identifier: MIT
"""Bytes of the image of the HLI: as memory of an image, and as numbers of each of its types.

Numbers have the byte order of the processor.
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.bounds import check_range


class NumberBytes:
    """Eight bytes, seen as a number of each type (``codes.IMAGE_BOOLEAN`` …)."""

    def __init__(self) -> None:
        scratch = memoryview(bytearray(8))
        self.scratch = scratch
        self.as_signed_8 = scratch.cast("b")
        self.as_signed_16 = scratch.cast("h")
        self.as_unsigned_16 = scratch.cast("H")
        self.as_signed_32 = scratch.cast("i")
        self.as_unsigned_32 = scratch.cast("I")
        self.as_real = scratch.cast("d")

    def value(self, kind: int) -> float:
        """Return the number of a type."""
        if kind == codes.IMAGE_BOOLEAN:
            return 1.0 if self.scratch[0] else 0.0
        if kind == codes.IMAGE_SGN08:
            return self.as_signed_8[0]
        if kind == codes.IMAGE_UNS08:
            return self.scratch[0]
        if kind == codes.IMAGE_SGN16:
            return self.as_signed_16[0]
        if kind == codes.IMAGE_UNS16:
            return self.as_unsigned_16[0]
        if kind == codes.IMAGE_SGN32:
            return self.as_signed_32[0]
        if kind == codes.IMAGE_UNS32:
            return self.as_unsigned_32[0]
        return self.as_real[0]

    def put(self, kind: int, value: float) -> None:
        """Put a number of a type into the bytes."""
        if kind == codes.IMAGE_SGN08:
            self.as_signed_8[0] = int(value)
        elif kind in (codes.IMAGE_BOOLEAN, codes.IMAGE_UNS08):
            self.scratch[0] = int(value)
        elif kind == codes.IMAGE_SGN16:
            self.as_signed_16[0] = int(value)
        elif kind == codes.IMAGE_UNS16:
            self.as_unsigned_16[0] = int(value)
        elif kind == codes.IMAGE_SGN32:
            self.as_signed_32[0] = int(value)
        elif kind == codes.IMAGE_UNS32:
            # the bits of a signed number: a long of 32 bits can hold no larger ones
            if value > 2147483647.0:
                value -= 4294967296.0
            self.as_signed_32[0] = int(value)
        else:
            self.as_real[0] = value


class ImageBytes:
    """The bytes of an image, and those of them that the tick has published or taken over.

    ``image``: writable bytes, a multiple of 8; ``published``: as many. ``halves`` and ``words`` are
    the numbers of 32 and 64 bits in them.
    """

    def __init__(self, image: memoryview, published: memoryview) -> None:
        check_range(len(published), len(image), len(image), "length of the published image")
        self.count = len(image)
        self.image = image
        self.halves = image.cast("i")
        self.words = image.cast("q")
        self.reals = image.cast("d")
        self.published = published
        self.published_halves = published.cast("i")
        self.published_words = published.cast("q")

    def put(self, first: int, number: NumberBytes, size: int) -> None:
        """Write the first ``size`` bytes of a number, which are published then, at ``first``."""
        for i in range(size):
            self.published[first + i] = self.image[first + i] = number.scratch[i]
