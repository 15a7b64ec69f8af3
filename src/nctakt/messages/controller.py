# SPDX-License-Identifier: MIT
"""Messages about the use of a controller from Python."""

from __future__ import annotations

from nctakt.messages.catalogue import error

CONTROLLER_IS_BUSY = error(
    901005,
    en="another thread is using the controller: only one can run, step or reset it at a time",
    de="ein anderer Thread benutzt die Steuerung: bedienen kann sie immer nur einer",
    remedy_en="Give each thread a controller of its own.",
    remedy_de="Jedem Thread eine eigene Steuerung geben.",
    cause_en="Controllers are independent of each other, and any number of them may run at the "
    "same time.",
    cause_de="Steuerungen sind voneinander unabhängig; beliebig viele können gleichzeitig laufen.",
)
