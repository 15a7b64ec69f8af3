# SPDX-License-Identifier: MIT
"""Verdicts of a study on its runs as a whole: shares with intervals, limits of measures.

In: counts, a plan. Out: numbers for summary and report.
"""

from __future__ import annotations

import math
import re

from nctakt.base.failure import Failure
from nctakt.lists.format.times import read_time
from nctakt.studies.plans.plan import Plan

#: Quantile of the normal distribution for an interval of 95 %.
_QUANTILE = 1.959963984540054

_LIMIT = re.compile(r"\s*(?P<subject>[^<>=]+?)\s*(?:<=|>=|<|>|=)\s*(?P<value>[^<>=]+?)\s*")


def wilson(count: int, total: int) -> tuple[float, float]:
    """Return Wilson's interval of 95 % for a share of which ``count`` of ``total`` were seen."""
    share, square = count / total, _QUANTILE * _QUANTILE
    middle = share + square / (2 * total)
    spread = _QUANTILE * math.sqrt(share * (1 - share) / total + square / (4 * total * total))
    low, high = (middle - spread) / (1 + square / total), (middle + spread) / (1 + square / total)
    return (low if count else 0.0), (high if count < total else 1.0)


def share_text(count: int, total: int) -> str:
    """Return a share in percent with its interval, such as ``25 % (7.1 … 59.1 %)``."""
    low, high = wilson(count, total)
    return f"{100 * count / total:.3g} % ({100 * low:.3g} … {100 * high:.3g} %)"


def limits_of(plan: Plan, measure: str) -> list[float]:
    """Return the numbers that expectations compare a measure with, by its name or its text."""
    texts = {measure} | {one.text for one in plan.measures if one.name == measure}
    found = []
    for expectation in plan.expectations:
        match = _LIMIT.fullmatch(expectation.text)
        if match is not None and match["subject"] in texts:
            value = _number(match["value"])
            if value is not None:
                found.append(value)
    return found


def _number(text: str) -> float | None:
    """Return a number or a time in seconds; ``None`` for anything else."""
    try:
        return float(text)
    except ValueError:
        pass
    try:
        time = read_time(text)
    except Failure:
        return None
    return None if time.is_in_ticks else time.us(1) / 1e6
