# SPDX-License-Identifier: MIT
"""Measures of a simulated schedule: texts -> numbers of its threads, of Windows, of processors.

Times are exact seconds::

    response of GEO             the longest one; min, mean, p50, p90, p99, p99.9 response of GEO
    bound of GEO                the longest one by analysis, of all phases and times
    slack of GEO                what is left of the thread's cycle after its longest response
    overflows of GEO            likewise lost, jobs, suspensions; without a name: of all threads
    windows                     the least time of Windows in an NC cycle
    windows share               of the processors on which it runs, 0 … 1; windows violations
    load of 1                   how much of processor 1 its threads need, 0 … 1
    cycles, duration            of the simulation

A study of a program that runs under a schedule has these words in addition, except cycles and
duration.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import UNKNOWN_THREAD
from nctakt.schedule.analysis.analyse import Analysis
from nctakt.schedule.model import NS_PER_US, Model
from nctakt.schedule.simulation.results import Simulation
from nctakt.studies.measuring.measure_nodes import COMPARISONS, Binary, Node, Number
from nctakt.studies.measuring.measure_text import NotAMeasureError, Reader
from nctakt.studies.measuring.outcome import NotMeasuredError, Outcome
from nctakt.studies.plans.plan import Plan

#: Counts of a thread, which can be summed over all.
COUNTS = ("overflows", "lost", "jobs", "suspensions")
#: Times of a thread.
TIMES = ("response", "min", "max", "mean", "bound", "slack")
#: Nanoseconds in a second.
_SECOND_NS = Fraction(10**9)
_WHOLE = ("cycles", "duration", "windows", "windows share", "windows violations")


class ScheduleOutcome(Outcome):
    """A simulated schedule, as measures look at it."""

    simulation: Simulation

    def __init__(self, simulation: Simulation) -> None:
        self.simulation = simulation
        self.queries = simulation  # type: ignore[assignment]

    @property
    def cycle_time_us(self) -> int:
        """The length of an NC cycle in microseconds."""
        return self.simulation.model.cycle // NS_PER_US


@dataclass(frozen=True, slots=True)
class ScheduleNumber:
    """A number of a schedule; ``name``: of what, ``of``: of which thread or processor."""

    name: str
    of: str = ""

    def value(self, outcome: Outcome) -> Number:
        """Return the number, times in seconds; raises ``NotMeasuredError`` without a job."""
        run = outcome.simulation
        assert run is not None
        if self.name in COUNTS:
            return self._count(run)
        if self.name == "load":
            return self._load(outcome.analysis)
        if self.name in _WHOLE:
            return self._whole(run)
        return self._time(run, outcome) / _SECOND_NS

    @property
    def is_time(self) -> bool:
        """Whether it is a time, in seconds."""
        if self.name in _WHOLE:
            return self.name in ("duration", "windows")
        return self.name != "load" and self.name not in COUNTS

    def signals(self) -> Iterator[str]:
        """Yield nothing."""
        yield from ()

    def check(self, model: Model) -> None:
        """Raise ``Failure`` (901391) for a thread or processor that the model does not have."""
        if not self.of:
            return
        names = [str(cpu) for cpu in model.cpus]
        if self.name != "load":
            names = [name for task in model.tasks for name in (task.name, task.key)]
        if self.of not in names:
            near = nearest(self.of, names) or names[0]
            raise Failure(diagnostic(UNKNOWN_THREAD, name=self.of, nearest=near))

    def _task(self, model: Model) -> int:
        return next(i for i, one in enumerate(model.tasks) if self.of in (one.name, one.key))

    def _count(self, run: Simulation) -> int:
        tasks = run.tasks if not self.of else run.tasks[self._task(run.model) :][:1]
        name = "completed" if self.name == "jobs" else self.name
        return sum(getattr(task, name) for task in tasks)

    def _load(self, analysis: Analysis) -> float:
        return next(one.demand for one in analysis.cpus if str(one.cpu) == self.of)

    def _whole(self, run: Simulation) -> Number:
        windows = run.windows[-1]
        match self.name:
            case "cycles":
                return run.cycles
            case "duration":
                return run.duration / _SECOND_NS
            case "windows":
                return windows.minimum / _SECOND_NS
            case "windows share":
                return Fraction(windows.total, run.duration * (len(run.windows) - 1))
        return windows.violated

    def _time(self, run: Simulation, outcome: Outcome) -> int | Fraction:
        """Return a time in nanoseconds."""
        index = self._task(run.model)
        numbers, analysis = run.tasks[index], None
        if self.name == "bound":
            analysis = outcome.analysis.tasks[index].response
            return _measured(analysis)
        if self.name.startswith("p"):
            return _measured(numbers.responses.percentile(round(float(self.name[1:]) * 10)))
        if self.name == "min":
            return _measured(numbers.response_min)
        if self.name == "mean":
            return Fraction(numbers.response_sum, _measured(numbers.completed or None))
        longest = numbers.response_max
        if numbers.unfinished_since is not None:
            longest = max(longest or 0, run.end - numbers.unfinished_since)
        if self.name == "slack":
            return run.model.tasks[index].every * run.model.train.distance - _measured(longest)
        return _measured(longest)


def _measured(time: int | None) -> int:
    if time is None:
        raise NotMeasuredError
    return time


class ScheduleReader(Reader):
    """Reads the text of a measure or an expectation of a schedule study."""

    is_of_program = False

    def expectation(self) -> Node:
        """Return the comparison that the whole text is."""
        left = self._sum()
        word = self._take().text
        if word not in COMPARISONS:
            raise NotAMeasureError("a comparison is missing", "es fehlt ein Vergleich")
        node = Binary(word, left, self._sum())
        self._end()
        return node

    def _named(self, name: str) -> Node:
        return self._known.get(name) or self._schedule_number(name)

    def _schedule_number(self, name: str) -> ScheduleNumber:
        word = name.lower()
        if word == "windows" and self._peek().text.lower() in ("share", "violations"):
            return ScheduleNumber(f"windows {self._take().text.lower()}")
        if word in _WHOLE:
            return ScheduleNumber(word)
        if word in COUNTS:
            return ScheduleNumber(word, self._thread() if self._word("of") else "")
        if word in ("min", "max", "mean") or _is_percentile(word):
            self._expect("response")
        elif word not in (*TIMES, "load"):
            raise NotAMeasureError(
                f"{name} is not a number of a schedule", f"{name} ist keine Zahl eines Ablaufplans"
            )
        self._expect("of")
        return ScheduleNumber(word, self._thread())

    def _thread(self) -> str:
        token = self._take()
        if token.kind not in ("name", "text", "number"):
            raise NotAMeasureError(
                "the name of a thread is missing", "es fehlt der Name eines Threads"
            )
        return token.text.strip('"')


class ScheduledProgramReader(ScheduleReader):
    """Reads the text of a study of a program that runs under a schedule: the words of both."""

    is_of_program = True

    def expectation(self) -> Node:
        """Return the expectation that the whole text is."""
        return Reader.expectation(self)

    def _named(self, name: str) -> Node:
        word, following = name.lower(), self._peek().text.lower()
        is_counted = word in (*COUNTS, "windows") and following != "at"
        is_timed = word in (*TIMES, "load") and following == "of"
        if is_counted or is_timed or following == "response":
            return self._known.get(name) or self._schedule_number(name)
        return Reader._named(self, name)


def _is_percentile(word: str) -> bool:
    try:
        return word.startswith("p") and 0 < float(word[1:]) <= 100
    except ValueError:
        return False


def _numbers_of(node: Node) -> Iterator[ScheduleNumber]:
    """Yield the numbers of schedules that a measure or an expectation consists of."""
    if isinstance(node, ScheduleNumber):
        yield node
    if isinstance(node, Binary):
        yield from _numbers_of(node.left)
        yield from _numbers_of(node.right)


def problems_of_numbers(plan: Plan, model: Model) -> list[Diagnostic]:
    """Return the mistakes in threads and processors named by measures and expectations."""
    readers = [("measure", measure.name, measure.node) for measure in plan.measures]
    readers += [("expect", one.text, one.node) for one in plan.expectations if one.node is not None]
    found: list[Diagnostic] = []
    for table, entry, node in readers:
        for number in _numbers_of(node):
            try:
                number.check(model)
            except Failure as failure:
                found += plan.placed(failure, table, entry)
    return found
