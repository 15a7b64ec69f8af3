# SPDX-License-Identifier: MIT
"""Sessions of two channels go back over waits and signals, and their ticks are the same again."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt import NcText
from nctakt.session import Session

pytestmark = pytest.mark.slow

MACHINE = Path(__file__).parents[1] / "runs" / "two_channels" / "machine"
ONE = NcText(
    "one.nc",
    "%one\nG04 0.005\n#SIGNAL SYN [ID=1 P[0]=7 CH=2]\n#WAIT SYN [ID=2 CH=2]\nG01 X1 F600\n"
    "#WAIT FOR V.E.SHARED > 7\nM30\n",
)
TWO = NcText(
    "two.nc",
    "%two\n#WAIT [ID=1 P[0]=P1 CH=1]\nG04 0.003\n#SIGNAL SYN [ID=2 CH=1]\nG04 0.02\n"
    "V.E.SHARED = P1 + 1\n#WAIT [ID=9 CH=1]\nM30\n",
)
NAMES = ("CH1.X.ACS.ACT_POS", "V.E.SHARED")


def test_each_tick_is_the_same_when_it_comes_again() -> None:
    """Over the waits of both levels; what each channel waits for is known at each tick."""
    with Session(ONE, channels={2: [TWO]}, machine=MACHINE, until="60 ticks") as session:
        first = []
        for _ in range(50):
            session.step(1)
            state_view = session.state_view(*NAMES)
            shown = [one.awaited and one.awaited.en for one in state_view.channels]
            first.append((state_view.tick, state_view.values, shown))
        assert first[3][2] == [None, "signal 1 of channel 1 (since 0.000000 s)"]
        assert first[6][2] == ["signal 2 of channel 2 (since 0.005000 s)", None]
        assert first[45][2][1] == "signal 9 of channel 1 (since 0.006000 s)"
        for tick in (44, 8, 6, 2, 30):
            session.go_to(tick)
            state_view = session.state_view(*NAMES)
            shown = [one.awaited and one.awaited.en for one in state_view.channels]
            assert (state_view.tick, state_view.values, shown) == first[tick - 1]
        session.go_to(3)
        for before in first[3:]:
            session.step(1)
            state_view = session.state_view(*NAMES)
            shown = [one.awaited and one.awaited.en for one in state_view.channels]
            assert (state_view.tick, state_view.values, shown) == before
