# SPDX-License-Identifier: MIT
"""Text -> tree: what is read, where mistakes are reported, what is refused by name."""

from __future__ import annotations

import pytest
from support.plc_text import body_errors, check, check_files, errors, messages, pou_file

from nctakt.base.diagnostics import Severity
from nctakt.st.tree import Assignment, Binary, Name, Operator, Unary
from nctakt.st.types import Kind


def test_comments_nest_and_hide_nothing_in_strings() -> None:
    """ST-202: ``//``, ``(* *)`` nested, ``/* */``; none of them begins in a string."""
    body = "s := 'a // b (* c'; (* one (* two *) still *) n := 1; // end\n/* n := X; */ n := 2;"
    assert body_errors("s : STRING; n : INT;", body) == []
    assert body_errors("n : INT;", "n := 1; (* open (* twice *)\nn := 2;")[0].startswith(
        "5: this comment is not closed"
    )


def test_names_are_not_case_sensitive_and_a_point_means_global() -> None:
    """ST-201: keywords and names in any case; a local name hides a global one but for ``.name``."""
    text = """VAR_GLOBAL nValue : STRING; END_VAR
program Main
var nvalue : INT; END_VAR
NVALUE := 3;
.nValue := 'x';
End_Program
"""
    assert errors(text) == []


@pytest.mark.parametrize(
    ("literal", "kind", "value"),
    [
        ("16#FF_FF", "DINT", 65535), ("2#1010", "INT", 10), ("1_000", "INT", 1000),
        ("INT#-5", "INT", -5), ("BYTE#16#FF", "BYTE", 255), ("REAL#1.0", "REAL", 1.0),
        ("1.5E-3", "LREAL", 0.0015), ("T#1d2h3m4s5ms", "TIME", 93784005), ("t#1.5s", "TIME", 1500),
        ("TIME#90m", "TIME", 5400000), ("LTIME#1us2ns", "LTIME", 1002),
        ("D#2024-02-29", "DATE", 1709164800), ("TOD#12:34:56.789", "TIME_OF_DAY", 45296789),
        ("DT#2024-02-29-12:34:56", "DATE_AND_TIME", 1709210096), ("BOOL#1", "BOOL", True),
        ("'a$41$$$N'", "STRING(4)", b"aA$\n"), ('"ab"', "WSTRING(2)", b"a\0b\0"),
    ],
)  # fmt: skip
def test_literals_have_type_and_value(literal: str, kind: str, value: object) -> None:
    """ST-206 … 208, with the dates reckoned by hand from 1970-01-01."""
    program, found = check(
        f"FUNCTION F : BOOL\nVAR v : DINT; END_VAR\nREPEAT v := SIZEOF({literal});\n"
        "UNTIL TRUE END_REPEAT\nEND_FUNCTION"
    )
    assert found == []
    node = program.pous["f"].body[0].body[0].value.operands[0]  # type: ignore[attr-defined]
    assert (node.type.name, node.value) == (kind, value)


@pytest.mark.parametrize(
    ("literal", "number"),
    [
        ("T#1s2h", "duration"),
        ("D#2023-02-29", "date"),
        ("T#1.5h3m", "duration"),
        ("'$X'", "string"),
    ],
)
def test_wrong_literals_are_reported(literal: str, number: str) -> None:
    """ST-207, ST-208: units from large to small, days that exist, known escapes."""
    assert f"is not a valid {number}" in body_errors("x : LREAL;", f"x := {literal};")[0]


def test_operators_bind_in_their_order() -> None:
    """ST-501: NOT before comparison, AND before XOR before OR, from left to right."""
    program, _ = check(
        "FUNCTION F : BOOL\nVAR a, b, c : BOOL; END_VAR\nF := NOT a = b OR b AND c;\nEND_FUNCTION"
    )
    value = program.pous["f"].body[0].value  # type: ignore[attr-defined]
    assert isinstance(value, Binary)
    assert value.operator is Operator.OR
    left, right = value.left, value.right
    assert isinstance(left, Binary)
    assert isinstance(left.left, Unary)
    assert isinstance(right, Binary)
    assert (left.operator, right.operator) == (Operator.EQUAL, Operator.AND)


