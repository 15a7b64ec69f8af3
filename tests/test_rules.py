# SPDX-License-Identifier: MIT
"""Each rule of realtime cycles has its tests, and no test cites a rule that there is not."""

from __future__ import annotations

import pytest
from support.rules_and_tests import RULES, proofs, rules_in

TESTS_OF = proofs()


@pytest.mark.parametrize("rule", RULES)
def test_each_rule_has_a_test(rule: int) -> None:
    """At least one test cites it."""
    assert TESTS_OF[rule], f"RC-{rule:03}"


def test_each_rule_that_is_cited_exists() -> None:
    """A wrong number would prove nothing."""
    assert sorted(TESTS_OF.keys() - RULES.keys()) == []


def test_citations_are_read() -> None:
    """Alone, in rows, from one to another."""
    assert rules_in("RC-203") == {203}
    assert rules_in("(RC-203, RC-204): RC-111") == {111, 203, 204}
    assert rules_in("RC-105 … RC-107") == {105, 106, 107}
    assert rules_in("RC-001 … 003, 102, 201 … 202; 403") == {1, 2, 3, 102, 201, 202}
    assert rules_in("RC-207 and RC-307 speak of 50879") == {207, 307}
    assert rules_in("RC-307: 128, 255") == {307}
