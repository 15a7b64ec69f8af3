# SPDX-License-Identifier: MIT
"""Traces are streamed to files, kept in memory, and read back the same."""

import array
import errno
import io
import json
import math
import time
from pathlib import Path

import pytest

from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.results.trace.events import Event
from nctakt.results.trace.reading import read_trace
from nctakt.results.trace.recorded import MemorySink, Trace
from nctakt.results.trace.sinks import CsvSink, JsonlSink, Signal, Sink, TraceHeader, file_sink

HEADER = TraceHeader(
    1000, (Signal("X.ACS.ACT_POS", "mm"), Signal("BLOCK", "", True), Signal("V.E.A[0,1]"))
)
EVENTS = [
    Event(0, 0, "created", "17 PROG", Span("a, b.nc", 3, 1, 2), "17"),
    Event(0, 0, "started", "17"),
    Event(2, 2000, "message", 'say "x"; then <y>\n\\end', Span("c:d.nc", 1, 9, 10)),
    Event(2, 2000, "fired", "#1 line 5", None, "#1"),
    Event(3, 3000, "end", "a, b.nc"),
]
ROWS = [[0.0, 10.0, 0.1], [-0.0, 10.0, 1e-9], [1 / 3, 20.0, 1e300], [5e-324, 9007199254740991.0, 2]]


def feed(sink: Sink, cuts: tuple[int, ...] = (4,), first_tick: int = 0) -> None:
    """Give the events and rows above in pieces that end at ``cuts``."""
    sink.open(HEADER)
    start = 0
    for cut in cuts:
        sink.events([event for event in EVENTS if start <= event.tick < cut])
        flat = array.array("d", [value for row in ROWS[start:cut] for value in row])
        sink.rows(first_tick + start, memoryview(flat), 3)
        start = cut
    sink.close()


def assert_same(trace: Trace) -> None:
    """``trace`` holds what ``feed`` gave."""
    assert list(trace) == ["X.ACS.ACT_POS", "BLOCK", "V.E.A[0,1]"]
    assert [trace[name].tolist() for name in trace] == [
        list(column) for column in zip(*ROWS, strict=True)
    ]
    assert trace.events == EVENTS
    assert trace.tick.tolist() == [0, 1, 2, 3]
    assert trace.time_us.tolist() == [0, 1000, 2000, 3000]
    assert [signal.integral for signal in trace.signals] == [False, True, False]


def test_csv_has_a_line_per_tick_with_its_events(tmp_path: Path) -> None:
    """Whole-number signals have no decimals, the others their shortest text, -0 is 0."""
    path = tmp_path / "out.csv"
    feed(file_sink(path))
    assert path.read_text(encoding="utf-8").splitlines() == [
        'tick,time_us,X.ACS.ACT_POS,BLOCK,"V.E.A[0,1]",events',
        '0,0,0.0,10,0.1,"created 17 PROG <17 a, b.nc:3:1>; started 17"',
        "1,1000,0.0,10,1e-09,",
        '2,2000,0.3333333333333333,20,1e+300,"message say ""x""\\; then \\<y>\\n\\\\end '
        '<- c:d.nc:1:9>; fired #1 line 5 <#1 ->"',
        '3,3000,5e-324,9007199254740991,2.0,"end a, b.nc"',
    ]


def test_jsonl_has_an_object_per_tick(tmp_path: Path) -> None:
    """The header comes first; ticks without events have no list of them."""
    path = tmp_path / "out.jsonl"
    feed(file_sink(path))
    header, *ticks = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    assert header["format"] == "nctakt-trace"
    assert header["version"] == 1
    assert header["cycle_time_us"] == 1000
    assert header["signals"][0] == {"name": "X.ACS.ACT_POS", "unit": "mm", "integral": False}
    assert ticks[1] == {"tick": 1, "time_us": 1000, "values": [0.0, 10, 1e-09]}
    assert ticks[0]["events"][0] == {
        "kind": "created",
        "text": "17 PROG",
        "cycle": "17",
        "file": "a, b.nc",
        "line": 3,
        "column": 1,
        "end_column": 2,
    }


@pytest.mark.parametrize("suffix", ["csv", "jsonl", "CSV"])
def test_a_file_is_read_back_as_the_same_trace(tmp_path: Path, suffix: str) -> None:
    """Writing and reading changes neither a bit of a value nor a word of an event."""
    path = tmp_path / f"out.{suffix}"
    feed(file_sink(path))
    trace = read_trace(path)
    assert trace.cycle_time_us == 1000
    assert_same(trace)


def test_memory_keeps_the_same_trace() -> None:
    """The memory sink gives the arrays and events that came."""
    sink = MemorySink()
    feed(sink, (1, 3, 4))
    assert_same(sink.trace)
    assert sink.trace.at(2, "BLOCK") == 20.0


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_cutting_the_run_into_pieces_changes_no_byte(tmp_path: Path, suffix: str) -> None:
    """The same ticks in other chunks make the same file (architecture: same bytes)."""
    whole, pieces = tmp_path / f"whole.{suffix}", tmp_path / f"pieces.{suffix}"
    feed(file_sink(whole))
    feed(file_sink(pieces), (1, 2, 3, 4))
    assert whole.read_bytes() == pieces.read_bytes()


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_a_file_that_breaks_off_is_readable_up_to_there(tmp_path: Path, suffix: str) -> None:
    """What a broken-off run has written is read, without the line that is not whole."""
    path = tmp_path / f"out.{suffix}"
    feed(file_sink(path))
    path.write_bytes(path.read_bytes()[:-8])
    trace = read_trace(path)
    assert trace.ticks == 3
    assert trace.events == EVENTS[:-1]


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_without_signals_only_ticks_with_events_have_a_line(tmp_path: Path, suffix: str) -> None:
    """A trace of events alone streams and is read back."""
    path = tmp_path / f"out.{suffix}"
    sink = file_sink(path)
    sink.open(TraceHeader(1000, ()))
    sink.events(EVENTS)
    sink.close()
    trace = read_trace(path)
    assert trace.events == EVENTS
    assert trace.ticks == 0
    assert len(path.read_text(encoding="utf-8").splitlines()) == 4


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_what_is_no_number_is_written_and_read(tmp_path: Path, suffix: str) -> None:
    """A signal that is not finite does not break the file's format."""
    path = tmp_path / f"out.{suffix}"
    sink = file_sink(path)
    sink.open(TraceHeader(1000, (Signal("A"), Signal("B", "", True))))
    sink.rows(0, memoryview(array.array("d", [math.nan, math.inf, 1.0, 2.0])), 2)
    sink.close()
    trace = read_trace(path)
    assert math.isnan(trace.at(0, "A"))
    assert trace.at(1, "B") == 2.0


