# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""Shapes of statements: their text without its numbers and comments.

In: lines. Out: the shape of the statement that begins there, a structure with all its lines, and
what it leaves out: numbers, and where each of them and each comment ends. Ordinary programs are
made by programs: statements of the same shape come again and again with other numbers. A number is
left out where it is a value (``X10``, ``[3 * P1]``) and not 0; the numbers of functions, parameters
and elements (``G01``, ``P1``, ``V.P.A[2]``) belong to the shape. What has a label, a text in
quotes, a ``#`` or a ``%`` has no shape, nor has what is long; it is for the parser alone.
"""

from __future__ import annotations

#: In a shape: a number, a comment.
NUMBER = 1
COMMENT = 2

#: Numbers and comments, lines and characters that a statement with a shape may have.
MOST_PLACES = 200
MOST_LINES = 60
MOST_TEXT = 4000

#: Characters and places of one of its lines.
LONGEST_LINE = 200
MOST_PLACES_OF_LINE = 24


class ShapeScanner:
    """Finds shapes; ``key``: the last one, empty for none, of so many ``lines``.

    Behind it ``count`` numbers and comments are known: ``numbers`` their values, ``ends`` where in
    their lines they end.
    """

    def __init__(self) -> None:
        self.room = bytearray(MOST_TEXT + LONGEST_LINE + 2)
        self.text = memoryview(self.room)
        self.numbers = memoryview(bytearray(8 * (MOST_PLACES + LONGEST_LINE))).cast("d")
        self.ends = memoryview(bytearray(8 * (MOST_PLACES + LONGEST_LINE))).cast("q")
        self.key = b""
        self.lines = 0
        self.count = 0
        self.length = 0
        self.opens = 0
        self.value = 0.0
        self.is_name = False

    def pass_over(self, lines: list[str], index: int, keys: set[bytes]) -> int:
        """The first line from ``index`` on that is neither empty nor begins one of these shapes.

        ``key`` is its shape.
        """
        end = len(lines)
        while index < end:
            if self.read(lines, index) == 0:
                return index
            if self.key and self.key not in keys:
                return index
            index += self.lines
        return index

    def read(self, lines: list[str], index: int) -> int:
        """Find the shape of the statement that begins at ``lines[index]``; how many lines it has.

        An empty line is one with an empty ``key``; without a shape there are no lines.
        """
        self.key = b""
        self.lines = 0
        self.count = 0
        self.length = 0
        depth = 0
        first = index
        end = min(len(lines), index + 60)
        while index < end:
            self.opens = 0
            before = self.length
            if not self.line(lines[index]):
                return 0
            index += 1
            depth += self.opens
            if depth < 0 or self.length > 4000 or self.count > 200:
                return 0
            if depth == 0:
                self.lines = index - first
                if self.length > before:
                    self.key = bytes(self.room[: self.length])
                return self.lines
            self.text[self.length] = 10
            self.length += 1
        return 0

    def line(self, line: str) -> int:
        """Add a line to the shape; 0 where it has none. ``opens``: the structures that it does."""
        end = len(line)
        if end > 200:
            return 0
        start = self.length
        places = self.count
        i = 0
        is_empty = True  # nothing but blanks and comments yet
        is_head = True  # nothing but a skip level yet
        before = " "  # the character in front, and the last one in front that is no blank
        last = " "
        depth = 0  # of brackets; that of those around the number of an element; behind such ones
        element_depth = 0
        behind_element = False
        self.is_name = False
        while i < end:
            c = line[i]
            if c == ";":
                break
            if c == "(":
                i = self.comment(line, i, end)
                if i < 0:
                    return 0
                before = " "
                continue
            if c in " \t":
                self.put(c)
                i += 1
                before = c
                continue
            is_empty = False
            if "0" <= c <= "9" or c == ".":
                if c == "." and before == "]":
                    i = self.name(line, i, end)
                    before = last = "A"
                    if i < end and line[i] == "[" and element_depth == 0:
                        element_depth = depth + 1
                    continue
                if c == "." and not (i + 1 < end and "0" <= line[i + 1] <= "9"):
                    return 0
                if element_depth > 0 or (last == "/" and is_head):
                    i = self.digits(line, i, end)
                else:
                    i = self.number(line, i, end, last in "Nn")
                if i < 0:
                    return 0
                before = last = "0"
                is_head = False
                continue
            if "A" <= c <= "Z" or "a" <= c <= "z" or c == "_":
                stop = self.word(line, i, end)
                if stop < 0:
                    return 0
                before = last = line[stop - 1]
                i = stop
                is_head = False
                if i < end and line[i] == "[" and self.is_name and element_depth == 0:
                    element_depth = depth + 1
                continue
            if c == "[":
                depth += 1
                if before == "]" and behind_element and element_depth == 0:
                    element_depth = depth
            elif c == "]":
                behind_element = depth == element_depth
                if behind_element:
                    element_depth = 0
                depth -= 1
            elif c == "$":
                self.control(line, i + 1, end)
            elif not self.is_sign(c):
                return 0
            if not (c == "/" and is_head and last == " "):
                is_head = False
            self.put(c)
            i += 1
            before = last = c
        while i < end:
            if line[i] == "\0":
                return 0
            i += 1
        if is_empty:
            self.length = start
            self.count = places
        return self.count - places <= 24

    def put(self, c: str) -> None:
        """A character of the shape."""
        self.text[self.length] = ord(c)
        self.length += 1

    def is_sign(self, c: str) -> int:
        """Whether it is a sign of expressions and words."""
        return c in "=+-*/,<>&|^!@"

    def place(self, mark: int, end: int) -> None:
        """A number or comment that ends here."""
        self.text[self.length] = mark
        self.length += 1
        self.ends[self.count] = end
        self.numbers[self.count] = self.value
        self.count += 1

    def comment(self, line: str, i: int, end: int) -> int:
        """The end of a comment in parentheses, which nest; -1 where a NUL stands in it."""
        depth = 0
        while i < end:
            c = line[i]
            i += 1
            if c == "(":
                depth += 1
            elif c == ")":
                depth -= 1
                if depth == 0:
                    break
            elif c == "\0":
                return -1
        self.value = 0.0
        self.place(2, i)
        return i

    def digits(self, line: str, i: int, end: int) -> int:
        """Digits that belong to the shape; where they end."""
        while i < end and ("0" <= line[i] <= "9" or line[i] == "."):
            self.put(line[i])
            i += 1
        return i

    def number(self, line: str, i: int, end: int, is_whole: bool) -> int:
        """A number; where it ends, -1 for one that is not exact or goes on strangely.

        ``is_whole``: it must not have a point.
        """
        first = i
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
        if count == 0 or count > 15 or (has_point and is_whole):
            return -1
        if i < end and (line[i] == "." or line[i] == "_"):
            return -1
        if mantissa == 0:
            return self.digits(line, first, end)
        self.value = mantissa / scale
        self.place(1, i)
        return i

    def word(self, line: str, i: int, end: int) -> int:
        """Letters with what belongs to them; where that ends, -1 where it has no shape.

        ``is_name``: a variable or parameter, which may have elements. The digits behind one letter
        of an axis, F, I, J, K, N, R are a number, unless the word is a name (``X1=5``).
        """
        first = i
        while i < end and ("A" <= line[i] <= "Z" or "a" <= line[i] <= "z" or line[i] == "_"):
            self.put(line[i])
            i += 1
        c = line[first]
        is_one = i - first == 1
        self.is_name = is_one and c in "Pp"
        if i < end and line[i] == "." and not (i + 1 < end and "0" <= line[i + 1] <= "9"):
            return self.name(line, i, end)
        if i == end:
            return i
        if line[i] == ".":
            is_value = c not in "VvNn" and self.takes_number(c)
            return i if is_one and is_value else -1
        if not "0" <= line[i] <= "9":
            return i
        if is_one and self.takes_number(c):
            stop = i
            while stop < end and "0" <= line[stop] <= "9":
                stop += 1
            while stop < end and line[stop] in " \t":
                stop += 1
            if stop == end or (line[stop] != "=" and line[stop] != "["):
                return i
        while i < end and "0" <= line[i] <= "9":
            self.put(line[i])
            i += 1
        if i < end and line[i] == ".":
            return -1
        while not is_one and i < end and self.is_letter_or_digit(line[i]):
            self.put(line[i])
            i += 1
        return i

    def takes_number(self, c: str) -> int:
        """Whether a letter's number is any value."""
        return c in "ABCFIJKNQRUVWXYZabcfijknqruvwxyz"

    def name(self, line: str, i: int, end: int) -> int:
        """The rest of a name with its members; where it ends."""
        self.is_name = True
        while i < end:
            c = line[i]
            if not self.is_letter_or_digit(c) and c != ".":
                break
            self.put(c)
            i += 1
        return i

    def is_letter_or_digit(self, c: str) -> int:
        """Whether it may stand in a name."""
        return "A" <= c <= "Z" or "a" <= c <= "z" or "0" <= c <= "9" or c == "_"

    def control(self, line: str, i: int, end: int) -> None:
        """Behind ``$``: whether it opens or closes a structure; a second one only jumps."""
        if self.opens == 1:
            self.opens = 0
            return
        first = line[i] if i < end else " "
        second = line[i + 1] if i + 1 < end else " "
        if first in "IiFfWwRrSs":
            self.opens = 1
        elif first in "Dd":
            self.opens = 1 if second in "Oo" else 0
        elif first in "Uu":
            self.opens = -1
        elif first in "Ee":
            self.opens = -1 if second in "Nn" else 0
