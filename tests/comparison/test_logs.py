# SPDX-License-Identifier: MIT
"""Logs of machines: exports of TwinCAT Scope (LG-101 … 111), tables of anybody's (LG-301, 304)."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.comparison.log import Log, Samples
from nctakt.comparison.log_file import open_log
from nctakt.files.access import FileAccess
from nctakt.run.controller import Controller

SCOPE = """Name\tcell_trace
File\tD:\\log\\cell_trace.csv
Starttime of export\t134000000000000000\tMontag, 18. August 2025\t16:13:20.000
Endtime of export\t134000000000060000\tMontag, 18. August 2025\t16:13:20.006


Name\tX_act\tX_cmd\tName\tM10
SymbolComment\tof the X axis\t\tSymbolComment\t
and its second line
Data-Type\tREAL64\tREAL64\tData-Type\tBIT
SampleTime[ms]\t0,5\t0,5\tSampleTime[ms]\t2
Unit\tm (Length)\tmm (Length)\tUnit\t(None)
Unit ScaleFactor\t1\t-10\tUnit ScaleFactor\t1

0\t0\t0\t-1\t0
0,5\t0,0125\t0,0131\t1\t1
1\t0,0494\t0,0502\t \t\x20
1,5\t0,05\t0,06
EOF
"""


def opened(folder: Path, text: str | bytes, **said: str) -> Log:
    """The log of a text."""
    path = folder / "log.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
    return open_log(path, FileAccess(), said)


def samples(log: Log) -> dict[str, list[tuple[float, float]]]:
    """Stamp in ms and value of each sample, by the names of the columns."""
    read = log.read(log.columns)
    return {
        column.name: [
            (round(float(time) / 1000.0, 6), float(value))
            for time, value in zip(one.times[:], one.values[:], strict=True)
        ]
        for column, one in zip(log.columns, read, strict=True)
    }


def numbers(log: Log) -> list[int]:
    """The numbers of the notes."""
    return [note.message.id for note in log.notes]


def test_an_export_is_several_tables_side_by_side(tmp_path: Path) -> None:
    """LG-101 … 107: groups with own times; blanks and short rows are no samples."""
    log = opened(tmp_path, SCOPE)
    assert [(one.name, one.unit) for one in log.columns] == [
        ("X_act", "m"), ("X_cmd", "mm"), ("M10", ""),
    ]  # fmt: skip
    assert samples(log) == {
        "X_act": [(0.0, 0.0), (0.5, 0.0125), (1.0, 0.0494), (1.5, 0.05)],
        "X_cmd": [(0.0, 0.0), (0.5, 0.0131), (1.0, 0.0502), (1.5, 0.06)],
        "M10": [(-1.0, 0.0), (1.0, 1.0)],
    }
    assert numbers(log) == [902524]


def test_the_decimal_mark_holds_for_data_only(tmp_path: Path) -> None:
    """LG-108: with the comma as separator ``SampleTime[ms],0,2`` is longer than the names."""
    text = "Name,a,b\nSampleTime[ms],0,2,0,2\nUnit,mm (Length),(None)\n\n0,0.5,1\n0.2,0.51,1\n"
    log = opened(tmp_path, text)
    assert [(one.name, one.unit) for one in log.columns] == [("a", "mm"), ("b", "")]
    assert samples(log)["a"] == [(0.0, 0.5), (0.2, 0.51)]
    with pytest.raises(Failure, match="902515"):
        opened(tmp_path, "Name,a,b\n0,0,0,5,1\n0,2,0,51,1\n")


def test_full_time_stamps_are_exact(tmp_path: Path) -> None:
    """LG-109: FILETIME counts 100 ns; 20,000 of them are 2 ms."""
    text = "Name;X\n134000000000000000;0,0125\n134000000000020000;0,0249\n"
    assert samples(opened(tmp_path, text)) == {"X": [(0.0, 0.0125), (2.0, 0.0249)]}


def test_a_table_with_names_and_times(tmp_path: Path) -> None:
    """LG-304: separator, decimal mark and units by what is found there, or as specified."""
    log = opened(tmp_path, "Zeit [s];Position X [mm];ok\n0,001;1,5;TRUE\n0,002;;FALSE\n")
    assert [(one.name, one.unit) for one in log.columns] == [("Position X", "mm"), ("ok", "")]
    assert samples(log) == {"Position X": [(1.0, 1.5)], "ok": [(1.0, 1.0), (2.0, 0.0)]}
    log = opened(tmp_path, "c|x\n5|1\n7|2\n", separator="|", time="c", time_unit="us")
    assert samples(log) == {"x": [(0.005, 1.0), (0.007, 2.0)]}


@pytest.mark.parametrize(
    ("name", "said", "factor"),
    [
        ("zeit_s", {}, 1e3),
        ("TIME_MS", {}, 1.0),
        ("t_min", {}, 6e4),
        ("Zeit [H]", {}, 3.6e6),
        ("t [\u03bcs]", {}, 1e-3),
        ("time", {}, 1e3),
        ("t [days]", {"time_unit": "ms"}, 1.0),
        ("clock_ms", {"time": "Clock_ms"}, 1e3),
    ],
)
def test_units_of_stamps(tmp_path: Path, name: str, said: dict[str, str], factor: float) -> None:
    """LG-304: what the mapping says, the brackets, the end of a known name, else seconds."""
    log = opened(tmp_path, f"x;{name}\n5;0\n7;2\n", **said)
    assert samples(log) == {"x": [(0.0, 5.0), (2.0 * factor, 7.0)]}


@pytest.mark.parametrize("kind", ["datetime64[ns]", "datetime64[ms]", "timedelta64[us]"])
def test_stamps_of_a_clock_in_parquet(tmp_path: Path, kind: str) -> None:
    """They have their own unit; a missing one is no sample."""
    arrow, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    stamps = numpy.array([1_700_000_000_000, 1_700_000_000_002, 0], dtype="datetime64[ms]")
    if kind.startswith("timedelta"):
        stamps = stamps - stamps[0]
    stamps = stamps.astype(kind)
    stamps[2] = "NaT"
    table = arrow.table({"time": stamps, "x": [5.0, 7.0, 9.0]})
    parquet.write_table(table, tmp_path / "log.parquet")
    log = open_log(tmp_path / "log.parquet", FileAccess())
    assert samples(log) == {"x": [(0.0, 5.0), (2.0, 7.0)]}


def test_a_trace_of_our_own(tmp_path: Path) -> None:
    """``tick,time_us,…,events``: signals only."""
    log = opened(
        tmp_path, "tick,time_us,X.ACS.ACT_POS,events\n0,0,1,\n1,1000,2,fired 1 <- -:1:1>\n"
    )
    assert samples(log) == {"X.ACS.ACT_POS": [(0.0, 1.0), (1.0, 2.0)]}


HEADER = (
    '{"format": "nctakt-trace", '
    '"signals": [{"name": "X", "unit": "mm"}, {"name": "B", "unit": ""}]}'
)


def test_a_trace_of_our_own_in_json(tmp_path: Path) -> None:
    """As ``--trace run.jsonl`` writes it: rows with values; events only; what is no number."""
    rows = [
        '{"tick": 0, "time_us": 0, "values": [1.5, null]}',
        '{"tick": 1, "time_us": 1000, "events": []}',
        '{"tick": 2, "time_us": 2000, "values": [2, 7], "events": []}',
    ]
    log = opened(tmp_path, "\n".join([HEADER, *rows]) + "\n")
    assert [(one.name, one.unit) for one in log.columns] == [("X", "mm"), ("B", "")]
    assert samples(log) == {"X": [(0.0, 1.5), (2.0, 2.0)], "B": [(2.0, 7.0)]}
    assert numbers(log) == [902864]


@pytest.mark.parametrize(
    ("text", "number", "line"),
    [
        (HEADER + '\n{"time_us": 0, "values": [1.5', 902956, 2),
        (HEADER + '\n{"time_us": 0, "values": [1.5]}\n', 902956, 2),
        (HEADER + '\n{"time_us": 0, "values": [1, "x"]}\n', 902956, 2),
        (HEADER + '\n{"values": [1, 2]}\n', 902956, 2),
        (HEADER + "\n[1, 2]\n", 902956, 2),
        ("{a\n", 902956, 1),
        (HEADER.replace("name", "title"), 902956, 1),
        ('{"format": "nctakt-trace", "signals": 5}', 902956, 1),
        ('{"format": "other"}\n', 902510, None),
        (HEADER.replace("nctakt-trace", "nctakt-tape") + "\n", 902510, None),
    ],
)
def test_json_that_is_no_trace(tmp_path: Path, text: str, number: int, line: int | None) -> None:
    """902956 at the line, e.g. of a file that was cut; 902510 for another format."""
    with pytest.raises(Failure) as caught:
        samples(opened(tmp_path, text))
    (found,) = caught.value.diagnostics
    assert found.id == number
    assert line is None or (found.span is not None and found.span.line == line)


def test_a_table_with_a_period(tmp_path: Path) -> None:
    """LG-301: no stamps; the rows are as far apart as the first line says."""
    log = opened(tmp_path, "# Sampling period is 2000000 ns\na;b\n1.0;2.0\n3.0;4.0\n")
    assert samples(log)["b"] == [(0.0, 2.0), (2.0, 4.0)]


def test_stamps_that_several_samples_share(tmp_path: Path) -> None:
    """LG-703: spread evenly, and reported; LG-107: what repeats time and value is one sample."""
    log = opened(tmp_path, "t,x\n0,1\n0,2\n0.01,3\n0.01,4\n0.02,5\n0.02,5\n")
    assert samples(log)["x"] == [(0.0, 1.0), (5.0, 2.0), (10.0, 3.0), (15.0, 4.0), (20.0, 5.0)]
    assert numbers(log) == [902525]


def test_cells_without_a_number_and_gaps_are_noted(tmp_path: Path) -> None:
    """Of ten rows, 1 ms apart, two have no number of x; then none comes for 21 ms: 21 periods.

    A step of 20 periods is no gap yet; a row without a time is no time of any column.
    """
    rows = [f"{at},{'nan' if at in (3, 4) else at},{at}" for at in range(10)]
    log = opened(tmp_path, "time_ms,x,y\n" + "\n".join([*rows, "30,1,1", ",5,5", "50,2,2"]) + "\n")
    assert {name: len(found) for name, found in samples(log).items()} == {"x": 10, "y": 12}
    assert [(one.id, one.values) for one in log.notes] == [
        (902864, {"name": "x", "count": 2}),
        (902865, {"name": "x", "length": "21", "time": "0.009", "period": "1"}),
        (902865, {"name": "y", "length": "21", "time": "0.009", "period": "1"}),
    ]


def test_encodings(tmp_path: Path) -> None:
    """UTF-8 with a mark, UTF-16, and what Windows wrote, which is reported."""
    text = "t;Höhe [°]\n0;1\n"
    for encoding, found in (
        ("utf-8-sig", []),
        ("utf-16", []),
        ("utf-16-le", []),
        ("cp1252", [902526]),
    ):
        log = opened(tmp_path, text.encode(encoding))
        assert [(one.name, one.unit) for one in log.columns] == [("Höhe", "°")]
        assert numbers(log) == found


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("", 902513),
        ("Name\tX\n", 902516),
        ("a,b\n1,2\n", 902511),
        ("1,2\n3,4\n", 902512),
        ("t,x\n0,1\n1,one\n", 902514),
        ("t,x\n0,1\n2,1\n1,1\n", 902517),
        ("t,x\n0,\n", 902516),
        ("t,x\n0,nan\n1,inf\n", 902516),
        ("t [days],x\n0,1\n", 902955),
        ("t,x\n0,001,1,5\n", 902515),
        ("t,x\n0,1\n1,2\nt,x\n0,1\n", 902514),
        ("t,x\n0,\0\n", 902510),
        ("t,x\n" + "1" * (1 << 20) + ",1\n", 902523),
    ],
)
def test_what_is_no_log(tmp_path: Path, text: str, number: int) -> None:
    """Each says what is wrong, with its file."""
    with pytest.raises(Failure, match=str(number)):
        samples(opened(tmp_path, text))


def test_forms_that_are_not_read(tmp_path: Path) -> None:
    """902510 says how to get one that is (LG-112)."""
    path = tmp_path / "a.svdx"
    path.write_bytes(b"\0\1")
    with pytest.raises(Failure, match="902510"):
        open_log(path, FileAccess())


def test_a_log_of_any_length_is_read_in_parts(tmp_path: Path) -> None:
    """Parts of a million characters and stretches of 65,536 samples leave no seam.

    Of 200,000 rows each 1,000th has no value, two have a truth, the last 20,000 share their stamps
    in twos, and the last one has no line end: 199,800 values, as many as there are rows less 200.
    """
    rows = [
        f"{row // 2 * 2 if row >= 180_000 else row}.5,{'' if row % 1000 == 999 else row / 8}"
        for row in range(200_000)
    ]
    rows[10], rows[150_000] = "10.5,TRUE", "150000.5,FALSE"
    log = opened(tmp_path, "time_ms,x\n" + "\n".join(rows))
    (found,) = log.read(log.columns)
    times, values = found.times[:], found.values[:]
    expected = [row for row in range(200_000) if row % 1000 != 999]
    assert len(times) == len(expected) == 199_800
    assert (values[10], values[149_850]) == (1.0, 0.0)
    wrong = [at for at, row in enumerate(expected) if values[at] != row / 8]
    assert wrong == [10, 149_850]
    assert numbers(log) == [902525, 902864]
    assert all(
        times[at] == row * 1000.0 + (0.0 if row >= 180_000 and row % 2 else 500.0)
        for at, row in enumerate(expected)
    )


def test_a_log_is_the_same_without_pyarrow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What reads plain numbers faster gives the same bits as ``float``, of each kind of text."""
    texts = (
        "0.1 1e-320 5e-324 -0.0 1.7976931348623157e308 0.30000000000000004 123456789012345678 "
        "+7.25 2.2250738585072014E-308 9007199254740993"
    ).split()
    log = opened(tmp_path, "t,x\n" + "".join(f"{at},{one}\n" for at, one in enumerate(texts)))
    (quick,) = log.read(log.columns)
    monkeypatch.setitem(sys.modules, "pyarrow.csv", None)
    (plain,) = log.read(log.columns)
    assert quick.values[:].tobytes() == plain.values[:].tobytes()
    assert plain.values[:].tolist() == list(map(float, texts))


