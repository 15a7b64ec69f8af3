# SPDX-License-Identifier: MIT
"""G127 … G137, G230 … G233, G333 … G339: weights of a block -> limits and feed-forward of axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.path.feed_forward import follow_feed_forward, weigh_feed_forward
from nctakt.decoder.state.path_limits import is_weight
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.feed import INVALID_WEIGHT
from nctakt.nc import tree
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
