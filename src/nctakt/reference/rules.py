# SPDX-License-Identifier: MIT
"""Articles about the rules of realtime cycles (RC) and of Structured Text (ST).

In: ``rules.tsv``, a line for each rule. Out: articles by the numbers that documents and tests cite.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from nctakt.base.diagnostics import Text
from nctakt.reference.article import Article, Topic, fact

_KINDS = {
    "RC": Text("rule of realtime cycles", "Regel der Echtzeit-Zyklen"),
    "ST": Text("rule of Structured Text", "Regel für Strukturierten Text"),
}
_NUMBER = re.compile(r"(RC|ST)[- ]?([0-9]{1,4})", re.IGNORECASE)


def _read() -> dict[str, Text]:
    lines = (Path(__file__).parent / "rules.tsv").read_text("utf-8").splitlines()
    rows = (line.split("\t") for line in lines[2:])
    return {rule: Text(en, de) for rule, en, de in rows}


#: The content of each rule, in a line.
RULES = _read()


def rule_name(family: str, number: int) -> str:
    """Return the name of a rule, such as ``RC-001`` of ``RC`` and 1."""
    return f"{family}-{number:03}"


def _article(rule: str) -> Article:
    proof = fact("Tests", "Tests", "docs/rules.md")
    decisions = fact("Decisions", "Entscheidungen", "docs/conformance/index.md")
    return Article(rule, _KINDS[rule[:2]], RULES[rule], (proof, decisions))


def _all() -> Iterator[Article]:
    return map(_article, RULES)


def _find(word: str) -> tuple[Article, ...]:
    match = _NUMBER.fullmatch(word)
    rule = "" if match is None else rule_name(match[1].upper(), int(match[2]))
    return (_article(rule),) if rule in RULES else ()


RULES_TOPIC = Topic(
    "rules",
    Text("Rules", "Regeln"),
    ("RC-105", "ST-701"),
    _all,
    _find,
    lambda: iter(RULES),
)
