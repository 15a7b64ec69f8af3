# SPDX-License-Identifier: MIT
"""NC files as tests: each program with expectations in its comments is one test."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess
from nctakt.fmu.coupled import fmu_of
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.loading import load_plcs
from nctakt.project.run_settings import RunSettings
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.options import RunKeywords
from nctakt.testing.coverage import note_coverage, session_coverage
from nctakt.testing.expectations import Script, read_script
from nctakt.testing.language import rendered
from nctakt.testing.named_files import missing_files
from nctakt.testing.queries import NcRun
from nctakt.testing.settings_under_test import settings_of_test
from nctakt.testing.verdict import differences


class UnmetError(Exception):
    """The unmet expectations of a run as text."""


class NcFile(pytest.File):
    """A program with expectations."""

    def collect(self) -> Iterator[pytest.Item]:
        """Yield one test: the whole program."""
        yield NcItem.from_parent(self, name="expectations")


class NcItem(pytest.Item):
    """Runs a program and compares the run with its comments.

    ``funcargs``: it has no fixtures; plugins such as pytest-lsp look for them in each item.
    """

    def __init__(self, **words: Any) -> None:
        super().__init__(**words)
        self.funcargs: dict[str, object] = {}

    def runtest(self) -> None:
        """Run the program; raises ``UnmetError`` with all unmet expectations."""
        text = decode_text(self.path.read_bytes()).text
        try:
            script = read_script(Path(self._shown()), text)
            missing = [*missing_files(script, self.path.parent, FileAccess())]
            if missing:
                raise Failure(*missing)
            run = self._run(script, text)
            is_limited = script.until is not None
            wrong = list(
                differences(
                    run,
                    script.expectations,
                    self._shown(),
                    is_limited=is_limited,
                    folder=self.path.parent,
                )
            )
        except Failure as failure:
            raise UnmetError(rendered(failure.diagnostics)) from failure
        if wrong:
            raise UnmetError("\n\n".join(wrong))

    def _run(self, script: Script, text: str) -> NcRun:
        folder = self.path.parent
        settings = settings_of_test(self.config, self.path, script.named(folder))
        try:
            run = self._run_with(settings, script, text)
        except Failure as failure:
            raise script.placed(settings.placed(failure)) from failure
        note_coverage(self.config, run)
        return NcRun(run)

    def _run_with(self, settings: RunSettings, script: Script, text: str) -> Run:
        controller = Controller(load_machine(settings.machine))
        names = [*controller.default_signals]
        names += [name for name in self._signals(script) if f"{name}.ACS.ACT_POS" not in names]
        options: RunKeywords = {
            **script.options,
            "set": {**settings.values, **script.assignments},
            "at": script.stimuli,
            "until": settings.until,
            "plc": load_plcs(settings.plcs),
            "fmu": None if settings.fmu is None else fmu_of(settings.fmu),
            "signals": list(dict.fromkeys(names)),
            "why": session_coverage(self.config) is not None,
        }
        return controller.run(
            NcText(self._shown(), text),
            channels={
                number: [self.path.parent / program for program in programs]
                for number, programs in script.channels.items()
            },
            **options,
        )

    def _signals(self, script: Script) -> list[str]:
        return [
            expectation.name
            for expectation in script.expectations
            if expectation.kind in ("value", "log")
        ]

    def _shown(self) -> str:
        """Return the path of the file as pytest shows it."""
        try:
            return self.path.relative_to(self.config.rootpath).as_posix()
        except ValueError:
            return str(self.path)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the unmet expectations without a traceback."""
        if isinstance(excinfo.value, UnmetError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return the position and the name of the test."""
        return self.path, 0, self._shown()
