# SPDX-License-Identifier: MIT
"""Statements of known shapes, made from templates without lexer and parser.

In: the next lines of a long program. Out: the statement as the parser would return it, except that
compound numeric expressions are ``TemplateExpression``; ``None`` for a new shape. A template is
made by parsing the text of the shape with distinct numbers, each of which must become exactly one
node of the tree; so only the parser knows the meaning of a number. Memory is bounded by
``MAX_SHAPE_CHARACTERS``.
"""

from __future__ import annotations

import dataclasses
from bisect import bisect_right
from typing import Any, TypeVar, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.messages import Collector
from nctakt.nc.fast import recipes
from nctakt.nc.fast.recipes import Occurrence, Recipe, RecipeBook
from nctakt.nc.fast.shape_checks import VALUE_WORDS, is_decided_by_shape
from nctakt.nc.fast.shapes import COMMENT, NUMBER, RUN, Shape, ShapeScanner
from nctakt.nc.parse.parser import StatementReader
from nctakt.nc.source import LineReader, Source
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Binary,
    Call,
    Case,
    Constant,
    Do,
    ElseIf,
    Expression,
    For,
    If,
    Number,
    Parameter,
    Repeat,
    Statement,
    Switch,
    Unary,
    Variable,
    While,
    Word,
)
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables.resolution import PROGRAM_FAMILIES

_Node = TypeVar("_Node", bound=Expression)

#: Maximum characters of all remembered shapes; then all are forgotten. Templates take about
#: a hundred times as many bytes.
MAX_SHAPE_CHARACTERS = 60_000

#: The first of the consecutive numbers in the text of a shape.
_FIRST_VALUE = 1001

#: The line that represents a run in the text of a shape.
_RUN_TEXT = "G1"

#: The slots of a number.
_SLOTS = tuple(getattr(Number, field.name) for field in dataclasses.fields(Number))

#: Fields that the decoder evaluates, by node; they may hold a template expression.
_EVALUATED_FIELDS: dict[type[Any], tuple[str, ...]] = {
    AxisWord: ("value",),
    Word: ("value",),
    Assignment: ("target", "value"),
    If: ("condition",),
    ElseIf: ("condition",),
    For: ("variable", "start", "end", "step"),
    While: ("condition",),
    Do: ("condition",),
    Repeat: ("condition",),
    Switch: ("subject",),
    Case: ("value",),
}


@dataclass(frozen=True, slots=True, eq=False)
class ExpressionTemplate:
    """A compound expression of a shape, the same object for all occurrences.

    ``tree``: the expression with the numbers of the shape's text; ``numbers``: their recipes by
    span. ``recipe`` makes the expression of an occurrence, ``span`` its span.
    """

    tree: Expression
    numbers: dict[Span, recipes.NumberRecipe]
    recipe: Recipe
    span: Recipe


class TemplateExpression(Expression):
    """A compound expression of numbers, program variables and parameters, bound to its template."""

    __slots__ = ("occurrence", "template")

    template: ExpressionTemplate
    occurrence: Occurrence

    @property
    def span(self) -> Span:
        """The span of this occurrence."""
        span: Span = self.template.span.make(self.occurrence)
        return span

    @property
    def tree(self) -> Expression:
        """The expression as the parser would return it."""
        tree: Expression = self.template.recipe.make(self.occurrence)
        return tree


def to_tree(node: _Node) -> _Node:
    """Return the node as the parser would return it."""
    return cast(_Node, node.tree) if isinstance(node, TemplateExpression) else node


@dataclass(frozen=True, slots=True)
class StatementTemplate:
    """The recipe of the statements of one shape.

    ``is_decided_by_shape``: one valid statement proves all of them valid, without effect on other
    checks.
    """

    recipe: Recipe
    is_decided_by_shape: bool


