# SPDX-License-Identifier: MIT
"""The names of a program: the symbol at the cursor, and all its occurrences.

In: a document and a position. Out: ``Symbol``, and its occurrences: where it is defined and where
it is used. Cycle IDs, labels, local subprograms, called files, parameters, variables and axes.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Literal, NamedTuple

from nctakt.editor.display.line_tokens import VARIABLE
from nctakt.nc.parse.block_head import BLOCK_HEAD, HEAD, LABEL, number_label
from nctakt.nc.parse.lexer import COMMENT_BEGIN, COMMENT_END, without_comments

Kind = Literal["cycle", "label", "subprogram", "file", "parameter", "variable", "axis"]

#: Families of variables that a program declares itself.
OWN_FAMILIES = ("P", "L", "S", "CYC")


class Symbol(NamedTuple):
    """A name: ``name`` in the form in which it is compared."""

    kind: Kind
    name: str


class Occurrence(NamedTuple):
    """A place of a symbol: its line, from 0, and its columns; ``is_definition``: made there."""

    symbol: Symbol
    line: int
    start: int
    end: int
    is_definition: bool


#: Comments of programs that nctakt reads: inputs and expectations.
READ_COMMENT = re.compile(r";\s*(?:expect|given)\b.*", re.IGNORECASE)
_OF_CHANNEL = re.compile(r"\bCH\d+\.(?=V)", re.IGNORECASE)
_CYCLE = re.compile(
    r"#\s*RT\s+CYCLE\b(?P<action>[^\[]*)\[[^\]]*?\bID\s*=\s*(?P<id>\d+)", re.IGNORECASE
)
_GOTO = re.compile(rf"\$GOTO(?!\w){LABEL.pattern}", re.IGNORECASE)
_PROGRAM = re.compile(r"%\s*(?P<local>L\s+(?=\S))?", re.IGNORECASE)
_START = re.compile(r"^\s*%\s*L\s+(?P<name>[^\s;(]+)", re.IGNORECASE)
_LOCAL_CALL = re.compile(r"(?<![\w.])LL\s+(?!CYCLE\b)(?P<name>[^\s\[;(=]+)", re.IGNORECASE)
_NAMED_CALL = re.compile(
    r"(?<![\w.])(?P<word>L|LL)\s+CYCLE\s*\[[^\]]*?\bNAME\s*=\s*\"?(?P<name>[^\s\]\"]+)", re.I
)
_FILE_CALL = re.compile(r"(?<![\w.])L\s+(?!CYCLE\b)(?P<name>[^\s\[;(=]+)", re.IGNORECASE)
_PARAMETER = re.compile(r"(?<![\w.@])P(?P<number>\d+)(?!\w)", re.IGNORECASE)
_ASSIGNED = re.compile(r"\s*[-+*/]?=(?!=)")
_VARIABLE = re.compile(rf"(?<!\w\w)(?<![\d._])(?P<name>{VARIABLE})", re.IGNORECASE)
_INDEX = re.compile(r"\[[^\[\]]*\]")
_STRING = re.compile(r'"[^"]*"?')
_VAR_BEGIN = re.compile(rf"{BLOCK_HEAD}\#\s*VAR\b", re.IGNORECASE)
_VAR_END = re.compile(rf"{BLOCK_HEAD}\#\s*ENDVAR\b", re.IGNORECASE)


def variable_name(written: str) -> str:
    """Return a variable without indices and ``Vs.``: ``Vs.E.A[3].B`` -> ``V.E.A.B``."""
    name = _INDEX.sub("", written).rstrip(".")
    parts = name.split(".")
    parts[0] = "V"
    if len(parts) > 1:
        parts[1] = parts[1].upper()
    return ".".join(parts)


def occurrences_in(line: str, number: int, *, declares: bool = False) -> Iterator[Occurrence]:
    """Yield the names of a line; ``declares``: it lies between ``#VAR`` and ``#ENDVAR``."""
    code = without_comments(line)
    for match in _CYCLE.finditer(code):
        action = match["action"].split()
        is_definition = not action or action[0].upper() == "DEF"
        yield _at(Symbol("cycle", str(int(match["id"]))), number, match, "id", is_definition)
    yield from _labels_in(code, number)
    start = _START.match(code)
    if start is not None:
        yield _at(Symbol("subprogram", start["name"]), number, start, "name", True)
    for match in _LOCAL_CALL.finditer(code):
        yield _at(Symbol("subprogram", match["name"]), number, match, "name", False)
    for match in _NAMED_CALL.finditer(code):
        kind: Kind = "subprogram" if match["word"].upper() == "LL" else "file"
        yield _at(Symbol(kind, match["name"]), number, match, "name", False)
    for match in _FILE_CALL.finditer(code):
        yield _at(Symbol("file", match["name"]), number, match, "name", False)
    for match in _PARAMETER.finditer(code):
        written = _ASSIGNED.match(code, match.end()) is not None
        yield _at(Symbol("parameter", f"P{int(match['number'])}"), number, match, None, written)
    for match in _VARIABLE.finditer(code):
        symbol = Symbol("variable", variable_name(match["name"]))
        yield _at(symbol, number, match, "name", declares)


