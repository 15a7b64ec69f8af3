# SPDX-License-Identifier: MIT
"""Blocks of runs: as many as keep a worker busy for a while, fewer at the end of a study.

In: numbers of runs, and how long runs have taken. Out: blocks of them. A block that takes too short
a time costs messages; one that takes too long loses more with its worker, and makes others wait at
the end.
"""

from __future__ import annotations

import gc
import itertools
import time
from collections.abc import Iterable, Iterator, Sized
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row

Block = tuple[int, ...]

#: Runs of the first blocks, whose duration is not known yet, and of a block at most.
FIRST, MAX_RUNS = 20, 5_000

#: Runs between two searches for garbage.
RUNS_BETWEEN_SEARCHES = 5

#: A block is this share of the runs left for each worker.
SHARE = 4

#: A block at the end is no smaller than this share of the block before.
MIN_SHARE = 20


class RowMaker(Protocol):
    """Makes the row of a run by its number."""

    def row(self, number: int, /) -> Row:
        """Return the row."""


@dataclass(frozen=True, slots=True)
class MadeBlock:
    """The rows of a block, and how long one took in seconds."""

    rows: RowBlock
    run_s: float


class RowWriter(Protocol):
    """Writes rows where they are made."""

    def written(self, block: RowBlock, /) -> RowBlock:
        """Write the rows of a block; return it without them."""


def make_runs(maker: RowMaker, block: Block, writer: RowWriter | None = None) -> MadeBlock:
    """Make the runs of a block; raises ``Failure`` if the writer cannot write them."""
    begin_s = time.perf_counter()
    rows = RowBlock(_rows(maker, block))
    if writer is not None:
        rows = writer.written(rows)
    return MadeBlock(rows, (time.perf_counter() - begin_s) / len(block))


def _rows(maker: RowMaker, block: Block) -> Iterator[Row]:
    """Yield the rows of a block; garbage is looked for between runs, not at any time in them.

    The leftovers of runs are all garbage then, and no objects of a present run are scanned.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        for count, number in enumerate(block, 1):
            yield maker.row(number)
            if count % RUNS_BETWEEN_SEARCHES == 0:
                gc.collect(0)
    finally:
        if was_enabled:
            gc.enable()


class Blocks:
    """Numbers in blocks for this many ``workers``; a block should take ``block_s`` seconds."""

    def __init__(self, numbers: Iterable[int], workers: int, block_s: float) -> None:
        self.workers = workers
        self._numbers = iter(numbers)
        self._left = len(numbers) if isinstance(numbers, Sized) else None
        self._block_s = block_s
        self._limit = FIRST

    def note(self, run_s: float) -> None:
        """Note how long a run takes by now."""
        self._limit = max(1, min(MAX_RUNS, int(self._block_s / max(run_s, 1e-9))))

    def __iter__(self) -> Iterator[Block]:
        while block := tuple(itertools.islice(self._numbers, self._size())):
            yield block

    def _size(self) -> int:
        """Return how many runs the next block has."""
        if self._left is None:
            return self._limit
        share = self._left // (SHARE * self.workers)
        size = min(self._limit, max(share, self._limit // MIN_SHARE, 1))
        self._left -= size
        return size
