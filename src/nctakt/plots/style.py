# SPDX-License-Identifier: MIT
"""Colours that all pictures of runs share; the live page has the same (docs/live.md)."""

from __future__ import annotations

INK, GRID = "#1f2937", "#e5e7eb"

#: Kinds of lanes whose begins go through all panels as lines.
FIRED = ("reaction", "function", "error", "starved", "overflow")

#: The colour of each kind of lane.
LANE_COLOURS = {
    "channel": "#b45309",
    "block": "#94a3b8",
    "wait": "#f59e0b",
    "cycle": "#0d9488",
    "condition": "#22a06b",
    "reaction": "#e8833a",
    "function": "#8b7cf6",
    "axis": "#8c564b",
    "spindle": "#8c564b",
    "message": "#0ea5b7",
    "error": "#d64545",
    "starved": "#ea580c",
    "overflow": "#b91c1c",
    "paused": "#f59e0b",
    "end": "#6b7280",
    "signal": "#15803d",
}

#: Signals on their way from channel to channel.
ARROW = "#15803d"

FEED, RAPID = "#3b82f6", "#9aa1ab"
START, END = "#15803d", "#b91c1c"
