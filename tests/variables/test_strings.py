# SPDX-License-Identifier: MIT
"""STRING and VSTRING of V.E and V.CH: programs, API, limits (P-EXTV-00003, 00008, 00022)."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from support.variable_programs import Machine, demo, errors, machine, messages

from nctakt.base.failure import Failure
from nctakt.run.access.stimuli import Stimulus, parse_assignment
from nctakt.run.controller import Controller, NcText

TEXTS = """
number_used_variables 6
var[0].name SYNC
var[0].type STRING
var[1].name FROZEN
var[1].type STRING
var[1].synchronisation FALSE
var[2].name SHORT
var[2].type VSTRING
var[2].size 4
var[3].name LONG
var[3].type VSTRING
var[3].size 800
var[4].name LIST
var[4].type VSTRING
var[4].size 10
var[4].array_elements 3
var[5].name CELL
var[5].type CELL
var[5].array_elements 2
struct[0].name CELL
struct[0].element[0].name NUMBER
struct[0].element[0].type REAL64
struct[0].element[1].name LABELS
struct[0].element[1].type STRING
struct[0].element[1].array_elements 2
vch[0].name OWN
vch[0].type STRING
vch[1].name LATER
vch[1].type STRING
vch[1].synchronisation FALSE
"""


@pytest.fixture
def texts(tmp_path: Path) -> Machine:
    """A machine with the texts above."""
    return machine(tmp_path, TEXTS)


# --- values -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["SYNC", "FROZEN", "LONG", "LIST[2]", "CELL[1].LABELS[1]"])
def test_a_text_is_assigned(texts: Machine, name: str) -> None:
    """A literal, and another variable's text; at once or through the queue (RC-308)."""
    run = texts.run(f'V.E.{name} = "Größe"\nV.CH.OWN = V.E.{name}\nV.CH.LATER = V.CH.OWN\nM30')
    assert errors(run) == []
    for read in (f"V.E.{name}", "V.CH.OWN", "V.CH.LATER"):
        assert texts.value(read) == "Größe"


def test_neighbours_keep_their_texts(texts: Machine) -> None:
    """Each element has its own characters, whatever the length of the others."""
    run = texts.run(
        "$FOR P1 = 0, 2, 1\n"
        'V.E.LIST[P1] = "123456789"\n'
        "$ENDFOR\n"
        'V.E.LIST[1] = ""\n'
        'V.E.CELL[1].LABELS[0] = "x"\nV.E.CELL[1].NUMBER = 7\nM30'
    )
    assert errors(run) == []
    assert [texts.value(f"V.E.LIST[{i}]") for i in range(3)] == ["123456789", "", "123456789"]
    assert texts.value("V.E.CELL[1].LABELS[0]") == "x"
    assert texts.value("V.E.CELL[1].LABELS[1]") == ""
    assert texts.value("V.E.CELL[0].LABELS[1]") == ""
    assert texts.value("V.E.CELL[1].NUMBER") == 7


def test_an_index_may_be_computed_from_live_values(texts: Machine) -> None:
    """``LIST[P1 + V.E.CELL[0].NUMBER]``: read first, then the text is written (RC-308)."""
    run = texts.run(
        'V.E.CELL[0].NUMBER = 1\nP1 = 1\nV.E.LIST[P1 + V.E.CELL[0].NUMBER] = "here"\n'
        "V.E.LIST[0] = V.E.LIST[V.E.CELL[0].NUMBER * 2]\nM30"
    )
    assert errors(run) == []
    assert texts.value("V.E.LIST[2]") == texts.value("V.E.LIST[0]") == "here"
    run = texts.run('P1 = 3\nV.E.LIST[P1] = "x"\nM30')
    assert errors(run) == [21928]


