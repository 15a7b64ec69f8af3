# SPDX-License-Identifier: MIT
"""The tool manager of a PLC: what D and T ask for, and what it answers (P-CHAN-00016, 00087).

Sources: pages 15335656587 (D: number of the tool, T and D in force, free values of the tool that
goes), 15335655051 (T), 251337611 (20296). ``docs/conformance/tools.md`` has what they leave open.
T = 1 ms: D is decoded before tick n, the PLC answers after tick n, and tick n + 1 latches that.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from support.plc_rig import loaded
from support.run_folders import changed_machine

import nctakt
from nctakt import Controller, HliView, NcText, Plc, Run, ToolData, ToolRequest
from nctakt.cli import main
from nctakt.plc.loading import PlcError, load_plc
from nctakt.session.session import Session

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"
TOOLS = {
    500: ToolData(length=120.0, radius=4.0, offsets=(1.0, -2.0), parameters=(7.5,)),
    501: ToolData(length=-3.0, spindle=5, max_speed=1000.0),
}


@pytest.fixture(scope="module", name="folder")
def fixture_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The demo machine with an external tool management that gets T."""
    entries = ["ext_wzv_vorhanden 1", "t_info_to_wzv 1"]
    folder = tmp_path_factory.mktemp("managed") / "machine"
    return changed_machine({"sda_mds1.lis": entries}, folder, base=DEMO)


class Cell(Plc):
    """A PLC with two tools, which notes what it is asked for."""

    def __init__(self) -> None:
        self.asked: list[ToolRequest] = []

    def tool_data(self, hli: HliView, request: ToolRequest) -> ToolData | None:
        """Return the tool."""
        self.asked.append(request)
        return TOOLS.get(request.basic)


def run(folder: Path, text: str, **settings: Any) -> Run:
    """A run of a program on this machine."""
    settings.setdefault("ticks", 20_000)
    return Controller(folder).run(NcText("t.nc", f"{text}\nM30"), **settings)


def numbers(found: Run) -> list[int]:
    """The numbers of all errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def test_the_data_of_the_answer_are_those_of_the_tool(folder: Path) -> None:
    shown = "V.G.WZ_AKT.L, V.G.WZ_AKT.R, V.G.WZ_AKT.V.X, V.G.WZ_AKT.V.Y, V.G.WZ_AKT.P[0], V.G.D_AKT"
    found = run(folder, f'D500\n#MSG ["%f %f %f %f %f %d", {shown}]', plc=Cell())
    assert numbers(found) == []
    assert [one.text for one in found.messages] == [
        "120.000000 4.000000 1.000000 -2.000000 7.500000 500"
    ]


def test_what_a_request_says(folder: Path) -> None:
    """T 500 is got ready; D501 shows what the program has written into P[0] of the tool 500."""
    plc = Cell()
    lines = ("T500", "D500", "V.G.WZ_AKT.P[0] = 9", "D501", "#TOOL PREP [500]", "D0")
    assert numbers(run(folder, "\n".join(lines), plc=plc)) == []
    assert [(one.basic, one.is_preparation, one.last_t, one.last_d) for one in plc.asked] == [
        (500, True, 500, 0),
        (500, False, 500, 0),
        (501, False, 500, 500),
        (500, True, 500, 501),
        (0, False, 500, 501),
    ]
    assert [one.parameters[0] for one in plc.asked] == [0.0, 0.0, 9.0, 0.0, 0.0]


def test_the_length_of_the_tool_moves_with_the_axes(folder: Path) -> None:
    """120 mm along Z: the axis goes to Z10 + 120 mm."""
    found = run(folder, "D500\nG90 G01 Z10 F6000", plc=Cell(), signals=["Z.ACS.ACT_POS"])
    assert found.trace is not None
    assert found.trace["Z.ACS.ACT_POS"][-1] == 130.0


def test_how_long_a_request_takes(folder: Path) -> None:
    """Before tick 0 D500 is asked, after it answered, in tick 1 latched; D501 follows then, before
    the PLC is called after tick 1, and is latched in tick 2.
    """
    ticks = [
        run(folder, text, plc=Cell(), set={"HLI.TOOL_MANAGER": 1}).ticks
        for text in ("G04 0.01", "D500\nG04 0.01", "D500\nD501\nG04 0.01")
    ]
    assert [after - before for before, after in pairwise(ticks)] == [2, 1]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("D7", [20296]),
        ("#TOOL DATA [500, 1, 2]", []),
        ("T7", []),
        ("G01 X1 F600\nP1 = V.G.WZ[3].L", [902801]),
        ("V.G.WZ[3].L = 2", [902801]),
        ("D500\nP1 = V.G.WZ[500].L", []),
        ("D500\n#TOOL REFRESH", []),
    ],
)
def test_what_is_refused(folder: Path, text: str, expected: list[int]) -> None:
    assert numbers(run(folder, text, plc=Cell())) == expected


def test_without_a_manager_the_tool_list_answers(folder: Path) -> None:
    """D1 of the demo machine's list; 500 is not there."""
    assert numbers(run(folder, "D1")) == []
    assert numbers(run(folder, "T500")) == []
    assert numbers(run(folder, "D500")) == [20296]


