# SPDX-License-Identifier: MIT
"""A file of the PLC on the page: its rows, what they name, the place of the session."""

from support.plc_text import pou_file

from nctakt.base.diagnostics import Span, Text
from nctakt.live.plc_view import PlcText, WordPlace, file_names, places_in, statement_stops
from nctakt.plc.stepping.debugging import PlcFrame
from nctakt.session.statements import PlcPlace

MAIN = pou_file(
    "MAIN",
    "PROGRAM MAIN\nVAR\n\n    n : INT; (* parts\n  😀 n *)\nEND_VAR",
    "\nn := aTools[2].nLife + TO_INT(fbGate.fPos);\nfbGate(bGo := n > 16#FF, sText := 'n');",
)
#: The file's line 4 has the first line of the declaration, 9 that of the implementation.
LINES = MAIN.split("\n")


def main() -> PlcText:
    return PlcText("MAIN.TcPOU", LINES, [11, 12], "de")


def test_an_object_in_xml_is_shown_without_markup() -> None:
    """A heading before each text, lines counted as the programming system counts them."""
    rows = main().rows()
    assert [(number, "".join(text for text, _ in parts)) for number, parts in rows] == [
        (0, "MAIN · Deklaration"),
        (1, "PROGRAM MAIN"),
        (2, "VAR"),
        (3, ""),
        (4, "    n : INT; (* parts"),
        (5, "  😀 n *)"),
        (6, "END_VAR"),
        (0, "MAIN · Implementierung"),
        (1, ""),
        (2, "n := aTools[2].nLife + TO_INT(fbGate.fPos);"),
        (3, "fbGate(bGo := n > 16#FF, sText := 'n');"),
    ]
    assert rows[5][1] == [("  😀 n *)", "nc-t-comment")]
    assert rows[4][1] == [
        ("    n : ", ""),
        ("INT", "nc-t-type"),
        ("; ", ""),
        ("(* parts", "nc-t-comment"),
    ]


def test_rows_are_lines_of_the_file() -> None:
    """Both ways; a stop is at the next statement, none after the last."""
    text = main()
    assert [text.index_of(line) for line in (4, 5, 8, 10, 11, 1)] == [1, 2, 5, 8, 9, -1]
    assert [text.statement_at(row) for row in (0, 7, 9, 10, 11)] == [11, 11, 11, 12, 0]


def test_what_lines_name() -> None:
    """Paths, not what is called, arguments by name, words in comments and texts; each once."""
    assert main().named_at(10) == (12, ("fbGate", "n"))
    assert main().named_at(7) == main().named_at(99) == (0, ())
    named = main().named(0, 100)
    assert named == [
        (4, ("MAIN",)),
        (7, ("n",)),
        (11, ("n", "aTools[2].nLife", "fbGate.fPos")),
        (12, ("n",)),
    ]
    beside = main().beside(named, [[""], ["3"], ["3", "x" * 200, ""], [""]])
    assert beside == {4: "n = 3", 9: f"n = 3 · aTools[2].nLife = {'x' * 73}…"}
    assert len(beside[9]) == 100


def test_words_are_places_of_the_file() -> None:
    """Names at a column of the browser, or all of a row; of the lines 4 and 12 with markup before.

    An emoji has two units of UTF-16.
    """
    text = main()
    line = LINES[3]
    assert line.endswith("<![CDATA[PROGRAM MAIN")
    assert text.words_at(1, 9) == [WordPlace(4, line.index("MAIN"))]
    assert text.words_at(1, 3) == text.words_at(0, None) == text.words_at(99, None) == []
    row = "fbGate(bGo := n > 16#FF, sText := 'n');"
    columns = [row.index(name) for name in ("fbGate", "bGo", "n >", "sText")]
    assert text.words_at(10, None) == [WordPlace(12, column) for column in columns]
    plain = PlcText("a.st", ["(* 😀 *) n := 1; // n"], [1], "en")
    assert plain.words_at(0, 9) == [WordPlace(1, 9)]
    assert plain.words_at(0, 8) == []


def test_words_of_a_line_with_entities_are_not_placed() -> None:
    """Its columns in the file are others than those shown."""
    file = MAIN.replace("<![CDATA[PROGRAM", "PROGRAM").replace("END_VAR]]>", "END_VAR")
    lines = file.replace("n : INT;", "n : INT := SEL(1 &lt; 2, 1, 2);").split("\n")
    text = PlcText("MAIN.TcPOU", lines, [11, 12], "en")
    assert text.words_at(1, None) != []
    assert text.words_at(4, None) == []


def test_the_place_of_the_session() -> None:
    """The innermost call, those around it, stops; a fault has its own colour."""
    text = main()
    frames = tuple(
        PlcFrame(name, "", Span(file, line, 1, 2), Text("", ""))
        for name, file, line in (("FB.Tick", "FB.TcPOU", 4), ("MAIN", "MAIN.TcPOU", 11))
    )
    stops = ["statement MAIN.TcPOU:12 if n > 3", "line 11", "statement FB.TcPOU:11"]
    assert text.marks(PlcPlace(0, 1, frames), stops) == {9: ["nc-caller"], 10: ["nc-stopped"]}
    assert text.marks(PlcPlace(0, 1, frames[1:]), []) == {9: ["nc-block"]}
    assert statement_stops([*stops, "statement 3"], "plc/MAIN.TcPOU") == [12, 3]


def test_places_that_an_answer_names() -> None:
    """Files of the PLC by their ends, each place once; other files are none."""
    files = {"plc/cell.st": (), "plc/FB_Gate.TcPOU": ()}
    text = "acknowledged (cell.st:12), as plc/cell.st:12 says; FB_Gate.TcPOU:3:5, part.nc:6"
    assert places_in(text, files) == [("plc/cell.st", 12), ("plc/FB_Gate.TcPOU", 3)]
    assert file_names(["a/x.st", "b/x.st", "b/y.st"]) == {
        "a/x.st": "a/x.st",
        "b/x.st": "b/x.st",
        "b/y.st": "y.st",
    }
