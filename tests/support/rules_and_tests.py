# SPDX-License-Identifier: MIT
"""The rules of realtime cycles and of Structured Text, and which tests prove each of them.

In: what docstrings of tests, names of cases in tables of tests and READMEs of runs cite, as
``RC-203``, ``ST-701 … 703`` or ``RC-101 … RC-111, 201``. Out: the table in ``docs/rules.md``, which
``scripts/docs`` writes.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from nctakt.reference.rules import RULES, rule_name

TESTS = Path(__file__).parent.parent

#: Tests that are named of each rule; those of a whole run come first.
MAX_NAMED = 4

_CITED = re.compile(r"(RC|ST)-\d{3,4}(?:\s*(?:…|,|\band\b)\s*(?:\1-)?\d{3,4}(?!\d))*")
_STEP = re.compile(r"(…|,|and)?\s*(?:RC-|ST-)?(\d{3,4})")


def rules_in(text: str) -> set[str]:
    """The rules that a text cites; ``…`` joins all between."""
    found: set[str] = set()
    for match in _CITED.finditer(text):
        family, last = match[1], 0
        for join, number in _STEP.findall(match[0]):
            first = last if join == "…" else int(number)
            between = (rule_name(family, one) for one in range(first, int(number)))
            found.update(rule for rule in between if rule in RULES)
            found.add(rule_name(family, int(number)))
            last = int(number)
    return found


def citations() -> Iterator[tuple[str, set[str]]]:
    """Each test with the rules that it cites: folders of runs, then functions and cases."""
    for readme in sorted(TESTS.glob("runs/*/README.md")):
        name = readme.parent.name
        own = re.match(r"rc_(\d{3})", name)
        rules = {rule_name("RC", int(own[1]))} if own else set()
        yield f"tests/runs/{name}", rules | rules_in(readme.read_text("utf-8"))
    for path in sorted(TESTS.rglob("test_*.py")):
        text = path.read_text("utf-8")
        if not _CITED.search(text):
            continue
        file = path.relative_to(TESTS.parent).as_posix()
        for node in ast.parse(text).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                yield f"{file}::{node.name}", rules_in(ast.get_docstring(node) or "")
            elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Dict):
                for key in node.value.keys:
                    if isinstance(key, ast.Constant) and isinstance(key.value, str):
                        yield f"{file}[{key.value}]", rules_in(key.value)


def proofs() -> dict[str, list[str]]:
    """Rule -> the tests that cite it, the fittest first."""
    found: dict[str, list[str]] = {rule: [] for rule in RULES}
    for test, rules in citations():
        for rule in sorted(rules):
            found.setdefault(rule, []).append(test)
    for rule, tests in found.items():
        tests.sort(key=lambda test: rule.lower().replace("-", "_") not in test)
    return found


def table() -> Iterator[str]:
    """The document, line by line."""
    yield "# The rules of realtime cycles and of Structured Text, and their tests"
    yield ""
    yield "Written by `scripts/docs` from `tests/support/rules_and_tests.py` and what tests cite."
    yield f"Up to {MAX_NAMED} tests of each rule are named; `grep -r RC-203 tests` finds all."
    yield "What a rule leaves open, and what was decided, says [conformance](conformance/index.md)."
    yield ""
    yield "| rule | says | tests |"
    yield "|---|---|---|"
    found = proofs()
    for rule in RULES:
        named = ", ".join(f"`{test}`" for test in found[rule][:MAX_NAMED])
        yield f"| {rule} | {RULES[rule].en} | {named} |"
