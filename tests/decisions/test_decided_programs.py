# SPDX-License-Identifier: MIT
"""Decisions on programs: when mistakes are reported, technology functions, limits of work."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from support.decided import machine, numbers, perform, reported

from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView
from nctakt.run.realtime.realtime_part import INSTRUCTION_COST_NS


def test_a_program_with_a_static_mistake_does_not_begin() -> None:
    """All programs of a run are checked before its first tick; all mistakes are reported."""
    good, bad = NcText("good.nc", "G00 X1\nM30"), NcText("bad.nc", "G66\nV.E.NONE = 1\nM30")
    run = Controller().run(good, bad)
    assert (run.state, run.ticks, numbers(run)) == ("error", 0, [900200, 20196, 901006])


def test_a_mistake_that_only_values_show_stops_after_what_is_prepared() -> None:
    """Class 2: the motion before it is finished, then the channel is in error state."""
    controller = Controller()
    run = perform("P1 = 0\nG00 X5\nP2 = 1 / P1\nG00 X9\nM30", controller)
    assert (run.state, numbers(run)) == ("error", [20396])
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 5.0


def test_wrong_arguments_of_functions_have_the_controllers_number() -> None:
    """RC-207: 20398 in the main program; what is not finite otherwise is 21739."""
    assert numbers(perform("P1 = SQRT[P2 - 1]\nM30")) == [20398]
    assert numbers(perform("P1 = EXP[P2 + 1000]\nM30")) == [21739]


def test_an_accepted_word_is_reported_once() -> None:
    """900201 is one note for each word and program, however often it is there."""
    assert numbers(perform("G165\nG94 G164\nG165\nM30")) == [900201, 900201]


def test_a_loop_that_never_moves_is_ended() -> None:
    """900303 after 100,000 blocks without one that takes time; $FOR with step 0 is 20852."""
    run = perform("$WHILE 1\nP1 = P1 + 1\n$ENDWHILE\nM30")
    assert (run.state, numbers(run)) == ("error", [900303])
    run = perform("$FOR P1 = 0, 1, 0\n#TIME 0.001\n$ENDFOR\nM30", ticks=20)
    assert (run.state, numbers(run)) == ("error", [20852])


@pytest.mark.parametrize(
    ("program", "line"),
    [
        ("G00 X1\n$WHILE 1\nP1 = 1\n$FOR P2 = 1, 3, 1\nP3 = P2\n$ENDFOR\n$ENDWHILE\nM30", 2),
        ("$FOR P2 = 1, 3, 1\nG00 X[P2]\n$WHILE 1\nP1 = 1\n$ENDWHILE\n$ENDFOR\nM30", 3),
        ("N10: P1 = 1\nP1 = 2\n$GOTO N10\nM30", 3),
    ],
)
def test_an_endless_loop_is_named_by_its_begin(program: str, line: int) -> None:
    """900303 is at the outermost loop that goes round without time, or at the jump."""
    (found,) = perform(program).diagnostics
    assert found.id == 900303
    assert found.span is not None
    assert found.span.line == line


class _Late:
    """Acknowledges each function after this many ticks."""

    def __init__(self, ticks: int) -> None:
        self.ticks = ticks

    def cycle(self, hli: PlcView) -> None:
        for function in hli.functions():
            if hli.tick - function.time_us // 1000 >= self.ticks:
                hli.acknowledge(function)


def test_functions_of_the_program_wait_as_their_synchronisation_says() -> None:
    """P-CHAN-00041: MOS waits never, MVS_SVS before the motion, MVS_SNS and MNS_SNS after it.

    The motion takes 32 ticks; the PLC acknowledges ten ticks after the output.
    """
    expected = {
        "M100": (0, 32),  # output with the motion, nobody waits
        "M111": (0, 43),  # acknowledged at the end of tick 10, the motion begins in tick 11
        "M112": (0, 32),  # acknowledged long before the motion's end
        "M113": (32, 43),  # output after the motion, then waited for
        "M117": (None, 32),  # never output
    }
    for function, (output, end) in expected.items():
        run = perform(f"G00 X1 {function}\nM30", plc=_Late(10))
        number = function.removeprefix("M")
        outputs = [] if output is None else [f"{output} output M {number}"]
        assert reported(run) == [*outputs, f"{end} end part.nc"], function


class _Deaf:
    """Acknowledges nothing."""

    def cycle(self, hli: PlcView) -> None:
        del hli


def test_the_realtime_section_has_20_slots_and_never_waits() -> None:
    """RC-403: the 21st function that waits is 50942, the 21st of one tick 50943."""
    one = "#RT CYCLE [ID=1 SCOPE=PROG]\nM100\n#RT CYCLE END\n#TIME 1\nM30"
    run = perform(one, plc=_Deaf())
    assert numbers(run) == [50942]
    assert reported(run, "error") == ["20 error 50942"]
    many = "#RT CYCLE [ID=1 SCOPE=PROG]\n" + "M100\n" * 21 + "#RT CYCLE END\nM30"
    assert numbers(perform(many)) == [50943]
    assert numbers(perform(many.replace("M100\n", "", 1))) == []


def test_the_programs_functions_wait_for_a_slot() -> None:
    """20 functions are in the section; the 21st is put out when the PLC has taken one."""
    run = perform("M100\n" * 21 + "M30", plc=_Late(5))
    assert reported(run, "output").count("0 output M 100") == 20
    assert reported(run)[-2:] == ["6 output M 100", "6 end part.nc"]


def test_a_slot_is_free_in_the_tick_after_the_acknowledgement() -> None:
    """RC-403: 20 functions in each tick go on forever with the default PLC."""
    body = "M100\n" * 20
    run = perform(f"#RT CYCLE [SCOPE=PROG]\n{body}#RT CYCLE END\n#TIME 0.01\nM30")
    assert (run.state, run.outputs[0].count) == ("ended", 200)


THREE = "V.E.VALUE = V.E.VALUE1 + 1\n"  # elementary instructions


def body(count: int) -> str:
    """A cycle of this many statements with three instructions each, and a tick for it."""
    return f"#RT CYCLE [ID=1 SCOPE=PROG]\n{THREE * count}#RT CYCLE END\n#TIME 0.001\nM30"


def test_the_limit_of_instructions_is_exact() -> None:
    """RC-502: P-CHAN-00427 instructions of all cycles in one tick may be, one more is 50854."""
    limited = machine(max_steps=9)
    assert numbers(perform(body(3), Controller(limited))) == []
    more = body(3).replace(THREE, THREE + "M100\n", 1)
    assert numbers(perform(more, Controller(limited))) == [50854]
    two = body(2).replace("M30", "").replace("#TIME 0.001\n", "")
    both = two + body(2).replace("ID=1", "ID=2")
    run = perform(both, Controller(limited))
    assert reported(run, "error", "ended") == ["0 error 50854", "0 ended 2 error"]


def test_the_limit_of_time_counts_ten_nanoseconds_each() -> None:
    """RC-503: 1 % of 1 ms are 1000 instructions; looked at after each 100 (P-CHAN-00426).

    339 statements are 1017 instructions and end before the next look, 340 do not.
    """
    limited = machine(max_duration_pct=1, cont_steps=100)
    assert numbers(perform(body(339), Controller(limited))) == []
    assert numbers(perform(body(340), Controller(limited))) == [50939]
    assert 75_000 * INSTRUCTION_COST_NS == 0.75 * 1_000_000


def test_a_run_without_limits_ends_after_ten_minutes_of_the_machine() -> None:
    """600 s of virtual time; a tick of one second makes that 600 ticks."""
    run = Controller(replace(machine(), cycle_time_us=1_000_000)).run(
        NcText("a.nc", "#TIME 999\nM30")
    )
    assert (run.state, run.ticks) == ("limit", 600)


LOOP = """
#RT CYCLE [ID=1 SCOPE=GLOBAL]
  V.E.COUNT += 1
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    M100 M101
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 60, 1
  V.E.ASYNC = P1 * 10
  #RT CYCLE [SCOPE=BLOCK]
    V.E.VALUE = V.E.ASYNC + V.E.COUNT
  #RT CYCLE END
  G00 X[P1 MOD 13] Y[P1] M111
  #MSG ["%d %f", P1, V.E.COUNT]
