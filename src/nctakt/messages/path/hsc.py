# SPDX-License-Identifier: MIT
"""Messages about ``#HSC``."""

from __future__ import annotations

from nctakt.messages.catalogue import error

HSC_MODE_WHILE_ON = error(
    901625,
    en="the curve of #HSC cannot be changed while #HSC is on",
    de="die Kurve von #HSC kann nicht geändert werden, solange #HSC aktiv ist",
    remedy_en="Program #HSC OFF before it.",
    remedy_de="Davor #HSC OFF programmieren.",
)
INVALID_HSC_VALUE = error(
    901626,
    en="{word} of #HSC cannot be {value}",
    de="{word} von #HSC kann nicht {value} sein",
    remedy_en="Write 1 or 2 for OPMODE, otherwise 0 or more.",
    remedy_de="Für OPMODE 1 oder 2 schreiben, sonst mindestens 0.",
)
