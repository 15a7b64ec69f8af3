# SPDX-License-Identifier: MIT
"""The diagnosis data of the realtime cycles (manual chapter 5, RC-601 … RC-603)."""

import pytest

from nctakt.base.diagnostics import Span
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import INVALID_TIME
from nctakt.messages.programs.realtime import CYCLE_OPERATION_WITHOUT_RESULT
from nctakt.results.report import DIAGNOSIS_CAPACITY, DiagnosisReport, DiagnosisSink
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader


def event(kind: str, text: str, time_us: int = 426098, cycle: str = "1") -> Event:
    """An event of cycle 1."""
    return Event(time_us // 1000, time_us, kind, text, None, cycle)


def body(report: DiagnosisReport, language: str = "en") -> list[str]:
    """The lines below the columns' heads."""
    text = report.render(4, "de" if language == "de" else "en")
    return text.split("-" * 63 + "\n")[1].splitlines()


def manual_example() -> DiagnosisReport:
    """What the manual's example shows: a start, a cycle created and started."""
    report = DiagnosisReport()
    report.initialised(50024, 0)
    report.add([event("created", "1 PROG"), event("started", "1")])
    return report


def test_the_manuals_example_in_german() -> None:
    """RC-601: header, rule, note, columns and lines as the German manual's chapter 5 has them."""
    lines = manual_example().render(3, "de").splitlines()
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
    lines = manual_example().render(3, "en").splitlines()
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
        ("axis", "Z aborted", "ACTION", "Cycle 1: the motion of axis Z was aborted"),
        ("axis", "Z failed", "ACTION", "Cycle 1: the motion of axis Z has failed"),
        ("axis", "Z held", "ACTION", "Cycle 1: the motion of axis Z is put on hold"),
        ("axis", "Z continued", "ACTION", "Cycle 1: the motion of axis Z continues"),
        ("axis", "Z stopped", "ACTION", "Cycle 1: the motion of axis Z has come to a stop"),
        ("spindle", "S2 M3 1000.5", "ACTION", "Cycle 1: spindle S2: M3 with 1000.5 1/min"),
        ("spindle", "S M5 0", "ACTION", "Cycle 1: spindle S: M5"),
        ("spindle_position", "S 90", "ACTION", "Cycle 1: spindle S is positioned at 90 degrees"),
        ("spindle_reached", "S", "ACTION", "Cycle 1: the job of spindle S is done"),
        ("timer", "3 START", "ACTION", "Cycle 1: #TIMER START of timer 3"),
        ("timer", "3 READ 17", "ACTION", "Cycle 1: #TIMER READ of timer 3: 17 ms"),
        ("H", "33 1 426098", "ACTION", "Cycle 1: H33 was output, number 1 of the tick"),
    ],
)
def test_each_event_has_its_level_and_text(kind: str, text: str, level: str, english: str) -> None:
    """RC-603: 1 errors, 2 warnings, 3 management, 4 actions; one line each."""
    report = DiagnosisReport()
    report.add([event(kind, text)])
    (line,) = body(report)
    assert line.split(None, 2)[:2] == ["426098", level]
    assert line.split(None, 2)[2].startswith(english)


@pytest.mark.parametrize("limit", [-1, 0, 1, 2, 3, 4, 5, 99])
def test_the_level_filters_when_the_text_is_made(limit: int) -> None:
    """RC-603, manual 5: what is kept does not depend on the level, what is shown does."""
    report = DiagnosisReport()
    report.initialised(0, 0)
    report.add(
        [
            event("error", "1"),
            event("warning", "2"),
            event("started", "1"),
            event("M", "100 1 0"),
        ]
    )
    levels = [line.level for line in report.lines(limit)]
    every = [3, 3, 1, 2, 3, 4]
    assert levels == [level for level in every if level <= limit]


@pytest.mark.parametrize("limit", [-3, 0])
def test_at_or_below_0_the_header_alone_is_left(limit: int) -> None:
    """RC-603: title, rule, note and the columns' heads."""
    report = manual_example()
    lines = report.render(limit).splitlines()
    assert lines == report.render(3).splitlines()[: len(lines)]
    assert lines[-1] == "-" * 63
    assert len(lines) == 9


def test_the_note_says_what_the_manuals_says() -> None:
    """Manual 5: messages may be missing, and the documentation says how to influence that."""
    english, german = (" ".join(manual_example().render(3, one).split()) for one in ("en", "de"))
    assert "Note: Messages may be hidden here. The documentation of the realtime" in english
    assert "how to influence the diagnosis" in english
    assert "Hinweis: Hier koennen Nachrichten ausgeblendet sein." in german
    assert (
        "Die Dokumentation der Echtzeit-Zyklen sagt, wie sich die Diagnose beeinflussen" in german
    )


