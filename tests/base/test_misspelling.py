# SPDX-License-Identifier: MIT
"""What a misspelt name was meant for: only what is near enough, in its family, and alone."""

from __future__ import annotations

import pytest

from nctakt.base.misspelling import KnownNames, nearest, nearest_first

#: The known names; an unknown one; what it was meant for, empty for nothing.
CASES = (
    (("V.E.WORD", "V.E.COUNT"), "V.E.FORCE", ""),
    (("V.E.WORD", "V.E.COUNT"), "V.E.COUNTT", "V.E.COUNT"),
    (("V.E.WORD", "V.E.COUNT"), "v.e.count", "V.E.COUNT"),
    (("V.E.COUNT", "V.E.COUNTER"), "V.E.COUN", "V.E.COUNT"),
    (("V.E.COUNT_POS", "V.RTA.ACS.ACT_POS.X"), "X.ACS.ACT_POS", "V.RTA.ACS.ACT_POS.X"),
    (("V.E.COUNT_POS", "V.RTA.ACS.ACT_POS.X"), "V.RTA.ACT_POS.ACS.X", "V.RTA.ACS.ACT_POS.X"),
    (("V.A.ABS.X", "V.A.ABS.Y"), "V.A.ABSS.X", "V.A.ABS.X"),
    (("V.A.ABS.X", "V.A.ABS.Y"), "V.A.ABS.Z", ""),
    (("--quiet", "--out", "--where"), "--set", ""),
    (("--quiet", "--out", "--where"), "--quite", "--quiet"),
    (("COS", "SIN", "ABS"), "POS", ""),
    (("COS", "SIN", "ABS"), "SNI", "SIN"),
    (("M100", "M200"), "M1000", "M100"),
    (("M11", "M12"), "M13", ""),
    (("REAL64", "REAL32"), "REAL46", "REAL64"),
    (("start", "state"), "stat", "state"),
    (("first_a", "first_b"), "first_c", ""),
    (("X", "Y"), "Z", ""),
    (("duration",), "dur", ""),
    (("max_duration",), "max_dur", "max_duration"),
    (("CMDPOS", "AX"), "POS", "CMDPOS"),
    (("CMDPOS", "ACTPOS"), "POS", ""),
    (("FEED_FACT", "RAPID_FACT"), "FEED", "FEED_FACT"),
    (("SPEED_FACT", "RAPID_FACT"), "FACT", ""),
    ((), "anything", ""),
)


@pytest.mark.parametrize(("known", "name", "meant"), CASES)
def test_only_a_name_that_was_meant_is_suggested(
    known: tuple[str, ...], name: str, meant: str
) -> None:
    assert nearest(name, known) == meant


def test_an_index_of_names_finds_what_a_search_finds() -> None:
    """For errors of typing; paths and beginnings are no matter of the index."""
    known = KnownNames(("rt_cycles.max_duration", "rt_cycles.enable", "kopf.achs_nr"))
    assert known.nearest("rt_cycles.max_duraton") == "rt_cycles.max_duration"
    assert known.nearest("rt_cycles.enabel") == "rt_cycles.enable"
    assert known.nearest("rt_cycles.limit") is None


def test_the_name_that_was_meant_comes_first() -> None:
    assert nearest_first("globl", ("BLOCK", "PROG", "GLOBAL")) == ["GLOBAL", "BLOCK", "PROG"]
    assert nearest_first("x", ("BLOCK", "PROG")) == ["BLOCK", "PROG"]
