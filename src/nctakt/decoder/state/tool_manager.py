# SPDX-License-Identifier: MIT
"""The tool manager of the PLC, which is asked for tools (P-CHAN-00016): request and answer.

Both are values of the interface (``TOOL_REQUEST`` and ``TOOL_ANSWER`` in ``hli/layout.py``). The
decoder writes a request with a new number and waits, tick by tick, until the answer has that
number. Manual: pages 15335656587 (D) and 15335655051 (T).
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Message, Span
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.commands import Answer, AwaitTools, Command
from nctakt.hli.layout import TOOL_OFFSETS, TOOL_PARAMETERS, TOOLS
from nctakt.lists.declared.tools import Tool
from nctakt.messages.path.tools import TOOL_MANAGER_SILENT

#: Requests: the data of a tool, or its preparation.
DATA = 1
PREPARATION = 2

#: Ticks after which a PLC that manages tools has announced it: one in Structured Text opens the
#: interface in its first two cycles.
_ANNOUNCED_TICKS = 5
#: How long the PLC may take for its answer.
ANSWER_LIMIT_S = 10

#: Units of the tool list in a revolution per minute: 1e-3 degrees per second.
_SPEED_UNITS = 6000.0

_OFFSETS = {entry.name.removeprefix("tool_"): index for index, entry in enumerate(TOOLS)}

#: Basic, sister and variant number of a tool.
Identity = tuple[int, int, int]


class ToolManager:
    """Asks the PLC for the tools of one program; ``known``: its answers so far."""

    def __init__(self, environment: DecoderEnvironment, state: ModalState) -> None:
        self._environment = environment
        self._state = state
        self._is_external = environment.parameters.tool_selection.is_external
        self.known: dict[Identity, Tool] = {}

    def _read(self, name: str) -> float:
        return self._environment.cells[self._environment.tool_cells + _OFFSETS[name]]

    def _write(self, name: str, value: float) -> None:
        self._environment.cells[self._environment.tool_cells + _OFFSETS[name]] = value

    @property
    def is_there(self) -> bool:
        """Whether the PLC manages the tools; the channel list says that it may."""
        return self._is_external and self._read("manager") != 0.0

    def await_announcement(self) -> Generator[Command, Answer]:
        """Let a PLC that has just begun say that it manages the tools, before the first block."""
        for _ in range(_ANNOUNCED_TICKS if self._is_external else 0):
            if not self.is_there:
                yield AwaitTools(0, 0)

    def ask(
        self, kind: int, identity: Identity, span: Span, number: int
    ) -> Generator[Command, Answer, tuple[Message | None, Tool | None]]:
        """Ask for a tool and wait; return the error, and the tool if it is valid."""
        request = self._request(kind, identity)
        source = self._environment.source_id(span)
        limit = ANSWER_LIMIT_S * 1_000_000 // self._environment.cycle_time_us
        for _ in range(limit):
            yield AwaitTools(source, number)
            if self._read("answer") == request:
                break
        else:
            return TOOL_MANAGER_SILENT, None
        tool = self._answered(identity)
        if tool is not None and kind == DATA:
            self.known[identity] = tool
        return None, tool

    def _request(self, kind: int, identity: Identity) -> float:
        """Write a request; return its number."""
        tool = self._state.tool
        self._write("request_kind", kind)
        for name, value in zip(("basic", "sister", "variant"), identity, strict=True):
            self._write(f"request_{name}", value)
        self._write("request_t", tool.number)
        self._write("request_d", tool.record)
        for i in range(TOOL_PARAMETERS):
            self._write(f"request_parameter_{i}", tool.tool.parameters.get(i, 0.0))
        request = self._read("request") + 1.0
        self._write("request", request)
        return request

    def _answered(self, identity: Identity) -> Tool | None:
        """Return the tool of the answer, ``None`` for one that is not valid."""
        if self._read("valid") == 0.0:
            return None
        offsets = {i: self._read(f"offset_{i}") for i in range(TOOL_OFFSETS)}
        parameters = {i: self._read(f"parameter_{i}") for i in range(TOOL_PARAMETERS)}
        speeds = (self._read("min_speed"), self._read("max_speed"))
        return Tool(
            number=identity[0],
            valid=True,
            cutter_position=int(self._read("cutter")),
            length=self._read("length"),
            radius=self._read("radius"),
            axis_offsets={i: value for i, value in offsets.items() if value != 0.0},
            parameters={i: value for i, value in parameters.items() if value != 0.0},
            spindle_number=int(self._read("spindle")),
            kinematic_id=int(self._read("kinematic")),
            kinematic_parameters={},
            type=int(self._read("type")),
            identity=identity,
            sister_is_valid=identity[1] != 0,
            variant_is_valid=identity[2] != 0,
            speeds=(speeds[0] * _SPEED_UNITS, speeds[1] * _SPEED_UNITS),
            acceleration=self._read("max_acceleration"),
        )
