# SPDX-License-Identifier: MIT
"""Words, control words, commands and keywords of brackets at the cursor.

In: a cursor. Out: completion items, only those that the checker permits there: in a realtime cycle
``$IF``, spindle and axis commands, functions of the channel's PLC, ``#TIMER`` and ``#ERROR``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from lsprotocol.types import CompletionItem, CompletionItemKind

from nctakt.base.diagnostics import Text
from nctakt.editor.completing.completion_items import Cursor
from nctakt.editor.completing.program_names import names_of, values_written
from nctakt.editor.completing.value_completion import targets, values
from nctakt.editor.names import OWN_FAMILIES
from nctakt.editor.structures import DIVIDERS, ENDS
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.nc.check.cycles.realtime_cycles import END_ACTIONS, SCOPES, TIMER_ACTIONS
from nctakt.nc.parse.block_head import BLOCK_HEAD
from nctakt.nc.parse.controls import CONTROL_WORDS
from nctakt.nc.parse.hash_commands import CYCLE_ACTIONS
from nctakt.nc.vocabulary.commands import COMMANDS, CONTROLS, VARIABLES
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.functions import (
    FLOW_FUNCTIONS,
    G_FUNCTIONS,
    M_FUNCTIONS,
    SPINDLE_FUNCTIONS,
)
from nctakt.nc.vocabulary.keywords import KEYWORDS
from nctakt.nc.vocabulary.single_axes.axis_commands import KEYWORDS as AXIS_KEYWORDS
from nctakt.nc.vocabulary.support_level import hash_command
from nctakt.nc.vocabulary.words import WORDS

_WORD = re.compile(r"[A-Z_@]\w*$", re.IGNORECASE)
_CONTROL = re.compile(r"\$\w*$")
_COMMAND = re.compile(BLOCK_HEAD + r"(?P<command>#[A-Z_ ]*)$", re.IGNORECASE)
_VALUE = re.compile(r"(?P<key>\w+)\s*=\s*(?P<value>\w*)$")
_NUMBERED = re.compile(r"[GMHFS]\d*$", re.IGNORECASE)
_BRACKETS = re.compile(r"\[([^\[\]]*)\]")
_KEYWORD = re.compile(r"(?<![\w.\"])[A-Z_]{2,}\d*(?![\w.\"])")
#: The written part of a bracket, if a value comes next.
_BEFORE_VALUE = re.compile(r"(?:[-+*/=<>&|^,]|\bMOD|\bAND|\bXOR|\bNOT)\s*\w*$", re.IGNORECASE)
#: The statements of a realtime cycle that begin with ``#`` (RC-201 … RC-208).
_OF_CYCLES = {
    **{f"#TIMER {action} SYN": "#TIMER SYN" for action in TIMER_ACTIONS},
    "#ERROR": "#ERROR",
}
#: Jumps, which may also follow a condition in its line.
_JUMPS = ("$GOTO", "$BREAK", "$CONTINUE")
_TIMES = Text("{count} times in this program", "{count}-mal in diesem Programm")
#: Opening word of a structure -> its text with gaps: condition, body, end.
_SNIPPETS = {
    "$IF": "$IF ${1:P1 > 0}\n  $0\n$ENDIF",
    "$FOR": "$FOR ${1:P1} = ${2:0}, ${3:9}, ${4:1}\n  $0\n$ENDFOR",
    "$WHILE": "$WHILE ${1:P1 > 0}\n  $0\n$ENDWHILE",
    "$REPEAT": "$REPEAT\n  $0\n$UNTIL ${1:P1 > 0}",
    "$SWITCH": "$SWITCH ${1:P1}\n$CASE ${2:1}\n  $0\n$ENDSWITCH",
}
_IF_IN_CYCLE = "$IF ${1|EDGE,ONCE,ALWAYS|} ${2:V.RTA.ACS.ACT_POS.%s > 0}\n  $0\n$ENDIF"
_CYCLE = "#RT CYCLE [ID=${1:%d} SCOPE=${2|PROG,BLOCK,GLOBAL|}]\n  $0\n#RT CYCLE END"


# --- $ and # -------------------------------------------------------------------------------------


def is_control(before: str) -> bool:
    """Return whether a ``$`` word is being written."""
    return _CONTROL.search(before) is not None


def is_command(before: str) -> bool:
    """Return whether the words of a ``#`` command are being written."""
    return _COMMAND.match(before) is not None


