# SPDX-License-Identifier: MIT
"""The form of Structured Text: white space changes, no token and no comment does."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from support.plc_text import pou_file
from support.random_seeds import seeds_in_parts
from support.structured_documents import Typed

from nctakt.editor.display.legend import TYPES
from nctakt.editor.structured_text.formatting import formatted
from nctakt.editor.structured_text.surroundings import hidden_parts
from nctakt.messages import Collector
from nctakt.st.parse.lexer import Definitions, Lexer
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece, Sources

UGLY = """\
FUNCTION_BLOCK FB_A
VAR_INPUT
bOn:BOOL;   // on
  nLong     : INT:=3;
END_VAR
VAR
      eStep : (Idle,Run);
END_VAR
IF bOn THEN~~
nLong:=nLong+1;
    FOR nLong:=0 TO 9 DO
Act(a:=1,b=>nLong,
      c := 2);
    END_FOR
ELSIF nLong<>3 THEN
CASE eStep OF
Idle:
nLong := 1; (* as is:=
   two lines *)
Run: nLong := 2;
ELSE
nLong := 'a:=b,c';
END_CASE
END_IF
END_FUNCTION_BLOCK
""".replace("~", " ")
#: Worked out by hand: four blanks for each structure, those of a label's statements among them.
NEAT = """\
FUNCTION_BLOCK FB_A
VAR_INPUT
    bOn:BOOL;   // on
    nLong     : INT := 3;
END_VAR
VAR
    eStep : (Idle, Run);
END_VAR
IF bOn THEN
    nLong := nLong+1;
    FOR nLong := 0 TO 9 DO
        Act(a := 1, b => nLong,
      c := 2);
    END_FOR
ELSIF nLong <> 3 THEN
    CASE eStep OF
        Idle:
            nLong := 1; (* as is:=
   two lines *)
        Run: nLong := 2;
    ELSE
        nLong := 'a:=b,c';
    END_CASE
END_IF
END_FUNCTION_BLOCK
"""
WORDS = [*re.findall(r"\s+|\w+|\W", UGLY), "(*", "*)", "//", "'", '"', "{", "}", "\t", "/*", "*/"]


def meaning(text: str) -> tuple[list[str], list[str], list[str]]:
    """The tokens of a text, and its comments without the blanks at the ends of lines."""
    piece = Piece("a.st", text, [0], [1], [1])
    reporter = Reporter(Sources(), Collector())
    reporter.sources.add(piece)
    tokens = Lexer(piece, Definitions(), reporter).read()
    comments = [text[start:end] for start, end in hidden_parts(text)]
    hidden = [re.sub(r"[ \t]+$", "", one, flags=re.MULTILINE) for one in comments]
    return tokens.kinds, tokens.texts, [one.rstrip() for one in hidden]


def test_a_text_gets_its_form() -> None:
    assert formatted(UGLY) == NEAT
    assert formatted(NEAT) == NEAT


@seeds_in_parts(400, 100, 100)
def test_no_token_and_no_comment_changes(seeds: range) -> None:
    """Of random texts, most of them with mistakes; what has its form keeps it."""
    for seed in seeds:
        rng = random.Random(seed)
        words = [rng.choice(WORDS) for _ in range(rng.randint(1, 120))]
        text = "".join(words) if seed % 2 else UGLY[: rng.randrange(len(UGLY))] + "".join(words)
        new = formatted(text)
        assert meaning(new) == meaning(text), seed
        assert "".join(new.split()) == "".join(text.split()), seed
        assert new.count("\n") == text.count("\n"), seed
        assert formatted(new) == new, seed


def test_nested_comments_stay_as_they_are() -> None:
    """ST-201: the comment ends with the second mark."""
    text = "x:=1; (* a:=b (* c:=d *) e:=f *) y:=2;"
    assert formatted(text) == "x := 1; (* a:=b (* c:=d *) e:=f *) y := 2;"


def test_of_an_xml_file_only_the_code_changes(tmp_path: Path) -> None:
    """The element around a text, and the mark that ends it, stay in their lines."""
    declaration, body = "FUNCTION_BLOCK FB_X\nVAR\nn:INT;\nEND_VAR\n", "IF n>0 THEN\nn:=0;\nEND_IF"
    text = pou_file("FB_X", declaration, body)
    typed = Typed(tmp_path, {"FB_X.TcPOU": text})
    document = typed.documents["FB_X.TcPOU"]
    edits = typed.answers.format(document, 0, len(document.lines))
    new = typed.edited("FB_X.TcPOU", edits)
    assert new == text.replace("\nn:INT;", "\n    n:INT;").replace("\nn:=0;", "\n    n := 0;")


def test_each_name_has_the_colour_of_what_it_is(tmp_path: Path) -> None:
    typed = Typed(tmp_path, {"a.st": UGLY.replace("Act(", "nLong(")})
    data = typed.answers.tokens(typed.documents["a.st"], 0, 100)
    lines = typed.documents["a.st"].lines
    found: dict[str, set[str]] = {}
    line = column = 0
    for index in range(0, len(data), 5):
        ahead, start, length, kind, _ = data[index : index + 5]
        line, column = line + ahead, start + (0 if ahead else column)
        found.setdefault(lines[line][column : column + length], set()).add(TYPES[kind])
    assert found["nLong"] == found["bOn"] == {"parameter"}
    assert found["FB_A"] == {"class"}
    assert found["eStep"] == {"variable"}
    assert found["Idle"] == {"enumMember"}
    assert found["INT"] == {"type"}
    assert found["VAR_INPUT"] == found["IF"] == {"keyword"}
    assert found["'a:=b,c'"] == {"string"}
    assert found["(* as is:="] == found["   two lines *)"] == {"comment"}
    assert found["3"] == {"number"}
