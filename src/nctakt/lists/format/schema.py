# SPDX-License-Identifier: MIT
"""Entries of a list -> checked values.

In: the entries of one list, the schema of its kind, maybe the values of a defaults list. Out: a
``Values``; what is wrong goes to the collector. Nothing here stops a start (manual of rtconf.lis,
2.4): a defective value becomes the default, an unknown entry is left out, both are reported. Of
two entries for one parameter the last counts.
"""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from dataclasses import dataclass, field

from nctakt.base.diagnostics import Diagnostic, Message, Span
from nctakt.lists.format.convert import convert
from nctakt.lists.format.parameter import (
    Effect,
    Parameter,
    Schema,
    Value,
    ValueType,
    shown,
    with_indices,
)
from nctakt.lists.format.reader import Entry, read_list
from nctakt.messages import Collector
from nctakt.messages.lists import (
    DUPLICATE_ENTRY,
    INVALID_PARAMETER_REFERENCE,
    MISSPELLED_PARAMETER,
    OLD_PARAMETER_NAME,
    PARAMETER_INDEX_OUT_OF_RANGE,
    PARAMETER_OF_OTHER_LIST,
    PARAMETER_WITHOUT_EFFECT,
    UNKNOWN_ENTRIES,
    UNKNOWN_PARAMETER,
)

#: A parameter of a list: its pattern and its indices.
Key = tuple[str, tuple[int, ...]]

_REFERENCE = re.compile(r"(P-[A-Z]{4}-[0-9]{5})((?:\.[0-9]{1,4})*)")


@dataclass(frozen=True, slots=True)
class Taken:
    """A value that stands in a list, and where.

    ``reference`` is the other parameter whose value it takes (``P-AXIS-00008.0``), as text.
    """

    value: Value
    entry: Entry
    reference: str = ""


