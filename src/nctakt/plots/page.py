# SPDX-License-Identifier: MIT
"""A scene -> one page with an interactive picture, which needs no network.

In: ``Scene``. Out: a file with the data of the run, the viewer (``viewer_*.js``) and its look
(``viewer.css``). Curves are on a grid of ticks; for long ones the lowest and highest value of each
piece. The same run gives the same bytes.
"""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy

from nctakt.base.diagnostics import Language, Text
from nctakt.plots.lanes import Bar, Lane, joined
from nctakt.plots.scene import Line, Panel, Scene
from nctakt.plots.style import LANE_COLOURS
from nctakt.plots.tool_path import ToolPath

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Values = NDArray[numpy.float64]

#: Maximum number of points of a curve; a run of 50 s with ticks of 1 ms is whole.
MAX_POINTS = 50_000
#: Maximum number of bars of a lane; closer ones are joined.
MAX_BARS = 10_000
#: Maximum number of signals that are drawn as arrows.
MAX_ARROWS = 5_000
#: Maximum number of lanes.
MAX_LANES = 200

#: The texts of the viewer.
WORDS = {
    "time": Text("time in s", "Zeit in s"),
    "whole": Text("whole run", "ganzer Lauf"),
    "theme": Text("light or dark", "hell oder dunkel"),
    "plane": Text("plane", "Ebene"),
    "space": Text("space", "Raum"),
    "start": Text("start", "Start"),
    "end": Text("end", "Ende"),
    "feed": Text("feed", "Vorschub"),
    "rapid": Text("rapid", "Eilgang"),
    "condition": Text("condition true", "Bedingung wahr"),
    "from": Text("from", "ab"),
    "for": Text("for", "für"),
    "at": Text("at", "bei"),
    "help": Text(
        "Wheel or drag: zoom. Shift and drag: move. Double click: whole run. Click: hold the "
        "cursor. Arrow keys: one tick.",
        "Mausrad oder Ziehen: vergrößern. Umschalt und Ziehen: verschieben. Doppelklick: ganzer "
        "Lauf. Klick: Zeitmarke halten. Pfeiltasten: ein Takt.",
    ),
    "script": Text(
        "This page draws the run with JavaScript.", "Diese Seite zeichnet den Lauf mit JavaScript."
    ),
}
_THINNED = Text(
    "curves: lowest and highest value of each {ticks} ticks",
    "Kurven: kleinster und größter Wert je {ticks} Takte",
)
_JOINED = Text("bars close together are joined", "dicht stehende Balken sind vereint")
_MORE = Text("{count} more lanes", "{count} weitere Zeilen")
_MORE_MARKS = Text(
    "{count} further firings without a mark on the path",
    "{count} weitere Auslösungen ohne Marke auf der Bahn",
)

#: The files of the viewer, in their order.
_SCRIPTS = ("parts", "time", "path", "pointer")

_PAGE = """\
<!doctype html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" \
content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>{title}</title>
<style>
{style}</style>
</head>
<body>
<header><h1>{title}</h1><p id="notes">{notes}</p><nav id="tools"></nav></header>
<noscript>{script_needed}</noscript>
<main id="view"></main>
<script type="application/json" id="run">{data}</script>
<script>
"use strict";
(() => {{
{script}}})();
</script>
</body>
</html>
"""