$ENDFOR
M30
"""


class _Prompt:
    """Acknowledges all, and so stops the kernel in each tick."""

    def cycle(self, hli: PlcView) -> None:
        hli.acknowledge_all()


def test_a_run_that_is_cut_into_ticks_is_the_same_run() -> None:
    """Where the kernel returns to Python changes nothing: decode moments, frozen values, events."""
    names = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "V.E.VALUE", "V.E.COUNT", "BLOCK"]
    whole, cut = perform(LOOP, signals=names), perform(LOOP, signals=names, plc=_Prompt())
    assert whole.state == "ended"
    assert reported(whole) == reported(cut)
    assert whole.trace is not None
    assert cut.trace is not None
    assert all((whole.trace[name] == cut.trace[name]).all() for name in names)


def trace_of(folder: Path, *words: str, **environment: str) -> bytes | None:
    """The CSV trace of the program above in its own process; ``None`` where it is refused."""
    program, trace = folder / "loop.nc", folder / "loop.csv"
    program.write_text(LOOP, "utf-8")
    command = [sys.executable, "-m", "nctakt", "run", str(program), "--trace", str(trace), *words]
    kept = {key: value for key, value in os.environ.items() if key != "NCTAKT_PLAIN"}
    done = subprocess.run(command, env={**kept, **environment}, check=False, capture_output=True)
    return trace.read_bytes() if done.returncode == 0 else None


@pytest.mark.slow
def test_the_same_inputs_give_the_same_bytes(tmp_path: Path) -> None:
    """Whatever the hash seed of the process."""
    traces = [trace_of(tmp_path, "--plain", PYTHONHASHSEED=seed) for seed in ("1", "2")]
    assert traces[0] is not None
    assert traces[0] == traces[1]


@pytest.mark.slow
def test_compiled_and_plain_give_the_same_bytes(tmp_path: Path) -> None:
    """The two forms of the realtime part have the same results, bit for bit."""
    compiled = trace_of(tmp_path, "--compiled")
    if compiled is None:
        pytest.skip("not compiled")
    assert compiled == trace_of(tmp_path, "--plain")


def test_flush_continue_has_no_effect_on_the_queue() -> None:
    """It asks for no stop: M30 is taken in tick 32, after ``#FLUSH`` in tick 33."""
    motion = "G00 X1\n{flush}\nM30"
    assert reported(perform(motion.format(flush="#FLUSH CONTINUE"))) == ["32 end part.nc"]
    assert reported(perform(motion.format(flush="#FLUSH"))) == ["33 end part.nc"]


