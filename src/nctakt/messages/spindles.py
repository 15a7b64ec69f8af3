# SPDX-License-Identifier: MIT
"""Messages of spindles (900282, 900470 … 900479)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    50935,
    ERROR,
    "spindle {spindle} is busy with a job of this tick, or one that the PLC has not acknowledged",
    "Spindel {spindle} ist belegt: mit einem Auftrag dieses Takts oder einem unquittierten der SPS",
    remedy_en="Give each spindle one job in a tick; let the PLC acknowledge in time.",
    remedy_de="Jeder Spindel nur einen Auftrag je Takt geben; die SPS rechtzeitig quittieren "
    "lassen.",
    parameters={"spindle": "the spindle's name"},
    reaction=6,
    clearing=6,
)
_add(
    50954,
    ERROR,
    "too many or too few words for a spindle: {command}",
    "zu viele oder zu wenige Wörter für eine Spindel: {command}",
    remedy_en="A realtime cycle gives M3|M4 and speed, or M3|M4, M19, speed and position, or M5 "
    "alone.",
    remedy_de="Ein Echtzeit-Zyklus gibt M3|M4 und Drehzahl an, oder dazu M19 und Position, oder M5 "
    "allein.",
    cause_en="In the main program M3, M4 and M5 exclude each other, and a position needs M19.",
    cause_de="Im Hauptprogramm schließen M3, M4 und M5 einander aus; eine Position braucht M19.",
    parameters={"command": "the command as written"},
    reaction=6,
    clearing=6,
)
_add(
    50955,
    ERROR,
    "spindle {spindle} cannot turn: no axis list has the logical number {logical}",
    "Spindel {spindle} kann nicht drehen: keine Achsliste hat die logische Nummer {logical}",
    remedy_en="Give it an axis list (kopf.achs_nr), or leave it to the PLC (plc_control 1).",
    remedy_de="Ihr eine Achsliste geben (kopf.achs_nr) oder sie der SPS überlassen (plc_control "
    "1).",
    parameters={"spindle": "the spindle's name", "logical": "spindel[i].log_achs_nr"},
    reaction=6,
    clearing=6,
)
_add(
    51028,
    ERROR,
    "realtime cycle {cycle} has {places} actions open, and no place for another",
    "Echtzeit-Zyklus {cycle} hat {places} offene Aktionen und keinen Platz für eine weitere",
    remedy_en="Let actions end first, or raise configuration.rt_cycles.buffers (P-CHAN-00480).",
    remedy_de="Aktionen vorher enden lassen oder configuration.rt_cycles.buffers (P-CHAN-00480) "
    "erhöhen.",
    parameters={"cycle": "cycle at fault", "places": "P-CHAN-00480"},
    reaction=6,
    clearing=6,
)
_add(
    900282,
    ERROR,
    "{word} does not belong to a spindle command",
    "{word} gehört nicht zu einem Spindelbefehl",
    remedy_en="Did you mean {nearest}? A spindle knows M3, M4, M5, M19, S or REV, S.POS or POS.",
    remedy_de="Ist {nearest} gemeint? Eine Spindel kennt M3, M4, M5, M19, S oder REV, S.POS oder "
    "POS.",
    parameters={"word": "the word as written", "nearest": "the nearest known name"},
)
_add(
    900473,
    ERROR,
    "the channel has no main spindle",
    "der Kanal hat keine Hauptspindel",
    remedy_en="Name one (main_spindle_ax_nr, P-CHAN-00051), or use a spindle's name: "
    "S2[M3 REV=1000]",
    remedy_de="Eine nennen (main_spindle_ax_nr, P-CHAN-00051) oder eine Spindel mit Namen "
    "ansprechen: S2[M3]",
)
_add(
    900470,
    ERROR,
    "a spindle's speed cannot be {value}: M3 and M4 give the direction",
    "die Drehzahl einer Spindel kann nicht {value} sein: M3 und M4 geben die Richtung an",
    remedy_en="Give a speed from 0 on, and M3 or M4.",
    remedy_de="Eine Drehzahl ab 0 angeben, und M3 oder M4.",
    parameters={"value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    900471,
    ERROR,
    "M19 without a speed: none is active, and the block gives none",
    "M19 ohne Drehzahl: keine ist aktiv, und der Satz gibt keine an",
    remedy_en="Give the speed with which the spindle goes to its position: M19 S100 S.POS=90",
    remedy_de="Die Drehzahl angeben, mit der die Spindel auf ihre Position fährt: M19 S100 "
    "S.POS=90",
    reaction=2,
    clearing=3,
)
_add(
    900472,
    ERROR,
    "M19 with the speed 0: the spindle would never arrive",
    "M19 mit der Drehzahl 0: die Spindel käme nie an",
    remedy_en="Give a speed above 0.",
    remedy_de="Eine Drehzahl über 0 angeben.",
    reaction=6,
    clearing=6,
)
_add(
    900811,
    ERROR,
    "the program waits for the spindle {spindle}, whose job is held",
    "das Programm wartet auf die Spindel {spindle}, deren Auftrag angehalten ist",
    remedy_en="Let the realtime cycle go on with #RT CYCLE CONTINUE before, or end the job with "
    "ABORT ACTION.",
    remedy_de="Vorher den Echtzeit-Zyklus mit #RT CYCLE CONTINUE fortsetzen oder den Auftrag mit "
    "ABORT ACTION beenden.",
    cause_en="A realtime cycle has taken the spindle over and is held: only the program could let "
    "it go on, and the program waits.",
    cause_de="Ein Echtzeit-Zyklus hat die Spindel übernommen und ist angehalten: nur das Programm "
    "könnte ihn fortsetzen, und das wartet.",
    parameters={"spindle": "the spindle"},
    reaction=6,
    clearing=6,
)
_add(
    900901,
    ERROR,
    "{words} exclude each other in one block",
    "{words} schließen einander in einem Satz aus",
    remedy_en="Give one of M3, M4 and M5 in a block; M5 alone, M19 alone or with M3 or M4.",
    remedy_de="Je Satz nur eines von M3, M4 und M5; M5 allein, M19 allein oder mit M3 oder M4.",
    parameters={"words": "the words of the block"},
)
_add(
    900902,
    ERROR,
    "a position of the spindle without M19",
    "eine Position der Spindel ohne M19",
    remedy_en="Write M19 in the same block: M19 S100 S.POS=90",
    remedy_de="M19 in denselben Satz schreiben: M19 S100 S.POS=90",
)
_add(
    900905,
    WARNING,
    "spindle {spindle} turns no faster than {limit} 1/min; {speed} is limited to that",
    "Spindel {spindle} dreht höchstens {limit} 1/min; {speed} wird darauf begrenzt",
    remedy_en="Program at most that speed, or raise P-AXIS-00212 of the spindle's axis list.",
    remedy_de="Höchstens diese Drehzahl programmieren oder P-AXIS-00212 der Spindelliste erhöhen.",
    parameters={
        "spindle": "the spindle's name",
        "limit": "the speed of the axis list in 1/min",
        "speed": "the speed as programmed",
    },
)
_add(
    900813,
    ERROR,
    "G04 S: the program has not set the main spindle turning",
    "G04 S: das Programm hat die Hauptspindel nicht in Drehung versetzt",
    remedy_en="Program M3 or M4 with a speed above 0 before, or give the time: G04 X1.5",
    remedy_de="Vorher M3 oder M4 mit einer Drehzahl über 0 programmieren, oder die Zeit angeben: "
    "G04 X1.5",
    cause_en="The time is that of revolutions at the programmed speed.",
    cause_de="Die Zeit ist die von Umdrehungen mit der programmierten Drehzahl.",
    reaction=2,
    clearing=3,
)
