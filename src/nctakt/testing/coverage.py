# SPDX-License-Identifier: MIT
"""Branch coverage of realtime cycles over a test session.

In: the runs of the tests. Out: a table at the end of the session, and the requested files. A
program that a test holds as text does not count: it is not a program of the shop. Workers of
pytest-xdist send their coverage to the process that started them.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.files.output import write_file
from nctakt.messages import diagnostic
from nctakt.messages.commands.coverage import UNKNOWN_COVERAGE_FORMAT
from nctakt.results.coverage import Coverage
from nctakt.results.coverage_files import as_json, as_lcov, from_json
from nctakt.results.coverage_text import CoverageText
from nctakt.results.run import Run
from nctakt.testing.language import language_of_tests, rendered
from nctakt.testing.queries import TEXT_NAME

_NAME = "nctakt-coverage"
_WRITERS: dict[str, Callable[[Coverage], str]] = {
    ".json": as_json,
    ".info": as_lcov,
    ".txt": lambda coverage: CoverageText(coverage, "en").source(),
}


def session_coverage(config: pytest.Config) -> SessionCoverage | None:
    """Return the coverage of this session, ``None`` if it is not requested."""
    plugin = config.pluginmanager.get_plugin(_NAME)
    return plugin if isinstance(plugin, SessionCoverage) else None


def note_coverage(config: pytest.Config, run: Run) -> None:
    """Add the run of a test to the coverage of the session."""
    session = session_coverage(config)
    if session is not None and run.coverage is not None:
        session.add(run.coverage)


class SessionCoverage:
    """Gathers coverage; file names become relative to the root of the tests."""

    def __init__(self, config: pytest.Config, files: list[str]) -> None:
        self._root = config.rootpath
        self._is_worker = hasattr(config, "workeroutput")
        self._files = [Path(config.invocation_params.dir, file) for file in files]
        self._unwritten: list[str] = []
        self.coverage = Coverage()
        for file in self._files:
            if file.suffix not in _WRITERS:
                message = diagnostic(
                    UNKNOWN_COVERAGE_FORMAT, file=file, suffixes=", ".join(_WRITERS)
                )
                raise pytest.UsageError(message.render(language_of_tests()))

    def add(self, coverage: Coverage) -> None:
        """Add the coverage of a run."""
        self.coverage = self.coverage.plus(coverage.renamed(self._shown))

    def _shown(self, file: str) -> str | None:
        path = self._root / file
        if file == TEXT_NAME or not path.is_file():
            return None
        try:
            return path.resolve().relative_to(self._root.resolve()).as_posix()
        except ValueError:
            return path.as_posix()

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        """Add the coverage of a worker of pytest-xdist that has finished."""
        text = getattr(node, "workeroutput", {}).get(_NAME, "")
        self.coverage = self.coverage.plus(from_json(_NAME, text))

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Write the requested files, in a worker send the coverage instead."""
        if self._is_worker:
            output = session.config.workeroutput  # type: ignore[attr-defined]
            output[_NAME] = as_json(self.coverage)
            return
        for file in self._files:
            try:
                write_file(file, _WRITERS[file.suffix](self.coverage))
            except Failure as failure:
                self._unwritten.append(rendered(failure.diagnostics))
                session.exitstatus = pytest.ExitCode.USAGE_ERROR

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """Print the table."""
        terminalreporter.section("branches of realtime cycles", sep="-")
        terminalreporter.write(CoverageText(self.coverage, "en").table())
        for problem in self._unwritten:
            terminalreporter.write_line(problem)
