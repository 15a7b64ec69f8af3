# SPDX-License-Identifier: MIT
"""Runs of a plan on the workers of a Dask cluster (extra ``cluster``).

In: a plan, numbers of runs, the address of a scheduler. Out: rows, block by block as they are
finished. Programs, lists and the PLC travel with the runs. Nothing is lost with a worker: its
blocks are repeated elsewhere; a run that loses workers again and again gets a row that says so.
"""

from __future__ import annotations

import contextlib
import gc
import importlib.util
import logging
import sys
import tempfile
import threading
from collections import OrderedDict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure, error_text
from nctakt.base.version import __version__
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import CLUSTER_LOST, EXTRA_MISSING, WORKER_UNFIT
from nctakt.messages.extras import install_command
from nctakt.results.coverage_files import as_json, from_json
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.plan import COVERAGE, Plan
from nctakt.studies.runs.blocks import Block, Blocks, MadeBlock, RowWriter, make_runs
from nctakt.studies.runs.bundle import Bundle, bundle
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.schedule_runner import runner_of
from nctakt.studies.runs.shared_beginning import maker_of
from nctakt.studies.runs.study_runner import Row, crashed_row
from nctakt.studies.searching.search_runs import Point, RowsOfPoints

#: Blocks on the cluster for each of its threads: one in progress, others waiting.
AHEAD = 3

#: How long a worker has a block, in seconds: long enough for its transport to matter little.
BLOCK_S = 1.0

#: How long to wait for the scheduler, and then for a worker, in seconds.
CONNECT_S, WORKER_S = 20, 300

#: Studies that a worker is ready for; those used last.
STATIONS = 4

#: The start of the error of a scheduler that cannot read what it is sent.
_NOT_READ = "Error during deserialization"
_OTHER_PYTHON = Text(
    "nctakt or what it needs is not installed there, or is another version",
    "nctakt oder etwas, das es braucht, fehlt dort oder hat eine andere Version",
)

_lock = threading.Lock()
_stations: OrderedDict[str, Station] = OrderedDict()


def received(packed: Bundle) -> Bundle:
    """Return a bundle, on a worker, from where the others get it; made again if that is lost."""
    return packed


def make_block(
    packed: Bundle, key: str, block: Block, writer: RowWriter | None = None
) -> MadeBlock:
    """Make the runs of a block, on a worker, where the runner stays for the next block.

    Raises ``Failure`` (901485) on a worker that cannot make runs as they would be made elsewhere.
    """
    with _lock:
        return _station(packed, key).make(block, writer)


def make_point(
    packed: Bundle, key: str, number: int, point: Sequence[Value], *, covers: bool
) -> Row:
    """Make a run of a search, on a worker; raises as ``make_block``."""
    with _lock:
        return _station(packed, key).row_of(number, point, covers=covers)


def _station(packed: Bundle, key: str) -> Station:
    """Return the maker of a study's runs on this worker; those used last are kept."""
    station = _stations.get(key) or Station(packed)
    _stations[key] = station
    _stations.move_to_end(key)
    if len(_stations) > STATIONS:
        _stations.popitem(last=False)[1].close()
    return station


