# SPDX-License-Identifier: MIT
"""Shapes of statements: their text without its numbers and comments.

In: lines. Out: the ``Shape`` of the statement that begins there, and what it leaves out: numbers,
and where each of them and each comment ends. Ordinary programs are made by programs: statements of
the same shape come again and again with other numbers. A number is left out where it is a value
(``X10``, ``[3 * P1]``) and not 0; the numbers of functions, parameters and elements (``G01``,
``P1``, ``V.P.A[2]``) belong to the shape. The shape of a structure is that of its own ``$`` lines;
the statements between them are *runs*, each with a shape of its own. What has a label, a text in
quotes, a ``#`` or a ``%`` has no shape, nor has what is long; it is for the parser alone.
"""

from __future__ import annotations

from nctakt.nc.fast.line_scanner import LineScanner

#: In a shape: a number, a comment, a run.
NUMBER = 1
COMMENT = 2
RUN = 3

#: Numbers and comments, lines, characters of a statement with a shape; structures inside it.
MAX_MARKS = 200
MAX_LINES = 400
MAX_TEXT = 4000
MAX_DEPTH = 20

#: Characters and marks of one of its lines.
LONGEST_LINE = 200
MAX_MARKS_OF_LINE = 24


class Shape:
    """The shape of one statement: its ``key``, and what is not part of it.

    ``lines``: which of the lines at hand its own lines are. ``numbers``: the values of its numbers,
    0 for a comment; ``ends``: where in their lines they end. ``runs``: the statements inside it.
    """

    def __init__(self, key: bytes) -> None:
        self.key = key
        self.lines: list[int] = []
        self.numbers: list[float] = []
        self.ends: list[int] = []
        self.runs: list[list[Shape]] = []

    def is_of(self, keys: set[bytes]) -> int:
        """Whether it and all that is inside it have one of these keys."""
        if self.key not in keys:
            return 0
        for run in self.runs:
            for inside in run:
                if not inside.is_of(keys):
                    return 0
        return 1


