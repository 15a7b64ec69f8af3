# SPDX-License-Identifier: MIT
"""G functions with weights in per cent: ``G131=70``."""

from __future__ import annotations

from nctakt.messages.programs.checked_blocks import WORD_VALUE_MISSING
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Number, Word
from nctakt.nc.vocabulary.function_rows import GFunction


def check_weight(word: Word, values: ValueChecker, findings: Findings) -> None:
    """Check the weight of all axes: ``G131=70``."""
    if word.additional is None or word.arguments:
        findings.report(WORD_VALUE_MISSING, word.span, word=findings.written(word.span))
    else:
        values.value(word.additional)


def is_neutral(word: Word, entry: GFunction) -> bool:
    """Return whether a G function that is not simulated changes nothing: ``G52=0``."""
    value = word.additional
    return isinstance(value, Number) and value.value == entry.neutral
