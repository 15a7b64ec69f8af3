# SPDX-License-Identifier: MIT
"""A scene -> a picture file: PNG or SVG (matplotlib), or an interactive page (``page.py``).

In: ``Scene``, a file name. Out: the file; the same run gives the same bytes. No window is opened
and no state of matplotlib is changed.
"""

from __future__ import annotations

import contextlib
import importlib.util
import io
import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.pictures import WRONG_SUFFIX
from nctakt.messages.extras import install_command
from nctakt.messages.scheduling.schedule_results import LIBRARY_MISSING, UNKNOWN_PICTURE_FORMAT
from nctakt.plots.lanes import Lane, joined
from nctakt.plots.motion import thinned
from nctakt.plots.page import write_page
from nctakt.plots.scene import Panel, Scene
from nctakt.plots.sheet_path import draw_numbers, draw_plane, draw_space
from nctakt.plots.style import ARROW, FIRED, GRID, INK, LANE_COLOURS
from nctakt.plots.tool_path import MAX_MARKS

ENDINGS = (".png", ".svg", ".html")

_DPI = 110
_WIDTH_IN = 12.0
_PATH_HEIGHT_IN = 4.6
_PANEL_HEIGHT_IN = 1.55
_LANE_HEIGHT_IN = 0.19
#: Maximum number of points of a curve: more cannot be seen.
MAX_POINTS = 4000
#: Maximum number of lines through all panels: more would hide the curves.
_MAX_LINES = 60
#: Maximum number of lanes, and of bars in one; further lanes are counted, close bars joined.
_MAX_LANES = 48
_MAX_BARS = 600
#: Maximum number of signals that are drawn as arrows.
_MAX_ARROWS = 200
#: Maximum number of characters of a reaction's line.
_MAX_TEXT = 44
#: Smallest part of the width in which the name of a block is written, for each character.
_CHARACTER = 0.0075

_DRAWINGS = Text(".svg or .png", ".svg oder .png")
_TIME = Text("time in s", "Zeit in s")
_MORE = Text("{count} more lanes", "{count} weitere Zeilen")
_MORE_MARKS = Text(
    "{count} further firings without a mark on the path",
    "{count} weitere Auslösungen ohne Marke auf der Bahn",
)


def check_picture(path: str) -> None:
    """Raise ``Failure`` for another suffix (900635) and without matplotlib (900634)."""
    suffix = Path(path).suffix.lower()
    if suffix not in ENDINGS:
        raise Failure(diagnostic(UNKNOWN_PICTURE_FORMAT, file=path))
    if suffix != ".html" and not has_matplotlib():
        raise Failure(
            diagnostic(
                LIBRARY_MISSING,
                library="matplotlib",
                what="--plot",
                install=install_command("plot"),
            )
        )


def has_matplotlib() -> bool:
    """Return whether figures can be drawn."""
    return importlib.util.find_spec("matplotlib") is not None


def check_drawing(path: str) -> None:
    """Raise ``Failure`` for another suffix than a drawing's (901090) and without matplotlib."""
    if Path(path).suffix.lower() not in (".svg", ".png"):
        raise Failure(diagnostic(WRONG_SUFFIX, file=path, option="--plot", suffix=_DRAWINGS))
    check_picture(path)


def write_picture(scene: Scene, path: Path, language: Language) -> None:
    """Draw a run; raises ``OSError``."""
    suffix = path.suffix.lower()
    if suffix == ".html":
        write_page(scene, path, language)
    else:
        path.write_bytes(Sheet(scene, language).render(suffix[1:]))


def png_of(scene: Scene, language: Language) -> bytes:
    """Return a run as the bytes of a PNG file."""
    return Sheet(scene, language).render("png")


@contextlib.contextmanager
def new_sheet(height_in: float, kind: Any = None) -> Iterator[Any]:
    """Yield an empty figure of matplotlib, with settings that hold until it is written.

    ``kind``: its class, by default that of matplotlib.
    """
    import matplotlib  # noqa: PLC0415 - only a picture needs it
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure as PlainFigure  # noqa: PLC0415

    # names of files, axes and cells are not formulas, and may have signs that the font lacks
    settings: dict[Any, Any] = {"svg.hashsalt": "nctakt", "svg.fonttype": "path"}
    settings["text.parse_math"] = False
    with matplotlib.rc_context(), warnings.catch_warnings():
        matplotlib.rcdefaults()  # a "matplotlibrc" in the working directory may be anybody's
        matplotlib.rcParams.update(settings)
        warnings.filterwarnings("ignore", message="Glyph .* missing")
        sheet = (kind or PlainFigure)(
            figsize=(_WIDTH_IN, height_in), dpi=_DPI, layout="constrained"
        )
        FigureCanvasAgg(sheet)
        yield sheet


