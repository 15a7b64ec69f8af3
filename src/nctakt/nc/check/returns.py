# SPDX-License-Identifier: MIT
"""The options of M17 and M29: ``M17 [MAIN]``, ``M17 [JUMPS=2]``, each with or without a label."""

from __future__ import annotations

from nctakt.messages.programs.program_structure import (
    INVALID_RETURN_OPTION,
    SUBPROGRAM_END_IN_MAIN_PROGRAM,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import BracketCommand, Expression, Keyword, Name, Number


def check_return(
    command: BracketCommand, is_in_main: bool, values: ValueChecker, findings: Findings
) -> None:
    """Check ``M17 […]``; ``is_in_main``: it is in a main program."""
    if is_in_main:
        findings.report(SUBPROGRAM_END_IN_MAIN_PROGRAM, command.span, word=command.name)
    seen: dict[str, None] = {}
    for item in command.items:
        kind = _kind(item)
        if not kind or kind in seen:
            findings.report(INVALID_RETURN_OPTION, item.span, word=findings.written(item.span))
        elif isinstance(item, Keyword) and item.name == "JUMPS" and item.value is not None:
            values.value(item.value)
        seen[kind] = None


def _kind(item: Keyword | Expression) -> str:
    """Return the kind of an item: "calls", "label", or empty if unknown."""
    if isinstance(item, Name):
        return "label"
    if not isinstance(item, Keyword):
        return ""
    if item.name == "JUMPS":
        return "calls" if item.value is not None else ""
    if item.name == "N":
        return "label" if isinstance(item.value, Number) else ""
    if item.value is not None or item.arguments:
        return ""
    return "calls" if item.name == "MAIN" else "label"
