# SPDX-License-Identifier: MIT
"""The scope and the path as options of ECharts: curves, marks, the place in time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from nctakt.live.view import MAX_MARKS, Curves, TimeMark

#: Colours of curves: distinct on light and dark pages, and for the colour-blind.
COLOURS = ("#3b82f6", "#e8833a", "#22a06b", "#c2549d", "#b08900", "#7c6ff0", "#0ea5b7", "#d64545")

_GREY = "#8a8f98"
_MARK_COLOURS = {"fired": "#e8833a", "M": "#7c6ff0", "H": "#7c6ff0"}

#: Lanes of the scope at most; further units share the last one.
_MAX_LANES = 4


def lanes_of(names: Sequence[str], units: Mapping[str, str]) -> list[tuple[str, list[str]]]:
    """Return the lanes of the scope: a unit and its signals, in the order of the names."""
    lanes: list[tuple[str, list[str]]] = []
    for name in names:
        unit = units.get(name, "")
        own = next((lane for lane in lanes if lane[0] == unit), None)
        if own is None and len(lanes) >= _MAX_LANES:
            own = lanes[-1]
        if own is None:
            lanes.append((unit, [name]))
        else:
            own[1].append(name)
    return lanes


def scope_options(
    curves: Curves,
    units: Mapping[str, str],
    marks: Sequence[TimeMark],
    tick: int,
    cycle_time_us: int,
) -> dict[str, Any]:
    """Return the chart of signals over time in s: a lane for each unit, marks, a cursor."""
    lanes = lanes_of(curves.names, units)
    count = max(1, len(lanes))
    top, bottom = 15.0, 6.0
    height = (100.0 - top - bottom) / count
    axis: dict[str, Any] = {
        "axisLine": {"lineStyle": {"color": _GREY}},
        "axisLabel": {"color": _GREY, "fontSize": 10},
        "splitLine": {"lineStyle": {"color": _GREY, "opacity": 0.2}},
    }
    times = [round(at * cycle_time_us / 1e6, 9) for at in curves.ticks]
    series: list[dict[str, Any]] = []
    for index, (_, names) in enumerate(lanes):
        for name in names:
            column = curves.columns[curves.names.index(name)]
            one: dict[str, Any] = {
                "name": name,
                "type": "line",
                "step": "end" if units.get(name, "") == "" else False,
                "xAxisIndex": index,
                "yAxisIndex": index,
                "showSymbol": False,
                "animation": False,
                "lineStyle": {"width": 1.6},
                "data": [list(pair) for pair in zip(times, column, strict=True)],
            }
            if name == names[0]:
                one["markLine"] = _mark_line(marks, tick, cycle_time_us, with_labels=index == 0)
            series.append(one)
    return {
        "animation": False,
        "color": list(COLOURS),
        "textStyle": {"color": _GREY},
        "legend": {
            "type": "scroll",
            "top": 0,
            "itemHeight": 8,
            "itemWidth": 14,
            "textStyle": {"color": _GREY, "fontSize": 11},
            "pageTextStyle": {"color": _GREY},
            "pageIconColor": _GREY,
        },
        "tooltip": {"trigger": "axis", "confine": True, "textStyle": {"fontSize": 11}},
        "axisPointer": {"link": [{"xAxisIndex": "all"}]},
        "dataZoom": [{"type": "inside", "xAxisIndex": list(range(count))}],
        "grid": [
            {
                "left": 52,
                "right": 14,
                "top": f"{top + lane * height + 1:.2f}%",
                "height": f"{height - 3:.2f}%",
            }
            for lane in range(count)
        ],
        "xAxis": [
            {
                **axis,
                "type": "value",
                "gridIndex": lane,
                "min": "dataMin",
                "max": "dataMax",
                "axisLabel": {
                    **axis["axisLabel"],
                    "show": lane == count - 1,
                    "hideOverlap": True,
                    "showMaxLabel": False,
                },
            }
            for lane in range(count)
        ],
        "yAxis": [
            {
                **axis,
                "type": "value",
                "gridIndex": lane,
                "scale": True,
                "splitNumber": 2,
                "name": lanes[lane][0] if lanes else "",
                "nameLocation": "middle",
                "nameGap": 38,
                "nameTextStyle": {"color": _GREY, "fontSize": 10},
            }
            for lane in range(count)
        ],
        "series": series,
    }


def _mark_line(
    marks: Sequence[TimeMark], tick: int, cycle_time_us: int, *, with_labels: bool
) -> dict[str, Any]:
    """Return the vertical lines of a lane: reactions, functions, and where the session stands."""
    lines: list[dict[str, Any]] = [
        {
            "xAxis": mark.tick * cycle_time_us / 1e6,
            "lineStyle": {
                "color": _MARK_COLOURS[mark.kind],
                "type": "dashed" if mark.kind == "fired" else "dotted",
            },
            "label": {
                "show": with_labels,
                "formatter": mark.label,
                "color": _MARK_COLOURS[mark.kind],
                "fontSize": 9,
            },
        }
        for mark in marks[-MAX_MARKS:]
    ]
    lines.append(
        {
            "xAxis": tick * cycle_time_us / 1e6,
            "lineStyle": {"color": "#d64545", "type": "solid", "width": 1.5},
            "label": {"show": False},
        }
    )
    return {"symbol": "none", "silent": True, "animation": False, "data": lines}


def path_options(
    curves: Curves,
    plane: tuple[str, str],
    marks: Sequence[TimeMark],
    tool: tuple[float, float],
    words: tuple[str, str],
) -> dict[str, Any]:
    """Return the chart of the path: rapid dashed, feed solid, reactions, the tool.

    ``plane``: the signals of its two axes. ``words``: the names of feed and rapid.
    """
    across, up = (curves.columns[curves.names.index(name)] for name in plane)
    rapid: Sequence[float] = [0.0] * len(curves.ticks)
    if "PATH.RAPID" in curves.names:
        rapid = curves.columns[curves.names.index("PATH.RAPID")]
    feed_points: list[list[float | None]] = []
    rapid_points: list[list[float | None]] = []
    for index, (x, y) in enumerate(zip(across, up, strict=True)):
        is_rapid = rapid[index] > 0
        drawn, other = (rapid_points, feed_points) if is_rapid else (feed_points, rapid_points)
        if index and (rapid[index - 1] > 0) != is_rapid:
            drawn.append([across[index - 1], up[index - 1]])
            other.append([None, None])
        drawn.append([x, y])
    reactions = [_point_at(curves, mark.tick, across, up) for mark in marks if mark.kind == "fired"]
    limits = _limits([*across, tool[0]], [*up, tool[1]])
    axis = {
        "type": "value",
        "axisLine": {"lineStyle": {"color": _GREY}},
        "axisLabel": {
            "color": _GREY,
            "fontSize": 10,
            "hideOverlap": True,
            "showMinLabel": False,
            "showMaxLabel": False,
        },
        "splitLine": {"lineStyle": {"color": _GREY, "opacity": 0.2}},
        "nameTextStyle": {"color": _GREY},
    }
    line = {"type": "line", "showSymbol": False, "animation": False}
    return {
        "animation": False,
        "textStyle": {"color": _GREY},
        "grid": {"left": 48, "right": 20, "top": 22, "bottom": 24},
        "tooltip": {"trigger": "none"},
        "dataZoom": [
            {"type": "inside", "xAxisIndex": 0},
            {"type": "inside", "yAxisIndex": 0},
        ],
        "xAxis": {**axis, "min": limits[0], "max": limits[1], "name": plane[0].split(".")[0]},
        "yAxis": {**axis, "min": limits[2], "max": limits[3], "name": plane[1].split(".")[0]},
        "series": [
            {**line, "name": words[0], "data": feed_points, "color": COLOURS[0]},
            {
                **line,
                "name": words[1],
                "data": rapid_points,
                "color": _GREY,
                "lineStyle": {"type": "dashed", "width": 1.4},
            },
            {
                "type": "scatter",
                "name": "fired",
                "symbol": "diamond",
                "symbolSize": 9,
                "color": _MARK_COLOURS["fired"],
                "data": reactions[-MAX_MARKS:],
            },
            {
                "type": "scatter",
                "name": "tool",
                "symbolSize": 12,
                "color": "#d64545",
                "data": [list(tool)],
            },
        ],
    }


def _point_at(
    curves: Curves, tick: int, across: Sequence[float], up: Sequence[float]
) -> list[float]:
    """Return where the tool is at the last known tick up to this one."""
    index = sum(1 for at in curves.ticks if at <= tick) - 1
    return [across[max(0, index)], up[max(0, index)]] if curves.ticks else [0.0, 0.0]


#: How much wider than high the path's picture is.
_ASPECT = 1.9


def _limits(across: Sequence[float], up: Sequence[float]) -> tuple[float, float, float, float]:
    """Return the limits of both axes, so that a millimetre is as long on either."""
    middle = (min(across) + max(across)) / 2, (min(up) + max(up)) / 2
    width, height = max(across) - min(across), max(up) - min(up)
    half = max(width / _ASPECT, height, 1.0) * 0.55
    return (
        round(middle[0] - half * _ASPECT, 3),
        round(middle[0] + half * _ASPECT, 3),
        round(middle[1] - half, 3),
        round(middle[1] + half, 3),
    )
