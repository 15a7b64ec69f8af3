# SPDX-License-Identifier: MIT
"""Two lists compared: what became better or worse, per thread and for Windows.

In: for each list its configuration, its analysis and a simulation. Out: ``Comparison``. Threads
belong together by name. The criteria, in this order: the share of activations that overflow, the
longest simulated response, the bound. Times in ns.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.format.parameter import shown, with_indices
from nctakt.schedule.analysis.analyse import Analysis, TaskAnalysis
from nctakt.schedule.effective_table import effective_values
from nctakt.schedule.simulation.results import Simulation, TaskNumbers, WindowsNumbers


class Verdict(enum.Enum):
    """The change from the first list to the second."""

    BETTER = "better"
    WORSE = "worse"
    SAME = "same"
    ADDED = "added"
    REMOVED = "removed"


@dataclass(frozen=True, slots=True)
class Side:
    """One list: its name, its content, the findings about it."""

    name: str
    configuration: RtconfConfiguration
    analysis: Analysis
    run: Simulation


@dataclass(frozen=True, slots=True)
class ThreadSide:
    """A thread in one of the lists."""

    bound: TaskAnalysis
    numbers: TaskNumbers


@dataclass(frozen=True, slots=True)
class ThreadComparison:
    """A thread in both lists; ``None`` where it is missing."""

    name: str
    first: ThreadSide | None
    second: ThreadSide | None
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class WindowsComparison:
    """Windows on one processor (0: the sum) as shares and least times; ``None`` if absent."""

    cpu: int
    shares: tuple[float | None, float | None]
    minimum: tuple[int | None, int | None]
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Comparison:
    """``parameters``: name, value in the first, value in the second list, where they differ."""

    parameters: tuple[tuple[str, str, str], ...]
    threads: tuple[ThreadComparison, ...]
    windows: tuple[WindowsComparison, ...]


def compare(first: Side, second: Side) -> Comparison:
    """Compare two lists."""
    return Comparison(
        tuple(_parameters(first.configuration, second.configuration)),
        tuple(_threads(first, second)),
        tuple(_windows(first.run, second.run)),
    )


def _parameters(
    first: RtconfConfiguration, second: RtconfConfiguration
) -> Iterator[tuple[str, str, str]]:
    values, others = effective_values(first), effective_values(second)
    for key in dict.fromkeys((*values, *others)):
        one = shown(values[key]) if key in values else "–"
        other = shown(others[key]) if key in others else "–"
        if one != other:
            yield with_indices(*key), one, other


def _threads(first: Side, second: Side) -> Iterator[ThreadComparison]:
    ones, others = _by_name(first), _by_name(second)
    for name in dict.fromkeys((*ones, *others)):
        one, other = ones.get(name), others.get(name)
        if one is None or other is None:
            verdict = Verdict.ADDED if one is None else Verdict.REMOVED
        else:
            verdict = _verdict(_rank(one), _rank(other))
        yield ThreadComparison(name, one, other, verdict)


def _by_name(side: Side) -> dict[str, ThreadSide]:
    """Return the threads by name; of several with one name, all but the first by their key."""
    threads: dict[str, ThreadSide] = {}
    rows = zip(side.run.model.tasks, side.analysis.tasks, side.run.tasks, strict=True)
    for task, bound, numbers in rows:
        name = task.key if task.name in threads else task.name
        threads[name] = ThreadSide(bound, numbers)
    return threads


def _rank(thread: ThreadSide) -> tuple[float, float, float]:
    """Return a key that is smaller for the better."""
    numbers, bound = thread.numbers, thread.bound.response
    longest = numbers.response_max
    return (
        numbers.overflows / numbers.due if numbers.due else 0.0,
        float("inf") if longest is None and numbers.due else longest or 0,
        float("inf") if bound is None else bound,
    )


def _verdict(first: object, second: object) -> Verdict:
    """Compare two ranks."""
    if first == second:
        return Verdict.SAME
    return Verdict.BETTER if second < first else Verdict.WORSE  # type: ignore[operator]


def _windows(first: Simulation, second: Simulation) -> Iterator[WindowsComparison]:
    ones = {one.cpu: one for one in first.windows}
    others = {one.cpu: one for one in second.windows}
    for cpu in dict.fromkeys((*ones, *others)):
        one, other = ones.get(cpu), others.get(cpu)
        if one is None or other is None:
            verdict = Verdict.ADDED if one is None else Verdict.REMOVED
        else:
            verdict = _verdict(_lack(first, one), _lack(second, other))
        yield WindowsComparison(
            cpu,
            (_share(first, one), _share(second, other)),
            (None if one is None else one.minimum, None if other is None else other.minimum),
            verdict,
        )


def _lack(run: Simulation, windows: WindowsNumbers) -> tuple[float, float, float]:
    """Return a key that is smaller for the better for Windows."""
    share = windows.total / run.duration
    return windows.violated / run.cycles, -windows.minimum / run.model.cycle, -share


def _share(run: Simulation, windows: WindowsNumbers | None) -> float | None:
    return None if windows is None else windows.total / run.duration
