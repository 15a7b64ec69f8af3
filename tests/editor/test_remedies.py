# SPDX-License-Identifier: MIT
"""Code actions: each edit is applied, and the changed text checked again."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Diagnostic, Range, TextEdit

from nctakt.base.diagnostics import Severity
from nctakt.editor.document import Document, uri_of
from nctakt.editor.edits.remedies import actions
from nctakt.editor.workspace import Workspace
from nctakt.lists.machine.files import DEMO_FOLDER

WORK = Workspace()
CYCLE, END = "#RT CYCLE [ID=1 SCOPE=PROG]\n", "#RT CYCLE END\nG01 X10 F1000\nM30\n"


def opened(text: str, path: Path | None = None) -> Document:
    uri = "untitled:1" if path is None else uri_of(path)
    name = "1" if path is None else path.as_posix()
    return Document(uri, path, name, "nctakt", 0, text.split("\n"))


def applied(text: str, edits: list[TextEdit]) -> str:
    """The text after edits, from the last one to the first."""

    def offset(line: int, character: int) -> int:
        return sum(len(one) + 1 for one in text.split("\n")[:line]) + character

    def ends(area: Range) -> tuple[int, int]:
        return offset(area.start.line, area.start.character), offset(
            area.end.line, area.end.character
        )

    for edit in sorted(edits, key=lambda edit: ends(edit.range), reverse=True):
        start, end = ends(edit.range)
        text = text[:start] + edit.new_text + text[end:]
    return text


def remedies(text: str, number: int, path: Path | None = None) -> dict[str, list[str]]:
    """The titles of the actions for a finding with the texts that result, and their findings."""
    document = opened(text, path)
    found = [item for item in WORK.check(document) if item.id == number]
    assert found, [item.id for item in WORK.check(document)]
    shown = [(item, Diagnostic(document.range_of(item.span), "")) for item in found[:1]]
    results: dict[str, list[str]] = {}
    for action in actions(document, shown, WORK.machine_of(document), "en"):
        assert action.edit is not None
        assert action.edit.changes is not None
        if document.uri in action.edit.changes and not action.title.startswith("Ignore"):
            new = applied(text, list(action.edit.changes[document.uri]))
            if path is not None:
                path.write_text(new)
            again = [
                str(item.id)
                for item in WORK.check(opened(new, path))
                if item.severity is Severity.ERROR or item.id == number
            ]
            assert again == [], (action.title, new, again)
            results[action.title] = new.split("\n")
    return results


def test_an_if_with_frequency_gets_branches_of_its_own() -> None:
    """22022 (RC-203): each branch asks for what the earlier ones leave; or no frequency."""
    body = (
        "  $IF EDGE V.E.COUNT > 1 ; first\n    M100\n  $ELSEIF V.E.COUNT < 0\n    M101\n"
        "  $ELSE ; else\n    V.E.SYNC = 1\n  $ENDIF\n"
    )
    found = remedies(CYCLE + body + END, 22022)
    assert found["Write a second $IF EDGE"][1:10] == [
        "  $IF EDGE V.E.COUNT > 1 ; first",
        "    M100",
        "  $ENDIF",
        "  $IF EDGE NOT [V.E.COUNT > 1] && [V.E.COUNT < 0]",
        "    M101",
        "  $ENDIF",
        "  $IF EDGE NOT [V.E.COUNT > 1] && NOT [V.E.COUNT < 0] ; else",
        "    V.E.SYNC = 1",
        "  $ENDIF",
    ]
    assert found["Remove EDGE"][1] == "  $IF V.E.COUNT > 1 ; first"


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("  M100\n", ["  $IF ONCE 1\n    M100\n  $ENDIF"]),
        (
            "  $IF V.E.COUNT > 1\n    M100\n  $ENDIF\n",
            [
                "  $IF EDGE V.E.COUNT > 1\n    M100\n  $ENDIF",
                "  $IF ONCE V.E.COUNT > 1\n    M100\n  $ENDIF",
            ],
        ),
        (
            "  $IF V.E.COUNT > 1\n    V.E.SYNC = 2\n  $ELSE\n    M100\n  $ENDIF\n",
            [
                f"  $IF {word} V.E.COUNT > 1\n    V.E.SYNC = 2\n  $ENDIF\n"
                f"  $IF {word} NOT [V.E.COUNT > 1]\n    M100\n  $ENDIF"
                for word in ("EDGE", "ONCE")
            ],
        ),
        (
            "  $IF ALWAYS V.E.COUNT > 1\n    M100\n  $ENDIF\n",
            [
                "  $IF EDGE V.E.COUNT > 1\n    M100\n  $ENDIF",
                "  $IF ONCE V.E.COUNT > 1\n    M100\n  $ENDIF",
            ],
        ),
    ],
)
def test_a_function_of_each_tick_gets_a_frequency(body: str, expected: list[str]) -> None:
    """900243 (RC-403)."""
    found = remedies(CYCLE + body + END, 900243)
    after = END.count("\n") + 1
    assert ["\n".join(lines[1:-after]) for lines in found.values()] == expected


@pytest.mark.parametrize(
    ("body", "new"),
    [
        ("  $IF EDGE V.E.COUNT > 1\n    N10 G00 X10 Y=P1+2\n  $ENDIF\n", 2),
        ("  G91 G01 X10 F600\n", 1),
    ],
)
def test_words_of_the_path_become_independent_motions(body: str, new: int) -> None:
    """22002 (RC-405): POS with G90 or G91, rapid or with FEED."""
    expected = {
        2: "    N10 X[INDP G90 G00 POS=10] Y[INDP G90 G00 POS=P1+2]",
        1: "  X[INDP G91 G01 FEED=600 POS=10]",
    }
    found = remedies(CYCLE + body + END, 22002)
    title = next(title for title in found if title.startswith("Move alone"))
    assert found[title][new] == expected[new]


@pytest.mark.parametrize(
    "statement", ["#FLUSH", "G17", "$FOR P1 = 0, 3, 1\n    V.E.COUNT = P1\n  $ENDFOR"]
)
def test_what_a_cycle_cannot_do_moves_to_after_it(statement: str) -> None:
    """22002 (RC-201): the statement as a whole, with its structure."""
    found = remedies(f"{CYCLE}  {statement}\n  V.E.SYNC = 1\n{END}", 22002)
    lines = found["Move it to after #RT CYCLE END"]
    assert lines[:3] == [CYCLE.strip(), "  V.E.SYNC = 1", "#RT CYCLE END"]
    assert "\n".join(lines[3:]) == statement.replace("\n  ", "\n") + END.removeprefix(
        "#RT CYCLE END"
    )


def test_a_query_is_read_before_the_cycle() -> None:
    """Queries of names belong to the decoder: a free parameter holds the answer."""
    body = "  $IF EDGE V.E.COUNT > 1 && EXIST[V.P.SIZE]\n    M100\n  $ENDIF\n"
    document = f"P4 = 1\n{CYCLE}{body}{END}"
    number = next(i.id for i in WORK.check(opened(document)) if i.severity is Severity.ERROR)
    (lines,) = remedies(document, number).values()
    assert lines[1] == "P5 = EXIST[V.P.SIZE]"
    assert lines[3] == "  $IF EDGE V.E.COUNT > 1 && P5"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('#MSG ["%ld mm", P1]', '#MSG ["%d mm", P1]'),
        ('#MSG ["100%: %d", P1]', '#MSG ["100%%: %d", P1]'),
        ('#MSG ["%F and %k", P1, P2]', '#MSG ["%f and %f", P1, P2]'),
        ('#MSG ["%5.2k", P1]', '#MSG ["%5.2f", P1]'),
        ('#MSG ["%d%", P1]', '#MSG ["%d%%", P1]'),
        ('#MSG ["is %k", V.E.TEXT]', '#MSG ["is %s", V.E.TEXT]'),
    ],
)
def test_placeholders_fit_the_values(text: str, expected: str) -> None:
    """21180: a placeholder for each value, all other signs doubled."""
    (lines,) = remedies(f"{text}\nM30\n", 21180).values()
    assert lines[0] == expected


def test_a_g_function_gets_its_program(tmp_path: Path) -> None:
    """20131 (P-CHAN-00160 …): a program of the folder, by #FILE NAME or in the channel list."""
    shutil.copytree(DEMO_FOLDER, tmp_path / "machine")
    (tmp_path / "nctakt.toml").write_text('machine = "machine"\n')
    for name in ("other.nc", "drill_80.nc"):
        (tmp_path / name).write_text("M17\n")
    program = tmp_path / "part.nc"
    text = "  G80\nM30\n"
    program.write_text(text)
    found = remedies(text, 20131, program)
    assert [lines[0] for lines in found.values()] == [
        '  #FILE NAME [G80="drill_80.nc"]',
        '  #FILE NAME [G80="other.nc"]',
    ]
    program.write_text(text)
    document = opened(text, program)
    item = next(item for item in WORK.check(document) if item.id == 20131)
    shown = Diagnostic(document.range_of(item.span), "")
    loaded = WORK.machine_of(document)
    edit = next(
        action.edit
        for action in actions(document, [(item, shown)], loaded, "en")
        if action.title.startswith("Call drill_80.nc: g80_prog_file in ")
    )
    assert edit is not None
    assert edit.changes is not None
    ((uri, edits),) = edit.changes.items()
    changed = next(path for _, path in loaded.machine.configuration.lists if uri_of(path) == uri)
    changed.write_text(applied(changed.read_text("utf-8"), list(edits)), "utf-8")
    assert [item.id for item in WORK.check(opened(text, program)) if item.id == 20131] == []
