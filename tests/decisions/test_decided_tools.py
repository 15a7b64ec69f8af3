# SPDX-License-Identifier: MIT
"""Tools with IDs (#TOOL), their data (V.TOOL, V.TLM, V.G.WZ): docs/conformance/tools.md."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.check_machine import demo_channel
from support.decided import numbers, perform

from nctakt.checking.program import check_program
from nctakt.checking.program_pass import ProgramChannel
from nctakt.files.access import FileAccess
from nctakt.lists.declared.schemas import CHANNEL, TOOLS
from nctakt.lists.declared.tools import Tool, tools_configuration
from nctakt.lists.format.list_check import load_list
from nctakt.lists.machine.machine import load_machine
from nctakt.lists.machine.tool_selection import tool_selection
from nctakt.messages import Collector
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.source import Source
from nctakt.run.controller import Controller


def tool(number: int, identity: tuple[int, int, int], length: float) -> Tool:
    """A valid tool of this length in mm."""
    return Tool(
        number, True, 0, length, 5.0, {}, {}, 0, 0, {}, 1, False, identity,
        bool(identity[1]), bool(identity[2]),
    )  # fmt: skip


def machine(*tools: Tool, **selection: float) -> Controller:
    """The demo machine with these tools, and other effects of T and D (``ToolSelection``)."""
    demo = load_machine(None)
    (channel,) = demo.channels
    listed = {one.number: one for one in tools}
    parameters = channel.parameters
    selected = replace(parameters.tool_selection, **selection)
    parameters = replace(parameters, tool_selection=selected)
    return Controller(
        replace(demo, channels=(replace(channel, tools=listed, parameters=parameters),))
    )


SISTERS = (tool(1, (20, 0, 0), 10.0), tool(2, (20, 1, 0), 11.0), tool(3, (20, 1, 4), 12.0))


def message(program: str, controller: Controller | None = None) -> str:
    """The last message of a program that ends without an error."""
    run = perform(f"{program}\nM30", controller)
    assert run.state == "ended", run.diagnostics
    return run.messages[-1].text


@pytest.mark.parametrize(
    ("word", "length", "identity"),
    [
        ("#TOOL DATA [20]", "10.0", "20 0 0"),
        ("#TOOL DATA [20, 1]", "11.0", "20 1 0"),
        ("P1 = 1\n#TOOL DATA [10 + 10, P1, 4]", "12.0", "20 1 4"),
        ("D20", "10.0", "20 0 0"),
        ("#TOOL DATA [0]", "0.0", "0 0 0"),
    ],
)
def test_an_id_selects_tool_sister_and_variant(word: str, length: str, identity: str) -> None:
    """208577419: parts that are missing are 0; D is the basic number."""
    names = "V.G.WZ_AKT.L, V.TOOL.BASIC, V.TOOL.SISTER, V.TOOL.VARIANT"
    text = f'{word}\n#MSG ["%.1f %d %d %d", {names}]'
    assert message(text, machine(*SISTERS)) == f"{length} {identity}"


def test_an_id_that_no_tool_has_is_an_error() -> None:
    """20172 for the data, 20167 for the tool."""
    run = perform("#TOOL DATA [20, 2]\nM30", machine(*SISTERS))
    assert numbers(run) == [20172]
    assert "20, 2, 0" in str(run.diagnostics[0])
    assert numbers(perform("#TOOL PREP [21]\nM30", machine(*SISTERS))) == [20167]
    assert numbers(perform("#TOOL DATA [1.5]\nM30", machine(*SISTERS))) == [20171]


@pytest.mark.parametrize(
    ("program", "found"),
    [
        ("T21\nT20\n#TOOL PREP [21, 3]", []),
        ("D20", []),
        ("D21", [20296]),
        ("#TOOL DATA [20, 2]", [20296]),
    ],
)
def test_an_external_tool_management_has_other_tools_than_the_list(
    program: str, found: list[int]
) -> None:
    """P-CHAN-00016, page 15335641227: T informs the PLC, D asks it; here the list answers for it.

    What it does not know is 20296, diagnosis page 251337611.
    """
    run = perform(f"{program}\nM30", machine(*SISTERS, is_external=True))
    assert [number for number in numbers(run) if number != 900201] == found
    assert numbers(perform("D20\nM30", machine(is_external=True))) == [20296]


def test_the_tool_is_prepared_without_its_offsets() -> None:
    """``#TOOL PREP`` is T: V.G.T_AKT, not D_AKT."""
    text = '#TOOL PREP [20, 1]\n#MSG ["%d %d", V.G.T_AKT, V.G.D_AKT]'
    assert message(text, machine(*SISTERS)) == "20 0"


