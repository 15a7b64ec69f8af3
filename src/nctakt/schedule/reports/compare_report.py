# SPDX-License-Identifier: MIT
"""A comparison of two lists as tables of text, and for other programs.

In: ``Comparison``, both sides. Out: text in the user's language, a dictionary; times in µs.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.analysis.compare import Comparison, Side, ThreadSide, Verdict
from nctakt.schedule.analysis.findings import us
from nctakt.schedule.model import NS_PER_US
from nctakt.schedule.reports.documents import Document
from nctakt.schedule.reports.report import NONE, bound_text, chosen_report, table

_VERDICTS = {
    Verdict.BETTER: Text("better", "besser"),
    Verdict.WORSE: Text("worse", "schlechter"),
    Verdict.SAME: Text("same", "gleich"),
    Verdict.ADDED: Text("only in B", "nur in B"),
    Verdict.REMOVED: Text("only in A", "nur in A"),
}


def comparison_report(comparison: Comparison, first: Side, second: Side, language: Language) -> str:
    """Return the differences, then threads and Windows in both lists."""
    lines: list[str] = []
    for letter, side in (("A", first), ("B", second)):
        lines += [f"{letter}: {side.name}"]
        lines += [f"   {line}" for line in chosen_report(side.run.model, language)]
    lines += ["", *_parameters(comparison, language)]
    lines += ["", *_threads(comparison, language), "", *_windows(comparison, language)]
    return "\n".join(lines) + "\n"


def _parameters(comparison: Comparison, language: Language) -> list[str]:
    if not comparison.parameters:
        return [Text("Both lists say the same.", "Beide Listen sagen dasselbe.").get(language)]
    heads = [Text("Parameter", "Parameter").get(language), "A", "B"]
    return table(heads, [list(row) for row in comparison.parameters], left=3)


def _threads(comparison: Comparison, language: Language) -> list[str]:
    heads = Text(
        "Thread|R max A|R max B|Change|R bound A|R bound B|Overflows A|Overflows B|B is",
        "Thread|R max A|R max B|Änderung|R Schranke A|R Schranke B|Überläufe A|Überläufe B|B ist",
    )
    rows = []
    for thread in comparison.threads:
        sides = (thread.first, thread.second)
        longest = [None if side is None else side.numbers.response_max for side in sides]
        rows.append(
            [
                thread.name,
                *(NONE if time is None else us(time) for time in longest),
                _change(*longest),
                *(NONE if side is None else bound_text(side.bound) for side in sides),
                *(NONE if side is None else str(side.numbers.overflows) for side in sides),
                _VERDICTS[thread.verdict].get(language),
            ]
        )
    return table(heads.get(language).split("|"), rows)


def _change(first: int | None, second: int | None) -> str:
    if first is None or second is None:
        return NONE
    change = second - first
    return f"+{us(change)}" if change > 0 else f"−{us(-change)}" if change < 0 else "0"


def _windows(comparison: Comparison, language: Language) -> list[str]:
    heads = Text(
        "Windows|Share A %|Share B %|Min A|Min B|B is",
        "Windows|Anteil A %|Anteil B %|Min A|Min B|B ist",
    )
    rows = [
        [
            f"CPU {windows.cpu}" if windows.cpu else Text("sum", "Summe").get(language),
            *(NONE if share is None else f"{100 * share:.2f}" for share in windows.shares),
            *(NONE if minimum is None else us(minimum) for minimum in windows.minimum),
            _VERDICTS[windows.verdict].get(language),
        ]
        for windows in comparison.windows
        if windows.cpu or len(comparison.windows) > 2  # the sum of one processor is that processor
    ]
    return table(heads.get(language).split("|"), rows)


def comparison_document(comparison: Comparison, first: Side, second: Side) -> Document:
    """Return the comparison for other programs."""
    return {
        "first": first.name,
        "second": second.name,
        "parameters": [
            {"name": name, "first": windows, "second": other}
            for name, windows, other in comparison.parameters
        ],
        "threads": [
            {
                "name": thread.name,
                "first": _side(thread.first),
                "second": _side(thread.second),
                "verdict": thread.verdict.value,
            }
            for thread in comparison.threads
        ],
        "windows": [
            {
                "cpu": windows.cpu or None,
                "share_pct": [
                    None if share is None else round(100 * share, 3) for share in windows.shares
                ],
                "min_us": [None if time is None else time / NS_PER_US for time in windows.minimum],
                "verdict": windows.verdict.value,
            }
            for windows in comparison.windows
        ],
    }


def _side(thread: ThreadSide | None) -> Document | None:
    if thread is None:
        return None
    longest, bound = thread.numbers.response_max, thread.bound.response
    return {
        "response_max_us": None if longest is None else longest / NS_PER_US,
        "response_bound_us": None if bound is None else bound / NS_PER_US,
        "is_exact": thread.bound.is_exact,
        "overflows": thread.numbers.overflows,
        "due": thread.numbers.due,
    }
