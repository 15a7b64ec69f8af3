# SPDX-License-Identifier: MIT
"""The record of a simulation as a picture: who runs when, and the oscilloscope below.

In: ``Simulation`` with a record, the names of list and load. Out: ``Figure``. In its rows: NC
interrupts, timer interrupts, suspensions, overflows, the arrow from the NC interrupt to each
external thread and the three times of the list as dimensions. Rows and strips are those of
``gantt_layout``, signs those of ``gantt_style``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.analysis.findings import us
from nctakt.schedule.model import Model, TaskClass, suspension_point
from nctakt.schedule.pictures.figure import (
    Box,
    Figure,
    Label,
    Shape,
    Stroke,
    fitting,
    label_left,
    text_width,
)
from nctakt.schedule.pictures.gantt_layout import Row, RowKind, Strip, rows_of, strips_of
from nctakt.schedule.pictures.gantt_style import (
    BIT,
    FAINT,
    INK,
    NC,
    PART_COLOURS,
    PART_NAMES,
    TICK,
    WINDOWS,
    colour_of,
    legend,
    overflow_mark,
)
from nctakt.schedule.reports.report import chosen_report
from nctakt.schedule.simulation.interpolation_steps import has_parts, parts_of
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.timeline import (
    pending_times,
    suspended_times,
    tick_times,
    windows_times,
)
from nctakt.schedule.simulation.tracebits import trace_bits

_LEFT, _RIGHT, _MARGIN = 200, 40, 12
_LINE, _DIMENSION, _BAR, _ROW, _HEADING, _BIT_ROW = 18, 22, 18, 28, 24, 24
#: The width of an NC cycle, and of all of them, in pixels.
_WIDEST_CYCLE, _NARROWEST, _WIDEST = 300, 780, 1560
#: Timer interrupts that would be closer than this, in pixels, are left out.
_CLOSEST = 3.0

_ALL_CYCLES = Text("NC cycles {first} … {last}", "NC-Takte {first} … {last}")
_CHOSEN_CYCLES = Text(
    "{count} of {all} NC cycles: overflows, longest responses, least time of Windows, the first",
    "{count} von {all} NC-Takten: Überläufe, längste Antwortzeiten, kleinste Zeit von Windows, die "
    "ersten",
)
_ASSUMED = Text("assumed load", "angenommene Last")

_Span = tuple[int, int]


@dataclass(frozen=True, slots=True)
class PictureTitle:
    """The names of the list and of the load (``None``: assumed times) above a picture."""

    list_name: str
    load_name: str | None = None


def picture_title(list_path: str, load_path: str | None) -> PictureTitle:
    """Return the title for the files of a list and a load."""
    return PictureTitle(Path(list_path).name, None if load_path is None else Path(load_path).name)


def gantt(run: Simulation, title: PictureTitle, language: Language) -> Figure:
    """Return the picture of a simulation's record."""
    strips = strips_of(run)
    longest = max((strip.end - strip.begin for strip in strips), default=1)
    cycles = max((strip.count for strip in strips), default=1)
    inner = min(_WIDEST, max(_NARROWEST, _WIDEST_CYCLE * cycles))
    width = _LEFT + inner + _RIGHT
    shapes: list[Shape] = list(_head(run, strips, title, width, language))
    y = float(_MARGIN + _LINE * len(shapes) + 4)
    signs, y = legend(run.model, _MARGIN, y, width - _MARGIN, language)
    shapes += signs
    contents = _Contents(run, language)
    for index, strip in enumerate(strips):
        drawing = _StripDrawing(contents, strip, inner / max(1, longest), y, width, index == 0)
        shapes += drawing.shapes()
        y = drawing.bottom
    return Figure(width, int(y + _MARGIN), tuple(shapes))


def below_each_other(figures: Sequence[Figure]) -> Figure:
    """Return pictures combined into one, below each other."""
    shapes: list[Shape] = []
    height = 0
    for figure in figures:
        shapes += [_moved(shape, height) for shape in figure.shapes]
        height += figure.height
    return Figure(max(figure.width for figure in figures), height, tuple(shapes))


