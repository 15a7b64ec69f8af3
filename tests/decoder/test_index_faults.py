# SPDX-License-Identifier: MIT
"""Indices and conditions that are no usable numbers: faults with a place, never an exception."""

from __future__ import annotations

import pytest

from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText

DEMO = load_machine(None)

#: VALUE is 1e300: its square is infinite, the difference of two squares no number at all.
INFINITE = "V.E.VALUE * V.E.VALUE"
UNDEFINED = f"{INFINITE} - {INFINITE}"


def errors_of(text: str) -> list[tuple[int, int]]:
    """Number and column of the errors of a program."""
    run = Controller(DEMO).run(
        NcText("p.nc", f"{text}\nG00 X1\nM30"), set={"V.E.VALUE": 1e300}, memory_trace=False
    )
    assert run.state == ("error" if run.errors else "ended")
    return [(found.id, found.span.column if found.span else 0) for found in run.errors]


def cycle(statement: str) -> str:
    """A realtime cycle of one statement."""
    return f"#RT CYCLE\n{statement}\n#RT CYCLE END"


@pytest.mark.parametrize(
    ("index", "id_"),
    [
        (INFINITE, 50879),
        (UNDEFINED, 50879),
        ("1 / V.E.ASYNC", 50879),
        ("V.E.VALUE", 50895),
        ("10", 50895),
        ("9.51", 50895),
        ("-0.51", 50895),
    ],
)
def test_an_index_in_a_cycle_must_be_a_number_in_range(index: str, id_: int) -> None:
    """What is no number is 50879, what is outside the array 50895; nothing is stored (RC-307)."""
    for statement in (f"V.E.LIST[{index}] = 1", f"V.E.SYNC = V.E.LIST[{index}]"):
        assert [number for number, _ in errors_of(cycle(statement))] == [id_]


@pytest.mark.parametrize("index", ["9.5", "-0.5", "0", "V.E.COUNT + 9.4"])
def test_an_index_is_rounded_half_to_even(index: str) -> None:
    """-0.5 is element 0; 9.5 would be element 10, which the list does not have."""
    expected = [50895] if index == "9.5" else []
    assert [number for number, _ in errors_of(cycle(f"V.E.LIST[{index}] = 1"))] == expected


@pytest.mark.parametrize(
    ("index", "id_"), [(INFINITE, 21739), ("1 / V.E.ASYNC", 20396), ("SQRT[-1]", 20398)]
)
@pytest.mark.parametrize("text", ["V.E.LIST[@] = 1", "P1 = V.E.LIST[@]", "P1 = P[@]", "P[@] = 1"])
def test_an_index_of_the_decoder_must_be_a_number(text: str, index: str, id_: int) -> None:
    """A fault in an index stops decoding, at the place of the index."""
    column = text.index("@") + 1
    ((number, found),) = errors_of(text.replace("@", index))
    assert number == id_
    assert found >= column


def test_a_condition_that_is_not_finite_is_a_fault() -> None:
    """A bare value as a condition must be finite; a comparison of anything is 0 or 1 (RC-207)."""
    for form in ("$IF @", "$IF EDGE @", "$IF ONCE @"):
        for value in (INFINITE, UNDEFINED):
            text = form.replace("@", value) + "\nV.E.COUNT = 1\n$ENDIF"
            assert [number for number, _ in errors_of(cycle(text))] == [50879]
    assert errors_of(cycle(f"$IF {INFINITE} > 3\nV.E.COUNT = 1\n$ENDIF")) == []


@pytest.mark.parametrize(
    ("target", "value", "id_"),
    [
        ("V.RTA.OVERRIDE.VEL.CYCLE.X", "65535.4", None),
        ("V.RTA.OVERRIDE.VEL.CYCLE.X", "65535.6", 50892),
        ("V.RTA.OVERRIDE.VEL.CYCLE.A", "-1", 50892),
        ("V.RTG.OVERRIDE.VEL.CYCLE", "70000", 50892),
        ("V.RTG.LOOP.COUNT", "1000000 * 1000000", 50892),
        ("V.E.LEVEL_1_A[2].LEVEL_2_A[1].LIST[3]", "1000000 * 1000000", 50892),
    ],
)
def test_a_value_out_of_range_names_its_variable(target: str, value: str, id_: int | None) -> None:
    """50892 names the variable as the program writes it, whatever family it is of (RC-307)."""
    run = Controller(DEMO).run(NcText("p.nc", cycle(f"{target} = {value}") + "\nG00 X1\nM30"))
    assert [found.id for found in run.errors] == ([] if id_ is None else [id_])
    if id_ is not None:
        assert target in run.errors[0].text()
