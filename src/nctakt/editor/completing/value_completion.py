# SPDX-License-Identifier: MIT
"""Values and variables at the cursor that the context may read or write, the best first.

In: a cursor. Out: completion items. In the condition of a realtime cycle, values that change from
tick to tick come first; values frozen at the cycle's definition are marked. Rights: RC-303, RC-301,
RC-310.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lsprotocol.types import CompletionItem, CompletionItemKind

from nctakt.base.diagnostics import Text
from nctakt.editor.completing.completion_items import Cursor
from nctakt.editor.completing.program_names import names_of, searched_lines
from nctakt.editor.names import OWN_FAMILIES
from nctakt.nc.vocabulary.commands import VARIABLES
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.keywords import KEYWORDS
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.vocabulary.variables.realtime_variables import Access
from nctakt.nc.vocabulary.variables.system_names import ROWS
from nctakt.nc.vocabulary.variables.variable_table import DECLARED

_PATH = re.compile(r"(?<!\w\w)(?<![\d._])Vs?\.[\w.\[\]]*$", re.IGNORECASE)
_WORD = re.compile(r"[A-Z_@]\w*$", re.IGNORECASE)
_FREQUENCY = re.compile(r"[$]IF\s+[A-Z]*$", re.IGNORECASE)
_FURTHER_ELEMENT = re.compile(r"\[[1-9]\d*\]")
_TARGET = re.compile(r"(?<![\w.])(?P<name>Vs?\.[^=\s]*?)\s*[-+*/]?=(?!=)", re.IGNORECASE)
_FROZEN = Text("read once, when the cycle is defined", "einmal gelesen, bei der Definition")


def written_path(before: str) -> str | None:
    """Return the beginning of a variable's path at the end of a text, ``None`` without one."""
    match = _PATH.search(before)
    return None if match is None else match[0]


