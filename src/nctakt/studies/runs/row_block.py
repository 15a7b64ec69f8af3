# SPDX-License-Identifier: MIT
"""Finished rows in transit from the process that makes them to the one that keeps them.

They travel as the lines of text that a file of rows consists of: the process that distributes the
runs need not parse them.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from functools import cached_property

from nctakt.studies.runs.study_runner import CRASHED, PASSED, Row

_encode = json.JSONEncoder(ensure_ascii=False).encode


class RowBlock:
    """Rows, with data for the progress display: ``numbers`` of their runs, ``crashed`` ones.

    ``broken``: how many runs did not meet all expectations. ``has_rows``: they are in it.
    """

    def __init__(self, rows: Iterable[Row]) -> None:
        self.rows = list(rows)
        self.has_rows = True
        self.numbers: Sequence[int] = tuple(int(row["run"] or 0) for row in self.rows)
        self.broken = sum(row["verdict"] != PASSED for row in self.rows)
        self.crashed = tuple(
            number
            for number, row in zip(self.numbers, self.rows, strict=True)
            if row["verdict"] == CRASHED
        )

    def __len__(self) -> int:
        return len(self.numbers)

    def without_rows(self) -> RowBlock:
        """Return the block without its rows, which are elsewhere by now."""
        block = RowBlock(())
        vars(block).update(vars(self))
        block.rows, block.lines, block.has_rows = [], b"", False
        numbers = range(min(self.numbers, default=0), max(self.numbers, default=-1) + 1)
        if tuple(numbers) == self.numbers:
            block.numbers = numbers  # a few bytes instead of some for each run
        return block

    def __getstate__(self) -> dict[str, object]:
        """Return all but the rows, which ``lines`` have."""
        state = {**vars(self), "lines": self.lines}
        del state["rows"]
        return state

    @cached_property
    def lines(self) -> bytes:
        """The rows as JSON, one per line."""
        return "".join(f"{_encode(row)}\n" for row in self.rows).encode()

    @cached_property
    def rows(self) -> list[Row]:
        """The original rows."""
        rows: list[Row] = json.loads(b"[%b]" % self.lines[:-1].replace(b"\n", b","))
        return rows
