# SPDX-License-Identifier: MIT
"""Access to program variables, and functions of texts, at decode time.

In: nodes, and indices evaluated by the caller. Out: values. Faults raise ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import NoReturn

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.call_stack import CallStack
from nctakt.decoder.state.program_variables import LONGEST_STRING, ProgramVariable, VariableError
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.tools import Fail
from nctakt.decoder.values.texts import compute
from nctakt.messages.programs.checked_values import INVALID_ELEMENT_COUNT
from nctakt.messages.programs.decoder import OPERATION_WITHOUT_RESULT, VALUE_LIST_FOR_ONE_ELEMENT
from nctakt.nc import tree
from nctakt.nc.meaning.words import DECLARED_TYPES
from nctakt.nc.vocabulary.variables.resolution import bare_name, indices_of, name_of, path_text

Evaluate = Callable[[tree.Expression, int], Generator[Command, Answer, float]]
EvaluateAny = Callable[[tree.Expression, int], Generator[Command, Answer, float | str]]


class ProgramValues:
    """The variables of one program; ``index`` evaluates an index, ``fail`` raises
    ``DecodeError``.
    """

    def __init__(
        self,
        call_stack: CallStack,
        index: Callable[[tree.Expression], float],
        fail: Fail,
    ) -> None:
        self._scopes = call_stack.scopes
        self._index = index
        self._fail = fail

    def _indices(self, variable: tree.Variable) -> list[int]:
        return [int(self._index(index)) for index in indices_of(variable)]

    def read(self, variable: tree.Variable) -> float | str:
        """Return the current value."""
        try:
            stored = self._scopes.get(variable.family, bare_name(variable))
            return stored.values[stored.element(self._indices(variable))]
        except VariableError as error:
            self._wrong(error, variable.span)

    def is_text(self, variable: tree.Variable) -> bool:
        """Return whether the variable holds texts."""
        try:
            return self._scopes.get(variable.family, bare_name(variable)).type == "STRING"
        except VariableError as error:
            self._wrong(error, variable.span)

    def write(self, variable: tree.Variable, value: float | str) -> None:
        """Assign to the variable; the first value creates V.P and V.S."""
        indices = self._indices(variable)
        path = bare_name(variable)
        try:
            stored = self._scopes.for_writing(variable.family, path, value, indices)
            stored.put(stored.element(indices), value)
        except VariableError as error:
            self._wrong(error, variable.span)

    def fill(self, variable: tree.Variable, values: Sequence[float | str]) -> None:
        """Assign to the elements of a whole array."""
        try:
            if any(True for _ in indices_of(variable)):
                raise VariableError(VALUE_LIST_FOR_ONE_ELEMENT)
            self._scopes.get(variable.family, bare_name(variable)).fill(values)
        except VariableError as error:
            self._wrong(error, variable.span)

    def exists(self, variable: tree.Variable) -> bool:
        """Return whether the variable, and the element if one is named, exists."""
        stored = self._scopes.find(variable.family, bare_name(variable))
        indices = self._indices(variable)
        if stored is None or not indices:
            return stored is not None
        try:
            stored.element(indices)
        except VariableError:
            return False
        return True

    def size(self, variable: tree.Variable, dimension: int) -> int:
        """Return the number of elements in a dimension, counted from 1; 0 without that
        dimension.
        """
        try:
            dimensions = self._scopes.get(variable.family, bare_name(variable)).dimensions
        except VariableError as error:
            self._wrong(error, variable.span)
        return dimensions[dimension - 1] if 1 <= dimension <= len(dimensions) else 0

    def function(self, call: tree.Call, values: Sequence[float | str]) -> float | str:
        """Return the result of a function of texts."""
        result = compute(call.function, values)
        if result is None:
            self._fail(OPERATION_WITHOUT_RESULT, call.span, operation=call.function)
        return result

    # --- declarations ---------------------------------------------------------------------------

    def declare(
        self, declaration: tree.Declaration, number: int, evaluate: Evaluate, any_: EvaluateAny
    ) -> Generator[Command, Answer]:
        """Declare the variable of a line of ``#VAR``."""
        variable = declaration.variable
        dimensions: list[int] = []
        for index in indices_of(variable):
            count = yield from evaluate(index, number)
            if not 1 <= count == int(count):
                self._fail(
                    INVALID_ELEMENT_COUNT,
                    index.span,
                    name=path_text(variable),
                    count=count,
                )
            dimensions.append(int(count))
        values: list[float | str] = []
        if declaration.initial is not None:
            values = yield from self.items(declaration.initial, number, any_)
        if isinstance(declaration.initial, tree.ArrayLiteral) and not dimensions:
            dimensions = [len(values)]
        characters = float(LONGEST_STRING)
        if declaration.size is not None:
            characters = yield from evaluate(declaration.size, number)
        path = bare_name(variable)
        name = name_of(variable.family, path)
        try:
            declared = ProgramVariable(
                name, _type(declaration, values), int(characters), tuple(dimensions)
            )
            declared.fill(values)
            self._scopes.declare(variable.family, path, declared)
        except VariableError as error:
            self._wrong(error, declaration.span)

    def items(
        self, value: tree.Expression, number: int, any_: EvaluateAny
    ) -> Generator[Command, Answer, list[float | str]]:
        """Return the values of a list, nested lists flattened."""
        if not isinstance(value, tree.ArrayLiteral):
            return [(yield from any_(value, number))]
        values: list[float | str] = []
        for item in value.items:
            values += yield from self.items(item, number, any_)
        return values

    def delete(self, variable: tree.Variable) -> None:
        """Delete a variable, or a whole family."""
        self._scopes.delete(variable.family, bare_name(variable))

    def _wrong(self, error: VariableError, span: Span) -> NoReturn:
        self._fail(error.message, span, **error.values)


def _type(declaration: tree.Declaration, values: Sequence[float | str]) -> str:
    """Return the declared type; without one that of the first value, REAL64 without a value."""
    if declaration.type_name is not None:
        return DECLARED_TYPES[declaration.type_name]
    return "STRING" if values and isinstance(values[0], str) else "REAL64"
