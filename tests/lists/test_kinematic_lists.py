# SPDX-License-Identifier: MIT
"""Kinematics in channel lists: read, checked, and refused with the entry (language: 1.2, 1.4)."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.lists.machine.transformations.kinematics import Transformations
from nctakt.messages.machines import kinematics

KINEMATIC_MESSAGES = [
    message for name, message in vars(kinematics).items() if name.startswith("KINEMATIC")
]
AXES = "XYZCA"
HEAD = """
trafo[0].id 91
trafo[0].zero_orientation[2] 1
trafo[0].zero_position[0] 12000
trafo[0].zero_position[1] -3200
trafo[0].zero_position[2] 500
trafo[0].rtcp 1
trafo[0].programming_mode 17
trafo[0].number_of_axes 5
trafo[0].chain[0] 0
trafo[0].chain[1] 1
trafo[0].chain[2] 2
trafo[0].chain[3] 3
trafo[0].chain[4] 4
trafo[0].axis[0].type 1
trafo[0].axis[0].orientation[0] 1
trafo[0].axis[1].type 1
trafo[0].axis[1].orientation[1] 1
trafo[0].axis[2].type 1
trafo[0].axis[2].orientation[2] 1
trafo[0].axis[3].type 2
trafo[0].axis[3].orientation[2] 1
trafo[0].axis[4].type 2
trafo[0].axis[4].orientation[0] 1
trafo[0].axis[4].point[2] 1000000
"""


def machine_of(folder: Path, entries: str, axes: str = AXES) -> Machine:
    """Return a machine whose channel list has these entries."""
    startup = ["zykl_anzahl 1", "sda_mds[0] sda.lis"]
    channel = [f"gruppe[0].achs_anzahl {len(axes)}"]
    for index, name in enumerate(axes):
        startup.append(f"achs_mds[{index}] axis{index}.lis")
        channel.append(f"gruppe[0].achse[{index}].log_achs_nr {index + 1}")
        channel.append(f"gruppe[0].achse[{index}].bezeichnung {name}")
        (folder / f"axis{index}.lis").write_text(f"kopf.achs_nr {index + 1}\nEnd\n")
    (folder / "hochlauf.lis").write_text("\n".join([*startup[1:], "End", ""]))
    (folder / "sda.lis").write_text("\n".join(channel) + entries + "End\n")
    return load_machine(folder)


def read(folder: Path, entries: str, axes: str = AXES) -> tuple[Transformations, list[str]]:
    """Return the transformations of a list, and what is reported about it."""
    machine = machine_of(folder, entries, axes)
    found = [
        f"{one.id} {one.entry}" for one in machine.diagnostics if one.message in KINEMATIC_MESSAGES
    ]
    return machine.channels[0].parameters.transformations, found


def test_universal_kinematic_is_read(tmp_path: Path) -> None:
    """The published example of a head C A: lengths in mm, the chain, RTCP, mode 17."""
    transformations, found = read(tmp_path, HEAD + "kinematik_id 91\n")
    assert found == []
    assert transformations.default_ids == (91, 0)
    kinematic = transformations.steps[0][91]
    assert (kinematic.type, kinematic.universal is not None) == (91, True)
    universal = kinematic.universal
    assert universal is not None
    assert universal.zero_position == (1.2, -0.32, 0.05)
    assert universal.zero_orientation == (0.0, 0.0, 1.0)
    assert universal.is_rtcp
    assert universal.chain == (0, 1, 2, 3, 4)
    assert universal.rotary == (3, 4)
    assert universal.axes[4].point == (0.0, 0.0, 100.0)


def test_ids_may_share_a_type_and_steps_are_apart(tmp_path: Path) -> None:
    """``type`` names the type, without it the ID does; ``kin_step`` says which step."""
    entries = """
