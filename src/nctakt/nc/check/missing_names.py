# SPDX-License-Identifier: MIT
"""Reports about variables of lists and of the realtime part that do not exist.

In: a variable of the tree, and the reason from the table of names. Out: a diagnostic with the
nearest known name.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from nctakt.messages.checked_values import (
    STRUCTURE_USED_AS_VALUE,
    UNKNOWN_AXIS_OF_VARIABLE,
    UNKNOWN_VARIABLE,
    WRONG_INDEX_COUNT,
)
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Variable
from nctakt.nc.vocabulary.resolution import indices_of, path_text
from nctakt.nc.vocabulary.variable_table import DECLARED, Location, NameTable, NotFound, Problem

_INDEX = re.compile(r"\[\d+\]")


class MissingNames:
    """Reports missing variables, for the axes of one channel."""

    def __init__(self, names: NameTable, axes: Sequence[str], findings: Findings) -> None:
        self._names = names
        self._axes = axes
        self._findings = findings

    def report(self, variable: Variable, missing: NotFound) -> None:
        """Report why a variable does not exist."""
        report, span = self._findings.report, variable.span
        match missing.reason:
            case Problem.UNKNOWN if self._lacks_axis(variable):
                report(
                    UNKNOWN_AXIS_OF_VARIABLE,
                    span,
                    name=path_text(variable),
                    axis=variable.parts[-1].name,
                    axes=", ".join(self._axes),
                )
            case Problem.UNKNOWN:
                nearest = (
                    self._with_axis(variable) or self._spelled(variable) or missing.nearest or "–"
                )
                report(UNKNOWN_VARIABLE, span, name=path_text(variable), nearest=nearest)
            case Problem.INDICES:
                actual = sum(1 for _ in indices_of(variable))
                report(
                    WRONG_INDEX_COUNT,
                    span,
                    name=missing.name,
                    expected=missing.expected_indices,
                    given=actual,
                )
            case Problem.STRUCTURE:
                report(STRUCTURE_USED_AS_VALUE, span, name=missing.name, member=missing.nearest)

    def _with_axis(self, variable: Variable) -> str:
        """Return ``V.RTA.ACS.ACT_POS.X`` if only the axis is missing at the end, else an empty
        text.
        """
        if variable.family == "RTA":
            parts = [(part.name, len(part.indices)) for part in variable.parts]
            for axis in self._axes:
                location = self._names.resolve("RTA", [*parts, (axis, 0)])
                if isinstance(location, Location):
                    return location.name
        return ""

    def _lacks_axis(self, variable: Variable) -> bool:
        """Return whether the V.RTA variable exists for another axis than the one named."""
        if variable.family != "RTA" or len(variable.parts) < 2:
            return False
        parts = [(part.name, len(part.indices)) for part in variable.parts[:-1]]
        return any(
            isinstance(self._names.resolve("RTA", [*parts, (axis, 0)]), Location)
            for axis in self._axes
        )

    def _spelled(self, variable: Variable) -> str:
        """Return the variable that differs only in case, else an empty text."""
        folded = path_text(variable).casefold()
        if variable.family in DECLARED:
            names = (_INDEX.sub("[]", name) for name, _, _ in self._names.values())
            return next((name for name in names if name.casefold() == folded), "")
        parts = [(part.name.upper(), len(part.indices)) for part in variable.parts]
        location = self._names.resolve(variable.family, parts)
        return location.name if isinstance(location, Location) else ""
