# SPDX-License-Identifier: MIT
"""Findings in the program itself -> the edits that remedy them.

In: a document and a finding. Out: titles, edits and the documents that they change: placeholders of
``#MSG`` that fit its values (21180), a program for a G function that calls one (20131).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lsprotocol.types import Position, Range, TextEdit

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.editor.completing.program_names import programs_to_call
from nctakt.editor.document import Document, uri_of
from nctakt.editor.list_lines import LIST_ENDS, VALUE_COLUMN
from nctakt.editor.workspace import LoadedMachine
from nctakt.lists.machine.machine import ChannelConfiguration
from nctakt.messages import Collector
from nctakt.messages.programs.checked_blocks import INVALID_PLACEHOLDER, NO_PROGRAM_FOR_G_FUNCTION
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.source import Source
from nctakt.nc.tree import UserMessage
from nctakt.nc.vocabulary.message_formats import conversions
from nctakt.nc.vocabulary.variables.resolution import is_text

#: Programs that are offered at most; those with the number in their names come first.
MAX_PROGRAMS = 5

_WRITE = Text("Write {new}", "{new} schreiben")
_IN_PROGRAM = Text("Call {file}: {new}", "{file} aufrufen: {new}")
_IN_LIST = Text("Call {file}: {new} in {list}", "{file} aufrufen: {new} in {list}")
#: Lengths of other languages' placeholders, which say nothing here: ``%ld``.
_LENGTHS = ("%l", "%h", "%L", "%q", "%j", "%z", "%t")


def program_remedies(
    document: Document, item: Diagnostic, loaded: LoadedMachine, language: Language
) -> Iterator[tuple[str, list[TextEdit], str]]:
    """Yield title, edits and document of each remedy of a finding."""
    if item.message is INVALID_PLACEHOLDER:
        yield from _placeholders(document, item, loaded, language)
    elif item.message is NO_PROGRAM_FOR_G_FUNCTION:
        yield from _program(document, item, loaded, language)


def _placeholders(
    document: Document, item: Diagnostic, loaded: LoadedMachine, language: Language
) -> Iterator[tuple[str, list[TextEdit], str]]:
    """Yield the text of a message with placeholders for its values, other signs doubled."""
    assert item.span is not None
    line = document.line(item.span.line - 1)
    program = parse_program(Source("", [line]), Collector())
    messages = [one for one in program.statements if isinstance(one, UserMessage)]
    if len(messages) != 1:
        return
    arguments = list(messages[0].arguments)
    text = line[item.span.column - 1 : item.span.end_column - 1]
    surplus = len(arguments) - sum(found.is_valid for found in conversions(text))
    new, at, value = "", 0, 0
    for found in conversions(text):
        start = text.index(found.text, at)
        new += text[at:start]
        at = start + len(found.text)
        if found.is_valid:
            new += found.text
            value += 1
        elif surplus > 0:
            kind, length = _kind(found.text, text[at : at + 1])
            at += length
            if value < len(arguments) and is_text(arguments[value], loaded.machine.names):
                kind = "%s"
            new += kind
            value += 1
            surplus -= 1
        else:
            new += f"%{found.text}"
    new += text[at:]
    yield (
        _WRITE.get(language).format(new=new),
        [TextEdit(document.range_of(item.span), new)],
        (document.uri),
    )


def _kind(written: str, following: str) -> tuple[str, int]:
    """Return the placeholder that a wrong one means, and how much of what follows it takes in."""
    if written in _LENGTHS and following and following in "diuxXofeEgG":
        return f"%{following}", 1
    lower = written[:-1] + written[-1:].lower()
    if next(conversions(lower)).is_valid:
        return lower, 0
    if next(conversions(f"{written[:-1]}f")).is_valid and not written[-1:].isspace():
        return f"{written[:-1]}f", 0
    return f"%f{written[-1:].strip('%')}", 0


def _program(
    document: Document, item: Diagnostic, loaded: LoadedMachine, language: Language
) -> Iterator[tuple[str, list[TextEdit], str]]:
    """Yield the names of programs that a G function can call, for the program or for the list."""
    assert item.span is not None
    word, key = str(item.values["word"]), str(item.values["key"])
    number = word.lstrip("G")
    files = sorted(
        programs_to_call(document, loaded.machine),
        key=lambda file: re.search(rf"(?<!\d)0*{number}(?!\d)", file) is None,
    )[:MAX_PROGRAMS]
    line = document.line(item.span.line - 1)
    indent = line[: len(line) - len(line.lstrip())]
    at = document.range(item.span.line - 1, 0, 0)
    for file in files:
        new = f'#FILE NAME [{word}="{file}"]'
        title = _IN_PROGRAM.get(language).format(file=file, new=new)
        yield title, [TextEdit(at, f"{indent}{new}\n")], document.uri
    configuration = loaded.machine.configuration
    named = {_base_name(channel) for channel in configuration.channels}
    lists = [path for kind, path in configuration.lists if kind == "channel" and path.name in named]
    if configuration.is_demo or len(lists) != 1 or lists[0].suffix.lower() == ".xml":
        return
    lines = loaded.access.read_lines(lists[0])
    last = max(
        (n for n, text in enumerate(lines) if text.strip() not in ("", *LIST_ENDS)), default=0
    )
    end = Position(last, len(lines[last].encode("utf-16-le")) // 2) if lines else Position(0, 0)
    for file in files:
        entry = f"{key:<{VALUE_COLUMN - 1}} {file}"
        title = _IN_LIST.get(language).format(file=file, new=key, list=lists[0].name)
        yield title, [TextEdit(Range(end, end), f"\n{entry}")], uri_of(lists[0])


def _base_name(channel: ChannelConfiguration) -> str:
    """Return the name of the file with a channel's list, without its folder."""
    reference = channel.startup.parameters
    return "" if reference is None else reference.path.replace("\\", "/").rpartition("/")[2]
