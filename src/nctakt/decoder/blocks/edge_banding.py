# SPDX-License-Identifier: MIT
"""G107, G108: the edge joint is measured in a block with a function of the type MNE_SNS."""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.technology_output import BlockFunction
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    Measure,
    MeasureEnd,
    TechnologyOutput,
)
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.backward import EDGE_BANDING_NOT_SIMULATED
from nctakt.nc.vocabulary.functions import EDGE_BANDING


def switch_edge_banding(values: Values, function: int, span: Span) -> None:
    """Let the next block with a function of the type MNE_SNS look for an edge (G108)."""
    if function == EDGE_BANDING and values.environment.parameters.edge_across_blocks:
        values.fail(EDGE_BANDING_NOT_SIMULATED, span)
    values.state.measures = function == EDGE_BANDING


def seek_edge(
    values: Values,
    motion: Generator[Command, Answer],
    measured: BlockFunction,
    span: Span,
    number: int,
) -> Generator[Command, Answer]:
    """Yield a motion that looks for the edge of the strip (G108, V.RTG.MEAS_DELTA)."""
    values.state.measures = False
    source = values.environment.source_id(span)
    output = measured.output
    assert isinstance(output, TechnologyOutput)
    residual = values.environment.parameters.residual_path_mm
    function, ticks, value = output.function, output.ticks, output.value
    yield Measure(source, number, function, ticks, residual, value)
    yield from motion
    yield MeasureEnd(source, number)
