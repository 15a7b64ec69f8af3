# SPDX-License-Identifier: MIT
"""rtconf.lis as written and as effective: raw value, effective value, reason.

In: the list's bytes, its configuration, its diagnostics. Out: one row per parameter that the list
names or that counts without it, in the order of the manual.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.declared.schemas import RTCONF
from nctakt.lists.format.entries import read_entries
from nctakt.lists.format.parameter import Parameter, Value, shown, with_indices
from nctakt.lists.format.reader import BLANKS, Entry
from nctakt.lists.format.values import Key
from nctakt.messages import Collector

_WRITTEN = {"en": "as written", "de": "wie geschrieben"}
_DEFAULT = {"en": "default", "de": "Standardwert"}
_UNUSED = {"en": "not used", "de": "nicht verwendet"}


@dataclass(frozen=True, slots=True)
class EffectiveRow:
    """One parameter. ``raw`` is empty when the list does not name it; ``line`` is 0 then."""

    id: str
    key: str
    line: int
    raw: str
    effective: str
    unit: str
    reason: str


def effective_rows(
    file: str,
    data: bytes,
    configuration: RtconfConfiguration,
    diagnostics: list[Diagnostic],
    language: Language,
) -> list[EffectiveRow]:
    """Return the table of a list, a row for each parameter of P-RTCF."""
    entries = effective_entries(file, data)
    counts = {key: shown(value) for key, value in effective_values(configuration).items()}
    keys = sorted({*entries, *counts}, key=_rank)
    return [_row(key, entries.get(key), counts.get(key), diagnostics, language) for key in keys]


def _rank(key: Key) -> tuple[object, ...]:
    patterns = [parameter.pattern for parameter in RTCONF.parameters]
    pattern, indices = key
    group = 0 if not indices else 1 if pattern.startswith("thread") else 2
    is_function = len(indices) == 2
    return group, indices[:1], is_function, indices, patterns.index(pattern)


def effective_entries(file: str, data: bytes) -> dict[Key, Entry]:
    """Return the entry that counts for each parameter that the list names."""
    entries: dict[Key, Entry] = {}
    for entry in read_entries(file, data, RTCONF, Collector()):
        declared = RTCONF.find(entry.pattern) if entry.is_well_formed else None
        if declared is None:
            continue
        parameter, alias = declared
        ranges = zip(entry.indices, parameter.index_ranges, strict=True)
        key = (parameter.pattern, entry.indices)
        if all(low <= index <= high for index, (low, high) in ranges):
            present_name_stands = key in entries and entries[key].pattern == parameter.pattern
            if alias is None or not present_name_stands:
                entries[key] = entry
    return entries


def effective_values(configuration: RtconfConfiguration) -> dict[Key, Value]:
    """Return effective values by parameter; of interrupt_source only the meaning."""
    values: dict[Key, Value] = {
        ("interrupt_source", ()): configuration.interrupt_source.value,
        ("cycle_time", ()): configuration.cycle_time_us,
        ("time_slice", ()): configuration.time_slice_us,
        ("windows_time", ()): configuration.windows_time_us,
        ("external_object_name", ()): configuration.external_object_name,
        ("schedule", ()): configuration.schedule,
    }
    for thread in configuration.threads:
        at = (thread.index,)
        values |= {
            ("thread[].name", at): thread.name,
            ("thread[].cycle", at): thread.cycle_us,
            ("thread[].priority", at): thread.priority,
            ("thread[].error_on_overflow", at): thread.error_on_overflow,
            ("thread[].cpu", at): thread.cpu,
            ("thread[].context_info", at): thread.context,
        }
        for function in thread.functions:
            indices = (thread.index, function.index)
            values |= {
                ("thread[].function[].name", indices): function.name,
                ("thread[].function[].calls_per_cycle", indices): function.calls_per_cycle,
                ("thread[].function[].trace_bit", indices): function.trace_bit,
            }
    for external in configuration.external_threads:
        at = (external.index,)
        values["external_thread[].cycle", at] = external.cycle_us
        values["external_thread[].semaphore_name", at] = external.semaphore_name
    return values


def _row(
    key: Key,
    entry: Entry | None,
    effective: str | None,
    diagnostics: list[Diagnostic],
    language: Language,
) -> EffectiveRow:
    parameter = _parameter(key[0])
    name = with_indices(*key)
    line = 0 if entry is None else entry.key_span.line
    reasons = [
        f"{finding.id}: {finding.text(language)}"
        for finding in diagnostics
        if finding.entry == name
        or (not finding.entry and line and finding.span is not None and finding.span.line == line)
    ]
    if not reasons:
        usual = _DEFAULT if entry is None else _UNUSED if effective is None else _WRITTEN
        reasons = [usual[language]]
    raw = "" if entry is None else _raw(entry)
    shown_value = "–" if effective is None else effective
    return EffectiveRow(
        parameter.id, name, line, raw, shown_value, parameter.unit, "; ".join(reasons)
    )


def _raw(entry: Entry) -> str:
    """Return the value as written, without its comment."""
    text = entry.rest.strip(BLANKS)
    if text.startswith('"') and text.find('"', 1) > 0:
        return text[: text.find('"', 1) + 1]
    return text.split(None, 1)[0] if text else ""


def _parameter(pattern: str) -> Parameter:
    declared = RTCONF.find(pattern)
    assert declared is not None
    return declared[0]
