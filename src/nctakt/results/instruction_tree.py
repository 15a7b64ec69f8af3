# SPDX-License-Identifier: MIT
"""A realtime cycle as the tree of its elementary instructions, for readers (RC-501, RC-302).

In: a definition: its checked tree and its frozen values. Out: statements in their order, each with
the nodes that are counted when it runs. Each operator, function, variable access, assignment,
condition and action counts 1, constants count 0; a frozen variable is one access, regardless of its
indices. The nodes that the realtime part fuses are listed separately. As text (``nctakt
disassemble``), a definition that is reached again is listed once; its frozen values are listed each
time.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Span, Text
from nctakt.decoder.cycles.builder import CycleDefinition, FrozenValue
from nctakt.nc import tree
from nctakt.nc.parse.printer import format_expression, format_word, print_statement
from nctakt.nc.vocabulary.variables.resolution import indices_of
from nctakt.results.trace.events import value_text


@dataclass(frozen=True, slots=True)
class Instruction:
    """A node: its text, its own count (0 for a constant), its depth in its statement.

    ``is_frozen``: an asynchronous variable; its text includes its frozen value (RC-302).
    """

    text: str
    count: int
    depth: int
    is_frozen: bool = False


@dataclass(frozen=True, slots=True)
class ListedStatement:
    """A statement or a branch of an ``$IF``; ``depth`` is the number of structures around it."""

    line: int
    depth: int
    text: str
    instructions: tuple[Instruction, ...]

    @property
    def count(self) -> int:
        """The elementary instructions counted each time it is reached."""
        return sum(instruction.count for instruction in self.instructions)


@dataclass(frozen=True, slots=True)
class ListedCycle:
    """A realtime cycle: all its statements; ``max_count`` is the most that a run-through costs."""

    text: str
    span: Span
    statements: tuple[ListedStatement, ...]
    max_count: int
    frozen: tuple[FrozenValue, ...]

    @property
    def count(self) -> int:
        """The elementary instructions of all statements."""
        return sum(statement.count for statement in self.statements)


def list_cycle(definition: CycleDefinition) -> ListedCycle:
    """Return the listing of a cycle."""
    lister = _Lister(definition.frozen, definition.steps)
    maximum = lister.sequence(definition.statement.body, 0)
    text = next(print_statement(dataclasses.replace(definition.statement, body=())))
    return ListedCycle(text, definition.span, tuple(lister.listed), maximum, definition.frozen)


class _Lister:
    """Gathers the statements of a cycle; its methods return the maximum cost of a run-through."""

    def __init__(self, frozen: Sequence[FrozenValue], steps: Mapping[Span, int]) -> None:
        self.listed: list[ListedStatement] = []
        self._steps = steps
        self._frozen = {(value.span, value.name): value for value in frozen}

    def sequence(self, statements: Sequence[tree.Statement], depth: int) -> int:
        """Add statements in their order and return the sum of their maximum costs."""
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
        """Add all branches and return the cost of the most expensive one with all conditions."""
        frequency = f" {statement.frequency}" if statement.frequency else ""
        asked = self._condition(statement.span, depth, f"$IF{frequency}", statement.condition)
        maximum = asked + self.sequence(statement.body, depth + 1)
        for branch in statement.elseifs:
            asked += self._condition(branch.span, depth, "$ELSEIF", branch.condition)
            maximum = max(maximum, asked + self.sequence(branch.body, depth + 1))
        if statement.else_body is not None:
            assert statement.else_span is not None
            self._add(statement.else_span, depth, "$ELSE", iter(()))
            asked += self.sequence(statement.else_body, depth + 1)
        return max(maximum, asked)

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
        """Yield an instruction, below it the expressions evaluated for it in the tick."""
        yield Instruction(text, 1, 0)
        for expression in _expressions(node):
            if not isinstance(expression, tree.Number | tree.Name):
                yield from self._expression(expression, 1)

    def _assignment(self, node: tree.Assignment) -> Iterator[Instruction]:
        """Yield the assignment, below it the indices of the target and the value."""
        assert isinstance(node.target, tree.Variable)
        indices = indices_of(node.target)
        yield Instruction(
            f"store {format_expression(node.target)}", self._steps.get(node.target.span, 1), 0
        )
        for index in indices:
            yield from self._expression(index, 1)
        if node.operator == "=":
            yield from self._expression(node.value, 1)
        else:
            yield from self._above(node.operator[0], 1, node.target, node.value)

    def _above(self, text: str, depth: int, *operands: tree.Expression) -> Iterator[Instruction]:
        """Yield a node and its operands."""
        yield Instruction(text, 1, depth)
        for operand in operands:
            yield from self._expression(operand, depth + 1)

    def _expression(self, node: tree.Expression, depth: int) -> Iterator[Instruction]:
        frozen = None
        if isinstance(node, tree.Variable | tree.Parameter):
            frozen = self._frozen.get((node.span, format_expression(node)))
        match node:
            case tree.Variable() | tree.Parameter() if frozen is not None:
                text = f"{frozen.name} = {value_text(frozen.value)}"
                yield Instruction(text, 1, depth, is_frozen=True)
            case tree.Variable():
                yield Instruction(format_expression(node), self._steps.get(node.span, 1), depth)
                for index in indices_of(node):
                    yield from self._expression(index, depth + 1)
            case tree.Unary():
                yield from self._above(node.operator, depth, node.operand)
            case tree.Binary():
                yield from self._above(node.operator, depth, node.left, node.right)
            case tree.Call():
                yield from self._above(node.function, depth, *node.arguments)
            case _:
                yield Instruction(format_expression(node), 0, depth)


def _bare(statement: tree.Statement) -> tree.Statement:
    """Return the statement without block number and label."""
    return dataclasses.replace(statement, head=tree.NO_HEAD)


def _expressions(node: tree.Node) -> Iterator[tree.Expression]:
    """Yield the outermost expressions in a node, in their order."""
    for field in dataclasses.fields(node):
        value = getattr(node, field.name)
        for item in value if isinstance(value, tuple) else (value,):
            if isinstance(item, tree.Expression):
                yield item
            elif isinstance(item, tree.Node):
                yield from _expressions(item)


# --- as text --------------------------------------------------------------------------------------


_HEAD = Text("Realtime cycle {name}, {position}", "Echtzeit-Zyklus {name}, {position}")
_SIZE = Text(
    "elementary instructions: {count}, in one run-through at most {maximum}; memory: {bytes} bytes",
    "Elementar-Anweisungen: {count}, in einem Durchlauf höchstens {maximum}; Speicher: {bytes} "
    "Byte",
)
_FROZEN = Text("frozen when it was decoded: {values}", "beim Dekodieren eingefroren: {values}")
_FROZEN_VALUE = Text("{name} = {value} (line {line})", "{name} = {value} (Zeile {line})")
_AGAIN = Text("the instructions of cycle {first}", "die Anweisungen von Zyklus {first}")
_FREEZES = Text("frozen", "eingefroren")
_COLUMNS = (Text("line", "Zeile"), Text("count", "Anzahl"))
_STEP = "  "


class Listing:
    """Lists one definition after another, in the order in which the decoder reached them."""

    def __init__(self, language: Language) -> None:
        self._language = language
        self._listed: dict[Span, str] = {}

    def lines(self, name: str, definition: CycleDefinition, memory_bytes: int) -> Iterator[str]:
        """Yield the lines of a cycle; ``memory_bytes`` is its share of P-CHAN-00407."""
        cycle = list_cycle(definition)
        position = f"{cycle.span.file}:{cycle.span.line}"
        yield self._text(_HEAD, name=name, position=position)
        counts = {"count": cycle.count, "maximum": cycle.max_count, "bytes": memory_bytes}
        yield _STEP + self._text(_SIZE, **counts)
        if cycle.frozen:
            yield _STEP + self._text(_FROZEN, values=self._frozen(cycle))
        first = self._listed.setdefault(cycle.span, name)
        if first != name:
            yield _STEP + self._text(_AGAIN, first=first)
            return
        yield ""
        yield from self._table(cycle)

    def _text(self, text: Text, **values: object) -> str:
        return text.get(self._language).format_map(values)

    def _frozen(self, cycle: ListedCycle) -> str:
        return ", ".join(
            self._text(
                _FROZEN_VALUE, name=value.name, value=value_text(value.value), line=value.span.line
            )
            for value in cycle.frozen
        )

    def _table(self, cycle: ListedCycle) -> Iterator[str]:
        """Yield the rows: line, count of the statement, count of the node, text."""
        line_head, count_head = (head.get(self._language) for head in _COLUMNS)
        widths = (max(6, len(line_head)), max(6, len(count_head)))
        yield f"{line_head:>{widths[0]}}  {count_head:>{widths[1]}}"
        yield f"{cycle.span.line:>{widths[0]}}  {'':>{widths[1]}}  {cycle.text}"
        for statement in cycle.statements:
            indent = _STEP * (statement.depth + 1)
            yield (
                f"{statement.line:>{widths[0]}}  {statement.count:>{widths[1]}}  "
                f"{indent}{statement.text}"
            )
            for line in self._nodes(statement):
                yield f"{'':>{widths[0]}}  {'':>{widths[1]}}  {indent}{_STEP}{line}"

    def _nodes(self, statement: ListedStatement) -> Iterator[str]:
        """Yield the nodes of a statement; none for a statement of a single node."""
        if len(statement.instructions) < 2 and not any(
            instruction.is_frozen for instruction in statement.instructions
        ):
            return
        for instruction in statement.instructions:
            mark = f", {_FREEZES.get(self._language)}" if instruction.is_frozen else ""
            yield f"{instruction.count}  {_STEP * instruction.depth}{instruction.text}{mark}"
