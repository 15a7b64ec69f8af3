# SPDX-License-Identifier: MIT
"""The common part of the scanners of plain lines and shapes: decimals and comments.

In: a line, an index in it, its length. Out: the index after the part read, -1 for a part that the
scanners leave to the parser.
"""

from __future__ import annotations


class LineScanner:
    """Base of the scanners; ``value``: the last decimal, ``has_point``: whether it has a point."""

    def __init__(self) -> None:
        self.value = 0.0
        self.has_point = False

    def decimal(self, line: str, i: int, end: int) -> int:
        """Read an unsigned number into ``value``; return -1 without digits or with too many."""
        mantissa = 0
        count = 0
        scale = 1.0
        has_point = False
        while i < end:
            c = line[i]
            if "0" <= c <= "9":
                mantissa = mantissa * 10 + ord(c) - 48
                count += 1
                if has_point:
                    scale *= 10.0
            elif c == "." and not has_point:
                has_point = True
            else:
                break
            i += 1
        if count == 0 or count > 15:
            return -1
        self.value = mantissa / scale
        self.has_point = has_point
        return i

    def signed(self, line: str, i: int, end: int) -> int:
        """Read a decimal with its sign."""
        if i == end or (line[i] != "-" and line[i] != "+"):
            return self.decimal(line, i, end)
        stop = self.decimal(line, i + 1, end)
        if line[i] == "-":
            self.value = -self.value
        return stop

    def comment(self, line: str, i: int, end: int) -> int:
        """Return the end of a nested comment in parentheses; -1 if it contains a NUL."""
        depth = 0
        while i < end:
            c = line[i]
            i += 1
            if c == "(":
                depth += 1
            elif c == ")":
                depth -= 1
                if depth == 0:
                    return i
            elif c == "\0":
                return -1
        return i
