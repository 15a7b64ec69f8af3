# SPDX-License-Identifier: MIT
"""Messages about thread cutting and tapping: G33, G63, G331, G332."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning
from nctakt.messages.catalogue import error, note, warning

THREAD_PITCH_MISSING = error(
    120173,
    cases=by_beginning("word", {"I": 120175, "J": 120175}),
    en="{function} without a pitch: {word} has no value other than 0",
    de="{function} ohne Steigung: {word} hat keinen Wert außer 0",
    remedy_en="Program the pitch of the axis with the longest travel: I for X, J for Y, K for Z.",
    remedy_de="Die Steigung der Achse mit dem längsten Weg angeben: I für X, J für Y, K für Z.",
    word=("the word of the pitch", "das Wort der Steigung"),
    classes=(2, 6),
)
NEGATIVE_THREAD_PITCH = error(
    901518,
    en="the pitch {value} of G33 is below 0",
    de="die Steigung {value} von G33 liegt unter 0",
    remedy_en="The spindle's direction makes a left-hand thread: M4 instead of M3.",
    remedy_de="Ein Linksgewinde ergibt sich aus der Drehrichtung der Spindel: M4 statt M3.",
)
THREAD_SPINDLE_STOPPED = error(
    50499,
    en="thread cutting (G33) with spindle {spindle} at a standstill",
    de="Gewindeschneiden (G33) bei stehender Spindel {spindle}",
    remedy_en="Program M03 or M04 with a speed S first.",
    remedy_de="Vorher M03 oder M04 mit einer Drehzahl S programmieren.",
    classes=(6, 6),
)
THREAD_WAY_TOO_SHORT = error(
    50206,
    en="thread cutting (G33): spindle {spindle} is too slow for the travel in one tick",
    de="Gewindeschneiden (G33): Spindel {spindle} ist zu langsam für den Weg eines Takts",
    remedy_en="Program a higher speed or a larger pitch: at least 0.0000001 mm for each tick.",
    remedy_de="Eine höhere Drehzahl oder größere Steigung angeben: mindestens 0,0000001 mm je "
    "Takt.",
    classes=(4, 6),
)
THREAD_CHAIN_TOO_FAST = error(
    51103,
    en="the chain of threads is too fast for the corner between two blocks (spindle {spindle})",
    de="die Gewindekette ist zu schnell für die Ecke zwischen zwei Sätzen (Spindel {spindle})",
    remedy_en="Lower the speed, or change direction and pitch in smaller steps.",
    remedy_de="Die Drehzahl senken oder Richtung und Steigung in kleineren Stufen ändern.",
    classes=(4, 6),
)
TAP_SPEED_ZERO = error(
    20007,
    known_as=(901521,),
    en="{function} without a spindle speed",
    de="{function} ohne Spindeldrehzahl",
    remedy_en="Program S: above 0 into a right-hand thread, below 0 out of it.",
    remedy_de="S angeben: über 0 in ein Rechtsgewinde hinein, unter 0 heraus.",
)
TAP_WITH_FEED_FUNCTION = error(
    20635,
    cases=by_beginning("function", {"G96": 20636, "G196": 20637}),
    en="G63 together with {function}",
    de="G63 zusammen mit {function}",
    remedy_en="Program F per minute (G94) and a constant speed (G97): the pitch is F / S.",
    remedy_de="F je Minute (G94) und eine feste Drehzahl (G97) programmieren: die Steigung ist "
    "F / S.",
    function=("the other function", "die andere Funktion"),
)
TAP_SPINDLE_TURNING = error(
    901508,
    en="tapping with spindle {spindle}, which is turning",
    de="Gewindebohren mit Spindel {spindle}, die sich dreht",
    remedy_en="Stop the spindle first, with M05 or M19.",
    remedy_de="Die Spindel vorher anhalten, mit M05 oder M19.",
    cause_en="The path turns the spindle: it must be at a standstill when tapping begins.",
    cause_de="Die Bahn dreht die Spindel: sie muss stehen, wenn das Gewindebohren beginnt.",
    classes=(6, 6),
)
THREAD_TOO_FAST = error(
    901509,
    en="the thread is too fast for the axes: speed of spindle {spindle} times pitch",
    de="das Gewinde ist zu schnell für die Achsen: Drehzahl von Spindel {spindle} mal Steigung",
    remedy_en="Program a lower speed; the axes allow at most P-AXIS-00212.",
    remedy_de="Eine kleinere Drehzahl programmieren; die Achsen erlauben höchstens P-AXIS-00212.",
    classes=(6, 6),
)
THREAD_LOST = error(
    901510,
    en="the thread is lost: spindle {spindle} has another speed or angle than at its start",
    de="das Gewinde ist verloren: Drehzahl oder Winkel der Spindel {spindle} sind andere als am "
    "Anfang",
    remedy_en="Keep its speed while the path accelerates; do not turn it before backward motion.",
    remedy_de="Ihre Drehzahl halten, während die Bahn beschleunigt; sie vor Rückwärtsfahrt nicht "
    "drehen.",
    classes=(6, 6),
)
THREAD_REVERSED = error(
    901511,
    en="spindle {spindle} has reversed while a thread was being cut",
    de="Spindel {spindle} hat beim Gewindeschneiden die Richtung gewechselt",
    remedy_en="Reverse the spindle after the thread.",
    remedy_de="Die Drehrichtung nach dem Gewinde wechseln.",
    classes=(6, 6),
)
THREAD_TOO_SHORT = warning(
    901512,
    en="the thread is too short: the path never reached its speed",
    de="das Gewinde ist zu kurz: die Bahn hat ihre Geschwindigkeit nie erreicht",
    remedy_en="Begin further away, or lower the speed of the spindle.",
    remedy_de="Weiter entfernt beginnen oder die Drehzahl senken.",
    cause_en="While the path accelerates and brakes, it is off the thread.",
    cause_de="Solange die Bahn beschleunigt und bremst, liegt sie neben dem Gewinde.",
)
SPINDLE_WORD_IN_TAPPING = error(
    901513,
    en="{word} while {function} is active",
    de="{word}, während {function} aktiv ist",
    remedy_en="End tapping first, with G00 or G01: it needs the spindle for itself.",
    remedy_de="Das Gewindebohren vorher mit G00 oder G01 beenden: es hat die Spindel für sich.",
    classes=(2, 3),
)
THREAD_WITH_PLC_SPINDLE = error(
    901514,
    en="{function} with spindle {spindle}, which the PLC turns",
    de="{function} mit Spindel {spindle}, die die SPS dreht",
    remedy_en="Take a spindle that the CNC turns (spindel[i].plc_control 0, P-CHAN-00069).",
    remedy_de="Eine Spindel nehmen, die die CNC dreht (spindel[i].plc_control 0, P-CHAN-00069).",
)
THREAD_DURING_COMPENSATION = error(
    901515,
    en="{function} while tool radius compensation is active",
    de="{function} bei aktiver Werkzeugradiuskorrektur",
    remedy_en="Program G40 first.",
    remedy_de="Vorher G40 programmieren.",
)
THREAD_ENTRY_DECIDED = note(
    901516,
    en="G33: the thread starts at the block's start point at the start angle, at any speed",
    de="G33: das Gewinde beginnt bei jeder Drehzahl am Startpunkt des Satzes mit dem Startwinkel",
    remedy_en="Keep a run-in: the path is off the thread while it accelerates and brakes.",
    remedy_de="Einen Einlauf lassen: beim Beschleunigen und Bremsen liegt die Bahn daneben.",
    cause_en="Override, feed hold, single block and backward motion wait for the end of the "
    "threads. No source settles this.",
    cause_de="Override, Vorschubhalt, Einzelsatz und Rückwärtsfahrt warten auf das Ende der "
    "Gewinde. Keine Quelle legt das fest.",
)
TAPPING_DECIDED = note(
    901517,
    en="tapping: override, feed hold and backward motion act on path and spindle together",
    de="Gewindebohren: Override, Halt und Rückwärtsfahrt wirken auf Bahn und Spindel zugleich",
    remedy_en="The spindle has the angle that belongs to the depth in each tick.",
    remedy_de="Die Spindel hat in jedem Takt den Winkel, der zur Tiefe gehört.",
    cause_en="No source settles what they do while a thread is tapped.",
    cause_de="Keine Quelle legt fest, was sie während des Gewindebohrens bewirken.",
)
INVALID_TURN_VALUE = error(
    901519,
    en="#TURN: {word} cannot be {value}",
    de="#TURN: {word} kann nicht {value} sein",
    remedy_en="Give a whole number from 0 to {highest}.",
    remedy_de="Eine ganze Zahl von 0 bis {highest} angeben.",
)
TURN_VALUE_NOT_SIMULATED = error(
    901520,
    en="#TURN: {word} is not simulated",
    de="#TURN: {word} wird nicht simuliert",
    remedy_en="Leave it out: G04 S is a time at the programmed speed, and no override acts on G33.",
    remedy_de="Es weglassen: G04 S ist eine Zeit bei programmierter Drehzahl; auf G33 wirkt kein "
    "Override.",
    word=("the keyword with its value", "das Schlüsselwort mit seinem Wert"),
)
