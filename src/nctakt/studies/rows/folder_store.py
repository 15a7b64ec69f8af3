# SPDX-License-Identifier: MIT
"""The results of a study in a folder of parts while its runs are made.

In: blocks, of which workers have written the rows already, or which this process writes. Out: which
runs are finished, and the rows in the order of their runs.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import ROWS_NOT_SHARED
from nctakt.studies.plans.plan import Plan
from nctakt.studies.rows.part_folder import PartFolder, RowsOfFolder
from nctakt.studies.rows.row_store import RunNumbers, fingerprint, lock, open_stores
from nctakt.studies.runs.row_block import RowBlock

#: Rows that this process gathers for a part: of a study, and of a search, which has few runs.
GATHERED, GATHERED_OF_SEARCH = 500, 50


class FolderStore:
    """As ``RowStore``, in a folder that can be anywhere; on this machine no two studies have it.

    ``purpose``: a further purpose of the runs, as for ``fingerprint``; ``gathered``: how many rows
    this process gathers for a part. Raises ``Failure`` as ``PartFolder``, and for a folder that
    another study writes (900919).
    """

    def __init__(
        self,
        folder: PartFolder,
        plan: Plan,
        *,
        resumes: bool,
        purpose: str = "",
        gathered: int = GATHERED,
    ) -> None:
        self.folder = folder
        self.name = folder.address
        self.done = RunNumbers()
        self._lock = -1
        self._rows: list[RowBlock] = []
        self._gathered = gathered
        digits = fingerprint(plan, purpose)
        if folder.is_local and Path(folder.address, "_study.json").exists():
            self._take_lock()
        try:
            folder.begin(digits, resumes=resumes)
            if folder.is_local and self._lock < 0:
                self._take_lock()
            for part in folder.parts():
                for number in folder.numbers(part):
                    self.done.add(number)
        except BaseException:
            self.leave()
            raise

    def _take_lock(self) -> None:
        path = Path(self.folder.address, "_study.json")
        self._lock = os.open(path, os.O_RDWR)
        open_stores.add(self)
        try:
            lock(self._lock, path)
        except BaseException:
            self.leave()
            raise

    def add(self, block: RowBlock) -> None:
        """Record that the runs of a block are done; write its rows unless a worker has."""
        for number in block.numbers:
            self.done.add(number)
        if block.has_rows:
            self._rows.append(block)
            if sum(map(len, self._rows)) >= self._gathered:
                self._write()

    def _write(self) -> None:
        rows = [row for block in self._rows for row in block.rows]
        self._rows = []
        self.folder.written(RowBlock(sorted(rows, key=lambda row: int(row["run"] or 0))))

    def rows(self) -> RowsOfFolder:
        """Return the rows so far; raises ``Failure`` if workers wrote some elsewhere (902982)."""
        self._write()
        rows = RowsOfFolder(self.folder)
        missing = len(self.done) - len(rows)
        if missing > 0:
            raise Failure(diagnostic(ROWS_NOT_SHARED, folder=self.name, missing=missing))
        return rows

    def close(self) -> None:
        """Write the remaining rows; then another study may use the folder."""
        try:
            self._write()
        finally:
            self.leave()

    def leave(self) -> None:
        """Let others have the folder."""
        if self._lock >= 0:
            with contextlib.suppress(OSError):
                os.close(self._lock)
            self._lock = -1

    def remove(self) -> None:
        """Close it; the parts are the results."""
        self.close()
