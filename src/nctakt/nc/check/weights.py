# SPDX-License-Identifier: MIT
"""G functions with weights in per cent: ``G131=70``, ``G136 X100``."""

from __future__ import annotations

from nctakt.messages.checked_blocks import WORD_VALUE_MISSING
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, Number, Word
from nctakt.nc.vocabulary.function_rows import Form, GFunction


def check_weight(word: Word, values: ValueChecker, findings: Findings) -> None:
    """Check the weight of all axes: ``G131=70``."""
    if word.additional is None or word.arguments:
        findings.report(WORD_VALUE_MISSING, word.span, word=findings.written(word.span))
    else:
        values.value(word.additional)


def is_neutral(word: Word, entry: GFunction, axes: tuple[AxisWord, ...]) -> bool:
    """Return whether a G function that is not simulated changes nothing: ``G131=100``."""
    if entry.neutral is None:
        return False
    if entry.form is Form.AXIS_WEIGHTS and word.additional is None:
        values = [axis.value for axis in axes]
    else:
        values = [word.additional]
    return bool(values) and all(
        isinstance(value, Number) and value.value == entry.neutral for value in values
    )
