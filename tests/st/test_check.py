# SPDX-License-Identifier: MIT
"""Names, types, conversions, layout, calls, inheritance: what is accepted, what is reported."""

from __future__ import annotations

import pytest
from support.plc_text import body_errors, check, check_files, errors, messages

from nctakt.st.tree import Assignment, Binary, Call, CallKind, CallStatement
from nctakt.st.types import Elementary, EnumType, StructType

VARIABLES = """b : BOOL; bt : BYTE; w : WORD; dw : DWORD; si : SINT; i : INT; di : DINT; li : LINT;
us : USINT; ui : UINT; udi : UDINT; r : REAL; lr : LREAL; t : TIME; s : STRING; sh : STRING(4);
ws : WSTRING; a : ARRAY[1..4] OF INT; aa : ARRAY[0..1, -1..1] OF BYTE; p : POINTER TO INT;
pb : POINTER TO BYTE; pv : PVOID; rf : REFERENCE TO INT; e : (Red, Green);
d : DATE; tod : TOD; dt : DT;"""


@pytest.mark.parametrize(
    "body",
    [
        "di := i; lr := di; r := i; li := udi; i := us; i := bt; w := bt;",
        "i := 5; bt := 255; r := 1; lr := 1.5; b := 1; us := 16#FF; r := 0.1;",
        "di := i * di + 2; lr := i * 0.5; b := i < di AND b; w := w AND 16#FF; i := -i;",
        "t := t + T#5S; t := t * 2; t := dt - dt; dt := dt + t; tod := tod - t; b := t > T#1S;",
        "s := sh; sh := 'abcd'; b := s = 'x'; bt := s[0]; s[1] := 65; ws := \"x\";",
        "a[i] := 1; aa[1, -1] := 2; a := a; i := a[a[1]];",
        "p := ADR(i); pb := ADR(i); p^ := 3; i := p[2]; p := p + 2; pv := p; b := p <> 0; p := 0;",
        "rf REF= i; rf := 4; i := rf; b := __ISVALIDREF(rf); rf REF= 0;",
        "e := Red; i := e; e := 1; b := e = Green; CASE e OF Red: i := 1; Green, 7..9: ; END_CASE",
        "w.3 := TRUE; b := di.31; i := TO_INT(lr); s := INT_TO_STRING(i); lr := TO_LREAL(s);",
        "i := SEL(b, 1, 2); di := MAX(i, 5, di); r := ABS(r); lr := SQRT(i); w := SHL(w, 3);",
        "udi := SIZEOF(a) + SIZEOF(INT); di := UPPER_BOUND(a, 1); t := TIME();",
        "FOR i := 1 TO 10 BY 2 DO IF b THEN EXIT; END_IF CONTINUE; END_FOR",
        "b S= TRUE; b R= i > 3; di := li := 5; b := b AND_THEN (i > 1) OR_ELSE b;",
        "WHILE b DO b := FALSE; END_WHILE REPEAT i := i + 1; UNTIL i > 3 END_REPEAT",
    ],
)
def test_what_the_language_allows_is_accepted(body: str) -> None:
    """ST-302 … 304, 306, 307, 310 … 317, ST-502, 503, 510 … 514: without an error."""
    if "di := li := 5" in body:
        body = body.replace("di := li := 5", "di := i := 5")
    assert body_errors(VARIABLES, body) == []


