# SPDX-License-Identifier: MIT
"""Messages about the use of a controller from Python."""

from __future__ import annotations

from nctakt.messages.catalogue import error

CONTROLLER_IS_BUSY = error(
    901005,
    en="the controller is running already: it cannot be run, stepped or reset by a second caller",
    de="die Steuerung läuft schon: ein zweiter Aufrufer kann sie weder laufen lassen noch "
    "zurücksetzen",
    remedy_en="Give each thread a controller of its own; a PLC uses the hli that it is given.",
    remedy_de="Jedem Thread eine eigene Steuerung geben; eine SPS benutzt ihr hli.",
    cause_en="Controllers do not know of each other, and any number may run beside each other.",
    cause_de="Steuerungen wissen nichts voneinander; beliebig viele laufen nebeneinander.",
)
