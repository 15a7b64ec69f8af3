# SPDX-License-Identifier: MIT
"""Weights -> limits of the axes.

Those that a block programs (G127 … G137, G230 … G233, G333 … G339, with feed-forward), and those by
the length of a motion or the radius of an arc (``#DYNAMIC WEIGHT``), where the row of the channel
list for a block differs from that for the block before.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.path.feed import FeedRate
from nctakt.decoder.blocks.path.feed_forward import follow_feed_forward, weigh_feed_forward
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.path_limits import BLOCK_UNWEIGHTED, BlockWeights, is_weight
from nctakt.decoder.state.queued.commands import Command, Segment
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.dynamic_weights import OF_FEED, OF_RAPID, WeightRow
from nctakt.messages.path.feed import INVALID_WEIGHT
from nctakt.nc import tree
from nctakt.nc.meaning.path import keywords
from nctakt.nc.vocabulary.functions import FEED_FORWARD_WEIGHTS

#: By G function: a weight of all axes, or those of named ones, in per cent.
Weights = dict[int, tuple[Span, float | list[tuple[tree.AxisWord, float]]]]


def weigh(
    values: Values,
    weights: Mapping[int, tuple[Span, float | list[tuple[tree.AxisWord, float]]]],
    number: int,
) -> Iterator[Command]:
    """Yield the limits of the axes where the weights of a block change them.

    Raises ``DecodeError`` for a weight that is not allowed.
    """
    environment, limits = values.environment, values.state.limits
    if values.state.feed_forward.is_due or FEED_FORWARD_WEIGHTS in weights:
        yield from _feed_forward(values, weights, number)
    every = range(len(environment.axes))
    source = 0
    for function, (span, weight) in weights.items():
        if function == FEED_FORWARD_WEIGHTS:
            continue
        if isinstance(weight, float):
            percentages = dict.fromkeys(every, weight)
        else:
            percentages = {environment.axis_numbers[word.name]: pct for word, pct in weight}
        for pct in percentages.values():
            if not is_weight(function, pct):
                values.fail(INVALID_WEIGHT, span, word=f"G{function}", value=pct)
        if limits.weigh(function, every, percentages):
            source = environment.source_id(span)
    if source:
        yield set_limits(environment.axes, limits, source, number)


def _feed_forward(
    values: Values,
    weights: Mapping[int, tuple[Span, float | list[tuple[tree.AxisWord, float]]]],
    number: int,
) -> Iterator[Command]:
    source = 0
    if FEED_FORWARD_WEIGHTS in weights:
        span, words = weights[FEED_FORWARD_WEIGHTS]
        assert isinstance(words, list)
        weigh_feed_forward(values, words, span)
        source = values.environment.source_id(span)
    yield from follow_feed_forward(values, source, number)


# --- weights by length and radius -----------------------------------------------------------------


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
