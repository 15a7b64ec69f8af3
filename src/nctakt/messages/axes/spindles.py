# SPDX-License-Identifier: MIT
"""Messages about spindles."""

from __future__ import annotations

from nctakt.messages.cases import in_case
from nctakt.messages.catalogue import error, warning

SPINDLE_BUSY = error(
    60331,
    en="spindle {spindle} already has a job in this tick, or the PLC has not acknowledged one",
    de="Spindel {spindle} hat in diesem Takt schon einen Auftrag, oder die SPS hat einen nicht "
    "quittiert",
    remedy_en="Give each spindle one job per tick; let the PLC acknowledge in time.",
    remedy_de="Jeder Spindel nur einen Auftrag je Takt geben; die SPS rechtzeitig quittieren "
    "lassen.",
    classes=(6, 6),
)
SPINDLE_WORD_COUNT = error(
    50954,
    en="too many or too few words for a spindle: {command}",
    de="zu viele oder zu wenige Wörter für eine Spindel: {command}",
    remedy_en="A realtime cycle gives M3|M4 and speed, or M3|M4, M19, speed and position, or M5 "
    "alone.",
    remedy_de="Ein Echtzeit-Zyklus gibt M3|M4 und Drehzahl an, oder M3|M4, M19, Drehzahl und "
    "Position, oder nur M5.",
    cause_en="In the main program M3, M4 and M5 are mutually exclusive, and a position needs M19.",
    cause_de="Im Hauptprogramm schließen M3, M4 und M5 einander aus; eine Position braucht M19.",
    classes=(6, 6),
)
SPINDLE_AXIS_LIST_MISSING = error(
    50397,
    en="spindle {spindle} cannot turn: no axis list has the logical number {logical}",
    de="Spindel {spindle} kann nicht drehen: keine Achsliste hat die logische Nummer {logical}",
    remedy_en="Give it an axis list (kopf.achs_nr), or leave it to the PLC (plc_control 1).",
    remedy_de="Ihr eine Achsliste geben (kopf.achs_nr) oder sie der SPS überlassen (plc_control "
    "1).",
    logical=("spindel[i].log_achs_nr", "spindel[i].log_achs_nr"),
    classes=(6, 6),
)
CYCLE_ACTIONS_FULL = error(
    51028,
    en="realtime cycle {cycle} cannot start another action: {used}",
    de="Echtzeit-Zyklus {cycle} kann keine weitere Aktion beginnen: {used}",
    remedy_en="Let an action end first (open: {open}). More slots: "
    "configuration.rt_cycles.buffers (P-CHAN-00480).",
    remedy_de="Eine Aktion vorher enden lassen (offen: {open}). Mehr Plätze: "
    "configuration.rt_cycles.buffers (P-CHAN-00480).",
    cause_en="An action keeps its slot until it has ended. One published list of errors gives "
    "51028 for missing memory of realtime loops; here that is 51029.",
    cause_de="Eine Aktion behält ihren Platz bis zu ihrem Ende. Eine veröffentlichte Fehlerliste "
    "nennt 51028 für fehlenden Speicher von Echtzeit-Schleifen; hier ist das 51029.",
    used=("what its slots are used for", "wofür seine Plätze verwendet werden"),
    open=("how many of its actions are open", "wie viele seiner Aktionen offen sind"),
    classes=(6, 6),
)
NOT_A_SPINDLE_WORD = error(
    21035,
    classes=(0, 0),
    known_as=(900282, 20180, 21039),
    en="{word} does not belong to a spindle command",
    de="{word} gehört nicht zu einem Spindelbefehl",
    remedy_en="Did you mean {nearest}? Possible are M3, M4, M5, M19, S or REV, S.POS or POS.",
    remedy_de="War {nearest} gemeint? Möglich sind M3, M4, M5, M19, S oder REV, S.POS oder POS.",
)
NO_MAIN_SPINDLE = error(
    21961,
    classes=(0, 0),
    known_as=(900473,),
    en="the channel has no main spindle",
    de="der Kanal hat keine Hauptspindel",
    remedy_en="Name one (main_spindle_ax_nr, P-CHAN-00051), or use the name of a spindle: S2[M3 "
    "REV=1000]",
    remedy_de="Eine angeben (main_spindle_ax_nr, P-CHAN-00051) oder eine Spindel mit Namen: S2[M3 "
    "REV=1000]",
)
NO_SUCH_SPINDLE = error(
    21306,
    en="#MAIN SPINDLE: the channel has no spindle {spindle}",
    de="#MAIN SPINDLE: der Kanal hat keine Spindel {spindle}",
    remedy_en="Program the name or the logical number of one of its spindles. Known: {known}",
    remedy_de="Name oder logische Nummer einer seiner Spindeln programmieren. Bekannt: {known}",
    spindle=("the name or number as written", "Name oder Nummer, wie geschrieben"),
    known=("names of the spindles", "Namen der Spindeln"),
)
TOOL_SPEED_RANGE = error(
    60312,
    en="the tool of spindle {spindle} allows {low} … {high} 1/min, not {speed}",
    de="das Werkzeug der Spindel {spindle} erlaubt {low} … {high} 1/min, nicht {speed}",
    remedy_en="Program another speed, or change wz[i].vb_min and wz[i].vb_max of the tool list.",
    remedy_de="Eine andere Drehzahl programmieren oder wz[i].vb_min und wz[i].vb_max der "
    "Werkzeugliste ändern.",
    low=("lowest speed of the tool", "kleinste Drehzahl des Werkzeugs"),
    high=("highest speed of the tool; 0: none", "größte Drehzahl des Werkzeugs; 0: keine"),
    classes=(6, 6),
)
MAIN_SPINDLE_IN_USE = error(
    901871,
    en="#MAIN SPINDLE while {word} is active",
    de="#MAIN SPINDLE, solange {word} aktiv ist",
    remedy_en="Program G97 before it.",
    remedy_de="Davor G97 programmieren.",
    word=("what acts on the main spindle", "was auf die Hauptspindel wirkt"),
    classes=(2, 3),
)
INVALID_SPINDLE_SPEED = error(
    20991,
    known_as=(900470,),
    en="the speed of a spindle cannot be {value}: M3 and M4 define the direction",
    de="die Drehzahl einer Spindel kann nicht {value} sein: M3 und M4 bestimmen die Richtung",
    remedy_en="Give a speed of at least 0, and M3 or M4.",
    remedy_de="Eine Drehzahl ab 0 angeben, und M3 oder M4.",
    classes=(6, 6),
)
M19_WITHOUT_SPEED = error(
    20007,
    known_as=(900471,),
    en="M19 without a speed: none is active, and the block contains none",
    de="M19 ohne Drehzahl: es ist keine aktiv, und der Satz enthält keine",
    remedy_en="Give the speed at which the spindle moves to its position: M19 S100 S.POS=90",
    remedy_de="Die Drehzahl angeben, mit der die Spindel auf ihre Position fährt: M19 S100 "
    "S.POS=90",
)
M19_SPEED_ZERO = error(
    20007,
    known_as=(900472, 60212),
    en="M19 with speed 0: the spindle would never arrive",
    de="M19 mit der Drehzahl 0: die Spindel käme nie an",
    remedy_en="Give a speed above 0.",
    remedy_de="Eine Drehzahl über 0 angeben.",
    classes=(6, 6),
)
SPINDLE_JOB_HELD = error(
    900811,
    en="the program waits for spindle {spindle}, whose job is on hold",
    de="das Programm wartet auf Spindel {spindle}, deren Auftrag angehalten ist",
    remedy_en="First continue the realtime cycle with #RT CYCLE CONTINUE, or end the job with "
    "ABORT ACTION.",
    remedy_de="Vorher den Echtzeit-Zyklus mit #RT CYCLE CONTINUE fortsetzen oder den Auftrag mit "
    "ABORT ACTION beenden.",
    cause_en="A realtime cycle has taken over the spindle and is on hold: only the program could "
    "continue it, and the program is waiting.",
    cause_de="Ein Echtzeit-Zyklus hat die Spindel übernommen und ist angehalten: nur das Programm "
    "könnte ihn fortsetzen, und das wartet.",
    classes=(6, 6),
)
EXCLUSIVE_SPINDLE_WORDS = error(
    20155,
    classes=(0, 0),
    known_as=(900901,),
    cases=in_case(21151, lambda values: "M19" in str(values["words"]).split(", ")),
    en="{words} must not be in the same block",
    de="{words} dürfen nicht im selben Satz stehen",
    remedy_en="Program only one of M3, M4 and M5 per block; M5 alone, M19 alone or with M3 or M4.",
    remedy_de="Je Satz nur eines von M3, M4 und M5 programmieren; M5 allein, M19 allein oder mit "
    "M3 oder M4.",
    words=("the words of the block", "die Wörter des Satzes"),
)
SPINDLE_POSITION_WITHOUT_M19 = error(
    900902,
    known_as=(21151,),
    en="a spindle position without M19",
    de="eine Spindelposition ohne M19",
    remedy_en="Write M19 in the same block: M19 S100 S.POS=90",
    remedy_de="M19 in denselben Satz schreiben: M19 S100 S.POS=90",
)
SPINDLE_SPEED_LIMITED = warning(
    900905,
    known_as=(60019,),
    en="spindle {spindle}: the speed {speed} is limited to {limit} 1/min",
    de="Spindel {spindle}: die Drehzahl {speed} wird auf {limit} 1/min begrenzt",
    remedy_en="Program at most this speed, or increase P-AXIS-00212 in the axis list of the "
    "spindle.",
    remedy_de="Höchstens diese Drehzahl programmieren oder P-AXIS-00212 in der Achsliste der "
    "Spindel erhöhen.",
    limit=(
        "the maximum speed in the axis list, in 1/min",
        "die größte Drehzahl laut Achsliste in 1/min",
    ),
)
DWELL_WITHOUT_SPINDLE = error(
    20007,
    known_as=(900813,),
    en="G04 S: the program has not started the main spindle",
    de="G04 S: das Programm hat die Hauptspindel nicht gestartet",
    remedy_en="First program M3 or M4 with a speed above 0, or give the time: G04 X1.5",
    remedy_de="Vorher M3 oder M4 mit einer Drehzahl über 0 programmieren, oder die Zeit angeben: "
    "G04 X1.5",
    cause_en="The dwell time is that of the revolutions at the programmed speed.",
    cause_de="Die Verweilzeit ist die der Umdrehungen bei der programmierten Drehzahl.",
)
SPINDLE_TURNS_IN_EXCHANGE = error(
    60137,
    en="spindle {spindle} is turning and cannot give away its axis",
    de="Spindel {spindle} dreht sich und kann ihre Achse nicht abgeben",
    remedy_en="Stop it by M5 before PUTAX.",
    remedy_de="Sie vor PUTAX mit M5 anhalten.",
    classes=(6, 6),
)
SPINDLE_WITHOUT_AXIS = error(
    902720,
    en="spindle {spindle} has no axis here: PUTAX has released it",
    de="Spindel {spindle} hat hier keine Achse: PUTAX hat sie abgegeben",
    remedy_en="Program CALLAX for the spindle before it.",
    remedy_de="Davor CALLAX für die Spindel programmieren.",
    classes=(2, 3),
)
SPINDLE_EXCHANGE_NOT_ALONE = error(
    902721,
    en="{word} must be the only word in the brackets of a spindle",
    de="{word} muss in den Klammern einer Spindel allein stehen",
    remedy_en="Write the other words in a separate block.",
    remedy_de="Die anderen Wörter in einen eigenen Satz schreiben.",
    word=("CALLAX or PUTAX", "CALLAX oder PUTAX"),
)
SPINDLE_OF_PLC_HAS_NO_AXIS = error(
    902722,
    en="{command}: the PLC turns spindle {spindle}, which has no axis of the CNC",
    de="{command}: die SPS dreht Spindel {spindle}, die keine Achse der CNC hat",
    remedy_en="Exchange the axis of a spindle that the CNC turns (plc_control 0).",
    remedy_de="Die Achse einer Spindel tauschen, die die CNC dreht (plc_control 0).",
    classes=(2, 3),
)


