# SPDX-License-Identifier: MIT
"""Messages of lists: their text, their entries, their values (900000 … 900029)."""

from __future__ import annotations

from nctakt.messages.catalogue import NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900000,
    NOTE,
    "the text is no UTF-8; it is read as {encoding}",
    "der Text ist kein UTF-8; er wird als {encoding} gelesen",
    remedy_en="Save the file as UTF-8.",
    remedy_de="Die Datei als UTF-8 speichern.",
    parameters={"encoding": "the encoding that was taken"},
)
_add(
    900001,
    NOTE,
    "no blank behind the '#' of a comment line; it is a comment all the same",
    "kein Leerzeichen hinter dem '#' einer Kommentarzeile; sie gilt trotzdem als Kommentar",
    remedy_en="Write '# ' with a blank.",
    remedy_de="'# ' mit Leerzeichen schreiben.",
)
_add(
    900002,
    NOTE,
    "the '#' of this comment line does not stand at its start; it is a comment all the same",
    "das '#' dieser Kommentarzeile steht nicht am Anfang; sie gilt trotzdem als Kommentar",
    remedy_en="Move the '#' to the first column.",
    remedy_de="Das '#' in die erste Spalte rücken.",
)
_add(
    900003,
    NOTE,
    "'{word}' is taken as the end of the list",
    "'{word}' gilt als Ende der Liste",
    remedy_en="Write End or Ende.",
    remedy_de="End oder Ende schreiben.",
    parameters={"word": "the word as it stands in the list"},
)
_add(
    900004,
    NOTE,
    "text behind the end of the list is ignored, from this line on",
    "Text hinter dem Ende der Liste wird ignoriert, ab dieser Zeile",
    remedy_en="Move the entries before End, or delete them.",
    remedy_de="Die Einträge vor Ende verschieben oder löschen.",
)
_add(
    900005,
    WARNING,
    "the list has no End; it may be cut off",
    "der Liste fehlt das Ende; sie ist womöglich abgeschnitten",
    remedy_en="Close the list with a line End.",
    remedy_de="Die Liste mit einer Zeile Ende abschließen.",
)
_add(
    900006,
    WARNING,
    "the line contains a NUL character and is left out",
    "die Zeile enthält ein NUL-Zeichen und wird ausgelassen",
    remedy_en="Delete the character, or save the file as UTF-8.",
    remedy_de="Das Zeichen löschen oder die Datei als UTF-8 speichern.",
)
_add(
    900007,
    WARNING,
    "{key}: a blank is missing here",
    "{key}: hier fehlt ein Leerzeichen",
    remedy_en="Put a blank between name, value and comment.",
    remedy_de="Name, Wert und Kommentar durch Leerzeichen trennen.",
    parameters={"key": "the entry's name"},
)
_add(
    900008,
    WARNING,
    "{key} is no parameter of this list; the entry is left out",
    "{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="Correct the name or delete the line.",
    remedy_de="Den Namen berichtigen oder die Zeile löschen.",
    parameters={"key": "the name as it stands in the list"},
)
_add(
    900009,
    WARNING,
    "{key} is no parameter of this list; the entry is left out",
    "{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="Did you mean {nearest}?",
    remedy_de="Ist {nearest} gemeint?",
    parameters={
        "key": "the name as it stands in the list",
        "nearest": "the known name that is most like it",
    },
)
_add(
    900010,
    NOTE,
    "entries left out because nctakt does not know their names: {count}",
    "Einträge, deren Namen nctakt nicht kennt und deshalb auslässt: {count}",
    remedy_en="With --verbose each of them is named.",
    remedy_de="Mit --verbose wird jeder davon genannt.",
    parameters={"count": "how many entries of the file"},
)
_add(
    900011,
    WARNING,
    "{key}: the index lies outside {low} … {high}; the entry is left out",
    "{key}: der Index liegt außerhalb {low} … {high}; der Eintrag wird ausgelassen",
    remedy_en="Use an index from {low} to {high}.",
    remedy_de="Einen Index von {low} bis {high} verwenden.",
    parameters={
        "key": "the entry's name",
        "low": "the lowest index",
        "high": "the highest index",
    },
)
_add(
    900012,
    WARNING,
    "{key} is no parameter of this list; the entry is left out",
    "{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="It belongs in the {list} list ({id}).",
    remedy_de="Er gehört in die {list}-Liste ({id}).",
    parameters={
        "key": "the name as it stands in the list",
        "list": "the kind of list where it belongs",
        "id": "the parameter's ID there",
    },
)
_add(
    900013,
    WARNING,
    "{key} has no value; default {default} is used",
    "{key} hat keinen Wert; es gilt der Standardwert {default}",
    remedy_en="Write the value behind the name, or delete the line.",
    remedy_de="Den Wert hinter den Namen schreiben oder die Zeile löschen.",
    parameters={"key": "the entry's name", "default": "the value that is used"},
)
_add(
    900014,
    WARNING,
    "{key}: '{value}' is no number; default {default} is used",
    "{key}: '{value}' ist keine Zahl; es gilt der Standardwert {default}",
    remedy_en="Write a number, then a blank before any comment.",
    remedy_de="Eine Zahl schreiben, vor einem Kommentar ein Leerzeichen.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the value that is used",
    },
)
_add(
    900015,
    WARNING,
    "{key}: a number stands in quotation marks; it is taken",
    "{key}: eine Zahl steht in Anführungszeichen; sie wird übernommen",
    remedy_en="Write the number without quotation marks.",
    remedy_de="Die Zahl ohne Anführungszeichen schreiben.",
    parameters={"key": "the entry's name"},
)
_add(
    900016,
    WARNING,
    "{key}: the closing quotation mark is missing; the text up to the end of the line is taken",
    "{key}: das schließende Anführungszeichen fehlt; der Text bis zum Zeilenende wird übernommen",
    remedy_en="Close the text with a quotation mark.",
    remedy_de="Den Text mit einem Anführungszeichen schließen.",
    parameters={"key": "the entry's name"},
)
_add(
    900017,
    WARNING,
    "{key}: what stands behind the quoted text is no comment, and is ignored",
    "{key}: hinter dem Text in Anführungszeichen steht kein Kommentar; es wird ignoriert",
    remedy_en="Open a comment behind a text with '('.",
    remedy_de="Einen Kommentar hinter einem Text mit '(' beginnen.",
    parameters={"key": "the entry's name"},
)
_add(
    900018,
    WARNING,
    "{key}: the text has special characters but no quotation marks; it is taken up to '('",
    "{key}: der Text hat Sonderzeichen, aber keine Anführungszeichen; er gilt bis '('",
    remedy_en="Put the text in quotation marks; open a comment with '('.",
    remedy_de="Den Text in Anführungszeichen setzen; einen Kommentar mit '(' beginnen.",
    parameters={"key": "the entry's name"},
)
_add(
    900019,
    WARNING,
    "{key}: {value} lies outside {low} … {high}; default {default} is used",
    "{key}: {value} liegt außerhalb {low} … {high}; es gilt der Standardwert {default}",
    remedy_en="Use a value from {low} to {high}.",
    remedy_de="Einen Wert von {low} bis {high} verwenden.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "low": "the lowest value",
        "high": "the highest value",
        "default": "the value that is used",
    },
)
_add(
    900020,
    WARNING,
    "{key}: the text has {length} characters, {limit} are allowed; default '{default}' is used",
    "{key}: der Text hat {length} Zeichen, erlaubt sind {limit}; es gilt der Standardwert "
    "'{default}'",
    remedy_en="Shorten the text.",
    remedy_de="Den Text kürzen.",
    parameters={
        "key": "the entry's name",
        "length": "the text's length",
        "limit": "the longest text allowed",
        "default": "the value that is used",
    },
)
_add(
    900021,
    WARNING,
    "{key}: '{value}' is not one of {names}; default {default} is used",
    "{key}: '{value}' ist nicht eines von {names}; es gilt der Standardwert {default}",
    remedy_en="Use one of {names}.",
    remedy_de="Eines von {names} verwenden.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "names": "the names that are allowed",
        "default": "the value that is used",
    },
)
_add(
    900022,
    WARNING,
    "{key}: '{value}' is no truth value; default {default} is used",
    "{key}: '{value}' ist kein Wahrheitswert; es gilt der Standardwert {default}",
    remedy_en="Write FALSE or TRUE.",
    remedy_de="FALSE oder TRUE schreiben.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the value that is used",
    },
)
_add(
    900023,
    WARNING,
    "{key} stands in line {first} and in line {second}; line {taken} is taken",
    "{key} steht in Zeile {first} und in Zeile {second}; Zeile {taken} gilt",
    remedy_en="Delete one of the two lines.",
    remedy_de="Eine der beiden Zeilen löschen.",
    parameters={
        "key": "the entry's name",
        "first": "the earlier line",
        "second": "the later line",
        "taken": "the line whose value is used",
    },
)
_add(
    900024,
    WARNING,
    "{alias} is an old name of {key}; the entry is taken",
    "{alias} ist ein alter Name von {key}; der Eintrag wird übernommen",
    remedy_en="Write {key}.",
    remedy_de="{key} schreiben.",
    parameters={"alias": "the name in the list", "key": "the parameter's present name"},
)
_add(
    900025,
    WARNING,
    "{key}: {value} names no parameter of this list that has a value of its own; "
    "default {default} is used",
    "{key}: {value} nennt keinen Parameter dieser Liste mit eigenem Wert; es gilt der "
    "Standardwert {default}",
    remedy_en="Name a number parameter of the same list, or write the number itself.",
    remedy_de="Einen Zahlenparameter derselben Liste nennen oder die Zahl selbst schreiben.",
    parameters={
        "key": "the entry's name",
        "value": "the reference as it stands in the list",
        "default": "the value that is used",
    },
)
_add(
    900026,
    NOTE,
    "{key} ({id}) is accepted and has no effect here",
    "{key} ({id}) wird angenommen und bleibt hier ohne Wirkung",
    remedy_en="nctakt does not simulate what this parameter sets.",
    remedy_de="nctakt simuliert nicht, was dieser Parameter einstellt.",
    parameters={"key": "the entry's name", "id": "the parameter's ID"},
)
_add(
    20965,
    WARNING,
    "{key}: '{value}' is no synchronisation type; {default} is used",
    "{key}: '{value}' ist keine Synchronisationsart; es gilt {default}",
    remedy_en="Use the constants of P-CHAN-00041, joined by '|', or their hexadecimal value.",
    remedy_de="Die Konstanten von P-CHAN-00041, durch '|' verbunden, oder ihren hexadezimalen "
    "Wert verwenden.",
    cause_en="A function without a valid synchronisation must not be lost, so the safest one is "
    "taken: the path waits for the PLC.",
    cause_de="Eine Funktion ohne gültige Synchronisationsart darf nicht verlorengehen; darum gilt "
    "die sicherste: die Bahn wartet auf die SPS.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the synchronisation type that is used",
    },
    reaction=1,
    clearing=1,
)
_add(
    900812,
    WARNING,
    "{key}: no axis or spindle of the channel is called {value}; the function is the channel's",
    "{key}: keine Achse oder Spindel des Kanals heißt {value}; die Funktion ist die des Kanals",
    remedy_en="Use a name of gruppe[0].achse[i].bezeichnung or spindel[i].bezeichnung.",
    remedy_de="Einen Namen aus gruppe[0].achse[i].bezeichnung oder spindel[i].bezeichnung"
    " verwenden.",
    parameters={"key": "the entry", "value": "the name"},
)
