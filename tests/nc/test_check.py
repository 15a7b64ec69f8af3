# SPDX-License-Identifier: MIT
"""The checker beside its chunks: channel lists, suggestions, texts in both languages, any text."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from itertools import chain
from pathlib import Path

import pytest
from support.check_machine import demo_channel, findings
from support.nc_chunks import FOLDER, expected_messages, read_chunks

from nctakt.base.diagnostics import Message
from nctakt.base.text import decode_text, split_lines
from nctakt.messages.programs import (
    checked_axes,
    checked_blocks,
    checked_cycles,
    checked_values,
    lints,
)

CORPUS = Path(os.environ.get("NCTAKT_CORPUS", FOLDER.parents[2] / "corpus"))


def test_realtime_cycles_need_p_chan_00406() -> None:
    """RC-114: while the parameter is off each ``#RT CYCLE`` is 21982 and names the parameter."""
    parameters = demo_channel().parameters
    off = replace(parameters, realtime_cycles=replace(parameters.realtime_cycles, enable=False))
    lines = ("#RT CYCLE [ID=1]", "M100", "#RT CYCLE END", "#RT CYCLE DELETE [ID=1]")
    found = findings(lines, off)
    assert [(one.id, one.span and one.span.line) for one in found] == [(21982, 1), (21982, 4)]
    assert all("P-CHAN-00406" in one.text(language) for one in found for language in ("en", "de"))
    assert "configuration.rt_cycles.enable 1" in found[0].remedy("en")


def test_a_tool_change_program_is_a_call() -> None:
    """M6 with its own subprogram (P-CHAN-00118) needs no entry in the channel list."""
    parameters = replace(demo_channel().parameters, m_functions={})
    programs = replace(parameters.implicit_programs, m6="change.nc")
    found = findings(("M6",), replace(parameters, implicit_programs=programs))
    assert found == []
    assert [one.id for one in findings(("M6",), parameters)] == [20157]


def test_words_of_the_main_spindle_need_one() -> None:
    """P-CHAN-00051: without a main spindle S and M3 are nobody's, in cycles, too."""
    parameters = replace(demo_channel().parameters, spindles=())
    lines = ("M3 S100", "#RT CYCLE", "M5", "#RT CYCLE END", "S2[M5]")
    found = [(one.id, one.span and one.span.line) for one in findings(lines, parameters)]
    assert found == [(21961, 1), (21961, 3), (20797, 5)]


def test_a_channel_without_axes_knows_no_axis() -> None:
    """Axis words are those of the channel list."""
    found = findings(("G00 X1",), replace(demo_channel().parameters, axes=()))
    assert [one.id for one in found] == [20797]


@pytest.mark.parametrize(
    ("line", "suggestion"),
    [
        ("#FLUHS WAIT", "#FLUSH"),
        ("#CHANEL INIT", "#CHANNEL INIT"),
        ("V.E.VALU = 1", "V.E.VALUE"),
        ("V.E.LEVEL_1_A[0].REAL46 = 1", "V.E.LEVEL_1_A[].REAL64"),
        ("V.E.value = 1", "V.E.VALUE"),
        ("V.CH.level.real64 = 1", "V.CH.Level.REAL64"),
        ("P1 = V.RTA.acs.act_pos.x", "V.RTA.ACS.ACT_POS.X"),
        ("P1 = V.RTG.timer[3]", "V.RTG.TIMER[]"),
        ("V.CHN.Total = 1", "V.CH"),
        ("P1 = V.RTG.OVERRIDE.VEL.TOTL", "V.RTG.OVERRIDE.VEL.TOTAL"),
        ("P1 = V.RTA.ACS.ACT_POS", "V.RTA.ACS.ACT_POS.X"),
        ("P1 = V.RTA.MCS.DIST_TO_GO", "V.RTA.MCS.DIST_TO_GO.X"),
        ("P1 = V.RTA.ACS.AKT_POS.Y", "V.RTA.ACS.ACT_POS.Y"),
        ("P1 = SINE[30]", "SIN"),
        ("P1 = TRU", "TRUE"),
        ("V.E.LEVEL_1_A[1].REAL64 = V.E.LEVEL_1_A[0]", "V.E.LEVEL_1_A[0].REAL64"),
        ("V.E.VALUE = V.E.LEVEL_1_A[0]", "V.E.LEVEL_1_A[].BOOLEAN"),
        ("#MSG SAFE ['x']", "SAVE"),
        ("S22=100", "S2"),
        ("#RT CYCLE [SCOPE=GLOBL ID=1]", "GLOBAL, BLOCK, PROG"),
        ("Q5", "X, Y, Z, A"),
        ("P1 = X.ACS.ACT_POS", "V.RTA.ACS.ACT_POS.X"),
        ("IF P1 > 3", "$IF"),
        ("Z[INDPP POS=3]", "INDP"),
    ],
)
def test_the_remedy_names_what_is_probably_meant(line: str, suggestion: str) -> None:
    """A word that nobody knows is an error with the nearest known name (nc-programs, 12)."""
    line = line.replace("'", '"')
    found = findings((line, "#RT CYCLE END") if "#RT" in line else (line,))
    assert len(found) == 1
    for language in ("en", "de"):
        assert suggestion in found[0].remedy(language)


