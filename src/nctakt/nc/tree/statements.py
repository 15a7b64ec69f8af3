# SPDX-License-Identifier: MIT
"""Statements in general, blocks, assignments and calls."""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.nc.tree.values import Expression, Keyword, Node, Parameter, Variable
from nctakt.nc.tree.words import BlockWord

AssignmentOperator = Literal["=", "+=", "-=", "*=", "/="]


@dataclass(frozen=True, slots=True)
class Head:
    """The parts before a block's content.

    ``number``: the value of the N word. ``skip``: the level 1 … 10 of ``/`` (``/`` alone is 1).
    ``label``: ``N20`` for ``N20:``, ``NAME`` in upper case for ``[NAME]``.
    """

    number: Expression | None = None
    skip: int | None = None
    label: str | None = None


NO_HEAD = Head()


@dataclass(frozen=True, slots=True)
class Statement(Node):
    """One block, or a control structure with the blocks inside it."""

    head: Head


@dataclass(frozen=True, slots=True)
class Block(Statement):
    """A block of words; empty if it has only a number or a label."""

    words: tuple[BlockWord, ...]


@dataclass(frozen=True, slots=True)
class SubprogramCall(Statement):
    """``L file``, ``LL name``, ``L CYCLE [NAME=… @P1=…]``.

    ``local`` for LL. ``name`` is a ``StringLiteral`` with the text as written, or a variable.
    ``cycle`` for the form with CYCLE, whose other keywords are ``keywords``. ``words`` are the
    other words of the block.
    """

    local: bool
    name: Expression
    cycle: bool = False
    keywords: tuple[Keyword | Expression, ...] = ()
    words: tuple[BlockWord, ...] = ()


@dataclass(frozen=True, slots=True)
class Assignment(Statement):
    """``target operator value``."""

    target: Variable | Parameter
    operator: AssignmentOperator
    value: Expression


@dataclass(frozen=True, slots=True)
class VariableBlock(Statement):
    """A bare variable as a block (RC-311)."""

    variable: Variable | Parameter


@dataclass(frozen=True, slots=True)
class MacroDefinition(Statement):
    """``"NAME" = "text"``."""

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Goto(Statement):
    """``$GOTO N20``, ``$GOTO [NAME]``; ``label`` as in ``Head``."""

    label: str


@dataclass(frozen=True, slots=True)
class Break(Statement):
    """``$BREAK``."""


@dataclass(frozen=True, slots=True)
class Continue(Statement):
    """``$CONTINUE``."""
