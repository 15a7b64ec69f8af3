# SPDX-License-Identifier: MIT
"""A study in parts: each makes a share of the runs and writes its own file into one folder.

In: ``3/10``, the folder, the number of runs. Out: the numbers of the runs of a part, and its file.
Parts are independent of each other: they can be the jobs of an array, on any machines with a common
folder, and finished parts can be read while others run (``FOLDER/*.parquet``).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.studies.rows.results import RowsOfFile, StreamedRows
from nctakt.studies.runs.study_runner import Row

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
