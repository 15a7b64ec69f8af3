# SPDX-License-Identifier: MIT
"""Texts and structures in realtime cycles: compared, assigned, copied in the tick (RC-208)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest
from support.variable_machines import machine_with
from support.variable_programs import Machine, errors

from nctakt.checking.program import check_program
from nctakt.checking.program_pass import ProgramChannel
from nctakt.files.access import FileAccess
from nctakt.messages import Collector
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.variables.variable_table import ChannelNames, Layout
from nctakt.results.instruction_tree import list_cycle
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

LISTS = """
struct[0].name CELL
struct[0].element[0].name NUMBER
struct[0].element[0].type SGN16
struct[0].element[1].name NAMES
struct[0].element[1].type STRING
struct[0].element[1].array_elements 2
struct[1].name MIXED
struct[1].element[0].name LIVE
struct[1].element[0].type REAL64
struct[1].element[1].name LATER
struct[1].element[1].type REAL64
struct[1].element[1].synchronisation FALSE
struct[1].element[2].name TEXT
struct[1].element[2].type STRING
struct[1].element[2].synchronisation FALSE
number_used_variables 12
var[0].name A
var[0].type STRING
var[1].name B
var[1].type STRING
var[2].name LATER
var[2].type STRING
var[2].synchronisation FALSE
var[3].name LIST
var[3].type VSTRING
var[3].size 16
var[3].array_elements 3
var[4].name LONG
var[4].type VSTRING
var[4].size 40
var[5].name I
var[5].type SGN32
var[6].name HIT
var[6].type SGN32
var[7].name CELL
var[7].type CELL
var[7].array_elements 3
var[8].name NUMBERS
var[8].type REAL64
var[8].array_elements 4
var[9].name MIXED
var[9].type MIXED
var[9].array_elements 2
var[10].name FLAG
var[10].type BOOLEAN
var[11].name THEN
var[11].type CELL
var[11].synchronisation FALSE
vch[0].name Cell
vch[0].type CELL
vch[1].name Numbers
vch[1].type REAL64
vch[1].array_elements 4
vch[2].name Own
vch[2].type STRING
"""


class Lists(Machine):
    """A machine with the variables above, with a new controller for each run."""

    def __init__(self, tmp_path: Path) -> None:
        self.configuration = machine_with(tmp_path, LISTS, 8)
        super().__init__(Controller(self.configuration))


@pytest.fixture
def lists(tmp_path: Path) -> Lists:
    """A machine with the variables above."""
    return Lists(tmp_path)


def text_of(body: str, before: str = "") -> NcText:
    """A program with a cycle of this body, which runs for six ticks."""
    cycle_text = f"#RT CYCLE [ID=1 SCOPE=PROG]\n{body}\n#RT CYCLE END"
    return NcText("p.nc", f"{before}\n{cycle_text}\n#TIME 0.006\nM30")


def cycle(
    lists: Lists,
    body: str,
    before: str = "",
    initial: Mapping[str, float | str] | None = None,
    at: Sequence[Stimulus] = (),
) -> Run:
    """A run of such a program on a new controller, as which it stays in ``lists``."""
    lists.controller = Controller(lists.configuration)
    return lists.controller.run(text_of(body, before), set=initial or {}, at=at)


def written(run: Run) -> list[str]:
    """What the cycle has written, each with its tick."""
    return [f"{one.tick} {one.text}" for one in run.events if one.kind == "written" and one.cycle]


# --- comparison -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("condition", "ticks"),
    [
        ('V.E.A == "go"', [2, 3]),
        ('"go" == V.E.A', [2, 3]),
        ('V.E.A != "go"', [0, 1, 4, 5]),
        ('V.E.A == ""', [0, 1]),
        ('V.E.A == "gone"', [4, 5]),
        ('V.E.A == "g"', []),
        ("V.E.A == V.E.LONG", [0, 1, 4, 5]),  # of another length: only characters count
        ("V.E.A != V.E.LONG", [2, 3]),
        ('V.E.A == "go" || V.E.A == "gone"', [2, 3, 4, 5]),
        ('V.E.A == "go" && V.E.I == 0', [2, 3]),
        ('NOT [V.E.A == "go"]', [0, 1, 4, 5]),
        ('[V.E.A == "go"] + 1 > 1.5', [2, 3]),
        ('"a" == "a"', [0, 1, 2, 3, 4, 5]),
        ('V.E.LIST[V.E.I + 1] == "x"', [0, 1, 2, 3, 4, 5]),
        ('V.E.A == "a text that is longer than any string of that type can be"', []),
    ],
)
def test_texts_are_compared_in_each_tick(lists: Lists, condition: str, ticks: list[int]) -> None:
    """Up to the first zero byte; in an ``$IF``, combined, and as a value."""
    at = [
        Stimulus("2 ms", "V.E.A", "go"),
        Stimulus("4 ms", "V.E.A", "gone"),
        Stimulus("4 ms", "V.E.LONG", "gone"),
    ]
    body = f"$IF {condition}\nV.E.HIT += 1\n$ENDIF"
    run = cycle(lists, body, initial={"V.E.LIST[1]": "x"}, at=at)
    assert errors(run) == []
    assert [int(line.split()[0]) for line in written(run)] == ticks


def test_a_comparison_is_a_number(lists: Lists) -> None:
    """1 or 0, as with numbers."""
    at = [Stimulus("2 ms", "V.E.A", "go")]
    run = cycle(lists, 'V.E.FLAG = V.E.A == "go"\nV.E.HIT = 2 * [V.E.A != "go"]', at=at)
    assert errors(run) == []
    assert written(run) == ["0 V.E.HIT 2", "2 V.E.FLAG 1", "2 V.E.HIT 0"]


def test_what_the_plc_leaves_after_the_zero_does_not_count(lists: Lists) -> None:
    """The bytes after the first zero are no part of the text."""
    with lists.controller.interface_image() as image:
        image.external[:10] = b"go\0rubbish"
        run = lists.controller.run(text_of('$IF V.E.A == "go"\nV.E.B = V.E.A\n$ENDIF'))
    assert errors(run) == []
    assert written(run) == ['0 V.E.B "go"']


# --- assignment -------------------------------------------------------------------------------


def test_texts_are_assigned_and_reported(lists: Lists) -> None:
    """A constant and a string of the same length; only a new text is an event.

    Tick 0: A is "one" and B takes it over. Tick 3: the outside writes A, so the cycle writes again.
    """
    at = [Stimulus("3 ms", "V.E.A", "other")]
    run = cycle(lists, 'V.E.B = V.E.A\nV.E.A = "Größe"\nV.CH.Own = V.E.A', at=at)
    assert errors(run) == []
    assert written(run) == [
        '0 V.E.A "Größe"',
        '0 V.CH.Own "Größe"',
        '1 V.E.B "Größe"',
        '3 V.E.B "other"',
        '3 V.E.A "Größe"',
        '4 V.E.B "Größe"',
    ]
    assert lists.value("V.CH.Own") == "Größe"


def test_a_long_text_is_reported_in_parts(lists: Lists) -> None:
    """Twelve characters each, none of them lost; a shorter one leaves nothing of the longer."""
    body = '$IF ONCE V.E.I == 0\nV.E.LONG = "abcdefghijklmnopqrstuvwxyz"\n$ENDIF\n'
    run = cycle(lists, f'{body}$IF ONCE V.E.I == 1\nV.E.LONG = "z"\n$ENDIF\nV.E.I = 1')
    assert errors(run) == []
    assert written(run)[:3] == [
        '0 V.E.LONG "abcdefghijkl…"',
        '0 V.E.LONG "…mnopqrstuvwx…"',
        '0 V.E.LONG "…yz"',
    ]
    assert written(run)[4:] == ['1 V.E.LONG "z"']
    assert lists.value("V.E.LONG") == "z"
    run = cycle(lists, 'V.E.LONG = ""', initial={"V.E.LONG": "z"})
    assert written(run) == ['0 V.E.LONG ""']


def test_elements_are_found_in_the_tick(lists: Lists) -> None:
    """A computed index on both sides; outside of the array it is a fault, and nothing is stored."""
    body = "$IF V.E.I < 2\nV.E.LIST[V.E.I + 1] = V.E.LIST[V.E.I]\n$ENDIF\nV.E.I += 1"
    run = cycle(lists, body, initial={"V.E.LIST[0]": "first"})
    assert errors(run) == []
    assert [line for line in written(run) if "LIST" in line] == [
        '0 V.E.LIST[1] "first"',
        '1 V.E.LIST[2] "first"',
    ]
    run = cycle(lists, 'V.E.LIST[V.E.I] = "late"', initial={"V.E.I": 3})
    assert errors(run) == [50895]
    run = cycle(lists, '$IF V.E.LIST[V.E.I] == ""\nV.E.HIT = 1\n$ENDIF', initial={"V.E.I": -1})
    assert errors(run) == [50895]
    assert written(run) == []


def test_asynchronous_texts_are_those_of_the_definition(lists: Lists) -> None:
    """RC-302: V.P, V.L, V.S and V.CYC, and V.E without synchronisation; reported as frozen."""
    before = 'V.P.NAME = "go"\nV.S.NAME = "b"\nV.E.LATER = "later"'
    body = "$IF ONCE V.E.A == V.P.NAME\nV.E.A = V.S.NAME\nV.E.B = V.E.LATER\n$ENDIF"
    at = [Stimulus("2 ms", "V.E.LATER", "new"), Stimulus("3 ms", "V.E.A", "go")]
    run = cycle(lists, body, before, at=at)
    assert errors(run) == []
    assert written(run) == ['3 V.E.A "b"', '3 V.E.B "later"']
    (found,) = run.cycles
    assert [(one.name, one.value) for one in found.frozen] == [
        ("V.P.NAME", "go"),
        ("V.S.NAME", "b"),
        ("V.E.LATER", "later"),
    ]
    frozen = [one.text for one in run.events if one.kind == "frozen"]
    assert frozen == ['V.P.NAME "go"', 'V.S.NAME "b"', 'V.E.LATER "later"']


def test_vs_reads_and_writes_an_asynchronous_text_in_the_tick(lists: Lists) -> None:
    """RC-301: ``Vs.`` for its line."""
    at = [Stimulus("2 ms", "V.E.LATER", "new")]
    body = '$IF Vs.E.LATER == "new"\nVs.E.LATER = "seen"\n$ENDIF'
    run = cycle(lists, body, at=at)
    assert errors(run) == []
    assert written(run) == ['2 V.E.LATER "seen"']


@pytest.mark.parametrize(
    ("body", "number"),
    [
        ('V.E.LATER = "a"', 22009),
        ("V.P.TEXT = V.E.A", 22009),
        ("V.E.A = V.E.LONG", 901079),
        ("V.E.LONG = V.E.A", 901079),
        ('V.E.LIST[0] = "more than fifteen characters"', 21462),
        ("V.E.A = V.E.I", 21460),
        ("V.E.A = 1", 21460),
        ("$IF V.E.A == 1\n$ENDIF", 21460),
        ("$IF V.E.I == V.E.A\n$ENDIF", 21460),
        ('V.E.A = "→"', 900344),
        ("V.E.CELL[0] = V.E.A", 900215),
    ],
)
def test_mistakes_are_reported_before_the_run(lists: Lists, body: str, number: int) -> None:
    """Lengths, types, rights: each with its number and place."""
    run = cycle(lists, body)
    assert number in errors(run), errors(run)
    assert run.ticks == 0
    assert run.diagnostics[0].span is not None


@pytest.mark.parametrize(
    ("body", "number"),
    [
        ("V.E.LIST[0] = V.P.TEXT", 21462),
        ("V.E.A = V.P.NUMBER", 21460),
        ("V.E.I = V.P.TEXT", 21461),
        ("$IF V.E.A == V.P.NUMBER\n$ENDIF", 21460),
        ("$IF V.E.I == V.P.TEXT\n$ENDIF", 21460),
    ],
)
def test_variables_of_the_program_are_known_at_the_definition(
    lists: Lists, body: str, number: int
) -> None:
    """What V.P holds shows when the cycle is defined."""
    run = cycle(lists, body, 'V.P.TEXT = "a text of more than fifteen"\nV.P.NUMBER = 5')
    assert errors(run) == [number]


# --- structures and arrays --------------------------------------------------------------------


def test_a_structure_is_copied_member_by_member(lists: Lists) -> None:
    """The order is that of the declaration; what is the same is no event."""
    initial = {
        "V.E.CELL[1].NUMBER": 7,
        "V.E.CELL[1].NAMES[1]": "second",
        "V.CH.Cell.NAMES[0]": "old",
    }
    run = cycle(lists, "V.CH.Cell = V.E.CELL[V.E.I + 1]", initial=initial)
    assert errors(run) == []
    assert written(run) == [
        "0 V.CH.Cell.NUMBER 7",
        '0 V.CH.Cell.NAMES[0] ""',
        '0 V.CH.Cell.NAMES[1] "second"',
    ]


def test_an_array_is_copied(lists: Lists) -> None:
    """Element by element; V.CH and V.E of one type (manual 3.3.2)."""
    initial = {"V.E.NUMBERS[0]": 1.5, "V.E.NUMBERS[3]": -2}
    run = cycle(lists, "V.CH.Numbers = V.E.NUMBERS", initial=initial)
    assert written(run) == ["0 V.CH.Numbers[0] 1.5", "0 V.CH.Numbers[3] -2"]


def test_both_indices_count_from_before_the_copy(lists: Lists) -> None:
    """An index inside the target does not change in the midst of its own copy."""
    initial = {"V.E.CELL[0].NUMBER": 0, "V.E.CELL[1].NUMBER": 2, "V.E.CELL[1].NAMES[0]": "x"}
    run = cycle(
        lists, "$IF ONCE 1\nV.E.CELL[V.E.CELL[0].NUMBER] = V.E.CELL[1]\n$ENDIF", initial=initial
    )
    assert errors(run) == []
    assert written(run) == ["0 V.E.CELL[0].NUMBER 2", '0 V.E.CELL[0].NAMES[0] "x"']


def test_asynchronous_members_are_those_of_the_definition(lists: Lists) -> None:
    """RC-302: each member by its own list; the target needs ``Vs.``, for it has such members."""
    initial = {"V.E.MIXED[1].LATER": 3, "V.E.MIXED[1].TEXT": "then"}
    at = [
        Stimulus("2 ms", "V.E.MIXED[1].LIVE", 4),
        Stimulus("2 ms", "V.E.MIXED[1].LATER", 5),
        Stimulus("2 ms", "V.E.MIXED[1].TEXT", "now"),
    ]
    run = cycle(lists, "Vs.E.MIXED[0] = V.E.MIXED[1]", initial=initial, at=at)
    assert 900228 in errors(run)  # with and without Vs. in one line
    run = cycle(lists, "V.E.MIXED[0] = V.E.MIXED[1]", initial=initial)
    assert errors(run) == [22009]
    run = cycle(lists, "Vs.E.MIXED[0] = Vs.E.MIXED[1]", initial=initial, at=at)
    assert errors(run) == []
    assert written(run) == [
        "0 V.E.MIXED[0].LATER 3",
        '0 V.E.MIXED[0].TEXT "then"',
        "2 V.E.MIXED[0].LIVE 4",
        "2 V.E.MIXED[0].LATER 5",
        '2 V.E.MIXED[0].TEXT "now"',
    ]


def test_members_of_the_definition_are_reported_as_frozen(lists: Lists) -> None:
    """RC-302: each member of a copy with its name and value; those of ``Vs.`` are none."""
    initial = {"V.E.THEN.NUMBER": 3, "V.E.THEN.NAMES[1]": "then"}
    run = cycle(lists, "V.E.CELL[0] = V.E.THEN", initial=initial)
    assert errors(run) == []
    (found,) = run.cycles
    assert [(one.name, one.value) for one in found.frozen] == [
        ("V.E.THEN.NUMBER", 3.0),
        ("V.E.THEN.NAMES[0]", ""),
        ("V.E.THEN.NAMES[1]", "then"),
    ]
    frozen = [one.text for one in run.events if one.kind == "frozen"]
    assert frozen == ["V.E.THEN.NUMBER 3", 'V.E.THEN.NAMES[0] ""', 'V.E.THEN.NAMES[1] "then"']
    run = cycle(lists, "Vs.E.CELL[0] = Vs.E.THEN", initial=initial)
    assert run.cycles[0].frozen == ()
    (channel,) = lists.configuration.channels
    declared = ChannelNames((), frozenset(), channel.external_variables, channel.channel_variables)
    (names,) = Layout([declared], 0).tables
    limits, collector = StepLimits(201, 200), Collector()
    source = Source("p.nc", tuple(text_of("V.E.CELL[0] = V.E.THEN").text.splitlines()))
    checked = ProgramChannel(names, channel.parameters, limits)
    check_program(source, checked, collector, access=FileAccess())
    notes = [one for one in collector.diagnostics if one.message.id == 900236]
    assert [one.values["name"] for one in notes] == [
        "V.E.THEN.NUMBER",
        "V.E.THEN.NAMES[0]",
        "V.E.THEN.NAMES[1]",
    ]


def test_an_index_outside_copies_nothing(lists: Lists) -> None:
    """RC-307."""
    run = cycle(lists, "V.E.CELL[0] = V.E.CELL[V.E.I]", initial={"V.E.I": 3, "V.E.HIT": 1})
    assert errors(run) == [50895]
    assert written(run) == []


# --- bounds -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("body", "steps"),
    [
        ('V.E.A = "x"', 3),  # 24 bytes of the target
        ("V.E.A = V.E.B", 6),
        ('V.E.HIT = V.E.A == "x"', 5),  # store, compare, three times eight bytes
        ("V.E.LIST[V.E.I] = V.E.LIST[0]", 5),
        ("V.CH.Cell = V.E.CELL[0]", 14),  # a number and two strings of 24 bytes, twice
        ("V.CH.Cell = V.E.CELL[V.E.I]", 15),
        ("V.CH.Cell = V.E.THEN", 14),
        ("V.CH.Numbers = V.E.NUMBERS", 8),
    ],
)
def test_instructions_are_counted(lists: Lists, body: str, steps: int) -> None:
    """RC-501: eight bytes of a string are an access, a structure counts as its members."""
    lists.controller.start(text_of(body))
    lists.controller.step()
    assert lists.controller.instructions_in_tick == steps
    found: list[int] = []
    Controller(lists.configuration).run(
        text_of(body), on_cycle=lambda _, one: found.append(list_cycle(one).max_count)
    )
    assert found == [steps]
