# SPDX-License-Identifier: MIT
"""The bytes of a list -> its entries and comments, line by line.

In: a list in ASCII or XML, the schema of its kind. Out: its comments and entries in their order, an
entry with its parameter, its value as text and its comment. Nothing is checked.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.text import decode_text, split_lines
from nctakt.lists.format.entries import read_entries
from nctakt.lists.format.parameter import Parameter, ValueType
from nctakt.lists.format.reader import BLANKS, Entry
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.value_text import Word, read_flags, read_string, read_word
from nctakt.lists.format.xml_reader import is_xml, read_xml_comments
from nctakt.messages import Collector


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment line, without its comment sign."""

    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Item:
    """An entry; ``parameter`` is ``None`` for an unknown one.

    ``indices``: as in the list. ``value``: its text without quotation marks. ``comment``: the text
    after it.
    """

    line: int
    name: str
    indices: tuple[int, ...]
    parameter: Parameter | None
    value: str
    comment: str


def read_items(data: bytes, schema: Schema) -> list[Comment | Item]:
    """Return the comments and entries of a list in the order of its lines."""
    entries = [_item(entry, schema) for entry in read_entries("", data, schema, Collector())]
    if not is_xml(data):
        return _in_order([*entries, *_ascii_comments(data)])
    last_of_line = {item.line: index for index, item in enumerate(entries)}
    comments: list[Comment] = []
    for line, text in read_xml_comments(data, schema):
        index = last_of_line.get(line)
        if index is None:
            comments.append(Comment(line, text.strip()))
        else:
            item = entries[index]
            entries[index] = replace(item, comment=_own_comment(item, text.strip()))
    return _in_order([*entries, *comments])


def _in_order(items: list[Comment | Item]) -> list[Comment | Item]:
    return sorted(items, key=lambda item: item.line)


def _own_comment(item: Item, text: str) -> str:
    """Return the comment after an entry without its name, which XML lists have for readers.

    The meaning of the parameter does not count as a comment.
    """
    text = text.removeprefix(item.name).removeprefix(":").strip()
    meanings = () if item.parameter is None else _meanings(item.parameter)
    return "" if text in meanings else text


def _meanings(parameter: Parameter) -> tuple[str, ...]:
    languages: tuple[Language, ...] = ("en", "de")
    return tuple(
        meaning_of(parameter, language, has_id=has_id)
        for language in languages
        for has_id in (True, False)
    )


def meaning_of(parameter: Parameter, language: Language, *, has_id: bool) -> str:
    """Return the meaning of a parameter with its unit, after its ID if ``has_id``."""
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    identity = f"{parameter.id}: " if parameter.id and has_id else ""
    return f"{identity}{parameter.text.get(language)}{unit}"


def _ascii_comments(data: bytes) -> list[Comment]:
    lines = enumerate(split_lines(decode_text(data).text), start=1)
    return [
        Comment(number, line.strip(BLANKS)[1:].strip(BLANKS))
        for number, line in lines
        if line.lstrip(BLANKS).startswith("#")
    ]


def _item(entry: Entry, schema: Schema) -> Item:
    declared = schema.find(entry.pattern) if entry.is_well_formed else None
    parameter = None if declared is None else declared[0]
    words = _words(entry, parameter)
    value = " | ".join(word.text for word in words)
    end = words[-1].span.end_column - entry.rest_column if words else 0
    comment = "" if entry.is_verbatim else entry.rest[end:].strip(BLANKS).lstrip("(#").strip(BLANKS)
    line = entry.key_span.line
    item = Item(line, entry.path, entry.indices, parameter, value, comment)
    return replace(item, comment=_own_comment(item, comment))


def _words(entry: Entry, parameter: Parameter | None) -> tuple[Word, ...]:
    unheard = Collector()
    if parameter is not None and parameter.type is ValueType.FLAGS:
        return read_flags(entry, unheard)
    is_text = parameter is not None and parameter.type is ValueType.STRING
    word = read_string(entry, unheard) if is_text else read_word(entry, unheard)
    return () if word is None else (word,)