def test_an_answer_that_never_comes(folder: Path) -> None:
    """Ten seconds after the request, or a note of what is waited for at an earlier end."""
    found = run(folder, "D500", set={"HLI.TOOL_MANAGER": 1})
    assert numbers(found) == [902800]
    assert 10_000_000 <= found.virtual_time_us <= 10_010_000
    found = run(folder, "D500", set={"HLI.TOOL_MANAGER": 1}, until="1 s")
    assert found.state == "limit"
    assert any("HLI.TOOL_REQUEST" in one.headline() for one in found.diagnostics)


def test_any_other_client_answers_by_the_values(folder: Path) -> None:
    at = [("5 ms", "HLI.TOOL_LENGTH", -2.5), ("5 ms", "HLI.TOOL_VALID", 1)]
    at += [("6 ms", "HLI.TOOL_ANSWER", 1)]
    text = 'D9\n#MSG ["%f", V.G.WZ_AKT.L]'
    found = run(folder, text, set={"HLI.TOOL_MANAGER": 1}, at=at)
    assert numbers(found) == []
    assert [one.text for one in found.messages] == ["-2.500000"]


STRUCTURED = """
PROGRAM MAIN VAR fbHli : MCV_HliInterface; END_VAR
IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF
gpCh[0]^.head.plc_present_w := TRUE;
gpCh[0]^.tool_mc_control.tool_manager.enable_w := TRUE;
gpCh[0]^.tool_mc_control.tool_manager.command_w := TRUE;
gpCh[0]^.tool_mc_control.tool_answer.enable_w := TRUE;
gpCh[0]^.tool_mc_control.tool_valid.enable_w := TRUE;
gpCh[0]^.tool_mc_control.tool_length.enable_w := TRUE;
gpCh[0]^.tool_mc_control.tool_offset_1.enable_w := TRUE;
IF gpCh[0]^.tool_state.serial_r <> gpCh[0]^.tool_mc_control.tool_answer.command_w THEN
  gpCh[0]^.tool_mc_control.tool_valid.command_w := gpCh[0]^.tool_state.basic_r < 600;
  gpCh[0]^.tool_mc_control.tool_length.command_w :=
    UDINT_TO_DINT(gpCh[0]^.tool_state.basic_r) * 10000;
  gpCh[0]^.tool_mc_control.tool_offset_1.command_w := -15000;
  gpCh[0]^.tool_mc_control.tool_answer.command_w := gpCh[0]^.tool_state.serial_r;
END_IF
END_PROGRAM
"""


