# SPDX-License-Identifier: MIT
"""A study: many runs of one program, made on this machine or on others, and their results."""

from __future__ import annotations

import contextlib
import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.base.notebook_progress import notebook_progress
from nctakt.base.plain_values import plain_data
from nctakt.lists.format import arguments
from nctakt.results.trace.arrow import pandas_frame
from nctakt.studies.measuring.measures import MeasuredValue, function_measure
from nctakt.studies.measuring.outcome import NotMeasuredError
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.inputs import command_of, inputs_of
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.plan_file import read_plan, read_tables
from nctakt.studies.report import ShownRuns, extreme_runs, report, shown_result
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.results import arrow_table, text_columns, write_rows
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.each_tick import Nominal, nominal_run, with_span
from nctakt.studies.runs.effects import without_effect, without_shown_effect
from nctakt.studies.runs.recording import picture_of_run, record_run
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.schedule_runner import runner_of
from nctakt.studies.runs.shared_beginning import is_copied
from nctakt.studies.runs.study_runner import (
    CRASHED,
    FAILED,
    PASSED,
    REFUSED,
    Row,
    StudyRunner,
    columns_of,
)
from nctakt.studies.searching.corpus import Corpus
from nctakt.studies.searching.cover import Reached, reach
from nctakt.studies.searching.search import Answer, search, shrink
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.workers.processes import rows_here, rows_of_processes

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

#: Makes the rows of runs by their numbers, in any order.
Executor = Callable[[Plan, Iterable[int]], Iterator[RowBlock]]


#: The most runs whose numbers are listed before the first of them is made.
MAX_LISTED = 1_000_000


