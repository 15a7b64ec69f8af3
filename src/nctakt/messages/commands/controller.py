# SPDX-License-Identifier: MIT
"""Messages about the use of a controller from Python."""

from __future__ import annotations

from nctakt.messages.catalogue import error

CONTROLLER_IS_BUSY = error(
    901005,
    en="another thread is using the controller: only one can run, step or reset it at a time",
    de="ein anderer Thread benutzt die Steuerung: sie ausführen oder zurücksetzen kann immer nur "
    "einer",
    remedy_en="Use a separate controller in each thread.",
    remedy_de="Jedem Thread eine eigene Steuerung geben.",
    cause_en="Controllers are independent of each other, and any number of them may run at the "
    "same time.",
    cause_de="Steuerungen sind voneinander unabhängig; beliebig viele können gleichzeitig laufen.",
)
REUSE_WITH_SCHEDULE = error(
    902536,
    en="a controller with a schedule cannot be put back into its start-up state",
    de="eine Steuerung mit Ablaufplan kann nicht in den Zustand nach dem Hochlauf zurück",
    remedy_en="Create a new Controller for each run, or use a study with rtconf in its plan.",
    remedy_de="Für jeden Lauf einen neuen Controller anlegen oder eine Studie mit rtconf im Plan "
    "verwenden.",
)