@pytest.mark.parametrize(
    ("line", "remedy"),
    [
        ("P1 = V.E.FORCE", "V.E variables are declared in the machine's list of variables: var"),
        ("P1 = V.CH.FORCE", "V.CH variables are declared in the machine's list of variables: vch"),
        ("P1 = V.G.FEEDRAT", "V.G.FEEDRATE?"),
        ("P1 = V.A.ABSS.X", "V.A.ABS.X?"),
        ("P1 = V.G.WZ_AKT.RADIUS", "V.G.WZ_AKT.R?"),
        ("P1 = V.SPDL_PROG.SPED.S", "V.SPDL_PROG.SPEED.S?"),
        ("P1 = V.RTG.TIMER[200]", "below 128. The list sizes V.E and V.CH"),
        ("Z[ABORTING G90 POS=30]", "Write Z[INDP …] in a realtime cycle."),
        ("Z[INDP_ASYN G90 G00 POS=3 SLOPE_TYPE=STEP]", "the slope of P-CHAN-00071"),
        ("#MSG INFO ['x']", "positions and times do not depend on it"),
        ("#FILE DELETE [A]", "positions and times do not depend on it"),
        ("#INIT MACRO TAB", "positions and times do not depend on it"),
        ("#INIT V.E", "may differ from those on the machine"),
        ("P1 = V.I.STATE", "here it has none"),
        ("G200", "its effect would change positions or times"),
        ("V.E.LEVEL_1_A = [1, 2]", "Assign each element by itself."),
    ],
)
def test_the_remedy_says_what_is_true_of_the_word(line: str, remedy: str) -> None:
    """Where variables are declared, which ones are built in, what would be lost without it."""
    found = findings((line.replace("'", '"'),))
    assert len(found) == 1
    assert remedy in found[0].remedy()


@pytest.mark.parametrize(
    "line",
    [
        "P1 = V.E.FORCE",
        "P1 = POS + 1",
        "P1 = V.G.NIX",
        "P1 = V.A.NIX.X",
        "XX = 3",
        "#NIX",
        "$NIX",
        "LL NIX",
        "$GOTO [NIX]",
        "P1 = NIX[3]",
    ],
)
def test_nothing_is_suggested_that_was_not_meant(line: str) -> None:
    """Letters that are alike, a word of another family, and the only name that there is."""
    found = findings(("[LABEL] P1 = 1", line, "M30", "%L OTHER", "M17"))
    assert found
    assert all("Did you mean" not in one.remedy() for one in found)


