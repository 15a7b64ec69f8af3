# SPDX-License-Identifier: MIT
"""Random expressions in the main program and in a realtime cycle, against a second opinion.

The same text is decoded, and run in the tick; both must agree with ``slow_expressions.py`` to the
last bit, in their faults too.
"""

from __future__ import annotations

import pytest
from hypothesis import example, given, settings
from support.insides import machine_of
from support.slow_expressions import (
    FaultError,
    Tree,
    all_leaves,
    cost_of,
    result_of,
    synchronous_leaves,
    text_of,
    trees,
    values,
)

from nctakt.base.mode import is_compiled
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText

pytestmark = pytest.mark.slow

DEMO = load_machine(None)
often = settings(
    max_examples=150 if is_compiled() else 40, deadline=None, derandomize=True, database=None
)

#: Numbers of the decoder's faults that neither all functions (21241) nor all operators have.
NUMBERS = {
    **dict.fromkeys(("=", "EXP", "DEXP"), 21739),
    **dict.fromkeys(("LN", "LOG"), 20399),
    **dict.fromkeys(("&", "|", "^"), 20978),
    **{"SQRT": 20398, "INV": 20396},
}
#: Operations whose fault is a wrong argument of a function in the decoder.
FUNCTIONS = ("SQRT", "EXP", "DEXP", "LN", "LOG", "SIN", "COS", "TAN", "COT", "ASIN", "ACOS", "INV")


def frozen_of(tree: Tree) -> set[int]:
    """The elements that a tree uses as parameters."""
    if tree[0] == "frozen":
        return {tree[1]}
    return {k for part in tree[1:] if isinstance(part, tuple) for k in frozen_of(part)}


def perform(tree: Tree, numbers: list[float], body: str) -> tuple[Controller, list[str]]:
    """Run a program around the expression: the controller, and its errors as texts."""
    parameters = [f"P{k + 1} = V.E.LIST[{k}]" for k in sorted(frozen_of(tree))]
    controller = Controller(DEMO)
    run = controller.run(
        NcText("p.nc", "\n".join([*parameters, body.replace("@", text_of(tree)), "M30"])),
        set={f"V.E.LIST[{k}]": number for k, number in enumerate(numbers)},
        ticks=60,
        memory_trace=False,
    )
    return controller, [f"{found.id} {found.text()}" for found in run.errors]


CYCLE = "#RT CYCLE\nV.E.VALUE = @\n#RT CYCLE END"
CONDITION = "#RT CYCLE\n$IF @\nV.E.COUNT = 1\n$ELSE\nV.E.COUNT = 2\n$ENDIF\n#RT CYCLE END"


@often
@given(trees(all_leaves), values)
@example(("unary", "-", ("binary", "**", ("number", "2"), ("number", "2"))), [0.0] * 10)
@example(("binary", "**", ("number", "2"), ("unary", "-", ("number", "1"))), [0.0] * 10)
@example(
    ("binary", "**", ("number", "2"), ("binary", "**", ("number", "3"), ("number", "2"))),
    [0.0] * 10,
)
@example(
    ("call", "ATAN2", ("unary", "-", ("number", "0")), ("unary", "-", ("number", "1"))), [0.0] * 10
)
@example(
    (
        *("call", "ATAN2", ("call", "COT", ("number", "0"))),
        ("binary", "MOD", ("number", "0"), ("list", ("number", "0"))),
    ),
    [0.0] * 10,
)
def test_a_realtime_cycle_computes_what_the_rules_say(tree: Tree, numbers: list[float]) -> None:
    """An assignment in a cycle has the value, or the fault, of RC-206 and RC-207."""
    controller, errors = perform(tree, numbers, CYCLE)
    try:
        expected = result_of(tree, numbers)
    except FaultError as fault:
        assert errors
        assert errors[0].startswith(f"50879 '{fault.operation}' ")
        assert controller.read("V.E.VALUE") == 0.0
    else:
        assert errors == []
        assert controller.read("V.E.VALUE") == expected


@often
@given(trees(all_leaves), values)
def test_the_decoder_computes_the_same(tree: Tree, numbers: list[float]) -> None:
    """The main program's expressions have the values of a cycle's; their faults stop decoding."""
    controller, errors = perform(tree, numbers, "V.E.VALUE = @")
    try:
        expected = result_of(tree, numbers)
    except FaultError as fault:
        assert len(errors) == 1
        id_ = NUMBERS.get(fault.operation, 20396)
        if fault.operation in (*FUNCTIONS, "ATAN2"):
            id_ = NUMBERS.get(fault.operation, 21241)
        assert errors[0].startswith(str(id_))
        assert fault.operation == "=" or fault.operation in errors[0]
    else:
        assert errors == []
        assert controller.read("V.E.VALUE") == expected


@often
@given(trees(all_leaves, size=5), values)
def test_a_condition_is_true_from_a_half_on(tree: Tree, numbers: list[float]) -> None:
    """A branch is taken when |value| >= 0.5, whatever nodes the condition is fused to (RC-202)."""
    controller, errors = perform(tree, numbers, CONDITION)
    try:
        truth = abs(result_of(tree, numbers)) >= 0.5
    except FaultError:
        assert errors
        assert controller.read("V.E.COUNT") == 0
    else:
        assert errors == []
        assert controller.read("V.E.COUNT") == (1 if truth else 2)


@often
@given(trees(synchronous_leaves, size=20), values)
def test_elementary_instructions_are_counted_on_the_tree(tree: Tree, numbers: list[float]) -> None:
    """A statement counts its operators, functions, accesses and itself, fused or not (RC-501)."""
    controller = Controller(DEMO)
    for k, number in enumerate(numbers):
        controller.write(f"V.E.LIST[{k}]", number)
    controller.start(NcText("p.nc", CYCLE.replace("@", text_of(tree)) + "\nM30"))
    controller.step(1)
    assert machine_of(controller).channels[0].context.steps == cost_of(tree) + 1


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2 + 3 * 4", 14),
        ("2 ** 3 ** 2", 512),
        ("-2 ** 2", -4),
        ("[-2] ** 2", 4),
        ("7 - 3 - 2", 2),
        ("100 / 10 / 5", 2),
        ("-7 MOD 3", -1),
        ("7 MOD -3", 1),
        ("NOT 0 + 1", 2),
        ("1 + 1 == 2", 1),
        ("6 & 3 ^ 1 | 8", 11),
        ("6 & 3 == 3", 0),
        ("1 | 2 && 0", 0),
        ("1 XOR 1 && 1", 0),
        ("1 || 1 XOR 1", 1),
        ("0.49 || 0.5", 1),
        ("ROUND[2.5] + ROUND[3.5] + ROUND[-0.5]", 6),
        ("INT[-1.5] + FLOOR[-1.5] + CEIL[-1.5]", -4),
        ("INV[5]", -6),
    ],
)
def test_operators_bind_as_the_table_says(text: str, value: float) -> None:
    """Precedence and associativity of RC-206, in both places."""
    for body in (f"V.E.VALUE = {text}", CYCLE.replace("@", text)):
        controller = Controller(DEMO)
        run = controller.run(NcText("p.nc", body + "\nM30"), memory_trace=False)
        assert run.errors == ()
        assert controller.read("V.E.VALUE") == value
