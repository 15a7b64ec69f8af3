# SPDX-License-Identifier: MIT
"""A trial: what an injection does in the ticks after it, off a run that goes on without it.

In: an unchanged run at a tick. Out: the rest of the run with the injection, up to where it is
decided, and the realtime part put back to that tick. Only ticks are tried, nothing of Python's
side: where the decoder, the PLC or another stimulus is due before, or an error comes, there is no
trial, and the run has to be made from its start.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.kernel import codes, rows
from nctakt.run.access.inputs import Input
from nctakt.run.access.machine_names import MachineNames
from nctakt.run.access.variable_access import VariableAccess
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.snapshot import Snapshot
from nctakt.studies.measuring.window import Injection, WindowOutcome, decided_run

#: Events that Python's side answers.
_ANSWERED = frozenset((rows.EVENT_ERROR, rows.EVENT_NOTICE, rows.EVENT_USER_ERROR))


@dataclass(frozen=True, slots=True)
class Tried:
    """What a trial has made: its outcome, and the events and rows since the injection."""

    outcome: WindowOutcome
    events: bytes
    rows: bytes


class Trials:
    """Trials off one realtime part; ``signals`` are those of its rows."""

    def __init__(self, part: RealtimePart, names: MachineNames, signals: Sequence[str]) -> None:
        self._part = part
        self._access = VariableAccess(names.layout.tables, names.panels, part.memory, part.kernel)
        self._signals = tuple(signals)
        self._snapshot: Snapshot | None = None

    def make(
        self,
        injection: Injection,
        inputs: Sequence[Input],
        before: Mapping[str, float],
        values: Sequence[float],
    ) -> Tried | None:
        """Try inputs from the present tick on, which is the injection's.

        ``values``: the present ones of the signals. Returns ``None`` if there can be no trial;
        raises ``Failure`` for an input that the machine does not take.
        """
        if self._snapshot is None or not self._snapshot.take_again():
            self._snapshot = Snapshot(self._part)
        try:
            return self._tried(injection, list(inputs), before, array("d", values))
        finally:
            self._snapshot.put_back()

    def _tried(
        self,
        injection: Injection,
        inputs: list[Input],
        before: Mapping[str, float],
        values: array[float],
    ) -> Tried | None:
        kernel, record = self._part.kernel, self._part.record
        events, taken = [], []
        for look in injection.looks():
            while kernel.tick < look:
                due = self._post(inputs, look)
                kernel.reserve()
                reason = kernel.run(due - kernel.tick)
                if reason not in (codes.DONE, codes.FULL):
                    return None
                new, data = record.take_events(), record.take_rows()
                record.take_probes()
                if not _ANSWERED.isdisjoint(
                    memoryview(new).cast("d")[rows.EVENT_KIND :: rows.EVENT_WIDTH]
                ):
                    return None
                events.append(new)
                taken.append(data)
                values.frombytes(data)
            run = decided_run(look, injection.cycle_time_us, before)
            outcome = WindowOutcome(run, injection, self._signals, values)
            if injection.is_decided(outcome):
                break
        return Tried(outcome, b"".join(events), b"".join(taken))

    def _post(self, inputs: list[Input], end: int) -> int:
        """Post the inputs of the coming tick; return up to which tick nothing else is due."""
        tick = self._part.kernel.tick
        while inputs and inputs[0].tick <= tick:
            name, value = inputs.pop(0).values
            self._access.write(str(name), value)
        return min(inputs[0].tick, end) if inputs else end
