# SPDX-License-Identifier: MIT
"""Diameter programming of the face axis (G51), as P-AXIS-00058 and P-AXIS-00059 allow it."""

from __future__ import annotations

from nctakt.decoder.values.variables import Values


def radius_of(values: Values, axis: int, value: float, *, is_absolute: bool) -> float:
    """Return a programmed position or distance of an axis, halved if it is a diameter."""
    path = values.state.path
    if not path.has_diameters or path.turning_plane is not None:
        return value
    listed = values.environment.axes[axis]
    is_diameter = listed.absolute_diameters if is_absolute else listed.relative_diameters
    return 0.5 * value if listed.is_face and is_diameter else value