def test_the_data_of_ids_can_be_read() -> None:
    """V.G.WZ[j] with the basic number, V.G.WZ_AKT."""
    names = "V.G.WZ_AKT.SISTER, V.G.WZ_AKT.SISTER_VALID, V.G.WZ[20].VARIANT_VALID, V.G.WZ_AKT.TYPE"
    text = f'#TOOL DATA [20, 1]\n#MSG ["%d %d %d %d", {names}]'
    assert message(text, machine(*SISTERS)) == "1 1 0 1"


def test_a_tool_of_the_list_is_changed_until_the_next_start_up() -> None:
    """V.G.WZ[j] is written; the active tool follows with D or #TOOL REFRESH."""
    controller = machine(*SISTERS)
    read = '#MSG ["%.1f %.1f %.1f", V.G.WZ_AKT.L, V.G.WZ[20].P[3], V.G.WZ[20].V.X]'
    text = "D20\nV.G.WZ[20].L = 33\nV.G.WZ[20].P[3] = 4.5\nV.G.WZ[20].V.X = 2\n"
    assert message(f"{text}{read}", controller) == "10.0 4.5 2.0"
    assert message(f"D20\n{read}", controller) == "33.0 4.5 2.0"
    text = f"D20\nV.G.WZ[20].L = 34\n#TOOL REFRESH\n{read}"
    assert message(text, controller) == "34.0 4.5 2.0"
    assert message(f"D20\n{read}", machine(*SISTERS)) == "10.0 0.0 0.0"


def test_the_offsets_of_the_active_tool_are_written() -> None:
    """V.G.WZ_AKT.V.X shifts absolute positions from the next block on."""
    text = 'D20\nV.G.WZ_AKT.V.X = 2\nG01 X10 F6000\n#MSG ["%.1f", V.A.ABS.X]'
    assert message(text, machine(*SISTERS)) == "12.0"


def test_factors_of_tool_life_outlive_programs() -> None:
    """208584843: at least 0, 1 at the start."""
    controller = Controller()
    read = '#MSG ["%.1f %.1f", V.TLM.TIME_FACT, V.TLM.DIST_FACT]'
    assert message(read, controller) == "1.0 1.0"
    message(f"V.TLM.TIME_FACT = 2.5\n{read}", controller)
    assert message(read, controller) == "2.5 1.0"
    assert numbers(perform("V.TLM.DIST_FACT = -1\nM30")) == [901720]


def test_other_commands_are_refused() -> None:
    """There is no such form, and no such command."""
    assert perform("#TOOL DATA\nM30").state != "ended"
    assert perform("#TOOL CHANGE\nM30").state != "ended"


def test_the_list_gives_tools_their_ids() -> None:
    """P-TOOL-00140 … 00145: sister and variant count where they are valid."""
    text = (
        "wz[0].tool_id.basic 7\nwz[1].tool_id.basic 7\nwz[1].tool_id.sister 2\n"
        "wz[1].tool_id.variant 3\nwz[1].tool_id.variant_valid 1\n"
    )
    for head, expected in (
        ("", [(1, 0, 0)]),
        ("tool_data_with_id 1\n", [(7, 0, 0), (7, 0, 3)]),
    ):
        collector = Collector()
        values = load_list(TOOLS, "x.lis", f"{head}{text}".encode(), collector)
        tools = tools_configuration(values, (True,), collector)
        assert [one.identity for one in tools.values()] == expected


