# SPDX-License-Identifier: MIT
"""The table of what is simulated, accepted and refused, and the conversions in the texts of
``#MSG``."""

from __future__ import annotations

from collections import Counter

import pytest
from support.check_machine import demo_channel, findings

from nctakt.base.diagnostics import Severity
from nctakt.lists.declared.technology_functions import (
    INTERNAL_M_FUNCTIONS,
    SYNCHRONISATIONS,
    TechnologyFunction,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.commands import COMMANDS
from nctakt.nc.vocabulary.entries import Kind, Support
from nctakt.nc.vocabulary.message_formats import conversions
from nctakt.nc.vocabulary.operators import FUNCTIONS


def test_each_name_has_one_row_and_two_texts() -> None:
    """The table can be printed: no name twice in its kind, a meaning in both languages."""
    table = list(support_level.entries())
    names = Counter((entry.kind, entry.name) for entry in table)
    assert [name for name, count in names.items() if count > 1] == []
    assert all(entry.meaning.en and entry.meaning.de for entry in table)
    assert {entry.kind for entry in table} == set(Kind)


def test_the_table_covers_what_the_other_tables_name() -> None:
    """Synchronisation types, internal M functions, functions and control words have rows."""
    known = {(entry.kind, entry.name) for entry in support_level.entries()}
    for name in SYNCHRONISATIONS:
        assert (Kind.TECHNOLOGY, name) in known
    for number in INTERNAL_M_FUNCTIONS:
        assert (Kind.M_FUNCTION, f"M{number:02}") in known
    for function in FUNCTIONS:
        assert (Kind.FUNCTION, function) in known
    for word in ("$IF", "$FOR", "$WHILE", "$DO", "$REPEAT", "$SWITCH", "$GOTO"):
        assert (Kind.CONTROL, word) in known


def test_g_functions_are_found_by_number() -> None:
    """``G1`` and ``G01`` are one function; what is not in the table nobody knows."""
    rapid, unknown = support_level.g_function(0), support_level.g_function(7)
    assert rapid is not None
    assert rapid.name == "G00"
    assert rapid.support is Support.SIMULATED
    assert unknown is None
    assert support_level.g_function(1.5) is None


def test_technology_functions_are_supported_by_their_synchronisation() -> None:
    """An M function of the channel list is simulated if its synchronisation type is."""
    functions = demo_channel().parameters.m_functions
    entries = {
        number: support_level.m_function(number, functions) for number in (30, 100, 116, 200, 99)
    }
    assert entries[99] is None
    assert {number: entry.support for number, entry in entries.items() if entry} == {
        30: Support.SIMULATED,
        100: Support.SIMULATED,
        116: Support.SIMULATED,
        200: Support.SIMULATED,
    }


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (("RT", "CYCLE", "START"), "#RT CYCLE"),
        (("RT", "WHILE"), "#RT WHILE"),
        (("MSG", "SAVE"), "#MSG"),
        (("MC_MOVEPATH",), "#MC_"),
        (("RT",), None),
        (("CHANNEL",), None),
    ],
)
def test_commands_are_known_by_their_first_words(words: tuple[str, ...], name: str | None) -> None:
    """The longest row that fits counts."""
    entry = support_level.hash_command(words)
    assert (entry.name if entry else None) == name


def test_what_ends_a_simulated_command_is_simulated() -> None:
    """The end of a realtime loop has the support of its begin."""
    found, begin = (
        support_level.hash_command(["RT", "ENDWHILE"]),
        support_level.hash_command(["RT", "WHILE"]),
    )
    assert found is not None
    assert begin is not None
    assert found.support == begin.support


def test_a_text_tells_its_places_for_values() -> None:
    """``%%`` is the sign itself, an unknown letter is no place that can be filled."""
    assert list(conversions("%d %% %5.2f %y %")) == [
        ("%d", True),
        ("%5.2f", True),
        ("%y", False),
        ("%", False),
    ]


#: Commands that need the C axis of a lathe.
TURNING = ("#CYL", "#FACE", "#FGROUP ROT")
#: Commands whose slaves cannot be main axes.
COUPLING = ("#AX LINK", "#SET AX LINK")


@pytest.mark.parametrize("command", [name for name, one in COMMANDS.items() if one.forms])
def test_the_forms_of_a_command_are_right(command: str) -> None:
    """Each form that a remedy and ``nctakt explain`` show passes the check."""
    entry = support_level.hash_command(command.removeprefix("#").split())
    assert entry is not None
    assert entry.support is Support.SIMULATED
    for form in COMMANDS[command].forms:
        lines = ("#VAR", "V.P.NAME", "#ENDVAR", form, "M30")
        rotary = ("C",) if command in TURNING else ("A", "C") if command in COUPLING else ()
        found = findings(lines, rotary=rotary)
        assert [one.headline() for one in found if one.severity is Severity.ERROR] == []


@pytest.mark.parametrize("synchronisation", ["MEP_SVS", "MEP_MOS", "MET_SVS", "MET_MOS"])
@pytest.mark.parametrize("axis", ["", "X"])
def test_functions_that_go_out_before_their_block(synchronisation: str, axis: str) -> None:
    """P-CHAN-00041: a distance or a time before the block; for axes as well."""
    functions = {7: TechnologyFunction(7, synchronisation, (), 0.0, axis)}
    entry = support_level.m_function(7, functions)
    assert entry is not None
    name = "M110 X" if axis else synchronisation
    assert (entry.name, entry.support) == (name, Support.SIMULATED)
