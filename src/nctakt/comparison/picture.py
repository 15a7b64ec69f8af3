# SPDX-License-Identifier: MIT
"""A comparison as a picture: both curves of each signal, and their difference below.

In: a ``Comparison`` that keeps its overlaid samples. Out: PNG or SVG (matplotlib, extra ``plot``).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Language, Text
from nctakt.comparison.comparison import Comparison
from nctakt.comparison.deviations import Deviation, Overlaid
from nctakt.plots.picture import new_sheet, picture_of, style_axes
from nctakt.plots.style import FEED, INK, RAPID

#: Signals that a picture shows, those that are farthest beyond their tolerance first.
MAX_SIGNALS = 6
_SIGNAL_HEIGHT_IN = 2.6

_RUN = Text("run", "Lauf")
_LOG = Text("log", "Log")
_DIFFERENCE = Text("log − run", "Log − Lauf")
_TIME = Text("time of the run in s", "Zeit des Laufs in s")


def write_comparison_picture(comparison: Comparison, path: Path, language: Language) -> None:
    """Draw a comparison; raises ``OSError``."""
    shown = sorted(comparison.deviations, key=_urgency)[:MAX_SIGNALS]
    with new_sheet(0.8 + _SIGNAL_HEIGHT_IN * len(shown)) as sheet:
        sheet.suptitle(comparison.log.file, fontsize=11, color=INK)
        rows = sheet.subplots(
            2 * len(shown), 1, sharex=True, squeeze=False, height_ratios=[2, 1] * len(shown)
        )
        for number, one in enumerate(shown):
            assert one.overlaid is not None
            _draw(rows[2 * number][0], rows[2 * number + 1][0], one, one.overlaid, language)
        rows[0][0].legend(fontsize=8, loc="best")
        rows[-1][0].set_xlabel(_TIME.get(language), fontsize=8)
        path.write_bytes(picture_of(sheet, path.suffix.lower()[1:]))


def _urgency(one: Deviation) -> tuple[bool, float]:
    """Return a key that sorts signals beyond their tolerance, then the farthest, to the front."""
    return one.first_us is None, -abs(one.greatest)


def _draw(upper: Any, lower: Any, one: Deviation, both: Overlaid, language: Language) -> None:
    seconds, values, differences = both.times / 1e6, both.values, both.differences
    upper.plot(seconds, values, color=RAPID, linewidth=1.6, alpha=0.6, label=_LOG.get(language))
    upper.plot(seconds, values - differences, color=FEED, linewidth=0.8, label=_RUN.get(language))
    unit = f" [{one.pair.signal.unit}]" if one.pair.signal.unit else ""
    upper.set_ylabel(f"{one.pair.signal.name}{unit}", fontsize=8)
    lower.plot(seconds, differences, color=INK, linewidth=0.8)
    lower.set_ylabel(_DIFFERENCE.get(language), fontsize=8)
    if one.tolerance is not None and not one.ticks:
        for limit in (-one.tolerance, one.tolerance):
            lower.axhline(limit, color=RAPID, linewidth=0.8, linestyle="--")
    if one.first_us is not None:
        for axes in (upper, lower):
            axes.axvline(one.first_us / 1e6, color=RAPID, linewidth=0.8, linestyle=":")
    style_axes(upper)
    style_axes(lower)
