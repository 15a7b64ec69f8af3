# SPDX-License-Identifier: MIT
"""The Python of README, documents and examples passes ``mypy --strict``."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent

#: Pages each of whose examples goes on where the one before it has stopped.
_GO_ON = ("ads-handshakes",)

_FENCE = re.compile(r"^```python[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
_IMPORT = re.compile(r"^(?:import|from) .*\n", re.MULTILINE)


def examples() -> Iterator[tuple[str, str]]:
    """Yield name and text of each example; later ones of a page have its imports so far.

    Those of a page on which they go on have all that comes before them.
    """
    for page in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))):
        before = ""
        for match in _FENCE.finditer(text := page.read_text("utf-8")):
            line = text[: match.start()].count("\n") + 1
            yield f"{page.stem}_{line}".replace("-", "_"), before + match[1]
            goes_on = page.stem in _GO_ON
            before += match[1] if goes_on else "".join(_IMPORT.findall(match[1]))
    for file in sorted((ROOT / "examples").rglob("*.py")):
        name = "_".join(file.relative_to(ROOT).with_suffix("").parts)
        yield name, file.read_text("utf-8")


@pytest.mark.nightly
def test_examples_have_no_mistake_in_their_types(tmp_path: Path) -> None:
    """Each file by itself, with the settings of the project."""
    found = list(examples())
    assert len(found) > 25
    for name, text in found:
        (tmp_path / f"{name}.py").write_text(text, "utf-8")
    files = sorted(map(str, tmp_path.glob("*.py")))
    command = [sys.executable, "-m", "mypy", *files]
    done = subprocess.run(command, cwd=ROOT, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
