# SPDX-License-Identifier: MIT
"""What the live page shows, without a browser: marks of the program, curves, lists, fields."""

import shutil
import time
from pathlib import Path

import pytest
from support.insides import audience_of, kill_controller

from nctakt import NcText, Session
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.live import track, view
from nctakt.live.conditions import conditions_of
from nctakt.live.document import Checker, Document
from nctakt.live.parts.keys import GROUPS, KEYS
from nctakt.live.shared import SharedSession
from nctakt.live.texts import Texts
from nctakt.live.view import LogRow, Snapshot
from nctakt.messages import diagnostic
from nctakt.messages.machines.lists import TEXT_NOT_UTF8
from nctakt.messages.programs.decoder import NO_FEED_ACTIVE
from nctakt.results.compared import Compared
from nctakt.results.trace.event_words import event_words
from nctakt.results.trace.events import Event
from nctakt.session.engine import BranchState, CycleState
from nctakt.session.listening import MAX_NOTICES

pytestmark = pytest.mark.slow

LINES = [
    "#RT CYCLE [ID=1 SCOPE=PROG]",
    "$IF V.E.VALUE > 0.5 ; V.E.COUNT",
    "#RT CYCLE END",
    "G01 X9",
]
FILE = "part.nc"
TEXTS = Texts("en")


def branch(
    truth: bool | None,
    *,
    has_run: bool = False,
    count: int = 0,
    seen: Compared | None = None,
    now: Compared | None = None,
) -> BranchState:
    """A branch in line 2, evaluated in tick 4 if at all."""
    span, at = Span(FILE, 2, 1, 4), None if seen is None else 4
    return BranchState(span, "", truth, truth is not None, has_run, count, at, seen, now)


def snapshot(*branches: BranchState, state: str = "running") -> Snapshot:
    """A session in line 4, before tick 5."""
    cycle = CycleState("1", state, "PROG", Span(FILE, 1, 1, 4), 3, branches)
    blocks = {1: Span(FILE, 4, 1, 4)}
    return Snapshot(1, 1, 5, 5, 1, False, None, {}, blocks, {}, [cycle], [])


@pytest.mark.parametrize(
    ("state", "shown"),
    [
        (branch(True, has_run=True), "nc-true nc-ran"),
        (branch(True), "nc-true"),
        (branch(False), "nc-false"),
        (branch(None), "nc-unknown"),
    ],
)
def test_a_condition_is_coloured_by_its_truth(state: BranchState, shown: str) -> None:
    """Also a condition that holds while its body does not run (ONCE, EDGE)."""
    assert view.truth_class(state) == shown


def test_marks_of_the_program() -> None:
    """The current block, the condition, and beside it what it saw in its tick, and its runs."""
    seen = Compared(">", True, 0.75, 0.5)
    state = branch(True, count=3, seen=seen, now=seen)
    found = view.program_marks(LINES, FILE, snapshot(state), TEXTS)
    block, line, beside = found
    assert block["class"] == "nc-block"
    assert line == {"line": 2, "class": "nc-true"}
    text = "true in tick 4: 0.75 > 0.5 · ran 3×"
    assert beside == {"line": 2, "class": "nc-inline", "text": text}


def test_values_that_have_changed_since_the_evaluation_are_marked() -> None:
    """The present values are beside those of the evaluation; an ended cycle is grey."""
    seen = Compared(">", True, 0.75, 0.5)
    state = branch(True, count=3, seen=seen, now=Compared(">", False, 0.25, 0.5))
    *_, line, widget = view.program_marks(LINES, FILE, snapshot(state), TEXTS)
    assert widget["text"] == "true in tick 4: 0.75 > 0.5 · now false: 0.25 > 0.5 · ran 3×"
    assert (line["class"], widget["class"]) == ("nc-true", "nc-inline nc-moved")
    state = branch(True, count=3, seen=seen)
    *_, line, widget = view.program_marks(LINES, FILE, snapshot(state, state="ended"), Texts("de"))
    assert widget["text"] == "wahr in Takt 4: 0.75 > 0.5 · jetzt nicht definiert · lief 3×"
    assert line["class"] == "nc-unknown"


