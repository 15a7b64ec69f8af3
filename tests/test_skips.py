# SPDX-License-Identifier: MIT
"""No test is left out in silence: CI fails, other runs say at their end what was missing."""

from __future__ import annotations

import pytest
from support import skips


def report(reason: str) -> pytest.CollectReport:
    """A file of tests that is skipped for a reason."""
    return pytest.CollectReport("tests/x.py", "skipped", ("x.py", 1, f"Skipped: {reason}"), [])


@pytest.mark.parametrize(
    ("reason", "outcome"),
    [
        ("Chromium is not installed", "failed"),
        ("could not import 'toppra': No module named 'toppra'", "failed"),
        ("compiled methods cannot be called", "skipped"),
    ],
)
def test_ci_permits_a_skip_only_for_a_reason_of_the_table(
    monkeypatch: pytest.MonkeyPatch, reason: str, outcome: str
) -> None:
    """A missing program is a failure there; what the other mode asks is not."""
    monkeypatch.setattr(skips, "IS_CI", True)
    found = report(reason)
    skips.refuse(found)
    assert found.outcome == outcome


def test_other_runs_say_what_was_missing_and_how_to_get_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each reason once with its count; what is permitted is not missing."""
    monkeypatch.setattr(skips, "IS_CI", False)
    reports = [report(reason) for reason in ("no browser", "no browser", "not compiled")]
    for one in reports:
        skips.refuse(one)
    assert [one.outcome for one in reports] == ["skipped"] * 3
    assert [line.split() for line in skips.summary(reports)[:-1]] == [["2", "no", "browser"]]
    assert skips.summary(reports[2:]) == []
