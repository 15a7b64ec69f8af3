# SPDX-License-Identifier: MIT
"""``#DYNAMIC WEIGHT``: weights of the dynamics by the length of a motion or an arc's radius.

In: the segment of a block, the rows of the channel list. Out: the limits of the axes, where the
row of a block differs from that of the block before.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.path.feed import FeedRate
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.path_limits import BLOCK_UNWEIGHTED, BlockWeights
from nctakt.decoder.state.queued.commands import Command, Segment
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.dynamic_weights import OF_FEED, OF_RAPID, WeightRow
from nctakt.nc import tree
from nctakt.nc.meaning.path import keywords


class DynamicWeighting:
    """The weights by length and radius of one program; at its start those of the list are on."""

    def __init__(self, values: Values, feed_rate: FeedRate) -> None:
        self._environment = values.environment
        self._state = values.state
        self._feed_rate = feed_rate
        self._listed = values.environment.parameters.dynamic_weights
        limits = values.state.limits
        limits.weights_motions = self._listed.motions
        limits.weights_arcs = self._listed.on_arcs

    def switch(self, command: tree.HashCommand, number: int) -> Iterator[Command]:
        """Execute ``#DYNAMIC WEIGHT ON [PATH CURVE]`` or ``OFF``."""
        is_on = command.words[-1].name == "ON"
        limits = self._state.limits
        names = {item.name for item in keywords(command)}
        if "PATH" in names:
            every = self._listed.motions or OF_RAPID | OF_FEED
            limits.weights_motions = every if is_on else 0
        if "CURVE" in names:
            limits.weights_arcs = is_on
        if not limits.weights_blocks:
            yield from self._apply(BLOCK_UNWEIGHTED, command.span, number)

    def of(self, segment: Segment, span: Span, number: int) -> Iterator[Command]:
        """Yield the limits for a segment where they differ from those of the one before."""
        limits = self._state.limits
        arc = None
        if segment.arc is not None:
            first, second, *others = segment.arc
            arc = Arc(int(first), int(second), *others)
        weights = BLOCK_UNWEIGHTED
        kind = OF_FEED if segment.is_feed else OF_RAPID
        if limits.weights_motions & kind:
            length = self._feed_rate.length(segment.start, segment.target, arc)
            row = _row(self._listed.by_length, length)
            weights = weights.with_row(row, is_rapid=not segment.is_feed, is_capped=False)
        if limits.weights_arcs and arc is not None:
            x = segment.start[arc.first] - arc.centre_first
            y = segment.start[arc.second] - arc.centre_second
            row = _row(self._listed.by_radius, arithmetic.square_root(x * x + y * y))
            weights = weights.with_row(row, is_rapid=False, is_capped=True)
        yield from self._apply(weights, span, number)

    def _apply(self, weights: BlockWeights, span: Span, number: int) -> Iterator[Command]:
        limits = self._state.limits
        if weights != limits.block:
            limits.block = weights
            source = self._environment.source_id(span)
            yield set_limits(self._environment.axes, limits, source, number)


def _row(rows: Sequence[WeightRow], size: float) -> WeightRow | None:
    """Return the first row whose limit is above a length or radius; ``None`` above all."""
    return next((row for row in rows if size < row.below), None)
