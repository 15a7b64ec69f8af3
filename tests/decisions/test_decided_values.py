# SPDX-License-Identifier: MIT
"""Decisions on statements, expressions and variables."""

from __future__ import annotations

import math

import pytest
from support.decided import left, numbers, perform, reported

from nctakt.base.failure import Failure
from nctakt.run.controller import Controller

#: Characters of a STRING of the demo machine, whose variables list asks for long ones.
LONGEST = 127


def cycle(*statements: str) -> str:
    """A program whose one cycle runs once."""
    return "\n".join(["#RT CYCLE [ID=1 SCOPE=PROG]", *statements, "#RT CYCLE END", "M30"])


def test_compound_assignments_are_those_of_the_four_operations() -> None:
    """RC-205: += as in the manual, and -=, *=, /= as well."""
    text = cycle("V.E.VALUE += 7", "V.E.VALUE *= 6", "V.E.VALUE -= 2", "V.E.VALUE /= 8")
    assert left(text, "V.E.VALUE") == 5.0


def test_a_branch_fires_at_the_first_of_a_series_and_hold_does_not_break_it() -> None:
    """``fired`` comes once for consecutive run-throughs; HOLD keeps a series, START ends it."""
    body = (
        "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF V.E.VALUE == 0\nV.E.COUNT += 1\n$ENDIF\n#RT CYCLE END\n"
    )
    hold = "#TIME 0.002\n#RT CYCLE HOLD [ID=1]\n#TIME 0.002\n#RT CYCLE CONTINUE [ID=1]\n"
    run = perform(body + hold + "#TIME 0.002\n#RT CYCLE START [ID=1]\n#TIME 0.002\nM30")
    assert reported(run, "fired") == ["0 fired 1 line 2", "6 fired 1 line 2"]


@pytest.mark.parametrize(
    "expression", ["1 / V.E.VALUE1", "SQRT[V.E.VALUE1 - 1]", "EXP[1000 + V.E.VALUE1]"]
)
def test_a_result_that_is_not_finite_is_a_fault_at_the_assignment(expression: str) -> None:
    """RC-207: 50879 whatever made it, an undefined operation or an overflow; nothing is stored."""
    controller = Controller()
    run = perform(cycle("V.E.VALUE = 3", f"V.E.VALUE = {expression}"), controller)
    assert numbers(run) == [50879]
    assert controller.read("V.E.VALUE") == 3.0


def test_an_overflow_that_only_meets_a_comparison_compares_as_infinite() -> None:
    """RC-207: only what is assigned has to be finite."""
    text = cycle("$IF EXP[1000 + V.E.VALUE1] > 5", "V.E.COUNT = 1", "$ENDIF")
    assert left(text, "V.E.COUNT") == 1


def test_values_from_outside_are_finite() -> None:
    """RC-307: 50893 is what a value from a stimulus, the PLC or Python gets."""
    controller = Controller()
    with pytest.raises(Failure) as failure:
        controller.write("V.E.VALUE", math.inf)
    assert [found.message.id for found in failure.value.diagnostics] == [50893]


def test_positions_are_in_the_unit_that_was_active_at_the_definition() -> None:
    """RC-304, RC-410: a cycle defined under G70 reads inches, also when G71 is back."""
    text = "G01 X25.4 F60000\nG70\n#RT CYCLE [ID=1 SCOPE=PROG]\nV.E.VALUE = V.RTA.ACS.ACT_POS.X\n"
    text += "V.E.VALUE1 = V.RTA.ACS.ACT_POS.A\n#RT CYCLE END\nG71\n#TIME 0.001\nM30"
    assert left(text, "V.E.VALUE") == pytest.approx(1.0)


def test_positions_are_not_quantised() -> None:
    """RC-304: after the first increment of a diagonal the cycle reads what the path computes."""
    text = "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE V.RTA.ACS.ACT_POS.X > 0\n"
    text += "V.E.VALUE = V.RTA.ACS.ACT_POS.X\n$ENDIF\n#RT CYCLE END\nG00 X1 Y3\nM30"
    assert left(text, "V.E.VALUE") == pytest.approx(0.002 / 3.0, abs=1e-15)


