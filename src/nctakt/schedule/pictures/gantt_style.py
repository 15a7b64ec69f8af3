# SPDX-License-Identifier: MIT
"""Colours and signs of the picture of a schedule, and its legend.

In: the model, where the legend begins, how wide it may be. Out: shapes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.model import Model, TaskClass
from nctakt.schedule.pictures.figure import Box, Label, Shape, Stroke, text_width
from nctakt.schedule.simulation.interpolation_steps import has_parts

INK, FAINT, RED, BIT = "#222222", "#c8c8c8", "#c00000", "#1a7a1a"
WINDOWS = "#b8d4f0"
_EXTERNAL = ("#7f7f7f", "#a0a0a0", "#5f5f5f", "#b8b8b8")
_COLOURS = (
    "#0072b2",
    "#e69f00",
    "#009e73",
    "#cc79a7",
    "#56b4e9",
    "#d55e00",
    "#8c6d31",
    "#6a51a3",
    "#41ab5d",
    "#a50f15",
)
#: Input, interpolation, output.
PART_COLOURS = ("#9ecae1", "#4a90c2", "#08306b")
PART_NAMES = (
    Text("input", "Eingabe"),
    Text("interpolation", "Interpolation"),
    Text("output", "Ausgabe"),
)

NC = Text("NC interrupt", "NC-Interrupt")
TICK = Text("timer interrupt", "Timer-Interrupt")
_RUNS = Text("runs", "läuft")
_EXTERNAL_RUNS = Text("external thread runs", "externer Thread läuft")
_DUE = Text("due, does not run", "fällig, läuft nicht")
_SUSPENDED = Text("suspended", "suspendiert")
_OVERFLOW = Text("overflow", "Überlauf")
_WAKE_UP = Text("wakes an external thread", "weckt einen externen Thread")
_TRACE_BIT = Text("trace bit", "Trace-Bit")
_WINDOWS_TEXT = Text("Windows", "Windows")

_SIZE, _LINE, _SWATCH, _GAP = 10.0, 18.0, 24.0, 16.0

#: Draws a sign with its upper left corner at a position.
_Swatch = Callable[[float, float], list[Shape]]


def colour_of(model: Model, i: int) -> str:
    """Return the colour of a task."""
    if model.tasks[i].kind is TaskClass.EXTERNAL:
        internal = sum(task.kind is not TaskClass.EXTERNAL for task in model.tasks)
        return _EXTERNAL[(i - internal) % len(_EXTERNAL)]
    return _COLOURS[i % len(_COLOURS)]


def overflow_mark(x: float, y: float, height: float, tip: str = "") -> list[Shape]:
    """Return the sign of an overflow: a line with an arrow's head at ``x``."""
    return [
        Stroke(((x, y), (x, y + height)), RED, 2.5, tip=tip),
        Stroke(((x - 5, y - 1), (x, y + 5), (x + 5, y - 1)), RED, 2.5, tip=tip),
    ]


def legend(
    model: Model, x: float, y: float, right: float, language: Language
) -> tuple[list[Shape], float]:
    """Return the meanings of all signs in as many lines as they need, and where they end."""
    shapes: list[Shape] = []
    left = x
    for swatch, text in _meanings(model):
        label = Label(0, 0, text.get(language), _SIZE)
        width = _SWATCH + 6 + text_width(label)
        if x + width > right and x > left:
            x, y = left, y + _LINE
        shapes += [*swatch(x, y), Label(x + _SWATCH + 6, y + 10, label.text, _SIZE)]
        x += width + _GAP
    return shapes, y + _LINE


def _meanings(model: Model) -> Iterator[tuple[_Swatch, Text]]:
    kinds = {task.kind for task in model.tasks}
    yield _line(INK, (12, 0), (12, 12)), NC
    yield _line(FAINT, (12, 0), (12, 12), dashed=True), TICK
    yield _box(_COLOURS[0]), _RUNS
    if TaskClass.EXTERNAL in kinds:
        yield _box(_EXTERNAL[0]), _EXTERNAL_RUNS
        yield _wake_up, _WAKE_UP
    yield _line(_COLOURS[0], (0, 6), (24, 6)), _DUE
    if model.windows and TaskClass.ASYNCHRONOUS in kinds:
        yield _box(_COLOURS[1], hatched=True), _SUSPENDED
    yield (lambda x, y: overflow_mark(x + 12, y + 1, 11)), _OVERFLOW
    if model.windows_cpus:
        yield _box(WINDOWS), _WINDOWS_TEXT
    if has_parts(model):
        for colour, name in zip(PART_COLOURS, PART_NAMES, strict=True):
            yield _box(colour), name
    if any(call.trace_bit for task in model.tasks for call in task.calls):
        yield _line(BIT, (0, 11), (5, 11), (5, 1), (19, 1), (19, 11), (24, 11)), _TRACE_BIT


def _box(colour: str, *, hatched: bool = False) -> _Swatch:
    return lambda x, y: [Box(x, y, _SWATCH, 12, colour, hatched)]


def _line(colour: str, *points: tuple[float, float], dashed: bool = False) -> _Swatch:
    return lambda x, y: [Stroke(tuple((x + dx, y + dy) for dx, dy in points), colour, 1.4, dashed)]


def _wake_up(x: float, y: float) -> list[Shape]:
    return [Stroke(((x + 12, y), (x + 12, y + 12)), _EXTERNAL[0], 1.0, arrows="end")]
