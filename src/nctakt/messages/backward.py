# SPDX-License-Identifier: MIT
"""Messages of backward motion on the path and what works with its history (900880 … 900899)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    50450,
    WARNING,
    "the memory for backward motion, {value} bytes, is too small; {least} are used",
    "der Speicher für das Rückwärtsfahren, {value} Byte, ist zu klein; es gelten {least}",
    remedy_en="Give fb_storage_size at least {least}, or 0 where nothing goes back.",
    remedy_de="fb_storage_size mindestens {least} geben, oder 0, wo nichts rückwärts fährt.",
    cause_en="The history of the path shall hold some blocks in any case.",
    cause_de="Die Vorgeschichte der Bahn soll in jedem Fall einige Sätze fassen.",
    parameters={"value": "P-STUP-00033 as written", "least": "the least size in bytes"},
)
_add(
    900880,
    WARNING,
    "backward motion is commanded, but the path has no history; it goes on forward",
    "Rückwärtsfahren ist befohlen, aber die Bahn hat keine Vorgeschichte; sie fährt vorwärts",
    remedy_en="Give the channel memory: fb_storage_size (P-STUP-00033) in the start-up list.",
    remedy_de="Dem Kanal Speicher geben: fb_storage_size (P-STUP-00033) in der Hochlaufliste.",
    cause_en="P-STUP-00033 is 0, its default: backward motion is not available.",
    cause_de="P-STUP-00033 ist 0, seine Vorgabe: Rückwärtsfahren gibt es nicht.",
)
_add(
    900890,
    WARNING,
    "backward motion is commanded, and there is no way behind: the program waits",
    "Rückwärtsfahren ist befohlen, und es gibt keinen Weg zurück: das Programm wartet",
    remedy_en="Command forward: HLI.BACKWARD_MOTION = 0.",
    remedy_de="Vorwärts befehlen: HLI.BACKWARD_MOTION = 0.",
    cause_en="The history begins with the program, behind a reset and where it was cleared.",
    cause_de="Die Vorgeschichte beginnt mit dem Programm, nach einem Reset und nach dem Löschen.",
)
_add(
    900881,
    ERROR,
    "#RT WHILE needs the history of the path, and this channel has none",
    "#RT WHILE braucht die Vorgeschichte der Bahn, und dieser Kanal hat keine",
    remedy_en="Give the channel memory: fb_storage_size (P-STUP-00033) in the start-up list.",
    remedy_de="Dem Kanal Speicher geben: fb_storage_size (P-STUP-00033) in der Hochlaufliste.",
    cause_en="The passes of a realtime loop are kept in the memory of backward motion.",
    cause_de="Die Durchläufe einer Echtzeit-Schleife liegen im Speicher des Rückwärtsfahrens.",
    reaction=2,
    clearing=3,
)
_add(
    900882,
    ERROR,
    "the realtime loop has {count} motions; the history of the path holds {size} blocks",
    "die Echtzeit-Schleife hat {count} Bewegungen; die Vorgeschichte der Bahn fasst {size} Sätze",
    remedy_en="Raise fb_storage_size (P-STUP-00033), or shorten the loop.",
    remedy_de="fb_storage_size (P-STUP-00033) erhöhen oder die Schleife kürzen.",
    cause_en="A pass of a realtime loop has to fit into the memory of backward motion.",
    cause_de="Ein Durchlauf muss in den Speicher des Rückwärtsfahrens passen.",
    parameters={
        "count": "how many motions the loop has",
        "size": "how many blocks the history holds",
    },
    reaction=2,
    clearing=3,
)
_add(
    22073,
    ERROR,
    "{command} has no place in a realtime loop",
    "{command} hat in einer Echtzeit-Schleife keinen Platz",
    remedy_en="Move it in front of #RT WHILE or behind #RT ENDWHILE.",
    remedy_de="Es vor #RT WHILE oder hinter #RT ENDWHILE stellen.",
    cause_en="The realtime part repeats what was decoded once: motions with G00 to G03, and values "
    "for synchronous V.E variables that do not depend on what happens meanwhile.",
    cause_de="Der Echtzeit-Teil wiederholt, was einmal dekodiert wurde: Bewegungen mit G00 bis G03 "
    "und Werte für synchrone V.E-Variablen, die nicht von dem abhängen, was inzwischen geschieht.",
    parameters={"command": "the command as written"},
    reaction=3,
    clearing=3,
)
_add(
    22158,
    ERROR,
    "#RT WHILE while tool radius compensation is active",
    "#RT WHILE bei aktiver Werkzeugradiuskorrektur",
    remedy_en="Program G40 before the loop.",
    remedy_de="Vor der Schleife G40 programmieren.",
    cause_en="The path of a realtime loop has to end where it began.",
    cause_de="Die Bahn einer Echtzeit-Schleife muss enden, wo sie begann.",
    reaction=2,
    clearing=3,
)
_add(
    22181,
    ERROR,
    "{found}: realtime loops stand one behind the other, each with its #RT ENDWHILE",
    "{found}: Echtzeit-Schleifen stehen hintereinander, jede mit ihrem #RT ENDWHILE",
    remedy_en="Write one #RT ENDWHILE for each #RT WHILE, and none inside another.",
    remedy_de="Zu jedem #RT WHILE ein #RT ENDWHILE schreiben, und keines in einem anderen.",
    parameters={"found": "the command as written"},
    reaction=2,
    clearing=3,
)
_add(
    50991,
    ERROR,
    "the realtime loop ends {off} mm away from where it begins (axis {axis})",
    "die Echtzeit-Schleife endet {off} mm von ihrem Anfang entfernt (Achse {axis})",
    remedy_en="Let the last block go to where the loop was entered.",
    remedy_de="Den letzten Satz dorthin führen, wo die Schleife betreten wurde.",
    cause_en="Each pass begins where the one before has ended; the path never jumps.",
    cause_de="Jeder Durchlauf beginnt, wo der vorige geendet hat; die Bahn springt nie.",
    parameters={"off": "the distance of both in mm or degrees", "axis": "the axis"},
    reaction=2,
    clearing=3,
)
_add(
    50992,
    ERROR,
    "#RT WHILE without #RT ENDWHILE",
    "#RT WHILE ohne #RT ENDWHILE",
    remedy_en="Close the realtime loop with #RT ENDWHILE.",
    remedy_de="Die Echtzeit-Schleife mit #RT ENDWHILE schließen.",
    reaction=2,
    clearing=3,
)
_add(
    900883,
    ERROR,
    "nothing moves in the realtime loop",
    "in der Echtzeit-Schleife bewegt sich nichts",
    remedy_en="Program at least one motion with a way between #RT WHILE and #RT ENDWHILE.",
    remedy_de="Zwischen #RT WHILE und #RT ENDWHILE mindestens eine Bewegung mit Weg programmieren.",
    cause_en="A pass without a motion would take no time.",
    cause_de="Ein Durchlauf ohne Bewegung bräuchte keine Zeit.",
    reaction=2,
    clearing=3,
)
_add(
    900884,
    ERROR,
    "G108: edge banding across blocks (P-CHAN-00029) is not simulated",
    "G108: Kantenanleimen über Sätze hinweg (P-CHAN-00029) wird nicht simuliert",
    remedy_en="Set kasto_multi_block to 0 and measure within the block of the M function.",
    remedy_de="kasto_multi_block auf 0 setzen und im Satz der M-Funktion messen.",
    reaction=2,
    clearing=3,
)
_add(
    50891,
    ERROR,
    "the probe has found no edge in the block that measures it (G108)",
    "der Taster hat in dem Satz, der sie misst, keine Kante gefunden (G108)",
    remedy_en="Let HLI.PROBE become 1 while the block moves, or move farther.",
    remedy_de="HLI.PROBE während der Bewegung des Satzes 1 werden lassen, oder weiter fahren.",
    cause_en="A function of the type MNE_SNS waits for the measuring event within its block.",
    cause_de="Eine Funktion der Art MNE_SNS wartet in ihrem Satz auf das Messereignis.",
    reaction=6,
    clearing=6,
)
