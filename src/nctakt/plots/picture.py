# SPDX-License-Identifier: MIT
"""The curves of a run -> a picture file: PNG, SVG, or a page with the SVG in it (matplotlib).

In: ``Motion``, a file name. Out: the file; the same run gives the same bytes. Above the path in the
plane and in space, below it the motion over time: a lane for each reaction, M and H function and
error; position, speed, acceleration, jerk with the limits of the axes as dashed lines, override and
distance to go. No window is opened and no state of matplotlib is changed.
"""

from __future__ import annotations

import importlib.util
import io
import re
import warnings
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.schedule_results import LIBRARY_MISSING, UNKNOWN_PICTURE_FORMAT
from nctakt.plots.motion import ACCELERATION, JERK, SPEED, AxisMotion, Curve, Lane, Motion, thinned

ENDINGS = (".png", ".svg", ".html")

_DPI = 110
_WIDTH_IN = 12.0
_PATH_HEIGHT_IN = 4.4
_PANEL_HEIGHT_IN = 1.7
#: Maximum number of points of a curve: more cannot be seen.
_MAX_POINTS = 4000
#: Maximum number of lines through all panels: more would hide the curves.
_MAX_LINES = 60
_LANE_HEIGHT_IN = 0.17
#: Maximum number of lanes; further ones are counted.
_MAX_LANES = 24

_COLOURS = (
    "#1f77b4",
    "#d95f02",
    "#2ca02c",
    "#9467bd",
    "#8c564b",
    "#e377c2",
    "#17becf",
    "#7f7f7f",
    "#bcbd22",
    "#000000",
)
_LANE_COLOURS = {
    "fired": "#d62728",
    "M": "#9467bd",
    "H": "#9467bd",
    "output": "#1f77b4",
    "error": "#d62728",
    "starved": "#ff7f0e",
    "overflow": "#d62728",
    "end": "#7f7f7f",
}

_POSITION = Text("position", "Position")
_DERIVED = {
    SPEED: (Text("speed", "Geschwindigkeit"), "/s"),
    ACCELERATION: (Text("acceleration", "Beschleunigung"), "/s²"),
    JERK: (Text("jerk", "Ruck"), "/s³"),
}
_TIME = Text("time in s", "Zeit in s")
_PLANE = Text("path in the plane", "Bahn in der Ebene")
_SPACE = Text("path in space", "Bahn im Raum")
_PATH_SPEED = Text("path", "Bahn")
_OVERRIDE = Text("override in %", "Override in %")
_REST = Text("distance to go", "Restweg")
_AT_REST = Text("at rest: {names}", "in Ruhe: {names}")
_HAPPENED = Text("events", "Ereignisse")
_MORE = Text("{count} more", "{count} weitere")
_NOTHING = Text("no axis moved", "keine Achse hat sich bewegt")

#: Label, curves as (name, colour, curve), limits as (value, colour).
_Panel = tuple[str, list[tuple[str, str, Curve]], list[tuple[float, str]]]

_PAGE = """\
<!doctype html>
<html lang="{language}">
<head><meta charset="utf-8"><title>{title}</title>
<style>body {{ margin: 1em; font-family: sans-serif; }} svg {{ max-width: 100%; height: auto; }}
</style></head>
<body>
{picture}</body>
</html>
"""


def check_picture(path: str) -> None:
    """Raise ``Failure`` for another suffix (900635) and without matplotlib (900634)."""
    if Path(path).suffix.lower() not in ENDINGS:
        raise Failure(diagnostic(UNKNOWN_PICTURE_FORMAT, file=path))
    if importlib.util.find_spec("matplotlib") is None:
        raise Failure(diagnostic(LIBRARY_MISSING, library="matplotlib", what="--plot"))


def write_picture(motion: Motion, path: Path, title: str, language: Language) -> None:
    """Draw a run; raises ``OSError``. Unprintable characters of ``title`` become dots."""
    title = "".join(character if character.isprintable() else "·" for character in title)
    ending = path.suffix.lower()
    data = _Drawing(motion, title, language).render("png" if ending == ".png" else "svg")
    if ending == ".html":
        picture = data.decode("utf-8")
        picture = picture[picture.index("<svg") :]
        page = _PAGE.format(language=language, title=escape(title), picture=picture)
        data = page.encode("utf-8")
    path.write_bytes(data)