def axes_in(line: str, number: int, name: str) -> Iterator[Occurrence]:
    """Yield where a line means the axis ``name``: its words, paths of V.A and V.RTA, commands."""
    if name.upper() not in line.upper():
        return
    code = _STRING.sub(lambda text: " " * len(text[0]), without_comments(line))
    for pattern in _axis_patterns(name):
        for match in pattern.finditer(code):
            yield _at(Symbol("axis", name), number, match, "name", False)


@lru_cache(maxsize=64)
def _axis_patterns(name: str) -> tuple[re.Pattern[str], ...]:
    """Return the patterns of words, of paths and of arguments; one letter needs no ``=``."""
    value = r"=(?!=)|\[" + (r"|[-+]?[\d.]|P\d|P\[|Vs?\." if len(name) == 1 else "")
    written = (
        rf"(?<![A-Z_.#$])(?P<name>{name})(?=\s*(?:{value}))",
        rf"(?<![\w.])Vs?\.(?:A|RTA)\.[\w.\[\]]*?\.(?P<name>{name})(?!\w)",
        rf"(?<=[\[,=\s])(?P<name>{name})(?=\s*[,\]])",
    )
    return tuple(re.compile(pattern, re.IGNORECASE) for pattern in written)


def _labels_in(code: str, line: int) -> Iterator[Occurrence]:
    """Yield the label at a block's head, and those that its jumps name."""
    head = HEAD.match(code)
    assert head is not None
    if head[4] is not None:
        yield _at(Symbol("label", head[4].upper()), line, head, 4, True)
    elif head[3] is not None:
        yield _at(Symbol("label", number_label(head[2])), line, head, 2, True)
    for match in _GOTO.finditer(code):
        is_number = match[1] is not None
        name = number_label(match[1]) if is_number else match[2].upper()
        yield _at(Symbol("label", name), line, match, 1 if is_number else 2, False)


def _at(
    symbol: Symbol, line: int, match: re.Match[str], group: str | int | None, is_definition: bool
) -> Occurrence:
    start, end = match.span() if group is None else match.span(group)
    return Occurrence(symbol, line, start, end, is_definition)


def symbol_at(
    lines: Sequence[str], line: int, index: int, axes: Iterable[str] = ()
) -> Occurrence | None:
    """Return the name at a position, the shortest of several; ``axes``: those of the machine."""
    if not 0 <= line < len(lines):
        return None
    found = list(occurrences_in(lines[line], line, declares=_is_declared(lines, line)))
    for name in axes:
        found += axes_in(lines[line], line, name)
    touching = [item for item in found if item.start <= index <= item.end]
    item = min(touching, key=lambda item: item.end - item.start, default=None)
    if item is None or item.symbol.kind != "variable":
        return item
    return item._replace(symbol=_up_to(item, lines[line], index))


def _up_to(item: Occurrence, line: str, index: int) -> Symbol:
    """Return the variable or member at an index of a path."""
    written = _INDEX.sub(lambda text: " " * len(text[0]), line[item.start : item.end])
    count = max(3, 1 + written.count(".", 0, index - item.start))
    return Symbol("variable", ".".join(item.symbol.name.split(".")[:count]))


