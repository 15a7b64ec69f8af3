# SPDX-License-Identifier: MIT
"""What holds for all tests: the same examples in every run, and no test left out in silence."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from support import skips

# Messages are in the language of the locale where nothing names another one.
os.environ["LC_ALL"] = "C.UTF-8"

settings.register_profile("repeatable", derandomize=True, deadline=None, database=None)
settings.load_profile("repeatable")

if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    # A shell without job control has started the tests in the background: what they start would
    # ignore Ctrl-C, too. Under a handler of Python it begins with the system's default.
    signal.signal(signal.SIGINT, signal.default_int_handler)

#: How a file says that all its tests are slow.
_SLOW = "\npytestmark = pytest.mark.slow\n"


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave files of slow tests unread where none is wanted: reading them takes time, too."""
    if "not slow" not in config.option.markexpr or collection_path.suffix != ".py":
        return None
    return True if _SLOW in collection_path.read_text("utf-8") else None


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect no garbage among thousands of tests that live to the end, now or later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.enable()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the tests of the whole tree: some are long, and the last test is waited for."""
    here = Path(__file__).parent
    items.sort(key=lambda item: item.path.parent != here)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Fail tests that CI leaves out because something is missing."""
    report = yield
    skips.refuse(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Fail files of tests that CI leaves out because something is missing."""
    report = yield
    skips.refuse(report)
    return report


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """Say what could not be tried here, and how to get it."""
    if lines := skips.summary(terminalreporter.stats.get("skipped", ())):
        terminalreporter.section("not tried here")
        for line in lines:
            terminalreporter.write_line(line)
