# SPDX-License-Identifier: MIT
"""A project that is typed has the findings of a check that restarts, after each keystroke.

What a check reports is what ST-1001 says; ``nctakt check`` is the other side of each comparison.
"""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from support.random_seeds import seeds_in_parts

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from support.structured_documents import Typed

FILES = {
    "types.st": """TYPE E_Step : (Idle, Run := 5, Stop) USINT := Run; END_TYPE
TYPE ST_A : STRUCT a : INT := 4; b : ARRAY[0..N] OF REAL; c : BIT; END_STRUCT END_TYPE
TYPE T_Alias : ST_A; END_TYPE
""",
    "lists.st": """VAR_GLOBAL CONSTANT N : INT := 3 * (2 + 1); M : INT := N; END_VAR
VAR_GLOBAL x AT %I* : BOOL; st : T_Alias := (a := 1, b := [1, 2(2.5)]); END_VAR
""",
    "base.st": """INTERFACE I_A METHOD Go : BOOL VAR_INPUT n : INT; END_VAR END_METHOD
PROPERTY Name : STRING(20) GET END_GET END_PROPERTY END_INTERFACE
FUNCTION_BLOCK FB_A IMPLEMENTS I_A
VAR_INPUT i : INT; END_VAR
VAR_OUTPUT o : LREAL; END_VAR
VAR e : E_Step; t : TON := (PT := T#1S500MS); p : POINTER TO ST_A; s : STRING := 'a'; END_VAR
METHOD Go : BOOL
VAR_INPUT n : INT; END_VAR
Go := n > THIS^.i AND_THEN NOT x;
END_METHOD
PROPERTY Name : STRING(20) GET Name := CONCAT(s, INT_TO_STRING(i)); END_GET END_PROPERTY
CASE e OF
    E_Step.Idle: e := SEL(x, E_Step.Idle, E_Step.Run);
    E_Step.Run, 7..9: t(IN := TRUE, Q => x);
ELSE
    p := ADR(st);
    FOR i := 0 TO M BY 1 DO p^.b[i] := LREAL_TO_REAL(o); IF i.3 THEN EXIT; END_IF END_FOR
END_CASE
END_FUNCTION_BLOCK
""",
    "derived.st": """FUNCTION_BLOCK FB_B EXTENDS FB_A
METHOD Go : BOOL VAR_INPUT n : INT; END_VAR VAR_INST k : DINT; END_VAR
Go := SUPER^.Go(n := n) XOR (k MOD 2 = 1);
END_METHOD
SUPER^(i := 1);
i := Twice(i);
END_FUNCTION_BLOCK
FUNCTION Twice : INT VAR_INPUT n : INT; END_VAR Twice := n * 2 + UpTo(SIZEOF(ST_A)); END_FUNCTION
FUNCTION UpTo : INT VAR_INPUT u : UDINT; END_VAR UpTo := UDINT_TO_INT(u); END_FUNCTION
""",
    "main.st": """PROGRAM MAIN
VAR a : ARRAY[1..2] OF FB_B; d : I_A; r : REFERENCE TO INT; c : INT := N; END_VAR
d := a[1]; r REF= a[2].i; r := r + 1; a[r](i := 2, o => st.b[0]); d.Go(1);
st.b[N] := 1.0; c := Twice(n := M);
END_PROGRAM
""",
}
#: What is typed in place of a part of a file.
PIECES = (
    "", "", " ", ";", "i", "n", "N", "x", "INT", "LREAL", ": BOOL;", ":=", "(", ")", "END_VAR\n",
    "VAR y : INT; END_VAR ", "E_Step.Idle", "st.", "a : REAL; ", "EXTENDS FB_A ", "CONSTANT ",
    "METHOD Go : INT END_METHOD ", "{attribute 'qualified_only'} ", "Go", "FB_B", "(* ", "' ",
)  # fmt: skip