def test_numbers_have_no_exponents() -> None:
    """``1E3`` is the number 1 and a word E, the feed at the block's end."""
    assert numbers(perform("G01 X1E-3 F100\nM30")) == [20176]


def test_a_hash_command_may_go_on_in_the_next_line() -> None:
    r"""``\`` at the end of a line continues ``#`` commands as well."""
    assert reported(perform("#TIME \\\n  0.003\nM30")) == ["3 end part.nc"]


# --- neutral statements ----------------------------------------------------------------

NEUTRAL = """
#TRAFO OFF
#HSC OFF
#MCS OFF
#CAX OFF
#FACE OFF
#CYL OFF
#ROTATION OFF
#SCALE OFF
#VECTOR LIMIT OFF
#TLC OFF
#RTCP OFF
#FGROUP
#FGROUP [X, Y, Z]
#FGROUP [Z Y, X]
G12
G20
G52
G52 0
G117
G137
G150
G202
G128=100
G129=100 G131=100
G133=100
G134=100
G231=100 G233=100
G127 X100
G130 X100 Y100
G90 G132 X100 Z100
G136 X100
G230 X100 A100
G232 X100
G333 X100 G334=100
G338 X100
G339=100
"""


def test_what_switches_off_what_is_off_changes_nothing() -> None:
    """The statements of a usual start sequence: accepted, and no tick longer."""
    motion = "G01 X10 F1000\nM30\n"
    plain, neutral = perform(motion), perform(NEUTRAL + motion)
    assert not neutral.errors
    assert neutral.ticks == plain.ticks
    assert {one.id for one in neutral.diagnostics} <= {900201, 21209}


@pytest.mark.parametrize(
    "line",
    [
        "#CAXTRACK ON",
    ],
)
def test_what_would_change_the_motion_stays_refused(line: str) -> None:
    """Any other weight of feed-forward, and what switches on."""
    assert [one.id for one in perform(f"{line}\nG01 X10 F1000\nM30\n").errors] == [900200]
