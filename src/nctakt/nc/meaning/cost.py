# SPDX-License-Identifier: MIT
"""The maximum cost of a realtime cycle in one tick, known before it runs (RC-501).

In: nodes of a cycle's body. Out: elementary instructions: one for each operator, function, access
to a variable, assignment, condition and action; constants are free. A string counts as an
access for each eight bytes, a structure as its members one by one. The realtime part adds up the
same counts; at most one branch of an ``$IF`` is taken.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.nc.tree import (
    Assignment,
    Binary,
    Block,
    BlockWord,
    BracketCommand,
    Call,
    Expression,
    If,
    Keyword,
    Parameter,
    Statement,
    Timer,
    Unary,
    UserError,
    Variable,
    VariableBlock,
)
from nctakt.nc.vocabulary.spindle_commands import SpindleCommand, split
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES, cells_of
from nctakt.nc.vocabulary.variables.resolution import indices_of, resolve, resolve_aggregate
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location, NameTable


def max_steps(statements: Sequence[Statement], names: NameTable) -> int:
    """Return the maximum cost of one run through these statements."""
    return sum(_statement(statement, names) for statement in statements)


def _statement(statement: Statement, names: NameTable) -> int:
    match statement:
        case Assignment():
            return _assignment(statement, names)
        case If():
            return _if(statement, names)
        case Block():
            return _block(statement, names)
        case VariableBlock():
            return expression_steps(statement.variable, names)
        case Timer() | UserError():
            return 1 + sum(
                expression_steps(keyword.value, names)
                for keyword in statement.keywords
                if isinstance(keyword, Keyword) and keyword.value is not None
            )
    return 1


def _block(block: Block, names: NameTable) -> int:
    """Return the cost of a block: one per M or H function, one plus its values per spindle
    command.
    """
    commands, others = split(block.words, names.spindle_names)
    steps = sum(word_steps(word, names) for word in others)
    return steps + sum(command_steps(command, names) for command in commands)


def command_steps(command: SpindleCommand, names: NameTable) -> int:
    """Return the cost of a command to a spindle."""
    values = (command.speed, command.position)
    return 1 + sum(expression_steps(value, names) for value in values if value is not None)


def word_steps(word: BlockWord, names: NameTable) -> int:
    """Return the cost of an action: its values and one for itself."""
    if not isinstance(word, BracketCommand):
        return 1
    return 1 + sum(
        expression_steps(item.value, names)
        for item in word.items
        if isinstance(item, Keyword) and item.value is not None
    )


def _assignment(statement: Assignment, names: NameTable) -> int:
    access = _access_steps(statement.target, names)
    value = _access_steps(statement.value, names)
    # A compound assignment also reads its target and computes.
    return access + value if statement.operator == "=" else 2 * access + value + 1


def _if(statement: If, names: NameTable) -> int:
    """Return the cost of the most expensive branch with all conditions before it."""
    asked = condition_steps(statement.condition, names)
    costs = [asked + max_steps(statement.body, names)]
    for branch in statement.elseifs:
        asked += condition_steps(branch.condition, names)
        costs.append(asked + max_steps(branch.body, names))
    costs.append(asked + max_steps(statement.else_body or (), names))
    return max(costs)


def condition_steps(condition: Expression, names: NameTable) -> int:
    """Return the cost of the condition of an ``$IF``, including its own instruction."""
    return expression_steps(condition, names) + 1


def expression_steps(expression: Expression, names: NameTable) -> int:
    """Return the cost of an expression; an asynchronous variable counts one, whatever its
    indices.
    """
    match expression:
        case Unary():
            return 1 + expression_steps(expression.operand, names)
        case Binary():
            sides = (expression.left, expression.right)
            return 1 + sum(expression_steps(side, names) for side in sides)
        case Call():
            return 1 + sum(expression_steps(argument, names) for argument in expression.arguments)
        case Parameter():
            return 1
        case Variable() if is_live(expression, names):
            indices = sum(expression_steps(index, names) for index in indices_of(expression))
            return max(1, _cells(expression, names)) + indices
        case Variable():
            return 1
    return 0


def _cells(variable: Variable, names: NameTable) -> int:
    """Return the number of cells of a string; 0 for anything else."""
    location = resolve(variable, names)
    return -(-location.size_bytes // CELL_BYTES) if isinstance(location, Location) else 0


def _access_steps(expression: Expression, names: NameTable) -> int:
    """Return the cost of a side of an assignment, which may be a structure or array."""
    if isinstance(expression, Variable):
        whole = resolve_aggregate(expression, names)
        if isinstance(whole, Aggregate):
            indices = sum(expression_steps(index, names) for index in indices_of(expression))
            return cells_of(whole.node) + indices
    return expression_steps(expression, names)


def is_live(variable: Variable, names: NameTable) -> bool:
    """Return whether a realtime cycle reads this variable in each tick (RC-302)."""
    location = resolve(variable, names)
    return isinstance(location, Location) and (location.synchronous or variable.synchronous)
