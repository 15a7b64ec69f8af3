# SPDX-License-Identifier: MIT
"""Structures and arrays assigned as wholes between V.E and V.CH (RC-310, manual 3.3.2)."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.variable_programs import Machine, demo, errors, machine

from nctakt.run.controller import NcText

TREE = """
struct[0].name TREE
struct[0].element[0].name NUMBER
struct[0].element[0].type SGN16
struct[0].element[1].name FROZEN
struct[0].element[1].type REAL64
struct[0].element[1].synchronisation FALSE
struct[0].element[2].name TEXT
struct[0].element[2].type STRING
struct[0].element[3].name LEAVES
struct[0].element[3].type LEAF
struct[0].element[3].array_elements 2
struct[1].name LEAF
struct[1].element[0].name LIST
struct[1].element[0].type UNS08
struct[1].element[0].array_elements 3
struct[2].name SHUT
struct[2].element[0].name NUMBER
struct[2].element[0].type SGN16
struct[2].element[1].name SECRET
struct[2].element[1].type SGN16
struct[2].element[1].access_rights WRITE_ONLY
struct[2].element[2].name FIXED
struct[2].element[2].type SGN16
struct[2].element[2].access_rights READ_ONLY
number_used_variables 7
var[0].name TREE
var[0].type TREE
var[1].name FOREST
var[1].type TREE
var[1].array_elements 3
var[2].name LIST
var[2].type REAL64
var[2].array_elements 4
var[3].name OTHER
var[3].type SGN32
var[3].array_elements 4
var[4].name LONGER
var[4].type REAL64
var[4].array_elements 5
var[5].name LATER
var[5].type TREE
var[5].synchronisation FALSE
var[6].name SHUT
var[6].type SHUT
vch[0].name Tree
vch[0].type TREE
vch[1].name Forest
vch[1].type TREE
vch[1].array_elements 3
vch[2].name List
vch[2].type REAL64
vch[2].array_elements 4
vch[3].name Shut
vch[3].type SHUT
vch[4].name Later
vch[4].type TREE
vch[4].synchronisation FALSE
vch[5].name Alike
vch[5].type ALIKE
struct[3].name ALIKE
struct[3].element[0].name NUMBER
struct[3].element[0].type SGN16
"""
MEMBERS = ("NUMBER", "FROZEN", "TEXT", "LEAVES[0].LIST[0]", "LEAVES[1].LIST[2]")
VALUES = (-7, 2.5, "oak", 1, 200)
FILL = "".join(
    f"{{name}}.{member} = {value!r}\n".replace("'", '"')
    for member, value in zip(MEMBERS, VALUES, strict=True)
)


@pytest.fixture
def trees(tmp_path: Path) -> Machine:
    """A machine with the variables above."""
    return machine(tmp_path, TREE)


def members(m: Machine, name: str) -> tuple[object, ...]:
    """What the members of a tree hold."""
    return tuple(m.value(f"{name}.{member}") for member in MEMBERS)


PAIRS = [
    ("V.CH.Tree", "V.E.TREE"),
    ("V.E.TREE", "V.CH.Tree"),
    ("V.E.FOREST[2]", "V.CH.Forest[1]"),
    ("V.CH.Later", "V.E.TREE"),
    ("V.E.TREE", "V.E.LATER"),
    ("Vs.E.LATER", "V.CH.Later"),
    ("V.CH.Forest[0]", "Vs.CH.Later"),
]


@pytest.mark.parametrize(("target", "source"), PAIRS)
def test_structures_of_one_type_are_copied(trees: Machine, target: str, source: str) -> None:
    """RC-310: all members, texts and nested arrays among them, synchronous or not."""
    plain_target, plain_source = target.replace("Vs.", "V."), source.replace("Vs.", "V.")
    run = trees.run(FILL.format(name=plain_source) + f"{target} = {source}\nM30")
    assert errors(run) == []
    assert members(trees, plain_target) == members(trees, plain_source) == VALUES


def test_whole_arrays_are_copied(trees: Machine) -> None:
    """RC-310: arrays of numbers and of structures with as many elements."""
    run = trees.run(
        "$FOR P1 = 0, 3, 1\nV.E.LIST[P1] = P1 * P1\n$ENDFOR\nV.CH.List = V.E.LIST\n"
        + FILL.format(name="V.E.FOREST[1]")
        + "V.CH.Forest = V.E.FOREST\nM30"
    )
    assert errors(run) == []
    assert [trees.value(f"V.CH.List[{i}]") for i in range(4)] == [0, 1, 4, 9]
    assert members(trees, "V.CH.Forest[1]") == VALUES
    assert members(trees, "V.CH.Forest[0]") == (0, 0, "", 0, 0)


def test_members_that_are_wholes_are_copied(trees: Machine) -> None:
    """A structure or array inside a structure, with computed indices on both sides."""
    run = trees.run(
        FILL.format(name="V.E.FOREST[2]")
        + "P1 = 1\nV.CH.Forest[P1].LEAVES[0] = V.E.FOREST[P1 + 1].LEAVES[P1]\n"
        "V.E.TREE.LEAVES[V.CH.Forest[0].NUMBER].LIST = V.CH.Forest[1].LEAVES[0].LIST\nM30"
    )
    assert errors(run) == []
    assert trees.value("V.CH.Forest[1].LEAVES[0].LIST[2]") == 200
    assert trees.value("V.E.TREE.LEAVES[0].LIST[2]") == 200


def test_a_whole_may_be_given_to_itself(trees: Machine) -> None:
    """Nothing changes."""
    run = trees.run(FILL.format(name="V.E.TREE") + "V.E.TREE = V.E.TREE\nM30")
    assert errors(run) == []
    assert members(trees, "V.E.TREE") == VALUES


def test_reading_a_synchronous_whole_empties_the_channel_once(trees: Machine) -> None:
    """RC-308: one tick for all members; a wholly asynchronous one takes nothing."""
    ticks = [
        trees.run(f"{line}\nM30").ticks
        for line in ("P1 = 1", "V.E.TREE = V.CH.Later", "V.CH.Later = V.E.TREE")
    ]
    # Tree has an asynchronous member only beside synchronous ones; Later has none of those
    assert ticks == [ticks[0], ticks[0], ticks[0] + 1]


def test_synchronous_members_come_through_the_queue(tmp_path: Path) -> None:
    """RC-308: each member by its own synchronisation: the frozen one at once, others in order."""
    m = machine(tmp_path, TREE)
    m.run(FILL.format(name="V.CH.Later") + "M30")
    program = "G01 X1 F600\nV.E.TREE = V.CH.Later\nG01 X2\nM30"
    m.controller.start(NcText("p.nc", program))
    m.controller.step(20)
    assert members(m, "V.E.TREE") == (0, 2.5, "", 0, 0)
    m.controller.step(150)
    assert members(m, "V.E.TREE") == VALUES


@pytest.mark.parametrize(
    ("line", "number", "words"),
    [
        ("V.E.TREE = V.E.SHUT", 21443, "V.E.SHUT is not of the type of V.E.TREE"),
        ("V.CH.Alike = V.E.TREE", 21443, ""),
        ("V.E.LIST = V.E.OTHER", 21443, ""),
        ("V.E.LIST = V.E.LONGER", 21443, ""),
        ("V.E.FOREST = V.E.TREE", 21443, ""),
        ("V.E.TREE = V.E.FOREST", 21443, ""),
        ("V.E.TREE = 5", 900215, "V.E.TREE"),
        ('V.E.TREE = "a"', 900215, "V.E.TREE"),
        ("V.E.LIST[0] = V.E.LIST", 21216, "V.E.LIST"),
        ("P1 = V.E.TREE", 900215, "V.E.TREE"),
        ("V.E.TREE += V.CH.Tree", 900215, "V.E.TREE"),
        ("V.E.FOREST[3] = V.E.TREE", 21928, ""),
        ("V.E.TREE = V.E.FOREST[-1]", 21928, ""),
        ("V.CH.Shut = V.E.SHUT", 20100, "V.CH.Shut.FIXED"),
        ("V.E.TREE = V.E.NOTHING", 20196, "V.E.NOTHING"),
        ("V.E.NOTHING = V.E.TREE", 20196, "V.E.NOTHING"),
        ("V.E.TREE = V.E.LATER + V.E.LATER", 900215, ""),
        ("V.E.LATER = Vs.E.LATER", 900228, "V.E.LATER"),
    ],
)
def test_what_cannot_be_copied_is_reported(
    trees: Machine, line: str, number: int, words: str
) -> None:
    """Before the run: another type, rights, elements that are not there, single values."""
    run = trees.run(f"{line}\nM30")
    assert number in errors(run), errors(run)
    found = next(one for one in run.diagnostics if one.id == number)
    assert words in found.text("en")
    assert run.ticks == 0


def test_members_without_the_right_are_reported(tmp_path: Path) -> None:
    """RC-303: WRITE_ONLY members cannot be read (20097), READ_ONLY ones not written (20100)."""
    shut = TREE.replace("struct[2].element[2].access_rights READ_ONLY", "")
    run = machine(tmp_path, shut).run("V.CH.Shut = V.E.SHUT\nM30")
    assert errors(run) == [20097]
    assert "V.E.SHUT.SECRET" in run.diagnostics[0].text("en")


def test_an_element_outside_at_run_time_is_reported(trees: Machine) -> None:
    """RC-307: a computed index; nothing is copied."""
    run = trees.run("P1 = 3\nV.E.TREE = V.E.FOREST[P1]\nM30")
    assert errors(run) == [21928]


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("V.CH.Tree = V.E.TREE", 22009),  # its member FROZEN is asynchronous
        ("V.E.FOREST[1] = V.CH.Tree", 22009),
        ("V.E.LIST = V.E.LONGER", 21443),
        ("V.E.LIST = [1, 2, 3, 4]", 22001),
        ("V.E.TREE = [1, 2]", 22001),
        ("V.E.TREE.NUMBER = V.E.TREE", 900215),
    ],
)
def test_what_cycles_do_not_copy(trees: Machine, line: str, number: int) -> None:
    """RC-208, RC-301: another type, asynchronous members, lists of values, single values."""
    run = trees.run(f"#RT CYCLE [SCOPE=PROG]\n{line}\n#RT CYCLE END\nM30")
    assert number in errors(run)
    assert run.ticks == 0


def test_the_manuals_line_suggests_the_member_of_that_name() -> None:
    """Manual 3.4: the printed line is refused, and repaired as suggested it runs."""
    broken = "#RT CYCLE [SCOPE=PROG]\nV.E.LEVEL_1_A[0].REAL64 = {}\n#RT CYCLE END\nM30"
    run = demo().run(broken.format("V.E.LEVEL_1_A[0]"))
    assert errors(run) == [900215]
    assert "V.E.LEVEL_1_A[0].REAL64" in run.diagnostics[0].remedy("en")
    m = demo()
    run = m.run(broken.format("V.E.LEVEL_1_A[0].REAL64"), initial={"V.E.LEVEL_1_A[0].REAL64": 2.5})
    assert errors(run) == []
    assert m.value("V.E.LEVEL_1_A[0].REAL64") == 2.5
