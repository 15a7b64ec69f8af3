# SPDX-License-Identifier: MIT
"""What a realtime cycle can cost in one tick, known before it runs (RC-501).

In: nodes of a cycle's body. Out: elementary instructions: each operator, function, access to a
variable, assignment, condition and action counts one, constants are free. They are the counts that
the realtime part adds up; of the branches of an ``$IF`` at most one is taken.
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
from nctakt.nc.vocabulary.resolution import indices_of, resolve
from nctakt.nc.vocabulary.spindle_commands import SpindleCommand, split
from nctakt.nc.vocabulary.variable_table import Location, NameTable


def max_steps(statements: Sequence[Statement], names: NameTable) -> int:
    """The most that one run through these statements can cost."""
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
    """Each M and H function counts one, each command to a spindle one and its values."""
    commands, others = split(block.words, names.spindles)
    steps = sum(word_steps(word, names) for word in others)
    return steps + sum(command_steps(command, names) for command in commands)


def command_steps(command: SpindleCommand, names: NameTable) -> int:
    """The cost of a command to a spindle."""
    values = (command.speed, command.position)
    return 1 + sum(expression_steps(value, names) for value in values if value is not None)


def word_steps(word: BlockWord, names: NameTable) -> int:
    """The cost of an action: what it computes, and itself."""
    if not isinstance(word, BracketCommand):
        return 1
    return 1 + sum(
        expression_steps(item.value, names)
        for item in word.items
        if isinstance(item, Keyword) and item.value is not None
    )


def _assignment(statement: Assignment, names: NameTable) -> int:
    access = expression_steps(statement.target, names)
    value = expression_steps(statement.value, names)
    # A compound one reads its target, and computes, before it stores.
    return access + value if statement.operator == "=" else 2 * access + value + 1


def _if(statement: If, names: NameTable) -> int:
    """All conditions up to the branch whose way costs most, and its body."""
    asked = condition_steps(statement.condition, names)
    costs = [asked + max_steps(statement.body, names)]
    for branch in statement.elseifs:
        asked += condition_steps(branch.condition, names)
        costs.append(asked + max_steps(branch.body, names))
    costs.append(asked + max_steps(statement.else_body or (), names))
    return max(costs)


def condition_steps(condition: Expression, names: NameTable) -> int:
    """The cost of evaluating the condition of an ``$IF``, its own instruction included."""
    return expression_steps(condition, names) + 1


def expression_steps(expression: Expression, names: NameTable) -> int:
    """The cost of an expression; an asynchronous variable is one access whatever its indices."""
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
            return 1 + sum(expression_steps(index, names) for index in indices_of(expression))
        case Variable():
            return 1
    return 0


def is_live(variable: Variable, names: NameTable) -> bool:
    """Whether a realtime cycle reads this variable in each tick (RC-302)."""
    location = resolve(variable, names)
    return isinstance(location, Location) and (location.synchronous or variable.synchronous)
