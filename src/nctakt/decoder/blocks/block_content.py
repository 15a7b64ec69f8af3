# SPDX-License-Identifier: MIT
"""A block's words, sorted by their effect."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.path.path_motion import PathWords
from nctakt.decoder.blocks.path.weights import Weights
from nctakt.decoder.blocks.technology_output import BlockFunction
from nctakt.decoder.state.queued.axis_commands import EndOscillation, MoveAlone, Oscillate
from nctakt.decoder.state.queued.commands import FixedStop, ProgramStop
from nctakt.nc import tree

#: Axis words and their values.
AxisValues = list[tuple[tree.AxisWord, float]]

#: Commands for axes that move independently of the path.
AloneCommand = MoveAlone | Oscillate | EndOscillation


@dataclass(slots=True)
class BlockContent:
    """A block's words by effect; ``has_offset_word``: there is a D.

    ``selects_tool``: it selects the data of a tool; ``kept``: axes that keep their programmed
    positions meanwhile, so that they move, with these.

    ``independent``: axes that begin an independent motion, each with its command; ``awaited``:
    those for which the block waits.

    ``axis_values``: functions whose axis words are no targets, with these words.
    ``measures``: G100 or G310, ``continues``: G106, ``interrupts``: G310. ``angle_deg``: R of G68.
    """

    axes: AxisValues = field(default_factory=list)
    path: PathWords = field(default_factory=PathWords)
    functions: list[BlockFunction] = field(default_factory=list)
    dwell_s: float | None = None
    zero_group: int | None = None
    is_reference: bool = False
    updates_tool_offsets: bool = False
    has_offset_word: bool = False
    selects_tool: bool = False
    kept: dict[int, float] = field(default_factory=dict)
    stops: tuple[tuple[tree.BracketCommand, FixedStop], ...] = ()
    independent: tuple[tuple[tree.BracketCommand, AloneCommand], ...] = ()
    awaited: tuple[str, ...] = ()
    program_stops: tuple[ProgramStop, ...] = ()
    ends_program: bool = False
    weights: Weights = field(default_factory=dict)
    axis_values: dict[int, AxisValues] = field(default_factory=dict)
    measures: Span | None = None
    continues: bool = False
    interrupts: bool = False
    angle_deg: float = 0.0

    @property
    def programmed(self) -> list[tree.AxisWord | tree.BracketCommand]:
        """The words of axes that the block moves."""
        return [*(word for word, _ in self.axes), *(word for word, _ in self.stops)]
