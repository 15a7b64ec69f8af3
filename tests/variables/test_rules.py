# SPDX-License-Identifier: MIT
"""RC-301 … RC-311: variables in programs and realtime cycles, each rule by its number.

The expected values are worked out by hand from the rules; whole runs with traces are in
``tests/runs``.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.variable_machines import folder_with
from support.variable_programs import Machine, demo, errors, machine, messages

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.plc import AnyPlc
from nctakt.run.controller import Controller, NcText

#: V.E of the channel, V.E GLOBAL and V.CH: each synchronous and asynchronous, as number, array and
#: nested structure.
ALL = """
struct[0].name OUTER
struct[0].element[0].name NUMBER
struct[0].element[0].type REAL64
struct[0].element[1].name INNER
struct[0].element[1].type INNER
struct[0].element[1].array_elements 3
struct[1].name INNER
struct[1].element[0].name LIST
struct[1].element[0].type SGN32
struct[1].element[0].array_elements 4
struct[1].element[1].name BESIDE
struct[1].element[1].type SGN32
number_used_variables 12
""" + "".join(
    f"""
{prefix}[{index}].name {name}
{prefix}[{index}].type {type_}
{prefix}[{index}].array_elements {elements}
{prefix}[{index}].synchronisation {"FALSE" if later else "TRUE"}
"""
    + (f"var[{index}].scope {scope}\n" if scope else "")
    for prefix, scope, first, letter in (
        ("var", "CHANNEL", 0, "C"),
        ("var", "GLOBAL", 6, "G"),
        ("vch", "", 0, "H"),
    )
    for index, name, type_, elements, later in (
        (first, f"{letter}S", "REAL64", 0, False),
        (first + 1, f"{letter}A", "REAL64", 0, True),
        (first + 2, f"{letter}S_LIST", "SGN32", 5, False),
        (first + 3, f"{letter}A_LIST", "SGN32", 5, True),
        (first + 4, f"{letter}S_OUTER", "OUTER", 2, False),
        (first + 5, f"{letter}A_OUTER", "OUTER", 2, True),
    )
)
FAMILIES = {"C": "E", "G": "E", "H": "CH"}
PATHS = {
    "number": "{name}",
    "element": "{name}_LIST[3]",
    "computed": "{name}_LIST[P1 + V.E.CS_LIST[0]]",
    "nested": "{name}_OUTER[1].INNER[P1].LIST[P1 + 1]",
    "member": "{name}_OUTER[0].NUMBER",
}
#: Where ``PATHS`` point with P1 = 2 and V.E.CS_LIST[0] = 1.
PLACES = {
    "number": "{name}",
    "element": "{name}_LIST[3]",
    "computed": "{name}_LIST[3]",
    "nested": "{name}_OUTER[1].INNER[2].LIST[3]",
    "member": "{name}_OUTER[0].NUMBER",
}
KINDS = list(PATHS)


@pytest.fixture
def every(tmp_path: Path) -> Machine:
    """A machine with all kinds of variables, P1 is set by each program itself."""
    m = machine(tmp_path, ALL)
    m.controller.write("V.E.CS_LIST[0]", 1)
    m.controller.step(1)
    return m


def path(letter: str, later: bool, kind: str, *, forced: bool = False) -> tuple[str, str]:
    """A variable as a program writes it, and the name of what it means."""
    name = f"{letter}{'A' if later else 'S'}"
    family = FAMILIES[letter]
    text = f"V{'s' if forced else ''}.{family}.{PATHS[kind].format(name=name)}"
    return text, f"V.{family}.{PLACES[kind].format(name=name)}"


def ticks_of(m: Machine, line: str) -> int:
    """Ticks of a program with this line."""
    run = m.run(f"P1 = 2\n{line}\nM30")
    assert errors(run) == [], run.diagnostics
    return run.ticks


# --- RC-301, RC-308: decoder ------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("letter", FAMILIES)
@pytest.mark.parametrize("later", [False, True])
def test_rc_308_programs_write(every: Machine, letter: str, later: bool, kind: str) -> None:
    """A write goes through the queue or at once; either way what is read after it sees it."""
    text, name = path(letter, later, kind)
    run = every.run(
        f'P1 = 2\n{text} = 7\n{text} += 4\n{text} -= 1\nP2 = {text}\n#MSG ["%f", P2]\nM30'
    )
    assert errors(run) == []
    assert every.value(name) == 10
    assert messages(run) == ["10.000000"]
    others = [path(letter, later, other)[1] for other in KINDS]
    assert {every.value(other) for other in others if other != name} == {0.0}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("letter", FAMILIES)
def test_rc_308_a_synchronous_read_empties_the_channel(
    every: Machine, letter: str, kind: str
) -> None:
    """One tick for each synchronous variable that is read, indices included; else none."""
    in_index = 1 if kind == "computed" else 0
    plain = ticks_of(every, "P2 = 1")
    assert ticks_of(every, f"P2 = {path(letter, True, kind)[0]}") == plain + in_index
    assert ticks_of(every, f"P2 = {path(letter, False, kind)[0]}") == plain + in_index + 1
    forced = path(letter, True, kind, forced=True)[0]
    assert ticks_of(every, f"P2 = {forced}") == plain + in_index + 1


@pytest.mark.parametrize("letter", FAMILIES)
def test_rc_308_a_write_waits_for_nothing(every: Machine, letter: str) -> None:
    """Synchronous or not; ``+=`` reads, so that a synchronous one costs a tick."""
    plain = ticks_of(every, "P2 = 1")
    assert ticks_of(every, f"{path(letter, True, 'number')[0]} = 1") == plain
    assert ticks_of(every, f"{path(letter, False, 'number')[0]} = 1") == plain
    assert ticks_of(every, f"{path(letter, True, 'number')[0]} += 1") == plain
    assert ticks_of(every, f"{path(letter, False, 'number')[0]} += 1") == plain + 1


@pytest.mark.parametrize("letter", FAMILIES)
def test_rc_308_writes_take_their_place_in_the_queue(every: Machine, letter: str) -> None:
    """A synchronous one after the motion before it, an asynchronous one while it is decoded."""
    later, now = path(letter, False, "nested"), path(letter, True, "nested")
    text = f"P1 = 2\nG01 X1 F600\n{later[0]} = 5\n{now[0]} = 6\nG01 X2\nM30"
    every.controller.start(NcText("p.nc", text))
    every.controller.step(10)
    assert (every.value(later[1]), every.value(now[1])) == (0, 6)
    every.controller.step(200)
    assert (every.value(later[1]), every.value(now[1])) == (5, 6)


def test_rc_308_realtime_variables_empty_the_channel_when_written(every: Machine) -> None:
    """V.RT*: a read and a write, one tick each."""
    plain = ticks_of(every, "P2 = 1")
    assert ticks_of(every, "P2 = V.RTG.LOOP.COUNT") == plain + 1
    assert ticks_of(every, "V.RTG.LOOP.COUNT = 3") == plain + 1
    assert every.value("V.RTG.LOOP.COUNT") == 3


# --- RC-301, RC-302: cycles -------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("letter", FAMILIES)
@pytest.mark.parametrize("forced", [False, True])
def test_rc_301_cycles_write_synchronous_variables(
    every: Machine, letter: str, forced: bool, kind: str
) -> None:
    """Those of the list, and any one with ``Vs.`` for its statement."""
    text, name = path(letter, forced, kind, forced=forced)
    body = f"$IF ONCE TRUE\n{text} = 7\n{text} += 4\n{text} *= 2\n$ENDIF"
    run = every.run(f"P1 = 2\n#RT CYCLE [SCOPE=PROG]\n{body}\n#RT CYCLE END\n#TIME 0.003\nM30")
    assert errors(run) == []
    assert every.value(name) == 22
    written = [event.text for event in run.events if event.kind == "written"]
    assert written == [f"{name} {number}" for number in (7, 11, 22)]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("letter", FAMILIES)
@pytest.mark.parametrize("operator", ["=", "+=", "-=", "*=", "/="])
def test_rc_301_cycles_do_not_write_asynchronous_ones(
    every: Machine, letter: str, operator: str, kind: str
) -> None:
    """22009 names the variable, before the first tick."""
    text, _ = path(letter, True, kind)
    run = every.run(f"P1 = 2\n#RT CYCLE [SCOPE=PROG]\n{text} {operator} 1\n#RT CYCLE END\nM30")
    assert 22009 in errors(run)
    assert run.ticks == 0


def test_rc_301_vs_binds_a_whole_block(every: Machine) -> None:
    """With and without in one block is 900228; in the next block it is as before."""
    text = "#RT CYCLE [SCOPE=PROG]\n{}\n#RT CYCLE END\n#TIME 0.003\nM30"
    assert errors(every.run(text.format("V.E.CS = Vs.E.CA + V.E.CA"))) == [900228]
    good = machine_like(every)
    assert errors(good.run(text.format("V.E.CS = Vs.E.CA\nV.E.GS = V.E.CA"))) == []


def machine_like(m: Machine) -> Machine:
    """Another controller of the same machine."""
    return Machine(Controller(m.controller.machine))


@pytest.mark.parametrize("letter", FAMILIES)
@pytest.mark.parametrize("kind", KINDS)
def test_rc_302_live_or_frozen(every: Machine, letter: str, kind: str) -> None:
    """Synchronous: the value of each tick; asynchronous: that of the definition, not of START."""
    live, live_name = path(letter, False, kind)
    frozen, frozen_name = path(letter, True, kind)
    every.controller.write(frozen_name, 5)
    every.controller.step(1)
    program = (
        f"P1 = 2\n#RT CYCLE DEF [ID=1 SCOPE=PROG]\n"
        f"V.RTG.LOOP.COUNT = 100 * {live} + {frozen}\n#RT CYCLE END\n"
        f"{frozen} = 6\n#RT CYCLE START [ID=1]\n#TIME 0.01\nM30"
    )
    every.controller.start(NcText("p.nc", program))
    every.controller.step(3)
    assert every.value("V.RTG.LOOP.COUNT") == 5
    assert every.value(frozen_name) == 6
    every.controller.write(live_name, 2)
    every.controller.step(1)
    assert every.value("V.RTG.LOOP.COUNT") == 205


def test_rc_302_an_index_of_a_frozen_element_is_frozen_too(tmp_path: Path) -> None:
    """``A_LIST[S]``: element and index are those of the definition (warning 900227)."""
    m = machine(tmp_path, ALL)
    m.controller.write("V.E.CA_LIST[2]", 22)
    m.controller.write("V.E.CA_LIST[0]", 20)
    m.controller.step(1)
    run = m.run(
        "V.E.CS = 2\n#FLUSH WAIT\n#RT CYCLE [SCOPE=PROG]\nV.E.CS_LIST[1] = V.E.CA_LIST[V.E.CS]\n"
        "V.E.CS = 0\n#RT CYCLE END\n#TIME 0.005\nM30"
    )
    assert errors(run) == [900227]
    assert m.value("V.E.CS_LIST[1]") == 22


# --- RC-303 -----------------------------------------------------------------------------------

CYCLE = "#RT CYCLE [SCOPE=PROG]\n{}\n#RT CYCLE END\nM30"


@pytest.mark.parametrize(
    ("line", "program", "cycle"),
    [
        ("V.E.INPUT = 1", 20100, 20100),
        ("V.E.INPUT += 1", 20100, 20100),
        ("V.E.VALUE = V.E.OUTPUT", 20097, 20097),
        ("V.E.OUTPUT += 1", 20097, 20097),
        ("V.E.OUTPUT", 20097, 20097),
        ("V.E.VALUE = V.E.INPUT", 0, 0),
        ("V.E.OUTPUT = 1", 0, 0),
        ("V.RTG.OVERRIDE.VEL.CYCLE = 50", 21993, 0),
        ("V.RTG.OVERRIDE.VEL.TOTAL = 50", 21993, 21993),
        ("V.RTG.TIMER[0] = 1", 21993, 21993),
        ("V.RTG.MEAS_DELTA = 1", 0, 21993),
        ("V.E.VALUE = V.RTG.MEAS_DELTA", 0, 21993),
        ("V.RTG.CYCLES.DIAG_LEVEL = 2", 0, 0),
        ("V.RTG.LOOP.ENABLED = 1", 0, 0),
        ("V.RTG.LOOP.COUNT += 1", 0, 0),
        ("V.RTA.OVERRIDE.VEL.CYCLE.X = 50", 21993, 0),
        ("V.RTA.ACS.ACT_POS.X = 1", 21993, 21993),
        ("V.E.VALUE = V.RTA.FIXED_STOP.ACS.POS.X", 0, 0),
    ],
)
def test_rc_303_rights_in_both_contexts(line: str, program: int, cycle: int) -> None:
    """The tables of 3.2 and access_rights, where it is decoded; 0: allowed."""
    for text, number in ((f"{line}\nM30", program), (CYCLE.format(line), cycle)):
        run = demo().run(text)
        assert errors(run) == ([number] if number else [])
        assert (run.ticks == 0) == bool(number)


# --- RC-304 … RC-307 --------------------------------------------------------------------------


def test_rc_304_positions_are_not_quantised() -> None:
    """ACT_POS in mm as a REAL64; a comparison with == is exact."""
    m = demo()
    run = m.run(
        'G00 X0.1\n#FLUSH WAIT\n$IF V.RTA.ACS.ACT_POS.X == 0.1\n#MSG ["exact"]\n$ENDIF\n'
        "V.E.VALUE = V.RTA.MCS.DIST_TO_GO.X\nM30"
    )
    assert errors(run) == []
    assert messages(run) == ["exact"]
    assert m.value("V.E.VALUE") == 0


def test_rc_305_the_override_of_cycles_holds_for_a_tick() -> None:
    """100 % at the start of each tick: what the cycle wrote once is gone in the next one."""
    m = demo()
    run = m.run(
        "#RT CYCLE [SCOPE=PROG]\nV.E.COUNT += 1\nV.E.LIST[V.E.COUNT] = V.RTG.OVERRIDE.VEL.CYCLE\n"
        "$IF ONCE TRUE\nV.RTG.OVERRIDE.VEL.CYCLE = 50\n$ENDIF\n#RT CYCLE END\n#TIME 0.005\nM30"
    )
    assert errors(run) == []
    assert [m.value(f"V.E.LIST[{i}]") for i in (1, 2, 3)] == [100, 100, 100]


def test_rc_306_the_other_realtime_variables_rest() -> None:
    """TIMER, DIAG_LEVEL 3, LOOP.*, FIXED_STOP.* at start-up."""
    m = demo()
    assert m.value("V.RTG.CYCLES.DIAG_LEVEL") == 3
    assert m.value("V.RTG.TIMER[127]") == 0
    assert m.value("V.RTG.LOOP.ENABLED") is False
    assert m.value("V.RTA.FIXED_STOP.DETECTED.X") is False


VALUES = [
    ("SMALL", 2.5, 2),
    ("SMALL", -0.5, 0),
    ("SMALL", 127.5, None),
    ("SMALL", -128.5, -128),
    ("BYTE", 255.4, 255),
    ("BYTE", -1, None),
    ("WORD", 65535.5, None),
    ("COUNT", 4294967295.4, 4294967295),
    ("FLAG", 0.5, True),
    ("FLAG", -0.49, False),
    ("FLAG", -3, True),
]


@pytest.mark.parametrize(("name", "value", "stored"), VALUES)
def test_rc_307_types_round_and_refuse(name: str, value: float, stored: float | None) -> None:
    """Half to even; outside of the type 20847 by program and by name, 50892 by cycle."""
    line = f"V.E.{name} = {value}"
    for number, text in (
        (20847, f"{line}\n#FLUSH WAIT\nM30"),
        (50892, f"#RT CYCLE [SCOPE=PROG]\n{line}\n#RT CYCLE END\nM30"),
    ):
        m = demo()
        run = m.run(text)
        assert errors(run) == ([number] if stored is None else [])
        assert m.value(f"V.E.{name}") == (stored or 0)
    m = demo()
    if stored is None:
        with pytest.raises(Failure) as caught:
            m.controller.write(f"V.E.{name}", value)
        assert caught.value.diagnostics[0].id == 20847
    else:
        m.controller.write(f"V.E.{name}", value)
        assert m.value(f"V.E.{name}") == stored


# --- RC-309 -----------------------------------------------------------------------------------

NEEDS = """
struct[0].name PAIR
struct[0].element[0].name A
struct[0].element[0].type REAL64
struct[0].element[1].name B
struct[0].element[1].type UNS08
vch[0].name LIST
vch[0].type PAIR
vch[0].array_size 3
vch[1].name FLAG
vch[1].type BOOLEAN
"""


@pytest.mark.parametrize(("bytes_", "enough"), [(155, False), (156, True), (157, True)])
def test_rc_309_memory_for_channel_variables(tmp_path: Path, bytes_: int, enough: bool) -> None:
    """P-CHAN-00424: 3 times 9 bytes and 1, 64 for the management of each variable: 156."""
    folder = folder_with(tmp_path, NEEDS)
    list_ = folder / "sda_mds1.lis"
    kept = [line for line in list_.read_text("utf-8").splitlines() if "v_ch_memory" not in line]
    entry = f"configuration.decoder.v_ch_memory {bytes_}"
    list_.write_text("\n".join([entry, *kept, ""]), "utf-8")
    loaded = load_machine(folder)
    found = [one for one in loaded.diagnostics if one.id == 22079]
    assert bool(found) == (not enough)
    assert len(loaded.channels[0].channel_variables) == (2 if enough else 0)
    if found:
        assert "156" in found[0].text("en")
        assert "155" in found[0].text("en")


def test_rc_309_channel_variables_live_until_restart(every: Machine) -> None:
    """Zero at start-up; programs, errors and resets leave them."""
    assert every.value("V.CH.HS") == 0
    every.run("V.CH.HS = 4\nV.CH.HA_OUTER[1].INNER[2].LIST[3] = 5\nM30")
    every.run("P1 = 1 / 0\nM30")
    every.controller.reset()
    run = every.run('#MSG ["%d %d", V.CH.HS, V.CH.HA_OUTER[1].INNER[2].LIST[3]]\nM30')
    assert messages(run) == ["4 5"]
    assert machine_like(every).value("V.CH.HS") == 0


class Peeping(AnyPlc):
    """A PLC that wants to see a channel variable."""

    def __init__(self) -> None:
        self.reported: list[int] = []

    def cycle(self, hli: object) -> None:
        """Read and write one."""
        for act in (
            lambda: hli.read("V.CH.Total"),  # type: ignore[attr-defined]
            lambda: hli.write("V.CH.Total", 1.0),  # type: ignore[attr-defined]
        ):
            try:
                act()
            except Failure as failure:
                self.reported.append(failure.diagnostics[0].id)


def test_rc_309_the_plc_does_not_see_them() -> None:
    """V.CH is neither read nor written by a scripted PLC (900351)."""
    plc = Peeping()
    Controller().run(NcText("p.nc", "M30"), plc=plc, ticks=1)
    assert plc.reported == [900351, 900351]


# --- RC-310, RC-311 ---------------------------------------------------------------------------

INHERITED = """
struct[0].name S
struct[0].element[0].name AS_ITS_OWNER
struct[0].element[0].type REAL64
struct[0].element[1].name OWN
struct[0].element[1].type REAL64
struct[0].element[1].synchronisation TRUE
struct[0].element[2].name INNER
struct[0].element[2].type T
struct[0].element[2].synchronisation TRUE
struct[1].name T
struct[1].element[0].name INHERITED
struct[1].element[0].type REAL64
struct[1].element[1].name FROZEN
struct[1].element[1].type REAL64
struct[1].element[1].synchronisation FALSE
number_used_variables 2
var[0].name LATER
var[0].type S
var[0].synchronisation FALSE
var[1].name LIVE
var[1].type S
"""


@pytest.mark.parametrize(
    ("member", "synchronous"),
    [
        ("LATER.AS_ITS_OWNER", False),
        ("LATER.OWN", True),
        ("LATER.INNER.INHERITED", True),
        ("LATER.INNER.FROZEN", False),
        ("LIVE.AS_ITS_OWNER", True),
        ("LIVE.INNER.FROZEN", False),
    ],
)
def test_rc_310_synchronisation_is_inherited_or_an_elements_own(
    tmp_path: Path, member: str, synchronous: bool
) -> None:
    """P-EXTV-00018: what an element says counts for it and what is inside; else its owner's."""
    m = machine(tmp_path, INHERITED)
    run = m.run(f"#RT CYCLE [SCOPE=PROG]\nV.E.{member} = 1\n#RT CYCLE END\nM30")
    assert errors(run) == ([] if synchronous else [22009])


