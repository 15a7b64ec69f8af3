# SPDX-License-Identifier: MIT
"""What happened before the PLC announced itself is reported: functions, jobs, motions (ST-763).

T = 1 ms. The PLC opens the interface in cycles 0 and 1 and announces itself in cycle 2, that after
tick 2 (ST-801); from tick 3 on functions wait for it (RC-002).
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.changed_lists import machine_with
from support.plc_rig import EACH_TICK, loaded, values_in_main

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.session import Session

GATE = """
PROGRAM MAIN
VAR fbHli : MCV_HliInterface; nSeen : UDINT; pData : POINTER TO HLI_M_H_PROZESS; END_VAR
IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF
gpCh[0]^.head.plc_present_w := TRUE;
IF gpCh[0]^.techno_unit_std_sync[0].please_rw THEN
    gpCh[0]^.techno_unit_std_sync[0].please_rw := FALSE;
    pData := ADR(gpCh[0]^.techno_unit_std_sync[0].attribut_r.data);
    nSeen := pData^.nr;
    gpCh[0]^.techno_unit_std_sync[0].done_w := TRUE;
END_IF
END_PROGRAM
"""
TOLD = (
    "M7 was acknowledged at once: the PLC announced itself (gpCh[0]^.head.plc_present_w) "
    "only in tick {}"
)


def notes(run: Run) -> list[str]:
    """The notes about such functions."""
    return [one.text() for one in run.diagnostics if one.id == 902931]


def perform(folder: Path, nc: str, text: str = GATE, task: str = EACH_TICK) -> Run:
    """The run of a program beside the PLC."""
    return Controller().run(NcText("part.nc", nc), plc=loaded(folder, text, task))


def test_a_function_before_the_plc_is_reported_with_place_and_remedy(tmp_path: Path) -> None:
    """M7 (MVS_SVS) of tick 0 acknowledges itself; what waits until tick 3 reaches the PLC."""
    run = perform(tmp_path, "N10 G01 X0 F100\nN20 M7\nG04 0.02\nM30")
    (note,) = [one for one in run.diagnostics if one.id == 902931]
    assert note.text() == TOLD.format(2)
    assert note.span is not None
    assert (note.severity.name, note.span.line, note.span.column) == ("NOTE", 2, 5)
    assert note.remedy().startswith("Let the program wait at its beginning: G04 0.01.")
    remedied = loaded(tmp_path, GATE)
    run = Controller().run(NcText("part.nc", "N5 G04 0.01\nN20 M7\nM30"), plc=remedied)
    assert notes(run) == []
    assert values_in_main(remedied, "nSeen") == [7]


def test_a_line_is_reported_once_and_each_line_of_its_own(tmp_path: Path) -> None:
    """M7 twice in a loop is one note, a second line another one."""
    slow = EACH_TICK.replace("T#1MS", "T#10MS")
    run = perform(tmp_path, "$FOR P1 = 1, 2, 1\nM7\n$ENDFOR\nM7\nG04 0.05\nM30", task=slow)
    reported = [one.span.line for one in run.diagnostics if one.id == 902931 and one.span]
    assert reported == [2, 4]


def test_functions_that_do_not_wait_are_not_reported(tmp_path: Path) -> None:
    """M100 is MOS: nobody waits for it."""
    assert notes(perform(tmp_path, "M100\nG04 0.02\nM30")) == []


def test_a_plc_that_stays_away_is_reported_once_at_the_end(tmp_path: Path) -> None:
    """The first function names the element; M100 (MOS) alone, or a PLC without interface, none."""
    away = GATE.replace("plc_present_w := TRUE", "plc_present_w := FALSE")
    run = perform(tmp_path, "M100\nM7\nG04 0.02\nM7\nM30", away)
    assert notes(run) == []
    (note,) = [one for one in run.diagnostics if one.id == 902966]
    assert note.text() == (
        "M7 was acknowledged at once: until the run's end the PLC did not announce itself "
        "(gpCh[0]^.head.plc_present_w)"
    )
    assert note.span is not None and note.span.line == 2
    assert note.remedy().startswith("Let the PLC set gpCh[0]^.head.plc_present_w to TRUE")
    assert perform(tmp_path, "M100\nG04 0.02\nM30", away).diagnostics == ()
    alone = "PROGRAM MAIN\nVAR n : UDINT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"
    assert perform(tmp_path, "M7\nG04 0.02\nM30", alone).diagnostics == ()


def test_a_motion_of_a_cycle_before_the_plc_is_reported(tmp_path: Path) -> None:
    """ST-764: from tick 3 on X needs the releases that the PLC gives; in tick 0 it needs none."""
    text = GATE.replace(
        "gpCh[0]^.head.plc_present_w := TRUE;",
        "gpAx[0]^.head.plc_present_w := TRUE;\n"
        + "".join(
            f"gpAx[0]^.lr_mc_control.{one}.{member} := TRUE;\n"
            for one in ("drive_on", "torque_permission", "release_feedhold")
            for member in ("enable_w", "command_w")
        ),
    )
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE 1\nX[INDP G90 POS=50 FEED=500]\n$ENDIF\n"
    cycle += "#RT CYCLE END\n"
    reported = perform(tmp_path, f"{cycle}G04 0.02\nM30", text).diagnostics
    (note,) = [one for one in reported if one.id == 902965]
    assert note.text() == (
        "X moved without releases: the PLC announced itself (gpAx[0]^.head.plc_present_w) "
        "only in tick 2"
    )
    assert note.span is not None and note.span.line == 3
    late = perform(tmp_path, f"G04 0.01\n{cycle}G04 0.02\nM30", text).diagnostics
    assert [one for one in late if one.id == 902965] == []


def test_a_job_of_a_cycle_before_the_plc_that_turns_the_spindle_is_reported(tmp_path: Path) -> None:
    """RC-404, P-CHAN-00069: the job of tick 0 acknowledges itself, that of tick 10 waits."""
    folder = machine_with(tmp_path / "machine")
    lists = folder / "sda_mds1.lis"
    line = "spindel[0].plc_control                  "
    lists.write_text(lists.read_text("utf-8").replace(f"{line}0", f"{line}1"), "utf-8")
    text = GATE.replace(
        "gpCh[0]^.head.plc_present_w := TRUE;",
        "FOR n := 0 TO 5 DO gpAx[n]^.head.plc_present_w := TRUE; END_FOR",
    ).replace("VAR fbHli", "VAR n : DINT; fbHli")
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE 1\nS[M3 REV1000]\n$ENDIF\n#RT CYCLE END\n"
    run = Controller(folder).run(
        NcText("part.nc", f"{cycle}G04 0.02\nM30"), plc=loaded(tmp_path, text)
    )
    (note,) = [one for one in run.diagnostics if one.id == 902931]
    assert note.text().startswith("S M3 was acknowledged at once: the PLC announced itself (gpAx[")
    assert note.span is not None and note.span.line == 3
    run = Controller(folder).run(
        NcText("part.nc", f"G04 0.01\n{cycle}G04 0.02\nM30"), plc=loaded(tmp_path, text)
    )
    assert notes(run) == []


@pytest.mark.parametrize(("ticks", "seen", "reported"), [(0, 0, 1), (2, 0, 1), (3, 7, 0)])
def test_a_function_that_takes_its_time_may_still_reach_the_plc(
    tmp_path: Path, ticks: int, seen: int, reported: int
) -> None:
    """P-CHAN-00040: M7 acknowledges itself after its time, in tick 2 nobody has it, in 3 the PLC.

    The list counts in 0.1 µs.
    """
    lists = f"m_prozess_zeit[7] {ticks * 10_000}"
    machine = machine_with(tmp_path / "machine", default_sda=lists)
    plc = loaded(tmp_path, GATE)
    run = Controller(machine).run(NcText("part.nc", "M7\nG04 0.02\nM30"), plc=plc)
    assert (values_in_main(plc, "nSeen"), len(notes(run))) == ([seen], reported)


@pytest.mark.parametrize(
    ("function", "lists"),
    [("H77", "h_synch[77] MVS_SVS"), ("T1", "tool.synch MVS_SVS")],
)
def test_functions_of_other_letters_are_reported_as_well(
    tmp_path: Path, function: str, lists: str
) -> None:
    """P-CHAN-00027 and P-CHAN-00086: H77 and T1 are MVS_SVS, so that the program waits for them."""
    machine = machine_with(tmp_path / "machine", default_sda=lists)
    run = Controller(machine).run(
        NcText("part.nc", f"{function}\nG04 0.02\nM30"), plc=loaded(tmp_path, GATE)
    )
    assert notes(run) == [TOLD.format(2).replace("M7", function)]


def test_each_of_several_plcs_may_be_the_one_that_answers(tmp_path: Path) -> None:
    """With a second PLC that stays away the first one is the one that announced itself."""
    away = GATE.replace("plc_present_w := TRUE", "plc_present_w := FALSE")
    for name in ("near", "far"):
        (tmp_path / name).mkdir()
    plcs = [loaded(tmp_path / "far", away), loaded(tmp_path / "near", GATE)]
    run = Controller().run(NcText("part.nc", "M7\nG04 0.02\nM30"), plc=plcs)
    assert notes(run) == [TOLD.format(2)]


def test_a_session_tells_it_as_soon_as_the_plc_is_there(tmp_path: Path) -> None:
    """A session's slices have the same note in their diagnostics: M7 of tick 0, seen in tick 2."""
    cell = tmp_path / "cell.st"
    cell.write_text(GATE + EACH_TICK, "utf-8")
    with Session(NcText("part.nc", "M7\nG04 0.02\nM30"), plc=cell) as session:
        assert [one.id for one in session.step(2).diagnostics] == []
        assert [one.id for one in session.step(3).diagnostics] == [902931]
