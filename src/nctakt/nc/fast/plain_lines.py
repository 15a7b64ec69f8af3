# SPDX-License-Identifier: MIT
"""Plain blocks, read without a tree: a number, G00 or G01, axis words, F above 0, comments.

In: lines. Out: the content of a plain line as numbers. Programs of CAM systems consist of such
lines; any other line is left to the parser. Numbers equal those of ``float`` to the last bit: with
up to 15 digits both the digits and their power of ten are exact, so that the division rounds once.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.nc.fast.line_scanner import LineScanner
from nctakt.nc.vocabulary.functions import PLAIN_MOTIONS

#: Maximum number of a motion in a shape code.
MAX_MOTION = 4

#: Kinds of lines.
OTHER = 0
EMPTY = 1
PLAIN = 2


def shape_code(shape: Sequence[str | float]) -> int:
    """Return the ``shape`` of plain blocks with these letters, G followed by its number; 0 for
    others.
    """
    code = 0
    for item in shape:
        if isinstance(item, str):
            if len(item) > 1:
                return 0
            code = code * 32 + ord(item) - 64
        elif item in PLAIN_MOTIONS:
            code = code * 32 + 27 + int(item)
        else:
            return 0
    return code if len(shape) <= 12 else 0


class PlainScanner(LineScanner):
    """Scans lines for a channel with these axes; the fields describe the last ``PLAIN`` line.

    ``number``: the N word, 0 without one. ``column``: of the first word, from 1. ``motion``: 0 or 1
    for G00 and G01, else -1. ``has_feed``, ``feed``: the F word. ``axes``: bits of the axes that
    have a word, ``values``: their numbers. ``shape``: letters and G functions in order, as one
    number; blocks of one shape are equal for every check.
    """

    def __init__(self, axes: Sequence[str]) -> None:
        super().__init__()
        #: Index of the axis by letter (A is 1), -1 without one.
        self.axis_of_letter = memoryview(bytearray(8 * 27)).cast("q")
        for i in range(27):
            self.axis_of_letter[i] = -1
        for index, name in enumerate(axes[:62]):
            if len(name) == 1 and name in "ABCQUVWXYZ":
                self.axis_of_letter[ord(name) - 64] = index
        self.values = memoryview(bytearray(8 * max(1, len(axes)))).cast("d")
        #: 1 at the number of each motion that a plain line may have.
        self.motions = memoryview(bytearray(MAX_MOTION + 1))
        for number in PLAIN_MOTIONS:
            self.motions[number] = 1
        self.number = 0
        self.column = 0
        self.motion = -1
        self.has_feed = False
        self.feed = 0.0
        self.axes = 0
        self.shape = 0
        self.words = 0

    def skip_known(self, lines: list[str], index: int, end: int, shapes: set[int]) -> int:
        """Return the index of the first line before ``end`` that is neither empty nor plain with
        one of these shapes.
        """
        last = 0
        while index < end:
            what = self.read(lines[index])
            if what == 0:
                return index
            if what == 2 and self.shape != last:
                if self.shape not in shapes:
                    return index
                last = self.shape
            index += 1
        return index

    def read(self, line: str) -> int:
        """Read a line; return ``OTHER``, ``EMPTY`` or ``PLAIN``."""
        end = len(line)
        if end > 4000:
            return 0
        self.number = 0
        self.motion = -1
        self.has_feed = False
        self.axes = 0
        self.shape = 0
        self.words = 0
        i = self.blanks(line, 0, end)
        if i < end and (line[i] == "N" or line[i] == "n"):
            i = self.digits(line, self.blanks(line, i + 1, end), end)
            if i < 0:
                return 0
        while True:
            i = self.blanks(line, i, end)
            if i >= end or line[i] == ";":
                break
            i = self.comment(line, i, end) if line[i] == "(" else self.word(line, i, end)
            if i < 0:
                return 0
        while i < end:
            if line[i] == "\0":
                return 0
            i += 1
        if self.words == 0:
            return 1 if self.number == 0 else 0
        return 2

    def blanks(self, line: str, i: int, end: int) -> int:
        """Return the index of the next character other than a blank."""
        while i < end and (line[i] == " " or line[i] == "\t"):
            i += 1
        return i

    def digits(self, line: str, i: int, end: int) -> int:
        """Read a block number above 0; return its end, -1 for anything else."""
        first = i
        while i < end and "0" <= line[i] <= "9":
            self.number = self.number * 10 + ord(line[i]) - 48
            i += 1
            if i - first > 15:
                return -1
        return i if self.number > 0 else -1

    def word(self, line: str, i: int, end: int) -> int:
        """Read a word; return its end, -1 for a word that plain blocks do not have."""
        letter = ord(line[i])
        if 97 <= letter <= 122:
            letter -= 32
        if letter < 65 or letter > 90 or self.words == 12:
            return -1
        if self.shape == 0:
            self.column = i + 1
        i = self.signed(line, self.blanks(line, i + 1, end), end)
        if i < 0:
            return -1
        self.shape = self.shape * 32 + letter - 64
        self.words += 1
        axis = self.axis_of_letter[letter - 64]
        if axis >= 0:
            if self.axes >> axis & 1:
                return -1
            self.axes |= 1 << axis
            self.values[axis] = self.value
        elif letter == 71 and self.motion < 0 and self.words < 12:
            if not 0.0 <= self.value <= 4.0:
                return -1
            self.motion = int(self.value)
            if self.value != self.motion or self.motions[self.motion] == 0:
                return -1
            self.shape = self.shape * 32 + 27 + self.motion
            self.words += 1
        elif letter == 70 and not self.has_feed and self.value > 0.0:
            self.has_feed = True
            self.feed = self.value
        else:
            return -1
        return i
