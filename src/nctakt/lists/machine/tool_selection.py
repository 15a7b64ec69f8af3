# SPDX-License-Identifier: MIT
"""Effects of T and D, from the values of a channel list."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message
from nctakt.lists.declared.technology_functions import TechnologyFunction, tool_output
from nctakt.lists.declared.tools import Tool
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.path.tools import (
    FLUSH_WITHOUT_TOOL_MANAGEMENT,
    TOOL_TOO_SHORT,
    TOOL_TOO_THIN,
)

_LENGTH_UNITS = 10_000


@dataclass(frozen=True, slots=True)
class ToolLifeRules:
    """When the tool life is sent, and what counts towards it.

    ``is_sent``: with each change of the tool (P-CHAN-00076); ``omits_zero``: P-CHAN-00243,
    ``counts_rapid``: P-CHAN-00255, ``by_d``: that of another tool begins with D (P-CHAN-00482).
    """

    is_sent: bool = False
    omits_zero: bool = False
    counts_rapid: bool = False
    by_d: bool = False


@dataclass(frozen=True, slots=True)
class ToolSelection:
    """The effects of T and D, and the tools that D accepts; lengths in mm.

    ``by_t``: T also selects the offsets of its number. ``flushes``: the channel is flushed before a
    D word. ``output``: how T is passed to the PLC, ``None``: not at all. ``flushes_before_t``: the
    path is at rest before T goes out. ``moves_directly``: axes move by new offsets in the block of
    D. ``keeps_length_axis``: the length acts along the third main axis in every plane.
    ``min_length``, ``min_radius``: 0 for any tool. ``life``: of the tool life. ``is_external``: an
    external tool management may have the tools (P-CHAN-00016), and is informed of T if
    ``informs_of_t`` (P-CHAN-00087).
    """

    by_t: bool
    flushes: bool
    output: TechnologyFunction | None
    flushes_before_t: bool = False
    moves_directly: bool = False
    keeps_length_axis: bool = False
    min_length: float = 0.0
    min_radius: float = 0.0
    life: ToolLifeRules = ToolLifeRules()
    is_external: bool = False
    informs_of_t: bool = False

    @property
    def reports_t(self) -> bool:
        """Whether T goes to the PLC, or to its tool manager."""
        return self.output is not None or (self.is_external and self.informs_of_t)

    def mistakes(self, tool: Tool) -> Iterator[tuple[Message, Mapping[str, float]]]:
        """Yield why D must not select a tool: too short, too thin; with the values of the message,
        mm.
        """
        if self.min_length > 0.0 and tool.length < self.min_length:
            yield TOOL_TOO_SHORT, {"length": tool.length, "minimum": self.min_length}
        if self.min_radius > 0.0 and tool.radius < self.min_radius:
            yield TOOL_TOO_THIN, {"radius": tool.radius, "minimum": self.min_radius}


def tool_selection(values: Values, collector: Collector) -> ToolSelection:
    """Return the settings of a channel list for T and D; report a flush without effect (21244)."""
    flushes_before_t = values.flag("t_with_implicit_flush")
    is_managed = values.flag("t_info_to_wzv")
    if flushes_before_t and not is_managed:
        values.report(collector, FLUSH_WITHOUT_TOOL_MANAGEMENT, ("t_with_implicit_flush",))
    return ToolSelection(
        values.flag("einrechnen_mit_t"),
        values.text("flush.d_cmd") == "FAW_D",
        tool_output(values, collector),
        flushes_before_t and is_managed,
        values.flag("move_tool_offsets_directly"),
        values.flag("remain_tool_length_in_ax"),
        values.integer("tool.minimum_length") / _LENGTH_UNITS,
        values.integer("tool.minimum_radius") / _LENGTH_UNITS,
        ToolLifeRules(
            values.flag("tool_life_to_wzv"),
            values.flag("tool_life_to_wzv_suppress_zero"),
            values.flag("tool_life_capture_all_movements"),
            values.flag("tool_life_with_d"),
        ),
        values.flag("ext_wzv_vorhanden"),
        is_managed,
    )
