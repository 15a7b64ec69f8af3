# SPDX-License-Identifier: MIT
"""Logs of runs with one known change: the search names it and its value.

A curve of another run is the log itself, so that the distance of the right change is nought.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.script import Plc
from nctakt.proposals.changes import Change, changes_by_axis, changes_of
from nctakt.proposals.nearer import Proposal, Proposals
from nctakt.proposals.report import proposals_document, proposals_text
from nctakt.results.trace.sinks import CsvSink
from nctakt.run.controller import Controller
from nctakt.studies.plans.changed_lists import changed_machine
from nctakt.studies.plans.faults import FaultyPlc, PlcFaults

PART = "G01 X100 F20000\nM10\nG01 Y50 F10000\nG02 X150 Y100 I50 J0\nG00 X0 Y0\nM30\n"
SIGNALS = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "PATH.SPEED"]


@pytest.fixture(autouse=True)
def _part(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PART, "utf-8")


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("target", "owners", "value"),
    [
        ("HLI.OVERRIDE", [], 80.0),
        ("P-AXIS-00008", ["X", "Y"], 2500.0),
        ("P-AXIS-00008", ["Y"], 1500.0),
        ("P-AXIS-00209", ["X", "Y"], 200_000.0),
        ("P-AXIS-00212", ["X", "Y"], 150_000.0),
        ("M10", [], 42_000.0),
    ],
)
def test_the_change_is_found(
    target: str, owners: list[str], value: float, capsys: pytest.CaptureFixture[str]
) -> None:
    """The first proposal is the change that was made, and leaves (almost) nothing."""
    machine = load_machine(None)
    if owners:
        machine = changed_machine(machine, {(target, owner): value for owner in owners})
    plc = FaultyPlc(Plc(), PlcFaults({target: value})) if target == "M10" else None
    start = {target: value} if target == "HLI.OVERRIDE" else {}
    with Path("log.csv").open("w", encoding="utf-8", newline="") as file:
        sinks = [CsvSink(file)]
        Controller(machine).run("part.nc", signals=SIGNALS, sinks=sinks, plc=plc, set=start)
    words = ["compare", "log.csv", "part.nc", "--propose", "--format", "json", "--quiet"]
    assert main(words) == 0
    found = json.loads(capsys.readouterr().out)["comparison"]["proposals"]["found"]
    assert (found[0]["target"], found[0]["of"]) == (target, owners)
    assert found[0]["value"] == pytest.approx(value, rel=0.01)
    assert found[0]["distance"] < 1e-3


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("target", "value", "others"),
    [
        ("P-AXIS-00196", 20_000.0, set()),
        ("P-AXIS-00196", 200_000.0, set()),
        ("P-AXIS-00198", 100_000.0, {"P-AXIS-00195", "P-AXIS-00197"}),
    ],
)
def test_another_jerk_is_found_or_one_of_several(
    target: str, value: float, others: set[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """The slowest ramp makes the jerk of a path: a log does not say which of three it is."""
    Path("part.nc").write_text(f"#SLOPE [TYPE=TRAPEZ]\n{PART}", "utf-8")
    machine = changed_machine(load_machine(None), {(target, axis): value for axis in "XY"})
    with Path("log.csv").open("w", encoding="utf-8", newline="") as file:
        Controller(machine).run("part.nc", signals=SIGNALS, sinks=[CsvSink(file)])
    words = ["compare", "log.csv", "part.nc", "--propose", "--format", "json", "--quiet"]
    assert main(words) == 0
    proposals = json.loads(capsys.readouterr().out)["comparison"]["proposals"]
    first = proposals["found"][: proposals["equal"]]
    assert {one["target"] for one in first} == {target, *others}
    assert ["X", "Y"] in [one["of"] for one in first if one["target"] == target]
    for one in first:
        assert one["value"] == pytest.approx(value, rel=0.01)
        assert one["distance"] < 1e-3


@pytest.mark.nightly
def test_another_tolerance_of_corners_is_found(capsys: pytest.CaptureFixture[str]) -> None:
    """P-CHAN-00122 counts in ``#HSC ON`` without PATH_DEV: 2 mm instead of 0.2 mm, nothing else."""
    Path("part.nc").write_text("#HSC ON\nG01 X50 F10000\nY50\nX0\nY0\n#HSC OFF\nM30\n", "utf-8")
    machine = changed_machine(load_machine(None), {("P-CHAN-00122", "1"): 20_000.0})
    with Path("log.csv").open("w", encoding="utf-8", newline="") as file:
        Controller(machine).run("part.nc", signals=SIGNALS, sinks=[CsvSink(file)])
    words = ["compare", "log.csv", "part.nc", "--propose", "--format", "json", "--quiet"]
    assert main(words) == 0
    proposals = json.loads(capsys.readouterr().out)["comparison"]["proposals"]
    first = proposals["found"][0]
    assert (first["target"], first["of"], proposals["equal"]) == ("P-CHAN-00122", ["1"], 1)
    assert first["present"] == 2000.0
    assert first["value"] == pytest.approx(20_000.0, rel=0.01)
    assert first["distance"] < 1e-3


