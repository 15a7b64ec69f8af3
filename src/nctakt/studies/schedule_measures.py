# SPDX-License-Identifier: MIT
"""Measures of a simulated schedule: texts -> numbers of its threads, of Windows, of processors.

Times are seconds::

    response of GEO             the longest one; min, mean, p50, p90, p99, p99.9 response of GEO
    bound of GEO                the longest one by analysis, of all phases and times
    slack of GEO                what is left of the thread's cycle behind its longest response
    overflows of GEO            likewise lost, jobs, suspensions; without a name: of all threads
    windows                     the least time of Windows in an NC cycle
    windows share               of the processors on which it runs, 0 … 1; windows violations
    load of 1                   how much of processor 1 its threads need, 0 … 1
    cycles, duration            of the simulation
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.base.text import nearest
from nctakt.messages import diagnostic
from nctakt.messages.studies import UNKNOWN_THREAD
from nctakt.schedule.analyse import Analysis, analyse
from nctakt.schedule.model import NS_PER_US, Model
from nctakt.schedule.results import Simulation
from nctakt.studies.measure_nodes import COMPARISONS, Binary, Node, Number
from nctakt.studies.measure_text import NotAMeasureError, Reader
from nctakt.studies.outcome import NotMeasuredError, Outcome

#: Counts of a thread, which can be summed over all.
COUNTS = ("overflows", "lost", "jobs", "suspensions")
#: Times of a thread.
TIMES = ("response", "min", "max", "mean", "bound", "slack")
_WHOLE = ("cycles", "duration", "windows", "windows share", "windows violations")


class ScheduleOutcome(Outcome):
    """A simulated schedule, as measures look at it."""

    def __init__(self, simulation: Simulation) -> None:
        self.simulation = simulation
        self.queries = simulation  # type: ignore[assignment]

    @cached_property
    def analysis(self) -> Analysis:
        """The analysis of its model."""
        return analyse(self.simulation.model)

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
        assert isinstance(outcome, ScheduleOutcome)
        if self.name in COUNTS:
            return self._count(outcome.simulation)
        if self.name == "load":
            return self._load(outcome.analysis)
        if self.name in _WHOLE:
            return self._whole(outcome.simulation)
        return self._time(outcome) / 1e9

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

    def _whole(self, run: Simulation) -> float:
        windows = run.windows[-1]
        match self.name:
            case "cycles":
                return run.cycles
            case "duration":
                return run.duration / 1e9
            case "windows":
                return windows.minimum / 1e9
            case "windows share":
                return windows.total / (run.duration * (len(run.windows) - 1))
        return windows.violated

    def _time(self, outcome: ScheduleOutcome) -> float:
        run = outcome.simulation
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
            return numbers.response_sum / _measured(numbers.completed or None)
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

    def expectation(self) -> Node:
        """Return the comparison that the whole text is."""
        left = self._sum()
        word = self._take().text
        if word not in COMPARISONS:
            raise NotAMeasureError("a comparison is missing")
        node = Binary(word, left, self._sum())
        self._end()
        return node

    def _named(self, name: str) -> Node:
        word = name.lower()
        if name in self._known:
            return self._known[name]
        if word == "windows" and self._peek().text.lower() in ("share", "violations"):
            return ScheduleNumber(f"windows {self._take().text.lower()}")
        if word in _WHOLE:
            return ScheduleNumber(word)
        if word in COUNTS:
            return ScheduleNumber(word, self._thread() if self._word("of") else "")
        if word in ("min", "max", "mean") or _is_percentile(word):
            self._expect("response")
        elif word not in (*TIMES, "load"):
            raise NotAMeasureError(f"{name} is not a number of a schedule")
        self._expect("of")
        return ScheduleNumber(word, self._thread())

    def _thread(self) -> str:
        token = self._take()
        if token.kind not in ("name", "text", "number"):
            raise NotAMeasureError("the name of a thread is missing")
        return token.text.strip('"')


def _is_percentile(word: str) -> bool:
    try:
        return word.startswith("p") and 0 < float(word[1:]) <= 100
    except ValueError:
        return False


def numbers_of(node: Node) -> Iterator[ScheduleNumber]:
    """Yield the numbers that a measure or an expectation consists of."""
    if isinstance(node, ScheduleNumber):
        yield node
    if isinstance(node, Binary):
        yield from numbers_of(node.left)
        yield from numbers_of(node.right)
