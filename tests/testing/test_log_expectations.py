# SPDX-License-Identifier: MIT
"""``; expect: X within 0.05 mm of machine.csv``: a signal stays near a machine's log."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.results.trace.sinks import file_sink
from nctakt.run.controller import Controller, NcText
from nctakt.testing.expectations import read_expectation, read_script
from nctakt.testing.queries import NcRun
from nctakt.testing.verdict import differences

PROGRAM = "G01 X20 Y5 F6000\nG01 X0 F{feed}\nM30\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the logs of two runs: with a feed of 3000 and 2990 mm/min."""
    for feed in (3000, 2990):
        sink = file_sink(tmp_path / f"{feed}.csv")
        Controller().run(NcText("part.nc", PROGRAM.format(feed=feed)), sinks=(sink,))
    return tmp_path


def wrong(folder: Path, expectation: str) -> list[str]:
    """Return what differs in the run with a feed of 3000 mm/min."""
    text = f"{PROGRAM.format(feed=3000)}; expect: {expectation}\n"
    script = read_script(folder / "part.nc", text)
    run = Controller().run(NcText("part.nc", text))
    return list(differences(NcRun(run), script.expectations, "part.nc", folder=folder))


@pytest.mark.parametrize(
    "expectation",
    [
        "X.ACS.ACT_POS within 0.000001 mm of 3000.csv",
        "X within 1 µm of 3000.csv; Y within 0 of 3000.csv",
        "X within 0.1 mm of 2990.csv",
    ],
)
def test_a_signal_stays_near_its_log(folder: Path, expectation: str) -> None:
    """The same run is at no distance; X falls behind by less than 0.1 mm, at 10 mm/min in 0.4 s."""
    assert wrong(folder, expectation) == []


def test_where_it_leaves_its_tolerance_is_reported(folder: Path) -> None:
    """With time and number of samples; 10 µm are 0.01 mm."""
    for limit in ("0.01", "0.01 mm", "10 µm"):
        (found,) = wrong(folder, f"X within {limit} of 2990.csv")
        assert found.startswith(f"part.nc:4: expect: X within {limit} of 2990.csv\n")
        assert "+ beyond from 0." in found
        assert " samples; " in found


@pytest.mark.parametrize(
    ("expectation", "number"),
    [
        ("X within 1 of none.csv", "9005"),
        ("X within 1 1/min of 3000.csv", "902518"),
        ("V.E.VALUE within 1 of 3000.csv", "902619"),
    ],
)
def test_what_cannot_be_compared_is_reported(folder: Path, expectation: str, number: str) -> None:
    """No such log, a unit of another quantity, a signal that the log lacks."""
    (found,) = wrong(folder, expectation)
    assert f"error {number}" in found


def test_a_log_whose_time_is_not_found(folder: Path) -> None:
    """902528 is beside the deviation: nothing moves in the log, so its time is the run's."""
    rows = "".join(f"{tick},{400.0}\n" for tick in range(10))
    (folder / "still.csv").write_text(f"time_ms,X.ACS.ACT_POS\n{rows}", "utf-8")
    (found,) = wrong(folder, "X within 1 of still.csv")
    assert "beyond from 0." in found
    assert "the time of the log is taken as that of the run: nothing moves in both" in found


def test_a_study_has_no_log() -> None:
    """Its runs differ by their inputs: 900660."""
    with pytest.raises(Failure, match="900660"):
        read_expectation("X within 1 of 3000.csv")
