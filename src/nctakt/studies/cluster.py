# SPDX-License-Identifier: MIT
"""Runs of a plan on the workers of a Dask cluster (extra ``cluster``).

In: a plan, numbers of runs, the address of a scheduler. Out: rows, block by block as they are
finished. Programs, lists and the PLC go along with the runs. A worker that is lost loses nothing:
its blocks are made again elsewhere; a run at which workers are lost again and again gets a row that
says so.
"""

from __future__ import annotations

import contextlib
import gc
import tempfile
import threading
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.studies import CLUSTER_LOST, EXTRA_MISSING
from nctakt.studies.bench import Bench, Row, crashed_row
from nctakt.studies.bundle import Bundle, bundle
from nctakt.studies.plan import Plan
from nctakt.studies.processes import Block, in_blocks
from nctakt.studies.schedule_bench import bench_of
from nctakt.studies.shared_beginning import SharedBeginning, maker_of

#: Blocks that wait on the cluster for each of its threads.
AHEAD = 4

#: How long to wait for the scheduler, in seconds.
CONNECT_S = 20

_lock = threading.Lock()
_makers: dict[str, Bench | SharedBeginning] = {}


def received(packed: Bundle) -> Bundle:
    """Return a bundle, on a worker, from where the others get it; made again if that is lost."""
    return packed


def make_block(packed: Bundle, key: str, block: Block) -> list[Row]:
    """Make the runs of a block, on a worker, where the bench stays for the next block."""
    with _lock:
        if key not in _makers:
            folder = Path(tempfile.mkdtemp(prefix="nctakt-study-"))
            _makers[key] = maker_of(bench_of(packed.unpack(folder)), may_copy=False)
            gc.collect()
            gc.freeze()  # machine and program stay: nobody looks for garbage in them again
        return [_makers[key].row(number) for number in block]


def rows_of_cluster(plan: Plan, numbers: Iterable[int], address: str | Any) -> Iterator[list[Row]]:
    """Yield the rows of runs, in the order in which they finish.

    ``address``: of the scheduler, or a ``distributed`` cluster or client. Raises ``Failure``: no
    package distributed (901311), no such scheduler or none any more (901316).
    """
    try:
        import distributed  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise Failure(diagnostic(EXTRA_MISSING, package="distributed", extra="cluster")) from error
    packed = bundle(plan)
    is_own = not isinstance(address, distributed.Client)
    try:
        client: Any = distributed.Client(address, timeout=CONNECT_S) if is_own else address
    except (OSError, ValueError) as error:
        raise _lost(address, error) from error
    try:
        yield from _Blocks(client, packed).rows(numbers)
    except (
        OSError,
        distributed.comm.CommClosedError,
        distributed.client.FutureCancelledError,
    ) as error:
        raise _lost(address, error) from error
    finally:
        if is_own:
            with contextlib.suppress(OSError, TimeoutError):
                client.close()


def _lost(address: object, error: Exception) -> Failure:
    reason = str(error) or type(error).__name__
    return Failure(diagnostic(CLUSTER_LOST, address=str(address), reason=reason))


class _Blocks:
    """The blocks of a study on a cluster; only some of them wait there at a time."""

    def __init__(self, client: Any, packed: Bundle) -> None:
        self._client = client
        self._packed = packed
        self._study = packed.key
        self._received = client.submit(received, packed, key=f"nctakt-study-{self._study}")
        self._blocks: dict[Any, Block] = {}

    def rows(self, numbers: Iterable[int]) -> Iterator[list[Row]]:
        """Yield the rows of each block."""
        import distributed  # noqa: PLC0415 - as above

        finished = distributed.as_completed()
        threads = max(1, sum(self._client.nthreads().values()))
        for block in in_blocks(numbers, threads):
            self._submit(block, finished)
            if len(self._blocks) >= AHEAD * threads:
                yield from self._take(finished)
                threads = max(threads, len(self._client.nthreads()))
        while self._blocks:
            yield from self._take(finished)

    def _submit(self, block: Block, finished: Any) -> None:
        future = self._client.submit(
            make_block, self._received, self._study, block, pure=False, retries=0
        )
        self._blocks[future.key] = block
        finished.add(future)

    def _take(self, finished: Any) -> Iterator[list[Row]]:
        """Yield the rows of the next finished block; divide one that has cost workers."""
        import distributed  # noqa: PLC0415 - as above

        future = next(finished)
        block = self._blocks.pop(future.key)
        try:
            yield future.result()
        except distributed.scheduler.KilledWorker:
            if len(block) == 1:
                yield [crashed_row(self._packed.plan, block[0])]
                return
            for number in block:
                self._submit((number,), finished)