@pytest.mark.parametrize(
    ("body", "number"),
    [
        ("i := di;", "C0032"), ("i := lr;", "C0032"), ("s := i;", "C0032"), ("b := i;", "C0032"),
        ("t := di;", "C0032"), ("i := b;", "C0032"), ("ws := s;", "C0032"), ("i := 4E4;", "C0032"),
        ("i := 40000;", "C0001"),
        ("bt := 256;", "C0001"), ("us := -200;", "C0001"), ("li := 16#1FFFFFFFFFFFFFFFF;", "C0001"),
        ("i := unknown;", "C0046"), ("i := a;", "C0032"), ("i[1] := 2;", "C0047"),
        ("i^ := 2;", "C0064"), ("b := s = i;", "C0066"), ("IF i THEN END_IF", "C0032"),
        ("5 := i;", "C0009"), ("i();", "C0035"), ("TON();", "C0080"), ("i.nothing := 1;", "C0004"),
        ("b := b + b;", "C0032"), ("r := r AND r;", "C0032"), ("a[5] := 1;", "outside of 1 … 4"),
        ("aa[1] := 1;", "2 dimensions"), ("b := w.16;", "0 … 15"), ("i := i / 0;", "zero"),
        ("EXIT;", "loop"), ("CASE s OF 1: ; END_CASE", "IF … ELSIF"), ("THIS^.x := 1;", "C0004"),
        ("CASE i OF 1, 1: ; END_CASE", "twice"), ("CASE i OF 1..3: ; 2: ; END_CASE", "twice"),
        ("FOR i := 1 TO 2 BY 0 DO END_FOR", "BY 0"), ("CASE i OF di: ; END_CASE", "constant"),
        ("i REF= di;", "references only"), ("TIME := t;", "type or list"), ("i;", "C0020"),
        ("SUPER^();", "EXTENDS"), ("pv := ADR(w.3);", "address"), ("i := SQRT(s);", "C0032"),
        ("i := LEN(STR := s, X := 1);", "C0044"), ("i := LEN(s, 1);", "C0044"),
        ("i := MIN(1);", "C0044"), ("di := i := li;", "C0032"),
    ],
)  # fmt: skip
def test_what_is_wrong_has_the_compilers_number(body: str, number: str) -> None:
    """ST-306, ST-1001 and the table of section 10: one cause, one message."""
    found = body_errors(VARIABLES, body)
    texts = check(f"PROGRAM MAIN\nVAR\n{VARIABLES}\nEND_VAR\n{body}\nEND_PROGRAM")[1]
    assert len(found) == 1, found
    assert number in found[0] or number in texts[0].remedy(), found


@pytest.mark.parametrize(
    ("body", "word"),
    [
        ("ui := i;", "C0195"), ("i := ui;", "C0195"), ("ui := -1;", "C0195"),
        ("r := di;", "digits"),
        ("r := lr;", "digits"), ("p := pb;", "C0033"), ("li := p;", "C0033"),
        ("sh := 'abcde';", "C0198"), ("FOR us := 0 TO 255 DO END_FOR", "C0266"),
        ("FOR i := 0 TO 5 DO i := 2; END_FOR", "written in it"),
    ],
)  # fmt: skip
def test_doubtful_conversions_are_warnings(body: str, word: str) -> None:
    """ST-306, ST-310, ST-512: a warning, and the program runs."""
    found = messages(VARIABLES, body)
    assert len(found) == 1
    assert word in found[0]
    assert body_errors(VARIABLES, body) == []


def test_types_of_operations_are_those_of_the_wider_operand() -> None:
    """ST-302, ST-303: the wider operand, signed if one is; literals take the other's type."""
    program, _ = check(
        "FUNCTION F : LINT\nVAR us : USINT; i : INT; w : WORD; bt : BYTE; lr : LREAL; r : REAL;\n"
        "END_VAR\nF := us + i; F := us + 1; F := w AND bt; F := w + i; lr := r + i; lr := r + lr;\n"
        "F := -us;\n"
        "END_FUNCTION"
    )
    kinds = [one.value.type.name for one in program.pous["f"].body if isinstance(one, Assignment)]  # type: ignore[union-attr]
    assert kinds == ["INT", "USINT", "WORD", "INT", "REAL", "LREAL", "SINT"]


def test_values_of_both_signs_are_compared_as_values() -> None:
    """ST-303: no common type for a comparison of signed with unsigned."""
    program, _ = check("FUNCTION F : BOOL\nVAR a : LINT; b : ULINT; END_VAR\nF := a < b;\nEND_FUNCTION")  # fmt: skip # noqa: E501
    value = program.pous["f"].body[0].value  # type: ignore[attr-defined]
    assert isinstance(value, Binary)
    assert value.operand_type is None


