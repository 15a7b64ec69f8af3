# SPDX-License-Identifier: MIT
"""The environment of a channel's decoder: names, lists, memory, callbacks.

Immutable except for the values in memory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields
from typing import TYPE_CHECKING, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.decoder.state.axis_places import AxisIndices, ChannelPlaces
from nctakt.decoder.state.call_stack import OpenCall
from nctakt.decoder.state.controller_data import ControllerData
from nctakt.decoder.state.geometry.offsets import ActiveOffsets
from nctakt.decoder.state.queued.in_force import InForce
from nctakt.decoder.state.spindle_gears import SpindleGears
from nctakt.decoder.state.uncertain_axes import LivingCycle
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.nc.outline import ProgramText
from nctakt.nc.tree import Statement
from nctakt.nc.vocabulary.variables.variable_table import NameTable


class DecoderSignals(Protocol):
    """The signals of one channel; channels are masks as in ``kernel/tick/signals.py``.

    ``channel_count``: the number of channels of the machine.
    """

    channel_count: int

    def send(
        self,
        source: int,
        signal: int,
        receivers: int,
        count: int,
        mask: int,
        values: Sequence[float],
    ) -> bool:
        """Send a signal; return whether there was room for it."""

    def remove(self, low: int, high: int, receivers: int, *, is_range: bool) -> None:
        """Remove the oldest signal of this number, or all of a range."""

    def read(self, source: int, signal: int, senders: int) -> tuple[float, ...]:
        """Take a signal: the mask of its values and the values; empty if it is not there.

        -1 in place of the mask, and its number, if another signal must be taken first.
        """


if TYPE_CHECKING:
    from nctakt.decoder.state.kept_trees import KeptTrees


@dataclass(slots=True)
class DecoderEnvironment:
    """One channel as its decoder sees it; only its axes change (``ChannelPlaces``).

    ``tools``: those of the list, by number. ``axis_numbers``: axis name -> index in the path's
    positions. ``cells``: the machine's memory, ``memory``: the same as bytes. ``source_id``:
    returns the number of a span (``base/source_ids.py``). ``line_text``: returns the line of a
    span. ``first_mistake``: checks statements that only the run shows, see
    ``nc/check/checker.py``. ``spindle_gears``: index -> the gear steps of a spindle
    that the CNC turns. ``text_id``: returns the number of a text for a user error, ``path_id`` that
    of the open programs, ``modal_id`` that of the functions in force. ``warn``: receives findings
    that do not stop the program. ``subprogram``: returns the text of a called file, by name,
    calling file and span; raises ``DecodeError``. ``skip_levels``: blocks of these levels are
    skipped. ``marks_blocks``: each block is marked. ``controller_data``: data of V.G and V.S.
    ``living_cycles``: cycles left by earlier programs. ``moving_axes``: returns the names of the
    axes in independent motion. ``history_size``: the number of blocks in the history of the path.
    ``signals``: those between the channels. ``places``: the axes of the channel and those that it
    can fetch. ``poll`` is called while the decoder works. ``kept_cycles``: cycles of earlier runs,
    if runs follow each other.
    """

    names: NameTable
    parameters: ChannelParameters
    axis_numbers: AxisIndices
    axes: tuple[AxisConfiguration, ...]
    offsets: ActiveOffsets
    tools: Mapping[int, Tool]
    cells: memoryview[float]
    tool_cells: int
    memory: memoryview
    cycle_time_us: int
    source_id: Callable[[Span], int]
    line_text: Callable[[Span], str]
    first_mistake: Callable[
        [Sequence[Statement], Span, Callable[[], str], bool, Iterable[str]], Diagnostic | None
    ]
    text_id: Callable[[str], int]
    path_id: Callable[[tuple[OpenCall, ...]], int]
    modal_id: Callable[[InForce], int]
    spindle_gears: Mapping[int, SpindleGears]
    warn: Callable[[Diagnostic], None]
    subprogram: Callable[[str, str, Span], ProgramText]
    skip_levels: frozenset[int]
    marks_blocks: bool
    controller_data: ControllerData
    living_cycles: tuple[LivingCycle, ...]
    moving_axes: Callable[[], tuple[str, ...]]
    history_size: int
    signals: DecoderSignals
    poll: Callable[[], None]
    places: ChannelPlaces
    kept_cycles: KeptTrees | None = None


class WatchedEnvironment(DecoderEnvironment):
    """An environment that notes whether the decoder has used the machine's memory."""

    __slots__ = ("has_used_memory", "watched")

    def __init__(self, watched: DecoderEnvironment) -> None:
        self.watched = watched
        for member in fields(watched):
            if member.name not in ("cells", "memory"):
                setattr(self, member.name, getattr(watched, member.name))
        self.has_used_memory = False

    @property
    def cells(self) -> memoryview[float]:  # type: ignore[override]
        """The machine's memory."""
        self.has_used_memory = True
        return self.watched.cells

    @property
    def memory(self) -> memoryview:  # type: ignore[override]
        """The machine's memory as bytes."""
        self.has_used_memory = True
        return self.watched.memory


class DecodeError(Exception):
    """Decoding cannot continue; the program ends after the prepared blocks."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.headline())
        self.diagnostic = diagnostic
