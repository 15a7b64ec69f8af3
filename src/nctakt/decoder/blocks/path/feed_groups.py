# SPDX-License-Identifier: MIT
"""``#FGROUP``: the axes that F refers to, and how much faster the path is than they are.

In: the command, the list's group, the ends of a block. Out: the ratio of both lengths.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Sequence

from nctakt.base.diagnostics import Message, Span
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.modal_state import FeedGroup
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.feed import (
    AXIS_NOT_ROTARY,
    FEED_GROUP_NOT_FOR_SPLINES,
    FEED_GROUP_VALUE_NOT_POSITIVE,
    NO_FEED_AXES,
)
from nctakt.nc import tree
from nctakt.nc.meaning.path import FEED_GROUP_RADIUS, FEED_GROUP_WEAKEST, axis_and_factor

_SHORTEST = 1e-6


class FeedGroups:
    """The groups of the feed of one program; at its start that of the channel list applies."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._noted: set[Message] = set()
        self._choose(self._listed())

    def select(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#FGROUP``, ``#FGROUP ROT`` or ``#FGROUP WAXIS``."""
        group = self._state.feed.group or FeedGroup()
        words = [word.name for word in command.words]
        items = [
            item
            for argument in command.arguments
            if isinstance(argument, tree.Bracket)
            for item in argument.items
        ]
        if words[-1] == FEED_GROUP_RADIUS:
            rotary, radius = yield from self._radius(items, number)
            self._choose(FeedGroup(group.axes, group.is_weakest, rotary, radius))
        elif words[-1] == FEED_GROUP_WEAKEST:
            self._choose(FeedGroup({}, True, group.rotary, group.radius))
        elif items:
            axes = yield from self._axes(items, number)
            self._choose(FeedGroup(axes, False, group.rotary, group.radius))
        else:
            listed = self._listed()
            if listed.is_linear:
                self._note(NO_FEED_AXES, command.span)
            self._choose(FeedGroup(listed.axes, listed.is_weakest, group.rotary, group.radius))

    def ratio(
        self,
        group: FeedGroup,
        start: Sequence[float],
        target: Sequence[float],
        arc: Arc | None,
        length: float,
        span: Span,
    ) -> float:
        """Return the length of a block by that which F applies to; 1 if nothing of it moves."""
        if self._state.shapes.spline.is_on:
            self._note(FEED_GROUP_NOT_FOR_SPLINES, span)
            return 1.0
        plane = () if arc is None else (arc.first, arc.second)
        turn = 0.0 if arc is None else arc.length(start)
        travels = [abs(end - begin) for begin, end in zip(start, target, strict=True)]
        for index in plane:
            travels[index] = turn
        if group.rotary >= 0:
            travels[group.rotary] *= math.radians(1.0) * group.radius
        counted = (
            self._length_of_weakest(travels, group)
            if group.is_weakest
            else self._length_of_group(travels, group, arc)
        )
        return length / counted if counted > _SHORTEST else 1.0

    def _length_of_group(
        self, travels: Sequence[float], group: FeedGroup, arc: Arc | None
    ) -> float:
        """Return the length of the group's path; an arc counts once, with the larger factor."""
        axes = dict(group.axes or self._linear())
        if group.rotary >= 0:
            axes.setdefault(group.rotary, 1.0)
        if arc is not None and {arc.first, arc.second} <= axes.keys():
            factor = max(axes[arc.first], axes[arc.second])
            axes[arc.first] = factor
            del axes[arc.second]
        return arithmetic.square_root(
            sum((travels[index] * factor) ** 2 for index, factor in axes.items())
        )

    def _length_of_weakest(self, travels: Sequence[float], group: FeedGroup) -> float:
        """Return the distance of the axis that takes longest for it at its highest speed."""
        longest = (0.0, 0.0)
        for index, axis in enumerate(self._environment.axes):
            speed = axis.max_speed
            if index == group.rotary:
                speed *= math.radians(1.0) * group.radius
            longest = max(longest, (travels[index] / speed, travels[index]))
        return longest[1]

    def _radius(
        self, items: Sequence[tree.Keyword | tree.Expression], number: int
    ) -> Generator[Command, Answer, tuple[int, float]]:
        """Return the axis of ``#FGROUP ROT [AX=C REF=40]`` and its radius in mm; none: -1."""
        rotary, radius = -1, 0.0
        for item in items:
            assert isinstance(item, tree.Keyword) and item.value is not None
            if item.name == "AX":
                assert isinstance(item.value, tree.Name)
                rotary = self._environment.axis_numbers[item.value.name]
                if self._environment.axes[rotary].is_linear:
                    axis = item.value.name
                    self._values.fail(AXIS_NOT_ROTARY, item.value.span, axis=axis)
            else:
                radius = yield from self._positive(item.name, item.value, number)
                radius *= self._state.length_unit_mm
        return rotary, radius

    def _axes(
        self, items: Sequence[tree.Keyword | tree.Expression], number: int
    ) -> Generator[Command, Answer, dict[int, float]]:
        axes: dict[int, float] = {}
        for item in items:
            name, value = axis_and_factor(item)
            factor = 1.0
            if value is not None:
                factor = yield from self._positive(name, value, number)
            axes[self._environment.axis_numbers[name]] = factor
        return axes

    def _positive(
        self, word: str, value: tree.Expression, number: int
    ) -> Generator[Command, Answer, float]:
        result = yield from self._values.evaluate(value, number)
        if result <= 0.0:
            self._values.fail(FEED_GROUP_VALUE_NOT_POSITIVE, value.span, word=word, value=result)
        return result

    def _listed(self) -> FeedGroup:
        """Return the group of the channel list; its axes count as long as the channel has them."""
        listed = self._environment.parameters.feed_group
        numbers = self._environment.axis_numbers
        axes = {numbers[name]: 1.0 for name in sorted(listed.axes) if name in numbers}
        return FeedGroup({} if listed.is_weakest else axes, listed.is_weakest)

    def _linear(self) -> dict[int, float]:
        axes = enumerate(self._environment.axes)
        return {index: 1.0 for index, axis in axes if axis.is_linear}

    def _note(self, message: Message, span: Span) -> None:
        """Report a message once per program."""
        if message not in self._noted:
            self._noted.add(message)
            self._values.warn(message, span)

    def _choose(self, group: FeedGroup) -> None:
        """Let F refer to a group; the linear axes, which it refers to anyway, are not a group."""
        if group.axes == self._linear():
            group = FeedGroup({}, False, group.rotary, group.radius)
        self._state.feed.group = None if group.is_linear else group
