# SPDX-License-Identifier: MIT
"""Blocks with G04: the time of the dwell is their only other word."""

from __future__ import annotations

from nctakt.messages.programs.checked_blocks import (
    G04_NOT_ALONE,
    G04_WITH_TWO_TIMES,
    G04_WITHOUT_TIME,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, Block, Expression, Number, Word
from nctakt.nc.vocabulary.functions import DWELL


def dwell_of(block: Block) -> Word | None:
    """Return the G04 of a block."""
    for word in block.words:
        if isinstance(word, Word) and word.name == "G" and isinstance(word.value, Number):
            if word.value.value == DWELL:
                return word
    return None


def check_dwell(block: Block, dwell: Word, values: ValueChecker, findings: Findings) -> None:
    """Check ``G04`` with its time, ``G04 X0.5``, ``G04 0.5``, or its revolutions, ``G04 S10``."""
    others = [word for word in block.words if word is not dwell]
    times: list[Expression] = [] if dwell.additional is None else [dwell.additional]
    wrong = bool(dwell.arguments)
    for word in others:
        if isinstance(word, AxisWord) and word.name == "X" and word.value is not None:
            times.append(word.value)
        elif isinstance(word, Word) and word.name == "S" and word.value is not None:
            times.append(word.value)
        else:
            wrong = True
    if wrong:
        findings.report(G04_NOT_ALONE, dwell.span)
    elif not times:
        findings.report(G04_WITHOUT_TIME, dwell.span)
    elif len(times) > 1:
        findings.report(G04_WITH_TWO_TIMES, dwell.span)
    for time in times:
        values.value(time)