class _Drawing:
    """One sheet; the axes of the machine keep their colours in all panels."""

    def __init__(self, motion: Motion, title: str, language: Language) -> None:
        self._motion = motion
        self._language = language
        self._moving = [axis for axis in motion.axes if axis.moves]
        self._colours = {
            axis.name: _COLOURS[index % len(_COLOURS)] for index, axis in enumerate(motion.axes)
        }
        self._title = title

    def render(self, format_: str) -> bytes:
        """Return the picture's file as bytes."""
        import matplotlib  # noqa: PLC0415 - only a picture needs it
        from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
        from matplotlib.figure import Figure  # noqa: PLC0415

        panels = list(self._panels())
        spatial = [axis for axis in self._moving if axis.unit == "mm"]
        path_rows = 1 if len(spatial) > 1 else 0
        lanes = self._motion.lanes[:_MAX_LANES]
        heights = [_PATH_HEIGHT_IN] * path_rows
        heights.append(0.25 + _LANE_HEIGHT_IN * max(len(lanes), 2))
        heights += [_PANEL_HEIGHT_IN] * len(panels)
        # names of files, axes and cells are not formulas, and may have signs that the font lacks
        settings: dict[Any, Any] = {"svg.hashsalt": "nctakt", "svg.fonttype": "path"}
        settings["text.parse_math"] = False
        with matplotlib.rc_context(settings), warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="Glyph .* missing")
            sheet = Figure(figsize=(_WIDTH_IN, sum(heights) + 1.2), dpi=_DPI, layout="constrained")
            FigureCanvasAgg(sheet)
            sheet.suptitle(self._title, fontsize=11)
            grid = sheet.add_gridspec(len(heights), 2, height_ratios=heights)
            if path_rows:
                self._draw_path(sheet, grid, spatial)
            shared = sheet.add_subplot(grid[path_rows, :])
            self._draw_lanes(shared, lanes)
            for index, panel in enumerate(panels):
                axes = sheet.add_subplot(grid[path_rows + 1 + index, :], sharex=shared)
                self._draw_panel(axes, *panel)
                if index < len(panels) - 1:
                    axes.tick_params(labelbottom=False)
                else:
                    axes.set_xlabel(self._text(_TIME))
            buffer = io.BytesIO()
            metadata = {"Software": None} if format_ == "png" else {"Date": None, "Creator": None}
            sheet.savefig(buffer, format=format_, metadata=metadata)
        return buffer.getvalue() if format_ == "png" else _with_steady_names(buffer.getvalue())

    def _text(self, text: Text) -> str:
        return text.get(self._language)

    # --- the path --------------------------------------------------------------------------------

    def _draw_path(self, sheet: Any, grid: Any, spatial: Sequence[AxisMotion]) -> None:
        """Draw the first two moving linear axes as a plane, the first three in space."""
        in_space = len(spatial) > 2
        plane = sheet.add_subplot(grid[0, 0] if in_space else grid[0, :])
        first, second = spatial[:2]
        line = _points(first, second)
        plane.plot(*line, color="#1f77b4", linewidth=1.0)
        plane.plot([line[0][0]], [line[1][0]], "o", color="#2ca02c", markersize=5)
        plane.plot([line[0][-1]], [line[1][-1]], "s", color="#d62728", markersize=5)
        plane.set_aspect("equal", adjustable="datalim")
        plane.set_xlabel(f"{first.name} / mm")
        plane.set_ylabel(f"{second.name} / mm")
        plane.set_title(self._text(_PLANE), fontsize=9)
        plane.grid(linewidth=0.3)
        if not in_space:
            return
        space = sheet.add_subplot(grid[0, 1], projection="3d")
        space.plot(*_points(*spatial[:3]), color="#1f77b4", linewidth=0.8)
        labels = (space.set_xlabel, space.set_ylabel, space.set_zlabel)
        for axis, label in zip(spatial, labels, strict=False):
            label(f"{axis.name} / mm")
        space.set_title(self._text(_SPACE), fontsize=9)
        space.tick_params(labelsize=7)

    # --- over time -------------------------------------------------------------------------------

    def _panels(
        self,
    ) -> Iterator[tuple[str, list[tuple[str, str, Curve]], list[tuple[float, str]]]]:
        """Yield label, curves (name, colour, curve) and limits (value, colour) of each panel."""
        for unit in dict.fromkeys(axis.unit for axis in self._moving):
            axes = [axis for axis in self._moving if axis.unit == unit]
            curves = [(axis.name, self._colours[axis.name], axis.position) for axis in axes]
            yield f"{self._text(_POSITION)}\n{unit}", curves, []
            for order, (name, per) in _DERIVED.items():
                curves = [
                    (axis.name, self._colours[axis.name], axis.derivatives[order - 1])
                    for axis in axes
                ]
                if order == SPEED and unit == self._moving[0].unit:
                    curves.append((self._text(_PATH_SPEED), "#555555", self._motion.path_speed))
                limits = {
                    axis.limits[order - 1]: self._colours[axis.name] for axis in reversed(axes)
                }
                lines = [(limit, limits[limit]) for limit in sorted(limits) if limit > 0.0]
                yield f"{self._text(name)}\n{unit}{per}", curves, lines
        yield self._text(_OVERRIDE), [("", "#333333", self._motion.override)], []
        unit = self._moving[0].unit if self._moving else "mm"
        yield f"{self._text(_REST)}\n{unit}", [("", "#333333", self._motion.distance_to_go)], []

    def _draw_panel(
        self,
        axes: Any,
        label: str,
        curves: Sequence[tuple[str, str, Curve]],
        limits: Sequence[tuple[float, str]],
    ) -> None:
        self._draw_moments(axes)
        for value, colour in limits:
            for sign in (1.0, -1.0):
                axes.axhline(sign * value, color=colour, linewidth=0.7, linestyle=(0, (5, 4)))
        for name, colour, curve in curves:
            few = thinned(curve, _MAX_POINTS)
            style = ":" if colour == "#555555" else "-"
            axes.plot(few.time_s, few.values, style, color=colour, linewidth=0.9, label=name)
        axes.set_ylabel(label, fontsize=8)
        axes.tick_params(labelsize=7)
        axes.grid(linewidth=0.3)
        if any(name for name, _, _ in curves):
            resting = [axis.name for axis in self._motion.axes if not axis.moves]
            title = self._text(_AT_REST).format(names=", ".join(resting)) if resting else None
            axes.legend(
                loc="upper left",
                bbox_to_anchor=(1.0, 1.0),
                fontsize=7,
                title=title if label.startswith(self._text(_POSITION)) else None,
                title_fontsize=6,
                ncols=1 + len(curves) // 8,
            )

    def _draw_lanes(self, axes: Any, lanes: Sequence[Lane]) -> None:
        """Draw a row for each lane, the first one on top: marks, and bars for longer spans."""
        self._draw_moments(axes)
        for row, lane in enumerate(lanes):
            colour = _LANE_COLOURS[lane.kind]
            for begin, end in lane.spans:
                if end > begin:
                    axes.plot([begin, end], [row, row], color=colour, linewidth=4.0, alpha=0.5)
            begun = [begin for begin, _ in lane.spans]
            axes.plot(begun, [row] * len(begun), "|", color=colour, markersize=8)
        axes.set_yticks(range(len(lanes)), [lane.label for lane in lanes])
        axes.set_ylim(max(len(lanes), 2) - 0.4, -0.6)
        axes.set_ylabel(self._text(_HAPPENED), fontsize=8)
        axes.tick_params(labelsize=7, labelbottom=False)
        axes.grid(axis="x", linewidth=0.3)
        hidden = len(self._motion.lanes) - len(lanes)
        notes = [self._text(_MORE).format(count=hidden)] if hidden else []
        if not self._moving:
            notes.append(self._text(_NOTHING))
        if notes:
            axes.set_title(", ".join(notes), fontsize=8)

    def _draw_moments(self, axes: Any) -> None:
        """Draw a line through all panels at the begin of each span of a lane."""
        begun = [(span[0], lane.kind) for lane in self._motion.lanes for span in lane.spans]
        if len(begun) > _MAX_LINES:
            return
        for time_s, kind in begun:
            axes.axvline(time_s, color=_LANE_COLOURS[kind], linewidth=0.5, alpha=0.5)


def _with_steady_names(svg: bytes) -> bytes:
    """Return the SVG with numbered clip paths and markers, whose names may hold addresses."""
    names: dict[bytes, bytes] = {}
    for match in re.finditer(rb'id="([a-zA-Z][0-9a-f]{10})"', svg):
        names.setdefault(match[1], b"i%d" % len(names))
    return re.sub(
        rb'(id="|url\(#|href="#)([a-zA-Z][0-9a-f]{10})(?=["\)])',
        lambda match: match[1] + names.get(match[2], match[2]),
        svg,
    )


def _points(*axes: AxisMotion) -> list[Any]:
    """Return the positions of the axes at the same times, thinned by leaving points out."""
    step = max(1, len(axes[0].position.values) // (5 * _MAX_POINTS))
    return [axis.position.values[::step] for axis in axes]
