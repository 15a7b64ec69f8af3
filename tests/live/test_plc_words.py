# SPDX-License-Identifier: MIT
"""What the page explains of a PLC's files: as the language server does, of the texts that run."""

import pytest

pytest.importorskip("lsprotocol", reason="explanations need lsprotocol")
pytest.importorskip("markdown2", reason="explanations need markdown2")

from pathlib import Path

from nctakt.live.plc_view import WordPlace
from nctakt.live.plc_words import PlcWords

TEXT = """\
PROGRAM MAIN
VAR CONSTANT
    cMax : INT := 16#10; // parts at most
END_VAR
VAR
    n : INT; (* <b>parts</b> *)
END_VAR
n := cMax;
END_PROGRAM
"""


def test_names_are_explained_by_declaration_value_and_comment(tmp_path: Path) -> None:
    """Each once, escaped; the file on disk may be another one by now."""
    file = tmp_path / "cell.st"
    file.write_text("PROGRAM MAIN\nEND_PROGRAM\n", "utf-8")
    words = PlcWords({file.as_posix(): TEXT.split("\n")})
    html = words.explained(file.as_posix(), [WordPlace(8, 0), WordPlace(6, 4)], "en") or ""
    assert html.count("VAR n : INT;") == 1
    assert "&lt;b&gt;parts&lt;/b&gt;" in html
    german = words.explained(file.as_posix(), [WordPlace(8, 5)], "de") or ""
    assert "VAR CONSTANT cMax : INT;" in german
    assert "Wert <code>16</code>" in german
    assert "parts at most" in german


def test_findings_of_a_text_that_is_typed(tmp_path: Path) -> None:
    """Of all files that the session runs, with their names there; what runs stays as it is."""
    called = "FUNCTION F_Next : INT\nVAR_INPUT\n    n : INT;\nEND_VAR\nF_Next := n + 1;\n"
    texts = {}
    for name, text in {
        "main.st": "PROGRAM MAIN\nVAR n : INT; END_VAR\nn := F_Next(n := n);\nEND_PROGRAM\n",
        "next.st": f"{called}END_FUNCTION\n",
        "other.st": "PROGRAM P_Other\nVAR n : INT; END_VAR\nn := F_Next(k := n);\nEND_PROGRAM\n",
    }.items():
        (tmp_path / name).write_text(text, "utf-8")
        if name != "other.st":
            texts[str(tmp_path / name)] = text.split("\n")
    words = PlcWords(texts)
    main, changed = texts
    assert words.found(main, texts[main]) == []
    found = words.found(changed, [line.replace("n", "k") for line in texts[changed]])
    places = {(one.span.file, one.span.line) for one in found if one.span is not None}
    assert places >= {(main, 3)}
    assert words.found(main, texts[main]) == []


def test_nothing_is_known_of_other_places(tmp_path: Path) -> None:
    """No word, no name, no words at all."""
    words = PlcWords({str(tmp_path / "cell.st"): TEXT.split("\n")})
    for places in ([], [WordPlace(8, 3)], [WordPlace(1, 2)]):
        assert words.explained(str(tmp_path / "cell.st"), places, "en") is None