def test_the_whole_folder_is_one_project(tmp_path: Path) -> None:
    """The files name each other's objects, and nothing is wrong with them."""
    typed = Typed(tmp_path, FILES)
    assert [typed.findings(name) for name in FILES] == [[]] * len(FILES)


def test_a_changed_declaration_is_felt_in_another_file(tmp_path: Path) -> None:
    """C0046: ``Twice`` is gone; an array is shorter than its index (ST-313)."""
    typed = Typed(tmp_path, FILES)
    typed.put("derived.st", FILES["derived.st"].replace("FUNCTION Twice", "FUNCTION Thrice"))
    assert "Twice is not declared" in typed.findings("main.st")[0]
    typed.put("derived.st", FILES["derived.st"])
    assert typed.findings("main.st") == []
    typed.put("lists.st", FILES["lists.st"].replace("N : INT := 3 * (2 + 1)", "N : INT := 3"))
    assert typed.findings("main.st") == []
    typed.put("types.st", FILES["types.st"].replace("0..N", "0..N - 1"))
    assert "index 3 is outside of 0 … 2" in typed.findings("main.st")[0]


def test_files_of_other_plcs_in_the_folder_are_left_out(tmp_path: Path) -> None:
    """Two programs ``MAIN`` belong to two PLCs: neither is declared twice."""
    text = "PROGRAM MAIN\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"
    typed = Typed(tmp_path, {"one.st": text, "two.st": text})
    assert typed.findings("one.st") == typed.findings("two.st") == []


@seeds_in_parts(30, 20, 10)
def test_after_each_keystroke_the_findings_are_those_of_a_check(
    seeds: range, tmp_path: Path
) -> None:
    for seed in seeds:
        rng = random.Random(seed)
        typed = Typed(tmp_path, FILES)
        texts = dict(FILES)
        for _ in range(6):
            name = rng.choice(list(FILES))
            text = texts[name]
            if text != FILES[name] and rng.random() < 0.4:
                text = FILES[name]
            else:
                first = rng.randrange(len(text) + 1)
                last = min(len(text), first + rng.choice((0, 0, 1, 1, 2, 5, 20)))
                text = text[:first] + rng.choice(PIECES) + text[last:]
            texts[name] = text
            typed.put(name, text)
            found = {other: typed.findings(other) for other in FILES}
            assert found == typed.checked(), (seed, texts)


def test_changes_in_libraries_and_classes_are_noticed(tmp_path: Path) -> None:
    """ST-107: sources of a library and the class of a stub, once they are saved."""
    library, stubs = tmp_path / "libraries" / "valves.st", tmp_path / "stubs.py"
    library.parent.mkdir()
    settings = '[plc]\nlibraries = ["libraries"]\nstubs = {FB_Sdo = "stubs.py:Sdo"}\n'
    (tmp_path / "nctakt.toml").write_text(settings, "utf-8")
    valve = "FUNCTION_BLOCK FB_Valve VAR_INPUT bOpen : BOOL; END_VAR END_FUNCTION_BLOCK"
    sdo = "class Sdo:\n    declaration = 'VAR_INPUT nIndex : UINT; END_VAR'\n    def cycle(): ...\n"
    library.write_text(valve, "utf-8")
    stubs.write_text(sdo, "utf-8")
    text = "PROGRAM MAIN VAR v : FB_Valve; s : FB_Sdo; END_VAR\nv(bOpen := TRUE); s(nIndex := 1);\n"
    typed = Typed(tmp_path, {"main.st": f"{text}END_PROGRAM\n"})
    assert typed.findings("main.st") == []
    library.write_text(valve.replace("bOpen", "bShut"), "utf-8")
    assert ["bOpen" in one for one in typed.findings("main.st")] == [True]
    stubs.write_text(sdo.replace("nIndex", "nSubIndex"), "utf-8")
    assert len(typed.findings("main.st")) == 2
    library.write_text(valve, "utf-8")
    stubs.write_text(sdo, "utf-8")
    assert typed.findings("main.st") == []
