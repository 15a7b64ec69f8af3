# SPDX-License-Identifier: MIT
"""A trial: the effect of an injection in the ticks after it, on a run that continues without it.

In: an unchanged run that waits at the injection's tick or some ticks before. Out: the rest of the
run with the injection, up to where it is decided, and the realtime part restored to where the run
waits. Only ticks are tried, nothing on Python's side: if the decoder, the PLC or another stimulus
is due before, or an error occurs, there is no trial, and the run must be made from its start.
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
    """The result of a trial: its outcome, and the events and rows since the run waits."""

    outcome: WindowOutcome
    events: bytes
    rows: bytes


class Trials:
    """Trials on one realtime part; ``cells`` are those of its rows' signals, by their names."""

    def __init__(self, part: RealtimePart, names: MachineNames, cells: Mapping[str, int]) -> None:
        self._part = part
        self._access = VariableAccess(names.layout.tables, names.panels, part.memory, part.kernel)
        self._signals = tuple(cells)
        self._cells = tuple(cells.values())
        self._snapshot: Snapshot | None = None
        self._tick = -1

    def make(
        self, injection: Injection, inputs: Sequence[Input], before: Mapping[str, float]
    ) -> Tried | None:
        """Continue from the present tick to that of the injection, and try these inputs there.

        Returns ``None`` if there can be no trial; raises ``Failure`` for an input that the machine
        refuses.
        """
        tick = self._part.kernel.tick
        if self._snapshot is None or tick != self._tick:
            if self._snapshot is None or not self._snapshot.take_again():
                self._snapshot = Snapshot(self._part)
            self._tick = tick
        try:
            return self._tried(injection, list(inputs), before)
        finally:
            self._snapshot.put_back()

    def _tried(
        self, injection: Injection, inputs: list[Input], before: Mapping[str, float]
    ) -> Tried | None:
        lead = self._run(injection.tick, ())
        if lead is None:
            return None
        events, taken = [lead[0]], [lead[1]]
        values = array("d", map(self._part.cells.__getitem__, self._cells))
        if injection.tick == 0:
            values = array("d", before.values())
        for look in injection.looks():
            stretch = self._run(look, inputs)
            if stretch is None:
                return None
            events.append(stretch[0])
            taken.append(stretch[1])
            values.frombytes(stretch[1])
            run = decided_run(look, injection.cycle_time_us, before)
            outcome = WindowOutcome(run, injection, self._signals, values)
            if injection.is_decided(outcome):
                break
        return Tried(outcome, b"".join(events), b"".join(taken))

    def _run(self, end: int, inputs: list[Input] | tuple[()]) -> tuple[bytes, bytes] | None:
        """Run up to a tick with these inputs; return events and rows, ``None`` if it stops."""
        kernel, record = self._part.kernel, self._part.record
        events, taken = b"", b""
        while kernel.tick < end:
            due = self._post(inputs, end)
            kernel.reserve()
            reason = kernel.run(due - kernel.tick)
            if reason not in (codes.DONE, codes.FULL):
                return None
            if record.event_count:
                new = record.take_events()
                kinds = memoryview(new).cast("d")[rows.EVENT_KIND :: rows.EVENT_WIDTH]
                if not _ANSWERED.isdisjoint(kinds):
                    return None
                events += new
            taken += record.take_rows()
            if record.probe_count:
                record.take_probes()
        return events, taken

    def _post(self, inputs: list[Input] | tuple[()], end: int) -> int:
        """Post the inputs of the coming tick; return up to which tick nothing else is due."""
        tick = self._part.kernel.tick
        while inputs and inputs[0].tick <= tick:
            name, value = inputs.pop(0).values
            self._access.write(str(name), value)
        return min(inputs[0].tick, end) if inputs else end
