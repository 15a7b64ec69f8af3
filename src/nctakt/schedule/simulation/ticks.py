# SPDX-License-Identifier: MIT
"""The schedule and the ticks of a controller: the time of each thread between two ticks.

In: a model, the threads that work for the controller. Out: for each tick its ``Share``. A tick is
one call of the thread with ``task_int``; it takes over the results that decoder and PLC have
produced before that call begins. The first activation of that thread lies before tick 0: in it the
decoder has its time for the first blocks, and the interpolation has nothing to do yet.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.recorder import Recorder
from nctakt.schedule.simulation.results import Event, EventKind, Simulation, WindowsNumbers
from nctakt.schedule.simulation.simulate import SchedulerState

#: The function that decodes (SDA, P-RTCF-00012).
DECODER_FUNCTION = "task_rnd"

#: The schedule of a tick needs that of the next, and yet another has begun by then.
_TICKS_AHEAD = 2


@dataclass(frozen=True, slots=True)
class ThreadRoles:
    """The threads that work for a controller, as indices in ``Model.tasks``.

    ``every``: NC cycles of a tick. ``interpolators``: without a call of one of them there is no
    tick. ``decoders``: groups of threads, each with the channels (from 0) that it decodes for.
    ``plc``: the external thread that is the PLC; ``None``: it runs with each tick.
    """

    every: int
    interpolators: tuple[int, ...]
    decoders: tuple[tuple[tuple[int, ...], tuple[int, ...]], ...]
    plc: int | None = None


@dataclass(frozen=True, slots=True)
class Share:
    """The share of one tick in the schedule.

    ``decoding``: for each group of decoders its time in ns since the tick before. ``is_lost``: the
    interpolation is not called, since its thread is still busy. ``overflows``: the threads that
    were busy when they were due in this tick. ``plc_calls``: how often the PLC ends a call before
    the tick that follows.
    """

    decoding: tuple[int, ...]
    is_lost: bool
    overflows: tuple[int, ...]
    plc_calls: int


class TickSchedule:
    """A schedule that advances tick by tick."""

    def __init__(self, model: Model, roles: ThreadRoles) -> None:
        self._roles = roles
        self._watcher = _Watcher(model, roles)
        self._state = SchedulerState(model, self._watcher)
        self._model = model
        self._cycle = 0
        self._begin = self._start = self._state.interrupt(0)
        self._marks: deque[_Mark] = deque(maxlen=_TICKS_AHEAD + 2)
        first = self._period()
        self._first_mark = self._mark()
        self._late = first.late
        self._now = self._period()

    def next_share(self) -> Share:
        """Return the share of the next tick, beginning with tick 0."""
        late, now = self._late, self._now
        following = self._period()
        decoding = tuple(a + b for a, b in zip(late, now.early, strict=True))
        plc_calls = now.plc_late + following.plc_early
        if self._roles.plc is None:
            plc_calls = 1
        self._late, self._now = now.late, following
        return Share(decoding, now.is_lost, now.overflows, plc_calls)

    def simulation(self, ticks: int) -> Simulation:
        """Return the results of the schedule in the first ``ticks`` ticks.

        The numbers of Windows and of missed suspensions are exactly those of these ticks; greatest
        responses are those up to here, two ticks ahead of the controller.
        """
        whole = self._state.result(self._cycle, self._start, self._begin, None)
        cycles = ticks * self._roles.every
        mark = next((candidate for candidate in self._marks if candidate.ticks == ticks), None)
        if mark is None:
            return replace(whole, cycles=cycles)
        first = self._first_mark
        windows = (_since(*both) for both in zip(first.windows, mark.windows, strict=True))
        missed = mark.missed - first.missed
        return replace(whole, cycles=cycles, windows=tuple(windows), missed_suspensions=missed)

    def _mark(self) -> _Mark:
        """Return the numbers of Windows at this tick."""
        counters = self._state.counters
        ticks = self._cycle // self._roles.every - 1
        return _Mark(ticks, counters.windows_numbers(), counters.missed)

    def _period(self) -> _Period:
        """Simulate the NC cycles from one activation of the interpolation to the next."""
        self._watcher.clear()
        begin = self._begin
        for _ in range(self._roles.every):
            end = self._state.interrupt(self._cycle + 1)
            self._state.run_cycle(self._cycle, self._begin, end)
            self._begin = end
            self._cycle += 1
        if self._model.windows:
            self._marks.append(self._mark())
        return self._watcher.period(begin)


@dataclass(frozen=True, slots=True)
class _Mark:
    """The state of the schedule after ``ticks`` ticks."""

    ticks: int
    windows: tuple[WindowsNumbers, ...]
    missed: int


def _since(first: WindowsNumbers, last: WindowsNumbers) -> WindowsNumbers:
    """Return the numbers of Windows from ``first`` to ``last``."""
    return replace(
        last,
        violated=last.violated - first.violated,
        culprits=tuple(b - a for a, b in zip(first.culprits, last.culprits, strict=True)),
        late=last.late - first.late,
    )


@dataclass(frozen=True, slots=True)
class _Period:
    """One period, with the times before and after the call of the interpolation kept apart."""

    early: tuple[int, ...]
    late: tuple[int, ...]
    is_lost: bool
    overflows: tuple[int, ...]
    plc_early: int
    plc_late: int


class _Watcher(Recorder):
    """Records only what concerns the controller in a period."""

    def __init__(self, model: Model, roles: ThreadRoles) -> None:
        super().__init__(range(0))
        self.is_open = True
        self._roles = roles
        decoding = {task for tasks, _ in roles.decoders for task in tasks}
        self._calls = {task: _Calls(model, task) for task in decoding}
        self._released: set[int] = set()
        self._begun: dict[int, int] = {}
        self._overflows: list[int] = []
        self._plc_ends: list[int] = []

    def clear(self) -> None:
        """Begin another period."""
        self._begun.clear()
        self._overflows.clear()
        self._plc_ends.clear()
        for calls in self._calls.values():
            calls.worked.clear()

    def period(self, begin: int) -> _Period:
        """Return the period that began at ``begin``."""
        interpolators = self._roles.interpolators
        is_lost = any(task not in self._begun for task in interpolators)
        cut = begin if is_lost else self._begun[interpolators[0]]
        early: list[int] = []
        late: list[int] = []
        for tasks, _ in self._roles.decoders:
            worked = [piece for task in tasks for piece in self._calls[task].worked]
            before = sum(max(0, min(end, cut) - start) for start, end in worked)
            early.append(before)
            late.append(sum(end - start for start, end in worked) - before)
        plc_early = sum(end <= cut for end in self._plc_ends)
        return _Period(
            tuple(early),
            tuple(late),
            is_lost,
            tuple(self._overflows),
            plc_early,
            len(self._plc_ends) - plc_early,
        )

    # --- calls of the simulation ----------------------------------------------------------------

    def interrupt(self, now: int, cycle: int) -> None:
        """Do nothing: it does not concern the controller."""

    def suspend(self, now: int, task: int, left: int) -> None:
        """Do nothing: it does not concern the controller."""

    def event(self, event: Event) -> None:
        """Record an overflow or the end of the PLC's call."""
        if event.kind is EventKind.OVERFLOW:
            self._overflows.append(event.task)
        elif event.kind is EventKind.END and event.task == self._roles.plc:
            self._plc_ends.append(event.time)

    def job(self, task: int, due: int, now: int, times: tuple[int, ...]) -> None:
        """Record a released job of ``task``."""
        self._released.add(task)
        if task in self._calls:
            self._calls[task].begin(times)

    def segment(self, cpu: int, begin: int, end: int, task: int, overhead: int) -> None:
        """Record that ``task`` has a processor from one time to another."""
        if task in self._released:
            self._released.remove(task)
            self._begun.setdefault(task, begin)
        if task in self._calls:
            self._calls[task].go_on(begin, end, overhead)


class _Calls:
    """The progress of a thread in the calls of its job, and its times in those of the decoder."""

    def __init__(self, model: Model, task: int) -> None:
        self._decodes = [call.function == DECODER_FUNCTION for call in model.tasks[task].calls]
        self._activation = model.overheads.activation
        self._overhead = 0
        self._left: deque[tuple[bool, int]] = deque()
        self.worked: list[tuple[int, int]] = []

    def begin(self, times: Sequence[int]) -> None:
        """Begin another job, with the times of its calls."""
        self._overhead = self._activation
        self._left = deque(zip(self._decodes, times, strict=True))

    def go_on(self, begin: int, end: int, overhead: int) -> None:
        """Let the job have a processor; the cost of scheduling comes first."""
        self._overhead += overhead
        used = min(self._overhead, end - begin)
        self._overhead -= used
        now = begin + used
        while now < end and self._left:
            decodes, left = self._left.popleft()
            used = min(left, end - now)
            if decodes:
                self.worked.append((now, now + used))
            if used < left:
                self._left.appendleft((decodes, left - used))
            now += used
