# SPDX-License-Identifier: MIT
"""Behaviour of nctakt where public sources are silent; reported once per program."""

from __future__ import annotations

from nctakt.base.diagnostics import Text

#: How the feed of G193 and G293 changes over a block.
FEED_RAMP = Text(
    "F changes from the one before in up to 32 steps; at once with limited jerk and in contours",
    "F ändert sich ab dem vorigen in bis zu 32 Stufen; mit Ruckbegrenzung und in Konturen sofort",
)
CORNER_FEED = Text(
    "F falls in up to 32 steps before each block's end, not with limited jerk and in contours",
    "F fällt vor jedem Satzende in bis zu 32 Stufen, nicht mit Ruckbegrenzung und in Konturen",
)
AS_G900 = Text(
    "the path brakes before the block's end, as with G900",
    "die Bahn bremst wie bei G900 vor dem Satzende",
)
TANGENTIAL_ARC = Text(
    "the arc begins or ends beside the contour as with G138, at whatever corner",
    "der Bogen beginnt oder endet wie bei G138 neben der Kontur, an jeder Ecke",
)
AKIMA_CURVE = Text(
    "with the type AKIMA the curve is that of Akima (1970), axis by axis over the chords' length",
    "beim Typ AKIMA ist es die Kurve von Akima (1970), achsweise über der Länge der Sehnen",
)
BSPLINE_CURVE = Text(
    "the curve is cubic with uniform knots, from the first control point to the last one",
    "die Kurve ist kubisch mit gleichen Knotenabständen, vom ersten bis zum letzten Kontrollpunkt",
)
HSC_CONTOUR = Text(
    "the contour is the polygon, with corners rounded within PATH_DEV or CONTERROR",
    "die Kontur ist das Polygon mit Ecken, die innerhalb PATH_DEV oder CONTERROR verschliffen sind",
)
