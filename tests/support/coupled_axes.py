# SPDX-License-Identifier: MIT
"""Programs with coupled axes, and where their axes are."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

FOLDER = Path(__file__).parent.parent / "channels" / "coupled_machine"


MACHINE = load_machine(FOLDER)


POSITIONS = [f"{axis}.ACS.ACT_POS" for axis in ("X", "Y", "Z", "U", "V", "A", "B")]


def run(
    *lines: str,
    controller: Controller | None = None,
    signals: Sequence[str] = POSITIONS,
    at: Sequence[Stimulus] = (),
) -> Run:
    """A run of these lines."""
    text = "\n".join(["%part", *lines, "M30", ""])
    controller = controller or Controller(MACHINE)
    return controller.run(NcText("part.nc", text), signals=signals, ticks=20_000, at=at)


def numbers(found: Run) -> list[int]:
    """The numbers of errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def path_of(found: Run, axis: str) -> np.ndarray:
    """The command positions of an axis, tick by tick."""
    assert found.trace is not None
    return np.asarray(found.trace[f"{axis}.ACS.ACT_POS"].tolist())