def picture_of(sheet: Any, format_: str) -> bytes:
    """Return the file of a figure, ``png`` or ``svg``: the same figure gives the same bytes."""
    buffer = io.BytesIO()
    metadata = {"Software": None} if format_ == "png" else {"Date": None, "Creator": None}
    sheet.savefig(buffer, format=format_, metadata=metadata)
    return buffer.getvalue() if format_ == "png" else _with_steady_names(buffer.getvalue())


class Sheet:
    """One sheet of matplotlib: path, lanes and panels below each other."""

    def __init__(self, scene: Scene, language: Language) -> None:
        self._scene = scene
        self._language = language
        self._lanes = scene.lanes[:_MAX_LANES]

    def _text(self, text: Text) -> str:
        return text.get(self._language)

    @property
    def _heights_in(self) -> list[float]:
        """The heights of path, lanes and panels, in inches."""
        heights = [_PATH_HEIGHT_IN] if self._scene.path is not None else []
        heights.append(0.2 + _LANE_HEIGHT_IN * max(len(self._lanes), 2))
        return heights + [_PANEL_HEIGHT_IN] * len(self._scene.panels)

    @property
    def height_in(self) -> float:
        """The height of the sheet in inches."""
        return sum(self._heights_in) + 1.1

    def render(self, format_: str) -> bytes:
        """Return the picture's file as bytes."""
        with new_sheet(self.height_in) as sheet:
            self.draw(sheet)
            return picture_of(sheet, format_)

    def draw(self, sheet: Any) -> None:
        """Draw on an empty figure."""
        scene, heights = self._scene, self._heights_in
        sheet.suptitle(scene.title, fontsize=12, fontweight="bold", color=INK)
        grid = sheet.add_gridspec(len(heights), 2, height_ratios=heights)
        row = 0
        if scene.path is not None:
            self._draw_path(sheet, grid)
            row = 1
        shared = sheet.add_subplot(grid[row, :])
        self._draw_lanes(shared)
        panels = [
            sheet.add_subplot(grid[index, :], sharex=shared)
            for index in range(row + 1, len(heights))
        ]
        for index, (axes, panel) in enumerate(zip(panels, scene.panels, strict=True)):
            self._draw_panel(axes, panel)
            axes.tick_params(labelbottom=axes is panels[-1])
            if index == 0 and scene.path is None:
                self._draw_numbers(axes, panel)
        sheet.align_ylabels(panels)
        shared.set_xlim(self._range())
        sheet.get_axes()[-1].set_xlabel(self._text(_TIME), fontsize=8)
        if not scene.panels:
            shared.tick_params(labelbottom=True)

    def _range(self) -> tuple[float, float]:
        margin = 0.01 * (self._scene.end_s - self._scene.begin_s) or 0.001
        return self._scene.begin_s - margin, self._scene.end_s + margin

    def _draw_path(self, sheet: Any, grid: Any) -> None:
        path = self._scene.path
        assert path is not None
        in_space = len(path.axes) > 2
        draw_plane(sheet.add_subplot(grid[0, 0] if in_space else grid[0, :]), path, self._language)
        if in_space:
            draw_space(sheet.add_subplot(grid[0, 1], projection="3d"), path, self._language)

    # --- over time -------------------------------------------------------------------------------

    def _draw_panel(self, axes: Any, panel: Panel) -> None:
        self._draw_moments(axes)
        for value, colour in panel.limits:
            for sign in (1.0, -1.0):
                axes.axhline(sign * value, color=colour, linewidth=0.7, linestyle=(0, (5, 4)))
        for line in panel.lines:
            few = thinned(line.curve, MAX_POINTS)
            axes.plot(
                few.time_s,
                few.values,
                ":" if line.is_dotted else "-",
                color=line.colour,
                linewidth=1.0,
                label=line.name,
                drawstyle="steps-post" if line.is_step else "default",
            )
        title = panel.title if len(panel.title) <= 24 else f"{panel.title[:23]}…"
        axes.set_ylabel(f"{title}\n{panel.unit}".strip(), fontsize=8, color=INK)
        style_axes(axes)
        if len(panel.lines) > 1 or panel.lines[0].name != panel.title:
            axes.legend(
                loc="upper left",
                bbox_to_anchor=(1.0, 1.02),
                fontsize=7,
                frameon=False,
                ncols=1 + len(panel.lines) // 9,
            )

    def _draw_numbers(self, axes: Any, panel: Panel) -> None:
        """Mark the firings of reactions on the first curve, where there is no path to mark."""
        curve = panel.lines[0].curve
        places: dict[float, list[int]] = {}
        for lane in self._lanes:
            for bar in lane.bars[:MAX_MARKS] if lane.number else ():
                places.setdefault(bar.begin_s, []).append(lane.number)
        for time_s, numbers in places.items():
            value = float(numpy.interp(time_s, curve.time_s, curve.values))
            draw_numbers(axes, (time_s, value), numbers)

    def _draw_lanes(self, axes: Any) -> None:
        """Draw a row for each lane, the first one on top: bars, and marks for moments."""
        self._draw_moments(axes)
        scene = self._scene
        duration_s = max(scene.end_s - scene.begin_s, 1e-9)
        shortest_s = 0.0015 * duration_s
        for row, lane in enumerate(self._lanes):
            colour = LANE_COLOURS[lane.kind]
            background, _ = joined(lane.background, _MAX_BARS, duration_s)
            spans = [(bar.begin_s, max(bar.end_s - bar.begin_s, shortest_s)) for bar in background]
            axes.broken_barh(spans, (row - 0.38, 0.76), facecolors=colour, alpha=0.22)
            bars, _ = joined(lane.bars, _MAX_BARS, duration_s)
            is_block = lane.kind in ("block", "cycle", "wait", "channel")
            height = 0.62 if is_block else 0.4
            moments = [bar.begin_s for bar in bars if bar.end_s - bar.begin_s < shortest_s]
            lasting = [bar for bar in bars if bar.end_s - bar.begin_s >= shortest_s]
            axes.broken_barh(
                [(bar.begin_s, bar.end_s - bar.begin_s) for bar in lasting],
                (row - height / 2, height),
                facecolors=colour,
                alpha=0.45 if is_block else 0.95,
                edgecolors="white",
                linewidth=0.5,
            )
            axes.plot(moments, [row] * len(moments), "|", color=colour, markersize=9, mew=1.6)
            for bar in lasting if is_block else ():
                if bar.end_s - bar.begin_s > _CHARACTER * (len(bar.name) + 1) * duration_s:
                    middle = (bar.begin_s + bar.end_s) / 2
                    axes.text(
                        middle, row, bar.name, fontsize=6, ha="center", va="center", color=INK
                    )
            self._draw_line_text(axes, row, lane)
        self._draw_arrows(axes)
        axes.set_yticks(range(len(self._lanes)), [_label(lane) for lane in self._lanes])
        axes.set_ylim(max(len(self._lanes), 2) - 0.4, -0.6)
        style_axes(axes)
        axes.grid(False, axis="y")
        axes.tick_params(labelbottom=False)
        notes = list(scene.notes)
        if len(scene.lanes) > len(self._lanes):
            count = len(scene.lanes) - len(self._lanes)
            notes.append(self._text(_MORE).format(count=count))
        if scene.path is not None and scene.path.left_out:
            notes.append(self._text(_MORE_MARKS).format(count=scene.path.left_out))
        if notes:
            axes.set_title(" · ".join(notes), fontsize=7, loc="right", color="#6b7280")

    def _draw_arrows(self, axes: Any) -> None:
        """Draw the signals from channel to channel, each from its sending to its being taken."""
        for arrow in self._scene.arrows[:_MAX_ARROWS]:
            axes.annotate(
                "",
                (arrow.end_s, arrow.receiver),
                (arrow.begin_s, arrow.sender),
                arrowprops={"arrowstyle": "-|>", "color": ARROW, "linewidth": 0.9},
            )
            middle = (arrow.begin_s + arrow.end_s) / 2, (arrow.sender + arrow.receiver) / 2
            axes.annotate(
                arrow.name, middle, (3, 0), textcoords="offset points", fontsize=6, color=ARROW
            )

    def _draw_line_text(self, axes: Any, row: int, lane: Lane) -> None:
        """Write the line of a reaction after its lane."""
        if lane.text:
            text = lane.text if len(lane.text) <= _MAX_TEXT else f"{lane.text[: _MAX_TEXT - 1]}…"
            axes.annotate(
                text,
                (1.005, row),
                xycoords=("axes fraction", "data"),
                fontsize=6,
                va="center",
                color="#4b5563",
                family="monospace",
                annotation_clip=False,
            )

    def _draw_moments(self, axes: Any) -> None:
        """Draw a line through all panels at the begin of each reaction and report."""
        begun = [
            (bar.begin_s, lane.kind)
            for lane in self._scene.lanes
            if lane.kind in FIRED
            for bar in lane.bars
        ]
        if len(begun) > _MAX_LINES:
            return
        for time_s, kind in begun:
            axes.axvline(time_s, color=LANE_COLOURS[kind], linewidth=0.6, alpha=0.45)


def _label(lane: Lane) -> str:
    label = lane.label if len(lane.label) <= 22 else f"{lane.label[:21]}…"
    return f"({lane.number})  {label}" if lane.number else label


def style_axes(axes: Any) -> None:
    axes.tick_params(labelsize=7, color=GRID, labelcolor=INK)
    axes.yaxis.get_offset_text().set_fontsize(7)
    axes.grid(linewidth=0.4, color=GRID)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color("#9ca3af")


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
