# SPDX-License-Identifier: MIT
"""Traces as tables: the same values and events in memory and in a Parquet file."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.run.controller import Controller, NcText

TEXT = "M100\nG01 X10 F6000\nM30\n"


def test_a_table_has_the_values_and_events_of_the_trace() -> None:
    """A row per tick, integral signals as whole numbers."""
    pytest.importorskip("pyarrow")
    run = Controller().run(NcText("part.nc", TEXT))
    table = run.to_arrow()
    assert run.trace is not None
    assert table.column("X.ACS.ACT_POS").to_pylist() == run.trace["X.ACS.ACT_POS"].tolist()
    assert table.column("tick").to_pylist() == list(range(run.ticks))
    assert str(table.schema.field("BLOCK").type) == "int64"
    assert sum("M 100" in text for text in table.column("events").to_pylist()) == 1


def test_the_file_of_a_run_is_its_table(tmp_path: Path) -> None:
    """``--trace`` with the ending .parquet."""
    parquet = pytest.importorskip("pyarrow.parquet")
    program, file = tmp_path / "part.nc", tmp_path / "out.parquet"
    program.write_text(TEXT)
    assert main(["run", str(program), "--trace", str(file), "--quiet"]) == 0
    written = parquet.read_table(file)
    run = Controller().run(program)
    assert written.drop_columns(["events"]).equals(run.to_arrow().drop_columns(["events"]))
    assert written.schema.metadata[b"cycle_time_us"] == b"1000"


def test_frames_of_other_packages() -> None:
    """pandas and polars have the same columns."""
    pytest.importorskip("pyarrow")
    run = Controller().run(NcText("part.nc", TEXT))
    for package, frame in (("pandas", run.to_pandas), ("polars", run.to_polars)):
        pytest.importorskip(package)
        assert len(frame()) == run.ticks


def test_columns_have_their_units() -> None:
    """In the metadata of a field in Arrow, in ``attrs`` of a pandas frame."""
    pytest.importorskip("pyarrow")
    pytest.importorskip("pandas")
    run = Controller().run(NcText("part.nc", TEXT), signals=["X.ACS.ACT_POS", "BLOCK"])
    schema = run.to_arrow().schema
    units = [(one.name, (one.metadata or {}).get(b"unit")) for one in schema]
    assert units == [
        ("tick", None), ("time_us", b"us"), ("X.ACS.ACT_POS", b"mm"), ("BLOCK", None),
        ("events", None),
    ]  # fmt: skip
    assert run.to_pandas().attrs["units"] == {"time_us": "us", "X.ACS.ACT_POS": "mm"}


def test_a_run_without_a_trace_has_no_table() -> None:
    """901350."""
    run = Controller().run(NcText("part.nc", TEXT), memory_trace=False)
    with pytest.raises(Failure) as raised:
        run.to_arrow()
    assert raised.value.diagnostics[0].id == 901350
