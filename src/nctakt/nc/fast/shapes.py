# SPDX-License-Identifier: MIT
"""Shapes of statements: their text without numbers and comments.

In: lines. Out: the ``Shape`` of the statement that begins there, its numbers, and the end of each
number and comment. Generated programs repeat statements of the same shape with other numbers. A
number that is a value (``X10``, ``[3 * P1]``) and not 0 is not part of the shape; the numbers of
functions, parameters and elements (``G01``, ``P1``, ``V.P.A[2]``) are. The shape of a structure is
that of its ``$`` lines; the statements between them are *runs*, each with its own shape. Statements
with a label, a quoted text, ``#`` or ``%``, and long ones, have no shape; the parser reads them.
"""

from __future__ import annotations

from nctakt.nc.fast.line_scanner import LineScanner

#: Marks in a shape: a number, a comment, a run.
NUMBER = 1
COMMENT = 2
RUN = 3

#: Limits of a statement with a shape: marks, lines, characters, nested structures.
MAX_MARKS = 200
MAX_LINES = 400
MAX_TEXT = 4000
MAX_DEPTH = 20

#: Limits of one line: characters, marks.
LONGEST_LINE = 200
MAX_MARKS_OF_LINE = 24


class Shape:
    """The shape of one statement: its ``key``, and the parts that vary.

    ``lines``: the indices of its lines in the group read. ``numbers``: the values of its numbers, 0
    for a comment; ``ends``: their end columns. ``runs``: the statements inside it.
    """

    def __init__(self, key: bytes) -> None:
        self.key = key
        self.lines: list[int] = []
        self.numbers: list[float] = []
        self.ends: list[int] = []
        self.runs: list[list[Shape]] = []

    def is_of(self, keys: set[bytes]) -> int:
        """Return whether its key and those of all statements inside it are in ``keys``."""
        if self.key not in keys:
            return 0
        for run in self.runs:
            for inside in run:
                if not inside.is_of(keys):
                    return 0
        return 1


