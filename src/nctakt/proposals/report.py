# SPDX-License-Identifier: MIT
"""Proposals as text and as data."""

from __future__ import annotations

from typing import Any

from nctakt.base.diagnostics import Language, Text
from nctakt.proposals.changes import Change
from nctakt.proposals.nearer import Proposal, Proposals
from nctakt.results.summary import Table, plain_table

_TITLE = Text(
    "Single changes that come nearer to the log ({runs} runs; RMS in % of the curves' spans, "
    "without a change {before})",
    "Einzelne Änderungen, die dem Log näher kommen ({runs} Läufe; RMS in % der Spannen "
    "der Kurven, ohne Änderung {before})",
)
_NONE = Text(
    "No single change comes nearer to the log ({runs} runs; RMS {before} % of the curves' spans)",
    "Keine einzelne Änderung kommt dem Log näher ({runs} Läufe; RMS {before} % der "
    "Spannen der Kurven)",
)
_HEADS = (
    Text("change", "Änderung"),
    Text("now", "jetzt"),
    Text("then", "dann"),
    Text("RMS", "RMS"),
)
_EQUAL = Text(
    "The first {count} come equally near: the log does not say which one of them it is.",
    "Die ersten {count} kommen gleich nahe: welche davon es ist, sagt das Log nicht.",
)
_OF = Text("{target} of {owners}", "{target} von {owners}")
_LATE = Text("{target} acknowledged later", "{target} später quittiert")


def proposals_text(proposals: Proposals, language: Language) -> str:
    """Return proposals as text."""
    words = {"runs": proposals.runs, "before": _percent(proposals.distance)}
    if not proposals.found:
        return _NONE.get(language).format(**words) + "\n"
    rows = tuple(_row(one, language) for one in proposals.found)
    heads = tuple(head.get(language) for head in _HEADS)
    lines = [_TITLE.get(language).format(**words), *plain_table(Table(heads, rows))]
    if proposals.equal > 1:
        lines.append(_EQUAL.get(language).format(count=proposals.equal))
    return "\n".join(lines) + "\n"


def _row(one: Proposal, language: Language) -> tuple[str, ...]:
    change = one.change
    return (
        _name(change, language),
        _amount(change, change.present),
        _amount(change, one.value),
        _percent(one.distance),
    )


def _name(change: Change, language: Language) -> str:
    if change.kind == "function":
        return _LATE.get(language).format(target=change.target)
    if change.kind == "variable":
        return change.target
    return _OF.get(language).format(target=change.target, owners=", ".join(change.of))


def _amount(change: Change, value: float) -> str:
    shown = value / 1000.0 if change.kind == "function" else value
    return f"{shown:.10g} {change.unit}"


def _percent(share: float) -> str:
    return f"{share * 100.0:.3g}"


def proposals_document(proposals: Proposals) -> dict[str, Any]:
    """Return proposals as data; the value of a function is its delay in µs."""
    return {
        "distance": proposals.distance,
        "runs": proposals.runs,
        "equal": proposals.equal,
        "found": [
            {
                "kind": one.change.kind,
                "target": one.change.target,
                "of": list(one.change.of),
                "present": one.change.present,
                "value": one.value,
                "unit": "µs" if one.change.kind == "function" else one.change.unit,
                "distance": one.distance,
            }
            for one in proposals.found
        ],
    }