def test_a_difference_below_the_shown_digits_is_no_change() -> None:
    """``60 > 50 · now true: 60 > 50`` would ask the reader to see what cannot be seen."""
    seen, now = (Compared(">", True, value, 50) for value in (59.9999999999, 60.0))
    assert str(seen) == str(now)
    state = branch(True, count=3, seen=seen, now=now)
    *_, widget = view.program_marks(LINES, FILE, snapshot(state), TEXTS)
    assert widget["text"] == "true in tick 4: 60 > 50 · ran 3×"
    assert widget["class"] == "nc-inline"


def test_a_living_cycle_is_shown_before_an_ended_one_of_its_line() -> None:
    living = snapshot(branch(False)).cycles
    ended = snapshot(branch(True), state="ended").cycles
    assert view.truths([*living, *ended], FILE) == {2: False}
    assert view.truths([*ended, *living], FILE) == {2: False}


def test_a_cycle_that_has_ended_has_no_truth_in_the_lanes() -> None:
    """In the tick in which the program ends its cycles are not evaluated, so no lane goes on."""
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF V.RTA.ACS.ACT_POS.X > 5\nV.E.COUNT += 1\n$ENDIF\n"
    with Session(NcText(FILE, f"{cycle}#RT CYCLE END\nG01 X9 F6000\nM30\n")) as session:
        session.run()
        cycles = session.state_view().cycles
        assert [one.state for one in cycles] == ["ended"]
        assert [one.truth for one in cycles[0].branches] == [True]  # of its last evaluation
        assert view.truths(cycles, FILE) == {2: None}


@pytest.mark.parametrize(
    ("axes", "placed"),
    [
        (["X", "Y", "Z", "C"], ("X", "Y", "Z")),
        (["Z2", "X2"], ("X2", None, "Z2")),
        (["U", "X"], ("U", None, None)),
        (["C", "A"], (None, None, None)),
    ],
)
def test_axes_of_other_channels_are_placed_by_their_letters(
    axes: list[str], placed: tuple[str | None, ...]
) -> None:
    """U, V, W as X, Y, Z; the first of several; rotary axes are not drawn."""
    assert view.placed_axes(axes) == placed


def test_marks_of_another_file_are_not_shown() -> None:
    """A subprogram is not in the editor."""
    assert view.program_marks(LINES, "other.nc", snapshot(branch(True)), TEXTS) == []


def test_findings_are_underlined() -> None:
    """Where they are in the text; at the end of a line its last character."""
    found = [
        diagnostic(NO_FEED_ACTIVE, Span(FILE, line, column, column + 3), LINES[line - 1])
        for line, column in ((1, 2), (4, 8))
    ]
    marks = view.finding_marks(LINES, FILE, found, "de")
    assert [(one["line"], one["from"], one["to"]) for one in marks] == [(1, 1, 4), (4, 5, 6)]
    (first, _), one = marks, found[0]
    assert first["text"] == f"{one.id}: {one.text('de')}"
    assert first["remedy"] == one.remedy("de")
    assert view.finding_marks(LINES, "other.nc", found, "en") == []


def test_first_signals() -> None:
    """Axes that the program moves, the path's speed, variables that it names."""
    units = dict.fromkeys(
        ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "PATH.SPEED", "V.E.VALUE", "V.E.COUNT"], ""
    )
    assert view.axes_of(units) == ["X", "Y"]
    assert view.first_signals(units, LINES) == ["X.ACS.ACT_POS", "PATH.SPEED", "V.E.VALUE"]


def test_fields_by_types() -> None:
    """A switch for a truth value; variables that the program names come first; texts have none."""
    types = [("V.E.FLAG", "BOOLEAN"), ("V.E.TEXT", "STRING"), ("V.E.VALUE", "REAL64")]
    rows = view.variable_rows([*types, ("V.E.COUNT", "SGN32")], LINES)
    assert [(row.name, row.field) for row in rows] == [
        ("V.E.VALUE", "number"),
        ("V.E.FLAG", "switch"),
        ("V.E.COUNT", "integer"),
    ]


