# SPDX-License-Identifier: MIT
"""Encodings and line ends, shared by lists and NC programs (rtconf.lis, list syntax)."""

from __future__ import annotations

import pytest

from nctakt.base.text import decode_text, split_lines


def test_byte_order_mark_is_dropped() -> None:
    """A UTF-8 byte order mark is no part of the text."""
    decoded = decode_text(b"\xef\xbb\xbfcycle_time 2000\r\n")
    assert (decoded.text, decoded.encoding, decoded.guessed) == (
        "cycle_time 2000\r\n",
        "utf-8-sig",
        False,
    )


def test_utf8_is_taken_where_it_fits() -> None:
    """Text that is valid UTF-8 is read as UTF-8, plain ASCII included."""
    assert decode_text("Vorschubü".encode()).text == "Vorschubü"
    assert decode_text(b"End").encoding == "utf-8"


@pytest.mark.parametrize("mark", ["utf-16-le", "utf-16-be"])
def test_utf16_is_read_by_its_mark(mark: str) -> None:
    """What a Windows editor saves as Unicode is read by its byte order mark."""
    assert decode_text("\ufeffEnd ü".encode(mark)).text == "End ü"


def test_windows_1252_is_the_last_resort() -> None:
    """Bytes that are no UTF-8 are Windows-1252, and that is marked as a guess."""
    decoded = decode_text(b"Vorschub\xfc \x80")
    assert (decoded.text, decoded.encoding, decoded.guessed) == ("Vorschubü €", "cp1252", True)


def test_each_single_byte_has_a_reading() -> None:
    """No byte makes a file unreadable, not even those that Windows-1252 leaves open."""
    for byte in range(256):
        assert len(decode_text(bytes([0xFC, 0x20, byte])).text) == 3


def test_lines_end_at_three_ends_only() -> None:
    """CR LF, LF and CR end a line; form feed, NEL and U+2028 do not."""
    assert split_lines("a\r\nb\nc\rd") == ["a", "b", "c", "d"]
    text = "a\x0bb\x0cc\x1cd\x1de\x1ef\x85g\u2028h"
    assert split_lines(text) == [text]


def test_a_last_line_end_begins_no_line() -> None:
    """A text has as many lines as it has line ends, plus an unfinished one."""
    assert split_lines("") == []
    assert split_lines("\n") == [""]
    assert split_lines("a\r") == ["a"]
    assert split_lines("a\n\n") == ["a", ""]
