# SPDX-License-Identifier: MIT
"""The arithmetic compiled and as plain Python: two processes, the same bits."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from support import arithmetic_table

SCRIPT = Path(arithmetic_table.__file__)


def results(plain: bool) -> dict[str, Any]:
    """The table of another process."""
    environment = {name: value for name, value in os.environ.items() if name != "NCTAKT_PLAIN"}
    if plain:
        environment["NCTAKT_PLAIN"] = "1"
    done = subprocess.run(
        [sys.executable, SCRIPT], env=environment, check=True, capture_output=True, text=True
    )
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def test_every_result_has_the_same_bits_compiled_and_plain() -> None:
    """No operation depends on the mode, not even in its zeros (NaN counts as one value)."""
    plain, usual = results(True), results(False)
    assert plain["compiled"] is False
    for name, bits in plain["table"].items():
        assert usual["table"][name] == bits, name


def test_every_function_is_in_the_table() -> None:
    """A new function of the arithmetic is compared as well."""
    table = arithmetic_table
    known = {*table.UNARY, *table.BINARY, *table.TERNARY}
    public = {
        name
        for name in dir(arithmetic_table.arithmetic)
        if not name.startswith("_") and name.islower() and name not in ("math", "annotations")
    }
    assert public == known
