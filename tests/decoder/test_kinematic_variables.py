# SPDX-License-Identifier: MIT
"""V.G.KIN and the kinematic parameters of tools; the note on fixed types (language: 1.2)."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.base.diagnostics import Message
from nctakt.messages.path.transformations import (
    KINEMATIC_NOT_POSSIBLE,
    NOT_OF_KINEMATIC,
    PARAMETER_DURING_TRANSFORMATION,
    PARAMETER_NOT_PUBLIC,
    UNKNOWN_KINEMATIC,
)
from nctakt.messages.programs.checked_blocks import NOT_SIMULATED
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE
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
    """The tip is lower by what HD1 and HD2 were made longer."""
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
        ("P1 = V.G.KIN[91].AXIS[6].TYPE\n", INDEX_OUT_OF_RANGE),
        ("P1 = V.G.KIN[91].BASE[6]\n", INDEX_OUT_OF_RANGE),
        ("P1 = V.G.KIN[9].RTCP\n", NOT_OF_KINEMATIC),
        ("V.G.KIN[91].PARAM[49] = 1\n", PARAMETER_NOT_PUBLIC),
        ("P1 = V.G.KIN[91].LOCK_DOF[0]\n", NOT_SIMULATED),
        ("P1 = V.G.KIN[91].GROUP[0].CHAIN[1]\n", NOT_SIMULATED),
        ("P1 = V.G.KIN[91].RTCP[0]\n", NOT_SIMULATED),
    ],
)
def test_what_cannot_be_read_or_written(machine: Path, text: str, message: Message) -> None:
    """Unknown kinematics and indices, and the tool's parameters while they are in use."""
    found, _ = run(machine, text)
    (error,) = found.errors
    assert error.message is message


def test_note_on_a_fixed_type_comes_once(machine: Path) -> None:
    """Whatever no source settles is reported once per program; kinematic 91 settles it itself."""
    found, _ = run(machine, "#TRAFO [9]\n#TRAFO OFF\n#TRAFO ON\n#TRAFO OFF\n#TRAFO [91]\n")
    assert found.errors == ()
    notes = [one for one in found.diagnostics if "plain geometry" in one.text("en")]
    assert [one.span.line for one in notes if one.span] == [1]


def test_type_that_is_not_there_is_refused_at_selection(machine: Path) -> None:
    """The reason names the type."""
    found, _ = run(machine, "#KIN ID [77]\n#TRAFO ON\n")
    (error,) = found.errors
    assert "type 77 is not simulated" in error.text("en")


def test_numbers_of_the_universal_kinematic_by_name_and_by_index(machine: Path) -> None:
    """UK 882078603: both are one memory; CK 654323083: BASE, which nothing uses here."""
    found, said = run(
        machine,
        '#MSG ["%g %g", V.G.KIN[91].RTCP, V.G.KIN[91].PROGRAMMING_MODE]\n'
        '#MSG ["%g %g", V.G.KIN[91].CHAIN[4], V.G.KIN[91].NUMBER_OF_AXES]\n'
        '#MSG ["%g %g", V.G.KIN[91].PARAM[6], V.G.KIN[91].PARAM[34]]\n'
        '#MSG ["%g %g", V.G.KIN[91].AXIS[3].POINT[2], V.G.KIN[91].AXIS[4].ORIENTATION[0]]\n'
        "V.G.KIN[91].PARAM[34] = 1600000\nV.G.KIN[9].BASE[5] = 7\n"
        '#MSG ["%g %g", V.G.KIN[91].AXIS[3].POINT[2], V.G.KIN[9].BASE[5]]\n',
    )
    assert found.errors == ()
    assert said == ["1 17", "4 5", "5 1.5e+06", "1.5e+06 1", "1.6e+06 7"]


def test_a_written_universal_kinematic_counts_from_the_next_activation_on(machine: Path) -> None:
    """The holder is 10 mm, then 20 mm lower; then the axis A turns against the angle A."""
    tip = '#MSG ["%.3f", V.A.ABS.Z]\n'
    found, said = run(
        machine,
        "V.G.KIN[91].ZERO_POSITION[2] = -100000\n#TRAFO ON\n" + tip
        + "V.G.KIN[91].PARAM[5] = -200000\n" + tip + "#TRAFO OFF\n#TRAFO ON\n" + tip
        + "#TRAFO OFF\nV.G.KIN[91].RTCP = 0\nV.G.KIN[91].AXIS[4].ORIENTATION[0] = -1\n"
        "G00 C30 A10\n#TRAFO ON\nG01 C30 A-20 F5000\n#TRAFO OFF\n"
        '#MSG ["%.3f %.3f", V.A.ABS.C, V.A.ABS.A]\n',
    )  # fmt: skip
    assert found.errors == ()
    assert said == ["-10.000", "-10.000", "-20.000", "30.000 20.000"]