class ShapeScanner(LineScanner):
    """Finds shapes; ``shape``: the last one, ``None`` for none, behind ``index`` lines."""

    def __init__(self) -> None:
        super().__init__()
        self.room = bytearray(MAX_TEXT + LONGEST_LINE + 4)
        self.text = memoryview(self.room)
        self.numbers = memoryview(bytearray(8 * (MAX_MARKS + LONGEST_LINE))).cast("d")
        self.ends = memoryview(bytearray(8 * (MAX_MARKS + LONGEST_LINE))).cast("q")
        self.shape: Shape | None = None
        self.index = 0
        self.end = 0
        self.count = 0
        self.length = 0
        self.opens = 0
        self.controls = False
        self.is_name = False

    def skip_known(self, lines: list[str], index: int, keys: set[bytes]) -> int:
        """The first line from ``index`` on that is neither empty nor begins one of these shapes.

        ``shape`` is its shape.
        """
        end = len(lines)
        while index < end:
            if self.read(lines, index) == 0:
                return index
            shape = self.shape
            if shape is not None and not shape.is_of(keys):
                return index
            index = self.index
        return index

    def read(self, lines: list[str], index: int) -> int:
        """Find the shape of the statement that begins at ``lines[index]``; how many lines it has.

        An empty line is one without a ``shape``; without lines there is none.
        """
        self.shape = None
        self.count = 0
        self.length = 0
        self.index = index
        self.end = min(len(lines), index + 400)
        if not self.line(lines[index]):
            return 0
        if self.length == 0:
            self.index = index + 1
            return 1
        self.shape = self.statement(lines, 0, 0, 0)
        return self.index - index if self.shape is not None else 0

    def statement(self, lines: list[str], start: int, first_mark: int, depth: int) -> Shape | None:
        """The statement whose first line has just been added, which is ``lines[index]``.

        ``start``, ``first_mark``: where its text and its marks begin; none of it is left there.
        """
        if self.opens < 0 or depth > 20:
            return None
        own = [self.index]
        runs: list[list[Shape]] = []
        self.index += 1
        if self.opens > 0:
            if not self.inside(lines, own, runs, depth):
                return None
        if self.length > 4000 or self.count > 200:
            return None
        shape = Shape(bytes(self.room[start : self.length]))
        shape.lines = own
        shape.runs = runs
        for i in range(first_mark, self.count):
            shape.numbers.append(self.numbers[i])
            shape.ends.append(self.ends[i])
        self.length = start
        self.count = first_mark
        return shape

    def inside(self, lines: list[str], own: list[int], runs: list[list[Shape]], depth: int) -> int:
        """The rest of a structure: its ``$`` lines to its shape, the others to its runs."""
        run: list[Shape] | None = None
        while self.index < self.end:
            start = self.length
            first_mark = self.count
            if start > 4000 or first_mark > 200:
                return 0
            self.append("\n")
            if not self.line(lines[self.index]):
                return 0
            if self.length == start + 1:
                self.length = start
                self.index += 1
                continue
            if self.controls and self.opens <= 0:
                own.append(self.index)
                run = None
                self.index += 1
                if self.opens < 0:
                    self.opens = 0
                    return 1
                continue
            shape = self.statement(lines, start + 1, first_mark, depth + 1)
            if shape is None:
                return 0
            self.length = start
            if run is None:
                run = []
                runs.append(run)
                own.append(-1)
                self.append("\n")
                self.text[self.length] = 3
                self.length += 1
            run.append(shape)
        return 0

    def line(self, line: str) -> int:
        """Add a line to the shape; 0 where it has none.

        ``controls``: it begins with ``$``. ``opens``: the structures that it opens, -1 closes.
        """
        end = len(line)
        if end > 200:
            return 0
        start = self.length
        marks = self.count
        i = 0
        is_empty = True  # nothing but blanks and comments yet
        is_head = True  # nothing but a skip level yet
        before = " "  # the character in front, and the last one in front that is no blank
        last = " "
        depth = 0  # of brackets; that of those around the number of an element; behind such ones
        element_depth = 0
        behind_element = False
        self.is_name = False
        self.opens = 0
        self.controls = False
        while i < end:
            c = line[i]
            if c == ";":
                break
            if c == "(":
                i = self.comment(line, i, end)
                if i < 0:
                    return 0
                self.add_mark(2, 0.0, i)
                before = " "
                continue
            if c in " \t":
                self.append(c)
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
            self.append(c)
            i += 1
            before = last = c
        while i < end:
            if line[i] == "\0":
                return 0
            i += 1
        if is_empty:
            self.length = start
            self.count = marks
        return self.count - marks <= 24

    def append(self, c: str) -> None:
        """A character of the shape."""
        self.text[self.length] = ord(c)
        self.length += 1

    def is_sign(self, c: str) -> int:
        """Whether it is a sign of expressions and words."""
        return c in "=+-*/,<>&|^!@"

    def add_mark(self, mark: int, value: float, end: int) -> None:
        """A number or comment that ends here."""
        self.text[self.length] = mark
        self.length += 1
        self.ends[self.count] = end
        self.numbers[self.count] = value
        self.count += 1

    def digits(self, line: str, i: int, end: int) -> int:
        """Digits that belong to the shape; where they end."""
        while i < end and ("0" <= line[i] <= "9" or line[i] == "."):
            self.append(line[i])
            i += 1
        return i

    def number(self, line: str, i: int, end: int, is_whole: bool) -> int:
        """A number; where it ends, -1 for one that is not exact or goes on strangely.

        ``is_whole``: it must not have a point.
        """
        stop = self.decimal(line, i, end)
        if stop < 0 or (self.has_point and is_whole):
            return -1
        if stop < end and (line[stop] == "." or line[stop] == "_"):
            return -1
        if self.value == 0.0:
            return self.digits(line, i, end)
        self.add_mark(1, self.value, stop)
        return stop

    def word(self, line: str, i: int, end: int) -> int:
        """Letters with what belongs to them; where that ends, -1 where it has no shape.

        ``is_name``: a variable or parameter, which may have elements. The digits behind one letter
        of an axis, F, I, J, K, N, R are a number, unless the word is a name (``X1=5``).
        """
        first = i
        while i < end and ("A" <= line[i] <= "Z" or "a" <= line[i] <= "z" or line[i] == "_"):
            self.append(line[i])
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
            self.append(line[i])
            i += 1
        if i < end and line[i] == ".":
            return -1
        while not is_one and i < end and self.is_letter_or_digit(line[i]):
            self.append(line[i])
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
            self.append(c)
            i += 1
        return i

    def is_letter_or_digit(self, c: str) -> int:
        """Whether it may stand in a name."""
        return "A" <= c <= "Z" or "a" <= c <= "z" or "0" <= c <= "9" or c == "_"

    def control(self, line: str, i: int, end: int) -> None:
        """Behind ``$``: whether it opens or closes a structure; a second one only jumps."""
        if self.controls:
            self.opens = 0
            return
        self.controls = True
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
