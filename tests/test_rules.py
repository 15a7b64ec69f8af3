# SPDX-License-Identifier: MIT
"""Each rule (RC, ST) has its tests, and no test cites a rule that there is not."""

from __future__ import annotations

import pytest
from support.rules_and_tests import RULES, proofs, rules_in

TESTS_OF = proofs()


@pytest.mark.parametrize("rule", RULES)
def test_each_rule_has_a_test(rule: str) -> None:
    """At least one test cites it."""
    assert TESTS_OF[rule]


def test_each_rule_that_is_cited_exists() -> None:
    """A wrong number would prove nothing."""
    assert sorted(TESTS_OF.keys() - RULES.keys()) == []


def test_citations_are_read() -> None:
    """Alone, in rows, from one to another."""
    assert rules_in("RC-203") == {"RC-203"}
    assert rules_in("(RC-203, RC-204): RC-111") == {"RC-111", "RC-203", "RC-204"}
    assert rules_in("RC-105 … RC-107") == {"RC-105", "RC-106", "RC-107"}
    assert rules_in("RC-001 … 003, 102, 201 … 202; 403") == {
        *("RC-001", "RC-002", "RC-003", "RC-102", "RC-201", "RC-202")
    }
    assert rules_in("RC-207 and RC-307 speak of 50879") == {"RC-207", "RC-307"}
    assert rules_in("RC-307: 128, 255") == {"RC-307"}
    assert rules_in("ST-1001, ST-501 … 503") == {"ST-1001", "ST-501", "ST-502", "ST-503"}
    assert rules_in("ST-701, RC-203") == {"ST-701", "RC-203"}
