# SPDX-License-Identifier: MIT
"""One session that several browsers share: commands in, snapshots and increments out.

In: commands of the browser in control, from any thread. Out: the latest snapshot, curves, marks and
lists, made by a separate thread that listens to the session. Browsers read them at their own rates;
none of them can hold up the session or another browser.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.base.failure import Failure, error_text
from nctakt.comparison.overlay import LoggedCurve
from nctakt.live import view
from nctakt.live.ahead import Ahead, FutureOf
from nctakt.live.parts.explaining import Explainer, Moment, why_plc_text, why_text
from nctakt.live.plc_words import PlcFiles, PlcWords
from nctakt.live.run_log import RunLog
from nctakt.live.searching import Searches
from nctakt.live.shown_channel import ShownChannel
from nctakt.live.time_account import TimeAccounting, TimesShown
from nctakt.live.track import Entry, Growing, Shown, Track, blocks_of, marks_of
from nctakt.live.view import LogRow, Snapshot
from nctakt.session.listening import Frame, Listener
from nctakt.session.session import Session
from nctakt.session.stops import StopAt

#: Where the page's inputs come from, on the tape.
PAGE = "page"

#: Frames per second of a session, fewer at full speed, and how long the thread waits for one.
RATE_HZ = 20.0
FAST_RATE_HZ = 10.0
_WAIT_S = 0.2

#: How long nothing must have changed before the past is read, so that reading delays
#: no request, in seconds.
_REST_S = 0.1

#: Rows of the curves that are taken from the past at even distances, as many more where the path
#: bends, and how many of its ticks are shown.
SCOPE_ROWS, SCOPE_TICKS = 1000, 200_000

#: Opens the session of all programs, or of one; whether functions acknowledge themselves.
Opener = Callable[[str | None, bool], Session]


class SharedSession:
    """A session and the data that browsers show; raises ``Failure`` if it cannot be opened.

    ``channel``: the one that is shown, with its program. ``delay``: ticks to an automatic
    acknowledgement, 0: the CNC acknowledges at once, ``None``: a person does. ``in_control``: the
    browser that may command. ``stops``: those of users, as text. ``busy``: commands under way.
    ``branch_names``: those given by users. ``logged``: curves of a machine's log. ``plcs``: those
    of the session, whose ``plc_files`` may be saved meanwhile. ``transformed``: channels
    whose positions may be those of the tool's tip. ``watchers`` are called, from the
    session's thread, when a command or its end has changed the visible state.
    """

    def __init__(
        self,
        opener: Opener,
        file: str,
        *,
        acknowledges: bool,
        channel: int = 1,
        logged: Sequence[LoggedCurve] = (),
        plcs: Sequence[Path] = (),
        transformed: Collection[int] = (),
    ) -> None:
        self._transformed = transformed
        self.logged = {
            one.signal: {
                "ticks": one.ticks,
                "values": one.values,
                "isWhole": one.is_whole,
                "beyond": one.beyond,
            }
            for one in logged
        }
        self._opener = opener
        self.plc_files = PlcFiles(plcs)
        self.delay: int | None = 0 if acknowledges else None
        self.program: str | None = None
        self.in_control: str | None = None
        self.stops: list[str] = []
        self.busy = 0
        self._passing: StopAt | None = None
        self.lock = threading.Lock()
        self._wake = threading.Event()
        self._listener: Listener | None = None
        self.watchers: set[Callable[[], None]] = set()
        self._is_closed = self._has_rested = False
        self._serial = self._number = 0
        self.track = Track()
        self.explainer = Explainer(self._look_now)
        self.ahead = Ahead()
        self.searches = Searches()
        self._accounting: TimeAccounting | None = None
        self._start(self._opened(), channel, file)
        self._thread = threading.Thread(target=self._watch, name="nctakt live", daemon=True)
        self._thread.start()

    def _opened(self) -> Session:
        states = self.plc_files.states()
        session = self._opener(self.program, self.delay == 0)
        self.plc_files.note(states)
        session.acknowledge_after(self.delay or None)
        with contextlib.suppress(Failure):  # a stop of a line or a cycle that is gone
            session.set_stops(*self.stops)
        return session

    def _start(self, session: Session, channel: int, file: str) -> None:
        self.session = session
        self._serial += 1
        self.branch_names: dict[int, str] = {}
        self.description = session.description
        self.plc_words = PlcWords(self.description.plc_texts)
        self._show_channel(channel, file)
        self.track.clear(session.branch)
        self.log = RunLog(self.description.cycle_time_us)
        self.stopped_at: tuple[int, str] = (0, "")
        self._looked_at: tuple[object, ...] = ()
        self._passing = None
        self.snapshot = self.snapshot_of(None)

    def _show_channel(self, number: int, file: str) -> None:
        transformed = number in self._transformed
        self.channel = ShownChannel(self.description, number, file, is_transformed=transformed)
        logged = (name for name in self.logged if name in self.description.signals)
        self.scope = self.channel.first_signals(logged)
        self._show()

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """The findings in lists and programs, and in the run up to here, each once."""
        found = [*self.description.diagnostics, *self.log.diagnostics]
        return list({str(one): one for one in found}.values())

    @property
    def moment(self) -> Moment:
        """The last known position of the session."""
        return self._serial, self.snapshot.branch, self.snapshot.tick

    @property
    def future_subject(self) -> FutureOf:
        """The state that the future drawn by browsers depends on."""
        return FutureOf.of(self.session, self._serial, self.channel.drawn, self.channel.file)

    # --- commands -------------------------------------------------------------------------------

    def do(self, command: Callable[[Session], object]) -> object:
        """Carry out a command on the session and return its answer; raises ``Failure``."""
        self.busy += 1
        try:
            return command(self.session)
        finally:
            self.busy -= 1
            self._look_now()

    def go_to_next(self, stop: StopAt) -> None:
        """Run to the next such moment, or to a stop; the page shows the way, and may pause it."""
        with self.lock:  # the thread must not confuse this stop with the previous one
            self.session.pause()
            self.session.set_stops(*self.stops, stop)
            self.session.play(rests=True)
            self._passing = stop
        self._look_now()

    def set_stops(self, stops: Sequence[str]) -> None:
        """Let the session stop at these; raises ``Failure``, and keeps the old ones."""
        self.session.set_stops(*stops)
        self.stops = list(stops)
        self._look_now()

    def acknowledge_after(self, delay: int | None) -> None:
        """Let functions be acknowledged after this many ticks, by the CNC (0), or by a person."""
        present = float(delay != 0)
        count = self.description.channel_count
        names = ["HLI.PLC_PRESENT"] if count == 1 else []
        names = names or [f"CH{n}.HLI.PLC_PRESENT" for n in range(1, count + 1)]
        if (self.delay == 0) != (delay == 0):
            self.session.write(dict.fromkeys(names, present), PAGE)
        self.session.acknowledge_after(delay or None)
        self.delay = delay
        self._look_now()

    def reopen(self, program: str | None = None) -> None:
        """Run the programs again from the start, or one; raises ``Failure``, keeps the old run."""
        before = self.program
        self.program = program
        try:
            session = self._opened()
        except Failure:
            self.program = before
            raise
        with self.lock:
            old = self.session
            self._start(session, self.channel.number, self.channel.file)
        old.close()
        self._look_now()

    def choose(self, signals: Sequence[str]) -> None:
        """Show these signals in the scope; unknown ones are left out."""
        with self.lock:
            self.scope = [name for name in signals if name in self.description.signals]
            self._show()
        self._look_now()

    def look_at(self, channel: int, file: str) -> None:
        """Show this channel and this program."""
        with self.lock:
            self.track.clear()
            self._show_channel(channel, file)
            self._looked_at = ()
        self._look_now()

    def why(self, line: int, language: Language, file: str = "") -> str:
        """Return why the condition in a line of the program has its truth; raises ``Failure``.

        ``file``: one of the PLC; then the writes of the statement in its line.
        """
        with self.lock:
            moment, session = self.moment, self.session
        self.busy += 1  # the past is looked at afterwards
        try:
            report = self.explainer.report(moment, session)
        finally:
            self.busy -= 1
            self._look_now()
        if file:
            return why_plc_text(report, file, line, language)
        return why_text(report, line, language)

    def stretch(self, first: int, end: int) -> dict[str, Any]:
        """Return the curves of a stretch of the past in detail; raises ``Failure``."""
        shown = self.track.shown
        every, ticks, columns = self._past(self.session, first, end)
        return {
            "names": list(shown.signals),
            "first": first,
            "end": max(end, ticks[-1] if ticks else 0),
            "every": every,
            "ticks": ticks,
            "columns": columns,
        }

    def times(self, language: Language) -> TimesShown:
        """Return where the time of the branch went that is shown, as far as it is known."""
        with self.lock:
            work, session = self._accounting, self.session
            if work is None or work.session is not session or work.branch != session.branch:
                if work is not None:
                    work.end_it()
                self._accounting = work = TimeAccounting(session)
                self.searches.begin(work)
        return work.shown(language)

    def name_branch(self, number: int, name: str) -> None:
        """Give a branch of the tape a name, for all browsers."""
        self.branch_names[number] = name
        self._look_now()

    def close(self) -> None:
        """End the session."""
        self.leave()
        self.session.close()

    def leave(self) -> None:
        """Stop watching the session, which continues."""
        self._is_closed = True
        self._look_now()
        self._thread.join()
        self.explainer.close()
        self.ahead.close()
        self.searches.close()

    # --- the thread -----------------------------------------------------------------------------

    def _look_now(self) -> None:
        """Let the thread look at the session at once."""
        self._wake.set()
        if self._listener is not None:
            self._listener.wake()

    def _watch(self) -> None:
        while not self._is_closed:
            session = self.session
            try:
                with session.listen(rate_hz=RATE_HZ) as listener:
                    self._listener = listener
                    while not self._is_closed and session is self.session:
                        self._take(session, listener)
                        if listener.is_dropped:
                            break  # it would get nothing more; the next one will
            except (Failure, RuntimeError) as error:
                if session is self.session and not self._is_closed:
                    row = LogRow("error", 0, error_text(error))
                    if row not in self.log.messages[-1:]:
                        self.log.say(row)
                    self._wake.clear()
                    self._wake.wait(2.0)

    def _take(self, session: Session, listener: Listener) -> None:
        """Take a frame, or the changes of a command; and the notices."""
        is_fast = session.is_playing and session.speed is None
        listener.rate_hz = FAST_RATE_HZ if is_fast else RATE_HZ
        wait_s = _WAIT_S if self._has_rested else _REST_S
        frame = listener.take(0.0 if self._wake.is_set() else wait_s)
        was_woken = self._wake.is_set()
        if was_woken:
            self._wake.clear()
        notices = listener.notices()
        with self.lock:
            if session is not self.session:
                return
            for notice in notices:
                if notice.kind == "refused":
                    self.log.say(LogRow("warning", 0, notice.text))
                elif notice.kind == "stopped":
                    self.stopped_at = (notice.tick, self._names_of_stops(session))
            if frame is not None:
                self._note(frame)
            if self._passing is not None and not session.is_playing:
                self._passing = None
                with contextlib.suppress(Failure):
                    session.set_stops(*self.stops)
            is_new = frame is not None or was_woken or bool(notices)
            if is_new:
                self.snapshot = self.snapshot_of(frame)
        if was_woken or (is_new and not self.snapshot.is_playing):
            for watcher in list(self.watchers):
                watcher()
        if is_new:
            self._has_rested = self.snapshot.is_playing
        elif not self._has_rested and not self.busy:
            self._has_rested = True
            self._look_back(session)
        elif not session.is_playing:
            time.sleep(0.01)

    def _names_of_stops(self, session: Session) -> str:
        hits = [hit for hit in session.latest.hits if hit < len(self.stops)]
        return ", ".join(self.stops[hit] for hit in hits)

    def _note(self, frame: Frame) -> None:
        """Note the events and messages of a frame."""
        self.log.note(frame, self.session.fork)
        self._turn_to(frame.branch)
        self.track.note(frame.events, self.channel.number, self.channel.file)

    def _turn_to(self, branch: int) -> None:
        """Switch the track to a branch; parts cut off are fetched again."""
        if self.track.turn_to(branch, self.session.fork):
            self._looked_at = ()

    def snapshot_of(self, frame: Frame | None) -> Snapshot:
        """Return the visible state of the session."""
        session = self.session
        is_playing = session.is_playing
        names = self.channel.read_signals(self.track.shown.signals)
        branch = session.branch
        state_view = session.state_view(*names)
        latest = session.latest
        values = dict(zip(names, state_view.values, strict=True))
        self._turn_to(branch)
        is_known = branch == session.branch
        if is_known:  # the data read belongs to this branch
            self._append_truths(
                state_view.tick - 1, view.truths(state_view.cycles, self.channel.file)
            )
            if is_playing:
                self._append(state_view.tick - 1, values)
        self._number += 1
        snapshot = Snapshot(
            self._number,
            self._serial,
            state_view.tick,
            session.branches.get(session.branch, state_view.tick),
            session.branch,
            is_playing,
            latest.run_state if frame is None else frame.run_state,
            values,
            latest.blocks,
            latest.decoding,
            (*state_view.ended, *state_view.cycles),
            state_view.waiting,
            session.lateness[0],
            state_view.channels[self.channel.number - 1].awaited,
            None if is_playing else session.statement,
        )
        is_fast = is_playing and session.speed is None
        if self.channel.path and not is_fast:  # else it would be the present before it is drawn
            self.ahead.request(self.future_subject, session)
        if is_playing:
            self.explainer.forget_request()
        else:
            self.explainer.request((self._serial, snapshot.branch, snapshot.tick), session)
        return snapshot

    # --- curves ---------------------------------------------------------------------------------

    def _show(self) -> None:
        """Let the track have the columns of the scope and of the path."""
        path = dict.fromkeys(self.channel.drawn)
        hidden = [
            name for name in path if name in self.description.signals and name not in self.scope
        ]
        signals = (*self.scope, *hidden)
        units = tuple(self.description.signals[name] for name in signals)
        self.track.show(Shown(self.channel.conditions, signals, units, len(hidden)))
        self._looked_at = ()

    def _past(
        self, session: Session, first: int, end: int
    ) -> tuple[int, list[int], list[list[float | None]]]:
        """Return the distance of rows, their ticks and the columns of a stretch of the past."""
        names = self.track.shown.signals
        if not names:
            return 1, [], []
        every, cells = session.look(first, end, names, SCOPE_ROWS)
        flat = [view.rounded(cell) for cell in cells.tolist()]
        width = len(names)
        last = min(end, session.branches[session.branch]) - 1
        ticks = [min(first + (row + 1) * every - 1, last) for row in range(len(flat) // width)]
        return every, ticks, [flat[index::width] for index in range(width)]

    def _outline(
        self, session: Session, first: int, end: int
    ) -> tuple[list[int], list[list[float | None]]]:
        """Return ticks that show the path of a stretch of the past, and the columns after them."""
        names, paths = self.track.shown.signals, self.channel.drawn
        if not names:
            return [], []
        followed = [name for name in names if name in paths]
        asked = [*followed, *(name for name in names if name not in paths)]
        ticks, cells = session.outline(first, end, asked, len(followed), 2 * SCOPE_ROWS)
        columns = dict(zip(asked, cells, strict=True))
        return ticks, [[view.rounded(cell) for cell in columns[name]] for name in names]

    def _look_back(self, session: Session) -> None:
        """Fetch lists, curves, marks and blocks from the past, unless they are already there.

        That takes a while, but delays nothing: the state of the session is shown first.
        """
        log = self.log
        if log.lacks_some:
            with contextlib.suppress(Failure):  # the next look tries it again
                log.complete(session.happened)
                self._look_now()
        key, end = self._past_key(session), session.branches[session.branch]
        if key == self._looked_at or end == 0:
            return
        first = max(0, end - SCOPE_TICKS)
        ticks, columns = self._outline(session, first, end)
        rows = zip(*columns, strict=True) if columns else ((),) * len(ticks)
        events, left_out = session.events(first, end)
        with self.lock:
            if session is not self.session or key != self._past_key(session):
                return  # something else is shown meanwhile
            self.track.rows.replace((tick, *row) for tick, row in zip(ticks, rows, strict=True))
            if not left_out:
                self.track.marks.replace(marks_of(events, self.channel.file))
                self.track.blocks.replace(blocks_of(events, self.channel.number, self.channel.file))
            self._looked_at = key

    def _past_key(self, session: Session) -> tuple[object, ...]:
        """Return the state that the curves of the past depend on."""
        branch = session.branch
        end = session.branches[branch]
        return self._serial, branch, end, self.track.shown, self.channel.number, self.channel.file

    def _append(self, tick: int, values: dict[str, float | bool | str]) -> None:
        """Add a row while the session plays, unless it plays in a past that is known."""
        cells = [view.rounded(float(values[name])) for name in self.track.shown.signals]
        _add_newer(self.track.rows, (tick, *cells))

    def _append_truths(self, tick: int, truths: dict[int, bool | None]) -> None:
        """Add a sample of the lanes; a stretch that is explained replaces them."""
        states = [None if (truth := truths.get(one.line)) is None else int(truth)
                  for one in self.track.shown.conditions]  # fmt: skip
        _add_newer(self.track.lanes, (tick, *states))


def _add_newer(part: Growing, entry: Entry) -> None:
    """Add an entry unless its tick is known already."""
    known = part.newest()
    if entry[0] >= 0 and not (known and entry[0] <= known[0][0]):
        part.add([entry])
