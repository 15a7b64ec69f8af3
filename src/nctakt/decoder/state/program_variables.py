# SPDX-License-Identifier: MIT
"""The variables that programs create: V.P, V.S, V.L, V.CYC, arrays of P parameters.

In: declarations, names and indices. Out: values. V.P lives as long as its main program, V.S until
the next start-up, V.L as long as its program and all that it calls, V.CYC as long as its cycle.
Raises ``VariableError`` for a missing variable or element, and for too many elements.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message
from nctakt.base.misspelling import nearest
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages.machines.memory import (
    NUMBER_INSTEAD_OF_TEXT,
    TEXT_INSTEAD_OF_NUMBER,
    TEXT_TOO_LONG,
)
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE, WRONG_INDEX_COUNT
from nctakt.messages.programs.decoder import (
    PARAMETER_ARRAY_MISSING,
    TOO_MANY_ELEMENTS,
    VALUE_COUNT_MISMATCH,
    VALUE_OUTSIDE_TYPE_RANGE,
    VARIABLE_NOT_PRESENT,
)
from nctakt.nc import tree
from nctakt.nc.vocabulary.variables.resolution import name_of

#: Maximum and default length of a STRING.
LONGEST_STRING = 126

#: Maximum number of elements of a variable (a choice: a typing error must not fill the memory).
MAX_ELEMENTS = 100_000

#: Families that a first assignment creates.
_MADE_BY_WRITING = ("P", "S")


class VariableError(Exception):
    """A message and its values."""

    def __init__(self, message: Message, **values: object) -> None:
        super().__init__(message)
        self.message = message
        self.values = values


@dataclass(slots=True)
class ProgramVariable:
    """One variable; its elements in ascending order, the last index varying fastest.

    ``characters``: the maximum length of a STRING. ``dimensions`` is empty for a single value.
    """

    name: str
    type: str
    characters: int
    dimensions: tuple[int, ...]
    values: list[float | str] = field(default_factory=list)

    def __post_init__(self) -> None:
        count = prod(self.dimensions)
        if count > MAX_ELEMENTS:
            raise VariableError(
                TOO_MANY_ELEMENTS, name=self.name, count=count, maximum=MAX_ELEMENTS
            )
        self.values = ["" if self.type == "STRING" else 0.0] * count

    def element(self, indices: Sequence[int]) -> int:
        """Return the position of an element; raises ``VariableError``."""
        if len(indices) != len(self.dimensions):
            expected = len(self.dimensions)
            raise VariableError(
                WRONG_INDEX_COUNT, name=self.name, expected=expected, given=len(indices)
            )
        position = 0
        for index, count in zip(indices, self.dimensions, strict=True):
            if not 0 <= index < count:
                raise VariableError(
                    INDEX_OUT_OF_RANGE, variable=self.name, index=index, count=count
                )
            position = position * count + index
        return position

    def put(self, position: int, value: float | str) -> None:
        """Set an element, converted to its type: integers rounded, BOOLEAN 0 or 1."""
        self.values[position] = self._converted(value)

    def _converted(self, value: float | str) -> float | str:
        if isinstance(value, str):
            if self.type != "STRING":
                raise VariableError(TEXT_INSTEAD_OF_NUMBER, name=self.name)
            if len(value) > self.characters:
                count = len(value)
                raise VariableError(
                    TEXT_TOO_LONG, name=self.name, limit=self.characters, count=count
                )
            return value
        if self.type == "STRING":
            raise VariableError(NUMBER_INSTEAD_OF_TEXT, value=value)
        if self.type == "BOOLEAN":
            return 1.0 if arithmetic.is_true(value) else 0.0
        scalar = SCALARS[self.type]
        if not scalar.is_integer:
            return value
        value = arithmetic.round_half_even(value)
        if not scalar.low <= value <= scalar.high:
            low, high = scalar.low, scalar.high
            raise VariableError(
                VALUE_OUTSIDE_TYPE_RANGE, name=self.name, value=value, low=low, high=high
            )
        return value

    def fill(self, values: Sequence[float | str]) -> None:
        """Set the first elements to these values; the others keep theirs."""
        if len(values) > len(self.values):
            count = len(self.values)
            raise VariableError(
                VALUE_COUNT_MISMATCH, name=self.name, given=len(values), count=count
            )
        for position, value in enumerate(values):
            self.put(position, value)


Variables = dict[str, ProgramVariable]


class Scopes:
    """The scopes of all families, the innermost first.

    ``kept``: V.S; those of V.L and V.CYC come and go with the frames. ``changes``: counts the
    changes after which a name may denote another variable.
    """

    def __init__(self, kept: Variables) -> None:
        self._program: Variables = {}
        self._arrays: Variables = {}
        self._kept = kept
        self._locals: list[Variables] = []
        self._cycles: list[Variables] = []
        self.changes = 0

    def enter(self, *, is_cycle: bool) -> None:
        """Open the scopes of a program; ``is_cycle``: with V.CYC, too."""
        self._locals.append({})
        if is_cycle:
            self.changes += 1
            self._cycles.append({})

    def leave(self, *, is_cycle: bool) -> None:
        """Close the scopes of the innermost program."""
        if self._locals.pop() or is_cycle:
            self.changes += 1
        if is_cycle:
            self._cycles.pop()

    def scopes_of(self, family: str) -> Sequence[Variables]:
        """Return the scopes of a family in which a name is looked for, the innermost first."""
        match family:
            case "P":
                return (self._program,)
            case "S":
                return (self._kept,)
            case "L":
                return self._locals[::-1]
            case tree.PARAMETER_ARRAYS:
                return (self._arrays,)
        return self._cycles[-1:]

    def find(self, family: str, path: str) -> ProgramVariable | None:
        """Return a variable by its path without indices, ``None`` if there is none."""
        for scope in self.scopes_of(family):
            if path in scope:
                return scope[path]
        return None

    def get(self, family: str, path: str) -> ProgramVariable:
        """Return a variable as ``find``; raises ``VariableError`` 20932 if there is none."""
        variable = self.find(family, path)
        if variable is None and family == tree.PARAMETER_ARRAYS:
            raise VariableError(PARAMETER_ARRAY_MISSING, name=name_of(family, path))
        if variable is None:
            names = [name for scope in self.scopes_of(family) for name in scope]
            near = nearest(path, names)
            shown = name_of(family, near) if near else "–"
            name = name_of(family, path)
            raise VariableError(VARIABLE_NOT_PRESENT, name=name, nearest=shown)
        return variable

    def for_writing(
        self, family: str, path: str, value: float | str, indices: Sequence[int]
    ) -> ProgramVariable:
        """Return a variable as ``get``; the first value creates V.P and V.S."""
        if family in _MADE_BY_WRITING and not indices and self.find(family, path) is None:
            type_ = "STRING" if isinstance(value, str) else "REAL64"
            name = name_of(family, path)
            self.declare(family, path, ProgramVariable(name, type_, LONGEST_STRING, ()))
        return self.get(family, path)

    def check_single(self, parameter: int) -> None:
        """Raise ``VariableError`` if a P parameter is an array, which needs indices."""
        if self._arrays and str(parameter) in self._arrays:
            array = self._arrays[str(parameter)]
            count = len(array.dimensions)
            raise VariableError(WRONG_INDEX_COUNT, name=array.name, expected=count, given=0)

    def is_array(self, parameter: int) -> bool:
        """Return whether a P parameter is an array."""
        return bool(self._arrays) and str(parameter) in self._arrays

    def declare(self, family: str, path: str, variable: ProgramVariable) -> None:
        """Declare a variable in the innermost scope, replacing one of the same name."""
        self.changes += 1
        self.scopes_of(family)[0][path] = variable

    def delete(self, family: str, path: str) -> None:
        """Delete a variable, or the whole family for an empty path; unknown ones are ignored."""
        self.changes += 1
        for scope in self.scopes_of(family):
            if not path:
                scope.clear()
            elif scope.pop(path, None) is not None:
                return
