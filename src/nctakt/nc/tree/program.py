# SPDX-License-Identifier: MIT
"""Declarations and programs."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.nc.source import Source
from nctakt.nc.tree.statements import Head, Statement
from nctakt.nc.tree.values import Expression, Node, Variable


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