def _moved(shape: Shape, down: float) -> Shape:
    if isinstance(shape, Stroke):
        return replace(shape, points=tuple((x, y + down) for x, y in shape.points))
    return replace(shape, y=shape.y + down)


def _head(
    run: Simulation, strips: list[Strip], title: PictureTitle, width: int, language: Language
) -> Iterator[Label]:
    """Yield list, load, times, rules and NC cycles."""
    shown = sum(strip.count for strip in strips)
    recorded = [event.value for event in run.record.events if event.kind is EventKind.INTERRUPT]
    cycles = _ALL_CYCLES if shown == len(recorded) else _CHOSEN_CYCLES
    numbers = {"first": min(recorded, default=0), "last": max(recorded, default=0)}
    numbers |= {"count": shown, "all": len(recorded)}
    lines = [
        f"{title.list_name} · {title.load_name or _ASSUMED.get(language)}",
        *chosen_report(run.model, language),
        cycles.get(language).format(**numbers),
    ]
    for line, text in enumerate(lines):
        size = 10.5 if line else 14.0
        label = Label(_MARGIN, 20.0 + _LINE * line, text, size, bold=not line)
        yield fitting(label, width - 2 * _MARGIN)


class _Contents:
    """The contents of a picture, computed once for all strips; times in ns."""

    def __init__(self, run: Simulation, language: Language) -> None:
        model = run.model
        self.model = model
        self.run = run
        self.language = language
        self.rows = rows_of(model, language)
        self.interrupts = [
            (event.value, event.time)
            for event in run.record.events
            if event.kind is EventKind.INTERRUPT
        ]
        self.overflows = [event for event in run.record.events if event.kind is EventKind.OVERFLOW]
        self.pending = pending_times(run)
        self.suspended = {i: suspended_times(run, i) for i in range(len(model.tasks))}
        self.windows = {cpu: windows_times(run, cpu) for cpu in model.windows_cpus}
        self.bits = trace_bits(model, run.record)
        self.parts = parts_of(model, run.record) if has_parts(model) else []


