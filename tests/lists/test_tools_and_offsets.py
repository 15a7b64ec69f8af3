# SPDX-License-Identifier: MIT
"""Tool lists and lists of offsets: units, what is left out, what is reported."""

from __future__ import annotations

from nctakt.lists.declared.offsets import (
    ClampOffsets,
    ZeroOffsets,
    clamp_offsets_configuration,
    zero_offsets_configuration,
)
from nctakt.lists.declared.schemas import CLAMP_OFFSETS, TOOLS, ZERO_OFFSETS
from nctakt.lists.declared.tools import Tool, tools_configuration
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import Values
from nctakt.messages import Collector


def read(schema: Schema, text: str) -> tuple[Values, Collector]:
    """The values of a list that is well formed."""
    collector = Collector()
    values = load_list(schema, "x.lis", text.encode(), collector)
    assert collector.diagnostics == []
    return values, collector


def tools(text: str, *linear: bool) -> tuple[dict[int, Tool], list[str]]:
    """The tools, and what was reported as ``number at line``."""
    values, collector = read(TOOLS, text)
    return tools_configuration(values, linear, collector), reported(collector)


def zero_offsets(text: str, axes: int = 2) -> tuple[ZeroOffsets, list[str]]:
    """The zero offsets, and what was reported."""
    values, collector = read(ZERO_OFFSETS, text)
    return zero_offsets_configuration(values, axes, collector), reported(collector)


def clamp_offsets(text: str) -> tuple[ClampOffsets, list[str]]:
    """The clamp offsets of two axes, and what was reported."""
    values, collector = read(CLAMP_OFFSETS, text)
    return clamp_offsets_configuration(values, 2, collector), reported(collector)


def reported(collector: Collector) -> list[str]:
    """Each finding with its line."""
    return [f"{one.id} at {one.span.line if one.span else 0}" for one in collector.diagnostics]


def test_lengths_are_a_tenth_of_a_micrometre() -> None:
    """P-TOOL-00003, 00004, 00006: 0.1 µm, in rotary axes 1e-4°."""
    text = "wz[1].laenge 600000\nwz[1].radius 12500\n"
    text += "wz[1].ax_versatz[0] -1\nwz[1].ax_versatz[1] 900000\n"
    found, reported = tools(text, True, False)
    tool = found[1]
    assert (tool.length, tool.radius) == (60.0, 1.25)
    assert tool.axis_offsets == {0: -0.0001, 1: 90.0}
    assert reported == []


def test_lengths_of_an_inch_tool() -> None:
    """P-TOOL-00008 = 1: 0.0001 inch = 2.54 µm; angles stay angles."""
    text = "wz[7].mass_einheit 1\nwz[7].laenge 10000\n"
    text += "wz[7].ax_versatz[0] 20000\nwz[7].ax_versatz[1] 20000\n"
    found, _ = tools(text, True, False)
    assert found[7].length == 25.4
    assert found[7].axis_offsets == {0: 50.8, 1: 2.0}


def test_a_tool_is_not_valid_unless_it_says_so() -> None:
    """P-TOOL-00005: default 0; the other defaults of an entry that gives little."""
    found, _ = tools("wz[2].param[5] 1.5\nwz[3].gueltig 1\n", True)
    assert (found[2].valid, found[2].parameters) == (False, {5: 1.5})
    assert (found[3].valid, found[3].length) == (True, 0.0)


def test_tool_0_has_no_dimensions() -> None:
    """D0 removes the dimensions: entries of wz[0] are left out, and reported if they are not 0."""
    found, reported = tools("wz[1].radius 1\nwz[0].laenge 5\nwz[0].radius 0\n", True)
    assert (list(found), reported) == ([1], ["900740 at 2"])
    assert tools("wz[0].laenge 0\nwz[0].ax_versatz[0] 0\n", True) == ({}, [])
    assert tools("wz[0].ax_versatz[0] 1\n", True)[1] == ["900740 at 1"]


def test_offsets_of_axes_that_there_are_not() -> None:
    """Two axes have the indices 0 and 1: an offset of index 2 is left out and reported."""
    assert tools("wz[1].ax_versatz[2] 5\n", True, True)[1] == ["900741 at 1"]
    text = "np_grp[1].achse[1].versch 5\nnp_grp[1].achse[2].versch 5\n"
    offsets, reported = zero_offsets(text)
    assert (dict(offsets.groups[1]), reported) == ({1: 0.0005}, ["900741 at 2"])
    offsets_of_clamps, reported = clamp_offsets("pzv_grp[0].achse[31].versatz 5\n")
    assert (offsets_of_clamps.offset(0, 31), reported) == (0.0, ["900741 at 1"])


def test_zero_offsets_by_group_and_axis() -> None:
    """P-ZERO-00003: G54 is group 1, G159 = 96 the last; what is not listed is 0."""
    text = "np_grp[1].achse[0].versch 100000\nnp_grp[96].achse[1].versch -5000\n"
    offsets, reported = zero_offsets(text)
    assert reported == []
    assert [offsets.offset(1, 0), offsets.offset(1, 1), offsets.offset(2, 0)] == [10.0, 0.0, 0.0]
    assert offsets.offset(96, 1) == -0.5


def test_an_axis_that_a_group_leaves_alone() -> None:
    """P-ZERO-00004 = 1: the offset does not count."""
    text = (
        "np_grp[1].achse[0].versch 5\nnp_grp[1].achse[0].inaktiv 1\nnp_grp[1].achse[1].versch 5\n"
    )
    offsets, _ = zero_offsets(text)
    assert dict(offsets.groups[1]) == {1: 0.0005}


def test_offsets_of_g53() -> None:
    """P-ZERO-00001: group 0 has offsets only where G53 may have some."""
    text = "np_grp[0].achse[0].versch 0\nnp_grp[0].achse[1].versch 70000\n"
    offsets, reported = zero_offsets(text)
    assert (offsets.offset(0, 1), reported) == (0.0, ["900742 at 2"])
    offsets, reported = zero_offsets(text + "g53_verfuegbar 1\n")
    assert (offsets.offset(0, 1), reported) == (7.0, [])


def test_the_group_that_is_active_after_start_up() -> None:
    """P-ZERO-00002: the group must have offsets; 0 is none."""
    assert zero_offsets("default_index 0\n") == (ZeroOffsets(), [])
    offsets, reported = zero_offsets("default_index 2\nnp_grp[2].achse[0].versch 1\n")
    assert (offsets.default_group, reported) == (2, [])
    assert zero_offsets("default_index 2\n")[1] == ["20585 at 1"]


def test_clamp_offsets_by_group_and_axis() -> None:
    """P-CLMP-00001: 0.1 µm."""
    offsets, reported = clamp_offsets("pzv_grp[4].achse[1].versatz 25000\n")
    assert (offsets.offset(4, 1), offsets.offset(4, 0), offsets.offset(3, 1)) == (2.5, 0.0, 0.0)
    assert reported == []
