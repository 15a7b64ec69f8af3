# SPDX-License-Identifier: MIT
"""Runs of a plan on several processes of this machine.

In: a plan and numbers of runs. Out: rows, block by block as they are finished. A process that dies
is replaced; the runs of its block are repeated one by one, and the run that kills the new process
as well gets a row that says so. Nothing else can be lost.
"""

from __future__ import annotations

import contextlib
import gc
import queue
import threading
from collections import deque
from collections.abc import Iterable, Iterator

from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.blocks import Block, Blocks, RowWriter
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.schedule_runner import runner_of
from nctakt.studies.runs.shared_beginning import maker_of
from nctakt.studies.runs.study_runner import StudyRunner, crashed_row
from nctakt.studies.workers.worker_process import WorkerProcess, can_copy

#: How long a worker has a block, in seconds.
BLOCK_S = 0.2

#: The same where it writes the rows: a block is a part then, a file.
PART_S = 2.0

#: Blocks requested from a worker: one in progress, one so that it need not wait.
ASKED = 2


def rows_here(plan: Plan, numbers: Iterable[int]) -> Iterator[RowBlock]:
    """Yield the rows of runs, made in this process one by one."""
    maker = maker_of(runner_of(plan), may_copy=False)
    for number in numbers:
        yield RowBlock([maker.row(number)])


def rows_of_processes(
    plan: Plan,
    numbers: Iterable[int],
    count: int,
    runner: StudyRunner | None = None,
    writer: RowWriter | None = None,
) -> Iterator[RowBlock]:
    """Yield the rows of runs, made by ``count`` processes, in the order in which they finish.

    ``runner``: of this process, which its copies share. ``writer``: writes the rows there.
    Raises ``Failure`` if no process can be started, and that of the writer.
    """
    pool = _Pool(plan, Blocks(numbers, count, BLOCK_S if writer is None else PART_S), writer)
    workers: list[WorkerProcess | None] = [None] * count
    if can_copy():
        workers = list(pool.copies(runner or runner_of(plan), count))
    threads = [threading.Thread(target=pool.serve, args=(one,), daemon=True) for one in workers]
    for thread in threads:
        thread.start()
    try:
        working = count
        while working:
            answer = pool.answers.get()
            if isinstance(answer, BaseException):
                raise answer
            working -= answer is None
            if answer is not None:
                yield answer
    finally:
        pool.stop()
        for thread in threads:
            thread.join()


class _Pool:
    """Hands out blocks to workers; each thread talks to one worker at a time."""

    def __init__(self, plan: Plan, blocks: Blocks, writer: RowWriter | None) -> None:
        self._plan = plan
        self._writer = writer
        self._blocks = blocks
        self._next_blocks = iter(blocks)
        self._lock = threading.Lock()
        self._workers: list[WorkerProcess] = []
        self._is_stopped = False
        #: Rows, an error, or ``None`` from each thread at its end; bounded, so is the memory.
        self.answers: queue.Queue[RowBlock | BaseException | None] = queue.Queue(16)

    def copies(self, runner: StudyRunner, count: int) -> Iterator[WorkerProcess]:
        """Yield workers that are copies of this process."""
        gc.collect()
        gc.freeze()  # a copy shares the memory that the garbage collector skips
        try:
            for _ in range(count):
                worker = WorkerProcess.copied(runner, self._workers)
                self._workers.append(worker)
                yield worker
        finally:
            gc.unfreeze()

    def serve(self, worker: WorkerProcess | None) -> None:
        """Have blocks made until there is none left."""
        asked: deque[Block] = deque()
        try:
            while True:
                while len(asked) < ASKED and (block := self._next()) is not None:
                    worker = worker or self._start()
                    worker.ask(block, self._writer)
                    asked.append(block)
                if worker is None or not asked:
                    return
                done = worker.answer()
                block = asked.popleft()
                if done is not None:
                    self._put(done.rows)
                    self._blocks.note(done.run_s)
                    continue
                worker.end()
                worker = self._one_by_one(block)
                for block in asked:
                    worker = worker or self._start()
                    worker.ask(block, self._writer)
        except BaseException as error:  # noqa: BLE001 - goes to who waits for the rows
            self._put(error)
        finally:
            if worker is not None:
                worker.end()
            self._put(None)

    def _one_by_one(self, block: Block) -> WorkerProcess | None:
        """Have the runs of a block made by new workers; return the one that is left."""
        worker = None
        for number in block:
            if self._is_stopped:
                break
            worker = worker or self._start()
            worker.ask((number,), self._writer)
            done = worker.answer()
            if done is None:
                worker.end()
                worker = None
                self._put(RowBlock([crashed_row(self._plan, number)]))
            else:
                self._put(done.rows)
        return worker

    def _next(self) -> Block | None:
        with self._lock:
            return None if self._is_stopped else next(self._next_blocks, None)

    def _start(self) -> WorkerProcess:
        worker = WorkerProcess.started(self._plan)
        with self._lock:
            self._workers.append(worker)
            if self._is_stopped:
                worker.kill()
        return worker

    def _put(self, answer: RowBlock | BaseException | None) -> None:
        while not self._is_stopped:
            with contextlib.suppress(queue.Full):
                self.answers.put(answer, timeout=0.2)
                return

    def stop(self) -> None:
        """End all workers."""
        with self._lock:
            self._is_stopped = True
            for worker in self._workers:
                worker.kill()