def test_structured_text_answers_by_the_same_elements(folder: Path, tmp_path: Path) -> None:
    """Tool n is n mm long; 1.5 mm less along Y."""
    plc = loaded(tmp_path, STRUCTURED)
    text = 'D77\n#MSG ["%f %f", V.G.WZ_AKT.L, V.G.WZ_AKT.V.Y]\nD600'
    found = run(folder, text, plc=plc)
    assert [one.text for one in found.messages] == ["77.000000 -1.500000"]
    assert numbers(found) == [20296]


PLC = """
from nctakt import Plc, ToolData


class Cell(Plc):
    def tool_data(self, hli, request):
        return ToolData(length=float(request.basic))
"""


def test_a_session_goes_back_over_a_request_and_its_tape_is_replayed(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G04 0.01\nD12\nG01 Z1 F6000\nD30\nG01 Z2\nM30\n", "utf-8")
    Path("cell.py").write_text(PLC, "utf-8")
    with Session("part.nc", machine=str(folder), plc="cell.py") as session:
        session.run()
        end, position = session.tick, session.read("V.RTA.ACS.ACT_POS.Z")
        assert position == [32.0]
        for tick in (5, end // 2, end):
            session.go_to(tick)
        assert session.read("V.RTA.ACS.ACT_POS.Z") == position
        session.save("tools.tape")
    assert main(["replay", "tools.tape", "--root", "/"]) == 0


def test_check_looks_no_tool_up(folder: Path, tmp_path: Path) -> None:
    """Only the PLC knows; a program that a run accepts has no errors."""
    program = tmp_path / "part.nc"
    program.write_text("T500 D500\nM30\n", "utf-8")
    assert main(["check", str(program), "--machine", str(folder)]) == 0


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        ("5", "answers 5 for tool 12: neither ToolData nor None"),
        ("ToolData(length='long')", "length='long' for tool 12: not a finite number"),
        ("ToolData(length=float('nan'))", "length=nan for tool 12: not a finite number"),
        ("ToolData(radius=-1)", "radius=-1 for tool 12: below 0"),
        ("ToolData(kinematic=1.5)", "kinematic=1.5 for tool 12: not a whole number"),
        ("ToolData(type=65536)", "type=65536 for tool 12: above 65535"),
        ("ToolData(offsets=[0.0] * 7)", "for tool 12: not a series of at most 6"),
        ("ToolData(parameters=['a'])", "parameters[0]='a' for tool 12: not a finite number"),
    ],
)
def test_a_wrong_answer_is_reported_at_the_method(
    folder: Path, tmp_path: Path, answer: str, reason: str
) -> None:
    """902804 at the def of tool_data, for each kind of value of the interface."""
    (tmp_path / "cell.py").write_text(PLC.replace("ToolData(length=float(request.basic))", answer))
    with pytest.raises(PlcError) as caught:
        run(folder, "D12", plc=load_plc(tmp_path / "cell.py"))
    (found,) = caught.value.diagnostics
    assert (found.id, found.span and found.span.line) == (902804, 6)
    assert reason in found.text()


def test_a_manager_that_is_never_asked_is_noted(folder: Path, tmp_path: Path) -> None:
    """901014, since the demo machine has no external tool management; not where it was asked."""
    (tmp_path / "cell.py").write_text(PLC)
    plc = load_plc(tmp_path / "cell.py")
    assert [one.id for one in run(folder, "D12", plc=plc).diagnostics] == []
    plc = load_plc(tmp_path / "cell.py")
    notes = Controller().run(NcText("t.nc", "G04 0.01\nM30"), plc=plc).diagnostics
    assert [one.id for one in notes] == [901014]
    assert "ext_wzv_vorhanden" in notes[0].text()


def test_t_has_an_effect_where_the_tool_manager_is_informed(folder: Path) -> None:
    """No note 900201, which says that T has none; on the demo machine it is true."""
    for machine, expected in ((folder, []), (DEMO, [900201])):
        found = Controller(machine).run(NcText("t.nc", "T1\nM30"))
        assert [one.id for one in found.diagnostics] == expected
