# SPDX-License-Identifier: MIT
"""Reports of a debugger besides stops: messages of programs, diagnostics, progress.

In: parts of a run; reports of somebody else's session while others run it. Out: events of the
protocol.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.debugger.sources import Sources
from nctakt.lists.format.times import time_stamp
from nctakt.results.run import ProgramMessage
from nctakt.session.engine import StepResult
from nctakt.session.listening import Listener
from nctakt.session.session import Session

#: A run reports its progress first after ``PROGRESS_S`` seconds, then at this interval.
PROGRESS_S, PROGRESS_AGAIN_S = 1.0, 0.5

#: Diagnostics that are kept to explain an error.
MAX_DIAGNOSTICS = 1000

#: How often a debugger gets reports of somebody else's playing session.
HEARD_HZ = 20.0

SendEvent = Callable[[str, dict[str, Any]], None]


class Report:
    """The output of one session; ``listens``: others run it, too."""

    def __init__(
        self,
        session: Session,
        sources: Sources,
        language: Language,
        send_event: SendEvent,
        *,
        listens: bool,
        has_progress: bool,
    ) -> None:
        self._session = session
        self._sources = sources
        self._language: Language = language
        self._send_event = send_event
        self._has_progress = has_progress
        self._kept: deque[Diagnostic] = deque(maxlen=MAX_DIAGNOSTICS)
        self._progress = 0
        self._progress_s = 0.0
        self._cycle_us = session.description.cycle_time_us
        self._heard_us = session.tick * self._cycle_us
        self._listener: Listener | None = None
        if listens:
            self._listener = Listener((), HEARD_HZ, wants_events=False)
            session.attach(self._listener)

    @property
    def kept(self) -> Sequence[Diagnostic]:
        """The latest diagnostics of the run."""
        return tuple(self._kept)

    @property
    def tick_word(self) -> str:
        """The word for a tick."""
        return "Takt" if self._language == "de" else "tick"

    def time(self, tick: int) -> str:
        """Return the time at which a tick begins."""
        return time_stamp(tick * self._cycle_us)

    def close(self) -> None:
        """Hear nothing more."""
        if self._listener is not None:
            self._session.detach(self._listener)

    def output(self, category: str, text: str, **where: Any) -> None:
        """Report a text."""
        self._send_event("output", {"category": category, "output": text, **where})

    def news(self, done: StepResult) -> None:
        """Report messages of programs and diagnostics of a part of the run."""
        if self._listener is None:
            self._messages(done.messages)
            self.diagnostics(done.diagnostics)
        else:
            self.report_latest()

    def report_latest(self) -> None:
        """Report the output of somebody else's session since, no matter who has run it.

        Reports are not repeated when somebody goes back.
        """
        frame = None if self._listener is None else self._listener.take()
        if frame is None:
            return
        before_us, self._heard_us = self._heard_us, frame.tick * self._cycle_us
        self._messages([item for item in frame.messages if item.time_us >= before_us])
        if self._heard_us > before_us:
            self.diagnostics(frame.diagnostics)

    def _messages(self, messages: Sequence[ProgramMessage]) -> None:
        for message in messages:
            channel = f"CH{message.channel} " if message.channel else ""
            self.output("stdout", f"{time_stamp(message.time_us)}  {channel}{message.text}\n")

    def diagnostics(self, found: Sequence[Diagnostic]) -> None:
        """Report diagnostics, and keep them to explain errors."""
        self._kept += found
        for item in found:
            where: dict[str, Any] = {}
            if item.span is not None and item.span.line:
                source = self._sources.source(item.span.file)
                where = {"line": item.span.line, "column": item.span.column, "source": source}
            category = "stderr" if item.severity is Severity.ERROR else "console"
            self.output(category, f"{item.render(self._language)}\n", **where)

    def progress(self, begin_s: float) -> None:
        """Report the progress of a long run that started at a time of ``time.monotonic``."""
        tick = self._session.tick
        self._report_progress(begin_s, f"{self.tick_word} {tick} = {self.time(tick)}")

    def travel(self, begin_s: float, done: int, whole: int) -> None:
        """Report the progress of a long travel back, in rerun ticks."""
        word = "Takte" if self._language == "de" else "ticks"
        self._report_progress(begin_s, f"{done:,} / {whole:,} {word}")

    def _report_progress(self, begin_s: float, text: str) -> None:
        now_s = time.monotonic()
        if not self._has_progress or now_s - begin_s < PROGRESS_S:
            return
        if now_s - self._progress_s < PROGRESS_AGAIN_S:
            return
        body = {"progressId": f"run-{self._progress}", "message": text}
        if self._progress_s:
            self._send_event("progressUpdate", body)
        else:
            title = "Lauf" if self._language == "de" else "Running"
            self._progress += 1
            body["progressId"] = f"run-{self._progress}"
            self._send_event("progressStart", {**body, "title": title, "cancellable": True})
        self._progress_s = now_s

    def end_progress(self) -> None:
        """Report that the run whose progress was reported is over."""
        if self._progress_s:
            self._progress_s = 0.0
            self._send_event("progressEnd", {"progressId": f"run-{self._progress}"})
