# SPDX-License-Identifier: MIT
"""Suggestions as tables of text, and for other programs.

In: ``Suggestions``, the slacks. Out: text in the user's language, a dictionary; times in µs.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.lists.format.parameter import shown, with_indices
from nctakt.schedule.analysis.analyse import TaskAnalysis
from nctakt.schedule.analysis.suggest import Slacks, Suggestion, Suggestions
from nctakt.schedule.effective_table import effective_values
from nctakt.schedule.model import NS_PER_US
from nctakt.schedule.reports.documents import Document
from nctakt.schedule.reports.report import NONE, bound_text, chosen_report, table


def changed_entries(present: Suggestion, suggestion: Suggestion) -> list[tuple[str, str, str]]:
    """Return name, present and suggested value of each parameter that differs."""
    before = effective_values(present.configuration)
    after = effective_values(suggestion.configuration)
    return [
        (with_indices(*key), shown(before[key]), shown(value))
        for key, value in after.items()
        if before[key] != value
    ]


def suggestion_report(suggestions: Suggestions, slacks: Slacks, language: Language) -> str:
    """Return the present values of the list, and possible changes."""
    present = suggestions.present
    lines = chosen_report(present.analysis.model, language)
    lines += ["", *_threads(present, slacks, language)]
    if suggestions.is_met:
        met = Text(
            "The list has the slacks that are asked for.",
            "Die Liste hat die verlangten Reserven.",
        )
        lines += ["", met.get(language)]
        more = Text(
            "{thread} could call task_rnd {count} times per activation.",
            "{thread} könnte task_rnd je Aktivierung {count}-mal aufrufen.",
        )
        lines += [
            more.get(language).format(thread=name, count=count)
            for name, count in suggestions.max_calls.items()
        ]
    for number, suggestion in enumerate(suggestions.better, start=1):
        title = Text("Suggestion {number}", "Vorschlag {number}").get(language)
        heads = Text("Parameter|Now|Suggested", "Parameter|Jetzt|Vorschlag").get(language)
        rows = [list(row) for row in changed_entries(present, suggestion)]
        lines += ["", title.format(number=number), *table(heads.split("|"), rows, left=3)]
        lines += ["", *_threads(suggestion, slacks, language)]
    return "\n".join(lines) + "\n"


def _threads(suggestion: Suggestion, slacks: Slacks, language: Language) -> list[str]:
    heads = Text(
        "Thread|Period|R bound|Slack %|Asked for %|Met",
        "Thread|Periode|R Schranke|Reserve %|Verlangt %|Erfüllt",
    )
    yes, no = Text("yes", "ja").get(language), Text("no", "nein").get(language)
    rows = []
    for task, bound in zip(suggestion.analysis.model.tasks, suggestion.analysis.tasks, strict=True):
        is_met = bound.response is not None and bound.response <= slacks.limit(
            task.name, bound.period
        )
        rows.append(
            [
                task.name,
                f"{bound.period / NS_PER_US:g}",
                bound_text(bound),
                _slack_text(bound),
                f"{slacks.threads.get(task.name, slacks.everybody):g}",
                yes if is_met or not task.calls else no,
            ]
        )
    return table(heads.get(language).split("|"), rows)


def _slack_pct(bound: TaskAnalysis) -> float | None:
    return None if bound.slack is None else 100 * bound.slack / max(1, bound.period)


def _slack_text(bound: TaskAnalysis) -> str:
    share = _slack_pct(bound)
    return NONE if share is None else f"{share:.1f}"


def suggestion_document(suggestions: Suggestions, slacks: Slacks) -> Document:
    """Return the suggestions for other programs."""
    present = suggestions.present
    return {
        "is_met": suggestions.is_met,
        "slack_pct": slacks.everybody,
        "threads": _thread_documents(present),
        "max_calls": dict(suggestions.max_calls),
        "suggestions": [
            {
                "changes": [
                    {"name": name, "present": before, "suggested": after}
                    for name, before, after in changed_entries(present, suggestion)
                ],
                "threads": _thread_documents(suggestion),
            }
            for suggestion in suggestions.better
        ],
    }


def _thread_documents(suggestion: Suggestion) -> list[Document]:
    pairs = zip(suggestion.analysis.model.tasks, suggestion.analysis.tasks, strict=True)
    return [
        {
            "key": task.key,
            "name": task.name,
            "response_bound_us": None if bound.response is None else bound.response / NS_PER_US,
            "slack_pct": _slack_pct(bound),
        }
        for task, bound in pairs
    ]