def test_a_part_of_the_samples_does_not_hold_the_others() -> None:
    """Of each hundredth sample its own array is yielded, whatever the length of the log."""
    samples = Samples(numpy.arange(1000.0), numpy.arange(1000.0))
    ((times, values),) = samples.stretches(100)
    assert times.tolist() == values.tolist() == [100.0 * number for number in range(10)]
    assert times.base is None
    assert values.base is None


def test_names_with_commas(tmp_path: Path) -> None:
    """LG-108: the separator is in both rows equally often, however many commas the names have."""
    path = tmp_path / "log.csv"
    path.write_text("t;Pos, X, act [mm];Pos, Y, act [mm]\n0;1,5;2\n1;2,5;3\n", "utf-8")
    log = open_log(path, FileAccess())
    assert [one.name for one in log.columns] == ["Pos, X, act", "Pos, Y, act"]
    assert log.read(log.columns)[0].values[:].tolist() == [1.5, 2.5]


def test_a_late_byte_that_is_no_utf_8(tmp_path: Path) -> None:
    """It is beyond what is looked at first: reported with line and column, not as a number."""
    path = tmp_path / "log.csv"
    rows = "".join(f"{at},{at}.5\n" for at in range(200_000))
    path.write_bytes(b"t,X\n" + rows.encode() + b"200000,2\xff5\n")
    log = open_log(path, FileAccess())
    with pytest.raises(Failure) as reported:
        log.read(log.columns)
    (found,) = reported.value.diagnostics
    assert found.id == 902880
    assert found.span is not None
    assert (found.span.line, found.span.column) == (200_002, 9)


