# SPDX-License-Identifier: MIT
"""The interface image between CNC and PLC (HLI): its values and their offsets, and ``attach``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.base.lazy_names import import_when_used

if TYPE_CHECKING:
    from nctakt.hli.connection import PlcConnection, attach

__all__ = ["PlcConnection", "attach"]

_MODULES = {
    "PlcConnection": "nctakt.hli.connection",
    "attach": "nctakt.hli.connection",
}

__getattr__ = import_when_used(globals(), _MODULES)
