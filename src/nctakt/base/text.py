# SPDX-License-Identifier: MIT
"""Bytes of a list or an NC program -> text -> lines, tolerantly.

In: the bytes of a file. Out: its text, its encoding and whether that was a guess; then its lines.
Nothing here fails: each byte sequence can be read. The rules are those of the ASCII lists, and NC
programs share them: a byte order mark decides; else UTF-8 if it is valid; else Windows-1252, in
which each byte is a character. Lines end at CR LF, LF or CR and nowhere else.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass

_UTF8_MARK = b"\xef\xbb\xbf"
_UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")
#: Byte order marks, which give the encoding.
BYTE_ORDER_MARKS = (_UTF8_MARK, *_UTF16_MARKS)

#: Where Windows-1252 differs from Latin-1. The five bytes that it leaves open stay control
#: characters, as in browsers, so that no file is unreadable.
WINDOWS_1252 = {
    byte: character
    for byte in range(0x80, 0xA0)
    if (character := bytes([byte]).decode("cp1252", errors="ignore"))
}


#: Bytes at the start of a file that decide whether it is a text.
_LOOKED_AT_BYTES = 8192
#: Control characters that a text may contain by accident.
_FEW_CONTROLS = 4


@dataclass(frozen=True, slots=True)
class DecodedText:
    """A file's text (without byte order mark) and how it was read.

    ``encoding`` is ``utf-8``, ``utf-8-sig``, ``utf-16`` or ``cp1252``. ``guessed``: the bytes were
    not valid UTF-8, so that Windows-1252 was assumed, which is worth a note.
    """

    text: str
    encoding: str
    guessed: bool = False


def decode_text(data: bytes) -> DecodedText:
    """Read ``data`` by its byte order mark, else as UTF-8, else as Windows-1252."""
    if data.startswith(_UTF16_MARKS):
        return DecodedText(data.decode("utf-16", errors="replace"), "utf-16")
    body = data.removeprefix(_UTF8_MARK)
    try:
        text = body.decode("utf-8")
    except UnicodeDecodeError:
        return DecodedText(body.decode("latin-1").translate(WINDOWS_1252), "cp1252", guessed=True)
    return DecodedText(text, "utf-8" if len(body) == len(data) else "utf-8-sig")


def encode_text(text: str, like: bytes) -> bytes:
    """Return ``text`` in the encoding, and with the byte order mark, in which ``like`` is read.

    A text that the encoding of Windows cannot hold is UTF-8, which is read as such: no character is
    lost.
    """
    encoding = decode_text(like).encoding
    if encoding == "utf-16":
        mark = like[:2]
        return mark + text.encode("utf-16-le" if mark == _UTF16_MARKS[0] else "utf-16-be")
    if encoding == "cp1252":
        bytes_of = {character: byte for byte, character in WINDOWS_1252.items()}
        codes = [bytes_of.get(character, ord(character)) for character in text]
        return bytes(codes) if max(codes, default=0) < 256 else text.encode("utf-8")
    return text.encode(encoding)


def is_binary(data: bytes) -> bool:
    """Return whether a file is binary: it has NULs and more control characters than a text.

    A text with a few NULs, such as one that is padded with them at its end, is not binary.
    """
    begin = data[:_LOOKED_AT_BYTES].rstrip(b"\0")
    if b"\0" not in begin or data.startswith(_UTF16_MARKS):
        return False
    controls = sum(byte < 32 and byte not in b"\t\n\r\f\v\x1a" for byte in begin)
    return controls > _FEW_CONTROLS and controls * 50 > len(begin)


def split_lines(text: str) -> list[str]:
    r"""Return the lines of ``text`` without their ends, which are ``\r\n``, ``\n`` and ``\r`` only.

    ``str.splitlines`` would also split at form feeds and other separators that may be inside a
    comment. A line end at the very end of the text does not begin another line.
    """
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    if not lines[-1]:
        lines.pop()
    return lines