def test_texts_are_joined(texts: Machine) -> None:
    """``+`` and ``+=``, as many as fit."""
    run = texts.run(
        'V.E.SYNC = "a" + "b"\nV.E.FROZEN = V.E.SYNC + "-" + V.E.SYNC\nV.E.FROZEN += "!"\n'
        "V.E.LONG = V.E.FROZEN + V.E.FROZEN\nM30"
    )
    assert errors(run) == []
    assert texts.value("V.E.LONG") == "ab-ab!ab-ab!"


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ('V.E.SYNC == "part"', True),
        ('"part" == V.E.SYNC', True),
        ('V.E.SYNC != "part"', False),
        ('V.E.SYNC == "Part"', False),
        ('V.E.SYNC == ""', False),
        ('V.E.FROZEN == ""', True),
        ('V.E.SYNC == V.E.FROZEN + "part"', True),
        ('V.E.SYNC + "s" == "parts" && V.E.CELL[0].NUMBER == 0', True),
        ('NOT [V.E.SYNC == "part"] || 1 > 2', False),
        ('[V.E.SYNC == "part"] + 1 == 2', True),
    ],
)
def test_texts_are_compared(texts: Machine, condition: str, holds: bool) -> None:
    """``==`` and ``!=``, character by character; the result is a truth value like any other."""
    run = texts.run(f'V.E.SYNC = "part"\n$IF {condition}\n#MSG ["yes"]\n$ENDIF\nM30')
    assert errors(run) == []
    assert messages(run) == (["yes"] if holds else [])


def test_texts_decide_loops_and_show_in_messages(texts: Machine) -> None:
    """``$WHILE`` with a text; ``%s`` with and without a width."""
    run = texts.run(
        '$WHILE V.E.FROZEN != "xxx"\nV.E.FROZEN += "x"\n$ENDWHILE\n'
        '#MSG ["[%s][%5s][%-5s] %d", V.E.FROZEN, V.E.FROZEN, "a" + V.E.FROZEN, 4]\nM30'
    )
    assert errors(run) == []
    assert messages(run) == ["[xxx][  xxx][axxx ] 4"]


def test_a_bare_text_variable_is_read_and_dropped(texts: Machine) -> None:
    """RC-311, RC-308: a synchronous one empties the channel, one tick; the other takes nothing."""
    ticks = [texts.run(f"{line}\nM30").ticks for line in ("V.E.FROZEN", "V.E.SYNC", "Vs.E.FROZEN")]
    assert ticks == [ticks[0], ticks[0] + 1, ticks[0] + 1]


def test_a_synchronous_text_is_written_in_its_tick() -> None:
    """RC-308: after the motion before it (with exact stop), before the one after it."""
    m = demo()
    m.controller.write("V.E.TEXT", "before")
    m.controller.step(1)
    m.controller.start(NcText("p.nc", 'G60 G01 X1 F600\nV.E.TEXT = "after"\nG01 X2\nM30'))
    seen = []
    for _ in range(150):
        m.controller.step(1)
        seen.append((m.value("V.E.TEXT"), float(m.value("V.RTA.ACS.ACT_POS.X"))))
    assert max(x for text, x in seen if text == "before") == 1.0
    assert 1.0 < min(x for text, x in seen if text == "after") < 1.1


def test_texts_live_on_between_programs(texts: Machine) -> None:
    """As numbers do; a controller begins with empty ones (RC-309)."""
    assert texts.value("V.CH.OWN") == ""
    texts.run('V.CH.OWN = "kept"\nM30')
    assert messages(texts.run('#MSG ["%s", V.CH.OWN]\nM30')) == ["kept"]


# --- limits -----------------------------------------------------------------------------------

LIMITS = [("SYNC", 20), ("FROZEN", 20), ("SHORT", 3), ("LONG", 799), ("LIST[0]", 9)]


@pytest.mark.parametrize(("name", "limit"), LIMITS)
def test_texts_have_their_variables_length(texts: Machine, name: str, limit: int) -> None:
    """STRING 20 characters, VSTRING one less than its bytes: one more is 21462, nothing stored."""
    assert errors(texts.run(f'V.E.{name} = "{"x" * (limit - 1)}"\nM30')) == []
    assert errors(texts.run(f'V.E.{name} = "{"y" * limit}"\nM30')) == []
    run = texts.run(f'V.E.{name} = "{"z" * (limit + 1)}"\nM30')
    assert errors(run) == [21462]
    assert f"can hold {limit} characters; the text has {limit + 1}" in run.diagnostics[0].text("en")
    assert texts.value(f"V.E.{name}") == "y" * limit
    run = texts.run(f'V.E.{name} += "z"\nM30')
    assert errors(run) == [21462]
    assert run.diagnostics[0].span is not None
    assert texts.value(f"V.E.{name}") == "y" * limit