@pytest.mark.parametrize("length", [30, 100, 300, 800])
def test_a_damaged_mf4_is_reported_and_nothing_else(
    length: int, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """902510, and no complaint of the library's half-made object."""
    asammdf = pytest.importorskip("asammdf")
    whole = tmp_path / "whole.mf4"
    measured = asammdf.MDF(version="4.10")
    stamps = numpy.arange(100) / 1000.0
    measured.append([asammdf.Signal(stamps, stamps, name="X", unit="mm")])
    measured.save(whole)
    measured.close()
    cut = tmp_path / "cut.mf4"
    cut.write_bytes(whole.read_bytes()[:length])
    with pytest.raises(Failure) as reported:
        open_log(cut, FileAccess())
    assert [one.id for one in reported.value.diagnostics] == [902510]
    assert capfd.readouterr().err == ""


def test_a_trace_of_a_kernel_by_a_mapping(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """LG-201: a table in 0.1 µm at a period of 2 ms, as docs/logs.md shows it."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G01 X10 F6000\nM30\n", "utf-8")
    trace = Controller().run("part.nc", signals=["X.ACS.ACT_POS"]).trace
    assert trace is not None
    rows = "".join(f"{10_000 * x:.0f};0\n" for x in trace["X.ACS.ACT_POS"][::2])
    text = f"# Sampling period is 2000000 ns\nistw_1;istw_2\n{rows}"
    Path("trace.txt").write_text(text, "utf-8")
    mapping = '[signals]\n"X.ACS.ACT_POS" = { log = "istw_1", unit = "0.1µm" }\n'
    Path("trace.toml").write_text(mapping, "utf-8")
    words = ["--map", "trace.toml", "--offset", "0s", "--tolerance", "0.0001"]
    assert main(["compare", "trace.txt", "part.nc", *words]) == 0
    assert "within the tolerances" in capsys.readouterr().out
