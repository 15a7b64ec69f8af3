# SPDX-License-Identifier: MIT
"""Texts of a PLC's files that are changed: nothing else of the file changes, byte by byte."""

import pytest
from support.plc_text import pou_file

from nctakt.st.files.editable import EditableTexts

MAIN = pou_file("MAIN", "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR", "n := n + 1;\nn := 2;")
PLAIN = "\ufeffPROGRAM MAIN\r\nVAR n : INT; END_VAR\r\nn := 1; // ä\r\nEND_PROGRAM\r\n"


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_one_text_of_an_object_changes(end: str) -> None:
    """Texts have LF; the file keeps its ends of lines; the end of CDATA can be in a text."""
    content = MAIN.replace("\n", end).encode()
    texts = EditableTexts("MAIN.TcPOU", content)
    assert texts.texts[1] == "n := n + 1;\nn := 2;"
    assert texts.replaced(1, texts.texts[1]) == content
    changed = texts.replaced(1, "n := 3; // ]]> & <\nn := 4;")
    written = "n := 3; // ]]]]><![CDATA[> & <\nn := 4;"
    assert changed == MAIN.replace("n := n + 1;\nn := 2;", written).replace("\n", end).encode()
    assert EditableTexts("MAIN.TcPOU", changed).texts[1] == "n := 3; // ]]> & <\nn := 4;"


def test_a_text_with_entities_keeps_them() -> None:
    """A text outside of CDATA is written with entities."""
    content = MAIN.replace("<![CDATA[n := n + 1;\nn := 2;]]>", "n := SEL(n &lt; 2, 1, 2);").encode()
    texts = EditableTexts("MAIN.TcPOU", content)
    assert texts.texts[1] == "n := SEL(n < 2, 1, 2);"
    assert b"<ST>b := n &gt; 2 &amp; n &lt; 3;</ST>" in texts.replaced(1, "b := n > 2 & n < 3;")


def test_a_plain_file_is_one_text() -> None:
    """With its byte order mark and ends of lines."""
    content = PLAIN.encode()
    texts = EditableTexts("main.st", content)
    (text,) = texts.texts
    assert texts.replaced(0, text) == content
    assert texts.replaced(0, text.replace("ä", "ö <")) == PLAIN.replace("ä", "ö <").encode()


def test_a_file_that_is_written_otherwise_has_no_texts() -> None:
    """CDATA beside other text: it is not known what belongs to the text."""
    content = MAIN.replace("<![CDATA[n :=", "m := 1;<![CDATA[n :=").encode()
    assert EditableTexts("MAIN.TcPOU", content).texts == []
