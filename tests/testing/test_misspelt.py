# SPDX-License-Identifier: MIT
"""What would be checked by nobody: misspelt keywords, branches where there are none."""

from pathlib import Path

import pytest

from nctakt.base.comment_keywords import has_expectation, keyword_near
from nctakt.base.failure import Failure
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.testing.expectations import read_script
from nctakt.testing.queries import run_program
from nctakt.testing.verdict import differences

PROGRAM = (
    "#RT CYCLE [SCOPE=PROG]\n$IF V.RTA.ACS.ACT_POS.X > 1\nM100\n$ENDIF\n#RT CYCLE END\nG00 X5\nM30"
)


@pytest.mark.parametrize("word", ["expct", "exepct", "expects", "Expected", "epxect", "EXPETC"])
def test_a_misspelt_expectation_is_an_error(word: str) -> None:
    """900662 with the place of the word; a file with nothing else is a test all the same."""
    text = f"G00 X5 ; {word}: ended"
    assert has_expectation(text)
    with pytest.raises(Failure) as failure:
        read_script(Path("part.nc"), text)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900662
    assert diagnostic.span is not None
    assert (diagnostic.span.line, diagnostic.span.column) == (1, 10)
    assert "'; expect: …'" in diagnostic.remedy()


@pytest.mark.parametrize("word", ["gvien", "givn", "givens"])
def test_a_misspelt_condition_is_an_error(word: str) -> None:
    """``given`` likewise."""
    with pytest.raises(Failure) as failure:
        read_script(Path("part.nc"), f"; expect: ended\n; {word}: V.E.VALUE = 5\nM30")
    assert [one.id for one in failure.value.diagnostics] == [900662]


@pytest.mark.parametrize("word", ["note", "feed", "spindle", "inspect", "aspect", "tool", "effect"])
def test_other_words_are_comments(word: str) -> None:
    """A comment may have a colon."""
    assert keyword_near(word) == ""
    assert read_script(Path("part.nc"), f"G00 X5 ; {word}: 5").expectations == []


def test_a_line_without_a_branch_is_an_error() -> None:
    """900663 names the lines that have one, whether or not it fired."""
    run = run_program(Controller(), PROGRAM, Path())
    assert run.fired(line=2)
    with pytest.raises(Failure, match="line 99") as failure:
        run.fired(line=99)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900663
    assert diagnostic.remedy() == "Lines with branches: 2."
    assert not run_program(Controller(), PROGRAM.replace("> 1", "> 100"), Path()).fired(line=2)


def found_by_check(text: str) -> list[tuple[int, int, str]]:
    """Number, line and severity of each finding of ``nctakt check`` in a text."""
    result = check_files([NcText("part.nc", text)], AssembledMachine(load_machine(None)))
    found = [one.diagnostic for one in result.findings]
    return [(one.id, one.span.line, one.severity.name) for one in found if one.span is not None]


def test_check_finds_what_no_test_would_look_at() -> None:
    """Misspelt keywords, invalid expectations and inputs, impossible times: each in its line."""
    text = (
        "; expct: ended\nG00 X5 ; expect: fird\nG00 X6 ; given: nothing\nM30 ; expect: X = 1 at 5w"
    )
    assert found_by_check(text) == [
        (900662, 1, "ERROR"),
        (900660, 2, "ERROR"),
        (900661, 3, "ERROR"),
        (900660, 4, "ERROR"),
    ]


def test_check_knows_the_lines_with_branches() -> None:
    """900663 for a named line and for the comment's own; a called file may have the line."""
    lines = PROGRAM.splitlines()
    lines[1] = lines[1].replace("$IF", "$IF ONCE")
    fired = [*lines[:2], "M100 ; expect: fired line 2; expect: fired line 99", *lines[3:]]
    assert found_by_check("\n".join(fired)) == [(900663, 3, "ERROR")]
    own = [*lines[:2], "M100 ; expect: fired", *lines[3:]]
    assert found_by_check("\n".join(own)) == [(900663, 3, "ERROR")]
    calls = [*fired[:-1], 'L "other.nc"', "M30"]
    assert 900663 not in [number for number, _, _ in found_by_check("\n".join(calls))]
    met = PROGRAM.replace("$IF", "$IF ONCE").replace("> 1", "> 1 ; expect: fired")
    assert found_by_check(met) == []


def test_a_run_warns_of_a_misspelt_keyword() -> None:
    """The controller ignores comments, so the program runs."""
    run = Controller().run(NcText("part.nc", "G00 X5 ; expct: ended\nM30"))
    assert run.state == "ended"
    assert [(one.id, one.severity.name) for one in run.diagnostics] == [(900662, "WARNING")]