trafo[0].id 1
trafo[0].type 9
trafo[0].param[0] 1000000
trafo[1].id 9
kin_step[0].trafo[4].id 34
kin_step[1].trafo[0].id 5
default_id_of_kin_step[0] 9
default_id_of_kin_step[1] 5
"""
    transformations, found = read(tmp_path, entries)
    assert found == []
    assert {id_: one.type for id_, one in transformations.steps[0].items()} == {
        1: 9,
        9: 9,
        34: 34,
    }
    assert list(transformations.steps[1]) == [5]
    assert transformations.default_ids == (9, 5)
    assert transformations.steps[0][1].parameters == {0: 1000000.0}


def test_mode_of_the_channel_counts_without_one_of_the_kinematic(tmp_path: Path) -> None:
    """P-CHAN-00112 takes the values of P-CHAN-00288, which comes first."""
    entries = HEAD.replace("programming_mode 17", "programming_mode 0").replace("rtcp 1", "rtcp 0")
    transformations, found = read(tmp_path, entries + "ori_rotation_angle 16\n")
    assert found == []
    universal = transformations.steps[0][91].universal
    assert universal is not None
    assert universal.programming_mode == 16


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("id 91", "id 0", "901488 trafo[0].id"),
        ("number_of_axes 5", "number_of_axes 2", "901489 trafo[0].number_of_axes"),
        ("number_of_axes 5", "number_of_axes 6", "901489 trafo[0].number_of_axes"),
        ("chain[4] 4", "chain[4] 5", "901490 trafo[0].chain[0]"),
        ("chain[4] 4", "chain[4] 3", "901490 trafo[0].chain[0]"),
        ("axis[2].type 1", "axis[2].type 2", "901491 trafo[0].axis[2].type"),
        ("axis[3].type 2", "axis[3].type 7", "901491 trafo[0].axis[3].type"),
        ("axis[3].orientation[2] 1", "", "901492 trafo[0].axis[3].orientation[0]"),
        ("zero_orientation[2] 1", "", "901492 trafo[0].zero_orientation[0]"),
        ("axis[2].orientation[2]", "axis[2].orientation[0]", "901493 trafo[0].axis[0].orientation"),
        ("rtcp 1", "linkage_mode 1", "901493 trafo[0].linkage[0][0]"),
        ("programming_mode 17", "programming_mode 11", "901494 trafo[0].programming_mode"),
        ("programming_mode 17", "programming_mode 10", "901496 trafo[0].programming_mode"),
    ],
)
def test_defective_kinematics_cannot_be_selected(
    tmp_path: Path, old: str, new: str, expected: str
) -> None:
    """Each mistake is reported at its entry, and the kinematic is left out."""
    kept = [line.replace(old, new) for line in HEAD.splitlines() if new or old not in line]
    entries = "\n".join([*kept, ""])
    transformations, found = read(tmp_path, entries)
    assert [one for one in found if one.startswith(expected)], found
    assert 91 not in transformations.steps[0]


def test_complete_kinematic_needs_a_mode(tmp_path: Path) -> None:
    """Without RTCP a mode says what is programmed for the tool's direction."""
    entries = HEAD.replace("rtcp 1", "rtcp 0").replace("programming_mode 17", "type 91")
    assert read(tmp_path, entries)[1] == ["901494 trafo[0].programming_mode"]


def test_orientation_needs_two_axes_that_turn_the_tool(tmp_path: Path) -> None:
    """A complete kinematic whose second axis lies along the tool cannot point it."""
    entries = HEAD.replace("rtcp 1", "rtcp 0").replace(
        "axis[4].orientation[0]", "axis[4].orientation[2]"
    )
    transformations, found = read(tmp_path, entries)
    assert found == ["901495 trafo[0].rtcp"]
    assert transformations.steps[0] == {}


def test_second_definition_of_an_id_is_ignored(tmp_path: Path) -> None:
    """The first kinematic of an ID counts."""
    transformations, found = read(tmp_path, "\ntrafo[0].id 9\ntrafo[3].id 9\ntrafo[3].type 34\n")
    assert found == ["901487 trafo[3].id"]
    assert transformations.steps[0][9].type == 9


def test_old_form_is_not_read(tmp_path: Path) -> None:
    """``kinematik[91]`` is from old versions: reported where it is used, and without effect."""
    machine = machine_of(tmp_path, "\nkinematik[91].param[0] 5\nkinematik[91].rtcp 1\n")
    assert machine.channels[0].parameters.transformations.steps[0] == {}
    assert [one.id for one in machine.diagnostics if one.id in {900028, 900008}] == [900028]
