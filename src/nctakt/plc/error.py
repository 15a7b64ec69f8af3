# SPDX-License-Identifier: MIT
"""The failure of a user's PLC."""

from __future__ import annotations

from nctakt.base.failure import Failure


class PlcError(Failure):
    """The user's PLC cannot be loaded, or failed while it ran."""
