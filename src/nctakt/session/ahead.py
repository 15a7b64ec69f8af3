# SPDX-License-Identifier: MIT
"""The future of a session without further inputs: a copy of its controller runs ahead.

In: a copy at the end of its branch. Out: sampled signals and events of the ticks to come. The copy
is discarded; its actions have no effect elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.results.trace.events import Event
from nctakt.session.outline import outlined
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.stops import StopAt

#: Ticks that a copy runs ahead at most.
MAX_AHEAD = 500_000

#: Rows and events that are kept; of more rows the half that shows best where the signals go.
MAX_POINTS, MAX_EVENTS = 4000, 2000

#: Rows between two looks whether the run is over or waits.
_PART = 250

_BLOCK = StopAt("block")


@dataclass(frozen=True, slots=True)
class Future:
    """The signals after some ticks to come, column by column, and the events of all of them.

    ``reason``: why it ends there: the run is ``over``, all programs ``wait`` for somebody outside,
    or it continues ``later``; ``unknown``: there is no future to show, since it depends on somebody
    outside. ``causes``: the reasons for which the programs wait, or the errors of the run.
    """

    ticks: tuple[int, ...]
    columns: tuple[tuple[float, ...], ...]
    events: tuple[Event, ...]
    reason: Literal["over", "wait", "later", "unknown"]
    causes: tuple[Diagnostic, ...] = ()


UNKNOWN = Future((), (), (), "unknown")


def run_ahead(engine: RemoteEngine, signals: Sequence[str]) -> Iterator[Future]:
    """Run a copy ahead; the known future grows with each item. Closes the copy."""
    width = len(signals)
    rows = np.empty((0, width + 1))  # the tick, and the signals after it
    events: list[Event] = []
    errors: list[Diagnostic] = []
    first, every = engine.tick, 1
    try:
        while True:
            end = min(engine.tick + every * _PART, first + MAX_AHEAD)
            data = engine.ask("outline", end, list(signals), width, _PART)
            done = engine.run(end, (_BLOCK,), rests=True)
            rows = np.concatenate((rows, np.frombuffer(data).reshape(-1, width + 1)))
            events = [*events, *done.events][:MAX_EVENTS]
            if len(rows) > MAX_POINTS:
                kept = outlined(rows[:, 0].astype(np.int64), rows[:, 1:], MAX_POINTS // 2)
                rows, every = rows[kept], 2 * every
            reason: Literal["over", "wait", "later"] = "later"
            if done.run_state is not None:
                reason = "over"
            elif done.is_resting:
                reason = "wait"
            errors += [one for one in done.diagnostics if one.severity is Severity.ERROR]
            causes = tuple(done.diagnostics if reason == "wait" else errors)
            ticks, *columns = (tuple(column) for column in rows.T.tolist())
            known = tuple(int(tick) for tick in ticks)
            yield Future(known, tuple(columns), tuple(events), reason, causes)
            if reason != "later" or done.tick >= first + MAX_AHEAD:
                return
    finally:
        engine.close()
