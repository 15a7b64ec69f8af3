# SPDX-License-Identifier: MIT
"""Surroundings of the cursor in Structured Text.

In: a piece of text, the cursor's offset. Out: ``Surroundings``: whether there is code, the unit,
the part of a declaration, the path before the last point, the open call. The text need not be
readable: it is being written.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from nctakt.base.dataclass import dataclass

Part = Literal["nothing", "statement", "name", "type", "initial", "object"]

#: Characters before the cursor that are searched for an open call or path.
_MAX_STATEMENT = 4000

_HIDDEN = re.compile(
    r"//[^\n]*|\(\*|/\*(?:[^*]|\*(?!/))*(?:\*/|\Z)|\{(?:[^{}']|'[^']*')*\}|\{[^}]*(?:\}|\Z)"
    r"|'(?:[^'$\n]|\$.)*(?:'|\Z|(?=\n))|\"(?:[^\"$\n]|\$.)*(?:\"|\Z|(?=\n))",
    re.DOTALL,
)
_NESTED = re.compile(r"\(\*|\*\)")
_CLOSED = re.compile(r"(?:\*\)|\*/|\}|'|\")\Z")
_STRUCTURE = re.compile(
    r"\b(?:(?P<end>END_\w+)|(?P<open>FUNCTION_BLOCK|FUNCTION|PROGRAM|INTERFACE|METHOD|ACTION"
    r"|PROPERTY|GET|SET|TYPE|STRUCT|UNION|VAR(?:_\w+)?))\b"
    r"(?:[ \t]+(?:ABSTRACT|FINAL|PUBLIC|PRIVATE|PROTECTED|INTERNAL|CONSTANT|RETAIN|PERSISTENT)\b)*"
    r"(?:[ \t]+(?P<name>[^\W\d]\w*))?",
    re.IGNORECASE,
)
_UNITS = ("FUNCTION_BLOCK", "FUNCTION", "PROGRAM", "INTERFACE", "METHOD", "ACTION", "PROPERTY")
_PATH = re.compile(
    r"(?P<path>(?:[^\W\d]\w*|\))(?:\s*\^|\s*\[[^\[\]]*\]|\s*\([^()]*\))*"
    r"(?:\s*\.\s*[^\W\d]\w*(?:\s*\^|\s*\[[^\[\]]*\]|\s*\([^()]*\))*)*)\s*\.\s*(?P<word>\w*)\Z"
)
_WORD = re.compile(r"[^\W\d]\w*\Z")


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The cursor's surroundings.

    ``unit``: the path of the POU or member, "" outside. ``path``: the expression before a point.
    ``callee``: the expression before the innermost open bracket, with ``argument``, its index, and
    ``named``, the name of the argument. ``word``: the written part of a word.
    """

    part: Part
    unit: str
    path: str
    word: str
    callee: str = ""
    argument: int = 0
    named: str = ""


def surroundings(text: str, offset: int, title: str = "", *, is_declaration: bool) -> Surroundings:
    """Return an offset's surroundings; ``title``: the unit of a piece of XML, "" in plain text."""
    before = text[:offset]
    code = _without_hidden(before)
    if code is None:
        return Surroundings("nothing", "", "", "")
    stack = _open_structures(code)
    word = _WORD.search(code)
    written = "" if word is None else word[0]
    unit = title or ".".join(name for keyword, name in stack if keyword in _UNITS and name)
    if title and is_declaration:
        stack = [one for one in stack if one[0] not in _UNITS]
    part = _part(code, stack, title, is_declaration=is_declaration)
    statement = code[-_MAX_STATEMENT:]
    path = _PATH.search(statement)
    if path is not None:
        return Surroundings(part, unit, path["path"], path["word"])
    callee, argument, named = _open_call(statement)
    return Surroundings(part, unit, "", written, callee, argument, named)


def hidden_parts(text: str) -> Iterator[tuple[int, int]]:
    """Yield where comments, pragmas and texts begin and end.

    An open one at the end of the text reaches to the end; comments may be nested (ST-201).
    """
    position = 0
    while (match := _HIDDEN.search(text, position)) is not None:
        start, position = match.span()
        if match[0] == "(*":
            depth, position = 0, len(text)
            for mark in _NESTED.finditer(text, start):
                depth += 1 if mark[0] == "(*" else -1
                if not depth:
                    position = mark.end()
                    break
        yield start, position
        if position == start:
            position += 1


