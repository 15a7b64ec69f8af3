# SPDX-License-Identifier: MIT
"""A realtime cycle as the tree of its elementary instructions, for people (RC-501, RC-302).

In: the definition that was built: its checked tree and the values that were frozen into it. Out:
statements in their order, each with the nodes that are counted when it runs. Each operator,
function, variable access, assignment, condition and action counts 1, constants are free; a frozen
variable is one access, whatever its indices were. How the realtime part fuses nodes does not show.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.cycles.builder import CycleDefinition, FrozenValue
from nctakt.nc import tree
from nctakt.nc.parse.printer import format_expression, format_word, print_statement
from nctakt.nc.vocabulary.resolution import indices_of
from nctakt.trace.events import number_text


@dataclass(frozen=True, slots=True)
class Instruction:
    """A node: its text, its own count (0 for a constant), how deep it stands in its statement.

    ``is_frozen``: an asynchronous variable, whose text tells the value that stands in its place.
    """

    text: str
    count: int
    depth: int
    is_frozen: bool = False


@dataclass(frozen=True, slots=True)
class ListedStatement:
    """A statement or a branch of an ``$IF``, ``depth`` structures deep in the cycle."""

    line: int
    depth: int
    text: str
    instructions: tuple[Instruction, ...]

    @property
    def count(self) -> int:
        """Elementary instructions that are added each time it is reached."""
        return sum(one.count for one in self.instructions)


@dataclass(frozen=True, slots=True)
class ListedCycle:
    """A realtime cycle: all its statements; ``most`` is what one run-through can cost at most."""

    text: str
    span: Span
    statements: tuple[ListedStatement, ...]
    most: int
    frozen: tuple[FrozenValue, ...]

    @property
    def count(self) -> int:
        """Elementary instructions of all statements."""
        return sum(one.count for one in self.statements)


def list_cycle(definition: CycleDefinition) -> ListedCycle:
    """The listing of a built cycle."""
    lister = _Lister(definition.frozen)
    most = lister.sequence(definition.statement.body, 0)
    text = next(print_statement(dataclasses.replace(definition.statement, body=())))
    return ListedCycle(text, definition.span, tuple(lister.listed), most, definition.frozen)


class _Lister:
    """Gathers the statements of one cycle; its methods give the most that a run can cost."""

    def __init__(self, frozen: Sequence[FrozenValue]) -> None:
        self.listed: list[ListedStatement] = []
        self._frozen = {one.span: one for one in frozen}

    def sequence(self, statements: Sequence[tree.Statement], depth: int) -> int:
        """Statements one after another."""
        return sum(self._statement(statement, depth) for statement in statements)

    def _statement(self, statement: tree.Statement, depth: int) -> int:
        if isinstance(statement, tree.If):
            return self._if(statement, depth)
        text = " ".join(line.strip() for line in print_statement(_bare(statement)))
        return self._add(statement.span, depth, text, self._instructions(statement))

    def _add(self, span: Span, depth: int, text: str, instructions: Iterator[Instruction]) -> int:
        listed = ListedStatement(span.line, depth, text, tuple(instructions))
        self.listed.append(listed)
        return listed.count

    def _if(self, statement: tree.If, depth: int) -> int:
        """All conditions up to the branch whose way costs most, and its body."""
        frequency = f" {statement.frequency}" if statement.frequency else ""
        asked = self._condition(statement.span, depth, f"$IF{frequency}", statement.condition)
        most = asked + self.sequence(statement.body, depth + 1)
        for branch in statement.elseifs:
            asked += self._condition(branch.span, depth, "$ELSEIF", branch.condition)
            most = max(most, asked + self.sequence(branch.body, depth + 1))
        if statement.else_body is not None:
            assert statement.else_span is not None
            self._add(statement.else_span, depth, "$ELSE", iter(()))
            asked += self.sequence(statement.else_body, depth + 1)
        return max(most, asked)

    def _condition(self, span: Span, depth: int, word: str, condition: tree.Expression) -> int:
        text = f"{word} {format_expression(condition)}"
        return self._add(span, depth, text, self._above(word, 0, condition))

    def _instructions(self, statement: tree.Statement) -> Iterator[Instruction]:
        match statement:
            case tree.Assignment():
                yield from self._assignment(statement)
            case tree.VariableBlock():
                yield from self._expression(statement.variable, 0)
            case tree.Block():
                for word in statement.words:
                    yield from self._action(format_word(word), word)
            case _:
                words = next(print_statement(_bare(statement))).split("[", maxsplit=1)[0]
                yield from self._action(words.strip(), statement)

    def _action(self, text: str, node: tree.Node) -> Iterator[Instruction]:
        """One instruction, below it what is computed for it in the tick."""
        yield Instruction(text, 1, 0)
        for expression in _expressions(node):
            if not isinstance(expression, tree.Number | tree.Name):
                yield from self._expression(expression, 1)

    def _assignment(self, node: tree.Assignment) -> Iterator[Instruction]:
        """Store; below it the indices of the target and the value."""
        assert isinstance(node.target, tree.Variable)
        indices = indices_of(node.target)
        yield from self._above(f"store {format_expression(node.target)}", 0, *indices)
        if node.operator == "=":
            yield from self._expression(node.value, 1)
        else:
            yield from self._above(node.operator[0], 1, node.target, node.value)

    def _above(self, text: str, depth: int, *operands: tree.Expression) -> Iterator[Instruction]:
        """A node and its operands."""
        yield Instruction(text, 1, depth)
        for operand in operands:
            yield from self._expression(operand, depth + 1)

    def _expression(self, node: tree.Expression, depth: int) -> Iterator[Instruction]:
        frozen = self._frozen.get(node.span)
        match node:
            case tree.Variable() | tree.Parameter() if frozen is not None:
                text = f"{frozen.name} = {number_text(frozen.value)}"
                yield Instruction(text, 1, depth, is_frozen=True)
            case tree.Variable():
                yield from self._above(format_expression(node), depth, *indices_of(node))
            case tree.Unary():
                yield from self._above(node.operator, depth, node.operand)
            case tree.Binary():
                yield from self._above(node.operator, depth, node.left, node.right)
            case tree.Call():
                yield from self._above(node.function, depth, *node.arguments)
            case _:
                yield Instruction(format_expression(node), 0, depth)


def _bare(statement: tree.Statement) -> tree.Statement:
    """The statement without block number and label."""
    return dataclasses.replace(statement, head=tree.NO_HEAD)


def _expressions(node: tree.Node) -> Iterator[tree.Expression]:
    """The outermost expressions in a node, in their order."""
    for field in dataclasses.fields(node):
        value = getattr(node, field.name)
        for item in value if isinstance(value, tuple) else (value,):
            if isinstance(item, tree.Expression):
                yield item
            elif isinstance(item, tree.Node):
                yield from _expressions(item)
