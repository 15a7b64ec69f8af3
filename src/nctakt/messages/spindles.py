# SPDX-License-Identifier: MIT
"""Messages about spindles."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

SPINDLE_BUSY = error(
    50935,
    en="spindle {spindle} is busy with a job of this tick, or one that the PLC has not "
    "acknowledged",
    de="Spindel {spindle} ist belegt: mit einem Auftrag dieses Takts oder einem unquittierten der "
    "SPS",
    remedy_en="Give each spindle one job in a tick; let the PLC acknowledge in time.",
    remedy_de="Jeder Spindel nur einen Auftrag je Takt geben; die SPS rechtzeitig quittieren "
    "lassen.",
    spindle=("the spindle's name", "der Name der Spindel"),
    reaction=6,
    clearing=6,
)
SPINDLE_WORD_COUNT = error(
    50954,
    en="too many or too few words for a spindle: {command}",
    de="zu viele oder zu wenige Wörter für eine Spindel: {command}",
    remedy_en="A realtime cycle gives M3|M4 and speed, or M3|M4, M19, speed and position, or M5 "
    "alone.",
    remedy_de="Ein Echtzeit-Zyklus gibt M3|M4 und Drehzahl an, oder dazu M19 und Position, oder M5 "
    "allein.",
    cause_en="In the main program M3, M4 and M5 exclude each other, and a position needs M19.",
    cause_de="Im Hauptprogramm schließen M3, M4 und M5 einander aus; eine Position braucht M19.",
    command=("the command as written", "der Befehl, wie geschrieben"),
    reaction=6,
    clearing=6,
)
SPINDLE_AXIS_LIST_MISSING = error(
    50955,
    en="spindle {spindle} cannot turn: no axis list has the logical number {logical}",
    de="Spindel {spindle} kann nicht drehen: keine Achsliste hat die logische Nummer {logical}",
    remedy_en="Give it an axis list (kopf.achs_nr), or leave it to the PLC (plc_control 1).",
    remedy_de="Ihr eine Achsliste geben (kopf.achs_nr) oder sie der SPS überlassen (plc_control "
    "1).",
    spindle=("the spindle's name", "der Name der Spindel"),
    logical=("spindel[i].log_achs_nr", "spindel[i].log_achs_nr"),
    reaction=6,
    clearing=6,
)
CYCLE_ACTIONS_FULL = error(
    51028,
    en="realtime cycle {cycle} has {places} actions open, and no place for another",
    de="Echtzeit-Zyklus {cycle} hat {places} offene Aktionen und keinen Platz für eine weitere",
    remedy_en="Let actions end first, or raise configuration.rt_cycles.buffers (P-CHAN-00480).",
    remedy_de="Aktionen vorher enden lassen oder configuration.rt_cycles.buffers (P-CHAN-00480) "
    "erhöhen.",
    cycle=("cycle at fault", "der fehlerhafte Zyklus"),
    places=("P-CHAN-00480", "P-CHAN-00480"),
    reaction=6,
    clearing=6,
)
NOT_A_SPINDLE_WORD = error(
    900282,
    en="{word} does not belong to a spindle command",
    de="{word} gehört nicht zu einem Spindelbefehl",
    remedy_en="Did you mean {nearest}? A spindle knows M3, M4, M5, M19, S or REV, S.POS or POS.",
    remedy_de="Ist {nearest} gemeint? Eine Spindel kennt M3, M4, M5, M19, S oder REV, S.POS oder "
    "POS.",
    word=("the word as written", "das Wort, wie geschrieben"),
    nearest=("the nearest known name", "der ähnlichste bekannte Name"),
)
NO_MAIN_SPINDLE = error(
    900473,
    en="the channel has no main spindle",
    de="der Kanal hat keine Hauptspindel",
    remedy_en="Name one (main_spindle_ax_nr, P-CHAN-00051), or use a spindle's name: S2[M3 "
    "REV=1000]",
    remedy_de="Eine nennen (main_spindle_ax_nr, P-CHAN-00051) oder eine Spindel mit Namen "
    "ansprechen: S2[M3]",
)
INVALID_SPINDLE_SPEED = error(
    900470,
    en="a spindle's speed cannot be {value}: M3 and M4 give the direction",
    de="die Drehzahl einer Spindel kann nicht {value} sein: M3 und M4 geben die Richtung an",
    remedy_en="Give a speed from 0 on, and M3 or M4.",
    remedy_de="Eine Drehzahl ab 0 angeben, und M3 oder M4.",
    value=("the value", "der Wert"),
    reaction=6,
    clearing=6,
)
M19_WITHOUT_SPEED = error(
    900471,
    en="M19 without a speed: none is active, and the block gives none",
    de="M19 ohne Drehzahl: keine ist aktiv, und der Satz gibt keine an",
    remedy_en="Give the speed with which the spindle goes to its position: M19 S100 S.POS=90",
    remedy_de="Die Drehzahl angeben, mit der die Spindel auf ihre Position fährt: M19 S100 "
    "S.POS=90",
    reaction=2,
    clearing=3,
)
M19_SPEED_ZERO = error(
    900472,
    en="M19 with the speed 0: the spindle would never arrive",
    de="M19 mit der Drehzahl 0: die Spindel käme nie an",
    remedy_en="Give a speed above 0.",
    remedy_de="Eine Drehzahl über 0 angeben.",
    reaction=6,
    clearing=6,
)
SPINDLE_JOB_HELD = error(
    900811,
    en="the program waits for the spindle {spindle}, whose job is held",
    de="das Programm wartet auf die Spindel {spindle}, deren Auftrag angehalten ist",
    remedy_en="Let the realtime cycle go on with #RT CYCLE CONTINUE before, or end the job with "
    "ABORT ACTION.",
    remedy_de="Vorher den Echtzeit-Zyklus mit #RT CYCLE CONTINUE fortsetzen oder den Auftrag mit "
    "ABORT ACTION beenden.",
    cause_en="A realtime cycle has taken the spindle over and is held: only the program could let "
    "it go on, and the program waits.",
    cause_de="Ein Echtzeit-Zyklus hat die Spindel übernommen und ist angehalten: nur das Programm "
    "könnte ihn fortsetzen, und das wartet.",
    spindle=("the spindle", "die Spindel"),
    reaction=6,
    clearing=6,
)
EXCLUSIVE_SPINDLE_WORDS = error(
    900901,
    en="{words} exclude each other in one block",
    de="{words} schließen einander in einem Satz aus",
    remedy_en="Give one of M3, M4 and M5 in a block; M5 alone, M19 alone or with M3 or M4.",
    remedy_de="Je Satz nur eines von M3, M4 und M5; M5 allein, M19 allein oder mit M3 oder M4.",
    words=("the words of the block", "die Wörter des Satzes"),
)
SPINDLE_POSITION_WITHOUT_M19 = error(
    900902,
    en="a position of the spindle without M19",
    de="eine Position der Spindel ohne M19",
    remedy_en="Write M19 in the same block: M19 S100 S.POS=90",
    remedy_de="M19 in denselben Satz schreiben: M19 S100 S.POS=90",
)
SPINDLE_SPEED_LIMITED = warning(
    900905,
    en="spindle {spindle} turns no faster than {limit} 1/min; {speed} is limited to that",
    de="Spindel {spindle} dreht höchstens {limit} 1/min; {speed} wird darauf begrenzt",
    remedy_en="Program at most that speed, or raise P-AXIS-00212 of the spindle's axis list.",
    remedy_de="Höchstens diese Drehzahl programmieren oder P-AXIS-00212 der Spindelliste erhöhen.",
    spindle=("the spindle's name", "der Name der Spindel"),
    limit=("the speed of the axis list in 1/min", "die Drehzahl der Achsliste in 1/min"),
    speed=("the speed as programmed", "die Drehzahl, wie programmiert"),
)
DWELL_WITHOUT_SPINDLE = error(
    900813,
    en="G04 S: the program has not set the main spindle turning",
    de="G04 S: das Programm hat die Hauptspindel nicht in Drehung versetzt",
    remedy_en="Program M3 or M4 with a speed above 0 before, or give the time: G04 X1.5",
    remedy_de="Vorher M3 oder M4 mit einer Drehzahl über 0 programmieren, oder die Zeit angeben: "
    "G04 X1.5",
    cause_en="The time is that of revolutions at the programmed speed.",
    cause_de="Die Zeit ist die von Umdrehungen mit der programmierten Drehzahl.",
    reaction=2,
    clearing=3,
)
