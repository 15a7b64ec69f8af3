# SPDX-License-Identifier: MIT
"""The pytest plugin: fixtures ``machine``, ``controller``, ``run_nc``; NC files as tests; coverage.

pytest loads it by its entry point in each session, so nothing of nctakt is imported before a test
needs it.
"""

from __future__ import annotations

import sys
from collections.abc import Generator, Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from nctakt.lists.machine.machine import Machine
    from nctakt.run.controller import Controller
    from nctakt.testing.queries import RunNc


#: Files that may hold suites in Structured Text.
_SUITE_SUFFIXES = (".plcproj", ".st", ".iecst", ".exp")

#: The key under which a worker of pytest-xdist learns whether all projects are trusted.
_TRUST = "nctakt_trusts_all"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the plugin's entries to pytest's configuration."""
    parser.addini(
        "nctakt_machine",
        "folder with the lists of the machine under test [the project's]",
        default="",
    )
    parser.addini(
        "nctakt_files",
        "patterns of the NC files whose expectations are tests",
        type="args",
        default=["*.nc"],
    )
    group = parser.getgroup("nctakt")
    group.addoption(
        "--nctakt-coverage",
        action="store_true",
        help="tell which branches of realtime cycles ran in the tests",
    )
    group.addoption(
        "--nctakt-processes",
        type=int,
        default=1,
        metavar="N",
        help="run the suites of up to N files at the same time",
    )
    group.addoption(
        "--nctakt-coverage-file",
        action="append",
        metavar="FILE",
        default=[],
        help="write that to FILE: .json (for nctakt coverage), .info (LCOV) or .txt (source)",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Start gathering coverage if it is requested, in each worker on its own.

    A worker trusts the same projects as the command that started it.
    """
    if getattr(config, "workerinput", {}).get(_TRUST):
        from nctakt.project.trust import trusting  # noqa: PLC0415 - see above

        trust = ExitStack()
        trust.enter_context(trusting())
        config.add_cleanup(trust.close)
    files = config.getoption("nctakt_coverage_file")
    if files or config.getoption("nctakt_coverage"):
        from nctakt.testing.coverage import SessionCoverage  # noqa: PLC0415 - see above

        config.pluginmanager.register(SessionCoverage(config, files), "nctakt-coverage")


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Inform a worker of pytest-xdist whether ``nctakt test`` trusts all projects."""
    trust = sys.modules.get("nctakt.project.trust")
    node.workerinput[_TRUST] = trust is not None and trust.trusts_all()


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Collect an NC file with at least one expectation in its comments, even a misspelt one.

    Of Structured Text: files with suites.
    """
    if file_path.suffix.lower() in _SUITE_SUFFIXES:
        from nctakt.plc.unit_tests import may_hold_suites  # noqa: PLC0415 - see above

        if not may_hold_suites(file_path, file_path.read_bytes()):
            return None
        from nctakt.testing.suites import SuiteFile  # noqa: PLC0415 - see above

        return SuiteFile.from_parent(parent, path=file_path)
    patterns = parent.config.getini("nctakt_files")
    if not any(file_path.match(pattern) for pattern in patterns):
        return None
    from nctakt.base.comment_keywords import has_expectation  # noqa: PLC0415 - see above

    if not has_expectation(file_path.read_bytes().decode("latin-1")):
        return None
    from nctakt.testing.collecting import NcFile  # noqa: PLC0415 - see above

    return NcFile.from_parent(parent, path=file_path)


def pytest_collection_finish(session: pytest.Session) -> None:
    """Begin to run the suites of several files at the same time, if that is asked for."""
    config = session.config
    count: int = config.getoption("nctakt_processes")
    if count < 2 or config.option.collectonly or hasattr(config, "workerinput"):
        return
    if "nctakt.testing.suites" in sys.modules:
        from nctakt.testing.suite_processes import run_ahead  # noqa: PLC0415 - see above

        run_ahead(session, count)


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    """Report the machines of tests that neither a test nor an entry of pytest names."""
    from nctakt.testing.settings_under_test import REPORTED_MACHINES  # noqa: PLC0415 - see above

    for text in config.stash.get(REPORTED_MACHINES, {}):
        terminalreporter.write_line(f"nctakt: {text}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Add nctakt's data to a report.

    A suite's test has its time on the machine, which JUnit has then, too; a test that fails the
    errors of its runs as nctakt shows them elsewhere.
    """
    report = yield
    if report.failed and call.when == "call":
        runner = getattr(item, "funcargs", {}).get("run_nc")
        report.sections += [("Errors of a run", text) for text in getattr(runner, "errors", ())]
    seconds = getattr(item, "virtual_seconds", None)
    if seconds is not None:
        report.duration = seconds if call.when == "call" else 0.0
        if isinstance(report.longrepr, tuple):  # why it is skipped, at its own place
            file, line, _ = item.reportinfo()
            report.longrepr = str(file), (line or 0) + 1, report.longrepr[2]
    return report


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """Show a test's wrong request to nctakt at the test's line, unless --full-trace."""
    try:
        return (yield)
    except Exception as error:
        if not _is_mistake_of_test(error):
            raise
        if not item.config.getoption("fulltrace"):
            _end_outside_of_nctakt(error)
        raise


def _is_mistake_of_test(error: Exception) -> bool:
    """Return whether nctakt has refused a test's request; it may not even be loaded."""
    for module, name in (
        ("nctakt.base.failure", "Failure"),
        ("nctakt.run.options", "UnknownOptionError"),
    ):
        loaded = sys.modules.get(module)
        if loaded is not None and isinstance(error, getattr(loaded, name)):
            return True
    return False


def _end_outside_of_nctakt(error: Exception) -> None:
    """Cut the end of a traceback within nctakt, and the causes of the error there."""
    error.__cause__, error.__suppress_context__ = None, True
    last, entry = None, error.__traceback__
    while entry is not None:
        if not entry.tb_frame.f_globals.get("__name__", "").startswith("nctakt."):
            last = entry
        entry = entry.tb_next
    if last is not None:
        last.tb_next = None


@pytest.fixture
def machine(request: pytest.FixtureRequest) -> Machine:
    """The machine under test: ``nctakt_machine``, else that of the project around the test."""
    from nctakt.base.failure import Failure  # noqa: PLC0415 - see above
    from nctakt.lists.machine.machine import load_machine  # noqa: PLC0415
    from nctakt.testing.settings_under_test import settings_of_test  # noqa: PLC0415

    try:
        return load_machine(settings_of_test(request.config, request.path).machine)
    except Failure as failure:
        pytest.fail(str(failure), pytrace=False)


@pytest.fixture
def controller(machine: Machine) -> Controller:
    """A controller of the machine after its start."""
    from nctakt.run.controller import Controller  # noqa: PLC0415 - see above

    return Controller(machine)


@pytest.fixture
def run_nc(controller: Controller, request: pytest.FixtureRequest) -> RunNc:
    """A function that runs a program: ``run_nc("part.nc")``, ``run_nc(text, plc=…)``."""
    from nctakt.testing.coverage import note_coverage, session_coverage  # noqa: PLC0415 - see above
    from nctakt.testing.queries import Runner  # noqa: PLC0415

    config = request.config
    why = session_coverage(config) is not None
    return Runner(controller, request.path.parent, partial(note_coverage, config), why=why)
