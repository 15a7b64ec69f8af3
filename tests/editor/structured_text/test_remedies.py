# SPDX-License-Identifier: MIT
"""Code actions of Structured Text: each edit is applied, and the changed text checked again."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Diagnostic, TextDocumentContentChangePartial
from support.editor_client import Editor, types
from support.plc_text import pou_file
from support.structured_documents import Typed

from nctakt.editor.document import Document

HEAD = "PROGRAM MAIN\nVAR\n    n : INT;\n    nLarge : DINT;\n    b : BOOL;\nEND_VAR\n"


def remedies(folder: Path, files: dict[str, str], name: str, number: int) -> dict[str, str]:
    """The titles of the actions for the first finding of a number, with the texts that result.

    A check that restarts must lack the finding, and have none that was not there before.
    """
    typed = Typed(folder, files)
    document = typed.documents[name]
    before = typed.checked()
    found = [one for one in typed.projects.findings(document) if one.id == number]
    assert found, before
    shown = Diagnostic(document.range_of(found[0].span), "")
    results: dict[str, str] = {}
    begin = document.text()
    for action in typed.answers.actions(document, [(found[0], shown)], "en"):
        assert action.edit is not None
        assert action.edit.changes is not None
        changed = Document("", None, "", "", 0, begin.split("\n"))
        edits = sorted(
            action.edit.changes[document.uri],
            key=lambda one: (one.range.start.line, one.range.start.character),
            reverse=True,
        )
        for edit in edits:
            changed.change(TextDocumentContentChangePartial(edit.range, edit.new_text))
        typed.put(name, changed.text())
        after = typed.checked()
        assert sum(map(len, after.values())) < sum(map(len, before.values())), (action.title, after)
        results[action.title] = changed.text()
        typed.put(name, begin)
    assert typed.checked() == before
    return results


def body(folder: Path, statements: str, number: int, head: str = HEAD) -> dict[str, str]:
    """The bodies that actions make of statements of MAIN."""
    text = f"{head}{statements}\nEND_PROGRAM\n"
    found = remedies(folder, {"main.st": text}, "main.st", number)
    return {
        title: new.removeprefix(head).removesuffix("\nEND_PROGRAM\n")
        for title, new in found.items()
    }


@pytest.mark.parametrize(
    ("statements", "number", "title", "new"),
    [
        ("nLarg := 1;", 902190, "Write nLarge", "nLarge := 1;"),
        ("n := 1\nb := TRUE;", 902177, "Insert ;", "n := 1;\nb := TRUE;"),
        ("n := 1 // one\n;b := TRUE", 902177, "Insert ;", "n := 1 // one\n;b := TRUE;"),
        ("n := 1 (* a *) // one\nb := b;", 902177, "Insert ;", "n := 1; (* a *) // one\nb := b;"),
        ("IF b\n  n := 1;\nEND_IF", 902177, "Insert THEN", "IF b THEN\n  n := 1;\nEND_IF"),
        ("n := (n + 1;", 902177, "Insert )", "n := (n + 1);"),
        (
            "IF b THEN\n    n := 1;\nn := 2;",
            902181,
            "Insert END_IF",
            "IF b THEN\n    n := 1;\nEND_IF\nn := 2;",
        ),
        (
            "FOR n := 1 TO 9 DO\n  IF b THEN\n    n := n;\n  ELSE\n    b := b;\nEND_FOR",
            902181,
            "Insert END_IF",
            "FOR n := 1 TO 9 DO\n  IF b THEN\n    n := n;\n  ELSE\n    b := b;\n  END_IF\nEND_FOR",
        ),
        ("n = 1;", 902182, "Write :=", "n := 1;"),
        ("n := nLarge;", 902204, "Write TO_INT(nLarge)", "n := TO_INT(nLarge);"),
        ("n := nLarge + 1;", 902204, "Write TO_INT(nLarge + 1)", "n := TO_INT(nLarge + 1);"),
        ("IF n THEN\nEND_IF", 902213, "Write n <> 0", "IF n <> 0 THEN\nEND_IF"),
        ("IF n + 1 THEN\nEND_IF", 902213, "Write (n + 1) <> 0", "IF (n + 1) <> 0 THEN\nEND_IF"),
        ("n := nLarge^;", 902217, "Remove ^", None),
        ("n := n^;", 902217, "Remove ^", "n := n;"),
        ("n := 1; §", 902170, "Remove §", "n := 1; "),
        ("{attribute 'x'\nn := 1;", 902169, "Insert }", "{attribute 'x'}\nn := 1;"),
    ],
)
def test_what_is_written_wrong_is_written_right(
    tmp_path: Path, statements: str, number: int, title: str, new: str | None
) -> None:
    """One edit, after which the check (ST-306, 501 … 512) lacks the finding; none that adds one."""
    assert body(tmp_path, statements, number).get(title) == new


@pytest.mark.parametrize(
    ("statements", "written"),
    [
        ("nNew := n;", "nNew : INT;"),
        ("fNew := 1.5;", "fNew : LREAL;"),
        ("nNew := 70000;", "nNew : DINT;"),
        ("nLarge := nNew;", "nNew : DINT;"),
        ("IF bNew THEN\nEND_IF", "bNew : BOOL;"),
        ("IF NOT bNew AND b THEN\nEND_IF", "bNew : BOOL;"),
        ("WHILE nNew < nLarge DO\nEXIT;\nEND_WHILE", "nNew : DINT;"),
        ("FOR i := 0 TO 9 DO\nEND_FOR", "i : INT;"),
        ("sNew := 'abc';", "sNew : STRING(3);"),
    ],
)
def test_a_name_is_declared_with_the_type_that_its_use_tells(
    tmp_path: Path, statements: str, written: str
) -> None:
    """In the VAR block of its unit, after the other variables (ST-401)."""
    text = f"{HEAD}{statements}\nEND_PROGRAM\n"
    found = remedies(tmp_path, {"main.st": text}, "main.st", 902190)
    head = HEAD.replace("END_VAR", f"    {written}\nEND_VAR")
    assert found[f"Declare {written}"] == f"{head}{statements}\nEND_PROGRAM\n"


def test_a_method_without_variables_gets_a_block(tmp_path: Path) -> None:
    """After its inputs, or after its header; an action declares in its block."""
    text = (
        "FUNCTION_BLOCK FB\n    METHOD Run : BOOL\n    VAR_INPUT\n        nIn : INT;\n"
        "    END_VAR\n    nNew := nIn;\n    END_METHOD\nEND_FUNCTION_BLOCK\n"
    )
    (found,) = remedies(tmp_path, {"fb.st": text}, "fb.st", 902190).values()
    block = "    VAR\n        nNew : INT;\n    END_VAR\n"
    assert found == text.replace("    nNew :=", f"{block}    nNew :=")
    text = "FUNCTION_BLOCK FB\nACTION Run\nbNew := TRUE;\nEND_ACTION\nEND_FUNCTION_BLOCK\n"
    (found,) = remedies(tmp_path, {"fb.st": text}, "fb.st", 902190).values()
    assert found == text.replace("FB\n", "FB\nVAR\n    bNew : BOOL;\nEND_VAR\n")


def test_what_its_use_does_not_tell_is_not_declared(tmp_path: Path) -> None:
    """Neither what is called nor what has members: any type could be meant."""
    assert body(tmp_path, "fbGate(bOpen := TRUE);", 902190) == {}
    assert body(tmp_path, "nLarge := stPart.nNumber;", 902190) == {}


def test_a_declaration_in_xml_goes_into_the_text_of_the_declaration(tmp_path: Path) -> None:
    """Nothing else of the file changes (ST-102)."""
    text = pou_file("MAIN", "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\n", "m := n;")
    (found,) = remedies(tmp_path, {"MAIN.TcPOU": text}, "MAIN.TcPOU", 902190).values()
    assert found == text.replace("INT;\nEND_VAR", "INT;\n    m : INT;\nEND_VAR")
    text = text.replace("</Declaration>\n", "</Declaration>")  # two texts on one line
    (found,) = remedies(tmp_path, {"MAIN.TcPOU": text}, "MAIN.TcPOU", 902190).values()
    assert found == text.replace("INT;\nEND_VAR", "INT;\n    m : INT;\nEND_VAR")
    text = pou_file("MAIN", "PROGRAM MAIN", "m := 1;\nIF m > 1 THEN\n    m := 2;")
    found = remedies(tmp_path, {"MAIN.TcPOU": text}, "MAIN.TcPOU", 902181)
    assert found["Insert END_IF"] == text.replace("m := 2;", "m := 2;\nEND_IF")


def test_a_name_of_a_list_gets_its_list(tmp_path: Path) -> None:
    """Of several lists each is offered (ST-203)."""
    lists = "{attribute 'qualified_only'}\nVAR_GLOBAL\n    nLimit : INT;\nEND_VAR"
    file = (
        '<TcPlcObject><GVL Name="%s"><Declaration><![CDATA['
        f"{lists}]]></Declaration></GVL></TcPlcObject>"
    )
    text = f"{HEAD}n := nLimit;\nEND_PROGRAM\n"
    files = {"GVL.TcGVL": file % "GVL", "main.st": text}
    found = remedies(tmp_path, files, "main.st", 902193)
    assert found == {"Write GVL.nLimit": text.replace("nLimit", "GVL.nLimit")}
    plain = {
        f"{name}.TcGVL": (file % name).replace("{attribute 'qualified_only'}\n", "")
        for name in ("GVL", "Other")
    }
    found = remedies(tmp_path, {**plain, "main.st": text}, "main.st", 902194)
    assert sorted(found) == ["Write GVL.nLimit", "Write Other.nLimit"]


def test_members_types_and_arguments_are_named_as_they_are_declared(tmp_path: Path) -> None:
    """The nearest name of each kind."""
    text = (
        "TYPE ST_Part : STRUCT\n    nNumber : INT;\nEND_STRUCT\nEND_TYPE\n"
        "FUNCTION Twice : INT\nVAR_INPUT\n    nValue : INT;\nEND_VAR\nTwice := nValue;\n"
        "END_FUNCTION\nPROGRAM MAIN\nVAR\n    st : ST_Part;\n    n : INT;\nEND_VAR\n"
        "n := st.nNumbr;\nn := Twice(nValu := 1);\nEND_PROGRAM\n"
    )
    files = {"main.st": text}
    found = remedies(tmp_path, files, "main.st", 902196)
    assert found == {"Write nNumber": text.replace("nNumbr;", "nNumber;")}
    found = remedies(tmp_path, files, "main.st", 902229)
    assert found == {"Write nValue": text.replace("nValu :", "nValue :")}
    text = text.replace("Numbr", "Number").replace("nValu ", "nValue ")
    text = text.replace("st : ST_Part", "st : ST_Prt")
    found = remedies(tmp_path, {"main.st": text}, "main.st", 902191)
    assert found == {"Write ST_Part": text.replace("ST_Prt", "ST_Part")}


def test_an_editor_gets_the_actions_of_a_line(in_editor: Callable[..., None]) -> None:
    """Only those of the findings in the range that it asks for; the titles in its language."""

    async def script(editor: Editor) -> None:
        text = f"{HEAD}nLarg := 1;\nn := 1\nEND_PROGRAM\n"
        uri = await editor.open("main.st", text)
        place = types.Position(7, 2)
        found = await editor.client.text_document_code_action_async(
            types.CodeActionParams(
                types.TextDocumentIdentifier(uri),
                types.Range(place, place),
                types.CodeActionContext([]),
            )
        )
        assert [(one.title, one.is_preferred) for one in found] == [("Insert ;", True)]
        (edit,) = found[0].edit.changes[uri]
        assert (edit.new_text, edit.range.start) == (";", types.Position(7, 6))

    in_editor(script)


def test_a_slip_that_other_findings_would_follow_is_not_offered(tmp_path: Path) -> None:
    """The nearest name has a type that does not fit: no edit makes it right."""
    found = body(tmp_path, "bb := 1.5;", 902190)
    assert list(found) == ["Declare bb : LREAL;"]
