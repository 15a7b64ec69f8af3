# SPDX-License-Identifier: MIT
"""Messages about checked programs: words and commands."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

NOT_SIMULATED = error(
    900200,
    en="{command} ({meaning}) is not simulated by this version",
    de="{command} ({meaning}) wird von dieser Version nicht simuliert",
    remedy_en="Leave it out: what it does would change positions or times. {instead}",
    remedy_de="Weglassen: die Wirkung würde Positionen oder Zeiten ändern. {instead}",
    command=("the word or command", "das Wort oder der Befehl"),
    meaning=("what it does", "was es tut"),
    instead=(
        "what to use in its place, in English, where there is something",
        "was man statt dessen verwendet, auf Englisch, wo es etwas gibt",
    ),
)
ACCEPTED_WITHOUT_EFFECT = note(
    900201,
    en="{command} ({meaning}) is accepted and has no effect here",
    de="{command} ({meaning}) wird angenommen und wirkt hier nicht",
    remedy_en="Nothing to do; this is told once per program.",
    remedy_de="Nichts zu tun; das wird einmal je Programm gemeldet.",
    command=("the word or command", "das Wort oder der Befehl"),
    meaning=("what it does", "was es tut"),
)
UNKNOWN_COMMAND = error(
    900202,
    en="nobody knows the command {word}",
    de="den Befehl {word} kennt niemand",
    remedy_en="Most similar: {nearest}",
    remedy_de="Am ähnlichsten: {nearest}",
    word=("the word as written", "das Wort, wie geschrieben"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
UNKNOWN_WORD = error(
    900203,
    en="{word} is neither a word of the language nor an axis or spindle of this channel",
    de="{word} ist weder ein Wort der Sprache noch eine Achse oder Spindel dieses Kanals",
    remedy_en="Axes of the channel: {axes}; most similar: {nearest}",
    remedy_de="Achsen des Kanals: {axes}; am ähnlichsten: {nearest}",
    word=("the word as written", "das Wort, wie geschrieben"),
    axes=("names of the channel's axes", "Namen der Achsen des Kanals"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
INVALID_FUNCTION_NUMBER = error(
    900204,
    en="there is no function {word}",
    de="eine Funktion {word} gibt es nicht",
    remedy_en="Write the number of a G, M or H function, a whole one.",
    remedy_de="Die Nummer einer G-, M- oder H-Funktion schreiben, eine ganze Zahl.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
FUNCTION_NOT_DEFINED = error(
    900205,
    en="the channel list does not define {word}",
    de="die Kanalliste definiert {word} nicht",
    remedy_en="Give it a synchronisation type there: {key} MOS",
    remedy_de="Dort eine Synchronisationsart angeben: {key} MOS",
    word=("the word as written", "das Wort, wie geschrieben"),
    key=("the key of the channel list", "der Schlüssel in der Kanalliste"),
)
AXIS_FUNCTION_IN_CYCLE = error(
    900206,
    en="{word} belongs to axis {axis}; a realtime cycle outputs functions of the channel only",
    de="{word} gehört zur Achse {axis}; ein Echtzeit-Zyklus gibt nur Funktionen des Kanals aus",
    remedy_en="Use another function, or take {key} out of the channel list.",
    remedy_de="Eine andere Funktion verwenden oder {key} aus der Kanalliste nehmen.",
    word=("the word as written", "das Wort, wie geschrieben"),
    axis=("the axis that the channel list names", "die Achse, die die Kanalliste nennt"),
    key=("the key of the channel list", "der Schlüssel in der Kanalliste"),
)
PROGRAM_CONTROL_IN_CYCLE = error(
    900207,
    en="{word} controls programs and has no place in a realtime cycle",
    de="{word} steuert Programme und hat im Echtzeit-Zyklus keinen Platz",
    remedy_en="Output another M function and let the PLC react to it.",
    remedy_de="Eine andere M-Funktion ausgeben und die SPS darauf reagieren lassen.",
    cause_en="Such functions end programs or call them, which only the decoder can do.",
    cause_de="Solche Funktionen beenden Programme oder rufen sie auf; das kann nur der Dekoder.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
WORD_VALUE_MISSING = error(
    900208,
    en="a value is missing behind {word}",
    de="hinter {word} fehlt ein Wert",
    remedy_en="Write a number, a variable or an expression behind it.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck dahinter schreiben.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
DUPLICATE_WORD = error(
    900209,
    en="{word} stands twice in this block",
    de="{word} steht zweimal in diesem Satz",
    remedy_en="Keep the one that is meant.",
    remedy_de="Das behalten, das gemeint ist.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
EXCLUSIVE_WORDS = error(
    900210,
    en="{word} and {other} exclude each other in one block",
    de="{word} und {other} schließen sich in einem Satz aus",
    remedy_en="Divide the block, or keep one of both.",
    remedy_de="Den Satz teilen oder eines von beiden behalten.",
    word=("the word as written", "das Wort, wie geschrieben"),
    other=("the function that stands before it", "die Funktion davor"),
)
G04_NOT_ALONE = error(
    900211,
    en="G04 stands alone in its block, with one time in seconds",
    de="G04 steht allein im Satz, mit einer Zeit in Sekunden",
    remedy_en="Write G04 X0.5 or G04 0.5.",
    remedy_de="G04 X0.5 oder G04 0.5 schreiben.",
)
EXTRA_PARAMETERS = error(
    900212,
    en="{word} takes nothing further",
    de="zu {word} gehört nichts Weiteres",
    remedy_en="Remove what stands behind the number.",
    remedy_de="Entfernen, was hinter der Nummer steht.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
NOT_NC_TEXT = error(
    900229,
    en="this block is no NC text",
    de="dieser Satz ist kein NC-Text",
    remedy_en="Make it a comment.",
    remedy_de="Zum Kommentar machen.",
)
FORMAT_VALUE_COUNT = error(
    900230,
    en="the text has places for {expected} values, {given} are given",
    de="der Text hat Platz für {expected} Werte, angegeben sind {given}",
    remedy_en="Write one value for each %d, %f or %s; %% is the sign itself.",
    remedy_de="Zu jedem %d, %f oder %s einen Wert schreiben; %% ist das Zeichen selbst.",
    expected=("places in the text", "Plätze im Text"),
    given=("values behind it", "Werte dahinter"),
)
INVALID_PLACEHOLDER = error(
    900231,
    en="{word} is no place for a value",
    de="{word} ist kein Platz für einen Wert",
    remedy_en="Write %d, %f, %e, %g, %x or %s, or %% for the sign itself.",
    remedy_de="%d, %f, %e, %g, %x oder %s schreiben, oder %% für das Zeichen selbst.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
TEXT_FOR_NUMERIC_WORD = error(
    900232,
    en="{word} takes a number, no text",
    de="{word} nimmt eine Zahl, keinen Text",
    remedy_en="Write %s in its place, or give a number.",
    remedy_de="%s an dieser Stelle schreiben oder eine Zahl angeben.",
    word=("the place in the text", "der Platz im Text"),
)
INVALID_COMMAND_FORM = error(
    900233,
    en="{command} does not have this form",
    de="{command} hat diese Form nicht",
    remedy_en="It is written so: {forms}",
    remedy_de="Es wird so geschrieben: {forms}",
    command=("the command", "der Befehl"),
    forms=("the forms that it has", "die Formen, die es hat"),
)
UNKNOWN_COMMAND_OPTION = error(
    900234,
    en="{command} has no option {word}",
    de="{command} hat keine Option {word}",
    remedy_en="One of these is possible: {names}",
    remedy_de="Möglich sind: {names}",
    command=("the command", "der Befehl"),
    word=("the word as written", "das Wort, wie geschrieben"),
    names=("the options that exist", "die Optionen, die es gibt"),
)
G60_WITHOUT_MOTION = error(
    20003,
    en="G60 in a block without motion",
    de="G60 in einem Satz ohne Bewegung",
    remedy_en="Write it into the block at whose end the axes shall stand.",
    remedy_de="In den Satz schreiben, an dessen Ende die Achsen stehen sollen.",
    reaction=2,
    clearing=3,
)
WORD_VALUE_OUT_OF_RANGE = error(
    900847,
    en="{word}: {value} is not between {least} and {most}",
    de="{word}: {value} liegt nicht zwischen {least} und {most}",
    remedy_en="The PLC gets a whole number of 32 bits with an M or H function.",
    remedy_de="Die SPS erhält mit einer M- oder H-Funktion eine ganze Zahl von 32 Bit.",
    word=("the word as written", "das Wort, wie geschrieben"),
    value=("the value, rounded", "der Wert, gerundet"),
    least=("lower limit", "untere Grenze"),
    most=("upper limit", "obere Grenze"),
    reaction=2,
    clearing=3,
)
G163_WITHOUT_RADIUS = error(
    900927,
    en="G163 without a radius",
    de="G163 ohne Radius",
    remedy_en="Write G163=10: the radius of this arc and of those behind it, as R10.",
    remedy_de="G163=10 schreiben: der Radius dieses Kreises und der folgenden, wie R10.",
    reaction=2,
    clearing=3,
)
