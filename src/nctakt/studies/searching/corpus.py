# SPDX-License-Identifier: MIT
"""Points that earlier searches for branches have found, kept in a file from call to call.

In: a file with a JSON object per line, value by name of the dimension; times in microseconds. Out:
those of its points that belong to a plan, and the file with the new ones first.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.files.output import write_file
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import INVALID_CORPUS
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.plan import Plan

#: Points that a file keeps, those found last.
MAX_POINTS = 1_000

_Entry = dict[str, Value]


class Corpus:
    """The points of a file, which need not be there yet; raises ``Failure`` (902530)."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._entries: list[_Entry] = []
        found: list[Diagnostic] = []
        for number, line in enumerate(FileAccess().read_lines(path) if path.exists() else (), 1):
            entry = _entry(line)
            if entry is not None:
                self._entries.append(entry)
            elif line.strip():
                span = Span(path.as_posix(), number, 1, len(line) + 1)
                found.append(diagnostic(INVALID_CORPUS, span, line))
        if found:
            raise Failure(*found)

    def points(self, plan: Plan) -> list[tuple[Value, ...]]:
        """Return the points with the dimensions of a plan."""
        names = [dimension.name for dimension in plan.dimensions]
        fitting = [entry for entry in self._entries if sorted(entry) == sorted(names)]
        return [tuple(entry[name] for name in names) for entry in fitting]

    def add(self, plan: Plan, points: Sequence[Sequence[Value]]) -> None:
        """Put points first and write the file; raises ``Failure`` if that is impossible."""
        names = [dimension.name for dimension in plan.dimensions]
        entries = [dict(zip(names, point, strict=True)) for point in points]
        entries += [entry for entry in self._entries if entry not in entries]
        self._entries = entries[:MAX_POINTS]
        lines = (json.dumps(entry, ensure_ascii=False) for entry in self._entries)
        write_file(self._path, "".join(f"{line}\n" for line in lines), "--corpus")


def _entry(line: str) -> _Entry | None:
    """Return a line's values by name; ``None`` for any other line."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return None
    if not isinstance(entry, dict):
        return None
    is_valid = all(type(value) in (str, int, float) for value in entry.values())
    return entry if is_valid else None