class _StripDrawing:
    """Draws one strip; ``top`` and ``bottom`` are its edges in the picture."""

    def __init__(
        self,
        contents: _Contents,
        strip: Strip,
        scale: float,
        top: float,
        width: int,
        has_dimensions: bool,
    ) -> None:
        self._contents = contents
        self._model: Model = contents.model
        self._language: Language = contents.language
        self._strip = strip
        self._scale = scale
        self._width = width
        self._dimensions_top = top + 6
        self._has_dimensions = has_dimensions
        dimensions = 3 * _DIMENSION if has_dimensions else 0
        self._top = top + dimensions + 18
        self._y: dict[Row, float] = {}
        y = self._top
        for row in contents.rows:
            self._y[row] = y
            y += {RowKind.HEADING: _HEADING, RowKind.BIT: _BIT_ROW}.get(row.kind, _ROW)
        self._floor = y + 6
        self.bottom = self._floor + 34

    def shapes(self) -> Iterator[Shape]:
        """Yield all shapes; later ones lie above."""
        yield from self._interrupts()
        if self._has_dimensions:
            yield from self._dimensions()
        yield from self._rows()
        yield from self._pending()
        yield from self._running()
        yield from self._parts()
        yield from self._suspended()
        yield from self._windows()
        yield from self._overflows()
        yield from self._wake_ups()
        yield from self._bits()
        yield from self._axis()

    # --- places -----------------------------------------------------------------------------------

    def _x(self, time: int) -> float:
        return _LEFT + (time - self._strip.begin) * self._scale

    def _clip(self, begin: int, end: int) -> _Span | None:
        """Return the part of a time that the strip shows."""
        low, high = max(begin, self._strip.begin), min(end, self._strip.end)
        if low < high or (low == high and begin == end and high < self._strip.end):
            return low, high
        return None

    def _task_y(self, task: int) -> float:
        """Return the upper edge of a task's bars."""
        return self._bar_y(RowKind.TASK, task)

    def _bar_y(self, kind: RowKind, number: int) -> float:
        row = next(row for row in self._y if (row.kind, row.number) == (kind, number))
        return self._y[row] + (_ROW - _BAR) / 2

    def _box(self, span: _Span, y: float, height: float, colour: str, tip: str) -> Box:
        x = self._x(span[0])
        return Box(x, y, max(0.5, self._x(span[1]) - x), height, colour, tip=tip)

    # --- shapes -----------------------------------------------------------------------------------

    def _edges(self) -> list[tuple[int, int]]:
        """Return number and time of the NC interrupts, the end of the strip with them."""
        strip = self._strip
        shown = self._contents.interrupts[strip.first : strip.first + strip.count]
        return [*shown, (shown[-1][0] + 1, strip.end)]

    def _interrupts(self) -> Iterator[Shape]:
        strip = self._strip
        if self._model.slice * self._scale >= _CLOSEST:
            for time in tick_times(self._model, strip.begin, strip.end):
                x = self._x(time)
                tip = f"{TICK.get(self._language)} {us(time)} µs"
                yield Stroke(((x, self._top - 4), (x, self._floor)), FAINT, 0.6, True, tip=tip)
        for cycle, time in self._edges():
            x = self._x(time)
            tip = f"{NC.get(self._language)} {cycle}: {us(time)} µs"
            yield Stroke(((x, self._top - 8), (x, self._floor)), INK, 1.2, tip=tip)

    def _dimensions(self) -> Iterator[Shape]:
        """Yield cycle_time, time_slice and windows_time in the first cycle, as the manual does."""
        model, begin = self._model, self._strip.begin
        ticks = tick_times(model, begin, begin + 2 * model.slice)
        spans = [("cycle_time", begin, begin + model.cycle)]
        spans.append(("time_slice", ticks[0], ticks[0] + model.slice))
        point = suspension_point(model, begin)
        if point is not None:
            spans.append(("windows_time", point, point + model.windows))
        for line, (name, start, end) in enumerate(spans):
            left, right = self._x(start), self._x(end)
            if right > self._width - _MARGIN or right - left < _CLOSEST:
                continue
            y = self._dimensions_top + _DIMENSION * (line + 1)
            yield Stroke(((left, y), (right, y)), INK, 0.8, arrows="both")
            label = Label((left + right) / 2, y - 6, f"{name} {us(end - start)}", 9, "middle")
            beyond = label_left(label) + text_width(label) - (self._width - _MARGIN)
            yield replace(label, x=label.x - max(0.0, beyond))

    def _rows(self) -> Iterator[Shape]:
        right = self._x(self._strip.end)
        for row, y in self._y.items():
            yield self._row_label(row, y)
            if row.kind in (RowKind.TASK, RowKind.WINDOWS):
                yield Stroke(((_LEFT, y + _ROW), (right, y + _ROW)), "#e4e4e4", 0.8)

    @staticmethod
    def _row_label(row: Row, y: float) -> Label:
        if row.kind is RowKind.HEADING:
            return fitting(Label(_MARGIN, y + 17, row.name, 11, bold=True), _LEFT - 2 * _MARGIN)
        size, down = (10.0, 17.0) if row.kind is RowKind.BIT else (11.0, 18.0)
        label = fitting(Label(0, 0, row.name, size), _LEFT - 2 * _MARGIN)
        return replace(label, x=_LEFT - 10, y=y + down, anchor="end")

    def _pending(self) -> Iterator[Shape]:
        """Yield a thin line from the moment when a job is due to its end."""
        for task, begin, end in self._contents.pending:
            if span := self._clip(begin, end):
                y = self._task_y(task) + _BAR / 2
                points = ((self._x(span[0]), y), (self._x(span[1]), y))
                yield Stroke(points, colour_of(self._model, task), 1.0)

    def _running(self) -> Iterator[Shape]:
        for segment in self._contents.run.record.segments:
            if span := self._clip(segment.begin, segment.end):
                name = self._model.tasks[segment.task].name
                times = f"{us(segment.begin)} … {us(segment.end)} µs"
                tip = f"{name} #{segment.job}, CPU {segment.cpu}: {times}"
                colour = colour_of(self._model, segment.task)
                yield self._box(span, self._task_y(segment.task), _BAR, colour, tip)

    def _parts(self) -> Iterator[Shape]:
        """Yield the parts of the interpolation, in the lower half of its bars."""
        for part in self._contents.parts:
            if span := self._clip(part.begin, part.end):
                name = PART_NAMES[part.part].get(self._language)
                tip = f"{name}: {us(part.begin)} … {us(part.end)} µs"
                y = self._task_y(part.task) + _BAR / 2
                yield self._box(span, y, _BAR / 2, PART_COLOURS[part.part], tip)

    def _suspended(self) -> Iterator[Shape]:
        for task, times in self._contents.suspended.items():
            name, colour = self._model.tasks[task].name, colour_of(self._model, task)
            for begin, end in times:
                if span := self._clip(begin, end):
                    tip = f"{name}: {us(begin)} … {us(end)} µs"
                    box = self._box(span, self._task_y(task), _BAR, colour, tip)
                    yield replace(box, hatched=True)

    def _windows(self) -> Iterator[Shape]:
        for cpu, times in self._contents.windows.items():
            y = self._bar_y(RowKind.WINDOWS, cpu)
            for begin, end in times:
                if span := self._clip(begin, end):
                    tip = f"Windows: {us(begin)} … {us(end)} µs"
                    yield self._box(span, y, _BAR, WINDOWS, tip)

    def _overflows(self) -> Iterator[Shape]:
        for event in self._contents.overflows:
            if self._strip.begin <= event.time < self._strip.end:
                name = self._model.tasks[event.task].name
                tip = f"{name}: {us(event.time)} µs, {us(event.value)} µs"
                y = self._task_y(event.task) - 4
                yield from overflow_mark(self._x(event.time), y, _BAR + 8, tip)

    def _wake_ups(self) -> Iterator[Shape]:
        """Yield an arrow from the NC interrupt to each external thread that it wakes."""
        for job in self._contents.run.record.jobs:
            kind = self._model.tasks[job.task].kind
            if kind is TaskClass.EXTERNAL and self._strip.begin <= job.due < self._strip.end:
                x, y = self._x(job.due) + 3, self._task_y(job.task) + _BAR / 2
                colour = colour_of(self._model, job.task)
                yield Stroke(((x, self._top - 6), (x, y)), colour, 1.0, arrows="end")

    def _bits(self) -> Iterator[Shape]:
        right = self._x(self._strip.end)
        for row, y in self._y.items():
            if row.kind is not RowKind.BIT:
                continue
            low = y + _BIT_ROW - 2
            points: list[tuple[float, float]] = [(_LEFT, low)]
            for begin, end in self._contents.bits[row.number]:
                if span := self._clip(begin, end):
                    first, last = self._x(span[0]), self._x(span[1])
                    high = low - _BIT_ROW + 8
                    points += [(first, low), (first, high), (last, high), (last, low)]
            yield Stroke((*points, (right, low)), BIT, 1.4)

    def _axis(self) -> Iterator[Shape]:
        """Yield the times of the NC interrupts in µs, as many as there is room for."""
        free = 0.0
        y = self._floor + 16
        unit = Label(_MARGIN, y, f"{NC.get(self._language)}, µs", 10)
        yield unit
        for _, time in self._edges():
            label = Label(self._x(time), y, us(time), 10, "middle")
            left = label_left(label)
            is_inside = left + text_width(label) <= self._width and left > text_width(unit) + 24
            if left >= free and is_inside:
                yield label
                free = left + text_width(label) + 8
