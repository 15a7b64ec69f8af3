# SPDX-License-Identifier: MIT
"""The demo machine with other lists."""

from __future__ import annotations

import shutil
from pathlib import Path

import nctakt

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


def machine_with(folder: Path, **lists: str) -> Path:
    """The demo machine with further lines at the beginning of some of its lists."""
    shutil.copytree(DEMO, folder)
    for name, lines in lists.items():
        file = folder / f"{name}.lis"
        file.write_text(lines + "\n" + file.read_text("utf-8"), "utf-8")
    return folder
