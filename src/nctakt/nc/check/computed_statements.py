# SPDX-License-Identifier: MIT
"""Statements that only the run shows, checked as any others are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import overload

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.nc.check.checker import Checker
from nctakt.nc.source import Source
from nctakt.nc.tree import Statement
from nctakt.nc.vocabulary.variables.variable_table import NameTable


def first_mistake(
    names: NameTable,
    parameters: ChannelParameters,
    statements: Sequence[Statement],
    span: Span,
    line: Callable[[], str],
    is_main: bool,
    named_programs: Iterable[str],
) -> Diagnostic | None:
    """Return the first error in statements at ``span``, ``None`` if there is none.

    ``line`` returns the text that they were read from, for a message that shows part of it.
    ``is_main``: they belong to the main program itself. ``named_programs``: the words whose program
    ``#FILE NAME`` has named.
    """
    collector = Collector()
    source = Source(span.file, _OneLine(span.line, line))
    checker = Checker(source, names, parameters, collector, named_programs)
    checker.begin("main" if is_main else "either")
    for statement in statements:
        checker.statement(statement)
    errors = (one for one in collector.diagnostics if one.severity.name == "ERROR")
    return next(errors, None)


class _OneLine(Sequence[str]):
    """A text of which only the line of this number matters, the last one."""

    def __init__(self, number: int, line: Callable[[], str]) -> None:
        self._number = number
        self._line = line

    def __len__(self) -> int:
        return self._number

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[str]: ...

    def __getitem__(self, index: int | slice) -> str | Sequence[str]:
        if isinstance(index, slice):
            return [self[position] for position in range(*index.indices(self._number))]
        return self._line() if index == self._number - 1 else ""
