# SPDX-License-Identifier: MIT
"""The words T and D, and what V.G shows of tools (MO-8).

The demo machine has tools 1 (length 100, radius 5), 2 (length 80, radius 3) and 3 (length 120, 1 mm
beside the spindle in X).
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.changed_lists import machine_with

import nctakt
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.policies import after, only
from nctakt.plc.script import Plc
from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


def run(text: str, machine: Path | None = None) -> tuple[Run, list[str]]:
    """A program's run, and what it says."""
    said: list[ProgramMessage] = []
    found = Controller(machine).run(NcText("p.nc", text + "M30\n"), on_message=said.append)
    return found, [one.text for one in said]


def test_v_g_tells_of_the_active_tool_and_of_those_of_the_list() -> None:
    """Lengths in the program's unit; an offset by the axis' name or its place."""
    found, said = run(
        '#MSG ["%g %g %g", V.G.WZ_AKT.R, V.G.D_AKT, V.G.T_AKT]\n'
        "T3 D2\n"
        '#MSG ["%g %g %g %g", V.G.WZ_AKT.R, V.G.WZ_AKT.L, V.G.D_AKT, V.G.T_AKT]\n'
        '#MSG ["%g %g %g", V.G.WZ[3].V.X, V.G.WZ[1 + 2].V[0], V.G.WZ_AKT.V.X]\n'
        '#MSG ["%g %g %g", V.G.WZ[1].OK, V.G.WZ[1].SPDL_AX_NR, V.G.WZ[0].L]\n'
        '#MSG ["%g %g", V.G.WZ[1].P[7], V.G.WZ[1].SRK_ID]\n'
        'G70\n#MSG ["%.6f %.6f", V.G.WZR * 25.4, V.G.WZ[3].V.X * 25.4]\n'
    )
    assert found.errors == ()
    assert said == ["0 0 0", "3 80 2 3", "1 1 0", "1 5 0", "0 0", "3.000000 1.000000"]


def test_radius_and_length_of_the_active_tool_can_be_written() -> None:
    """Until the next D; the list's tool is as it was."""
    found, said = run(
        "D1\nV.G.WZ_AKT.R = 4\nV.G.WZ_AKT.L -= 10\n"
        '#MSG ["%g %g %g", V.G.WZ_AKT.R, V.G.WZ_AKT.L, V.G.WZ[1].R]\n'
        'D1\n#MSG ["%g %g", V.G.WZ_AKT.R, V.G.WZ_AKT.L]\n'
        'D0\nV.G.WZR = 2\n#MSG ["%g", V.G.WZ_AKT.R]\n'
    )
    assert found.errors == ()
    assert said == ["4 90 5", "5 100", "2"]


def test_a_realtime_cycle_has_the_tool_of_its_definition() -> None:
    """V.G is asynchronous: a constant in the cycle (RC-302)."""
    controller = Controller()
    text = (
        "D2\n#RT CYCLE [SCOPE=PROG]\nV.E.VALUE = V.G.WZ_AKT.R\n#RT CYCLE END\nD1\nG04 0.01\nM30\n"
    )
    assert controller.run(NcText("p.nc", text)).errors == ()
    assert controller.read("V.E.VALUE") == 3


@pytest.mark.parametrize(
    ("text", "number", "message"),
    [
        ("D7\n", 20172, "the tool list has no tool 7"),
        ("P1 = 9\nD P1\n", 20172, "the tool list has no tool 9"),
        ("P1 = V.G.WZ[9].R\n", 20172, "the tool list has no tool 9"),
        ("D1.5\n", 20171, "1.5 is not a tool number"),
        ("T-1\n", 20166, "-1 is not a tool number"),
        ("P1 = V.G.WZ_AKT.V[9]\n", 21928, "V.G.WZ_AKT.V"),
        ("P1 = V.G.WZ_AKT.P[60]\n", 21928, "V.G.WZ_AKT.P"),
        ("V.G.WZ[1].TYPE = 1\n", 20100, "V.G.WZ"),
        ("V.G.WZ_AKT.R = 5\nP1 = V.G.WZ_AKT.X\n", 900200, "V.G"),
    ],
)
def test_what_no_tool_answers_to(text: str, number: int, message: str) -> None:
    """A tool that there is not, no number of a tool, an element that there is not."""
    found, _ = run(text)
    assert [one.id for one in found.errors] == [number]
    assert message in found.errors[0].text("en")


def test_a_tool_that_is_not_valid(tmp_path: Path) -> None:
    """P-TOOL-00005 is 0."""
    machine = machine_with(tmp_path / "m", werkz_d1="wz[9].laenge 5")
    found, _ = run("D9\n", machine)
    assert [one.id for one in found.errors] == [20691]
    assert found.errors[0].text("de") == "Werkzeug 9 ist nicht gültig"


def test_t_selects_the_offsets_of_its_number(tmp_path: Path) -> None:
    """P-CHAN-00014: T2 is T2 D2; a D of the block counts before it."""
    machine = machine_with(tmp_path / "m", sda_mds1="einrechnen_mit_t 1")
    found, said = run(
        'T2\n#MSG ["%g %g %g", V.G.T_AKT, V.G.D_AKT, V.G.WZ_AKT.L]\n'
        'D1 T3\n#MSG ["%g %g", V.G.T_AKT, V.G.D_AKT]\n'
        'T0\n#MSG ["%g %g", V.G.D_AKT, V.G.WZ_AKT.L]\n',
        machine,
    )
    assert (found.errors, said) == ((), ["2 2 80", "3 1", "0 0"])


