# SPDX-License-Identifier: MIT
"""When plain blocks take the short way, and what they find and leave there.

In: the lines that come next in a long program. Out: a ``PlainRun``, with which the queue is filled
directly (``lines.py``) for as long as plain blocks follow. The modal state goes there and
comes back, so that both ways mix block by block; a block that the short way does not take is
decoded from its tree, with its diagnostics.
"""

from __future__ import annotations

import math
from collections.abc import Generator
from dataclasses import dataclass
from typing import Protocol

from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import NO_SOURCE, pack
from nctakt.decoder.blocks.technology_output import TechnologyOutputs
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.decoder.fast.compensated_lines import PlainBeside
from nctakt.decoder.fast.lines import PlainMotion
from nctakt.decoder.state.commands import Answer, Command
from nctakt.decoder.state.uncertain_axes import MovedAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel.tick.command_queue import CommandRing
from nctakt.nc.fast.plain_lines import EMPTY, PLAIN
from nctakt.nc.inspection import plain_scanner
from nctakt.nc.outline import SectionReader
from nctakt.nc.source import LineReader


class HeldContour(Protocol):
    """A contour that the tool is beside, or may be (``compensation.py``)."""

    tool: ToolPath

    def can_hand_over(self) -> bool:
        """Whether plain blocks may go on with it; true without a contour."""

    def hand_over(self, beside: PlainBeside) -> None:
        """What is held goes there."""

    def take_back(self, beside: PlainBeside, file: str) -> None:
        """And comes back, of this file."""


class PlainBlocks:
    """The plain blocks of one program; not more than ``most`` in a row may take no time."""

    def __init__(
        self,
        values: Values,
        moved: MovedAxes,
        technology: TechnologyOutputs,
        contour: HeldContour,
        most: int,
    ) -> None:
        self._environment = values.environment
        self._state = values.state
        self._moved = moved
        self._technology = technology
        parameters = self._environment.parameters
        self._scanner = plain_scanner(parameters)
        self._contour = contour
        count = len(self._environment.axes)
        self._beside = PlainBeside(contour.tool, count)
        self._motion = PlainMotion(self._scanner, count, self._beside)
        self._motion.most_blocks = most
        self._motion.rapid_stops_exactly = parameters.exact_stop_after_g00
        self._lines: LineReader | None = None
        self._file = ""
        self._run = PlainRun(0, 0, self)

    def decode(self, reader: SectionReader, blocks: int) -> Generator[Command, Answer, int]:
        """Decode the plain blocks that come next.

        ``blocks``: how many were decoded since the last one that takes time, before and behind.
        """
        lines = reader.lines
        if lines is None or not self._comes(lines) or not self._is_usual():
            return blocks
        self._hand_over(reader.source.file)
        self._motion.blocks = blocks
        self._lines = lines
        while self._lines is not None:
            yield self._run
        self._take_back()
        return self._motion.blocks

    def _comes(self, lines: LineReader) -> bool:
        """Whether the next line that says anything is plain; empty ones are taken."""
        while lines.more():
            what = self._scanner.read(lines.group[lines.index])
            if what != EMPTY:
                return what == PLAIN
            lines.index += 1
        return False

    def _is_usual(self) -> bool:
        """Whether nothing is active that plain blocks do not know."""
        return (
            self._state.is_usual
            and not self._environment.offsets.systems.is_active
            and not self._environment.marks_blocks
            and self._moved.is_quiet
            and self._contour.can_hand_over()
            and not self._technology.awaits_feed
        )

    def _hand_over(self, file: str) -> None:
        motion, state = self._motion, self._state
        environment = self._environment
        self._file = file
        for index, axis in enumerate(environment.axes):
            motion.set_axis(
                index,
                state.positions[index],
                environment.offsets.total(index),
                state.length_unit_mm if axis.is_linear else 1.0,
                -math.inf if axis.is_modulo else axis.software_limit_low,
                math.inf if axis.is_modulo else axis.software_limit_high,
            )
        feed_unit = environment.parameters.program_start.feed_unit_mm_min
        motion.motion = state.motion
        motion.feed_v = state.feed_mm_s
        motion.feed_factor = state.length_unit_mm if state.inch else feed_unit
        motion.is_absolute = state.absolute
        motion.stops_exactly = state.path.exact_stop
        motion.deviation = state.path.deviation if state.path.contouring else 0.0
        motion.limits_jerk = state.path.limits_jerk
        self._contour.hand_over(self._beside)
        place = environment.source_id(Span(file, 1, 1, 2))
        motion.place = -1 if place == NO_SOURCE else place - pack(0, 1, 1)

    def _take_back(self) -> None:
        motion, state = self._motion, self._state
        state.positions = motion.places()
        state.motion = motion.motion
        state.feed_mm_s = motion.feed_v
        if self._beside.is_on:
            self._contour.take_back(self._beside, self._file)

    def fill(self, ring: CommandRing, timed: int) -> None:
        """Fill the queue up to so many commands that take time, or up to a block that is not plain.

        Whoever takes the ``PlainRun`` does this.
        """
        lines = self._lines
        assert lines is not None
        ring.reserve(timed)
        if not self._motion.resume(ring, timed):
            return
        while ring.timed_count < timed:
            if not lines.more():
                self._lines = None
                return
            lines.index = self._motion.fill(ring, timed, lines.group, lines.index, lines.number)
            if lines.index < len(lines.group) and ring.timed_count < timed:
                self._lines = None
                return


@dataclass(frozen=True, slots=True)
class PlainRun(Command):
    """Plain blocks come next, which ``blocks`` puts into the queue."""

    blocks: PlainBlocks