LONG = tool(5, (5, 0, 0), 20.0)
POSITIONS = '#MSG ["%.1f %.1f %.1f", V.A.ABS.X, V.A.ABS.Y, V.A.ABS.Z]'


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("G01 Z10 F6000\nD5", "0.0 0.0 30.0"),
        ("G01 Z10 F6000\nD5 X4", "4.0 0.0 30.0"),
        ("G01 Z10 F6000\nD5 G91 Z1", "0.0 0.0 31.0"),
        ("G01 Z10 F6000\nD5 Z3", "0.0 0.0 23.0"),
        ("G01 Z10 F6000\nD5\nD0", "0.0 0.0 10.0"),
        ("G01 Z10 F6000\n#TOOL DATA [5]", "0.0 0.0 30.0"),
        ("G02 X10 I5 F6000\nD5", "10.0 0.0 20.0"),
        ("G01 X10 Z10 F6000\nG21\nD5 G91 X1\nG20", "9.0 0.0 30.0"),
        ("G01 Z10 F6000\nG18\nD5", "0.0 20.0 10.0"),
        ("G70 G01 Z1 F600\nD5", "0.0 0.0 1.8"),
        ("G00 Z10\nD5 G92 X3", "0.0 0.0 30.0"),
    ],
)
def test_offsets_that_move_the_axes_at_once(text: str, shown: str) -> None:
    """P-CHAN-00100: the axes keep their programmed positions in the block of D."""
    assert message(f"{text}\n{POSITIONS}", machine(LONG, moves_directly=True)) == shown


def test_offsets_move_nothing_by_themselves() -> None:
    """Without P-CHAN-00100."""
    assert message(f"G01 Z10 F6000\nD5 X4\n{POSITIONS}", machine(LONG)) == "4.0 0.0 10.0"


def test_direct_offsets_respect_limits_feed_and_systems() -> None:
    """120002 beyond a limit; no feed: as each line; in a turned system along the machine's axis."""
    far = machine(tool(5, (5, 0, 0), 90_000.0), moves_directly=True)
    assert 120002 in numbers(perform("G00 X1\nD5\nM30", far))
    text = f"#CS ON [0, 0, 0, 0, 0, 90]\nG01 X10 F6000\nD5\n{POSITIONS}"
    run = perform(f"{text}\nM30", machine(LONG, moves_directly=True))
    assert run.state == "ended", run.diagnostics
    assert run.messages[-1].text == "10.0 0.0 0.0"


def test_the_length_stays_in_the_third_main_axis() -> None:
    """P-CHAN-00420: in G18 as well."""
    text = f"G18 D5\nG01 Y1 Z1 F6000\n{POSITIONS}"
    assert message(text, machine(LONG)) == "0.0 21.0 1.0"
    assert message(text, machine(LONG, keeps_length_axis=True)) == "0.0 1.0 21.0"


def test_tools_that_are_too_small() -> None:
    """P-CHAN-00156, P-CHAN-00157: 21426, 21427, also reported by a check; D0 is none."""
    controller = machine(LONG, min_length=20.5, min_radius=5.5)
    assert numbers(perform("D0\nP1 = 5\nDP1\nM30", controller)) == [21426]
    assert numbers(perform("#TOOL DATA [5]\nM30", machine(LONG, min_radius=5.5))) == [21427]
    collector, channel = Collector(), controller.machine.channels[0]
    check_program(
        Source("p.nc", ("D5", "D0", "M30")),
        ProgramChannel(
            demo_channel().names, channel.parameters, StepLimits(201, 200), channel.tools
        ),
        collector,
        access=FileAccess(),
    )
    assert [one.id for one in collector.diagnostics] == [21426, 21427]
    assert perform("D5\nM30", machine(LONG, min_length=20.0, min_radius=5.0)).state == "ended"