class Templates:
    """The templates of one text, and the shapes that need no further check."""

    def __init__(self) -> None:
        self.scanner = ShapeScanner()
        self._valid_keys: set[bytes] = set()
        self._known: dict[bytes, StatementTemplate | None] = {}
        self._book = RecipeBook()
        self._seen: set[bytes] = set()
        self._characters = 0

    def next(self, lines: LineReader | None, file: str) -> Statement | None:
        """Return the next statement if its shape is known, and consume its lines and empty
        lines.
        """
        if lines is None:
            return None
        scanner = self.scanner
        while lines.more():
            count = scanner.read(lines.group, lines.index)
            if count == 0:
                return None
            shape = scanner.shape
            if shape is not None:
                statement: Statement | None = self._book.statement(
                    shape, file, lines.number - lines.index
                )
                if statement is None:
                    self._learn(shape)
                    return None
                lines.index += count
                return statement
            lines.index += count
        return None

    def _learn(self, shape: Shape) -> None:
        """Note the shape of a statement that was not made from a template."""
        self.of(shape.key)
        self._learn_runs(shape)

    def _learn_runs(self, shape: Shape) -> None:
        for run in shape.runs:
            for inner in run:
                self._learn(inner)

    def skip_known(self, lines: list[str], index: int) -> int:
        """Return the index of the first line to be checked; ``scanner.shape`` is its shape."""
        return self.scanner.skip_known(lines, index, self._valid_keys)

    def mark_valid(self, shape: Shape) -> None:
        """Note that a statement of this shape was checked without findings.

        If that depends on more than the shape, statements inside may not have been checked.
        """
        template = self.of(shape.key)
        if template is None:
            self._learn_runs(shape)
        if template is None or not template.is_decided_by_shape:
            return
        self._valid_keys.add(shape.key)
        for run in shape.runs:
            for inner in run:
                self.mark_valid(inner)

    def of(self, key: bytes) -> StatementTemplate | None:
        """Return the template of a shape; ``None`` for a new shape or one without a template."""
        if key in self._known:
            return self._known[key]
        if key in self._seen:
            template = self._known[key] = make_template(key)
            if template is not None:
                self._book.recipes[key] = template.recipe
            return template
        self._characters += len(key)
        if self._characters > MAX_SHAPE_CHARACTERS:
            self._characters = len(key)
            self._known.clear()
            self._book.recipes.clear()
            self._seen.clear()
            self._valid_keys.clear()
        self._seen.add(key)
        return None


def make_template(key: bytes) -> StatementTemplate | None:
    """Return the template of a shape; ``None`` if one of its numbers is not simply a number."""
    lines, placeholders, runs = _text_of(key)
    collector = Collector()
    statements = [statement for _, statement in StatementReader(Source("", lines), collector)]
    if collector.diagnostics or len(statements) != 1:
        return None
    writer = _RecipeWriter(placeholders, runs)
    recipe = writer.recipe(statements[0])
    numbers = sum(placeholder.number > 0.0 for placeholder in placeholders)
    if len(writer.numbers) != numbers or len(writer.taken) != numbers:
        return None
    if sorted(writer.runs) != list(range(len(runs))):
        return None
    return StatementTemplate(recipe, is_decided_by_shape(statements[0], writer.numbers, numbers))


@dataclass(frozen=True, slots=True)
class _Placeholder:
    """A placeholder in a shape's text: line and columns from 0; ``number`` is 0 for a comment."""

    line: int
    start: int
    end: int
    number: float


def _text_of(key: bytes) -> tuple[list[str], list[_Placeholder], list[int]]:
    """Return NC text of this shape, its placeholders, and the lines that represent runs."""
    lines: list[str] = []
    placeholders: list[_Placeholder] = []
    runs: list[int] = []
    for number, shape in enumerate(key.split(b"\n")):
        text = ""
        for code in shape:
            start = len(text)
            if code == RUN:
                runs.append(number)
                text = _RUN_TEXT
            elif code == NUMBER:
                value = _FIRST_VALUE + len(placeholders)
                text += str(value)
                placeholders.append(_Placeholder(number, start, len(text), float(value)))
            elif code == COMMENT:
                text += "()"
                placeholders.append(_Placeholder(number, start, len(text), 0.0))
            else:
                text += chr(code)
        lines.append(text)
    return lines, placeholders, runs


