# SPDX-License-Identifier: MIT
"""Traces as MF4 files, and logs in MF4 and Parquet that are laid beside a run."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.comparison.log_file import open_log
from nctakt.files.access import FileAccess
from nctakt.results.trace import measurement
from nctakt.run.controller import Controller, NcText

asammdf = pytest.importorskip("asammdf", reason="MF4 needs asammdf (extra measure)")
pytestmark = pytest.mark.filterwarnings("default")

TEXT = "M100\nG01 X10 F6000\nM30\n"
SIGNALS = ["X.ACS.ACT_POS", "BLOCK"]


def write(file: Path) -> None:
    """Write the trace of a run."""
    controller = Controller()
    sink = measurement.Mf4Sink(file)
    controller.run(NcText("part.nc", TEXT), sinks=(sink,), signals=SIGNALS)


def test_an_mf4_file_has_values_units_and_events(tmp_path: Path) -> None:
    """As its own library reads it: the bits of the trace, at the seconds of the ticks."""
    write(tmp_path / "a.mf4")
    run = Controller().run(NcText("part.nc", TEXT), signals=SIGNALS)
    with asammdf.MDF(tmp_path / "a.mf4") as measured:
        position = measured.get("X.ACS.ACT_POS")
        assert position.unit == "mm"
        np.testing.assert_array_equal(position.samples, run.trace["X.ACS.ACT_POS"])
        np.testing.assert_array_equal(position.timestamps, np.arange(run.ticks) * 1000 / 1e6)
        np.testing.assert_array_equal(measured.get("BLOCK").samples, run.trace["BLOCK"])
        events = measured.get("events")
        assert b"M 100" in events.samples[0]
        assert events.timestamps[0] == 0.0


def test_pieces_and_repetitions_give_the_same_bytes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No clock is in it; a long trace is written in pieces and reads as one."""
    write(tmp_path / "a.mf4")
    write(tmp_path / "b.mf4")
    assert (tmp_path / "a.mf4").read_bytes() == (tmp_path / "b.mf4").read_bytes()
    monkeypatch.setattr(measurement, "_GROUP", 10)
    write(tmp_path / "c.mf4")
    with asammdf.MDF(tmp_path / "a.mf4") as one, asammdf.MDF(tmp_path / "c.mf4") as other:
        for name in SIGNALS:
            np.testing.assert_array_equal(one.get(name).samples, other.get(name).samples)
            np.testing.assert_array_equal(one.get(name).timestamps, other.get(name).timestamps)


def test_logs_of_measuring_tools_have_time_bases_and_units_of_their_own(tmp_path: Path) -> None:
    """Each group its stamps, from the begin of the measurement; texts are no signals."""
    measured = asammdf.MDF(version="4.10")
    fast, slow = np.arange(5) * 0.001 + 0.5, np.arange(2) * 0.01
    measured.append([asammdf.Signal(np.arange(5), fast, name="Axis X ActPos", unit="m")])
    measured.append([asammdf.Signal(np.array([1.5, 2.5]), slow, name="Force", unit="N")])
    measured.append([asammdf.Signal(np.array([b"a", b"b"]), slow, name="t", encoding="utf-8")])
    measured.save(tmp_path / "log.mf4")
    measured.close()
    log = open_log(tmp_path / "log.mf4", FileAccess())
    assert [(one.name, one.unit) for one in log.columns] == [("Axis X ActPos", "m"), ("Force", "N")]
    position, force = log.read(log.columns)
    np.testing.assert_allclose(position.times[:], [5e5, 5.01e5, 5.02e5, 5.03e5, 5.04e5])
    assert position.values[:].tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert (force.times[:].tolist(), force.values[:].tolist()) == ([0.0, 10_000.0], [1.5, 2.5])


def test_parquet_tables_have_stamps_and_units(tmp_path: Path) -> None:
    """Stamps by their name and unit; empty cells are no samples, and the zero is the table's."""
    arrow = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    table = arrow.table({
        "time_ms": [5.0, 6.0, 7.0], "X [m]": [None, 0.5, 0.6], "name": ["a", "b", "c"],
        "S": arrow.array([1, 2, 3], arrow.int32()),
    })  # fmt: skip
    parquet.write_table(table, tmp_path / "log.parquet")
    log = open_log(tmp_path / "log.parquet", FileAccess())
    assert [(one.name, one.unit) for one in log.columns] == [("X", "m"), ("S", "")]
    x, s = log.read(log.columns)
    assert (x.times[:].tolist(), x.values[:].tolist()) == ([1000.0, 2000.0], [0.5, 0.6])
    assert s.times[:].tolist() == [0.0, 1000.0, 2000.0]
    parquet.write_table(arrow.table({"X": [1.0]}), tmp_path / "none.parquet")
    with pytest.raises(Failure, match="902511"):
        open_log(tmp_path / "none.parquet", FileAccess())
    for name in ("bad.parquet", "bad.mf4"):
        (tmp_path / name).write_bytes(b"no such file")
        with pytest.raises(Failure, match="902510"):
            open_log(tmp_path / name, FileAccess())


@pytest.mark.parametrize("ending", ["mf4", "parquet"])
def test_a_trace_is_a_log_of_its_run(
    tmp_path: Path, ending: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """``nctakt run --trace`` and ``nctakt compare`` of it: no deviation at all."""
    program = tmp_path / "part.nc"
    program.write_text(TEXT, "utf-8")
    log = str(tmp_path / f"log.{ending}")
    assert main(["run", str(program), "--trace", log, "--quiet"]) == 0
    assert main(["compare", log, str(program), "--tolerance", "0"]) == 0
    assert "X.ACS.ACT_POS" in capsys.readouterr().out
