# SPDX-License-Identifier: MIT
"""Messages about times, values and names that a user gives a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_TIME = error(
    900510,
    en="'{text}' is not a valid time",
    de="'{text}' ist keine gültige Zeit",
    remedy_en="Write 1500us, 1.5ms, 2s, 3min, 1h or '300 ticks'; a number alone means seconds.",
    remedy_de="1500us, 1.5ms, 2s, 3min, 1h oder '300 ticks' schreiben; eine Zahl allein bedeutet "
    "Sekunden.",
    text=("the time as it was given", "die Zeit, wie angegeben"),
)
WRONG_TIME_TYPE = error(
    900513,
    en="{value} is of type {type} and cannot be a time",
    de="{value} ist vom Typ {type} und kann keine Zeitangabe sein",
    remedy_en='Give a text such as "20 ms", a number of seconds, or a datetime.timedelta.',
    remedy_de='Einen Text wie "20 ms", eine Zahl in Sekunden oder ein datetime.timedelta angeben.',
    type=("its type in Python", "sein Typ in Python"),
)
NOT_A_STIMULUS = error(
    900514,
    en="{value} does not give a variable a value at a time",
    de="{value} gibt keiner Variablen zu einer Zeit einen Wert",
    remedy_en='Give a time, the name of a variable and its value: ("20 ms", "V.E.DOOR", 1).',
    remedy_de='Zeit, Name der Variablen und Wert angeben: ("20 ms", "V.E.DOOR", 1).',
)
ARGUMENT_OF_WRONG_TYPE = error(
    901186,
    en="{name} must be {expected}, not {value}",
    de="{name} muss {expected} sein, nicht {value}",
    remedy_en="Give such a value; help(nctakt) shows the functions with their arguments.",
    remedy_de="Einen solchen Wert angeben; help(nctakt) zeigt die Funktionen mit ihren Argumenten.",
    name=("the argument", "das Argument"),
)
TEXT_INSTEAD_OF_FILE = error(
    900515,
    en="'{line} …' is the text of a program, not the name of a file",
    de="'{line} …' ist der Text eines Programms, kein Dateiname",
    remedy_en='Give the text a name: NcText("part.nc", text).',
    remedy_de='Dem Text einen Namen geben: NcText("teil.nc", text).',
    line=("the first line of the text", "die erste Zeile des Textes"),
)
STIMULUS_WITHOUT_VALUE = error(
    900579,
    en="--at {time}: the value that a variable gets at this time is missing",
    de="--at {time}: der Wert, den eine Variable zu dieser Zeit erhält, fehlt",
    remedy_en="Write --at {time} NAME=VALUE. --state {time} shows the state at that time.",
    remedy_de="--at {time} NAME=WERT schreiben. --state {time} zeigt den Zustand zu dieser Zeit.",
    time=("the time as it was given", "die Zeit, wie angegeben"),
)
NOT_AN_ASSIGNMENT = error(
    900511,
    en="'{text}' does not assign a value to a variable",
    de="'{text}' weist keiner Variablen einen Wert zu",
    remedy_en="Write NAME=VALUE, such as V.E.VALUE=5.",
    remedy_de="NAME=WERT schreiben, etwa V.E.VALUE=5.",
    text=("the word as it was given", "das Wort, wie angegeben"),
)
UNREADABLE_VALUE = error(
    900512,
    en="{name}: '{value}' is not a valid value",
    de="{name}: '{value}' ist kein gültiger Wert",
    remedy_en="Write a number such as 1.5, TRUE, FALSE, an item such as E_Gate.Open, or a text in "
    "double quotes.",
    remedy_de="Eine Zahl wie 1.5, TRUE, FALSE, einen Wert wie E_Gate.Open oder einen Text in "
    "Anführungszeichen schreiben.",
)
UNKNOWN_MACHINE_VARIABLE = error(
    900540,
    en="unknown variable {name}",
    de="unbekannte Variable {name}",
    remedy_en="The names are in the machine's variables list{plc}.",
    remedy_de="Die Namen stehen in der Variablenliste der Maschine{plc}.",
    plc=("where the variables of the PLC are", "wo die Variablen der SPS sind"),
)
MISSPELLED_MACHINE_VARIABLE = error(
    900541,
    en="unknown variable {name}",
    de="unbekannte Variable {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
VARIABLE_NOT_SETTABLE = error(
    900542,
    en="{name} belongs to the controller and cannot be set from outside",
    de="{name} gehört der Steuerung und kann nicht von außen gesetzt werden",
    remedy_en="Set V.E or V.CH variables; write V.RT* variables in a program or a realtime cycle.",
    remedy_de="V.E- oder V.CH-Variablen setzen; V.RT* in einem Programm oder Echtzeit-Zyklus "
    "schreiben.",
)
VALUE_NOT_OF_TYPE = error(
    900543,
    en="{name} is of type {type} and cannot take the value {value}",
    de="{name} ist vom Typ {type} und kann den Wert {value} nicht annehmen",
    remedy_en="Assign a number to a number, a text to a text.",
    remedy_de="Einer Zahl eine Zahl zuweisen, einem Text einen Text.",
)
UNKNOWN_SIGNAL = error(
    900544,
    en="unknown signal {name}",
    de="unbekanntes Signal {name}",
    remedy_en="Signals are X.ACS.ACT_POS and similar, PATH.SPEED, BLOCK, V.E and V.CH "
    "variables{plc}.",
    remedy_de="Signale sind X.ACS.ACT_POS und ähnliche, PATH.SPEED, BLOCK, V.E- und "
    "V.CH-Variablen{plc}.",
    plc=("where the variables of the PLC are", "wo die Variablen der SPS sind"),
)
MISSPELLED_SIGNAL = error(
    900545,
    en="unknown signal {name}",
    de="unbekanntes Signal {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
INVALID_EXPECTATION = error(
    900660,
    en="'{text}' is not a valid expectation",
    de="'{text}' ist keine gültige Erwartung",
    remedy_en='Write fired, M100, message "…", error 22009, ended, X = 1.5 at 2s or at end; see '
    "docs/testing.md.",
    remedy_de='Möglich sind fired, M100, message "…", error 22009, ended, X = 1.5 at 2s oder at '
    "end; siehe docs/testing.md.",
    text=(
        "the expectation as written in the comment",
        "die Erwartung, wie sie im Kommentar steht",
    ),
)
MISSPELT_KEYWORD = error(
    900662,
    en="'{word}:' in a comment looks like '{keyword}:'",
    de="'{word}:' in einem Kommentar sieht aus wie '{keyword}:'",
    remedy_en="Write '; {keyword}: …' to have it checked, or use another word in an ordinary "
    "comment.",
    remedy_de="'; {keyword}: …' schreiben, damit es geprüft wird, sonst ein anderes Wort "
    "verwenden.",
    word=("the word in the comment", "das Wort im Kommentar"),
    keyword=("the keyword", "das Schlüsselwort"),
)
NAMED_FILE_MISSING = error(
    902940,
    en="{file}, named in a comment, does not exist",
    de="{file}, in einem Kommentar genannt, gibt es nicht",
    remedy_en="Correct the path; it is relative to the folder of the program.",
    remedy_de="Den Pfad berichtigen; er gilt relativ zum Ordner des Programms.",
)
NO_BRANCH_IN_LINE = error(
    900663,
    en="no realtime cycle has a branch in line {line}",
    de="kein Echtzeit-Zyklus hat einen Zweig in Zeile {line}",
    remedy_en="Lines with branches: {known}.",
    remedy_de="Zeilen mit Zweigen: {known}.",
    known=("the lines with branches", "die Zeilen mit Zweigen"),
)
UNKNOWN_ITEM = error(
    902631,
    en="{name} has no value {item}; its values are {known}",
    de="{name} hat keinen Wert {item}; seine Werte sind {known}",
    remedy_en="Did you mean {nearest}? Write one of its values, or a number.",
    remedy_de="War {nearest} gemeint? Einen seiner Werte oder eine Zahl schreiben.",
    item=("the item that is expected", "der erwartete Wert"),
    known=("the items of the enumeration", "die Werte der Aufzählung"),
    nearest=("the most similar item", "der ähnlichste Wert"),
)
INVALID_GIVEN_INPUT = error(
    900661,
    en="'{text}' is not a valid input of a run",
    de="'{text}' ist keine gültige Vorgabe für einen Lauf",
    remedy_en="Write V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc FILE, machine FOLDER, until TIME, "
    "after TIME or start.",
    remedy_de="V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc DATEI, machine ORDNER, until ZEIT, after "
    "ZEIT oder start schreiben.",
    text=("the text of the comment", "der Text des Kommentars"),
)
NAMES_OF_DEMO_MACHINE = note(
    901006,
    en="the names are looked up on the built-in demo machine",
    de="die Namen werden an der eingebauten Demo-Maschine gesucht",
    remedy_en="--machine FOLDER selects your machine; in Python it is Controller(FOLDER).",
    remedy_de="--machine ORDNER wählt die eigene Maschine; in Python ist es Controller(ORDNER).",
    cause_en="Variables, axes, spindles, M and H functions come from the lists of a machine.",
    cause_de="Variablen, Achsen, Spindeln, M- und H-Funktionen stammen aus den Listen einer "
    "Maschine.",
)
STIMULUS_NOT_REACHED = warning(
    901007,
    en="{name} did not get its value at {time}: the run ended before, after {end}",
    de="{name} hat bei {time} keinen Wert erhalten: der Lauf endete vorher, nach {end}",
    remedy_en="Give it an earlier time, or let the run continue (--after, --until).",
    remedy_de="Eine frühere Zeit angeben oder den Lauf fortsetzen (--after, --until).",
    time=("the time of the value", "die Zeit des Wertes"),
    end=("how long the run lasted", "die Dauer des Laufs"),
)
GIVEN_IN_TESTS_ONLY = note(
    902930,
    en="{file} gives {count} values in comments (given:), which count in tests only",
    de="{file} gibt {count} Werte in Kommentaren vor (given:), die nur in Tests gelten",
    remedy_en="For the same run as in the test: {options}",
    remedy_de="Für denselben Lauf wie im Test: {options}",
    count=("the number of values", "die Zahl der Werte"),
    options=("the options that give the same values", "die Optionen für dieselben Werte"),
)
