# SPDX-License-Identifier: MIT
"""One reading of a program by parser, checker, linter and the checker of the path.

In: its text and channel. Out: findings, and the program's links to others, each as a list in the
order of the text. Between two statements the reading has a state from which another can continue:
later findings depend on nothing else.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.line_shift import LineShift
from nctakt.checking.path_checker import MAX_LINES, PathChecker, PathState
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.nc.check.blocks import Role
from nctakt.nc.check.cycles.branches import branch_outlines, realtime_cycles
from nctakt.nc.check.findings import Findings
from nctakt.nc.inspection import Inspection, InspectionState
from nctakt.nc.lint.cycle_uses import CycleUse
from nctakt.nc.lint.linter import GlobalCycle, Linter, LinterState
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.outline import AxisUse, Call, SignalUse
from nctakt.nc.plain_shapes import PlainShapes
from nctakt.nc.source import Source
from nctakt.nc.tree import Statement
from nctakt.nc.vocabulary.variables.variable_table import NameTable


@dataclass(frozen=True, slots=True)
class ProgramChannel:
    """The channel, by its number, for which a program is checked, and the program's part.

    ``is_shifted``: offsets act from the start. ``role``: ``called`` if it is only called by others.
    ``speed_limits``: spindle -> its highest speed in 1/min, of those with one gear step.
    """

    names: NameTable
    parameters: ChannelParameters
    limits: StepLimits
    tools: Mapping[int, Tool] = field(default_factory=dict)
    role: Role = "either"
    axes: Mapping[str, AxisConfiguration] = field(default_factory=dict)
    is_shifted: bool = False
    number: int = 1
    speed_limits: Mapping[str, float] = field(default_factory=dict)

    def is_same(self, other: ProgramChannel) -> bool:
        """Return whether it is the same channel of the same machine as loaded then."""
        return self.names is other.names and self.parameters is other.parameters


@dataclass(frozen=True, slots=True)
class PassState:
    """The state of a reading between two statements."""

    inspection: InspectionState
    linter: LinterState
    path: PathState

    @property
    def size(self) -> int:
        """How many values are in it."""
        return self.inspection.size + self.linter.size

    def shifted(self, shift: LineShift) -> PassState:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        if not shift.by:
            return self
        inspection, linter = self.inspection.shifted(shift), self.linter.shifted(shift)
        return PassState(inspection, linter, self.path.shifted(shift))


class ProgramPass:
    """A reading; ``inspection`` runs it, ``results`` are the lists that grow with it.

    Programs of more than ``MAX_LINES`` are not followed along their path.
    """

    def __init__(
        self, source: Source, channel: ProgramChannel, shapes: PlainShapes | None = None
    ) -> None:
        self.source = source
        self.is_followed = len(source.lines) <= MAX_LINES
        self.of_lint, self.of_path = Collector(), Collector()
        parameters = channel.parameters
        self.linter = Linter(
            source,
            channel.names,
            channel.limits,
            self.of_lint,
            channel.tools,
            parameters.tool_selection,
        )
        self.path = PathChecker(
            parameters,
            channel.axes,
            Findings(source, self.of_path),
            begins=channel.role != "called",
            is_shifted=channel.is_shifted,
            speed_limits=channel.speed_limits,
        )
        #: The lines of all branches of realtime cycles.
        self.branch_lines: list[int] = []
        self.inspection = Inspection(
            source,
            channel.names,
            parameters,
            channel.role,
            self,
            shapes,
            keeps_statements=False,
        )

    # --- as the watcher of the inspection --------------------------------------------------------

    @property
    def sees_next_block(self) -> bool:
        """Whether a plain block of a known shape may matter."""
        return self.is_followed or self.linter.sees_next_block

    def section(self, *, is_main: bool) -> None:
        """Begin a main program or a subprogram."""
        self.linter.section()
        self.path.section(is_main=is_main)

    def statement(self, statement: Statement) -> None:
        """Visit a statement."""
        for cycle in realtime_cycles((statement,)):
            self.branch_lines += [branch.span.line for branch in branch_outlines(cycle)]
        self.linter.statement(statement)
        if self.is_followed:
            self.path.statement(statement)

    # --- its state and results -------------------------------------------------------------------

    @property
    def state(self) -> PassState:
        """State that later statements depend on; only in a pause of the inspection."""
        return PassState(self.inspection.state, self.linter.state, self.path.state)

    def resume(self, state: PassState, line: int) -> None:
        """Continue from a state before a line."""
        self.inspection.resume(state.inspection, line)
        self.linter.resume(state.linter)
        self.path.resume(state.path)

    @property
    def results(self) -> tuple[list[Any], ...]:
        """All lists that grow while it reads; ``shifters`` has a function for each."""
        return (
            self.inspection.found,
            self.of_lint.diagnostics,
            self.of_path.diagnostics,
            self.inspection.program.calls,
            self.inspection.program.signals,
            self.inspection.program.exchanges,
            self.inspection.local_calls,
            self.linter.defined,
            self.linter.deleted,
            self.linter.cycle_uses,
            self.path.subprogram_ends,
            self.branch_lines,
        )


def shifters(shift: LineShift) -> tuple[Callable[[Any], Any], ...]:
    """Return a function for each list of ``ProgramPass.results`` that moves one of its items."""

    def call(item: Call) -> Call:
        return Call(item.name, shift.span(item.span))

    def cycle(item: GlobalCycle) -> GlobalCycle:
        return GlobalCycle(item.identity, shift.span(item.span), item.line)

    def signal(item: SignalUse) -> SignalUse:
        return replace(item, span=shift.span(item.span))

    def exchange(item: AxisUse) -> AxisUse:
        return replace(item, span=shift.span(item.span))

    def use(item: CycleUse) -> CycleUse:
        return item.shifted(shift)

    def same(item: int | None) -> int | None:
        return item

    found = shift.diagnostic
    span: Callable[[Span], Span] = shift.span
    return found, found, found, call, signal, exchange, call, cycle, same, use, span, shift.line
