# SPDX-License-Identifier: MIT
"""What the statements of a realtime cycle cost, in elementary instructions (RC-501).

Each count is added up by hand: a variable access, an operator, a function, an assignment, a
condition and an action are one each, constants are free.
"""

from __future__ import annotations

import pytest

from nctakt.run.controller import Controller, NcText


def cost(*lines: str) -> int:
    """The instructions of one run-through of a cycle with these lines; all variables are 0."""
    controller = Controller()
    head, end = "#RT CYCLE [ID = 1 SCOPE = GLOBAL]", "#RT CYCLE END"
    controller.start(NcText("cost.nc", "\n".join((head, *lines, end, "M30"))))
    controller.step()
    return controller.instructions_in_tick


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ((), 0),
        (("V.E.VALUE1 = 5",), 1),
        (("V.E.VALUE1 = -5",), 1),
        (("V.E.VALUE1 = PI",), 1),
        (("V.E.VALUE1 = V.E.VALUE",), 2),
        (("V.E.VALUE1 = 2 * V.E.VALUE",), 3),
        (("V.E.VALUE1 = -V.E.VALUE",), 3),
        (("V.E.VALUE1 = NOT V.E.VALUE",), 3),
        (("V.E.VALUE1 = SIN[V.E.VALUE]",), 3),
        (("V.E.VALUE1 = ATAN2[V.E.VALUE, 1]",), 3),
        (("V.E.VALUE1 = [[V.E.VALUE]]",), 2),
        (("V.E.VALUE1 = V.E.VALUE ** 2 + 3 * V.E.VALUE2 - 1",), 7),
        (("V.E.COUNT += 1",), 3),
        (("V.E.COUNT *= V.E.VALUE + 1",), 5),
        (("V.E.LIST[3] = 1",), 1),
        (("V.E.LIST[V.E.COUNT] = 1",), 2),
        (("V.E.LIST[V.E.COUNT + 1] = V.E.LIST[V.E.COUNT]",), 5),
        (("V.E.VALUE",), 1),
        (("V.RTG.OVERRIDE.VEL.CYCLE = 50",), 1),
        (("V.E.VALUE1 = V.RTA.ACS.ACT_POS.X",), 2),
        (("M100",), 1),
        (("M100 H101", "M102"), 3),
        (("V.E.VALUE1 = V.E.VALUE", "V.E.VALUE2 = V.E.VALUE + 1"), 5),
        (("$IF V.E.TRIGGER", "V.E.VALUE1 = 5", "$ENDIF"), 2),
        (("$IF V.E.TRIGGER == 0", "V.E.VALUE1 = 5", "$ENDIF"), 4),
        (("$IF ONCE V.E.TRIGGER == 1", "V.E.VALUE1 = 5", "$ENDIF"), 3),
        (("$IF EDGE V.E.TRIGGER == 0", "V.E.VALUE1 = 5", "$ENDIF"), 4),
        (("$IF V.E.VALUE > 1", "$ELSEIF V.E.VALUE > 0", "$ELSE", "M100", "$ENDIF"), 7),
        (("$IF V.E.VALUE < 1", "$ELSEIF V.E.VALUE > 0", "$ELSE", "M100", "$ENDIF"), 3),
        (("$IF V.E.VALUE && V.E.VALUE1", "$ENDIF"), 4),
        (("$IF 1 - V.E.VALUE || V.E.VALUE1 / 2", "$ENDIF"), 6),
    ],
)
def test_each_counted_node_is_one_instruction(lines: tuple[str, ...], expected: int) -> None:
    """RC-501: the count is fixed by the text; both sides of ``&&`` and ``||`` belong to it."""
    assert cost(*lines) == expected


def test_the_instructions_of_all_cycles_are_added() -> None:
    """RC-502: a tick's count is that of all cycles that ran in it; held ones cost nothing."""
    lines = [
        "#RT CYCLE [ID = 1]",
        "V.E.VALUE1 = V.E.VALUE",
        "#RT CYCLE END",
        "#RT CYCLE [ID = 2]",
        "V.E.COUNT += 1",
        "#RT CYCLE END",
        "#TIME 0.001",
        "#RT CYCLE HOLD [ID = 1]",
        "#TIME 0.001",
        "M30",
    ]
    controller = Controller()
    controller.start(NcText("two.nc", "\n".join(lines)))
    found = []
    for _ in range(3):
        controller.step()
        found.append(controller.instructions_in_tick)
    assert found == [5, 3, 0]
