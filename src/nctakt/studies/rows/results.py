# SPDX-License-Identifier: MIT
"""The results of a study as a file: one row per run, as Parquet, CSV or JSON lines.

In: rows in the order of their runs. Out: a file, with the same bytes no matter which process made
the rows; and back. Rows are written in groups, so that not all of them need be in memory. The parts
of a study are independent of each other: they can be the jobs of an array, on any machines with a
common folder, and finished parts can be read while others run (``FOLDER/*.parquet``).
"""

from __future__ import annotations

import csv
import io
import itertools
import json
import re
from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import IO, TYPE_CHECKING, Any, overload

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.pictures import WRONG_SUFFIX
from nctakt.messages.files import FILE_NOT_READABLE, NOT_A_REGULAR_FILE
from nctakt.results.trace.arrow import field, load_pyarrow
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.study_runner import EARLIER_VERDICTS, Row

if TYPE_CHECKING:
    import pyarrow

#: No column has a unit.
NO_UNITS: Mapping[str, str] = MappingProxyType({})

#: The suffixes of files with rows.
SUFFIXES = (".parquet", ".csv", ".jsonl")
_SUFFIXES_SHOWN = Text(".parquet, .csv or .jsonl", ".parquet, .csv oder .jsonl")

#: The columns that are always whole numbers.
_COUNTS = ("run", "ticks", "seed")

#: Rows in one group of a Parquet file; rows that are read from one at a time.
GROUP, READ_GROUP = 50_000, 5_000


def check_target(path: Path) -> None:
    """Raise ``Failure`` for another suffix than those of rows (901090) or no pyarrow (901311)."""
    if path.suffix not in SUFFIXES:
        name = path.as_posix()
        raise Failure(diagnostic(WRONG_SUFFIX, file=name, option="--out", suffix=_SUFFIXES_SHOWN))
    if path.suffix == ".parquet":
        load_pyarrow()


def write_rows(
    rows: Iterable[Row],
    columns: Sequence[str],
    path: Path,
    units: Mapping[str, str] = NO_UNITS,
    texts: Collection[str] | None = None,
) -> None:
    """Write rows to a file by its ending: .parquet, .csv, else JSON lines.

    ``units``: those of the columns, which Parquet keeps. ``texts``: the columns of texts, where
    the types must not depend on these rows, because others are in other files; all others but
    counts are then numbers with a fraction. ``rows`` is gone through twice. Raises
    ``Failure``: no pyarrow (901311), a file that cannot be written (900507).
    """
    with OutputFile(path) as file:
        if path.suffix == ".parquet":
            schema = _schema(rows, columns, units, texts)
            file.fill(lambda target: _write_parquet(rows, schema, target))
        elif path.suffix == ".csv":
            file.write(_csv_line(columns))
            for group in in_groups(rows):
                file.write("".join(_csv_line([row.get(name) for name in columns]) for row in group))
        else:
            file.write("")
            for group in in_groups(rows):
                file.write("".join(json.dumps(row, ensure_ascii=False) + "\n" for row in group))


def text_columns(plan: Plan) -> list[str]:
    """Return the inputs of a plan that have texts."""
    return [one.name for one in plan.dimensions if any(isinstance(v, str) for v in one.values)]


def parquet_bytes(
    rows: Sequence[Row], columns: Sequence[str], units: Mapping[str, str], texts: Collection[str]
) -> bytes:
    """Return rows as a Parquet file, with types that do not depend on them (``write_rows``)."""
    arrow, parquet = load_pyarrow(), load_pyarrow("parquet")
    schema = _schema(rows, columns, units, texts)
    target = io.BytesIO()
    parquet.write_table(
        arrow.table(_arrays(rows, schema), schema=schema), target, compression="zstd"
    )
    return target.getvalue()


