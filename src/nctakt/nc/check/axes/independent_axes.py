# SPDX-License-Identifier: MIT
"""Checks of axes that programs move independently of the path: INDP_SYN, INDP_ASYN, OSC."""

from __future__ import annotations

from nctakt.base.diagnostics import Span
from nctakt.messages.axes.independent_axes import AXIS_MOVED_TWICE
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, BracketCommand, Expression
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.single_axes.axis_brackets import OSC, form_of
from nctakt.nc.vocabulary.single_axes.independent_axes import read_independent
from nctakt.nc.vocabulary.single_axes.oscillation import read_oscillation


def check_independent(
    command: BracketCommand,
    path: tuple[AxisWord, ...],
    values: ValueChecker,
    findings: Findings,
) -> bool:
    """Check a command for an independent axis; return false for any other command.

    ``path``: the words of the block's axes.
    """
    form = form_of(command)
    if not form:
        return False
    expressions: list[Expression]
    refused: list[tuple[str, Span]] = []
    if form == OSC:
        oscillation, wrong = read_oscillation(command)
        expressions = list(oscillation.values.values())
    else:
        parsed, wrong, refused = read_independent(command)
        expressions = parsed.expressions()
    for finding in wrong:
        findings.report(finding.message, finding.span, **finding.values)
    for word, span in refused:
        entry = support_level.form(f"X[{form} {word}]")
        findings.report_support(entry, span, f"{command.name}[{form} {word}]")
    reported = {finding.span for finding in wrong}
    for value in expressions:
        if value.span not in reported:
            values.value(value)
    if any(word.name == command.name for word in path):
        findings.report(AXIS_MOVED_TWICE, command.span, axis=command.name, form=form)
    return True
