# SPDX-License-Identifier: MIT
"""ST-840: why a PLC in Structured Text has changed what it changes; values worked out by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt import Controller, NcText
from nctakt.base.failure import Failure
from nctakt.hli.variables_memory import describe
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import load_structured
from nctakt.results.explained.plc_histories import Fact, PlcHistory
from nctakt.results.explained.why import WhyReport

TASK = """\
CONFIGURATION Cell
RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#1MS, PRIORITY := 1);
PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE
END_CONFIGURATION
"""
CELL = """\
FUNCTION_BLOCK FB_Gate
VAR bSensor : BOOL; nCount : INT; rPos : LREAL; END_VAR
METHOD IsOpen : BOOL
IF nCount > 3 THEN
    IsOpen := bSensor AND rPos >= 1.5;
END_IF
END_METHOD
METHOD Tick
nCount := nCount + 1;
rPos := rPos + 0.5;
IF nCount = 2 THEN bSensor := TRUE; END_IF
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR
    fbHli : MCV_HliInterface;
    gate : FB_Gate;
    bAlarm, bLate : BOOL;
    i, n : INT;
    p : POINTER TO UDINT;
END_VAR
IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF
gate.Tick();
FOR i := 1 TO 3 DO
    IF i = 2 AND NOT bAlarm AND gate.IsOpen() THEN
        bAlarm := TRUE;
    END_IF
END_FOR
n := n + 1;
CASE n OF
    1, 2: bLate := FALSE;
    6: bLate := TRUE;
END_CASE
gpCh[0]^.bahn_mc_control.feedhold.command_w := bAlarm;
p := @BASE;
p^ := INT_TO_UDINT(n) * 10;
END_PROGRAM
"""
NC = """\
#RT CYCLE [ID = 3 SCOPE = PROG]
  $IF ONCE V.E.COUNT >= 40
    M100
  $ENDIF
#RT CYCLE END
G04 0.012
M30
"""


@pytest.fixture(scope="module")
def why(tmp_path_factory: pytest.TempPathFactory) -> WhyReport:
    """The report of a run of 12 ticks; the PLC's body runs from tick 2 on, with n = 1."""
    machine = load_machine(None)
    channel, offset = next(
        (channel, one.offset)
        for channel in (0, 1)
        for one in describe(machine, channel)
        if one.path == "COUNT"
    )
    base = "gpVECh[0]" if channel else "gpVEGlob"
    path = tmp_path_factory.mktemp("cell") / "cell.st"
    path.write_text(CELL.replace("@BASE", f"{base} + {offset}") + TASK, "utf-8")
    run = Controller().run(NcText("p.nc", NC), plc=load_structured(path), ticks=12, why=True)
    assert run.why is not None
    return run.why


def history(why: WhyReport, path: str) -> PlcHistory:
    """The history of one variable."""
    (found,) = why.select_plc(path).plc
    return found


def line(fact: Fact) -> int:
    """The line of a fact."""
    return 0 if fact.span is None else fact.span.line


def row(fact: Fact) -> tuple[str, int, str]:
    """Kind, line and value of a fact."""
    return fact.kind, line(fact), fact.value


def test_the_statement_and_its_conditions_with_values(why: WhyReport) -> None:
    """gate.nCount is 4 in tick 5; IsOpen is asked in the pass i = 2 only."""
    alarm = history(why, "main.balarm")
    (change,) = alarm.changes
    assert change.span is not None
    assert (change.tick, change.before, change.value) == (5, "FALSE", "TRUE")
    assert (change.span.line, change.statement) == (26, "bAlarm := TRUE")
    assert (alarm.begin, alarm.written) == ("FALSE", 5)
    assert [row(fact) for fact in change.facts] == [
        ("operand", 22, "TRUE"),  # what has returned early decides about all that follows
        ("condition", 22, "FALSE"),
        ("pass", 24, "2"),
        ("operand", 25, "2"),
        ("operand", 25, "FALSE"),
        ("call", 25, ""),
        ("operand", 25, "TRUE"),
        ("condition", 25, "TRUE"),
    ]


def test_what_led_to_the_result_of_a_method(why: WhyReport) -> None:
    """rPos is 2 when nCount is 4."""
    (change,) = history(why, "MAIN.bAlarm").changes
    (call,) = [fact for fact in change.facts if fact.kind == "call"]
    assert [row(fact) for fact in call.inside] == [
        ("operand", 4, "4"),
        ("condition", 4, "TRUE"),
        ("operand", 5, "TRUE"),
        ("operand", 5, "2"),
        ("operand", 5, "TRUE"),
        ("result", 5, ""),
    ]


def test_a_statement_in_a_method_names_its_call(why: WhyReport) -> None:
    (change,) = history(why, "MAIN.gate.bSensor").changes
    assert (change.tick, change.value) == (3, "TRUE")
    assert [row(fact)[:2] for fact in change.facts][2:] == [
        ("call", 23),
        ("operand", 11),
        ("condition", 11),
    ]


def test_what_is_written_again_is_no_change(why: WhyReport) -> None:
    """bLate is written FALSE for n = 1 and 2, TRUE for 6, in tick 7."""
    late = history(why, "MAIN.bLate")
    (change,) = late.changes
    assert (change.tick, change.facts[-1].text, change.facts[-1].value) == (7, "n", "6")
    hold = history(why, "gpCh[0]^.bahn_mc_control.feedhold.command_w")
    assert [(one.tick, one.before, one.value) for one in hold.changes] == [
        (2, "", "FALSE"),
        (5, "FALSE", "TRUE"),
    ]
    assert hold.written == 11


