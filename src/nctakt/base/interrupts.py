# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM: two ways to end a command, with the same care.

A shell without job control starts background commands (``nohup … &``) with SIGINT ignored, so that
Ctrl-C ends only the foreground. It stays ignored; SIGTERM ends such a command.
"""

from __future__ import annotations

import ctypes
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

#: The handler of a signal, as for ``signal.signal``.
Handler = Callable[[int, FrameType | None], object]

#: The number of the request to the system that a process gets a signal when its parent ends.
_PR_SET_PDEATHSIG = 1

_BOTH = (signal.SIGINT, signal.SIGTERM)

#: The answers of this module to SIGTERM: signals belong to the process, and so does their count.
_terminations: list[int] = []


def terminations() -> int:
    """Return how often SIGTERM has come to a handler of this module."""
    return len(_terminations)


def numbers() -> list[signal.Signals]:
    """Return the signals that end a command: SIGTERM, and SIGINT unless it is ignored."""
    is_ignored = signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    return [signal.SIGTERM] if is_ignored else [signal.SIGTERM, signal.SIGINT]


@contextmanager
def handling(handler: Handler, *, only_termination: bool = False) -> Iterator[None]:
    """Answer Ctrl-C and SIGTERM with ``handler``; in another thread than the main one, nothing.

    ``only_termination``: only SIGTERM, and not if the process has an answer to it already.
    """

    def answer(number: int, frame: FrameType | None) -> object:
        if number == signal.SIGTERM:
            _terminations.append(number)
        return handler(number, frame)

    due = numbers()
    if only_termination:
        due = [signal.SIGTERM] if signal.getsignal(signal.SIGTERM) == signal.SIG_DFL else []
    before: dict[signal.Signals, signal._HANDLER] = {}
    try:
        for number in due:
            before[number] = signal.signal(number, answer)
    except ValueError:
        pass  # signals come to the main thread only
    try:
        yield
    finally:
        for number, own in before.items():
            signal.signal(number, own)


@contextmanager
def blocked_for_children() -> Iterator[None]:
    """Keep both from a process that starts meanwhile, until it calls ``ignore``.

    They may go to a whole group while it still imports modules: its parent answers them.
    """
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _BOTH)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def ignore() -> None:
    """Ignore both, in a process that its parent ends."""
    for number in _BOTH:
        signal.signal(number, signal.SIG_IGN)
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _BOTH)  # pending signals are dropped


def end_with_parent() -> None:
    """Have this process, a copy of another, killed when that ends, if the system can."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
