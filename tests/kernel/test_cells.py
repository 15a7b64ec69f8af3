# SPDX-License-Identifier: MIT
"""The realtime part writes its cells and words where the tables say that they are read."""

from __future__ import annotations

from collections.abc import Iterable

from nctakt.hli.layout import LAMPS, PANEL, PANEL_CELLS, SPINDLE, TOOLS, UNIT
from nctakt.hli.places import entry, size_of
from nctakt.kernel import cells
from nctakt.nc.vocabulary.variables.realtime_variables import (
    AXIS_VARIABLES,
    CHANNEL_VARIABLES,
    SPINDLE_VALUES,
)

#: Bytes of the units in which the realtime part counts in the image.
HALF, WORD = 4, 8


def names(prefix: str, paths: Iterable[str]) -> list[str]:
    """The names of cells for the paths of a table: ``AXIS_ACS_ACT_POS`` for ``ACS.ACT_POS``."""
    return [f"{prefix}_{path.replace('.', '_').upper()}" for path in paths]


def test_cells_of_axes_channels_and_spindles_are_in_the_order_of_their_tables() -> None:
    """One cell for each variable; arrays come last."""
    for prefix, table in (
        ("AXIS", AXIS_VARIABLES),
        ("CHANNEL", CHANNEL_VARIABLES),
        ("SPINDLE", SPINDLE_VALUES),
    ):
        found = [getattr(cells, name) for name in names(prefix, (row.path for row in table))]
        assert found == list(range(len(table)))
        assert [row.count for row in table[:-1]] == [0] * (len(table) - 1)
    assert cells.AXIS_CELLS == len(AXIS_VARIABLES)
    assert cells.SPINDLE_CELLS == len(SPINDLE_VALUES)
    assert CHANNEL_VARIABLES[cells.CHANNEL_TIMER].count == cells.TIMERS


def test_each_coordinate_system_has_the_same_cells() -> None:
    """Four values from the first one on."""
    for system in ("MCS", "PCS", "IPO"):
        first = getattr(cells, f"AXIS_{system}_ACT_POS")
        for value in ("ACT_POS", "CUR_POS", "CMD_POS", "DIST_TO_GO"):
            cell = getattr(cells, f"AXIS_{system}_{value}")
            assert cell == first + getattr(cells, f"SYSTEM_{value}")


def test_cells_of_the_panel_are_in_the_order_of_its_table() -> None:
    """Commands, then lamps, then what concerns the tool manager."""
    paths = [one.name for one in (*PANEL, *LAMPS)]
    assert [getattr(cells, name) for name in names("PANEL", paths)] == list(
        range(cells.PANEL_TOOLS)
    )
    assert cells.PANEL_STATE == len(PANEL)
    assert cells.PANEL_TOOLS + len(TOOLS) == PANEL_CELLS
    assert cells.PANEL_CELLS == PANEL_CELLS


def test_words_of_a_unit_are_where_its_structure_says() -> None:
    """Halves of a word, then the times."""
    for name in ("serial", "letter", "number", "sequence", "axis", "value"):
        assert entry(UNIT, name).offset == HALF * getattr(cells, f"UNIT_{name.upper()}")
    times = HALF * cells.UNIT_TIMES
    assert entry(UNIT, "time_us").offset == times + WORD * cells.IMAGE_TIME
    assert entry(UNIT, "duration_us").offset == times + WORD * cells.IMAGE_DURATION
    assert size_of(UNIT) == HALF * cells.UNIT_WIDTH


def test_words_of_a_spindles_job_are_where_its_structure_says() -> None:
    """From its number on."""
    first = entry(SPINDLE, "job").offset - HALF * cells.SPINDLE_JOB
    assert entry(SPINDLE, "function").offset == first + HALF * cells.SPINDLE_JOB_FUNCTION
    assert entry(SPINDLE, "direction").offset == first + HALF * cells.SPINDLE_JOB_DIRECTION
    times = first + HALF * cells.SPINDLE_JOB_TIMES
    assert entry(SPINDLE, "job_time_us").offset == times + WORD * cells.IMAGE_TIME
    assert entry(SPINDLE, "job_duration_us").offset == times + WORD * cells.IMAGE_DURATION
    assert entry(SPINDLE, "job_speed").offset == times + WORD * cells.IMAGE_SPEED
    assert entry(SPINDLE, "job_position").offset == times + WORD * cells.IMAGE_POSITION
