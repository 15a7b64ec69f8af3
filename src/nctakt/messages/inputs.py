# SPDX-License-Identifier: MIT
"""Messages about times, values and names that a user gives a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error

INVALID_TIME = error(
    900510,
    en="'{text}' is not a time",
    de="'{text}' ist keine Zeitangabe",
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
    value=("what was given", "was angegeben wurde"),
    type=("its type in Python", "sein Typ in Python"),
)
NOT_A_STIMULUS = error(
    900514,
    en="{value} is not a value at a time",
    de="{value} ist kein Wert zu einer Zeit",
    remedy_en='Give a time, the name of a variable and its value: ("20 ms", "V.E.DOOR", 1).',
    remedy_de='Zeit, Name der Variablen und Wert angeben: ("20 ms", "V.E.DOOR", 1).',
    value=("what was given", "was angegeben wurde"),
)
TEXT_INSTEAD_OF_FILE = error(
    900515,
    en="'{line} …' is the text of a program, not the name of a file",
    de="'{line} …' ist der Text eines Programms, kein Dateiname",
    remedy_en='Give the text a name: NcText("part.nc", text).',
    remedy_de='Dem Text einen Namen geben: NcText("teil.nc", text).',
    line=("the begin of the text", "der Anfang des Textes"),
)
STIMULUS_WITHOUT_VALUE = error(
    900579,
    en="--at {time} lacks the value that a variable gets at this time",
    de="bei --at {time} fehlt der Wert, den eine Variable zu dieser Zeit bekommt",
    remedy_en="Write --at {time} NAME=VALUE. --state {time} tells how everything stood.",
    remedy_de="--at {time} NAME=WERT schreiben. --state {time} sagt, wie alles stand.",
    time=("the time as it was given", "die Zeit, wie angegeben"),
)
NOT_AN_ASSIGNMENT = error(
    900511,
    en="'{text}' does not give a value to a variable",
    de="'{text}' gibt keiner Variablen einen Wert",
    remedy_en="Write NAME=VALUE, such as V.E.VALUE=5.",
    remedy_de="NAME=WERT schreiben, etwa V.E.VALUE=5.",
    text=("what was given", "was angegeben wurde"),
)
UNREADABLE_VALUE = error(
    900512,
    en="{name}: '{value}' is no value",
    de="{name}: '{value}' ist kein Wert",
    remedy_en='Write a number, TRUE, FALSE or a text between "…".',
    remedy_de='Eine Zahl, TRUE, FALSE oder einen Text zwischen "…" schreiben.',
    name=("the variable", "die Variable"),
    value=("the value as it was given", "der Wert, wie angegeben"),
)
UNKNOWN_MACHINE_VARIABLE = error(
    900540,
    en="there is no variable {name}",
    de="es gibt keine Variable {name}",
    remedy_en="See the machine's variables list for the names.",
    remedy_de="Die Namen stehen in der Variablenliste der Maschine.",
    name=("the name", "der Name"),
)
MISSPELLED_MACHINE_VARIABLE = error(
    900541,
    en="there is no variable {name}",
    de="es gibt keine Variable {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    name=("the name", "der Name"),
    nearest=("the nearest known name", "der ähnlichste bekannte Name"),
)
VARIABLE_NOT_SETTABLE = error(
    900542,
    en="{name} belongs to the controller and cannot be set from outside",
    de="{name} gehört der Steuerung und kann nicht von außen gesetzt werden",
    remedy_en="Set V.E or V.CH variables; write V.RT* variables in a program or a realtime cycle.",
    remedy_de="V.E- oder V.CH-Variablen setzen; V.RT* in Programm oder Echtzeit-Zyklus schreiben.",
    name=("the name", "der Name"),
)
VALUE_NOT_OF_TYPE = error(
    900543,
    en="{name} of type {type} does not take the value {value}",
    de="{name} vom Typ {type} nimmt den Wert {value} nicht",
    remedy_en="Give a number to a number, a text to a text.",
    remedy_de="Einer Zahl eine Zahl geben, einem Text einen Text.",
    name=("the variable", "die Variable"),
    type=("its type", "ihr Typ"),
    value=("the value", "der Wert"),
)
UNKNOWN_SIGNAL = error(
    900544,
    en="there is no signal {name}",
    de="es gibt kein Signal {name}",
    remedy_en="Signals are X.ACS.ACT_POS and its kin, PATH.SPEED, BLOCK, V.E and V.CH variables.",
    remedy_de="Signale sind X.ACS.ACT_POS und andere, PATH.SPEED, BLOCK, V.E- und V.CH-Variablen.",
    name=("the name", "der Name"),
)
MISSPELLED_SIGNAL = error(
    900545,
    en="there is no signal {name}",
    de="es gibt kein Signal {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    name=("the name", "der Name"),
    nearest=("the nearest known name", "der ähnlichste bekannte Name"),
)
INVALID_EXPECTATION = error(
    900660,
    en="'{text}' is no expectation",
    de="'{text}' ist keine Erwartung",
    remedy_en='Write fired, M100, message "…", error 22009, ended, X = 1.5; see docs/testing.md.',
    remedy_de='Etwa fired, M100, message "…", error 22009, X = 1.5; siehe docs/testing.md.',
    text=(
        "the expectation as it stands in the comment",
        "die Erwartung, wie sie im Kommentar steht",
    ),
)
MISSPELT_KEYWORD = error(
    900662,
    en="'{word}:' in a comment is nearly '{keyword}:'",
    de="'{word}:' in einem Kommentar ist beinahe '{keyword}:'",
    remedy_en="Write '; {keyword}: …' so that it is checked, or another word in a plain comment.",
    remedy_de="'; {keyword}: …' schreiben, damit es geprüft wird, sonst ein anderes Wort wählen.",
    word=("the word in the comment", "das Wort im Kommentar"),
    keyword=("the keyword", "das Schlüsselwort"),
)
NO_BRANCH_IN_LINE = error(
    900663,
    en="no realtime cycle of this run has a branch in line {line}",
    de="kein Echtzeit-Zyklus dieses Laufs hat einen Zweig in Zeile {line}",
    remedy_en="Branches stand in the lines {known}.",
    remedy_de="Zweige stehen in den Zeilen {known}.",
    line=("the line", "die Zeile"),
    known=("the lines with branches", "die Zeilen mit Zweigen"),
)
INVALID_GIVEN_INPUT = error(
    900661,
    en="'{text}' cannot be given to a run",
    de="'{text}' kann einem Lauf nicht mitgegeben werden",
    remedy_en="Write V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc FILE, machine FOLDER, until TIME, "
    "after TIME or start.",
    remedy_de="V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc DATEI, machine ORDNER, until ZEIT, after "
    "ZEIT oder start schreiben.",
    text=("what stands in the comment", "was im Kommentar steht"),
)
