# SPDX-License-Identifier: MIT
"""Chunks of event rows: by kind, counted, decoded no sooner and no more than is looked at."""

from __future__ import annotations

import pytest
from support.event_rows import Names, row

from nctakt.kernel import rows
from nctakt.results.report import DIAGNOSIS_CAPACITY, DiagnosisReport, DiagnosisSink
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event, EventDecoder
from nctakt.run.controller import Controller, NcText


class Counting(EventDecoder):
    """Counts the rows that it decodes."""

    decoded = 0

    def decode(self, data: bytes | memoryview) -> list[Event]:
        found = super().decode(data)
        self.decoded += len(found)
        return found


def test_rows_of_some_kinds_are_chosen_undecoded() -> None:
    """The others are never decoded."""
    decoder = Counting(1000, Names())
    data = row(rows.EVENT_STARTED, 1) + row(rows.EVENT_FIRED, 1) + row(rows.EVENT_HELD, 2)
    chosen = EventChunk(decoder, data).of_kinds({rows.EVENT_STARTED, rows.EVENT_HELD})
    assert decoder.decoded == 0
    assert [str(event) for event in chosen] == ["started 17", "held #1"]
    assert decoder.decoded == 2


def test_repetitions_are_counted_with_the_first_and_the_last_tick() -> None:
    """Firings of one branch are one entry; of another cycle another; other kinds stay single."""
    decoder = Counting(1000, Names())
    data = b"".join(
        [
            row(rows.EVENT_FIRED, 1, tick=3),
            row(rows.EVENT_STARTED, 1, tick=4),
            row(rows.EVENT_FIRED, 2, tick=4),
            row(rows.EVENT_STARTED, 1, tick=5),
            row(rows.EVENT_WRITTEN, 1, 40, 1.0, tick=6),
            row(rows.EVENT_FIRED, 1, tick=8),
            row(rows.EVENT_WRITTEN, 1, 40, 2.0, tick=9),
            row(rows.EVENT_TECHNOLOGY_RT, 1, 100, 1, tick=9),
            row(rows.EVENT_TECHNOLOGY_RT, 1, 101, 2, tick=9),
        ]
    )
    found = EventChunk(decoder, data).repetitions()
    assert [(str(event), event.tick, count, last) for event, count, last in found] == [
        ("fired 17 line 5", 3, 2, 8),
        ("started 17", 4, 1, 4),
        ("fired #1 line 5", 4, 1, 4),
        ("started 17", 5, 1, 5),
        ("written V.E.VALUE 1", 6, 2, 9),
        ("M 100 1 9000", 9, 1, 9),
        ("M 101 2 9000", 9, 1, 9),
    ]
    assert decoder.decoded == len(found)


def test_an_empty_chunk_has_nothing() -> None:
    """No rows, no repetitions."""
    chunk = EventChunk(Counting(1000, Names()), b"")
    assert (len(chunk), chunk.repetitions(), list(chunk.of_kinds({1}))) == (0, [], [])


def test_diagnosis_data_decode_no_more_actions_than_they_keep() -> None:
    """RC-603: of thousands of actions the newest count; the rest are counted, never decoded."""
    decoder = Counting(1000, Names())
    count = 5 * DIAGNOSIS_CAPACITY
    data = b"".join(row(rows.EVENT_WRITTEN, 1, 40, tick, tick=tick) for tick in range(count))
    data += row(rows.EVENT_WRITTEN, 0, 40, 5.0) + row(rows.EVENT_WRITTEN, 1, 40, 5.0, channel=2)
    report = DiagnosisReport()
    report.add(EventChunk(decoder, row(rows.EVENT_STARTED, 1) + data))
    assert decoder.decoded == DIAGNOSIS_CAPACITY + 1
    lines = report.lines(4)
    assert [lines[0].level, lines[1].time_us] == [3, 1000 * (count - DIAGNOSIS_CAPACITY)]
    assert f"older ones: {count - DIAGNOSIS_CAPACITY}\n" in report.render(4)


@pytest.mark.parametrize("ticks", [500, 1000])
def test_a_run_with_many_actions_decodes_few(ticks: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Twenty cycles that act in each tick: what is decoded does not grow with the ticks."""
    decoded: list[int] = []
    decode = EventDecoder.decode

    def counted(self: EventDecoder, data: bytes | memoryview) -> list[Event]:
        decoded.append(len(data) // (8 * rows.EVENT_WIDTH))
        return decode(self, data)

    monkeypatch.setattr(EventDecoder, "decode", counted)
    cycles = "".join(
        f"#RT CYCLE [ID={number} SCOPE=PROG]\nV.E.COUNT += 1\n#RT CYCLE END\n"
        for number in range(1, 21)
    )
    sink = DiagnosisSink(DiagnosisReport(capacity=10))
    run = Controller().run(
        NcText("part.nc", f"{cycles}#TIME {ticks / 1000}\nM30\n"),
        sinks=[sink],
        signals=[],
        memory_trace=False,
    )
    assert run.ticks == ticks + 1
    assert len(sink.report.lines(4)) == 20
    assert sum(decoded) < 1000


@pytest.mark.parametrize("words", [("M", "H", "output"), ("fired",), ("message",), ("ended", "M")])
def test_events_of_a_kind_are_those_of_all_events(words: tuple[str, ...]) -> None:
    """Whether only their rows are decoded, or all have been before, in the same order."""
    text = (
        "#RT CYCLE [ID = 1 SCOPE = PROG]\n$IF EDGE V.RTA.ACS.ACT_POS.X > 5\nM100 H7\n$ENDIF\n"
        '#RT CYCLE END\nM8\nG01 X10 F6000\n#MSG ["there"]\nM9\nM30\n'
    )
    first = Controller().run(NcText("part.nc", text)).trace
    second = Controller().run(NcText("part.nc", text)).trace
    expected = [event for event in second.events if event.kind in words]
    assert expected
    assert first.events_of(words) == second.events_of(words) == expected


def test_chunks_of_one_decoder_are_joined_undecoded() -> None:
    """Those of another one, which has other names, stay apart."""
    decoder = Counting(1000, Names())
    first = EventChunk(decoder, row(rows.EVENT_STARTED, 1) + row(rows.EVENT_FIRED, 1))
    second = EventChunk(decoder, row(rows.EVENT_HELD, 2))
    whole = first.joined([second])
    assert whole is not None
    assert whole.has_any({rows.EVENT_HELD}) and not first.has_any({rows.EVENT_HELD})
    assert decoder.decoded == 0
    assert [str(event) for event in whole.after(2)] == ["held #1"]
    assert decoder.decoded == 1
    other = EventChunk(Counting(1000, Names()), row(rows.EVENT_HELD, 2))
    assert first.joined([second, other]) is None