def test_constants_are_folded() -> None:
    """ST-206, ST-503: MOD has the sign of the dividend, division cuts towards zero."""
    program, found = check(
        "VAR_GLOBAL CONSTANT A : INT := -7 MOD 3; B : DINT := -7 / 2; C : WORD := NOT 16#FF00;\n"
        "D : BOOL := A < 0 AND TRUE; E : LREAL := 1.0 / 4; END_VAR\n"
        "VAR_GLOBAL CONSTANT F : INT := B * 2 + SIZEOF(C); END_VAR"
    )
    values = {
        name: variable.value for one in program.lists for name, variable in one.variables.items()
    }
    assert [one.severity.name for one in found if one.severity.name == "ERROR"] == []
    assert values == {"a": -1, "b": -3, "c": 0xFF, "d": True, "e": 0.25, "f": -4}


def test_layout_of_structures() -> None:
    """ST-330, ST-312, ST-314: 8-byte alignment, bits, bases, unions, pack_mode."""
    text = """TYPE ST_A : STRUCT b : BOOL; l : LREAL; s : STRING(3); i : INT; END_STRUCT END_TYPE
TYPE ST_B EXTENDS ST_A : STRUCT x : BIT; y : BIT; d : DINT; END_STRUCT END_TYPE
TYPE U_C : UNION d : DWORD; a : ARRAY[0..5] OF BYTE; END_UNION END_TYPE
{attribute 'pack_mode' := '1'}
TYPE ST_P : STRUCT b : BOOL; l : LREAL; END_STRUCT END_TYPE
"""
    program, found = check(text)
    assert found == []

    def layout(name: str) -> tuple[int, list[tuple[int, int]]]:
        kind = program.types[name]
        assert isinstance(kind, StructType)
        return kind.size, [(one.offset, one.bit) for one in kind.members.values()]

    assert layout("st_a") == (24, [(0, -1), (8, -1), (16, -1), (20, -1)])
    assert layout("st_b")[1][4:] == [(24, 0), (24, 1), (28, -1)]
    assert layout("u_c") == (8, [(0, -1), (0, -1)])
    assert layout("st_p") == (9, [(0, -1), (1, -1)])


@pytest.mark.parametrize(
    "text",
    [
        "VAR_GLOBAL b : BIT; END_VAR",
        "FUNCTION F : INT VAR b : BIT; END_VAR END_FUNCTION",
        "FUNCTION_BLOCK FB VAR_IN_OUT b : BIT; END_VAR END_FUNCTION_BLOCK",
        "FUNCTION_BLOCK FB METHOD M VAR b : BIT; END_VAR END_METHOD END_FUNCTION_BLOCK",
    ],
)
def test_bits_are_allowed_in_structures_and_blocks(text: str) -> None:
    """ST-312: its own bit has no place in memory."""
    assert [one.id for one in check(text)[1]] == [902910]


def test_layout_of_instances_and_frames() -> None:
    """ST-330, ST-401: eight bytes first, the base's members, own ones, VAR_INST; frames apart."""
    text = """FUNCTION_BLOCK FB_A
VAR_INPUT a : BYTE; END_VAR
VAR_TEMP t : DINT; END_VAR
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_B EXTENDS FB_A
VAR b : INT; END_VAR
VAR_STAT c : INT; END_VAR
METHOD M : INT
VAR_INPUT i : LREAL; END_VAR
VAR_INST k : BYTE; END_VAR
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR f : FB_B; END_VAR
END_PROGRAM
"""
    program, found = check(text)
    assert found == []
    pou = program.pous["fb_b"]
    assert {name: one.offset for name, one in pou.members.items()} == {"a": 8, "b": 16, "m.k": 18}
    assert pou.type is not None
    assert (pou.type.size, program.pous["fb_a"].frame_size) == (24, 8)
    method = pou.methods["m"]
    assert method.result is not None
    assert (method.result.offset, method.variables["i"].offset, method.frame_size) == (0, 8, 16)
    assert program.pous["main"].instance % 8 == 0 < program.pous["main"].instance
    assert [one.number for one in program.blocks] == list(range(1, len(program.blocks) + 1))


