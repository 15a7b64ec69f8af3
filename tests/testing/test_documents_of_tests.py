# SPDX-License-Identifier: MIT
"""docs/testing.md and docs/plc.md show the examples as they are."""

from __future__ import annotations

import re
from pathlib import Path

from nctakt.plc import load_plc
from nctakt.run.controller import Controller

ROOT = Path(__file__).parent.parent.parent
EXAMPLES = ROOT / "examples"


def fences(name: str) -> list[str]:
    """The fenced blocks of a document."""
    text = (ROOT / "docs" / name).read_text("utf-8")
    return re.findall(r"^```\w*\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def test_the_program_and_the_tests_are_those_of_the_example_project() -> None:
    """Letter by letter."""
    program, _, tests = fences("testing.md")
    assert program == (EXAMPLES / "testing" / "programs" / "crossing.nc").read_text("utf-8")
    assert tests == (EXAMPLES / "testing" / "tests" / "test_crossing.py").read_text("utf-8")


def test_the_plc_is_the_example_and_does_what_it_says() -> None:
    """Feed hold from 0.1 s to 0.15 s, half the speed from 0.5 s, a fifth of it beyond 400 mm.

    It declares all that it waits for, so that no tick calls it for nothing.
    """
    shown, *_ = fences("plc.md")
    assert (EXAMPLES / "cell_plc.py").read_text("utf-8").endswith(shown)
    names = ["X.ACS.ACT_POS", "HLI.OVERRIDE", "HLI.FEED_HOLD", "V.E.CONDITION"]
    run = Controller().run(
        EXAMPLES / "crossing.nc", plc=load_plc(EXAMPLES / "cell_plc.py"), signals=names
    )
    assert run.state == "ended"
    trace = run.trace
    assert trace is not None
    hold = trace["HLI.FEED_HOLD"].tolist()
    assert (hold.index(1.0), 150 - hold[::-1].index(1.0) + len(hold) - 150) == (100, 150)
    override = trace["HLI.OVERRIDE"].tolist()
    assert override.index(50.0) == 500
    beyond = next(i for i, x in enumerate(trace["X.ACS.ACT_POS"].tolist()) if x > 400)
    assert override.index(20.0) == beyond + 1
    assert trace["V.E.CONDITION"].tolist()[-1] == 1.0
