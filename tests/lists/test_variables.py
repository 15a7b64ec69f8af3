# SPDX-License-Identifier: MIT
"""Variables lists: V.E, V.CH, structures, arrays, inheritance."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.changed_lists import machine_with

from nctakt.lists.declared.schemas import VARIABLES
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format.list_check import load_list
from nctakt.lists.machine.external.variables import (
    MANAGEMENT_BYTES,
    MAX_LEAVES,
    AccessRights,
    VariablesConfiguration,
    VariableScope,
    VariableSpace,
    channel_memory_bytes,
    variables_configuration,
)
from nctakt.messages import Collector
from nctakt.run.controller import Controller, NcText


def load(text: str, count: int | None = 100) -> tuple[VariablesConfiguration, list[int]]:
    """The variables of a list, and what was found."""
    if count is not None:
        text += f"\nnumber_used_variables {count}\n"
    collector = Collector()
    values = load_list(VARIABLES, "v.lis", text.encode(), collector)
    configuration = variables_configuration(values, collector)
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return configuration, [found.id for found in collector.diagnostics]


def paths(configuration: VariablesConfiguration) -> list[str]:
    """All leaves of the external variables."""
    return [leaf.path for variable in configuration.external for leaf in variable.leaves()]


def test_defaults_of_a_variable() -> None:
    """A variable that has a name only is UNS32, CHANNEL, synchronous, READ_WRITE (P-EXTV)."""
    configuration, found = load("var[0].name A")
    assert found == []
    (variable,) = configuration.external
    (leaf,) = variable.leaves()
    assert (leaf.path, leaf.steps, leaf.type) == ("A", ("A",), "UNS32")
    assert (leaf.scope, leaf.space) == (VariableScope.CHANNEL, VariableSpace.EXTERNAL)
    assert (leaf.synchronous, leaf.rights) == (True, AccessRights.READ_WRITE)
    assert (leaf.size_bytes, leaf.is_numeric, variable.byte_offset) == (4, True, -1)


@pytest.mark.parametrize("type_", list(SCALARS))
def test_each_type_exists(type_: str) -> None:
    """All basic types are known; character strings are no numbers."""
    configuration, found = load(f"var[0].name A\nvar[0].type {type_}")
    assert found == []
    (leaf,) = configuration.external[0].leaves()
    assert leaf.is_numeric is (type_ not in {"STRING", "VSTRING"})
    numeric = list(configuration.external[0].numeric_leaves())
    assert len(numeric) == int(leaf.is_numeric)
    assert SCALARS[type_].is_integer is (type_ not in {"REAL64", "STRING", "VSTRING"})


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("var[0].type STRING", 24),
        ("var[0].type STRING\nuse_extended_string_var 1", 128),
        ("var[0].type VSTRING", 128),
        ("var[0].type VSTRING\nvar[0].size 800", 800),
        ("var[0].type REAL64\nvar[0].size 4", 8),
    ],
)
def test_sizes(text: str, size: int) -> None:
    """P-EXTV-00008, 00022: sizes of strings come from the list, others from the type."""
    configuration, _ = load(f"var[0].name A\n{text}")
    (leaf,) = configuration.external[0].leaves()
    assert leaf.size_bytes == size


@pytest.mark.parametrize("key", ["array_elements", "array_size"])
def test_arrays(key: str) -> None:
    """An array has its elements from 0; both names of its size count."""
    configuration, found = load(f"var[0].name A\nvar[0].{key} 3")
    assert (paths(configuration), found) == (["A[0]", "A[1]", "A[2]"], [])


STRUCTURES = """
struct[0].name OUTER
struct[0].element[0].name X
struct[0].element[0].type REAL64
struct[0].element[1].name IN
struct[0].element[1].type INNER
struct[0].element[1].array_size 2
struct[0].element[2].name FROZEN
struct[0].element[2].synchronisation FALSE
struct[1].name INNER
struct[1].element[0].name N
struct[1].element[0].type SGN08
struct[1].element[1].name LIVE
struct[1].element[1].synchronisation TRUE
struct[1].element[1].access_rights READ_ONLY
"""


def test_structures_unfold_in_order() -> None:
    """Members and elements of arrays come in the order of the list, nested as deep as it says."""
    text = f"var[0].name S\nvar[0].type OUTER\nvar[0].array_elements 2\n{STRUCTURES}"
    configuration, found = load(text)
    assert found == []
    one = ["X", "IN[0].N", "IN[0].LIVE", "IN[1].N", "IN[1].LIVE", "FROZEN"]
    assert paths(configuration) == [f"S[{index}].{path}" for index in (0, 1) for path in one]
    leaf = list(configuration.external[0].leaves())[1]
    assert leaf.steps == ("S", 0, "IN", 0, "N")


@pytest.mark.parametrize("own", ["TRUE", "FALSE"])
def test_synchronisation_is_inherited_and_can_be_overridden(own: str) -> None:
    """P-EXTV-00005, 00018: members take it from what they belong to, unless they say otherwise."""
    text = f"var[0].name S\nvar[0].type OUTER\nvar[0].synchronisation {own}\n{STRUCTURES}"
    configuration, _ = load(text)
    found = {leaf.path: leaf.synchronous for leaf in configuration.external[0].leaves()}
    inherited = own == "TRUE"
    assert found["S.X"] is found["S.IN[0].N"] is inherited
    assert found["S.IN[1].LIVE"] is True
    assert found["S.FROZEN"] is False


def test_access_rights_are_inherited_and_can_be_overridden() -> None:
    """P-EXTV-00006, 00019: as synchronisation."""
    text = f"var[0].name S\nvar[0].type OUTER\nvar[0].access_rights WRITE_ONLY\n{STRUCTURES}"
    configuration, _ = load(text)
    found = {leaf.path: leaf.rights for leaf in configuration.external[0].leaves()}
    assert found["S.X"] is AccessRights.WRITE_ONLY
    assert found["S.IN[0].LIVE"] is AccessRights.READ_ONLY


def test_channel_variables() -> None:
    """V.CH variables are in the same list, under vch, and need no number of variables."""
    text = "vch[0].name Var_name\nvch[0].type SGN08\nvch[0].array_size 0\n"
    configuration, found = load(f"{text}vch[0].synchronisation FALSE", count=None)
    assert found == []
    (leaf,) = configuration.channel[0].leaves()
    assert (leaf.space, leaf.path) == (VariableSpace.CHANNEL, "Var_name")
    assert (leaf.synchronous, leaf.type) == (False, "SGN08")


def test_memory_of_channel_variables() -> None:
    """RC-309: data plus a fixed number of bytes for each variable."""
    text = "vch[0].name A\nvch[0].type REAL64\nvch[0].array_size 3\nvch[1].name B"
    configuration, _ = load(text)
    assert channel_memory_bytes(configuration.channel) == 3 * 8 + 4 + 2 * MANAGEMENT_BYTES


@pytest.mark.parametrize(
    ("count", "names", "numbers"),
    [(3, ["A", "C"], []), (2, ["A"], [900081]), (0, [], [900081]), (None, [], [900081])],
)
def test_variables_beyond_the_number_do_not_exist(
    count: int | None, names: list[str], numbers: list[int]
) -> None:
    """P-EXTV-00010 is the highest index plus 1; gaps are allowed."""
    configuration, found = load("var[0].name A\nvar[2].name C", count)
    assert (paths(configuration), found) == (names, numbers)


def test_old_name_of_the_number() -> None:
    """anzahl_belegt is the old name of number_used_variables."""
    assert load("var[0].name A\nanzahl_belegt 1", None)[1] == []


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("var[0].type REAL64", 20788),
        ("var[0].name 1A", 20788),
        ("var[0].name A-B", 20788),
        ('var[0].name ""', 20788),
        ("var[0].name " + "A" * 257, 21182),
        ("var[0].name Größe", 20788),
    ],
)
def test_unusable_names(text: str, number: int) -> None:
    """P-EXTV-00001: a variable without a usable name of up to 256 characters is left out."""
    configuration, found = load(text)
    assert (paths(configuration), found) == ([], [number])


def test_longest_name() -> None:
    """The manual names 26 characters; longer names are taken with a note."""
    assert load("var[0].name " + "A" * 26)[1] == []
    configuration, numbers = load("var[0].name " + "A" * 27)
    assert (paths(configuration), numbers) == (["A" * 27], [900972])


@pytest.mark.parametrize(
    ("word", "synchronous"), [("SYN", True), ("ASYN", False), ("VE_INHERIT_SYNCH", True)]
)
def test_names_of_the_synchronisation(word: str, synchronous: bool) -> None:
    """P-EXTV-00005: names beside truth values; a variable on its own inherits the default."""
    configuration, numbers = load(f"var[0].name A\nvar[0].synchronisation {word}")
    assert (configuration.external[0].node.synchronous, numbers) == (synchronous, [])


def test_rights_that_are_inherited() -> None:
    """P-EXTV-00019: INHERIT_ACCESS leaves the rights to what the element belongs to."""
    text = (
        "struct[0].name T\nstruct[0].element[0].name A\nvar[0].name V\nvar[0].type T\n"
        "struct[0].element[0].access_rights INHERIT_ACCESS\nvar[0].access_rights READ_ONLY\n"
    )
    configuration, numbers = load(text)
    (leaf,) = configuration.external[0].leaves()
    assert (leaf.rights, numbers) == (AccessRights.READ_ONLY, [])
    configuration, numbers = load("var[0].name V\nvar[0].access_rights INHERIT_ACCESS\n")
    (leaf,) = configuration.external[0].leaves()
    assert (leaf.rights, numbers) == (AccessRights.READ_WRITE, [])


def test_names_are_unique_and_case_sensitive() -> None:
    """The second variable of a name is left out; a and A differ."""
    configuration, found = load("var[0].name A\nvar[1].name a\nvar[2].name A")
    assert (paths(configuration), found) == (["A", "a"], [21485])


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("var[0].type NOWHERE", [20088]),
        ("var[0].type real64", [20088]),
        ("var[0].type S\nstruct[0].name S", [20088]),
        (
            "var[0].type S\nstruct[0].name S\nstruct[0].element[0].name A\n"
            "struct[0].element[0].type T",
            [21441],
        ),
        (
            "var[0].type S\nstruct[0].name S\nstruct[0].element[0].name A\n"
            "struct[0].element[0].type S",
            [900083],
        ),
        (
            "var[0].type S\nstruct[0].name S\nstruct[0].element[0].name A\n"
            "struct[0].element[0].type T\nstruct[1].name T\nstruct[1].element[0].name B\n"
            "struct[1].element[0].type S",
            [900083],
        ),
    ],
)
def test_unusable_types(text: str, numbers: list[int]) -> None:
    """A type that does not exist, is empty or contains itself leaves the variable out."""
    configuration, found = load(f"var[0].name V\n{text}")
    assert (paths(configuration), found) == ([], numbers)


@pytest.mark.parametrize(("elements", "numbers"), [(65535, []), (65536, [21602])])
def test_largest_array(elements: int, numbers: list[int]) -> None:
    """The bound of P-EXTV-00007 is that of its type."""
    assert load(f"var[0].name V\nvar[0].array_elements {elements}")[1] == numbers


@pytest.mark.parametrize(("members", "fits"), [(64, True), (65, False)])
def test_largest_variable(members: int, fits: bool) -> None:
    """A variable holds at most 65536 numbers; one more and it is left out."""
    lines = ["var[0].name V", "var[0].type S", "var[0].array_elements 1024", "struct[0].name S"]
    lines += [f"struct[0].element[{index}].name M{index}" for index in range(members)]
    configuration, found = load("\n".join(lines))
    assert found == ([] if fits else [900084])
    assert len(paths(configuration)) == (MAX_LEAVES if fits else 0)


def test_a_list_does_not_take_all_memory() -> None:
    """All variables together have at most 2^20 elements (902028); smaller ones still fit."""
    lines = [
        f"var[{index}].name V{index}\nvar[{index}].array_elements {size}"
        for index, size in enumerate([65535] * 18 + [16])
    ]
    configuration, found = load("\n".join(lines))
    assert found == [902028, 902028]
    names = [variable.name for variable in configuration.external]
    assert names == [f"V{index}" for index in (*range(16), 18)]


@pytest.mark.parametrize(("depth", "numbers"), [(32, []), (33, []), (34, [21440])])
def test_deepest_nesting(depth: int, numbers: list[int]) -> None:
    """Structures nest 33 deep, not deeper."""
    lines = ["var[0].name V", "var[0].type S0"]
    for index in range(depth):
        inner = f"S{index + 1}" if index + 1 < depth else "UNS08"
        lines += [
            f"struct[{index}].name S{index}",
            f"struct[{index}].element[0].name M",
            f"struct[{index}].element[0].type {inner}",
        ]
    assert load("\n".join(lines))[1] == numbers


def test_entries_without_effect() -> None:
    """Names for the operating panel, old places and the like are known; one may change a run."""
    text = (
        "name_rd_global_array cnc_ve_%s_[%d]_r\nname_wr_channel mc_ve_%s_w\n"
        "var[0].name A\nvar[0].index 0\nvar[0].create_hmi_interface 0\n"
        "check_overlapping_variables 1\nauto_memory_mode 0\ninit 1"
    )
    assert load(text)[1] == [900029]


def test_a_type_of_another_language_is_reported_with_the_one_of_lists() -> None:
    """20088 names what is nearest, and the variable is kept as ignored, with both places."""
    collector = Collector()
    text = "number_used_variables 1\nvar[0].name DOOR\nvar[0].type BOOL\n"
    configuration = variables_configuration(
        load_list(VARIABLES, "v.lis", text.encode(), collector), collector
    )
    (found,) = collector.diagnostics
    assert found.remedy().startswith("Did you mean BOOLEAN? Use one of BOOLEAN, SGN08")
    (ignored,) = configuration.ignored
    assert (ignored.name, ignored.declared.line, ignored.reason.line) == ("DOOR", 2, 3)
    assert (ignored.space, ignored.what.en) == (VariableSpace.EXTERNAL, "type")


@pytest.mark.parametrize("space", ["V.CH", "V.E"])
def test_a_program_hears_why_its_variable_is_not_there(tmp_path: Path, space: str) -> None:
    """20196 of a variable that the list declares in vain says where, and why it is ignored."""
    entry = "vch[9]" if space == "V.CH" else "var[9]"
    machine = machine_with(tmp_path / "machine")
    (machine / "ext_var1.lis").write_text(
        f"number_used_variables 10\n{entry}.name DOOR\n{entry}.type BOOL\n", "utf-8"
    )
    run = Controller(machine).run(NcText("p.nc", f"{space}.DOOR = 1\nM30"))
    (error,) = [one for one in run.diagnostics if one.id == 20196]
    reported = "It is declared in ext_var1.lis:2, and ignored because of its type (line 3)."
    assert reported in error.remedy()
    reported = "Sie ist in ext_var1.lis:2 deklariert und wird wegen ihres Typs (Zeile 3) ignoriert."
    assert reported in error.remedy("de")
