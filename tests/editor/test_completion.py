# SPDX-License-Identifier: MIT
"""Completion by context: what the checker permits at the cursor, the best first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import CompletionItem, InsertTextFormat, Position

from nctakt.base.diagnostics import Severity
from nctakt.editor.completing.completion import complete
from nctakt.editor.document import Document
from nctakt.editor.workspace import Workspace

HEAD = """\
P1 = 5
#VAR
V.P.SIZE = 10
#ENDVAR
G01 X10 F1000
G01 X20 F1000 S2000
G01 X20 F500
$IF V.RTA.ACS.ACT_POS.Y > 5
$ENDIF
"""
CYCLE = "#RT CYCLE [ID=1 SCOPE=PROG]\n"
END = "#RT CYCLE END\nM30\n"
WORK = Workspace()


def opened(text: str) -> Document:
    return Document("untitled:1", None, "1", "nctakt", 0, text.split("\n"))


def items(text: str, *, has_snippets: bool = False) -> list[CompletionItem]:
    document = opened(HEAD + text)
    line = len(document.lines) - 1
    end = Position(line, len(document.lines[line]))
    machine = WORK.machine_of(document).machine
    found = complete(document, end, machine, "en", has_snippets=has_snippets)
    return sorted(found, key=lambda item: item.sort_text or "")


def labels(text: str) -> list[str]:
    return [item.label for item in items(text)]


def errors(lines: Sequence[str], before: str, after: str) -> list[str]:
    """The errors of a program that has these lines, with what they say."""
    text = HEAD + before + "\n".join(lines) + "\n" + after
    return [
        f"{item.id} {item.text('en')}"
        for item in WORK.check(opened(text))
        if item.severity is Severity.ERROR
    ]


def is_variable(label: str) -> bool:
    return label.count(".") > 1 or label[1:].isdigit()


@pytest.mark.parametrize(
    ("before", "form", "after", "chosen"),
    [
        pytest.param("", "P2 = {}", "M30\n", is_variable, marks=pytest.mark.nightly),
        pytest.param("", "$IF {}", "M30\n", is_variable, marks=pytest.mark.nightly),
        (CYCLE, "V.E.COUNT = {}", END, is_variable),
        (CYCLE, "M{}", END, lambda label: int(label[1:]) not in (3, 4, 19)),
        ("", "M{}", "M30\n", lambda label: True),
        ("", "#RT CYCLE DELETE [ID={}", "M30\n", lambda label: True),
    ],
)
def test_what_is_offered_the_checker_accepts(
    before: str, form: str, after: str, chosen: Callable[[str], bool]
) -> None:
    """Rights and kinds of variables (RC-303, RC-301, RC-208), functions in cycles (RC-403)."""
    written = form.split("{", maxsplit=1)[0]
    found = [label for label in labels(before + written) if chosen(label)]
    assert found or "DELETE" in form
    ends = {"$": " > 0 $GOTO [THERE]\n[THERE]", "#": "]"}
    lines = []
    for label in found:
        line = form.replace("{}", label.removeprefix("M"))
        lines.append(line + ends.get(form[0], "").replace("THERE", f"THERE{len(lines)}"))
    texts = [item for item in errors(lines, before, after) if "text" not in item]
    assert texts == []


@pytest.mark.parametrize(("before", "after"), [("", "M30\n"), (CYCLE, END)])
def test_variables_at_the_start_of_a_line_can_be_written(before: str, after: str) -> None:
    """Rights (RC-303); a cycle writes no asynchronous variable (RC-301)."""
    found = [label for label in labels(before + "V.") if is_variable(label)]
    assert "V.E.COUNT" in found
    texts = {"V.E.TEXT", "V.E.LEVEL_1_A[0].STRING", "V.CH.Level.STRING"}
    lines = [f"{label} = 1" for label in found if label not in texts]
    assert errors(lines, before, after) == []
    assert ("V.E.ASYNC" in found, "V.P.SIZE" in found) == ((not before,) * 2)


def test_a_condition_of_a_cycle_reads_first_what_changes() -> None:
    """Frequencies (RC-203), synchronous variables, those in use first, then frozen ones."""
    found = items(CYCLE + "  $IF ")
    order = [item.label for item in found]
    assert order[:4] == ["EDGE", "ONCE", "ALWAYS", "V.RTA.ACS.ACT_POS.Y"]
    assert order.index("V.RTA.ACS.CUR_POS.X") < order.index("V.E.ASYNC") < order.index("P1")
    frozen = {item.label: item.detail or "" for item in found}
    assert "read once, when the cycle is defined" in frozen["V.E.ASYNC"]
    assert "read once" not in frozen["V.E.COUNT"]
    assert "SIN" in order
    assert not {"EXIST", "M100", "X", "G01"} & set(order)
    assert not {"EDGE", "ONCE"} & set(labels("$IF "))
    assert "EDGE" not in labels(CYCLE + "  $IF EDGE ")


def test_a_statement_of_a_cycle_begins_with_what_it_writes() -> None:
    """Variables before functions and axes, and first those in use in the program."""
    order = labels(CYCLE + "  V.E.TRIGGER = 1\n  ")
    assert order[0] == "V.E.TRIGGER"
    assert order.index("V.E.COUNT") < order.index("M100") < order.index("X")
    assert labels("")[0] == "G00"


def test_commands_and_control_words_by_context() -> None:
    """A cycle has $IF, #TIMER with SYN and #ERROR (RC-201 … RC-208); others say how they go on."""
    timers = [f"#TIMER {action} SYN" for action in ("START", "STOP", "READ", "CLEAR")]
    assert labels(CYCLE + "  #") == ["#RT CYCLE END", *timers, "#ERROR"]
    lines = [label + " [ID=1]" for label in labels(CYCLE + "  #")[1:]]
    assert errors(lines, CYCLE, END) == []
    assert labels("#TRAFO ") == ["#TRAFO ON", "#TRAFO OFF"]
    assert labels("#VAR\n#") == ["#ENDVAR"]
    assert labels("#VAR\n") == ["V.P", "V.L", "V.S", "V.CYC"]
    assert labels(CYCLE + "  $") == ["$IF"]
    assert labels(CYCLE + "  $IF P1 > 2\n  $") == ["$ENDIF", "$ELSEIF", "$ELSE", "$IF"]
    assert labels(CYCLE + "  $IF EDGE P1 > 2\n  $") == ["$ENDIF", "$IF"]
    assert labels("$IF P1 > 2\n$ELSE\n$")[:2] == ["$ENDIF", "$IF"]
    assert labels("$SWITCH P1\n$")[:3] == ["$ENDSWITCH", "$CASE", "$DEFAULT"]
    assert labels("$IF P1 > 2 $") == ["$GOTO", "$BREAK", "$CONTINUE"]
    assert labels("#RT CYCLE DELETE [") == ["ID"]
    assert labels("#OVERRIDE [") == ["FEED_FACT", "RAPID_FACT"]


