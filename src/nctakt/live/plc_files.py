# SPDX-License-Identifier: MIT
"""The files of the session's PLCs: whether one has been saved since the run began.

In: the files that name the PLCs. Out: yes or no; nothing of a file is executed. For a project, the
files that it lists and its own file count; for a PLC in Python its file.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import Collector
from nctakt.st.files.project import read_project
from nctakt.st.files.suffixes import PROJECT_SUFFIXES
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources

#: Files that are looked at, at most.
_MAX_FILES = 5000


class PlcFiles:
    """The files of PLCs with their states when the run began."""

    def __init__(self, plcs: Sequence[Path] = ()) -> None:
        self._plcs = plcs
        self._states: dict[Path, tuple[int, int]] = {}

    def states(self) -> dict[Path, tuple[int, int]]:
        """Return the present state of the files."""
        return {path: _state(path) for path in self._files()[:_MAX_FILES]}

    def note(self, states: dict[Path, tuple[int, int]]) -> None:
        """Note with which files a run has begun."""
        self._states = states

    @property
    def are_replaced(self) -> bool:
        """Whether a file is another than when the run began, or is gone."""
        return any(_state(path) != state for path, state in self._states.items())

    def _files(self) -> list[Path]:
        found: list[Path] = []
        for plc in self._plcs:
            found.append(plc)
            if plc.suffix.lower() in PROJECT_SUFFIXES:
                reporter = Reporter(Sources(), Collector())
                for project in read_project(plc, _bytes, reporter):
                    found += project.files
        return found


def _bytes(path: Path) -> bytes | None:
    try:
        return FileAccess().read_bytes(path)
    except Failure:
        return None


def _state(path: Path) -> tuple[int, int]:
    try:
        state = path.stat()
    except OSError:
        return 0, 0
    return state.st_mtime_ns, state.st_size
