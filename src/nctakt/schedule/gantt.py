# SPDX-License-Identifier: MIT
"""The record of a simulation as a picture: who runs when, and the oscilloscope below.

In: ``Simulation`` with a record. Out: ``Figure``. One row per thread and per Windows processor,
with NC interrupts, timer interrupts, suspensions, overflows, the arrow from the NC interrupt to
each external thread and the three times of the list as dimensions; then the seven trace bits.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Language, Text
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.figure import Box, Figure, Label, Shape, Stroke
from nctakt.schedule.findings import us
from nctakt.schedule.interpolation_steps import has_parts, parts_of
from nctakt.schedule.model import NS_PER_US, Model, TaskClass, suspension_point
from nctakt.schedule.results import EventKind, Simulation
from nctakt.schedule.tracebits import BITS, trace_bits

_LEFT, _RIGHT, _TOP = 190, 30, 96
_ROW, _BAR, _BIT = 30, 18, 24
_LEAST_WIDTH, _CYCLE_WIDTH, _MOST_WIDTH = 900, 300, 12_000
#: More timer interrupts than this are not drawn.
_MOST_TICKS = 2000

_COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#8c6d31")
_EXTERNAL, _WINDOWS = "#7f7f7f", "#b8d4f0"
_INK, _FAINT, _RED = "#222222", "#c8c8c8", "#c00000"

#: Input, interpolation, output.
_PART_COLOURS = ("#9ecae1", "#4a90c2", "#08306b")
_PART_NAMES = (
    Text("input", "Eingabe"),
    Text("interpolation", "Interpolation"),
    Text("output", "Ausgabe"),
)

_PARTS = Text("light: input · dark: output", "hell: Eingabe · dunkel: Ausgabe")
_TITLE = Text("Schedule", "Ablauf")
_SCOPE = Text("Trace bits", "Trace-Bits")
_NC = Text("NC interrupt", "NC-Interrupt")
_TICK = Text("timer interrupt", "Timer-Interrupt")
_LEGEND = Text(
    "hatched: suspended · red mark: overflow · thin line: due, not running",
    "schraffiert: suspendiert · rote Marke: Überlauf · dünne Linie: fällig, läuft nicht",
)


def tick_times(model: Model, begin: int, end: int) -> range:
    """The timer interrupts from ``begin`` to ``end``, in ns."""
    origin = model.train.phase if model.source is InterruptSource.TIMER else 0
    first = begin + (origin - begin) % model.slice
    return range(first, end + 1, model.slice)


def windows_times(run: Simulation, cpu: int) -> list[tuple[int, int]]:
    """The times in the record in which no task has the processor, in ns."""
    record = run.record
    free: list[tuple[int, int]] = []
    now = record.begin
    for segment in record.segments:
        if segment.cpu == cpu:
            if segment.begin > now:
                free.append((now, segment.begin))
            now = max(now, segment.end)
    if now < record.end:
        free.append((now, record.end))
    return free


def gantt(run: Simulation, language: Language) -> Figure:
    """The picture of a simulation's record."""
    return _Gantt(run, language).figure()


