# SPDX-License-Identifier: MIT
"""The rows of a study while its runs are made, and in the order of their runs afterwards.

They are in ``NAME.rows``: a line that identifies the plan, then a line per run, each written at
once, so that no finished run is lost however the process ends. Which runs are finished takes a bit
of memory for each. Rows that came out of order are sorted in parts of bounded size, to a file next
to it, so that a study may have more rows than memory holds. A file of that name that no study has
written is left alone.
"""

from __future__ import annotations

import contextlib
import hashlib
import heapq
import json
import os
import tempfile
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO, Protocol

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import NOT_ROWS_OF_A_STUDY, OTHER_PLAN
from nctakt.messages.files import FILE_NOT_WRITABLE, OUTPUT_IN_USE
from nctakt.run.access.tape import digest_of
from nctakt.studies.plans.plan import Plan
from nctakt.studies.rows.results import StreamedRows, checked_row, unreadable
from nctakt.studies.runs.plan_files import files_of
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

#: The begin of the first line.
_HEAD = b'{"study": "'

#: Maximum bytes of rows kept in memory; more stay in their file.
MAX_KEPT = 16 << 20

#: Bytes of rows that are sorted at a time, and the most parts: each is a file that is open.
MAX_SORTED, MAX_PARTS = 64 << 20, 500


def fingerprint(plan: Plan, purpose: str = "") -> str:
    """Return digits that change with the plan and with all files that its runs depend on.

    ``purpose``: further identifies the runs.
    """
    needed = files_of(plan)
    files = [*needed.files, *needed.modules.files]
    digests = [digest_of(path) for path in files]
    return hashlib.sha256(f"{plan!r}{digests}{purpose}".encode()).hexdigest()


class RowStore:
    """The rows of a study in a file, line by line; ``done`` are the numbers of finished runs.

    ``resumes``: continue the existing rows; ``purpose``: identifies the rows further than the plan.
    Raises ``Failure``: rows of another plan or purpose (901309), an existing file without rows
    (902023), or cannot be written (900507).
    """

    def __init__(self, path: Path, plan: Plan, *, resumes: bool, purpose: str = "") -> None:
        self.path = path
        self.name = path.as_posix()
        self.folder = None
        self.done = RunNumbers()
        self._is_sorted = True
        self._last = -1
        self._sorted: Path | None = None
        head = json.dumps({"study": fingerprint(plan, purpose)})
        flags = os.O_RDWR | getattr(os, "O_BINARY", 0)
        try:
            try:
                self._file = os.open(path, flags | os.O_CREAT | os.O_EXCL, 0o666)
            except FileExistsError:
                _check_rows(path)
                self._file = os.open(path, flags)
        except OSError as error:
            raise _unwritable(self.path, error) from error
        open_stores.add(self)
        try:
            lock(self._file, path)
            length = self._read(head) if resumes else 0
            os.ftruncate(self._file, length)
            os.lseek(self._file, length, os.SEEK_SET)
        except OSError as error:
            self.leave()
            raise _unwritable(self.path, error) from error
        except Failure:
            self.leave()
            raise
        if not length:
            self._write(f"{head}\n".encode())

    def _read(self, head: str) -> int:
        """Note the finished runs; return the length of the complete part, in bytes."""
        length = 0
        try:
            with self.path.open("rb") as file:
                for number, line in enumerate(file):
                    if not line.endswith(b"\n"):
                        break
                    if number == 0 and line.decode("utf-8", "replace").rstrip() != head:
                        raise Failure(diagnostic(OTHER_PLAN, folder=self.path.as_posix()))
                    if number:
                        self._note(int(checked_row(json.loads(line))["run"] or 0))
                    length += len(line)
        except (OSError, ValueError) as error:
            raise unreadable(self.path, error) from error
        return length

    def _note(self, number: int) -> None:
        self._is_sorted &= number > self._last
        self._last = number
        self.done.add(number)

    def add(self, block: RowBlock) -> None:
        """Keep rows; raises ``Failure`` (900507) if there is no room for them."""
        for number in block.numbers:
            self._note(number)
        self._write(block.lines)

    def _write(self, data: bytes) -> None:
        try:
            while data:
                data = data[os.write(self._file, data) :]
        except OSError as error:
            raise _unwritable(self.path, error) from error

    def rows(self) -> StoredRows:
        """Return the rows so far, in the order of their runs.

        Raises ``Failure`` (900507) if there is no room to sort them.
        """
        path = self.path
        if not self._is_sorted and path.stat().st_size > MAX_KEPT:
            try:
                path = self._sorted = self._sorted or _new_file(path, ".sorted")
                _sort(self.path, path)
            except OSError as error:
                raise _unwritable(path, error) from error
        return StoredRows(path, len(self.done))

    def close(self) -> None:
        """Close the file, which stays."""
        if self._sorted is not None:
            self._sorted.unlink(missing_ok=True)
            self._sorted = None
        self.leave()

    def leave(self) -> None:
        """Close the file as a copy of the process that has it does; others may then have it."""
        if self._file >= 0:
            with contextlib.suppress(OSError):
                os.close(self._file)
            self._file = -1

    def remove(self) -> None:
        """Close and remove the file."""
        if fcntl is not None:  # while it is ours; elsewhere an open file cannot be removed
            self.path.unlink(missing_ok=True)
        self.close()
        if fcntl is None:
            self.path.unlink(missing_ok=True)


