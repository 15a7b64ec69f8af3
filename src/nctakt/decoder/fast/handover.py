# SPDX-License-Identifier: MIT
"""Decides when plain blocks bypass the tree, and transfers the modal state.

In: the next lines of a long program. Out: a ``PlainRun``, which fills the queue directly
(``lines.py``) as long as plain blocks follow. The modal state is exported and imported again, so
that both paths alternate block by block; a block that the fast path does not accept is decoded from
its tree, with its diagnostics.
"""

from __future__ import annotations

import math
from collections.abc import Generator
from functools import cached_property
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import NO_SOURCE, pack
from nctakt.decoder.blocks.in_force_marks import InForceMarks
from nctakt.decoder.blocks.technology_output import TechnologyOutputs
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.decoder.fast.compensated_lines import CompensatedLines
from nctakt.decoder.fast.lines import PlainLines
from nctakt.decoder.pending_motion import plain_span
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.nc.fast.plain_lines import EMPTY, PLAIN, PlainScanner
from nctakt.nc.inspection import plain_scanner
from nctakt.nc.outline import SectionReader
from nctakt.nc.source import LineReader


class PendingContour(Protocol):
    """The compensated contour of a program, possibly none (``compensation.py``)."""

    @property
    def tool(self) -> ToolPath:
        """The path of the tool's centre."""

    def can_export(self) -> bool:
        """Return whether plain blocks may continue it; true without a contour."""

    def export_to(self, lines: CompensatedLines) -> None:
        """Export the pending contour."""

    def import_from(self, lines: CompensatedLines, file: str) -> None:
        """Import the pending contour; ``file``: the name of the text."""


class HeldMotions(Protocol):
    """The motions that a program holds until it knows the next one (``MotionStages``)."""

    @property
    def needs_next(self) -> bool:
        """Whether the next motion shapes the held one."""


