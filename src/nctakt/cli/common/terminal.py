# SPDX-License-Identifier: MIT
"""The output of a command: diagnostics, messages of programs, progress, text files.

Diagnostics and progress go to standard error, messages of programs to standard output. The progress
bar appears only on a terminal and only for longer work.
"""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Callable, Iterable
from types import FrameType
from typing import TYPE_CHECKING, Any, Self, TextIO

import click

from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.base.interrupts import handling
from nctakt.lists.format.times import time_stamp

if TYPE_CHECKING:
    from rich.progress import Progress

    from nctakt.results.run import ProgramMessage

#: Wall-clock time after which the progress bar appears, in seconds.
PATIENCE_S = 1.0

#: Wall-clock time between two updates of the progress bar, in seconds.
_REFRESH_S = 0.1

_COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.NOTE: None}


def print_diagnostics(
    diagnostics: Iterable[Diagnostic], language: Language, lowest: Severity = Severity.NOTE
) -> None:
    """Show the diagnostics of severity ``lowest`` and above on standard error."""
    for item in diagnostics:
        if item.severity >= lowest:
            headline, *rest = item.render(language).split("\n")
            complain(click.style(headline, fg=_COLOURS[item.severity]))
            for line in rest:
                complain(line)


def complain(line: str) -> None:
    """Show a line on standard error, if that accepts it."""
    try:
        click.echo(line, err=True)
    except OSError:
        silence(sys.stderr)


def complain_notes(error: BaseException) -> None:
    """Show the notes of an exception, or of its cause: truncated files."""
    for one in (error, error.__cause__):
        for note in getattr(one, "__notes__", ()):
            complain(note)


def silence(stream: TextIO) -> None:
    """Discard the buffered and all further output of a stream that refuses it."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def message_line(message: ProgramMessage) -> str:
    """Return a message of a program with its virtual time, on one line."""
    return f"{time_stamp(message.time_us)}  {_channel(message)}{_printable(message.text)}"


def saved_message(message: ProgramMessage) -> str:
    """Return a message for its file, with time stamp and line end unless it forbids them."""
    stamp = "" if message.is_exclusive else f"{time_stamp(message.time_us)}  {_channel(message)}"
    return f"{stamp}{_printable(message.text)}" + ("" if message.is_unbroken else "\n")


def _channel(message: ProgramMessage) -> str:
    """Return the prefix with the channel on a machine with several."""
    return f"CH{message.channel}  " if message.channel else ""


def _printable(text: str) -> str:
    return "".join(character if character.isprintable() else "·" for character in text)


def show_at_the_end(show: Callable[[TextIO], None]) -> None:
    """Let ``show`` write to standard output; a closed pipe is not an error of the run."""
    try:
        show(sys.stdout)
        sys.stdout.flush()
    except BrokenPipeError:  # nor may there be one when Python flushes at its end
        silence(sys.stdout)


class InterruptRequest:
    """Ctrl-C or SIGTERM during a run: ``check`` raises after the first one.

    So the run ends between two ticks, with all its records. A second one interrupts at once, even
    an endless loop in the user's PLC.
    """

    def __init__(self) -> None:
        self._requested = False
        self._handling = handling(self._on_interrupt)

    def __enter__(self) -> Self:
        self._handling.__enter__()
        return self

    def __exit__(self, *reason: Any) -> None:
        self._handling.__exit__(*reason)

    def check(self) -> None:
        """Raise ``KeyboardInterrupt`` if an end was asked for."""
        if self._requested:
            raise KeyboardInterrupt

    def _on_interrupt(self, _number: int, _frame: FrameType | None) -> None:
        self.check()
        self._requested = True


class ProgressBar:
    """The progress of a run, shown on a terminal from ``PATIENCE_S`` after its begin."""

    def __init__(self, file: TextIO | None = None) -> None:
        self._file = sys.stderr if file is None else file
        self._is_shown = self._file.isatty()
        self._next_s = time.monotonic() + PATIENCE_S
        self._progress: Progress | None = None

    def update(self, tick: int, limit: int | None) -> None:
        """Show that ``tick`` of at most ``limit`` ticks are done."""
        if not self._is_shown or time.monotonic() < self._next_s:
            return
        self._next_s = time.monotonic() + _REFRESH_S
        if self._progress is None:
            self._progress = self._begin(limit)
        self._progress.update(self._progress.task_ids[0], completed=tick, total=limit)

    def hide(self) -> None:
        """Remove the bar for other output; ``update`` shows it again."""
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
