# SPDX-License-Identifier: MIT
"""Messages about backward motion, realtime loops and probing on the path."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

BACKWARD_MEMORY_TOO_SMALL = warning(
    50450,
    en="the memory for backward motion ({value} bytes) is too small; {minimum} bytes are used",
    de="der Speicher für das Rückwärtsfahren ({value} Byte) ist zu klein; es gelten {minimum} Byte",
    remedy_en="Set fb_storage_size to at least {minimum}, or to 0 if nothing moves backward.",
    remedy_de="fb_storage_size auf mindestens {minimum} setzen, oder auf 0, wenn nichts rückwärts "
    "fährt.",
    cause_en="The history of the path must hold a few blocks in any case.",
    cause_de="Die Historie der Bahn muss in jedem Fall einige Sätze fassen.",
    value=("P-STUP-00033 as written", "P-STUP-00033, wie geschrieben"),
    minimum=("the smallest size in bytes", "die kleinste Größe in Byte"),
)
BACKWARD_MEMORY_TOO_LARGE = warning(
    902027,
    en="the memory for backward motion ({value} bytes) is too large; {maximum} bytes are used",
    de="der Speicher für das Rückwärtsfahren ({value} Byte) ist zu groß; es gelten {maximum} Byte",
    remedy_en="Set fb_storage_size to at most {maximum}.",
    remedy_de="fb_storage_size auf höchstens {maximum} setzen.",
    cause_en="A list must not take the memory of the computer that simulates it.",
    cause_de="Eine Liste darf dem Rechner, der sie simuliert, nicht den Speicher nehmen.",
    value=("P-STUP-00033 as written", "P-STUP-00033, wie geschrieben"),
    maximum=("the largest size in bytes", "die größte Größe in Byte"),
)
BACKWARD_WITHOUT_HISTORY = warning(
    50453,
    known_as=(900880, 50473),
    en="backward motion is commanded, but the path has no history; it continues forward",
    de="Rückwärtsfahren ist befohlen, aber die Bahn hat keine Historie; sie fährt vorwärts weiter",
    remedy_en="Give the channel memory: fb_storage_size (P-STUP-00033) in the start-up list.",
    remedy_de="Dem Kanal Speicher geben: fb_storage_size (P-STUP-00033) in der Hochlaufliste.",
    cause_en="P-STUP-00033 is 0, its default: backward motion is not available.",
    cause_de="P-STUP-00033 ist 0 (Standardwert): Rückwärtsfahren ist nicht verfügbar.",
)
BACKWARD_AT_HISTORY_START = warning(
    50449,
    known_as=(900890,),
    en="backward motion is commanded, but the history ends here: the program waits",
    de="Rückwärtsfahren ist befohlen, aber die Historie endet hier: das Programm wartet",
    remedy_en="Command forward motion: HLI.BACKWARD_MOTION = 0.",
    remedy_de="Vorwärtsfahren befehlen: HLI.BACKWARD_MOTION = 0.",
    cause_en="The history starts with the program, after a reset and where it was cleared.",
    cause_de="Die Historie beginnt mit dem Programm, nach einem Reset und nach dem Löschen.",
)
RT_WHILE_WITHOUT_HISTORY = error(
    51029,
    known_as=(900881,),
    en="#RT WHILE needs the history of the path, and this channel has none",
    de="#RT WHILE braucht die Historie der Bahn, und dieser Kanal hat keine",
    remedy_en="Give the channel memory: fb_storage_size (P-STUP-00033) in the start-up list.",
    remedy_de="Dem Kanal Speicher geben: fb_storage_size (P-STUP-00033) in der Hochlaufliste.",
    cause_en="The passes of a realtime loop are kept in the memory of backward motion.",
    cause_de="Die Durchläufe einer Echtzeit-Schleife liegen im Speicher des Rückwärtsfahrens.",
)
RT_WHILE_TOO_LONG = error(
    51027,
    known_as=(900882, 51029),
    en="the realtime loop has {count} motions; the history of the path holds {size} blocks",
    de="die Echtzeit-Schleife hat {count} Bewegungen; die Historie der Bahn fasst {size} Sätze",
    remedy_en="Increase fb_storage_size (P-STUP-00033), or shorten the loop.",
    remedy_de="fb_storage_size (P-STUP-00033) erhöhen oder die Schleife kürzen.",
    cause_en="A pass of a realtime loop has to fit into the memory of backward motion.",
    cause_de="Ein Durchlauf muss in den Speicher des Rückwärtsfahrens passen.",
    count=("the number of motions in the loop", "die Anzahl der Bewegungen in der Schleife"),
    size=(
        "the number of blocks that the history holds",
        "die Anzahl der Sätze, die die Historie fasst",
    ),
)
NOT_ALLOWED_IN_RT_WHILE = error(
    22073,
    en="{command} is not allowed in a realtime loop",
    de="{command} ist in einer Echtzeit-Schleife nicht erlaubt",
    remedy_en="Move it before #RT WHILE or after #RT ENDWHILE.",
    remedy_de="Den Befehl vor #RT WHILE oder nach #RT ENDWHILE programmieren.",
    cause_en="The realtime part repeats blocks that were decoded once: motions with G00 to G03, "
    "and values for synchronous V.E variables that do not depend on later events.",
    cause_de="Der Echtzeit-Teil wiederholt einmal dekodierte Sätze: Bewegungen mit G00 bis G03 und "
    "Werte für synchrone V.E-Variablen, die nicht von späteren Ereignissen abhängen.",
    classes=(3, 3),
)
RT_WHILE_DURING_COMPENSATION = error(
    22158,
    en="#RT WHILE is not allowed while tool radius compensation is active",
    de="#RT WHILE ist bei aktiver Werkzeugradiuskorrektur nicht erlaubt",
    remedy_en="Program G40 before the loop.",
    remedy_de="Vor der Schleife G40 programmieren.",
    cause_en="The path of a realtime loop must end where it began.",
    cause_de="Die Bahn einer Echtzeit-Schleife muss dort enden, wo sie begann.",
)
RT_WHILE_NESTED = error(
    22181,
    en="{found}: realtime loops follow one another, each with its own #RT ENDWHILE",
    de="{found}: Echtzeit-Schleifen stehen nacheinander, jede mit ihrem eigenen #RT ENDWHILE",
    remedy_en="Write one #RT ENDWHILE for each #RT WHILE, and do not nest realtime loops.",
    remedy_de="Zu jedem #RT WHILE ein #RT ENDWHILE schreiben; Echtzeit-Schleifen nicht schachteln.",
)
RT_WHILE_PATH_NOT_CLOSED = error(
    50991,
    en="the realtime loop ends {off} mm from where it starts (axis {axis})",
    de="die Echtzeit-Schleife endet {off} mm von ihrem Anfang entfernt (Achse {axis})",
    remedy_en="Let the last block return to where the loop was entered.",
    remedy_de="Den letzten Satz dorthin zurückführen, wo die Schleife begonnen hat.",
    cause_en="Each pass starts where the previous one ended; the path never jumps.",
    cause_de="Jeder Durchlauf beginnt, wo der vorige geendet hat; die Bahn springt nie.",
    off=(
        "the distance between start and end in mm or degrees",
        "der Abstand zwischen Anfang und Ende in mm oder Grad",
    ),
)
RT_WHILE_WITHOUT_END = error(
    50992,
    en="#RT WHILE without #RT ENDWHILE",
    de="#RT WHILE ohne #RT ENDWHILE",
    remedy_en="Close the realtime loop with #RT ENDWHILE.",
    remedy_de="Die Echtzeit-Schleife mit #RT ENDWHILE schließen.",
)
RT_WHILE_WITHOUT_MOTION = error(
    900883,
    en="nothing moves in the realtime loop",
    de="in der Echtzeit-Schleife bewegt sich nichts",
    remedy_en="Program at least one motion of non-zero length between #RT WHILE and #RT ENDWHILE.",
    remedy_de="Zwischen #RT WHILE und #RT ENDWHILE mindestens eine Bewegung mit Weg programmieren.",
    cause_en="A pass without a motion would take no time.",
    cause_de="Ein Durchlauf ohne Bewegung bräuchte keine Zeit.",
    classes=(2, 3),
)
EDGE_BANDING_NOT_SIMULATED = error(
    900884,
    en="G108: edge banding across blocks (P-CHAN-00029) is not simulated",
    de="G108: Kantenanleimen über Sätze hinweg (P-CHAN-00029) wird nicht simuliert",
    remedy_en="Set kasto_multi_block to 0 and measure within the block of the M function.",
    remedy_de="kasto_multi_block auf 0 setzen und im Satz der M-Funktion messen.",
    classes=(2, 3),
)
EDGE_NOT_FOUND = error(
    50891,
    en="the probe found no edge in the measuring block (G108)",
    de="der Taster hat im Messsatz keine Kante gefunden (G108)",
    remedy_en="Set HLI.PROBE to 1 while the block moves, or program a longer motion.",
    remedy_de="HLI.PROBE während der Bewegung des Satzes auf 1 setzen oder einen längeren Weg "
    "programmieren.",
    cause_en="A function of type MNE_SNS waits for the measuring event within its block.",
    cause_de="Eine Funktion der Art MNE_SNS wartet in ihrem Satz auf das Messereignis.",
    classes=(6, 6),
)
OPTIONAL_PART_WORDS = error(
    22132,
    en="#OPTIONAL EXECUTION has both APPROACH and SIMULATE",
    de="#OPTIONAL EXECUTION hat sowohl APPROACH als auch SIMULATE",
    remedy_en="Remove one of them.",
    remedy_de="Eines davon entfernen.",
)
OPTIONAL_PART_SWITCHED_TWICE = error(
    22143,
    en="#OPTIONAL EXECUTION has more than one of ON, OFF and CLEAR",
    de="#OPTIONAL EXECUTION hat mehr als eines von ON, OFF und CLEAR",
    remedy_en="Write one of them.",
    remedy_de="Eines davon schreiben.",
)
