# SPDX-License-Identifier: MIT
"""Numbers of the controller that no program of nctakt reaches; each says why in its cause.

Programs and people who know the controller ask for them. The numbers of faults of a compiled cycle
are those that the checker makes impossible: a test holds that nothing reports them.
"""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()

_REMEDY_EN = "Nothing to do: nctakt never reports it."
_REMEDY_DE = "Nichts zu tun: nctakt meldet das nie."


def _add(
    number: int, en: str, de: str, cause_en: str, cause_de: str, reaction: int, clearing: int
) -> None:
    MESSAGES.add(
        number,
        ERROR,
        en,
        de,
        remedy_en=_REMEDY_EN,
        remedy_de=_REMEDY_DE,
        cause_en=cause_en,
        cause_de=cause_de,
        reaction=reaction,
        clearing=clearing,
    )


_add(
    22017,
    "the list of the V.CH variables cannot be read",
    "die Liste der V.CH-Variablen kann nicht gelesen werden",
    "nctakt tells it with 900062 or 900076, as for every other list.",
    "nctakt meldet es mit 900062 oder 900076, wie bei jeder anderen Liste.",
    2,
    7,
)
_add(
    50874,
    "a realtime cycle has failed for a reason without a number of its own",
    "ein Echtzeit-Zyklus ist aus einem Grund ohne eigene Nummer gescheitert",
    "In nctakt each fault of a realtime cycle has its number.",
    "In nctakt hat jeder Fehler eines Echtzeit-Zyklus seine Nummer.",
    6,
    6,
)
_add(
    50876,
    "realtime cycles are off in the realtime part",
    "Echtzeit-Zyklen sind im Echtzeit-Teil ausgeschaltet",
    "Decoder and realtime part of nctakt share one switch, P-CHAN-00406; 21982 tells that it is "
    "off.",
    "Dekoder und Echtzeit-Teil von nctakt haben einen gemeinsamen Schalter, P-CHAN-00406; 21982 "
    "meldet, dass er aus ist.",
    6,
    6,
)

_RESOLVED_EN = "The checker resolves names of axes before a cycle runs; an unknown one is 900213."
_RESOLVED_DE = "Der Prüfer löst Achsnamen auf, bevor ein Zyklus läuft; ein unbekannter ist 900213."

_add(
    50898,
    "the index of an axis is not valid",
    "der Index einer Achse ist ungültig",
    _RESOLVED_EN,
    _RESOLVED_DE,
    6,
    6,
)
_add(
    50899,
    "an axis does not belong to the channel",
    "eine Achse gehört nicht zum Kanal",
    _RESOLVED_EN,
    _RESOLVED_DE,
    6,
    6,
)

_add(
    50948,
    "an axis inside an active transformation cannot be moved on its own",
    "eine Achse in einer aktiven Transformation kann nicht für sich bewegt werden",
    "nctakt refuses transformations when a program is checked, so that none is ever active.",
    "nctakt lehnt Transformationen beim Prüfen ab, sodass nie eine aktiv ist.",
    6,
    6,
)

#: Faults of a compiled realtime cycle.
CYCLE_FAULTS = (
    50856,
    50859,
    50860,
    *range(50862, 50870),
    50872,
    50880,
)

for _number in CYCLE_FAULTS:
    _add(
        _number,
        f"a compiled realtime cycle is not what the realtime part expects (fault {_number})",
        f"ein übersetzter Echtzeit-Zyklus ist nicht, was der Echtzeit-Teil erwartet ({_number})",
        "The checker lets no cycle pass that could do this: no program reaches it.",
        "Der Prüfer lässt keinen Zyklus durch, der das könnte: kein Programm erreicht es.",
        6,
        6,
    )