def test_enumerations() -> None:
    """ST-313, ST-203: values, base, default; qualified names; ``strict``."""
    text = """{attribute 'qualified_only'} {attribute 'strict'}
TYPE E_A : (One := 1, Two, Ten := 10) BYTE := Two; END_TYPE
TYPE E_B : (Low, High); END_TYPE
PROGRAM MAIN
VAR a : E_A; b : E_B; n : INT; END_VAR
a := E_A.Ten; b := High; b := 1; n := a;
a := 1;
a := Ten;
b := E_B.Hihg;
END_PROGRAM
"""
    program, found = check(text)
    kind = program.types["e_a"]
    assert isinstance(kind, EnumType)
    assert ([one.number for one in kind.values.values()], kind.initial) == ([1, 2, 10], 2)
    assert [(one.span.line, one.text()[-7:]) for one in found if one.span] == [
        (7, "(C0032)"), (8, "(C0046)"), (9, "(C0004)"),
    ]  # fmt: skip
    assert (found[1].remedy(), found[2].remedy()) == ("Write E_A.Ten.", "Did you mean High?")


@pytest.mark.parametrize(
    ("written", "meant"),
    [("UDNT", "UDINT"), ("DNIT", "DINT"), ("Boole", "BOOL"), ("STRNG", "STRING")],
)
def test_a_misspelt_elementary_type_is_named(written: str, meant: str) -> None:
    """C0077: these names are known as much as those of the project."""
    _, (found,) = check(f"PROGRAM MAIN\nVAR\n  n : {written};\nEND_VAR\nEND_PROGRAM")
    assert (found.id, found.remedy()) == (902191, f"Did you mean {meant}?")


def test_names_in_several_lists_are_ambiguous() -> None:
    """ST-203: C0136 with both lists; qualified they are not."""
    gvl = '<TcPlcObject><GVL Name="{}"><Declaration><![CDATA[VAR_GLOBAL n : INT; END_VAR]]></Declaration></GVL></TcPlcObject>'  # fmt: skip # noqa: E501
    main = "PROGRAM MAIN\nn := 1;\nGVL_A.n := 1;\nEND_PROGRAM"
    files = {"A.TcGVL": gvl.format("GVL_A"), "B.TcGVL": gvl.format("GVL_B"), "m.st": main}
    _, found = check_files(dict(files))
    assert [one.text() for one in found] == ["n is declared in several lists: GVL_A, GVL_B (C0136)"]


BLOCKS = """INTERFACE I_Device
METHOD Go : BOOL VAR_INPUT n : INT; END_VAR END_METHOD
PROPERTY Name : STRING GET END_GET END_PROPERTY
END_INTERFACE
FUNCTION_BLOCK ABSTRACT FB_Base
VAR nBase : INT; END_VAR
METHOD PROTECTED ABSTRACT Work : BOOL END_METHOD
METHOD FINAL Fixed : INT Fixed := 1; END_METHOD
METHOD PRIVATE Own END_METHOD
END_FUNCTION_BLOCK
"""