@pytest.mark.parametrize(
    ("target", "values"), [("P-CHAN-00059", (500, 90_000)), ("P-CHAN-00060", (1, 900))]
)
def test_a_tolerance_of_arcs_changes_no_curve(target: str, values: tuple[float, float]) -> None:
    """The centre is off by 4 µm: moved by as much with any tolerance, and refused beyond it."""
    Path("part.nc").write_text("G01 X10 F6000\nG02 X30 I10.004\nM30\n", "utf-8")
    curves = []
    for value in (None, *values):
        machine = load_machine(None)
        if value is not None:
            machine = changed_machine(machine, {(target, "1"): float(value)})
        run = Controller(machine).run("part.nc", signals=SIGNALS)
        assert not run.errors
        assert run.trace is not None
        curves.append([run.trace[name].tobytes() for name in SIGNALS])
    assert curves[0] == curves[1] == curves[2]
    machine = changed_machine(
        load_machine(None), {(target, "1"): 0.0 if target.endswith("59") else 1.0}
    )
    Path("part.nc").write_text("G01 X10 F6000\nG02 X30 I10.2\nM30\n", "utf-8")
    run = Controller(machine).run("part.nc", signals=SIGNALS)
    assert [one.id for one in run.errors] == [20035]


def proposed(target: str, distance: float) -> Proposal:
    """A proposal of 80 instead of 50 for an axis."""
    return Proposal(Change("parameter", target, ("X",), 50.0, 50.0, "µs"), 80.0, distance)


@pytest.mark.parametrize(
    ("distances", "equal"), [((), 0), ((0.1,), 1), ((0.1, 0.103), 1), ((0.1, 0.102, 0.2), 2)]
)
def test_what_comes_equally_near_is_reported(distances: tuple[float, ...], equal: int) -> None:
    """Up to 2 % more than the first one is as near: then the log does not choose."""
    found = [proposed(f"P-AXIS-0019{n}", one) for n, one in enumerate(distances, 5)]
    proposals = Proposals(0.5, 20, found)
    assert proposals.equal == equal
    assert proposals_document(proposals)["equal"] == equal
    text = proposals_text(proposals, "en")
    assert ("The first 2 come equally near: the log does not say which" in text) is (equal == 2)


def test_what_is_tried() -> None:
    """Override, the axes' dynamics together and each alone, the path's limits, functions."""
    machine = load_machine(None)
    changes = list(changes_of(machine, ["X", "Y"], ["M10"], 90.0, 1000))
    assert changes[0] == Change("variable", "HLI.OVERRIDE", (), 90.0, 90.0, "%", 0.1)
    assert changes[-1] == Change("function", "M10", (), 0.0, 0.0, "ms", 1000)
    by_target = {change.target: change for change in changes}
    together = by_target["P-AXIS-00008"]
    assert (together.of, together.present) == (("X", "Y"), 4000.0)
    assert [one.of for one in changes_by_axis(machine, together)] == [("X",), ("Y",)]
    assert by_target["P-AXIS-00196"].present == 50_000.0
    assert {"P-CHAN-00002", "P-CHAN-00361", "P-CHAN-00122"} <= by_target.keys()


def test_a_run_that_is_the_log_gets_no_proposal(capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing comes nearer than a distance of nought."""
    Path("part.nc").write_text("G01 X1 F6000\nM30\n", "utf-8")
    with Path("log.csv").open("w", encoding="utf-8", newline="") as file:
        Controller().run("part.nc", signals=SIGNALS[:1], sinks=[CsvSink(file)])
    assert main(["compare", "log.csv", "part.nc", "--propose", "--lang", "de", "--quiet"]) == 0
    assert "Keine einzelne Änderung" in capsys.readouterr().out
