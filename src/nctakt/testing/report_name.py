# SPDX-License-Identifier: MIT
"""The name that pytest tells of a JUnit file: that of the file, not that of its unfinished copy."""

from __future__ import annotations

from pathlib import Path

import pytest


class ReportName:
    """A plugin for a run whose report is written as ``partial`` and named ``name`` in the end."""

    def __init__(self, partial: Path, name: Path) -> None:
        self._partial = str(partial.absolute())
        self._name = str(name.absolute())

    @pytest.hookimpl(tryfirst=True)
    def pytest_terminal_summary(self, config: pytest.Config) -> None:
        """Give the report, which is written by now, its name before pytest tells it."""
        for plugin in config.pluginmanager.get_plugins():
            if getattr(plugin, "logfile", None) == self._partial:
                vars(plugin)["logfile"] = self._name
