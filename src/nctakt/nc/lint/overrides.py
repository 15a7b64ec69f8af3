# SPDX-License-Identifier: MIT
"""Constants of programmed overrides: ``#OVERRIDE [FEED_FACT=50]``, ``X[OVERRIDE FEED_FACT=50]``,
``S[OVERRIDE SPEED_FACT=50]``.

In: a command. Out: the error of a run (21419) where a value is out of the range, a warning (901158)
where it is so small that a share was meant instead of per cent.
"""

from __future__ import annotations

from collections.abc import Iterable

from nctakt.messages.path.feed import INVALID_PROGRAM_OVERRIDE
from nctakt.messages.programs.lints import OVERRIDE_IS_PERCENT
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import SPINDLE_FACTOR
from nctakt.nc.lint.constants import constant
from nctakt.nc.meaning.path import OVERRIDE_FACTORS, OVERRIDE_MAX_PCT, OVERRIDE_MIN_PCT
from nctakt.nc.tree import Keyword, Node

#: Overrides up to this value are taken for shares: 1 for all, 0.5 for one half.
_LARGEST_SHARE = 1.0


def check_overrides(items: Iterable[Node], findings: Findings) -> None:
    """Report constants of FEED_FACT, RAPID_FACT and SPEED_FACT that cannot be meant."""
    for item in items:
        if not isinstance(item, Keyword) or item.name not in (*OVERRIDE_FACTORS, SPINDLE_FACTOR):
            continue
        value = None if item.value is None else constant(item.value)
        if item.value is None or value is None:
            continue
        if not OVERRIDE_MIN_PCT <= value <= OVERRIDE_MAX_PCT:
            findings.report(
                INVALID_PROGRAM_OVERRIDE,
                item.value.span,
                word=item.name,
                value=value,
                low=OVERRIDE_MIN_PCT,
                high=OVERRIDE_MAX_PCT,
            )
        elif value <= _LARGEST_SHARE:
            findings.report(
                OVERRIDE_IS_PERCENT,
                item.value.span,
                word=item.name,
                value=value,
                meant=100.0 * value,
            )
