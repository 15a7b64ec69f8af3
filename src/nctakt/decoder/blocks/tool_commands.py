# SPDX-License-Identifier: MIT
"""``#TOOL DATA``, ``#TOOL PREP``, ``#TOOL REFRESH``: D and T for tools with an ID; ``#TLAX``,
``#TOOL LIFE``.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.blocks.technology_output import tool_function
from nctakt.decoder.state.queued.commands import Answer, Command, Flush
from nctakt.decoder.state.queued.tool_life import UNCHANGED, SetToolLife
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.messages.path.tools import NEGATIVE_TOOL_LIFE
from nctakt.nc import tree
from nctakt.nc.meaning.path import keywords
from nctakt.nc.meaning.words import numbers_of, signed_axis


class ToolCommands:
    """Decodes these commands for one program."""

    def __init__(self, values: Values, blocks: BlockDecoder) -> None:
        self._blocks = blocks
        self._values = values
        self._environment = values.environment

    def length_axis(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#TLAX [Z-]`` or ``#TLAX DEFAULT``; it moves nothing by itself."""
        signed, axis = signed_axis(command), None
        if signed is not None:
            axis = self._environment.axis_numbers[signed[0]], signed[1]
        self._values.state.tool.length_axis = axis
        yield from self._values.tool.offsets(command.span, number)

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one of these commands."""
        name = command.words[1].name
        tool, span = self._values.tool, command.span
        if name == "LIFE":
            yield from self._life(command, number)
            return
        if name == "REFRESH":
            yield from tool.refresh(span, number)
            yield from self._blocks.change_tool(span, number)
            return
        numbers = []
        for expression in numbers_of(command) or ():
            numbers.append((yield from self._values.evaluate(expression, number)))
        identity = tool.identity(numbers, f"#TOOL {name}", span)
        selection = self._environment.parameters.tool_selection
        if name == "PREP":
            tool.prepare(identity, span)
            yield from self._blocks.tools.flush_before_t(span, number)
            yield from tool.announce(identity, "#TOOL PREP", span, number)
            if selection.output is not None:
                function = tool_function(self._values, span, identity[0], selection.output, number)
                yield function.output
                yield function.wait
            yield from tool.change_life(identity, span, number, by_d=False)
            if not selection.by_t:
                return
        if selection.flushes:
            self._values.check_flush_allowed(f"#TOOL {name}", span)
            yield Flush(self._environment.source_id(span), number, True)
        yield from tool.select_identity(identity, f"#TOOL {name}", span, number)
        yield from tool.change_life(identity, span, number, by_d=True)
        yield from self._blocks.change_tool(span, number)

    def _life(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#TOOL LIFE READ``, ``#TOOL LIFE REMOVE`` or ``#TOOL LIFE DEF``."""
        name, span = command.words[2].name, command.span
        source = self._environment.source_id(span)
        if name == "REMOVE":
            yield SetToolLife(source, number, codes.LIFE_REMOVED)
            return
        if name == "READ":
            numbers = []
            for expression in numbers_of(command) or ():
                numbers.append((yield from self._values.evaluate(expression, number)))
            identity = self._values.tool.identity(numbers, "#TOOL LIFE READ", span)
            yield self._values.tool.life(codes.LIFE_READ, identity, span, number)
            return
        given = {"TIME": UNCHANGED, "DIST": UNCHANGED}
        for item in keywords(command):
            assert item.value is not None
            value = yield from self._values.evaluate(item.value, number)
            if value < 0.0:
                self._values.fail(NEGATIVE_TOOL_LIFE, item.value.span, word=item.name, value=value)
            given[item.name] = value
        time_s, distance_mm = given["TIME"], given["DIST"]
        yield SetToolLife(source, number, codes.LIFE_DEFINED, 0, 0, time_s, distance_mm)
