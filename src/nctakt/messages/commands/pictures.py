# SPDX-License-Identifier: MIT
"""Messages about pictures of runs and about traces for other viewers."""

from __future__ import annotations

from nctakt.messages.catalogue import error

WRONG_SUFFIX = error(
    901090,
    en="{file}: a file of {option} must end in {suffix}",
    de="{file}: eine Datei von {option} muss auf {suffix} enden",
    remedy_en="Change the suffix.",
    remedy_de="Die Endung ändern.",
    suffix=("the suffix", "die Endung"),
)
RUN_NOT_RECORDED = error(
    901091,
    en="the run has no trace in memory, so there is nothing to draw",
    de="der Lauf hat keine Aufzeichnung im Speicher, also gibt es nichts zu zeichnen",
    remedy_en="Run with memory_trace=True, which is the default.",
    remedy_de="Mit memory_trace=True laufen lassen; das ist die Voreinstellung.",
)
SIGNAL_NOT_RECORDED = error(
    901092,
    en="the run has not recorded the signal {name}",
    de="der Lauf hat das Signal {name} nicht aufgezeichnet",
    remedy_en="Record it, too: Controller.run(…, signals=[…]).",
    remedy_de="Es mit aufzeichnen: Controller.run(…, signals=[…]).",
    name=("the signal", "das Signal"),
)
