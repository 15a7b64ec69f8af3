# SPDX-License-Identifier: MIT
"""Values of a list with which each thread has the slack that is asked for.

In: the configuration, a function that makes its model, the slacks, the parameters that may vary.
Out: ``Suggestions``: lists with the fewest changes first, those that guarantee Windows nothing
last. The search starts from the present list, makes one change after another, and continues with
the most promising lists; its results hold by the analysis, others may exist. Times in ns unless
stated otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import RtconfConfiguration, SchedulerThread
from nctakt.lists.format.values import Key
from nctakt.lists.machine.schedules.scheduling_checks import is_realtime
from nctakt.schedule.analysis.analyse import Analysis, TaskAnalysis, analyse
from nctakt.schedule.effective_table import effective_values
from nctakt.schedule.model import Model

Variable = Literal["windows_time", "time_slice", "priorities", "cpus", "calls"]
VARIABLES: tuple[Variable, ...] = ("windows_time", "time_slice", "priorities", "cpus", "calls")

#: Number of lists kept after each change, and maximum number of changes.
_BEAM, _MAX_CHANGES = 8, 4
#: Maximum number of suggestions.
_MAX_SUGGESTIONS = 3
#: The lack of a thread without a bound, in periods.
_NO_BOUND = 10.0
#: Number of values of windows_time that are tried.
_MAX_WINDOWS = 24
#: time_slice lies between these parts of cycle_time (manual 3.3).
_RATIOS = range(3, 21)

#: Makes the model of a configuration.
ModelOf = Callable[[RtconfConfiguration], Model]


@dataclass(frozen=True, slots=True)
class Slacks:
    """The part of its period that each thread shall have left, in percent; ``threads``: by name."""

    everybody: float
    threads: Mapping[str, float]

    def limit(self, name: str, period: int) -> float:
        """Return the longest response of a thread that leaves its slack, in ns."""
        return period * (1 - self.threads.get(name, self.everybody) / 100)


@dataclass(frozen=True, slots=True)
class Suggestion:
    """A list, its analysis; ``changes``: how many parameters differ from the present list."""

    configuration: RtconfConfiguration
    analysis: Analysis
    changes: int


@dataclass(frozen=True, slots=True)
class Suggestions:
    """``present``: the present list; ``is_met``: it has the slacks already.

    ``max_calls``: for a list that has them, how many calls of task_rnd each thread could have.
    """

    present: Suggestion
    is_met: bool
    better: tuple[Suggestion, ...]
    max_calls: Mapping[str, int]


def suggest(
    configuration: RtconfConfiguration,
    model_of: ModelOf,
    slacks: Slacks,
    variables: Collection[Variable],
    cpus: range,
) -> Suggestions:
    """Return lists that have the slacks; ``cpus``: the values ``thread[i].cpu`` may have."""
    search = _Search(configuration, model_of, slacks, variables, cpus)
    present = search.judge(configuration)
    if present.shortfall == 0:
        return Suggestions(present.suggestion, True, (), search.max_calls())
    return Suggestions(present.suggestion, False, tuple(search.better(present)), {})


@dataclass(frozen=True, slots=True)
class _Judged:
    """A list with its shortfall: 0 if all slacks are met."""

    suggestion: Suggestion
    shortfall: float


class _Search:
    def __init__(
        self,
        present: RtconfConfiguration,
        model_of: ModelOf,
        slacks: Slacks,
        variables: Collection[Variable],
        cpus: range,
    ) -> None:
        self._present = present
        self._values = effective_values(present)
        self._model_of = model_of
        self._slacks = slacks
        self._variables = variables
        self._cpus = cpus
        self._seen: dict[RtconfConfiguration, None] = {present: None}
        self._had_windows = self._windows_kept(analyse(model_of(present)))

    def judge(self, configuration: RtconfConfiguration) -> _Judged:
        """Analyse a list and compute its shortfall."""
        analysis = analyse(self._model_of(configuration))
        shortfall = sum(
            self._shortfall(task.name, bound)
            for task, bound in zip(analysis.model.tasks, analysis.tasks, strict=True)
            if task.calls
        )
        # Windows shall keep the time guaranteed to it before.
        if self._had_windows and not self._windows_kept(analysis):
            shortfall += 1
        values = effective_values(configuration)
        changes = sum(values[key] != value for key, value in self._values.items())
        return _Judged(Suggestion(configuration, analysis, changes), shortfall)

    def _shortfall(self, name: str, bound: TaskAnalysis) -> float:
        limit = max(1.0, self._slacks.limit(name, bound.period))
        if bound.response is None:
            return _NO_BOUND
        return min(_NO_BOUND, max(0.0, bound.response / limit - 1))

    @staticmethod
    def _windows_kept(analysis: Analysis) -> bool:
        return not any(cpu.reaches_windows for cpu in analysis.cpus)

    def better(self, present: _Judged) -> list[Suggestion]:
        """Return lists that have all slacks, the best first."""
        beam = [present]
        solutions: list[_Judged] = []
        for _ in range(_MAX_CHANGES):
            reached: list[_Judged] = []
            for judged in beam:
                for configuration in self._neighbours(judged.suggestion.configuration):
                    if configuration not in self._seen:
                        self._seen[configuration] = None
                        reached.append(self.judge(configuration))
            solutions += [judged for judged in reached if judged.shortfall == 0]
            if len(self._different(solutions)) >= _MAX_SUGGESTIONS:
                break
            open_ones = [judged for judged in reached if judged.shortfall > 0]
            beam = sorted(open_ones, key=lambda candidate: candidate.shortfall)[:_BEAM]
        return self._different(solutions)[:_MAX_SUGGESTIONS]

    def _different(self, solutions: list[_Judged]) -> list[Suggestion]:
        """Return the best solution for each choice of parameters.

        A list is dropped if it changes more than a better one, including that one's parameters.
        """
        best: dict[frozenset[Key], Suggestion] = {}
        for judged in sorted(solutions, key=self._rank):
            values = effective_values(judged.suggestion.configuration)
            changed = frozenset(key for key, value in self._values.items() if values[key] != value)
            if not any(fewer <= changed for fewer in best):
                best[changed] = judged.suggestion
        return list(best.values())

    def _rank(self, judged: _Judged) -> tuple[float, ...]:
        """Return a key that is smaller for a better list."""
        suggestion = judged.suggestion
        configuration = suggestion.configuration
        calls = sum(
            function.calls_per_cycle
            for thread in configuration.threads
            for function in thread.functions
        )
        gives_up_windows = self._present.windows_time_us > 0 == configuration.windows_time_us
        return (
            gives_up_windows,
            suggestion.changes,
            # Windows and the functions lose as little as can be.
            max(0, self._present.windows_time_us - configuration.windows_time_us),
            -calls,
            max(self._usage(suggestion.analysis)),
        )

    @staticmethod
    def _usage(analysis: Analysis) -> list[float]:
        """Return which part of its period each thread needs at most."""
        return [0.0, *((bound.response or 0) / max(1, bound.period) for bound in analysis.tasks)]

    # --- changes ----------------------------------------------------------------------------------

    def _neighbours(self, configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
        """Yield the lists that are one change away."""
        if "windows_time" in self._variables:
            yield from self._windows_times(configuration)
        if "time_slice" in self._variables:
            yield from _time_slices(configuration)
        if "priorities" in self._variables:
            yield from self._priorities(configuration)
        if "cpus" in self._variables:
            yield from self._placements(configuration)
        if "calls" in self._variables:
            yield from _fewer_calls(configuration)

    @staticmethod
    def _windows_times(configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
        slice_, present = configuration.time_slice_us, configuration.windows_time_us
        maximum = configuration.cycle_time_us // slice_
        step = -(-maximum // _MAX_WINDOWS)
        for slices in range(0, maximum, step):
            if slices * slice_ != present:
                yield replace(configuration, windows_time_us=slices * slice_)

    def _priorities(self, configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
        """Yield lists in which two threads, not the realtime one, have exchanged priorities."""
        threads = configuration.threads
        free = [i for i, thread in enumerate(threads) if not is_realtime(thread)]
        for index, i in enumerate(free):
            for k in free[index + 1 :]:
                one, other = threads[i], threads[k]
                if one.priority != other.priority:
                    changed = {
                        i: replace(one, priority=other.priority),
                        k: replace(other, priority=one.priority),
                    }
                    yield _with_threads(configuration, changed)

    def _placements(self, configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
        for i, thread in enumerate(configuration.threads):
            for cpu in self._cpus:
                if cpu != thread.cpu:
                    yield _with_threads(configuration, {i: replace(thread, cpu=cpu)})

    # --- more calls -------------------------------------------------------------------------------

    def max_calls(self) -> dict[str, int]:
        """Return for each thread how often it could call task_rnd, all else unchanged."""
        calls_of_threads: dict[str, int] = {}
        for i, thread in enumerate(self._present.threads):
            present = _calls_of(thread)
            if not present:
                continue
            calls = present
            while calls < _MAX_CALLS:
                more = _with_threads(self._present, {i: _with_calls(thread, calls + 1)})
                if self.judge(more).shortfall > 0:
                    break
                calls += 1
            calls_of_threads[thread.name] = calls
        return calls_of_threads


#: Maximum number of calls of a function that is tried.
_MAX_CALLS = 1000
_ROTATING = "task_rnd"


def _with_threads(
    configuration: RtconfConfiguration, changed: Mapping[int, SchedulerThread]
) -> RtconfConfiguration:
    threads = tuple(changed.get(i, thread) for i, thread in enumerate(configuration.threads))
    return replace(configuration, threads=threads)


def _time_slices(configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
    """Yield lists with another time_slice; windows_time stays a multiple, no shorter than it is."""
    cycle = configuration.cycle_time_us
    for ratio in _RATIOS:
        slice_ = cycle // ratio
        if cycle % ratio or slice_ == configuration.time_slice_us:
            continue
        windows = -(-configuration.windows_time_us // slice_) * slice_
        yield replace(configuration, time_slice_us=slice_, windows_time_us=windows)


def _calls_of(thread: SchedulerThread) -> int:
    return sum(
        function.calls_per_cycle for function in thread.functions if function.name == _ROTATING
    )


def _with_calls(thread: SchedulerThread, calls: int) -> SchedulerThread:
    """Return the thread with another number of calls of its (first) rotating function."""
    functions = list(thread.functions)
    index = next(i for i, function in enumerate(functions) if function.name == _ROTATING)
    others = _calls_of(thread) - functions[index].calls_per_cycle
    functions[index] = replace(functions[index], calls_per_cycle=calls - others)
    return replace(thread, functions=tuple(functions))


def _fewer_calls(configuration: RtconfConfiguration) -> Iterator[RtconfConfiguration]:
    """Yield lists in which a thread calls its rotating function once less, half as often, once."""
    for i, thread in enumerate(configuration.threads):
        for function in thread.functions:
            calls = function.calls_per_cycle
            if function.name != _ROTATING or calls < 2:
                continue
            for fewer in dict.fromkeys((calls - 1, calls // 2, 1)):
                functions = tuple(
                    replace(called, calls_per_cycle=fewer) if called is function else called
                    for called in thread.functions
                )
                yield _with_threads(configuration, {i: replace(thread, functions=functions)})
