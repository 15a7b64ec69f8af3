# SPDX-License-Identifier: MIT
"""``#CALL AX``, ``#PUT AX``, ``#SET AX``, ``#AX REQUEST``, ``#AX RELEASE``, ``#AX DEF``, ``#CAX``.

In: checked nodes. Out: position requests and ``ExchangeAxes`` commands; from their answers on the
decoder has other axes. A channel first gives axes and then takes others, all of them at once, so
that two channels can swap axes.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from typing import TypeVar

from nctakt.base.diagnostics import Span, Text
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.axes.software_limits import limits_of_program_again, listed_limits_again
from nctakt.decoder.blocks.axes.spindles import main_of
from nctakt.decoder.blocks.path.feed_forward import follow_feed_forward
from nctakt.decoder.state.axis_places import (
    AxisNotInChannelError,
    AxisPlace,
    ExchangeAxes,
    Places,
    indices_of,
    trimmed,
)
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.commands import Answer, Command, PositionRequest
from nctakt.decoder.state.queued.spindle_commands import AwaitSpindle, SpindleAxis, SpindleJob
from nctakt.decoder.values.variables import Values
from nctakt.messages.axes.axis_exchange import (
    AXIS_NOT_IN_CHANNEL,
    AXIS_OF_SPINDLE,
    AXIS_TWICE,
    EXCHANGE_IN_SEARCH,
    EXCHANGE_UNDER_TRANSFORMATION,
    INVALID_AXIS_PLACE,
    UNKNOWN_AXIS_NUMBER,
)
from nctakt.messages.axes.c_axis import C_AXIS_IN_PLANE, C_AXIS_OF_OTHER_SPINDLE
from nctakt.messages.axes.couplings import COUPLED_AXIS_GIVEN, COUPLED_AXIS_MOVED_TO_INDEX
from nctakt.messages.axes.spindles import SPINDLE_WITHOUT_AXIS
from nctakt.nc import tree
from nctakt.nc.meaning.axes import (
    GIVING,
    CAxisCommand,
    ExchangeCommand,
    FetchedAxis,
    c_axis_command,
    exchange_command,
    is_c_axis,
)
from nctakt.nc.vocabulary.functions import SPINDLE_STOP

_Value = TypeVar("_Value")
Decoded = Generator[Command, Answer]


class AxisExchange:
    """Decodes these commands for one program; ``adapt`` is called when the axes have changed."""

    def __init__(self, values: Values, adapt: Callable[[], None]) -> None:
        self._values = values
        self._environment = values.environment
        self._places = values.environment.places
        self._c_axis = CAxisCommands(values)
        self._adapt = adapt

    def run(
        self,
        commands: Decoded,
        members: list[int],
        current: Callable[[], tree.Statement | None],
    ) -> Decoded:
        """Run a program with the axes of its list; ``current`` returns the statement at work."""
        limited = frozenset(self._environment.controller_data.limited_axes)
        yield from listed_limits_again(self._environment, limited, 0, 0)
        yield from self._restore(members)
        for spindle in self._places.without_axis():
            yield SpindleAxis(0, 0, spindle, False)
        yield from self.resume(commands, current)

    def resume(self, commands: Decoded, current: Callable[[], tree.Statement | None]) -> Decoded:
        """Run a program with the axes that it has."""
        try:
            yield from commands
        except AxisNotInChannelError as error:
            statement = current()
            assert statement is not None
            self._refuse(error.name, statement)

    def _restore(self, members: list[int]) -> Decoded:
        """Give and take until the channel has the axes of its list; ``members``: those it has."""
        places = self._places
        own = places.members(places.listed)
        if members == own:
            return
        yield ExchangeAxes(0, 0, tuple(i for i in own if i in members and places.holder(i)), ())
        answer = yield ExchangeAxes(0, 0, tuple(own), tuple(i for i in own if i not in members))
        assert isinstance(answer, tuple)
        self._values.state.positions = list(answer)

    def command(self, command: tree.HashCommand, number: int) -> Decoded:
        """Execute one of the commands."""
        name, target = "#CAX", self._places.present
        if is_c_axis(command):
            target = yield from self._c_axis.target(command, number)
            if target == self._places.present:
                return
        else:
            parsed = exchange_command(command)
            assert parsed is not None
            name = f"#{parsed.action}"
            decode = self._without if parsed.action in GIVING else self._with
            target = yield from decode(parsed, number)
        self._check(name, target, command.span)
        self._values.check_flush_allowed(name, command.span)
        yield from self._change(target, command.span, number)

    # --- the axes that a command asks for -------------------------------------------------------

    def _without(self, parsed: ExchangeCommand, number: int) -> Generator[Command, Answer, Places]:
        """Return the present places without the axes that a command gives."""
        numbers = []
        for expression in parsed.numbers:
            numbers.append((yield from self._values.evaluate(expression, number)))
        present = self._places.present
        if parsed.is_all:
            return ()
        return trimmed(
            [
                None
                if slot is None
                or slot.name in parsed.names
                or self._places.logical(slot.index) in numbers
                else slot
                for slot in present
            ]
        )

    def _with(self, parsed: ExchangeCommand, number: int) -> Generator[Command, Answer, Places]:
        """Return the places with the axes that a command fetches."""
        places: list[AxisPlace | None] = []
        if parsed.keeps_others:
            places = list(self._places.present)
        elif parsed.from_default:
            places = list(self._places.listed)
        fetched = []
        for axis in parsed.fetched:
            fetched.append((axis, *(yield from self._axis(axis, number))))
        if not parsed.keeps_others:
            moved = {index for _, index, _ in fetched}
            places = [None if one is None or one.index in moved else one for one in places]
        for axis, index, position in fetched:
            self._put(places, axis, AxisPlace(axis.name, index), position)
        return trimmed(places)

    def _axis(self, axis: FetchedAxis, number: int) -> Generator[Command, Answer, tuple[int, int]]:
        """Return number in the machine and place of an axis to be fetched."""
        places = self._places
        value = yield from self._values.evaluate(axis.number, number)
        of_spindle = self._of_spindle(value)
        if value in places.spindles and of_spindle < 0:
            spindle, channel = places.spindles[int(value)]
            self._values.fail(
                AXIS_OF_SPINDLE,
                axis.number.span,
                value=int(value),
                spindle=spindle,
                channel=channel,
            )
        if value not in places.by_number and of_spindle < 0:
            known = ", ".join(map(str, sorted(places.by_number)))
            self._values.fail(UNKNOWN_AXIS_NUMBER, axis.number.span, value=value, numbers=known)
        slot = yield from self._values.evaluate(axis.slot, number)
        if not 0 <= slot < places.room or slot != int(slot):
            highest = places.room - 1
            self._values.fail(INVALID_AXIS_PLACE, axis.slot.span, value=slot, highest=highest)
        index = places.by_number[int(value)] if of_spindle < 0 else of_spindle
        return index, int(slot)

    def _of_spindle(self, value: float) -> int:
        """Return the axis of a spindle by its logical number; -1: there is none to be fetched.

        The channel's own spindle has given it up; that of another channel may still have to.
        """
        index = self._places.c_axes.get(int(value), -1) if value == int(value) else -1
        if index < 0 or index != self._places.c_axis:
            return index
        main = main_of(self._environment.parameters.spindles)
        return index if main in self._values.state.spindles_without_axis else -1

    def _put(
        self, places: list[AxisPlace | None], axis: FetchedAxis, new: AxisPlace, position: int
    ) -> None:
        """Put an axis at its place; nothing happens if the channel has it there or elsewhere."""
        if new in places:
            return
        for slot, other in enumerate(places):
            if other is None:
                continue
            same: object = None
            if other.index == new.index:
                same = Text(f"number {self._logical(new)}", f"die Nummer {self._logical(new)}")
            elif other.name == new.name:
                same = Text(f"the name {new.name}", f"der Name {new.name}")
            elif slot == position:
                same = Text(f"index {position}", f"der Index {position}")
            if same is not None:
                self._values.fail(
                    AXIS_TWICE,
                    axis.span,
                    what=same,
                    first=self._logical(other),
                    second=self._logical(new),
                )
        places += [None] * (position + 1 - len(places))
        places[position] = new

    def _logical(self, slot: AxisPlace) -> int:
        return self._places.logical(slot.index)

    def _check(self, name: str, target: Places, span: Span) -> None:
        """Refuse an exchange while a system or a transformation is active, or off for a while."""
        offsets = self._environment.offsets
        for group, pairs in self._values.state.couplings.groups.items():
            for axis in (axis for pair in pairs for axis in pair.axes):
                self._check_coupled(name, target, axis, group, span)
        if self._values.state.is_searching:
            self._values.fail(EXCHANGE_IN_SEARCH, span, command=name)
        if target != self._places.present and (
            offsets.systems.is_active
            or offsets.transformation.is_active
            or offsets.suspended is not None
            or self._values.state.frame.is_active
        ):
            self._values.fail(EXCHANGE_UNDER_TRANSFORMATION, span, command=name)

    def _check_coupled(self, name: str, target: Places, axis: int, group: int, span: Span) -> None:
        """Refuse to give away an axis that is coupled, or to put it at another index."""
        before = [one is not None and one.index == axis for one in self._places.present]
        after = [one is not None and one.index == axis for one in target]
        if any(before) and before.index(True) != (after.index(True) if any(after) else -1):
            message = COUPLED_AXIS_MOVED_TO_INDEX if any(after) else COUPLED_AXIS_GIVEN
            shown = self._places.name(before.index(True))
            self._values.fail(message, span, command=name, axis=shown, group=group)

    # --- the exchange ---------------------------------------------------------------------------

    def _change(self, target: Places, span: Span, number: int) -> Decoded:
        """Let path and axes come to rest, give up the leaving axes, then take the new ones."""
        places = self._places
        source = self._environment.source_id(span)
        before = places.present
        own_indices = {slot.index for slot in before if slot is not None}
        target_indices = {slot.index for slot in target if slot is not None}
        answer = yield PositionRequest(source, number, tuple(sorted(own_indices)))
        assert isinstance(answer, tuple)
        self._values.state.positions = list(answer)
        if target == before:
            return
        given = own_indices - target_indices
        yield from listed_limits_again(self._environment, given, source, number)
        if given and target_indices - own_indices:
            kept = trimmed(
                [None if one is None or one.index not in target_indices else one for one in before]
            )
            answer = yield ExchangeAxes(source, number, tuple(places.members(kept)), ())
        awaited = tuple(sorted(target_indices - own_indices))
        answer = yield ExchangeAxes(source, number, tuple(places.members(target)), awaited)
        assert isinstance(answer, tuple)
        self._take(target, answer)
        state = self._values.state
        yield from limits_of_program_again(self._environment, state, source, number)
        yield from follow_feed_forward(self._values, source, number)
        if state.limits.is_reduced:
            yield set_limits(self._environment.axes, state.limits, source, number)

    def _take(self, target: Places, positions: tuple[float, ...]) -> None:
        """Let the decoder have other axes."""
        environment, state = self._environment, self._values.state
        before = self._places.present
        self._places.present = target
        environment.axis_numbers = indices_of(target)
        environment.axes = tuple(map(self._places.axis_of, target))
        environment.offsets.exchange(self._places.own_axes(target))
        for slot in target:
            if slot is not None:
                environment.names.place_axis(slot.name, slot.index)
        state.positions = list(positions)
        moved = {
            old: new
            for old, slot in enumerate(before)
            for new, other in enumerate(target)
            if slot is not None and other is not None and slot.index == other.index
        }
        move_axis_values(state, moved)
        self._adapt()

    def _refuse(self, name: str, statement: tree.Statement) -> None:
        """Fail because a statement names an axis that the channel does not have."""
        words = getattr(statement, "words", ())
        span = next((word.span for word in words if word.name == name), statement.span)
        index = self._environment.names.axis(name)
        channel = 0 if index is None else self._places.holder(index.number)
        holder = Text("no channel has it", "kein Kanal hat sie")
        if channel:
            holder = Text(f"channel {channel} has it", f"Kanal {channel} hat sie")
        self._values.fail(AXIS_NOT_IN_CHANNEL, span, axis=name, holder=holder)


def move_axis_values(state: ModalState, moved: Mapping[int, int]) -> None:
    """Let the values by axis follow their axes; ``moved``: old indices -> new ones.

    Those of axes that the channel has given are lost.
    """
    state.limits.weights = _moved(state.limits.weights, moved)
    state.feed.axis_overrides = _moved(state.feed.axis_overrides, moved)
    if state.feed.group is not None:
        state.feed.group = state.feed.group.after_exchange(moved)
    state.software_limits.programmed = _moved(state.software_limits.programmed, moved)
    state.measuring.measured = _moved(state.measuring.measured, moved)
    state.frame.factors = _moved(state.frame.factors, moved)
    state.path.contour.point = _moved(state.path.contour.point, moved)
    state.feed_forward.weights = _moved(state.feed_forward.weights, moved)
    state.wcs = _moved(state.wcs, moved)
    state.mcs = _moved(state.mcs, moved)
    if state.tool.length_axis is not None:
        axis, sign = state.tool.length_axis
        state.tool.length_axis = (moved[axis], sign) if axis in moved else None


def _moved(values: Mapping[int, _Value], moved: Mapping[int, int]) -> dict[int, _Value]:
    return {moved[axis]: value for axis, value in values.items() if axis in moved}


class CAxisCommands:
    """The commands of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._places = values.environment.places

    def target(
        self, statement: tree.HashCommand, number: int
    ) -> Generator[Command, Answer, Places]:
        """Stop the spindle for ``#CAX``; return the axes that the channel is to have."""
        command = c_axis_command(statement)
        assert command is not None
        if not command.is_on:
            return self._without(statement)
        if self._places.c_axis_name == self._name(command):
            return self._places.present
        target = self._with(command, statement)
        source = self._environment.source_id(statement.span)
        index = main_of(self._environment.parameters.spindles)
        if self._values.state.main_spindle != index:
            self._values.fail(C_AXIS_OF_OTHER_SPINDLE, statement.span)
        if index in self._values.state.spindles_without_axis:
            name = self._environment.parameters.spindles[index].name
            self._values.fail(SPINDLE_WITHOUT_AXIS, statement.span, spindle=name)
        yield SpindleJob(source, number, index, SPINDLE_STOP, 0.0, 0.0, 0, 0)
        yield AwaitSpindle(source, number, index)
        return target

    def _without(self, statement: tree.HashCommand) -> Places:
        """Return the present axes without that of the spindle."""
        plane = self._environment.offsets.transformation.plane
        if self._places.c_axis_name and plane is not None:
            self._values.fail(C_AXIS_IN_PLANE, statement.span, command=plane.command)
        index = self._places.c_axis
        present = self._places.present
        return trimmed([None if one is None or one.index == index else one for one in present])

    def _with(self, command: CAxisCommand, statement: tree.HashCommand) -> Places:
        """Return the present axes with that of the spindle at the first free index above 2."""
        places = list(self._places.present)
        new = AxisPlace(self._name(command), self._places.c_axis)
        for other in places:
            if other is not None and (other.name == new.name or other.index == new.index):
                self._values.fail(
                    AXIS_TWICE,
                    statement.span,
                    what=Text(f"the name {new.name}", f"der Name {new.name}")
                    if other.name == new.name
                    else Text(f"the axis {other.name}", f"die Achse {other.name}"),
                    first=self._places.logical(other.index),
                    second=self._places.logical(new.index),
                )
        places += [None] * (MAIN_AXES - len(places))
        free = [slot for slot in range(MAIN_AXES, len(places)) if places[slot] is None]
        if free:
            places[free[0]] = new
        else:
            places.append(new)
        return tuple(places)

    def _name(self, command: CAxisCommand) -> str:
        return command.name or self._environment.parameters.c_axis_name
