# SPDX-License-Identifier: MIT
"""The results of a study: one row per run, kept as they come, and as a file at the end.

While runs are made, rows stand in ``NAME.rows``: a line that says of which plan, then a line per
run, each written at once, so that whatever ends the process loses no finished run. At the end they
are sorted by the number of the run and become ``NAME`` (Parquet, CSV or JSON lines): the same bytes
whoever has made them.
"""

from __future__ import annotations

import contextlib
import csv
import hashlib
import io
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.machine.machine import load_machine
from nctakt.messages import diagnostic
from nctakt.messages.files import FILE_NOT_READABLE, FILE_NOT_WRITABLE
from nctakt.messages.studies import OTHER_PLAN
from nctakt.project.machine_choice import machine_of
from nctakt.run.tape import digest_of
from nctakt.studies.bench import Row
from nctakt.studies.plan import Plan
from nctakt.trace.arrow import load_pyarrow

if TYPE_CHECKING:
    import pyarrow

#: Rows in one group of a Parquet file.
GROUP = 100_000


def fingerprint(plan: Plan) -> str:
    """Return digits that change with the plan, its program, its PLC and its lists."""
    files = [plan.program, *plan.files]
    if not plan.is_schedule:
        machine = load_machine(plan.machine or machine_of(plan.program, FileAccess()).path)
        files += [path for _, path in machine.lists]
    digests = [digest_of(path) for path in files]
    return hashlib.sha256(f"{plan!r}{digests}".encode()).hexdigest()


class RowStore:
    """The rows of a study in a file, line by line; ``done`` are the numbers of finished runs.

    ``resumes``: go on with the rows that are there. Raises ``Failure``: rows of another plan
    (901309), a file that cannot be written (900507).
    """

    def __init__(self, path: Path, plan: Plan, *, resumes: bool) -> None:
        self.path = path
        self.done: set[int] = set()
        head = json.dumps({"study": fingerprint(plan)})
        length = self._read(head) if resumes else 0
        try:
            flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_BINARY", 0)
            self._file = os.open(path, flags, 0o666)
            os.ftruncate(self._file, length)
            os.lseek(self._file, length, os.SEEK_SET)
        except OSError as error:
            raise self._unwritable(error) from error
        if not length:
            self._write(head + "\n")

    def _read(self, head: str) -> int:
        """Note the finished runs; return the length of what is whole, in bytes."""
        if not self.path.exists():
            return 0
        length = 0
        try:
            with self.path.open("rb") as file:
                for number, line in enumerate(file):
                    if not line.endswith(b"\n"):
                        break
                    if number == 0 and line.decode("utf-8", "replace").rstrip() != head:
                        raise Failure(diagnostic(OTHER_PLAN, folder=self.path.as_posix()))
                    if number:
                        self.done.add(int(_checked(json.loads(line))["run"] or 0))
                    length += len(line)
        except (OSError, ValueError) as error:
            raise _unreadable(self.path, error) from error
        return length

    def add(self, rows: Iterable[Row]) -> None:
        """Keep rows; raises ``Failure`` (900507) if there is no room for them."""
        texts = []
        for row in rows:
            number = row["run"]
            assert isinstance(number, int)
            self.done.add(number)
            texts.append(json.dumps(row, ensure_ascii=False) + "\n")
        self._write("".join(texts))

    def _write(self, text: str) -> None:
        data = text.encode("utf-8")
        try:
            while data:
                data = data[os.write(self._file, data) :]
        except OSError as error:
            raise self._unwritable(error) from error

    def _unwritable(self, error: OSError) -> Failure:
        reason = error.strerror or str(error)
        return Failure(diagnostic(FILE_NOT_WRITABLE, file=self.path.as_posix(), reason=reason))

    def rows(self) -> list[Row]:
        """Return the rows so far, in the order of their runs."""
        return sorted(_lines(self.path), key=lambda row: int(row["run"] or 0))

    def close(self) -> None:
        """Close the file, which stays."""
        with contextlib.suppress(OSError):
            os.close(self._file)

    def remove(self) -> None:
        """Close and remove the file."""
        self.close()
        self.path.unlink(missing_ok=True)


