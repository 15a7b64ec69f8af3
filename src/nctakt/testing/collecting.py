# SPDX-License-Identifier: MIT
"""NC files as tests: each program with expectations in its comments is one test."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.plc import load_plc
from nctakt.run.controller import Controller, NcText
from nctakt.testing.coverage import note_coverage, session_coverage
from nctakt.testing.expectations import Script, read_script
from nctakt.testing.queries import NcRun, configured_machine, values_before
from nctakt.testing.verdict import differences


class UnmetError(Exception):
    """What is wrong with a run, ready to be shown."""


class NcFile(pytest.File):
    """A program with expectations."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test: the whole program."""
        yield NcItem.from_parent(self, name="expectations")


class NcItem(pytest.Item):
    """Runs a program and compares the run with its comments."""

    def runtest(self) -> None:
        """Raise ``UnmetError`` with all that is wrong."""
        text = decode_text(self.path.read_bytes()).text
        try:
            script = read_script(self.path, text)
            run = self._run(script, text)
            wrong = list(differences(run, script.expectations, self._shown()))
        except Failure as failure:
            raise UnmetError("\n".join(one.render() for one in failure.diagnostics)) from failure
        if wrong:
            raise UnmetError("\n\n".join(wrong))

    def _run(self, script: Script, text: str) -> NcRun:
        folder = self.path.parent
        controller = Controller(self._machine(script))
        names = [*controller.default_signals]
        names += [name for name in self._signals(script) if f"{name}.ACS.ACT_POS" not in names]
        start = values_before(controller, dict.fromkeys(names), script.assignments)
        run = controller.run(
            NcText(self._shown(), text),
            set=script.assignments,
            at=script.stimuli,
            until=script.until,
            after=script.after,
            plc=None if script.plc is None else load_plc(folder / script.plc),
            wait_for_start=script.waits_for_start,
            signals=list(start),
            why=session_coverage(self.config) is not None,
        )
        note_coverage(self.config, run)
        return NcRun(run, start)

    def _signals(self, script: Script) -> list[str]:
        return [one.name for one in script.expectations if one.kind == "value"]

    def _machine(self, script: Script) -> Machine:
        if script.machine is None:
            return configured_machine(self.config)
        return load_machine(self.path.parent / script.machine)

    def _shown(self) -> str:
        """The file as pytest names it."""
        try:
            return self.path.relative_to(self.config.rootpath).as_posix()
        except ValueError:
            return str(self.path)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """What is wrong, without the way through our code."""
        if isinstance(excinfo.value, UnmetError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Where the test stands."""
        return self.path, 0, self._shown()
