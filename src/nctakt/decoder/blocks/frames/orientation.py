# SPDX-License-Identifier: MIT
"""The direction of the tool as a vector: A, B, C under ``#ORI MODE [VECTOR_2DOF]``, P-CHAN-00177.

In: the words of a block while a transformation is active, a vector from the tool's tip to its clamp
in the directions of the machine. Out: axis words of the rotary axes that turn the tool there.
"""

from __future__ import annotations

from collections.abc import Collection, Generator, Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.blocks.axes.moved_axes import MovedAxes
from nctakt.decoder.blocks.block_content import AxisValues, BlockContent
from nctakt.decoder.kinematics.selection import REASONS
from nctakt.decoder.state.axis_places import AxisNotInChannelError
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel.kinematics import map_rows
from nctakt.messages.path.transformations import POSITION_NOT_REACHED
from nctakt.messages.programs.checked_blocks import UNKNOWN_WORD
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import AXIS_VALUES, AXIS_WEIGHTS, DWELL, REFERENCE_OFFSET
from nctakt.nc.vocabulary.orientation import ANGLE, VECTOR, VECTOR_WORDS

#: G functions whose axis words are no positions.
_OTHER_VALUES = frozenset((*AXIS_VALUES, *AXIS_WEIGHTS, DWELL, REFERENCE_OFFSET))


class Orientation:
    """The direction of the tool in one program."""

    def __init__(self, values: Values, moved: MovedAxes) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._moved = moved
        self._transformation = values.environment.offsets.transformation
        mode = values.environment.parameters.transformations.orientation_mode
        self._state.orientation = VECTOR if mode == VECTOR else ANGLE

    @property
    def has_vector(self) -> bool:
        """Whether A, B and C are components of a vector."""
        return self._state.orientation == VECTOR and self._transformation.is_transformation

    def check(self, word: tree.AxisWord, functions: Collection[int]) -> None:
        """Raise ``DecodeError`` for a word of no axis that is not a component.

        Raise ``AxisNotInChannelError`` for an axis that the channel does not have now.
        """
        if not self.has_vector or not _OTHER_VALUES.isdisjoint(functions):
            if self._environment.names.axis(word.name) is not None:
                raise AxisNotInChannelError(word.name)
            axes = ", ".join(self._environment.axis_numbers)
            self._values.fail(UNKNOWN_WORD, word.span, word=word.name, axes=axes, nearest=NOTHING)

    def resolve(self, content: BlockContent, span: Span, number: int) -> Generator[Command, Answer]:
        """Replace the components of a vector by words of the rotary axes; missing ones are 0."""
        given = {word.name: value for word, value in content.axes if word.name in VECTOR_WORDS}
        if not given:
            return
        content.axes = [one for one in content.axes if one[0].name not in VECTOR_WORDS]
        vector = self._in_machine([given.get(name, 0.0) for name in VECTOR_WORDS])
        yield from self._moved.request(self._transformation.with_moved([]), span, number)
        result, answer = self._transformation.aim(
            self._transformation.number, vector, self._state.positions
        )
        if answer != map_rows.REACHED:
            self._values.fail(POSITION_NOT_REACHED, span, reason=REASONS[answer])
        content.axes += self.words_to(result, content.path.offset_kinds, span)

    def _in_machine(self, vector: list[float]) -> list[float]:
        """Return a programmed vector in directions of the machine (P-CHAN-00247)."""
        systems = self._environment.offsets.systems
        parameters = self._environment.parameters.transformations
        if not parameters.has_vector_in_system or not systems.is_active:
            return vector
        x, y, z = (systems.direction(axis) for axis in range(3))
        return [vector[0] * x[i] + vector[1] * y[i] + vector[2] * z[i] for i in range(3)]

    def words_to(self, positions: Sequence[float], kinds: int, span: Span) -> AxisValues:
        """Return words for the axes that are to go to other positions than the present ones."""
        begin = self._programmed(self._state.positions, kinds)
        end = self._programmed(positions, kinds)
        words: AxisValues = []
        for name, axis in self._environment.axis_numbers.items():
            if end[axis] != begin[axis]:
                value = end[axis] if self._state.absolute else end[axis] - begin[axis]
                words.append((tree.AxisWord(span, name, None), value))
        return words

    def _programmed(self, positions: Sequence[float], kinds: int) -> list[float]:
        """Return how positions of the axes would be programmed."""
        offsets = self._environment.offsets
        inside = offsets.inside(positions, kinds)
        return self._state.frame.inside(
            [value - offsets.total(axis, kinds) for axis, value in enumerate(inside)]
        )
