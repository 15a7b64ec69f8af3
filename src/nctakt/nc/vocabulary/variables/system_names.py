# SPDX-License-Identifier: MIT
"""The controller's data that programs may use by V.G and V.A: names, types, rights, meanings.

One row each; ``system_variables.py`` finds them in the tree, the decoder gives their values,
``nctakt explain`` shows them. ``<X>`` is an axis of the channel, or its index ``[0]``. All are read
when the block is decoded; those that ``wait`` empty the channel first, since they show the present.
"""

from __future__ import annotations

from typing import NamedTuple

from nctakt.base.diagnostics import Text


class SystemRow(NamedTuple):
    """One variable: ``family`` G or A, ``path`` without family and axis; ``unit`` mm: also
    degrees or inch; ``elements``: how many it has, 0 for a single value.
    """

    family: str
    path: str
    type: str
    unit: str
    meaning: Text
    has_axis: bool = False
    is_writable: bool = False
    waits: bool = False
    elements: int = 0

    @property
    def name(self) -> str:
        """The name in documents: ``V.A.ABS.X``."""
        element = "[0]" if self.elements else ""
        return f"V.{self.family}.{self.path}{element}" + (".X" if self.has_axis else "")


def _axis(path: str, en: str, de: str, *, unit: str = "mm", waits: bool = False) -> SystemRow:
    return SystemRow("A", path, "REAL64", unit, Text(en, de), has_axis=True, waits=waits)


def _channel(path: str, type_: str, unit: str, en: str, de: str) -> SystemRow:
    return SystemRow("G", path, type_, unit, Text(en, de))


