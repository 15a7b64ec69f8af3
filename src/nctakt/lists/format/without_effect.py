# SPDX-License-Identifier: MIT
"""Reports on entries without effect that would change a run on the machine.

In: the values of one list. Out: findings. One for the file names the entries whose values differ
from the defaults and would change positions, times or program flow; with the detail ``effects``
each of them has a separate finding, with ``all`` each entry without effect.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from nctakt.lists.format.parameter import Parameter, Relevance, Value, shown, with_indices
from nctakt.lists.format.references import default_of
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import EntryValue, Key
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    PARAMETER_MAY_CHANGE_RUN,
    PARAMETER_WITHOUT_EFFECT,
    PARAMETER_WOULD_CHANGE_RUN,
    WITHOUT_EFFECT_MAY_CHANGE_RUN,
    WITHOUT_EFFECT_WOULD_CHANGE_RUN,
)

#: The finding of a file, by the effect of its entries.
_SUMMARIES = {
    Relevance.YES: WITHOUT_EFFECT_WOULD_CHANGE_RUN,
    Relevance.MAYBE: WITHOUT_EFFECT_MAY_CHANGE_RUN,
}
#: The finding of an entry.
_SINGLE = {
    Relevance.YES: PARAMETER_WOULD_CHANGE_RUN,
    Relevance.MAYBE: PARAMETER_MAY_CHANGE_RUN,
    Relevance.NO: PARAMETER_WITHOUT_EFFECT,
}
#: Maximum number of entries in the finding of a file.
_NAMED_ENTRIES = 5


#: The extent of reports: one finding for all entries that would change a run, one for each of them,
#: or one for each entry without effect and each unknown one.
Detail = Literal["summary", "effects", "all"]


def report_without_effect(
    schema: Schema,
    file: str,
    values: Mapping[Key, EntryValue],
    unused: Sequence[Key],
    collector: Collector,
    detail: Detail,
) -> None:
    """Report the entries of ``file`` among ``unused``."""
    by_relevance: dict[Relevance, list[tuple[Key, Parameter, Value]]] = {
        relevance: [] for relevance in Relevance
    }
    for key in unused:
        if values[key].entry.key_span.file != file:
            continue
        declared = schema.find(key[0])
        assert declared is not None, key
        parameter = declared[0]
        default = default_of(schema, values, parameter, key[1])
        changes = values[key].value != default
        relevance = parameter.relevance if changes else Relevance.NO
        by_relevance[relevance].append((key, parameter, default))
    if detail == "summary":
        for relevance in _SUMMARIES:
            _report_summary(relevance, values, by_relevance[relevance], collector)
        return
    for relevance, entries in by_relevance.items():
        if detail == "all" or relevance is not Relevance.NO:
            _report_each(relevance, values, entries, collector)


def _report_summary(
    relevance: Relevance,
    values: Mapping[Key, EntryValue],
    entries: Sequence[tuple[Key, Parameter, Value]],
    collector: Collector,
) -> None:
    if not entries:
        return
    first = min((values[key].entry for key, _, _ in entries), key=lambda entry: entry.key_span.line)
    names = [with_indices(*key) for key, _, _ in entries[:_NAMED_ENTRIES]]
    more = " …" if len(entries) > _NAMED_ENTRIES else ""
    collector.report(
        _SUMMARIES[relevance],
        first.key_span,
        first.line,
        count=len(entries),
        names=", ".join(names) + more,
    )


def _report_each(
    relevance: Relevance,
    values: Mapping[Key, EntryValue],
    entries: Sequence[tuple[Key, Parameter, Value]],
    collector: Collector,
) -> None:
    for key, parameter, default in entries:
        item = values[key]
        collector.report(
            _SINGLE[relevance],
            item.entry.key_span,
            item.entry.line,
            key=with_indices(*key),
            id=parameter.id or "–",
            value=shown(item.value),
            default=shown(default),
            meaning=parameter.text,
        )
