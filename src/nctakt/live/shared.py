# SPDX-License-Identifier: MIT
"""One session that several browsers share: commands in, snapshots out.

In: commands of whoever has the pen, from any thread. Out: the latest snapshot, curves, marks and
lists, made by a thread of its own that listens to the session. Browsers look at them at their own
rates; none of them can hold the session or another browser up.
"""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from collections.abc import Callable, Sequence

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.live import view
from nctakt.live.view import Curves, LogRow, Snapshot, TimeMark
from nctakt.session.listening import Frame, Listener
from nctakt.session.session import Session

#: Where the page's inputs come from, on the tape.
PAGE = "page"

#: Frames a second that a session gives, and how long the thread waits for one.
RATE_HZ = 10.0
_WAIT_S = 0.2

#: Rows of the scope, and how many ticks of the past it shows.
SCOPE_ROWS = 500
SCOPE_TICKS = 200_000

#: Rows of the lists of messages and events.
MAX_LOG = 200

#: Opens the session; the argument: whether functions acknowledge themselves.
Opener = Callable[[bool], Session]


class SharedSession:
    """A session and what browsers show of it; raises ``Failure`` if it cannot be opened.

    ``acknowledges``: functions acknowledge themselves. ``pen``: who may command.
    """

    def __init__(self, opener: Opener, file: str, *, acknowledges: bool) -> None:
        self._opener = opener
        self._file = file
        self.acknowledges = acknowledges
        self.pen: str | None = None
        self._lock = threading.Lock()
        self._wake = threading.Event()
        self._is_closed = False
        self._serial = 0
        self._number = 0
        self.messages: deque[LogRow] = deque(maxlen=MAX_LOG)
        self.events: deque[LogRow] = deque(maxlen=MAX_LOG)
        self.diagnostics: list[Diagnostic] = []
        self._start(opener(acknowledges))
        self._thread = threading.Thread(target=self._watch, name="nctakt live", daemon=True)
        self._thread.start()

    def _start(self, session: Session) -> None:
        self.session = session
        self._serial += 1
        description = session.description
        self.lines: Sequence[str] = list(description.texts.get(self._file, ()))
        self.units = description.signals
        self.cycle_time_us = description.cycle_time_us
        self.axes = view.axes_of(self.units)
        self.scope = view.first_signals(self.units, self.lines)
        self.marks: list[TimeMark] = []
        self.messages.clear()
        self.events.clear()
        self.diagnostics = list(description.diagnostics)
        self.curves = Curves((), (), ())
        self._looked_at: tuple[object, ...] = ()
        self._branch = 1
        self.snapshot = self._look(None)

    # --- commands -------------------------------------------------------------------------------

    def do(self, command: Callable[[Session], object]) -> object:
        """Carry out a command on the session and return its answer; raises ``Failure``."""
        answer = command(self.session)
        self._wake.set()
        return answer

    def reopen(self, *, acknowledges: bool | None = None) -> None:
        """Run the programs again from the start; raises ``Failure``, and keeps the old session."""
        wished = self.acknowledges if acknowledges is None else acknowledges
        session = self._opener(wished)
        with self._lock:
            old, self.acknowledges = self.session, wished
            self._start(session)
        old.close()
        self._wake.set()

    def choose(self, signals: Sequence[str]) -> None:
        """Show these signals in the scope; unknown ones are left out."""
        self.scope = [name for name in signals if name in self.units]
        self._wake.set()

    def close(self) -> None:
        """End the session."""
        self._is_closed = True
        self._wake.set()
        self._thread.join()
        self.session.close()

    # --- the thread -----------------------------------------------------------------------------

    def _watch(self) -> None:
        while not self._is_closed:
            session = self.session
            with contextlib.suppress(Failure), session.listen(rate_hz=RATE_HZ) as listener:
                while not self._is_closed and session is self.session:
                    self._take(session, listener)

    def _take(self, session: Session, listener: Listener) -> None:
        """Take a frame, or what a command has changed; and the notices."""
        frame = listener.take(0.0 if self._wake.is_set() else _WAIT_S)
        was_woken = self._wake.is_set()
        self._wake.clear()
        notices = listener.notices()
        with self._lock:
            if session is not self.session:
                return
            self.messages += [
                LogRow("warning", 0, notice.text) for notice in notices if notice.kind == "refused"
            ]
            if frame is not None:
                self._note(frame)
            if frame is not None or was_woken or notices:
                self.snapshot = self._look(frame)

    def _note(self, frame: Frame) -> None:
        """Note the events and messages of a frame."""
        from_tick = None
        if frame.branch != self._branch:
            self._branch, from_tick = frame.branch, frame.tick
        self.marks = view.merged_marks(self.marks, view.time_marks(frame.events), from_tick)
        self.messages += map(view.message_row, frame.messages)
        self.events += map(view.event_row, frame.events)
        known = set(map(str, self.diagnostics))
        self.diagnostics += [one for one in frame.diagnostics if str(one) not in known]

    def _look(self, frame: Frame | None) -> Snapshot:
        """Return what there is to see of the session now."""
        session = self.session
        is_playing = session.is_playing
        latest = session.latest
        names = self._names()
        values = dict(zip(names, session.read(*names), strict=True))
        cycles = session.cycles()
        operands: dict[str, float] = {}
        if not is_playing:
            for name in view.operands_of(self.lines, cycles):
                with contextlib.suppress(Failure):
                    operands[name] = session.evaluate(name)
            self._look_back(session)
        else:
            self._append(latest.tick - 1, values)
        self._number += 1
        return Snapshot(
            self._number,
            self._serial,
            latest.tick,
            session.branches.get(session.branch, latest.tick),
            session.branch,
            is_playing,
            latest.run_state if frame is None else frame.run_state,
            values,
            latest.blocks,
            cycles,
            session.waiting(),
            operands,
        )

    def _names(self) -> list[str]:
        """Return the signals that are read at each look."""
        own = [name for name in view.PANEL if name in self.units]
        for axis in self.axes:
            own += [f"{axis}.ACS.ACT_POS", f"{axis}.PCS.DIST_TO_GO"]
        variables = [name for name in self.units if name.startswith("V.E.")]
        return list(dict.fromkeys([*own, *self._drawn(), *variables]))

    def _drawn(self) -> list[str]:
        """Return the signals of the scope and of the path."""
        path = [*self.plane, "PATH.RAPID"]
        return list(dict.fromkeys([*self.scope, *(name for name in path if name in self.units)]))

    @property
    def plane(self) -> tuple[str, ...]:
        """The signals of the first two axes; empty on a machine with fewer."""
        axes = self.axes[:2]
        return tuple(f"{axis}.ACS.ACT_POS" for axis in axes) if len(axes) == 2 else ()

    def _look_back(self, session: Session) -> None:
        """Take the curves from the past, in detail, unless they are there already."""
        names = tuple(self._drawn())
        end = session.branches[session.branch]
        key = (self._serial, session.branch, end, names)
        if key == self._looked_at or not names:
            return
        first = max(0, end - SCOPE_TICKS)
        every, cells = session.look(first, end, names, SCOPE_ROWS)
        flat = cells.tolist()
        width = len(names)
        ticks = [
            min(first + (row + 1) * every, end) - 1 if every > 1 else first + row
            for row in range(len(flat) // width)
        ]
        self.curves = Curves(names, ticks, [flat[index::width] for index in range(width)])
        self._looked_at = key

    def _append(self, tick: int, values: dict[str, float | bool | str]) -> None:
        """Add a point to the curves while the session plays."""
        names = tuple(self._drawn())
        old = self.curves
        if old.names != names:
            old = Curves(names, (), [() for _ in names])
        kept = sum(1 for at in old.ticks if at < tick)
        self.curves = Curves(
            names,
            [*old.ticks[:kept], tick][-2 * SCOPE_ROWS :],
            [
                [*column[:kept], float(values[name])][-2 * SCOPE_ROWS :]
                for name, column in zip(names, old.columns, strict=True)
            ],
        )
