# SPDX-License-Identifier: MIT
"""Changes made by a PLC in Structured Text, by which statement, and what led to them.

Made by ``plc/st_reasons.py``, shown by ``plc_text.py``. Ticks count from the controller's start.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, overload

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span

FactKind = Literal["condition", "operand", "selector", "pass", "result", "call"]


@dataclass(frozen=True, slots=True)
class Fact:
    """Something that led to a change: a value that the code saw, or a call.

    ``value``: empty for calls and results. ``inside``: for a call that has returned, the facts that
    led to its result.
    """

    kind: FactKind
    span: Span | None
    text: str
    value: str
    inside: tuple[Fact, ...] = ()


@dataclass(frozen=True, slots=True)
class PlcChange:
    """A change of a variable; without ``span`` no statement made it, but the CNC or an input.

    ``before``: empty if it was not known. ``statement``: its text. ``facts``: what led to it, from
    the task's program to the statement; ``is_cut``: some are missing.
    """

    tick: int
    span: Span | None
    before: str
    value: str
    statement: str = ""
    facts: tuple[Fact, ...] = ()
    is_cut: bool = False


@dataclass(frozen=True, slots=True)
class PlcHistory:
    """The changes of a variable in a run; of many only the newest.

    ``is_interface``: it lies in the interface or is a V.E variable. ``begin``: its value before the
    first change that is kept, empty where that is not known. ``left_out``: older changes;
    ``missed``: changes for which a tick had no room.
    ``written`` and ``writer``: tick and statement that wrote it last, whether its value changed or
    not.
    """

    path: str
    is_interface: bool
    begin: str
    changes: tuple[PlcChange, ...] = ()
    left_out: int = 0
    missed: int = 0
    written: int | None = None
    writer: Span | None = None
    writer_statement: str = ""

    def change_at(self, tick: int) -> PlcChange | None:
        """Return the change that gave the value in a tick; ``None`` if it is older."""
        return next((one for one in reversed(self.changes) if one.tick <= tick), None)


class PlcHistories(Sequence[PlcHistory]):
    """Histories that are made when somebody looks at them: few runs are asked for them."""

    def __init__(self, make: Callable[[], tuple[PlcHistory, ...]]) -> None:
        self._make = make
        self._histories: tuple[PlcHistory, ...] | None = None

    @property
    def _all(self) -> tuple[PlcHistory, ...]:
        if self._histories is None:
            self._histories = self._make()
        return self._histories

    def __len__(self) -> int:
        return len(self._all)

    @overload
    def __getitem__(self, index: int) -> PlcHistory: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[PlcHistory]: ...

    def __getitem__(self, index: int | slice) -> PlcHistory | Sequence[PlcHistory]:
        return self._all[index]

    def __reduce__(self) -> tuple[Callable[..., object], tuple[object, ...]]:
        return tuple, (self._all,)
