# SPDX-License-Identifier: MIT
"""Where the time of a branch went, from its first tick on: its ticks are rerun one by one.

In: a branch that may go on. Out: tables, as ``nctakt time`` shows them.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language
from nctakt.session.history.record import ticks_of
from nctakt.session.history.rerun import PastRerun
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.timing.table import TitledTables


class PastAccount(PastRerun):
    """The account of a branch, as far as it has come."""

    _engine: RemoteEngine | None = None

    @property
    def tick(self) -> int:
        """How many ticks are accounted for."""
        return 0 if self._engine is None else self._engine.tick

    def advance(self, count: int) -> bool:
        """Account for up to ``count`` further ticks; return whether there were any.

        Raises ``Failure`` if the past cannot be rerun (901901).
        """
        tick = self.tick
        if self.latest <= tick:
            return False
        if self._engine is None:
            self._engine = self._controller(1, 0.0)[0]
        engine = self._engine
        end = min(self._plan_on(engine), tick + count)
        part, marks = self._next_part(tick, end)
        self._compare(engine.account(part, ticks_of(marks))[1], marks)
        return engine.tick > tick

    def tables(self, language: Language) -> TitledTables:
        """Return where the time of these ticks went."""
        return [] if self._engine is None else self._engine.time_tables(language)

    def close(self) -> None:
        """Give the controller back."""
        if self._engine is not None:
            self._engine.close()
