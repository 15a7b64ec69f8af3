# SPDX-License-Identifier: MIT
"""Control structures: statements with statements inside."""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.nc.tree.statements import Head, Statement
from nctakt.nc.tree.values import Expression, Keyword, Node, Parameter, Variable

Frequency = Literal["ONCE", "EDGE", "ALWAYS"]


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
class RealtimeCycle(Statement):
    """``#RT CYCLE [DEF] [ID=… SCOPE=… END_ACTION=…] … #RT CYCLE END`` (RC-101).

    ``end_span``: the span of its end, or of its start if the end is missing.
    """

    definition_only: bool
    keywords: tuple[Keyword | Expression, ...]
    body: tuple[Statement, ...]
    end_span: Span