@pytest.mark.parametrize(
    ("value", "ids"),
    [("POS", []), ("-1", []), ("POS + 0", [900225]), ("-NEG", [900225]), ("FORE", [900225])],
)
def test_the_direction_of_an_axis_is_a_word_or_a_number(value: str, ids: list[int]) -> None:
    """Manual 4.5.1: POS, CUR, NEG or 1, 0, -1; with POS, which is no value, nothing is computed."""
    lines = ("#RT CYCLE [ID=1 SCOPE=PROG]", f"A[INDP FEED=9 DIR={value}]", "#RT CYCLE END")
    found = findings(lines)
    assert [one.id for one in found] == ids
    assert all("POS, CUR, NEG" in one.remedy() for one in found)


@pytest.mark.parametrize("operand", ["P1", "V.E.VALUE", "[P1 > 3]"])
@pytest.mark.parametrize("before", ["$IF ", "$WHILE P2 && ", "P2 = "])
def test_the_negation_of_other_languages_is_not(before: str, operand: str) -> None:
    """``!`` is a part of ``!=`` only; the operator is NOT."""
    found = findings((f"{before}!{operand}",))
    slip = next(one for one in found if "'!'" in one.text() or "!" in one.text())
    assert slip.remedy() == "Write NOT"


def test_the_manuals_line_that_assigns_a_parent_to_its_member_is_refused() -> None:
    """RC-208: the remedy repairs the line, and the repaired line passes."""
    first, last = "#RT CYCLE [ID=17 SCOPE=GLOBAL]", "#RT CYCLE END"
    found = findings((first, "V.E.LEVEL_1_A[0].REAL64 = V.E.LEVEL_1_A[0]", last))
    assert [one.id for one in found] == [900215]
    assert "V.E.LEVEL_1_A[0].REAL64" in found[0].remedy("en")
    assert findings((first, "V.E.LEVEL_1_A[0].REAL64 = V.E.LEVEL_1_A[0].REAL64", last)) == []


def test_each_message_reads_in_both_languages() -> None:
    """Every diagnostic of the chunks renders with its place, its source line and its remedy."""
    for chunk in read_chunks("check_*.nc"):
        for found in findings(chunk.lines):
            for language in ("en", "de"):
                text = found.render(language)
                assert "p.nc:" in text
                assert "^" in text
                assert found.remedy(language)


def test_each_message_of_the_checker_is_tested() -> None:
    """No message of checked programs is without a line that causes it.

    21982 and 901079 need their own machine, 901810, 901811, 901986 and 901987 whole programs; these
    have their own tests.
    """
    files = ("check_*.nc", "lint_*.nc")
    expected = {number for one in files for _, number, _ in expected_messages(one)}
    modules = (checked_axes, checked_blocks, checked_cycles, checked_values, lints)
    declared = [one for module in modules for one in vars(module).values()]
    messages = [one for one in declared if isinstance(one, Message)]
    elsewhere = {21982, 901079, 901810, 901811, 901986, 901987}
    assert {one.id for one in messages if expected.isdisjoint(one.leading)} == elsewhere


@pytest.mark.parametrize("seed", range(20))
def test_any_text_is_checked_without_a_fault(seed: int) -> None:
    """Programs of lines in any order, with pieces lost and doubled, give diagnostics only."""
    chance = random.Random(seed)
    lines = list(chain.from_iterable(chunk.lines for chunk in read_chunks("*.nc")))
    for _ in range(20):
        program = []
        for line in chance.choices(lines, k=60):
            text = line.split("; ")[0]
            first, last = sorted((chance.randrange(60), chance.randrange(60)))
            cut = chance.random()
            if cut < 0.3:
                text = text[:first] + text[last:]
            elif cut < 0.4:
                text = text[first:last] * 2
            program.append(text)
        findings(tuple(program))


@pytest.mark.skipif(not CORPUS.is_dir(), reason="programs of others are not at hand")
def test_programs_of_others_are_checked_without_a_fault() -> None:
    """Whatever the programs hold, the checker gives diagnostics and nothing else."""
    for path in sorted(CORPUS.rglob("*")):
        if path.is_file() and path.suffix != ".md" and path.stat().st_size < 100_000:
            findings(tuple(split_lines(decode_text(path.read_bytes()).text)))