def test_an_override_is_rounded_and_bounded_to_its_type() -> None:
    """RC-305: UNS16; 49.5 is 50 (half to even), −1 is 50892."""
    slow = "V.RTG.OVERRIDE.VEL.CYCLE = 49.5 + V.E.VALUE1"
    text = f"#RT CYCLE [SCOPE=PROG]\n{slow}\n#RT CYCLE END\n#TIME 0.002\nM30"
    run = perform(text, signals=["OVERRIDE.VEL.CYCLE", "OVERRIDE.VEL.TOTAL"])
    assert run.trace is not None
    assert run.trace.at(0, "OVERRIDE.VEL.CYCLE") == run.trace.at(0, "OVERRIDE.VEL.TOTAL") == 50.0
    assert numbers(perform(cycle("V.RTG.OVERRIDE.VEL.CYCLE = V.E.VALUE1 - 1"))) == [50892]


def test_only_cycles_and_writes_to_realtime_variables_make_events() -> None:
    """RC-308: the program's own writes are silent but for V.RT*, which empty the channel first."""
    run = perform("V.E.VALUE = 3\nV.E.ASYNC = 4\nV.RTG.LOOP.COUNT = 5\nM30")
    assert reported(run) == ["1 written V.RTG.LOOP.COUNT 5", "1 end part.nc"]


def test_both_sides_of_a_logical_operator_are_evaluated() -> None:
    """RC-501: ``&&`` and ``||`` have a fixed cost; a fault on the right is one in any case."""
    for operator, first in (("&&", "V.E.VALUE1 > 1"), ("||", "V.E.VALUE1 < 1")):
        condition = f"$IF {first} {operator} 1 / V.E.VALUE1 > 0"
        assert numbers(perform(cycle(condition, "$ENDIF"))) == [50879], operator


@pytest.mark.parametrize(
    ("statement", "count"),
    [
        ("V.E.VALUE = 3", 1),
        ("V.E.VALUE = 3 * 4 + SQRT[16]", 4),
        ("V.E.VALUE = V.E.VALUE1", 2),
        ("V.E.VALUE = V.E.ASYNC", 2),
        ("V.E.VALUE += V.E.VALUE1 * -2", 5),
        ("V.E.VALUE = V.E.LIST[3]", 2),
        ("V.E.VALUE = V.E.LIST[V.E.COUNT]", 3),
        ("M100", 1),
        ("$IF V.E.VALUE > 1\n$ENDIF", 3),
        ("$IF V.E.VALUE > 1\n$ELSEIF V.E.VALUE\n$ELSE\nM100\n$ENDIF", 6),
    ],
)
def test_what_counts_as_an_elementary_instruction(statement: str, count: int) -> None:
    """RC-501: operator, function, access, assignment, condition, action; not constants and ELSE."""
    controller = Controller()
    run = perform(
        f"#RT CYCLE [SCOPE=PROG]\n{statement}\n#RT CYCLE END\n#TIME 1\nM30", controller, ticks=1
    )
    assert numbers(run) == []
    assert controller.instructions_in_tick == count


def test_an_axis_override_does_not_slow_the_path() -> None:
    """RC-305: V.RTA.OVERRIDE.VEL.CYCLE is for independent motions only."""
    slow = "#RT CYCLE [SCOPE=PROG]\nV.RTA.OVERRIDE.VEL.CYCLE.X = 10\n#RT CYCLE END\n"
    assert perform(slow + "G00 X100\nM30").ticks == perform("G00 X100\nM30").ticks


def test_what_is_written_from_outside_is_read_at_once_and_acts_in_the_next_tick() -> None:
    """RC-002: a text too, which only the outside can read and write."""
    controller = Controller()
    controller.write("V.E.VALUE", 2.5)
    controller.write("V.E.TEXT", "abc")
    assert (controller.read("V.E.VALUE"), controller.read("V.E.TEXT")) == (2.5, "abc")
    controller.step()
    assert (controller.read("V.E.VALUE"), controller.read("V.E.TEXT")) == (2.5, "abc")


def test_the_diagnosis_level_is_3_at_the_start() -> None:
    """RC-603: errors, warnings and management are listed unless a program says otherwise."""
    assert Controller().read("V.RTG.CYCLES.DIAG_LEVEL") == 3.0


def test_a_text_has_to_fit_its_variable() -> None:
    """STRING takes 127 characters of Windows-1252 here; one more is 21462, others are 900344."""
    controller = Controller()
    assert perform('V.E.TEXT = "' + "ä" * LONGEST + '"\nM30', controller).state == "ended"
    assert controller.read("V.E.TEXT") == "ä" * LONGEST
    assert numbers(perform('V.E.TEXT = "' + "x" * (LONGEST + 1) + '"\nM30')) == [21462]
    for text, number in (("x" * (LONGEST + 1), 21462), ("→", 900344)):
        with pytest.raises(Failure) as failure:
            controller.write("V.E.TEXT", text)
        assert [found.message.id for found in failure.value.diagnostics] == [number]
