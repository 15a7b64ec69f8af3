# SPDX-License-Identifier: MIT
"""Marks in the queue where something else comes into force.

In: the modal state after the words of a block. Out: a mark where it has changed, so that an
observer of a run sees it from the tick in which the block begins.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.state.queued.in_force import InForce, ModalMark
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import group_of


class InForceMarks:
    """Marks where something else is in force than in the block before."""

    def __init__(self, environment: DecoderEnvironment, state: ModalState) -> None:
        self._environment = environment
        self._state = state
        self._marked: InForce | None = None
        self._functions: dict[Group, int] = {}
        for function in environment.parameters.program_start.g_functions.values():
            self.note(function)

    def note(self, function: int) -> None:
        """Note a G function of a block."""
        group = group_of(function)
        if group is not None and group is not Group.MOTION:
            self._functions[group] = function

    @property
    def are_up_to_date(self) -> bool:
        """Whether the latest mark matches the functions in force."""
        return self._present() == self._marked

    def _present(self) -> InForce:
        functions = (self._state.motion, *self._functions.values())
        return InForce(tuple(sorted(functions)), self._state.tool.number)

    def of_block(self, span: Span, number: int) -> Iterator[Command]:
        """Yield a mark for a block if its words have changed anything."""
        found = self._present()
        if found != self._marked:
            self._marked = found
            source = self._environment.source_id(span)
            yield ModalMark(source, number, self._environment.modal_id(found))
