# SPDX-License-Identifier: MIT
"""``#CS`` of the main program -> the coordinate system that is active, as commands (MO-8).

In: the tree of a checked command. Stored systems have numbers; what is not stored gets the next
free one, which ends with it. Up to five are stored at a time.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.decoder.commands import Answer, Command
from nctakt.decoder.frames import MAIN_AXES
from nctakt.decoder.values import Values
from nctakt.diagnostics import Span
from nctakt.kernel import arithmetic
from nctakt.nc import syntax
from nctakt.nc.check_systems import SystemCommand, system_command

#: So many systems are stored at a time.
MOST_STORED = 5


class SystemCommands:
    """The ``#CS`` commands of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._surroundings = values.surroundings
        self._stored: dict[int, tuple[float, ...]] = {}
        self._latest = 0

    def command(self, statement: syntax.HashCommand, number: int) -> Generator[Command, Answer]:
        """One command."""
        command = system_command(statement)
        assert command is not None
        source = self._surroundings.place(statement.span)
        offsets = self._surroundings.offsets
        compensation = self._values.state.path.compensation
        if compensation.is_active:
            self._values.fail(900846, statement.span, command=f"#CS {command.action}")
        if command.action.startswith("OFF"):
            is_one = command.action == "OFF"
            if is_one and not offsets.systems.is_active:
                self._values.fail(900841, statement.span)
            for _ in range(1 if is_one else offsets.systems.count):
                yield from offsets.leave_system(source, number)
            return
        self._check_axes(statement.span)
        components = yield from self._components(command, statement.span, number)
        if command.action == "ON":
            yield from offsets.enter_system(components, source, number)

    def _check_axes(self, span: Span) -> None:
        axes = self._surroundings.axes
        if len(axes) < MAIN_AXES or not all(axis.is_linear for axis in axes[:MAIN_AXES]):
            self._values.fail(900843, span)

    def _components(
        self, command: SystemCommand, span: Span, number: int
    ) -> Generator[Command, Answer, tuple[float, ...]]:
        """The components of the system that is meant, stored where it has a number."""
        identity = self._latest
        if command.identity is not None:
            value = yield from self._values.evaluate(command.identity, number)
            identity = int(arithmetic.round_half_even(value))
        if command.components is None:
            if identity not in self._stored:
                known = ", ".join(map(str, self._stored)) or "–"
                self._values.fail(900840, span, id=identity, known=known)
            return self._stored[identity]
        found: list[float] = []
        for place, component in enumerate(command.components):
            value = yield from self._values.evaluate(component, number)
            found.append(value * self._values.state.length_unit_mm if place < 3 else value)
        if command.identity is None:
            if command.action == "ON":
                return tuple(found)
            identity = next(free for free in range(1, 7) if free not in self._stored)
        if identity not in self._stored and len(self._stored) >= MOST_STORED:
            self._values.fail(900844, span, most=MOST_STORED)
        self._stored[identity] = tuple(found)
        self._latest = identity
        return tuple(found)
