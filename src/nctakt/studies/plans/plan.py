# SPDX-License-Identifier: MIT
"""A plan: the program, variations, measures, expectations and goal; immutable.

``Plan.point`` gives the values of each run by its number. Which runs there are does not depend on
who makes them, or in which order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, Literal, cast

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Severity, Span
from nctakt.base.failure import Failure
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING
from nctakt.messages.extras import install_command
from nctakt.run.options import ProgramOptions
from nctakt.studies.measuring.measures import Expectation, Measure
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.plans.dimension import Dimension, Value, chance
from nctakt.studies.plans.distribution import Samples

#: How points are chosen: each with each, at random, or spread evenly.
Method = Literal["grid", "list", "random", "latin", "sobol"]
METHODS: tuple[Method, ...] = ("grid", "list", "random", "latin", "sobol")
#: The methods whose points are made as a whole, and the maximum number of points.
DESIGNS: tuple[Method, ...] = ("latin", "sobol")
MAX_DESIGN = 10_000_000

#: Where the row of a run of ``--cover`` has the counts of its branches, which no results have.
COVERAGE = "--coverage"

#: The names of each row that are neither inputs nor measures.
RESERVED = (
    "run", "reaction_time", "state", "ticks", "verdict", "broken", "seed", "digest",
    COVERAGE,
)  # fmt: skip


#: An entry of a plan: its table, and its name or its number there; and where it is.
Entry = tuple[str, str | int]
Place = tuple[Span | None, str]

GoalWord = Literal["minimize", "maximize", "boundary", "pareto"]


@dataclass(frozen=True, slots=True)
class Goal:
    """The goal of a search: ``word`` says how, ``measure`` of what.

    ``budget``: how many runs the search may take. ``several``: the objectives of a Pareto set.
    """

    word: GoalWord
    measure: str
    budget: int
    several: tuple[tuple[str, str], ...] = ()

    @property
    def objectives(self) -> tuple[tuple[str, str], ...]:
        """``minimize`` or ``maximize`` of each measure; none of a boundary."""
        if self.word == "boundary":
            return ()
        return self.several or ((self.word, self.measure),)


@dataclass(frozen=True, slots=True)
class Plan:
    """A checked plan; ``text``: that of the program where it is in no file.

    ``machine`` ``None``: the demo machine. No ``plcs``: the built-in one; with
    ``names_default_plc`` because the plan says so. ``assignments`` and ``stimuli`` are those of all
    runs. ``count``: the number of points of a method without a grid. ``rtconf``, ``load``,
    ``system``: the scheduling list, its load and its operating system; ``is_schedule``: the list is
    simulated without a program, and ``program`` then is the list. ``further``: run options without
    their own entry here, by name. ``places``: where the entries are in the plan's file, with the
    text of the line; ``source``: the text of that file, empty for a plan from Python.
    """

    program: Path
    machine: Path | None
    plcs: tuple[Path, ...]
    dimensions: tuple[Dimension, ...]
    measures: tuple[Measure, ...]
    expectations: tuple[Expectation, ...]
    method: Method = "grid"
    count: int = 0
    seed: int = 0
    until: Time | None = None
    after: Time = Time(0)
    assignments: tuple[tuple[str, float | str], ...] = ()
    stimuli: tuple[tuple[Time, str, float | str], ...] = ()
    goals: tuple[Goal, ...] = ()
    text: str | None = None
    rtconf: Path | None = None
    load: Path | None = None
    system: str = "rtx"
    is_schedule: bool = False
    names_default_plc: bool = False
    further: tuple[tuple[str, Any], ...] = ()
    places: Mapping[Entry, Place] = field(default_factory=dict, compare=False, repr=False)
    source: str = field(default="", compare=False, repr=False)

    @property
    def options(self) -> ProgramOptions:
        """The run options of all runs, without the values that it sets."""
        given = {**dict(self.further), "until": self.until, "after": self.after}
        return cast("ProgramOptions", given)

    @property
    def files(self) -> list[Path]:
        """The files besides program and machine: PLC, schedule, series, Python measures."""
        single = (*self.plcs, self.rtconf, self.load)
        files = [path for path in single if path is not None]
        for dimension in self.dimensions:
            if dimension.has_files:
                files += [Path(str(value)) for value in dimension.values]
            if isinstance(dimension.distribution, Samples):
                files.append(dimension.distribution.file)
        nodes = [measure.node for measure in self.measures]
        files += [one.file for one in nodes if isinstance(one, PythonMeasure) and not one.function]
        return list(dict.fromkeys(files))

    @property
    def size(self) -> int:
        """The number of its runs; 0 for a grid in which a dimension has no value."""
        if self.method == "grid":
            size = 1
            for dimension in self.dimensions:
                size *= dimension.count
            return size
        if self.method == "list":
            return min((dimension.count for dimension in self.dimensions), default=1)
        return self.count

    @property
    def speaks_of_errors(self) -> bool:
        """Whether an expectation is about errors or the state; else a run must not have any."""
        words = " ".join(expectation.text for expectation in self.expectations).split()
        return not {"error", "state"}.isdisjoint(words)

    def point(self, index: int) -> tuple[Value, ...]:
        """Return the values of a run, one for each dimension.

        Raises ``Failure`` (901311) where a method needs a package that is not installed.
        """
        if self.method == "grid":
            values: list[Value] = []
            for dimension in reversed(self.dimensions):
                index, number = divmod(index, dimension.count)
                values.append(dimension.value(number))
            return tuple(reversed(values))
        if self.method == "list":
            return tuple(dimension.value(index) for dimension in self.dimensions)
        return tuple(
            dimension.drawn(share)
            for dimension, share in zip(self.dimensions, self._shares(index), strict=True)
        )

    def placed(self, failure: Failure, table: str, entry: str | int) -> list[Diagnostic]:
        """Return the diagnostics of a failure, errors without a place at that of the entry."""
        span, line = self.places.get((table, entry), (None, ""))
        return [
            replace(found, span=span, source_line=line)
            if found.span is None and found.severity is Severity.ERROR
            else found
            for found in failure.diagnostics
        ]

    def injection_us(self, point: Sequence[Value]) -> int | None:
        """Return the time of the injection of an each-tick study in microseconds, else ``None``."""
        for dimension, value in zip(self.dimensions, point, strict=True):
            if dimension.is_each_tick:
                return int(value)
        return None

    def window_us(self, cycle_time_us: int) -> int | None:
        """Return how long after an injection a run is decided; ``None``: only at its end.

        That is so where there are measures, and expectations of another form than ``CONDITION
        within TIME``.
        """
        reactions = [expectation.reaction for expectation in self.expectations]
        limits = [
            reaction.limit.us(cycle_time_us)
            for reaction in reactions
            if reaction is not None and reaction.after is None
        ]
        if self.measures or not limits or len(limits) < len(reactions):
            return None
        return max(limits)

    def _shares(self, index: int) -> tuple[float, ...]:
        if self.method == "random":
            return tuple(chance(self.seed, index, i) for i in range(len(self.dimensions)))
        return _design(self.method, self.count, len(self.dimensions), self.seed)[index]


@cache
def _design(method: Method, count: int, width: int, seed: int) -> list[tuple[float, ...]]:
    """Return the points of a design that is made as a whole, in the unit cube."""
    try:
        from scipy.stats import qmc  # noqa: PLC0415 - an extra that few plans need
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="scipy", install=install_command("studies"))
        ) from error
    if method == "latin":
        return [tuple(map(float, row)) for row in qmc.LatinHypercube(width, rng=seed).random(count)]
    power = max(count - 1, 0).bit_length()
    sobol = qmc.Sobol(width, rng=seed).random_base2(power)
    return [tuple(map(float, row)) for row in sobol[:count]]
