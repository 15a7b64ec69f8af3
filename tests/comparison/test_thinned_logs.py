# SPDX-License-Identifier: MIT
"""A log with more samples than a page shows: thinned, and reported (902844)."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy
import pytest

from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.comparison import Comparison
from nctakt.comparison.deviations import deviation_of
from nctakt.comparison.log import LogColumn, Samples
from nctakt.comparison.mapping import Pair
from nctakt.comparison.overlay import left_out
from nctakt.results.trace.sinks import Signal

PAIR = Pair(Signal("X.ACS.ACT_POS", "mm"), LogColumn("a", "", 1, 0), 1.0, 0.0, None, False)


@pytest.mark.parametrize(("samples", "kept"), [(200, 200), (202, 101), (1000, 125)])
def test_samples_that_are_left_out_are_reported(samples: int, kept: int) -> None:
    """Of 100 to keep: 200 stay; beyond, every other one goes until no more than 200 are left."""
    values = numpy.arange(samples, dtype=numpy.float64)
    curve = Curve(1000.0, values)
    stamps = 1000.0 * values
    found = deviation_of(PAIR, Samples(stamps, values), curve, Alignment(0.0), None, kept=100)
    assert found is not None
    assert found.overlaid is not None
    assert found.overlaid.times.tolist() == stamps[:: -(-samples // kept)].tolist()
    notes = left_out(cast(Comparison, SimpleNamespace(deviations=[found])))
    if kept == samples:
        assert notes == []
        return
    (note,) = notes
    assert note.id == 902844
    assert f"X.ACS.ACT_POS: the page shows {kept} of the log's {samples} samples" in note.text("en")