def test_all_mistakes_are_reported_and_reading_goes_on() -> None:
    """ST-1001: after a syntax error at the next statement, in the next object too."""
    text = """PROGRAM MAIN
VAR n : INT; m : ; k : INT; END_VAR
n := * 2;
n = 3;
IF n > 1 THEN k := 1
n := unknown;
END_PROGRAM
FUNCTION F : INT
F := 'x';
END_FUNCTION
"""
    assert [one.split(":")[0] for one in errors(text)] == ["2", "3", "4", "5", "7", "6", "9"]


def test_lone_expressions_and_comparisons_have_their_advice() -> None:
    """ST-514: C0020, with ``:=`` as advice for ``x = 2``."""
    _, found = check("PROGRAM MAIN\nVAR n : INT; END_VAR\nn = 2;\nn + 1;\nEND_PROGRAM")
    assert ["C0020" in one.text() for one in found] == [True, True]
    assert ":=" in found[0].remedy()


@pytest.mark.parametrize(
    ("body", "word"),
    [
        ("JMP again;", "JMP"), ("again: n := 1;", "again"), ("__TRY n := 1; __ENDTRY", "__TRY"),
        ("p := __NEW(INT);", "__NEW"), ("__DELETE(p);", "__DELETE"), ("n := BITADR(n);", "BITADR"),
        ("x := n ** 2;", ""), ("%QX0.0 := TRUE;", "%QX0.0"),
    ],
)  # fmt: skip
def test_what_is_refused_is_named(body: str, word: str) -> None:
    """ST-513, ST-561, ST-620, ST-315, ST-402: one message; ``**`` in plain text only."""
    found = body_errors("n : INT; x : LREAL; p : POINTER TO INT;", body)
    assert (len(found), word in found[0] if found else True) == (1 if word else 0, True)


def test_graphical_languages_are_refused_by_name() -> None:
    """ST-104: that object only; its interface stays known, the others are checked."""
    text = pou_file("FB_Net", "FUNCTION_BLOCK FB_Net\nVAR_INPUT a : INT; END_VAR", "")
    text = text.replace("<ST><![CDATA[]]></ST>", "<NWL><XmlArchive/></NWL>")
    main = pou_file("MAIN", "PROGRAM MAIN\nVAR f : FB_Net; END_VAR", "f(a := 1);\nf(b := 2);")
    program, found = check_files({"FB_Net.TcPOU": text, "MAIN.TcPOU": main})
    assert [(one.span.file, one.span.line) for one in found if one.span] == [
        ("FB_Net.TcPOU", 6),
        ("MAIN.TcPOU", 7),
    ]
    assert "networks" in found[0].text()
    assert program.pous["fb_net"].is_refused


def test_positions_are_those_of_the_file_and_of_the_object() -> None:
    """ST-103: line and column in the file, and the object's own line."""
    text = pou_file("MAIN", "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR", "n := 1;\n  n := TRUE;")
    _, found = check_files({"MAIN.TcPOU": b"\xef\xbb\xbf" + text.encode().replace(b"\n", b"\r\n")})
    span = found[0].span
    assert span is not None
    assert (span.line, span.column, found[0].source_line) == (
        9,
        8,
        "  n := TRUE;]]></ST></Implementation>",
    )
    assert found[0].text().endswith("(MAIN, implementation line 2)")
    assert found[0].text("de").endswith("(MAIN, Implementierung Zeile 2)")


def test_texts_without_cdata_have_exact_positions() -> None:
    """ST-103: entities in a text do not shift what follows them."""
    text = pou_file("MAIN", "PROGRAM MAIN\nVAR n : BOOL; END_VAR", "")
    text = text.replace("<![CDATA[]]>", "n := 1 &lt; 2 AND 3;")
    span = check_files({"MAIN.TcPOU": text})[1][0].span
    assert span is not None
    assert (
        text.splitlines()[span.line - 1][span.column - 1 :].startswith("n := 1") or span.column > 1
    )


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE x [<!ENTITY a "b">]><TcPlcObject/>',
        '<!DOCTYPE x SYSTEM "http://example.com/x.dtd"><TcPlcObject/>',
        "<a>" * 300,
    ],
)
def test_xml_is_read_safely(text: str) -> None:
    """ST-102: no document types, no entities, no depth without bound."""
    _, found = check_files({"MAIN.TcPOU": text})
    assert [one.severity for one in found] == [Severity.ERROR]


