# SPDX-License-Identifier: MIT
"""A run -> the content of a picture of it, in any format: path, lanes, panels.

In: the trace, the timeline, the axes of the machine, the chosen signals. Out: ``Scene``. Above is
the path with the places of reactions; below, over time, a lane for each reaction with its
condition, each function and report, then panels of curves. Panels without a change are left out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.plots.lanes import Arrow, Lane, arrows_of, lanes_of, signal_lane
from nctakt.plots.motion import (
    ACCELERATION,
    DISTANCE_TO_GO,
    JERK,
    OVERRIDE,
    PATH_SPEED,
    RAPID,
    SPEED,
    AxisMotion,
    Curve,
    axis_motion,
    curve_of,
    position_signal,
    tip_signal,
)
from nctakt.plots.tool_path import ToolPath, tool_path
from nctakt.results.timelines.timeline import Timeline
from nctakt.results.trace.recorded import Trace

#: Colours of axes and signals, in their order; the same in all panels.
COLOURS = (
    "#1f77b4",
    "#d95f02",
    "#2ca02c",
    "#9467bd",
    "#8c564b",
    "#e377c2",
    "#17becf",
    "#7f7f7f",
    "#bcbd22",
    "#3b4cc0",
)
NEUTRAL = "#6b7280"

#: Signals of the first channel that a picture shows in another way.
_SHOWN = (PATH_SPEED, DISTANCE_TO_GO, OVERRIDE, RAPID, "BLOCK", "CYCLES.ACTIVE")
_CHANNEL = re.compile(r"CH\d+")

#: Maximum number of names in a note.
MAX_NAMES = 6

#: Maximum number of panels of single signals.
MAX_PANELS = 12

_POSITION = Text("position", "Position")
_DERIVED = {
    SPEED: (Text("speed", "Geschwindigkeit"), "/s"),
    ACCELERATION: (Text("acceleration", "Beschleunigung"), "/s²"),
    JERK: (Text("jerk", "Ruck"), "/s³"),
}
_PATH = Text("path", "Bahn")
_OVERRIDE = Text("override", "Override")
_REST = Text("distance to go", "Restweg")
_SIGNALS = Text("signals", "Signale")
_AT_REST = Text("at rest: {names}", "in Ruhe: {names}")
_NOTHING = Text("no axis moved", "keine Achse hat sich bewegt")
_MORE_PANELS = Text("{count} more signals", "{count} weitere Signale")
_CONSTANT = Text("constant: {names}", "konstant: {names}")


@dataclass(frozen=True, slots=True)
class Line:
    """A curve of a panel; ``is_step``: it keeps its value until the next one."""

    name: str
    colour: str
    curve: Curve
    is_step: bool = False
    is_dotted: bool = False


@dataclass(frozen=True, slots=True)
class Panel:
    """Curves of one unit; ``limits``: values of dashed lines with their colours."""

    title: str
    unit: str
    lines: tuple[Line, ...]
    limits: tuple[tuple[float, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Scene:
    """What a picture shows, times in s; ``notes``: omitted parts; ``arrows``: signals."""

    title: str
    begin_s: float
    end_s: float
    tick_s: float
    path: ToolPath | None
    lanes: tuple[Lane, ...]
    panels: tuple[Panel, ...]
    notes: tuple[str, ...]
    arrows: tuple[Arrow, ...] = ()


def scene_of(
    trace: Trace,
    timeline: Timeline,
    axes: Sequence[AxisConfiguration],
    *,
    limits_jerk: bool,
    chosen: Sequence[str] | None,
    title: str,
    language: Language,
) -> Scene:
    """Return the scene of a run; the signals ``chosen`` take the place of the axes' motion.

    Unprintable characters of ``title`` become dots.
    """
    recorded = [axis for axis in axes if position_signal(axis.name) in trace]
    motions = [axis_motion(trace, axis, limits_jerk=limits_jerk) for axis in recorded]
    moving = [motion for motion in motions if motion.moves]
    builder = _Panels(trace, motions, language)
    if chosen is None:
        panels = [*builder.motion(), *builder.path()]
        positions = {position_signal(motion.name) for motion in motions}
        positions |= {tip_signal(motion.name) for motion in motions}
        names = [name for name in trace if name not in positions and not _is_shown(name)]
        notes = builder.rest_notes()
    else:
        panels, names, notes = [], list(dict.fromkeys(chosen)), []
    switches, further, constant = builder.signals(names, keeps_constant=chosen is not None)
    if len(further) > MAX_PANELS:
        notes.append(_MORE_PANELS.get(language).format(count=len(further) - MAX_PANELS))
    if constant:
        listed = [*constant[:MAX_NAMES], *(["…"] if len(constant) > MAX_NAMES else [])]
        notes.append(_CONSTANT.get(language).format(names=", ".join(listed)))
    lanes = [*lanes_of(timeline, language), *switches]
    spatial = [motion for motion in moving if motion.unit == "mm"]
    rapid = curve_of(trace, RAPID).values
    return Scene(
        "".join(character if character.isprintable() else "·" for character in title),
        timeline.begin_us / 1e6,
        timeline.end_us / 1e6,
        timeline.cycle_time_us / 1e6,
        tool_path(spatial, rapid, lanes) if len(spatial) > 1 else None,
        tuple(lanes),
        (*panels, *further[:MAX_PANELS]),
        tuple(notes),
        tuple(arrows_of(timeline)),
    )


def _is_shown(name: str) -> bool:
    """Return whether an unchosen signal is in the picture already, or says little.

    Of further channels positions, speed and override are drawn as they were recorded.
    """
    channel, _, rest = name.partition(".")
    if not _CHANNEL.fullmatch(channel):
        return name in _SHOWN or name.endswith(".ACS.CUR_POS")
    return channel == "CH1" or rest in ("BLOCK", "CYCLES.ACTIVE") or rest.endswith(".ACS.CUR_POS")


class _Panels:
    """Makes the panels; axes keep their colours in all of them."""

    def __init__(self, trace: Trace, motions: Sequence[AxisMotion], language: Language) -> None:
        self._trace = trace
        self._motions = motions
        self._moving = [motion for motion in motions if motion.moves]
        self._language = language
        self._colours = {
            motion.name: COLOURS[index % len(COLOURS)] for index, motion in enumerate(motions)
        }

    def _text(self, text: Text) -> str:
        return text.get(self._language)

    def rest_notes(self) -> list[str]:
        """Return the note about axes that do not move."""
        resting = [motion.name for motion in self._motions if not motion.moves]
        if not self._moving:
            return [self._text(_NOTHING)]
        return [self._text(_AT_REST).format(names=", ".join(resting))] if resting else []

    def motion(self) -> Iterator[Panel]:
        """Yield position, speed, acceleration and jerk of the axes that move, by unit."""
        for unit in dict.fromkeys(motion.unit for motion in self._moving):
            own = [motion for motion in self._moving if motion.unit == unit]
            positions = tuple(self._line(motion.name, motion.position) for motion in own)
            yield Panel(self._text(_POSITION), unit, positions)
            for order, (name, per) in _DERIVED.items():
                lines = [self._line(axis.name, axis.derivatives[order - 1]) for axis in own]
                speed = curve_of(self._trace, PATH_SPEED)
                if order == SPEED and unit == self._moving[0].unit and len(own) > 1:
                    lines.append(Line(self._text(_PATH), NEUTRAL, speed, is_dotted=True))
                limits = {
                    axis.limits[order - 1]: self._colours[axis.name] for axis in reversed(own)
                }
                yield Panel(
                    self._text(name),
                    f"{unit}{per}",
                    tuple(line for line in lines if len(line.curve.values)),
                    tuple((limit, limits[limit]) for limit in sorted(limits) if limit > 0.0),
                )

    def _line(self, name: str, curve: Curve) -> Line:
        return Line(name, self._colours[name], curve)

    def path(self) -> Iterator[Panel]:
        """Yield override and distance to go, unless they never change."""
        unit = self._moving[0].unit if self._moving else "mm"
        for signal, text, unit_shown, is_step in (
            (OVERRIDE, _OVERRIDE, "%", True),
            (DISTANCE_TO_GO, _REST, unit, False),
        ):
            curve = curve_of(self._trace, signal)
            if not curve.is_constant:
                name = self._text(text)
                yield Panel(name, unit_shown, (Line(name, NEUTRAL, curve, is_step),))

    def signals(
        self, names: Sequence[str], *, keeps_constant: bool
    ) -> tuple[list[Lane], list[Panel], list[str]]:
        """Return lanes of switches, panels of other signals, names of those that are left out.

        Signals with a unit share the panel of their unit.
        """
        details = {signal.name: signal for signal in self._trace.signals}
        switches: list[Lane] = []
        panels: dict[tuple[str, str], list[Line]] = {}
        constant: list[str] = []
        for index, name in enumerate(names):
            signal, curve = details[name], curve_of(self._trace, name)
            if curve.is_constant and not keeps_constant:
                constant.append(name)
                continue
            lane = signal_lane(name, curve, self._trace) if signal.integral else None
            if lane is not None:
                switches.append(lane)
                continue
            colour = COLOURS[index % len(COLOURS)]
            key = (self._text(_SIGNALS), signal.unit) if signal.unit else (name, "")
            line = Line(name, colour, curve, is_step=signal.integral)
            panels.setdefault(key, []).append(line)
        all_panels = [Panel(title, unit, tuple(lines)) for (title, unit), lines in panels.items()]
        return switches, all_panels, constant
