# SPDX-License-Identifier: MIT
"""Independent axes of programs, checked before the run: ``X[INDP_SYN …]``, ``X[INDP_ASYN …]``."""

from __future__ import annotations

from nctakt.messages.independent_axes import AXIS_MOVED_TWICE
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import AxisWord, BracketCommand
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.independent_axes import form_of, read_independent


def check_independent(
    command: BracketCommand,
    path: tuple[AxisWord, ...],
    values: ValueChecker,
    findings: Findings,
) -> bool:
    """Check a command for an independent axis; return false for another command.

    ``path``: the words of the block's axes.
    """
    form = form_of(command)
    if not form:
        return False
    parsed, wrong, refused = read_independent(command)
    for finding in wrong:
        findings.report(finding.message, finding.span, **finding.values)
    for word, span in refused:
        entry = support_level.form(f"X[{form} {word}]")
        findings.report_support(entry, span, f"{command.name}[{form} {word}]")
    reported = {finding.span for finding in wrong}
    for value in parsed.expressions():
        if value.span not in reported:
            values.value(value)
    if any(word.name == command.name for word in path):
        findings.report(AXIS_MOVED_TWICE, command.span, axis=command.name, form=form)
    return True
