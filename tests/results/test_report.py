# SPDX-License-Identifier: MIT
"""The diagnosis data of the realtime cycles (manual chapter 5, RC-601 … RC-603)."""

import pytest

from nctakt.base.diagnostics import Span
from nctakt.messages import diagnostic
from nctakt.messages.inputs import INVALID_TIME
from nctakt.results.report import DIAGNOSIS_CAPACITY, DiagnosisReport, DiagnosisSink
from nctakt.trace import Event, TraceHeader


def event(kind: str, text: str, time_us: int = 426098, cycle: str = "1") -> Event:
    """An event of cycle 1."""
    return Event(time_us // 1000, time_us, kind, text, None, cycle)


def body(report: DiagnosisReport, language: str = "en") -> list[str]:
    """The lines below the columns' heads."""
    text = report.render("de" if language == "de" else "en")
    return text.split("-" * 63 + "\n")[1].splitlines()


def manual_example() -> DiagnosisReport:
    """What the manual's example shows: a start, a cycle created and started."""
    report = DiagnosisReport()
    report.initialised(50024, 0)
    report.add(event("created", "1 PROG"), 3)
    report.add(event("started", "1"), 3)
    return report


def test_the_manuals_example_in_german() -> None:
    """RC-601: header, rule, note, columns and lines as the German manual's chapter 5 has them."""
    lines = manual_example().render("de").splitlines()
    assert lines[0] == "BAHN : ECHTZEIT-ZYKLEN DIAGNOSE DATEN KANAL-NR.: 1"
    assert lines[1] == "=" * 63
    assert "Hinweis:" in lines
    assert [line.split(None, 2) for line in lines[-6:]] == [
        ["Zeitstempel", "Level", "Nachricht"],
        ["-" * 63],
        ["50024", "INFO", "Echtzeit-Zyklen-Manager wurde initialisiert"],
        ["50024", "INFO", "Echtzeit-Zyklen-Manager: 0 Zyklen"],
        ["426098", "INFO", "Zyklus 1 mit Gueltigkeit PROG wurde angelegt"],
        ["426098", "INFO", "Zyklus 1 wurde gestartet"],
    ]


def test_the_manuals_example_in_english() -> None:
    """RC-601: the same in English."""
    lines = manual_example().render("en").splitlines()
    assert lines[0] == "PATH : REALTIME CYCLES DIAGNOSIS DATA CHANNEL NO.: 1"
    assert "Note:" in lines
    assert [line.split(None, 2) for line in lines[-6:]] == [
        ["Timestamp", "Level", "Message"],
        ["-" * 63],
        ["50024", "INFO", "Realtime cycle manager was initialised"],
        ["50024", "INFO", "Realtime cycle manager: 0 cycles"],
        ["426098", "INFO", "Cycle 1 was created with PROG validity"],
        ["426098", "INFO", "Cycle 1 was started"],
    ]


@pytest.mark.parametrize(
    ("kind", "text", "level", "english"),
    [
        ("error", "50879", "ERROR", "50879"),
        ("warning", "900531", "WARNING", "900531: the realtime part is not compiled here"),
        ("notice", "900504", "WARNING", "900504: standard input"),
        ("held", "1", "INFO", "Cycle 1 was put on hold"),
        ("continued", "1", "INFO", "Cycle 1 was continued"),
        ("aborted", "1", "INFO", "The actions of cycle 1 were aborted"),
        ("ended", "1 scope", "INFO", "Cycle 1 ended with its validity"),
        ("ended", "1 delete", "INFO", "Cycle 1 was deleted"),
        ("ended", "1 reset", "INFO", "Cycle 1 was ended by a reset"),
        ("ended", "1 error", "INFO", "Cycle 1 was ended by an error"),
        ("fired", "1 line 5", "ACTION", "Cycle 1: the branch in line 5 runs"),
        ("written", "V.E.VALUE 16.57", "ACTION", "Cycle 1: V.E.VALUE = 16.57"),
        ("M", "100 2 426098", "ACTION", "Cycle 1: M100 was output, number 2 of the tick"),
        ("axis", "Z begun 900", "ACTION", "Cycle 1: axis Z moves to 900"),
        ("axis", "A begun negative", "ACTION", "Cycle 1: axis A moves endlessly in negative"),
        ("axis", "Z done", "ACTION", "Cycle 1: the motion of axis Z is done"),
        ("axis", "Z aborted", "ACTION", "Cycle 1: the motion of axis Z was given up"),
        ("axis", "Z failed", "ACTION", "Cycle 1: the motion of axis Z has failed"),
        ("axis", "Z held", "ACTION", "Cycle 1: the motion of axis Z is put on hold"),
        ("axis", "Z continued", "ACTION", "Cycle 1: the motion of axis Z goes on"),
        ("axis", "Z stopped", "ACTION", "Cycle 1: the motion of axis Z has come to a stand"),
        ("H", "33 1 426098", "ACTION", "Cycle 1: H33 was output, number 1 of the tick"),
    ],
)
def test_each_event_has_its_level_and_text(kind: str, text: str, level: str, english: str) -> None:
    """RC-603: 1 errors, 2 warnings, 3 management, 4 actions; one line each."""
    report = DiagnosisReport()
    report.add(event(kind, text), 4)
    (line,) = body(report)
    assert line.split(None, 2)[:2] == ["426098", level]
    assert line.split(None, 2)[2].startswith(english)


@pytest.mark.parametrize("limit", [-1, 0, 1, 2, 3, 4, 5, 99])
def test_the_level_filters_when_the_line_is_made(limit: int) -> None:
    """RC-603: at or below 0 nothing is kept, from 4 on everything; later changes alter nothing."""
    report = DiagnosisReport()
    report.initialised(0, 0, limit)
    for kind, text in [
        ("error", "1"),
        ("warning", "2"),
        ("started", "1"),
        ("M", "100 1 0"),
    ]:
        report.add(event(kind, text), limit)
    levels = [line.level for line in report.lines]
    every = [3, 3, 1, 2, 3, 4]
    assert levels == [level for level in every if level <= limit]


def test_motions_in_german() -> None:
    """RC-601: the same lines in the other language."""
    report = DiagnosisReport()
    for text in ("Z begun 900", "A begun positive", "Z stopped"):
        report.add(event("axis", text), 4)
    assert [line.split(None, 2)[2] for line in body(report, "de")] == [
        "Zyklus 1: Achse Z faehrt auf 900",
        "Zyklus 1: Achse A faehrt endlos in positiver Richtung",
        "Zyklus 1: die Bewegung der Achse Z ist zum Stehen gekommen",
    ]


def test_what_is_not_the_cycles_makes_no_line() -> None:
    """Messages, program ends, and outputs of the main program are no diagnosis data."""
    report = DiagnosisReport()
    for kind in ("message", "output", "end"):
        report.add(event(kind, "m 5", cycle=""), 4)
    report.add(event("written", "V.E.VALUE 5", cycle=""), 4)
    assert report.lines == ()


def test_an_error_is_told_with_its_text() -> None:
    """RC-602: what the error says stands behind its number, in the language asked for."""
    place = Span("part.nc", 5, 3, 4)
    report = DiagnosisReport()
    report.add(Event(1, 1000, "error", "900510", place, "1"), 1)
    other = diagnostic(INVALID_TIME, Span("part.nc", 6, 3, 9), text="never")
    found = diagnostic(INVALID_TIME, Span("part.nc", 5, 1, 9), text="soon")
    assert report.render("en", [other, found]).endswith("900510: 'soon' is not a valid time\n")
    assert report.render("de", [found]).endswith("900510: 'soon' ist keine gültige Zeit\n")
    assert report.render("en", [other]).endswith("900510\n")


def test_a_sink_follows_the_level_that_is_written() -> None:
    """RC-603: from the event on that writes DIAG_LEVEL the new level counts."""
    sink = DiagnosisSink(DiagnosisReport())
    sink.open(TraceHeader(1000, ()))
    sink.events(
        [
            event("M", "100 1 0"),
            event("written", "V.RTG.CYCLES.DIAG_LEVEL 99", cycle=""),
            event("M", "101 1 0"),
            event("written", "V.RTG.CYCLES.DIAG_LEVEL 0"),
            event("M", "102 1 0"),
        ]
    )
    assert [line.split(": ", 1)[1][:4] for line in body(sink.report)] == ["M101", "V.RT"]


@pytest.mark.parametrize("extra", [-1, 0, 1])
def test_the_ring_is_bounded(extra: int) -> None:
    """RC-603: at the bound all lines are there, one more pushes out the oldest and is told."""
    report = DiagnosisReport()
    for number in range(DIAGNOSIS_CAPACITY + extra):
        report.add(event("started", "1", time_us=number), 3)
    kept = report.lines
    assert len(kept) == min(DIAGNOSIS_CAPACITY, DIAGNOSIS_CAPACITY + extra)
    assert kept[0].time_us == max(0, extra)
    assert ("no longer kept: 1" in report.render()) == (extra > 0)
