# SPDX-License-Identifier: MIT
"""Expressions, and arguments in brackets and after ``#``."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span


@dataclass(frozen=True, slots=True)
class Node:
    """A part of the program's text."""

    span: Span


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


#: The family of arrays of P parameters; the number is the only part.
PARAMETER_ARRAYS = "P[]"


@dataclass(frozen=True, slots=True)
class Variable(Expression):
    """``V.<family>.<part>.<part> …``; ``synchronous`` for ``Vs.``.

    ``family`` is E, CH, P, L, S, CYC, RTG, RTA, G, A, … in upper case; ``PARAMETER_ARRAYS`` for
    ``P10[1]``. ``parts`` is empty only
    where a whole family is named (``#INIT V.E.``).
    """

    family: str
    parts: tuple[Part, ...]
    synchronous: bool = False


@dataclass(frozen=True, slots=True)
class Parameter(Expression):
    """``P1``, ``P[expression]``; ``call`` for the parameters of a call, ``@P1``.

    ``PP1`` is ``P[P1]``.
    """

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


@dataclass(frozen=True, slots=True)
class Keyword(Node):
    """``ID = 17``, ``FEED100``, ``ABORTING``: a word in upper case with or without a value.

    ``G90`` and ``M03`` in brackets are keywords ``G`` and ``M`` with the values 90 and 3. ``@P1 =``
    of a call is the keyword ``@P1``. ``arguments`` is for keywords with their own brackets.
    """

    name: str
    value: Expression | None = None
    arguments: tuple[Expression | Keyword, ...] = ()


@dataclass(frozen=True, slots=True)
class Bracket(Node):
    """One ``[ … ]`` of a command: keywords and plain values in their order."""

    items: tuple[Keyword | Expression, ...]
