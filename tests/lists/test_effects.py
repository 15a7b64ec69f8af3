# SPDX-License-Identifier: MIT
"""What is said of a parameter's effect is true: what "takes effect" is read from the lists."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

import pytest

import nctakt
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.declared.offsets import ClampOffsets, ZeroOffsets
from nctakt.lists.declared.startup import ChannelStartup, StartupConfiguration
from nctakt.lists.declared.tools import Tool
from nctakt.lists.format.parameter import Value, pattern_of
from nctakt.lists.format.values import Values
from nctakt.lists.machine.axis_configuration import (
    AxisConfiguration,
    AxisDynamics,
    JerkSlope,
    TrapezoidSlope,
)
from nctakt.lists.machine.channel_configuration import (
    CentreTolerance,
    ChannelParameters,
    ImplicitPrograms,
    NamedAxis,
    ProgramPath,
    ProgramStart,
    RealtimeCycleLimits,
    Spindle,
)
from nctakt.lists.machine.machine import ChannelConfiguration, load_machine
from nctakt.lists.machine.tool_selection import ToolSelection

SOURCE = "\n".join(
    path.read_text("utf-8") for path in sorted(Path(nctakt.__path__[0]).rglob("*.py"))
)
DECLARED = Path(nctakt.__path__[0]) / "lists" / "declared"
#: What the lists of a machine yield.
CONFIGURATIONS = (
    StartupConfiguration,
    ChannelStartup,
    ChannelParameters,
    ChannelConfiguration,
    CentreTolerance,
    ImplicitPrograms,
    NamedAxis,
    ProgramPath,
    ProgramStart,
    RealtimeCycleLimits,
    Spindle,
    ToolSelection,
    AxisConfiguration,
    AxisDynamics,
    JerkSlope,
    TrapezoidSlope,
    Tool,
    ZeroOffsets,
    ClampOffsets,
)
CENTRE = Path(__file__).parent.parent / "machines" / "centre"


def _kinematic(place: str, id_: int) -> str:
    """A universal kinematic with each of its entries."""
    entries = ["number_of_axes 3", "linkage_mode 1", "type 91", "rtcp 1", f"id {id_}"]
    entries += ["zero_orientation[2] 1", "param[0] 1"]
    for i in range(3):
        entries += [f"chain[{i}] {i}", f"axis[{i}].type 1", f"linkage[{i}][{i}] 1"]
        entries.append(f"axis[{i}].orientation[{i}] 1")
    return "".join(f"{place}.{entry}\n" for entry in entries)


_CHANNEL_AXES = "".join(
    f"gruppe[0].achse[{index}].bezeichnung {name}\n" for index, name in enumerate("XYZ")
)
#: Entries that the other machines do not have.
RARE = {
    "hochlauf.lis": (
        "sda_mds[0] sda.lis\nachs_mds[0] axis.lis\nrtconf_lis rtconf.lis\nhand_mds hand.lis\n"
        "achs_kw[0] kw.lis\nhw_configuration_list hw.lis\nscene_mds[0] scene.lis\n"
        "vol_comp[0].file_name vol.lis\nve_var[0] ve.lis\nwerkz_data[0] tools.lis\n"
    ),
    "sda.lis": "g800_prog_file[0] g800.nc\n"
    + _CHANNEL_AXES
    + _kinematic("trafo[0]", 91)
    + _kinematic("kin_step[0].trafo[1]", 92)
    + "trafo[0].base[0] 1\nkin_step[0].trafo[1].base[0] 1\n"
    + "dynamic_weighting[0].path_limit 1\ncurve_dynamic_weighting[0].radius_limit 1\n"
    + "coordinate_system.def[0].id A\nspindel[0].range_table[0].max_speed 1\n"
    + "synchro_data.koppel_gruppe[0].paar[0].mode 1\n",
    "tools.lis": "wz[1].kinematic.param[0] 1\n",
    "axis.lis": "kopf.achs_nr 1\nvorsteuer.vorsteuerung VEL\n",
    "ve.lis": (
        "anzahl_belegt 1\nstruct[0].name T\nstruct[0].element[0].name A\nvar[0].name V\n"
        "var[0].type T\nstruct[0].element[0].access_rights READ_ONLY\n"
    ),
    "rtconf.lis": "external_thread[0].cycle 1000\nexternal_thread[0].semaphore_name S\nEnd\n",
}


def test_each_name_has_one_line_of_its_table() -> None:
    """No name is twice, neither as an entry nor as an old name."""
    for schema in SCHEMAS:
        names = [parameter.pattern for parameter in schema.parameters]
        names += [pattern_of(alias.path) for one in schema.used for alias in one.aliases]
        table = (DECLARED / f"{schema.kind}.tsv").read_text("utf-8").splitlines()[2:]
        entries = [pattern_of(entry) for row in table for entry in row.split("\t")[1].split(" | ")]
        assert len(entries) == len(schema.parameters)
        assert [name for name in names if names.count(name) > 1] == []


def test_each_parameter_that_takes_effect_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What no configuration asks for has no effect, and must not claim it."""
    read: set[tuple[str, str]] = set()
    get = Values.get

    def recorded(values: Values, pattern: str, *indices: int) -> Value:
        read.add((values.schema.kind, pattern))
        return get(values, pattern, *indices)

    monkeypatch.setattr(Values, "get", recorded)
    for name, text in RARE.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    for folder in (None, CENTRE, tmp_path):
        load_machine(folder, detail="all")  # reread, also the built-in one
    declared = {(schema.kind, parameter.pattern) for schema in SCHEMAS for parameter in schema.used}
    assert sorted(declared - read) == []


@pytest.mark.parametrize("configuration", CONFIGURATIONS, ids=lambda one: one.__name__)
def test_each_value_of_a_configuration_is_used(configuration: type) -> None:
    """What is gathered and asked for by nobody has no effect either."""
    unused = [
        item.name for item in fields(configuration) if not re.search(rf"\.{item.name}\b", SOURCE)
    ]
    assert unused == []
