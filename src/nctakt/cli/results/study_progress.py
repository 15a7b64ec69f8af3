# SPDX-License-Identifier: MIT
"""The progress of a study on a terminal: rate, failed runs so far, remaining time."""

from __future__ import annotations

import time

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.base.failure import Failure
from nctakt.cli.common.terminal import complain
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import RUN_CRASHED, STUDY_TOO_LARGE
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.study import Study

#: Estimated time from which on a study has to be confirmed, in seconds.
LONG_S = 3600.0

#: Runs beyond which they are not counted.
MAX_COUNTED = 10**30

_LINES = {
    "en": "{} of {} runs, {} per second, {} failed, {} left",
    "de": "{0} von {1} Läufen, {2} je Sekunde, {3} nicht bestanden, noch {4}",
}

#: Wall-clock time between two lines, in seconds.
_PERIOD_S = 2.0


class StudyProgress:
    """Counts the rows of a study of ``size`` runs as they come."""

    def __init__(self, size: int, *, is_shown: bool, language: Language = "en") -> None:
        self._size = size
        self._language: Language = language
        self._is_shown = is_shown
        self._begin_s = self._shown_s = time.monotonic()
        self._count = 0
        self._broken = 0
        self._crashed: list[int] = []

    def check_size(self, study: Study, cores: int) -> None:
        """Raise ``Failure`` (901305) for a study that would take more than an hour.

        If there are many runs, one is made and timed.
        """
        if self._size < 10_000:
            return
        study.runner.row(0)
        begin_s = time.perf_counter()
        study.runner.row(0)
        estimate_s = (time.perf_counter() - begin_s) * min(self._size, MAX_COUNTED) / cores
        if estimate_s > LONG_S:
            shown = _length(estimate_s)
            raise Failure(diagnostic(STUDY_TOO_LARGE, count=self._size, time=shown, cores=cores))

    def add(self, block: RowBlock) -> None:
        """Count rows; show a line now and then."""
        self._count += len(block)
        self._broken += block.broken
        self._crashed += block.crashed
        now_s = time.monotonic()
        if self._is_shown and now_s - self._shown_s >= _PERIOD_S:
            self._shown_s = now_s
            rate = self._count / (now_s - self._begin_s)
            rest = _length((self._size - self._count) / rate)
            counts = (self._count, self._size, f"{rate:.0f}", self._broken)
            complain(_LINES[self._language].format(*counts, rest.get(self._language)))

    def crashed(self) -> list[Diagnostic]:
        """Return a warning (901308) for each run whose process died."""
        return [diagnostic(RUN_CRASHED, index=index) for index in sorted(self._crashed)]

    def close(self) -> None:
        """Show no further line."""
        self._is_shown = False


def _length(seconds: float) -> Text:
    """Return a length of time in a unit that suits it."""
    for unit, en, de in _UNITS:
        if seconds >= 2 * unit or unit == 1:
            return Text(f"{seconds / unit:.0f} {en}", f"{seconds / unit:.0f} {de}")
    raise AssertionError


#: Seconds in each unit of a length of time.
_UNITS = (
    (31_557_600, "years", "Jahre"),
    (86_400, "days", "Tage"),
    (3600, "hours", "Stunden"),
    (60, "minutes", "Minuten"),
    (1, "seconds", "Sekunden"),
)
