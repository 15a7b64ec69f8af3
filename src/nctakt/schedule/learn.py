# SPDX-License-Identifier: MIT
"""Execution times learnt from a recording of trace bits.

In: the model of the list used for the recording, a ``Recording``. Out: ``LearntTimes``. A bit is
high from the start of a call to its end, through all interruptions (manual 4.5.3). Where the
recording shows when threads have a processor, the time of a call is that in between; otherwise
interruptions are subtracted: more urgent threads of the same processor whose bits are high, and the
suspension according to the list. Calls cut off by the recording are left out. Times are in ns.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.files.vcd import identifier
from nctakt.lists.declared.rtconf import REALTIME_FUNCTION, InterruptSource
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.learn import (
    FUNCTIONS_NOT_LEARNT,
    INTERRUPTIONS_ESTIMATED,
    SHARED_BIT_NOT_LEARNT,
    SUSPENSIONS_UNKNOWN,
)
from nctakt.schedule.model import ANY_CPU, Model, TaskClass, suspension_point
from nctakt.schedule.pictures.traces import GAP
from nctakt.schedule.trace_reader import Recording, Times

#: A caller of a function: the task's index in the model, the function's name.
Caller = tuple[int, str]


@dataclass(frozen=True, slots=True)
class LearntTimes:
    """The times of all whole calls by caller, those of external threads by name."""

    calls: dict[Caller, tuple[int, ...]] = field(default_factory=dict)
    external: dict[str, tuple[int, ...]] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()


def learn(model: Model, recording: Recording) -> LearntTimes:
    """Return the times of the calls that were recorded."""
    if recording.jobs:
        return _from_jobs(model, recording)
    return _Learning(model, recording).times()


def _from_jobs(model: Model, recording: Recording) -> LearntTimes:
    """Return times from whole jobs: those of threads that call one function."""
    lengths: dict[str, list[int]] = {}
    for job in recording.jobs:
        lengths.setdefault(job.thread, []).append(job.length)
    calls: dict[Caller, tuple[int, ...]] = {}
    external: dict[str, tuple[int, ...]] = {}
    for i, task in enumerate(model.tasks):
        functions = {call.function for call in task.calls}
        if task.name not in lengths or len(functions) != 1:
            continue
        # Several calls of one function share the time of their job.
        times = tuple(length // len(task.calls) for length in lengths[task.name])
        if task.kind is TaskClass.EXTERNAL:
            external[task.name] = times
        else:
            calls[i, task.calls[0].function] = times
    return LearntTimes(calls, external, tuple(_unlearnt(model, calls, external)))


class _Learning:
    def __init__(self, model: Model, recording: Recording) -> None:
        self._model = model
        self._recording = recording
        self._found: list[Diagnostic] = []
        self._callers = self._callers_of_bits()

    def _callers_of_bits(self) -> dict[int, Caller]:
        """Return the function of each bit that only one function has."""
        callers: dict[int, dict[Caller, None]] = {}
        for i, task in enumerate(self._model.tasks):
            for call in task.calls:
                if call.trace_bit:
                    callers.setdefault(call.trace_bit, {})[i, call.function] = None
        for bit, several in callers.items():
            if len(several) > 1 and self._recording.bits.get(bit):
                names = ", ".join(f"{self._model.tasks[i].name}: {name}" for i, name in several)
                self._found.append(diagnostic(SHARED_BIT_NOT_LEARNT, bit=bit, names=names))
        return {
            bit: next(iter(callers_of_bit))
            for bit, callers_of_bit in callers.items()
            if len(callers_of_bit) == 1
        }

    def times(self) -> LearntTimes:
        """Return the times of all functions with a bit."""
        calls: dict[Caller, tuple[int, ...]] = {}
        estimated = unknown = False
        for bit, caller in self._callers.items():
            high = self._calls(bit)
            if not high:
                continue
            running = self._recording.running.get(identifier(self._model.tasks[caller[0]].name))
            if running is not None:
                lengths = [_overlap(running, *call) for call in high]
            else:
                blocked, is_known = self._blocked(caller[0])
                lengths = [end - begin - _overlap(blocked, begin, end) for begin, end in high]
                estimated, unknown = True, unknown or not is_known
            calls[caller] = tuple(lengths)
        if calls and estimated:
            self._found.append(diagnostic(INTERRUPTIONS_ESTIMATED))
        if calls and unknown:
            self._found.append(diagnostic(SUSPENSIONS_UNKNOWN))
        self._found += _unlearnt(self._model, calls, {})
        return LearntTimes(calls, {}, tuple(self._found))

    def _calls(self, bit: int) -> Times:
        """Return begin and end of the calls that the recording does not cut.

        A gap no longer than that drawn between two calls belongs to the second call.
        """
        calls: Times = []
        before: int | None = None
        for begin, end in self._recording.bits.get(bit, []):
            start = before if before is not None and begin - before <= GAP else begin
            if start > self._recording.begin and end < self._recording.end:
                calls.append((start, end))
            before = end
        return calls

    def _blocked(self, task: int) -> tuple[Times, bool]:
        """Return when a task cannot run by the recording, and whether suspension is known."""
        own = self._model.tasks[task]
        blocked = [
            time
            for bit, (other, _) in self._callers.items()
            if other != task
            and self._model.tasks[other].urgency >= own.urgency
            and _share_cpu(self._model, task, other)
            for time in self._recording.bits.get(bit, [])
        ]
        is_guarded = own.cpu in self._model.windows_cpus or own.cpu == ANY_CPU
        if own.kind is not TaskClass.ASYNCHRONOUS or not self._model.windows or not is_guarded:
            return _union(blocked), True
        suspended = self._suspended()
        return _union([*blocked, *(suspended or [])]), suspended is not None

    def _suspended(self) -> Times | None:
        """Return when the list suspends threads; ``None``: unknown."""
        model = self._model
        if model.source is not InterruptSource.TIMER:
            return None
        interrupts = self._interrupts()
        if not interrupts:
            return None
        model = replace(model, train=replace(model.train, phase=interrupts[0]))
        times: Times = []
        for cycle in range((self._recording.end - interrupts[0]) // model.cycle + 1):
            begin = interrupts[0] + cycle * model.cycle
            point = suspension_point(model, begin)
            if point is not None and point < begin + model.cycle:
                times.append((point, begin + model.cycle))
        return times

    def _interrupts(self) -> list[int]:
        """Return NC interrupts: as recorded, else where the interpolation begins."""
        if self._recording.interrupts:
            return self._recording.interrupts
        for bit, (_, function) in self._callers.items():
            if function == REALTIME_FUNCTION:
                return [
                    begin
                    for begin, _ in self._recording.bits.get(bit, [])
                    if begin > self._recording.begin
                ]
        return []


def _share_cpu(model: Model, task: int, other: int) -> bool:
    cpus = (model.tasks[task].cpu, model.tasks[other].cpu)
    return cpus[0] == cpus[1] or ANY_CPU in cpus


def _union(times: Times) -> Times:
    """Return the times in order, with overlapping ones merged."""
    merged: Times = []
    for begin, end in sorted(times):
        if merged and begin <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(merged[-1][1], end))
        else:
            merged.append((begin, end))
    return merged


def _overlap(times: Sequence[tuple[int, int]], begin: int, end: int) -> int:
    """Return how long ``times``, which are apart and in order, lie in a time."""
    index = max(0, bisect_left(times, (begin, begin)) - 1)
    total = 0
    while index < len(times) and times[index][0] < end:
        start, stop = times[index]
        total += max(0, min(stop, end) - max(start, begin))
        index += 1
    return total


def _unlearnt(
    model: Model, calls: dict[Caller, tuple[int, ...]], external: dict[str, tuple[int, ...]]
) -> list[Diagnostic]:
    """Return the note about missing functions."""
    names: dict[str, None] = {}
    for i, task in enumerate(model.tasks):
        if task.kind is TaskClass.EXTERNAL:
            if task.name not in external:
                names[task.name] = None
            continue
        for call in task.calls:
            if (i, call.function) not in calls:
                names[call.function] = None
    return [diagnostic(FUNCTIONS_NOT_LEARNT, names=", ".join(names))] if names else []
