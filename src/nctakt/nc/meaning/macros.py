# SPDX-License-Identifier: MIT
"""Macros as parts of expressions: ``X[-2 * "NAME"]`` (facts 2.1).

In: statements, and the meaning of each quoted text. Out: the statements with their macros expanded;
the same node if nothing changes. A quoted text is a macro where a number is needed: as an operand,
index, value of a word, condition, or value for P1 or a numeric variable of a list. It is a text
where a text is allowed: alone after V.P.X =, in a call, in a message, next to other texts with
``+``, ``==`` and ``!=``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import zip_longest
from typing import Any, TypeVar, cast

from nctakt.nc import tree
from nctakt.nc.fast.templates import to_tree
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables.resolution import is_text, may_be_text, resolve
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable

_Node = TypeVar("_Node", bound=Any)
_Item = TypeVar("_Item")
_Given = tree.Keyword | tree.Expression

#: Commands whose texts are names.
_OF_NAMES = ("FILENAME", "FILE", "DELETE")


class MacroExpander:
    """Replaces each macro by the result of ``meaning``, which is ``None`` for a plain text."""

    def __init__(
        self,
        names: NameTable,
        meaning: Callable[[tree.StringLiteral], tree.Expression | None],
    ) -> None:
        self._names = names
        self._meaning = meaning

    def statement(self, statement: tree.Statement) -> tree.Statement:
        """Return a statement of the program, expanded except for the bodies of structures."""
        match statement:
            case tree.Block() | tree.OffsetCommand():
                return _with(statement, words=_each(statement.words, self._word))
            case tree.SubprogramCall():
                words = _each(statement.words, self._word)
                return _with(statement, words=words, keywords=self._keywords(statement.keywords))
            case tree.Assignment():
                return self._assignment(statement)
            case tree.UserMessage():
                return _with(statement, arguments=_each(statement.arguments, self.any_value))
            case tree.UserError():
                return _with(statement, keywords=self._keywords(statement.keywords))
            case tree.Timer() | tree.CycleControl():
                return _with(statement, keywords=_each(statement.keywords, self._item))
            case tree.Time():
                return _with(statement, seconds=self.number(statement.seconds))
            case tree.VariableDeclarations():
                declared = _each(statement.declarations, self._declaration)
                return _with(statement, declarations=declared)
            case tree.HashCommand() if statement.words[0].name not in _OF_NAMES:
                return _with(statement, arguments=_each(statement.arguments, self._argument))
            case tree.RealtimeCycle():
                keywords = _each(statement.keywords, self._item)
                return _with(statement, keywords=keywords, body=_each(statement.body, self._inside))
        return self._structure(statement)

    def _structure(self, statement: tree.Statement) -> tree.Statement:
        match statement:
            case tree.If():
                elseifs = _each(statement.elseifs, self._elseif)
                condition = self.number(statement.condition)
                return _with(statement, condition=condition, elseifs=elseifs)
            case tree.While() | tree.Do() | tree.Repeat():
                return _with(statement, condition=self.number(statement.condition))
            case tree.For():
                return _with(
                    statement,
                    start=self.number(statement.start),
                    end=self.number(statement.end),
                    step=self.number(statement.step),
                )
            case tree.Switch():
                cases = _each(statement.cases, self._case)
                return _with(statement, subject=self.number(statement.subject), cases=cases)
        return statement

    def _inside(self, statement: tree.Statement) -> tree.Statement:
        """Return a statement of a realtime cycle, expanded with its bodies."""
        changed = self.statement(statement)
        if not isinstance(changed, tree.If):
            return changed
        elseifs = _each(changed.elseifs, lambda branch: _with(branch, body=self._body(branch.body)))
        last = None if changed.else_body is None else self._body(changed.else_body)
        return _with(changed, body=self._body(changed.body), elseifs=elseifs, else_body=last)

    def _body(self, statements: tuple[tree.Statement, ...]) -> tuple[tree.Statement, ...]:
        return _each(statements, self._inside)

    def _elseif(self, branch: tree.ElseIf) -> tree.ElseIf:
        return _with(branch, condition=self.number(branch.condition))

    def _case(self, case: tree.Case) -> tree.Case:
        return case if case.value is None else _with(case, value=self.number(case.value))

    def _assignment(self, statement: tree.Assignment) -> tree.Assignment:
        target = cast(tree.Variable, self.number(statement.target))
        expand = self.number if self._takes_number(statement.target) else self.any_value
        return _with(statement, target=target, value=expand(statement.value))

    def _takes_number(self, target: tree.Variable | tree.Parameter) -> bool:
        """Return whether the target accepts numbers only."""
        target = to_tree(target)
        if isinstance(target, tree.Parameter):
            return not target.call
        location = resolve(target, self._names)
        return isinstance(location, Location) and location.is_numeric

    # --- parts of statements ---------------------------------------------------------------------

    def _word(self, word: tree.BlockWord) -> tree.BlockWord:
        match word:
            case tree.AxisWord() if word.value is not None:
                return _with(word, value=self.number(word.value))
            case tree.Word():
                value = None if word.value is None else self.number(word.value)
                added = None if word.additional is None else self.number(word.additional)
                arguments = _each(word.arguments, self.any_value)
                return _with(word, value=value, additional=added, arguments=arguments)
            case tree.BracketCommand():
                return _with(word, items=_each(word.items, self._item))
        return word

    def _item(self, item: _Given) -> _Given:
        """Return an item in brackets that is a number, expanded."""
        if not isinstance(item, tree.Keyword):
            return self.number(item)
        return item if item.value is None else _with(item, value=self.number(item.value))

    def _keywords(self, items: tuple[_Given, ...]) -> tuple[_Given, ...]:
        """Return keywords whose values may be texts, expanded."""
        return _each(items, self._any_item)

    def _any_item(self, item: _Given) -> _Given:
        if not isinstance(item, tree.Keyword) or item.value is None:
            return item
        return _with(item, value=self.any_value(item.value))

    def _argument(
        self, argument: tree.Bracket | tree.Keyword | tree.Expression
    ) -> tree.Bracket | tree.Keyword | tree.Expression:
        if isinstance(argument, tree.Bracket):
            return _with(argument, items=_each(argument.items, self._item))
        return self._item(argument)

    def _declaration(self, declaration: tree.Declaration) -> tree.Declaration:
        if declaration.initial is None:
            return declaration
        return _with(declaration, initial=self.any_value(declaration.initial))

    # --- expressions -----------------------------------------------------------------------------

    def any_value(self, expression: tree.Expression) -> tree.Expression:
        """Return an expression where a text is allowed, expanded."""
        return expression if self._is_text(expression) else self.number(expression)

    def number(self, expression: tree.Expression) -> tree.Expression:
        """Return an expression where a number is needed, expanded."""
        match expression:
            case tree.StringLiteral():
                return self._meaning(expression) or expression
            case tree.Unary():
                return _with(expression, operand=self.number(expression.operand))
            case tree.Binary():
                if expression.operator in ("==", "!="):
                    if self._is_text(expression.left) and self._is_text(expression.right):
                        return expression
                return _with(
                    expression,
                    left=self.number(expression.left),
                    right=self.number(expression.right),
                )
            case tree.Call():
                return _with(expression, arguments=self._arguments(expression))
            case tree.Variable():
                return _with(expression, parts=_each(expression.parts, self._part))
            case tree.Parameter():
                return _with(expression, index=self.number(expression.index))
            case tree.ArrayLiteral():
                return _with(expression, items=_each(expression.items, self.any_value))
        return expression

    def _part(self, part: tree.Part) -> tree.Part:
        return _with(part, indices=_each(part.indices, self.number))

    def _arguments(self, call: tree.Call) -> tuple[tree.Expression, ...]:
        """Return the arguments of a call, expanded except for texts and names."""
        function = FUNCTIONS.get(call.function)
        kinds = "" if function is None else function.arguments[: len(call.arguments)]
        pairs = zip_longest(kinds, call.arguments)
        changed = tuple(
            argument if kind in ("T", "V", "A") else self.number(argument)
            for kind, argument in pairs
        )
        same = all(
            argument is other for argument, other in zip(changed, call.arguments, strict=True)
        )
        return call.arguments if same else changed

    def _is_text(self, expression: tree.Expression) -> bool:
        """Return whether the expression as written is or may be a text."""
        if isinstance(expression, tree.StringLiteral):
            return True
        if isinstance(expression, tree.Binary):
            both = (expression.left, expression.right)
            return expression.operator == "+" and all(self._is_text(part) for part in both)
        return may_be_text(expression) or is_text(expression, self._names)


def _each(items: tuple[_Item, ...], change: Callable[[_Item], _Item]) -> tuple[_Item, ...]:
    """Return the changed items; the same tuple if none changes."""
    changed = tuple(change(item) for item in items)
    same = all(item is other for item, other in zip(items, changed, strict=True))
    return items if same else changed


def _with(node: _Node, **fields: object) -> _Node:
    """Return the node with these fields; the same node if none changes."""
    if all(getattr(node, name) is value for name, value in fields.items()):
        return node
    return replace(node, **fields)


def with_span(expression: _Node, span: object) -> _Node:
    """Return an expression with all its nodes at ``span``."""
    fields: dict[str, object] = {"span": span}
    for name in type(expression).__dataclass_fields__:
        value = getattr(expression, name)
        if isinstance(value, tree.Node):
            fields[name] = with_span(value, span)
        elif isinstance(value, tuple):
            fields[name] = tuple(with_span(item, span) for item in value)
    return replace(expression, **fields)