def _lines(path: Path) -> Iterator[Row]:
    with path.open("rb") as file:
        next(file, None)
        for line in file:
            if line.endswith(b"\n"):
                yield json.loads(line)


def check_target(path: Path) -> None:
    """Raise ``Failure`` (901311) if rows cannot be written to a file of this ending."""
    if path.suffix == ".parquet":
        load_pyarrow()


def write_rows(rows: Sequence[Row], columns: Sequence[str], path: Path) -> None:
    """Write rows to a file by its ending: .parquet, .csv, else JSON lines.

    Raises ``Failure``: no pyarrow (901311), a file that cannot be written (900507).
    """
    if path.suffix == ".parquet":
        _write_parquet(rows, columns, path)
        return
    file = OutputFile(path)
    with file:
        if path.suffix == ".csv":
            text = io.StringIO()
            writer = csv.writer(text, lineterminator="\n")
            writer.writerow(columns)
            writer.writerows([row.get(name) for name in columns] for row in rows)
            file.write(text.getvalue())
        else:
            for row in rows:
                file.write(json.dumps(row, ensure_ascii=False) + "\n")


def read_rows(path: Path) -> list[Row]:
    """Return the rows of a file that ``write_rows`` has written.

    Raises ``Failure`` for a file that cannot be read (900500 …), without pyarrow (901311).
    """
    data = FileAccess().read_bytes(path)
    try:
        return [_checked(row) for row in _rows_of(data, path.suffix)]
    except (ValueError, RecursionError, csv.Error) as error:  # of pyarrow, of UTF-8, of JSON
        raise _unreadable(path, error) from error


def _unreadable(path: Path, error: Exception) -> Failure:
    return Failure(diagnostic(FILE_NOT_READABLE, file=path.as_posix(), reason=str(error)))


def _checked(row: Any) -> Row:
    """Return a row; raises ``ValueError`` for what is none."""
    if not isinstance(row, dict) or not isinstance(row.get("verdict"), str):
        raise ValueError("not a row of a study")
    if not isinstance(row.get("run"), int | float):
        raise ValueError("a row without its run")
    return row


def _rows_of(data: bytes, suffix: str) -> list[Row]:
    if suffix == ".parquet":
        table = load_pyarrow("parquet").read_table(io.BytesIO(data))
        rows: list[Row] = table.to_pylist()
        return rows
    if suffix == ".csv":
        return [
            {name: _cell(name, cell) for name, cell in row.items()}
            for row in csv.DictReader(io.StringIO(data.decode("utf-8")))
        ]
    return [json.loads(line) for line in data.decode("utf-8").split("\n") if line]


def _cell(name: str, text: str) -> float | str | None:
    if name in ("state", "verdict", "broken", "digest"):
        return text
    try:
        return float(text)
    except ValueError:
        return text or None


def arrow_table(rows: Sequence[Mapping[str, Any]], columns: Sequence[str]) -> pyarrow.Table:
    """Return rows as an Arrow table; a column that has numbers and texts becomes one of texts.

    Raises ``Failure`` (901311) without pyarrow.
    """
    arrow = load_pyarrow()
    arrays = {}
    for name in columns:
        values = [row.get(name) for row in rows]
        if any(isinstance(value, str) for value in values):
            kept = [None if value is None else str(value) for value in values]
            array = arrow.array(kept, arrow.string())
            arrays[name] = array.dictionary_encode() if name in ("verdict", "state") else array
        elif all(isinstance(value, int) or value is None for value in values):
            arrays[name] = arrow.array(values, arrow.int64())
        else:
            arrays[name] = arrow.array(values, arrow.float64())
    return arrow.table(arrays)


def _write_parquet(rows: Sequence[Row], columns: Sequence[str], path: Path) -> None:
    parquet = load_pyarrow("parquet")
    target = io.BytesIO()
    parquet.write_table(
        arrow_table(rows, columns), target, compression="zstd", row_group_size=GROUP
    )
    file = OutputFile(path)
    with file:
        file.write(target.getvalue())
