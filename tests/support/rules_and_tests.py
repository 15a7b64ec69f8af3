# SPDX-License-Identifier: MIT
"""The rules of realtime cycles, and which tests prove each of them.

In: what docstrings of tests and READMEs of runs cite, as ``RC-203`` or ``RC-101 … RC-111, 201``.
Out: the table in ``docs/rules.md``, which ``scripts/docs`` writes.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from nctakt.reference.rules import RULES

TESTS = Path(__file__).parent.parent

#: Tests that are named of each rule; those of a whole run come first.
MAX_NAMED = 4

_CITED = re.compile(r"RC-\d{3}(?:\s*(?:…|,|\band\b)\s*(?:RC-)?\d{3}(?!\d))*")
_STEP = re.compile(r"(…|,|and)?\s*(?:RC-)?(\d{3})")


def rules_in(text: str) -> set[int]:
    """The numbers of the rules that a text cites; ``…`` joins all between."""
    found: set[int] = set()
    for cited in _CITED.findall(text):
        last = 0
        for join, number in _STEP.findall(cited):
            first = last if join == "…" else int(number)
            found.update(one for one in RULES if first <= one <= int(number))
            found.add(int(number))
            last = int(number)
    return found


def citations() -> Iterator[tuple[str, set[int]]]:
    """Each test with the rules that it cites: folders of runs, then functions, in their order."""
    for readme in sorted(TESTS.glob("runs/*/README.md")):
        name = readme.parent.name
        own = re.match(r"rc_(\d{3})", name)
        rules = rules_in(readme.read_text("utf-8")) | ({int(own[1])} if own else set())
        yield f"tests/runs/{name}", rules
    for path in sorted(TESTS.rglob("test_*.py")):
        file = path.relative_to(TESTS.parent).as_posix()
        for node in ast.parse(path.read_text("utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                yield f"{file}::{node.name}", rules_in(ast.get_docstring(node) or "")


def proofs() -> dict[int, list[str]]:
    """Rule -> the tests that cite it, the fittest first."""
    found: dict[int, list[str]] = {rule: [] for rule in RULES}
    for test, rules in citations():
        for rule in sorted(rules):
            found.setdefault(rule, []).append(test)
    for rule, tests in found.items():
        tests.sort(key=lambda test: f"rc_{rule:03}" not in test)
    return found


def table() -> Iterator[str]:
    """The document, line by line."""
    yield "# The rules of realtime cycles, and their tests"
    yield ""
    yield "Written by `scripts/docs` from `tests/support/rules_and_tests.py` and what tests cite."
    yield f"Up to {MAX_NAMED} tests of each rule are named; `grep -r RC-203 tests` finds all."
    yield "What a rule leaves open, and what was decided, says [conformance](conformance/index.md)."
    yield ""
    yield "| rule | says | tests |"
    yield "|---|---|---|"
    for rule, tests in sorted(proofs().items()):
        named = ", ".join(f"`{test}`" for test in tests[:MAX_NAMED])
        yield f"| RC-{rule:03} | {RULES[rule].en} | {named} |"