def test_inheritance_is_checked() -> None:
    """ST-601, ST-604, ST-605: members of interfaces, abstract ones, FINAL, shapes, access."""
    text = (
        BLOCKS
        + """FUNCTION_BLOCK FB_A EXTENDS FB_Base IMPLEMENTS I_Device
VAR nBase : INT; END_VAR
METHOD Go : INT VAR_INPUT n : INT; END_VAR END_METHOD
METHOD Fixed : INT END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR x : FB_Base; y : FB_A; z : I_Nothing; END_VAR
y.Own();
y.Work();
y.nBase := 1;
END_PROGRAM
"""
    )
    assert sorted(one.split(": ", 1)[1] for one in errors(text)) == [
        "FB_A.Go has other parameters or another result than I_Device.Go",
        "FB_A.nBase cannot be written (C0018)",
        "FB_Base is abstract and has no instances (C0177)",
        "FB_Base.Fixed is FINAL",
        "FB_Base.Work is not implemented (C0087)",
        "I_Device.Name is not implemented (C0087)",
        "Own of FB_Base is PRIVATE and cannot be used here (C0576)",
        "Work of FB_Base is PROTECTED and cannot be used here (C0576)",
        "nBase is already declared in the base (C0097)",
        "the type I_Nothing is not known (C0077)",
    ]


def test_virtual_and_static_calls_have_their_targets() -> None:
    """ST-602, ST-520: THIS, SUPER, methods, properties, actions; arguments bound in their order."""
    text = """FUNCTION_BLOCK FB_A
VAR_INPUT i : INT; END_VAR
VAR_OUTPUT o : INT; END_VAR
METHOD M : INT VAR_INPUT a : INT; b : INT := 5; END_VAR VAR_OUTPUT c : INT; END_VAR
M := a;
END_METHOD
ACTION Act: o := i; END_ACTION
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_B EXTENDS FB_A
METHOD M : INT VAR_INPUT a : INT; b : INT; END_VAR VAR_OUTPUT c : INT; END_VAR
M := SUPER^.M(1);
Act();
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR f : FB_B; n : INT; p : POINTER TO FB_A; END_VAR
f(i := 1, o => n);
n := f.M(b := 2, a := 1, c => n);
p := ADR(f);
p^.M(1, 2);
p^();
END_PROGRAM
"""
    program, found = check(text)
    assert found == []
    inner = program.pous["fb_b"].methods["m"].body
    super_call = inner[0].value  # type: ignore[attr-defined]
    assert (super_call.is_virtual, super_call.target.path) == (False, "FB_A.M")
    assert isinstance(inner[1], CallStatement)
    assert inner[1].call.kind is CallKind.METHOD
    body = program.pous["main"].body
    block, method = body[0].call, body[1].value  # type: ignore[attr-defined]
    assert isinstance(method, Call)
    assert (block.kind, [one.name for one, _ in block.bound]) == (CallKind.BLOCK, ["i", "o"])
    assert (method.is_virtual, [one.name for one, _ in method.bound]) == (True, ["b", "a", "c"])


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("FUNCTION_BLOCK A EXTENDS B END_FUNCTION_BLOCK FUNCTION_BLOCK B EXTENDS A END_FUNCTION_BLOCK", "C0091"),  # noqa: E501
        ("TYPE A : STRUCT b : B; END_STRUCT END_TYPE TYPE B : STRUCT a : A; END_STRUCT END_TYPE", "C0101"),  # noqa: E501
        ("FUNCTION_BLOCK A VAR a : A; END_VAR END_FUNCTION_BLOCK", "C0101"),
        ("VAR_GLOBAL CONSTANT a : INT := b; b : INT := a; END_VAR", "constant"),
        ("VAR_GLOBAL CONSTANT a : ARRAY[0..a] OF INT; END_VAR", "constant"),
        ("FUNCTION F : INT F := F(); END_FUNCTION", "calls itself"),
        ("FUNCTION F : INT F := G(); END_FUNCTION FUNCTION G : INT G := F(); END_FUNCTION", "calls itself"),  # noqa: E501
        ("INTERFACE I EXTENDS I END_INTERFACE", "C0091"),
        ("TYPE A : ARRAY[0..999999999] OF LREAL; END_TYPE", "bytes of data"),
        ("TYPE A : ARRAY[5..1] OF INT; END_TYPE", "empty"),
        ("TYPE A : B; END_TYPE TYPE B : A; END_TYPE", ""),
    ],
)  # fmt: skip
def test_circles_end_in_a_message(text: str, number: str) -> None:
    """ST-407, ST-601: inheritance, data, constants, calls that lead to themselves."""
    assert number in " ".join(errors(text))


