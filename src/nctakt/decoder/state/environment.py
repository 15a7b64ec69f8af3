# SPDX-License-Identifier: MIT
"""What the decoder of one channel works with: names, lists, memory, places. Immutable but for the
memory's values."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.decoder.state.controller_data import ControllerData
from nctakt.decoder.state.offsets import ActiveOffsets
from nctakt.decoder.state.uncertain_axes import LivingCycle
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.nc.outline import ProgramText
from nctakt.nc.vocabulary.variable_table import NameTable


@dataclass(frozen=True, slots=True)
class DecoderEnvironment:
    """One channel as its decoder sees it.

    ``tools``: those of the list, by number. ``axis_numbers``: axis name -> place in the path's
    positions. ``cells``: the machine's memory, ``memory`` the same as bytes. ``source_id``: the
    source number of a span (``base/source_ids.py``). ``line_text``: the text line of a span.
    ``max_spindle_speeds``: the places of the spindles that the CNC turns and has an axis list for,
    with its highest speed in degrees per second. ``text_id``: the number of a text that is told
    with a user error. ``warn``: takes a finding that does not stop the program. ``subprogram``: the
    text of the file of this name, called at this place of that file; raises ``DecodeError``. Blocks
    of ``skip_levels`` are left out. ``marks_blocks``: each block is marked. ``controller_data``:
    data of the controller (V.G, V.A). ``living_cycles``: what earlier programs have left.
    ``moving_axes``: names of the axes that move beside the path at this moment. ``history_size``:
    how many blocks the history of the path holds. ``poll`` is called while the decoder works.
    """

    names: NameTable
    parameters: ChannelParameters
    axis_numbers: Mapping[str, int]
    axes: tuple[AxisConfiguration, ...]
    offsets: ActiveOffsets
    tools: Mapping[int, Tool]
    cells: memoryview[float]
    memory: memoryview
    cycle_time_us: int
    source_id: Callable[[Span], int]
    line_text: Callable[[Span], str]
    text_id: Callable[[str], int]
    max_spindle_speeds: Mapping[int, float]
    warn: Callable[[Diagnostic], None]
    subprogram: Callable[[str, str, Span], ProgramText]
    skip_levels: frozenset[int]
    marks_blocks: bool
    controller_data: ControllerData
    living_cycles: tuple[LivingCycle, ...]
    moving_axes: Callable[[], tuple[str, ...]]
    history_size: int
    poll: Callable[[], None]


class DecodeError(Exception):
    """Decoding cannot go on: the program is given up behind the blocks that are prepared."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.headline())
        self.diagnostic = diagnostic
