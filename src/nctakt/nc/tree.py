# SPDX-License-Identifier: MIT
"""The tree of an NC program: frozen nodes, each with its span in the text.

Made by the parser; read by printer, checker and decoder. Nodes hold the program as written, not its
meaning: the checker decides which letters are axes of the machine, which words exist and what is
allowed where. Names of words, keywords, functions and variable families are in upper case, names of
user variables and texts as written. A span covers the first line of a node only.

Layout: ``Expression`` (values), ``BlockWord`` (words of a block), ``Statement`` (parts of a
program, each with a ``Head`` of block number, skip level and label).
"""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.nc.source import Source

Frequency = Literal["ONCE", "EDGE", "ALWAYS"]
AssignmentOperator = Literal["=", "+=", "-=", "*=", "/="]


@dataclass(frozen=True, slots=True)
class Node:
    """A part of the program's text."""

    span: Span


# --- expressions ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Expression(Node):
    """A node with a value."""


@dataclass(frozen=True, slots=True)
class Number(Expression):
    """A literal with its sign (``X-2``), so that a constant is one node."""

    value: float


@dataclass(frozen=True, slots=True)
class StringLiteral(Expression):
    """Text between double quotes, without them; there are no escapes."""

    value: str


@dataclass(frozen=True, slots=True)
class Constant(Expression):
    """``TRUE``, ``FALSE`` or ``PI``."""

    name: str


@dataclass(frozen=True, slots=True)
class Name(Expression):
    """A bare word as a value, as in ``SCOPE = BLOCK`` or ``MSG = report.txt``.

    ``name`` is in upper case, ``text`` as written.
    """

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Part(Node):
    """One step of a variable's path: ``NP[1]``; several indices for ``FIELD[2][3]``."""

    name: str
    indices: tuple[Expression, ...] = ()


@dataclass(frozen=True, slots=True)
class Variable(Expression):
    """``V.<family>.<part>.<part> …``; ``synchronous`` for ``Vs.``.

    ``family`` is E, CH, P, L, S, CYC, RTG, RTA, G, A, … in upper case. ``parts`` is empty only
    where a whole family is named (``#INIT V.E.``).
    """

    family: str
    parts: tuple[Part, ...]
    synchronous: bool = False


@dataclass(frozen=True, slots=True)
class Parameter(Expression):
    """``P1``, ``P[expression]``; ``call`` for the parameters of a call, ``@P1``."""

    index: Expression
    call: bool = False


@dataclass(frozen=True, slots=True)
class Unary(Expression):
    """``-operand``; ``NOT[…]`` and ``INV[…]`` are calls."""

    operator: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class Binary(Expression):
    """``left operator right``; operators as in ``nc/vocabulary/operators.py``, words in upper
    case.
    """

    operator: str
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Call(Expression):
    """``SIN[30]``, ``ATAN2[y, x]``, ``EXIST[V.P.A]``; an unknown function is kept."""

    function: str
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class ArrayLiteral(Expression):
    """``[1, 2, 3]``: the value of an array or a structure, in declarations and assignments."""

    items: tuple[Expression, ...]


# --- what stands in brackets and behind # --------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Keyword(Node):
    """``ID = 17``, ``FEED100``, ``ABORTING``: a word in upper case with or without a value.

    ``G90`` and ``M03`` in brackets are keywords ``G`` and ``M`` with the values 90 and 3. ``@P1 =``
    of a call is the keyword ``@P1``. ``arguments`` is for keywords with brackets of their own.
    """

    name: str
    value: Expression | None = None
    arguments: tuple[Expression | Keyword, ...] = ()


@dataclass(frozen=True, slots=True)
class Bracket(Node):
    """One ``[ … ]`` of a command: keywords and plain values in their order."""

    items: tuple[Keyword | Expression, ...]


# --- words of a block ----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class BlockWord(Node):
    """One word of a block."""


@dataclass(frozen=True, slots=True)
class Word(BlockWord):
    """``G01``, ``F100``, ``S.POS=314``; ``value`` is ``None`` for a word without a value.

    ``additional``: the value of ``M110=130`` or ``G129=50``; ``arguments``: those of ``G805[1,
    2]``. Unknown words are kept as well.
    """

    name: str
    value: Expression | None
    additional: Expression | None = None
    arguments: tuple[Expression, ...] = ()