def test_a_finding_of_the_lists_is_shown_once(tmp_path: Path) -> None:
    """The machine has it before the run, and the run's first ticks report it again."""
    folder = tmp_path / "machine"
    shutil.copytree(DEMO_FOLDER, folder)
    axis = folder / "achs_mds1.lis"
    axis.write_bytes("# für X\n".encode("cp1252") + axis.read_bytes())

    def opener(program: str | None, acknowledges: bool) -> Session:
        return Session(NcText(FILE, "G01 X9 F6000\nM30"), machine=folder, acknowledges=acknowledges)

    shared = SharedSession(opener, FILE, acknowledges=True)
    try:
        shared.do(lambda session: session.step(3))
        with shared.lock:
            assert shared.snapshot_of(None).tick == 3
        of_axis = [one for one in shared.diagnostics if one.id == TEXT_NOT_UTF8.id]
        (row,) = view.finding_rows(of_axis, FILE, "en")
        assert row.outside == f"{axis.as_posix()}:1"
    finally:
        shared.close()


def test_a_shared_session_follows_commands() -> None:
    """What a command has done is in the next look; a run anew begins at tick 0."""
    text = "\n".join([*LINES[:2], "V.E.COUNT += 1", "$ENDIF", *LINES[2:], "M30"])

    def opener(program: str | None, acknowledges: bool) -> Session:
        return Session(NcText(FILE, text), acknowledges=acknowledges)

    shared = SharedSession(opener, FILE, acknowledges=True)
    try:
        shared.do(lambda session: session.step(3))
        shared.do(lambda session: session.write({"V.E.VALUE": 1}, "page"))
        shared.do(lambda session: session.step(1))
        with shared.lock:
            shown = shared.snapshot_of(None)
        assert shown.tick == 4
        assert shown.values["V.E.COUNT"] == 1
        (state,) = shown.cycles[-1].branches
        assert (state.evaluated_at, str(state.seen)) == (3, "1 > 0.5")
        assert shown.shown_tick == 3
        end_s = time.monotonic() + 60
        while len(shared.track.rows) < 4 and time.monotonic() < end_s:
            time.sleep(0.02)  # the curves of the past come after the state
        assert [row[0] for row in shared.track.rows.entries()] == [0, 1, 2, 3]
        shared.reopen()
        assert shared.snapshot.tick == 0
        assert shared.snapshot.serial == 2
    finally:
        shared.close()


def test_another_channel_can_be_shown() -> None:
    """Its axes, its variables, its program; inputs name it."""
    folder = Path(__file__).parents[1] / "runs" / "two_channels"
    files = {number: str(folder / name) for number, name in ((1, "one.nc"), (2, "two.nc"))}

    def opener(program: str | None, acknowledges: bool) -> Session:
        channels = {number: [file] for number, file in files.items()}
        return Session(channels=channels, machine=folder / "machine", acknowledges=acknowledges)

    shared = SharedSession(opener, files[1], acknowledges=True)
    try:
        shared.look_at(2, files[2])
        shared.do(lambda session: session.run("2 ticks"))
        with shared.lock:
            shown = shared.snapshot_of(None)
        assert shared.channel.prefix == "CH2."
        assert shared.channel.axes == ["X"]
        assert shared.scope[-1] == "CH2.V.E.OWN"
        assert shown.values["CH2.V.E.OWN"] == 20
        assert shown.blocks[2].file == files[2]
        shared.acknowledge_after(5)
        assert {one.values[0] for one in shared.session.tape()} == {
            "CH1.HLI.PLC_PRESENT",
            "CH2.HLI.PLC_PRESENT",
        }
    finally:
        shared.close()