def _is_declared(lines: Sequence[str], line: int) -> bool:
    """Return whether a line lies between ``#VAR`` and ``#ENDVAR``; looks back 1,000 lines."""
    for number in range(line, max(-1, line - 1000), -1):
        if _VAR_BEGIN.match(lines[number]):
            return number != line
        if _VAR_END.match(lines[number]):
            return False
    return False


def section_of(lines: Sequence[str], line: int) -> range:
    """Return the lines of the main program or subprogram that has a line; labels are its own."""
    first = 0
    for start in _section_starts(lines):
        if start > line:
            return range(first, start)
        first = start
    return range(first, len(lines))


def sections(lines: Sequence[str]) -> Iterator[range]:
    """Yield the lines of the main program and of each subprogram, in their order."""
    first = 0
    for start in _section_starts(lines):
        if any(without_comments(line).strip() for line in lines[first:start]):
            yield range(first, start)
        first = start
    yield range(first, len(lines))


def _section_starts(lines: Sequence[str]) -> Iterator[int]:
    """Yield the lines with which sections begin, as ``SectionCounter`` counts them: a ``%`` line
    inside the main program is a comment.
    """
    is_main, has_begun = True, False
    for number, line in outside_comments(lines):
        if "%" not in line:
            continue
        code = without_comments(line)
        head = HEAD.match(code)
        start = None if head is None else _PROGRAM.match(code, head.end())
        if start is None:
            continue
        if start["local"] is None and is_main:
            if has_begun or any(without_comments(other).strip() for other in lines[:number]):
                continue
            has_begun = True
        elif start["local"] is None and not has_begun:
            is_main = has_begun = True
        else:
            is_main = False
        yield number


def outside_comments(
    lines: Sequence[str], within: range | None = None
) -> Iterator[tuple[int, str]]:
    """Yield the lines that ``#COMMENT BEGIN … #COMMENT END`` does not take out, with numbers."""
    is_comment = False
    for number in within or range(len(lines)):
        line = lines[number]
        if "#" in line:
            if is_comment and COMMENT_END.search(line):
                is_comment = False
                continue
            if COMMENT_BEGIN.search(without_comments(line)):
                is_comment = True
        if not is_comment:
            yield number, line


def occurrences(
    lines: Sequence[str], symbol: Symbol, within: range | None = None
) -> Iterator[Occurrence]:
    """Yield all places of a symbol in the order of the text; ``within``: only in these lines."""
    needle = _needle(symbol)
    declares = False
    for number, line in outside_comments(lines, within):
        if "#" in line:
            if _VAR_BEGIN.match(line):
                declares = True
            elif _VAR_END.match(line):
                declares = False
        if needle not in line.upper():
            continue
        if symbol.kind == "axis":
            yield from axes_in(line, number, symbol.name)
            continue
        for item in occurrences_in(line, number, declares=declares):
            if same(item.symbol, symbol):
                yield item


def read_comments(lines: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Yield the content of comments with inputs and expectations, in its columns, with lines."""
    for number, line in enumerate(lines):
        comment = READ_COMMENT.search(line) if ";" in line else None
        if comment is not None:
            said = _OF_CHANNEL.sub(lambda found: " " * len(found[0]), comment[0])
            yield number, " " * comment.start() + said.replace(";", " ")


def called_files(lines: Sequence[str]) -> list[str]:
    """Return the names of the files that a program calls by a constant name, each once."""
    names: dict[str, None] = {}
    for _, line in outside_comments(lines):
        if "L" in line or "l" in line:
            code = without_comments(line)
            for match in (*_NAMED_CALL.finditer(code), *_FILE_CALL.finditer(code)):
                if match.groupdict().get("word", "L").upper() == "L":
                    names[match["name"]] = None
    return list(names)


def same(one: Symbol, other: Symbol) -> bool:
    """Return whether two symbols are the same; a member belongs to its variable."""
    return one == other or (
        one.kind == other.kind == "variable" and one.name.startswith(f"{other.name}.")
    )


def _needle(symbol: Symbol) -> str:
    """Return the text, in upper case, that a line must contain to have the symbol."""
    if symbol.kind == "cycle":
        return "CYCLE"
    if symbol.kind in ("label", "parameter"):
        return symbol.name.lstrip("NP") if symbol.name[1:].isdigit() else symbol.name.upper()
    if symbol.kind == "variable":
        return symbol.name.split(".")[-1].upper()
    return symbol.name.upper()
