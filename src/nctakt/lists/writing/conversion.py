# SPDX-License-Identifier: MIT
"""The lists of a machine -> the same lists in ASCII or XML, with comments, in one folder.

In: a loaded machine. Out: files by name. Lists keep their names except for the suffix; the second
of two equal names gets a number. The start-up list names the new files. A list with a parameter
that has no ID stays in ASCII, unknown entries become comments in XML.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TypeGuard

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import SCHEMA_BY_KIND
from nctakt.lists.declared.rtconf import INTERRUPT_SOURCES
from nctakt.lists.declared.schemas import STARTUP
from nctakt.lists.format.parameter import ValueType
from nctakt.lists.machine.files import ListSearch
from nctakt.lists.machine.machine import Machine
from nctakt.lists.writing.list_items import Comment, Item, read_items
from nctakt.lists.writing.list_writer import (
    SUFFIXES,
    ListFormat,
    ascii_text,
    has_no_id,
    xml_text,
)

#: Parameters of the start-up list that name files to be converted or copied.
_PATHS = {parameter.id for parameter in STARTUP.used if parameter.type is ValueType.STRING}
_USER_TEXTS = "error_text_user_of_id"
_DEFAULTS = ("default_sda_mds", "default_achs_mds")


@dataclass(frozen=True, slots=True)
class ConvertedLists:
    """Files by name; ``unknown``: entries as comments; ``in_ascii``: lists that stay in ASCII."""

    files: Mapping[str, bytes]
    unknown: tuple[str, ...]
    in_ascii: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Conversion:
    """Format and language of a conversion; ``edit`` changes comments and entries on the way."""

    list_format: ListFormat
    language: Language
    edit: Callable[[Comment | Item], Comment | Item] = lambda item: item


def convert_lists(
    machine: Machine, search: ListSearch, access: FileAccess, conversion: Conversion
) -> ConvertedLists:
    """Convert all lists of a machine; ``search`` finds the files that its lists name."""
    items = _items(machine, access)
    formats = {
        path: _format_of(list_items, conversion.list_format) for path, list_items in items.items()
    }
    names = _new_names(formats)
    kinds = {path.resolve(): kind for kind, path in reversed(machine.lists)}
    files: dict[str, bytes] = {}
    unknown: list[str] = []
    defaults: dict[str, None] = {}
    for path, original in items.items():
        new = [
            conversion.edit(
                _with_plain_source(_with_new_path(item, search, names, defaults), machine)
            )
            for item in original
        ]
        if formats[path] == "ascii":
            text = ascii_text(new, conversion.language)
        else:
            unknown += [f"{path.name}: {item.name}" for item in new if _is_unknown(item)]
            schema, is_default = SCHEMA_BY_KIND[kinds[path]], names[path] in defaults
            text = xml_text(new, schema, conversion.language, is_default=is_default)
        files[names[path]] = text.encode("utf-8")
    if machine.startup.error_texts:
        texts = search.find(machine.startup.error_texts)
        if texts is not None:
            files[texts.name] = access.read_bytes(texts)
    in_ascii = [path.name for path, format_ in formats.items() if format_ == "ascii"]
    return ConvertedLists(
        files, tuple(unknown), () if conversion.list_format == "ascii" else tuple(in_ascii)
    )


def _items(machine: Machine, access: FileAccess) -> dict[Path, list[Comment | Item]]:
    """Return the comments and entries of each list by its file, the start-up list first."""
    items: dict[Path, list[Comment | Item]] = {}
    for kind, path in machine.lists:
        if path.resolve() not in items:
            items[path.resolve()] = read_items(access.read_bytes(path), SCHEMA_BY_KIND[kind])
    return items


def _format_of(items: list[Comment | Item], list_format: ListFormat) -> ListFormat:
    return "ascii" if any(has_no_id(item) for item in items) else list_format


def _is_unknown(item: Comment | Item) -> TypeGuard[Item]:
    return isinstance(item, Item) and item.parameter is None


def _new_names(formats: Mapping[Path, ListFormat]) -> dict[Path, str]:
    """Return the new name of each list by its file; no two names differ in letter case only."""
    names: dict[Path, str] = {}
    used: dict[str, None] = {}
    for path, list_format in formats.items():
        number = 1
        name = path.stem + SUFFIXES[list_format]
        while name.casefold() in used:
            number += 1
            name = f"{path.stem}_{number}{SUFFIXES[list_format]}"
        used[name.casefold()] = None
        names[path] = name
    return names


def _with_new_path(
    item: Comment | Item,
    search: ListSearch,
    names: Mapping[Path, str],
    defaults: dict[str, None],
) -> Comment | Item:
    """Return an entry of the start-up list with the new name of its file."""
    if isinstance(item, Comment) or item.parameter is None or not item.value:
        return item
    if item.parameter.id not in _PATHS:
        return item
    file = search.find(item.value)
    if file is None:
        return item
    if item.parameter.pattern == _USER_TEXTS:
        return replace(item, value=file.name)
    name = names.get(file.resolve())
    if name is None:
        return item
    if item.parameter.pattern in _DEFAULTS:
        defaults[name] = None
    return replace(item, value=name)


def _with_plain_source(item: Comment | Item, machine: Machine) -> Comment | Item:
    """Return interrupt_source with its number in the manual's table: comments may get lost."""
    if isinstance(item, Comment) or item.parameter is None or machine.rtconf is None:
        return item
    if item.parameter.pattern != "interrupt_source":
        return item
    source = machine.rtconf.interrupt_source
    numbers = [number for number, other in INTERRUPT_SOURCES.items() if other is source]
    return replace(item, value=str(numbers[0]), comment="") if numbers else item
