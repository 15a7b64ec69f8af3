# SPDX-License-Identifier: MIT
"""What an editor shows of names: explanations, places, other names, completion, signatures."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Position
from support.plc_text import pou_file
from support.structured_documents import Typed

from nctakt.base.failure import Failure
from nctakt.editor.document import Document, split_text
from nctakt.editor.structured_text.renaming import part_at

CELL = """\
// Steps of the gate.
TYPE E_Gate : (Closed, Moving := 5, Open); END_TYPE
TYPE ST_Part :
STRUCT
    nNumber : UDINT; // counts from 1
    fLength : LREAL;
END_STRUCT
END_TYPE
VAR_GLOBAL CONSTANT
    cMax : INT := 3 * 4; (* parts in a row *)
END_VAR
FUNCTION Twice : INT
VAR_INPUT
    nValue : INT;
END_VAR
Twice := nValue * 2;
END_FUNCTION
(* Opens and closes.
   Waits for both ends. *)
FUNCTION_BLOCK FB_Gate
VAR_INPUT
    bOpen : BOOL; // opens while TRUE
END_VAR
VAR_OUTPUT
    bDone : BOOL;
END_VAR
VAR
    eState : E_Gate;
    nCount : INT;
END_VAR
METHOD Reset : BOOL
VAR_INPUT
    bHard : BOOL;
END_VAR
nCount := 0;
Reset := TRUE;
END_METHOD
METHOD PRIVATE Hidden
END_METHOD
IF bOpen THEN
    eState := E_Gate.Moving;
    nCount := nCount + 1;
END_IF
END_FUNCTION_BLOCK
"""
MAIN = """\
PROGRAM MAIN
VAR
    fbGate : FB_Gate;
    stPart : ST_Part;
    n : INT;
END_VAR
fbGate(bOpen := TRUE);
IF fbGate.bDone THEN
    stPart.nNumber := stPart.nNumber + 1;
    n := Twice(nValue := cMax);
    fbGate.Reset(bHard := FALSE);
