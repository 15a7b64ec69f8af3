# SPDX-License-Identifier: MIT
"""Each word that is known has one of three levels of support, and nothing is skipped in silence.

nc-programs, "What a command that we know but do not simulate does": the table of
``support_level.py`` is the only place that decides, so the checker is held to it row by row.
"""

from __future__ import annotations

import pytest
from support.check_machine import findings

from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.entries import Entry, Kind, Support
from nctakt.nc.vocabulary.function_rows import Form, GFunction

#: The messages that report the level.
REFUSED, ACCEPTED = 900200, 900201
#: The message that shows the forms of a command.
MISFORMED = 900233


def reported(block: str) -> list[tuple[int, str]]:
    """Number and text of what is found in a program of one block."""
    found = findings((block, "M30"), file="p.nc")
    return [(one.id, one.render("en")) for one in found]


def rows(kind: Kind, support: Support) -> list[Entry]:
    """The rows of the table with this level of support."""
    return [
        entry for entry in support_level.entries() if (entry.kind, entry.support) == (kind, support)
    ]


@pytest.mark.parametrize("entry", rows(Kind.G_FUNCTION, Support.REFUSED), ids=lambda one: one.name)
def test_a_refused_g_function_is_refused_by_name(entry: Entry) -> None:
    """One error, which names the function and what it does."""
    ((number, text),) = reported(f"{entry.name} X1")
    assert number == REFUSED
    assert f"{entry.name} ({entry.meaning.en})" in text


@pytest.mark.parametrize("entry", rows(Kind.G_FUNCTION, Support.ACCEPTED), ids=lambda one: one.name)
def test_an_accepted_g_function_is_reported_as_a_note(entry: Entry) -> None:
    """Once per program, however often it is there."""
    is_weight = isinstance(entry, GFunction) and entry.form is Form.WEIGHT
    first, second = ("=50", "=60") if is_weight else (" X1", " X2")
    found = findings((entry.name + first, entry.name + second, "M30"), file="p.nc")
    assert [one.id for one in found] == [ACCEPTED]


@pytest.mark.parametrize(
    "entry", rows(Kind.G_FUNCTION, Support.SIMULATED), ids=lambda one: one.name
)
def test_a_simulated_g_function_is_neither(entry: Entry) -> None:
    """It may lack its value or axis here; refused it is not."""
    assert not {REFUSED, ACCEPTED} & {number for number, _ in reported(f"{entry.name} X1")}


@pytest.mark.parametrize("entry", rows(Kind.COMMAND, Support.REFUSED), ids=lambda one: one.name)
def test_a_refused_command_is_refused_by_name(entry: Entry) -> None:
    """``#MC_`` means all that begin like it."""
    name = entry.name + "POWER" if entry.name.endswith("_") else entry.name
    numbers = [number for number, text in reported(f"{name} [X]") if entry.meaning.en in text]
    assert numbers == [REFUSED]


@pytest.mark.parametrize(
    "entry",
    [one for one in rows(Kind.COMMAND, Support.SIMULATED) if one.forms == (one.name,)],
    ids=lambda one: one.name,
)
def test_a_command_whose_name_is_its_only_form_has_no_arguments(entry: Entry) -> None:
    """The error shows the form; the form itself is in order, or needs something of the machine."""
    texts = [text for number, text in reported(f"{entry.name} [1]") if number == MISFORMED]
    assert len(texts) == 1
    assert entry.name in texts[0]
    assert MISFORMED not in {number for number, _ in reported(entry.name)}


@pytest.mark.parametrize("entry", rows(Kind.VARIABLE, Support.REFUSED), ids=lambda one: one.name)
def test_a_refused_family_of_variables_is_refused_by_name(entry: Entry) -> None:
    """Read and written."""
    for block in (f"P1 = {entry.name}.NONE.X", f"{entry.name}.NONE.X = 1"):
        ((number, text),) = reported(block)
        assert number == REFUSED
        assert entry.meaning.en in text


@pytest.mark.parametrize(
    "block",
    [
        "G7",
        "M99",
        "H99",
        "Q1",
        "ABC",
        "#FOO",
        "#CS FOO",
        "$FOO",
        "P1 = V.FOO.X",
        "P1 = V.E.NOTHING",
        "P1 = FOO[1]",
        "P1 = FOO",
        "X[FOO]",
        "S9[M3]",
        '#MSG FOO ["x"]',
        "#TIMER FOO",
        "#RT CYCLE FOO",
        "#SLOPE [FOO=1]",
        "LL NOWHERE",
        "$GOTO [NOWHERE]",
        'M110="x"',
        "=5",
        "]",
    ],
)
def test_unknown_names_are_errors(block: str) -> None:
    """Each of them is reported at its line; none is passed over."""
    found = findings((block, "M30"), file="p.nc")
    assert any(one.severity.name == "ERROR" for one in found), block


@pytest.mark.parametrize(
    ("block", "instead"),
    [
        ("G236", "G138 leads to the contour directly"),
        ("#TRC [REMOVE_MASKED_BLOCKS]", "G140 and G141"),
    ],
)
def test_a_refused_word_of_compensation_says_what_to_use(block: str, instead: str) -> None:
    """MO-9: the remedy names what leads to a contour in its place."""
    found = [text for number, text in reported(block) if number == REFUSED]
    assert len(found) == 1
    assert instead in found[0]


@pytest.mark.parametrize(
    ("block", "name"),
    [
        ("S[G74]", "S[G74]"),
        ("S[M3 REV=200 G74]", "S[G74]"),
        ("G74 S1", "G74 S1"),
        ("G74 X1 S1", "G74 S1"),
    ],
)
def test_what_spindles_do_with_their_axes_is_refused_by_name(block: str, name: str) -> None:
    """Pages 208221195, 208164107 (G74)."""
    ((number, text),) = reported(block)
    assert number == REFUSED
    assert f": {name} (" in text