ROWS = (
    _axis(
        "ABS",
        "end of the block before, with all offsets, in the active coordinate system",
        "Ende des vorigen Satzes, mit allen Verschiebungen, im aktiven Koordinatensystem",
    ),
    _axis(
        "PROG",
        "end of the block before as it was programmed, without offsets",
        "Ende des vorigen Satzes wie programmiert, ohne Verschiebungen",
    ),
    _axis(
        "MENT",
        "as V.A.PROG, before mirroring",
        "wie V.A.PROG, vor einer Spiegelung",
    ),
    _axis(
        "ACT_POS",
        "measured position in the active coordinate system, without offsets of the program",
        "gemessene Position im aktiven Koordinatensystem, ohne Verschiebungen des Programms",
        waits=True,
    ),
    _axis(
        "ACS.ABS",
        "measured position of the axis itself",
        "gemessene Position der Achse selbst",
        waits=True,
    ),
    _axis("+SWE", "positive software limit in force", "wirksamer positiver Software-Endschalter"),
    _axis("-SWE", "negative software limit in force", "wirksamer negativer Software-Endschalter"),
    _axis("+SWE_MDS", "positive software limit of the list", "positiver Endschalter der Liste"),
    _axis("-SWE_MDS", "negative software limit of the list", "negativer Endschalter der Liste"),
    _axis("BZP", "reference point offset (G92)", "Bezugspunktverschiebung (G92)"),
    _axis("PZV", "clamp offset", "Platzversatz"),
    _axis(
        "MODULO_VALUE",
        "range of a modulo axis, 0 of any other",
        "Bereich einer Moduloachse, 0 bei anderen",
    ),
    _axis("MESS", "measured position (G100), with all offsets", "Messwert, mit Verschiebungen"),
    _axis("MOFFS", "measured position less the target of G100", "Messwert minus Ziel von G100"),
    _axis("MEIN", "measuring offset that G101 has included", "durch G101 eingerechneter Versatz"),
    _axis("MEAS.ACS.VALUE", "measured position of the axis itself", "Messwert der Achse selbst"),
    _axis("MEAS.PCS.VALUE", "measured position as programmed", "Messwert, wie programmiert"),
    SystemRow(
        "A",
        "MERF",
        "BOOLEAN",
        "",
        Text("whether the probe has touched (G100)", "ob der Taster geschaltet hat (G100)"),
        has_axis=True,
    ),
    _axis("REF", "reference position of the last G74", "Referenzposition des letzten G74"),
    SystemRow(
        "A",
        "RERF",
        "BOOLEAN",
        "",
        Text("whether the axis was homed (G74)", "ob die Achse referenziert ist (G74)"),
        has_axis=True,
    ),
    _channel("MEAS_TYPE", "UNS16", "", "active measuring type", "wirksamer Messtyp"),
    SystemRow(
        "A",
        "WCS",
        "REAL64",
        "mm",
        Text(
            "programmed position that #WCS TO MCS converts, result of #MCS TO WCS",
            "programmierte Position, die #WCS TO MCS umrechnet, Ergebnis von #MCS TO WCS",
        ),
        has_axis=True,
        is_writable=True,
    ),
    SystemRow(
        "A",
        "MCS",
        "REAL64",
        "mm",
        Text(
            "position of the axis that #MCS TO WCS converts, result of #WCS TO MCS",
            "Achsposition, die #MCS TO WCS umrechnet, Ergebnis von #WCS TO MCS",
        ),
        has_axis=True,
        is_writable=True,
    ),
    _channel("ROT_ACTIVE", "BOOLEAN", "", "whether the contour is rotated", "Kontur gedreht"),
    _channel("ROT_ANGLE", "REAL64", "°", "angle of the rotation", "Winkel der Konturdrehung"),
    _channel("ROT_CENTER1", "REAL64", "mm", "centre, first axis", "Drehpunkt, erste Achse"),
    _channel("ROT_CENTER2", "REAL64", "mm", "centre, second axis", "Drehpunkt, zweite Achse"),
    _channel(
        "AX_LINK.NR",
        "UNS32",
        "",
        "the coupling group that is active, or that was active last",
        "die aktive oder zuletzt aktive Kopplungsgruppe",
    ),
    _channel(
        "AX_LINK.ACTIVE", "BOOLEAN", "", "whether axes are coupled", "ob Achsen gekoppelt sind"
    ),
    _channel("BLOCK_NR", "UNS32", "", "the last programmed N", "das letzte programmierte N"),
    _channel("SATZ_NR", "UNS32", "", "old name of V.G.BLOCK_NR", "alter Name von V.G.BLOCK_NR"),
    _channel(
        "PROG_NR",
        "UNS32",
        "",
        "name of the main program if it is a number, else 0",
        "Name des Hauptprogramms, wenn er eine Zahl ist, sonst 0",
    ),
    _channel("I", "REAL64", "mm", "I of the last arc", "I des letzten Kreises"),
    _channel("J", "REAL64", "mm", "J of the last arc", "J des letzten Kreises"),
    _channel("K", "REAL64", "mm", "K of the last arc", "K des letzten Kreises"),
    _channel("R", "REAL64", "mm", "radius of the last arc", "Radius des letzten Kreises"),
    SystemRow(
        "G",
        "MERR",
        "REAL64",
        "mm",
        Text("how far the last centre was moved", "Korrektur des letzten Mittelpunkts"),
        elements=2,
    ),
    SystemRow(
        "G",
        "SELECTED_CS.TRANS",
        "REAL64",
        "mm",
        Text("shift of the active system", "Verschiebung des aktiven Systems"),
        has_axis=True,
    ),
    SystemRow(
        "A",
        "MODE",
        "UNS32",
        "",
        Text("mode of the axis (P-AXIS-00015)", "Betriebsart der Achse (P-AXIS-00015)"),
        has_axis=True,
    ),
    _axis("SOFFS", "way of manual mode beside the path", "Handweg neben der Bahn"),
    _channel("MASS_MM", "BOOLEAN", "", "lengths: 0 in mm, 1 in inch", "Längen: 0 mm, 1 Zoll"),
    _channel("MASS_360", "BOOLEAN", "", "angles: 0, in degrees", "Winkel: 0, in Grad"),
    _channel(
        "FEEDRATE", "REAL64", "as F", "the last F of the active kind", "letztes F der aktiven Art"
    ),
    _channel(
        "FEEDRATE_MODE",
        "UNS16",
        "",
        "93, 94, 95, 194: what F is",
        "93, 94, 95, 194: was F bedeutet",
    ),
    _channel(
        "FEEDRATE_SCALE",
        "REAL64",
        "",
        "mm per minute in an F of 1 (P-CHAN-00108)",
        "mm je Minute bei F1 (P-CHAN-00108)",
    ),
    _channel(
        "SIGNAL_READ",
        "BOOLEAN",
        "",
        "whether the last #SIGNAL READ has taken a signal",
        "ob das letzte #SIGNAL READ ein Signal abgeholt hat",
    ),
    SystemRow(
        "G",
        "NP_DEFAULT",
        "UNS16",
        "",
        Text(
            "zero offset with which programs begin",
            "Nullpunktverschiebung, mit der Programme beginnen",
        ),
        is_writable=True,
    ),
    SystemRow(
        "G",
        "NP_AKT.V",
        "REAL64",
        "mm",
        Text("active zero offset of an axis", "aktive Nullpunktverschiebung einer Achse"),
        has_axis=True,
        is_writable=True,
    ),
    SystemRow(
        "G",
        "NP[1].V",
        "REAL64",
        "mm",
        Text(
            "zero offset 1 (G54) of an axis, in the list",
            "Nullpunktverschiebung 1 (G54) einer Achse, in der Liste",
        ),
        has_axis=True,
        is_writable=True,
    ),
)

#: The rows by family and path.
BY_PATH = {(row.family, row.path): row for row in ROWS}

#: The rows by their names.
BY_NAME = {row.name: row for row in ROWS}
