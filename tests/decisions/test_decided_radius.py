# SPDX-License-Identifier: MIT
"""G163: the radius of arcs, as R gives it (facts 2.6)."""

from __future__ import annotations

import pytest
from support.decided import numbers, perform

ARC = "G17 F6000\nG02 {words}\nG02 X40 Y0\nM30"


@pytest.mark.parametrize("words", ["G163=10 X20 Y0", "G163=P1 X20 Y0"])
def test_g163_is_modal_as_r(words: str) -> None:
    """Two half circles of 10 mm: the same positions in each tick as with R10."""
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    one = perform("P1=10\n" + ARC.format(words=words), signals=signals)
    other = perform("P1=10\n" + ARC.format(words="R10 X20 Y0"), signals=signals)
    assert not one.errors
    assert one.trace is not None
    assert other.trace is not None
    for signal in signals:
        assert one.trace[signal].tolist() == other.trace[signal].tolist()


def test_a_radius_that_is_none() -> None:
    """As R: 0 is no radius (20036); a G163 without value is reported before the run."""
    assert numbers(perform(ARC.format(words="G163=0 X20"))) == [20036]
    assert numbers(perform("G163\nM30")) == [900927]
