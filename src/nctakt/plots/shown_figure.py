# SPDX-License-Identifier: MIT
"""A figure of matplotlib that notebooks show without its interface for plots (extra ``plot``)."""

from __future__ import annotations

from matplotlib.figure import Figure

from nctakt.plots.picture import picture_of


class ShownFigure(Figure):
    """A figure that a notebook shows as the value of a cell."""

    def _repr_png_(self) -> bytes:
        """Return its picture."""
        return picture_of(self, "png")
