# SPDX-License-Identifier: MIT
"""Compared numbers for a reader: six digits, more where the comparison would look false."""

from __future__ import annotations

import pytest

from nctakt.results.compared import Compared
from nctakt.results.compared_numbers import comparison_text, distance_text


@pytest.mark.parametrize(
    ("operator", "left", "right", "shown"),
    [
        (">", 150.26666666666665, 150.0, "150.267 > 150"),
        (">", 200.02699999999996, 200.0, "200.027 > 200"),
        (">", 200.0000004, 200.0, "200.0000004 > 200"),  # six and nine digits show 200 > 200
        (">", 199.9999996, 200.0, "199.9999996 > 200"),  # false, but not since both are the same
        ("==", 0.1 + 0.2, 0.3, "0.30000000000000004 == 0.3"),  # false: they differ
        ("!=", 1 / 3, 1 / 3, "0.333333 != 0.333333"),
        (">=", 12345678.5, 3, "12345678 >= 3"),  # no digit before the point is lost
        ("<", -0.0, 1e-9, "0 < 1e-09"),
        ("", 0.7071067811865475, 0.0, "0.707107"),
        ("", 0.4999999, 0.0, "0.4999999"),  # false: it is true from 0.5 on (RC-202)
        ("", -0.4999999, 0.0, "-0.4999999"),
        ("<", float("inf"), 1.0, "inf < 1"),
    ],
)
def test_a_comparison_is_short_and_stays_true(
    operator: str, left: float, right: float, shown: str
) -> None:
    """The numbers keep their order; the live page and the report have the same text."""
    assert comparison_text(operator, left, right) == shown
    assert str(Compared(operator, True, left, right)) == shown


def test_a_distance_has_six_digits() -> None:
    """What is nearest is never 0 away by rounding."""
    assert distance_text(0.033333333333331439) == "0.0333333"
    assert distance_text(1.2345678e-12) == "1.23457e-12"
