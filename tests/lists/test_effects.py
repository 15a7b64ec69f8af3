# SPDX-License-Identifier: MIT
"""What is said of a parameter's effect is true: what "takes effect" is read from the lists."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import Effect, Value
from nctakt.lists.format.values import Values
from nctakt.lists.machine.machine import load_machine

CENTRE = Path(__file__).parent.parent / "machines" / "centre"
#: Entries that the other machines do not have.
RARE = {
    "hochlauf.lis": (
        "sda_mds[0] sda.lis\nachs_mds[0] axis.lis\nrtconf_lis rtconf.lis\nhand_mds hand.lis\n"
        "achs_kw[0] kw.lis\nhw_configuration_list hw.lis\nscene_mds[0] scene.lis\n"
        "vol_comp[0].file_name vol.lis\nve_var[0] ve.lis\n"
    ),
    "sda.lis": "g800_prog_file[0] g800.nc\n",
    "axis.lis": "kopf.achs_nr 1\nvorsteuer.vs_v_faktor 1\nvorsteuer.vs_v_nenner 2\n",
    "ve.lis": (
        "anzahl_belegt 1\nstruct[0].name T\nstruct[0].element[0].name A\nvar[0].name V\n"
        "var[0].type T\nstruct[0].element[0].access_rights READ_ONLY\n"
    ),
    "rtconf.lis": "external_thread[0].cycle 1000\nexternal_thread[0].semaphore_name S\nEnd\n",
}


def test_what_nctakt_uses_is_declared_in_code_and_the_rest_in_tables() -> None:
    """A declaration in code takes effect, one of a table has none; no name stands in both."""
    for schema in SCHEMAS:
        assert {parameter.effect for parameter in schema.declared} <= {Effect.USED}
        if schema.table is None:
            continue
        assert {one.effect for one in schema.table.parameters()} == {Effect.WITHOUT_EFFECT}
        names = {parameter.pattern for parameter in schema.declared}
        assert names.isdisjoint(schema.table.patterns())


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
        load_machine(folder)
    declared = {
        (schema.kind, parameter.pattern) for schema in SCHEMAS for parameter in schema.declared
    }
    assert sorted(declared - read) == []
