# SPDX-License-Identifier: MIT
"""All parameters of one kind of list.

In: declarations, in code for parameters with an effect and in a table for the others. Out:
``Schema``, which finds a parameter by its name or ID, and the known name nearest to a misspelt one.
"""

from __future__ import annotations

from typing import Protocol

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.base.misspelling import KnownNames
from nctakt.lists.format.parameter import Alias, Parameter, pattern_of
from nctakt.lists.format.reader import ListDialect


class Table(Protocol):
    """Declarations that are read when they are needed (``table.py``)."""

    def find(self, pattern: str) -> Parameter | None:
        """Return the parameter with that name."""

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """Return the parameters with that ID."""

    def patterns(self) -> tuple[str, ...]:
        """Return all names."""

    def parameters(self) -> tuple[Parameter, ...]:
        """Return all parameters."""


@dataclass(frozen=True, slots=True)
class ForeignName:
    """A name that users write into the wrong list, with its right list and ID."""

    pattern: str
    kind: str
    id: str


@dataclass(frozen=True, slots=True)
class Schema:
    """All parameters of one kind of list.

    ``kind`` is its short name (``channel``), ``title`` its name for readers. ``declared``: the
    parameters with an effect. ``table``: those without one, ``None`` if there are none.
    """

    kind: str
    title: Text
    dialect: ListDialect
    declared: tuple[Parameter, ...]
    table: Table | None = None
    foreign: tuple[ForeignName, ...] = ()
    _by_pattern: dict[str, tuple[Parameter, Alias | None]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )
    _by_id: dict[str, list[Parameter]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )
    _known_names: list[KnownNames] = field(
        default_factory=list, init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        for parameter in self.declared:
            self._add(parameter.pattern, parameter, None)
            self._add_id(parameter.id, parameter)
            for alias in parameter.aliases:
                self._add(pattern_of(alias.path), parameter, alias)
                self._add_id(alias.id, parameter)

    def _add(self, pattern: str, parameter: Parameter, alias: Alias | None) -> None:
        assert pattern not in self._by_pattern, pattern
        assert pattern.count("[]") == len(parameter.index_ranges), pattern
        self._by_pattern[pattern] = (parameter, alias)

    def _add_id(self, parameter_id: str, parameter: Parameter) -> None:
        if parameter_id:
            self._by_id.setdefault(parameter_id, []).append(parameter)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All parameters: those with an effect, then those of the table."""
        return self.declared + (self.table.parameters() if self.table is not None else ())

    def find(self, pattern: str) -> tuple[Parameter, Alias | None] | None:
        """Return the parameter with this name, and the alias if the name is an old one."""
        declared = self._by_pattern.get(pattern)
        if declared is not None or self.table is None:
            return declared
        parameter = self.table.find(pattern)
        return None if parameter is None else (parameter, None)

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """Return the parameters with that ID: some IDs stand for several names."""
        declared = tuple(self._by_id.get(parameter_id, ()))
        return declared + (self.table.by_id(parameter_id) if self.table is not None else ())

    def nearest(self, pattern: str) -> str | None:
        """Return the known name that an unknown one misspells, ``None`` without one.

        The names are indexed at the first call.
        """
        if not self._known_names:
            patterns = self.table.patterns() if self.table is not None else ()
            self._known_names.append(KnownNames((*self._by_pattern, *patterns)))
        return self._known_names[0].nearest(pattern)
