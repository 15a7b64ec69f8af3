# SPDX-License-Identifier: MIT
"""Suites in Structured Text as tests: each test of a suite is one test of pytest (ST-904).

The suites of a file run together, once in a process, when the first of their tests is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import StructuredPlc
from nctakt.plc.unit_tests import (
    OTHER_TESTS,
    NamedTest,
    Outcome,
    Suite,
    SuiteResults,
    load_suites,
    run_suites,
    suites_of,
)
from nctakt.project.run_settings import Named, RunSettings
from nctakt.testing.collecting import UnmetError
from nctakt.testing.coverage import session_coverage
from nctakt.testing.junit import SUITE
from nctakt.testing.language import language_of_tests, rendered
from nctakt.testing.settings_under_test import settings_of_test

if TYPE_CHECKING:
    from nctakt.results.coverage import Coverage

_NEVER_OPENED = Text("the suite never opens this test", "die Suite öffnet diesen Test nie")
_DISABLED = Text("disabled", "abgeschaltet")


class SuiteRunResult(NamedTuple):
    """The results of the tests of a file, or why there was no run; the counts."""

    found: SuiteResults | None
    coverage: Coverage | None = None
    failure: str = ""


class SuiteFile(pytest.File):
    """A file with suites: a project, or a text that is checked with the project's PLC.

    ``ahead``: waits for its run, where another process has begun it.
    """

    ahead: Callable[[], SuiteRunResult] | None = None

    def collect(self) -> Iterator[pytest.Collector]:
        """Yield the suites of the file; raises ``CollectError`` with all its mistakes."""
        try:
            self._plc, self._settings = self._load()
        except Failure as failure:
            raise self.CollectError(rendered(failure.diagnostics)) from failure
        self._found: SuiteResults | None = None
        self._suites = suites_of(self._plc.program)
        for suite in self._suites:
            yield SuiteNode.from_parent(self, name=suite.path, suite=suite)

    def _load(self) -> tuple[StructuredPlc, RunSettings]:
        settings = settings_of_test(self.config, self.path, Named(has_plc=True))
        own = None if settings.project is None else settings.project.plc
        return load_suites(self.path, own), settings

    def results(self) -> SuiteResults:
        """Return the results of all tests; the first call runs them, and releases the PLC.

        pytest collects garbage several times at its end, among all remaining objects. Raises
        ``UnmetError`` with the reason if the run cannot start.
        """
        if self._found is None:
            done = self.run() if self.ahead is None else self.ahead()
            if done.found is None:
                raise UnmetError(done.failure)
            session = session_coverage(self.config)
            if session is not None and done.coverage is not None:
                session.add(replace(done.coverage, runs=1))
            self._found = done.found
            del self._plc, self._suites
        return self._found

    def run(self) -> SuiteRunResult:
        """Run the suites."""
        if session_coverage(self.config) is not None:
            self._plc.count_branches()
        until, language = self._settings.until, language_of_tests()
        try:
            machine = load_machine(self._settings.machine)
            found = run_suites(self._plc, machine, until, language, self._suites)
        except Failure as failure:
            return SuiteRunResult(None, failure=rendered(failure.diagnostics))
        return SuiteRunResult(found, self._plc.coverage())


class SuiteNode(pytest.Collector):
    """An instance of a suite."""

    def __init__(self, suite: Suite, **words: Any) -> None:
        super().__init__(**words)
        self.suite = suite

    def collect(self) -> Iterator[pytest.Item]:
        """Yield its tests in the order of the text."""
        for test in self.suite.tests.values():
            yield SuiteItem.from_parent(self, name=test.name, test=test)
        if self.suite.has_others:
            yield SuiteItem.from_parent(self, name=OTHER_TESTS, test=None)


class SuiteItem(pytest.Item):
    """One test of a suite; without ``test`` all those whose names are not in the text.

    ``funcargs``: it has no fixtures; plugins such as pytest-lsp look for them in each item.
    ``virtual_seconds``: how long the test takes on the machine, once it has run.
    """

    def __init__(self, test: NamedTest | None, **words: Any) -> None:
        super().__init__(**words)
        self.funcargs: dict[str, object] = {}
        self.virtual_seconds = 0.0
        self._test = test
        self.user_properties.append((SUITE, self._suite.path))

    @property
    def _suite(self) -> Suite:
        assert isinstance(self.parent, SuiteNode)
        return self.parent.suite

    def runtest(self) -> None:
        """Look up the result of the test; raises ``UnmetError`` with its failures."""
        assert self.parent is not None and isinstance(self.parent.parent, SuiteFile)
        results = self.parent.parent.results()
        outcomes = self._outcomes(results.outcomes.get(self._suite.path, {}))
        self.virtual_seconds = sum(one.duration_us for one in outcomes) / 1e6
        problems = [*results.problems.get(self._suite.path, [])]
        problems += [problem for one in outcomes for problem in one.problems]
        if problems:
            root = f"{self.config.rootpath.as_posix()}/"
            raise UnmetError("\n\n".join(problems).replace(root, ""))
        if self._test is not None and not outcomes:
            pytest.skip(_NEVER_OPENED.get(language_of_tests()))
        if outcomes and all(one.is_disabled for one in outcomes):
            pytest.skip(_DISABLED.get(language_of_tests()))

    def _outcomes(self, by_name: dict[str, Outcome]) -> list[Outcome]:
        if self._test is None:
            return [one for name, one in by_name.items() if name not in self._suite.tests]
        return [by_name[self._test.name]] if self._test.name in by_name else []

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the failure without a traceback."""
        if isinstance(excinfo.value, UnmetError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """Return the position and the name of the test."""
        title = f"{self._suite.path}: {self.name}"
        if self._test is None:
            return self.path, None, title
        return Path(self._test.span.file), self._test.span.line - 1, title
