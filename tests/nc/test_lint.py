# SPDX-License-Identifier: MIT
"""Findings beyond errors, written beside the lines that cause them (``lint_*.nc``)."""

from __future__ import annotations

import random
import shutil
from dataclasses import replace
from itertools import chain
from pathlib import Path

import pytest
from support.check_machine import demo_channel, findings
from support.nc_chunks import Chunk, compare, read_chunks

from nctakt import machines
from nctakt.base.diagnostics import Diagnostic, Message, Severity
from nctakt.checking.program import check_program
from nctakt.checking.program_pass import ProgramChannel
from nctakt.files.access import FileAccess
from nctakt.lists.declared.tools import NO_TOOL
from nctakt.messages import Collector
from nctakt.messages.axes.axis_motions import INDP_TARGET_OUTSIDE_LIMITS
from nctakt.messages.path.feed import FEED_NOT_POSITIVE, INVALID_PROGRAM_OVERRIDE
from nctakt.messages.programs import lints as lint_messages
from nctakt.messages.programs.decoder import VALUE_OUTSIDE_TYPE_RANGE
from nctakt.messages.programs.extensions import EXTENSION_USED
from nctakt.messages.programs.realtime import CYCLE_ID_IN_USE, CYCLE_VALUE_OUT_OF_RANGE
from nctakt.nc.lint.linter import never_deleted
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.source import Source
from nctakt.run.controller import Controller, NcText

DEMO = Path(machines.__path__[0]) / "demo"
LINTS = [message.id for message in vars(lint_messages).values() if isinstance(message, Message)]
#: Errors of a run that lint foresees.
LINTS += [CYCLE_ID_IN_USE.id, CYCLE_VALUE_OUT_OF_RANGE.id, INDP_TARGET_OUTSIDE_LIMITS.id]
LINTS += [FEED_NOT_POSITIVE.id, VALUE_OUTSIDE_TYPE_RANGE.id]
LINTS += INVALID_PROGRAM_OVERRIDE.leading
LIMITS = StepLimits(201, 200)
FILES = FileAccess()


def lints(*programs: tuple[str, ...], limits: StepLimits = LIMITS) -> list[Diagnostic]:
    """The findings of a set of programs without errors of other kinds; the set's own at the end."""
    collector = Collector()
    channel = demo_channel()
    uses = [
        check_program(
            Source(f"{number}.nc", lines),
            ProgramChannel(channel.names, channel.parameters, limits),
            collector,
            access=FILES,
        ).global_cycles
        for number, lines in enumerate(programs, start=1)
    ]
    never_deleted(uses, collector)
    return [found for found in collector.diagnostics if found.id in LINTS]


@pytest.mark.parametrize("chunk", read_chunks("lint_*.nc"), ids=str)
def test_lint_finds_what_each_line_says_and_nothing_else(chunk: Chunk) -> None:
    """Each finding of a chunk comes once, at its line; what runs as meant gives none."""
    assert compare(chunk, lints(chunk.lines)) == []


# --- extensions ----------------------------------------------------------------------------------

EXTENDED = """\
#RT CYCLE [ID=1]
  $IF ONCE V.E.VALUE > 1
    V.E.COUNT -= 1
    V.E.COUNT += 1
    V.E.VALUE = 2
    Z[INDP BUFFERED G01 G90 FEED=500 POS=10]
  $ENDIF
#RT CYCLE END
#RT CYCLE [ID=2 SCOPE=GLOBAL]
  $IF ONCE V.E.VALUE > 1
    Z[INDP ABORTING G01 G90 FEED=500 POS=10]
  $ENDIF
#RT CYCLE END
"""


def test_each_extension_of_ours_is_a_warning_of_one_class() -> None:
    """SCOPE left out, assignments other than = and +=, BUFFERED: the controller lacks them."""
    collector = Collector()
    channel = demo_channel()
    lines = tuple(EXTENDED.splitlines())
    source = Source("p.nc", lines)
    checked = ProgramChannel(channel.names, channel.parameters, LIMITS)
    check_program(source, checked, collector, access=FILES)
    found = [one for one in collector.diagnostics if one.id == EXTENSION_USED.id]
    assert [one.span.line for one in found if one.span] == [1, 3, 6]
    assert {one.severity for one in found} == {Severity.WARNING}


