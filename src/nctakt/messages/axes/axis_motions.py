# SPDX-License-Identifier: MIT
"""Messages about independent motions of single axes."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import by_limit
from nctakt.messages.catalogue import error, note

AXIS_NOT_AT_BLOCK_START = error(
    900420,
    en="the block does not start where axis {axis} is",
    de="der Satz beginnt nicht dort, wo die Achse {axis} steht",
    remedy_en="Let the decoder read the positions again first, with #FLUSH WAIT or #CHANNEL INIT.",
    remedy_de="Den Dekoder vorher die Positionen neu lesen lassen: #FLUSH WAIT, #CHANNEL INIT",
    cause_en="Something other than the path has moved an axis since the block was decoded; the "
    "path never jumps.",
    cause_de="Etwas anderes als die Bahn hat eine Achse bewegt, seit der Satz dekodiert wurde; die "
    "Bahn springt nie.",
    axis=("the first of these axes", "die erste dieser Achsen"),
    classes=(6, 6),
)
AXIS_MOVED_BY_PATH = error(
    50603,
    known_as=(900430, 60262),
    en="axis {axis} is being moved by the path and takes no separate command now",
    de="Achse {axis} wird gerade von der Bahn bewegt und nimmt jetzt keinen eigenen Auftrag an",
    remedy_en="Command the axis while no block moves it.",
    remedy_de="Die Achse beauftragen, während kein Satz sie bewegt.",
    cause_en="An axis has one owner at a time: the path while the current block moves it.",
    cause_de="Eine Achse hat immer nur einen Eigentümer: die Bahn, während der aktuelle Satz sie "
    "bewegt.",
    classes=(6, 6),
)
AXIS_IN_ERROR_STATE = error(
    60213,
    known_as=(900431,),
    en="axis {axis} is in error state and takes no command before a reset",
    de="Achse {axis} ist im Fehlerzustand und nimmt vor einem Reset keinen Auftrag an",
    remedy_en="Reset the channel; the error before this one says what happened.",
    remedy_de="Den Kanal zurücksetzen; der Fehler davor sagt, was geschehen ist.",
    classes=(6, 6),
)
INDP_TARGET_OUTSIDE_LIMITS = error(
    60158,
    known_as=(900432, 1702, 1703),
    cases=by_limit("target", above=60158, below=60159),
    en="the target {target} of axis {axis} is outside its software limits {low} … {high}",
    de="das Ziel {target} der Achse {axis} liegt außerhalb ihrer Software-Endschalter {low} … "
    "{high}",
    remedy_en="Give a target between kenngr.swe_neg and kenngr.swe_pos, offsets included.",
    remedy_de="Ein Ziel zwischen kenngr.swe_neg und kenngr.swe_pos angeben, einschließlich "
    "Verschiebungen.",
    target=("the target in mm or degrees", "das Ziel in mm oder Grad"),
    classes=(6, 6),
)
BUFFERED_MOTION_WAITING = error(
    1704,
    known_as=(900433, 60156),
    en="a motion of axis {axis} is already waiting: only one BUFFERED motion can wait",
    de="eine Bewegung der Achse {axis} wartet bereits: nur eine BUFFERED-Bewegung kann warten",
    remedy_en="Command the next one once the waiting one has started, or use ABORTING.",
    remedy_de="Die nächste erst beauftragen, wenn die wartende begonnen hat, oder ABORTING "
    "verwenden.",
    classes=(6, 6),
)
MOTION_ENDED_BY_LIMIT = error(
    1702,
    known_as=(900434, 900436, 60158, 60159),
    cases=Cases((1702, 1703), lambda values: 0),
    en="a software limit of axis {axis} ends its motion",
    de="ein Software-Endschalter der Achse {axis} beendet ihre Bewegung",
    remedy_en="Stop the axis earlier, give a shorter distance, or make it a modulo axis.",
    remedy_de="Die Achse früher stoppen, einen kürzeren Weg angeben oder sie zur Moduloachse "
    "machen.",
    cause_en="An endless motion was braked so that it stopped at the limit, or a BUFFERED "
    "distance would have led beyond it. After an endless motion such a distance begins where the "
    "axis reaches its speed.",
    cause_de="Eine Endlosbewegung wurde so gebremst, dass die Achse am Endschalter steht, oder "
    "ein BUFFERED-Weg hätte darüber hinausgeführt. Nach einer Endlosbewegung beginnt ein solcher "
    "Weg dort, wo die Achse ihre Geschwindigkeit erreicht.",
    classes=(6, 6),
)
AXIS_IN_INDEPENDENT_MOTION = error(
    50766,
    known_as=(900435, 900446, 900447, 50629),
    en="the block moves axis {axis}, {motion}",
    de="der Satz bewegt die Achse {axis}, {motion}",
    remedy_en="Stop the motion first: {axis}[INDP STOP], ABORT ACTION or END_ACTION. If it is on "
    "hold, CONTINUE it.",
    remedy_de="Die Bewegung vorher stoppen: {axis}[INDP STOP], ABORT ACTION, END_ACTION. Eine "
    "angehaltene fortsetzen.",
    cause_en="An axis has one owner at a time, and the path never jumps. A block that programs an "
    "axis moved by a realtime cycle waits until that axis stops, which in an endless motion it "
    "never does. A motion on hold keeps its target and would continue later from a position that "
    "the path has left.",
    cause_de="Eine Achse hat immer nur einen Eigentümer, und die Bahn springt nie. Ein Satz mit "
    "einer Achse, die ein Echtzeit-Zyklus bewegt, wartet, bis sie steht; in einer Endlosbewegung "
    "bleibt sie nie stehen. Eine angehaltene Bewegung behält ihr Ziel und ginge später von einer "
    "Position aus weiter, die die Bahn verlassen hat.",
    motion=("its motion beside the path", "ihre Bewegung neben der Bahn"),
    classes=(6, 6),
)
MOTION_ENDED_WITH_CYCLE = note(
    902001,
    en="{axis} {what}: realtime cycle {cycle} {how} (MOVE_ABORT)",
    de="{axis} {what}: Echtzeit-Zyklus {cycle} {how} (MOVE_ABORT)",
    remedy_en="END_ACTION=MOVE_CONT lets the motion continue; END_ACTION=MOVE_ABORT marks the "
    "abort as intended.",
    remedy_de="Mit END_ACTION=MOVE_CONT läuft die Bewegung weiter; END_ACTION=MOVE_ABORT "
    "kennzeichnet gewollten Abbruch.",
    cause_en="Without END_ACTION the motions of a cycle are aborted when it ends: at the end of "
    "its scope or of the program, or by #RT CYCLE DELETE.",
    cause_de="Ohne END_ACTION werden die Bewegungen eines Zyklus abgebrochen, wenn er endet: am "
    "Ende seiner Gültigkeit oder des Programms oder durch #RT CYCLE DELETE.",
    what=("what became of the motion", "was aus der Bewegung wurde"),
    how=("how the cycle came to its end", "wie der Zyklus endete"),
)
