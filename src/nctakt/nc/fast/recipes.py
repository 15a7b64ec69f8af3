# SPDX-License-Identifier: MIT
"""Recipes that make the tree of a statement for another occurrence of its shape.

In: an ``Occurrence``: the numbers and spans in which two statements of one shape differ. Out: nodes
equal to those of the parser. ``templates.py`` writes the recipes into a ``RecipeBook``, which makes
a statement with all statements inside it. A compound numeric expression becomes a
``TemplateExpression``: it is evaluated from its template and the numbers, and its tree is made only
if something goes wrong.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nctakt.base.diagnostics import Span
from nctakt.nc.fast import raw_nodes
from nctakt.nc.fast.shapes import Shape

_FILE = Span.__dict__["file"]
_LINE = Span.__dict__["line"]
_COLUMN = Span.__dict__["column"]
_END_COLUMN = Span.__dict__["end_column"]


class Occurrence:
    """A statement of a shape: its file, the number of its first line, and its numbers.

    ``inside``: the statements of its runs.
    """

    def __init__(self, file: str, first: int, shape: Shape, inside: list[list[Any]]) -> None:
        self.file = file
        self.first = first
        self.lines = shape.lines
        self.numbers = shape.numbers
        self.ends = shape.ends
        self.inside = inside


class Recipe:
    """Makes one value of a tree: a node, a span, a tuple, or a constant."""

    def make(self, occurrence: Occurrence) -> Any:
        """Return the value in this occurrence."""
        raise AssertionError(self)


class SharedRecipe(Recipe):
    """A value that is the same in every occurrence."""

    def __init__(self, value: object) -> None:
        self.value = value

    def make(self, occurrence: Occurrence) -> Any:
        return self.value


class SpanRecipe(Recipe):
    """A span: a line of the shape, and columns relative to the ends of its marks.

    ``begin`` and ``end``: the marks from which the two columns count, -1 for the start of the line.
    """

    def __init__(self, line: int, begin: int, column: int, end: int, end_column: int) -> None:
        self.line = line
        self.begin = begin
        self.column = column
        self.end = end
        self.end_column = end_column

    def make(self, occurrence: Occurrence) -> Any:
        span = raw_nodes.new_node(Span, 0)
        column = self.column
        end_column = self.end_column
        if self.begin >= 0:
            column += occurrence.ends[self.begin]
        if self.end >= 0:
            end_column += occurrence.ends[self.end]
        raw_nodes.set_field(_FILE, span, occurrence.file)
        raw_nodes.set_field(_LINE, span, occurrence.first + occurrence.lines[self.line])
        raw_nodes.set_field(_COLUMN, span, column)
        raw_nodes.set_field(_END_COLUMN, span, end_column)
        return span


class NumberRecipe(Recipe):
    """A number of the shape, possibly with the opposite sign."""

    def __init__(self, index: int, sign: float) -> None:
        self.index = index
        self.sign = sign

    def make(self, occurrence: Occurrence) -> Any:
        return occurrence.numbers[self.index] * self.sign


class TupleRecipe(Recipe):
    """A tuple."""

    def __init__(self, parts: Sequence[Recipe]) -> None:
        self.parts = list(parts)

    def make(self, occurrence: Occurrence) -> Any:
        return tuple([part.make(occurrence) for part in self.parts])


class BodyRecipe(Recipe):
    """A tuple of statements, including the runs of the shape."""

    def __init__(self, parts: Sequence[Recipe | int]) -> None:
        self.parts = list(parts)

    def make(self, occurrence: Occurrence) -> Any:
        statements: list[Any] = []
        for part in self.parts:
            if isinstance(part, int):
                statements += occurrence.inside[part]
            else:
                statements.append(part.make(occurrence))
        return tuple(statements)


class NodeRecipe(Recipe):
    """A node: its class, and a recipe for each field."""

    def __init__(self, cls: type[Any], fields: Sequence[tuple[Any, Recipe]]) -> None:
        self.cls = cls
        self.fields = [slot for slot, _ in fields]
        self.parts = [part for _, part in fields]

    def make(self, occurrence: Occurrence) -> Any:
        node = raw_nodes.new_node(self.cls, 0)
        for i in range(len(self.parts)):
            part = self.parts[i]
            raw_nodes.set_field(self.fields[i], node, part.make(occurrence))
        return node


class ExpressionRecipe(Recipe):
    """A template expression; ``cls`` has the slots ``template`` and ``occurrence``."""

    def __init__(self, cls: type[Any], template: object) -> None:
        self.cls = cls
        self.template = template
        self.template_slot = cls.__dict__["template"]
        self.occurrence_slot = cls.__dict__["occurrence"]

    def make(self, occurrence: Occurrence) -> Any:
        node = raw_nodes.new_node(self.cls, 0)
        raw_nodes.set_field(self.template_slot, node, self.template)
        raw_nodes.set_field(self.occurrence_slot, node, occurrence)
        return node


class RecipeBook:
    """The recipes of shapes, by their keys."""

    def __init__(self) -> None:
        self.recipes: dict[bytes, Recipe] = {}

    def statement(self, shape: Shape, file: str, first: int) -> Any:
        """Return the statement of a shape; ``None`` if it or one inside it has no recipe.

        ``first``: the number of the first line read.
        """
        recipe = self.recipes.get(shape.key)
        if recipe is None:
            return None
        inside: list[list[Any]] = []
        for run in shape.runs:
            statements: list[Any] = []
            for inner in run:
                node = self.statement(inner, file, first)
                if node is None:
                    return None
                statements.append(node)
            inside.append(statements)
        return recipe.make(Occurrence(file, first, shape, inside))
