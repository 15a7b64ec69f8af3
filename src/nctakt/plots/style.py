# SPDX-License-Identifier: MIT
"""Colours that all pictures of runs share."""

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
    "condition": "#d62728",
    "reaction": "#d62728",
    "function": "#7c3aed",
    "axis": "#8c564b",
    "spindle": "#8c564b",
    "message": "#2563eb",
    "error": "#b91c1c",
    "starved": "#ea580c",
    "overflow": "#b91c1c",
    "paused": "#f59e0b",
    "end": "#6b7280",
    "signal": "#15803d",
}

#: Signals on their way from channel to channel.
ARROW = "#15803d"

FEED, RAPID = "#1f77b4", "#f28e2b"
START, END = "#15803d", "#b91c1c"
