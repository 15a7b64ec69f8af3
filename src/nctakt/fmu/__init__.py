# SPDX-License-Identifier: MIT
"""Simulation models as FMUs (FMI 2.0 and 3.0): a plant that is coupled to a run."""

from __future__ import annotations

from nctakt.fmu.coupled import Fmu
from nctakt.fmu.failures import FmuError

__all__ = ["Fmu", "FmuError"]
