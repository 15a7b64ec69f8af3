# SPDX-License-Identifier: MIT
"""Evidence about a stop in the record of a session, so that fewer ticks need a rerun.

In: a stop, the recorded signals. Out: a condition that one of these signals must meet in each tick
in which the stop holds.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Literal, cast

from nctakt.base.failure import Failure
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.session.history.columns import Necessary
from nctakt.session.stops import StopAt

_NAME = r"\s*(?P<name>V\.[\w.\[\]]+?)\s*"
_VARIABLE = re.compile(_NAME)
_COMPARISON = re.compile(_NAME + r"(?P<operator><=|>=|==|!=|<|>)\s*(?P<number>-?\d+(?:\.\d+)?)\s*")

_Operator = Literal["<", "<=", ">", ">=", "==", "!="]


def necessary(
    stop: StopAt, machine: AssembledMachine, columns: Mapping[int, int]
) -> Necessary | None:
    """Return a signal's necessary condition for a stop; ``None`` if none is known.

    ``columns``: cell of a recorded signal -> its column.
    """
    pattern = {"condition": _COMPARISON, "changes": _VARIABLE}.get(stop.kind)
    match = None if pattern is None else pattern.fullmatch(stop.text)
    if match is None:
        return None
    prefix = f"CH{stop.channel}." if stop.channel > 1 else ""
    try:
        cell, is_text = machine.access.cell_of(f"{prefix}{match['name']}")
    except Failure:
        return None
    if is_text or cell not in columns:
        return None
    if stop.kind == "changes":
        return Necessary(columns[cell], "changes")
    return Necessary(columns[cell], cast("_Operator", match["operator"]), float(match["number"]))
