# SPDX-License-Identifier: MIT
"""A machine's log as data: its columns, and the samples of those that are asked for.

A log has several time bases (LG-101): each signal has its own stamps, in microseconds since the
log's first one. What could not be settled while it was read is told in ``notes``.
"""

from __future__ import annotations

import abc
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Numbers = NDArray[numpy.float64]


@dataclass(frozen=True, slots=True)
class LogColumn:
    """A column of values; ``unit`` is "" where the log names none."""

    name: str
    unit: str
    column: int
    time_column: int


@dataclass(frozen=True, slots=True)
class Samples:
    """The samples of a column: ``times`` in µs since the log's first stamp, ascending."""

    times: Numbers
    values: Numbers


class Log(abc.ABC):
    """A log that is open: its columns are known, its samples are read on request."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.columns: Sequence[LogColumn] = ()
        self.notes: list[Diagnostic] = []

    @abc.abstractmethod
    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of columns; raises ``Failure`` for what is no sample."""
