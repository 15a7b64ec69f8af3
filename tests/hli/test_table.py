# SPDX-License-Identifier: MIT
"""The table of the interface: paths, types and places (ST-330), what each element does."""

from __future__ import annotations

import pytest

from nctakt.base.failure import Failure
from nctakt.hli import table
from nctakt.kernel.plc.technology_slots import SLOT_COUNT
from nctakt.lists.machine.machine import load_machine
from nctakt.run.access.machine_names import names_of_machine


def test_a_path_is_found_with_and_without_the_name_of_its_list() -> None:
    found = table.find("HLI_Global_Variables.gpCh[1]^.Bahn_State.program_end_r")
    assert found == table.find("gpCh[1]^.bahn_state.program_end_r")
    assert (found.root, found.index, found.type.name) == ("gpCh", 1, "BOOL")
    assert found.effect == table.SHOWS


def test_members_are_at_multiples_of_their_size() -> None:
    """ST-330; the structures as a client library declares them."""
    record = table.structure("HLI_M_H_PROZESS")
    places = {member.name: member.offset for member in record.members}
    assert record.size_bytes == 32
    assert [places[name] for name in ("nr", "zeit", "nr_late_sync", "synch_mode")] == [0, 4, 20, 24]
    mode = table.structure("HLI_PROC_TRANS_TO_MODE_STATE")
    assert {member.name: member.offset for member in mode.members}["parameter"] == 24
    assert mode.size_bytes == 24 + 300 + 4
    assert table.structure("HLI_ERROR_SATZ_KOPF").size_bytes == 104
    for type_ in table.structures():
        for member in type_.members:
            assert member.offset % member.type.alignment == 0, (type_.name, member.name)


def test_an_element_of_an_array_stands_after_the_one_before() -> None:
    first, second = (
        table.find(f"gpCh[0]^.hb_mc_control.key[{i}].command_w.direction") for i in (0, 1)
    )
    assert second.offset - first.offset == table.structure("MC_CONTROL_HB_KEY_UNIT").size_bytes


def test_names_of_the_older_generation_count_from_one() -> None:
    older = "pMC[2]^.addr^.StateBahn_Data.HLIBahnCoordDispData_Coord[3].D_CmdPosition"
    assert table.find(older).path == "gpCh[1]^.bahn_state.coord_r[2].cmd_position_r"
    for alias, path in table.aliases().items():
        assert table.find(alias.replace("[]", "[1]")).pattern.startswith(
            path.rstrip("]").rstrip("[")
        )


@pytest.mark.parametrize(
    ("path", "number", "word"),
    [
        ("gpCh[0]^.bahn_state.program_ende_r", "902100", "gpCh[0]^.bahn_state.program_end_r?"),
        ("program_end_r", "902100", "gpCh[]^.bahn_state.program_end_r?"),
        ("gpCh[0]^.hb_mc_control.key[12].enable_w", "902101", "from 0 to 11"),
        ("gpCh[0]^.head.plc_present_w[0]", "902102", "plc_present_w"),
        ("gpPform[0]^.plc_present_w", "902102", "gpPform"),
        ("pMC[0]^.addr^.StateBahn_Data.X_ProgramEnd", "902854", "an index from 1 on"),
        ("gpCh[x]^.head.plc_present_w", "902100", "x"),
    ],
)
def test_an_unknown_path_is_reported_with_the_nearest_one(
    path: str, number: str, word: str
) -> None:
    with pytest.raises(Failure) as caught:
        table.find(path)
    assert number in str(caught.value)
    assert word in str(caught.value)


def test_a_part_of_a_name_finds_all_that_have_it() -> None:
    found = [element.pattern for element in table.search("dyn_pos_limit_low")]
    assert found[0] == "gpAx[]^.ipo_mc_control.dyn_pos_limit_low"
    assert "gpAx[]^.ipo_mc_control.dyn_pos_limit_low.command_w" in found


def test_each_tie_names_a_value_that_there_is() -> None:
    signals = names_of_machine(load_machine()).signals()
    for element in table.patterns().values():
        tie = element.tie
        if tie is None or tie.kind in ("fact", table.UNSERVED):
            continue
        if tie.name in table.MANAGED:
            continue
        is_axis = element.root == "gpAx" or "coord_r" in element.path
        prefix = "HLI.S." if tie.name == "OVERRIDE" else "S." if tie.for_spindles else "X."
        assert (prefix if is_axis else "") + tie.name in signals, element.path


def test_sizes_are_those_of_the_realtime_part() -> None:
    units = table.find("gpCh[0]^.techno_unit_std_sync").type
    assert units.count == SLOT_COUNT
    for name, path in (
        ("HLI_KEY_MAXIDX", "gpCh[0]^.hb_mc_control.key"),
        ("HLI_HW_MAXIDX", "gpCh[0]^.hb_mc_control.handwheel_incs"),
        ("HLI_TU_CH_STD_SYNC_MAXIDX", "gpCh[0]^.techno_unit_std_sync"),
        ("HLI_TU_CH_LATE_SYNC_MAXIDX", "gpCh[0]^.techno_unit_late_sync"),
        ("HLI_TU_AX_STD_SYNC_MAXIDX", "gpAx[0]^.techno_unit_std_sync"),
        ("HLI_TECH_UNIT_CH_MAXIDX", "gpCh[0]^.techno_unit_std_sync[0].attribut_r.data"),
        ("HLI_ERR_MASK_MAXIDX", "gpCh[0]^.mc_error.satz_r.rumpf.maske.err_mask"),
        ("HLI_WERT_B_DATA_MAXIDX", "gpCh[0]^.mc_error.satz_r.rumpf.wert_1.inhalt.data"),
    ):
        assert table.constants()[name].value == table.find(path).type.count - 1


def test_ranges_name_groups_that_there_are() -> None:
    groups = {constant.group for constant in table.constants().values()}
    rows = [element.said for element in table.patterns().values() if element.said is not None]
    named = {row.range for row in rows if row.range.startswith("HLI_")}
    assert named <= groups
