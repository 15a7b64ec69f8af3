# SPDX-License-Identifier: MIT
"""Runs of suites in processes of their own, each a copy (``fork``) of one that has read them.

In: the files with suites of a session, and how many may run at a time. Out: what has become of
their tests, when they are asked for it. Where there is no ``fork`` a file runs when it is asked.
"""

from __future__ import annotations

import multiprocessing
import threading
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor

import pytest

from nctakt.testing.suites import SuiteFile, SuiteRunResult

#: The files that copies of this process run.
_files: Sequence[SuiteFile] = ()


def run_ahead(session: pytest.Session, count: int) -> None:
    """Begin to run all files with suites that have tests to run, ``count`` at a time."""
    global _files  # noqa: PLW0603 - it is what a copy of this process finds
    found: dict[SuiteFile, None] = {}
    for item in session.items:
        file = item.getparent(SuiteFile)
        if file is not None:
            found[file] = None
    is_possible = "fork" in multiprocessing.get_all_start_methods()
    if len(found) < 2 or not is_possible or threading.active_count() > 1:
        return
    _files = list(found)
    executor = ProcessPoolExecutor(min(count, len(found)), multiprocessing.get_context("fork"))
    session.config.add_cleanup(lambda: executor.shutdown(cancel_futures=True))
    for number, file in enumerate(_files):
        file.ahead = executor.submit(_run, number)


def _run(number: int) -> SuiteRunResult:
    return _files[number].run()
