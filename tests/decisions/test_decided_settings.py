# SPDX-License-Identifier: MIT
"""Decided: settings of start sequences that change nothing here, and parts left out backward."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

ACCEPTED, REFUSED, NO_FORM, NOT_SIMULATED, MISSPELT = 900201, 900200, 900233, 900706, 21220
SIMPLIFIED = 901551


def numbers(text: str, machine: Path | None = None) -> list[int]:
    """The numbers of the messages about a program."""
    controller = Controller(machine) if machine else Controller()
    return [
        found.id for found in controller.run(NcText("p.nc", f"{text}\nM30"), signals=[]).diagnostics
    ]


@pytest.mark.parametrize(
    ("command", "reported"),
    [
        ("#LAH [SMOOTH_PATH_VEL=0]", [ACCEPTED]),
        ("#LAH [SMOOTH_PATH_VEL=0 PROD_FACT=90]", [ACCEPTED]),
        ("#LAH [SMOOTH_PATH_VEL=1 PROD_FACT=90]", [REFUSED]),
        ("#LAH [SMOOTH_PATH_VEL=P1 PROD_FACT=90]", [REFUSED]),
        ("#LAH [SMOOTH_PATH_VEL=1]", [NO_FORM]),
        ("#LAH [PROD_FACT=90]", [NO_FORM]),
        ("#LAH", [NO_FORM]),
        ("#FILTER ON [ORDER=10 ORDER_TIME=100 SHARE=50 AX_DEV=0.1]", [ACCEPTED]),
        ("#FILTER [FCUT=30 ACC_FACT=2 QUALITY=0.5]\n#FILTER ON\n#FILTER OFF", [ACCEPTED] * 3),
        ("#FILTER ON [ORDERS=1]", [ACCEPTED, MISSPELT]),
        ("#FILTER", [NO_FORM]),
        ("#TRANSVELMIN ON\n#TRANSVELMIN ON [0]", [ACCEPTED]),
        ("#TRANSVELMIN OFF", [ACCEPTED]),
        ("#TRANSVELMIN ON [500]", [REFUSED]),
        ("#TRC [G236_LIN=1 KERF_MASKING=0 PERPENDICULAR_RADIUS_CHANGE=0]", [ACCEPTED]),
        ("#TRC [TANGENTIAL_LIMIT=1.5]\n#TRC [SPLIT_OFF]", [ACCEPTED]),
        ("#TRC [TANGENTIAL_LIMIT=4]", [REFUSED]),
        ("#TRC [KERF_MASKING=1]", [REFUSED]),
        ("#TRC [SPLIT]", [REFUSED]),
        ("#TRC", [NO_FORM]),
        ("#OPTIONAL EXECUTION ON\n#OPTIONAL EXECUTION OFF", [SIMPLIFIED]),
        ("#OPTIONAL EXECUTION ON [SIMULATE MASK=3]\n#OPTIONAL EXECUTION OFF", [SIMPLIFIED]),
        ("#OPTIONAL EXECUTION CLEAR", []),
        ("#OPTIONAL EXECUTION ON OFF", [22143]),
        ("#OPTIONAL EXECUTION ON [SIMULATE APPROACH]", [SIMPLIFIED, 22132]),
        ("#OPTIONAL EXECUTION ON [APPROACH]", [SIMPLIFIED, NOT_SIMULATED]),
        ("#OPTIONAL EXECUTION", [NO_FORM]),
    ],
)
def test_what_changes_nothing_is_accepted(command: str, reported: list[int]) -> None:
    """929628939, 552704267, 207486091, 987835915, 207592587: all else is refused by name."""
    assert numbers(command) == reported


def test_filters_with_a_type_are_refused(tmp_path: Path) -> None:
    """P-AXIS-00586: without a type a filter does not act; with one it moves axes."""
    machine = tmp_path / "machine"
    shutil.copytree(Path(nctakt.__file__).parent / "machines" / "demo", machine)
    for file in machine.rglob("*.lis"):
        if file.name == "achs_mds1.lis":
            text = file.read_text("utf-8")
            file.write_text(f"vib_guard.type 1\n{text}", "utf-8")
    assert numbers("#FILTER OFF", machine) == [ACCEPTED]
    assert numbers("#FILTER ON", machine) == [ACCEPTED, 901875]


@pytest.mark.parametrize(("part", "end"), [("", 20.0), (" [SIMULATE]", 0.0)])
def test_backward_motion_ends_after_an_optional_part(part: str, end: float) -> None:
    """207592587: it is left out on the way back; here there is no way back over it."""

    class Operator:
        def cycle(self, hli: PlcView) -> None:
            hli.backward_motion = hli.tick > 700

    text = f"N10 G01 X20 F6000\n#OPTIONAL EXECUTION ON{part}\nN20 Y9\nN30 Y0\n"
    text += "#OPTIONAL EXECUTION OFF\nN40 X60\nM30"
    signals = ["X.ACS.ACT_POS"]
    run = Controller().run(NcText("p.nc", text), signals=signals, ticks=3000, plc=Operator())
    assert run.trace is not None
    assert run.trace["X.ACS.ACT_POS"][-1] == end
