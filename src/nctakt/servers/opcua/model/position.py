# SPDX-License-Identifier: MIT
"""The structure of positions as the library writes and reads it."""

from __future__ import annotations

from dataclasses import dataclass

from asyncua import ua

from nctakt.servers.opcua.model.companion import POSITION, POSITION_BINARY


@dataclass
class CncPositionDataType:
    """A position: actual, command, distance to go."""

    ActPos: ua.Double = 0.0
    CmdPos: ua.Double = 0.0
    RemDist: ua.Double = 0.0


def register_position(index: int) -> None:
    """Register the structure with the library in the namespace ``index``."""
    CncPositionDataType.data_type = ua.NodeId(POSITION, index)  # type: ignore[attr-defined]
    ua.register_extension_object(
        "CncPositionDataType",
        ua.NodeId(POSITION_BINARY, index),
        CncPositionDataType,
        ua.NodeId(POSITION, index),
    )