def test_extended_strings_have_127_characters() -> None:
    """P-EXTV-00022 = 1, as on the demo machine."""
    m = demo()
    assert errors(m.run(f'V.E.TEXT = "{"x" * 127}"\nM30')) == []
    assert m.value("V.E.TEXT") == "x" * 127
    assert errors(m.run(f'V.E.TEXT = "{"x" * 128}"\nM30')) == [21462]


@pytest.mark.parametrize("character", ["→", "ł", "\x80"])
def test_a_text_has_characters_of_windows_1252(texts: Machine, character: str) -> None:
    """Others are 900344 with the character's number."""
    run = texts.run(f'V.E.SYNC = "a{character}"\nM30')
    assert errors(run) == [900344]
    assert f"U+{ord(character):04X}" in run.diagnostics[0].text("de")


def test_a_text_has_any_character_of_windows_1252(texts: Machine) -> None:
    """One byte for each, also where Latin-1 has none."""
    assert errors(texts.run('V.E.SYNC = "€ß…"\nM30')) == []
    assert texts.value("V.E.SYNC") == "€ß…"


# --- mistakes ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("V.E.SYNC = 1", 21460),
        ("V.E.SYNC = P1", 21460),
        ("V.E.SYNC += V.E.CELL[0].NUMBER", 21460),
        ('V.E.SYNC = "a" + 1', 21460),
        ('V.E.SYNC -= "a"', 21458),
        ('P1 = "a"', 21461),
        ("P1 = V.E.SYNC", 21461),
        ('P1 = "a" + 1', 21461),
        ('P1 = SIN["a"]', 21461),
        ("P1 = -V.E.SYNC", 21461),
        ("P1 = V.E.LIST[V.E.SYNC]", 21461),
        ("$IF V.E.SYNC\n$ENDIF", 21461),
        ('$IF V.E.SYNC < "a"\n$ENDIF', 21458),
        ("$IF V.E.SYNC && 1\n$ENDIF", 21458),
        ("$IF V.E.SYNC == 1\n$ENDIF", 21460),
        ('$IF 1 == "a"\n$ENDIF', 21460),
        ("$FOR V.E.SYNC = 1, 2, 1\n$ENDFOR", 21461),
        ("XV.E.SYNC", 21461),
        ('#MSG ["%d", V.E.SYNC]', 900232),
        ('#MSG ["%f", "a" + V.E.SYNC]', 900232),
    ],
)
def test_texts_out_of_place_are_reported_before_the_run(
    texts: Machine, line: str, number: int
) -> None:
    """What a text cannot do has its number, its place, and a remedy."""
    run = texts.run(f"{line}\nM30")
    assert number in errors(run), errors(run)
    assert run.ticks == 0
    assert run.diagnostics[0].span is not None


@pytest.mark.parametrize(
    "line",
    [
        "V.E.CELL[0].NUMBER = V.E.SYNC",
        'V.E.CELL[0].NUMBER = "a"',
        "V.E.SYNC",
        "Vs.E.FROZEN",
        'V.E.SYNC += "a"',
        'V.E.SYNC = "a" + "b"',
        "V.E.SYNC = V.CH.OWN + V.E.SYNC",
        'V.E.CELL[0].NUMBER = V.E.SYNC < "a"',
        "V.E.CELL[V.E.SYNC].NUMBER = 1",
        '$IF V.E.SYNC + "a" == "b"\n$ENDIF',
        "$IF V.E.SYNC\n$ENDIF",
    ],
)
def test_realtime_cycles_only_compare_and_assign_texts(texts: Machine, line: str) -> None:
    """RC-208: 21981 for all else, wherever a text is at rest."""
    run = texts.run(f"#RT CYCLE [SCOPE=PROG]\n{line}\n#RT CYCLE END\nM30")
    assert set(errors(run)) == {21981}