# --- limits --------------------------------------------------------------------------------------

FIVE_WAYS = """\
#RT CYCLE
  $IF V.E.VALUE > 1            ; load, comparison, condition: 3
    V.E.COUNT = V.E.COUNT + 1  ; load, sum, store: 3
    M100 H100                  ; 2
  $ELSEIF V.E.VALUE > SIN[30]  ; load, sine, comparison, condition: 4
    V.E.COUNT += V.E.ASYNC     ; load, frozen, sum, store: 4
    V.E.LIST[V.E.COUNT] *= 2   ; (index, load), product, (index, store): 5
  $ELSE
    V.E.LIST[2] = 1            ; store: 1
  $ENDIF
  $IF EDGE NOT[V.E.ASYNC]      ; frozen, negation, condition: 3
    V.E.LIST[P1 + V.E.COUNT]   ; frozen, load, sum, load: 4
  $ENDIF
#RT CYCLE END
"""
#: The way over $ELSEIF costs most: 3 + 4 + 4 + 5, then 3 + 4.
STEPS = 23


@pytest.mark.parametrize(
    ("limit", "found"), [(STEPS - 1, True), (STEPS, False), (STEPS + 1, False)]
)
def test_a_cycle_that_can_cost_more_than_a_tick_allows_is_found(limit: int, *, found: bool) -> None:
    """RC-501, RC-502, RC-503: the dearest way through the branches counts, limit by limit."""
    lines = tuple(FIVE_WAYS.splitlines())
    for number, limits in ((900246, StepLimits(limit, 1000)), (900247, StepLimits(1000, limit))):
        reported = [one for one in lints(lines, limits=limits) if one.id in (900246, 900247)]
        assert [(one.id, one.values) for one in reported] == (
            [(number, {"steps": STEPS, "limit": limit})] if found else []
        )


def test_the_count_is_that_of_the_realtime_part(tmp_path: Path) -> None:
    """RC-501: at P-CHAN-00427 equal to the count of the lint a cycle runs, below it ends."""
    body = FIVE_WAYS.split("\n", 1)[1]
    program = f"V.E.VALUE = 0.9\nP1 = 0\n#RT CYCLE\n{body}#TIME 0.003\nM30\n"
    for limit, errors in ((STEPS, []), (STEPS - 1, [50854])):
        folder = tmp_path / str(limit)
        shutil.copytree(DEMO, folder)
        with (folder / "sda_mds1.lis").open("r+", encoding="utf-8") as file:
            text = file.read().replace("Ende", f"rt_cycles.max_steps {limit}\nEnde")
            file.seek(0)
            file.write(text)
        run = Controller(folder).run(NcText("p.nc", program))
        assert [one.id for one in run.errors] == errors


# --- the way through a program -------------------------------------------------------------------


@pytest.mark.parametrize("chunk", read_chunks("*.nc"), ids=str)
def test_statement_by_statement_finds_what_the_whole_tree_tells(chunk: Chunk) -> None:
    """A check has the errors, warnings and notes of a run, its own, and files that are missing."""
    collector = Collector()
    channel = demo_channel()
    source = Source("p.nc", chunk.lines)
    checked = ProgramChannel(channel.names, channel.parameters, LIMITS)
    check_program(source, checked, collector, access=FILES)
    found = [
        one.headline()
        for one in collector.diagnostics
        if one.id not in (*LINTS, EXTENSION_USED.id, 20369)
    ]
    expected = findings(chunk.lines, role="either")
    assert sorted(found) == sorted(one.headline() for one in expected)


WORDS = tuple("N10 G00 G1 G01 G2 G04 G90 G17 X1 X2.5 Y-3 F100 F0 M100".split())
MORE = ("Q1", "S5", "M30", "M17", "/G01", "%L S", "%", "X", "XP1", "G4.5", "G41", "T3", "M5 X3")


