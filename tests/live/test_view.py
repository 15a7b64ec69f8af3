# SPDX-License-Identifier: MIT
"""What the live page shows, without a browser: marks of the program, curves, lists, fields."""

from pathlib import Path

import pytest

from nctakt import NcText, Session
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.live import view
from nctakt.live.document import Checker, Document
from nctakt.live.shared import SharedSession
from nctakt.live.texts import Texts
from nctakt.live.view import Snapshot
from nctakt.session.engine import BranchState, CycleState

pytestmark = pytest.mark.slow

LINES = [
    "#RT CYCLE [ID=1 SCOPE=PROG]",
    "$IF V.E.VALUE > 0.5 ; V.E.COUNT",
    "#RT CYCLE END",
    "G01 X9",
]
FILE = "part.nc"
TEXTS = Texts("en")


def branch(truth: bool | None, *, has_run: bool = False, count: int = 0) -> BranchState:
    """A branch in line 2."""
    return BranchState(Span(FILE, 2, 1, 4), "", truth, truth is not None, has_run, count)


def snapshot(*branches: BranchState, **operands: float) -> Snapshot:
    """A session that stands in line 4."""
    cycle = CycleState("1", "running", "PROG", Span(FILE, 1, 1, 4), 3, branches)
    named = {name.replace("_", "."): value for name, value in operands.items()}
    blocks = {1: Span(FILE, 4, 1, 4)}
    return Snapshot(1, 1, 5, 5, 1, False, None, {}, blocks, {}, [cycle], [], named)


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
    """The current block, the condition, and beside it runs and operands, comments left out."""
    found = view.program_marks(LINES, FILE, snapshot(branch(True, count=3), V_E_VALUE=0.75), TEXTS)
    assert [(one["kind"], one["class"]) for one in found] == [
        ("line", "nc-block"),
        ("line", "nc-true"),
        ("widget", "nc-inline"),
    ]
    assert found[2]["text"] == "true · 3×   VALUE = 0.75"
    assert found[2]["position"] == len("\n".join(LINES[:2]))


def test_marks_of_another_file_are_not_shown() -> None:
    """A subprogram is not in the editor."""
    assert view.program_marks(LINES, "other.nc", snapshot(branch(True)), TEXTS) == []


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
        with shared._lock:
            shown = shared._look(None)
        assert shown.tick == 4
        assert shown.values["V.E.COUNT"] == 1
        assert shown.operands == {"V.E.VALUE": 1.0}
        assert [row[0] for row in shared.track.rows.entries()] == [0, 1, 2, 3]
        shared.reopen()
        assert shared.snapshot.tick == 0
        assert shared.snapshot.serial == 2
    finally:
        shared.close()


def test_a_program_is_saved_as_it_was(tmp_path: Path) -> None:
    """Ends of lines and encoding stay; a file that has changed meanwhile stays (901162)."""
    path = tmp_path / "part.nc"
    path.write_bytes("G01 X1 (größer)\r\nM30\r\n".encode("cp1252"))
    document = Document(str(path), Checker(None, [tmp_path]))
    assert document.text == "G01 X1 (größer)\nM30"
    document.save("G01 X2 (größer)\nM30")
    assert path.read_bytes() == "G01 X2 (größer)\r\nM30\r\n".encode("cp1252")
    assert [found.id for found in document.check("G01 X[\nM30")] == [20397]
    path.write_text("M30\n", "utf-8")
    with pytest.raises(Failure, match="901162"):
        document.save("G01 X3")
    assert path.read_text("utf-8") == "M30\n"
