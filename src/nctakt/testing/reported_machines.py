# SPDX-License-Identifier: MIT
"""The key under which a process of pytest keeps the notes on the machines of its tests."""

from __future__ import annotations

import pytest

REPORTED_MACHINES = pytest.StashKey[dict[str, None]]()
