# SPDX-License-Identifier: MIT
"""Messages about lists: their text, their entries, their values."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

TEXT_NOT_UTF8 = note(
    900000,
    en="the text is no UTF-8; it is read as {encoding}",
    de="der Text ist kein UTF-8; er wird als {encoding} gelesen",
    remedy_en="Save the file as UTF-8.",
    remedy_de="Die Datei als UTF-8 speichern.",
    encoding=("the encoding that was taken", "die angenommene Kodierung"),
)
BLANK_MISSING_AFTER_HASH = note(
    900001,
    en="no blank behind the '#' of a comment line; it is a comment all the same",
    de="kein Leerzeichen hinter dem '#' einer Kommentarzeile; sie gilt trotzdem als Kommentar",
    remedy_en="Write '# ' with a blank.",
    remedy_de="'# ' mit Leerzeichen schreiben.",
)
HASH_NOT_AT_LINE_START = note(
    900002,
    en="the '#' of this comment line does not stand at its start; it is a comment all the same",
    de="das '#' dieser Kommentarzeile steht nicht am Anfang; sie gilt trotzdem als Kommentar",
    remedy_en="Move the '#' to the first column.",
    remedy_de="Das '#' in die erste Spalte rücken.",
)
UNUSUAL_END_WORD = note(
    900003,
    en="'{word}' is taken as the end of the list",
    de="'{word}' gilt als Ende der Liste",
    remedy_en="Write End or Ende.",
    remedy_de="End oder Ende schreiben.",
    word=("the word as it stands in the list", "das Wort, wie es in der Liste steht"),
)
TEXT_AFTER_END = note(
    900004,
    en="text behind the end of the list is ignored, from this line on",
    de="Text hinter dem Ende der Liste wird ignoriert, ab dieser Zeile",
    remedy_en="Move the entries before End, or delete them.",
    remedy_de="Die Einträge vor Ende verschieben oder löschen.",
)
LIST_WITHOUT_END = warning(
    900005,
    en="the list has no End; it may be cut off",
    de="der Liste fehlt das Ende; sie ist womöglich abgeschnitten",
    remedy_en="Close the list with a line End.",
    remedy_de="Die Liste mit einer Zeile Ende abschließen.",
)
NUL_CHARACTER_IN_LINE = warning(
    900006,
    en="the line contains a NUL character and is left out",
    de="die Zeile enthält ein NUL-Zeichen und wird ausgelassen",
    remedy_en="Delete the character, or save the file as UTF-8.",
    remedy_de="Das Zeichen löschen oder die Datei als UTF-8 speichern.",
)
BLANK_MISSING = warning(
    900007,
    en="{key}: a blank is missing here",
    de="{key}: hier fehlt ein Leerzeichen",
    remedy_en="Put a blank between name, value and comment.",
    remedy_de="Name, Wert und Kommentar durch Leerzeichen trennen.",
    key=("the entry's name", "der Name des Eintrags"),
)
UNKNOWN_PARAMETER = warning(
    900008,
    en="{key} is no parameter of this list; the entry is left out",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="nctakt knows the published parameters; one of a vendor's own has no effect here.",
    remedy_de="nctakt kennt die veröffentlichten Parameter; ein herstellereigener bleibt hier ohne "
    "Wirkung.",
    key=("the name as it stands in the list", "der Name, wie er in der Liste steht"),
)
MISSPELLED_PARAMETER = warning(
    900009,
    en="{key} is no parameter of this list; the entry is left out",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="Did you mean {nearest}?",
    remedy_de="Ist {nearest} gemeint?",
    key=("the name as it stands in the list", "der Name, wie er in der Liste steht"),
    nearest=("the known name that is most like it", "der ähnlichste bekannte Name"),
)
UNKNOWN_ENTRIES = note(
    900010,
    en="{count} more unknown entries are left out, from this line on",
    de="{count} weitere unbekannte Einträge werden ausgelassen, ab dieser Zeile",
    remedy_en="With --verbose each of them is named.",
    remedy_de="Mit --verbose wird jeder davon genannt.",
    count=(
        "the number of the other unknown entries",
        "die Anzahl der übrigen unbekannten Einträge",
    ),
)
PARAMETER_INDEX_OUT_OF_RANGE = warning(
    900011,
    en="{key}: the index lies outside {low} … {high}; the entry is left out",
    de="{key}: der Index liegt außerhalb {low} … {high}; der Eintrag wird ausgelassen",
    remedy_en="Use an index from {low} to {high}.",
    remedy_de="Einen Index von {low} bis {high} verwenden.",
    key=("the entry's name", "der Name des Eintrags"),
    low=("the lowest index", "der kleinste Index"),
    high=("the highest index", "der größte Index"),
)
PARAMETER_OF_OTHER_LIST = warning(
    900012,
    en="{key} is no parameter of this list; the entry is left out",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ausgelassen",
    remedy_en="It belongs in the {list} list ({id}).",
    remedy_de="Er gehört in die {list}-Liste ({id}).",
    key=("the name as it stands in the list", "der Name, wie er in der Liste steht"),
    list=("the kind of list where it belongs", "die Art der Liste, in die er gehört"),
    id=("the parameter's ID there", "die ID des Parameters dort"),
)
VALUE_MISSING = warning(
    900013,
    en="{key} has no value; default {default} is used",
    de="{key} hat keinen Wert; es gilt der Standardwert {default}",
    remedy_en="Write the value behind the name, or delete the line.",
    remedy_de="Den Wert hinter den Namen schreiben oder die Zeile löschen.",
    key=("the entry's name", "der Name des Eintrags"),
    default=("the value that is used", "der Wert, der gilt"),
)
NOT_A_NUMBER = warning(
    900014,
    en="{key}: '{value}' is no number; default {default} is used",
    de="{key}: '{value}' ist keine Zahl; es gilt der Standardwert {default}",
    remedy_en="Write a number, then a blank before any comment.",
    remedy_de="Eine Zahl schreiben, vor einem Kommentar ein Leerzeichen.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    default=("the value that is used", "der Wert, der gilt"),
)
QUOTED_NUMBER = warning(
    900015,
    en="{key}: a number stands in quotation marks; it is taken",
    de="{key}: eine Zahl steht in Anführungszeichen; sie wird übernommen",
    remedy_en="Write the number without quotation marks.",
    remedy_de="Die Zahl ohne Anführungszeichen schreiben.",
    key=("the entry's name", "der Name des Eintrags"),
)
CLOSING_QUOTE_MISSING = warning(
    900016,
    en="{key}: the closing quotation mark is missing; the text up to the end of the line is taken",
    de="{key}: das schließende Anführungszeichen fehlt; der Text bis zum Zeilenende wird "
    "übernommen",
    remedy_en="Close the text with a quotation mark.",
    remedy_de="Den Text mit einem Anführungszeichen schließen.",
    key=("the entry's name", "der Name des Eintrags"),
)
TEXT_AFTER_QUOTE = warning(
    900017,
    en="{key}: what stands behind the quoted text is no comment, and is ignored",
    de="{key}: hinter dem Text in Anführungszeichen steht kein Kommentar; es wird ignoriert",
    remedy_en="Open a comment behind a text with '('.",
    remedy_de="Einen Kommentar hinter einem Text mit '(' beginnen.",
    key=("the entry's name", "der Name des Eintrags"),
)
UNQUOTED_SPECIAL_CHARACTERS = warning(
    900018,
    en="{key}: the text has special characters but no quotation marks; it is taken up to '('",
    de="{key}: der Text hat Sonderzeichen, aber keine Anführungszeichen; er gilt bis '('",
    remedy_en="Put the text in quotation marks; open a comment with '('.",
    remedy_de="Den Text in Anführungszeichen setzen; einen Kommentar mit '(' beginnen.",
    key=("the entry's name", "der Name des Eintrags"),
)
PARAMETER_OUT_OF_RANGE = warning(
    900019,
    en="{key}: {value} lies outside {range}; default {default} is used",
    de="{key}: {value} liegt außerhalb {range}; es gilt der Standardwert {default}",
    remedy_en="Use a value of {range}.",
    remedy_de="Einen Wert aus {range} verwenden.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    range=("the values that are allowed", "die erlaubten Werte"),
    default=("the value that is used", "der Wert, der gilt"),
)
PARAMETER_TEXT_TOO_LONG = warning(
    900020,
    en="{key}: the text has {length} characters, {limit} are allowed; default '{default}' is used",
    de="{key}: der Text hat {length} Zeichen, erlaubt sind {limit}; es gilt der Standardwert "
    "'{default}'",
    remedy_en="Shorten the text.",
    remedy_de="Den Text kürzen.",
    key=("the entry's name", "der Name des Eintrags"),
    length=("the text's length", "die Länge des Textes"),
    limit=("the longest text allowed", "der längste erlaubte Text"),
    default=("the value that is used", "der Wert, der gilt"),
)
UNKNOWN_PARAMETER_VALUE = warning(
    900021,
    en="{key}: '{value}' is not one of {names}; default {default} is used",
    de="{key}: '{value}' ist nicht eines von {names}; es gilt der Standardwert {default}",
    remedy_en="Use one of {names}.",
    remedy_de="Eines von {names} verwenden.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    names=("the names that are allowed", "die erlaubten Namen"),
    default=("the value that is used", "der Wert, der gilt"),
)
NOT_A_BOOLEAN = warning(
    900022,
    en="{key}: '{value}' is no truth value; default {default} is used",
    de="{key}: '{value}' ist kein Wahrheitswert; es gilt der Standardwert {default}",
    remedy_en="Write FALSE or TRUE.",
    remedy_de="FALSE oder TRUE schreiben.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    default=("the value that is used", "der Wert, der gilt"),
)
DUPLICATE_ENTRY = warning(
    900023,
    en="{key} stands in line {first} and in line {second}; line {taken} is taken",
    de="{key} steht in Zeile {first} und in Zeile {second}; Zeile {taken} gilt",
    remedy_en="Delete one of the two lines.",
    remedy_de="Eine der beiden Zeilen löschen.",
    key=("the entry's name", "der Name des Eintrags"),
    first=("the earlier line", "die frühere Zeile"),
    second=("the later line", "die spätere Zeile"),
    taken=("the line whose value is used", "die Zeile, deren Wert gilt"),
)
OLD_PARAMETER_NAME = warning(
    900024,
    en="{alias} is an old name of {key}; the entry is taken",
    de="{alias} ist ein alter Name von {key}; der Eintrag wird übernommen",
    remedy_en="Write {key}.",
    remedy_de="{key} schreiben.",
    alias=("the name in the list", "der Name in der Liste"),
    key=("the parameter's present name", "der heutige Name des Parameters"),
)
INVALID_PARAMETER_REFERENCE = warning(
    900025,
    en="{key}: {value} names no parameter of this list that has a value of its own; default "
    "{default} is used",
    de="{key}: {value} nennt keinen Parameter dieser Liste mit eigenem Wert; es gilt der "
    "Standardwert {default}",
    remedy_en="Name a number parameter of the same list, or write the number itself.",
    remedy_de="Einen Zahlenparameter derselben Liste nennen oder die Zahl selbst schreiben.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the reference as it stands in the list", "der Verweis, wie er in der Liste steht"),
    default=("the value that is used", "der Wert, der gilt"),
)
PARAMETER_WITHOUT_EFFECT = note(
    900026,
    en="{key} ({id}) is {value}, default {default}, and has no effect here: {meaning}",
    de="{key} ({id}) ist {value}, Standardwert {default}, und bleibt hier ohne Wirkung: {meaning}",
    remedy_en="Nothing to do: no run depends on it.",
    remedy_de="Nichts zu tun: kein Lauf hängt davon ab.",
    key=("the entry's name", "der Name des Eintrags"),
    id=("the parameter's ID", "die ID des Parameters"),
    value=("the value that the list gives", "der Wert aus der Liste"),
    default=("the parameter's default", "der Standardwert des Parameters"),
    meaning=("what the parameter means", "die Bedeutung des Parameters"),
)
PARAMETER_WOULD_CHANGE_RUN = warning(
    900970,
    en="{key} ({id}) is {value} instead of {default}; this would change a run and has no effect "
    "here: {meaning}",
    de="{key} ({id}) ist {value} statt {default}; das würde einen Lauf ändern und bleibt hier ohne "
    "Wirkung: {meaning}",
    remedy_en="Expect other positions, times or outputs on the machine.",
    remedy_de="An der Maschine mit anderen Positionen, Zeiten oder Ausgaben rechnen.",
    key=("the entry's name", "der Name des Eintrags"),
    id=("the parameter's ID", "die ID des Parameters"),
    value=("the value that the list gives", "der Wert aus der Liste"),
    default=("the parameter's default", "der Standardwert des Parameters"),
    meaning=("what the parameter means", "die Bedeutung des Parameters"),
)
PARAMETER_MAY_CHANGE_RUN = note(
    900971,
    en="{key} ({id}) is {value} instead of {default}; this may change a run and has no effect "
    "here: {meaning}",
    de="{key} ({id}) ist {value} statt {default}; das kann einen Lauf ändern und bleibt hier ohne "
    "Wirkung: {meaning}",
    remedy_en="Expect other positions, times or outputs on the machine.",
    remedy_de="An der Maschine mit anderen Positionen, Zeiten oder Ausgaben rechnen.",
    key=("the entry's name", "der Name des Eintrags"),
    id=("the parameter's ID", "die ID des Parameters"),
    value=("the value that the list gives", "der Wert aus der Liste"),
    default=("the parameter's default", "der Standardwert des Parameters"),
    meaning=("what the parameter means", "die Bedeutung des Parameters"),
)
WITHOUT_EFFECT_WOULD_CHANGE_RUN = warning(
    900028,
    en="entries without effect here that would change a run: {count} ({names})",
    de="Einträge ohne Wirkung hier, die einen Lauf ändern würden: {count} ({names})",
    remedy_en="nctakt check --effects lists all of them with their meaning.",
    remedy_de="nctakt check --effects nennt alle mit ihrer Bedeutung.",
    count=("the number of these entries", "die Anzahl dieser Einträge"),
    names=("the first of them", "die ersten davon"),
)
WITHOUT_EFFECT_MAY_CHANGE_RUN = note(
    900029,
    en="entries without effect here that may change a run: {count} ({names})",
    de="Einträge ohne Wirkung hier, die einen Lauf ändern können: {count} ({names})",
    remedy_en="nctakt check --effects lists all of them with their meaning.",
    remedy_de="nctakt check --effects nennt alle mit ihrer Bedeutung.",
    count=("the number of these entries", "die Anzahl dieser Einträge"),
    names=("the first of them", "die ersten davon"),
)
BEYOND_OTHER_PARAMETER = warning(
    900027,
    en="{key}: {value} is beyond {other} ({id}); {limit} is used",
    de="{key}: {value} überschreitet die Grenze {other} ({id}); es gilt {limit}",
    remedy_en="Change one of the two values.",
    remedy_de="Einen der beiden Werte ändern.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    other=("the entry that sets the bound", "der Eintrag, der die Grenze setzt"),
    id=("the ID of that parameter", "die ID jenes Parameters"),
    limit=("the nearest value that is allowed", "der nächste erlaubte Wert"),
)
XML_LIST_WITH_MISTAKE = error(
    900975,
    en="no well-formed XML from here on: {reason}",
    de="ab hier kein wohlgeformtes XML: {reason}",
    remedy_en="Mend the file; what stands in front of this place is read.",
    remedy_de="Die Datei berichtigen; gelesen wird, was vor dieser Stelle steht.",
    reason=("what is wrong, in English", "der Grund, auf Englisch"),
)
XML_LIST_WITH_ENTITIES = error(
    900976,
    en="a document type or an entity: a list has none, it is not read from here on",
    de="ein Dokumenttyp oder eine Entität: Listen haben keine, ab hier wird nicht gelesen",
    remedy_en="Take the declaration out.",
    remedy_de="Die Deklaration entfernen.",
)
XML_LIST_TOO_DEEP = error(
    900977,
    en="elements are nested deeper than {limit}; the list is not read from here on",
    de="Elemente sind tiefer als {limit} geschachtelt; ab hier wird die Liste nicht gelesen",
    remedy_en="Take grouping elements out: they carry no meaning.",
    remedy_de="Gruppierende Elemente entfernen: sie haben keine Bedeutung.",
    limit=("the greatest depth", "die größte Tiefe"),
)
XML_LIST_TOO_LARGE = error(
    900978,
    en="the list has more than {limit} bytes and is not read",
    de="die Liste hat mehr als {limit} Byte und wird nicht gelesen",
    remedy_en="Name a list of parameters.",
    remedy_de="Eine Parameterliste angeben.",
    limit=("the greatest size in bytes", "die größte Länge in Byte"),
)
INVALID_SYNCHRONISATION_TYPE = warning(
    20965,
    en="{key}: '{value}' is no synchronisation type; {default} is used",
    de="{key}: '{value}' ist keine Synchronisationsart; es gilt {default}",
    remedy_en="Use the constants of P-CHAN-00041, joined by '|', or their hexadecimal value.",
    remedy_de="Die Konstanten von P-CHAN-00041, durch '|' verbunden, oder ihren hexadezimalen Wert "
    "verwenden.",
    cause_en="A function without a valid synchronisation must not be lost, so the safest one is "
    "taken: the path waits for the PLC.",
    cause_de="Eine Funktion ohne gültige Synchronisationsart darf nicht verlorengehen; darum gilt "
    "die sicherste: die Bahn wartet auf die SPS.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    default=("the synchronisation type that is used", "die Synchronisationsart, die gilt"),
    reaction=1,
    clearing=1,
)
UNKNOWN_FUNCTION_AXIS = warning(
    900812,
    en="{key}: no axis or spindle of the channel is called {value}; the function is the channel's",
    de="{key}: keine Achse oder Spindel des Kanals heißt {value}; die Funktion ist die des Kanals",
    remedy_en="Use a name of gruppe[0].achse[i].bezeichnung or spindel[i].bezeichnung.",
    remedy_de="Einen Namen aus gruppe[0].achse[i].bezeichnung oder spindel[i].bezeichnung "
    "verwenden.",
    key=("the entry", "der Eintrag"),
    value=("the name", "der Name"),
)
