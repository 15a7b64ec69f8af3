# SPDX-License-Identifier: MIT
"""Lines of a list: their names, possible values, and layout in columns.

In: lines of an ASCII list. Out: occurrences of variables and axes, values for completion, formatted
lines, groups of entries to fold. Lists in XML are not changed.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from nctakt.editor.names import Occurrence, Symbol
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format.parameter import Parameter, ValueType, pattern_of
from nctakt.lists.format.schema import Schema

#: Default column of the values in a list.
VALUE_COLUMN = 40

_ENTRY = re.compile(r"^[ \t]*(?P<key>[^\s#<\"(]+)(?P<gap>[ \t]+)(?P<rest>\S.*?)[ \t]*$")
_VARIABLE = re.compile(r"^\s*(?P<kind>var|vch)\[\d+\]\.name\s+(?P<name>[A-Za-z_]\w*)")
_AXIS = re.compile(r"^\s*gruppe\[\d+\]\.achse\[\d+\]\.bezeichnung\s+(?P<name>[A-Za-z]\w*)")
_SPACES = {"var": "V.E", "vch": "V.CH"}
_INDICES = re.compile(r"\[\d+\]")
_GROUP = re.compile(r"^\s*(?P<group>[^\s#<]+?\[\d+\])\.")
#: The words that end a list.
LIST_ENDS = ("End", "Ende")


def list_occurrences_in(line: str, number: int) -> Iterator[Occurrence]:
    """Yield the variable or axis that a line of a list names."""
    match = _VARIABLE.match(line)
    if match is not None:
        symbol = Symbol("variable", f"{_SPACES[match['kind']]}.{match['name']}")
        yield Occurrence(symbol, number, *match.span("name"), True)
    match = _AXIS.match(line)
    if match is not None:
        yield Occurrence(Symbol("axis", match["name"]), number, *match.span("name"), True)


def list_symbol_at(lines: Sequence[str], line: int, index: int) -> Occurrence | None:
    """Return the name at a position of a list."""
    found = list_occurrences_in(lines[line], line) if 0 <= line < len(lines) else ()
    return next((item for item in found if item.start <= index <= item.end), None)


def parameter_of(key: str, schema: Schema) -> Parameter | None:
    """Return the parameter that an entry's name means."""
    pattern = _INDICES.sub("[]", key)
    for parameter in schema.parameters:
        paths = (parameter.path, *(alias.path for alias in parameter.aliases))
        if any(pattern_of(path) == pattern for path in paths):
            return parameter
    return None


def values_of(parameter: Parameter) -> dict[str, str]:
    """Return the values that a parameter may have if they are few, and the meaning of each."""
    values: dict[str, str] = {}
    if parameter.type is ValueType.BOOLEAN:
        values = dict.fromkeys(("TRUE", "FALSE") if parameter.names else ("1", "0"), "")
    for name, number in parameter.names.items():
        values[name] = "" if number is None else str(number)
    if parameter.pattern in ("var[].type", "vch[].type", "struct[].element[].type"):
        values |= dict.fromkeys(SCALARS, "")
    default = parameter.default
    if isinstance(default, bool):
        default = "TRUE" if default and parameter.names else int(default)
    if default is not None and default != "" and not isinstance(default, tuple):
        values[str(default)] = "default"
    return values


# --- columns -------------------------------------------------------------------------------------


def format_list(lines: Sequence[str], first: int, last: int) -> list[str]:
    """Return the lines from ``first`` to ``last`` (exclusive), values in one column.

    The column is that of most entries. Values and text after them stay as written, as do comments
    and text after the end of the list.
    """
    column = _column(lines)
    end = next((n for n, line in enumerate(lines) if line.strip() in LIST_ENDS), len(lines))
    return [
        _formatted(line, column) if number < end else line
        for number, line in enumerate(lines[first:last], first)
    ]


def _column(lines: Sequence[str]) -> int:
    columns = Counter(
        match.start("rest") - (len(line) - len(line.lstrip()))
        for line in lines
        if (match := _ENTRY.match(line)) is not None
    )
    column, count = max(columns.items(), key=lambda item: (item[1], item[0]), default=(0, 0))
    return column if count * 2 > columns.total() else VALUE_COLUMN


def _formatted(line: str, column: int) -> str:
    match = _ENTRY.match(line)
    if match is None or "\t" in match["rest"]:
        return line.rstrip() if not line.lstrip().startswith("<") else line
    return f"{match['key']:{column - 1}} {match['rest']}"


def entry_groups(lines: Sequence[str]) -> Iterator[tuple[int, int]]:
    """Yield first and last line of the entries of one element: all of ``var[3]``."""
    first, group = 0, ""
    last = 0
    for number, line in enumerate([*lines, ""]):
        match = _GROUP.match(line)
        name = "" if match is None else match["group"]
        if name and name == group:
            last = number
        elif name or number == len(lines):
            if group and last > first:
                yield first, last
            first = last = number
            group = name
