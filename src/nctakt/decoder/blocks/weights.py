# SPDX-License-Identifier: MIT
"""G127 … G134, G230 … G233, G333 … G339: weights of a block -> limits of the axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.state.commands import Command
from nctakt.decoder.state.path_limits import is_weight
from nctakt.decoder.values.variables import Values
from nctakt.messages.feed import INVALID_WEIGHT
from nctakt.nc import tree

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
    every = range(len(environment.axes))
    source = 0
    for function, (span, weight) in weights.items():
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