def test_angles_are_handed_on(machine: Path) -> None:
    """P-CHAN-00112: -1 hands the angles on to the kinematic: the axes turn by them, as by 12."""
    said = [
        run(
            machine,
            f"V.G.KIN[91].PROGRAMMING_MODE = {mode}\nV.G.KIN[91].RTCP = 0\n#TRAFO ON\n"
            "G01 X10 C30 A10 F5000\n#TRAFO OFF\n"
            '#MSG ["%.3f %.3f %.3f", V.A.ABS.X, V.A.ABS.C, V.A.ABS.A]\n',
        )
        for mode in (-1, 12)
    ]
    assert [found.errors for found, _ in said] == [(), ()]
    assert said[0][1] == said[1][1]
    assert said[0][1][0].endswith("30.000 10.000")


def test_a_tool_adds_to_the_numbers_of_the_universal_kinematic(machine: Path) -> None:
    """P-TOOL-00009: parameter 5 is the height of the holder, in 0.1 µm."""
    found, said = run(
        machine,
        'V.G.WZ_AKT.KIN_PARAM[5] = -30000\n#TRAFO ON\n#MSG ["%.3f", V.A.ABS.Z]\n',
    )
    assert found.errors == ()
    assert said == ["-3.000"]


@pytest.mark.parametrize(
    "text",
    [
        "V.G.KIN[91].CHAIN[0] = 7\n",
        "V.G.KIN[91].NUMBER_OF_AXES = 4.5\n",
        "V.G.KIN[91].PROGRAMMING_MODE = 99\n",
        "V.G.KIN[91].ZERO_ORIENTATION[2] = 0\n",
        "V.G.KIN[91].AXIS[0].TYPE = 2\n",
        "V.G.WZ_AKT.KIN_PARAM[2] = -1\n",
    ],
)
def test_what_makes_no_kinematic_is_refused_at_activation(machine: Path, text: str) -> None:
    """The numbers may be wrong while a program writes them one after the other."""
    assert run(machine, text)[0].errors == ()
    found, _ = run(machine, text + "#TRAFO ON\n")
    (error,) = found.errors
    assert error.message is KINEMATIC_NOT_POSSIBLE


def test_param_of_the_list_is_the_same_memory(tmp_path: Path) -> None:
    folder = tmp_path / "demo5"
    shutil.copytree(DEMO5, folder)
    file = folder / "sda_mds1.lis"
    lines = [line for line in file.read_text("utf-8").splitlines() if "axis[3]" not in line]
    named = ["trafo[0].param[28] 2", "trafo[0].param[31] 1", "trafo[0].param[34] 1600000"]
    file.write_text("\n".join([*named, *lines]), "utf-8")
    found, said = run(folder, '#TRAFO ON\n#MSG ["%g", V.G.KIN[91].AXIS[3].POINT[2]]\n')
    assert found.errors == ()
    assert said == ["1.6e+06"]


def test_programs_begin_with_the_default_kinematic_and_end_without(tmp_path: Path) -> None:
    """P-CHAN-00151 and P-CHAN-00152: as #TRAFO ON and OFF in the first and last block."""
    folder = tmp_path / "demo5"
    shutil.copytree(DEMO5, folder)
    file = folder / "sda_mds1.lis"
    lines = [line for line in file.read_text("utf-8").splitlines() if "_position[2]" not in line]
    lists = "trafo[0].zero_position[2] -100000\n" + "\n".join(lines).replace("Ende", "") + "\n"
    text = '#MSG ["%.3f", V.A.ABS.Z]\n'
    for entries, begin, end in (("", 0.0, 0.0), ("enable", -10.0, -10.0), ("both", -10.0, 0.0)):
        own = lists
        if entries:
            own += "auto_enable_kin_trafo 1\n"
        if entries == "both":
            own += "auto_disable_kin_trafo 1\n"
        file.write_text(own, "utf-8")
        said: list[ProgramMessage] = []
        found = Controller(folder).run(
            NcText("p.nc", text + "M30\n"), on_message=said.append, signals=["Z.MCS.ACT_POS"]
        )
        assert found.errors == ()
        assert float(said[0].text) == begin
        assert found.trace is not None
        assert float(found.trace["Z.MCS.ACT_POS"][-1]) == end, entries
