# SPDX-License-Identifier: MIT
"""Messages about lists: their text, their entries, their values."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import by_end
from nctakt.messages.catalogue import error, note, warning

TEXT_NOT_UTF8 = note(
    900000,
    en="the text is not UTF-8; it is read as {encoding}",
    de="der Text ist kein UTF-8; er wird als {encoding} gelesen",
    remedy_en="If letters beyond ASCII look right, nothing is to be done; otherwise save the file "
    "as UTF-8.",
    remedy_de="Stimmen die Umlaute, ist nichts zu tun; sonst die Datei als UTF-8 speichern.",
    encoding=("the assumed encoding", "die angenommene Kodierung"),
)
BLANK_MISSING_AFTER_HASH = note(
    900001,
    en="the blank after the '#' of a comment line is missing; the line counts as a comment all the "
    "same",
    de="nach dem '#' einer Kommentarzeile fehlt das Leerzeichen; sie gilt trotzdem als Kommentar",
    remedy_en="Write '# ' with a blank.",
    remedy_de="'# ' mit Leerzeichen schreiben.",
)
HASH_NOT_AT_LINE_START = note(
    900002,
    en="the '#' of this comment line is not in the first column; the line counts as a comment all "
    "the same",
    de="das '#' dieser Kommentarzeile steht nicht in der ersten Spalte; sie gilt trotzdem als "
    "Kommentar",
    remedy_en="Move the '#' to the first column.",
    remedy_de="Das '#' in die erste Spalte rücken.",
)
UNUSUAL_END_WORD = note(
    900003,
    en="'{word}' is taken as the end of the list",
    de="'{word}' wird als Ende der Liste gelesen",
    remedy_en="Write End or Ende.",
    remedy_de="End oder Ende schreiben.",
    word=("the word as written in the list", "das Wort, wie es in der Liste steht"),
)
TEXT_AFTER_END = note(
    900004,
    en="text after the end of the list is ignored, from this line on",
    de="Text nach dem Ende der Liste wird ab dieser Zeile ignoriert",
    remedy_en="Move the entries before the End line, or delete them.",
    remedy_de="Die Einträge vor die Zeile Ende verschieben oder löschen.",
)
LIST_WITHOUT_END = warning(
    900005,
    en="the list has no End line; it may be truncated",
    de="der Liste fehlt die Zeile Ende; vielleicht ist sie abgeschnitten",
    remedy_en="End the list with a line End.",
    remedy_de="Die Liste mit einer Zeile Ende abschließen.",
)
NUL_CHARACTER_IN_LINE = warning(
    900006,
    en="the line contains a NUL character and is ignored",
    de="die Zeile enthält ein NUL-Zeichen und wird ignoriert",
    remedy_en="Delete the character, or save the file as UTF-8.",
    remedy_de="Das Zeichen löschen oder die Datei als UTF-8 speichern.",
)
BLANK_MISSING = warning(
    900007,
    en="{key}: a blank is missing here",
    de="{key}: hier fehlt ein Leerzeichen",
    remedy_en="Separate name, value and comment with blanks.",
    remedy_de="Name, Wert und Kommentar durch Leerzeichen trennen.",
)
UNKNOWN_PARAMETER = warning(
    900008,
    known_as=(120508, 150107, 1001118, 1001119, 1001120),
    cases=Cases((110303, 1001117), lambda values: 0),
    en="{key} is not a parameter of this list; the entry is ignored",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ignoriert",
    remedy_en="nctakt knows all published parameters; a vendor-specific one has no effect here.",
    remedy_de="nctakt kennt alle veröffentlichten Parameter; ein herstellereigener hat hier keine "
    "Wirkung.",
)
#: The number of an unknown entry in a kind of list that has one.
UNKNOWN_ENTRY_NUMBERS = {"axis": 110303, "startup": 1001117}

MISSPELLED_PARAMETER = warning(
    900009,
    known_as=(120508, 150107, 1001118, 1001119, 1001120),
    cases=Cases((110303, 1001117), lambda values: 0),
    en="{key} is not a parameter of this list; the entry is ignored",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ignoriert",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
UNKNOWN_ENTRIES = note(
    900010,
    en="{count} more unknown entries are ignored, from this line on",
    de="ab dieser Zeile werden {count} weitere unbekannte Einträge ignoriert",
    remedy_en="Option --verbose names each of them.",
    remedy_de="Die Option --verbose nennt jeden davon.",
    count=("the number of entries in the file", "die Anzahl der Einträge in der Datei"),
)
PARAMETER_INDEX_OUT_OF_RANGE = warning(
    2009,
    known_as=(900011,),
    en="{key}: the index is outside {low} … {high}; the entry is ignored",
    de="{key}: der Index liegt außerhalb {low} … {high}; der Eintrag wird ignoriert",
    remedy_en="Use an index from {low} to {high}.",
    remedy_de="Einen Index von {low} bis {high} verwenden.",
    low=("the lowest index", "der kleinste Index"),
    high=("the highest index", "der größte Index"),
)
PARAMETER_OF_OTHER_LIST = warning(
    900012,
    known_as=(120508, 150107, 1001118, 1001119, 1001120),
    cases=Cases((110303, 1001117), lambda values: 0),
    en="{key} is not a parameter of this list; the entry is ignored",
    de="{key} ist kein Parameter dieser Liste; der Eintrag wird ignoriert",
    remedy_en="It belongs in the {list} list ({id}).",
    remedy_de="Er gehört in die {list}-Liste ({id}).",
    list=("the kind of list where it belongs", "die Art der Liste, in die er gehört"),
    id=("the parameter's ID there", "die ID des Parameters dort"),
)
VALUE_MISSING = warning(
    900013,
    known_as=(2004,),
    en="{key} has no value; default {default} is used",
    de="{key} hat keinen Wert; es gilt der Standardwert {default}",
    remedy_en="Write the value after the name, or delete the line.",
    remedy_de="Den Wert hinter den Namen schreiben oder die Zeile löschen.",
)
NOT_A_NUMBER = warning(
    2022,
    known_as=(900014,),
    en="{key}: '{value}' is not a number; default {default} is used",
    de="{key}: '{value}' ist keine Zahl; es gilt der Standardwert {default}",
    remedy_en="Write a number, and a blank before any comment.",
    remedy_de="Eine Zahl schreiben, und vor einem Kommentar ein Leerzeichen.",
)
NOT_A_WHOLE_NUMBER = warning(
    2006,
    en="{key}: '{value}' is not a whole number; default {default} is used",
    de="{key}: '{value}' ist keine ganze Zahl; es gilt der Standardwert {default}",
    remedy_en="Write a whole number in the unit of the entry; explain shows it.",
    remedy_de="Eine ganze Zahl in der Einheit des Eintrags schreiben; explain zeigt sie.",
)
QUOTED_NUMBER = warning(
    900015,
    en="{key}: the number is in quotation marks; it is accepted",
    de="{key}: die Zahl steht in Anführungszeichen; sie wird übernommen",
    remedy_en="Write the number without quotation marks.",
    remedy_de="Die Zahl ohne Anführungszeichen schreiben.",
)
CLOSING_QUOTE_MISSING = warning(
    900016,
    en="{key}: the closing quotation mark is missing; the text up to the end of the line is used",
    de="{key}: das schließende Anführungszeichen fehlt; der Text bis zum Zeilenende wird "
    "übernommen",
    remedy_en="Close the text with a quotation mark.",
    remedy_de="Den Text mit einem Anführungszeichen schließen.",
)
TEXT_AFTER_QUOTE = warning(
    900017,
    en="{key}: the text after the closing quote is not a comment and is ignored",
    de="{key}: was auf den Text in Anführungszeichen folgt, ist kein Kommentar und wird ignoriert",
    remedy_en="Start a comment after a text with '('.",
    remedy_de="Einen Kommentar hinter einem Text mit '(' beginnen.",
)
UNQUOTED_SPECIAL_CHARACTERS = warning(
    900018,
    en="{key}: the text has special characters but no quotation marks; it is used up to '('",
    de="{key}: der Text hat Sonderzeichen, aber keine Anführungszeichen; er gilt bis '('",
    remedy_en="Put the text in quotation marks; start a comment with '('.",
    remedy_de="Den Text in Anführungszeichen setzen; einen Kommentar mit '(' beginnen.",
)
PARAMETER_OUT_OF_RANGE = warning(
    900019,
    cases=Cases((1023, 1024), lambda values: 0),
    en="{key}: {value} is outside {range}; default {default} is used",
    de="{key}: {value} liegt nicht in {range}; es gilt der Standardwert {default}",
    remedy_en="Use a value in {range}.",
    remedy_de="Einen Wert aus {range} verwenden.",
    range=("the values that are allowed", "die erlaubten Werte"),
)
PARAMETER_TEXT_TOO_LONG = warning(
    1021,
    known_as=(900020, 2023),
    en="{key}: the text has {length} characters, {limit} are allowed; default '{default}' is used",
    de="{key}: der Text hat {length} Zeichen, erlaubt sind {limit}; es gilt der Standardwert "
    "'{default}'",
    remedy_en="Shorten the text.",
    remedy_de="Den Text kürzen.",
    length=("the text's length", "die Länge des Textes"),
    limit=("the longest text allowed", "der längste erlaubte Text"),
)
UNKNOWN_PARAMETER_VALUE = warning(
    2021,
    known_as=(900021,),
    en="{key}: '{value}' is not one of {names}; default {default} is used",
    de="{key}: '{value}' ist keiner der Werte {names}; es gilt der Standardwert {default}",
    remedy_en="Use one of {names}.",
    remedy_de="Einen der Werte {names} verwenden.",
    names=("the allowed names", "die erlaubten Namen"),
)
NOT_A_BOOLEAN = warning(
    1019,
    known_as=(900022,),
    en="{key}: '{value}' is not a boolean; default {default} is used",
    de="{key}: '{value}' ist kein boolescher Wert; es gilt der Standardwert {default}",
    remedy_en="Write FALSE or TRUE.",
    remedy_de="FALSE oder TRUE schreiben.",
)
DUPLICATE_ENTRY = warning(
    900023,
    known_as=(2056,),
    en="{key} is given in line {first} and in line {second}; line {taken} is used",
    de="{key} steht in Zeile {first} und in Zeile {second}; es gilt Zeile {taken}",
    remedy_en="Delete one of the two lines.",
    remedy_de="Eine der beiden Zeilen löschen.",
    first=("the earlier line", "die frühere Zeile"),
    second=("the later line", "die spätere Zeile"),
    taken=("the line whose value is used", "die Zeile, deren Wert gilt"),
)
OLD_PARAMETER_NAME = warning(
    900024,
    known_as=(2044,),
    en="{alias} is an old name of {key}; the entry is accepted",
    de="{alias} ist ein alter Name von {key}; der Eintrag wird übernommen",
    remedy_en="Write {key}.",
    remedy_de="{key} schreiben.",
    alias=("the name in the list", "der Name in der Liste"),
    key=("the parameter's present name", "der heutige Name des Parameters"),
)
INVALID_PARAMETER_REFERENCE = warning(
    2052,
    known_as=(900025, 2041, 2051, 2062, 2065),
    en="{key}: {value} does not name a parameter with a value in this list; default {default} is "
    "used",
    de="{key}: {value} nennt keinen Parameter dieser Liste mit eigenem Wert; es gilt der "
    "Standardwert {default}",
    remedy_en="Name a numeric parameter of the same list, or write the number itself.",
    remedy_de="Einen Zahlenparameter derselben Liste nennen oder die Zahl selbst schreiben.",
    value=("the reference as written in the list", "der Verweis, wie er in der Liste steht"),
)
PARAMETER_WITHOUT_EFFECT = note(
    900026,
    en="{key} ({id}) is {value} (default {default}) and has no effect here: {meaning}",
    de="{key} ({id}) ist {value} (Standardwert {default}) und hat hier keine Wirkung: {meaning}",
    remedy_en="Nothing to do: no run depends on it.",
    remedy_de="Nichts zu tun: kein Lauf hängt davon ab.",
    id=("the parameter's ID", "die ID des Parameters"),
)
PARAMETER_WOULD_CHANGE_RUN = warning(
    900970,
    en="{key} ({id}) is {value}, not {default}; this would change a run, but has no effect here: "
    "{meaning}",
    de="{key} ({id}) ist {value}, nicht {default}; das würde einen Lauf ändern, hat hier aber "
    "keine Wirkung: {meaning}",
    remedy_en="Expect other positions, times or outputs on the machine.",
    remedy_de="An der Maschine andere Positionen, Zeiten oder Ausgaben erwarten.",
    id=("the parameter's ID", "die ID des Parameters"),
)
PARAMETER_MAY_CHANGE_RUN = note(
    900971,
    en="{key} ({id}) is {value}, not {default}; this may change a run, but has no effect here: "
    "{meaning}",
    de="{key} ({id}) ist {value}, nicht {default}; das kann einen Lauf ändern, hat hier aber keine "
    "Wirkung: {meaning}",
    remedy_en="Expect other positions, times or outputs on the machine.",
    remedy_de="An der Maschine andere Positionen, Zeiten oder Ausgaben erwarten.",
    id=("the parameter's ID", "die ID des Parameters"),
)
WITHOUT_EFFECT_WOULD_CHANGE_RUN = warning(
    900028,
    en="entries without effect here that would change a run: {count} ({names})",
    de="Einträge ohne Wirkung hier, die einen Lauf ändern würden: {count} ({names})",
    remedy_en="List all of them with their meaning: nctakt check --effects",
    remedy_de="Alle mit ihrer Bedeutung zeigen: nctakt check --effects",
    names=("the first of them", "die ersten davon"),
)
WITHOUT_EFFECT_MAY_CHANGE_RUN = note(
    900029,
    en="entries without effect here that may change a run: {count} ({names})",
    de="Einträge ohne Wirkung hier, die einen Lauf ändern können: {count} ({names})",
    remedy_en="List all of them with their meaning: nctakt check --effects",
    remedy_de="Alle mit ihrer Bedeutung zeigen: nctakt check --effects",
    names=("the first of them", "die ersten davon"),
)
BEYOND_OTHER_PARAMETER = warning(
    900027,
    cases=Cases((1023, 1024), lambda values: 0),
    en="{key}: {value} is {side} the limit {other} ({id}); {limit} is used",
    de="{key}: {value} liegt {side} der Grenze {other} ({id}); es gilt {limit}",
    remedy_en="Change one of the two values.",
    remedy_de="Einen der beiden Werte ändern.",
    side=("above or below", "über oder unter"),
    other=("the entry that sets the bound", "der Eintrag, der die Grenze setzt"),
    id=("the ID of that parameter", "die ID jenes Parameters"),
    limit=("the nearest value that is allowed", "der nächste erlaubte Wert"),
)
XML_LIST_WITH_MISTAKE = error(
    900975,
    en="from here on this is not well-formed XML: {reason}",
    de="ab hier ist dies kein wohlgeformtes XML: {reason}",
    remedy_en="Correct the file; what comes before this position is read.",
    remedy_de="Die Datei berichtigen; gelesen wird, was vor dieser Stelle steht.",
    reason=("what is wrong, in English", "der Grund, auf Englisch"),
)
XML_LIST_WITH_ENTITIES = error(
    900976,
    en="a document type or an entity is not allowed in a list, which is not read from here on",
    de="ein Dokumenttyp oder eine Entität ist in einer Liste nicht erlaubt; ab hier wird sie nicht "
    "gelesen",
    remedy_en="Remove the declaration.",
    remedy_de="Die Deklaration entfernen.",
)
XML_LIST_TOO_DEEP = error(
    900977,
    en="elements are nested deeper than {limit}; the list is not read from here on",
    de="Elemente sind tiefer als {limit} geschachtelt; ab hier wird die Liste nicht gelesen",
    remedy_en="Remove grouping elements: they have no meaning.",
    remedy_de="Gruppierende Elemente entfernen: sie haben keine Bedeutung.",
    limit=("the maximum depth", "die größte Tiefe"),
)
XML_LIST_TOO_LARGE = error(
    900978,
    en="the list is larger than {limit} bytes and is not read",
    de="die Liste ist größer als {limit} Byte und wird nicht gelesen",
    remedy_en="Name a list of parameters.",
    remedy_de="Eine Parameterliste angeben.",
    limit=("the maximum size in bytes", "die größte Länge in Byte"),
)
INVALID_SYNCHRONISATION_TYPE = warning(
    20764,
    en="{key}: '{value}' is not a synchronisation type; {default} is used",
    de="{key}: '{value}' ist keine Synchronisationsart; es gilt {default}",
    remedy_en="Use the constants of P-CHAN-00041, joined with '|', or their hexadecimal value.",
    remedy_de="Die Konstanten von P-CHAN-00041, durch '|' verbunden, oder ihren hexadezimalen Wert "
    "verwenden.",
    cause_en="A function without a valid synchronisation must not be lost, so the safest type is "
    "used: the path waits for the PLC.",
    cause_de="Eine Funktion ohne gültige Synchronisationsart darf nicht verlorengehen; darum gilt "
    "die sicherste: die Bahn wartet auf die SPS.",
    default=("the synchronisation type that is used", "die Synchronisationsart, die gilt"),
    classes=(1, 1),
)
UNKNOWN_FUNCTION_AXIS = warning(
    21131,
    known_as=(900812,),
    en="{key}: no axis or spindle of the channel is called {value}; the function belongs to the "
    "channel",
    de="{key}: keine Achse oder Spindel des Kanals heißt {value}; die Funktion gehört zum Kanal",
    remedy_en="Use a name of gruppe[0].achse[i].bezeichnung or spindel[i].bezeichnung.",
    remedy_de="Einen Namen aus gruppe[0].achse[i].bezeichnung oder spindel[i].bezeichnung "
    "verwenden.",
    value=("the name", "der Name"),
)
PROCESS_TIME_WITHOUT_WAITING = warning(
    20760,
    en="{key} {value}: a function of the type MOS takes no time; 0 is used",
    de="{key} {value}: eine Funktion der Art MOS braucht keine Zeit; es gilt 0",
    remedy_en="Set it to 0, or let the channel wait for the function (MVS_SVS, MVS_SNS, MNS_SNS).",
    remedy_de="Auf 0 setzen oder den Kanal auf die Funktion warten lassen (MVS_SVS, MVS_SNS, "
    "MNS_SNS).",
    value=("the time in 0.1 µs", "die Zeit in 0,1 µs"),
)
LEAD_TIME_TOO_SHORT = warning(
    21203,
    en="{key}: with MET_SVS the function must be output at least one tick ({minimum} µs) early",
    de="{key}: mit MET_SVS muss die Funktion mindestens einen Takt ({minimum} µs) früher "
    "ausgegeben werden",
    remedy_en="Set {lead} to {minimum} or more.",
    remedy_de="{lead} auf {minimum} oder mehr setzen.",
    key=("the entry of the type", "der Eintrag der Art"),
    lead=("the entry of the lead time", "der Eintrag der Vorhaltezeit"),
    minimum=("the shortest lead time, in µs", "die kürzeste Vorhaltezeit, in µs"),
)
LEAD_WITHOUT_EARLY_TYPE = warning(
    902650,
    en="{key}: a function of the type {synchronisation} goes out at its block, not before",
    de="{key}: eine Funktion der Art {synchronisation} wird bei ihrem Satz ausgegeben, nicht davor",
    remedy_en="Use MEP_SVS, MEP_MOS (distance), MET_SVS or MET_MOS (time), or set it to 0.",
    remedy_de="MEP_SVS, MEP_MOS (Weg), MET_SVS oder MET_MOS (Zeit) verwenden, oder auf 0 setzen.",
    cause_en="The controller outputs functions of other types early only with a licensed option "
    "(micro joints), which is not simulated.",
    cause_de="Die Steuerung gibt Funktionen anderer Arten nur mit einer lizenzpflichtigen Option "
    "(Mikrostege) früher aus, die nicht simuliert wird.",
    key=("the entry of the lead", "der Eintrag der Vorhaltung"),
    synchronisation=("the synchronisation type", "die Synchronisationsart"),
)
PATH_GIVEN_TWICE = warning(
    20771,
    cases=by_end("key", {".priority": 20707}),
    en="{key} {value} is already used by {other}",
    de="{key} {value} wird schon von {other} verwendet",
    remedy_en="Give each folder of a type a different number and priority.",
    remedy_de="Jedem Verzeichnis einer Art eine eigene Nummer und Priorität geben.",
    other=("the folder before", "das Verzeichnis davor"),
)
SYNCHRONISATION_NOT_OF_FUNCTION = warning(
    20965,
    en="{key}: this function cannot have the type {value}; {default} is used",
    de="{key}: diese Funktion kann die Art {value} nicht haben; {default} wird verwendet",
    remedy_en="Use MOS, MVS_SVS, MVS_SNS, MNS_SNS or MNE_SNS.",
    remedy_de="MOS, MVS_SVS, MVS_SNS, MNS_SNS oder MNE_SNS verwenden.",
    value=("the synchronisation type", "die Synchronisationsart"),
    default=("the synchronisation type that is used", "die Synchronisationsart, die gilt"),
)
