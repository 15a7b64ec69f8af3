# SPDX-License-Identifier: MIT
"""The signals that conditions of realtime cycles read.

In: loaded programs, by the number of their channel. Out: names of signals; a variable whose index
is computed has none, since it can be a different element in each tick.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from nctakt.nc import tree
from nctakt.nc.check.cycles.branches import branch_outlines
from nctakt.nc.vocabulary.variables.resolution import indices_of, resolve, variables_in
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.assembly import AssembledMachine


def with_condition_signals(
    names: Sequence[str],
    programs: Mapping[int, Sequence[LoadedProgram]],
    machine: AssembledMachine,
) -> list[str]:
    """Return ``names`` followed by the further signals that conditions of programs read."""
    of_cell: dict[int, str] = {}
    for name, (cell, *_) in machine.signals().items():
        of_cell.setdefault(cell, name)
    further = (
        of_cell[cell]
        for number, loaded in programs.items()
        for program in loaded
        for cell in _cells(program, machine.assembled[number - 1].names)
        if cell in of_cell
    )
    return list(dict.fromkeys((*names, *further)))


def _cells(program: LoadedProgram, names: NameTable) -> Iterator[int]:
    """Yield the cells of the variables in conditions, in the order of the text."""
    for text in program.texts:
        for cycle in text.cycles:
            for branch in branch_outlines(cycle):
                if branch.condition is None:
                    continue
                for variable in variables_in(branch.condition):
                    cell = _cell(variable, names)
                    if cell is not None:
                        yield cell


def _cell(variable: tree.Variable, names: NameTable) -> int | None:
    """Return the cell of a number with constant indices, else ``None``."""
    location = resolve(variable, names)
    if not isinstance(location, Location) or not location.is_numeric:
        return None
    cell = location.cell
    for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
        if not isinstance(index, tree.Number):
            return None
        cell += int(index.value) * dimension.stride
    return cell
