# SPDX-License-Identifier: MIT
"""Single-axis commands of realtime cycles, checked before the run.

In: brackets with INDP in the body of a cycle. Out: diagnostics (RC-405 … RC-407): which axis may be
moved independently, which keywords exclude or need each other. The tick checks everything that
depends on values.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.messages.programs.checked_axes import INDEPENDENT_MOTION_NOT_PERMITTED, INDP_OF_SPINDLE
from nctakt.nc.check.blocks import WordChecker
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import BracketCommand, Statement
from nctakt.nc.vocabulary.single_axes.axis_commands import (
    AxisCommand,
    Finding,
    axis_commands_in,
    is_axis_command,
    read_axis_command,
    refusal,
    whole_span,
)
from nctakt.nc.vocabulary.variables.variable_table import NameTable


class AxisCommandChecker:
    """Checks the single-axis commands of one cycle after another."""

    def __init__(
        self, names: NameTable, words: WordChecker, values: ValueChecker, findings: Findings
    ) -> None:
        self._names = names
        self._words = words
        self._values = values
        self._findings = findings
        self._with_feed: dict[str, None] = {}

    def begin(self, body: Sequence[Statement]) -> None:
        """Begin a cycle with this body; note which of its axes get a FEED."""
        commands = [read_axis_command(bracket)[0] for bracket in axis_commands_in(body)]
        self._with_feed = {command.axis: None for command in commands if command.feed is not None}

    def command(self, bracket: BracketCommand) -> None:
        """Check one command."""
        assert is_axis_command(bracket)
        command, findings = read_axis_command(bracket)
        self._axis(bracket)
        if not findings:
            findings = self._needs(command, bracket)
        for finding in findings:
            self._report(finding)
        reported = {finding.span for finding in findings}
        values = [value for value in command.expressions() if whole_span(value) not in reported]
        self._values.block(*values)

    def _axis(self, bracket: BracketCommand) -> None:
        """Check that the axis belongs to the channel and may be moved independently (RC-406)."""
        axis = self._names.axis(bracket.name)
        if bracket.name in self._words.spindles:
            self._findings.report(INDP_OF_SPINDLE, bracket.span, spindle=bracket.name)
        elif axis is None:
            self._words.unknown(bracket)
        elif not axis.moves_alone:
            self._findings.report(INDEPENDENT_MOTION_NOT_PERMITTED, bracket.span, axis=bracket.name)

    def _needs(self, command: AxisCommand, bracket: BracketCommand) -> list[Finding]:
        """Return the unmet needs of a command: a modulo axis, a FEED elsewhere in the cycle."""
        if command.position is None:
            return []
        if command.rapid is False and command.axis not in self._with_feed:
            return [refusal(bracket, 7)]
        return []

    def _report(self, wrong: Finding) -> None:
        values = dict(wrong.values)
        if wrong.written:
            values[wrong.written] = self._findings.written(wrong.span)
        self._findings.report(wrong.message, wrong.span, **values)
