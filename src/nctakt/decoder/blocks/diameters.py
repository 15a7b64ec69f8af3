# SPDX-License-Identifier: MIT
"""Diameter programming of the face axis (G51)."""

from __future__ import annotations

from nctakt.decoder.values.variables import Values


def radius_of(values: Values, axis: int, value: float) -> float:
    """Return a programmed value of an axis, half of it if it is a diameter (G51, G90)."""
    state = values.state
    is_diameter = state.path.has_diameters and state.absolute
    is_diameter = is_diameter and state.path.turning_plane is None
    return 0.5 * value if is_diameter and values.environment.axes[axis].is_face else value