_STAGE = ("number of the gear step", "Nummer der Getriebestufe")
_SPINDLE = ("name of the spindle", "Name der Spindel")

GEAR_STEP_OUT_OF_FORMAT = error(
    20030,
    en="G112: {stage} is not the number of a gear step",
    de="G112: {stage} ist keine Nummer einer Getriebestufe",
    remedy_en="Give a whole number from 1 to 65535.",
    remedy_de="Eine ganze Zahl von 1 bis 65535 angeben.",
    stage=_STAGE,
)
UNKNOWN_SPINDLE_GEAR = error(
    20029,
    en="the axis list of the spindle {spindle} has no gear step {stage}",
    de="die Achsliste der Spindel {spindle} hat keine Getriebestufe {stage}",
    remedy_en="Describe it there (getriebe[i].nummer), or choose one of these: {known}",
    remedy_de="Sie dort beschreiben (getriebe[i].nummer) oder eine von diesen wählen: {known}",
    spindle=_SPINDLE,
    stage=_STAGE,
    known=("the gear steps of the list", "die Getriebestufen der Liste"),
)
GEAR_CHANGE_WHILE_TURNING = error(
    60285,
    en="G112 while the spindle {spindle} turns",
    de="G112, während die Spindel {spindle} dreht",
    remedy_en="Program M5 before it, or M40 … M45, which stop the spindle themselves.",
    remedy_de="Davor M5 programmieren, oder M40 … M45, die die Spindel selbst anhalten.",
    spindle=_SPINDLE,
    classes=(6, 6),
)
GEAR_OF_PLC_SPINDLE = error(
    901876,
    en="the gear of the spindle {spindle} cannot change: the PLC turns it",
    de="das Getriebe der Spindel {spindle} kann nicht schalten: die SPS dreht sie",
    remedy_en="Gear steps need a spindle that the CNC turns (spindel[i].plc_control 0).",
    remedy_de="Getriebestufen brauchen eine Spindel, die die CNC dreht (spindel[i].plc_control 0).",
    spindle=_SPINDLE,
    classes=(2, 3),
)
NO_GEAR_FOR_SPEED = error(
    901877,
    en="no gear step of the spindle {spindle} has the speed {speed} 1/min",
    de="keine Getriebestufe der Spindel {spindle} hat die Drehzahl {speed} 1/min",
    remedy_en="Program a speed within the ranges of spindel[i].range_table: {ranges}",
    remedy_de="Eine Drehzahl aus den Bereichen von spindel[i].range_table programmieren: {ranges}",
    spindle=_SPINDLE,
    ranges=("the ranges of all steps", "die Bereiche aller Stufen"),
    classes=(2, 3),
)
GEAR_FUNCTION_SYNCHRONISATION = error(
    901878,
    en="M{function} changes the gear, but its synchronisation type does not make the program wait",
    de="M{function} schaltet das Getriebe, aber ihre Synchronisationsart lässt das Programm nicht "
    "warten",
    remedy_en="Set m_synch[{function}] to MVS_SVS (P-CHAN-00041).",
    remedy_de="m_synch[{function}] auf MVS_SVS setzen (P-CHAN-00041).",
    function=("number of the M function", "Nummer der M-Funktion"),
    classes=(2, 3),
)
