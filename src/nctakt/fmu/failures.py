# SPDX-License-Identifier: MIT
"""The failure of an FMU, and its library where it is used."""

from __future__ import annotations

from typing import Any

from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import FMU_LIBRARY_MISSING
from nctakt.plc.error import PlcError


class FmuError(PlcError):
    """An FMU cannot be loaded, or failed while it ran."""


def fmpy() -> Any:
    """Return FMPy; raises ``FmuError`` (902600) without it."""
    try:
        import fmpy.fmi2  # noqa: PLC0415 - an extra
        import fmpy.fmi3  # noqa: PLC0415
        import fmpy.model_description  # noqa: PLC0415
    except ImportError as error:
        raise FmuError(diagnostic(FMU_LIBRARY_MISSING)) from error
    return fmpy
