# SPDX-License-Identifier: MIT
"""Runs of suites in separate processes, each a copy (``fork``) of one that has read them.

In: the files with suites of a session, and how many may run at a time. Out: the results of their
tests, on request. Without ``fork`` a file runs on request.
"""

from __future__ import annotations

import multiprocessing
import threading
from collections.abc import Sequence
from functools import partial
from multiprocessing.connection import Connection

import pytest

from nctakt.testing.suites import SuiteFile, SuiteRunResult


def run_ahead(session: pytest.Session, count: int) -> None:
    """Begin to run all files with suites that have tests to run, ``count`` at a time."""
    found: dict[SuiteFile, None] = {}
    for item in session.items:
        file = item.getparent(SuiteFile)
        if file is not None:
            found[file] = None
    is_possible = "fork" in multiprocessing.get_all_start_methods()
    if len(found) < 2 or not is_possible or threading.active_count() > 1:
        return
    files, context = list(found), multiprocessing.get_context("fork")
    for first in range(min(count, len(files))):
        own = files[first::count]
        answers, answered = context.Pipe(duplex=False)
        process = context.Process(target=_run_all, args=(own, answered), daemon=True)
        process.start()
        answered.close()
        session.config.add_cleanup(process.kill)
        copy = _Copy(own, answers)
        for file in own:
            file.ahead = partial(copy.result, file)


def _run_all(files: Sequence[SuiteFile], answered: Connection) -> None:
    for file in files:
        answered.send(file.run())


class _Copy:
    """A copy of this process, which answers for its files in their order."""

    def __init__(self, files: Sequence[SuiteFile], answers: Connection) -> None:
        self._waiting = list(files)
        self._answers = answers
        self._done: dict[SuiteFile, SuiteRunResult] = {}

    def result(self, file: SuiteFile) -> SuiteRunResult:
        """Wait for the results of a file; if the copy has died, it runs here."""
        while file not in self._done:
            try:
                self._done[self._waiting[0]] = self._answers.recv()
            except EOFError:
                return file.run()
            del self._waiting[0]
        return self._done.pop(file)
