# SPDX-License-Identifier: MIT
"""Commands that begin with ``#``."""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.nc.tree.statements import Statement
from nctakt.nc.tree.values import Bracket, Expression, Keyword, Name
from nctakt.nc.tree.words import BlockWord


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
