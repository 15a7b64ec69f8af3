# SPDX-License-Identifier: MIT
"""``#AX LINK``: groups of axes and spindles that follow others.

In: checked nodes. Out: the commands that couple axes in the tick; ``blocks/spindles.py`` gives the
slaves of a spindle its jobs. Groups outlive programs, active ones where the channel list says so.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Iterator, Sequence

from nctakt.base.diagnostics import NOTHING, Span, Text
from nctakt.base.whole_numbers import is_whole
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.axes.cutting_speed import CuttingSpeeds
from nctakt.decoder.blocks.axes.spindles import index_of
from nctakt.decoder.state.couplings import Couple, CoupledPair, CoupledPlaces
from nctakt.decoder.state.environment import DecodeError
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, ClearHistory, Command, PositionRequest
from nctakt.decoder.values.variables import Values
from nctakt.messages.axes.couplings import (
    ACTIVE_GROUP_DEFINED_AGAIN,
    AXIS_FOLLOWS_ITSELF,
    COUPLED_MODES_DIFFER,
    COUPLED_TYPES_DIFFER,
    COUPLING_DURING_COMPENSATION,
    COUPLING_GROUP_OUT_OF_RANGE,
    FACTOR_IS_ZERO,
    GROUP_NOT_RESTORED,
    MAIN_AXIS_AS_SLAVE,
    MAIN_SPINDLE_AS_SLAVE,
    MASTER_IS_SLAVE_OF_GROUP,
    NOT_WHILE_COUPLED,
    SLAVE_IN_TWO_GROUPS,
    SLAVE_IS_MASTER_IN_GROUP,
    SLAVE_IS_MASTER_OF_GROUP,
    SLAVE_TWICE_IN_GROUP,
    SPINDLES_FOLLOW_JOBS,
    UNKNOWN_COUPLED_AXIS,
    UNKNOWN_COUPLING_GROUP,
)
from nctakt.nc import tree
from nctakt.nc.meaning.axes import MAX_GROUP, CouplingAction, WrittenPair, coupling_command

#: An axis by its number in the machine, or a spindle by its index in the channel.
Member = tuple[bool, int]

_BLOCK_SEARCH = Text("block search", "Satzvorlauf")


class Couplings:
    """Decodes these commands for one program."""

    def __init__(self, values: Values, cutting: CuttingSpeeds) -> None:
        self._values = values
        self._cutting = cutting
        self._environment = values.environment
        self._places = values.environment.places
        self._data = values.environment.controller_data.couplings
        self._active = values.state.couplings

    # --- begin and end of a program -------------------------------------------------------------

    def begin_program(self, span: Span) -> Generator[Command, Answer]:
        """Couple the groups again that an earlier program has left coupled, if the list says so.

        A group whose axes or spindles have changed is left out, with a warning.
        """
        name = "#ENABLE AX LINK"
        for group in self._data.take_restored():
            self._check_allowed(name, span, (group,))
            try:
                self._check_pairs(group, span)
            except DecodeError as error:
                found = error.diagnostic
                reason = Text(found.text("en"), found.text("de"))
                self._values.warn(GROUP_NOT_RESTORED, span, group=group, reason=reason)
            else:
                yield from self._enable(group, name, span, 0)

    def end_program(self, span: Span) -> Generator[Command, Answer]:
        """Release all groups (P-CHAN-00105)."""
        self._data.end_program()
        yield from self._disable(tuple(self._active.groups), span, 0)

    # --- commands -------------------------------------------------------------------------------

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one of the commands."""
        parsed = coupling_command(statement)
        assert parsed is not None
        name = "#" + " ".join(word.name for word in statement.words)
        span = statement.span
        is_definition = parsed.action is CouplingAction.DEFINE
        group = 0
        if parsed.group is not None:
            value = yield from self._values.evaluate(parsed.group, number)
            lowest = int(is_definition)
            if not is_whole(value, lowest, MAX_GROUP):
                self._values.fail(
                    COUPLING_GROUP_OUT_OF_RANGE,
                    parsed.group.span,
                    group=value,
                    low=lowest,
                    high=MAX_GROUP,
                )
            group = int(value)
        if is_definition:
            if group in self._active.groups:
                self._values.fail(ACTIVE_GROUP_DEFINED_AGAIN, span, group=group)
            pairs = []
            for written in parsed.pairs:
                pairs.append((yield from self._pair(written, number)))
            self._check_group(pairs, [pair.span for pair in parsed.pairs])
            self._data.groups[group] = tuple(pairs)
            return
        active = tuple(self._active.groups)
        if parsed.action is CouplingAction.DISABLE:
            active = (group,) if parsed.group is not None else active[-1:]
        is_enabling = parsed.action is CouplingAction.ENABLE
        self._check_allowed(name, span, (group,) if is_enabling else active)
        if is_enabling:
            yield from self._enable(group, name, span, number)
            return
        if any(one not in self._data.groups for one in active):
            self._fail_unknown(name, group, span)
        yield from self._disable(active, span, number)

    def _check_allowed(self, name: str, span: Span, groups: Sequence[int]) -> None:
        """Check that groups may be coupled or released here; raises ``DecodeError``."""
        if self._values.state.path.compensation.is_active:
            self._values.fail(COUPLING_DURING_COMPENSATION, span, command=name)
        pairs = [pair for group in groups for pair in self._data.groups.get(group, ())]
        has_axes = any(pair.axes for pair in pairs)
        if has_axes and self._environment.offsets.transformation.is_active:
            self._values.fail(NOT_WHILE_COUPLED, span, command=name, other="#TRAFO")
        if self._values.state.is_searching:
            self._values.fail(NOT_WHILE_COUPLED, span, command=name, other=_BLOCK_SEARCH)
        self._values.check_flush_allowed(name, span)

    # --- the definition -------------------------------------------------------------------------

    def _pair(self, written: WrittenPair, number: int) -> Generator[Command, Answer, CoupledPair]:
        slave = yield from self._member(written.slave, written.span, number)
        master = yield from self._member(written.master, written.span, number)
        if slave[0] != master[0]:
            self._values.fail(
                COUPLED_TYPES_DIFFER,
                written.span,
                slave=self._name(slave),
                master=self._name(master),
            )
        factor = 1.0
        if written.factor:
            parts = []
            for expression in written.factor:
                parts.append((yield from self._values.evaluate(expression, number)))
            if 0.0 in parts:
                self._values.fail(FACTOR_IS_ZERO, written.span)
            factor = parts[0] / parts[1]
        allowed = 0.0
        if written.is_gantry and not slave[0]:
            allowed = self._places.machine_axes[slave[1]].gantry.allowed_d
        for expression in written.limits[:1]:
            value = yield from self._values.evaluate(expression, number)
            is_linear = not slave[0] and self._places.machine_axes[slave[1]].is_linear
            allowed = abs(value) * (self._values.state.length_unit_mm if is_linear else 1.0)
        if slave[0] and (written.is_gantry or factor != 1.0):
            self._values.fail(SPINDLES_FOLLOW_JOBS, written.span, slave=self._name(slave))
        return CoupledPair(slave[1], master[1], factor, allowed, slave[0])

    def _member(
        self, written: str | tree.Expression, span: Span, number: int
    ) -> Generator[Command, Answer, Member]:
        """Return the axis or spindle of a name or a logical number."""
        spindles = self._environment.parameters.spindles
        if isinstance(written, str):
            axis = self._environment.names.axis(written)
            if axis is not None:
                return False, axis.number
            index = index_of(self._values, written)
            if index >= 0:
                return True, index
            known = ", ".join(self._environment.parameters.spindle_names)
            self._values.fail(UNKNOWN_COUPLED_AXIS, span, axis=written, known=known)
        value = yield from self._values.evaluate(written, number)
        numbers = [spindle.logical_number for spindle in spindles]
        if value in numbers:
            return True, numbers.index(int(value))
        if value not in self._places.by_number:
            known = ", ".join(map(str, sorted({*self._places.by_number, *numbers})))
            self._values.fail(UNKNOWN_COUPLED_AXIS, span, axis=value, known=known)
        return False, self._places.by_number[int(value)]

    def _check_group(self, pairs: Sequence[CoupledPair], spans: Sequence[Span]) -> None:
        """Check that no slave has two masters, and that no master is a slave."""
        slaves: set[Member] = set()
        for pair, span in zip(pairs, spans, strict=True):
            slave, master = pair.members
            if slave == master:
                self._values.fail(AXIS_FOLLOWS_ITSELF, span, slave=self._name(slave))
            if slave in slaves:
                self._values.fail(SLAVE_TWICE_IN_GROUP, span, slave=self._name(slave))
            slaves.add(slave)
        for pair, span in zip(pairs, spans, strict=True):
            if pair.members[1] in slaves:
                name = self._name(pair.members[1])
                self._values.fail(SLAVE_IS_MASTER_IN_GROUP, span, axis=name)

    def _name(self, member: Member) -> str:
        is_spindle, index = member
        if is_spindle:
            return self._environment.parameters.spindles[index].name
        slot = self._slot(index)
        if slot >= 0:
            return self._places.name(slot)
        return str(self._places.logical(index))

    def _slot(self, axis: int) -> int:
        """Return the place of an axis of the machine; -1 where the channel does not have it."""
        found = (i for i, one in enumerate(self._places.present) if one and one.index == axis)
        return next(found, -1)

    # --- coupling and releasing -----------------------------------------------------------------

    def _enable(self, group: int, name: str, span: Span, number: int) -> Generator[Command, Answer]:
        """Let the pairs of a group follow each other from the present positions on."""
        if group in self._active.groups:
            return
        if group not in self._data.groups:
            self._fail_unknown(name, group, span)
        self._check_pairs(group, span)
        pairs = self._data.groups[group]
        source = self._environment.source_id(span)
        yield from self._stop(source, number)
        state = self._values.state
        of_axes = [pair for pair in pairs if not pair.is_spindle]
        coupled = []
        for pair in of_axes:
            slave, master = self._slot(pair.slave), self._slot(pair.master)
            begins = state.positions[slave], state.positions[master]
            coupled.append(CoupledPlaces(slave, master, pair.factor, *begins))
            yield Couple(source, number, pair.slave, pair.master, pair.factor, pair.allowed_d)
        self._active.groups[group] = pairs
        self._active.places[group] = tuple(coupled)
        self._data.enable(group)
        yield from self._follow_limits(bool(of_axes), source, number)

    def _disable(
        self, groups: Sequence[int], span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Release groups: their slaves stay where they are."""
        active = [group for group in groups if group in self._active.groups]
        if not active:
            return
        source = self._environment.source_id(span)
        yield from self._stop(source, number)
        released = False
        for group in active:
            for pair in self._active.groups.pop(group):
                if not pair.is_spindle:
                    yield Couple(source, number, pair.slave, -1)
                    released = True
            self._active.places.pop(group)
            self._data.disable(group)
        yield from self._follow_limits(released, source, number)

    def _stop(self, source: int, number: int) -> Generator[Command, Answer]:
        """Let path and axes come to rest, and know their positions."""
        axes = [slot.index for slot in self._places.present if slot is not None]
        answer = yield PositionRequest(source, number, tuple(axes))
        assert isinstance(answer, tuple)
        self._values.state.positions = list(answer)

    def _follow_limits(self, has_axes: bool, source: int, number: int) -> Iterator[Command]:
        """Make masters keep the limits of their slaves from here on; bars backward motion."""
        if not has_axes:
            return
        limits = self._values.state.limits
        limits.followed = tuple(
            (pair.master, pair.slave, math.fabs(pair.factor)) for pair in self._active.of_axes
        )
        yield set_limits(self._environment.axes, limits, source, number)
        yield ClearHistory(source, number)

    def _check_pairs(self, group: int, span: Span) -> None:
        """Check that the pairs of a group can be coupled; raises ``DecodeError``."""
        for pair in self._data.groups[group]:
            self._check_pair(pair, span)

    def _check_pair(self, pair: CoupledPair, span: Span) -> None:
        """Check that a pair can be coupled in addition to the present ones."""
        slave, master = pair.members
        names = {"slave": self._name(slave), "master": self._name(master)}
        for group, others in self._active.groups.items():
            for other in others:
                if slave == other.members[0]:
                    shown = names["slave"]
                    self._values.fail(SLAVE_IN_TWO_GROUPS, span, axis=shown, group=group)
                if slave == other.members[1]:
                    shown = names["slave"]
                    self._values.fail(SLAVE_IS_MASTER_OF_GROUP, span, axis=shown, group=group)
                if master == other.members[0]:
                    shown = names["master"]
                    self._values.fail(MASTER_IS_SLAVE_OF_GROUP, span, axis=shown, group=group)
        if pair.is_spindle:
            if pair.slave == self._values.state.main_spindle:
                self._values.fail(MAIN_SPINDLE_AS_SLAVE, span, **names)
            if self._cutting.is_active and pair.master == self._values.state.main_spindle:
                self._values.fail(NOT_WHILE_COUPLED, span, command="#AX LINK", other="G96")
            return
        for index in pair.axes:
            if self._slot(index) < 0:
                logical = self._places.logical(index)
                known = ", ".join(one.name for one in self._places.present if one is not None)
                self._values.fail(UNKNOWN_COUPLED_AXIS, span, axis=logical, known=known)
        if self._slot(pair.slave) < MAIN_AXES:
            self._values.fail(MAIN_AXIS_AS_SLAVE, span, **names)
        axis, other_axis = (self._places.machine_axes[index] for index in pair.axes)
        if axis.is_linear != other_axis.is_linear:
            self._values.fail(COUPLED_TYPES_DIFFER, span, **names)
        if axis.mode != other_axis.mode:
            self._values.fail(COUPLED_MODES_DIFFER, span, **names)

    def _fail_unknown(self, name: str, group: int, span: Span) -> None:
        known = ", ".join(map(str, sorted(self._data.groups))) or NOTHING
        self._values.fail(UNKNOWN_COUPLING_GROUP, span, command=name, group=group, known=known)