def values(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield possible values at the cursor: variables, parameters, functions, constants."""
    match = _WORD.search(cursor.before)
    typed = "" if match is None else match[0]
    around = cursor.around
    if around.in_cycle and around.part == "condition" and _FREQUENCY.search(cursor.before):
        for word in ("EDGE", "ONCE", "ALWAYS"):
            meaning = KEYWORDS[word].meaning.get(cursor.language)
            yield cursor.item(word, CompletionItemKind.Keyword, len(typed), meaning)
    yield from _named(cursor, "V", "V.", len(typed), is_read=True)
    frozen = _FROZEN.get(cursor.language) if around.in_cycle else ""
    for name in names_of(cursor.document, cursor.line, "parameter"):
        yield cursor.item(name, CompletionItemKind.Variable, len(typed), frozen)
    yield from _functions(cursor, len(typed))


def variables(cursor: Cursor, path: str) -> Iterator[CompletionItem]:
    """Yield the variables whose paths continue the written part."""
    begin = path[: path.index(".")]
    around = cursor.around
    # ``X=V.E.…`` and ``XV.E.…`` read, too: only the first word of a line is written.
    is_read = around.part not in ("block", "target") or around.bracket is not None
    yield from _named(cursor, begin, path, len(path), is_read=is_read)


def targets(cursor: Cursor, written: int) -> Iterator[CompletionItem]:
    """Yield the variables that an assignment at the cursor may write."""
    yield from _named(cursor, "V", "V.", written, is_read=False)
    if not cursor.around.in_cycle:
        for name in names_of(cursor.document, cursor.line, "parameter"):
            yield cursor.item(name, CompletionItemKind.Variable, written)


def _functions(cursor: Cursor, written: int) -> Iterator[CompletionItem]:
    for name, function in FUNCTIONS.items():
        if not (function.decoder_only and cursor.around.in_cycle):
            detail = function.meaning.get(cursor.language)
            yield cursor.item(name, CompletionItemKind.Function, written, detail, f"{name}[")
    for name in CONSTANTS:
        yield cursor.item(name, CompletionItemKind.Constant, written)


def _named(
    cursor: Cursor, begin: str, path: str, written: int, *, is_read: bool
) -> Iterator[CompletionItem]:
    """Yield the variables that begin as ``path``, those of each tick and those in use first."""
    is_synchronous = begin.casefold() == "vs"
    found = list(_of_machine(cursor, is_read=is_read, is_synchronous=is_synchronous))
    if not is_synchronous:
        found += _of_program(cursor, is_read=is_read)
        found += _of_controller(cursor, is_read=is_read)
    typed = path[len(begin) :].upper()
    area = searched_lines(cursor.document, cursor.line)
    text = "\n".join(cursor.document.lines[area.start : area.stop]).upper()
    ranked = sorted(
        (is_frozen, f"V.{name}".upper() not in text, number)
        for number, (name, _, is_frozen) in enumerate(found)
        if f".{name}".upper().startswith(typed)
    )
    for is_frozen, _, number in ranked:
        name, detail, _ = found[number]
        if is_frozen:
            detail = f"{detail} · {_FROZEN.get(cursor.language)}".lstrip(" ·")
        label = f"{begin}.{name}"
        yield cursor.item(label, CompletionItemKind.Variable, written, detail)
    if path.count(".") == 1:
        yield from _families(cursor, begin, typed, written, {name for name, _, _ in found})


def _families(
    cursor: Cursor, begin: str, typed: str, written: int, names: set[str]
) -> Iterator[CompletionItem]:
    """Yield the families of the variables that can be written here."""
    families = {name.split(".")[0] for name in names}
    if not cursor.around.in_cycle or cursor.around.is_value:
        families |= set(OWN_FAMILIES)
    for entry in VARIABLES.values():
        family = entry.name[2:]
        if entry.support is Support.REFUSED or family not in families:
            continue
        if f".{family}".startswith(typed) and not (
            begin.upper() == "VS" and family not in DECLARED
        ):
            label = f"{begin}.{family}"
            detail = entry.meaning.get(cursor.language)
            yield cursor.item(label, CompletionItemKind.Module, written, detail, f"{label}.")


def _of_machine(
    cursor: Cursor, *, is_read: bool, is_synchronous: bool
) -> Iterator[tuple[str, str, bool]]:
    """Yield name, type, and whether a cycle freezes it, of V.E, V.CH, V.RTG and V.RTA."""
    table = cursor.machine.names
    right = Access.READ if is_read else Access.WRITE
    in_cycle = cursor.around.in_cycle
    names = [name for name, _ in table.realtime()] if not is_synchronous else []
    names += [name for name, _, _ in table.values() if not _FURTHER_ELEMENT.search(name)]
    for name in names:
        found = table.resolve_text(name)
        if not isinstance(found, tuple):
            continue
        location = found[0]
        if not right & (location.cycle if in_cycle else location.decoder):
            continue
        if not location.is_numeric and not _takes_text(cursor):
            continue
        is_frozen = in_cycle and not location.synchronous and not is_synchronous
        if not (is_frozen and not is_read):
            yield name[2:], location.type, is_frozen


def _takes_text(cursor: Cursor) -> bool:
    """Return whether a text can be compared, assigned or shown here."""
    around = cursor.around
    if around.bracket is not None:
        return around.bracket.startswith("#")
    if around.part != "value":
        return True
    target = _TARGET.search(cursor.before)
    if target is None:
        return False
    found = cursor.machine.names.resolve_text(target["name"])
    return not isinstance(found, tuple) or not found[0].is_numeric


def _of_program(cursor: Cursor, *, is_read: bool) -> Iterator[tuple[str, str, bool]]:
    """Yield the variables that the program has itself; no cycle writes them."""
    in_cycle = cursor.around.in_cycle
    if in_cycle and not is_read:
        return
    for name in names_of(cursor.document, cursor.line, "variable", any_use=True):
        if name.split(".")[1] in OWN_FAMILIES:
            yield name[2:], "", in_cycle


def _of_controller(cursor: Cursor, *, is_read: bool) -> Iterator[tuple[str, str, bool]]:
    """Yield V.G and V.A; those of an axis with each axis of the channel."""
    in_cycle = cursor.around.in_cycle
    if in_cycle and not is_read:
        return
    axes = [axis.name for axis in cursor.machine.parameters.axes]
    for row in ROWS:
        if not (is_read or row.is_writable):
            continue
        element = "[0]" if row.elements else ""
        for end in [f".{axis}" for axis in axes] if row.has_axis else [""]:
            meaning = row.meaning.get(cursor.language)
            yield f"{row.family}.{row.path}{element}{end}", meaning, in_cycle