def test_t_that_selects_offsets_needs_a_tool_of_the_list(tmp_path: Path) -> None:
    """P-CHAN-00014: with the parameter T2 is D2 as well; the list has T in any case."""
    program = NcText("p.nc", "T7\nT9\nT9 D1\nM30\n")
    for value, expected in (("0", [(20167, 1)]), ("1", [(20167, 1), (20691, 2)])):
        machine = machine_with(
            tmp_path / value, sda_mds1=f"einrechnen_mit_t {value}", werkz_d1="wz[9].laenge 5"
        )
        checked = check_files([program], AssembledMachine(load_machine(machine))).findings
        found = [one.diagnostic for one in checked]
        numbers = [(one.id, one.span and one.span.line) for one in found if one.id != 900201]
        assert numbers == expected
        assert [one.id for one in run("T[3 + 4]\n", machine)[0].errors] == [expected[0][0]]


def outputs(program: str, machine: Path) -> list[tuple[str, int]]:
    """The functions of a program with their ticks."""
    run = Controller(machine).run(NcText("p.nc", program))
    assert not run.errors, run.errors
    return [(one.name, one.tick) for one in run.technology]


@pytest.mark.parametrize(
    ("type_", "ticks"),
    [
        ("MOS", [("T2", 0), ("M7", 32)]),
        ("MVS_SVS", [("T2", 0), ("M7", 33)]),
        ("MVS_SNS", [("T2", 0), ("M7", 32)]),
        ("MNS_SNS", [("T2", 32), ("M7", 33)]),
        ("NO_SYNCH", [("M7", 32)]),
    ],
)
def test_t_goes_to_the_plc(tmp_path: Path, type_: str, ticks: list[tuple[str, int]]) -> None:
    """P-CHAN-00086: X1 takes 32 ticks; the PLC acknowledges T in its tick, known in the next."""
    machine = machine_with(tmp_path / "m", sda_mds1=f"tool.synch {type_}")
    assert outputs("G00 X1 T2\nM7\nM30\n", machine) == ticks


def test_t_has_few_synchronisation_types(tmp_path: Path) -> None:
    """20965: MVS_SVS takes the place of any other one."""
    machine = machine_with(tmp_path / "m", sda_mds1="tool.synch MET_SVS")
    controller = Controller(machine)
    assert [one.id for one in controller.diagnostics] == [20965]
    assert outputs("T2\nM30\n", machine) == [("T2", 0)]


def test_a_plc_sees_the_tool(tmp_path: Path) -> None:
    """The program waits until the PLC has acknowledged T2, five ticks later."""
    machine = machine_with(tmp_path / "m", sda_mds1="tool.synch MVS_SVS")

    class Changer(Plc):
        acknowledge = only("T2", "M7", then=after("5 ms"))

    found = Controller(machine).run(NcText("p.nc", "T2\nM7\nM30\n"), plc=Changer())
    assert [(one.name, one.tick) for one in found.technology] == [("T2", 0), ("M7", 6)]


def test_the_largest_number_of_a_tool(tmp_path: Path) -> None:
    """20166: the code of a function has no room for more."""
    machine = machine_with(tmp_path / "m", sda_mds1="tool.synch MOS")
    (machine / "werkz_d1.lis").write_text("End\n")
    assert outputs("T999999999\nM30\n", machine) == [("T999999999", 0)]
    assert [one.id for one in run("T1000000000\n", machine)[0].errors] == [20166]


def test_without_a_tool_list_each_t_is_accepted(tmp_path: Path) -> None:
    """Then the PLC alone knows the tools."""
    machine = machine_with(tmp_path / "m")
    (machine / "werkz_d1.lis").write_text("End\n")
    assert run("T7\n", machine)[0].errors == ()


@pytest.mark.parametrize(
    ("entries", "word", "stops"),
    [
        ("", "D1", False),
        ("flush.d_cmd D", "D1", False),
        ("flush.d_cmd FAW_D", "D1", True),
        ("flush.d_cmd FAW_D", "T1", False),
        ("flush.d_cmd FAW_D\neinrechnen_mit_t 1", "T1", True),
    ],
)
def test_d_empties_the_channel(tmp_path: Path, entries: str, word: str, stops: bool) -> None:
    """P-CHAN-00271: FAW_D is ``#FLUSH WAIT`` before D, T that selects included."""
    machine = machine_with(tmp_path / "m", sda_mds1=entries)
    program = "G01 X10 F6000\n{}\nG01 X20\n"
    ticks = run(program.format(word), machine)[0].ticks
    assert ticks == run(program.format("#FLUSH WAIT" if stops else "F6000"))[0].ticks


def test_d_that_empties_the_channel_is_not_possible_under_compensation(tmp_path: Path) -> None:
    """P-CHAN-00271, 20651: the path cannot stop between two motions of the contour."""
    machine = machine_with(tmp_path / "m", sda_mds1="flush.d_cmd FAW_D")
    found, _ = run("D1\nG41 G01 X20 F6000\nD2\nX40\nG40 X60\n", machine)
    assert [one.id for one in found.errors] == [20651]
