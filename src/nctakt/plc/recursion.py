# SPDX-License-Identifier: MIT
"""How deep plain Python may call: trees of code call several functions for each of their calls."""

from __future__ import annotations

import sys

#: Calls of Python for the deepest calls of a PLC (ST-407).
_DEPTH = 20_000


def allow_depth() -> None:
    """Let trees that run as plain Python nest as deep as compiled ones."""
    sys.setrecursionlimit(max(sys.getrecursionlimit(), _DEPTH))
