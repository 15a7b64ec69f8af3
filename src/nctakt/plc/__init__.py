# SPDX-License-Identifier: MIT
"""The PLC on the other side of the HLI: a class in a user's file, or another process."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.base.lazy_names import import_when_used

if TYPE_CHECKING:
    from nctakt.plc.axes import (
        CURRENT,
        NEGATIVE,
        POSITIVE,
        SHORTEST,
        MC_Halt,
        MC_MoveAbsolute,
        MC_MoveRelative,
        MC_MoveVelocity,
        MC_Reset,
    )
    from nctakt.plc.error import PlcError
    from nctakt.plc.loading import load_plc
    from nctakt.plc.partner import PartnerPlc
    from nctakt.plc.policies import ALL, NONE, Policy, SpindlePolicy, after, only, run_up
    from nctakt.plc.script import Plc, at, on, when
    from nctakt.run.plcs.plc_view import AnyPlc

__all__ = [
    "ALL",
    "CURRENT",
    "NEGATIVE",
    "NONE",
    "POSITIVE",
    "SHORTEST",
    "AnyPlc",
    "MC_Halt",
    "MC_MoveAbsolute",
    "MC_MoveRelative",
    "MC_MoveVelocity",
    "MC_Reset",
    "PartnerPlc",
    "Plc",
    "PlcError",
    "Policy",
    "SpindlePolicy",
    "after",
    "at",
    "load_plc",
    "on",
    "only",
    "run_up",
    "when",
]

#: The module of each name: a run without a PLC imports none of them.
_MODULES = {
    "ALL": "nctakt.plc.policies",
    "CURRENT": "nctakt.plc.axes",
    "NEGATIVE": "nctakt.plc.axes",
    "NONE": "nctakt.plc.policies",
    "POSITIVE": "nctakt.plc.axes",
    "SHORTEST": "nctakt.plc.axes",
    "AnyPlc": "nctakt.run.plcs.plc_view",
    "MC_Halt": "nctakt.plc.axes",
    "MC_MoveAbsolute": "nctakt.plc.axes",
    "MC_MoveRelative": "nctakt.plc.axes",
    "MC_MoveVelocity": "nctakt.plc.axes",
    "MC_Reset": "nctakt.plc.axes",
    "PartnerPlc": "nctakt.plc.partner",
    "Plc": "nctakt.plc.script",
    "PlcError": "nctakt.plc.error",
    "Policy": "nctakt.plc.policies",
    "SpindlePolicy": "nctakt.plc.policies",
    "after": "nctakt.plc.policies",
    "at": "nctakt.plc.script",
    "load_plc": "nctakt.plc.loading",
    "on": "nctakt.plc.script",
    "only": "nctakt.plc.policies",
    "run_up": "nctakt.plc.policies",
    "when": "nctakt.plc.script",
}

__getattr__ = import_when_used(globals(), _MODULES)