class LeftByCopies(Protocol):
    """Actions that a copy of the process leaves to the process itself."""

    def leave(self) -> None:
        """Close open files, without changing any."""


def lock(file: int, path: Path) -> None:
    """Keep other studies from writing an open file; raises ``Failure`` (900919)."""
    if fcntl is None:
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        is_ours = os.path.samestat(os.fstat(file), path.stat())
    except (BlockingIOError, FileNotFoundError):
        is_ours = False
    if not is_ours:  # another study writes it, or has just finished and removed it
        raise Failure(diagnostic(OUTPUT_IN_USE, file=path.as_posix()))


#: The stores of this process that are open: its copies, which make runs, must not hold their locks.
open_stores: weakref.WeakSet[LeftByCopies] = weakref.WeakSet()


def _leave_stores() -> None:
    for store in list(open_stores):
        store.leave()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_stores)


class StoredRows(StreamedRows):
    """The rows of a file in the order of their runs; few of them in memory, if they are many."""

    def __init__(self, path: Path, count: int) -> None:
        super().__init__(count)
        self._path = path
        self._rows: list[Row] | None = None
        if path.stat().st_size <= MAX_KEPT:
            self._rows = sorted(self._lines(), key=lambda row: int(row["run"] or 0))

    def __iter__(self) -> Iterator[Row]:
        return iter(self._lines() if self._rows is None else self._rows)

    def _lines(self) -> Iterator[Row]:
        with self._path.open("rb") as file:
            next(file, None)
            for line in file:
                if line.endswith(b"\n"):
                    yield json.loads(line)


class RunNumbers:
    """A set of numbers of runs, a bit for each."""

    def __init__(self) -> None:
        self._bits = bytearray()
        self._count = 0

    def add(self, number: int) -> None:
        """Add a number from 0 on."""
        index, bit = number >> 3, 1 << (number & 7)
        if index >= len(self._bits):
            self._bits.extend(bytes(index - len(self._bits) + 1))
        self._count += not self._bits[index] & bit
        self._bits[index] |= bit

    def __contains__(self, number: int) -> bool:
        index = number >> 3
        return index < len(self._bits) and bool(self._bits[index] & 1 << (number & 7))

    def __len__(self) -> int:
        return self._count


def _check_rows(path: Path) -> None:
    """Raise ``Failure`` (902023) for a file that does not begin as rows of a study do."""
    begin = FileAccess().read_begin(path) if path.is_file() else b""
    if not begin.startswith(_HEAD):
        raise Failure(diagnostic(NOT_ROWS_OF_A_STUDY, file=path.as_posix()))


def _new_file(beside: Path, suffix: str) -> Path:
    """Return a new file next to another; raises ``OSError``."""
    number, name = tempfile.mkstemp(suffix, f"{beside.name}.", beside.parent)
    os.close(number)
    return Path(name)


def _unwritable(path: Path, error: OSError) -> Failure:
    reason = error.strerror or str(error)
    return Failure(diagnostic(FILE_NOT_WRITABLE, file=path.as_posix(), reason=reason))


def _run_of(line: Any) -> int:
    """Return the number of the run of a line, which comes first in it."""
    return int(line[: line.index(b",")].rpartition(b":")[2])


def _sort(source: Path, target: Path) -> None:
    """Write the lines of a file in the order of their runs, after its first line.

    Parts that fit in memory are sorted and written in turn, then merged.
    """
    parts = _new_file(source, ".parts")
    try:
        with source.open("rb") as file, parts.open("wb") as sorted_parts:
            head = next(file)
            spans = []
            size = max(MAX_SORTED, source.stat().st_size // MAX_PARTS)
            while lines := file.readlines(size):
                lines = [line for line in lines if line.endswith(b"\n")]
                lines.sort(key=_run_of)
                begin = sorted_parts.tell()
                sorted_parts.writelines(lines)
                spans.append((begin, sorted_parts.tell()))
        with contextlib.ExitStack() as stack:
            merged = stack.enter_context(target.open("wb"))
            merged.write(head)
            files = (stack.enter_context(parts.open("rb")) for _ in spans)
            streams = [_span(file, *span) for file, span in zip(files, spans, strict=True)]
            ordered: Iterator[bytes] = heapq.merge(*streams, key=_run_of)
            merged.writelines(ordered)
    finally:
        parts.unlink(missing_ok=True)


def _span(file: BinaryIO, begin: int, end: int) -> Iterator[bytes]:
    """Yield the lines of a part of a file."""
    file.seek(begin)
    while begin < end:
        line = file.readline()
        begin += len(line)
        yield line
