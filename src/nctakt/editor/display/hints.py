# SPDX-License-Identifier: MIT
"""Hints, lenses and links in a program.

In: a document, its findings, the counts of its last run. Out: frozen values and the cost of a
realtime cycle; commands above programs and branches; the files that calls lead to.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from lsprotocol.types import (
    CodeLens,
    Command,
    DocumentLink,
    InlayHint,
    InlayHintKind,
    ParameterInformation,
    SignatureHelp,
    SignatureInformation,
)

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.editor.display.colours import lines_with_cycles
from nctakt.editor.document import Document, uri_of
from nctakt.editor.names import occurrences_in
from nctakt.editor.navigation import called_file, list_file
from nctakt.editor.structures import every, structures
from nctakt.editor.workspace import LoadedMachine
from nctakt.messages import Collector
from nctakt.messages.programs.lints import ASYNCHRONOUS_CONDITION, ASYNCHRONOUS_VALUE
from nctakt.nc.meaning.cost import max_steps
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.source import Source
from nctakt.nc.tree import RealtimeCycle
from nctakt.nc.vocabulary.commands import COMMANDS, forms_of
from nctakt.nc.vocabulary.keywords import KEYWORDS
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.single_axes.axis_commands import KEYWORDS as AXIS_KEYWORDS
from nctakt.nc.vocabulary.variables.variable_table import NameTable

_VALUE = re.compile(r"-?\d+(?:\.\d+)?")
_STEPS = Text("≤ {count} instructions", "≤ {count} Anweisungen")
_RAN = Text("ran {count} times in the last run", "lief {count}-mal im letzten Lauf")
_RUN = Text("Run", "Ausführen")
_DEBUG = Text("Debug", "Debuggen")
_LIVE = Text("Open live page", "Live-Seite öffnen")
_WHY = Text("Why?", "Warum?")
_COUNT = Text("Count branches", "Zweige zählen")
_CALL = re.compile(r"(?P<name>#\s*[A-Z_ ]+|[A-Z]\w*)\s*\[(?P<inside>[^\[\]]*)$", re.IGNORECASE)

#: Ticks in which the body of each branch ran, by its line from 1.
Counts = Mapping[int, int]


def inlay_hints(
    document: Document,
    findings: Sequence[Diagnostic],
    names: NameTable,
    lines: range,
    language: Language,
) -> list[InlayHint]:
    """Return the values of frozen variables, and the cost of each realtime cycle."""
    hints: list[InlayHint] = []
    for item in findings:
        span = item.span
        if span is None or item.message not in (ASYNCHRONOUS_CONDITION, ASYNCHRONOUS_VALUE):
            continue
        seen = item.values["seen"]
        text = seen.get("en") if isinstance(seen, Text) else str(seen)
        value = _VALUE.match(text)
        if value is not None and span.line - 1 in lines:
            area = document.range_of(span)
            hints.append(InlayHint(area.end, f" = {value[0]}", kind=InlayHintKind.Type))
    for structure in every(structures(document.lines)):
        if (
            structure.begin != "#RT CYCLE"
            or not structure.is_closed
            or structure.first not in lines
        ):
            continue
        steps = _steps(document.lines[structure.first : structure.last + 1], names)
        if steps is not None:
            end = document.whole_lines(structure.first, structure.first).end
            hints.append(
                InlayHint(end, _STEPS.get(language).format(count=steps), padding_left=True)
            )
    return hints


def _steps(lines: Sequence[str], names: NameTable) -> int | None:
    """Return the maximum cost of the cycle in these lines, ``None`` if they cannot be read."""
    collector = Collector()
    program = parse_program(Source("", lines), collector)
    cycles = [item for item in program.statements if isinstance(item, RealtimeCycle)]
    if collector.has_errors or len(cycles) != 1:
        return None
    return max_steps(cycles[0].body, names)


def code_lenses(document: Document, counts: Counts | None, language: Language) -> list[CodeLens]:
    """Return commands for the program, its cycles, and the counts of its branches."""
    start = document.range(0, 0, 0)
    lenses = [
        CodeLens(start, Command(text.get(language), name, arguments=[document.uri]))
        for text, name in (
            (_RUN, "nctakt.run"),
            (_DEBUG, "nctakt.debug"),
            (_LIVE, "nctakt.live"),
        )
    ]
    cycles = list(lines_with_cycles(document))
    if cycles:
        lenses.append(CodeLens(start, _command(_COUNT, "nctakt.count", document, None, language)))
    for line in cycles:
        area = document.range(line, 0, 0)
        lenses.append(CodeLens(area, _command(_WHY, "nctakt.why", document, line + 1, language)))
    for line, count in sorted((counts or {}).items()):
        if line <= len(document.lines):
            area = document.range(line - 1, 0, 0)
            lenses.append(CodeLens(area, Command(_RAN.get(language).format(count=count), "")))
    return lenses


def _command(
    text: Text, name: str, document: Document, line: int | None, language: Language
) -> Command:
    arguments: list[object] = [document.uri]
    if line is not None:
        arguments.append(line)
    return Command(text.get(language), name, arguments=arguments)


def document_links(document: Document, loaded: LoadedMachine) -> Iterator[DocumentLink]:
    """Yield the files that calls of a program, or entries of a list, lead to."""
    if document.is_list:
        yield from _links_of_list(document, loaded)
        return
    for number, line in enumerate(document.lines):
        if "L" not in line.upper():
            continue
        for item in occurrences_in(line, number):
            if item.symbol.kind == "file":
                path = called_file(document, item.symbol.name, loaded)
                if path is not None:
                    area = document.range(number, item.start, item.end)
                    yield DocumentLink(area, target=uri_of(path))


def _links_of_list(document: Document, loaded: LoadedMachine) -> Iterator[DocumentLink]:
    for number in range(len(document.lines)):
        found = list_file(document, number, loaded)
        if found is not None:
            path, columns = found
            yield DocumentLink(document.range(number, *columns), target=uri_of(path))


def signature_help(before: str, language: Language) -> SignatureHelp | None:
    """Return the form of the bracketed command or function that is open at the end of a text."""
    match = _CALL.search(before)
    if match is None:
        return None
    name = " ".join(match["name"].upper().replace("#", "# ").split()).replace("# ", "#")
    function = FUNCTIONS.get(name)
    if function is not None:
        words = [f"value {number}" for number in range(1, function.maximum + 1)]
        label, meaning = f"{name}[{', '.join(words)}]", function.meaning.get(language)
        active = match["inside"].count(",")
    elif name.startswith("#RT CYCLE"):
        words = ["ID", "SCOPE", "END_ACTION"]
        label, meaning = (
            f"{name} [ID=n SCOPE=BLOCK|PROG|GLOBAL END_ACTION=MOVE_ABORT|MOVE_CONT]",
            "",
        )
        active = _active(words, match["inside"])
    elif name.startswith("#"):
        if name not in COMMANDS or not COMMANDS[name].forms:
            return None
        words, active, meaning = [], 0, ""
        label = forms_of(name)
    elif len(name) <= 2:
        words = list(AXIS_KEYWORDS)
        label, meaning = f"{name}[{' '.join(words)}]", ""
        active = _active(words, match["inside"])
    else:
        return None
    parameters = [
        ParameterInformation(
            word, KEYWORDS[word].meaning.get(language) if word in KEYWORDS else None
        )
        for word in words
    ]
    signature = SignatureInformation(label, documentation=meaning or None, parameters=parameters)
    return SignatureHelp([signature], active_signature=0, active_parameter=active)


def _active(words: Sequence[str], inside: str) -> int:
    """Return the index of the keyword that is written last."""
    last = re.findall(r"[A-Z_]\w*", inside.upper())
    known = [words.index(word) for word in last if word in words]
    return known[-1] if known else 0
