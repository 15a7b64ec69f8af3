# SPDX-License-Identifier: MIT
"""What each kind of dimension does to a run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.studies.study import Study

MOVE = "M8\nG01 X10 F6000\nM30\n"


def rows(folder: Path, vary: dict[str, Any], text: str = MOVE, **entries: Any) -> list[Any]:
    """The durations of the runs of a dimension, in milliseconds."""
    path = folder / "part.nc"
    path.write_text(text)
    study = Study(
        program=str(path), until="3 s", vary=[vary], measure={"time": "duration"}, **entries
    )
    return [round(row["time"] * 1000) for row in study.run().rows]


def test_acknowledgements_come_late_never_and_twice(tmp_path: Path) -> None:
    """The block after M8 ends when both its way and the acknowledgement are over."""
    vary = {"acknowledge": "M8", "values": ["0 ms", "300 ms", "400 ms", "never", "twice"]}
    at_once, late, later, never, twice = rows(tmp_path, vary)
    assert late > at_once
    assert (later - late, never, twice) == (100, 3000, at_once)


def test_a_plc_dies_and_returns(tmp_path: Path) -> None:
    """A dead PLC acknowledges nothing; when it returns the program goes on."""
    assert rows(tmp_path, {"plc_dies": "yes", "values": ["0 ms"]}) == [3000]
    path = tmp_path / "part.nc"
    study = Study(
        program=str(path),
        until="3 s",
        vary=[
            {"plc_dies": "yes", "values": ["0 ms"]},
            {"plc_returns": "yes", "values": ["100 ms", "200 ms"]},
        ],
    )
    first, second = study.run().column("ticks")
    assert second - first == 100


def test_parameters_of_lists(tmp_path: Path) -> None:
    """P-AXIS-00008 is the acceleration in mm/s²: 100 mm/s take 100 ms at 1000 mm/s²."""
    vary = {"parameter": "P-AXIS-00008", "of": "X", "values": [1000, 10000]}
    slow, fast = rows(
        tmp_path,
        vary,
        "G01 X100 F6000\nM30\n",
    )
    assert slow - fast == 90


def test_unknown_parameters_are_reported(tmp_path: Path) -> None:
    """The axis and the ID are looked up before any run."""
    wrong = ({"of": "Q"}, {"parameter": "P-AXIS-99999", "of": "X"})
    for entry in wrong:
        vary = {"parameter": "P-AXIS-00008", "values": [1], **entry}
        with pytest.raises(Failure) as raised:
            rows(tmp_path, vary)
        assert raised.value.diagnostics[0].id == 901312


def test_values_that_a_list_does_not_take_are_reported(tmp_path: Path) -> None:
    """A study does not run with another value than that of its row."""
    vary = {"parameter": "P-AXIS-00008", "of": "X", "values": [1000, -5]}
    with pytest.raises(Failure) as raised:
        rows(tmp_path, vary)
    assert "a_max" in raised.value.diagnostics[0].text()


def test_variables_of_the_program(tmp_path: Path) -> None:
    """The number that the program assigns first is replaced."""
    text = "V.P.WAY = 10\nG01 X[V.P.WAY] F6000\nM30\n"
    short, long = rows(tmp_path, {"program_variable": "V.P.WAY", "values": [10, 20]}, text)
    assert long - short == 100


def test_a_program_variable_is_set_where_the_program_does(tmp_path: Path) -> None:
    """Not in a comment, not in a longer name; small numbers have no exponent."""
    text = (
        "; V.P.WAY = 1\nV.P.WAY_2 = 4 (V.P.WAY = 2)\nV.P.WAY = 3\n"
        "G01 X[V.P.WAY * 1000000] F6000\nM30\n"
    )
    short, long = rows(tmp_path, {"program_variable": "V.P.WAY", "values": [1e-05, 2e-05]}, text)
    assert long - short == 100


def test_overrides_noise_and_series(tmp_path: Path) -> None:
    """An override as a value, as a ramp; a noise belongs to its seed; a series is a file."""
    text = "G01 X100 F6000\nM30\n"
    half, full = rows(tmp_path, {"variable": "HLI.OVERRIDE", "values": [50, 100]}, text, set={})
    assert half > full
    ramp = {"variable": "HLI.OVERRIDE", "values": [100], "rest": 50, "over": "500 ms"}
    assert full < rows(tmp_path, ramp, text)[0] < half
    noise = {"noise": "HLI.OVERRIDE", "values": [1, 1, 2], "rest": 60, "amount": 30, "for": "1 s"}
    first, again, other = rows(tmp_path, noise, text)
    assert first == again != other
    (tmp_path / "way.csv").write_text("time,HLI.OVERRIDE\n0 s,50\n")
    series = {"series": "way", "values": [str(tmp_path / "way.csv")]}
    assert rows(tmp_path, series, text)[0] == pytest.approx(half, abs=2)