class PlainBlocks:
    """The plain blocks of one program; at most ``max_blocks`` in a row may take no time."""

    def __init__(
        self,
        values: Values,
        uncertain_axes: UncertainAxes,
        technology: TechnologyOutputs,
        marks: InForceMarks | None,
        held: HeldMotions,
        contour: PendingContour,
        max_blocks: int,
    ) -> None:
        self._environment = values.environment
        self._state = values.state
        self._uncertain_axes = uncertain_axes
        self._technology = technology
        self._marks = marks
        self._held = held
        self._contour = contour
        self._max_blocks = max_blocks
        self._lines: LineReader | None = None
        self._file = ""
        self._run = PlainRun(0, 0, self)

    @cached_property
    def _scanner(self) -> PlainScanner:
        """Distinguishes plain lines from others; made for the first line of a long program."""
        return plain_scanner(self._environment.parameters, self._environment.places.names)

    @cached_property
    def _compensated(self) -> CompensatedLines:
        """The lines of a compensated contour, made for the first plain block."""
        return CompensatedLines(self._contour.tool, len(self._environment.axes))

    @cached_property
    def _plain_lines(self) -> PlainLines:
        """The lines, made for the first plain block."""
        axis_check = self._environment.offsets.transformation.axis_check
        lines = PlainLines(
            self._scanner, len(self._environment.axes), self._compensated, axis_check
        )
        lines.max_blocks = self._max_blocks
        lines.rapid_stops_exactly = self._environment.parameters.exact_stop_after_g00
        return lines

    def adapt(self) -> None:
        """Take the axes that the channel has now."""
        self.__dict__.pop("_scanner", None)
        self.__dict__.pop("_compensated", None)
        self.__dict__.pop("_plain_lines", None)

    def decode(self, reader: SectionReader, blocks: int) -> Generator[Command, Answer, int]:
        """Decode the plain blocks that follow; return ``blocks`` after them.

        ``blocks``: the number of blocks decoded since the last one that takes time.
        """
        lines = reader.lines
        if lines is None or not self._is_next_plain(lines) or not self._is_allowed():
            return blocks
        self._export_state(reader.source.file)
        plain = self._plain_lines
        if plain.is_left(lines.group, lines.index):
            return blocks
        plain.blocks = blocks
        self._lines = lines
        while self._lines is not None:
            yield self._run
        self._import_state()
        return self._plain_lines.blocks

    def _is_next_plain(self, lines: LineReader) -> bool:
        """Return whether the next line is plain; skip empty ones."""
        while lines.more():
            what = self._scanner.read(lines.group[lines.index])
            if what != EMPTY:
                return what == PLAIN
            lines.index += 1
        return False

    def _is_allowed(self) -> bool:
        """Return whether the state of the program allows plain lines."""
        return (
            self._state.allows_plain_lines
            and not self._environment.offsets.systems.is_active
            and self._is_unshaped
            and not self._is_transformed_otherwise
            and self._is_marked
            and self._uncertain_axes.is_empty
            and self._contour.can_export()
            and not self._technology.awaits_feed
        )

    @property
    def _is_marked(self) -> bool:
        """Whether plain lines need no marks but those of blocks."""
        if self._marks is None:
            return True
        return self._marks.are_up_to_date and not self._state.path.compensation.is_active

    @property
    def _is_unshaped(self) -> bool:
        """Whether no plain line changes the motions before it, nor waits with them."""
        state = self._state
        if state.shapes.open_line is not None or self._held.needs_next:
            return False
        is_transformed = self._environment.offsets.transformation.is_active
        if state.path.contouring and (is_transformed or state.path.contour.is_own):
            return False
        return not state.shapes.waits_for_next or not state.path.compensation.is_active

    @property
    def _is_transformed_otherwise(self) -> bool:
        """Whether a transformation changes lines: by the tool's radius, or under ``#PTP``."""
        transformation = self._environment.offsets.transformation
        is_compensated = transformation.is_active and self._state.path.compensation.is_active
        return is_compensated or transformation.is_straight

    def _export_state(self, file: str) -> None:
        plain, state = self._plain_lines, self._state
        environment = self._environment
        is_transformed = environment.offsets.transformation.is_active
        plain.is_transformed = is_transformed
        is_linear = environment.offsets.transformation.is_linear
        self._file = file
        plain.marks = self._marks is not None
        if plain.marks:
            stack = state.call_stack
            plain.calls = stack.path_number_of(environment.path_id)
            plain.depth = len(stack.frames)
        plain.leaves_last = state.shapes.waits_for_next
        plain.leaves_functions = state.path.contouring and not state.path.compensation.is_active
        for index, axis in enumerate(environment.axes):
            is_free = axis.is_modulo or is_transformed
            low, high = state.software_limits.of(axis, index)
            plain.set_axis(
                index,
                state.positions[index],
                environment.offsets.total(index),
                state.length_unit_mm if is_linear(index, axis) else 1.0,
                -math.inf if is_free else low,
                math.inf if is_free else high,
            )
        feed_unit = environment.parameters.program_start.feed_unit_mm_min
        plain.block_number = state.block_number
        plain.motion = state.motion
        plain.feed_v = state.feed_mm_s
        plain.feed_factor = state.length_unit_mm if state.inch else feed_unit
        plain.is_absolute = state.absolute
        plain.stops_exactly = state.path.exact_stop
        plain.deviation = state.path.rounding
        plain.limits_jerk = state.path.limits_jerk
        self._contour.export_to(self._compensated)
        source = environment.source_id(Span(file, 1, 1, 2))
        plain.source_base = -1 if source == NO_SOURCE else source - pack(0, 1, 1)

    def _import_state(self) -> None:
        plain, state = self._plain_lines, self._state
        state.positions = plain.axis_positions()
        state.motion = plain.motion
        state.block_number = plain.block_number
        state.feed_mm_s = plain.feed_v
        if self._compensated.is_on:
            self._contour.import_from(self._compensated, self._file)

    def fill(self, queue: CommandQueue, timed: int, tick: int) -> None:
        """Fill the queue with up to ``timed`` commands that take time, or up to the next other
        block.

        Called by the consumer of the ``PlainRun`` in ``tick``.
        """
        plain = self._plain_lines
        plain.tick = tick
        before = plain.source
        self._fill(queue, timed)
        if plain.marks and plain.source != before:
            span = plain_span(plain.source, self._file, self._environment.line_text)
            self._state.call_stack.top.current = span

    def _fill(self, queue: CommandQueue, timed: int) -> None:
        lines = self._lines
        assert lines is not None
        queue.reserve(timed)
        if not self._plain_lines.resume(queue, timed):
            return
        while queue.timed_count < timed:
            if not lines.more():
                self._lines = None
                return
            lines.index = self._plain_lines.fill(
                queue, timed, lines.group, lines.index, lines.number
            )
            if lines.index < len(lines.group) and queue.timed_count < timed:
                self._lines = None
                return


@dataclass(frozen=True, slots=True)
class PlainRun(Command):
    """Plain blocks follow; ``blocks`` puts them into the queue."""

    blocks: PlainBlocks
