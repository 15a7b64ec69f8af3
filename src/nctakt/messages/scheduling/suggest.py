# SPDX-License-Identifier: MIT
"""Messages about suggestions for a scheduling list."""

from __future__ import annotations

from nctakt.messages.catalogue import error

NOTHING_SUGGESTED = error(
    900647,
    en="no values were found with which each thread has the slack that is asked for",
    de="es wurden keine Werte gefunden, mit denen jeder Thread die verlangte Reserve hat",
    remedy_en="Ask for less with --slack, allow more CPUs with --cpus, or shorten the functions.",
    remedy_de="Mit --slack weniger verlangen, mit --cpus mehr CPUs erlauben oder die Funktionen "
    "verkürzen.",
)
INVALID_SLACK = error(
    900648,
    en="'{text}' is not a slack",
    de="'{text}' ist keine Reserve",
    remedy_en="Write a percentage from 0 to below 100, alone or as THREAD=PERCENT. Threads are "
    "{names}.",
    remedy_de="Einen Prozentwert ab 0 und unter 100 schreiben, allein oder als THREAD=PROZENT. "
    "Threads sind {names}.",
    names=("the names of the threads", "die Namen der Threads"),
)
