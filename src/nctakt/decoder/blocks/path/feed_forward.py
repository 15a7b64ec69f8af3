# SPDX-License-Identifier: MIT
"""G135, G136, G137: feed-forward control on, weighed by axis, off.

It acts on the simulated drives whose lists provide it; the commanded path is unchanged.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.axis_commands import FeedForward
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.feed import INVALID_WEIGHT
from nctakt.nc import tree


def weigh_feed_forward(
    values: Values, words: Iterable[tuple[tree.AxisWord, float]], span: Span
) -> None:
    """Process the words of G136, in per cent and 100 at most; those of other axes stay."""
    state = values.state.feed_forward
    for word, pct in words:
        if pct < 0.0:
            values.fail(INVALID_WEIGHT, span, word="G136", value=pct)
        slot = values.environment.axis_numbers[word.name]
        state.weights[slot] = min(pct, 100.0) / 100.0
    state.is_due = True


def follow_feed_forward(values: Values, source: int, number: int) -> Iterator[Command]:
    """Yield the changes for the drives."""
    state, active = values.state.feed_forward, values.environment.controller_data.feed_forward
    state.is_due = False
    for slot, one in enumerate(values.environment.places.present):
        if one is None:
            continue
        listed = values.environment.axes[slot].feed_forward
        share = listed.share * state.weights.get(slot, 1.0)
        if not (state.is_on or listed.is_permanent):
            share = 0.0
        if share != active.get(one.index, listed.permanent_share):
            active[one.index] = share
            yield FeedForward(source, number, one.index, share)
