# SPDX-License-Identifier: MIT
"""Macros whose text cannot be used: told at the block that uses them."""

from __future__ import annotations

import pytest

from nctakt.controller import Controller, NcText


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ('"A"', 900319),
        ('"a" = "X1"\n"A"', 900319),
        ('"A" = "X1 :::"\n"A"', 900100),
        ('"A" = "Q1"\n"A"', 900203),
        ('"A" = "G33"\nX1 "A"', 900200),
        ('"A" = "V.P.X"\n"A"', 900314),
    ],
)
def test_a_macro_that_cannot_be_used_ends_the_program(text: str, error: int) -> None:
    """Facts 2.1: case counts; the text is checked like any other."""
    run = Controller().run(NcText("p.nc", text + "\nM30\n"))
    (found,) = run.errors
    assert found.id == error
    assert found.span is not None
    assert found.span.line == text.count("\n") + 1
    assert found.render("de")
