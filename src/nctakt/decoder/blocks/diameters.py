# SPDX-License-Identifier: MIT
"""Diameter programming of the face axis (G51), as P-AXIS-00058 and P-AXIS-00059 allow it."""

from __future__ import annotations

from nctakt.base.diagnostics import Span
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.cutting import DIAMETERS_WITHOUT_EFFECT


def radius_of(values: Values, axis: int, value: float, *, is_absolute: bool) -> float:
    """Return a programmed position or way of an axis, half of it if it is a diameter."""
    path = values.state.path
    if not path.has_diameters or path.turning_plane is not None:
        return value
    listed = values.environment.axes[axis]
    is_diameter = listed.absolute_diameters if is_absolute else listed.relative_diameters
    return 0.5 * value if listed.is_face and is_diameter else value


def tell_effect(values: Values, span: Span) -> None:
    """Tell that G51 has no effect where the lists of all face axes say so."""
    face = [axis for axis in values.environment.axes if axis.is_face]
    if face and not any(axis.absolute_diameters or axis.relative_diameters for axis in face):
        values.warn(DIAMETERS_WITHOUT_EFFECT, span, axis=face[0].name)