@dataclass(frozen=True, slots=True)
class AxisWord(BlockWord):
    """A word whose name may be that of an axis (first letter A B C Q U V W X Y Z): ``X10``,
    ``XR=5``.

    The checker decides whether the machine has that axis.
    """

    name: str
    value: Expression | None


@dataclass(frozen=True, slots=True)
class BracketCommand(BlockWord):
    """``X[INDP G90 POS=10]``, ``S2[M03 REV=1000]``, ``M17[MAIN]``."""

    name: str
    items: tuple[Keyword | Expression, ...]


@dataclass(frozen=True, slots=True)
class StringWord(BlockWord):
    """A quoted text in a block: the use of a macro."""

    text: str


# --- statements ----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Head:
    """The parts in front of a block's content.

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
class ElseIf(Node):
    """A ``$ELSEIF`` branch; the checker reports a frequency as an error (22021)."""

    head: Head
    frequency: Frequency | None
    condition: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class If(Statement):
    """``$IF … $ENDIF``, also ``$IF c $GOTO N20``.

    ``else_body`` and ``else_span`` (the span of ``$ELSE``) are ``None`` without ``$ELSE``.
    ``preprocessor`` for ``#IF … #ENDIF``.
    """

    frequency: Frequency | None
    condition: Expression
    body: tuple[Statement, ...]
    elseifs: tuple[ElseIf, ...] = ()
    else_body: tuple[Statement, ...] | None = None
    preprocessor: bool = False
    else_span: Span | None = None


@dataclass(frozen=True, slots=True)
class For(Statement):
    """``$FOR variable = start, end, step … $ENDFOR``."""

    variable: Variable | Parameter
    start: Expression
    end: Expression
    step: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class While(Statement):
    """``$WHILE condition … $ENDWHILE``."""

    condition: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class RealtimeLoop(Statement):
    """``#RT WHILE [MODULO] … #RT ENDWHILE``: the realtime part repeats the body."""

    modulo: bool
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Do(Statement):
    """``$DO … $ENDDO condition``: repeats while the condition holds."""

    body: tuple[Statement, ...]
    condition: Expression


@dataclass(frozen=True, slots=True)
class Repeat(Statement):
    """``$REPEAT … $UNTIL condition``: ends when the condition holds."""

    body: tuple[Statement, ...]
    condition: Expression


@dataclass(frozen=True, slots=True)
class Case(Node):
    """``$CASE value``, or ``$DEFAULT`` if ``value`` is ``None``."""

    head: Head
    value: Expression | None
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Switch(Statement):
    """``$SWITCH subject … $ENDSWITCH``; the branches in their order."""

    subject: Expression
    cases: tuple[Case, ...]


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
class RealtimeCycle(Statement):
    """``#RT CYCLE [DEF] [ID=… SCOPE=… END_ACTION=…] … #RT CYCLE END`` (RC-101).

    ``end_span``: the span of its end, or of its start if the end is missing.
    """

    definition_only: bool
    keywords: tuple[Keyword | Expression, ...]
    body: tuple[Statement, ...]
    end_span: Span


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

    ``options`` are the words behind the action, SYN among them.
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

    ``words``: the words behind ``#`` up to the first bracket or value (``CHANNEL INIT``, ``KIN
    ID``). ``arguments``: the rest, in order.
    """

    words: tuple[Name, ...]
    arguments: tuple[Bracket | Keyword | Expression, ...]


OffsetCommandName = Literal["PSET", "PRESET", "SUPPRESS OFFSETS"]


@dataclass(frozen=True, slots=True)
class OffsetCommand(Statement):
    """``#PSET X0``, ``#PRESET X0``, ``#SUPPRESS OFFSETS [ZERO] X0``.

    ``name``: the words behind ``#``. ``kinds``: the items in brackets. ``words``: the rest.
    """

    name: OffsetCommandName
    kinds: tuple[Keyword | Expression, ...]
    words: tuple[BlockWord, ...]


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
    """A program file: ``name`` behind ``%`` (empty without), main program, local subprograms."""

    source: Source
    name: str
    statements: tuple[Statement, ...]
    subprograms: tuple[Subprogram, ...] = ()
