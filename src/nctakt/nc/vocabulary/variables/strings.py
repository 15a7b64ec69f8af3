# SPDX-License-Identifier: MIT
"""Character strings in memory: one byte per character, terminated by a zero byte.

Converts texts to the bytes of a string variable and back. The characters are those of Windows-1252,
as in the lists (``base/text.py``). A variable holds one character less than its ``size_bytes``;
STRING without P-EXTV-00022 has 24 bytes and holds 20.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Message
from nctakt.base.text import WINDOWS_1252
from nctakt.messages.machines.memory import CHARACTER_NOT_STORABLE, TEXT_TOO_LONG
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES

_BYTES = {ord(character): byte for byte, character in WINDOWS_1252.items()}
_SHORT_STRING_BYTES, _SHORT_STRING_CHARACTERS = 24, 20


def max_characters(type_: str, size_bytes: int) -> int:
    """Return the length of the longest text that fits into a variable."""
    if type_ == "STRING" and size_bytes == _SHORT_STRING_BYTES:
        return _SHORT_STRING_CHARACTERS
    return size_bytes - 1


def decode(data: bytes | bytearray | memoryview) -> str:
    """Return the text of a string variable up to its first zero byte."""
    return bytes(data).split(b"\0", 1)[0].decode("latin-1").translate(WINDOWS_1252)


def encode(text: str, size_bytes: int) -> bytes:
    """Return the bytes of a variable that holds ``text``, padded with zeros; the text must fit
    (``misfit``).
    """
    data = text.translate(_BYTES).encode("latin-1")
    assert len(data) < size_bytes, (text, size_bytes)
    return data.ljust(size_bytes, b"\0")


def misfit(
    name: str, type_: str, size_bytes: int, text: str
) -> tuple[Message, dict[str, object]] | None:
    """Return why variable ``name`` cannot hold ``text``: message and values; ``None`` if it can."""
    for character in text:
        code = _BYTES.get(ord(character), ord(character))
        if not 0 < code < 256 or WINDOWS_1252.get(code, chr(code)) != character:
            return CHARACTER_NOT_STORABLE, {"name": name, "character": f"U+{ord(character):04X}"}
    limit = max_characters(type_, size_bytes)
    if len(text) > limit:
        return TEXT_TOO_LONG, {"name": name, "limit": limit, "count": len(text)}
    return None


def read(memory: memoryview, cell: int, size_bytes: int) -> str:
    """Return the text of the variable at ``cell``; ``memory``: the machine's, as bytes."""
    first = cell * CELL_BYTES
    return decode(memory[first : first + size_bytes])


def write(memory: memoryview, cell: int, data: bytes) -> None:
    """Store the bytes that ``encode`` returned."""
    first = cell * CELL_BYTES
    memory[first : first + len(data)] = data