def test_conditions_choose_text() -> None:
    """ST-205: defined, hasvalue, NOT, AND; what does not count is not read."""
    body = """{define FAST 'yes'}
{IF defined(FAST) AND NOT defined(OTHER)} n := 1; {ELSE} n := ; {END_IF}
{IF hasvalue(FAST, 'no')} n := ; {ELSIF defined(NCTAKT)} n := 3; {ELSE} n := ; {END_IF}
{IF defined(type: E_None)} {IF defined(FAST)} n := ; {END_IF} n := ; {END_IF}"""
    assert body_errors("n : INT;", body) == []
    assert "cannot be evaluated" in messages("n : INT;", "{IF moon} n := ; {END_IF}")[0]


def test_attributes_belong_to_what_follows() -> None:
    """ST-204: of variables, POUs and types; others are without effect."""
    text = """{attribute 'qualified_only'}
{attribute 'strict'}
TYPE E_Gate : (Open, Shut) BYTE; END_TYPE
FUNCTION_BLOCK FB_A
VAR {attribute 'hide'} a : INT; b : INT; END_VAR
END_FUNCTION_BLOCK
"""
    program, found = check(text)
    assert found == []
    members = program.pous["fb_a"].members
    assert (members["a"].attributes, members["b"].attributes) == ({"hide": ""}, {})
    assert program.types["e_gate"].is_strict  # type: ignore[attr-defined]


def test_plain_text_has_members_actions_and_tasks() -> None:
    """ST-105, ST-106: members before or after the body; CONFIGURATION gives the tasks."""
    text = """FUNCTION_BLOCK FB_A
VAR n : INT; END_VAR
METHOD PUBLIC Up : INT
n := n + 1;
Up := n;
END_METHOD
ACTION Clear: n := 0; END_ACTION
Up();
END_FUNCTION_BLOCK
PROGRAM PRG_Slow
VAR f : FB_A; END_VAR
f(); f.Clear();
END_PROGRAM
CONFIGURATION C
RESOURCE R ON PLC
TASK Slow (INTERVAL := T#20MS, PRIORITY := 3);
PROGRAM P WITH Slow : PRG_Slow;
END_RESOURCE
END_CONFIGURATION
"""
    program, found = check(text)
    assert found == []
    assert [
        (t.name, t.cycle_us, t.priority, [p.name for p in t.programs]) for t in program.tasks
    ] == [("Slow", 20_000, 3, ["PRG_Slow"])]
    assert program.pous["fb_a"].methods["clear"].is_action


def test_a_program_without_a_task_runs_each_ten_milliseconds() -> None:
    """ST-803: MAIN in a task of 10 ms."""
    program, _ = check("PROGRAM MAIN\nEND_PROGRAM\nPROGRAM PRG_Other\nEND_PROGRAM")
    assert [(task.cycle_us, task.programs[0].name) for task in program.tasks] == [(10_000, "MAIN")]
    assert program.pous["main"].kind is Kind.PROGRAM


def test_nesting_is_bounded() -> None:
    """Brackets, statements and chains of operators beyond the bounds end in a message."""
    assert "nested deeper" in body_errors("n : INT;", f"n := {'(' * 500}1{')' * 500};")[0]
    assert "nested deeper" in body_errors("b : BOOL;", "IF b THEN " * 300)[0]
    assert "operators in a row" in body_errors("n : INT;", f"n := 1{' + 1' * 5000};")[0]
    assert "nested deeper" in body_errors("n : INT;", f"n := {'NOT ' * 900}n;")[0]


def test_name_holds_its_text() -> None:
    """A name is as it is written."""
    program, _ = check("PROGRAM MAIN\nVAR nValue : INT; END_VAR\nNVALUE := 1;\nEND_PROGRAM")
    statement = program.pous["main"].body[0]
    assert isinstance(statement, Assignment)
    assert isinstance(statement.target, Name)
    assert statement.target.name == "NVALUE"


def test_the_folder_of_libraries_is_read() -> None:
    """What is built in has no its own mistakes."""
    program, found = check(
        "PROGRAM MAIN\nVAR t : TON; s : STRING; END_VAR\nt(IN := TRUE);\n"
        "s := CONCAT(s, 'x');\nEND_PROGRAM"
    )
    assert found == []
    assert program.pous["ton"].library == "Tc2_Standard"