def controls(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the ``$`` words: those that divide and close the open structure, then openings."""
    match = _CONTROL.search(cursor.before)
    assert match is not None
    written = len(match[0])
    around = cursor.around
    if around.part != "block":
        words = [] if around.in_cycle else list(_JUMPS)
    else:
        words = [*_closing(cursor), *_beginning(cursor)]
    kind = CompletionItemKind.Keyword
    for word in words:
        entry = CONTROLS.get(word)
        meaning = "" if entry is None else entry.meaning.get(cursor.language)
        yield cursor.item(word, kind, written, meaning)
    if around.part == "block" and cursor.has_snippets:
        for word in (word for word in _SNIPPETS if word in words):
            meaning = CONTROLS[word].meaning.get(cursor.language)
            label = f"{word} … {ENDS[word]}"
            yield cursor.snippet(label, written, meaning, _structure(cursor, word))


def _structure(cursor: Cursor, word: str) -> str:
    """Return the text of a structure with gaps."""
    axes = cursor.machine.parameters.axes
    if word != "$IF" or not cursor.around.in_cycle or not axes:
        return _SNIPPETS[word]
    return _IF_IN_CYCLE % axes[0].name


def _closing(cursor: Cursor) -> Iterator[str]:
    """Yield words that may divide or close the innermost structure."""
    around = cursor.around
    if not around.innermost.startswith("$"):
        return
    yield ENDS[around.innermost]
    dividers = {"$IF": DIVIDERS[:2], "$SWITCH": DIVIDERS[2:4]}.get(around.innermost, ())
    has_frequency = re.search(r"\$IF\s+(?:ONCE|EDGE|ALWAYS)\b", around.opening, re.IGNORECASE)
    if not around.has_else and has_frequency is None:
        yield from dividers


def _beginning(cursor: Cursor) -> Iterator[str]:
    """Yield the ``$`` words that begin something."""
    if cursor.around.in_cycle:
        yield "$IF"
        return
    for word in CONTROL_WORDS:
        if word not in ENDS.values() and word not in DIVIDERS:
            yield word


def commands(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the ``#`` commands whose first words are the written ones."""
    match = _COMMAND.match(cursor.before)
    assert match is not None
    typed = match["command"]
    written = " ".join(typed.upper().replace("#", "# ", 1).split()).replace("# ", "#")
    ended = written.rpartition(" ")[0] if not typed.endswith(" ") else written
    for name, meaning in _command_names(cursor).items():
        if name.startswith(f"{ended} ") or not ended.strip("#"):
            yield cursor.item(name, CompletionItemKind.Function, len(typed), meaning)
    is_free = not cursor.around.in_cycle and cursor.around.innermost != "#VAR"
    if cursor.has_snippets and is_free:
        meaning = COMMANDS["#RT CYCLE"].meaning.get(cursor.language)
        text = _CYCLE % _free_id(cursor)
        if not ended.strip("#") or "#RT CYCLE".startswith(f"{ended} "):
            yield cursor.snippet("#RT CYCLE … #RT CYCLE END", len(typed), meaning, text)


def _free_id(cursor: Cursor) -> int:
    """Return the first ID that no realtime cycle of the program has."""
    used = {int(name) for name in names_of(cursor.document, cursor.line, "cycle")}
    return next(number for number in range(1, len(used) + 2) if number not in used)


def _command_names(cursor: Cursor) -> dict[str, str]:
    """Return the ``#`` commands that may come here with their meanings, ``ON`` and ``OFF`` too."""
    around = cursor.around
    end = ENDS.get(around.innermost, "")
    closing = {end: ""} if end.startswith("#") else {}
    if around.in_cycle:
        names = {
            name: COMMANDS[row].meaning.get(cursor.language) for name, row in _OF_CYCLES.items()
        }
        return {**closing, **names}
    if around.innermost == "#VAR":
        return closing
    names = {}
    for entry in COMMANDS.values():
        if entry.support is Support.REFUSED or entry.name in ("#TIMER SYN", "#RT ENDWHILE"):
            continue
        meaning = entry.meaning.get(cursor.language)
        names[entry.name] = meaning
        for form in entry.forms:
            names.setdefault(_words_of(form, entry.name), meaning)
    cycle = COMMANDS["#RT CYCLE"].meaning.get(cursor.language)
    for word in ("DEF", *CYCLE_ACTIONS):
        names[f"#RT CYCLE {word}"] = cycle
    return {**closing, **names}


def _words_of(form: str, name: str) -> str:
    """Return the words of a form before its brackets and values."""
    match = re.match(r"#[A-Z_]+(?: [A-Z_]{2,}(?![.\d=]))*", form)
    return name if match is None else match[0]


# --- keywords of brackets ------------------------------------------------------------------------


def keywords(cursor: Cursor, name: str) -> Iterator[CompletionItem]:
    """Yield keywords in a bracket of a command or an axis, or values after ``=``."""
    value = _VALUE.search(cursor.before)
    command = " ".join(name.upper().replace("#", "# ").split()).replace("# ", "#")
    is_cycle = command.startswith("#RT CYCLE")
    if value is not None:
        written, key = len(value["value"]), value["key"].upper()
        texts: Iterable[str] = {"SCOPE": SCOPES, "END_ACTION": END_ACTIONS}.get(key, ())
        if key == "ID" and is_cycle:
            texts = names_of(cursor.document, cursor.line, "cycle")
        for text in texts if is_cycle else ():
            yield cursor.item(text, CompletionItemKind.EnumMember, written)
    if _BEFORE_VALUE.search(cursor.before) and not is_cycle:
        yield from values(cursor)
    if _BEFORE_VALUE.search(cursor.before):
        return
    match = _WORD.search(cursor.before)
    written = 0 if match is None else len(match[0])
    for word in _keywords_of(command):
        meaning = KEYWORDS[word].meaning.get(cursor.language) if word in KEYWORDS else ""
        yield cursor.item(word, CompletionItemKind.Property, written, meaning)


def _keywords_of(command: str) -> Iterable[str]:
    """Return the keywords in the brackets of a command, or of an axis."""
    if command.startswith("#RT CYCLE"):
        is_definition = command in ("#RT CYCLE", "#RT CYCLE DEF")
        return ("ID", "SCOPE", "END_ACTION") if is_definition else ("ID",)
    if not command.startswith("#"):
        return AXIS_KEYWORDS
    entry = hash_command(command.removeprefix("#").split())
    forms = entry.forms if entry else ()
    inside = (text for form in forms for text in _BRACKETS.findall(form))
    return dict.fromkeys(word for text in inside for word in _KEYWORD.findall(text))


# --- words ---------------------------------------------------------------------------------------


def words(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the words of a block; after G, M, H, F or S those of the letter only.

    A cycle writes variables above all, so that they come first there.
    """
    match = _WORD.search(cursor.before)
    typed = "" if match is None else match[0].upper()
    if cursor.around.part == "target":
        yield from targets(cursor, len(typed))
        return
    if cursor.around.innermost == "#VAR":
        for family in OWN_FAMILIES:
            meaning = VARIABLES[f"V.{family}"].meaning.get(cursor.language)
            text = f"V.{family}."
            yield cursor.item(text[:-1], CompletionItemKind.Module, len(typed), meaning, text)
        return
    if _NUMBERED.fullmatch(typed):
        yield from _of_letter(cursor, typed[0], len(typed))
        return
    if cursor.around.in_cycle and cursor.around.part == "block":
        yield from targets(cursor, len(typed))
    for letter in "GMH":
        yield from _of_letter(cursor, letter, len(typed))
    variable = CompletionItemKind.Variable
    parameters = cursor.machine.parameters
    for name in (
        *(axis.name for axis in parameters.axes),
        *(spindle.name for spindle in parameters.spindles),
    ):
        text = f"{name}[" if cursor.around.in_cycle else name
        yield cursor.item(name, variable, len(typed), text=text)
    if not cursor.around.in_cycle:
        for word in "FTD":
            yield cursor.item(
                word, CompletionItemKind.Field, len(typed), WORDS[word].meaning.get(cursor.language)
            )
    if cursor.around.part == "block" and not cursor.around.in_cycle:
        yield from targets(cursor, len(typed))


def _of_letter(cursor: Cursor, letter: str, written: int) -> Iterator[CompletionItem]:
    """Yield the functions of a letter; of F and S the values that the program has."""
    in_cycle, kind = cursor.around.in_cycle, CompletionItemKind.Function
    parameters = cursor.machine.parameters
    if letter == "G" and not in_cycle:
        for number, entry in G_FUNCTIONS.items():
            if entry.support is not Support.REFUSED:
                detail = entry.meaning.get(cursor.language)
                yield cursor.item(f"G{number:02}", kind, written, detail)
    elif letter == "M":
        yield from _m_functions(cursor, parameters.m_functions, written)
    elif letter == "H":
        for number, listed in parameters.h_functions.items():
            if not (in_cycle and listed.axis_name):
                yield cursor.item(f"H{number}", kind, written, listed.synchronisation)
    elif letter in "FS" and not (in_cycle and letter == "F"):
        for value, count in values_written(cursor.document, cursor.line, letter):
            detail = _TIMES.get(cursor.language).format(count=count)
            yield cursor.item(f"{letter}{value}", CompletionItemKind.Value, written, detail)


def _m_functions(
    cursor: Cursor, listed: Mapping[int, TechnologyFunction], written: int
) -> Iterator[CompletionItem]:
    in_cycle, kind = cursor.around.in_cycle, CompletionItemKind.Function
    for number in sorted({*M_FUNCTIONS, *listed}):
        entry, function = M_FUNCTIONS.get(number), listed.get(number)
        if entry is not None and entry.support is Support.REFUSED:
            continue
        if in_cycle and number not in SPINDLE_FUNCTIONS:
            if number in FLOW_FUNCTIONS or function is None or function.axis_name:
                continue
        if entry is not None:
            detail = entry.meaning.get(cursor.language)
        else:
            detail = "" if function is None else function.synchronisation
        yield cursor.item(f"M{number:02}", kind, written, detail)