def test_the_title_names_the_channel_and_the_lines_do_not() -> None:
    """RC-601: on a machine with several channels, too, cycle 17 of channel 2 is cycle 17."""
    report = DiagnosisReport(channel=2)
    report.add([Event(0, 0, kind, "2:17 PROG", None, "2:17", 2) for kind in ("created", "started")])
    report.add([Event(0, 0, "error", "50879", None, "2:17", 2)])
    found = diagnostic(CYCLE_OPERATION_WITHOUT_RESULT, cycle="2:17", operation="/")
    lines = [line.split(None, 2)[2] for line in report.render(4, details=[found]).splitlines()[-3:]]
    assert lines[:2] == ["Cycle 17 was created with PROG validity", "Cycle 17 was started"]
    assert "cycle 17" in lines[2] and "2:17" not in lines[2]


def test_a_user_error_is_an_action_and_what_it_says() -> None:
    """RC-603, manual 5: #ERROR is listed at its own level, and among the actions of level 4."""
    report = DiagnosisReport()
    report.add([event("user_error", "7 0"), event("user_error", "8 2")])
    assert [line.level for line in report.lines(3)] == [2, 1]
    assert [line.level for line in report.lines(4)] == [2, 4, 1, 4]
    assert body(report)[3].endswith("Cycle 1: #ERROR with ID 8 and RC 2")


def test_spindles_and_timers_of_the_program_make_no_line() -> None:
    """Manual 5: level 4 reports the actions of cycles."""
    report = DiagnosisReport()
    report.add([event("spindle", "S M3 100", cycle=""), event("spindle_reached", "S", cycle="")])
    assert report.lines(4) == []


def test_motions_in_german() -> None:
    """RC-601: the same lines in the other language."""
    report = DiagnosisReport()
    for text in ("Z begun 900", "A begun positive", "Z stopped"):
        report.add([event("axis", text)])
    assert [line.split(None, 2)[2] for line in body(report, "de")] == [
        "Zyklus 1: Achse Z faehrt auf 900",
        "Zyklus 1: Achse A faehrt endlos in positiver Richtung",
        "Zyklus 1: die Bewegung der Achse Z ist zum Stehen gekommen",
    ]


def test_what_is_not_the_cycles_makes_no_line() -> None:
    """Messages, program ends, and outputs of the main program are no diagnosis data."""
    report = DiagnosisReport()
    report.add([event(kind, "m 5", cycle="") for kind in ("message", "output", "end")])
    report.add([event("written", "V.E.VALUE 5", cycle=""), event("user_error", "7 1", cycle="")])
    assert report.lines(4) == []


def test_an_error_is_reported_with_its_text() -> None:
    """RC-602: what the error says comes after its number, in the requested language."""
    place = Span("part.nc", 5, 3, 4)
    report = DiagnosisReport()
    report.add([Event(1, 1000, "error", "900510", place, "1")])
    other = diagnostic(INVALID_TIME, Span("part.nc", 6, 3, 9), text="never")
    found = diagnostic(INVALID_TIME, Span("part.nc", 5, 1, 9), text="soon")
    assert report.render(1, "en", [other, found]).endswith("900510: 'soon' is not a valid time\n")
    assert report.render(1, "de", [found]).endswith("900510: 'soon' ist keine gültige Zeit\n")
    assert report.render(1, "en", [other]).endswith("900510\n")


def test_a_sink_keeps_everything() -> None:
    """RC-603: a level that is written meanwhile decides about nothing that is kept."""
    sink = DiagnosisSink(DiagnosisReport())
    sink.open(TraceHeader(1000, ()))
    sink.events([event("written", "V.RTG.CYCLES.DIAG_LEVEL 0"), event("M", "102 1 0")])
    assert [line.split(": ", 1)[1][:4] for line in body(sink.report)] == ["V.RT", "M102"]


@pytest.mark.parametrize("extra", [-1, 0, 1])
def test_the_ring_is_bounded(extra: int) -> None:
    """RC-603: at the bound all lines are there, one more pushes out the oldest and is reported."""
    report = DiagnosisReport()
    for number in range(DIAGNOSIS_CAPACITY + extra):
        report.add([event("started", "1", time_us=number)])
    kept = report.lines(3)
    assert len(kept) == min(DIAGNOSIS_CAPACITY, DIAGNOSIS_CAPACITY + extra)
    assert kept[0].time_us == max(0, extra)
    assert ("newest 1000 messages of each level are kept; older ones: 1" in report.render(3)) == (
        extra > 0
    )


def test_actions_push_out_no_other_lines() -> None:
    """RC-603: each level has its own bound; what is not shown does not count as missing."""
    report = DiagnosisReport(capacity=2)
    report.add([event("created", "1 PROG"), *(event("M", "1 1 0") for _ in range(5))])
    assert [line.level for line in report.lines(4)] == [3, 4, 4]
    assert "older ones: 3" in report.render(4)
    assert "older ones" not in report.render(3)


def test_lines_of_several_chunks_keep_their_order() -> None:
    """The levels are kept apart and shown together, as they happened."""
    report = DiagnosisReport()
    for _ in range(2):
        report.add([event("M", "1 1 0"), event("held", "1"), event("M", "2 1 0")])
    assert [line.level for line in report.lines(4)] == [4, 3, 4, 4, 3, 4]
