# SPDX-License-Identifier: MIT
"""Functions whose axis words are not targets but values: G74, G98, G99, G101, G102."""

from __future__ import annotations

from collections.abc import Generator, Mapping

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.homing import Homing
from nctakt.decoder.blocks.axes.software_limits import SoftwareLimits
from nctakt.decoder.blocks.block_content import AxisValues
from nctakt.decoder.blocks.measuring import Measuring
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.nc.vocabulary.functions import HOMING, NEGATIVE_LIMIT, POSITIVE_LIMIT


class AxisFunctions:
    """These functions in one program."""

    def __init__(self, values: Values, measuring: Measuring, uncertain_axes: UncertainAxes) -> None:
        self._measuring = measuring
        self._homing = Homing(values, uncertain_axes)
        self._software_limits = SoftwareLimits(values)
        self._source_id = values.environment.source_id

    def execute(
        self, functions: Mapping[int, AxisValues], span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield the commands of the functions of a block, each with its axis words."""
        source = self._source_id(span)
        for function, words in functions.items():
            if function == HOMING:
                yield from self._homing.home(words, span, number)
            elif function in (NEGATIVE_LIMIT, POSITIVE_LIMIT):
                yield from self._software_limits.set(function, words, source, number)
            else:
                yield from self._measuring.include(function, words, source, number)