def test_rows_come_as_increments() -> None:
    """A browser gets what it lacks; all of it after a change of what is shown."""
    rows = track.Growing(4)
    rows.add([(0, 1.0), (1, 2.0)])
    news, seen = rows.news((0, 0))
    assert news == {"whole": True, "added": [(0, 1.0), (1, 2.0)]}
    assert rows.news(seen) == (None, seen)
    rows.add([(2, 3.0)])
    news, seen = rows.news(seen)
    assert news == {"whole": False, "added": [(2, 3.0)]}
    rows.add([(tick, 0.0) for tick in range(3, 9)])
    news, seen = rows.news(seen)
    assert news is not None
    assert [tick for tick, _ in news["added"]] == [5, 6, 7, 8]  # the others are forgotten
    rows.cut(7)
    news, _ = rows.news(seen)
    assert news == {"whole": True, "added": [(5, 0.0), (6, 0.0)]}


def test_stops_of_lines() -> None:
    """A line with a condition stops when its branch fires, another one when its block comes up."""
    assert view.stop_for(FILE, 2, LINES[1]) == "fires part.nc:2"
    assert view.stop_for(FILE, 4, LINES[3]) == "line part.nc:4"
    stops = ["fires part.nc:2", "line 4", "line other.nc:1", "V.E.COUNT > 3"]
    assert view.stop_lines(stops, FILE) == [2, 4]
    assert [one.line for one in conditions_of(["$IF 1", *LINES])] == [3]


def test_rows_name_the_file_that_is_not_the_program_that_is_shown() -> None:
    """A line without a file is one of the program; a line of a list cannot be clicked."""
    found = [
        diagnostic(NO_FEED_ACTIVE, Span("listen/hochlauf.lis", 3, 1, 2)),
        diagnostic(NO_FEED_ACTIVE, Span("plc/cell.st", 55, 1, 2)),
        diagnostic(NO_FEED_ACTIVE, Span(FILE, 4, 1, 4)),
        diagnostic(NO_FEED_ACTIVE, Span("listen/sda_mds1.lis", 0, 0, 0)),
        diagnostic(NO_FEED_ACTIVE),
    ]
    rows = view.finding_rows(found, FILE, "en", ["plc/cell.st"])
    assert [(row.line, row.file, row.outside) for row in rows] == [
        (0, "", ""),
        (4, "", ""),
        (0, "", "listen/hochlauf.lis:3"),
        (0, "", "listen/sda_mds1.lis"),
        (55, "plc/cell.st", "plc/cell.st:55"),
    ]
    answered = Event(3, 3000, "acknowledged", "M 100 0 2000", Span("plc/cell.st", 55, 1, 2))
    row = view.event_row(answered, "de", FILE, ["plc/cell.st"])
    assert (row.text, row.outside) == ("3  quittiert M100", "plc/cell.st:55")
    assert view.event_row(answered, "de", FILE).outside == "plc/cell.st:55"
    of_program = Event(3, 3000, "fired", "17 line 2", Span(FILE, 2, 1, 4))
    assert (view.event_row(of_program, "de", FILE).line, row.line) == (2, 55)


def test_events_in_words() -> None:
    """In both languages; names, messages and values stay as they are."""
    span = Span(FILE, 6, 1, 2)
    fired = Event(3, 3000, "fired", "17 line 6", span, "17")
    assert event_words(fired, "en") == "reaction 17"
    assert event_words(fired, "de") == "Reaktion 17"
    ended = Event(3, 3000, "ended", "17 delete", span, "17", 2)
    assert event_words(ended, "de") == "CH2 Zyklus beendet 17 durch DELETE"
    assert event_words(Event(3, 3000, "message", "done"), "de") == "Meldung done"
    assert event_words(Event(3, 3000, "output", "M 7"), "de") == "an die SPS M7"


def test_words_and_keys_are_complete() -> None:
    """Each key has a word for the help; no key is twice."""
    for language in ("en", "de"):
        texts = Texts(language)  # type: ignore[arg-type]
        for heading, keys in GROUPS:
            assert texts[heading]
            assert all(texts[key.command] for key in keys)
    assert len(KEYS) == sum(len(keys) for _, keys in GROUPS)


