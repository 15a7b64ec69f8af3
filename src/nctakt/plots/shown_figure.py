# SPDX-License-Identifier: MIT
"""A figure of matplotlib that notebooks show without its interface for plots (extra ``plot``)."""

from __future__ import annotations

from matplotlib.figure import Figure

from nctakt.base.diagnostics import Language
from nctakt.plots.picture import Sheet, new_sheet, picture_of
from nctakt.plots.scene import Scene


class ShownFigure(Figure):
    """A figure that a notebook shows as the value of a cell."""

    def _repr_png_(self) -> bytes:
        """Return its picture."""
        return picture_of(self, "png")


def figure_of(scene: Scene, language: Language) -> Figure:
    """Return a run as a figure that notebooks show."""
    sheet = Sheet(scene, language)
    figure: Figure
    with new_sheet(sheet.height_in, ShownFigure) as figure:
        sheet.draw(figure)
    return figure