class StudyResult:
    """The rows of a study in the order of its runs; true if all runs met all expectations.

    ``units``: those of the columns that have any. Results can be compared and pickled; a measure
    that is a Python function is pickled by its name, so it has to be in a module.
    """

    def __init__(
        self,
        plan: Plan,
        rows: Sequence[Row],
        nominal: Nominal | None = None,
        units: Mapping[str, str] | None = None,
    ) -> None:
        self.plan = plan
        self.nominal = nominal
        self.rows = rows
        self.units: Mapping[str, str] = units or {}

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self.counts.items() if count)
        first = self.first_broken(1)
        shown = f"; first run {first[0]['run']}: {first[0]['broken']}" if first else ""
        return f"<StudyResult of {len(self.rows)} runs: {counts or 'none'}{shown}>"

    def _repr_html_(self) -> str:
        """Return the report in short for notebooks: counts, a histogram of each measure, runs."""
        return shown_result(self.plan, self.rows, self.units, self.nominal)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, StudyResult):
            return NotImplemented
        return self._content() == other._content()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[StudyResult], tuple[Any, ...]]:
        return StudyResult, self._content()

    def _content(self) -> tuple[Plan, list[Row], Nominal | None, dict[str, str]]:
        return self.plan, list(self.rows), self.nominal, dict(self.units)

    def __bool__(self) -> bool:
        return all(row["verdict"] == PASSED for row in self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def counts(self) -> dict[str, int]:
        """The number of runs by their verdict: passed, failed, refused, crashed."""
        counts = dict.fromkeys((PASSED, FAILED, REFUSED, CRASHED), 0)
        for row in self.rows:
            counts[str(row["verdict"])] += 1
        return counts

    @property
    def without_effect(self) -> list[str]:
        """The dimensions that changed nothing: runs that differ in them alone are the same."""
        return without_effect(self.plan, self.rows)

    def first_broken(self, count: int) -> list[Row]:
        """Return the first rows of runs that did not meet all expectations, at most this many."""
        return list(itertools.islice((r for r in self.rows if r["verdict"] != PASSED), count))

    @property
    def broken(self) -> list[Row]:
        """The rows of the runs that did not meet all expectations."""
        return [row for row in self.rows if row["verdict"] != PASSED]

    def column(self, name: str) -> list[Any]:
        """Return the values of an input or a measure, run by run."""
        return [row[name] for row in self.rows]

    def missing(self, measure: str) -> int:
        """Return in how many runs a measure has no value."""
        return sum(row[measure] is None for row in self.rows)

    def to_arrow(self) -> pyarrow.Table:
        """Return the rows as an Arrow table; each field has its ``unit`` as metadata.

        Raises ``Failure`` (901311) without pyarrow.
        """
        return arrow_table(self.rows, columns_of(self.plan), self.units)

    def to_pandas(self) -> pandas.DataFrame:
        """Return the rows as a pandas frame, units in ``attrs``; raises as ``to_arrow``."""
        return pandas_frame(self.to_arrow())

    def to_polars(self) -> polars.DataFrame:
        """Return the rows as a polars frame, which has no units; raises as ``to_arrow``."""
        import polars  # noqa: PLC0415 - an extra

        return polars.DataFrame(self.to_arrow())

    def report(
        self,
        language: Language = "en",
        command: Callable[[int], str] | None = None,
        picture: Callable[[int], bytes | None] | None = None,
        repeated: Sequence[tuple[str, int]] = (),
    ) -> str:
        """Return the report: an HTML page that needs no network.

        ``command`` shows a run by its number, as ``Study.command`` does; ``picture`` draws it, as
        ``Study.picture`` does; ``repeated``: the answer of ``Study.without_shown_effect``.
        """
        shown = ShownRuns(command, picture, repeated)
        return report(self.plan, self.rows, self.units, language, shown, self.nominal)

    @property
    def extreme_runs(self) -> list[int]:
        """The runs with the least and the greatest value of each measure, each once."""
        return extreme_runs(self.plan, self.rows)

    def save(self, path: str | Path, *, is_part: bool = False) -> None:
        """Write the rows to a .parquet, .csv or .jsonl file; raises ``Failure``.

        ``is_part``: one of several files of rows, with the same types for any values.
        """
        texts = None
        if is_part:
            texts = text_columns(self.plan)
        write_rows(self.rows, columns_of(self.plan), Path(path), self.units, texts)


class Study:
    """Many runs of one program: a plan's file, or its entries as keywords.

    ``program`` is a file or an ``NcText``. With a plan's file, ``method``, ``count`` and ``seed``
    replace those of the file.

    ``functions``: further measures as Python functions, which get the same queries of a run as a
    test (``run.m_function(100).at``). ``default_machine``: that of a plan that names none, before
    the project's. ``nominal``: the unchanged run of an each-tick study. Raises ``Failure`` with all
    mistakes of the plan.

    >>> study = Study(
    ...     program=NcText("move.nc", "G01 X100 F6000 M30"),
    ...     vary=[{"variable": "HLI.OVERRIDE", "values": [50, 100]}],
    ...     measure={"time": "duration"},
    ...     expect=["time < 1.5 s"],
    ... )
    >>> [(row["HLI.OVERRIDE"], row["time"], row["verdict"]) for row in study.run().rows]
    [(50, 2.014, 'failed'), (100, 1.026, 'passed')]
    """

    def __init__(
        self,
        file: str | Path | None = None,
        *,
        functions: dict[str, Callable[..., MeasuredValue]] | None = None,
        default_machine: Path | None = None,
        **entries: Any,
    ) -> None:
        if file is None:
            plan = read_tables(plain_data(entries), Path(), default_machine=default_machine)
        else:
            plan = replace(read_plan(arguments.path("file", file), default_machine), **entries)
        if functions:
            own = tuple(function_measure(name, one) for name, one in functions.items())
            plan = replace(plan, measures=(*plan.measures, *own))
        self.plan = plan
        self._has_functions = bool(functions)
        self._runner: StudyRunner | None = None
        self.nominal: Nominal | None = None
        if any(dimension.is_each_tick for dimension in plan.dimensions):
            runner = runner_of(plan)
            runner.check()
            self.nominal = nominal_run(runner)
            self.plan = with_span(plan, self.nominal)

    def __repr__(self) -> str:
        return f"<Study of {self.plan.program}: {len(self)} runs>"

    def __len__(self) -> int:
        return self.plan.size

    @property
    def runner(self) -> StudyRunner:
        """The runner of this process; raises ``Failure`` for names that are unknown."""
        if self._runner is None:
            runner = runner_of(self.plan)
            runner.check()
            self._runner = runner
        return self._runner

    def run(
        self,
        *,
        processes: int = 1,
        numbers: Iterable[int] | None = None,
        store: RowStore | FolderStore | None = None,
        executor: Executor | None = None,
        on_rows: Callable[[RowBlock], None] | None = None,
    ) -> StudyResult:
        """Make the runs, by default all, and return their rows in order.

        ``processes``: how many make them; with ``functions`` it is this one. ``executor`` makes
        them elsewhere. ``store`` keeps each row as it comes and knows those of earlier calls;
        ``on_rows`` is called with new ones. Raises ``Failure`` for unknown names, before any run.
        """
        self.runner  # noqa: B018 - checks the names
        numbers_due: Iterable[int] = range(self.plan.size) if numbers is None else numbers
        done = () if store is None else store.done
        missing: Iterable[int] = (number for number in numbers_due if number not in done)
        if self.plan.size <= MAX_LISTED:
            missing = list(missing)
        progress, count = notebook_progress("Study"), 0
        if executor is None:
            executor = rows_here
            copies = is_copied(self.plan, self.runner.cycle_time_us)
            writer = None if store is None else store.folder
            if (processes > 1 or copies or writer is not None) and not self._has_functions:
                executor = lambda plan, left: rows_of_processes(  # noqa: E731
                    plan, left, processes, self.runner, writer
                )
        total = len(missing) if isinstance(missing, list) else None
        blocks: list[RowBlock] = []
        with contextlib.ExitStack() as at_the_end:
            if progress is not None:
                at_the_end.callback(progress.close)
            for block in executor(self.plan, missing):
                if store is None:
                    blocks.append(block)
                else:
                    store.add(block)
                if on_rows is not None:
                    on_rows(block)
                elif progress is not None:
                    count += len(block)
                    progress.show(count, total)
        if store is not None:
            return StudyResult(self.plan, store.rows(), self.nominal, self.runner.units)
        rows = [row for block in blocks for row in block.rows]
        rows.sort(key=lambda row: int(row["run"] or 0))
        return StudyResult(self.plan, rows, self.nominal, self.runner.units)

    def without_shown_effect(self, result: StudyResult) -> list[tuple[str, int]]:
        """Repeat some runs with another value of one dimension alone, for random points.

        Returns the dimensions, beyond those of ``result.without_effect``, for which that changed
        nothing, each with the number of these runs. Raises ``Failure`` as ``run``.
        """
        return without_shown_effect(self.runner, result.rows, result.without_effect)

    def find(self, searched: SearchRuns | None = None) -> list[Answer]:
        """Return the answer to each goal of the plan (``find``); raises ``Failure`` as ``run``.

        ``searched``: makes the runs and keeps their rows, by default this process.
        """
        searched = searched or SearchRuns(self.runner)
        return [search(searched, goal) for goal in self.plan.goals]

    def cover(
        self,
        budget: int | None = None,
        corpus: str | Path | None = None,
        searched: SearchRuns | None = None,
    ) -> Reached:
        """Look for runs that reach every branch of the realtime cycles; return their result.

        ``budget``: how many runs it may take, by default as many as the plan has. ``corpus``: a
        file with points to begin with, to which those that were good are added. ``searched``: makes
        the runs (``covers=True``) and keeps their rows, by default this process. Raises ``Failure``
        as ``run``, and for a file that is no corpus or cannot be written.
        """
        kept = None if corpus is None else Corpus(Path(corpus))
        earlier = () if kept is None else kept.points(self.plan)
        searched = searched or SearchRuns(self.runner, covers=True)
        reached = reach(searched, len(self) if budget is None else budget, earlier)
        if kept is not None:
            kept.add(self.plan, reached.best)
        return reached

    def shrink(self, number: int) -> Answer:
        """Return the smallest change from the unchanged run that breaks as a run does."""
        nominal = [dimension.rest_value for dimension in self.plan.dimensions]
        return shrink(self.runner, self.plan.point(number), nominal)

    def reason(self, measure: str, number: int) -> str:
        """Return why a Python function has no value in a run, which is made again; else nothing."""
        own = next(one for one in self.plan.measures if one.name == measure)
        if not isinstance(own.node, PythonMeasure):
            return ""
        try:
            own.measured(self.runner.make(self.plan.point(number)).outcome)
        except (NotMeasuredError, Failure) as error:
            return next(iter(str(error).splitlines()), "")
        return ""

    def record(self, run: int | Sequence[Value], path: str | Path) -> str:
        """Write the tape of a run, by its number or its values; return the command that replays it.

        Of a schedule the list and its load are written instead. Raises ``Failure`` as the run, and
        for files that cannot be written.
        """
        return record_run(self.runner, self._point(run), Path(path))

    def picture(self, run: int | Sequence[Value], language: Language = "en") -> bytes | None:
        """Return a picture of a run, by its number or its values, as the bytes of a PNG file.

        ``None`` for a schedule, and without matplotlib. Raises ``Failure`` as the run.
        """
        return picture_of_run(self.runner, self._point(run), language)

    def command(self, run: int | Sequence[Value]) -> str | None:
        """Return the command that makes a run alone, by its number or its values.

        ``None`` if there is no option for its inputs, or the command would be very long.
        """
        inputs = inputs_of(self.plan, self._point(run), self.runner.cycle_time_us)
        return command_of(self.plan, inputs)

    def _point(self, run: int | Sequence[Value]) -> Sequence[Value]:
        return self.plan.point(run) if isinstance(run, int) else run


__all__ = ["Study", "StudyResult"]
