# SPDX-License-Identifier: MIT
"""V.G.KIN and the kinematic parameters of tools; the note on fixed types (language: 1.2)."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.base.diagnostics import Message
from nctakt.messages.checked_values import INDEX_OUT_OF_RANGE
from nctakt.messages.transformations import PARAMETER_DURING_TRANSFORMATION, UNKNOWN_KINEMATIC
from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller, NcText

DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"
KINEMATIC = "trafo[1].id 9\ntrafo[1].param[0] 1000000\ntrafo[2].id 34\ntrafo[3].id 77\n"


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``demo5`` with kinematics 9, 34 and 77 beside its own."""
    folder = tmp_path_factory.mktemp("machines") / "demo5"
    shutil.copytree(DEMO5, folder)
    file = folder / "sda_mds1.lis"
    file.write_text(KINEMATIC + file.read_text("utf-8"), "utf-8")
    tools = folder / "werkz_d1.lis"
    tools.write_text("wz[1].kinematic.param[1] 70\n" + tools.read_text("utf-8"), "utf-8")
    return folder


def run(machine: Path, text: str) -> tuple[Run, list[str]]:
    """A program's run, and what it says."""
    said: list[ProgramMessage] = []
    found = Controller(machine).run(NcText("p.nc", text + "M30\n"), on_message=said.append)
    return found, [one.text for one in said]


def test_parameters_of_kinematics_and_tools(machine: Path) -> None:
    """In the units of the lists; what was never given is 0."""
    found, said = run(
        machine,
        "T1 D1\n"
        '#MSG ["%g %g", V.G.KIN[9].PARAM[0], V.G.KIN[9].PARAM[73]]\n'
        '#MSG ["%g %g", V.G.WZ_AKT.KIN_PARAM[1], V.G.WZ_AKT.KIN_ID]\n'
        "V.G.KIN[9].PARAM[0] = 1500000\nV.G.WZ_AKT.KIN_PARAM[1] = 80\n"
        '#MSG ["%g %g", V.G.KIN[9].PARAM[0], V.G.WZ_AKT.KIN_PARAM[1]]\n'
        'D1\n#MSG ["%g %g", V.G.WZ_AKT.KIN_PARAM[1], V.G.WZ[1].KIN_PARAM[1]]\n',
    )
    assert found.errors == ()
    assert said == ["1e+06 0", "70 0", "1.5e+06 80", "70 70"]


def test_written_parameters_count_from_the_next_activation_on(machine: Path) -> None:
    """The tip stands lower by what HD1 and HD2 were made longer."""
    tip = '#MSG ["%.3f", V.A.ABS.Z]\n'
    found, said = run(
        machine,
        "#TRAFO [9]\n" + tip + "V.G.KIN[9].PARAM[0] = 1500000\n" + tip + "#TRAFO OFF\n"
        "V.G.WZ_AKT.KIN_PARAM[1] = 20000\n#TRAFO ON\n" + tip,
    )
    assert found.errors == ()
    assert said == ["-100.000", "-100.000", "-152.000"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("#TRAFO ON\nV.G.WZ_AKT.KIN_PARAM[0] = 1\n", PARAMETER_DURING_TRANSFORMATION),
        ("P1 = V.G.KIN[5].PARAM[0]\n", UNKNOWN_KINEMATIC),
        ("P1 = V.G.KIN[9].PARAM[74]\n", INDEX_OUT_OF_RANGE),
        ("V.G.WZ_AKT.KIN_PARAM[75] = 1\n", INDEX_OUT_OF_RANGE),
    ],
)
def test_what_cannot_be_read_or_written(machine: Path, text: str, message: Message) -> None:
    """Unknown kinematics and indices, and the tool's parameters while they are in use."""
    found, _ = run(machine, text)
    (error,) = found.errors
    assert error.message is message


def test_note_on_a_fixed_type_stands_once(machine: Path) -> None:
    """Whatever no source settles is told once per program; kinematic 91 settles it itself."""
    found, _ = run(machine, "#TRAFO [9]\n#TRAFO OFF\n#TRAFO ON\n#TRAFO OFF\n#TRAFO [91]\n")
    assert found.errors == ()
    notes = [one for one in found.diagnostics if "plain geometry" in one.text("en")]
    assert [one.span.line for one in notes if one.span] == [1]


def test_type_that_is_not_there_is_refused_at_selection(machine: Path) -> None:
    """The reason names the type."""
    found, _ = run(machine, "#KIN ID [77]\n#TRAFO ON\n")
    (error,) = found.errors
    assert "type 77 is not simulated" in error.text("en")
