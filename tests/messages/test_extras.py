# SPDX-License-Identifier: MIT
"""Remedies for missing libraries: they work in any folder, and name what pyproject.toml names."""

from __future__ import annotations

import re
import shlex
import tomllib
from pathlib import Path

import pytest

from nctakt.messages.catalogue import catalogue
from nctakt.messages.extras import install_command

PROJECT = Path(__file__).parents[2] / "pyproject.toml"
EXTRAS = tomllib.loads(PROJECT.read_text("utf-8"))["project"]["optional-dependencies"]


@pytest.mark.parametrize("extra", sorted(EXTRAS.keys() - {"all", "docs", "test"}))
def test_the_command_names_the_libraries_of_the_extra(extra: str) -> None:
    """It names those of pyproject.toml."""
    assert shlex.split(install_command(extra)) == ["pip", "install", *EXTRAS[extra]]


def test_all_has_each_extra_of_users() -> None:
    """``all`` leads to all that remedies name; ``test`` needs nothing of users twice."""
    (all_,) = EXTRAS["all"]
    users = sorted(EXTRAS.keys() - {"all", "docs", "test"})
    assert all_ == f"nctakt[{','.join(users)}]"
    assert "nctakt[all,docs]" in EXTRAS["test"]


def test_no_remedy_needs_a_checkout() -> None:
    """Each names libraries, never a folder or nctakt itself, which would be built again."""
    reported = [
        (message.id, text)
        for message in catalogue()
        for text in (message.remedy.en, message.remedy.de)
        if "pip install" in text
    ]
    assert len(reported) >= 14  # seven messages in both languages; two more name it by {install}
    for number, text in reported:
        words = shlex.split(text.partition("pip install")[2])
        assert all(re.fullmatch(r"[A-Za-z][\w-]+[<>=][\d.,<>=]+", word) for word in words), number