@dataclass(frozen=True, slots=True)
class Values:
    """The values of one list, the defaults of its schema for all that it does not name."""

    schema: Schema
    file: str
    taken: Mapping[Key, Taken] = field(default_factory=dict)

    def get(self, pattern: str, *indices: int) -> Value:
        """The effective value of ``pattern`` (``thread[].name``) at ``indices``."""
        taken = self.taken.get((pattern, indices))
        return taken.value if taken is not None else self._parameter(pattern).default

    def integer(self, pattern: str, *indices: int) -> int:
        """As ``get``, of an integer parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int), pattern
        return int(value)

    def real(self, pattern: str, *indices: int) -> float:
        """As ``get``, of a number parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int | float), pattern
        return float(value)

    def flag(self, pattern: str, *indices: int) -> bool:
        """As ``get``, of a BOOLEAN parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, bool), pattern
        return value

    def text(self, pattern: str, *indices: int) -> str:
        """As ``get``, of a STRING or NAME parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, str), pattern
        return value

    def names(self, pattern: str, *indices: int) -> tuple[str, ...]:
        """As ``get``, of a FLAGS parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, tuple), pattern
        return value

    def given(self, pattern: str, *indices: int) -> bool:
        """Whether a list gives a valid value for this parameter."""
        assert self._parameter(pattern)
        return (pattern, indices) in self.taken

    def indices(self, prefix: str, *outer: int) -> tuple[int, ...]:
        """The indices of ``prefix`` (``thread[]``) behind ``outer`` with any entry, ascending."""
        depth = prefix.count("[]")
        assert depth == len(outer) + 1, prefix
        found = {
            indices[depth - 1]
            for pattern, indices in self.taken
            if pattern.startswith(prefix) and indices[: depth - 1] == outer
        }
        return tuple(sorted(found))

    def place(self, pattern: str, *indices: int) -> tuple[Span, str]:
        """Where the parameter stands, and that line; the start of the file if it does not."""
        taken = self.taken.get((pattern, indices))
        if taken is None:
            return Span(self.file, 1, 1, 2), ""
        return taken.entry.key_span, taken.entry.line

    def where(self, patterns: Container[str], value: Value) -> tuple[Span, str]:
        """As ``place``, of the first entry of these names with this value."""
        for (pattern, indices), taken in self.taken.items():
            if pattern in patterns and taken.value == value:
                return self.place(pattern, *indices)
        return Span(self.file, 1, 1, 2), ""

    def report(
        self,
        collector: Collector,
        message: Message,
        at: tuple[str, *tuple[int, ...]],
        /,
        **values: object,
    ) -> None:
        """Report ``message`` at the entry ``at``: the pattern, then the indices."""
        span, line = self.place(*at)
        collector.report(message, span, line, **values)

    def _parameter(self, pattern: str) -> Parameter:
        found = self.schema.find(pattern)
        assert found is not None and found[1] is None, pattern
        return found[0]


def load_list(
    schema: Schema,
    file: str,
    data: bytes,
    collector: Collector,
    *,
    base: Values | None = None,
    verbose: bool = False,
) -> Values:
    """Read and check one list; findings are reported in the order of its lines.

    ``base`` holds the values of the defaults list of this kind: what the list does not name, or
    names with a defective value, comes from there. ``verbose``: name each unknown entry and each
    one that is accepted without effect.
    """
    findings = Collector()
    entries = read_list(file, data, schema.dialect, findings)
    values = check_list(schema, file, entries, findings, base=base, verbose=verbose)
    collector.diagnostics.extend(sorted(findings.diagnostics, key=_line_of))
    return values


def _line_of(found: Diagnostic) -> int:
    return found.span.line if found.span is not None else 0


def check_list(
    schema: Schema,
    file: str,
    entries: tuple[Entry, ...],
    collector: Collector,
    *,
    base: Values | None = None,
    verbose: bool = False,
) -> Values:
    """Check ``entries`` against ``schema``; see ``load_list``."""
    taken: dict[Key, Taken] = dict(base.taken) if base is not None else {}
    for key, (parameter, entry) in _select(schema, entries, collector, verbose).items():
        if verbose and parameter.effect is not Effect.TAKEN:
            name = parameter.id or "–"
            collector.report(
                PARAMETER_WITHOUT_EFFECT, entry.key_span, entry.line, key=entry.path, id=name
            )
        if parameter.effect is Effect.ACCEPTED:
            continue
        default = taken[key].value if key in taken else parameter.default
        reference = _reference(parameter, entry) if schema.dialect.references else ""
        if reference:
            taken[key] = Taken(default, entry, reference)
            continue
        value = convert(parameter, entry, schema.dialect, default, collector)
        if value is not None:
            taken[key] = Taken(value, entry)
    return Values(schema, file, _resolve(schema, taken, collector))


def _select(
    schema: Schema, entries: tuple[Entry, ...], collector: Collector, verbose: bool
) -> dict[Key, tuple[Parameter, Entry]]:
    """The entry that counts for each parameter."""
    selected: dict[Key, tuple[Parameter, Entry]] = {}
    unknown: list[Entry] = []
    for entry in entries:
        found = schema.find(entry.pattern) if entry.is_well_formed else None
        if found is None:
            unknown.append(entry)
            continue
        parameter, alias = found
        if not _check_indices(parameter, entry, collector):
            continue
        name = with_indices(parameter.pattern, entry.indices)
        if alias is not None and not alias.silent:
            place = entry.key_span
            collector.report(OLD_PARAMETER_NAME, place, entry.line, alias=entry.path, key=name)
        key = (parameter.pattern, entry.indices)
        earlier = selected.get(key)
        winner = entry
        if earlier is not None:
            winner = _check_duplicate(parameter, earlier[1], entry, name, collector)
        selected[key] = (parameter, winner)
    _report_unknown(schema, unknown, collector, verbose)
    return selected


def _check_indices(parameter: Parameter, entry: Entry, collector: Collector) -> bool:
    for index, (low, high) in zip(entry.indices, parameter.index_ranges, strict=True):
        if not low <= index <= high:
            place = entry.key_span
            collector.report(
                PARAMETER_INDEX_OUT_OF_RANGE, place, entry.line, key=entry.path, low=low, high=high
            )
            return False
    return True


def _check_duplicate(
    parameter: Parameter, first: Entry, second: Entry, name: str, collector: Collector
) -> Entry:
    """The last entry counts, but the present name beats an old one wherever it stands."""
    old_name_second = first.pattern == parameter.pattern != second.pattern
    winner = first if old_name_second else second
    collector.report(
        DUPLICATE_ENTRY,
        second.key_span,
        second.line,
        key=name,
        first=first.key_span.line,
        second=second.key_span.line,
        taken=winner.key_span.line,
    )
    return winner


def _report_unknown(
    schema: Schema, unknown: list[Entry], collector: Collector, verbose: bool
) -> None:
    if not unknown:
        return
    if not (verbose or schema.dialect.report_unknown):
        place = Span(unknown[0].key_span.file, 1, 1, 2)
        collector.report(UNKNOWN_ENTRIES, place, count=len(unknown))
        return
    foreign = {name.pattern: name for name in schema.foreign}
    for entry in unknown:
        place, line, key = entry.key_span, entry.line, entry.path
        if entry.pattern in foreign:
            other = foreign[entry.pattern]
            collector.report(
                PARAMETER_OF_OTHER_LIST, place, line, key=key, list=other.kind, id=other.id
            )
            continue
        nearest = schema.nearest(entry.pattern)
        if nearest is None:
            collector.report(UNKNOWN_PARAMETER, place, line, key=key)
            continue
        if nearest.count("[]") == len(entry.indices):
            nearest = with_indices(nearest, entry.indices)
        nearest = nearest.replace("[]", "[i]")
        collector.report(MISSPELLED_PARAMETER, place, line, key=key, nearest=nearest)


def _reference(parameter: Parameter, entry: Entry) -> str:
    """The reference that the entry's value is, or nothing.

    Vendors' axis lists write ``P-AXIS-00212.0`` for "as P-AXIS-00212 of gear step 0".
    """
    if parameter.type in {ValueType.STRING, ValueType.NAME, ValueType.FLAGS, ValueType.BOOLEAN}:
        return ""
    words = entry.rest.split(None, 1)
    return words[0] if words and _REFERENCE.fullmatch(words[0]) else ""


def _resolve(schema: Schema, taken: dict[Key, Taken], collector: Collector) -> dict[Key, Taken]:
    """Follow the references among ``taken``; one that leads nowhere leaves the default."""
    resolved: dict[Key, Taken] = {}
    for key, item in taken.items():
        if not item.reference:
            resolved[key] = item
            continue
        parameter = schema.find(key[0])
        assert parameter is not None
        value = _follow(schema, taken, key)
        low, high = parameter[0].bounds
        if isinstance(value, int | float) and low <= value <= high:
            resolved[key] = Taken(value, item.entry, item.reference)
            continue
        place = item.entry.key_span
        name = with_indices(*key)
        default = shown(item.value)
        collector.report(
            INVALID_PARAMETER_REFERENCE,
            place,
            item.entry.line,
            key=name,
            value=item.reference,
            default=default,
        )
        if item.value is not None:
            resolved[key] = Taken(item.value, item.entry)
    return resolved


def _follow(schema: Schema, taken: Mapping[Key, Taken], start: Key) -> Value:
    """The value at the end of a chain of references, ``None`` for a broken one or a circle."""
    key = start
    for _ in range(len(taken) + 1):
        item = taken.get(key)
        if item is None:
            found = schema.find(key[0])
            return found[0].default if found is not None else None
        if not item.reference:
            return item.value
        match = _REFERENCE.fullmatch(item.reference)
        assert match is not None
        targets = schema.by_id(match[1])
        if len(targets) != 1:
            return None
        target = targets[0]
        own = tuple(int(text) for text in match[2].split(".")[1:])
        indices = (own or key[1])[: len(target.index_ranges)]
        if len(indices) != len(target.index_ranges):
            return None
        key = (target.pattern, indices)
    return None
