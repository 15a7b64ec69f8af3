# SPDX-License-Identifier: MIT
"""Kinds of lists that are read and checked, all without an effect."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable


def _schema(kind: str, en: str, de: str) -> Schema:
    return Schema(kind, Text(en, de), ListDialect(), (), ParameterTable(f"{kind}.tsv"))


AXIS_COMPENSATION = _schema(
    "axis_compensation", "List of axis compensations", "Liste der Achskompensationen"
)
VOLUMETRIC_COMPENSATION = _schema(
    "volumetric_compensation",
    "List of a volumetric compensation",
    "Liste einer volumetrischen Kompensation",
)
MANUAL_MODE = _schema("manual_mode", "Manual mode list", "Handbetriebsliste")
SCENE = _schema("scene", "List of a scene with its collisions", "Liste einer Szene mit Kollisionen")
HARDWARE = _schema("hardware", "Hardware list", "Hardwareliste")
LIST_DESCRIPTION = _schema(
    "list_description", "Description of a technology list", "Beschreibung einer Technologieliste"
)
