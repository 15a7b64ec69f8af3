# SPDX-License-Identifier: MIT
"""All parameters of one kind of list.

In: the table of its declarations. Out: ``Schema``, which finds a parameter by its name or ID, and
the known name nearest to a misspelt one.
"""

from __future__ import annotations

import re

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.base.misspelling import KnownNames
from nctakt.lists.format.parameter import Alias, Parameter
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.table import ParameterTable

#: Brackets with something else than an index.
_NO_INDEX = re.compile(r"\[[^\]\d][^\]]*\]")


@dataclass(frozen=True, slots=True)
class ForeignName:
    """A name that users write into the wrong list, with its right list and ID."""

    pattern: str
    kind: str
    id: str


@dataclass(frozen=True, slots=True)
class Schema:
    """All parameters of one kind of list.

    ``kind`` is its short name (``channel``), ``title`` its name for readers. ``table`` has the
    declarations.
    """

    kind: str
    title: Text
    dialect: ListDialect
    table: ParameterTable
    foreign: tuple[ForeignName, ...] = ()
    _known_names: list[KnownNames] = field(
        default_factory=list, init=False, repr=False, compare=False
    )

    @property
    def used(self) -> tuple[Parameter, ...]:
        """The parameters with an effect."""
        return self.table.used

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All parameters: those with an effect, then the others."""
        return self.table.parameters()

    def find(self, pattern: str) -> tuple[Parameter, Alias | None] | None:
        """Return the parameter with this name, and the alias if it is a further name."""
        return self.table.find(pattern)

    def by_id(self, parameter_id: str) -> tuple[Parameter, ...]:
        """Return the parameters with that ID: some IDs belong to several names."""
        return self.table.by_id(parameter_id)

    def nearest(self, pattern: str) -> str | None:
        """Return the known name that an unknown one misspells, ``None`` without one.

        The names are indexed at the first call.
        """
        if not self._known_names:
            self._known_names.append(KnownNames(self.table.patterns()))
        return self._known_names[0].nearest(_NO_INDEX.sub("[]", pattern))
