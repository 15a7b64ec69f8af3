# SPDX-License-Identifier: MIT
"""What a command shows and writes: diagnostics, messages of programs, progress, text files.

Diagnostics and progress go to standard error, what programs say to standard output. The progress
bar appears only on a terminal and only for work that takes a while.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable
from types import FrameType
from typing import TYPE_CHECKING, Self, TextIO

import click

from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.lists.format.times import time_stamp

if TYPE_CHECKING:
    from rich.progress import Progress

    from nctakt.results.run import ProgramMessage

#: Seconds of wall-clock time after which the progress bar appears.
PATIENCE_S = 1.0

#: Seconds of wall-clock time between two looks of the progress bar.
_REFRESH_S = 0.1

_COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.NOTE: None}


def print_diagnostics(
    diagnostics: Iterable[Diagnostic], language: Language, lowest: Severity = Severity.NOTE
) -> None:
    """Show the diagnostics of severity ``lowest`` and above on standard error."""
    for found in diagnostics:
        if found.severity >= lowest:
            headline, *rest = found.render(language).split("\n")
            complain(click.style(headline, fg=_COLOURS[found.severity]))
            for line in rest:
                complain(line)


def complain(line: str) -> None:
    """Show a line on standard error; where that takes nothing, nobody can be told."""
    try:
        click.echo(line, err=True)
    except OSError:
        silence(sys.stderr)


def silence(stream: TextIO) -> None:
    """Let what a stream still holds, and what comes, go nowhere: it takes no more."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def message_line(message: ProgramMessage) -> str:
    """A message of a program with its virtual time, on one line."""
    return f"{time_stamp(message.time_us)}  {_channel(message)}{_printable(message.text)}"


def saved_message(message: ProgramMessage) -> str:
    """What the message file gets: time stamp and line end unless the message forbids them."""
    stamp = "" if message.is_exclusive else f"{time_stamp(message.time_us)}  {_channel(message)}"
    return f"{stamp}{_printable(message.text)}" + ("" if message.is_unbroken else "\n")


def _channel(message: ProgramMessage) -> str:
    """Which channel says it, where there is more than one."""
    return f"CH{message.channel}  " if message.channel else ""


def _printable(text: str) -> str:
    return "".join(character if character.isprintable() else "·" for character in text)


def show_at_the_end(show: Callable[[TextIO], None]) -> None:
    """Let ``show`` write to standard output; nobody reading on there is no error of the run."""
    try:
        show(sys.stdout)
        sys.stdout.flush()
    except BrokenPipeError:  # nor may it become one when Python flushes at its end
        silence(sys.stdout)


class InterruptRequest:
    """Ctrl-C while a run goes on: the first one asks for its end, which ``check`` then brings.

    So the run ends between two ticks, with all that it has recorded. A second Ctrl-C interrupts at
    once: what the first one waits for may be an endless loop in the user's PLC.
    """

    def __init__(self) -> None:
        self._requested = False

    def __enter__(self) -> Self:
        if threading.current_thread() is threading.main_thread():
            self._before = signal.signal(signal.SIGINT, self._on_interrupt)
        return self

    def __exit__(self, *_: object) -> None:
        if threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGINT, self._before)

    def check(self) -> None:
        """Raise ``KeyboardInterrupt`` when Ctrl-C was pressed."""
        if self._requested:
            raise KeyboardInterrupt

    def _on_interrupt(self, _number: int, _frame: FrameType | None) -> None:
        self.check()
        self._requested = True


class ProgressBar:
    """How far a run has come, on a terminal, from ``PATIENCE_S`` after its begin."""

    def __init__(self, file: TextIO | None = None) -> None:
        self._file = sys.stderr if file is None else file
        self._wanted = self._file.isatty()
        self._next_s = time.monotonic() + PATIENCE_S
        self._progress: Progress | None = None

    def update(self, tick: int, limit: int | None) -> None:
        """``tick`` ticks of at most ``limit`` are done."""
        if not self._wanted or time.monotonic() < self._next_s:
            return
        self._next_s = time.monotonic() + _REFRESH_S
        if self._progress is None:
            self._progress = self._begin(limit)
        self._progress.update(self._progress.task_ids[0], completed=tick, total=limit)

    def hide(self) -> None:
        """Take the bar away, since something else is to be shown; ``update`` brings it back."""
        if self._progress is not None:
            self._progress.stop()
            self._progress = None

    def _begin(self, limit: int | None) -> Progress:
        from rich.console import Console  # noqa: PLC0415 - short runs do not load it
        from rich.progress import Progress  # noqa: PLC0415

        console = Console(file=self._file)
        progress = Progress(
            console=console, transient=True, redirect_stdout=False, redirect_stderr=False
        )
        progress.add_task("", total=limit)
        progress.start()
        return progress
