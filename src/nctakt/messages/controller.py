# SPDX-License-Identifier: MIT
"""Messages about the use of a controller from Python."""

from __future__ import annotations

from nctakt.messages.catalogue import error

CONTROLLER_IS_BUSY = error(
    901005,
    en="another thread is running the controller: it can be run, stepped or reset by one only",
    de="ein anderer Thread lässt die Steuerung laufen: nur einer kann sie bedienen",
    remedy_en="Give each thread a controller of its own.",
    remedy_de="Jedem Thread eine eigene Steuerung geben.",
    cause_en="Controllers do not know of each other, and any number may run beside each other.",
    cause_de="Steuerungen wissen nichts voneinander; beliebig viele laufen nebeneinander.",
)