def test_a_test_names_the_expectation_of_a_line_without_branch() -> None:
    """900663 has the file, line and column of its comment."""
    script = read_script(Path("part.nc"), "M30 ; expect: fired line 99")
    run = run_program(Controller(), PROGRAM, Path())
    (wrong,) = differences(run, script.expectations, "part.nc")
    assert wrong.startswith("part.nc:1:15: error 900663: ")
    assert "^^^^^^^^^^^^^" in wrong


def test_a_misspelt_keyword_is_reported_once() -> None:
    """900662 alone, before or after another part; the wrong value has its own columns."""
    text = "G00 X5 ; expect: X = 0 ende; expct: M100; M5\nM30 ; expct: M5; expect: ended"
    with pytest.raises(Failure) as failure:
        read_script(Path("part.nc"), text)
    found = [(one.id, one.span) for one in failure.value.diagnostics]
    assert [
        (number, span.line, span.column, span.end_column) for number, span in found if span
    ] == [
        (900660, 1, 18, 28),
        (900662, 1, 30, 35),
        (900662, 2, 7, 12),
    ]
    assert "at end" in failure.value.diagnostics[0].remedy()


def places(folder: Path, text: str, **files: str) -> list[tuple[int, int, int]]:
    """Number, line and column of the errors that ``nctakt check`` finds in a program."""
    for name, content in {"part.nc": text, **files}.items():
        (folder / name.replace("_", ".")).write_text(content, "utf-8")
    machine = AssembledMachine(load_machine(None))
    found = [one.diagnostic for one in check_files([folder / "part.nc"], machine).findings]
    return [(one.id, one.span.line, one.span.column) for one in found if one.span is not None]


def test_check_finds_files_that_are_not_there(tmp_path: Path) -> None:
    """902940 for a PLC, a machine, a program of a channel and a log; what is there is none."""
    text = (
        "; given: plc nix.py; given: machine nix\n; given: channel 2 nix.nc\n"
        "; expect: X within 0.1 of nix.csv\n; given: plc default\nM30"
    )
    assert places(tmp_path, text) == [
        (902940, 1, 10),
        (902940, 1, 29),
        (902940, 2, 10),
        (902940, 3, 11),
    ]
    assert places(tmp_path, "; given: plc a.py; given: machine demo\nM30", a_py="") == []
    assert found_by_check("; given: plc nix.py\nM30") == []  # a text lies in no folder


def test_check_knows_the_names_of_the_machine(tmp_path: Path) -> None:
    """Unknown variables and signals; with a PLC it judges only what the machine alone has."""
    text = "; given: V.E.NIX = 1\n; expect: gate.bOpen = TRUE\nM30 ; expect: X = 0; V.E.NIX = 1"
    assert places(tmp_path, text) == [
        (900540, 1, 10),
        (900544, 2, 11),
        (900544, 3, 22),
    ]
    with_plc = f"; given: plc a.py\n{text}"
    assert places(tmp_path, with_plc, a_py="") == [(900540, 2, 10), (900544, 4, 22)]
    assert places(tmp_path, f"; given: machine demo5\n{text}") == []
    project = "; given: gate.bOpen = 1\nM30"
    assert places(tmp_path, project, nctakt_toml='plc = "a.py"\n') == []


def test_check_looks_for_branches_in_called_files(tmp_path: Path) -> None:
    """900663 where all called files are there and none has a branch in the line."""
    called = 'G00 X5 ; expect: fired line 4\nL "a.nc"\nM30'
    cycle = "\n\n#RT CYCLE [SCOPE=PROG]\n$IF ONCE V.RTA.ACS.ACT_POS.X > 1\nM100\n$ENDIF\n"
    assert places(tmp_path, called, a_nc=f"{cycle}#RT CYCLE END\nM29") == []
    assert places(tmp_path, called, a_nc="G00 X1\nM29") == [(900663, 1, 18)]


def test_a_test_names_the_places_of_unknown_names(tmp_path: Path) -> None:
    """What the run refuses has the place of the comment that says it."""
    script = read_script(Path("part.nc"), "; given: V.E.NIX = 1\nM30 ; expect: gate.bOpen = TRUE")
    with pytest.raises(Failure) as failure:
        Controller().run(NcText("part.nc", "M30"), set=script.assignments)
    placed = script.placed(failure.value).diagnostics[0]
    assert placed.headline() == "part.nc:1:10: error 900540: unknown variable V.E.NIX"
    with pytest.raises(Failure) as failure:
        Controller().run(NcText("part.nc", "M30"), signals=["gate.bOpen"])
    placed = script.placed(failure.value).diagnostics[0]
    assert placed.headline() == "part.nc:2:15: error 900544: unknown signal gate.bOpen"
