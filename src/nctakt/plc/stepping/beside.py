# SPDX-License-Identifier: MIT
"""Values next to the lines of a PLC's text: the variables named in each, in one instance.

In: lines of a file with the paths that they name, an instance or an open call. Out: texts. A name
has the meaning of its line: a variable of a call has a value only while that call is open, one of a
block only if an instance is chosen.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable as Function
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.failure import Failure
from nctakt.kernel.st import kinds
from nctakt.plc.stepping.places import Call, Place, Places
from nctakt.plc.stepping.shown import PlcValue, Shown
from nctakt.st.program import Program
from nctakt.st.sources import Piece
from nctakt.st.types import ArrayType, BlockType, Callable, Kind, Pou, Storage, StructType

#: Instances of a block that are named at most, and elements of an array that are looked at.
MAX_INSTANCES, MAX_ELEMENTS = 200, 100

#: Maximum rows of a tree, rows below one value, and depth of expansion.
MAX_ROWS, MAX_BELOW, MAX_DEPTH = 1000, 200, 30

#: A line of a file, and the paths that it names.
Line = tuple[int, Sequence[str]]

#: A row of a tree: how deep it is, and its value.
Branch = tuple[int, PlcValue]

#: Nothing is open, and only global variables are seen.
_NO_CALL = Call(Callable("", ""), None, 0, 0)


class Beside:
    """The values of one PLC; ``unit_of``: whose text holds a position."""

    def __init__(
        self,
        program: Program,
        places: Places,
        shown: Shown,
        unit_of: Function[[int], Callable | None],
    ) -> None:
        self._program = program
        self._places = places
        self._shown = shown
        self._unit_of = unit_of
        self._pieces: dict[str, list[Piece]] = {}
        for piece in program.sources.pieces:
            self._pieces.setdefault(piece.file, []).append(piece)
        self._global_starts = sorted(
            (one.start, one.name.lower(), f"{group.name}.{one.name}" if group.name else one.name)
            for group in program.lists
            for one in group.variables.values()
        )

    def texts(
        self, open_call: Call | None, instance: str, file: str, lines: Sequence[Line]
    ) -> list[list[str]]:
        """Return the values of names in lines; "" for one that has none there, or has parts."""
        found = []
        for number, paths in lines:
            places = self._in_line(open_call, instance, file, number)
            values = (self._value(path, *places(path)) for path in paths)
            found.append(["" if one is None or one.count else one.text for one in values])
        return found

    def tree(
        self, open_call: Call | None, instance: str, file: str, line: Line, opened: Sequence[str]
    ) -> list[Branch]:
        """Return the variables of a line as a tree, expanded below the ``opened`` paths."""
        number, paths = line
        places = self._in_line(open_call, instance, file, number)
        found: list[Branch] = []
        for path in paths:
            name, call = places(path)
            value = self._value(path, name, call)
            if value is not None:
                self._unfold(0, replace(value, path=path), (path, name), call, set(opened), found)
        return found

    def _unfold(
        self,
        depth: int,
        value: PlcValue,
        root: tuple[str, str],
        call: Call | None,
        opened: set[str],
        found: list[Branch],
    ) -> None:
        """Add a value and, if it is opened, its children.

        ``root``: the path in the line, and that by which it is found.
        """
        if len(found) >= MAX_ROWS:
            return
        found.append((depth, value))
        if not value.count or value.path not in opened or depth == MAX_DEPTH:
            return
        shown, own = root
        try:
            location = self._places.find(own + value.path[len(shown) :], call)
            inside = [] if location is None else self._shown.below(location, 0, MAX_BELOW)
        except Failure:
            return
        for one in inside:
            path = shown + one.path[len(own) :]
            self._unfold(depth + 1, replace(one, path=path), root, call, opened, found)
        if value.count > len(inside) and len(found) < MAX_ROWS:
            rest = PlcValue("…", f"{value.path} …", "", f"+ {value.count - len(inside)}")
            found.append((depth + 1, rest))

    def _in_line(
        self, open_call: Call | None, instance: str, file: str, number: int
    ) -> Function[[str], tuple[str, Call | None]]:
        """Return what gives for a path of a line the one to look for, and the call that sees it."""
        begin, end = self._stretch(file, number)
        if declared := self._globals_in(begin, end):
            return lambda path: (declared.get(path.lower(), ""), _NO_CALL)
        call = self._call(open_call, instance, end)
        return lambda path: (path, call)

    def _globals_in(self, begin: int, end: int) -> dict[str, str]:
        """Return the global variables that a stretch of text declares, with their paths."""
        starts = self._global_starts
        inside = starts[bisect_left(starts, (begin, "", "")) : bisect_left(starts, (end, "", ""))]
        return {name: path for _, name, path in inside}

    def _call(self, open_call: Call | None, instance: str, position: int) -> Call | None:
        """Return the call in which the names at a position have values; its frame may be none."""
        unit = self._unit_of(position)
        if unit is None:
            return None
        if open_call is not None and open_call.called is unit:
            return open_call
        owner = unit if isinstance(unit, Pou) else getattr(unit, "owner", None)
        if not isinstance(owner, Pou) or owner.type is None:
            return None
        if owner.kind is Kind.PROGRAM:
            return Call(unit, owner, 0, kinds.NULL_BYTES + owner.instance)
        location = self._instance(instance)
        if location is None or not isinstance(location.type, BlockType):
            return None
        is_it = owner in location.type.pou.bases()
        return Call(unit, location.type.pou, 0, location.address) if is_it else None

    def _stretch(self, file: str, line: int) -> tuple[int, int]:
        """Return the positions of the beginning and the end of a line."""
        for piece in self._pieces.get(file, ()):
            index = bisect_right(piece.lines, line) - 1
            if index < 0:
                continue
            offset = piece.offsets[index]
            for _ in range(line - piece.lines[index]):  # empty lines have no place
                offset = piece.text.find("\n", offset) + 1
                if not offset:
                    break
            else:
                end = piece.text.find("\n", offset)
                return piece.base + offset, piece.base + (end if end >= 0 else len(piece.text))
        return 0, 0

    def _instance(self, path: str) -> Place | None:
        try:
            return self._places.find(path, None) if path else None
        except Failure:
            return None

    def _value(self, shown: str, path: str, call: Call | None) -> PlcValue | None:
        """Return the value of a path in a call; ``None`` if it has none there."""
        if call is None or not path:
            return None
        first = path.partition(".")[0].partition("[")[0].partition("^")[0].strip().lower()
        if not call.frame and self._lives_in_call(first, call):
            return None
        try:
            location = self._places.find(path, call)
            return None if location is None else self._shown.value(shown, location)
        except Failure:
            return None

    def _lives_in_call(self, name: str, call: Call) -> bool:
        """Return whether a name belongs to a call's frame."""
        for _, variable in self._places.seen(call):
            if variable.name.lower() == name:
                return variable.storage is Storage.FRAME
        return False

    # --- instances

    def instances(self, file: str) -> list[str]:
        """Return the paths of the instances of the blocks that a file declares."""
        blocks = [
            pou
            for pou in self._program.pous.values()
            if pou.kind is Kind.FUNCTION_BLOCK and self._file_of(pou) == file
        ]
        found: list[str] = []
        for path, location in self._places.roots():
            for one in self._within(replace(location, path=path), blocks):
                found.append(one)
                if len(found) == MAX_INSTANCES:
                    return found
        return found

    def _file_of(self, pou: Pou) -> str:
        piece = self._program.sources.piece_of(pou.start) if pou.start else None
        return "" if piece is None else piece.file

    def _within(self, found: Place, blocks: Sequence[Pou]) -> Iterator[str]:
        """Yield the paths of instances in a variable, itself first."""
        sought = found.type
        if isinstance(sought, ArrayType):
            if isinstance(sought.element, BlockType | StructType | ArrayType):
                elements = self._shown.elements(found)
                for _, (_, one) in zip(range(MAX_ELEMENTS), elements, strict=False):
                    yield from self._within(one, blocks)
            return
        if isinstance(sought, BlockType) and any(one in blocks for one in sought.pou.bases()):
            yield found.path
        if isinstance(sought, BlockType | StructType):
            for _, one in self._places.members(found):
                if one.is_of_call or not isinstance(one.type, BlockType | StructType | ArrayType):
                    continue
                if found.address <= one.address < found.address + max(sought.size, 1):
                    yield from self._within(one, blocks)