def test_a_flush_before_t() -> None:
    """P-CHAN-00106 with P-CHAN-00087: not while a contour waits for its next motion."""
    text = "V.G.WZ_AKT.R = 2\nG41 G01 X10 F6000\nX20\nT5\nX30\nG40 Y10\nM30"
    assert perform(text, machine(LONG)).state == "ended"
    assert 20651 in numbers(perform(text, machine(LONG, flushes_before_t=True)))
    assert (
        perform("G01 X5 F600\nT5\nX6\nM30", machine(LONG, flushes_before_t=True)).state == "ended"
    )


def test_the_list_says_what_t_and_d_do() -> None:
    """21244: the flush needs the external tool management."""
    for text, found in (
        ("t_with_implicit_flush 1\n", [21244]),
        ("t_with_implicit_flush 1\nt_info_to_wzv 1\n", []),
    ):
        collector = Collector()
        values = load_list(
            CHANNEL, "x.lis", f"{text}tool.minimum_radius 15000\n".encode(), collector
        )
        selection = tool_selection(values, collector)
        assert [one.id for one in collector.diagnostics] == found
        assert selection.flushes_before_t == (not found)
        assert (selection.min_length, selection.min_radius) == (0.0, 1.5)


def test_all_data_that_programs_may_write() -> None:
    """318262795: OK, SPDL_AX_NR, KIN_ID, KIN_PARAM and SRK_ID of the internal table, too."""
    controller = machine(LONG)
    names = ("OK", "SPDL_AX_NR", "KIN_ID", "SRK_ID", "KIN_PARAM[3]")
    for tool_ in ("V.G.WZ[5]", "V.G.WZ_AKT"):
        text = "D5\n" + "".join(f"{tool_}.{name} = {n}\n" for n, name in enumerate(names))
        read = ", ".join(f"{tool_}.{name}" for name in names)
        assert message(f'{text}#MSG ["%d %d %d %d %d", {read}]', controller) == "0 1 2 3 4"
        perform(f"{tool_}.OK = 1\nM30", controller)
    assert numbers(perform("V.G.WZ[5].OK = 0\nP1 = 5\nDP1\nM30", controller)) == [20691]
    assert numbers(perform("V.G.WZ[5].SRK_ID = 1.5\nM30", controller)) == [22024]
    assert numbers(perform("V.G.WZ[5].KIN_ID = -1\nM30", controller)) == [22024]
    assert 20100 in numbers(perform("V.G.WZ[5].TYPE = 1\nM30", controller))


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("#TLAX [X-]\nD5", "-19.0 1.0 1.0"),
        ("D5\n#TLAX [ y + ]", "1.0 21.0 1.0"),
        ("#TLAX [Z-]\nG18 D5", "1.0 1.0 -19.0"),
        ("#TLAX [X-]\nG18 D5\n#TLAX DEFAULT", "1.0 21.0 1.0"),
    ],
)
def test_the_length_is_assigned_to_an_axis(text: str, shown: str) -> None:
    """304765835: ``#TLAX`` until DEFAULT or the program's end; nothing moves by itself."""
    controller = machine(LONG)
    assert message(f"{text}\nG01 X1 Y1 Z1 F6000\n{POSITIONS}", controller) == shown
    assert message(f"D5\nG01 X1 Y1 Z1 F6000\n{POSITIONS}", controller) == "1.0 1.0 21.0"


def test_wrong_forms_of_tlax() -> None:
    """A sign, one of the first three axes of the channel, DEFAULT alone."""
    for text in ("[Z]", "[Z+, X+]", "[A+]", "[Q-]", "[]", "", "DEFAULT [Z+]", "[1]", "OFF"):
        assert perform(f"#TLAX {text}\nM30").state == "error", text
    assert numbers(perform("#TLAX [A+]\nM30")) == [900233]