class Station:
    """Makes the runs of one study on a worker, with the modules of its user.

    Other studies may have other modules of the same names: each block begins by loading its own.
    """

    _present: Station | None = None

    def __init__(self, packed: Bundle) -> None:
        if packed.version != __version__:
            raise _unfit(f"nctakt {__version__}, not {packed.version}")
        self._folder = tempfile.TemporaryDirectory(prefix="nctakt-study-")
        folder = Path(self._folder.name)
        self._names = packed.modules
        self._folders = packed.write(folder)
        self._shown = packed.shown_names(folder)
        self._modules: dict[str, ModuleType] = {}
        self._enter()
        try:
            runner = runner_of(packed.plan(folder))
            runner.check()
        except (Failure, ImportError) as error:
            raise _unfit(error_text(error)) from error
        self._runner = runner
        self._maker = maker_of(runner, may_copy=False)
        gc.collect()
        gc.freeze()  # machine and program stay: the garbage collector need not scan them again

    def make(self, block: Block, writer: RowWriter | None) -> MadeBlock:
        """Make the runs of a block."""
        self._enter()
        return make_runs(self._maker, block, writer)

    def row_of(self, number: int, point: Sequence[Value], *, covers: bool) -> Row:
        """Return the row of a run with these values, as ``StudyRunner.row_of`` does elsewhere."""
        self._enter()
        row = self._runner.row_of(number, point, covers=covers)
        if COVERAGE in row:
            coverage = from_json(COVERAGE, str(row[COVERAGE]))
            row[COVERAGE] = as_json(coverage.renamed(lambda name: self._shown.get(name, name)))
        return row

    def close(self) -> None:
        """Remove its files, and make its memory collectable."""
        self._folder.cleanup()
        gc.unfreeze()

    def _enter(self) -> None:
        """Let imports find the modules of this study, and of no other."""
        before = Station._present
        if before is self:
            return
        if before is not None:
            before._leave()
        Station._present = self
        _taken(self._names)  # including the worker's own modules of these names
        sys.modules.update(self._modules)
        sys.path[:0] = self._folders
        importlib.invalidate_caches()

    def _leave(self) -> None:
        self._modules = _taken(self._names)
        sys.path[:] = [path for path in sys.path if path not in self._folders]


def _taken(names: Sequence[str]) -> dict[str, ModuleType]:
    """Remove the modules of these names from those that are imported; return them."""
    own = [name for name in sys.modules if name.partition(".")[0] in names]
    return {name: sys.modules.pop(name) for name in own}


def _unfit(reason: str) -> Failure:
    import distributed  # noqa: PLC0415 - as below

    return Failure(diagnostic(WORKER_UNFIT, worker=distributed.get_worker().address, reason=reason))


def rows_of_cluster(
    plan: Plan,
    numbers: Iterable[int],
    address: str | Any,
    uploads: Sequence[Path] = (),
    writer: RowWriter | None = None,
) -> Iterator[RowBlock]:
    """Yield the rows of runs, in the order in which they finish.

    ``address``: of the scheduler, or a ``distributed`` cluster or client; ``uploads``: further
    files, modules and wheels for the workers; ``writer`` writes rows there. Raises ``Failure``: no
    package distributed (901311), no such scheduler, or it is gone (901316), a worker that cannot
    make the runs (901485), and failures of the writer.
    """
    packed = bundle(plan, uploads)
    with _connected(address) as client:
        blocks = _Blocks(
            client, plan, packed, writer
        )  # the request makes some clusters start workers
        client.wait_for_workers(1, timeout=WORKER_S)
        yield from blocks.rows(numbers)


@contextlib.contextmanager
def points_of_cluster(
    plan: Plan, address: str | Any, uploads: Sequence[Path] = (), *, covers: bool = False
) -> Iterator[RowsOfPoints]:
    """Return the maker of a search's runs on a cluster; arguments and failures as above.

    ``covers``: runs of ``--cover``, as ``StudyRunner.row_of`` makes them.
    """
    packed = bundle(plan, uploads)
    with _connected(address) as client:
        bundle_on_workers = _sent(client, packed)
        client.wait_for_workers(1, timeout=WORKER_S)

        def make(points: Sequence[Point]) -> Iterator[Row]:
            futures = [
                client.submit(
                    make_point,
                    bundle_on_workers,
                    packed.key,
                    *one,
                    covers=covers,
                    pure=False,
                    retries=0,
                )
                for one in points
            ]
            for future, one in zip(futures, points, strict=True):
                yield _row_of(future, plan, *one)

        yield make


def _row_of(future: Any, plan: Plan, number: int, point: Sequence[Value]) -> Row:
    """Return the row of a requested run; a run that kills workers gets a row, too."""
    import distributed  # noqa: PLC0415 - as below

    try:
        row: Row = future.result()
    except distributed.scheduler.KilledWorker:
        return crashed_row(plan, number, point)
    return row


