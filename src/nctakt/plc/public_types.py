# SPDX-License-Identifier: MIT
"""The types that users annotate in a PLC, by their public names.

``HliView``: the argument of a PLC in Python. ``Function``: an M, H or T function that waits for it.
``SpindleJob``: a job of a spindle that it turns.
"""

from __future__ import annotations

from nctakt.hli.plc_entries import SpindleEntry as SpindleJob
from nctakt.hli.plc_entries import TechnologyEntry as Function
from nctakt.run.plcs.plc_view import PlcView as HliView

__all__ = ["Function", "HliView", "SpindleJob"]
