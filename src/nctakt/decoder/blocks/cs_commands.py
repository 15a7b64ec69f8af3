# SPDX-License-Identifier: MIT
"""``#CS`` of the main program -> commands for the active coordinate system (MO-8).

In: the tree of a checked command. Stored systems have numbers; one without gets the next free
number. At most five are stored. Systems with names (``#CS ADD``) form a stack; ``#CS SELECT``
activates it from the bottom up to one of them.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.state.commands import Answer, Command
from nctakt.decoder.state.coordinate_systems import MAIN_AXES
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.coordinate_systems import (
    COORDINATE_SYSTEM_DURING_COMPENSATION,
    COORDINATE_SYSTEM_NAME_TAKEN,
    COORDINATE_SYSTEM_NOT_STORED,
    COORDINATE_SYSTEM_STACK_FULL,
    CS_SELECT_DURING_CS_ON,
    LINEAR_AXES_MISSING,
    MACHINE_SYSTEM_MISSING,
    NO_COORDINATE_SYSTEM_ACTIVE,
    TOO_MANY_COORDINATE_SYSTEMS,
    UNKNOWN_COORDINATE_SYSTEM_NAME,
)
from nctakt.messages.transformations import COORDINATE_SYSTEM_DURING_PTP
from nctakt.nc import tree
from nctakt.nc.check.coordinate_systems import MACHINE_SYSTEM, CsCommand, cs_command

#: Maximum number of stored systems.
MAX_STORED = 5


class CsCommands:
    """The ``#CS`` commands of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._stored: dict[int, tuple[float, ...]] = {}
        self._latest = 0
        self._stack: dict[str, tuple[float, ...]] = {}
        self._selected = 0

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one command."""
        command = cs_command(statement)
        assert command is not None
        source = self._environment.source_id(statement.span)
        offsets = self._environment.offsets
        compensation = self._values.state.path.compensation
        if compensation.is_active:
            self._values.fail(
                COORDINATE_SYSTEM_DURING_COMPENSATION,
                statement.span,
                command=f"#CS {command.action}",
            )
        if offsets.transformation.is_straight and command.action not in ("DEF", "ADD"):
            shown = f"#CS {command.action}"
            self._values.fail(COORDINATE_SYSTEM_DURING_PTP, statement.span, command=shown)
        if command.action.startswith("OFF"):
            if command.action == "OFF" and not offsets.systems.is_active:
                self._values.warn(NO_COORDINATE_SYSTEM_ACTIVE, statement.span)
                return
            count = offsets.systems.count
            if command.action == "OFF":
                count = 1 if count > self._selected else self._selected
            yield from self._leave(count, source, number)
            return
        self._check_axes(statement.span)
        if command.action == "ADD":
            yield from self._add(command, statement.span, number)
            return
        if command.action == "SELECT":
            yield from self._select(command.name, statement.span, number)
            return
        components = yield from self._components(command, statement.span, number)
        if command.action == "ON":
            yield from offsets.enter_system(components, source, number)

    def stored(self, value: float, span: Span) -> tuple[float, ...]:
        """Return the components of the stored system of a number."""
        identity = int(arithmetic.round_half_even(value))
        if identity not in self._stored:
            stored = ", ".join(map(str, self._stored)) or NOTHING
            self._values.fail(COORDINATE_SYSTEM_NOT_STORED, span, id=identity, known=stored)
        return self._stored[identity]

    def _leave(self, count: int, source: int, number: int) -> Generator[Command, Answer]:
        """Deactivate ``count`` systems, the innermost first; a selected stack as a whole."""
        offsets = self._environment.offsets
        for _ in range(count):
            yield from offsets.leave_system(source, number)
        self._selected = min(self._selected, offsets.systems.count)

    def _add(self, command: CsCommand, span: Span, number: int) -> Generator[Command, Answer]:
        """Push a system onto the stack (``#CS ADD``) without activating it."""
        name, names = command.name, ", ".join(self._stack)
        if name in self._stack:
            self._values.fail(COORDINATE_SYSTEM_NAME_TAKEN, span, name=name, known=names)
        if len(self._stack) >= MAX_STORED:
            self._values.fail(
                COORDINATE_SYSTEM_STACK_FULL, span, name=name, maximum=MAX_STORED, known=names
            )
        assert command.components is not None
        self._stack[command.name] = yield from self._evaluated(command.components, number)

    def _select(self, name: str, span: Span, number: int) -> Generator[Command, Answer]:
        """Activate the stack from the bottom up to a system (``#CS SELECT``).

        MCS is the system of an active transformation, below the stack.
        """
        offsets = self._environment.offsets
        is_machine = name == MACHINE_SYSTEM
        if is_machine and not offsets.transformation.is_transformation:
            self._values.fail(MACHINE_SYSTEM_MISSING, span)
        if name not in self._stack and not is_machine:
            names = ", ".join(self._stack) or "–"
            self._values.fail(UNKNOWN_COORDINATE_SYSTEM_NAME, span, name=name, known=names)
        if offsets.systems.count > self._selected:
            self._values.fail(CS_SELECT_DURING_CS_ON, span)
        source = self._environment.source_id(span)
        yield from self._leave(self._selected, source, number)
        if is_machine:
            return
        for other, components in self._stack.items():
            yield from offsets.enter_system(components, source, number)
            self._selected += 1
            if other == name:
                return

    def _evaluated(
        self, components: Sequence[tree.Expression], number: int
    ) -> Generator[Command, Answer, tuple[float, ...]]:
        """Return the components: shift in mm, angles in degrees."""
        values: list[float] = []
        for index, component in enumerate(components):
            value = yield from self._values.evaluate(component, number)
            values.append(value * self._values.state.length_unit_mm if index < 3 else value)
        return tuple(values)

    def _check_axes(self, span: Span) -> None:
        axes = self._environment.axes
        if self._environment.places.lacks_any(range(MAIN_AXES)) or not all(
            axis.is_linear for axis in axes[:MAIN_AXES]
        ):
            self._values.fail(LINEAR_AXES_MISSING, span)

    def _components(
        self, command: CsCommand, span: Span, number: int
    ) -> Generator[Command, Answer, tuple[float, ...]]:
        """Return the components of the system and store them if it has a number."""
        identity = self._latest
        if command.identity is not None:
            value = yield from self._values.evaluate(command.identity, number)
            identity = int(arithmetic.round_half_even(value))
        if command.components is None:
            return self.stored(identity, span)
        components = yield from self._evaluated(command.components, number)
        if command.identity is None:
            if command.action == "ON":
                return components
            identity = next(free for free in range(1, 7) if free not in self._stored)
        if identity not in self._stored and len(self._stored) >= MAX_STORED:
            self._values.fail(TOO_MANY_COORDINATE_SYSTEMS, span, maximum=MAX_STORED)
        self._stored[identity] = components
        self._latest = identity
        return components
