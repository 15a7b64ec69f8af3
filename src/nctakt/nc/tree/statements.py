# SPDX-License-Identifier: MIT
"""Statements: blocks, assignments, calls, ``#`` commands, declarations; and the whole program."""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.nc.source import Source
from nctakt.nc.tree.values import Bracket, Expression, Keyword, Name, Node, Parameter, Variable
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


@dataclass(frozen=True, slots=True)
class Declaration(Node):
    """``V.L.NAME[3] : STRING[20] = value`` inside ``#VAR``.

    The dimensions are the indices of the variable's last part. ``type_name`` is in upper case,
    ``None`` if it is left out; ``size`` is the length of a string.
    """

    head: Head
    variable: Variable
    type_name: str | None = None
    size: Expression | None = None
    initial: Expression | None = None


@dataclass(frozen=True, slots=True)
class VariableDeclarations(Statement):
    """``#VAR … #ENDVAR``."""

    declarations: tuple[Declaration, ...]


@dataclass(frozen=True, slots=True)
class ProgramStart(Statement):
    """``%name``; ``local`` for ``%L name``."""

    name: str
    local: bool


@dataclass(frozen=True, slots=True)
class Unreadable(Statement):
    """A block that is not NC text in a part of the program that normally never runs.

    It follows a program end or is inside ``$IF 0``; the decoder refuses it if a jump reaches it.
    """

    text: str


@dataclass(frozen=True, slots=True)
class Subprogram(Node):
    """A local subprogram ``%L name`` with its statements."""

    name: str
    statements: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Program:
    """A program file: ``name`` after ``%`` (empty without), main program, local subprograms."""

    source: Source
    name: str
    statements: tuple[Statement, ...]
    subprograms: tuple[Subprogram, ...] = ()


@dataclass(frozen=True, slots=True)
class CycleControl(Statement):
    """``#RT CYCLE START|HOLD|CONTINUE|ABORT ACTION|DELETE [ID=…]`` (RC-111)."""

    action: str
    keywords: tuple[Keyword | Expression, ...]


@dataclass(frozen=True, slots=True)
class Flush(Statement):
    """``#FLUSH``, ``#FLUSH WAIT``, ``#FLUSH CONTINUE``: ``mode`` is ``None``, WAIT,
    CONTINUE."""

    mode: Literal["WAIT", "CONTINUE"] | None


@dataclass(frozen=True, slots=True)
class Time(Statement):
    """``#TIME seconds``."""

    seconds: Expression


@dataclass(frozen=True, slots=True)
class UserMessage(Statement):
    """``#MSG SAVE EXCLUSIVE ["format", value, …]``."""

    options: tuple[Name, ...]
    format: Expression
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Timer(Statement):
    """``#TIMER START|STOP|READ|CLEAR [SYN] [ID=…]`` (RC-401).

    ``options`` are the words after the action, SYN among them.
    """

    action: str
    options: tuple[Name, ...]
    keywords: tuple[Keyword | Expression, ...]


@dataclass(frozen=True, slots=True)
class UserError(Statement):
    """``#ERROR [ID=… RC=… PV1=… PM1=…]`` (RC-402)."""

    keywords: tuple[Keyword | Expression, ...]


@dataclass(frozen=True, slots=True)
class HashCommand(Statement):
    """Any other ``#`` command, and a known one in an unknown form.

    ``words``: the words after ``#`` up to the first bracket or value (``CHANNEL INIT``, ``KIN
    ID``). ``arguments``: the rest, in order.
    """

    words: tuple[Name, ...]
    arguments: tuple[Bracket | Keyword | Expression, ...]


OffsetCommandName = Literal["PSET", "PRESET", "SUPPRESS OFFSETS", "SCALE", "SCALE ON"]


@dataclass(frozen=True, slots=True)
class OffsetCommand(Statement):
    """``#PSET X0``, ``#PRESET X0``, ``#SUPPRESS OFFSETS [ZERO] X0``, ``#SCALE ON X2``.

    ``name``: the words after ``#``. ``kinds``: the items in brackets. ``words``: the rest.
    """

    name: OffsetCommandName
    kinds: tuple[Keyword | Expression, ...]
    words: tuple[BlockWord, ...]