class ShapeScanner(LineScanner):
    """Finds shapes; ``shape``: the last one or ``None``; ``index``: the line after it.

    Of a line: ``depth``: of its brackets, ``element_depth``: of those of an index, 0 outside.
    ``behind_element``: the last bracket ends an index.
    """

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
        self.depth = 0
        self.element_depth = 0
        self.behind_element = False

    def skip_known(self, lines: list[str], index: int, keys: set[bytes]) -> int:
        """Return the index of the first line that is neither empty nor of a known shape.

        ``shape`` is then the shape of that line.
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
        """Find the shape of the statement at ``lines[index]``; return its number of lines.

        An empty line counts one, without a ``shape``; 0 means that there is no shape.
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
        """Return the statement whose first line, ``lines[index]``, has just been added.

        ``start``, ``first_mark``: the start of its text and marks, which are removed again.
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
        """Read the rest of a structure: ``$`` lines into its shape, others into its runs."""
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
        """Add a line to the shape; return 0 if it cannot be part of one.

        ``controls``: it begins with ``$``. ``opens``: 1 if it opens a structure, -1 if it closes
        one.
        """
        end = len(line)
        if end > 200:
            return 0
        start = self.length
        marks = self.count
        i = 0
        is_empty = True  # only blanks and comments so far
        is_head = True  # only a skip level so far
        before = " "  # previous character; previous character other than a blank
        last = " "
        self.begin_line()
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
                i = self.figure(line, i, end, before, last, is_head)
                if i < 0:
                    return 0
                before = last = "0"
                is_head = False
            elif "A" <= c <= "Z" or "a" <= c <= "z" or c == "_":
                i = self.word(line, i, end)
                if i < 0:
                    return 0
                self.open_index(line, i, end)
                before = last = line[i - 1]
                is_head = False
            else:
                if not self.sign(line, i, end, before):
                    return 0
                is_head = c == "/" and is_head and last == " "
                self.append(c)
                i += 1
                before = last = c
        if is_empty:
            self.length = start
            self.count = marks
        return self.count - marks <= 24 and not self.has_nul(line, i, end)

    def begin_line(self) -> None:
        """Reset the state of the previous line."""
        self.depth = 0
        self.element_depth = 0
        self.behind_element = False
        self.is_name = False
        self.opens = 0
        self.controls = False

    def open_index(self, line: str, i: int, end: int) -> None:
        """Note where the index of an element begins after a name."""
        if i < end and line[i] == "[" and self.is_name and self.element_depth == 0:
            self.element_depth = self.depth + 1

    def figure(self, line: str, i: int, end: int, before: str, last: str, is_head: bool) -> int:
        """Read an index, a skip level, a value or the member of an element.

        Return its end, -1 without a shape. ``before``, ``last``: the character before it, and that
        other than a blank; ``is_head``: nothing but a skip level comes before it.
        """
        if line[i] == "." and before == "]":
            i = self.name(line, i, end)
            self.open_index(line, i, end)
            return i
        if line[i] == "." and not (i + 1 < end and "0" <= line[i + 1] <= "9"):
            return -1
        if self.element_depth > 0 or (last == "/" and is_head):
            return self.digits(line, i, end)
        return self.number(line, i, end, last in "Nn")

    def sign(self, line: str, i: int, end: int, before: str) -> int:
        """Follow brackets and ``$``; return 0 for a character that no shape has.

        ``before``: the character before it.
        """
        c = line[i]
        if c == "[":
            self.depth += 1
            if before == "]" and self.behind_element and self.element_depth == 0:
                self.element_depth = self.depth
        elif c == "]":
            self.behind_element = self.depth == self.element_depth
            if self.behind_element:
                self.element_depth = 0
            self.depth -= 1
        elif c == "$":
            self.control(line, i + 1, end)
        else:
            return self.is_sign(c)
        return 1

    def has_nul(self, line: str, i: int, end: int) -> int:
        """Return whether the comment that ends the line contains a NUL."""
        while i < end:
            if line[i] == "\0":
                return 1
            i += 1
        return 0

    def append(self, c: str) -> None:
        """Append a character to the shape."""
        self.text[self.length] = ord(c)
        self.length += 1

    def is_sign(self, c: str) -> int:
        """Return whether it is a sign of expressions and words."""
        return c in "=+-*/,<>&|^!@"

    def add_mark(self, mark: int, value: float, end: int) -> None:
        """Append the mark of a number or comment that ends at column ``end``."""
        self.text[self.length] = mark
        self.length += 1
        self.ends[self.count] = end
        self.numbers[self.count] = value
        self.count += 1

    def digits(self, line: str, i: int, end: int) -> int:
        """Append digits that belong to the shape; return their end."""
        while i < end and ("0" <= line[i] <= "9" or line[i] == "."):
            self.append(line[i])
            i += 1
        return i

    def number(self, line: str, i: int, end: int, is_whole: bool) -> int:
        """Read a number; return its end, -1 if it is inexact or oddly continued.

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
        """Read letters with the parts that belong to them; return their end, -1 without a shape.

        ``is_name``: a variable or parameter, which may have elements. The digits after a single
        letter of an axis, F, I, J, K, N, R are a number, unless the word is a name (``X1=5``).
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
        """Return whether the number after a letter is a value."""
        return c in "ABCFIJKNQRUVWXYZabcfijknqruvwxyz"

    def name(self, line: str, i: int, end: int) -> int:
        """Append the rest of a name with its members; return its end."""
        self.is_name = True
        while i < end:
            c = line[i]
            if not self.is_letter_or_digit(c) and c != ".":
                break
            self.append(c)
            i += 1
        return i

    def is_letter_or_digit(self, c: str) -> int:
        """Return whether it may be part of a name."""
        return "A" <= c <= "Z" or "a" <= c <= "z" or "0" <= c <= "9" or c == "_"

    def control(self, line: str, i: int, end: int) -> None:
        """Set ``opens`` for the word after ``$``; a second ``$`` in a line is a jump."""
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
