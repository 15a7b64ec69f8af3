# SPDX-License-Identifier: MIT
"""A fixture that runs the script of an editor; without the libraries its tests are skipped."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest


@pytest.fixture
def in_editor(tmp_path: Path) -> Callable[..., None]:
    """Run a script of an editor with its own server."""
    client = pytest.importorskip("support.editor_client")

    def run(script: Any, options: Any = None, encodings: Any = None) -> None:
        kinds = encodings or [client.types.PositionEncodingKind.Utf16]
        asyncio.run(client.with_editor(script, tmp_path, options, kinds))

    return run
