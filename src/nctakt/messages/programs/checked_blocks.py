# SPDX-License-Identifier: MIT
"""Messages about checked programs: words and commands."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import (
    by_beginning,
    by_group,
    by_word,
    by_word_or_group,
    unknown_functions,
)
from nctakt.messages.catalogue import error, note

NOT_SIMULATED = error(
    900200,
    en="{command} ({meaning}) is not simulated by this version",
    de="{command} ({meaning}) wird von dieser Version nicht simuliert",
    remedy_en="{advice}",
    remedy_de="{advice}",
    meaning=("its effect", "die Wirkung"),
    advice=(
        "what to do, and what to use instead if there is something",
        "was zu tun ist, und was man stattdessen verwendet, falls es etwas gibt",
    ),
)
ACCEPTED_WITHOUT_EFFECT = note(
    900201,
    en="{command} ({meaning}) is accepted and has no effect here",
    de="{command} ({meaning}) wird akzeptiert und hat hier keine Wirkung",
    remedy_en="Nothing to do; this is reported once per program.",
    remedy_de="Nichts zu tun; das wird einmal je Programm gemeldet.",
    meaning=("its effect", "die Wirkung"),
)
UNKNOWN_COMMAND = error(
    20209,
    classes=(0, 0),
    known_as=(900202,),
    cases=by_beginning("word", {"#": 20509}),
    en="unknown command {word}",
    de="unbekannter Befehl {word}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
UNKNOWN_WORD = error(
    20797,
    classes=(0, 0),
    known_as=(900203, 20180, 20875, 21047),
    en="unknown word {word}: neither a word of the language nor an axis or spindle of this channel",
    de="unbekanntes Wort {word}: weder Sprachelement noch Achse oder Spindel dieses Kanals",
    remedy_en="Axes of the channel: {axes}; most similar: {nearest}",
    remedy_de="Achsen des Kanals: {axes}; am ähnlichsten: {nearest}",
)
INVALID_FUNCTION_NUMBER = error(
    20107,
    classes=(0, 0),
    known_as=(900204,),
    cases=Cases((20131, 20154, 20161), unknown_functions),
    en="{word} is not a valid function",
    de="{word} ist keine gültige Funktion",
    remedy_en="Give the number of a G, M or H function as a whole number.",
    remedy_de="Die Nummer einer G-, M- oder H-Funktion als ganze Zahl angeben.",
)
NO_PROGRAM_FOR_G_FUNCTION = error(
    20131,
    en="unknown G function {word}: the channel list names no program for it",
    de="unbekannte G-Funktion {word}: die Kanalliste nennt kein Programm dafür",
    remedy_en='Name the program: {key} FILE in the channel list, or #FILE NAME [{word}="FILE"]',
    remedy_de='Programm nennen: {key} DATEI in der Kanalliste, oder #FILE NAME [{word}="DATEI"]',
    cause_en="G80 … G89 and G800 … G839 call programs of the user (P-CHAN-00160 … 00169, "
    "P-CHAN-00187).",
    cause_de="G80 … G89 und G800 … G839 rufen Programme des Anwenders auf (P-CHAN-00160 … 00169, "
    "P-CHAN-00187).",
    word=("the function", "die Funktion"),
    key=("the key of the channel list", "der Schlüssel in der Kanalliste"),
)
FUNCTION_NOT_DEFINED = error(
    900205,
    cases=by_word("word", {"M": 20157, "H": 20162}),
    en="{word} is not defined in the channel list",
    de="{word} ist in der Kanalliste nicht definiert",
    remedy_en="Give it a synchronisation type there, for example {key} MOS",
    remedy_de="Dort eine Synchronisationsart angeben, zum Beispiel {key} MOS",
    key=("the key of the channel list", "der Schlüssel in der Kanalliste"),
)
AXIS_FUNCTION_IN_CYCLE = error(
    900206,
    known_as=(22002,),
    en="{word} belongs to axis {axis}; a realtime cycle outputs only functions of the channel",
    de="{word} gehört zur Achse {axis}; ein Echtzeit-Zyklus gibt nur Funktionen des Kanals aus",
    remedy_en="Use another function, or remove {key} from the channel list.",
    remedy_de="Eine andere Funktion verwenden oder {key} aus der Kanalliste entfernen.",
    axis=("the axis that the channel list names", "die Achse, die die Kanalliste nennt"),
    key=("the key of the channel list", "der Schlüssel in der Kanalliste"),
)
PROGRAM_CONTROL_IN_CYCLE = error(
    900207,
    known_as=(50939,),
    en="{word} controls programs and is not allowed in a realtime cycle",
    de="{word} steuert Programme und ist im Echtzeit-Zyklus nicht erlaubt",
    remedy_en="Output another M function and let the PLC react to it.",
    remedy_de="Eine andere M-Funktion ausgeben und die SPS darauf reagieren lassen.",
    cause_en="Such functions end or call programs, which only the decoder can do.",
    cause_de="Solche Funktionen beenden Programme oder rufen sie auf; das kann nur der Dekoder.",
)
WORD_VALUE_MISSING = error(
    900208,
    known_as=(21461,),
    en="the value after {word} is missing",
    de="nach {word} fehlt der Wert",
    remedy_en="Write a number, a variable or an expression after it.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck angeben.",
)
DUPLICATE_WORD = error(
    20203,
    classes=(0, 0),
    known_as=(900209, 21785),
    cases=by_word_or_group(
        {
            "F": 20175,
            "I": 20205,
            "J": 20205,
            "K": 20205,
            "S": 20181,
            "T": 20165,
            "D": 20170,
            "N": 20841,
            "M": 20765,
            "H": 20766,
        }
    ),
    en="{word} is given twice in this block",
    de="{word} ist in diesem Satz doppelt angegeben",
    remedy_en="Keep the one that you need.",
    remedy_de="Nur das gewünschte behalten.",
)
EXCLUSIVE_WORDS = error(
    900210,
    known_as=(20109, 20115, 20119, 20123, 20124, 20125, 20129, 20792, 20810, 20846),
    cases=by_group(),
    en="{word} and {other} must not be in the same block",
    de="{word} und {other} dürfen nicht im selben Satz stehen",
    remedy_en="Split the block, or keep one of them.",
    remedy_de="Den Satz aufteilen oder eines davon behalten.",
    other=("the function before it", "die Funktion davor"),
)
G04_NOT_ALONE = error(
    20685,
    classes=(0, 0),
    known_as=(900211,),
    en="G04 must be alone in its block, with one time in seconds",
    de="G04 muss allein im Satz stehen, mit einer Zeit in Sekunden",
    remedy_en="Write G04 X0.5 or G04 0.5.",
    remedy_de="G04 X0.5 oder G04 0.5 schreiben.",
)
G04_WITHOUT_TIME = error(
    21786,
    classes=(0, 0),
    en="G04 without a time",
    de="G04 ohne Zeit",
    remedy_en="Give the time in seconds: G04 X0.5 or G04 0.5",
    remedy_de="Die Zeit in Sekunden angeben: G04 X0.5 oder G04 0.5",
)
G04_WITH_TWO_TIMES = error(
    21785,
    classes=(0, 0),
    en="G04 with more than one time",
    de="G04 mit mehr als einer Zeit",
    remedy_en="Keep one of them: G04 X0.5 or G04 0.5",
    remedy_de="Nur eine davon behalten: G04 X0.5 oder G04 0.5",
)
EXTRA_PARAMETERS = error(
    900212,
    known_as=(20744, 20745, 21542),
    en="{word} takes no further parameters",
    de="{word} hat keine weiteren Parameter",
    remedy_en="Remove the text after the number.",
    remedy_de="Alles hinter der Nummer entfernen.",
)
NOT_NC_TEXT = error(
    900229,
    known_as=(20797,),
    en="this block is not valid NC text",
    de="dieser Satz ist kein gültiger NC-Text",
    remedy_en="Correct it, or make it a comment.",
    remedy_de="Korrigieren oder zum Kommentar machen.",
)
FORMAT_VALUE_COUNT = error(
    20721,
    classes=(0, 0),
    known_as=(900230,),
    en="placeholders in the text: {expected}, values given: {given}",
    de="Platzhalter im Text: {expected}, angegebene Werte: {given}",
    remedy_en="Give one value for each %d, %f or %s; write %% for a percent sign.",
    remedy_de="Zu jedem %d, %f oder %s einen Wert angeben; %% steht für ein Prozentzeichen.",
    expected=("the number of placeholders in the text", "die Anzahl der Platzhalter im Text"),
    given=("the number of values", "die Anzahl der Werte"),
)
INVALID_PLACEHOLDER = error(
    21180,
    classes=(0, 0),
    known_as=(900231, 21232),
    en="{word} is not a valid placeholder",
    de="{word} ist kein gültiger Platzhalter",
    remedy_en="Write %d, %f, %e, %g, %x or %s, or %% for a percent sign.",
    remedy_de="%d, %f, %e, %g, %x oder %s schreiben, oder %% für ein Prozentzeichen.",
)
TEXT_FOR_NUMERIC_WORD = error(
    900232,
    known_as=(21457,),
    en="{word} needs a number, not a text",
    de="{word} braucht eine Zahl, keinen Text",
    remedy_en="Write %s instead, or give a number.",
    remedy_de="Stattdessen %s schreiben oder eine Zahl angeben.",
    word=("the placeholder in the text", "der Platzhalter im Text"),
)
INVALID_COMMAND_FORM = error(
    900233,
    known_as=(20499, 20675, 20994, 21104, 21107),
    en="{command} has no such form",
    de="diese Form von {command} gibt es nicht",
    remedy_en="Write: {forms}",
    remedy_de="Schreibweise: {forms}",
    forms=("the valid forms", "die gültigen Formen"),
)
UNKNOWN_COMMAND_OPTION = error(
    21220,
    classes=(0, 0),
    known_as=(900234, 21711),
    en="{command} has no option {word}",
    de="{command} hat keine Option {word}",
    remedy_en="Possible options: {names}",
    remedy_de="Mögliche Optionen: {names}",
    names=("the options that exist", "die Optionen, die es gibt"),
)
G60_WITHOUT_MOTION = error(
    20003,
    en="G60 in a block without motion",
    de="G60 in einem Satz ohne Bewegung",
    remedy_en="Write it in the block at whose end the axes should stop.",
    remedy_de="In den Satz schreiben, an dessen Ende die Achsen anhalten sollen.",
)
WORD_VALUE_OUT_OF_RANGE = error(
    900847,
    cases=by_word("word", {"M": 21494, "H": 21495}),
    en="{word}: {value} is not between {minimum} and {maximum}",
    de="{word}: {value} liegt nicht zwischen {minimum} und {maximum}",
    remedy_en="An M or H function passes the PLC a 32-bit whole number.",
    remedy_de="Mit einer M- oder H-Funktion erhält die SPS eine ganze Zahl mit 32 Bit.",
    value=("the value, rounded", "der Wert, gerundet"),
    minimum=("lower limit", "untere Grenze"),
    classes=(2, 3),
)
G163_WITHOUT_RADIUS = error(
    900927,
    known_as=(20402,),
    en="G163 without a radius",
    de="G163 ohne Radius",
    remedy_en="Write G163=10: the radius of this arc and of those that follow, as with R10.",
    remedy_de="G163=10 schreiben: der Radius dieses und der folgenden Kreisbögen, wie bei R10.",
    classes=(2, 3),
)
