# SPDX-License-Identifier: MIT
"""Where the time went, as a picture: a bar for each of the slowest blocks, in the program's order.

In: ``TimeAccount``. Out: PNG or SVG (matplotlib, extra ``plot``).
"""

from __future__ import annotations

from pathlib import Path

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.plots.picture import new_sheet, picture_of, style_axes
from nctakt.plots.style import FEED, INK, RAPID
from nctakt.results.summary import headline
from nctakt.timing.entries import Purpose, TimeAccount
from nctakt.timing.words import KINDS, PHASES

#: Bars at most: the slowest blocks.
MAX_BARS = 40
#: Characters of a block's text.
_MAX_TEXT = 44
_BAR_HEIGHT_IN = 0.24

_TIME = Text("time in s", "Zeit in s")
_OTHERS = Text("{count} other blocks", "{count} weitere Sätze")

#: The distinctions made by colours, and the colours.
_COLOURS = {
    "rapid": RAPID,
    "feed": FEED,
    "accelerating": "#0d9488",
    "braking": "#b45309",
    "dwell": "#7c3aed",
    "wait": "#f59e0b",
    "commands": "#6b7280",
    "backward": "#8c564b",
}


def write_time_picture(account: TimeAccount, path: Path, language: Language) -> None:
    """Draw the slowest blocks of a run; raises ``OSError``."""
    groups = account.by(lambda one: (_bar(one), _colour(one)))
    totals: dict[tuple[int, Span | None], int] = {}
    for (bar, _), ticks in groups.items():
        if bar[1] is not None:
            totals[bar] = totals.get(bar, 0) + ticks
    kept = set(sorted(totals, key=lambda one: -totals[one])[:MAX_BARS])
    bars = [bar for bar in totals if bar in kept]
    with new_sheet(1.6 + _BAR_HEIGHT_IN * max(len(bars), 2)) as sheet:
        sheet.suptitle(headline(account.run, language, None), fontsize=11, color=INK)
        axes = sheet.add_subplot()
        left = [0] * len(bars)
        for name, colour in _COLOURS.items():
            widths = [account.us(groups.get((bar, name), 0)) for bar in bars]
            if any(widths):
                seconds = [width / 1e6 for width in widths]
                begins = [begin / 1e6 for begin in left]
                axes.barh(
                    range(len(bars)),
                    seconds,
                    left=begins,
                    color=colour,
                    label=_name(name, language),
                )
                left = [begin + width for begin, width in zip(left, widths, strict=True)]
        axes.set_yticks(range(len(bars)), [_label(account, bar) for bar in bars], fontsize=7)
        axes.set_ylim(max(len(bars), 2) - 0.4, -0.6)
        text = _TIME.get(language)
        if len(totals) > len(bars):
            others = _OTHERS.get(language).format(count=len(totals) - len(bars))
            text = f"{text} ({others})"
        axes.set_xlabel(text, fontsize=8)
        if bars:
            axes.legend(fontsize=8, loc="best")
        style_axes(axes)
        path.write_bytes(picture_of(sheet, path.suffix.lower()[1:]))


def _bar(one: Purpose) -> tuple[int, Span | None]:
    return one.channel, one.span


def _colour(one: Purpose) -> str:
    if one.kind in ("rapid", "feed") and one.phase in ("accelerating", "braking"):
        return one.phase
    return one.kind


def _name(name: str, language: Language) -> str:
    for words in (KINDS, PHASES):
        for key, text in words.items():
            if key == name:
                return text.get(language)
    raise ValueError(name)


def _label(account: TimeAccount, bar: tuple[int, Span | None]) -> str:
    channel, span = bar
    assert span is not None
    prefix = f"CH{channel} " if account.channels > 1 else ""
    return f"{prefix}{span.line}: {account.lines[span]}"[:_MAX_TEXT]
