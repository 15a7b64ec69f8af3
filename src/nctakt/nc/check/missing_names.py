# SPDX-License-Identifier: MIT
"""Reports about variables of lists and of the realtime part that do not exist.

In: a variable of the tree, and the reason from the table of names. Out: a diagnostic with the
nearest known name.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.checked_values import (
    STRUCTURE_USED_AS_VALUE,
    UNKNOWN_AXIS_OF_VARIABLE,
    UNKNOWN_VARIABLE,
    WRONG_INDEX_COUNT,
)
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Part, Variable
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.vocabulary.variables.resolution import indices_of, path_text
from nctakt.nc.vocabulary.variables.system_variables import (
    SystemVariable,
    known_paths,
    system_variable,
)
from nctakt.nc.vocabulary.variables.variable_table import (
    DECLARED,
    Location,
    NameTable,
    NotFound,
    Problem,
)

#: Family of a variable -> where its variables are declared.
_DECLARED_IN = {
    family: Text(
        f"V.{family} variables are declared in the machine's list of variables: "
        f"{entry}[0].name and so on.",
        f"V.{family}-Variablen deklariert die Variablenliste der Maschine: {entry}[0].name usw.",
    )
    for family, entry in (("E", "var"), ("CH", "vch"))
} | {
    family: Text(
        f"nctakt explain V.{family} lists those that exist.",
        f"nctakt explain V.{family} zählt auf, welche es gibt.",
    )
    for family in ("RTG", "RTA", "G", "A")
}
#: Names that other controls use for the values of a tool.
_TOOL_WORDS = {"RADIUS": "R", "RAD": "R", "LENGTH": "L", "LEN": "L", "LAENGE": "L"}
_INDEX = re.compile(r"\[\d+\]")


class MissingNames:
    """Reports missing variables, for the axes of one channel."""

    def __init__(self, names: NameTable, axes: Sequence[str], findings: Findings) -> None:
        self._names = names
        self._axes = axes
        self._findings = findings
        self._meant: dict[str, str] = {}

    def report(self, variable: Variable, missing: NotFound) -> None:
        """Report why a variable does not exist."""
        report, span = self._findings.report, variable.span
        match missing.reason:
            case Problem.UNKNOWN if self._lacks_axis(variable):
                self._report_lacking(variable)
            case Problem.UNKNOWN:
                near = self._with_axis(variable) or self._spelled(variable) or missing.nearest
                self.unknown(variable, near)
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

    def report_axis(self, variable: Variable) -> bool:
        """Report V.A or V.G without a channel axis; return whether it is such a variable."""
        if not variable.parts:
            return False
        if system_variable(variable, (variable.parts[-1].name,)) is not None:
            self._report_lacking(variable)
            return True
        axis = Part(variable.span, self._axes[0]) if self._axes else variable.parts[-1]
        completed = replace(variable, parts=(*variable.parts, axis))
        if system_variable(completed, self._axes) is None:
            return False
        self.unknown(variable, path_text(completed))
        return True

    def report_spindle(self, variable: Variable, system: SystemVariable) -> None:
        """Report V.SPDL or V.SPDL_PROG of a spindle that the channel lacks."""
        spindles = self._names.spindle_names
        if system.kind == "spindle" and system.axis and system.axis not in spindles:
            self.unknown(variable, ", ".join(spindles))

    def unknown(self, variable: Variable, near: str = "") -> None:
        """Report a variable that does not exist; ``near``: the known one that was meant."""
        self._findings.report(
            UNKNOWN_VARIABLE,
            variable.span,
            name=path_text(variable),
            nearest=near or NOTHING,
            declared=self._ignored(variable) or _DECLARED_IN.get(variable.family, NOTHING),
        )

    def _ignored(self, variable: Variable) -> Text | None:
        """Return where the list declares a variable that is ignored; ``None`` if it does not."""
        if not variable.parts:
            return None
        found = self._names.ignored.get(f"V.{variable.family}.{variable.parts[0].name}")
        if found is None:
            return None
        at, line = f"{Path(found.declared.file).name}:{found.declared.line}", found.reason.line
        return Text(
            f"It is declared in {at}, and ignored because of its {found.what.en} (line {line}).",
            f"Sie ist in {at} deklariert und wird wegen {found.what.de} (Zeile {line}) ignoriert.",
        )

    def nearest_system_variable(self, variable: Variable) -> str:
        """Return the controller's variable probably meant by an unknown one, else an empty text."""
        first, _, last = path_text(variable).rpartition(".")
        name = f"{first}.{_TOOL_WORDS.get(last, last)}"
        if name not in self._meant:
            known = known_paths(self._axes, self._names.spindle_names)
            self._meant[name] = nearest(name, known)
        return self._meant[name]

    def nearest_value(self, name: str) -> str:
        """Return the function, constant or variable that a name is meant for, else an empty
        text.
        """
        if name not in self._meant:
            names = [*FUNCTIONS, *CONSTANTS]
            if "." in name:
                names = [path for path, _ in self._names.realtime()]
                names += [path for path, _, _ in self._names.values()]
            self._meant[name] = nearest(name, names)
        return self._meant[name]

    def _report_lacking(self, variable: Variable) -> None:
        self._findings.report(
            UNKNOWN_AXIS_OF_VARIABLE,
            variable.span,
            name=path_text(variable),
            axis=variable.parts[-1].name,
            axes=", ".join(self._axes),
        )

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
        """Return whether the V.RTA variable exists for an axis other than the one named."""
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
