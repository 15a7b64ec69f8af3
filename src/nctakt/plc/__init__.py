# SPDX-License-Identifier: MIT
"""The PLC: what runs on the other side of the HLI, in a file of the user's or another process."""

from __future__ import annotations

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
from nctakt.plc.loading import PlcError, load_plc
from nctakt.plc.partner import PartnerPlc
from nctakt.plc.policies import ALL, NONE, Policy, SpindlePolicy, after, only, run_up
from nctakt.plc.script import Plc, at, on, when
from nctakt.run.plc_view import AnyPlc

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