class _Gantt:
    def __init__(self, run: Simulation, language: Language) -> None:
        self._run = run
        self._model = run.model
        self._record = run.record
        self._language = language
        interrupts = [one.time for one in run.record.events if one.kind is EventKind.INTERRUPT]
        self._interrupts = interrupts
        wanted = min(max(_LEAST_WIDTH, _CYCLE_WIDTH * len(interrupts)), _MOST_WIDTH)
        self._scale = wanted / max(1, run.record.end - run.record.begin)
        self._right = _LEFT + wanted
        self._scope_top = _TOP + _ROW * (len(run.model.tasks) + len(run.model.windows_cpus)) + 34
        self._bottom = self._scope_top + _BIT * len(BITS) + 14

    def _x(self, time: int) -> float:
        return _LEFT + (time - self._record.begin) * self._scale

    def _y(self, row: int) -> float:
        """The upper edge of a row's bars."""
        return _TOP + row * _ROW + (_ROW - _BAR) / 2

    def _colour(self, i: int) -> str:
        if self._model.tasks[i].kind is TaskClass.EXTERNAL:
            return _EXTERNAL
        return _COLOURS[i % len(_COLOURS)]

    def figure(self) -> Figure:
        shapes: list[Shape] = [
            *self._interrupt_lines(),
            *self._dimensions(),
            *self._rows(),
            *self._waiting(),
            *self._running(),
            *self._parts(),
            *self._suspended(),
            *self._windows(),
            *self._overflows(),
            *self._wake_ups(),
            *self._scope(),
            *self._axis(),
        ]
        height = self._bottom + 46
        return Figure(int(self._right + _RIGHT), int(height), tuple(shapes))

    def _interrupt_lines(self) -> Iterator[Shape]:
        begin, end = self._record.begin, self._record.end
        ticks = tick_times(self._model, begin, end)
        if len(ticks) <= _MOST_TICKS:
            for time in ticks:
                x = self._x(time)
                tip = f"{_TICK.get(self._language)} {us(time)} µs"
                yield Stroke(((x, _TOP - 10), (x, self._bottom)), _FAINT, 0.6, True, tip=tip)
        for cycle, time in enumerate((*self._interrupts, end)):
            x = self._x(time)
            tip = f"{_NC.get(self._language)} {cycle}: {us(time)} µs"
            yield Stroke(((x, _TOP - 14), (x, self._bottom)), _INK, 1.2, tip=tip)

    def _dimensions(self) -> Iterator[Shape]:
        """cycle_time, time_slice and windows_time over the first cycle, as the manual has them."""
        model, begin = self._model, self._record.begin
        yield Label(10, 20, _TITLE.get(self._language), 14, bold=True)
        yield Label(10, 38, _LEGEND.get(self._language), 10)
        wide = model.cycle * self._scale > 200
        if not wide:
            return
        ticks = tick_times(model, begin, begin + 2 * model.slice)
        spans = [("cycle_time", begin, begin + model.cycle, 58.0)]
        spans.append(("time_slice", ticks[0], ticks[0] + model.slice, 80.0))
        point = suspension_point(model, begin)
        if point is not None:
            spans.append(("windows_time", point, point + model.windows, 80.0))
        for name, start, stop, y in spans:
            left, right = self._x(start), self._x(stop)
            if right > self._right + 1:
                continue
            yield Stroke(((left, y), (right, y)), _INK, 0.8, arrows="both")
            text = f"{name} {us(stop - start)}"
            yield Label((left + right) / 2, y - 4, text, 9, "middle")

    def _rows(self) -> Iterator[Shape]:
        names = [f"{task.name} (CPU {task.cpu or '*'})" for task in self._model.tasks] + [
            f"Windows (CPU {cpu})" for cpu in self._model.windows_cpus
        ]
        for row, name in enumerate(names):
            y = _TOP + (row + 1) * _ROW
            yield Stroke(((_LEFT, y), (self._right, y)), "#e4e4e4", 0.8)
            yield Label(_LEFT - 10, self._y(row) + _BAR - 5, _short(name), 11, "end")

    def _waiting(self) -> Iterator[Shape]:
        """A thin line from the moment when a job is due to its end."""
        ends = {
            (one.task, one.time - one.value): one.time
            for one in self._record.events
            if one.kind is EventKind.END
        }
        for job in self._record.jobs:
            if not job.times:  # it works in a process that is not ours
                continue
            end = ends.get((job.task, job.due), self._record.end)
            y = self._y(job.task) + _BAR / 2
            yield Stroke(((self._x(job.due), y), (self._x(end), y)), self._colour(job.task), 1.0)

    def _running(self) -> Iterator[Shape]:
        for one in self._record.segments:
            x = self._x(one.begin)
            name = self._model.tasks[one.task].name
            tip = f"{name} #{one.job}, CPU {one.cpu}: {us(one.begin)} … {us(one.end)} µs"
            width = max(0.5, self._x(one.end) - x)
            yield Box(x, self._y(one.task), width, _BAR, self._colour(one.task), tip=tip)

    def _parts(self) -> Iterator[Shape]:
        """What the interpolation consists of, in the lower half of its bars."""
        if not has_parts(self._model):
            return
        yield Label(10, 54, _PARTS.get(self._language), 10)
        for one in parts_of(self._model, self._record):
            x, name = self._x(one.begin), _PART_NAMES[one.part].get(self._language)
            tip = f"{name}: {us(one.begin)} … {us(one.end)} µs"
            width, y = self._x(one.end) - x, self._y(one.task) + _BAR / 2
            yield Box(x, y, width, _BAR / 2, _PART_COLOURS[one.part], tip=tip)

    def _suspended(self) -> Iterator[Shape]:
        begun: dict[int, tuple[int, int]] = {}
        spans: list[tuple[int, int, int, int]] = []
        for one in self._record.events:
            if one.kind is EventKind.SUSPEND:
                begun[one.task] = (one.time, one.value)
            elif one.kind is EventKind.RESUME:
                spans.append((one.task, *begun.pop(one.task), one.time))
        spans += [(task, *found, self._record.end) for task, found in begun.items()]
        for task, begin, left, end in spans:
            x = self._x(begin)
            name = self._model.tasks[task].name
            tip = f"{name}: {us(begin)} … {us(end)} µs, {us(left)} µs"
            yield Box(x, self._y(task), self._x(end) - x, _BAR, self._colour(task), True, tip)

    def _windows(self) -> Iterator[Shape]:
        for place, cpu in enumerate(self._model.windows_cpus):
            y = self._y(len(self._model.tasks) + place)
            for begin, end in windows_times(self._run, cpu):
                x = self._x(begin)
                tip = f"Windows: {us(begin)} … {us(end)} µs"
                yield Box(x, y, self._x(end) - x, _BAR, _WINDOWS, tip=tip)

    def _overflows(self) -> Iterator[Shape]:
        for one in self._record.events:
            if one.kind is EventKind.OVERFLOW:
                x, y = self._x(one.time), self._y(one.task)
                tip = f"{self._model.tasks[one.task].name}: {us(one.time)} µs, {us(one.value)} µs"
                yield Stroke(((x, y - 5), (x, y + _BAR + 5)), _RED, 2.5, tip=tip)
                yield Stroke(((x - 5, y - 6), (x, y), (x + 5, y - 6)), _RED, 2.5, tip=tip)

    def _wake_ups(self) -> Iterator[Shape]:
        """From the NC interrupt to each external thread that its semaphore wakes."""
        for job in self._record.jobs:
            if self._model.tasks[job.task].kind is TaskClass.EXTERNAL:
                x = self._x(job.due) + 2.5
                y = self._y(job.task) + _BAR / 2
                yield Stroke(((x, _TOP - 8), (x, y)), _EXTERNAL, 1.0, arrows="end")

    def _scope(self) -> Iterator[Shape]:
        yield Label(10, self._scope_top - 8, _SCOPE.get(self._language), 12, bold=True)
        names: dict[int, list[str]] = {bit: [] for bit in BITS}
        for task in self._model.tasks:
            for call in task.calls:
                if call.trace_bit and call.function not in names[call.trace_bit]:
                    names[call.trace_bit].append(call.function)
        for bit, times in trace_bits(self._model, self._record).items():
            low = self._scope_top + _BIT * bit
            high = low - _BIT + 8
            points: list[tuple[float, float]] = [(_LEFT, low)]
            for begin, end in times:
                left, right = self._x(begin), self._x(end)
                points += [(left, low), (left, high), (right, high), (right, low)]
            points.append((self._right, low))
            colour = "#1a7a1a" if times else "#9a9a9a"
            yield Stroke(tuple(points), colour, 1.4)
            text = f"{', '.join(names[bit])}  {bit}" if names[bit] else str(bit)
            yield Label(_LEFT - 10, low - 4, _short(text), 10, "end")

    def _axis(self) -> Iterator[Shape]:
        """Times of the NC interrupts in µs, as many as there is room for."""
        every = max(1, -(-60 // max(1, int(self._model.train.distance * self._scale))))
        for cycle, time in enumerate((*self._interrupts, self._record.end)):
            if cycle % every == 0:
                text = us(time // NS_PER_US * NS_PER_US)
                yield Label(self._x(time), self._bottom + 16, text, 10, "middle")
        yield Label(_LEFT - 40, self._bottom + 16, "µs", 10, "end")


def _short(name: str) -> str:
    """A name that fits beside the picture."""
    return name if len(name) <= 25 else name[:24] + "…"
