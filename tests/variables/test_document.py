# SPDX-License-Identifier: MIT
"""docs/variables.md says what is so."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nctakt.messages.catalogue import messages_of

TEXT = (Path(__file__).parents[2] / "docs" / "variables.md").read_text("utf-8")


def test_its_example_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """The Python in it prints the value that was written into the memory."""
    (code,) = re.findall(r"```python\n(.*?)```", TEXT, flags=re.DOTALL)
    exec(compile(code, "docs/variables.md", "exec"), {})
    assert capsys.readouterr().out == "2.5\n"


def test_its_numbers_exist() -> None:
    """Each number in brackets is one of the catalogue."""
    numbers = [int(number) for number in re.findall(r"\((\d{5,6})\)", TEXT)]
    assert len(numbers) > 4
    assert [number for number in numbers if not messages_of(number)] == []
