# SPDX-License-Identifier: MIT
"""Where the time of the branch that is shown went, for all browsers of a session.

In: a session. Out: tables that follow its branch, in the languages that browsers ask for. The
thread of the searches reruns the ticks; the session is not held up.
"""

from __future__ import annotations

import time

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.session.session import Session
from nctakt.timing.table import TitledTables

#: Ticks that are accounted for before others that search the past have their turn.
_TICKS = 2_000

#: Least time between two sets of tables, in seconds, and how often longer than making one.
_DISTANCE_S, _TIMES_LONGER = 0.5, 10

#: How long the tables may be out of sight before the work pauses, in seconds.
_UNSEEN_S = 5.0


@dataclass(frozen=True, slots=True)
class TimesShown:
    """Tables of the first ``tick`` ticks; ``latest``: the tick that the branch has reached.

    ``error``: why no more ticks are accounted for.
    """

    tables: TitledTables
    tick: int
    latest: int
    error: Failure | RuntimeError | None = None


class TimeAccounting:
    """The account of a branch of a session; it continues while someone looks at it."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self._account = session.time_account()
        self.branch = self._account.branch
        self._error: Failure | RuntimeError | None = None
        self._seen_s: dict[Language, float] = {}
        self._tables: dict[Language, tuple[int, TitledTables]] = {}
        self._due_s = 0.0
        self._is_ended = False

    def shown(self, language: Language) -> TimesShown:
        """Return the newest tables; any thread may ask."""
        self._seen_s[language] = time.monotonic()
        tick, tables = self._tables.get(language, (0, []))
        return TimesShown(tables, tick, self._account.latest, self._error)

    def end_it(self) -> None:
        """Account for no more."""
        self._is_ended = True

    # --- in the thread of the searches ----------------------------------------------------------

    @property
    def is_ended(self) -> bool:
        """Whether it accounts for no more."""
        return self._is_ended or self._error is not None

    def advance(self) -> bool:
        """Account for some ticks; return whether there were any."""
        try:
            return self._advance()
        except (Failure, RuntimeError) as error:
            self._error = error
            return False

    def _advance(self) -> bool:
        begin_s = time.monotonic()
        seen = [one for one, at in self._seen_s.items() if begin_s - at < _UNSEEN_S]
        if not seen:
            return False
        has_advanced = self._account.advance(_TICKS)
        tick = self._account.tick
        old = [one for one in seen if self._tables.get(one, (0,))[0] != tick]
        begin_s = time.monotonic()
        if old and begin_s >= self._due_s:
            for language in old:
                self._tables[language] = tick, self._account.tables(language)
            end_s = time.monotonic()
            self._due_s = end_s + max(_DISTANCE_S, _TIMES_LONGER * (end_s - begin_s))
        return has_advanced

    def close(self) -> None:
        """Give its controller back."""
        self._account.close()