class _RecipeWriter:
    """Writes the recipe of a tree; ``numbers``: its nodes that are numbers of the shape.

    ``taken``: indices of the placeholders used; ``runs``: the runs found.
    """

    def __init__(self, placeholders: list[_Placeholder], runs: list[int]) -> None:
        self._placeholders = placeholders
        self._runs = runs
        self._order = [(placeholder.line, placeholder.end) for placeholder in placeholders]
        self.numbers: dict[Span, recipes.NumberRecipe] = {}
        self.taken: set[int] = set()
        self.runs: list[int] = []

    def recipe(self, value: Any) -> Recipe:
        """Return the recipe of a node, span or tuple; any other value is shared."""
        if isinstance(value, Span):
            return self._span(value)
        if isinstance(value, tuple):
            return self._tuple(value)
        if isinstance(value, Number):
            return self._number(value)
        if dataclasses.is_dataclass(value):
            return self._node(value)
        return recipes.SharedRecipe(value)

    def _tuple(self, values: tuple[Any, ...]) -> Recipe:
        """Return the recipe of a tuple; shared if all its parts are."""
        parts: list[Recipe] = []
        body: list[Recipe | int] = []
        for value in values:
            line = value.span.line - 1 if isinstance(value, Statement) else -1
            if line in self._runs:
                self.runs.append(self._runs.index(line))
                body.append(self.runs[-1])
            else:
                parts.append(self.recipe(value))
                body.append(parts[-1])
        if len(parts) < len(body):
            return recipes.BodyRecipe(body)
        if all(isinstance(part, recipes.SharedRecipe) for part in parts):
            return recipes.SharedRecipe(values)
        return recipes.TupleRecipe(parts)

    def _node(self, node: Any) -> Recipe:
        cls = type(node)
        fields = []
        for field in dataclasses.fields(cls):
            part = self.recipe(getattr(node, field.name))
            if field.name in _EVALUATED_FIELDS.get(cls, ()):
                part = self._template_expression(node, field.name, part)
            fields.append((getattr(cls, field.name), part))
        if all(isinstance(part, recipes.SharedRecipe) for _, part in fields):
            return recipes.SharedRecipe(node)
        return recipes.NodeRecipe(cls, fields)

    def _template_expression(self, node: Any, name: str, recipe: Recipe) -> Recipe:
        """Return the recipe of a value that the decoder evaluates, as a template expression if
        possible.
        """
        tree = getattr(node, name)
        if (
            isinstance(tree, Number)
            or not isinstance(tree, Expression)
            or not _is_template_value(tree)
        ):
            return recipe
        if isinstance(node, Word) and node.name not in VALUE_WORDS:
            return recipe
        return recipes.ExpressionRecipe(
            TemplateExpression,
            ExpressionTemplate(tree, self.numbers, recipe, self._span(tree.span)),
        )

    def _number(self, node: Number) -> Recipe:
        span = self._span(node.span)
        slot, value_slot = _SLOTS
        for index, placeholder in enumerate(self._placeholders):
            if (
                placeholder.number
                and abs(node.value) == placeholder.number
                and _covers(node.span, placeholder)
            ):
                value = recipes.NumberRecipe(index, node.value / placeholder.number)
                self.numbers[node.span] = value
                self.taken.add(index)
                return recipes.NodeRecipe(Number, [(slot, span), (value_slot, value)])
        return recipes.NodeRecipe(
            Number, [(slot, span), (value_slot, recipes.SharedRecipe(node.value))]
        )

    def _span(self, span: Span) -> Recipe:
        line = span.line - 1
        begin, column = self._anchor(line, span.column - 1)
        end, end_column = self._anchor(line, span.end_column - 1)
        return recipes.SpanRecipe(line, begin, column + 1, end, end_column + 1)

    def _anchor(self, line: int, column: int) -> tuple[int, int]:
        """Return the last placeholder before a column and the distance from its end."""
        index = bisect_right(self._order, (line, column)) - 1
        if index < 0 or self._placeholders[index].line != line:
            return -1, column
        return index, column - self._placeholders[index].end


def _covers(span: Span, placeholder: _Placeholder) -> bool:
    is_inside = span.column - 1 <= placeholder.start and placeholder.end <= span.end_column - 1
    return span.line - 1 == placeholder.line and is_inside


def _is_template_value(expression: Expression) -> bool:
    """Return whether the value depends on numbers, program variables and parameters only.

    Elements of arrays are left to the tree.
    """
    match expression:
        case Number() | Constant():
            return True
        case Variable():
            is_single = not any(part.indices for part in expression.parts)
            return expression.family in PROGRAM_FAMILIES and is_single and bool(expression.parts)
        case Parameter():
            return not expression.call and isinstance(expression.index, Number)
        case Unary():
            return _is_template_value(expression.operand)
        case Binary():
            return _is_template_value(expression.left) and _is_template_value(expression.right)
        case Call():
            function = FUNCTIONS.get(expression.function)
            is_of_numbers = function is not None and not function.decoder_only
            return is_of_numbers and all(
                _is_template_value(argument) for argument in expression.arguments
            )
    return False
