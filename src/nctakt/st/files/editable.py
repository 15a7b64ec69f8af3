# SPDX-License-Identifier: MIT
"""The texts of a PLC's file that a person changes; nothing else of the file changes, byte by byte.

In: the content of a file, a text as shown to its programmer. Out: the content with that text
replaced: in XML that of one declaration or implementation, in a plain file all of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import unescape

from nctakt.base.dataclass import dataclass
from nctakt.base.text import decode_text, encode_text
from nctakt.st.files.shown_text import pieces_of
from nctakt.st.files.suffixes import TEXT_SUFFIXES

_TAG = re.compile(
    r"<!\[CDATA\[.*?\]\]>|<!--.*?-->|<\?.*?\?>"
    r"|<(?P<end>/?)(?P<name>[\w:.-]+)(?:\"[^\"]*\"|'[^']*'|[^>\"'])*?(?P<closed>/?)>",
    re.DOTALL,
)
_TEXTS = ("Declaration", "ST")
_CDATA, _CDATA_END = "<![CDATA[", "]]>"
#: How CDATA escapes its own end.
_SPLIT = "]]]]><![CDATA[>"


@dataclass(frozen=True, slots=True)
class _Stretch:
    """Where a text lies in a file, and whether it is in CDATA."""

    begin: int
    end: int
    is_cdata: bool


class EditableTexts:
    """The texts of a file by their numbers, as ``shown_text`` shows them, with LF at ends of lines.

    ``texts`` is empty if the file stores them in an unknown form.
    """

    def __init__(self, file: str, content: bytes) -> None:
        self._content = content
        self._whole = decode_text(content).text
        self._stretches = self._found(file)
        self.texts = [self._plain(one) for one in self._stretches]

    def _found(self, file: str) -> list[_Stretch]:
        if file[file.rfind(".") :].lower() in TEXT_SUFFIXES:
            return [_Stretch(0, len(self._whole), False)]
        found = [one for one in _stretches(self._whole) if one.end > one.begin]
        shown = [one.text for one in pieces_of(file, self._whole.replace("\r\n", "\n"))]
        is_known = [self._plain(one, is_xml=True) for one in found] == shown
        return found if is_known else []

    def _plain(self, one: _Stretch, *, is_xml: bool | None = None) -> str:
        """Return a text as its programmer writes it."""
        text = self._whole[one.begin : one.end].replace("\r\n", "\n")
        if one.is_cdata:
            return text.replace(_SPLIT, _CDATA_END)
        return unescape(text) if is_xml or self._is_xml(one) else text

    def _is_xml(self, one: _Stretch) -> bool:
        return (one.begin, one.end) != (0, len(self._whole))

    def place_of(self, number: int) -> tuple[int, int]:
        """Return line and column of the file, from 1, where a text begins."""
        before = self._whole[: self._stretches[number].begin]
        return before.count("\n") + 1, len(before) - before.rfind("\n")

    def replaced(self, number: int, text: str) -> bytes:
        """Return the content of the file with another text; line ends are kept."""
        one = self._stretches[number]
        if text == self.texts[number]:
            return self._content
        if one.is_cdata:
            text = text.replace(_CDATA_END, _SPLIT)
        elif self._is_xml(one):
            text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        if "\r\n" in self._whole:
            text = text.replace("\n", "\r\n")
        whole = f"{self._whole[: one.begin]}{text}{self._whole[one.end :]}"
        return encode_text(whole, self._content)


def _stretches(xml: str) -> Iterator[_Stretch]:
    """Yield the texts of declarations and implementations in an XML file."""
    begin, opened = -1, ""
    for match in _TAG.finditer(xml):
        name = match["name"]
        if name is None:
            continue
        if match["end"] and name == opened:
            yield _stretch(xml, begin, match.start())
            begin, opened = -1, ""
        elif begin < 0 and not match["end"] and not match["closed"] and name in _TEXTS:
            begin, opened = match.end(), name


def _stretch(xml: str, begin: int, end: int) -> _Stretch:
    """Return the text of an element, without the signs of CDATA."""
    first, last = xml.find(_CDATA, begin, end), xml.rfind(_CDATA_END, begin, end)
    if first < 0 or last < 0:
        return _Stretch(begin, end, is_cdata=False)
    return _Stretch(first + len(_CDATA), last, is_cdata=True)
