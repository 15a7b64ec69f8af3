# SPDX-License-Identifier: MIT
"""A started run of a study: it continues to its end, or to where an injection is decided.

Out: ``FinishedRun`` with the outcome of the run and a digest of its trace.
"""

from __future__ import annotations

import hashlib
from array import array
from collections.abc import Sequence
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader
from nctakt.run.access.inputs import Input
from nctakt.run.controller import Controller
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.scheduled.scheduled_run import ScheduledRun
from nctakt.studies.measuring.outcome import Outcome
from nctakt.studies.measuring.window import Injection, WindowOutcome, decided_run
from nctakt.studies.plans.inputs import RunInputs


class Digest:
    """A sink that condenses a trace to a few digits: the same trace, the same digits.

    ``tail``: the rows after the latest call of ``begin_tail``.
    """

    def __init__(self) -> None:
        self._events = hashlib.blake2b(digest_size=8)
        self._rows = hashlib.blake2b(digest_size=8)
        self._has_tail = False
        self.tail = array("d")

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Take events."""
        assert isinstance(events, EventChunk)
        self._events.update(events.data)

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Take the values of ticks."""
        self._rows.update(rows)
        if self._has_tail:
            self.tail.frombytes(rows.cast("B"))

    def close(self) -> None:
        """Do nothing."""

    def begin_tail(self, values: Sequence[float]) -> None:
        """Keep the rows from now on, after these values."""
        self._has_tail = True
        self.tail = array("d", values)

    def with_more(self, events: bytes, rows: bytes) -> str:
        """Return the digits of the trace with further events and rows, which it does not keep."""
        all_events, all_rows = self._events.copy(), self._rows.copy()
        all_events.update(events)
        all_rows.update(rows)
        all_events.update(all_rows.digest())
        return all_events.hexdigest()

    def text(self) -> str:
        """Return the digits."""
        self._events.update(self._rows.digest())
        return self._events.hexdigest()


@dataclass(frozen=True, slots=True)
class FinishedRun:
    """A run that was made: its outcome, its inputs, its digest."""

    outcome: Outcome
    inputs: RunInputs
    digest: str


class Lent(Protocol):
    """The objects that a run works on, returned at its end."""

    part: RealtimePart

    def give_back(self) -> None:
        """Let another run have it."""


class BegunRun:
    """A run in progress; ``before``: the values of its signals at its start.

    ``lent``: its realtime part, returned at its end; a run under a schedule has its own.
    """

    def __init__(
        self,
        controller: Controller,
        run: ProgramRun,
        inputs: RunInputs,
        digest: Digest,
        lent: Lent | None,
    ) -> None:
        self.controller = controller
        self.run = run
        self.before = run.before
        self.digest = digest
        self.lent = lent
        self._inputs = inputs

    def add(self, inputs: Sequence[Input]) -> None:
        """Plan further inputs, after those of their ticks that are planned already."""
        self.controller.plan(inputs)

    def values(self) -> list[float]:
        """Return the present values of the signals, as the coming tick reads them."""
        if self.controller.tick == 0:
            return list(self.before.values())
        return [self.controller.signal(name) for name in self.before]

    def finish(
        self, injected_us: int | None = None, injection: Injection | None = None
    ) -> FinishedRun:
        """Continue to the end of the run, or to where the injection is decided; return the run."""
        try:
            if injection is None:
                self.run.advance()
            else:
                self._advance_through(injection)
            if self.run.state is None:
                self.run.interrupt()
        finally:
            self.run.close()
        scheduled = self.run.scheduled_run
        simulation = scheduled.simulation() if isinstance(scheduled, ScheduledRun) else None
        outcome = Outcome(self.run.result(), injected_us, simulation)
        if self.lent is not None:
            self.lent.give_back()
        return FinishedRun(outcome, self._inputs, self.digest.text())

    def _advance_through(self, injection: Injection) -> None:
        """Continue until the injection is decided or the run is over."""
        self.run.advance(injection.tick)
        self.digest.begin_tail(self.values())
        for look in injection.looks():
            self.run.advance(look)
            if self.run.state is not None:
                return
            run = decided_run(look, injection.cycle_time_us, self.before)
            outcome = WindowOutcome(run, injection, tuple(self.before), self.digest.tail)
            if injection.is_decided(outcome):
                return
