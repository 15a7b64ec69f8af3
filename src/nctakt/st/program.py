# SPDX-License-Identifier: MIT
"""A checked PLC program, passed by the checker to the runtime, the editor and documents."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from nctakt.base.dataclass import dataclass, field
from nctakt.st.sources import Sources
from nctakt.st.tree import GlobalList
from nctakt.st.types import Callable, Expression, InterfaceType, Pou, Type, Variable


@dataclass(slots=True, eq=False)
class Task:
    """A task with its programs in the order of their calls (ST-801 … 803)."""

    name: str
    cycle_us: int
    priority: int
    programs: list[Pou]


class SingleReader(Protocol):
    """Checks an expression that belongs to no body: a condition, a question of a debugger."""

    def read(self, text: str, unit: Callable | None) -> Expression:
        """Return it in the scope of a unit, or of global names; raises ``Failure``."""


@dataclass(slots=True, eq=False)
class Program:
    """A project: all that is declared, with layout; bodies with their names and types resolved.

    The data area has ``data_size`` bytes: globals, VAR_STAT, and the instances of programs. There
    is never a variable at offset 0, so that no address is null. ``has_errors``: it must not run.
    ``files``: those of the project that were read; ``read_files``: also those of
    libraries, and the settings.
    ``initial_order``: the global variables in the order of their initialisation (ST-404), then
    programs by ``pous``. ``blocks``: blocks and programs by number, from 1.
    """

    name: str
    sources: Sources
    pous: Mapping[str, Pou]  # by the name in lower case; those of libraries that are used, too
    interfaces: list[InterfaceType]  # those of libraries, too
    types: Mapping[str, Type]
    lists: list[GlobalList]
    tasks: list[Task]
    data_size: int = 0
    initial_order: list[Variable] = field(default_factory=list)
    blocks: list[Pou] = field(default_factory=list)
    has_errors: bool = False
    files: list[str] = field(default_factory=list)
    read_files: list[str] = field(default_factory=list)
    #: Reads further expressions in the scopes of the project, once it has been checked.
    single: SingleReader | None = None
