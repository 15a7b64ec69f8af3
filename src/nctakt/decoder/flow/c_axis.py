# SPDX-License-Identifier: MIT
"""``#CAX``: the main spindle becomes an axis of the path, and a spindle again.

In: checked nodes. Out: the job that stops the spindle, and the axes that the channel has then; the
exchange itself is that of ``axis_exchange.py``.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Text
from nctakt.decoder.blocks.axes.spindles import main_of
from nctakt.decoder.state.axis_places import AxisPlace, Places, trimmed
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.spindle_commands import AwaitSpindle, SpindleJob
from nctakt.decoder.values.variables import Values
from nctakt.messages.axes.axis_exchange import AXIS_TWICE
from nctakt.messages.axes.c_axis import C_AXIS_IN_PLANE, C_AXIS_OF_OTHER_SPINDLE
from nctakt.messages.axes.spindles import SPINDLE_WITHOUT_AXIS
from nctakt.nc import tree
from nctakt.nc.meaning.axes import CAxisCommand, c_axis_command
from nctakt.nc.vocabulary.functions import SPINDLE_STOP


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
