# SPDX-License-Identifier: MIT
"""Values of a machine, bound by name once: then a read is a load, a write an input of a tick.

In: the place of a value, and the values it may have. Out: ``BoundValue``, read and written any
number of times without looking its name up again; ``BoundValues``, several of them as the
attributes of a view. Writes are posted to the kernel, whose next tick latches them (RC-002), and
noted for the tape.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nctakt.kernel.base import arithmetic
from nctakt.kernel.kernel import Kernel
from nctakt.run.access.input_words import WRITE


class InputNotes:
    """Inputs for a listener in the order of their arrival, as cells of ``run.access.inputs``."""

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.is_listening = False
        self.cells: list[Any] = []

    def add(self, source: str, kind: str, values: object, value: object) -> None:
        """Note an input of the coming tick, if anybody listens."""
        if self.is_listening:
            self.cells += (self.kernel.tick, source, kind, values, value)


class BoundValue:
    """A value of a machine by its name: ``value`` is the present one.

    ``access`` (``VariableAccess``) reads and writes values that are not plain numbers.

    A new value counts from the next tick on, but is returned at once. Raises ``Failure`` if the
    value cannot be set, and for a value out of its range.

    >>> controller = Controller()
    >>> position = controller.bind("V.RTA.ACS.ACT_POS.X")
    >>> run = controller.run(NcText("move.nc", "G01 X100 F6000 M30"))
    >>> position.value
    100.0
    """

    def __init__(
        self,
        access: Any,
        kernel: Kernel,
        notes: InputNotes,
        name: str,
        source: str,
        cell: int,
        type_: str,
        bounds: Sequence[float],
    ) -> None:
        kernel.posted.check_cell(cell)
        self.access = access
        self.kernel = kernel
        self.notes = notes
        self.name = name
        self.source = source
        self.cell = cell
        self.type = type_
        self.is_truth = type_ == "BOOLEAN"
        self.is_text = type_.endswith("STRING")
        self.is_whole = type_ not in ("REAL64", "BOOLEAN")
        self.low, self.high = bounds if bounds else (1.0, 0.0)

    def of_source(self, source: str) -> BoundValue:
        """Return the same value for the writes of another source."""
        bounds = (self.low, self.high) if self.low <= self.high else ()
        return BoundValue(
            self.access, self.kernel, self.notes, self.name, source, self.cell, self.type, bounds
        )

    @property
    def value(self) -> float | bool | str:
        """The present value; a new value is returned even before a tick has latched it."""
        if self.is_text:
            return str(self.access.text_of(self.name))
        number = self.kernel.posted.present(self.cell)
        if self.is_truth:
            return number != 0.0
        return number

    @value.setter
    def value(self, value: float | bool | str) -> None:
        self.write(value, self.source)

    def write(self, value: float | bool | str, source: str) -> None:
        """Set the value, as an input of ``source``; raises ``Failure``."""
        if self.low <= self.high and isinstance(value, (float, int)):
            given = float(value)
            number = given
            if self.is_whole:
                number = arithmetic.round_half_even(number)
            elif self.is_truth and number - number == 0.0:
                number = 1.0 if arithmetic.is_true(number) else 0.0
            if self.low <= number <= self.high:
                self.kernel.posted.put(self.cell, number)
                if self.notes.is_listening:
                    self.notes.add(source, WRITE, self.name, given)
                return
        self.access.write_checked(self.name, value)
        self.notes.add(source, WRITE, self.name, value if isinstance(value, str) else float(value))

    def __repr__(self) -> str:
        return f"<{self.name} = {self.value!r}>"


class BoundValues:
    """Values of a machine at these cells, for a class whose attributes are ``BoundAttribute``."""

    def __init__(self, kernel: Kernel, cells: Sequence[int]) -> None:
        self.kernel = kernel
        self.count = len(cells)
        self.numbers = memoryview(bytearray(8 * len(cells) + 8)).cast("q")
        for i, cell in enumerate(cells):
            kernel.posted.check_cell(cell)
            self.numbers[i] = cell


class BoundAttribute:
    """An attribute of a class of bound values: the one with this index among its cells."""

    def __init__(self, index: int) -> None:
        self.index = index

    def __get__(self, values: BoundValues, owner: object) -> float:
        return value_at(values, self.index)

    def __set__(self, values: BoundValues, value: object) -> None:
        raise AttributeError("the controller alone writes this value")


def value_at(values: BoundValues, index: int) -> float:
    """Return the value with this index; raises ``IndexError`` for an unknown one."""
    if not 0 <= index < values.count:
        raise IndexError(index)
    return values.kernel.cells[values.numbers[index]]
