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


@pytest.mark.parametrize("extra", sorted(EXTRAS.keys() - {"docs"}))
def test_the_command_names_the_libraries_of_the_extra(extra: str) -> None:
    """It names those of pyproject.toml; of the tests' extra only what runs tests."""
    expected = [one for one in EXTRAS[extra] if extra != "test" or one.startswith("pytest>=")]
    assert shlex.split(install_command(extra)) == ["pip", "install", *expected]


def test_no_remedy_needs_a_checkout() -> None:
    """Each names libraries, never a folder or nctakt itself, which would be built again."""
    told = [
        (message.id, text)
        for message in catalogue()
        for text in (message.remedy.en, message.remedy.de)
        if "pip install" in text
    ]
    assert len(told) >= 14  # seven messages in both languages; two more name it by {install}
    for number, text in told:
        words = shlex.split(text.partition("pip install")[2])
        assert all(re.fullmatch(r"[A-Za-z]\w+[<>=][\d.,<>=]+", word) for word in words), number
