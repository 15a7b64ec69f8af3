# SPDX-License-Identifier: MIT
"""The PLC: what runs on the other side of the HLI, in a file of the user's or another process."""

from __future__ import annotations

from nctakt.plc.loading import AnyPlc, PlcError, load_plc
from nctakt.plc.partner import PartnerPlc

__all__ = ["AnyPlc", "PartnerPlc", "PlcError", "load_plc"]
