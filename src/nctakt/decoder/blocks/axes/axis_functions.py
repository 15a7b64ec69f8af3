# SPDX-License-Identifier: MIT
"""Functions whose axis words are not targets but values: G74, G98, G99, G101, G102.

Of G74, homing: an axis moves to its zero pulse and has the position of its list there
(P-AXIS-00152); then it brakes. V.A.REF and V.A.RERF keep that until the controller restarts.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import homing_overrun
from nctakt.decoder.blocks.axes.software_limits import SoftwareLimits
from nctakt.decoder.blocks.block_content import AxisValues
from nctakt.decoder.blocks.measuring import Measuring
from nctakt.decoder.state.queued.axis_commands import Home, Refer
from nctakt.decoder.state.queued.commands import Answer, Command, PositionRequest
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.messages.axes.couplings import HOMING_WHILE_COUPLED
from nctakt.messages.axes.homing import (
    HOMING_DURING_TRANSFORMATION,
    HOMING_NOT_ALLOWED,
    INVALID_HOMING_ORDER,
)
from nctakt.messages.programs.block_search import HOMING_DURING_SEARCH
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


class Homing:
    """Homing in one program."""

    def __init__(self, values: Values, uncertain_axes: UncertainAxes) -> None:
        self._values = values
        self._environment = values.environment
        self._uncertain_axes = uncertain_axes

    def home(self, words: AxisValues, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield the motions of G74; the values of the words are their order, from 1 on."""
        offsets = self._environment.offsets
        for group in self._values.state.couplings.groups:
            self._values.fail(HOMING_WHILE_COUPLED, span, group=group)
        self._values.check_flush_allowed("G74", span)
        if self._values.state.is_searching:
            self._values.fail(HOMING_DURING_SEARCH, span)
        if offsets.transformation.is_active or offsets.systems.is_active:
            self._values.fail(HOMING_DURING_TRANSFORMATION, span)
        for word, order in words:
            if order < 1.0 or order != int(order):
                self._values.fail(INVALID_HOMING_ORDER, word.span, value=order)
            if not self._axis(word.name).homing.is_allowed:
                self._values.fail(HOMING_NOT_ALLOWED, word.span, axis=word.name)
        for order in sorted({order for _, order in words}):
            together = [word.name for word, other in words if other == order]
            yield from self._together(together, span, number)

    def _axis(self, name: str) -> AxisConfiguration:
        return self._environment.axes[self._environment.axis_numbers[name]]

    def _together(
        self, names: Sequence[str], span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield the motions of axes that are homed at the same time, and their positions then."""
        source = self._environment.source_id(span)
        members = []
        for name in names:
            axis = self._environment.names.axis(name)
            assert axis is not None
            members.append(axis.number)
        answer = yield PositionRequest(source, number, tuple(members))
        for name, member in zip(names, members, strict=True):
            axis_list = self._axis(name)
            homing = axis_list.homing
            rest = homing_overrun(axis_list)
            yield Home(source, number, member, homing.distance + rest, homing.speed)
        answer = yield PositionRequest(source, number, tuple(members))
        assert isinstance(answer, tuple)
        positions = list(answer)
        for name, member in zip(names, members, strict=True):
            axis_list = self._axis(name)
            position = axis_list.homing.position + homing_overrun(axis_list)
            positions[self._environment.axis_numbers[name]] = position
            yield Refer(source, number, member, position)
            references = self._environment.controller_data.references
            references.keep_reference(member, axis_list.homing.position)
        self._values.state.positions = positions
        self._uncertain_axes.confirm(names)
