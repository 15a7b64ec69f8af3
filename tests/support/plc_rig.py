# SPDX-License-Identifier: MIT
"""Structured Text in the ticks of the demo machine, for tests."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.plc.structured_text import StructuredPlc, load_structured
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

#: A task of 1 ms, the tick of the demo machine, that calls MAIN.
EACH_TICK = """
CONFIGURATION Cell
RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#1MS, PRIORITY := 1);
PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE
END_CONFIGURATION
"""

Stimulus = tuple[str, str, float]


def loaded(folder: Path, text: str, task: str = EACH_TICK) -> StructuredPlc:
    """The PLC of a text."""
    path = folder / "cell.st"
    path.write_text(text + task, "utf-8")
    return load_structured(path)


def run(
    plc: StructuredPlc, ticks: int, signals: Sequence[str] = (), at: Sequence[Stimulus] = ()
) -> Run:
    """The run of a program that does nothing for so many ticks, with this PLC."""
    waits = NcText("wait.nc", "G04 10\nM30")
    return Controller().run(waits, plc=plc, ticks=ticks, signals=list(signals), at=at)


def values_in_main(plc: StructuredPlc, *names: str) -> list[object]:
    """The values of variables of MAIN."""
    return [plc.read(f"MAIN.{name}") for name in names]
