# SPDX-License-Identifier: MIT
"""Offsets between ACS and PCS (MO-8, RC-407)."""

from nctakt.kernel import cells, codes
from nctakt.kernel.axes import coordinates
from nctakt.kernel.axes.axes import Axes


def test_offsets_are_summed_by_their_kinds() -> None:
    """Each keyword of RC-407 asks for one kind, ALL for all of them."""
    offsets = coordinates.Offsets(2)
    axes = Axes(bytearray(8 * 2 * cells.AXIS_CELLS), 0, 2)
    assert offsets.of(1, 127) == 0.0
    for kind in range(codes.OFFSET_KINDS):
        axes.shift(1, kind, 2.0**kind)
    assert axes.offsets.of(1, 127) == 127.0
    assert axes.offsets.of(1, 1 << codes.CLAMP_OFFSET) == 8.0
    assert axes.offsets.of(1, (1 << codes.ZERO_OFFSET) + (1 << codes.TOOL_OFFSET)) == 17.0
    assert axes.offsets.of(0, 127) == 0.0


def test_positions_in_pcs_lack_the_offsets() -> None:
    """ACS, MCS and IPO stay; PCS is less by the sum of the active offsets; distances stay."""
    memory = bytearray(8 * cells.AXIS_CELLS)
    values = memoryview(memory).cast("d")
    axes = Axes(memory, 0, 1)
    axes.set_position(0, 100.0)
    axes.shift(0, codes.ZERO_OFFSET, 11.0)
    axes.shift(0, codes.ADD_ZERO_OFFSET, 0.5)
    assert list(values[0:3]) == [100.0] * 3
    assert list(values[3:7]) == [100.0, 100.0, 100.0, 0.0]
    assert list(values[7:11]) == [88.5, 88.5, 88.5, 0.0]
    assert list(values[11:15]) == [100.0, 100.0, 100.0, 0.0]