# --- from outside -----------------------------------------------------------------------------


def test_texts_are_read_and_written_by_name(texts: Machine) -> None:
    """What is written is read back at once, and is there from the next tick on."""
    controller = texts.controller
    controller.write("V.E.LIST[1]", "one")
    assert controller.read("V.E.LIST[1]") == "one"
    controller.step(1)
    assert controller.read("V.E.LIST[1]") == "one"
    assert messages(texts.run('#MSG ["%s", V.E.LIST[1]]\nM30')) == ["one"]


@pytest.mark.parametrize(
    ("name", "value", "number"),
    [
        ("V.E.SHORT", "abcd", 21462),
        ("V.E.SYNC", "→", 900344),
        ("V.E.SYNC", "a\0b", 900344),
        ("V.E.SYNC", 1.0, 900543),
        ("V.E.CELL[0].NUMBER", "a", 900543),
    ],
)
def test_values_that_do_not_fit_are_refused(
    texts: Machine, name: str, value: float | str, number: int
) -> None:
    """By name, with their numbers."""
    with pytest.raises(Failure) as caught:
        texts.controller.write(name, value)
    assert caught.value.diagnostics[0].id == number
    assert texts.value("V.E.SYNC") == ""


def test_texts_are_values_at_times() -> None:
    """``--set`` and ``--at`` with a text between quotes."""
    assert parse_assignment('V.E.TEXT="a=b"') == ("V.E.TEXT", "a=b")
    controller = Controller()
    program = NcText("p.nc", '#TIME 0.01\n#MSG ["%s", V.E.TEXT]\nM30')
    run = controller.run(program, set={"V.E.TEXT": "first"})
    assert messages(run) == ["first"]
    run = controller.run(program, at=[Stimulus("5 ms", "V.E.TEXT", "then")])
    assert messages(run) == ["then"]


# --- anything ---------------------------------------------------------------------------------

_LEAVES = (
    '"a"',
    '""',
    "V.E.SYNC",
    "Vs.E.FROZEN",
    "V.CH.OWN",
    "V.E.LIST[P1]",
    "1",
    "P1",
    "V.E.CELL[0].NUMBER",
)
_OPERATORS = ("+", "+", "==", "!=", "-", "&&", "<", "MOD")
_TARGETS = ("V.E.SYNC", "V.CH.LATER", "V.E.LIST[P1 + 1]", "P2", "V.E.CELL[1].NUMBER", "V.E.CELL[1]")


def _expression(chance: Random, depth: int) -> str:
    if depth == 0 or chance.random() < 0.3:
        return chance.choice(_LEAVES)
    left, right = _expression(chance, depth - 1), _expression(chance, depth - 1)
    return f"[{left} {chance.choice(_OPERATORS)} {right}]"


def _line(chance: Random) -> str:
    value = _expression(chance, 3)
    match chance.randrange(4):
        case 0 | 1:
            return f"{chance.choice(_TARGETS)} {chance.choice(('=', '+='))} {value}"
        case 2:
            return f"$IF {value}\n$ENDIF"
    return f'#MSG ["%s", {value}]'


def test_what_passes_the_checker_runs(tmp_path: Path) -> None:
    """Random texts and numbers: a line is reported before the run, or runs to its end or limit."""
    chance = Random(7)
    m = machine(tmp_path, TEXTS)
    passed = 0
    for _ in range(400):
        line = _line(chance)
        reported = len(m.controller.diagnostics)
        first = m.controller.tick
        run = m.run(f"{line}\nM30")
        new = {one.id for one in m.controller.diagnostics[reported:]}
        if m.controller.tick > first:
            passed += 1
            assert new <= {21462, 20396, 50892}, line
        else:
            assert new <= {21461, 21458, 21460, 900215, 900228}, line
            assert new, line
        assert run.state in ("ended", "error"), line
    assert 40 < passed < 300
