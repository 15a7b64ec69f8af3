# SPDX-License-Identifier: MIT
"""A PLC with faults: it answers late, never or twice, it dies, it comes back.

In: the PLC of the plan, or none, and its faults. Out: a PLC for one run. The actions of a dead PLC
are lost; when it comes back it continues where it was.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass, field
from nctakt.hli.plc_entries import TechnologyEntry
from nctakt.plc.script import Plc
from nctakt.run.plcs.plc_view import AnyPlc, PlcView, WatchedPlc

if TYPE_CHECKING:
    from nctakt.base.diagnostics import Diagnostic

#: How a function is answered, if not by a number: how much later than the PLC does, in
#: microseconds.
NEVER, TWICE = "never", "twice"


@dataclass(slots=True)
class PlcFaults:
    """``answers``: function -> ``never``, ``twice`` or microseconds.

    ``dies_us``: the time of the run from which on the PLC does nothing, ``returns_us``: after how
    long it continues, both in microseconds.
    """

    answers: dict[str, float | str] = field(default_factory=dict)
    dies_us: int | None = None
    returns_us: int | None = None

    def __bool__(self) -> bool:
        return bool(self.answers) or self.dies_us is not None


class FaultyPlc(WatchedPlc):
    """The PLC ``inner`` with faults; without one, a PLC that acknowledges everything at once."""

    def __init__(self, inner: AnyPlc | None, faults: PlcFaults) -> None:
        self._inner = Plc() if inner is None else inner
        self._faults = faults
        self._first_us: int | None = None
        self._delayed: dict[tuple[tuple[str, int], tuple[int, int]], int] = {}
        self._again: list[TechnologyEntry] = []
        self._view: tuple[PlcView, _FaultyView] | None = None

    def begin_run(self, hli: PlcView) -> None:
        """Raise ``Failure`` as the PLC itself."""
        if isinstance(self._inner, WatchedPlc):
            self._inner.begin_run(hli)

    def notes(self) -> Sequence[Diagnostic]:
        """Return those of the PLC itself."""
        return self._inner.notes() if isinstance(self._inner, WatchedPlc) else ()

    def unused_handlers(self, hli: PlcView) -> Sequence[Diagnostic]:
        """Return those of the PLC itself."""
        return self._inner.unused_handlers(hli) if isinstance(self._inner, WatchedPlc) else ()

    def cycle(self, hli: PlcView) -> None:
        """Let the PLC work if it lives, and give the acknowledgements that are due."""
        if self._first_us is None:
            self._first_us = hli.time_us
        if self._is_dead(hli.time_us - self._first_us):
            return
        for entry in self._again:
            hli.acknowledge(entry)
        self._again.clear()
        if self._view is None or self._view[0] is not hli:
            self._view = hli, _FaultyView(hli, self._acknowledge)
        self._inner.cycle(self._view[1])
        for entry in hli.functions():
            since = self._delayed.get((entry.key, entry.stamp))
            if since is not None and hli.time_us - since >= self._delay_us(entry):
                del self._delayed[entry.key, entry.stamp]
                hli.acknowledge(entry)
                if self._faults.answers[entry.name.upper()] == TWICE:
                    self._again.append(entry)

    def _is_dead(self, time_us: int) -> bool:
        dies_us, returns_us = self._faults.dies_us, self._faults.returns_us
        if dies_us is None or time_us < dies_us:
            return False
        return returns_us is None or time_us < dies_us + returns_us

    def _delay_us(self, entry: TechnologyEntry) -> float:
        answer = self._faults.answers[entry.name.upper()]
        if answer == NEVER:
            return float("inf")
        return 0.0 if answer == TWICE else float(answer)

    def _acknowledge(self, entry: TechnologyEntry, view: PlcView) -> bool:
        """Note that the PLC wants to acknowledge; return whether a fault holds it back."""
        if entry.name.upper() not in self._faults.answers:
            return False
        self._delayed.setdefault((entry.key, entry.stamp), view.time_us)
        return True


class _FaultyView(PlcView):
    """The PLC's view of a channel, whose acknowledgements pass the faults."""

    __slots__ = ("_holds_back",)
    _holds_back: Callable[[TechnologyEntry, PlcView], bool]

    def __init__(
        self, hli: PlcView, holds_back: Callable[[TechnologyEntry, PlcView], bool]
    ) -> None:
        super().__init__(hli._machine, hli._index)
        object.__setattr__(self, "_holds_back", holds_back)

    def of_channel(self, number: int) -> PlcView:
        """Return the view of another channel, with the same faults."""
        return _FaultyView(super().of_channel(number), self._holds_back)

    def acknowledge(self, entry: TechnologyEntry) -> None:
        """Acknowledge a function unless a fault holds it back."""
        if not self._holds_back(entry, self):
            super().acknowledge(entry)
