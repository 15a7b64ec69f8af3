# SPDX-License-Identifier: MIT
"""Messages of checked program: words and commands.

Numbers 900200 … 900212, 900229 … 900249, 900847, 900927.
"""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_KNOWN = {
    "command": "the word or command",
    "meaning_en": "what it does, in English",
    "meaning_de": "what it does, in German",
}
_WORD = {"word": "the word as written"}
_NEAREST = {"nearest": "the most similar known name, or –"}

_add(
    900200,
    ERROR,
    "{command} ({meaning_en}) is not simulated by this version",
    "{command} ({meaning_de}) wird von dieser Version nicht simuliert",
    remedy_en="Leave it out: what it does would change positions or times.{instead_en}",
    remedy_de="Weglassen: die Wirkung würde Positionen oder Zeiten ändern.{instead_de}",
    parameters={
        **_KNOWN,
        "instead_en": "what to use in its place, in English, where there is something",
        "instead_de": "what to use in its place, in German, where there is something",
    },
)
_add(
    900201,
    NOTE,
    "{command} ({meaning_en}) is accepted and has no effect here",
    "{command} ({meaning_de}) wird angenommen und wirkt hier nicht",
    remedy_en="Nothing to do; this is told once per program.",
    remedy_de="Nichts zu tun; das wird einmal je Programm gemeldet.",
    parameters=_KNOWN,
)
_add(
    900202,
    ERROR,
    "nobody knows the command {word}",
    "den Befehl {word} kennt niemand",
    remedy_en="Most similar: {nearest}",
    remedy_de="Am ähnlichsten: {nearest}",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900203,
    ERROR,
    "{word} is neither a word of the language nor an axis or spindle of this channel",
    "{word} ist weder ein Wort der Sprache noch eine Achse oder Spindel dieses Kanals",
    remedy_en="Axes of the channel: {axes}; most similar: {nearest}",
    remedy_de="Achsen des Kanals: {axes}; am ähnlichsten: {nearest}",
    parameters={**_WORD, "axes": "names of the channel's axes", **_NEAREST},
)
_add(
    900204,
    ERROR,
    "there is no function {word}",
    "eine Funktion {word} gibt es nicht",
    remedy_en="Write the number of a G, M or H function, a whole one.",
    remedy_de="Die Nummer einer G-, M- oder H-Funktion schreiben, eine ganze Zahl.",
    parameters=_WORD,
)
_add(
    900205,
    ERROR,
    "the channel list does not define {word}",
    "die Kanalliste definiert {word} nicht",
    remedy_en="Give it a synchronisation type there: {key} MOS",
    remedy_de="Dort eine Synchronisationsart angeben: {key} MOS",
    parameters={**_WORD, "key": "the key of the channel list"},
)
_add(
    900206,
    ERROR,
    "{word} belongs to axis {axis}; a realtime cycle outputs functions of the channel only",
    "{word} gehört zur Achse {axis}; ein Echtzeit-Zyklus gibt nur Funktionen des Kanals aus",
    remedy_en="Use another function, or take {key} out of the channel list.",
    remedy_de="Eine andere Funktion verwenden oder {key} aus der Kanalliste nehmen.",
    parameters={
        **_WORD,
        "axis": "the axis that the channel list names",
        "key": "the key of the channel list",
    },
)
_add(
    900207,
    ERROR,
    "{word} controls programs and has no place in a realtime cycle",
    "{word} steuert Programme und hat im Echtzeit-Zyklus keinen Platz",
    remedy_en="Output another M function and let the PLC react to it.",
    remedy_de="Eine andere M-Funktion ausgeben und die SPS darauf reagieren lassen.",
    cause_en="Such functions end programs or call them, which only the decoder can do.",
    cause_de="Solche Funktionen beenden Programme oder rufen sie auf; das kann nur der Dekoder.",
    parameters=_WORD,
)
_add(
    900208,
    ERROR,
    "a value is missing behind {word}",
    "hinter {word} fehlt ein Wert",
    remedy_en="Write a number, a variable or an expression behind it.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck dahinter schreiben.",
    parameters=_WORD,
)
_add(
    900209,
    ERROR,
    "{word} stands twice in this block",
    "{word} steht zweimal in diesem Satz",
    remedy_en="Keep the one that is meant.",
    remedy_de="Das behalten, das gemeint ist.",
    parameters=_WORD,
)
_add(
    900210,
    ERROR,
    "{word} and {other} exclude each other in one block",
    "{word} und {other} schließen sich in einem Satz aus",
    remedy_en="Divide the block, or keep one of both.",
    remedy_de="Den Satz teilen oder eines von beiden behalten.",
    parameters={**_WORD, "other": "the function that stands before it"},
)
_add(
    900211,
    ERROR,
    "G04 stands alone in its block, with one time in seconds",
    "G04 steht allein im Satz, mit einer Zeit in Sekunden",
    remedy_en="Write G04 X0.5 or G04 0.5.",
    remedy_de="G04 X0.5 oder G04 0.5 schreiben.",
)
_add(
    900212,
    ERROR,
    "{word} takes nothing further",
    "zu {word} gehört nichts Weiteres",
    remedy_en="Remove what stands behind the number.",
    remedy_de="Entfernen, was hinter der Nummer steht.",
    parameters=_WORD,
)
_add(
    900229,
    ERROR,
    "this block is no NC text",
    "dieser Satz ist kein NC-Text",
    remedy_en="Make it a comment.",
    remedy_de="Zum Kommentar machen.",
)
_add(
    900230,
    ERROR,
    "the text has places for {expected} values, {given} are given",
    "der Text hat Platz für {expected} Werte, angegeben sind {given}",
    remedy_en="Write one value for each %d, %f or %s; %% is the sign itself.",
    remedy_de="Zu jedem %d, %f oder %s einen Wert schreiben; %% ist das Zeichen selbst.",
    parameters={"expected": "places in the text", "given": "values behind it"},
)
_add(
    900231,
    ERROR,
    "{word} is no place for a value",
    "{word} ist kein Platz für einen Wert",
    remedy_en="Write %d, %f, %e, %g, %x or %s, or %% for the sign itself.",
    remedy_de="%d, %f, %e, %g, %x oder %s schreiben, oder %% für das Zeichen selbst.",
    parameters=_WORD,
)
_add(
    900232,
    ERROR,
    "{word} takes a number, no text",
    "{word} nimmt eine Zahl, keinen Text",
    remedy_en="Write %s in its place, or give a number.",
    remedy_de="%s an dieser Stelle schreiben oder eine Zahl angeben.",
    parameters={"word": "the place in the text"},
)
_add(
    900233,
    ERROR,
    "{command} does not have this form",
    "{command} hat diese Form nicht",
    remedy_en="It is written so: {forms}",
    remedy_de="Es wird so geschrieben: {forms}",
    parameters={"command": "the command", "forms": "the forms that it has"},
)
_add(
    900234,
    ERROR,
    "{command} has no option {word}",
    "{command} hat keine Option {word}",
    remedy_en="One of these is possible: {names}",
    remedy_de="Möglich sind: {names}",
    parameters={"command": "the command", **_WORD, "names": "the options that exist"},
)
_add(
    20003,
    ERROR,
    "G60 in a block without motion",
    "G60 in einem Satz ohne Bewegung",
    remedy_en="Write it into the block at whose end the axes shall stand.",
    remedy_de="In den Satz schreiben, an dessen Ende die Achsen stehen sollen.",
    reaction=2,
    clearing=3,
)
_add(
    900847,
    ERROR,
    "{word}: {value} is not between {least} and {most}",
    "{word}: {value} liegt nicht zwischen {least} und {most}",
    remedy_en="The PLC gets a whole number of 32 bits with an M or H function.",
    remedy_de="Die SPS erhält mit einer M- oder H-Funktion eine ganze Zahl von 32 Bit.",
    parameters={
        **_WORD,
        "value": "the value, rounded",
        "least": "lower limit",
        "most": "upper limit",
    },
    reaction=2,
    clearing=3,
)
_add(
    900927,
    ERROR,
    "G163 without a radius",
    "G163 ohne Radius",
    remedy_en="Write G163=10: the radius of this arc and of those behind it, as R10.",
    remedy_de="G163=10 schreiben: der Radius dieses Kreises und der folgenden, wie R10.",
    reaction=2,
    clearing=3,
)
