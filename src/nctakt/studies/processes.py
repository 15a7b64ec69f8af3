# SPDX-License-Identifier: MIT
"""Runs of a plan on several processes of this machine.

In: a plan and numbers of runs. Out: rows, block by block as they are finished. A process that ends
by itself is replaced; the runs of its block are made again one by one, and the one at which the new
process ends as well gets a row that says so. Nothing else can be lost.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import pickle
import queue
import subprocess
import sys
import threading
from collections.abc import Iterable, Iterator, Sequence, Sized

from nctakt.studies.bench import Row, crashed_row
from nctakt.studies.plan import Plan
from nctakt.studies.schedule_bench import bench_of
from nctakt.studies.shared_beginning import maker_of

#: Runs that a worker makes between two answers, at most.
BLOCK = 200

#: Blocks for each worker, so that all end at about the same time.
BLOCKS_OF_A_WORKER = 16

Block = tuple[int, ...]


def in_blocks(numbers: Iterable[int], workers: int) -> Iterator[Block]:
    """Yield numbers in blocks for so many workers."""
    iterator = iter(numbers)
    size = BLOCK
    if isinstance(numbers, Sized):
        size = min(BLOCK, max(1, len(numbers) // (BLOCKS_OF_A_WORKER * workers)))
    while block := tuple(itertools.islice(iterator, size)):
        yield block


def rows_here(plan: Plan, numbers: Iterable[int]) -> Iterator[list[Row]]:
    """Yield the rows of runs, made in this process one after another."""
    maker = maker_of(bench_of(plan), may_copy=False)
    for number in numbers:
        yield [maker.row(number)]


def rows_of_processes(plan: Plan, numbers: Iterable[int], count: int) -> Iterator[list[Row]]:
    """Yield the rows of runs, made by ``count`` processes, in the order in which they finish."""
    pool = _Pool(plan, in_blocks(numbers, count))
    threads = [threading.Thread(target=pool.serve, daemon=True) for _ in range(count)]
    for thread in threads:
        thread.start()
    try:
        working = count
        while working:
            answer = pool.answers.get()
            if isinstance(answer, BaseException):
                raise answer
            working -= answer is None
            if answer:
                yield answer
    finally:
        pool.stop()
        for thread in threads:
            thread.join()


class _Pool:
    """Hands out blocks to workers; each thread speaks with one worker at a time."""

    def __init__(self, plan: Plan, blocks: Iterator[Block]) -> None:
        self._plan = plan
        self._blocks = blocks
        self._lock = threading.Lock()
        self._workers: list[subprocess.Popen[bytes]] = []
        self._is_stopped = False
        #: Rows, an error, or ``None`` from each thread at its end; bounded, so is the memory.
        self.answers: queue.Queue[list[Row] | BaseException | None] = queue.Queue(16)

    def serve(self) -> None:
        """Have blocks made until there is none left."""
        worker: subprocess.Popen[bytes] | None = None
        try:
            while (block := self._next()) is not None:
                worker = self._serve_block(worker, block)
        except BaseException as error:  # noqa: BLE001 - goes to who waits for the rows
            self._put(error)
        finally:
            if worker is not None:
                _end(worker)
            self._put(None)

    def _serve_block(
        self, worker: subprocess.Popen[bytes] | None, block: Block
    ) -> subprocess.Popen[bytes] | None:
        """Have a block made; return the worker that lives afterwards."""
        worker = worker or self._start()
        rows = _ask(worker, block)
        if rows is not None:
            self._put(rows)
            return worker
        _end(worker)
        worker = None
        for number in block:
            if self._is_stopped:
                break
            worker = worker or self._start()
            rows = _ask(worker, (number,))
            if rows is None:
                _end(worker)
                worker = None
                rows = [crashed_row(self._plan, number)]
            self._put(rows)
        return worker

    def _next(self) -> Block | None:
        with self._lock:
            return None if self._is_stopped else next(self._blocks, None)

    def _start(self) -> subprocess.Popen[bytes]:
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        worker = subprocess.Popen(
            [sys.executable, "-m", "nctakt.studies.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=environment,
        )
        with self._lock:
            self._workers.append(worker)
        _send(worker, self._plan)
        return worker

    def _put(self, answer: list[Row] | BaseException | None) -> None:
        while not self._is_stopped:
            with contextlib.suppress(queue.Full):
                self.answers.put(answer, timeout=0.2)
                return

    def stop(self) -> None:
        """End all workers."""
        self._is_stopped = True
        with self._lock:
            for worker in self._workers:
                worker.kill()


def _send(worker: subprocess.Popen[bytes], value: object) -> None:
    assert worker.stdin is not None
    with contextlib.suppress(BrokenPipeError):
        pickle.dump(value, worker.stdin)
        worker.stdin.flush()


def _ask(worker: subprocess.Popen[bytes], block: Sequence[int]) -> list[Row] | None:
    """Return the rows of a block; ``None`` if the worker has ended."""
    assert worker.stdout is not None
    _send(worker, tuple(block))
    try:
        rows: list[Row] = pickle.load(worker.stdout)
    except (EOFError, pickle.UnpicklingError):
        return None
    return rows


def _end(worker: subprocess.Popen[bytes]) -> None:
    """Close the pipes of a worker and wait until it has ended."""
    for stream in (worker.stdin, worker.stdout):
        assert stream is not None
        with contextlib.suppress(OSError):
            stream.close()
    worker.wait()
