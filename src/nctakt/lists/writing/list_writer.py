# SPDX-License-Identifier: MIT
"""The entries and comments of a list -> its text in ASCII or XML.

The first entry of each parameter gets its meaning as a comment, unless the list has a comment
there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal
from xml.sax.saxutils import quoteattr

from nctakt.base.diagnostics import Language
from nctakt.lists.format.parameter import ValueType
from nctakt.lists.format.schema import Schema
from nctakt.lists.writing.list_items import Comment, Item, meaning_of

ListFormat = Literal["ascii", "xml"]
SUFFIXES: dict[ListFormat, str] = {"ascii": ".lis", "xml": ".xml"}

_KEY_WIDTH, _VALUE_WIDTH = 48, 16
#: Column of the comment after an element.
_ELEMENT_WIDTH = 40
#: The outermost elements of XML lists, with those of lists that hold defaults.
_ROOTS = {
    "startup": "StartUp",
    "channel": "SDA_MDS",
    "axis": "AX_MDS",
    "variables": "ExtVar",
    "tools": "ToolData",
    "zero_offsets": "ZeroOffset",
    "clamp_offsets": "ClampPosOffset",
    "rtconf": "RTConfiguration",
    "manual_mode": "ManualMode",
    "axis_compensation": "AX_COMP",
    "volumetric_compensation": "VolComp",
}
_DEFAULT_ROOTS = {"channel": "Default_SDA_MDS", "axis": "Default_AX_MDS"}


def has_no_id(item: Comment | Item) -> bool:
    """Return whether an entry cannot be written in XML: the ID of its parameter is unknown."""
    return isinstance(item, Item) and item.parameter is not None and not item.parameter.id


def ascii_text(items: Iterable[Comment | Item], language: Language) -> str:
    """Return the text of an ASCII list."""
    return "\n".join((*_ascii_lines(items, language), "Ende", ""))


def _ascii_lines(items: Iterable[Comment | Item], language: Language) -> Iterator[str]:
    explained: dict[str, None] = {}
    for item in items:
        if isinstance(item, Comment):
            yield f"# {item.text}".rstrip()
            continue
        entry = f"{item.name:{_KEY_WIDTH - 1}} {_ascii_value(item)}"
        comment = _comment(item, explained, language, has_id=True)
        yield f"{entry:{_KEY_WIDTH + _VALUE_WIDTH}} ( {comment}" if comment else entry


def xml_text(
    items: Iterable[Comment | Item], schema: Schema, language: Language, *, is_default: bool
) -> str:
    """Return the text of an XML list; ``is_default``: it holds the defaults of others."""
    root = _ROOTS.get(schema.kind, schema.kind.title().replace("_", ""))
    if is_default:
        root = _DEFAULT_ROOTS.get(schema.kind, root)
    head = ('<?xml version="1.0" encoding="UTF-8"?>', f"<{root}>")
    version = '  <Version Label="1"><Schema Version="1"/></Version>'
    return "\n".join((*head, version, *_xml_lines(items, language), f"</{root}>", ""))


def _xml_lines(items: Iterable[Comment | Item], language: Language) -> Iterator[str]:
    explained: dict[str, None] = {}
    for item in items:
        if isinstance(item, Comment):
            yield f"  <!-- {_without_dashes(item.text)} -->"
        elif item.parameter is None or not item.parameter.id:
            yield f"  <!-- {_without_dashes(f'{item.name} {item.value}')} -->"
        else:
            indices = "".join(f".{index}" for index in item.indices)
            element = f"  <{item.parameter.id}{indices} Value={quoteattr(item.value)} />"
            comment = _comment(item, explained, language, has_id=False)
            text = f"{item.name}: {comment}" if comment else item.name
            yield f"{element:{_ELEMENT_WIDTH}} <!-- {_without_dashes(text)} -->"


def _without_dashes(text: str) -> str:
    """Return a text without two dashes and a final dash, which XML forbids in comments."""
    while "--" in text:
        text = text.replace("--", "- -")
    return f"{text} " if text.endswith("-") else text


def _ascii_value(item: Item) -> str:
    is_text = item.parameter is not None and item.parameter.type is ValueType.STRING
    needs_quotes = not item.value or any(sign in item.value for sign in ' \t#("')
    return f'"{item.value}"' if is_text and needs_quotes else item.value


def _comment(item: Item, explained: dict[str, None], language: Language, *, has_id: bool) -> str:
    """Return the list's comment, else at its first entry the meaning of the parameter."""
    parameter = item.parameter
    if item.comment or parameter is None or parameter.pattern in explained:
        return item.comment
    explained[parameter.pattern] = None
    return meaning_of(parameter, language, has_id=has_id)
