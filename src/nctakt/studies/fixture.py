# SPDX-License-Identifier: MIT
"""The pytest fixture ``study``: a study as a test, with its verdict.

    def test_every_stop_comes_in_time(study):
        assert study("stop.toml")

pytest loads it by its entry point, so nothing of nctakt is imported before a test needs it.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import pytest

if TYPE_CHECKING:
    from nctakt.studies.study import StudyResult


class RunStudy(Protocol):
    """The fixture ``study`` of a test, for its annotation.

    >>> def test_every_stop_comes_in_time(study: RunStudy) -> None:
    ...     assert study("stop.toml")
    """

    def __call__(
        self, file: str | Path | None = None, *, processes: int = 1, **entries: Any
    ) -> StudyResult:
        """Make the runs of a plan: a file next to the test, or its entries."""


@pytest.fixture
def study(request: pytest.FixtureRequest) -> RunStudy:
    """A function that makes the runs of a plan: a file next to the test, or its entries."""
    from nctakt.project.run_settings import DEFAULT_PLC  # noqa: PLC0415 - see above
    from nctakt.studies.study import Study  # noqa: PLC0415
    from nctakt.testing.settings_under_test import machine_of_configuration  # noqa: PLC0415

    folder = request.path.parent

    def make(file: str | Path | None = None, *, processes: int = 1, **entries: Any) -> StudyResult:
        for key in ("program", "plc"):
            value = entries.get(key)
            if isinstance(value, list | tuple):
                entries[key] = [str(folder / one) for one in value]
            elif isinstance(value, str | Path) and value != DEFAULT_PLC:
                entries[key] = str(folder / value)
        machine = machine_of_configuration(request.config)
        plan = Study(None if file is None else folder / file, default_machine=machine, **entries)
        return plan.run(processes=processes)

    return make
