# SPDX-License-Identifier: MIT
"""A program under the debugger: a session with its data, at a tick or running.

In: requests to continue, to step, to go back. Out: events of the protocol: stopped, output,
progress, terminated. A run continues in parts (``go_on``), so that requests are answered between
two of them.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.base.failure import Failure, error_text
from nctakt.debugger.breakpoints import Breakpoint, Breakpoints, moment_of
from nctakt.debugger.console import Console
from nctakt.debugger.disassembly import Disassembly
from nctakt.debugger.exceptions import ExceptionFilters, Raised
from nctakt.debugger.places import Places, StatementPlaces
from nctakt.debugger.plc_frames import PLC_THREAD
from nctakt.debugger.report import Report, SendEvent
from nctakt.debugger.scopes import Scopes
from nctakt.debugger.sources import Sources
from nctakt.debugger.values import Values
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import FILE_CHANGED_IN_RUN, RUN_IS_ON
from nctakt.results.instruction_tree import ListedCycle
from nctakt.results.summary import headline
from nctakt.results.trace.events import Event
from nctakt.session.cursor import FAULT
from nctakt.session.engine import StepResult
from nctakt.session.session import Session
from nctakt.session.stops import StopAt

#: How long a part of a run takes, in seconds, and its ticks at first and at most.
PART_S = 0.02
FIRST_TICKS, MAX_TICKS = 2_000, 2_000_000

#: Hits of breakpoints whose hit condition is not true that a search backward passes at most.
MAX_PASSED = 1000


@dataclass(slots=True)
class _Running:
    """A run in progress: the stops that end it besides breakpoints, the tick at which it ends."""

    reason: str
    thread: int
    until: Sequence[StopAt] = ()
    end: int | None = None
    begin_s: float = field(default_factory=time.monotonic)
    ticks: int = FIRST_TICKS


@dataclass(frozen=True, slots=True)
class Abilities:
    """Capabilities of the client."""

    has_progress: bool = False
    has_invalidated: bool = False


class Debuggee:
    """One session under the debugger; ``owns``: it is closed with the debugger.

    ``stops_at_end``: the run stays at its end; else the debugger ends.
    """

    def __init__(
        self,
        session: Session,
        breakpoints: Breakpoints,
        exceptions: ExceptionFilters,
        language: Language,
        send_event: SendEvent,
        abilities: Abilities,
        *,
        owns: bool,
        stops_at_end: bool,
    ) -> None:
        self.session = session
        self.breakpoints = breakpoints
        self.exceptions = exceptions
        self.language: Language = language
        self._send_event = send_event
        self._abilities = abilities
        self._owns = owns
        self._stops_at_end = stops_at_end
        own = session.description
        self.sources = Sources({**own.texts, **own.plc_texts})
        self.report = Report(
            session,
            self.sources,
            language,
            send_event,
            listens=not owns,
            has_progress=abilities.has_progress,
        )
        self.values = Values(session, session.inventory())
        self.disassembly = Disassembly(self.sources, self._listings)
        self.scopes = Scopes(session, self.values, self.sources, self.disassembly, language)
        self.console = Console(session, self.values, language)
        self._places: dict[str, Places | StatementPlaces] = {}
        self._owners: list[Breakpoint] = []
        self._stops: list[StopAt] = []
        self._seen: tuple[int, int, bool] = (session.tick, session.branch, False)
        self._running: _Running | None = None
        self._branch = session.branch
        self.raised: Raised | None = None
        self.is_over = False

    # --- its state ------------------------------------------------------------------------------

    @property
    def is_running(self) -> bool:
        """Whether it is running."""
        return self._running is not None

    def places(self, file: str) -> Places | StatementPlaces:
        """Return the places of a text where a breakpoint can be."""
        if file in self.session.description.plc_texts:
            return StatementPlaces(self.session.description.plc_lines.get(file, ()))
        if file not in self._places:
            lines = self.sources.lines(file)
            self._places[file] = Places(file, lines, self.values.inventory.cycles)
        return self._places[file]

    def _listings(self) -> dict[int, ListedCycle]:
        """Return the listings of the living cycles by the numbers of their threads."""
        return {
            self.scopes.number_of_cycle(name): listed
            for name, listed in self.session.instructions()
        }

    def check_stops(self, stops: Sequence[StopAt]) -> None:
        """Raise ``Failure`` with the mistakes of stops."""
        self.session.set_stops(*stops, only_check=True)

    def watch(self) -> None:
        """Watch the breakpoints and exceptions that there are now.

        The stops of somebody else's session stay; the debugger's are watched in addition.
        """
        stops, self._owners = self.breakpoints.stops()
        self._stops = [*stops, *self._exception_stops()]
        if self._owns:
            self.session.set_stops(*self._stops)

    def _exception_stops(self) -> list[StopAt]:
        """Return the stops at exceptions; without a PLC that can fail none at its faults."""
        has_plc = bool(self.session.description.plc_lines)
        return [stop for stop in self.exceptions.stops() if has_plc or stop.kind != "fault"]

    def check_paused(self, command: str) -> None:
        """Raise ``Failure`` (901226) while it is running."""
        if self._running is not None:
            raise Failure(diagnostic(RUN_IS_ON, command=command))

    def close(self) -> None:
        """End the session, unless it belongs to somebody else."""
        self._running = None
        if self._owns:
            self.session.close()
        else:
            self.report.close()

    # --- forward --------------------------------------------------------------------------------

    def run(self, thread: int = 1) -> None:
        """Run to a breakpoint or the end; from the end on, the debugger ends."""
        if self.session.is_over:
            self.finish()
            return
        self._start(_Running("breakpoint", thread))

    def step(self, thread: int, *, is_tick: bool, up: int | None) -> None:
        """Step to a block, or by a tick; in the PLC to a statement.

        ``up``: how many programs fewer may be open than now at the block, ``None``: any number of
        programs may be open.
        """
        if self.scopes.is_plc(thread):
            into = is_tick or up is None
            stop = self.session.sought("into" if into else "out" if up else "over")
            self._start(_Running("step", thread, [stop, FAULT]))
            return
        if is_tick or self.scopes.is_cycle(thread):
            self._start(_Running("step", thread, end=self.session.tick + 1))
            return
        depth = self.scopes.depth(thread)
        if up and up >= depth:
            self._start(_Running("step", thread))
            return
        max_depth = 0 if up is None else max(0, depth - up)
        stop = StopAt("block", channel=thread, is_of_channel=True, max_depth=max_depth)
        self._start(_Running("step", thread, [stop]))

    def run_until(self, stop: StopAt, thread: int) -> None:
        """Run to a stop."""
        self._start(_Running("goto", thread, [stop]))

    def _start(self, running: _Running) -> None:
        self.scopes.forget()
        self.raised = None
        self._running = running

    def go_on(self) -> None:
        """Run a part of the way; report the result."""
        running = self._running
        assert running is not None
        begin_s = time.monotonic()
        end = self.session.tick + running.ticks
        if running.end is not None:
            end = min(end, running.end)
        until = running.until if self._owns else [*self._stops, *running.until]
        others = 0 if self._owns else len(self.session.stops)
        try:
            done = self.session.run(
                Time(end, is_in_ticks=True), until=until, rests=running.end is None
            )
        except (Failure, RuntimeError) as error:
            text = error_text(error)
            self.report.output("stderr", f"{text}\n")
            self._stopped("pause", running.thread, text.partition("\n")[0])
            return
        took_s = time.monotonic() - begin_s
        running.ticks = (
            min(2 * running.ticks, MAX_TICKS) if took_s < PART_S else max(running.ticks // 2, 1)
        )
        self.report.news(done)
        if not self._ends(running, done, [hit - others for hit in done.hits]):
            self.report.progress(running.begin_s)

    def _ends(self, running: _Running, done: StepResult, hits: Sequence[int]) -> bool:
        """Stop where something is due; return whether it has stopped.

        ``hits``: the stops that have held: below 0 those of another one's session, then the
        debugger's, then those of the way.
        """
        tick = done.tick - 1
        own, watched = len(self._owners), len(self._stops)
        due = self._due([self._owners[hit] for hit in hits if 0 <= hit < own], tick, running)
        raised = None
        if any(own <= hit < watched for hit in hits):
            raised = self.exceptions.selected(done.events, tick)
        is_step = any(hit >= watched for hit in hits)
        if self.fault is not None and (is_step or self.exceptions.takes(self.fault)):
            self._stop_at_fault(self.fault)
        elif raised is not None:
            self._raise(raised, running.thread)
        elif due:
            self._stop_at(due, tick, running.thread)
        elif any(hit >= watched for hit in hits) or done.tick == running.end:
            self._stopped(running.reason, running.thread)
        elif any(hit < 0 for hit in hits):
            self._stopped("pause", running.thread)
        elif done.run_state is not None:
            self._end()
        elif done.is_resting:
            found = done.diagnostics[-1].headline(self.language)
            self._stopped("pause", running.thread, found)
        else:
            return False
        return True

    def _due(self, held: Sequence[Breakpoint], tick: int, running: _Running) -> list[Breakpoint]:
        """Return those breakpoints that held at which to stop; report the log points."""
        due = []
        for index, breakpoint_ in enumerate(held):
            if breakpoint_ in held[:index] or not breakpoint_.is_due(
                self._moment(tick, breakpoint_)
            ):
                continue
            if breakpoint_.log:
                self._log(breakpoint_, running.thread)
            else:
                due.append(breakpoint_)
        return due

    def _moment(self, tick: int, breakpoint_: Breakpoint) -> int:
        """Return the moment in which a breakpoint has held in a tick."""
        halted = self.session.statement
        is_statement = any(stop.kind == "statement" for stop in breakpoint_.stops)
        return moment_of(tick, halted.number if halted is not None and is_statement else 0)

    @property
    def fault(self) -> Diagnostic | None:
        """The fault at which the session is in its PLC, ``None`` elsewhere."""
        halted = self.session.statement
        return None if halted is None else halted.fault

    def _log(self, breakpoint_: Breakpoint, thread: int) -> None:
        """Report the text of a log point, with the values of the expressions in its braces."""
        channel = self.scopes.channel_of(thread) if not self.scopes.is_cycle(thread) else 1
        pieces = breakpoint_.log.split("{")
        text = pieces[0]
        for piece in pieces[1:]:
            expression, brace, rest = piece.partition("}")
            if not brace:
                text += "{" + piece
                continue
            try:
                text += self._logged(breakpoint_, expression, channel) + rest
            except Failure as failure:
                text += f"<{failure.diagnostics[0].text(self.language)}>{rest}"
        where: dict[str, Any] = {}
        if breakpoint_.line:
            where = {"line": breakpoint_.line, "source": self.sources.source(breakpoint_.file)}
        time = self.report.time(self.session.tick - 1)
        self.report.output("console", f"{time}  {text}\n", **where)

    def _logged(self, breakpoint_: Breakpoint, expression: str, channel: int) -> str:
        """Return the value of an expression of a log point."""
        if any(stop.kind == "statement" for stop in breakpoint_.stops):
            return self.session.value(expression).text
        return self.values.evaluate(expression, channel)

    # --- stopping -------------------------------------------------------------------------------

    def pause(self, thread: int) -> None:
        """Stop between two ticks; somebody else's playing session is paused."""
        if self._running is not None:
            self._stopped("pause", thread)
        elif self.session.is_playing:
            self.session.pause()
            self.attend()

    def _raise(self, raised: Raised, thread: int) -> None:
        self.raised = raised
        channel = max(raised.event.channel, 1)
        if raised.event.cycle:
            thread = self.scopes.thread_of_cycle(raised.event.cycle)
        elif not self.scopes.is_cycle(thread):
            thread = channel
        self._stopped("exception", thread, raised.title)

    def _stop_at_fault(self, fault: Diagnostic) -> None:
        self._stopped("exception", PLC_THREAD, fault.headline(self.language))

    def _stop_at(self, due: Sequence[Breakpoint], tick: int, thread: int) -> None:
        """Stop at breakpoints: in the thread in which the first of them has held."""
        kinds = {"function": "function breakpoint", "data": "data breakpoint"}
        reason = kinds.get(due[0].kind, "breakpoint")
        where = ", ".join(self._name(one) for one in due)
        thread = self._thread_of(due[0], thread)
        numbers = [one.number for one in due]
        self._stopped(reason, thread, f"{where}, {self.report.tick_word} {tick}", numbers)

    def _name(self, breakpoint_: Breakpoint) -> str:
        word = "Zeile" if self.language == "de" else "line"
        if breakpoint_.line:
            return f"{word} {breakpoint_.line}"
        return ", ".join(dict.fromkeys(stop.text for stop in breakpoint_.stops))

    def _thread_of(self, breakpoint_: Breakpoint, thread: int) -> int:
        """Return the thread in which a breakpoint has held: a realtime cycle, or a channel."""
        stop = breakpoint_.stops[0]
        if stop.kind == "statement":
            return PLC_THREAD
        if stop.kind in ("runs", "turns", "false", "fires", "cycle"):
            for cycle in self.session.cycles():
                lines = {cycle.span.line, *(branch.span.line for branch in cycle.branches)}
                if cycle.span.file == stop.file and stop.line in lines:
                    return self.scopes.thread_of_cycle(cycle.name)
        if stop.kind == "block":
            for channel, span in self.session.latest.blocks.items():
                if span.file == stop.file and span.line == stop.line:
                    return channel
        return 1 if self.scopes.is_cycle(thread) else thread

    def _stopped(
        self, reason: str, thread: int, text: str = "", numbers: Sequence[int] = ()
    ) -> None:
        self.report.end_progress()
        self._running = None
        self._note_seen()
        self.scopes.forget()
        body: dict[str, Any] = {"reason": reason, "threadId": thread, "allThreadsStopped": True}
        if text:
            body |= {"description": text, "text": text}
        if numbers:
            body["hitBreakpointIds"] = list(numbers)
        self.report_changed_files()
        self._send_event("stopped", body)

    def report_changed_files(self) -> None:
        """Report files that have changed since the run began."""
        changed = self.sources.newly_changed()
        self.report.diagnostics(
            [diagnostic(FILE_CHANGED_IN_RUN, span, file=Path(span.file).name) for span in changed]
        )

    def stop_on_entry(self) -> None:
        """Report that it is before its first tick."""
        self._stopped("entry", 1)

    def _end(self) -> None:
        """Stop at the end of the run, or end the debugger with it."""
        text = headline(self.session.result(), self.language, None)
        self.report.output("console", f"{text}\n")
        if self._stops_at_end:
            self._stopped("end", 1, text)
        else:
            self.finish()

    def finish(self) -> None:
        """End the debugger: report how the run has ended, and that it is over."""
        self.report.end_progress()
        self._running = None
        if not self.is_over:
            self.is_over = True
            state = self.session.latest.run_state
            self._send_event("exited", {"exitCode": 0 if state in ("ended", "limit", None) else 1})
            self._send_event("terminated", {})

    # --- somebody else's session ----------------------------------------------------------------

    def attend(self) -> None:
        """Report what others have done with the session since the last call."""
        session = self.session
        before, self._seen = self._seen, (session.tick, session.branch, session.is_playing)
        if session.is_playing and not before[2]:
            self.scopes.forget()
            self._send_event("continued", {"threadId": 1, "allThreadsContinued": True})
        self.report.report_latest()
        if before != self._seen and not session.is_playing:
            self._branch = session.branch
            self._stopped("pause", 1, self.console.position())

    def _note_seen(self) -> None:
        """Note where the session is, as the client knows it."""
        self._seen = self.session.tick, self.session.branch, self.session.is_playing

    # --- back -----------------------------------------------------------------------------------

    def step_back(self, thread: int, *, is_tick: bool) -> None:
        """Go back to the block before, past those of called programs, or by a tick."""
        self._travel(thread, lambda: self._step_back(thread, is_tick=is_tick))

    def _step_back(self, thread: int, *, is_tick: bool) -> None:
        if self.scopes.is_plc(thread):
            if self.session.back_to(self.session.sought("into" if is_tick else "over")) is None:
                self.session.go_to(0)
            self.report_travel("step", thread)
            return
        if is_tick or self.scopes.is_cycle(thread):
            self.session.back(1)
        else:
            depth = max(1, self.scopes.depth(thread))
            stop = StopAt("block", channel=thread, is_of_channel=True, max_depth=depth)
            if self.session.back_to(stop) is None:
                self.session.go_to(0)
        self.report_travel("step", thread)

    def restart_frame(self, channel: int, level: int) -> None:
        """Go back to where the block of a program began: the last one of no called program.

        ``level``: how many programs are open around that one.
        """
        self._travel(channel, lambda: self._restart_frame(channel, level))

    def _restart_frame(self, channel: int, level: int) -> None:
        stop = StopAt("block", channel=channel, is_of_channel=True, max_depth=level + 1)
        if not self._held([stop])[0] and self.session.back_to(stop) is None:
            self.session.go_to(0)
        self.report_travel("restart", channel)

    def reverse(self, thread: int) -> None:
        """Go back to the last breakpoint or exception, to the start without one."""
        self._travel(thread, lambda: self._reverse(thread))

    def _travel(self, thread: int, work: Callable[[], None]) -> None:
        """Go back; if that is interrupted or fails, report that and the position."""
        self.session.on_travel = partial(self.report.travel, time.monotonic())
        try:
            with self.session.together():
                work()
        except Failure as failure:
            self.report.diagnostics(failure.diagnostics)
            self.report_travel("pause", thread)
        finally:
            self.session.on_travel = None
            self.report.end_progress()

    def _reverse(self, thread: int) -> None:
        stopping = [one for one in self.breakpoints.all if not one.log and one.mistake is None]
        owners = [one for one in stopping for _ in one.stops]
        stops = [stop for one in stopping for stop in one.stops] + self._exception_stops()
        for _ in range(MAX_PASSED):
            done = self.session.back_to(*stops) if stops else None
            if done is None:
                break
            if self.session.statement is None:
                raised, due = self._due_here(stops, owners)
            else:
                held = _distinct(owners[hit] for hit in done.hits if hit < len(owners))
                raised, due = None, [one for one in held if self._is_due(one)]
            fault = self.fault if self.fault and self.exceptions.takes(self.fault) else None
            if raised is not None or due or fault is not None:
                self._note_branch()
                if fault is not None:
                    self._stop_at_fault(fault)
                elif raised is not None:
                    self._raise(raised, thread)
                else:
                    self._stop_at(due, self.session.tick - 1, thread)
                self._report_invalidated()
                return
        self.session.go_to(0)
        self.report_travel("entry", thread)

    def _is_due(self, breakpoint_: Breakpoint) -> bool:
        return breakpoint_.is_due(self._moment(self.session.tick - 1, breakpoint_))

    def _due_here(
        self, stops: Sequence[StopAt], owners: Sequence[Breakpoint]
    ) -> tuple[Raised | None, Sequence[Breakpoint]]:
        """Return the exception and the breakpoints that are due of what held in the last tick.

        ``owners``: the breakpoints of the first stops; the others are those of exceptions.
        """
        tick = self.session.tick - 1
        held, events = self._held(stops)
        raised = None
        if any(hit >= len(owners) for hit in held):
            raised = self.exceptions.selected(events, tick)
        own = _distinct(owners[hit] for hit in held if hit < len(owners))
        return raised, [one for one in own if self._is_due(one)]

    def _held(self, stops: Sequence[StopAt]) -> tuple[list[int], Sequence[Event]]:
        """Return which of some stops held in the last tick, which is run again, and its events."""
        session = self.session
        tick, others = session.tick, len(session.stops)
        if not tick:
            return [], ()
        session.back(1)
        done = session.run(Time(tick, is_in_ticks=True), until=stops)
        held = dict.fromkeys(hit - others for hit in done.hits if hit >= others)
        return list(held), done.events

    def report_travel(self, reason: str, thread: int) -> None:
        """Report that it has moved."""
        self._note_branch()
        self._stopped(reason, thread, self.console.position())
        self._report_invalidated()

    def _report_invalidated(self) -> None:
        """Make the client request everything again: it has moved."""
        if self._abilities.has_invalidated:
            self._send_event("invalidated", {"areas": ["all"]})

    def note_input(self) -> None:
        """Note that a value was set: in the past another branch of the tape begins there."""
        if self.session.branch != self._branch:
            self.breakpoints.forget_from(self.session.tick)
            self._note_branch()
            self._note_seen()
            self.report.output("console", f"{self.console.position()}\n")

    def _note_branch(self) -> None:
        self._branch = self.session.branch


def _distinct(breakpoints: Iterable[Breakpoint]) -> list[Breakpoint]:
    """Return each breakpoint once, in their order."""
    found: list[Breakpoint] = []
    for one in breakpoints:
        if not any(one is other for other in found):
            found.append(one)
    return found
