# SPDX-License-Identifier: MIT
"""The lists that a start-up list names -> their bytes and values.

In: references of the start-up list. Out: the values of the lists. A missing or unreadable list, a
list of another kind than that of its entry, and circular references are reported and not loaded.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from nctakt.base.text import is_binary
from nctakt.files.access import FileAccess
from nctakt.lists.declared.schemas import STARTUP
from nctakt.lists.declared.startup import ListReference, startup_configuration
from nctakt.lists.format.entries import read_entries
from nctakt.lists.format.list_check import check_list, in_order_of_lines, load_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import Values
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.files import ListSearch, read_file
from nctakt.lists.machine.list_kinds import kind_of, knows_any, other_kind, references
from nctakt.messages import Collector
from nctakt.messages.commands.checking import NOT_A_TEXT_FILE
from nctakt.messages.machines.folders import CIRCULAR_LIST_REFERENCE, WRONG_LIST_KIND


class LinkedLists:
    """The lists of one start-up list, found by ``search``; ``detail``: the extent of reports."""

    def __init__(
        self,
        startup_file: Path,
        search: ListSearch,
        access: FileAccess,
        collector: Collector,
        *,
        detail: Detail,
    ) -> None:
        self._startup_file = startup_file
        self._search = search
        self._access = access
        self._collector = collector
        self._detail = detail
        self.files: list[tuple[str, Path]] = []

    def startup(self) -> Values | None:
        """Return the values of the start-up list itself; ``None`` if it cannot be read."""
        path = self._startup_file
        data = read_file(path, self._access, self._collector)
        if data is None or self._is_binary(path, data, None):
            return None
        return load_list(STARTUP, path.as_posix(), data, self._collector, detail=self._detail)

    def values(
        self, schema: Schema, reference: ListReference | None, base: Values | None = None
    ) -> Values | None:
        """Return the values of a list over those of its defaults list, ``None`` without a list."""
        if reference is None:
            return None
        path, data = self._read(schema, reference)
        if path is None or data is None:
            return None
        name, findings = path.as_posix(), Collector()
        entries = read_entries(name, data, schema, findings)
        if not knows_any(schema, entries) and self._is_misplaced(schema, reference, path, data):
            return None
        values = check_list(schema, name, entries, findings, base=base, detail=self._detail)
        self._collector.diagnostics += in_order_of_lines(findings)
        return values

    def data(self, schema: Schema, reference: ListReference | None) -> tuple[Path, bytes] | None:
        """Return file and bytes of a list; ``None`` if it cannot be used."""
        if reference is None:
            return None
        path, data = self._read(schema, reference)
        if path is None or data is None or self._is_misplaced(schema, reference, path, data):
            return None
        return path, data

    def _read(self, schema: Schema, reference: ListReference) -> tuple[Path | None, bytes | None]:
        """Find and read a list; obstacles are reported."""
        path = self._search.find_list(reference, self._collector)
        if path is not None:
            self.files.append((schema.kind, path))
        data = None if path is None else read_file(path, self._access, self._collector)
        if path is None or data is None or self._is_binary(path, data, reference):
            return None, None
        return path, data

    def _is_binary(self, path: Path, data: bytes, reference: ListReference | None) -> bool:
        """Return whether a list is binary, which is reported."""
        if not is_binary(data):
            return False
        span, line = (None, "") if reference is None else (reference.span, reference.line)
        self._collector.report(NOT_A_TEXT_FILE, span, line, file=path.as_posix())
        return True

    def _is_misplaced(
        self, schema: Schema, reference: ListReference, path: Path, data: bytes
    ) -> bool:
        """Return whether a list is of another kind or refers back, which is reported."""
        other = other_kind(schema, path.name, data)
        if other is None:
            return False
        circle = find_circle(self._startup_file, path, self._access) if other is STARTUP else ()
        if circle:
            names = " → ".join(path.name for path in circle)
            self._collector.report(
                CIRCULAR_LIST_REFERENCE, reference.span, reference.line, circle=names
            )
            return True
        self._collector.report(
            WRONG_LIST_KIND,
            reference.span,
            reference.line,
            path=reference.path,
            kind=schema.title,
            found=other.title,
        )
        return True


def find_circle(origin: Path, first: Path, access: FileAccess) -> tuple[Path, ...]:
    """Return the chain from ``origin`` over the list ``first`` back to it, empty without one."""
    chains: list[tuple[Path, ...]] = [(origin, first)]
    seen: dict[Path, None] = {}
    while chains:
        chain = chains.pop(0)
        last = chain[-1].resolve()
        if last == origin.resolve():
            return chain
        if last not in seen:
            seen[last] = None
            chains += [(*chain, path) for path in _named_by(chain[-1], access)]
    return ()


def _named_by(path: Path, access: FileAccess) -> Iterator[Path]:
    """Yield the lists that a start-up list names; nothing for other lists."""
    unheard = Collector()
    data = read_file(path, access, unheard)
    if data is None or kind_of(path.name, data) is not STARTUP:
        return
    values = load_list(STARTUP, path.as_posix(), data, unheard)
    for _, reference in references(startup_configuration(values, unheard)):
        file = ListSearch(path, access).find(reference.path)
        if file is not None:
            yield file