def test_a_signal_that_was_not_recorded_suggests_the_nearest() -> None:
    """A mistyped name names the one that is meant."""
    sink = MemorySink()
    feed(sink)
    with pytest.raises(KeyError, match=r"did you mean X\.ACS\.ACT_POS"):
        sink.trace["X.ACS.ACTPOS"]
    with pytest.raises(IndexError, match="tick 4"):
        sink.trace.at(4, "BLOCK")


@pytest.mark.parametrize(
    ("name", "content", "number"),
    [
        ("out.txt", "", 900506),
        ("missing.csv", None, 900503),
        ("other.csv", "a,b\n1,2\n", 900508),
        ("short.csv", "tick,time_us,X,events\n0,0\n", 900508),
        ("other.jsonl", "[]\n", 900508),
        ("empty.jsonl", "", 900508),
    ],
)
def test_a_file_that_is_no_trace_is_a_diagnostic(
    tmp_path: Path, name: str, content: str | None, number: int
) -> None:
    """Reading what is not there, or no trace, says so by number."""
    path = tmp_path / name
    if content is not None:
        path.write_text(content, encoding="utf-8")
    with pytest.raises(Failure) as failure:
        read_trace(path)
    assert [found.id for found in failure.value.diagnostics] == [number]


@pytest.mark.parametrize(("name", "number"), [("out.txt", 900506), ("no/folder.csv", 900507)])
def test_a_trace_that_cannot_be_written_is_a_diagnostic(
    tmp_path: Path, name: str, number: int
) -> None:
    """An unknown format and an unwritable file are reported before the first tick."""
    with pytest.raises(Failure) as failure:
        file_sink(tmp_path / name).open(HEADER)
    assert [found.id for found in failure.value.diagnostics] == [number]


def test_csv_keeps_up_with_the_realtime_part(tmp_path: Path) -> None:
    """A row of 12 signals of a machine that moves in three axes takes some microseconds.

    The bound is ten times what is measured on a quiet machine (2 µs), so that a busy one does not
    fail: it catches a format that has become slow by its making.
    """
    width, count = 12, 4096
    row = [0.0] * width
    flat = array.array("d")
    for tick in range(count):
        row[0:3] = [tick * 0.3 / 7, tick * 0.1 / 7, tick * 0.7]
        row[3:6] = row[0:3]
        flat.extend(row)
    sink = file_sink(tmp_path / "out.csv")
    sink.open(TraceHeader(1000, tuple(Signal(f"S{i}") for i in range(width))))
    begin = time.process_time()
    for chunk in range(4):
        sink.rows(chunk * count, memoryview(flat), width)
    per_row_us = (time.process_time() - begin) / (4 * count) * 1e6
    sink.close()
    assert per_row_us < 20


class FullDisk(io.StringIO):
    """A file that takes no more after its first line."""

    name = "out.csv"
    lines = 0

    def write(self, text: str) -> int:
        self.lines += 1
        if self.lines > 1:
            raise OSError(errno.ENOSPC, "No space left on device")
        return super().write(text)


@pytest.mark.parametrize("kind", [CsvSink, JsonlSink])
def test_a_disk_that_runs_full_is_a_diagnostic(kind: type[CsvSink] | type[JsonlSink]) -> None:
    """A trace that cannot go on says why; closing it afterwards is harmless."""
    sink = kind(FullDisk())
    with pytest.raises(Failure, match="No space left"):
        feed(sink)
    sink.close()
    sink.close()


def test_a_file_stays_until_the_trace_begins(tmp_path: Path) -> None:
    """A sink that is never opened, since the run fails before, leaves an earlier trace alone."""
    path = tmp_path / "out.csv"
    path.write_text("of yesterday", encoding="utf-8")
    file_sink(path).close()
    assert path.read_text(encoding="utf-8") == "of yesterday"


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_events_may_come_long_before_their_rows(tmp_path: Path, suffix: str) -> None:
    """Each event is in the line of its tick, however the rows are cut."""
    path = tmp_path / f"out.{suffix}"
    sink = file_sink(path)
    sink.open(HEADER)
    sink.events(EVENTS)
    for tick, row in enumerate(ROWS):
        sink.rows(tick, memoryview(array.array("d", row)), 3)
    sink.rows(len(ROWS), memoryview(array.array("d")), 3)
    sink.close()
    assert_same(read_trace(path))


def test_a_path_that_is_full_is_reported() -> None:
    """The first line that the system does not take is a diagnostic."""
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("a device of Linux")
    with pytest.raises(Failure, match="900507"):
        CsvSink(full).open(HEADER)