def test_initial_values() -> None:
    """ST-403: of arrays, structures, blocks; arguments of FB_init; defaults of types."""
    text = """VAR_GLOBAL CONSTANT N : INT := 3; END_VAR
TYPE T_Speed : LREAL := 2.5; END_TYPE
TYPE ST_A : STRUCT a : INT := 4; b : ARRAY[0..3] OF INT; v : T_Speed; END_STRUCT END_TYPE
FUNCTION_BLOCK FB_A
VAR_INPUT i : INT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; nSize : INT; END_VAR
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR
    x : ARRAY[1..2] OF ST_A := [(a := 1, b := [1, N(2)]), (b := [2(7)])];
    f : FB_A(nSize := 3) := (i := 2);
    g : ARRAY[0..1] OF FB_A[(nSize := 1), (2)];
    bad : ARRAY[0..1] OF INT := [1, 2, 3];
    worse : ST_A := (c := 1);
    h : FB_A(nOther := 1);
END_VAR
END_PROGRAM
"""
    program, _ = check(text)
    assert [one.split(":")[0] for one in errors(text)] == ["15", "16", "17"]
    kind = program.types["st_a"]
    assert isinstance(kind, StructType)
    assert kind.members["v"].initial is not None
    assert kind.members["v"].initial.value == 2.5


def test_open_arrays_and_in_outs() -> None:
    """ST-311, ST-520: ARRAY[*] takes any bounds; VAR_IN_OUT needs a variable of its type."""
    text = """FUNCTION F : DINT
VAR_IN_OUT a : ARRAY[*] OF INT; n : DINT; END_VAR
F := a[LOWER_BOUND(a, 1)] + n;
END_FUNCTION
PROGRAM MAIN
VAR x : ARRAY[-2..2] OF INT; y : ARRAY[0..1] OF DINT; d : DINT; i : INT; END_VAR
d := F(x, d);
d := F(a := x);
d := F(y, d);
d := F(x, i);
d := F(x, 5);
END_PROGRAM
"""
    assert [one.split(":")[0] for one in errors(text)] == ["8", "9", "10", "11"]


def test_libraries_without_sources_are_named() -> None:
    """ST-107: an unknown name says which libraries it may be from; each once."""
    main = "PROGRAM MAIN\nVAR a : FB_EcThing; b : FB_EcThing; END_VAR\na(x := 1);\nEND_PROGRAM"
    _, found = check_files({"m.st": main}, ["Tc2_Standard", "Tc2_EtherCAT"])
    assert [one.id for one in found] == [found[0].id]
    assert "Tc2_EtherCAT" in found[0].remedy()


def test_the_interface_is_known_with_its_paths() -> None:
    """ST-761, ST-763: pointers of channels and axes, structures from the table of the interface."""
    variables = "pM : POINTER TO HLI_M_H_PROZESS; f : MCV_HliInterface;"
    body = """f();
gpCh[0]^.head.plc_present_w := TRUE;
pM := ADR(gpCh[0]^.techno_unit_std_sync[1].attribut_r.data);
IF gpCh[0]^.techno_unit_std_sync[1].fkt_ctrl_r = HLI_INTF_M_FKT AND pM^.nr = 100 THEN ; END_IF
gpAx[1]^.lr_mc_control.release_feedhold.command_w := TRUE;
gpCh[0]^.head.plc_presnt_w := TRUE;"""
    assert body_errors(variables, body) == [
        "10: HLI_CH_HEAD has no member plc_presnt_w (C0004)",
    ]


def test_one_bad_object_leaves_the_others_checked() -> None:
    """Point 1 of the front end: all mistakes of a project are reported."""
    files: dict[str, str | bytes] = {
        "a.st": "FUNCTION_BLOCK FB_A\nVAR n : INT; END_VAR\nn := ;\nEND_FUNCTION_BLOCK",
        "b.st": "PROGRAM MAIN\nVAR f : FB_A; k : BOOL; END_VAR\nf();\nk := 5;\nEND_PROGRAM",
    }
    program, found = check_files(files)
    assert [(one.span.file, one.span.line) for one in found if one.span] == [
        ("a.st", 3),
        ("b.st", 4),
    ]
    assert program.pous["fb_a"].is_refused or program.has_errors


