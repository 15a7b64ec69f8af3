# SPDX-License-Identifier: MIT
"""Numbers of the controller that no program of nctakt reaches; each says why in its cause.

Programs and people who know the controller ask for them.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Message
from nctakt.messages.catalogue import error


def _unreached(
    number: int,
    *,
    en: str,
    de: str,
    cause_en: str,
    cause_de: str,
    classes: tuple[int, int] = (6, 6),
) -> Message:
    return error(
        number,
        en=en,
        de=de,
        remedy_en="Nothing to do: nctakt never reports it.",
        remedy_de="Nichts zu tun: nctakt meldet das nie.",
        cause_en=cause_en,
        cause_de=cause_de,
        classes=classes,
    )


def _cycle_fault(number: int) -> Message:
    return _unreached(
        number,
        en=f"a compiled realtime cycle is not what the realtime part expects (fault {number})",
        de=f"ein übersetzter Echtzeit-Zyklus ist nicht, was der Echtzeit-Teil erwartet ({number})",
        cause_en="The checker lets no cycle pass that could do this: no program reaches it.",
        cause_de="Der Prüfer lässt keinen Zyklus durch, der das könnte: kein Programm erreicht es.",
    )


#: Faults of a compiled realtime cycle, which the checker makes impossible.
CYCLE_FAULTS = tuple(
    _cycle_fault(number) for number in (50856, 50859, 50860, *range(50862, 50870), 50872, 50880)
)

#: All messages of this module.
UNREACHED = (
    _unreached(
        21526,
        en="#PTP ON while tools are corrected online (#OTC)",
        de="#PTP ON während der Online-Werkzeugkorrektur (#OTC)",
        cause_en="nctakt refuses #OTC itself (900200), so it is never active.",
        cause_de="nctakt weist schon #OTC zurück (900200), es ist also nie aktiv.",
        classes=(2, 3),
    ),
    _unreached(
        22121,
        en="#PTP ON is not possible with the active kinematic",
        de="#PTP ON ist mit der aktiven Kinematik nicht möglich",
        cause_en="Which kinematics these are is not published; nctakt can do it with all it has.",
        cause_de="Welche Kinematiken das sind, ist nicht veröffentlicht; nctakt kann es mit allen.",
        classes=(2, 3),
    ),
    _unreached(
        22017,
        en="the list of the V.CH variables cannot be read",
        de="die Liste der V.CH-Variablen kann nicht gelesen werden",
        cause_en="nctakt reports this with 900062 or 900503, as for every other list.",
        cause_de="nctakt meldet es mit 900062 oder 900503, wie bei jeder anderen Liste.",
        classes=(2, 7),
    ),
    _unreached(
        50874,
        en="a realtime cycle has failed for a reason that has no number",
        de="ein Echtzeit-Zyklus ist aus einem Grund ohne eigene Nummer gescheitert",
        cause_en="In nctakt each fault of a realtime cycle has its number.",
        cause_de="In nctakt hat jeder Fehler eines Echtzeit-Zyklus seine Nummer.",
    ),
    _unreached(
        50876,
        en="realtime cycles are off in the realtime part",
        de="Echtzeit-Zyklen sind im Echtzeit-Teil ausgeschaltet",
        cause_en="Decoder and realtime part of nctakt share one switch, P-CHAN-00406; 21982 "
        "reports that it is off.",
        cause_de="Dekoder und Echtzeit-Teil von nctakt haben einen gemeinsamen Schalter, "
        "P-CHAN-00406; 21982 meldet, dass er aus ist.",
    ),
    _unreached(
        50898,
        en="the index of an axis is not valid",
        de="der Index einer Achse ist ungültig",
        cause_en="The checker resolves names of axes before a cycle runs; an unknown one "
        "gives 900213.",
        cause_de="Der Prüfer löst Achsnamen auf, bevor ein Zyklus läuft; ein unbekannter "
        "ergibt 900213.",
    ),
    _unreached(
        50948,
        en="an axis inside an active transformation cannot be moved separately",
        de="eine Achse in einer aktiven Transformation kann nicht für sich bewegt werden",
        cause_en="nctakt refuses such a command of a program with 21071 when it is decoded.",
        cause_de="nctakt lehnt einen solchen Befehl eines Programms beim Dekodieren mit 21071 ab.",
    ),
    *CYCLE_FAULTS,
)
