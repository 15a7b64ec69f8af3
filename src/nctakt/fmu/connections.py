# SPDX-License-Identifier: MIT
"""Connections between variables of an FMU and of a machine, with units.

In: the tables of ``[fmu]`` in the project file, or nothing, and then variables of equal names. Out:
inputs that are read from the machine, outputs that are written to it; one ``FmuError`` with all
mistakes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Diagnostic, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.base.unit_factors import factor_between
from nctakt.fmu.description import FmuDescription, FmuVariable
from nctakt.fmu.failures import FmuError
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import (
    FMU_NOT_CONNECTED,
    FMU_START_REFUSED,
    FMU_UNITS_DIFFER,
    FMU_VARIABLE_NOT_POSSIBLE,
    UNKNOWN_FMU_VARIABLE,
)

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine

_INPUT = Text("an input", "ein Eingang")
_OUTPUT = Text("an output or a variable inside", "ein Ausgang oder eine innere Variable")
_START = Text("a parameter or an input", "ein Parameter oder ein Eingang")
#: Causalities that each table takes.
_FITTING = {
    "inputs": (_INPUT, ("input",)),
    "outputs": (_OUTPUT, ("output", "local", "calculatedParameter")),
    "start": (_START, ("parameter", "structuralParameter", "input")),
}
#: Names that a message lists at most.
_LISTED = 12


@dataclass(frozen=True, slots=True)
class FmuTables:
    """The tables of ``[fmu]``: variables of the FMU -> names of the machine, or start values.

    ``places``: where start values are in a project file, with the lines.
    """

    inputs: Mapping[str, str]
    outputs: Mapping[str, str]
    start: Mapping[str, float | bool | str]
    places: Mapping[str, tuple[Span, str]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Connection:
    """A variable of the FMU and a name of the machine; ``factor``: of the value on its way."""

    variable: FmuVariable
    name: str
    factor: float = 1.0

    def scaled(self, value: float | bool | str) -> float | bool | str:
        """Return a value in the unit of the other side."""
        if isinstance(value, str) or self.factor == 1.0:
            return value
        return value * self.factor


class Connections:
    """The connections of an FMU with a machine."""

    def __init__(
        self, description: FmuDescription, tables: FmuTables, machine: AssembledMachine
    ) -> None:
        self._description = description
        self._machine = machine
        self._signals = machine.signals()
        self._found: list[Diagnostic] = []
        inputs, outputs = tables.inputs, tables.outputs
        if not inputs and not outputs:
            inputs = self._of_equal_name("input", self._is_readable)
            outputs = self._of_equal_name("output", self._is_writable)
        self.inputs = self._connected("inputs", inputs)
        self.outputs = self._connected("outputs", outputs)
        self.start = {
            one: self._start_value(one, tables) for one in self._variables("start", tables.start)
        }
        if not self._found and not self.inputs and not self.outputs:
            self._found.append(self._not_connected())
        if self._found:
            raise FmuError(*self._found)

    # --- names of the machine -------------------------------------------------------------------

    def reader(self, name: str) -> Callable[[], float | bool | str]:
        """Return a reader of a value of the machine; raises ``Failure`` for an unknown name."""
        signal = self._signals.get(name)
        if signal is not None:
            cells, cell = self._machine.cells, signal.cell
            return lambda: cells[cell]
        access = self._machine.access
        try:
            access.read(name)
        except Failure as failure:
            if "^" in name or name.upper().startswith(("V.", "CH")):
                raise
            raise Failure(self._machine.unknown_signal(name)) from failure
        return lambda: access.read(name)

    def _is_readable(self, name: str) -> bool:
        try:
            self.reader(name)
        except Failure:
            return False
        return True

    def _is_writable(self, name: str) -> bool:
        try:
            self._machine.access.check(name, self._machine.access.read(name))
        except Failure:
            return False
        return True

    # --- variables of the FMU -------------------------------------------------------------------

    def _of_equal_name(self, causality: str, is_known: Callable[[str], bool]) -> dict[str, str]:
        return {one.name: one.name for one in self._description.of(causality) if is_known(one.name)}

    def _variables(self, table: str, names: Mapping[str, object]) -> list[FmuVariable]:
        """Return the variables of a table; mistakes are noted."""
        found: list[FmuVariable] = []
        file = str(self._description.file)
        expected, causalities = _FITTING[table]
        for name in names:
            variable = self._description.variables.get(name)
            if variable is None:
                near = nearest(name, self._description.variables) or NOTHING
                self._found.append(
                    diagnostic(UNKNOWN_FMU_VARIABLE, file=file, name=name, nearest=near)
                )
            elif not variable.access or variable.causality not in causalities:
                kind = variable.causality if variable.access else f"{variable.type}[]"
                self._found.append(
                    diagnostic(
                        FMU_VARIABLE_NOT_POSSIBLE,
                        file=file,
                        name=name,
                        found=kind,
                        expected=expected,
                    )
                )
            else:
                found.append(variable)
        return found

    def _connected(self, table: str, names: Mapping[str, str]) -> list[Connection]:
        connections = []
        for variable in self._variables(table, names):
            name = names[variable.name]
            try:
                self.reader(name)
                if table == "outputs":
                    self._machine.access.check(name, self._machine.access.read(name))
            except Failure as failure:
                self._found += failure.diagnostics
                continue
            factor = self._factor(variable, name)
            if factor is not None:
                scale = factor if table == "outputs" else 1.0 / factor
                connections.append(Connection(variable, name, scale))
        return connections

    def _factor(self, variable: FmuVariable, name: str) -> float | None:
        """Return how many of the machine's unit one of the FMU is; what does not fit is noted."""
        own = self._signals[name].unit if name in self._signals else ""
        if not own or not variable.unit:
            return 1.0
        factor = factor_between(variable.unit, own)
        if factor is None:
            self._found.append(
                diagnostic(
                    FMU_UNITS_DIFFER,
                    file=str(self._description.file),
                    name=variable.name,
                    unit=variable.unit,
                    signal=name,
                    own=own,
                )
            )
        return factor

    def _start_value(self, variable: FmuVariable, tables: FmuTables) -> object:
        value = tables.start[variable.name]
        try:
            return variable.begun_with(value)
        except ValueError:
            span, line = tables.places.get(variable.name, (None, ""))
            refused = diagnostic(
                FMU_START_REFUSED,
                span,
                line,
                file=str(self._description.file),
                name=variable.name,
                value=_written(value),
                expected=variable.limits(),
            )
            self._found.append(refused)
            return None

    def _not_connected(self) -> Diagnostic:
        return diagnostic(
            FMU_NOT_CONNECTED,
            file=str(self._description.file),
            inputs=_listed(self._description.of("input")),
            outputs=_listed(self._description.of("output")),
        )


def _written(value: float | bool | str) -> str:
    """Return a value as a project file has it."""
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"


def _listed(variables: Sequence[FmuVariable]) -> str:
    names = [one.name for one in variables]
    return ", ".join([*names[:_LISTED], *["…"] * (len(names) > _LISTED)]) or "-"
