# SPDX-License-Identifier: MIT
"""Whatever happens in a run, its files give it back."""

import array
import string
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from nctakt.base.diagnostics import Span
from nctakt.results.trace.events import Event
from nctakt.results.trace.reading import read_trace
from nctakt.results.trace.sinks import Signal, TraceHeader, file_sink

WORDS = st.text(st.characters(codec="utf-8"), max_size=12)
FILES = st.text(st.characters(codec="utf-8", exclude_characters="\0"), min_size=1, max_size=8)
PLACES = st.builds(
    lambda file, line, column: Span(file, line, column, column + 1),
    FILES,
    st.integers(1, 99),
    st.integers(1, 99),
)
CYCLES = st.sampled_from(["", "17", "#1"])
KINDS = st.text(string.ascii_lowercase, min_size=1, max_size=7)
EVENTS = st.lists(st.tuples(st.integers(0, 5), KINDS, WORDS, st.none() | PLACES, CYCLES))
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
ROWS = st.lists(st.tuples(NUMBERS, NUMBERS), min_size=6, max_size=6)


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(happened=EVENTS, rows=ROWS)
def test_any_events_and_values_survive_a_file(
    tmp_path: Path,
    suffix: str,
    happened: list[tuple[int, str, str, Span | None, str]],
    rows: list[tuple[float, float]],
) -> None:
    """Texts with any characters, any finite numbers: what is read is what was written."""
    events = [
        Event(tick, 1000 * tick, kind, text, span, cycle)
        for tick, kind, text, span, cycle in sorted(happened, key=lambda one: one[0])
    ]
    path = tmp_path / f"out.{suffix}"
    sink = file_sink(path)
    sink.open(TraceHeader(1000, (Signal("A"), Signal("B"))))
    sink.events(events)
    flat = array.array("d", [value for row in rows for value in row])
    sink.rows(0, memoryview(flat), 2)
    sink.close()
    trace = read_trace(path)
    assert trace.events == events
    assert trace["A"].tolist() == [row[0] for row in rows]
    assert trace["B"].tolist() == [row[1] for row in rows]
