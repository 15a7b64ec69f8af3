# SPDX-License-Identifier: MIT
"""Numbers of the controller for values of parameters: the table, and who takes them."""

from __future__ import annotations

import subprocess
import sys

import pytest

from nctakt.lists.all_parameters import SCHEMA_BY_KIND, find_parameters
from nctakt.lists.format.controller_numbers import (
    CASES,
    all_numbers,
    bound_number,
    numbers_of,
    parameters_of,
)
from nctakt.lists.format.list_check import load_list
from nctakt.messages import Collector
from nctakt.reference.parameters import PARAMETER_NUMBERS


def test_the_table_is_in_order() -> None:
    """Each row once, sorted, with a known case, for a parameter that is declared."""
    rows = [(one.number, one.id) for one in all_numbers()]
    assert rows == sorted(set(rows))
    assert {one.case for one in all_numbers()} == CASES.keys()
    assert {one.found for one in all_numbers()} == {"list", "run"}
    unknown = {one.id for one in all_numbers() if not find_parameters(one.id)}
    assert unknown == set()


def test_the_table_is_large() -> None:
    """errors-map.md: some 750 numbers of some 550 parameters."""
    assert len({one.number for one in all_numbers()}) >= 740
    assert len({one.id for one in all_numbers()}) >= 540


def found_in(kind: str, line: str) -> list[int]:
    collector = Collector()
    load_list(SCHEMA_BY_KIND[kind], "x.lis", f"{line}\n".encode(), collector)
    return [one.id for one in collector.diagnostics]


@pytest.mark.parametrize(
    ("kind", "line", "number"),
    [
        ("axis", "getriebe[0].window 0", 110087),
        ("axis", "getriebe[0].dynamik.a_emergency 0", 110321),
        (
            "axis",
            "getriebe[0].dynamik.a_max 1000\ngetriebe[0].slope_profil.a_beschl 1001",
            110101,
        ),
        (
            "axis",
            "getriebe[0].dynamik.vb_max 1000\ngetriebe[0].vb_eilgang 1001",
            110085,
        ),
        ("manual_mode", "hr_data[0].log_hr_nr 70000", 150100),
        ("axis_compensation", "P-COMP-00079 0", 110670),
        ("rtconf", "thread[0].function[0].trace_bit 8\nEnd", 1023),
        ("axis", "getriebe[0].dynamik.a_max -1", 1024),
    ],
)
def test_a_value_has_the_number_of_its_parameter(kind: str, line: str, number: int) -> None:
    """Else it is 1023 above its range and 1024 below it."""
    assert found_in(kind, line) == [number]


def test_the_nearest_case_counts() -> None:
    """0 before too small, negative before both, then what speaks of any wrong value."""
    assert bound_number("P-AXIS-00236", 0.0, is_above=False) == 110087
    assert bound_number("P-CHAN-00099", -1.0, is_above=False) == 21305
    assert bound_number("P-AXIS-00015", 7.0, is_above=True) in {
        one.number for one in numbers_of("P-AXIS-00015") if one.case == "invalid"
    }
    assert bound_number("P-RTCF-00001", 7.0, is_above=True) == 1023


def test_each_number_is_explained() -> None:
    """In both languages, with each of its parameters."""
    for article in PARAMETER_NUMBERS.articles():
        assert len(article.facts) == len(parameters_of(int(article.name)))
        assert all(fact.value.en and fact.value.de for fact in article.facts)


def test_the_table_is_not_read_at_the_start() -> None:
    """A run that finds no wrong value does without it."""
    code = (
        "from nctakt.lists.format import controller_numbers as c; import nctakt;"
        "from nctakt import Controller; Controller(); print(c.all_numbers.cache_info().misses)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "0\n"
