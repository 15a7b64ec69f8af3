# SPDX-License-Identifier: MIT
"""Realtime loops, ``#RT WHILE … #RT ENDWHILE``: the statements allowed in them.

The realtime part repeats commands that were decoded once. A loop may therefore contain only motions
with G00 to G03, assignments to synchronous V.E variables, and signals with SYN, without waiting for
the realtime part (22073).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.path.backward import NOT_ALLOWED_IN_RT_WHILE, RT_WHILE_NESTED
from nctakt.messages.programs.checked_cycles import REALTIME_CYCLES_OFF
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.signals import is_in_block_order
from nctakt.nc.meaning.path import SWITCHES
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Block,
    BlockWord,
    Expression,
    HashCommand,
    Number,
    RealtimeLoop,
    Statement,
    Unreadable,
    Variable,
    Word,
)
from nctakt.nc.vocabulary.functions import MOTIONS
from nctakt.nc.vocabulary.variables.resolution import resolve, variables_in
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable

#: Words of a motion besides its axes: centre, radius, feed.
_VALUES = ("I", "J", "K", "R", "F")


class LoopChecker:
    """Checks loops; ``check`` checks each statement that is allowed in a loop."""

    def __init__(
        self,
        channel: ChannelParameters,
        names: NameTable,
        findings: Findings,
        check: Callable[[Statement], None],
    ) -> None:
        self._channel = channel
        self._names = names
        self._findings = findings
        self._check = check

    def loop(self, loop: RealtimeLoop) -> None:
        """Check the loop with its body."""
        if not self._channel.realtime_cycles.enable:
            self._findings.report(REALTIME_CYCLES_OFF, loop.span, command="#RT WHILE")
        for statement in loop.body:
            if self._belongs(statement):
                self._check(statement)

    def _belongs(self, statement: Statement) -> bool:
        match statement:
            case Block():
                return self._motion(statement)
            case Assignment():
                return self._writes(statement)
            case RealtimeLoop():
                self._findings.report(RT_WHILE_NESTED, statement.span, found="#RT WHILE")
                return False
            case Unreadable():
                return False
            case HashCommand() if is_in_block_order(statement):
                return True
        self._refuse(statement)
        return False

    def _refuse(self, node: Statement | BlockWord | Expression) -> None:
        self._findings.report(
            NOT_ALLOWED_IN_RT_WHILE, node.span, command=self._findings.written(node.span)
        )

    def _motion(self, block: Block) -> bool:
        wrong = next((word for word in block.words if not self._is_of_motion(word)), None)
        if wrong is not None:
            self._refuse(wrong)
            return False
        return self._is_known_ahead(value for word in block.words for value in _values(word))

    def _is_of_motion(self, word: BlockWord) -> bool:
        if isinstance(word, AxisWord):
            return True
        if not isinstance(word, Word) or word.arguments or word.additional is not None:
            return False
        if word.name == "G":
            return isinstance(word.value, Number) and word.value.value in MOTIONS
        return word.name in _VALUES or word.name in SWITCHES

    def _writes(self, statement: Assignment) -> bool:
        target = statement.target
        if not isinstance(target, Variable) or target.family != "E":
            self._refuse(statement)
            return False
        location = resolve(target, self._names)
        if isinstance(location, Location) and not (location.synchronous or target.synchronous):
            self._refuse(statement)
            return False
        values = [statement.value] if isinstance(statement.value, Expression) else []
        if statement.operator != "=":
            values.append(target)
        return self._is_known_ahead(values)

    def _is_known_ahead(self, values: Iterator[Expression] | list[Expression]) -> bool:
        """Return whether the decoder knows the values without the realtime part; report others."""
        for value in values:
            for variable in variables_in(value):
                location = resolve(variable, self._names)
                if isinstance(location, Location) and (
                    location.synchronous or variable.synchronous
                ):
                    self._refuse(variable)
                    return False
        return True


def _values(word: BlockWord) -> Iterator[Expression]:
    value = getattr(word, "value", None)
    if isinstance(value, Expression):
        yield value
