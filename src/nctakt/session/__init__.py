# SPDX-License-Identifier: MIT
"""An interactive run: on any clock, with stops, forward and back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.base.lazy_names import import_when_used

if TYPE_CHECKING:
    from nctakt.session.session import Session
    from nctakt.session.stops import StopAt

__all__ = ["Session", "StopAt"]

_MODULES = {
    "Session": "nctakt.session.session",
    "StopAt": "nctakt.session.stops",
}

__getattr__ = import_when_used(globals(), _MODULES)