def test_a_reaction_of_a_realtime_cycle_names_the_write(why: WhyReport) -> None:
    """V.E.COUNT is 40 after tick 5; the cycle sees it in tick 6 (RC-002)."""
    chosen = why.select(line=2)
    assert [one.path for one in chosen.plc] == ["V.E.COUNT"]
    text = chosen.render()
    assert "true from tick 6 (0.006 s): 40 >= 40" in text
    assert "30 -> 40 at tick 5 (0.005 s): " in text
    assert "p^ := INT_TO_UDINT(n) * 10" in text


def test_a_tick_of_the_past(why: WhyReport) -> None:
    text = why.select_plc("MAIN.bAlarm").render_at(4, "en")
    assert "is FALSE" in text
    assert "has not changed up to here" in text
    assert "->" not in text
    assert "wahr" in why.select_plc("MAIN.bAlarm").render("de")


def test_a_name_that_nothing_has_written(why: WhyReport) -> None:
    with pytest.raises(Failure, match=r"MAIN\.bAlarm"):
        why.select_plc("MAIN.bAlram")


def test_an_input_is_no_statement(tmp_path: Path) -> None:
    """bStop comes from outside while n is below 5; then the statement takes it back."""
    body = "n := n + 1; IF n = 5 THEN bStop := FALSE; END_IF"
    path = tmp_path / "cell.st"
    text = f"PROGRAM MAIN VAR bStop : BOOL; n : INT; END_VAR {body} END_PROGRAM\n{TASK}"
    path.write_text(text, "utf-8")
    at = [(0.003, "MAIN.bStop", 1)]
    nc = NcText("p.nc", "G04 0.01\nM30\n")
    run = Controller().run(nc, plc=load_structured(path), ticks=12, at=at, why=True)
    assert run.why is not None
    stop = history(run.why, "MAIN.bStop")
    changes = [(one.before, one.value, one.span is None) for one in stop.changes]
    assert changes == [("FALSE", "TRUE", True), ("TRUE", "FALSE", False)]
    assert stop.changes[0].tick < stop.changes[1].tick


def test_the_newest_changes_are_kept_however_many_there_are(tmp_path: Path) -> None:
    """More than a log of 2^20 words has room for: 50,000 changes of x in one tick, then 49 each.

    What changed once before them is still there, and so are those in their own order.
    """
    code = (
        "PROGRAM MAIN\nVAR i, n, x, z : DINT; END_VAR\nn := n + 1;\nIF n = 1 THEN z := 7; END_IF\n"
        "FOR i := 1 TO 50000 DO x := i; x := -i; END_FOR\nEND_PROGRAM\n"
    )
    path = tmp_path / "cell.st"
    path.write_text(code + TASK, "utf-8")
    run = Controller().run(
        NcText("p.nc", "G04 1\nM30\n"), plc=load_structured(path), ticks=3, why=True
    )
    assert run.why is not None
    x, z = (history(run.why, f"MAIN.{name}") for name in "xz")
    assert (x.missed, x.left_out, len(x.changes)) == (0, 300_000 - 50, 50)
    assert [one.value for one in x.changes[-3:]] == ["-49999", "50000", "-50000"]
    assert [one.value for one in z.changes] == ["7"]


def test_changes_that_a_tick_has_no_room_for_are_counted(tmp_path: Path) -> None:
    """A log has 2^20 words: the newest 50 changes of 1,024 elements and of x and y have no room.

    Each statement of the 80 passes has 14 conditions around it, of two rows each, so a change
    takes 8 + 2 · 32 words (pass, n, two rows of each condition, two of the value) and no fewer.
    What gave a value is then not known, and not shown; z, which changed before, is.
    """
    arrays = "".join(f"a{name}[i] := n;" for name in "1234")
    code = (
        "PROGRAM MAIN\nVAR n, i, x, y, z : DINT; a1, a2, a3, a4 : ARRAY[0..255] OF DINT; END_VAR\n"
        f"z := z + 1;\nFOR n := 1 TO 80 DO\n{'IF n > z - 2 THEN ' * 14}\n"
        f"FOR i := 0 TO 255 DO {arrays} END_FOR\nx := n; y := -n;\n{'END_IF ' * 14}END_FOR\n"
        "END_PROGRAM\n"
    )
    path = tmp_path / "cell.st"
    path.write_text(code + TASK, "utf-8")
    run = Controller().run(
        NcText("p.nc", "G04 1\nM30\n"), plc=load_structured(path), ticks=1, why=True
    )
    assert run.why is not None
    x, y = (history(run.why, f"MAIN.{name}") for name in "xy")
    assert x.missed > 0
    assert y.missed > 0
    assert (x.left_out + len(x.changes) + x.missed, x.begin) == (80, "")
    shown = run.why.select_plc("MAIN.x").render_at(0)
    assert f"{x.missed} changes are missing: their ticks had too many" in shown
    assert "is " not in shown.split("PLC: MAIN.x\n")[1].split("\n")[0]
    z = history(run.why, "MAIN.z")
    assert (z.missed, len(z.changes), z.begin) == (0, 1, "0")