def test_g_m_f_and_s_offer_their_own() -> None:
    """A letter's functions; of F and S the values of the program, the usual one first."""
    assert {label[0] for label in labels("G01 X10 G")} == {"G"}
    assert {label[0] for label in labels("M")} == {"M"}
    assert labels("G01 X10 F") == ["F1000", "F500"]
    assert labels("S") == ["S2000"]
    assert labels(CYCLE + "  G") == []
    assert not {"M30", "M17", "M00"} & set(labels(CYCLE + "  M"))


def test_values_begin_after_words_and_in_brackets() -> None:
    """After ``=``, in ``X[INDP POS=``, ``P[``, ``SIN[``, directly after an axis."""
    for text in ("G01 X=", "X[INDP POS=", "P[", '#MSG ["%d", ', "$FOR P1 = "):
        found = labels(text)
        assert "V.P.SIZE" in found, text
        assert not {"INDP", "G01"} & set(found), text
    assert labels("G01 XV.P.") == ["V.P.SIZE"]
    assert "INDP" in labels("X[")
    assert "G01" not in labels("$FOR ")


@pytest.mark.parametrize(
    "text", ['#MSG ["SIZE ', "G01 (back to ", "; nothing of the kind ", "#COMMENT BEGIN\nG"]
)
def test_texts_and_comments_offer_nothing(text: str) -> None:
    """No words in texts and comments."""
    assert labels(text) == []


def test_snippets_have_gaps_and_only_where_the_editor_knows_them() -> None:
    """``$IF … $ENDIF``, ``#RT CYCLE`` with a free ID; what they write is a program."""
    found = {item.label: item for item in items(CYCLE + END + "#", has_snippets=True)}
    cycle = found["#RT CYCLE … #RT CYCLE END"]
    assert cycle.insert_text_format is InsertTextFormat.Snippet
    assert cycle.text_edit is not None
    assert cycle.text_edit.new_text.startswith("#RT CYCLE [ID=${1:2} SCOPE=")
    found = {item.label: item for item in items(CYCLE + "  $", has_snippets=True)}
    assert list(found) == ["$IF", "$IF … $ENDIF"]
    assert "$IF … $ENDIF" not in labels("$")
