# SPDX-License-Identifier: MIT
"""The conditions that have a lane in the scope, and which of them fit a filter."""

import pytest

from nctakt.live.conditions import MAX_CONDITIONS, Condition, conditions_of, fitting

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.VALUE > 12
    M100
  $ELSEIF EDGE V.E.OTHER == 3
  $ENDIF
#RT CYCLE END
#RT CYCLE [SCOPE=PROG ID = 17]
  N5 $IF V.E.VALUE < 2
  $ENDIF
#RT CYCLE END
$IF V.E.VALUE == 5
$ENDIF
#RT CYCLE
  $IF V.E.LIST[2] > 1
  $ENDIF
#RT CYCLE END
"""

#: Lines 2, 4, 8 and 14, by hand.
FOUND = [
    Condition(2, "1", "$IF V.E.VALUE > 12"),
    Condition(4, "1", "$ELSEIF EDGE V.E.OTHER == 3"),
    Condition(8, "17", "N5 $IF V.E.VALUE < 2"),
    Condition(14, "", "$IF V.E.LIST[2] > 1"),
]


def test_conditions_are_those_in_realtime_cycles() -> None:
    """With line and ID of the cycle; a condition of the program itself has no lane."""
    assert conditions_of(PROGRAM.splitlines()) == FOUND


@pytest.mark.parametrize(
    ("wish", "places"),
    [
        ("", [0, 1, 2, 3]),
        ("  ", [0, 1, 2, 3]),
        ("2", [0]),
        ("4-13", [1, 2]),
        ("13-4", []),
        ("#1", [0, 1]),
        ("#17", [2]),
        ("value", [0, 2]),
        ("value #1", [0]),
        ('"12"', [0]),
        ('"12', [0]),
        ('"> 1"', [0, 3]),
        ("#", []),
        ("[2]", [3]),
        ("nothing", []),
        ("9" * 5000, []),
        ("²", []),
    ],
)
def test_all_words_of_a_filter_must_fit(wish: str, places: list[int]) -> None:
    """Line, range of lines, cycle, text in any case; what is quoted is a text."""
    assert fitting(FOUND, wish) == places


def test_of_many_conditions_the_first_ones_have_lanes() -> None:
    """A hundred of them; a program of 10^6 lines without any has none."""
    cycle = ["#RT CYCLE [ID=1]", *["$IF V.E.A > 1", "$ENDIF"] * (MAX_CONDITIONS + 1)]
    assert [one.line for one in conditions_of(cycle)][-1] == 2 * MAX_CONDITIONS
    assert conditions_of(["G01 X1"] * 1_000_000) == []
    assert fitting([], "12") == []
