# SPDX-License-Identifier: MIT
"""Event rows become events with the kinds and texts of the run tests."""

import pytest
from support.event_rows import Names, row

from nctakt.base.diagnostics import Span
from nctakt.kernel import codes, rows
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event, EventDecoder

PLACE = Span("part.nc", 5, 3, 4)


@pytest.mark.parametrize(
    ("data", "kind", "text", "cycle"),
    [
        (row(rows.EVENT_CREATED, 1, 1), "created", "17 PROG", "17"),
        (row(rows.EVENT_CREATED, 2, 0), "created", "#1 BLOCK", "#1"),
        (row(rows.EVENT_CREATED, 1, 2), "created", "17 GLOBAL", "17"),
        (row(rows.EVENT_STARTED, 2), "started", "#1", "#1"),
        (row(rows.EVENT_HELD, 1), "held", "17", "17"),
        (row(rows.EVENT_CONTINUED, 1), "continued", "17", "17"),
        (row(rows.EVENT_ABORTED, 1), "aborted", "17", "17"),
        (row(rows.EVENT_ENDED, 1, rows.ENDED_BY_SCOPE), "ended", "17 scope", "17"),
        (row(rows.EVENT_ENDED, 1, rows.ENDED_BY_DELETE), "ended", "17 delete", "17"),
        (row(rows.EVENT_ENDED, 1, rows.ENDED_BY_RESET), "ended", "17 reset", "17"),
        (row(rows.EVENT_ENDED, 1, rows.ENDED_BY_ERROR), "ended", "17 error", "17"),
        (row(rows.EVENT_FIRED, 1), "fired", "17 line 5", "17"),
        (row(rows.EVENT_WRITTEN, 1, 40, 198.0), "written", "V.E.VALUE 198", "17"),
        (row(rows.EVENT_WRITTEN, 0, 40, 16.57), "written", "V.E.VALUE 16.57", ""),
        (row(rows.EVENT_WRITTEN, 1, 40, -0.0), "written", "V.E.VALUE 0", "17"),
        (row(rows.EVENT_TECHNOLOGY_RT, 1, 100, 2), "M", "100 2 7000", "17"),
        (row(rows.EVENT_TECHNOLOGY_RT, 1, -34, 1), "H", "33 1 7000", "17"),
        (row(rows.EVENT_TECHNOLOGY, 0, 5), "output", "M 5", ""),
        (row(rows.EVENT_TECHNOLOGY, 0, -6), "output", "H 5", ""),
        (row(rows.EVENT_TECHNOLOGY, 0, -1), "output", "H 0", ""),
        (row(rows.EVENT_MESSAGE, 3), "message", "tool; worn <out>", ""),
        (row(rows.EVENT_ERROR, 1, 50879), "error", "50879", "17"),
        (row(rows.EVENT_ERROR, 0, 900531), "warning", "900531", ""),
        (row(rows.EVENT_PROGRAM_END, 0), "end", "part.nc", ""),
        (row(rows.EVENT_NOTICE, 1, 900531), "notice", "900531", "17"),
        (row(rows.EVENT_SPINDLE, 1, 2, 19, 1000.5), "spindle", "S3 M19 1000.5", "17"),
        (row(rows.EVENT_SPINDLE_POSITION, 1, 2, 314), "spindle_position", "S3 314", "17"),
        (row(rows.EVENT_SPINDLE_REACHED, 0, 0), "spindle_reached", "S1", ""),
        (row(rows.EVENT_USER_ERROR, 1, 666, 2), "user_error", "666 2", "17"),
        (row(rows.EVENT_USER_VALUE, 1, 3, 99.5), "user_value", "PV1 99.5", "17"),
        (row(rows.EVENT_USER_TEXT, 0, 6, 6), "user_value", "PV2 worn", ""),
        (row(rows.EVENT_TIMER, 1, 3, codes.TIMER_START), "timer", "3 START", "17"),
        (row(rows.EVENT_TIMER, 1, 3, codes.TIMER_READ, 1501.0), "timer", "3 READ 1501", "17"),
        (row(rows.EVENT_BLOCK, 10, 5), "block", "10 decoded 5", ""),
        (row(rows.EVENT_WAIT), "waits", "flush", ""),
        (row(rows.EVENT_WAIT, 1, 40), "waits", "read V.E.VALUE", ""),
        (row(rows.EVENT_ACKNOWLEDGED, 0, 100, 2, 5), "acknowledged", "M 100 2 5000", ""),
        (row(rows.EVENT_DROPPED, 0, -34, 0, 6), "dropped", "H 33 0 6000", ""),
        (row(rows.EVENT_FROZEN, 2, 4, 16.5), "frozen", "V.E.ASYNC 16.5", "#1"),
    ],
)
def test_each_kind_of_row_has_its_text(data: bytes, kind: str, text: str, cycle: str) -> None:
    """Kinds and texts are those that the run tests expect; the tick stamps its begin (RC-001)."""
    assert EventDecoder(1000, Names()).decode(data) == [Event(7, 7000, kind, text, PLACE, cycle)]


def test_a_chunk_decodes_when_it_is_looked_at() -> None:
    """Its length is known without decoding, its events come in the order of their rows."""

    class Counting(EventDecoder):
        decoded = 0

        def decode(self, data: bytes | memoryview) -> list[Event]:
            self.decoded += 1
            return super().decode(data)

    decoder = Counting(1000, Names())
    chunk = EventChunk(decoder, row(rows.EVENT_STARTED, 1) + row(rows.EVENT_HELD, 1))
    assert len(chunk) == 2
    assert decoder.decoded == 0
    assert [str(event) for event in chunk] == ["started 17", "held 17"]
    assert chunk[1].kind == "held"
    assert decoder.decoded == 1
