# SPDX-License-Identifier: MIT
"""Where a process of pytest keeps the notes that tell on which machines its tests ran."""

from __future__ import annotations

import pytest

MACHINES_TOLD = pytest.StashKey[dict[str, None]]()
