# SPDX-License-Identifier: MIT
"""Articles of the interface and of the rules in German."""

from __future__ import annotations

import re

import pytest

from nctakt.hli.layout import STRUCTURES
from nctakt.reference.interface import HLI
from nctakt.reference.interface_german import GERMAN
from nctakt.reference.rules import RULES, RULES_TOPIC

#: Numbers and names, which both languages have in common.
_FIXED = re.compile(r"[0-9]{3,}|[PMV]-[A-Z]+-[0-9]+|`[^`]+`|\$[A-Z]+|#[A-Z]+|V\.[A-Z]+")


def test_each_value_of_the_interface_has_a_german_meaning() -> None:
    """Of each structure and value, and of nothing else."""
    names = [one.name for one in STRUCTURES]
    names += [f"{one.name}.{entry.name}" for one in STRUCTURES for entry in one.entries]
    assert sorted(GERMAN) == sorted(names)


@pytest.mark.parametrize("topic", [HLI, RULES_TOPIC], ids=["interface", "rules"])
def test_both_languages_name_the_same_things(topic: object) -> None:
    """Numbers, parameters and names are those of the English text; the words are not."""
    for article in topic.articles():  # type: ignore[attr-defined]
        english, german = article.meaning.get("en"), article.meaning.get("de")
        assert sorted(_FIXED.findall(english)) == sorted(_FIXED.findall(german)), article.name
    equal = [rule for rule, text in RULES.items() if text.en == text.de]  # names of blocks
    assert [rule for rule in equal if RULES[rule].en != RULES[rule].en.upper()] == []
