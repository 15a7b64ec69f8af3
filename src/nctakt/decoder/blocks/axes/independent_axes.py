# SPDX-License-Identifier: MIT
"""``X[INDP_SYN …]`` and ``X[INDP_ASYN …]``: axes that a program moves independently of the path.

The rules SA-1 … SA-9 are in docs/conformance/single-axes.md. A command waits until an axis whose
position is uncertain is at rest, even in a motion that the program itself has begun (SA-4); the
decoder continues to compute from the target that it gives.
"""

from __future__ import annotations

from collections.abc import Collection, Generator

from nctakt.decoder.axis_limits import feed_unit
from nctakt.decoder.blocks.axes.moved_axes import MovedAxes
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.state.queued.axis_commands import EndOscillation, MoveAlone, Oscillate
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.messages.axes.axis_motions import INDP_TARGET_OUTSIDE_LIMITS
from nctakt.messages.axes.independent_axes import (
    AXIS_MOVED_TWICE,
    AXIS_VALUE_INVALID,
    INDEPENDENT_IN_TRANSFORMATION,
)
from nctakt.nc import tree
from nctakt.nc.vocabulary.single_axes.axis_brackets import form_of
from nctakt.nc.vocabulary.single_axes.independent_axes import (
    IndependentCommand,
    is_valid,
    read_independent,
)


class IndependentAxes:
    """The independent axes of one program."""

    def __init__(self, values: Values, moved: MovedAxes, uncertain_axes: UncertainAxes) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._moved = moved
        self._uncertain_axes = uncertain_axes

    def read(
        self, bracket: tree.BracketCommand, number: int, content: BlockContent
    ) -> Generator[Command, Answer]:
        """Evaluate a command and note it in the block's content; raises ``DecodeError``."""
        command, _, _ = read_independent(bracket)
        assert command.position is not None
        name, offsets = command.axis, self._environment.offsets
        named = {"axis": name, "form": command.form}
        self._values.check_flush_allowed(f"{name}[{command.form} …]", command.span)
        if offsets.transformation.is_active:
            self._values.fail(INDEPENDENT_IN_TRANSFORMATION, command.span, **named)
        speeds = {}
        for word, expression in command.speeds.items():
            value = speeds[word] = yield from self._values.evaluate(expression, number)
            if not is_valid(word, value):
                values = {"word": word, "value": value}
                self._values.fail(AXIS_VALUE_INVALID, expression.span, **values, **named)
        position = yield from self._values.evaluate(command.position, number)
        yield from self._moved.request([name], command.span, number)
        index = self._environment.axis_numbers[name]
        axis = self._environment.axes[index]
        value = position * self._state.length_unit_mm if axis.is_linear else position
        if command.absolute and command.with_offsets:
            value += offsets.total(index)
        start = self._state.positions[index]
        distance = self._distance(axis, start, value) if command.absolute else value
        self._check_limits(axis, index, start + distance, command)
        traits = self._environment.names.axis(name)
        assert traits is not None
        source = self._environment.source_id(command.span)
        speed = self._speed(axis, speeds, abs(distance))
        move = MoveAlone(source, number, traits.number, value, speed, not command.absolute)
        content.independent += ((bracket, move),)
        content.awaited += (name,) if command.waits else ()
        self._state.positions = list(self._state.positions)
        self._state.positions[index] = self._within(axis, start + distance)

    def _distance(self, axis: AxisConfiguration, start: float, target: float) -> float:
        """Return the distance to a position; a modulo axis goes the shorter way."""
        full = axis.modulo_range
        if not axis.is_modulo:
            return target - start
        away = self._within(axis, target) - self._within(axis, start)
        return away - full * arithmetic.ceiling(away / full - 0.5)

    def _within(self, axis: AxisConfiguration, position: float) -> float:
        if not axis.is_modulo:
            return position
        return arithmetic.within(position, axis.dynamics.modulo_low, axis.modulo_range)

    def _check_limits(
        self, axis: AxisConfiguration, index: int, target: float, command: IndependentCommand
    ) -> None:
        """Check a target against the software limits in force; raises ``DecodeError`` 60158."""
        low, high = self._state.software_limits.of(axis, index)
        if not axis.is_modulo and not low <= target <= high:
            assert command.position is not None
            self._values.fail(
                INDP_TARGET_OUTSIDE_LIMITS,
                command.position.span,
                axis=command.axis,
                target=target,
                low=low,
                high=high,
            )

    def _speed(self, axis: AxisConfiguration, speeds: dict[str, float], distance: float) -> float:
        """Return the speed of a motion, mm/s or degrees/s, at most that of the axis."""
        if "FEED" in speeds:
            listed_mm_min = self._environment.parameters.program_start.feed_unit_mm_min
            unit = feed_unit(axis, self._state, listed_mm_min)
            return min(speeds["FEED"] * unit, axis.max_speed)
        if "TIME" in speeds:
            return min(distance / speeds["TIME"], axis.max_speed) if distance else axis.max_speed
        if "FEED_MAX_WEIGHT" in speeds:
            return axis.max_speed * speeds["FEED_MAX_WEIGHT"] / 100.0
        return axis.rapid_speed

    def begin(self, content: BlockContent, path: Collection[str]) -> Generator[Command, Answer]:
        """Yield the beginnings of the motions; ``path``: the axes that the block moves with the
        path.
        """
        for bracket, move in content.independent:
            if bracket.name in path:
                form = form_of(bracket)
                self._values.fail(AXIS_MOVED_TWICE, bracket.span, axis=bracket.name, form=form)
            match move:
                case MoveAlone():
                    self._uncertain_axes.move_alone(bracket.name)
                case Oscillate():
                    self._uncertain_axes.oscillate(bracket.name)
                case EndOscillation(how=how):
                    halts = how == codes.HALTS
                    self._uncertain_axes.end_oscillation(bracket.name, anywhere=halts)
            yield move

    def without_resting(self, names: list[str], target: list[float]) -> list[str]:
        """Return the axes of a block without those that it leaves where the program sends them.

        ``target``: the end of the block (SA-6, P-CHAN-00451).
        """
        if self._environment.parameters.awaits_idle_axes:
            return names
        numbers, positions = self._environment.axis_numbers, self._state.positions
        resting = {
            name
            for name in self._uncertain_axes.of_program(names)
            if target[numbers[name]] == positions[numbers[name]]
        }
        return [name for name in names if name not in resting]
