# SPDX-License-Identifier: MIT
"""Factors of overrides in programs: ``#OVERRIDE``, ``X[OVERRIDE …]``, ``S[OVERRIDE …]``."""

from __future__ import annotations

from collections.abc import Generator

from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.feed import INVALID_PROGRAM_OVERRIDE
from nctakt.nc.meaning.path import OVERRIDE_MAX_PCT, OVERRIDE_MIN_PCT
from nctakt.nc.tree import Keyword


def override_factor(
    values: Values, keyword: Keyword, number: int
) -> Generator[Command, Answer, float]:
    """Return a factor of a program in per cent as a share; raises ``DecodeError``."""
    assert keyword.value is not None
    pct = yield from values.evaluate(keyword.value, number)
    if not OVERRIDE_MIN_PCT <= pct <= OVERRIDE_MAX_PCT:
        values.fail(
            INVALID_PROGRAM_OVERRIDE,
            keyword.value.span,
            word=keyword.name,
            value=pct,
            low=OVERRIDE_MIN_PCT,
            high=OVERRIDE_MAX_PCT,
        )
    return pct / 100.0