def _csv_line(cells: Sequence[object]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(cells)
    return text.getvalue()


def in_groups(rows: Iterable[Row]) -> Iterator[list[Row]]:
    iterator = iter(rows)
    while group := list(itertools.islice(iterator, GROUP)):
        yield group


def read_rows(path: Path) -> StreamedRows:
    """Return the rows of a file that ``write_rows`` has written; few of them are in memory.

    Raises ``Failure`` for a file that cannot be read (900500 …), without pyarrow (901311).
    """
    FileAccess().read_begin(path)
    if not path.is_file():  # it could be read only once, and may never end
        raise Failure(diagnostic(NOT_A_REGULAR_FILE, file=path.as_posix()))
    return RowsOfFile(path)


class StreamedRows(Sequence[Row], ABC):
    """Rows that are read again whenever they are gone through."""

    def __init__(self, count: int) -> None:
        self._count = count

    @abstractmethod
    def __iter__(self) -> Iterator[Row]: ...

    def __len__(self) -> int:
        return self._count

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and list(self) == list(other)

    __hash__ = None  # type: ignore[assignment]

    @overload
    def __getitem__(self, index: int) -> Row: ...

    @overload
    def __getitem__(self, index: slice) -> list[Row]: ...

    def __getitem__(self, index: int | slice) -> Row | list[Row]:
        if isinstance(index, slice):
            return [self[number] for number in range(self._count)[index]]
        number = range(self._count)[index]
        return next(itertools.islice(self, number, None))


class RowsOfFile(StreamedRows):
    """The rows of a file of results; raises ``Failure`` (900503) for other files."""

    def __init__(self, path: Path) -> None:
        self._path = path
        super().__init__(sum(1 for _ in self))

    def __iter__(self) -> Iterator[Row]:
        try:
            with self._path.open("rb") as file:
                yield from map(checked_row, _rows_of(file, self._path.suffix))
        except (OSError, ValueError, RecursionError, csv.Error) as error:  # of pyarrow, UTF-8, JSON
            raise unreadable(self._path, error) from error


def unreadable(path: Path, error: Exception) -> Failure:
    """Return the failure for a file of rows that cannot be read (900503)."""
    return Failure(diagnostic(FILE_NOT_READABLE, file=path.as_posix(), reason=str(error)))


def checked_row(row: Any) -> Row:
    """Return a row in the words of this version; raises ``ValueError`` if it is not one."""
    if not isinstance(row, dict) or not isinstance(row.get("verdict"), str):
        raise ValueError("not a row of a study")
    if not isinstance(row.get("run"), int | float):
        raise ValueError("a row without its run")
    verdict = EARLIER_VERDICTS.get(row["verdict"])
    return row if verdict is None else row | {"verdict": verdict}


def _rows_of(file: IO[bytes], suffix: str) -> Iterator[Any]:
    """Yield the rows of an open file."""
    if suffix == ".parquet":
        parquet = load_pyarrow("parquet").ParquetFile(file)
        for batch in parquet.iter_batches(READ_GROUP):
            yield from batch.to_pylist()
        return
    with io.TextIOWrapper(file, "utf-8", newline="") as text:
        if suffix == ".csv":
            for row in csv.DictReader(text):
                yield {name: _cell(name, cell) for name, cell in row.items()}
        else:
            for line in text:
                yield json.loads(line)


def _cell(name: str, text: str) -> float | str | None:
    if name in ("state", "verdict", "broken", "digest"):
        return text
    try:
        return float(text)
    except ValueError:
        return text or None


def arrow_table(
    rows: Iterable[Row], columns: Sequence[str], units: Mapping[str, str] = NO_UNITS
) -> pyarrow.Table:
    """Return rows as an Arrow table; a column that has numbers and texts becomes one of texts.

    Raises ``Failure`` (901311) without pyarrow.
    """
    schema = _schema(rows, columns, units)
    return load_pyarrow().table(_arrays(rows, schema), schema=schema)


def _schema(
    rows: Iterable[Row],
    columns: Sequence[str],
    units: Mapping[str, str],
    fixed_texts: Collection[str] | None = None,
) -> pyarrow.Schema:
    """Return types and units of the columns: texts, else numbers with a fraction, else whole."""
    arrow = load_pyarrow()
    texts = {"state", "verdict", "broken", "digest", *(fixed_texts or ())}
    fractions = set(columns).difference(_COUNTS)
    if fixed_texts is None:
        texts, fractions = set(), set()
    for row in rows if fixed_texts is None else ():
        for name, value in row.items():
            if isinstance(value, str):
                texts.add(name)
            elif isinstance(value, float):
                fractions.add(name)

    def type_of(name: str) -> pyarrow.DataType:
        if name in texts and name in ("verdict", "state"):
            return arrow.dictionary(arrow.int32(), arrow.string())
        if name in texts:
            return arrow.string()
        return arrow.float64() if name in fractions else arrow.int64()

    return arrow.schema([field(name, type_of(name), units.get(name, "")) for name in columns])


def _arrays(rows: Iterable[Row], schema: pyarrow.Schema) -> list[pyarrow.Array]:
    """Return the columns of rows."""
    arrow = load_pyarrow()
    arrays = []
    columns = [[row.get(name) for row in rows] for name in schema.names]
    for values, own in zip(columns, schema.types, strict=True):
        if arrow.types.is_floating(own) or arrow.types.is_integer(own):
            arrays.append(arrow.array(values, own))
        else:
            kept = [None if value is None else str(value) for value in values]
            arrays.append(arrow.array(kept, arrow.string()).cast(own))
    return arrays


def _write_parquet(rows: Iterable[Row], schema: pyarrow.Schema, path: Path) -> None:
    arrow, parquet = load_pyarrow(), load_pyarrow("parquet")
    with parquet.ParquetWriter(path, schema, compression="zstd") as writer:
        for group in in_groups(rows):
            writer.write_table(arrow.table(_arrays(group, schema), schema=schema))


# --- a study in parts -----------------------------------------------------------------------------


_PART = re.compile(r"(\d{1,9})/(\d{1,9})")
_FILE = re.compile(r"part-(\d+)-of-(\d+)\.parquet")


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a study: ``number`` from 1 to ``count``."""

    number: int
    count: int

    def runs(self, size: int) -> range:
        """Return the numbers of its runs."""
        return range(size * (self.number - 1) // self.count, size * self.number // self.count)

    def file(self, folder: Path) -> Path:
        """Return its file in a folder."""
        width = len(str(self.count))
        return folder / f"part-{self.number:0{width}}-of-{self.count}.parquet"


def parse_part(text: str) -> Part | None:
    """Return the part named by a text, ``3/10``; ``None`` for any other text."""
    match = _PART.fullmatch(text)
    if match is None or not 1 <= int(match[1]) <= int(match[2]):
        return None
    return Part(int(match[1]), int(match[2]))


class RowsOfParts(StreamedRows):
    """The rows of the parts in a folder, in the order of their runs.

    ``missing``: the numbers of the parts that it does not have; raises ``Failure`` as
    ``RowsOfFile``.
    """

    def __init__(self, folder: Path) -> None:
        found: dict[int, dict[int, Path]] = {}
        for path in sorted(folder.iterdir()):
            match = _FILE.fullmatch(path.name)
            if match is not None:
                found.setdefault(int(match[2]), {})[int(match[1])] = path
        self.counts = sorted(found)
        count = self.counts[0] if len(found) == 1 else 0
        parts = found.get(count, {})
        self.missing = [number for number in range(1, count + 1) if number not in parts]
        self._files = [RowsOfFile(parts[number]) for number in sorted(parts)]
        super().__init__(sum(map(len, self._files)))

    def __iter__(self) -> Iterator[Row]:
        for rows in self._files:
            yield from rows
