# SPDX-License-Identifier: MIT
"""Commands to spindles: what may stand together (RC-404).

In: a ``SpindleCommand``. Out: diagnostics. The main program may give speed, direction and position
in several blocks; a realtime cycle gives a whole job in one.
"""

from __future__ import annotations

from nctakt.lists.channel_configuration import ChannelParameters
from nctakt.nc.check_values import ValueChecker
from nctakt.nc.findings import Findings
from nctakt.nc.spindle_commands import (
    CLOCKWISE,
    COUNTER_CLOCKWISE,
    POSITION,
    STOP,
    SpindleCommand,
)


class SpindleChecker:
    """Checks commands to the spindles of one channel; ``in_cycle``: those of realtime cycles."""

    def __init__(
        self,
        channel: ChannelParameters,
        values: ValueChecker,
        findings: Findings,
        *,
        in_cycle: bool,
    ) -> None:
        self._has_main = any(spindle.is_main for spindle in channel.spindles)
        self._values = values
        self._findings = findings
        self._in_cycle = in_cycle

    def check(self, command: SpindleCommand) -> None:
        """One command."""
        if not command.name and not self._has_main:
            self._findings.report(900473, command.span)
        for word in command.wrong:
            written = self._findings.written(word.span)
            self._findings.report(900282, word.span, word=written)
        for doubled in command.doubled:
            self._findings.report(900224, doubled.span, word=self._findings.written(doubled.span))
        for value in (command.speed, command.position):
            if value is not None:
                self._values.value(value)
        if command.wrong or command.doubled:
            return
        fits = self._is_job(command) if self._in_cycle else self._fits(command)
        if not fits:
            self._findings.report(50954, command.span, command=self._findings.written(command.span))

    def _fits(self, command: SpindleCommand) -> bool:
        """Whether the words of the main program go together."""
        turns = [one for one in command.functions if one in (CLOCKWISE, COUNTER_CLOCKWISE)]
        if len(turns) > 1 or (STOP in command.functions and len(command.functions) > 1):
            return False
        if command.position is not None and POSITION not in command.functions:
            return False
        return bool(command.functions) or command.speed is not None

    def _is_job(self, command: SpindleCommand) -> bool:
        """Whether they are a complete job: turn, go to a position, or stop."""
        functions = sorted(command.functions)
        given = (command.speed is not None, command.position is not None)
        if functions == [STOP]:
            return given == (False, False)
        if len(functions) == 1:
            return functions[0] != POSITION and given == (True, False)
        turns = functions[:1] in ([CLOCKWISE], [COUNTER_CLOCKWISE])
        return turns and functions[1:] == [POSITION] and given == (True, True)