def write_page(scene: Scene, path: Path, language: Language) -> None:
    """Write the page; raises ``OSError``."""
    packer = _Packer(scene, language)
    data = json.dumps(packer.scene(), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    folder = Path(__file__).parent
    page = _PAGE.format(
        language=language,
        title=escape(scene.title),
        notes=escape(" · ".join(packer.notes)),
        script_needed=escape(WORDS["script"].get(language)),
        style=(folder / "viewer.css").read_text("utf-8"),
        script=_script(folder),
        data=data.replace("<", "\\u003c"),  # no text of a user ends the script
    )
    path.write_bytes(page.encode("utf-8", errors="backslashreplace"))


def _script(folder: Path) -> str:
    """Return the viewer: the helpers of all drawings, without the marks of a module, its parts."""
    helpers = (folder / "drawing" / "index.js").read_text("utf-8").replace("\nexport ", "\n")
    return helpers + "".join((folder / f"viewer_{part}.js").read_text("utf-8") for part in _SCRIPTS)


class _Packer:
    """Packs a scene into the viewer's format; ``notes``: omitted parts."""

    def __init__(self, scene: Scene, language: Language) -> None:
        self._scene = scene
        self._language = language
        self._texts: dict[str, int] = {}
        self.notes = list(scene.notes)

    def _note(self, text: Text, **values: int) -> None:
        note = text.get(self._language).format(**values)
        if note not in self.notes:
            self.notes.append(note)

    def scene(self) -> dict[str, Any]:
        """Return the object of the page."""
        scene = self._scene
        lanes = [self._lane(lane) for lane in scene.lanes[:MAX_LANES]]
        if len(scene.lanes) > MAX_LANES:
            self._note(_MORE, count=len(scene.lanes) - MAX_LANES)
        return {
            "begin": scene.begin_s,
            "end": scene.end_s,
            "tick": scene.tick_s,
            "words": {key: text.get(self._language) for key, text in WORDS.items()},
            "path": None if scene.path is None else self._path(scene.path),
            "lanes": lanes,
            "arrows": [
                [arrow.begin_s, arrow.end_s, arrow.sender, arrow.receiver, self._text(arrow.name)]
                for arrow in scene.arrows[:MAX_ARROWS]
                if max(arrow.sender, arrow.receiver) < MAX_LANES
            ],
            "panels": [self._panel(panel) for panel in scene.panels],
            "texts": list(self._texts),
        }

    def _text(self, text: str) -> int:
        return self._texts.setdefault(text, len(self._texts))

    def _lane(self, lane: Lane) -> dict[str, Any]:
        return {
            "kind": lane.kind,
            "colour": LANE_COLOURS[lane.kind],
            "label": lane.label,
            "number": lane.number,
            "text": lane.text,
            "bars": self._bars(lane.bars),
            "background": self._bars(lane.background),
        }

    def _bars(self, bars: Sequence[Bar]) -> list[list[float]]:
        duration_s = self._scene.end_s - self._scene.begin_s
        few, are_joined = joined(bars, MAX_BARS, duration_s)
        if are_joined:
            self._note(_JOINED)
        return [[bar.begin_s, bar.end_s, self._text(bar.name), self._text(bar.tip)] for bar in few]

    def _panel(self, panel: Panel) -> dict[str, Any]:
        return {
            "title": panel.title,
            "unit": panel.unit,
            "limits": [[value, colour] for value, colour in panel.limits],
            "lines": [self._line(line) for line in panel.lines],
        }

    def _line(self, line: Line) -> dict[str, Any]:
        time_s, values = line.curve.time_s, line.curve.values
        step_s = self._scene.tick_s
        if len(values) > MAX_POINTS:
            ticks = -(-2 * len(values) // MAX_POINTS)
            self._note(_THINNED, ticks=ticks)
            values = _extremes(values, ticks)
            step_s *= ticks / 2
        return {
            "name": line.name,
            "colour": line.colour,
            "step": line.is_step,
            "dotted": line.is_dotted,
            "begin": float(time_s[0]) if len(time_s) else 0.0,
            "every": step_s,
            "values": _packed(values),
        }

    def _path(self, path: ToolPath) -> dict[str, Any]:
        if path.left_out:
            self._note(_MORE_MARKS, count=path.left_out)
        stride = -(-len(path.positions) // MAX_POINTS)
        return {
            "axes": path.axes,
            "points": _packed(path.points.ravel()),
            "rapid": b64encode(path.is_rapid.astype(numpy.uint8).tobytes()).decode("ascii"),
            "begin": path.begin_s,
            "every": self._scene.tick_s * stride,
            "positions": _packed(path.positions[::stride].ravel()),
            "marks": [[mark.number, mark.time_s, *mark.point] for mark in path.marks],
        }


def _packed(values: Values) -> str:
    """Return numbers as base64 of little-endian float32; non-finite values are 0."""
    finite = numpy.nan_to_num(values, nan=0.0, posinf=0.0, neginf=0.0)
    return b64encode(finite.astype("<f4").tobytes()).decode("ascii")


def _extremes(values: Values, ticks: int) -> Values:
    """Return the lowest and highest value of each piece of this many ticks, in their order."""
    padded = numpy.pad(values, (0, -len(values) % ticks), mode="edge").reshape(-1, ticks)
    low, high = padded.argmin(axis=1), padded.argmax(axis=1)
    places = numpy.column_stack((numpy.minimum(low, high), numpy.maximum(low, high)))
    return numpy.take_along_axis(padded, places, axis=1).ravel()