END_IF
END_PROGRAM
"""


@pytest.fixture
def typed(tmp_path: Path) -> Typed:
    found = Typed(tmp_path, {"cell.st": CELL, "main.st": MAIN})
    assert found.findings("cell.st") == found.findings("main.st") == []
    return found


def explained(typed: Typed, name: str, before: str, count: int = 1) -> str:
    document, position = typed.at(name, before, count)
    found = typed.answers.hover(document, position, "en")
    return "" if found is None else found.contents.value


def test_an_explanation_has_type_value_and_comments(typed: Typed) -> None:
    """``cMax`` is 12; comments of the line, else those before the declaration."""
    text = explained(typed, "main.st", ":= cM")
    assert "VAR_GLOBAL CONSTANT cMax : INT;" in text
    assert "value `12`" in text
    assert text.endswith("parts in a row")
    assert explained(typed, "main.st", "bOp").endswith("opens while TRUE")
    text = explained(typed, "main.st", "fbGate : FB_G")
    assert "FUNCTION_BLOCK FB_Gate(bOpen : BOOL, bDone => BOOL)" in text
    assert "Opens and closes.  \nWaits for both ends." in text
    assert "E_Gate.Moving := 5" in explained(typed, "cell.st", "E_Gate.Mov")
    assert "counts from 1" in explained(typed, "main.st", "stPart.nN")
    assert explained(typed, "main.st", "IF") == ""


def labels(typed: Typed, name: str, before: str, count: int = 1) -> list[str]:
    document, position = typed.at(name, before, count)
    return [one.label for one in typed.answers.complete(document, position)]


def typed_in(typed: Typed, name: str, after: str, text: str) -> list[str]:
    """What is offered after a text that is put after another one."""
    whole = typed.documents[name].text()
    typed.put(name, whole.replace(after, after + text, 1))
    found = labels(typed, name, after + text)
    typed.put(name, whole)
    return found


def test_after_a_point_there_are_members(typed: Typed) -> None:
    """Inputs, outputs, public methods of an instance; of its own block all; values, members."""
    found = typed_in(typed, "main.st", "THEN\n", "fbGate.")
    assert found[:2] == ["bOpen", "bDone"]
    assert "Reset" in found
    assert "Hidden" not in found
    assert "Hidden" in typed_in(typed, "cell.st", "IF bOpen THEN\n", "THIS^.")
    assert typed_in(typed, "main.st", "THEN\n", "n := E_Gate.") == ["Closed", "Moving", "Open"]
    assert typed_in(typed, "main.st", "THEN\n", "stPart.") == ["nNumber", "fLength"]
    assert typed_in(typed, "main.st", "THEN\n", "n := n.") == []


def test_by_context_there_are_variables_types_and_keywords(typed: Typed) -> None:
    found = typed_in(typed, "main.st", "THEN\n", "st")
    assert "stPart" in found
    found = typed_in(typed, "main.st", "THEN\n", "")
    assert found[:3] == ["fbGate", "stPart", "n"]
    assert {"cMax", "Twice", "IF", "MAX", "E_Gate"} <= set(found)
    found = typed_in(typed, "main.st", "n : INT;\n", "x : ")
    assert {"FB_Gate", "ST_Part", "INT", "TON", "ARRAY"} <= set(found)
    assert not {"IF", "fbGate", "MAIN"} & set(found)
    assert "END_VAR" in typed_in(typed, "main.st", "n : INT;\n", "E")
    assert "bHard := " in typed_in(typed, "main.st", "THEN\n", "fbGate.Reset(")


@pytest.mark.parametrize("text", ["// f", "(* f", "n := 'f", "{attribute 'f"])
def test_in_comments_and_texts_there_is_nothing(typed: Typed, text: str) -> None:
    assert typed_in(typed, "main.st", "THEN\n", text) == []


def test_signatures_of_functions_methods_and_blocks(typed: Typed) -> None:
    document, position = typed.at("main.st", "Twice(nValue := ")
    found = typed.answers.signature(document, position)
    assert found is not None
    assert found.signatures[0].label == "Twice(nValue : INT) : INT"
    assert found.active_parameter == 0
    document, position = typed.at("main.st", "fbGate.Reset(")
    found = typed.answers.signature(document, position)
    assert found is not None
    assert found.signatures[0].label == "FB_Gate.Reset(bHard : BOOL) : BOOL"
    assert typed.answers.signature(*typed.at("main.st", "IF")) is None


def test_definition_and_references(typed: Typed) -> None:
    """Of a method in another file; of a parameter also where it is named in a call."""
    document, position = typed.at("main.st", "fbGate.Res")
    (found,) = typed.answers.definition(document, position)
    assert found.uri == typed.documents["cell.st"].uri
    assert found.range.start.line == CELL[: CELL.index("Reset : BOOL")].count("\n")
    document, position = typed.at("cell.st", "bOpen")
    uses = typed.answers.references(document, position, with_definition=False)
    assert [Path(one.uri).name for one in uses] == ["cell.st", "main.st"]
    marked = typed.answers.highlights(*typed.at("main.st", "stPart"))
    assert len(marked) == 3
    document, position = typed.at("cell.st", "Twice := nV")
    assert len(typed.answers.references(document, position, with_definition=True)) == 3


def renamed(typed: Typed, name: str, before: str, new: str, *programs: Document) -> list[str]:
    """The texts of all files after renaming; they are checked again without findings."""
    document, position = typed.at(name, before)
    edit = typed.answers.rename(document, position, new, lambda: programs)
    assert edit is not None
    texts = {
        one: typed.edited(one, (edit.changes or {}).get(other.uri, []))
        for one, other in typed.documents.items()
    }
    for one, text in texts.items():
        typed.put(one, text)
    assert [typed.findings(one) for one in texts] == [[]] * len(texts)
    return list(texts.values())


def test_a_name_changes_in_all_files(typed: Typed) -> None:
    """An input with the names of its arguments; a function with its result."""
    cell, main = renamed(typed, "cell.st", "bOpen", "bUp")
    assert cell == CELL.replace("bOpen", "bUp")
    assert main == MAIN.replace("bOpen", "bUp")
    cell, main = renamed(typed, "cell.st", "Twi", "Double")
    assert "Double := nValue * 2" in cell
    assert "Double(nValue := cMax)" in main


@pytest.mark.parametrize("is_open", [True, False])
def test_a_name_changes_from_a_comment_of_a_program(tmp_path: Path, is_open: bool) -> None:
    """Each part of the path, in the PLC that is open or that the project file names."""
    typed = Typed(tmp_path, {"cell.st": CELL, "main.st": MAIN} if is_open else {})
    if not is_open:
        (tmp_path / "plc").mkdir()
        (tmp_path / "plc" / "cell.st").write_text(CELL, "utf-8")
        (tmp_path / "plc" / "main.st").write_text(MAIN, "utf-8")
        (tmp_path / "nctakt.toml").write_text('[plc]\nfile = "plc/main.st"\n', "utf-8")
    program = tmp_path / "part.nc"
    text = "M30 ; expect: MAIN.fbGate.nCount = 1\n; MAIN.fbGate.nCount\n"
    nc = Document(program.as_uri(), program, program.as_posix(), "nctakt", 0, split_text(text))
    part = part_at(nc, Position(0, 28))
    assert part is not None and part.path == "MAIN.fbGate.nCount"
    edit = typed.answers.rename_from_program(nc, part, "nMoves", lambda: [nc])
    assert edit is not None and edit.changes is not None
    (found,) = edit.changes.pop(nc.uri)
    assert (found.range.start.line, found.range.start.character) == (0, 26)
    assert [Path(uri).name for uri in edit.changes] == ["cell.st"]
    part = part_at(nc, Position(0, 20))
    assert part is not None and part.path == "MAIN.fbGate"
    with pytest.raises(Failure):
        typed.answers.rename_from_program(nc, part, "IF", lambda: [nc])
    assert part_at(nc, Position(1, 10)) is None


def test_a_name_changes_in_comments_of_programs(typed: Typed) -> None:
    """``; expect:`` names a variable by its path: the variable changes, and not its namesake."""
    program = typed.folder / "part.nc"
    text = "M30\n; expect: MAIN.n = 3\n; expect: MAIN.fbGate.nCount = 1, n\n; MAIN.n\n"
    nc = Document(program.as_uri(), program, program.as_posix(), "nctakt", 0, split_text(text))
    document, position = typed.at("main.st", "    n")
    edit = typed.answers.rename(document, position, "nParts", lambda: [nc])
    assert edit is not None and edit.changes is not None
    (found,) = edit.changes[nc.uri]
    assert (found.range.start.line, found.range.start.character) == (1, 15)
    document, position = typed.at("cell.st", "nCount")
    edit = typed.answers.rename(document, position, "nMoves", lambda: [nc])
    assert edit is not None and edit.changes is not None
    (found,) = edit.changes[nc.uri]
    assert (found.range.start.line, found.range.start.character) == (2, 22)


@pytest.mark.parametrize(
    ("name", "before", "new", "reason"),
    [
        ("cell.st", "nCount", "bDone", "in the same object"),
        ("cell.st", "cMax", "n", "main.st, line 5"),
        ("main.st", "    n", "Twice", "main.st, line 10"),
        ("main.st", "    n", "2n", "a name has letters"),
        ("main.st", "    n", "IF", "a word of the language"),
        ("main.st", "PROGRAM MAIN", "P", "the system calls it by this name"),
    ],
)
def test_what_would_mean_something_else_is_refused(
    typed: Typed, name: str, before: str, new: str, reason: str
) -> None:
    document, position = typed.at(name, before)
    with pytest.raises(Failure) as caught:
        typed.answers.rename(document, position, new, list)
    assert reason in caught.value.diagnostics[0].text()


def test_an_override_changes_with_what_it_overrides(tmp_path: Path) -> None:
    """ST-601: a method of an interface, of the block that has it, and of one that extends that."""
    text = (
        "INTERFACE I_A\nMETHOD Go : BOOL\nEND_METHOD\nEND_INTERFACE\n"
        "FUNCTION_BLOCK FB_A IMPLEMENTS I_A\nMETHOD Go : BOOL\nGo := TRUE;\nEND_METHOD\n"
        "END_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK FB_B EXTENDS FB_A\nMETHOD Go : BOOL\nGo := SUPER^.Go();\nEND_METHOD\n"
        "END_FUNCTION_BLOCK\n"
    )
    typed = Typed(tmp_path, {"a.st": text})
    assert renamed(typed, "a.st", "METHOD G", "Run") == [text.replace("Go", "Run")]


def test_in_an_xml_file_nothing_but_the_name_changes(tmp_path: Path) -> None:
    """Declaration, implementation, the attributes that repeat the name; all else stays."""
    body = "IF bOn THEN\n\n    Act(nStep := 1);\n\nEND_IF"
    method = (
        '<Method Name="Act" Id="{1}">\n<Declaration><![CDATA[METHOD Act : BOOL\n'
        "VAR_INPUT\n    nStep : INT;\nEND_VAR]]></Declaration>\n<Implementation>"
        "<ST><![CDATA[Act := bOn AND nStep &lt; 3;]]></ST></Implementation>\n</Method>\n"
        '<LineIds Name="FB_X">\n<LineId Id="3" Count="0" />\n</LineIds>\n'
        '<LineIds Name="FB_X.Act">\n</LineIds>\n'
    ).replace("&lt;", "<")
    text = pou_file("FB_X", "FUNCTION_BLOCK FB_X\nVAR\n    bOn : BOOL;\nEND_VAR", body, method)
    typed = Typed(tmp_path, {"FB_X.TcPOU": text})
    assert typed.findings("FB_X.TcPOU") == []
    assert "VAR bOn : BOOL;" in explained(typed, "FB_X.TcPOU", "IF b")
    assert "bOn" in typed_in(typed, "FB_X.TcPOU", "IF bOn THEN\n", "b")
    assert renamed(typed, "FB_X.TcPOU", "Act", "Perform") == [text.replace("Act", "Perform")]
    assert renamed(typed, "FB_X.TcPOU", "    bOn", "bRuns")[0].count("bRuns") == 3
    document = typed.documents["FB_X.TcPOU"]
    names = [one.name for one in typed.answers.symbols(document)[0].children or ()]
    assert names == ["bRuns", "Perform"]


def test_the_outline_has_objects_with_what_they_declare(typed: Typed) -> None:
    found = typed.answers.symbols(typed.documents["cell.st"])
    names = {one.name: [child.name for child in one.children or ()] for one in found}
    assert names["FB_Gate"] == ["bOpen", "bDone", "eState", "nCount", "Reset", "Hidden"]
    assert names["E_Gate"] == ["Closed", "Moving", "Open"]
    assert names["VAR_GLOBAL"] == ["cMax"]
    folds = typed.answers.folds(typed.documents["main.st"])
    assert [(one.start_line, one.end_line) for one in folds] == [(0, 12), (1, 5), (7, 11)]