@pytest.mark.parametrize("spelling", ["array_size", "array_elements"])
def test_rc_310_both_spellings_of_an_arrays_size(tmp_path: Path, spelling: str) -> None:
    """P-EXTV-00007, also for V.CH."""
    lists = (
        f"number_used_variables 1\nvar[0].name A\nvar[0].{spelling} 3\n"
        f"vch[0].name B\nvch[0].{spelling} 4\n"
    )
    m = machine(tmp_path, lists)
    assert errors(m.run("V.E.A[2] = 1\nV.CH.B[3] = 2\nM30")) == []
    assert errors(m.run("V.E.A[3] = 1\nM30")) == [21928]


def test_rc_310_variables_beyond_the_number_do_not_exist(tmp_path: Path) -> None:
    """P-EXTV-00010: highest index + 1 (900081 shows); V.CH does not count."""
    lists = "number_used_variables 1\nvar[0].name A\nvar[1].name B\nvch[0].name C\n"
    loaded = load_machine(folder_with(tmp_path, lists))
    assert [one.id for one in loaded.diagnostics] == [900081]
    m = Machine(Controller(loaded))
    assert m.value("V.E.A") == 0
    assert m.value("V.CH.C") == 0
    with pytest.raises(Failure):
        m.value("V.E.B")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("letter", FAMILIES)
def test_rc_311_a_variable_alone_is_read_and_dropped(
    every: Machine, letter: str, kind: str
) -> None:
    """In the program with the tick of its access, in a cycle with its instructions."""
    text, name = path(letter, False, kind)
    plain = ticks_of(every, "P2 = 1")
    extra = 2 if kind == "computed" else 1
    assert ticks_of(every, text) == plain + extra
    run = every.run(f"P1 = 2\n#RT CYCLE [SCOPE=PROG]\n{text}\n#RT CYCLE END\n#TIME 0.003\nM30")
    assert errors(run) == []
    assert [event.text for event in run.events if event.kind == "written"] == []
    assert every.value(name) == 0