@pytest.mark.parametrize("seed", range(20))
def test_blocks_of_a_shape_that_was_seen_are_checked_all_the_same(seed: int) -> None:
    """Many blocks of few shapes, right and wrong: each mistake is reported each time."""
    chance = random.Random(seed)
    lines = tuple(
        " ".join(chance.choices((*WORDS, *WORDS, *MORE[: 3 + seed % 10]), k=chance.randint(1, 3)))
        for _ in range(150)
    )
    collector = Collector()
    channel = demo_channel()
    source = Source("p.nc", lines)
    checked = ProgramChannel(channel.names, channel.parameters, LIMITS)
    check_program(source, checked, collector, access=FILES)
    found = [one.headline() for one in collector.diagnostics if one.id not in LINTS]
    assert sorted(found) == sorted(one.headline() for one in findings(lines, role="either"))


def test_a_feed_of_nothing_is_found_in_a_long_program() -> None:
    """Lines that are passed over since they are like others may not hide it."""
    lines = (*["G01 X1 F100"] * 3000, "G01 X2 F0", "G01 X2 F-1", "M30")
    found = [(one.id, one.span.line) for one in lints(lines) if one.span is not None]
    assert found == [(20176, 3001), (20176, 3002)]


# --- sets of programs ----------------------------------------------------------------------------


def test_a_global_cycle_may_be_deleted_by_another_program() -> None:
    """RC-107: only where no program of the set deletes it the cycle is reported."""
    defines = ("#RT CYCLE [ID=3 SCOPE=GLOBAL]", "#RT CYCLE END")
    assert [str(one.span) for one in lints(defines, ("M30",))] == ["1.nc:1:1"]
    assert lints(defines, ("#RT CYCLE DELETE [ID=3]",)) == []
    assert lints(("#RT CYCLE DELETE [ID=3]",), defines) == []
    assert [one.id for one in lints(defines, ("#RT CYCLE DELETE [ID=4]",))] == [900245]


def test_each_finding_reads_in_both_languages() -> None:
    """Every finding of the chunks renders with its place, its source line and its remedy."""
    for chunk in read_chunks("lint_*.nc"):
        for found in lints(chunk.lines):
            for language in ("en", "de"):
                text = found.render(language)
                assert text.startswith("1.nc:")
                assert "^" in text
                assert found.remedy(language)


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(10))
def test_any_program_is_looked_at_without_a_fault(seed: int) -> None:
    """Programs of lines in any order, right and wrong ones, give findings only."""
    chance = random.Random(seed)
    lines = list(chain.from_iterable(chunk.lines for chunk in read_chunks("*.nc")))
    for _ in range(20):
        lints(tuple(line.split("; ")[0] for line in chance.choices(lines, k=60)))


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("D1", []),
        ("D0", []),
        ("D7", [20172]),
        ("T1\nT0\nTP1", []),
        ("T7 D1", [20167]),
        ("D2", [20691]),
        ("D[3 + 4]", []),
        ("D1\n$IF V.E.VALUE\nD8\n$ENDIF\nD9", [20172, 20172]),
    ],
)
def test_a_number_of_a_tool_is_looked_up_in_the_list(text: str, found: list[int]) -> None:
    """Each D that is a number, wherever it is; without a list nothing can be reported."""
    channel = demo_channel()
    source = Source("p.nc", tuple(f"{text}\nM30".splitlines()))
    tool = replace(NO_TOOL, valid=True, number=1)
    for tools, expected in (({1: tool, 2: NO_TOOL}, found), ({}, [])):
        collector = Collector()
        checked = ProgramChannel(channel.names, channel.parameters, LIMITS, tools)
        check_program(source, checked, collector, access=FILES)
        ids = [one.id for one in collector.diagnostics if one.id != 900201]
        assert ids == expected


def test_tools_of_an_external_tool_management_are_not_looked_up() -> None:
    """P-CHAN-00016: the PLC may have any tool, for T and for D; only a run can show it."""
    channel = demo_channel()
    source = Source("p.nc", ("T7", "T7 D7", "M30"))
    tools = {1: replace(NO_TOOL, valid=True, number=1)}
    for by_t in (False, True):
        selection = replace(channel.parameters.tool_selection, is_external=True, by_t=by_t)
        parameters = replace(channel.parameters, tool_selection=selection)
        collector = Collector()
        checked = ProgramChannel(channel.names, parameters, LIMITS, tools)
        check_program(source, checked, collector, access=FILES)
        assert [one.id for one in collector.diagnostics if one.id != 900201] == []
