# SPDX-License-Identifier: MIT
"""Damaged sources never raise and never hang: they end in messages, or are accepted."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from support.plc_text import check_files, pou_file
from support.random_seeds import seeds_in_parts

SOURCE = """{attribute 'qualified_only'}
TYPE E_Step : (Idle, Run := 5, Stop) USINT := Run; END_TYPE
TYPE ST_A : STRUCT a : INT := 4; b : ARRAY[0..3] OF REAL; c : BIT; END_STRUCT END_TYPE
INTERFACE I_A METHOD Go : BOOL VAR_INPUT n : INT; END_VAR END_METHOD
PROPERTY Name : STRING(20) GET END_GET END_PROPERTY END_INTERFACE
VAR_GLOBAL CONSTANT N : INT := 3 * (2 + 1); END_VAR
VAR_GLOBAL x AT %I* : BOOL; st : ST_A := (a := 1, b := [1, 2(2.5)]); END_VAR
FUNCTION_BLOCK FB_A IMPLEMENTS I_A
VAR_INPUT i : INT; END_VAR
VAR_OUTPUT o : LREAL; END_VAR
VAR e : E_Step; t : TON := (PT := T#1S500MS); p : POINTER TO ST_A; s : STRING := 'a$'b'; END_VAR
METHOD Go : BOOL
VAR_INPUT n : INT; END_VAR
Go := n > THIS^.i AND_THEN NOT x;
END_METHOD
PROPERTY Name : STRING(20) GET Name := CONCAT(s, INT_TO_STRING(i)); END_GET END_PROPERTY
CASE e OF
    E_Step.Idle: e := SEL(x, E_Step.Idle, E_Step.Run);
    E_Step.Run, 7..9: t(IN := TRUE, Q => x); (* wait (* nested *) *)
ELSE
    p := ADR(st);
    FOR i := 0 TO N BY 1 DO p^.b[i] := LREAL_TO_REAL(o) ** 2; IF i.3 THEN EXIT; END_IF END_FOR
    WHILE i > 0 DO i := i - 1; END_WHILE
END_CASE
END_FUNCTION_BLOCK
FUNCTION_BLOCK FINAL FB_B EXTENDS FB_A
METHOD Go : BOOL VAR_INPUT n : INT; END_VAR VAR_INST k : DINT; END_VAR
Go := SUPER^.Go(n := n) XOR (k MOD 2 = 1);
END_METHOD
SUPER^(i := 1);
{IF defined(NCTAKT)} i := 16#FF_F; {ELSE} i := ; {END_IF}
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR a : ARRAY[1..2] OF FB_B; d : I_A; r : REFERENCE TO INT; w : WSTRING(3) := "abc"; END_VAR
d := a[1]; r REF= a[2].i; r := r + 1; a[r](i := 2, o => st.b[0]); d.Go(1);
END_PROGRAM
"""
WORDS = [*SOURCE.split(), *"(* *) ' \" { } EXTENDS FB_A [ ] ( ) \0".split(" ")]


def mutated(rng: random.Random, text: str) -> str:
    """Return a text with some of its parts deleted, doubled, exchanged or overwritten."""
    for _ in range(rng.randint(1, 5)):
        first = rng.randrange(len(text) + 1)
        last = min(len(text), first + rng.randint(0, 40))
        match rng.randrange(5):
            case 0:
                text = text[:first] + text[last:]
            case 1:
                text = text[:last] + text[first:]
            case 2:
                text = text[:first] + f" {rng.choice(WORDS)} " + text[first:]
            case 3:
                text = text[:first] + rng.choice(WORDS) + text[last:]
            case _:
                other = rng.randrange(len(text) + 1)
                text = text[:first] + text[other : other + 60] + text[last:]
    return text


def plain_texts(seed: int) -> dict[str, str | bytes]:
    """Return a damaged plain text."""
    return {"m.st": mutated(random.Random(seed), SOURCE)}


def damaged_files(seed: int) -> dict[str, str | bytes]:
    """Return a damaged object in XML, of each second seed the file around it, too."""
    start = SOURCE.index("FUNCTION_BLOCK FB_A")
    block, _, body = SOURCE[start:].partition("METHOD")
    rng = random.Random(-1 - seed)
    text = pou_file("FB_A", mutated(rng, block), mutated(rng, body[:900]))
    if seed % 2:
        text = mutated(rng, text)
    return {"types.st": SOURCE[:start], "FB_A.TcPOU": text.encode("utf-8", "replace")}


@pytest.mark.parametrize("damaged", [plain_texts, damaged_files])
@seeds_in_parts(100, 40, 20)
def test_damaged_sources_end_in_messages(
    seeds: range, damaged: Callable[[int], dict[str, str | bytes]]
) -> None:
    """Each diagnostic can be shown in both languages; of each part plain texts come before XML."""
    for seed in seeds:
        _, found = check_files(damaged(seed))
        for one in found:
            assert one.render("en")
            assert one.render("de")


@pytest.mark.parametrize(
    "text",
    [
        "", "\0" * 100, "\xff\xfe" * 50, "PROGRAM", "(" * 5000, "[" * 5000, "IF " * 5000,
        "{IF " * 99, "x" * 100_000 + "#", "{" + " " * 50_000, "(*" * 20_000, "'" * 5000,
        "a.b" * 5000, "NOT " * 5000, "TYPE A : " + "ARRAY[0..1] OF " * 3000 + "INT; END_TYPE",
        "TYPE A : " + "POINTER TO " * 3000 + "INT; END_TYPE",
        "".join(f"FUNCTION_BLOCK F{n} EXTENDS F{n + 1} END_FUNCTION_BLOCK " for n in range(1500)),
        "".join(f"TYPE T{n} : T{n + 1}; END_TYPE " for n in range(1500)),
        "VAR_GLOBAL CONSTANT " + "".join(f"c{n} : INT := c{n + 1}; " for n in range(1500)),
    ],
)  # fmt: skip
def test_extreme_texts_end_in_messages(text: str) -> None:
    """Depth, length and chains without end are bounded."""
    check_files({"m.st": text})
    check_files({"m.TcPOU": text})
