# SPDX-License-Identifier: MIT
"""Messages of NC text: lexer and parser (900100 … 900199)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_FOUND = {"found": "what stands at that place"}

_add(
    900100,
    ERROR,
    "nobody knows what {found} means here",
    "mit {found} ist hier nichts anzufangen",
    remedy_en="Remove it, or write the block as the grammar has it.",
    remedy_de="Entfernen oder den Satz nach der Grammatik schreiben.",
    parameters=_FOUND,
)
_add(
    900101,
    ERROR,
    "a value is missing before {found}",
    "vor {found} fehlt ein Wert",
    remedy_en="Write a number, a variable or an expression.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck schreiben.",
    parameters=_FOUND,
)
_add(
    900102,
    ERROR,
    "this bracket is not closed",
    "diese Klammer wird nicht geschlossen",
    remedy_en="Write ']'; a command goes on in the next line only if this one ends with '\\'.",
    remedy_de="']' schreiben; ein Befehl geht nur weiter, wenn die Zeile mit '\\' endet.",
)
_add(
    900103,
    ERROR,
    "']' without '['",
    "']' ohne '['",
    remedy_en="Remove it, or open the bracket before.",
    remedy_de="Entfernen oder die Klammer vorher öffnen.",
)
_add(
    900104,
    ERROR,
    "this text has no closing quote",
    "diesem Text fehlt das schließende Anführungszeichen",
    remedy_en='Write " at its end; a text stays in one line.',
    remedy_de='Am Ende " schreiben; ein Text bleibt in einer Zeile.',
)
_add(
    900105,
    ERROR,
    "{begin} is never closed",
    "{begin} wird nie geschlossen",
    remedy_en="Write {end}; structures end in the opposite order of their begin.",
    remedy_de="{end} schreiben; Strukturen enden umgekehrt, wie sie beginnen.",
    parameters={"begin": "the word that opens the structure", "end": "the word that closes it"},
)
_add(
    900106,
    ERROR,
    "{word} without {begin}",
    "{word} ohne {begin}",
    remedy_en="Remove it, or write {begin} before.",
    remedy_de="Entfernen oder vorher {begin} schreiben.",
    parameters={"word": "the word at that place", "begin": "the word that should come before"},
)
_add(
    900107,
    ERROR,
    "{word} is no control word",
    "{word} ist kein Kontrollwort",
    remedy_en="Perhaps {suggestion} is meant; no blank stands behind $.",
    remedy_de="Vielleicht ist {suggestion} gemeint; hinter $ steht kein Leerzeichen.",
    parameters={"word": "the word as written", "suggestion": "the most similar control word"},
)
_add(
    900108,
    ERROR,
    "this is no text: here stands a byte 0",
    "das ist kein Text: hier steht ein Byte 0",
    remedy_en="Give an NC program; reading ends here.",
    remedy_de="Ein NC-Programm angeben; hier endet das Lesen.",
)
_add(
    900109,
    WARNING,
    "the program is empty",
    "das Programm ist leer",
    remedy_en="Write at least the program end, M30.",
    remedy_de="Wenigstens das Programmende M30 schreiben.",
)
_add(
    900110,
    WARNING,
    "the block has {length} characters, the manual allows {limit}",
    "der Satz hat {length} Zeichen, das Handbuch erlaubt {limit}",
    remedy_en="Divide it: the machine's controller may refuse it.",
    remedy_de="Teilen: die Steuerung der Maschine lehnt ihn möglicherweise ab.",
    parameters={"length": "characters of the block", "limit": "characters allowed"},
)
_add(
    900111,
    ERROR,
    "{begin} stands inside more than {limit} other structures",
    "{begin} steht in mehr als {limit} anderen Strukturen",
    remedy_en="Take the inner part out into a subprogram.",
    remedy_de="Den inneren Teil in ein Unterprogramm auslagern.",
    parameters={"begin": "the word that opens the structure", "limit": "structures allowed"},
)
_add(
    900112,
    ERROR,
    "this comment is never ended",
    "dieser Kommentar endet nie",
    remedy_en="Write #COMMENT END alone in a block.",
    remedy_de="#COMMENT END allein in einen Satz schreiben.",
)
_add(
    900113,
    ERROR,
    "'{symbol}' is missing before {found}",
    "vor {found} fehlt '{symbol}'",
    remedy_en="Write '{symbol}'.",
    remedy_de="'{symbol}' schreiben.",
    parameters={"symbol": "what has to stand there", **_FOUND},
)
_add(
    900114,
    ERROR,
    "a name is missing before {found}",
    "vor {found} fehlt ein Name",
    remedy_en="Write the name of the variable, label, program or command that is meant.",
    remedy_de="Den Namen schreiben: der Variablen, der Marke, des Programms, des Befehls.",
    parameters=_FOUND,
)
_add(
    900115,
    ERROR,
    "a statement between $SWITCH and its first $CASE",
    "eine Anweisung zwischen $SWITCH und dem ersten $CASE",
    remedy_en="Put it before $SWITCH or into a branch.",
    remedy_de="Vor $SWITCH oder in einen Zweig setzen.",
)
_add(
    900116,
    ERROR,
    "only declarations stand between #VAR and #ENDVAR",
    "zwischen #VAR und #ENDVAR stehen nur Deklarationen",
    remedy_en="Write V.L.NAME : TYPE = value, or close with #ENDVAR before.",
    remedy_de="V.L.NAME : TYP = Wert schreiben oder vorher mit #ENDVAR schließen.",
)
_add(
    900117,
    WARNING,
    "the file has a main program already; %{name} does not run",
    "die Datei hat schon ein Hauptprogramm; %{name} läuft nicht",
    remedy_en="Begin a subprogram with %L, or use a file of its own.",
    remedy_de="Ein Unterprogramm mit %L beginnen oder eine eigene Datei verwenden.",
    parameters={"name": "what stands behind %"},
)
_add(
    900118,
    WARNING,
    "what stands behind the program end is no NC text from here on",
    "was hinter dem Programmende steht, ist ab hier kein NC-Text",
    remedy_en="Make it a comment; a run that jumps there would end with an error.",
    remedy_de="Zum Kommentar machen; ein Lauf, der dorthin springt, endet mit einem Fehler.",
)
_add(
    900119,
    ERROR,
    "this number is too large",
    "diese Zahl ist zu groß",
    remedy_en="Write a number below 1.8 times 10 to the power of 308.",
    remedy_de="Eine Zahl unter 1,8 mal 10 hoch 308 schreiben.",
)
_add(
    900120,
    ERROR,
    "{word} behind the $ELSE of the same $IF",
    "{word} hinter dem $ELSE desselben $IF",
    remedy_en="Put $ELSE last, once, or close the $IF before.",
    remedy_de="$ELSE einmal und zuletzt schreiben oder das $IF vorher schließen.",
    parameters={"word": "the word at that place"},
)
_add(
    900122,
    ERROR,
    "there is no skip level {level}: levels are 1 to {limit}",
    "es gibt keine Ausblendebene {level}: Ebenen sind 1 bis {limit}",
    remedy_en="Write / or /1 to /{limit}",
    remedy_de="/ oder /1 bis /{limit} schreiben.",
    parameters={"level": "the level as written", "limit": "the highest level"},
)
_add(
    20301,
    ERROR,
    "the block has {length} characters, {limit} can be read",
    "der Satz hat {length} Zeichen, lesbar sind {limit}",
    remedy_en="Divide it into several blocks.",
    remedy_de="In mehrere Sätze teilen.",
    parameters={"length": "characters of the block", "limit": "characters that can be read"},
    reaction=2,
    clearing=3,
)
_add(
    20566,
    ERROR,
    "#COMMENT BEGIN is not alone in its block",
    "#COMMENT BEGIN steht nicht allein im Satz",
    remedy_en="Put it into a block of its own.",
    remedy_de="In einen eigenen Satz schreiben.",
    reaction=2,
    clearing=3,
)
_add(
    20569,
    ERROR,
    "#COMMENT END is not alone in its block",
    "#COMMENT END steht nicht allein im Satz",
    remedy_en="Put it into a block of its own.",
    remedy_de="In einen eigenen Satz schreiben.",
    reaction=2,
    clearing=3,
)
_add(
    21985,
    ERROR,
    "#RT CYCLE has no keyword {keyword}",
    "#RT CYCLE hat kein Schlüsselwort {keyword}",
    remedy_en="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION.",
    remedy_de="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION.",
    cause_en="The brackets of #RT CYCLE hold ID, SCOPE and END_ACTION, each once and in any order.",
    cause_de="In den Klammern von #RT CYCLE stehen ID, SCOPE und END_ACTION, jedes einmal und in "
    "beliebiger Folge.",
    parameters={"keyword": "the word as written"},
    reaction=2,
    clearing=3,
)
_add(
    22005,
    ERROR,
    "begin and end of realtime cycles do not fit together at this {found}",
    "Beginn und Ende der Echtzeit-Zyklen passen bei diesem {found} nicht zusammen",
    remedy_en="Close each #RT CYCLE with #RT CYCLE END before the next one begins.",
    remedy_de="Jedes #RT CYCLE mit #RT CYCLE END schließen, bevor das nächste beginnt.",
    cause_en="Definitions do not nest: each begins with #RT CYCLE and ends with #RT CYCLE END.",
    cause_de="Definitionen lassen sich nicht schachteln: jede beginnt mit #RT CYCLE und endet mit "
    "#RT CYCLE END.",
    parameters={"found": "the command at that place"},
    reaction=2,
    clearing=3,
)
_add(
    50861,
    ERROR,
    "the expression is nested deeper than {limit} levels",
    "der Ausdruck ist tiefer als {limit} Ebenen geschachtelt",
    remedy_en="Assign a part of it to a variable first.",
    remedy_de="Einen Teil davon vorher einer Variablen zuweisen.",
    cause_en="Evaluation must need little memory in the realtime part, so the depth has a limit.",
    cause_de="Die Auswertung darf im Echtzeit-Teil wenig Speicher brauchen; darum ist die Tiefe "
    "begrenzt.",
    parameters={"limit": "levels allowed"},
    reaction=6,
    clearing=6,
)
_add(
    900123,
    ERROR,
    "{word} ends a subprogram, and this is the main program",
    "{word} beendet ein Unterprogramm, und dies ist das Hauptprogramm",
    remedy_en="Write M30, or call this text with L or LL.",
    remedy_de="M30 schreiben oder diesen Text mit L oder LL rufen.",
    parameters={"word": "the word as written"},
)
_add(
    900124,
    WARNING,
    "{word} in a subprogram ends the main program",
    "{word} in einem Unterprogramm beendet das Hauptprogramm",
    remedy_en="Write M17 to go back to the caller.",
    remedy_de="Mit M17 geht es zurück zum Aufrufer.",
    parameters={"word": "the word as written"},
)
_add(
    900125,
    ERROR,
    "no block number stands before #IF",
    "vor #IF steht keine Satznummer",
    remedy_en="Remove the number, or write $IF.",
    remedy_de="Die Nummer entfernen oder $IF schreiben.",
)
_add(
    900126,
    ERROR,
    "this program has no label {label}",
    "dieses Programm hat keine Sprungmarke {label}",
    remedy_en="Nearest: {nearest}. Write N20: or [NAME] before a block of the same program.",
    remedy_de="Am nächsten: {nearest}. N20: oder [NAME] vor einen Satz desselben Programms "
    "schreiben.",
    cause_en="A jump stays within its main program or subprogram.",
    cause_de="Ein Sprung bleibt in seinem Haupt- oder Unterprogramm.",
    parameters={"label": "the label", "nearest": "the label that is most like it"},
)
_add(
    900127,
    ERROR,
    "the label {label} stands in a loop: no jump leads there",
    "die Sprungmarke {label} steht in einer Schleife: dorthin führt kein Sprung",
    remedy_en="Put the label before or behind the loop; $CONTINUE and $BREAK stay within it.",
    remedy_de="Die Marke vor oder hinter die Schleife setzen; in ihr bleiben $CONTINUE und $BREAK.",
    parameters={"label": "the label"},
)
_add(
    900128,
    ERROR,
    "the label {label} stands twice in this program",
    "die Sprungmarke {label} steht zweimal in diesem Programm",
    remedy_en="Rename one of them.",
    remedy_de="Eine der beiden umbenennen.",
    parameters={"label": "the label"},
)
_add(
    900129,
    ERROR,
    "this file has no local subprogram {name}",
    "diese Datei hat kein lokales Unterprogramm {name}",
    remedy_en="It has: {nearest}. A local subprogram begins with %L {name}; a file is called with "
    "L.",
    remedy_de="Vorhanden: {nearest}. Ein lokales Unterprogramm beginnt mit %L {name}; eine Datei "
    "ruft L.",
    parameters={"name": "the name", "nearest": "the nearest local subprogram"},
)
_add(
    900130,
    ERROR,
    "the local subprogram {name} begins in line {line} already",
    "das lokale Unterprogramm {name} beginnt schon in Zeile {line}",
    remedy_en="Rename one of them.",
    remedy_de="Eines der beiden umbenennen.",
    parameters={"name": "the name", "line": "the line of the first one"},
)
_add(
    900131,
    ERROR,
    "the program {name} is not found",
    "das Programm {name} ist nicht zu finden",
    remedy_en="Searched: {folders}. path[i].dir of the channel list names further folders.",
    remedy_de="Gesucht: {folders}. Weitere Ordner nennt path[i].dir der Kanalliste.",
    parameters={"name": "the name", "folders": "where it was searched"},
    reaction=2,
    clearing=3,
)
_add(
    900133,
    ERROR,
    "{word} is nothing that a call hands over",
    "{word} ist nichts, was ein Aufruf übergibt",
    remedy_en="A call has NAME and @P1 … @P200; perhaps {nearest} is meant.",
    remedy_de="Ein Aufruf hat NAME und @P1 … @P200; vielleicht ist {nearest} gemeint.",
    parameters={"word": "the word", "nearest": "the word that is most like it"},
)
_add(
    900135,
    ERROR,
    "{word} says nothing about a return",
    "{word} sagt nichts über einen Rücksprung",
    remedy_en="M17 has [MAIN] or [JUMPS=number], and one label: [NAME] or N20.",
    remedy_de="M17 hat [MAIN] oder [JUMPS=Zahl] und eine Marke: [NAME] oder N20.",
    parameters={"word": "the word as written"},
)
_add(
    900916,
    ERROR,
    "L CYCLE without NAME: nothing tells which program is called",
    "L CYCLE ohne NAME: nichts sagt, welches Programm gerufen wird",
    remedy_en="Write NAME=file.nc among its keywords: L CYCLE [NAME=file.nc @P1=5]",
    remedy_de="NAME=datei.nc zu den Schlüsselwörtern schreiben: L CYCLE [NAME=datei.nc @P1=5]",
)
