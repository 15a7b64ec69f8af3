# SPDX-License-Identifier: MIT
"""Texts of files and their encodings."""

from __future__ import annotations

import pytest

from nctakt.base.text import decode_text, encode_text


@pytest.mark.parametrize(
    "like",
    [
        "; Maße".encode("cp1252"),
        "; Maße".encode(),
        "; Maße".encode("utf-8-sig"),
        b"\xff\xfe" + "; Maße".encode("utf-16-le"),
        b"\xfe\xff" + "; Maße".encode("utf-16-be"),
    ],
)
@pytest.mark.parametrize("text", ["G01 X10 ; größer €", "; Ω in no encoding of Windows", ""])
def test_a_text_is_read_as_it_was_written(like: bytes, text: str) -> None:
    """In the encoding of another one, as far as that has its characters; none is lost."""
    assert decode_text(encode_text(text, like)).text == text


def test_the_encoding_stays_where_it_can() -> None:
    like = "; Maße".encode("cp1252")
    assert encode_text("größer €", like) == "größer €".encode("cp1252")