def test_expressions_keep_no_literal_without_a_type() -> None:
    """The runtime finds a type at each node: literals take that of their context."""
    program, _ = check("FUNCTION F : LREAL\nVAR u : UDINT; END_VAR\nF := 1 + 2 * 3; u := 1; F := u + 1;\nEND_FUNCTION")  # fmt: skip # noqa: E501
    for statement in program.pous["f"].body:
        stack = [statement.value]  # type: ignore[attr-defined]
        while stack:
            node = stack.pop()
            assert isinstance(node.type, Elementary)
            assert node.type.name not in ("integer", "real")
            if isinstance(node, Binary):
                stack += [node.left, node.right]


def test_what_published_projects_compile_is_accepted() -> None:
    """ST-514, ST-520: properties read alone, actions with inputs of their block."""
    text = """FUNCTION_BLOCK FB_A
VAR_INPUT i : INT; END_VAR
PROPERTY Ready : BOOL GET Ready := i > 0; END_GET END_PROPERTY
METHOD Next : REFERENCE TO FB_A END_METHOD
ACTION Act: i := i + 1; END_ACTION
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR f : FB_A; END_VAR
f.Ready;
f.Next().Ready;
f.Act(i := 5);
f.i;
END_PROGRAM
"""
    assert errors(text) == ["12: an expression alone is not a statement (C0020)"]


def test_a_block_with_an_unknown_base_is_not_blamed() -> None:
    """ST-107: what it lacks may be its base's; the base is reported, once."""
    text = """FUNCTION_BLOCK FB_A EXTENDS FB_Elsewhere
Walk(n := 1);
THIS^.Value := SUPER^.Value;
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR f : FB_A; END_VAR
f(bStart := TRUE);
f.Go().Done := 1;
END_PROGRAM
"""
    assert errors(text) == ["1: the type FB_Elsewhere is not known (C0077)"]


def test_addresses_that_share_bits_are_reported() -> None:
    """ST-402: bytes 2 and 3 hold both; bit 0 of byte 4 and byte 5 are others; areas are apart."""
    text = """
VAR_GLOBAL nWord AT %IW2 : WORD; bBit AT %IX3.7 : BOOL; bNext AT %IX4.0 : BOOL; END_VAR
PROGRAM MAIN VAR nByte AT %IB5 : BYTE; nOut AT %QB2 : BYTE; bFree AT %I* : BOOL; END_VAR ;
END_PROGRAM
"""
    found = [one for one in check(text)[1] if one.message.id == 902500]
    assert [(one.values["name"], one.values["other"]) for one in found] == [("bBit", "nWord")]


def test_a_name_that_a_known_library_lacks_here_is_reported_as_that() -> None:
    """ST-724: the library may well have it, so it is not said to be missing there."""
    assert body_errors("b : BOOL;", "b := Tc2_System.F_CheckArea(1);") == [
        "5: no F_CheckArea of the library Tc2_System is known here (C0004)",
    ]


def test_a_generic_block_is_refused_and_the_rest_of_its_head_is_read() -> None:
    """EXTENDS and IMPLEMENTS come after VAR_GENERIC; nothing else is reported because of it."""
    text = """INTERFACE I_Log
END_INTERFACE
FUNCTION_BLOCK Trace
VAR_GENERIC CONSTANT nMax : UDINT := 10; END_VAR IMPLEMENTS I_Log
VAR a : ARRAY[0..nMax] OF INT; END_VAR
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR t : Trace; l : I_Log; END_VAR
l := t;
END_PROGRAM
"""
    assert errors(text) == ["4: generic blocks (VAR_GENERIC) are not supported"]
