# SPDX-License-Identifier: MIT
"""A folder of Parquet parts: each is written by the process that made its runs, and then stays.

In: rows of runs, a folder: a path or an address that fsspec knows (``s3://bucket/study``). Out: its
parts, ``batch=000000/run-FIRST-LAST-COUNT.parquet``. A part is there as a whole or not at all, so
that polars, pandas and DuckDB can read the folder while a study runs.
"""

from __future__ import annotations

import heapq
import io
import json
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING, FOLDER_HAS_RESULTS, OTHER_PLAN
from nctakt.messages.extras import install_command
from nctakt.messages.files import FILE_NOT_READABLE, FILE_NOT_WRITABLE
from nctakt.results.trace.arrow import load_pyarrow
from nctakt.studies.plans.plan import COVERAGE, Plan
from nctakt.studies.rows.results import StreamedRows, checked_row, parquet_bytes, text_columns
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row, columns_of

#: Runs of a batch, which is a separate folder.
BATCH = 1_000_000

#: The file that says of which plan the parts are.
_HEAD = "_study.json"

_PART = re.compile(r"run-(\d+)-(\d+)-(\d+)\.parquet")


def is_folder(name: str) -> bool:
    """Return whether a name of ``--out`` means a folder: an address, or with a slash at its end."""
    return "://" in name or name.endswith(("/", os.sep)) or Path(name).is_dir()


@dataclass(frozen=True, slots=True, order=True)
class Part:
    """A part by its numbers: of its first and last run, and how many it has."""

    first: int
    last: int
    count: int

    @property
    def name(self) -> str:
        """Its name in the folder."""
        name = f"run-{self.first:012}-{self.last:012}-{self.count}.parquet"
        return f"batch={self.first // BATCH:06}/{name}"


class PartFolder:
    """The folder of a study's results, on this machine or elsewhere; copies of it can be sent.

    ``covers``: the rows are those of ``--cover``, with the counts of their branches. Raises
    ``Failure``: no package fsspec (901311), files that cannot be read or written (900503, 900507).
    """

    def __init__(
        self, address: str, plan: Plan, units: dict[str, str], *, covers: bool = False
    ) -> None:
        self.address = address.rstrip("/") if "://" in address else str(Path(address).absolute())
        counts = [COVERAGE] if covers else []
        self._columns = columns_of(plan) + counts
        self._texts = text_columns(plan) + counts
        self._units = units
        self._open()

    def _open(self) -> None:
        try:
            from fsspec.core import url_to_fs  # noqa: PLC0415 - an extra
        except ImportError as error:
            raise Failure(
                diagnostic(EXTRA_MISSING, package="fsspec", install=install_command("data"))
            ) from error
        with _Reported(self.address):
            self._files, self._root = url_to_fs(self.address)
        self.is_local = "file" in self._files.protocol

    def __getstate__(self) -> dict[str, Any]:
        """Return all but the connection, which each process makes for itself."""
        return {name: value for name, value in vars(self).items() if name != "_files"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._open()

    def begin(self, fingerprint: str, *, resumes: bool) -> None:
        """Begin a study in the folder, or continue one.

        Raises ``Failure``: results are there (902690), or those of another plan (901309).
        """
        head, path = json.dumps({"study": fingerprint}).encode(), f"{self._root}/{_HEAD}"
        with _Reported(self.address):
            self._files.invalidate_cache()
            known = self._files.cat_file(path) if self._files.exists(path) else None
        if known is not None and not resumes:
            raise Failure(diagnostic(FOLDER_HAS_RESULTS, folder=self.address))
        if known is not None and known != head:
            raise Failure(diagnostic(OTHER_PLAN, folder=self.address))
        if known is None:
            self._put(_HEAD, head)

    def written(self, block: RowBlock) -> RowBlock:
        """Write the rows of a block as a part; return the block without them."""
        if block.numbers:
            part = Part(min(block.numbers), max(block.numbers), len(block))
            data = parquet_bytes(block.rows, self._columns, self._units, self._texts)
            self._put(part.name, data)
        return block.without_rows()

    def _put(self, name: str, data: bytes) -> None:
        """Write a file atomically: as a whole or not at all."""
        path = f"{self._root}/{name}"
        with _Reported(self.address):
            if not self.is_local:
                self._files.pipe_file(path, data)
                return
            target = Path(path)
            beside = target.with_name(f"{target.name}.{os.getpid()}.tmp")
            target.parent.mkdir(parents=True, exist_ok=True)
            try:
                beside.write_bytes(data)
                beside.replace(target)
            except OSError:
                beside.unlink(missing_ok=True)
                raise

    def parts(self) -> list[Part]:
        """Return the existing parts, in the order of their first runs."""
        with _Reported(self.address, is_read=True):
            self._files.invalidate_cache()
            found = self._files.glob(f"{self._root}/batch=*/*.parquet")
        matches = (_PART.fullmatch(path.rpartition("/")[2]) for path in found)
        return sorted(Part(*map(int, match.groups())) for match in matches if match)

    def numbers(self, part: Part) -> Iterable[int]:
        """Return the numbers of the runs of a part."""
        if part.last - part.first + 1 == part.count:
            return range(part.first, part.last + 1)
        numbers: list[int] = self._table(part, ["run"]).column("run").to_pylist()
        return numbers

    def rows(self, part: Part) -> Iterator[Row]:
        """Yield the rows of a part."""
        yield from map(checked_row, self._table(part, None).to_pylist())

    def _table(self, part: Part, columns: list[str] | None) -> Any:
        parquet = load_pyarrow("parquet")
        with _Reported(f"{self.address}/{part.name}", is_read=True):
            data = self._files.cat_file(f"{self._root}/{part.name}")
            return parquet.ParquetFile(io.BytesIO(data)).read(columns)


class RowsOfFolder(StreamedRows):
    """The rows of a folder in the order of their runs, each once; few of them are in memory."""

    def __init__(self, folder: PartFolder) -> None:
        self._folder = folder
        self._parts = folder.parts()
        super().__init__(sum(1 for _ in self._merged(folder.numbers)))

    def __iter__(self) -> Iterator[Row]:
        return self._merged(self._folder.rows)

    def _merged(self, read: Any) -> Iterator[Any]:
        """Yield the rows that ``read`` returns for the parts; overlapping parts are merged."""
        previous = -1
        for group in _overlapping(self._parts):
            for one in heapq.merge(*map(read, group), key=_number_of):
                if _number_of(one) != previous:
                    yield one
                previous = _number_of(one)


def _number_of(one: int | Row) -> int:
    return one if isinstance(one, int) else int(one["run"] or 0)


def _overlapping(parts: Sequence[Part]) -> Iterator[list[Part]]:
    """Yield parts in groups of which each ends before the next begins."""
    group: list[Part] = []
    last = -1
    for part in parts:
        if group and part.first > last:
            yield group
            group = []
        group.append(part)
        last = max(last, part.last)
    if group:
        yield group


class _Reported:
    """Raise ``Failure`` for anything a storage raises: each has its own errors."""

    def __init__(self, address: str, *, is_read: bool = False) -> None:
        self._message = FILE_NOT_READABLE if is_read else FILE_NOT_WRITABLE
        self._address = address

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, Exception) and not isinstance(error, Failure):
            reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
            found = diagnostic(self._message, file=self._address, reason=reason)
            raise Failure(found) from error
