# SPDX-License-Identifier: MIT
"""Entries of a list -> checked values.

In: the entries of one list, the schema of its kind, optionally the values of a defaults list. Out:
``Values``; mistakes go to the collector. Nothing here stops a start (manual of rtconf.lis, 2.4): a
defective value becomes the default, an unknown entry is ignored, both are reported. Of two entries
for one parameter the last counts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.lists.format.convert import convert
from nctakt.lists.format.entries import read_entries
from nctakt.lists.format.limits import keep_limits
from nctakt.lists.format.parameter import Effect, Parameter, shown, with_indices
from nctakt.lists.format.reader import Entry
from nctakt.lists.format.references import (
    default_of,
    effective_value,
    key_of,
    reference_of,
    resolve,
)
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import EntryValue, Key, Values
from nctakt.lists.format.without_effect import Detail, report_without_effect
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    DUPLICATE_ENTRY,
    MISSPELLED_PARAMETER,
    OLD_PARAMETER_NAME,
    PARAMETER_INDEX_OUT_OF_RANGE,
    PARAMETER_OF_OTHER_LIST,
    UNKNOWN_ENTRIES,
    UNKNOWN_ENTRY_NUMBERS,
    UNKNOWN_PARAMETER,
)

#: Maximum number of separate reports of unknown entries, apart from those near a known name.
_NAMED_ENTRIES = 20


def load_list(
    schema: Schema,
    file: str,
    data: bytes,
    collector: Collector,
    *,
    base: Values | None = None,
    detail: Detail = "summary",
) -> Values:
    """Read and check one list; findings are reported in the order of its lines.

    ``base`` holds the values of the defaults list of this kind, which replace missing and defective
    values.
    """
    findings = Collector()
    entries = read_entries(file, data, schema, findings)
    values = check_list(schema, file, entries, findings, base=base, detail=detail)
    collector.diagnostics += in_order_of_lines(findings)
    return values


def in_order_of_lines(findings: Collector) -> list[Diagnostic]:
    """Return the diagnostics of one file in the order of its lines."""
    return sorted(
        findings.diagnostics,
        key=lambda diagnostic: 0 if diagnostic.span is None else diagnostic.span.line,
    )


def check_list(
    schema: Schema,
    file: str,
    entries: Sequence[Entry],
    collector: Collector,
    *,
    base: Values | None = None,
    detail: Detail = "summary",
) -> Values:
    """Check ``entries`` against ``schema`` and return the values; see ``load_list``."""
    values: dict[Key, EntryValue] = {}
    if base is not None:
        values = {**base.entry_values, **base.unused_values}
    selected = _select(schema, entries, collector, detail)
    for key, (parameter, entry) in selected.items():
        earlier = values.get(key)
        default = default_of(schema, values, parameter, key[1])
        if earlier is not None:
            default = earlier.value
        reference = reference_of(parameter, entry) if schema.dialect.references else ""
        if reference:
            values[key] = EntryValue(default, entry, reference)
            continue
        limits = _limits(schema, values, selected, parameter, key[1])
        value = convert(parameter, entry, schema.dialect, default, collector, limits)
        if value is not None:
            values[key] = EntryValue(value, entry)
    values = keep_limits(schema, file, resolve(schema, values, collector), collector)
    used = {key: item for key, item in values.items() if _is_used(schema, key)}
    unused = {key: item for key, item in values.items() if key not in used}
    report_without_effect(schema, file, values, tuple(unused), collector, detail)
    return Values(schema, file, used, unused)


def _limits(
    schema: Schema,
    values: Mapping[Key, EntryValue],
    selected: Mapping[Key, tuple[Parameter, Entry]],
    parameter: Parameter,
    indices: tuple[int, ...],
) -> dict[str, str]:
    """Return entry and value of each parameter that is a bound of this one, by their IDs."""
    found: dict[str, str] = {}
    for limit in (parameter.at_least, parameter.at_most):
        key = None if limit is None else key_of(schema, limit.id, indices)
        if limit is None or key is None:
            continue
        value = effective_value(schema, values, limit.id, indices)
        if key in selected and not reference_of(*selected[key]):
            own = convert(*selected[key], schema.dialect, value, Collector())
            value = value if own is None else own
        if value not in (None, 0):  # 0 may mean "not set"
            found[limit.id] = f"{with_indices(*key)} = {shown(value)}"
    return found


def _is_used(schema: Schema, key: Key) -> bool:
    declared = schema.find(key[0])
    return declared is not None and declared[0].effect is Effect.USED


def _select(
    schema: Schema, entries: Sequence[Entry], collector: Collector, detail: Detail
) -> dict[Key, tuple[Parameter, Entry]]:
    """Return the effective entry of each parameter."""
    selected: dict[Key, tuple[Parameter, Entry]] = {}
    unknown: list[Entry] = []
    for entry in entries:
        declared = schema.find(entry.pattern) if entry.is_well_formed else None
        if declared is None:
            unknown.append(entry)
            continue
        parameter, alias = declared
        if not _check_indices(parameter, entry, collector):
            continue
        name = with_indices(parameter.pattern, entry.indices)
        if alias is not None and not alias.silent:
            collector.report(
                OLD_PARAMETER_NAME, entry.key_span, entry.line, alias=entry.path, key=name
            )
        key = (parameter.pattern, entry.indices)
        earlier = selected.get(key)
        winner = entry
        if earlier is not None:
            winner = _check_duplicate(parameter, earlier[1], entry, name, collector)
        selected[key] = (parameter, winner)
    _report_unknown(schema, unknown, collector, detail)
    return selected


def _check_indices(parameter: Parameter, entry: Entry, collector: Collector) -> bool:
    for index, (low, high) in zip(entry.indices, parameter.index_ranges, strict=True):
        if not low <= index <= high:
            collector.report(
                PARAMETER_INDEX_OUT_OF_RANGE,
                entry.key_span,
                entry.line,
                key=entry.path,
                low=low,
                high=high,
            )
            return False
    return True


def _check_duplicate(
    parameter: Parameter, first: Entry, second: Entry, name: str, collector: Collector
) -> Entry:
    """Return the effective entry: the last, or the one with the present name."""
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
    schema: Schema, unknown: Sequence[Entry], collector: Collector, detail: Detail
) -> None:
    """Report unknown entries at their lines, from a maximum on all others together."""
    foreign = {name.pattern: name for name in schema.foreign}
    strangers: list[Entry] = []
    number = UNKNOWN_ENTRY_NUMBERS.get(schema.kind, 0)
    for entry in unknown:
        if entry.pattern in foreign:
            other = foreign[entry.pattern]
            collector.report_as(
                number,
                PARAMETER_OF_OTHER_LIST,
                entry.key_span,
                entry.line,
                key=entry.path,
                list=other.kind,
                id=other.id,
            )
            continue
        nearest = schema.nearest(entry.pattern)
        if nearest is None:
            strangers.append(entry)
            continue
        if nearest.count("[]") == len(entry.indices):
            nearest = with_indices(nearest, entry.indices)
        nearest = nearest.replace("[]", "[i]")
        collector.report_as(
            number,
            MISSPELLED_PARAMETER,
            entry.key_span,
            entry.line,
            key=entry.path,
            nearest=nearest,
        )
    single = strangers if detail == "all" else strangers[:_NAMED_ENTRIES]
    for entry in single:
        collector.report_as(number, UNKNOWN_PARAMETER, entry.key_span, entry.line, key=entry.path)
    if len(strangers) > len(single):
        first = strangers[len(single)]
        position = Span(first.key_span.file, first.key_span.line, 1, 2)
        collector.report(UNKNOWN_ENTRIES, position, first.line, count=len(strangers) - len(single))
