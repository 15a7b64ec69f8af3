# SPDX-License-Identifier: MIT
"""How corners are rounded: the modes of ``#CONTOUR MODE`` with their sizes and actions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from nctakt.base.dataclass import dataclass, field
from nctakt.decoder.state.path_limits import MAX_BEND, LimitState
from nctakt.nc.vocabulary.path_keywords import INTER_ACTION

#: Default of deviations and distances, mm.
DEVIATION_MM = 1.0

#: The largest part of a motion that a curve uses at one corner.
MAX_PART = 0.499

#: Used in place of a distance of 0 if the curve has a given interim point, mm.
NO_DISTANCE_MM = 1e-9


class ContourForm(NamedTuple):
    """The form of the curve at one corner.

    ``is_own``: the realtime part cannot round like this; it would with ``plain_deviation``.
    ``deviation`` in mm, 0: ``distances`` from the corner say where the curve begins and ends.
    ``point``: the interim point by axis, mm. ``action``: when M and H functions act. ``part`` of a
    motion that the curve takes at most; ``max_bend``: the largest change of direction.
    """

    is_own: bool
    plain_deviation: float
    deviation: float
    distances: tuple[float, float]
    point: Mapping[int, float]
    action: str
    part: float
    max_bend: float


@dataclass(slots=True)
class ContourState:
    """The mode of ``#CONTOUR MODE`` and its sizes in mm, by keyword.

    ``max_bend``: the largest change of direction that is rounded (``path_limits.py``). ``point``:
    the interim point of POS, positions by axis. ``action``: when M and H functions act.
    """

    mode: str = "DEV"
    max_bend: float = MAX_BEND
    point: dict[int, float] = field(default_factory=dict)
    action: str = INTER_ACTION
    sizes: dict[str, float] = field(
        default_factory=lambda: dict.fromkeys(
            ("PATH_DEV", "PATH_DIST", "SYM_DIST", "PRE_DIST", "POST_DIST"), DEVIATION_MM
        )
    )

    @property
    def is_own(self) -> bool:
        """Whether the decoder makes the curve of each corner (``shapes/contouring.py``)."""
        if self.mode == "POS" and self.point:
            return True
        sizes = self.sizes
        return self.mode in ("DIST", "POS") and sizes["PRE_DIST"] != sizes["POST_DIST"]

    @property
    def size(self) -> float:
        """The deviation at a corner; negative: the distance from it; 0: it stays sharp."""
        if self.is_own:
            return -max(self.sizes["PRE_DIST"], self.sizes["POST_DIST"], NO_DISTANCE_MM)
        return self._plain_size

    @property
    def _plain_size(self) -> float:
        """The same with equal distances from the corner, and without an interim point."""
        match self.mode:
            case "DIST" | "POS":
                return -min(self.sizes["PRE_DIST"], self.sizes["POST_DIST"])
            case "DIST_SOFT":
                return -max(self.sizes["PATH_DIST"], 0.0)
            case "DIST_MASTER":
                return -max(self.sizes["SYM_DIST"], 0.0)
        return self.sizes["PATH_DEV"]

    def form(self, limits: LimitState) -> ContourForm:
        """Return the curve of the next corner."""
        plain = self._plain_size
        distances = (-plain, -plain)
        if self.mode in ("DIST", "POS"):
            distances = (self.sizes["PRE_DIST"], self.sizes["POST_DIST"])
        return ContourForm(
            is_own=self.is_own,
            plain_deviation=plain,
            deviation=max(plain, 0.0),
            distances=distances,
            point=dict(self.point) if self.mode == "POS" else {},
            action=self.action,
            part=min(limits.rounded_part, MAX_PART),
            max_bend=self.max_bend,
        )