def test_a_program_is_saved_as_it_was(tmp_path: Path) -> None:
    """Ends of lines and encoding stay; a file that has changed meanwhile stays (901162)."""
    path = tmp_path / "part.nc"
    path.write_bytes("G01 X1 (größer)\r\nM30\r\n".encode("cp1252"))
    document = Document(str(path), Checker(None, [tmp_path]))
    assert document.text == "G01 X1 (größer)\nM30"
    document.save("G01 X2 (größer)\nM30", document.text)
    assert path.read_bytes() == "G01 X2 (größer)\r\nM30\r\n".encode("cp1252")
    assert [found.id for found in document.check("G01 X[\nM30")] == [20397]
    path.write_text("M30\n", "utf-8")
    with pytest.raises(Failure, match="901162"):
        document.save("G01 X3", document.text)
    assert path.read_text("utf-8") == "M30\n"


def test_what_another_browser_has_saved_is_not_written_over(tmp_path: Path) -> None:
    """901162."""
    path = tmp_path / "part.nc"
    path.write_text("G01 X1\nM30\n", "utf-8")
    document = Document(str(path), Checker(None, [tmp_path]))
    begin = document.text
    document.save("G01 X2\nM30", begin)
    with pytest.raises(Failure, match="901162"):
        document.save("G01 X3\nM30", begin)
    assert path.read_text("utf-8") == "G01 X2\nM30\n"


def test_empty_lines_at_the_end_of_a_program_stay(tmp_path: Path) -> None:
    path = tmp_path / "part.nc"
    path.write_text("G01 X1\nM30\n", "utf-8")
    document = Document(str(path), Checker(None, [tmp_path]))
    document.save(document.text + "\n", document.text)
    assert document.text == "G01 X1\nM30\n"
    assert Document(str(path), document.checker).text == document.text


ENDLESS = "\n".join([*LINES[:2], "$ENDIF", LINES[2], "$WHILE 1", "G01 X9 F600", "X0", "$ENDWHILE"])


def endless(program: str | None, acknowledges: bool) -> Session:
    return Session(NcText(FILE, ENDLESS), until="24 h", acknowledges=acknowledges)


def test_a_report_is_of_its_moment() -> None:
    """Also where the session has gone on; the lanes are those of the farthest one."""
    shared = SharedSession(endless, FILE, acknowledges=True)
    try:
        shared.do(lambda session: session.step(100))
        moment = shared.snapshot.serial, 1, 100
        shared.do(lambda session: session.step(50))
        report = shared.explainer.report(moment, shared.session)
        assert report.ticks == 100
        moment = shared.snapshot.serial, 1, 150
        assert shared.explainer.report(moment, shared.session).ticks == 150
        assert shared.explainer.report(moment, shared.session) is not report
        lines = [{"line": 2, "first": 0, "bars": []}]
        assert shared.explainer.bars(moment, FILE) == {"end": 150, "lines": lines}
    finally:
        shared.close()


def test_a_controller_that_is_lost_is_reported_once() -> None:
    shared = SharedSession(endless, FILE, acknowledges=True)
    try:
        kill_controller(shared.session)
        end_s = time.monotonic() + 60
        for _ in range(20):
            with pytest.raises(Failure, match="901153"):
                shared.do(lambda session: session.step(1))
            time.sleep(0.02)
        while not shared.log.messages and time.monotonic() < end_s:
            time.sleep(0.02)
        texts = [row.text for row in shared.log.messages if isinstance(row, LogRow)]
        assert texts
        assert len(texts) == len(set(texts))  # each reason of the system once
    finally:
        shared.close()


def test_a_page_that_did_not_keep_up_listens_anew() -> None:
    """Whoever leaves too many notices unread is reported no more."""
    shared = SharedSession(endless, FILE, acknowledges=True)
    try:
        audience = audience_of(shared.session)
        shared.do(lambda session: session.step(1))
        with shared.lock:
            for _ in range(MAX_NOTICES + 100):
                audience.report_travel()
        shared.do(lambda session: session.play(1.0))
        end_s = time.monotonic() + 60
        while time.monotonic() < end_s:
            if shared.snapshot.tick >= 100 and audience.count == 1:
                break
            time.sleep(0.02)
        assert shared.snapshot.tick >= 100
        assert audience.count == 1
    finally:
        shared.close()