def _sent(client: Any, packed: Bundle) -> Any:
    """Return a bundle as workers get it."""
    return client.submit(received, packed, key=f"nctakt-study-{packed.key}")


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keep distributed from logging what ``Failure`` reports: lost connections, with tracebacks."""
    loggers = [logging.getLogger(name) for name in ("distributed", "tornado")]
    loggers += [
        logging.getLogger(name)
        for name in sorted(logging.root.manager.loggerDict)
        if name.startswith(("distributed.", "tornado."))
    ]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


@contextlib.contextmanager
def _connected(address: str | Any) -> Iterator[Any]:
    """Return a client of a cluster that has nctakt; raises as ``rows_of_cluster``."""
    try:
        import distributed  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="distributed", install=install_command("cluster"))
        ) from error
    is_own = not isinstance(address, distributed.Client)
    with _quiet() if is_own else contextlib.nullcontext():
        try:
            client: Any = distributed.Client(address, timeout=CONNECT_S) if is_own else address
        except (OSError, ValueError) as error:
            raise _lost(address, error) from error
        try:
            _check_workers(client)
            yield client
        except (
            OSError,
            distributed.comm.CommClosedError,
            distributed.client.FutureCancelledError,
        ) as error:
            raise _lost(address, error) from error
        except (ImportError, RuntimeError) as error:
            if not isinstance(error, ImportError) and not str(error).startswith(_NOT_READ):
                raise
            raise _without_nctakt(client.scheduler.address) from error
        finally:
            if is_own:
                with contextlib.suppress(OSError, TimeoutError):
                    client.close()


def _check_workers(client: Any) -> None:
    """Raise ``Failure`` (901485) for a worker without nctakt: it would end, and leave no word."""
    for worker, spec in sorted(client.run(importlib.util.find_spec, "nctakt").items()):
        if spec is None:
            raise _without_nctakt(worker)


def _without_nctakt(address: str) -> Failure:
    return Failure(diagnostic(WORKER_UNFIT, worker=address, reason=_OTHER_PYTHON))


def _lost(address: object, error: Exception) -> Failure:
    reason = str(error) or type(error).__name__
    return Failure(diagnostic(CLUSTER_LOST, address=str(address), reason=reason))


class _Blocks:
    """The blocks of a study on a cluster; only some of them wait there at a time."""

    def __init__(self, client: Any, plan: Plan, packed: Bundle, writer: RowWriter | None) -> None:
        self._client = client
        self._writer = writer
        self._plan = plan
        self._study = packed.key
        self._received = _sent(client, packed)
        self._asked: dict[Any, Block] = {}

    def rows(self, numbers: Iterable[int]) -> Iterator[RowBlock]:
        """Yield the rows of each block."""
        import distributed  # noqa: PLC0415 - as above

        finished = distributed.as_completed()
        blocks = Blocks(numbers, self._threads(), BLOCK_S)
        for block in blocks:
            self._submit(block, finished)
            if len(self._asked) >= AHEAD * blocks.workers:
                yield from self._take(finished, blocks)
                blocks.workers = max(blocks.workers, self._threads())
        while self._asked:
            yield from self._take(finished, blocks)

    def _threads(self) -> int:
        threads: dict[str, int] = self._client.nthreads()
        return max(1, sum(threads.values()))

    def _submit(self, block: Block, finished: Any) -> None:
        future = self._client.submit(
            make_block, self._received, self._study, block, self._writer, pure=False, retries=0
        )
        self._asked[future.key] = block
        finished.add(future)

    def _take(self, finished: Any, blocks: Blocks) -> Iterator[RowBlock]:
        """Yield the rows of the next finished block; divide a block that has killed workers."""
        import distributed  # noqa: PLC0415 - as above

        future = next(finished)
        block = self._asked.pop(future.key)
        try:
            done = future.result()
            blocks.note(done.run_s)
            yield done.rows
        except distributed.scheduler.KilledWorker:
            if len(block) == 1:
                yield RowBlock([crashed_row(self._plan, block[0])])
                return
            for number in block:
                self._submit((number,), finished)
