# SPDX-License-Identifier: MIT
"""Text files of any length -> their lines, without having all of them in memory.

In: a file. Out: a sequence of lines. The rules are those of ``base/text.py``; a short file is read
at once. For a long file the encoding and the offsets of some lines are found in one pass, then
lines are read on request: forward without delay, elsewhere from the last offset before them.
"""

from __future__ import annotations

import codecs
import os
import re
import stat
from array import array
from collections.abc import Iterator, Sequence
from itertools import accumulate
from pathlib import Path
from typing import BinaryIO, overload

from nctakt.base.text import WINDOWS_1252, split_lines

#: Size of a file that is read at once, in bytes.
SHORT_FILE_BYTES = 1_000_000

#: Lines of a group: they are read together, and the offset of the first is stored.
LINES_PER_GROUP = 512

#: Maximum size of a group, in bytes.
MAX_GROUP_BYTES = 64 << 20

_CHUNK_BYTES = 1 << 20
_LINE_END = re.compile(rb"\r\n|\n|\r")
_UTF8_MARK = b"\xef\xbb\xbf"
_UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")


class LinesTooLong(Exception):
    """A group of lines has more than ``MAX_GROUP_BYTES``."""


class TextChanged(Exception):
    """A file has changed or gone since its lines were found; ``path`` is its name."""

    def __init__(self, path: Path) -> None:
        super().__init__(str(path))
        self.path = path


def is_long(file: BinaryIO) -> bool:
    """Return whether a file is read as ``LongText``: a plain one, long, and not UTF-16."""
    state = os.fstat(file.fileno())
    if not stat.S_ISREG(state.st_mode) or state.st_size <= SHORT_FILE_BYTES:
        return False
    is_utf16 = file.read(2).startswith(_UTF16_MARKS)
    file.seek(0)
    return not is_utf16


class LongText(Sequence[str]):
    """The lines of one file; equal to another if path, size and time of change are.

    Raises ``OSError``, and ``LinesTooLong`` for a file that is not a text of lines. Once the file
    has changed, reading on raises ``TextChanged``, and a line by its number is empty.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._identity = (str(path), *_state_of(path.stat()))
        self._offsets = array("Q")
        self._count = 0
        self._is_utf8 = True
        with path.open("rb") as file:
            self._scan(file)
        self._group = -1
        self._lines: list[str] = []

    def _scan(self, file: BinaryIO) -> None:
        """Find the encoding, the number of lines and the offset of each group."""
        decoder = codecs.getincrementaldecoder("utf-8")()
        offset = len(_UTF8_MARK) if file.read(3) == _UTF8_MARK else 0
        file.seek(offset)
        chunk_begin, rest = offset, b""  # the offset of the chunk; bytes of the one before it
        line_begin = offset
        while True:
            chunk = file.read(_CHUNK_BYTES)
            self._check_encoding(decoder, chunk)
            data = rest + chunk
            # A carriage return at the very end may be half of a line end.
            usable = len(data) - 1 if chunk and data.endswith(b"\r") else len(data)
            if b"\r" not in data:
                line_begin = self._add_lines(data, chunk_begin, line_begin)
            else:
                for line_end in _LINE_END.finditer(data, 0, usable):
                    self._add_line(line_begin)
                    line_begin = chunk_begin + line_end.end()
            if not chunk:
                end = chunk_begin + len(data)
                break
            rest = data[usable:]
            chunk_begin += usable
        if line_begin < end:
            self._add_line(line_begin)
        self._offsets.append(end)
        groups = zip(self._offsets, self._offsets[1:], strict=False)
        if any(last - first > MAX_GROUP_BYTES for first, last in groups):
            raise LinesTooLong

    def _add_line(self, begin: int) -> None:
        if self._count % LINES_PER_GROUP == 0:
            self._offsets.append(begin)
        self._count += 1

    def _add_lines(self, data: bytes, begin: int, line_begin: int) -> int:
        """Add the lines that a newline in ``data`` ends; return the offset of the line after them.

        ``data`` is at ``begin`` in the file, its first line begins at ``line_begin``.
        """
        lengths = list(accumulate(map(len, data.split(b"\n"))))
        count = len(lengths) - 1
        for line in range(-self._count % LINES_PER_GROUP, count, LINES_PER_GROUP):
            self._offsets.append(begin + lengths[line - 1] + line if line else line_begin)
        self._count += count
        return begin + lengths[count - 1] + count if count else line_begin

    def _check_encoding(self, decoder: codecs.IncrementalDecoder, chunk: bytes) -> None:
        if not self._is_utf8:
            return
        try:
            decoder.decode(chunk, final=not chunk)
        except UnicodeDecodeError:
            self._is_utf8 = False

    def _read(self, file: BinaryIO, group: int) -> list[str]:
        """Return the lines of a group.

        Copies of a process share the place in an open file, so it is neither used nor moved.
        """
        begin, end = self._offsets[group], self._offsets[group + 1]
        data = _bytes_at(file.fileno(), begin, end - begin)
        if _state_of(os.fstat(file.fileno())) != self._identity[1:]:
            raise TextChanged(self._path)
        if self._is_utf8:
            return split_lines(data.decode("utf-8", errors="replace"))
        return split_lines(data.decode("latin-1").translate(WINDOWS_1252))

    def _opened(self) -> BinaryIO:
        try:
            return self._path.open("rb", buffering=0)
        except OSError as error:
            raise TextChanged(self._path) from error

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[str]:
        return self.from_line(0)

    def from_line(self, first: int) -> Iterator[str]:
        """Yield the lines from index ``first`` on."""
        for group in self.groups(first):
            yield from group

    def groups(self, first: int) -> Iterator[list[str]]:
        """Yield the lines from index ``first`` on, some at a time."""
        with self._opened() as file:
            for group in range(first // LINES_PER_GROUP, len(self._offsets) - 1):
                lines = self._read(file, group)
                yield lines[max(0, first - group * LINES_PER_GROUP) :]

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> list[str]: ...

    def __getitem__(self, index: int | slice) -> str | list[str]:
        if isinstance(index, slice):
            return [self[number] for number in range(*index.indices(self._count))]
        if index < 0:
            index += self._count
        if not 0 <= index < self._count:
            raise IndexError(index)
        group = index // LINES_PER_GROUP
        if group != self._group:
            try:
                with self._opened() as file:
                    self._lines = self._read(file, group)
            except TextChanged:
                return ""  # only shown with a message; it is no longer known
            self._group = group
        return self._lines[index % LINES_PER_GROUP]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LongText) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)


def _state_of(state: os.stat_result) -> tuple[int, int]:
    """Return a key that changes with the content of a file: its size and modification time."""
    return state.st_size, state.st_mtime_ns


def _bytes_at(descriptor: int, offset: int, count: int) -> bytes:
    """Return up to ``count`` bytes of a file from an offset on; where it can, without its place."""
    data = b""
    while len(data) < count:
        if hasattr(os, "pread"):
            more = os.pread(descriptor, count - len(data), offset + len(data))
        else:
            os.lseek(descriptor, offset + len(data), os.SEEK_SET)
            more = os.read(descriptor, count - len(data))
        if not more:
            break
        data += more
    return data
