# SPDX-License-Identifier: MIT
"""T and D in a block: the tool for the PLC, the selection of its data.

With P-CHAN-00100 the axes whose offsets D changes move by the difference in its block, so that they
keep their programmed positions; a transformation or machine coordinates exclude that.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.moved_axes import MovedAxes
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.technology_output import tool_function
from nctakt.decoder.state.queued.commands import Answer, Command, Flush
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.nc import tree


class ToolWords:
    """T and D of one program."""

    def __init__(self, values: Values, moved: MovedAxes) -> None:
        self._values = values
        self._environment = values.environment
        self._moved = moved
        self._selection = values.environment.parameters.tool_selection

    def word(
        self, word: tree.Word, value: float, number: int, content: BlockContent
    ) -> Generator[Command, Answer]:
        """Process T or D; T may go to the PLC, and select offsets where the block has no D."""
        if word.name == "T":
            tool = self._values.tool.name(word, value)
            yield from self.flush_before_t(word.span, number)
            identity = (tool, 0, 0)
            yield from self._values.tool.announce(identity, f"T{tool}", word.span, number)
            output = self._selection.output
            if output is not None:
                function = tool_function(self._values, word.span, tool, output, number)
                content.functions.append(function)
            yield from self._values.tool.change_life(identity, word.span, number, by_d=False)
            if not self._selection.by_t or content.has_offset_word:
                return
        if self._selection.flushes:
            yield self._flush(word.name, word.span, number, waits=True)
        identity = yield from self._values.tool.select(word, value, number)
        yield from self._values.tool.change_life(identity, word.span, number, by_d=True)
        content.updates_tool_offsets = content.selects_tool = True

    def flush_before_t(self, span: Span, number: int) -> Generator[Command, Answer]:
        """Let the path come to rest before T goes out, where the list says so (P-CHAN-00106)."""
        if self._selection.flushes_before_t:
            yield self._flush("T", span, number, waits=False)

    def _flush(self, command: str, span: Span, number: int, *, waits: bool) -> Flush:
        self._values.check_flush_allowed(command, span)
        return Flush(self._environment.source_id(span), number, waits)

    def offsets(self, content: BlockContent, span: Span, number: int) -> Generator[Command, Answer]:
        """Activate the offsets of the tool in the plane; axes may have to move by them."""
        offsets = self._environment.offsets
        moves = (
            self._selection.moves_directly
            and content.selects_tool
            and not offsets.transformation.is_active
            and offsets.suspended is None
        )
        if not moves:
            yield from self._values.tool.offsets(span, number)
            return
        names = list(self._environment.axis_numbers)
        yield from self._moved.request(names, span, number)
        positions = offsets.inside(self._values.state.positions)
        axes = range(len(positions))
        programmed = [positions[axis] - offsets.total(axis) for axis in axes]
        before = [offsets.value(axis, codes.TOOL_OFFSET) for axis in axes]
        yield from self._values.tool.offsets(span, number)
        for axis in axes:
            if offsets.value(axis, codes.TOOL_OFFSET) != before[axis]:
                content.kept[axis] = programmed[axis]