def masked(text: str, letter: str) -> str:
    """Return a text with a letter in place of each character outside of code; lines stay."""
    parts: list[str] = []
    done = 0
    for start, end in hidden_parts(text):
        parts += (text[done:start], re.sub(r"[^\n]", letter, text[start:end]))
        done = end
    return "".join((*parts, text[done:]))


def _without_hidden(before: str) -> str | None:
    """Return code with other parts blanked; ``None`` if the cursor is in such a part."""

    hidden = list(hidden_parts(before))
    if hidden and hidden[-1][1] == len(before):
        last = before[hidden[-1][0] :]
        if last.startswith("//") or len(last) < 2 or not _CLOSED.search(last):
            return None
        if last.startswith("(*") and last.count("(*") != last.count("*)"):
            return None
    return masked(before, " ")


def _open_structures(code: str) -> list[tuple[str, str]]:
    """Return the structures open at the end of a code, each with its name."""
    stack: list[tuple[str, str]] = []
    for match in _STRUCTURE.finditer(code):
        keyword = (match["open"] or "").upper()
        if match["end"] is not None:
            closed = match["end"].upper().removeprefix("END_")
            while stack:
                opened, _ = stack.pop()
                if opened == closed or (closed == "VAR" and opened.startswith("VAR")):
                    break
        elif keyword in ("GET", "SET"):
            if stack and stack[-1][0] == "PROPERTY":
                stack.append((keyword, keyword.capitalize()))
        elif match.end() < len(code) or match["name"] is not None:
            stack.append((keyword, match["name"] or ""))
    return [
        ("METHOD", name) if keyword in ("GET", "SET") else (keyword, name)
        for keyword, name in stack
    ]


def _part(code: str, stack: list[tuple[str, str]], title: str, *, is_declaration: bool) -> Part:
    """Return which part of a declaration, or that a statement is at the end of a code."""
    inner = stack[-1][0] if stack else ""
    if inner.startswith("VAR") or inner in ("STRUCT", "UNION"):
        current = re.split(r";|\bEND_VAR\b|\bVAR(?:_\w+)?\b|\bSTRUCT\b|\bUNION\b", code, flags=re.I)
        declaration = current[-1]
        if ":=" in declaration:
            return "initial"
        return "type" if ":" in declaration else "name"
    if inner == "TYPE":
        return "type" if ":" in code[code.upper().rfind("TYPE") :] else "name"
    header = re.search(
        r"\b(?:FUNCTION|METHOD|PROPERTY)\b[^;\n]*:[^;\n]*\Z|\b(?:EXTENDS|IMPLEMENTS)\b[^;\n]*\Z",
        code,
        re.IGNORECASE,
    )
    if header is not None:
        return "type"
    if not stack and (not title or is_declaration):
        return "object"
    return "object" if is_declaration and title else "statement"


def _open_call(code: str) -> tuple[str, int, str]:
    """Return the expression before the innermost open bracket, which argument, and its name."""
    depth = commas = 0
    end = len(code)
    argument_start = -1
    for index in range(end - 1, -1, -1):
        letter = code[index]
        if letter in ")]":
            depth += 1
        elif letter in "([":
            if depth:
                depth -= 1
                continue
            if letter == "[":
                return "", 0, ""
            callee = re.search(
                r"(?:[^\W\d]\w*(?:\s*\^|\s*\[[^\[\]]*\])*\s*\.\s*)*[^\W\d]\w*(?:\^|\[[^\[\]]*\])*\s*\Z",
                code[:index],
            )
            start = argument_start if argument_start >= 0 else index + 1
            named = re.match(r"\s*([^\W\d]\w*)\s*(?::=|=>)", code[start:])
            name = "" if named is None else named[1]
            return ("" if callee is None else callee[0].strip()), commas, name
        elif letter == "," and not depth:
            commas += 1
            argument_start = index + 1 if argument_start < 0 else argument_start
        elif letter == ";" and not depth:
            break
    return "", 0, ""
