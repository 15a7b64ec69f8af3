# SPDX-License-Identifier: MIT
"""The catalogue: each message that nctakt can give, once.

The controller's own number is used where it is known; what the controller does not number has one
of ours:

====================  ==========================================================
900000 … 900099       lists: reader, schema, machine folder
900100 … 900199       NC text: lexer and parser
900200 … 900299       checked program: words, names, cycles
900300 … 900399       decoder, while it evaluates
900400 … 900499       realtime part
900500 … 900599       command line, files, stimuli, PLC
====================  ==========================================================
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.diagnostics import Diagnostic, Message, Severity, Span, Text

NOTE, WARNING, ERROR = Severity.NOTE, Severity.WARNING, Severity.ERROR


class Catalogue:
    """Messages by number; a number can be given once."""

    def __init__(self) -> None:
        self._messages: dict[int, Message] = {}

    def __getitem__(self, number: int) -> Message:
        return self._messages[number]

    def __iter__(self) -> Iterator[Message]:
        return iter(self._messages.values())

    def __contains__(self, number: int) -> bool:
        return number in self._messages

    def add(
        self,
        number: int,
        severity: Severity,
        en: str,
        de: str,
        *,
        remedy_en: str,
        remedy_de: str,
        parameters: dict[str, str] | None = None,
        reaction: int = 0,
        clearing: int = 0,
    ) -> None:
        """Declare one message; ``parameters`` says what each name in the texts means."""
        assert number not in self._messages, number
        self._messages[number] = Message(
            number,
            severity,
            Text(en, de),
            Text(remedy_en, remedy_de),
            parameters or {},
            reaction,
            clearing,
        )


CATALOGUE = Catalogue()
_add = CATALOGUE.add


class Collector:
    """Gathers diagnostics of one run over some text, in the order of their discovery."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []

    def report(
        self, number: int, span: Span | None, source_line: str = "", **values: object
    ) -> Diagnostic:
        """Add the message ``number`` at ``span``."""
        found = diagnostic(number, span, source_line, **values)
        self.diagnostics.append(found)
        return found

    @property
    def has_errors(self) -> bool:
        """Whether anything worse than a warning was reported."""
        return any(found.severity is Severity.ERROR for found in self.diagnostics)


def diagnostic(
    number: int, span: Span | None = None, source_line: str = "", **values: object
) -> Diagnostic:
    """Make the diagnostic of message ``number``; each parameter of the message needs a value."""
    message = CATALOGUE[number]
    assert values.keys() == message.parameters.keys(), (number, tuple(values))
    return Diagnostic(message, span, values, source_line)


# --- lists: reader, schema, machine folder -------------------------------------------------------

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
    "{key}: the text has characters with a special meaning and no quotation marks; "
    "it is taken up to '(' or the end of the line",
    "{key}: der Text enthält Zeichen mit besonderer Bedeutung und steht nicht in "
    "Anführungszeichen; er gilt bis '(' oder zum Zeilenende",
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
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the synchronisation type that is used",
    },
    reaction=1,
    clearing=1,
)

_add(
    900030,
    ERROR,
    "interrupt_source is not configured; the timer starts the NC cycles",
    "interrupt_source ist nicht konfiguriert; der Timer löst die NC-Takte aus",
    remedy_en="Set interrupt_source to 1 (hardware interrupt), 2 (timer) or 3 (semaphore); "
    "external scheduling (4) leaves nothing to simulate.",
    remedy_de="interrupt_source auf 1 (Hardware-Interrupt), 2 (Timer) oder 3 (Semaphor) setzen; "
    "bei externem Scheduling (4) gibt es nichts zu simulieren.",
)
_add(
    900031,
    ERROR,
    "{key} is missing or defective and has no default; {fallback} µs are used",
    "{key} fehlt oder ist fehlerhaft und hat keinen Standardwert; es gelten {fallback} µs",
    remedy_en="Set {key}.",
    remedy_de="{key} setzen.",
    parameters={
        "key": "the parameter's name",
        "fallback": "the value that is used, in µs",
    },
)
_add(
    900032,
    ERROR,
    "time_slice ({slice} µs) is longer than cycle_time ({cycle} µs)",
    "time_slice ({slice} µs) ist länger als cycle_time ({cycle} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900033,
    WARNING,
    "cycle_time ({cycle} µs) is less than three times time_slice ({slice} µs)",
    "cycle_time ({cycle} µs) ist kleiner als das Dreifache von time_slice ({slice} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900034,
    NOTE,
    "cycle_time ({cycle} µs) is more than twenty times time_slice ({slice} µs)",
    "cycle_time ({cycle} µs) ist größer als das Zwanzigfache von time_slice ({slice} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900035,
    WARNING,
    "{key}: {value} µs is no multiple of {step} µs; {effective} µs are used",
    "{key}: {value} µs ist kein Vielfaches von {step} µs; es gelten {effective} µs",
    remedy_en="Write a multiple of {step}.",
    remedy_de="Ein Vielfaches von {step} schreiben.",
    parameters={
        "key": "the parameter's name",
        "value": "the time as written, in µs",
        "step": "what it has to be a multiple of, in µs",
        "effective": "the time that is used, in µs",
    },
)
_add(
    1000153,
    WARNING,
    "cycle_time: {value} µs is no multiple of time_slice; {effective} µs are used",
    "cycle_time: {value} µs ist kein Vielfaches von time_slice; es gelten {effective} µs",
    remedy_en="Write a multiple of time_slice.",
    remedy_de="Ein Vielfaches von time_slice schreiben.",
    parameters={
        "value": "the time as written, in µs",
        "effective": "the time that is used, in µs",
    },
)
_add(
    900036,
    ERROR,
    "windows_time ({value} µs) is shorter than time_slice; {slice} µs are used",
    "windows_time ({value} µs) ist kürzer als time_slice; es gelten {slice} µs",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    parameters={
        "value": "windows_time as written, in µs",
        "slice": "time_slice, in µs",
    },
)
_add(
    900037,
    NOTE,
    "windows_time 0: no computing time is guaranteed to Windows",
    "windows_time 0: für Windows ist keine Rechenzeit garantiert",
    remedy_en="Make sure that all threads finish within every NC cycle.",
    remedy_de="Sicherstellen, dass alle Threads in jedem NC-Takt fertig werden.",
)
_add(
    900038,
    WARNING,
    "windows_time ({value} µs) takes the whole NC cycle ({cycle} µs): threads that can "
    "be suspended get nothing",
    "windows_time ({value} µs) nimmt den ganzen NC-Takt ({cycle} µs): suspendierbare "
    "Threads bekommen nichts",
    remedy_en="Shorten windows_time.",
    remedy_de="windows_time verkürzen.",
    parameters={
        "value": "windows_time, in µs",
        "cycle": "the NC cycle, in µs",
    },
)
_add(
    900039,
    WARNING,
    "windows_time ({value} µs) is short: switching to Windows and back takes much of it",
    "windows_time ({value} µs) ist kurz: der Wechsel zu Windows und zurück kostet viel davon",
    remedy_en="500 µs are usual; about 100 µs can make RTX unstable.",
    remedy_de="Üblich sind 500 µs; etwa 100 µs können RTX instabil machen.",
    parameters={
        "value": "windows_time, in µs",
    },
)
_add(
    900040,
    NOTE,
    "windows_time ({value} µs) differs from time_slice ({slice} µs)",
    "windows_time ({value} µs) weicht von time_slice ({slice} µs) ab",
    remedy_en="The manual recommends equal times.",
    remedy_de="Das Handbuch empfiehlt gleiche Zeiten.",
    parameters={
        "value": "windows_time, in µs",
        "slice": "time_slice, in µs",
    },
)
_add(
    900041,
    ERROR,
    "interrupt_source is a semaphore, but external_object_name is empty",
    "interrupt_source ist ein Semaphor, aber external_object_name ist leer",
    remedy_en="Name the semaphore.",
    remedy_de="Den Semaphor benennen.",
)
_add(
    900042,
    NOTE,
    "external_object_name has no effect: interrupt_source is no semaphore",
    "external_object_name bleibt ohne Wirkung: interrupt_source ist kein Semaphor",
    remedy_en="Set interrupt_source to 3, or delete the line.",
    remedy_de="interrupt_source auf 3 setzen oder die Zeile löschen.",
)
_add(
    900044,
    WARNING,
    "{key} is 0 or missing; the thread runs in every NC cycle ({effective} µs)",
    "{key} ist 0 oder fehlt; der Thread läuft in jedem NC-Takt ({effective} µs)",
    remedy_en="Set the cycle.",
    remedy_de="Den Takt setzen.",
    parameters={
        "key": "the parameter's name",
        "effective": "the cycle that is used, in µs",
    },
)
_add(
    900045,
    WARNING,
    "{key} is empty",
    "{key} ist leer",
    remedy_en="Name the thread; a function without a name is never called.",
    remedy_de="Den Thread benennen; eine Funktion ohne Namen wird nie gerufen.",
    parameters={
        "key": "the parameter's name",
    },
)
_add(
    900047,
    WARNING,
    "{key}: {other} has the name '{value}' already",
    "{key}: {other} heißt bereits '{value}'",
    remedy_en="Use different names.",
    remedy_de="Verschiedene Namen verwenden.",
    parameters={
        "key": "the parameter's name",
        "other": "the parameter that had the name first",
        "value": "the name",
    },
)
_add(
    900048,
    WARNING,
    "{key}: '{value}' is no function of the controller; it is taken as a function of yours",
    "{key}: '{value}' ist keine Funktion der Steuerung; sie gilt als eigene Funktion",
    remedy_en="The controller's functions are {names}.",
    remedy_de="Die Funktionen der Steuerung sind {names}.",
    parameters={
        "key": "the parameter's name",
        "value": "the function's name",
        "names": "the functions that exist",
    },
)
_add(
    900049,
    NOTE,
    "{key}: {other} uses bit {value} already",
    "{key}: {other} verwendet Bit {value} bereits",
    remedy_en="Use different bits to tell the functions apart.",
    remedy_de="Verschiedene Bits verwenden, um die Funktionen zu unterscheiden.",
    parameters={
        "key": "the parameter's name",
        "other": "the parameter that used the bit first",
        "value": "the bit",
    },
)
_add(
    900050,
    NOTE,
    "the indices have a gap: {key} is not configured",
    "die Indizes haben eine Lücke: {key} ist nicht konfiguriert",
    remedy_en="Number threads and functions without gaps.",
    remedy_de="Threads und Funktionen lückenlos nummerieren.",
    parameters={
        "key": "the first element that is missing",
    },
)
_add(
    900051,
    WARNING,
    "no thread calls task_int; the thread of highest priority is taken as the realtime thread",
    "kein Thread ruft task_int; der Thread höchster Priorität gilt als Echtzeit-Thread",
    remedy_en="Give the realtime thread the function task_int.",
    remedy_de="Dem Echtzeit-Thread die Funktion task_int geben.",
)
_add(
    900052,
    ERROR,
    "{key} goes beyond {limit} µs",
    "{key} übersteigt {limit} µs",
    remedy_en="Use a shorter time.",
    remedy_de="Eine kürzere Zeit verwenden.",
    parameters={
        "key": "the parameter's name",
        "limit": "the longest time, in µs",
    },
)
_add(
    900053,
    WARNING,
    "thread[{thread}] has no function and never runs",
    "thread[{thread}] hat keine Funktion und läuft nie",
    remedy_en="Give the thread a function, or delete its lines.",
    remedy_de="Dem Thread eine Funktion geben oder seine Zeilen löschen.",
    parameters={
        "thread": "the thread's index",
    },
)
_add(
    900054,
    NOTE,
    "{function} is called {value} times per activation; that is usual for task_rnd only",
    "{function} wird je Aktivierung {value}-mal gerufen; üblich ist das nur bei task_rnd",
    remedy_en="Set calls_per_cycle to 1.",
    remedy_de="calls_per_cycle auf 1 setzen.",
    parameters={
        "function": "the function's name",
        "value": "how often it is called",
    },
)
_add(
    900055,
    ERROR,
    "external_thread[{thread}] has no semaphore and is left out",
    "external_thread[{thread}] hat keinen Semaphor und wird ausgelassen",
    remedy_en="Set its semaphore_name.",
    remedy_de="Seinen semaphore_name setzen.",
    parameters={
        "thread": "the external thread's index",
    },
)
_add(
    900057,
    NOTE,
    "thread[{thread}] is the realtime thread, and its overflow is not reported",
    "thread[{thread}] ist der Echtzeit-Thread, und sein Überlauf wird nicht gemeldet",
    remedy_en="Set error_on_overflow to 1.",
    remedy_de="error_on_overflow auf 1 setzen.",
    parameters={
        "thread": "the thread's index",
    },
)

_add(
    900060,
    ERROR,
    "the machine folder {path} does not exist",
    "das Maschinenverzeichnis {path} gibt es nicht",
    remedy_en="Name a folder with a start-up list, or leave it out to use the demo machine.",
    remedy_de="Ein Verzeichnis mit Hochlaufliste angeben oder weglassen, um die Demomaschine zu "
    "verwenden.",
    parameters={
        "path": "the folder as the user gave it",
    },
)
_add(
    900061,
    ERROR,
    "the machine folder {path} has no start-up list ({names})",
    "im Maschinenverzeichnis {path} liegt keine Hochlaufliste ({names})",
    remedy_en="Put the start-up list into the folder, or name the folder where it is.",
    remedy_de="Die Hochlaufliste in das Verzeichnis legen oder das Verzeichnis angeben, in dem sie "
    "liegt.",
    parameters={
        "path": "the folder as the user gave it",
        "names": "the names that a start-up list may have",
    },
)
_add(
    900062,
    ERROR,
    "the list {path} does not exist",
    "die Liste {path} gibt es nicht",
    remedy_en="It is searched in the folder of this list, then in the folder above; correct the "
    "path.",
    remedy_de="Gesucht wird im Verzeichnis dieser Liste, dann im übergeordneten; den Pfad "
    "berichtigen.",
    parameters={
        "path": "the path as written",
    },
)
_add(
    900063,
    NOTE,
    "{path} is taken to mean {found}",
    "{path} wird als {found} verstanden",
    remedy_en="Write the path with '/' and in the letter case of the file.",
    remedy_de="Den Pfad mit '/' und in der Schreibweise der Datei angeben.",
    parameters={
        "path": "the path as written",
        "found": "the file that was found",
    },
)
_add(
    900064,
    ERROR,
    "lists of the format {format} cannot be read",
    "Listen im Format {format} können nicht gelesen werden",
    remedy_en="Use the machine's ASCII lists.",
    remedy_de="Die ASCII-Listen der Maschine verwenden.",
    parameters={
        "format": "the format that the start-up list names",
    },
)
_add(
    900065,
    WARNING,
    "{key} is missing: this list is left out",
    "{key} fehlt: diese Liste entfällt",
    remedy_en="Name the list, or lower the number of lists.",
    remedy_de="Die Liste nennen oder die Anzahl der Listen verringern.",
    parameters={
        "key": "the entry that is missing",
    },
)
_add(
    900066,
    ERROR,
    "no axis list has the logical number {logical} of {name}; it is left out",
    "keine Achsliste hat die logische Nummer {logical} von {name}; es entfällt",
    remedy_en="Correct the number, or add the axis to the start-up list.",
    remedy_de="Die Nummer berichtigen oder die Achse in die Hochlaufliste aufnehmen.",
    parameters={
        "logical": "the logical axis number",
        "name": "the axis or spindle",
    },
)
_add(
    900067,
    ERROR,
    "the logical axis number {logical} is 0 or used by another axis list; this list is left out",
    "die logische Achsnummer {logical} ist 0 oder von einer anderen Achsliste belegt; "
    "diese Liste entfällt",
    remedy_en="Give each axis a number of its own, from 1.",
    remedy_de="Jeder Achse eine eigene Nummer ab 1 geben.",
    parameters={
        "logical": "the logical axis number",
    },
)
_add(
    900068,
    NOTE,
    "there is no rtconf.lis; the NC cycle is {cycle} µs",
    "es gibt keine rtconf.lis; der NC-Takt ist {cycle} µs",
    remedy_en="Name the list with rtconf_lis to set the cycle time.",
    remedy_de="Die Liste mit rtconf_lis nennen, um die Taktzeit festzulegen.",
    parameters={
        "cycle": "the NC cycle that is used, in µs",
    },
)
_add(
    900069,
    ERROR,
    "{key}: {value} is no name for it, or used already; it is left out",
    "{key}: {value} ist kein zulässiger Name oder schon vergeben; es entfällt",
    remedy_en="Axis names begin with A, B, C, Q or U to Z, spindle names with S; each only once.",
    remedy_de="Achsnamen beginnen mit A, B, C, Q oder U bis Z, Spindelnamen mit S; jeder nur "
    "einmal.",
    parameters={
        "key": "the entry",
        "value": "the name, – if there is none",
    },
)
_add(
    900070,
    WARNING,
    "{key} is {count}, but {found} are described; the lesser number counts",
    "{key} ist {count}, beschrieben sind aber {found}; die kleinere Zahl gilt",
    remedy_en="Make the number agree with what is described.",
    remedy_de="Die Anzahl an die Beschreibung anpassen.",
    parameters={
        "key": "the entry that gives the number",
        "count": "the number as written",
        "found": "how many are described",
    },
)
_add(
    900072,
    WARNING,
    "main_spindle_ax_nr: no spindle of the channel has the logical number {logical}",
    "main_spindle_ax_nr: keine Spindel des Kanals hat die logische Nummer {logical}",
    remedy_en="Use the logical number of one of the channel's spindles.",
    remedy_de="Die logische Nummer einer Spindel des Kanals verwenden.",
    parameters={
        "logical": "the logical number",
    },
)
_add(
    900073,
    WARNING,
    "the modulo range {low} … {high} is empty; 0 … 360° are used",
    "der Modulobereich {low} … {high} ist leer; es gelten 0 … 360°",
    remedy_en="Make moduloo greater than modulou.",
    remedy_de="moduloo größer als modulou wählen.",
    parameters={
        "low": "modulou as written",
        "high": "moduloo as written",
    },
)
_add(
    900074,
    WARNING,
    "no gear step has the number {wanted}; gear step {used} is used",
    "keine Getriebestufe hat die Nummer {wanted}; es gilt die Stufe {used}",
    remedy_en="Correct kenngr.getriebe_stufe or getriebe[i].nummer.",
    remedy_de="kenngr.getriebe_stufe oder getriebe[i].nummer berichtigen.",
    parameters={
        "wanted": "the number that is asked for",
        "used": "the number of the step that is used",
    },
)
_add(
    900075,
    WARNING,
    "the software limits {low} … {high} are swapped or equal; they are put in order",
    "die Softwareendschalter {low} … {high} sind vertauscht oder gleich; sie werden geordnet",
    remedy_en="Make kenngr.swe_pos greater than kenngr.swe_neg.",
    remedy_de="kenngr.swe_pos größer als kenngr.swe_neg wählen.",
    parameters={
        "low": "kenngr.swe_neg as written",
        "high": "kenngr.swe_pos as written",
    },
)
_add(
    900076,
    ERROR,
    "{path} cannot be read: {reason}",
    "{path} kann nicht gelesen werden: {reason}",
    remedy_en="Make the file readable.",
    remedy_de="Die Datei lesbar machen.",
    parameters={
        "path": "the file",
        "reason": "what the operating system says",
    },
)
_add(
    900077,
    ERROR,
    "no channel has an axis or a list: nothing can be run",
    "kein Kanal hat eine Achse oder eine Liste: es kann nichts laufen",
    remedy_en="Name a channel list with sda_mds[0] and the axes with achs_mds[i].",
    remedy_de="Mit sda_mds[0] eine Kanalliste und mit achs_mds[i] die Achsen nennen.",
)
_add(
    900078,
    ERROR,
    "V.E.{name} is GLOBAL, but channel {channel} declares it differently; the "
    "declaration of channel {first} counts",
    "V.E.{name} ist GLOBAL, Kanal {channel} erklärt sie aber anders; die Erklärung von "
    "Kanal {first} gilt",
    remedy_en="Declare a GLOBAL variable alike in all channels.",
    remedy_de="Eine GLOBAL-Variable in allen Kanälen gleich erklären.",
    parameters={
        "name": "the variable",
        "channel": "the number of the channel that differs",
        "first": "the number of the channel that declares it first",
    },
)
_add(
    1000178,
    WARNING,
    "alignment {value} of the external variables does not exist; the controller chooses it",
    "die Ausrichtung {value} der externen Variablen gibt es nicht; die Steuerung wählt sie",
    remedy_en="Use 0, 1, 2, 4 or 8.",
    remedy_de="0, 1, 2, 4 oder 8 verwenden.",
    parameters={
        "value": "P-STUP-00145 as written",
    },
)
_add(
    21196,
    WARNING,
    "{key}: '{value}' is no scope; {default} is used",
    "{key}: '{value}' ist kein Gültigkeitsbereich; es gilt {default}",
    remedy_en="Use GLOBAL or CHANNEL.",
    remedy_de="GLOBAL oder CHANNEL verwenden.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the scope that is used",
    },
    reaction=1,
    clearing=1,
)
_add(
    21992,
    ERROR,
    "V.CH variables need {needed} byte, P-CHAN-00424 gives {available}; the channel has "
    "none of them",
    "V.CH-Variablen brauchen {needed} Byte, P-CHAN-00424 gibt {available}; der Kanal hat "
    "keine davon",
    remedy_en="Set configuration.decoder.v_ch_memory to at least {needed}.",
    remedy_de="configuration.decoder.v_ch_memory auf mindestens {needed} setzen.",
    parameters={
        "needed": "bytes of data and management",
        "available": "P-CHAN-00424",
    },
    reaction=2,
    clearing=7,
)
_add(
    900080,
    WARNING,
    "{key}: '{value}' is no name for a variable, or used already; it is left out",
    "{key}: '{value}' ist kein zulässiger Variablenname oder schon vergeben; sie entfällt",
    remedy_en="Use up to {limit} letters, digits and underscores, beginning with a letter.",
    remedy_de="Bis zu {limit} Buchstaben, Ziffern und Unterstriche verwenden, mit einem Buchstaben "
    "beginnend.",
    parameters={
        "key": "the entry's name",
        "value": "the name",
        "limit": "the greatest length",
    },
)
_add(
    900081,
    WARNING,
    "{key} does not exist: number_used_variables is {count}",
    "{key} gibt es nicht: number_used_variables ist {count}",
    remedy_en="Set number_used_variables to the highest index plus 1.",
    remedy_de="number_used_variables auf den höchsten Index plus 1 setzen.",
    parameters={
        "key": "the first variable beyond the number",
        "count": "P-EXTV-00010",
    },
)
_add(
    900082,
    WARNING,
    "{key}: '{value}' is no type and no structure of this list; the variable is left out",
    "{key}: '{value}' ist kein Typ und keine Struktur dieser Liste; die Variable entfällt",
    remedy_en="Use one of {names}, or the name of a structure.",
    remedy_de="Eines von {names} oder den Namen einer Struktur verwenden.",
    parameters={
        "key": "the entry's name",
        "value": "the type as written",
        "names": "the types that exist",
    },
)
_add(
    900083,
    WARNING,
    "the structure {name} contains itself; variables of it are left out",
    "die Struktur {name} enthält sich selbst; Variablen dieses Typs entfallen",
    remedy_en="Break the circle.",
    remedy_de="Den Kreis auflösen.",
    parameters={
        "name": "the structure",
    },
)
_add(
    900084,
    WARNING,
    "{key}: the variable has more than {limit} elements and is left out",
    "{key}: die Variable hat mehr als {limit} Elemente und entfällt",
    remedy_en="Make its arrays smaller.",
    remedy_de="Ihre Felder verkleinern.",
    parameters={
        "key": "the entry's name",
        "limit": "the greatest number of elements",
    },
)

_add(
    900085,
    WARNING,
    "structures inside {name} nest deeper than {limit}; variables of it are left out",
    "Strukturen in {name} sind tiefer als {limit} geschachtelt; Variablen dieses Typs entfallen",
    remedy_en="Nest the structures less deeply.",
    remedy_de="Die Strukturen weniger tief schachteln.",
    parameters={
        "name": "the outermost structure",
        "limit": "the deepest nesting",
    },
)

_add(
    900086,
    WARNING,
    "rt_cycles.max_duration is {value} %: realtime cycles may use more than the whole tick",
    "rt_cycles.max_duration ist {value} %: Echtzeit-Zyklen dürfen mehr als den ganzen "
    "CNC-Takt nutzen",
    remedy_en="Use at most 100, and leave time for the rest of the tick.",
    remedy_de="Höchstens 100 verwenden und Zeit für den Rest des Takts lassen.",
    parameters={
        "value": "P-CHAN-00425",
    },
)

# --- NC text: lexer and parser -------------------------------------------------------------------

_FOUND = {"found": "the text at that place; <EOL> at the end of the block"}

_add(
    900100,
    ERROR,
    "nobody knows what '{found}' means here",
    "mit '{found}' ist hier nichts anzufangen",
    remedy_en="remove it, or write the block as the grammar has it",
    remedy_de="entfernen oder den Satz nach der Grammatik schreiben",
    parameters=_FOUND,
)
_add(
    900101,
    ERROR,
    "a value is missing before '{found}'",
    "vor '{found}' fehlt ein Wert",
    remedy_en="write a number, a variable or an expression",
    remedy_de="eine Zahl, eine Variable oder einen Ausdruck schreiben",
    parameters=_FOUND,
)
_add(
    900102,
    ERROR,
    "this bracket is not closed",
    "diese Klammer wird nicht geschlossen",
    remedy_en="write ']'; a command goes on in the next line only if this one ends with '\\'",
    remedy_de="']' schreiben; ein Befehl geht nur weiter, wenn die Zeile mit '\\' endet",
)
_add(
    900103,
    ERROR,
    "']' without '['",
    "']' ohne '['",
    remedy_en="remove it, or open the bracket before",
    remedy_de="entfernen oder die Klammer vorher öffnen",
)
_add(
    900104,
    ERROR,
    "this text has no closing quote",
    "diesem Text fehlt das schließende Anführungszeichen",
    remedy_en='write " at its end; a text stays in one line',
    remedy_de='am Ende " schreiben; ein Text bleibt in einer Zeile',
)
_add(
    900105,
    ERROR,
    "{begin} is never closed",
    "{begin} wird nie geschlossen",
    remedy_en="write {end}; structures end in the opposite order of their begin",
    remedy_de="{end} schreiben; Strukturen enden umgekehrt, wie sie beginnen",
    parameters={"begin": "the word that opens the structure", "end": "the word that closes it"},
)
_add(
    900106,
    ERROR,
    "{word} without {begin}",
    "{word} ohne {begin}",
    remedy_en="remove it, or write {begin} before",
    remedy_de="entfernen oder vorher {begin} schreiben",
    parameters={"word": "the word at that place", "begin": "the word that should come before"},
)
_add(
    900107,
    ERROR,
    "{word} is no control word",
    "{word} ist kein Kontrollwort",
    remedy_en="perhaps {suggestion} is meant; no blank stands behind $",
    remedy_de="vielleicht ist {suggestion} gemeint; hinter $ steht kein Leerzeichen",
    parameters={"word": "the word as written", "suggestion": "the most similar control word"},
)
_add(
    900108,
    ERROR,
    "this is no text: here stands a byte 0",
    "das ist kein Text: hier steht ein Byte 0",
    remedy_en="give an NC program; reading ends here",
    remedy_de="ein NC-Programm angeben; hier endet das Lesen",
)
_add(
    900109,
    WARNING,
    "the program is empty",
    "das Programm ist leer",
    remedy_en="write at least the program end, M30",
    remedy_de="wenigstens das Programmende M30 schreiben",
)
_add(
    900110,
    WARNING,
    "the block has {length} characters, the manual allows {limit}",
    "der Satz hat {length} Zeichen, das Handbuch erlaubt {limit}",
    remedy_en="divide it: the machine's controller may refuse it",
    remedy_de="teilen: die Steuerung der Maschine lehnt ihn möglicherweise ab",
    parameters={"length": "characters of the block", "limit": "characters allowed"},
)
_add(
    900111,
    ERROR,
    "{begin} stands inside more than {limit} other structures",
    "{begin} steht in mehr als {limit} anderen Strukturen",
    remedy_en="take the inner part out into a subprogram",
    remedy_de="den inneren Teil in ein Unterprogramm auslagern",
    parameters={"begin": "the word that opens the structure", "limit": "structures allowed"},
)
_add(
    900112,
    ERROR,
    "this comment is never ended",
    "dieser Kommentar endet nie",
    remedy_en="write #COMMENT END alone in a block",
    remedy_de="#COMMENT END allein in einen Satz schreiben",
)
_add(
    900113,
    ERROR,
    "'{symbol}' is missing before '{found}'",
    "vor '{found}' fehlt '{symbol}'",
    remedy_en="write '{symbol}'",
    remedy_de="'{symbol}' schreiben",
    parameters={"symbol": "what has to stand there", **_FOUND},
)
_add(
    900114,
    ERROR,
    "a name is missing before '{found}'",
    "vor '{found}' fehlt ein Name",
    remedy_en="write the name of the variable, label, program or command that is meant",
    remedy_de="den Namen schreiben: der Variablen, der Marke, des Programms, des Befehls",
    parameters=_FOUND,
)
_add(
    900115,
    ERROR,
    "a statement between $SWITCH and its first $CASE",
    "eine Anweisung zwischen $SWITCH und dem ersten $CASE",
    remedy_en="put it before $SWITCH or into a branch",
    remedy_de="vor $SWITCH oder in einen Zweig setzen",
)
_add(
    900116,
    ERROR,
    "only declarations stand between #VAR and #ENDVAR",
    "zwischen #VAR und #ENDVAR stehen nur Deklarationen",
    remedy_en="write V.L.NAME : TYPE = value, or close with #ENDVAR before",
    remedy_de="V.L.NAME : TYP = Wert schreiben oder vorher mit #ENDVAR schließen",
)
_add(
    900117,
    WARNING,
    "the file has a main program already; %{name} does not run",
    "die Datei hat schon ein Hauptprogramm; %{name} läuft nicht",
    remedy_en="begin a subprogram with %L, or use a file of its own",
    remedy_de="ein Unterprogramm mit %L beginnen oder eine eigene Datei verwenden",
    parameters={"name": "what stands behind %"},
)
_add(
    900118,
    WARNING,
    "what stands behind the program end is no NC text from here on",
    "was hinter dem Programmende steht, ist ab hier kein NC-Text",
    remedy_en="make it a comment; a run that jumps there would end with an error",
    remedy_de="zum Kommentar machen; ein Lauf, der dorthin springt, endet mit einem Fehler",
)
_add(
    900119,
    ERROR,
    "this number is too large",
    "diese Zahl ist zu groß",
    remedy_en="write a number below 1.8 times 10 to the power of 308",
    remedy_de="eine Zahl unter 1,8 mal 10 hoch 308 schreiben",
)
_add(
    900120,
    ERROR,
    "{word} behind the $ELSE of the same $IF",
    "{word} hinter dem $ELSE desselben $IF",
    remedy_en="put $ELSE last, once, or close the $IF before",
    remedy_de="$ELSE einmal und zuletzt schreiben oder das $IF vorher schließen",
    parameters={"word": "the word at that place"},
)
_add(
    900122,
    ERROR,
    "there is no skip level {level}: levels are 1 to {limit}",
    "es gibt keine Ausblendebene {level}: Ebenen sind 1 bis {limit}",
    remedy_en="write / or /1 to /{limit}",
    remedy_de="/ oder /1 bis /{limit} schreiben",
    parameters={"level": "the level as written", "limit": "the highest level"},
)
_add(
    20301,
    ERROR,
    "the block has {length} characters, {limit} can be read",
    "der Satz hat {length} Zeichen, lesbar sind {limit}",
    remedy_en="divide it into several blocks",
    remedy_de="in mehrere Sätze teilen",
    parameters={"length": "characters of the block", "limit": "characters that can be read"},
    reaction=2,
    clearing=3,
)
_add(
    20566,
    ERROR,
    "#COMMENT BEGIN is not alone in its block",
    "#COMMENT BEGIN steht nicht allein im Satz",
    remedy_en="put it into a block of its own",
    remedy_de="in einen eigenen Satz schreiben",
    reaction=2,
    clearing=3,
)
_add(
    20569,
    ERROR,
    "#COMMENT END is not alone in its block",
    "#COMMENT END steht nicht allein im Satz",
    remedy_en="put it into a block of its own",
    remedy_de="in einen eigenen Satz schreiben",
    reaction=2,
    clearing=3,
)
_add(
    21985,
    ERROR,
    "#RT CYCLE has no keyword {keyword}",
    "#RT CYCLE hat kein Schlüsselwort {keyword}",
    remedy_en="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION",
    remedy_de="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION",
    parameters={"keyword": "the word as written"},
    reaction=2,
    clearing=3,
)
_add(
    22005,
    ERROR,
    "begin and end of realtime cycles do not fit together at this {found}",
    "Beginn und Ende der Echtzeit-Zyklen passen bei diesem {found} nicht zusammen",
    remedy_en="close each #RT CYCLE with #RT CYCLE END before the next one begins",
    remedy_de="jedes #RT CYCLE mit #RT CYCLE END schließen, bevor das nächste beginnt",
    parameters={"found": "the command at that place"},
    reaction=2,
    clearing=3,
)
_add(
    50861,
    ERROR,
    "the expression is nested deeper than {limit} levels",
    "der Ausdruck ist tiefer als {limit} Ebenen geschachtelt",
    remedy_en="assign a part of it to a variable first",
    remedy_de="einen Teil davon vorher einer Variablen zuweisen",
    parameters={"limit": "levels allowed"},
    reaction=6,
    clearing=6,
)

# --- checked program: words, names, cycles -------------------------------------------------------

_KNOWN = {
    "command": "the word or command",
    "meaning_en": "what it does, in English",
    "meaning_de": "what it does, in German",
}
_WORD = {"word": "the word as written"}
_NAME = {"name": "the variable"}
_NEAREST = {"nearest": "the most similar known name, or –"}

_add(
    900200,
    ERROR,
    "{command} ({meaning_en}) is not simulated by this version",
    "{command} ({meaning_de}) wird von dieser Version nicht simuliert",
    remedy_en="leave it out: what it does would change positions or times",
    remedy_de="weglassen: die Wirkung würde Positionen oder Zeiten ändern",
    parameters=_KNOWN,
)
_add(
    900201,
    NOTE,
    "{command} ({meaning_en}) is accepted and has no effect here",
    "{command} ({meaning_de}) wird angenommen und wirkt hier nicht",
    remedy_en="nothing to do; this is told once per program",
    remedy_de="nichts zu tun; das wird einmal je Programm gemeldet",
    parameters=_KNOWN,
)
_add(
    900202,
    ERROR,
    "nobody knows the command {word}",
    "den Befehl {word} kennt niemand",
    remedy_en="most similar: {nearest}",
    remedy_de="am ähnlichsten: {nearest}",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900203,
    ERROR,
    "{word} is neither a word of the language nor an axis or spindle of this channel",
    "{word} ist weder ein Wort der Sprache noch eine Achse oder Spindel dieses Kanals",
    remedy_en="axes of the channel: {axes}; most similar: {nearest}",
    remedy_de="Achsen des Kanals: {axes}; am ähnlichsten: {nearest}",
    parameters={**_WORD, "axes": "names of the channel's axes", **_NEAREST},
)
_add(
    900204,
    ERROR,
    "there is no function {word}",
    "eine Funktion {word} gibt es nicht",
    remedy_en="write the number of a G, M or H function, a whole one",
    remedy_de="die Nummer einer G-, M- oder H-Funktion schreiben, eine ganze Zahl",
    parameters=_WORD,
)
_add(
    900205,
    ERROR,
    "the channel list does not define {word}",
    "die Kanalliste definiert {word} nicht",
    remedy_en="give it a synchronisation type there: {key} MOS",
    remedy_de="dort eine Synchronisationsart angeben: {key} MOS",
    parameters={**_WORD, "key": "the key of the channel list"},
)
_add(
    900206,
    ERROR,
    "{word} belongs to axis {axis}; a realtime cycle outputs functions of the channel only",
    "{word} gehört zur Achse {axis}; ein Echtzeit-Zyklus gibt nur Funktionen des Kanals aus",
    remedy_en="use another function, or take {key} out of the channel list",
    remedy_de="eine andere Funktion verwenden oder {key} aus der Kanalliste nehmen",
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
    remedy_en="output another M function and let the PLC react to it",
    remedy_de="eine andere M-Funktion ausgeben und die SPS darauf reagieren lassen",
    parameters=_WORD,
)
_add(
    900208,
    ERROR,
    "a value is missing behind {word}",
    "hinter {word} fehlt ein Wert",
    remedy_en="write a number, a variable or an expression behind it",
    remedy_de="eine Zahl, eine Variable oder einen Ausdruck dahinter schreiben",
    parameters=_WORD,
)
_add(
    900209,
    ERROR,
    "{word} stands twice in this block",
    "{word} steht zweimal in diesem Satz",
    remedy_en="keep the one that is meant",
    remedy_de="das behalten, das gemeint ist",
    parameters=_WORD,
)
_add(
    900210,
    ERROR,
    "{word} and {other} exclude each other in one block",
    "{word} und {other} schließen sich in einem Satz aus",
    remedy_en="divide the block, or keep one of both",
    remedy_de="den Satz teilen oder eines von beiden behalten",
    parameters={**_WORD, "other": "the function that stands before it"},
)
_add(
    900211,
    ERROR,
    "G04 stands alone in its block, with one time in seconds",
    "G04 steht allein im Satz, mit einer Zeit in Sekunden",
    remedy_en="write G04 X0.5 or G04 0.5",
    remedy_de="G04 X0.5 oder G04 0.5 schreiben",
)
_add(
    900212,
    ERROR,
    "{word} takes nothing further",
    "zu {word} gehört nichts Weiteres",
    remedy_en="remove what stands behind the number",
    remedy_de="entfernen, was hinter der Nummer steht",
    parameters=_WORD,
)
_add(
    900213,
    ERROR,
    "there is no variable {name}",
    "eine Variable {name} gibt es nicht",
    remedy_en="most similar: {nearest}; names distinguish upper and lower case",
    remedy_de="am ähnlichsten: {nearest}; Groß- und Kleinschreibung zählt",
    parameters={**_NAME, **_NEAREST},
)
_add(
    900214,
    ERROR,
    "{name} has {expected} indices here, not {given}",
    "{name} hat hier {expected} Indizes, nicht {given}",
    remedy_en="write {expected} indices in brackets",
    remedy_de="{expected} Indizes in Klammern schreiben",
    parameters={**_NAME, "expected": "indices of the declaration", "given": "indices as written"},
)
_add(
    900215,
    ERROR,
    "{name} is a structure and no value",
    "{name} ist eine Struktur und kein Wert",
    remedy_en="name a member: {member}",
    remedy_de="ein Element angeben: {member}",
    parameters={**_NAME, "member": "the member that is probably meant"},
)
_add(
    900216,
    ERROR,
    "{name} is READ_ONLY and cannot be written",
    "{name} ist READ_ONLY und nicht beschreibbar",
    remedy_en="write another variable, or change access_rights in the variables list",
    remedy_de="eine andere Variable beschreiben oder access_rights in der Variablenliste ändern",
    parameters=_NAME,
)
_add(
    900217,
    ERROR,
    "{name} is WRITE_ONLY and cannot be read",
    "{name} ist WRITE_ONLY und nicht lesbar",
    remedy_en="read another variable, or change access_rights in the variables list",
    remedy_de="eine andere Variable lesen oder access_rights in der Variablenliste ändern",
    parameters=_NAME,
)
_add(
    900218,
    ERROR,
    "there is no function {word}",
    "eine Funktion {word} gibt es nicht",
    remedy_en="most similar: {nearest}",
    remedy_de="am ähnlichsten: {nearest}",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900219,
    ERROR,
    "{word} takes {expected} arguments, not {given}",
    "{word} hat {expected} Argumente, nicht {given}",
    remedy_en="write {expected} values in the brackets, commas between them",
    remedy_de="{expected} Werte in die Klammern schreiben, durch Kommas getrennt",
    parameters={
        **_WORD,
        "expected": "how many the function takes",
        "given": "how many are written",
    },
)
_add(
    900220,
    ERROR,
    "{word} asks about names or texts and has no place in a realtime cycle",
    "{word} fragt nach Namen oder Texten und hat im Echtzeit-Zyklus keinen Platz",
    remedy_en="assign its value to a P parameter before, and read that one",
    remedy_de="den Wert vorher einem P-Parameter zuweisen und diesen lesen",
    parameters=_WORD,
)
_add(
    900221,
    ERROR,
    "{word} is no value",
    "{word} ist kein Wert",
    remedy_en="most similar: {nearest}; variables begin with V., functions have brackets",
    remedy_de="am ähnlichsten: {nearest}; Variablen beginnen mit V., Funktionen haben Klammern",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900222,
    ERROR,
    "{word}: ONCE, EDGE and ALWAYS belong into a realtime cycle",
    "{word}: ONCE, EDGE und ALWAYS gehören in einen Echtzeit-Zyklus",
    remedy_en="leave the word out, or move the $IF into #RT CYCLE … #RT CYCLE END",
    remedy_de="das Wort weglassen oder das $IF in #RT CYCLE … #RT CYCLE END verschieben",
    parameters=_WORD,
)
_add(
    900223,
    ERROR,
    "{word} stands in nothing that it could leave or repeat",
    "{word} steht in nichts, das es verlassen oder wiederholen könnte",
    remedy_en="put it into a loop; $BREAK also ends a $CASE",
    remedy_de="in eine Schleife setzen; $BREAK beendet auch ein $CASE",
    parameters=_WORD,
)
_add(
    900224,
    ERROR,
    "the keyword {word} stands twice",
    "das Schlüsselwort {word} steht zweimal",
    remedy_en="keep one of both",
    remedy_de="eines von beiden behalten",
    parameters=_WORD,
)
_add(
    900225,
    ERROR,
    "{word} = {value} does not exist",
    "{word} = {value} gibt es nicht",
    remedy_en="write one of these: {names}",
    remedy_de="eines davon schreiben: {names}",
    parameters={
        **_WORD,
        "value": "the value as written, or –",
        "names": "what the keyword may be",
    },
)
_add(
    900226,
    ERROR,
    "#RT CYCLE {action} needs an ID",
    "#RT CYCLE {action} braucht eine ID",
    remedy_en="write #RT CYCLE {action} [ID=1] with the ID of the definition",
    remedy_de="#RT CYCLE {action} [ID=1] mit der ID der Definition schreiben",
    parameters={"action": "the management command"},
)
_add(
    900227,
    WARNING,
    "{name} is asynchronous: its index is read once, too, when the cycle is defined",
    "{name} ist asynchron: auch der Index wird nur einmal gelesen, beim Definieren des Zyklus",
    remedy_en="write Vs. in front of it, to read it in each tick",
    remedy_de="Vs. davor schreiben, damit in jedem Takt gelesen wird",
    parameters=_NAME,
)
_add(
    900228,
    ERROR,
    "{name} is accessed with Vs. and without in one block",
    "{name} wird in einem Satz mit und ohne Vs. angesprochen",
    remedy_en="write Vs. here, too: it is synchronous for the whole block",
    remedy_de="auch hier Vs. schreiben: sie ist für den ganzen Satz synchron",
    parameters=_NAME,
)
_add(
    900229,
    ERROR,
    "this block is no NC text",
    "dieser Satz ist kein NC-Text",
    remedy_en="make it a comment",
    remedy_de="zum Kommentar machen",
)
_add(
    900230,
    ERROR,
    "the text has places for {expected} values, {given} are given",
    "der Text hat Platz für {expected} Werte, angegeben sind {given}",
    remedy_en="write one value for each %d, %f or %s; %% is the sign itself",
    remedy_de="zu jedem %d, %f oder %s einen Wert schreiben; %% ist das Zeichen selbst",
    parameters={"expected": "places in the text", "given": "values behind it"},
)
_add(
    900231,
    ERROR,
    "{word} is no place for a value",
    "{word} ist kein Platz für einen Wert",
    remedy_en="write %d, %f, %e, %g, %x or %s, or %% for the sign itself",
    remedy_de="%d, %f, %e, %g, %x oder %s schreiben, oder %% für das Zeichen selbst",
    parameters=_WORD,
)
_add(
    900232,
    ERROR,
    "{word} takes a number, no text",
    "{word} nimmt eine Zahl, keinen Text",
    remedy_en="write %s in its place, or give a number",
    remedy_de="%s an dieser Stelle schreiben oder eine Zahl angeben",
    parameters={"word": "the place in the text"},
)
_add(
    900233,
    ERROR,
    "{command} does not have this form",
    "{command} hat diese Form nicht",
    remedy_en="write it as the manual of the language has it",
    remedy_de="so schreiben, wie es die Programmieranleitung angibt",
    parameters={"command": "the command"},
)
_add(
    900234,
    ERROR,
    "{command} has no option {word}",
    "{command} hat keine Option {word}",
    remedy_en="one of these is possible: {names}",
    remedy_de="möglich sind: {names}",
    parameters={"command": "the command", **_WORD, "names": "the options that exist"},
)
_add(
    20003,
    ERROR,
    "G60 in a block without motion",
    "G60 in einem Satz ohne Bewegung",
    remedy_en="write it into the block at whose end the axes shall stand",
    remedy_de="in den Satz schreiben, an dessen Ende die Achsen stehen sollen",
    reaction=2,
    clearing=3,
)
_add(
    21981,
    ERROR,
    "{name} holds a text; realtime cycles know numbers only",
    "{name} enthält einen Text; Echtzeit-Zyklen kennen nur Zahlen",
    remedy_en="use a variable with a number",
    remedy_de="eine Variable mit einer Zahl verwenden",
    parameters=_NAME,
    reaction=2,
    clearing=3,
)
_add(
    21982,
    ERROR,
    "{command}: realtime cycles are off in this channel (P-CHAN-00406)",
    "{command}: Echtzeit-Zyklen sind in diesem Kanal ausgeschaltet (P-CHAN-00406)",
    remedy_en="write configuration.rt_cycles.enable 1 into the channel list and start again",
    remedy_de="configuration.rt_cycles.enable 1 in die Kanalliste schreiben und neu starten",
    parameters={"command": "the command"},
    reaction=2,
    clearing=3,
)
_add(
    21983,
    ERROR,
    "a GLOBAL realtime cycle has an ID above 0, not {id}",
    "ein GLOBAL-Echtzeit-Zyklus hat eine ID über 0, nicht {id}",
    remedy_en="give it a whole number from 1 on",
    remedy_de="eine ganze Zahl ab 1 angeben",
    parameters={"id": "the ID"},
    reaction=2,
    clearing=3,
)
_add(
    21984,
    ERROR,
    "structure {name} cannot be copied in a realtime cycle",
    "die Struktur {name} kann im Echtzeit-Zyklus nicht kopiert werden",
    remedy_en="assign member by member: {member}",
    remedy_de="Element für Element zuweisen: {member}",
    parameters={**_NAME, "member": "a member of the structure"},
    reaction=2,
    clearing=3,
)
_add(
    21993,
    ERROR,
    "{access} access to {name} is not defined: program {decoder}, realtime cycle {cycle}",
    "{access}-Zugriff auf {name} ist nicht definiert: Programm {decoder}, Echtzeit-Zyklus {cycle}",
    remedy_en="R is reading, W writing, – neither; move the access to where it is defined",
    remedy_de="R ist Lesen, W Schreiben, – keines; den Zugriff dorthin verlegen, wo es ihn gibt",
    parameters={
        **_NAME,
        "access": "R for reading, W for writing",
        "decoder": "what programs may do",
        "cycle": "what realtime cycles may do",
    },
    reaction=2,
    clearing=3,
)
_add(
    22001,
    ERROR,
    "structure or array {name} cannot be given a list of values in a realtime cycle",
    "Struktur oder Feld {name} kann im Echtzeit-Zyklus keine Werteliste zugewiesen werden",
    remedy_en="assign member by member, or before the cycle",
    remedy_de="Element für Element zuweisen oder vor dem Zyklus",
    parameters=_NAME,
    reaction=2,
    clearing=3,
)
_add(
    22002,
    ERROR,
    "{command} has no meaning in a realtime cycle",
    "{command} hat in einem Echtzeit-Zyklus keinen Sinn",
    remedy_en="a cycle is made of $IF, assignments, M and H functions",
    remedy_de="ein Zyklus besteht aus $IF, Zuweisungen, M- und H-Funktionen",
    parameters={"command": "the word or command"},
    reaction=2,
    clearing=3,
)
_add(
    22003,
    ERROR,
    "a realtime cycle with {word} needs an ID",
    "ein Echtzeit-Zyklus mit {word} braucht eine ID",
    remedy_en="write ID=1 or another whole number into the brackets",
    remedy_de="ID=1 oder eine andere ganze Zahl in die Klammern schreiben",
    parameters={"word": "DEF or SCOPE=GLOBAL"},
    reaction=2,
    clearing=3,
)
_add(
    22004,
    ERROR,
    "{command} has no keyword {word} in a realtime cycle",
    "{command} hat im Echtzeit-Zyklus kein Schlüsselwort {word}",
    remedy_en="leave it out",
    remedy_de="weglassen",
    parameters={"command": "the command", **_WORD},
    reaction=2,
    clearing=3,
)
_add(
    22006,
    ERROR,
    "#TIMER in a realtime cycle needs the word SYN",
    "#TIMER braucht im Echtzeit-Zyklus das Wort SYN",
    remedy_en="write #TIMER {action} SYN",
    remedy_de="#TIMER {action} SYN schreiben",
    parameters={"action": "START, STOP, READ or CLEAR"},
    reaction=2,
    clearing=3,
)
_add(
    22009,
    ERROR,
    "{name} is asynchronous and cannot be written in a realtime cycle",
    "{name} ist asynchron und im Echtzeit-Zyklus nicht beschreibbar",
    remedy_en="V.E and V.CH: synchronisation TRUE in the variables list, or Vs. for this block",
    remedy_de="V.E und V.CH: synchronisation TRUE in der Variablenliste, oder Vs. für diesen Satz",
    parameters=_NAME,
    reaction=2,
    clearing=3,
)
_add(
    22021,
    ERROR,
    "$ELSEIF takes no {word}",
    "bei $ELSEIF gibt es kein {word}",
    remedy_en="put an $IF {word} of its own into the branch",
    remedy_de="ein eigenes $IF {word} in den Zweig schreiben",
    parameters=_WORD,
    reaction=2,
    clearing=3,
)
_add(
    22022,
    ERROR,
    "$IF {word} has neither $ELSEIF nor $ELSE",
    "$IF {word} hat weder $ELSEIF noch $ELSE",
    remedy_en="close it before and write a second $IF",
    remedy_de="vorher schließen und ein zweites $IF schreiben",
    parameters={"word": "ONCE, EDGE or ALWAYS"},
    reaction=2,
    clearing=3,
)
_add(
    50875,
    ERROR,
    "{id} is no ID of a realtime cycle",
    "{id} ist keine ID eines Echtzeit-Zyklus",
    remedy_en="IDs are whole numbers from 1 on",
    remedy_de="IDs sind ganze Zahlen ab 1",
    parameters={"id": "the value of the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50929,
    ERROR,
    "{variable} has no element {index}; there are {count}, counted from 0",
    "{variable} hat kein Element {index}; es gibt {count}, gezählt ab 0",
    remedy_en="keep the index within the array, or enlarge it in the variables list",
    remedy_de="den Index im Feld halten oder das Feld in der Variablenliste vergrößern",
    parameters={
        "variable": "the array",
        "index": "the index",
        "count": "elements of the array",
    },
    reaction=6,
    clearing=6,
)
_add(
    50938,
    ERROR,
    "the channel list does not define M{function}",
    "die Kanalliste definiert M{function} nicht",
    remedy_en="give it a synchronisation type there: m_synch[{function}] MOS",
    remedy_de="dort eine Synchronisationsart angeben: m_synch[{function}] MOS",
    parameters={"function": "the number of the function"},
    reaction=6,
    clearing=6,
)
_add(
    50940,
    ERROR,
    "the channel list does not define H{function}",
    "die Kanalliste definiert H{function} nicht",
    remedy_en="give it a synchronisation type there: h_synch[{function}] MOS",
    remedy_de="dort eine Synchronisationsart angeben: h_synch[{function}] MOS",
    parameters={"function": "the number of the function"},
    reaction=6,
    clearing=6,
)

# --- decoder, while it evaluates -----------------------------------------------------------------

_add(
    20008,
    ERROR,
    "no feed is active for this feed motion",
    "für diese Vorschubbewegung ist kein Vorschub aktiv",
    remedy_en="program F with a value above 0, or give P-CHAN-00099 a start value",
    remedy_de="F mit einem Wert über 0 programmieren oder P-CHAN-00099 einen Startwert geben",
    reaction=2,
    clearing=3,
)
_add(
    21241,
    ERROR,
    "the argument of {operation} is outside its range",
    "das Argument von {operation} liegt außerhalb seines Bereichs",
    remedy_en="test the argument before, for example with $IF",
    remedy_de="das Argument vorher prüfen, zum Beispiel mit $IF",
    parameters={"operation": "the function"},
    reaction=2,
    clearing=3,
)
_add(
    900300,
    ERROR,
    "the operation {operation} has no result for these operands",
    "die Operation {operation} hat für diese Operanden kein Ergebnis",
    remedy_en="test the operands before: a divisor of 0, a negative base or too large bit patterns",
    remedy_de="die Operanden vorher prüfen: Divisor 0, negative Basis oder zu große Bitmuster",
    parameters={"operation": "the operator"},
    reaction=2,
    clearing=3,
)
_add(
    900301,
    ERROR,
    "the result of this expression is too large for a number",
    "das Ergebnis dieses Ausdrucks ist zu groß für eine Zahl",
    remedy_en="keep intermediate results below 1.8e308",
    remedy_de="Zwischenergebnisse unter 1,8e308 halten",
    reaction=2,
    clearing=3,
)
_add(
    900302,
    WARNING,
    "the step of this $FOR is 0: it never ends by itself",
    "die Schrittweite dieses $FOR ist 0: es endet nicht von selbst",
    remedy_en="give a step other than 0, or leave the loop with $BREAK",
    remedy_de="eine Schrittweite ungleich 0 angeben oder die Schleife mit $BREAK verlassen",
)
_add(
    900303,
    ERROR,
    "{count} blocks in a row without one that takes time: a loop that never moves?",
    "{count} Sätze hintereinander ohne einen, der Zeit braucht: eine Schleife ohne Bewegung?",
    remedy_en="give the loop an end, or let it move, dwell (#TIME) or wait (#FLUSH WAIT)",
    remedy_de="die Schleife beenden oder in ihr fahren, verweilen (#TIME), warten (#FLUSH WAIT)",
    parameters={"count": "the most blocks that are decoded so"},
    reaction=2,
    clearing=3,
)
_add(
    900304,
    ERROR,
    "format and values of this #MSG do not fit together at '{found}'",
    "Format und Werte dieses #MSG passen bei '{found}' nicht zusammen",
    remedy_en="give one value for each %d, %f, %s … of the format",
    remedy_de="zu jedem %d, %f, %s … des Formats einen Wert angeben",
    parameters={"found": "the place in the format, or the value, that is too much"},
    reaction=2,
    clearing=3,
)
_add(
    900305,
    ERROR,
    "a dwell of {seconds} s is not possible",
    "eine Verweilzeit von {seconds} s ist nicht möglich",
    remedy_en="program a time of 0 s or more",
    remedy_de="eine Zeit von 0 s oder mehr programmieren",
    parameters={"seconds": "the time"},
    reaction=2,
    clearing=3,
)
_add(
    900306,
    ERROR,
    "the target {position} of axis {axis} is outside its software limits {low} … {high}",
    "das Ziel {position} der Achse {axis} liegt außerhalb der Software-Endschalter {low} … {high}",
    remedy_en="program a position between the limits (P-AXIS-00177, P-AXIS-00178)",
    remedy_de="eine Position zwischen den Grenzen programmieren (P-AXIS-00177, P-AXIS-00178)",
    parameters={
        "axis": "name of the axis",
        "position": "target in mm or degrees",
        "low": "lower limit",
        "high": "upper limit",
    },
    reaction=2,
    clearing=3,
)

# --- realtime part -------------------------------------------------------------------------------

_add(
    50854,
    ERROR,
    "the realtime cycles need {steps} elementary instructions in a tick, {limit} are allowed",
    "die Echtzeit-Zyklen brauchen {steps} Elementar-Anweisungen im Takt, erlaubt sind {limit}",
    remedy_en="shorten cycle {cycle} or another one, or raise rt_cycles.max_steps (P-CHAN-00427)",
    remedy_de="Zyklus {cycle} oder andere kürzen oder rt_cycles.max_steps (P-CHAN-00427) erhöhen",
    parameters={"cycle": "cycle at fault", "steps": "instructions so far", "limit": "the limit"},
    reaction=6,
    clearing=6,
)
_add(
    50858,
    ERROR,
    "no realtime cycle has the ID {id}",
    "kein Echtzeit-Zyklus hat die ID {id}",
    remedy_en="define the cycle before, and mind its scope: it may have ended already",
    remedy_de="den Zyklus vorher definieren; seine Gültigkeit beachten: er kann schon beendet sein",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50877,
    ERROR,
    "more than {count} realtime cycles at once",
    "mehr als {count} Echtzeit-Zyklen zugleich",
    remedy_en="delete cycles that are no longer needed with #RT CYCLE DELETE",
    remedy_de="nicht mehr gebrauchte Zyklen mit #RT CYCLE DELETE löschen",
    parameters={"count": "the most cycles of a channel"},
    reaction=6,
    clearing=6,
)
_add(
    50879,
    ERROR,
    "'{operation}' in realtime cycle {cycle} has no usable result",
    "'{operation}' im Echtzeit-Zyklus {cycle} hat kein brauchbares Ergebnis",
    remedy_en="test the operands with $IF before; '=' stands for a result that is too large",
    remedy_de="die Operanden vorher mit $IF prüfen; '=' steht für ein zu großes Ergebnis",
    parameters={"cycle": "cycle at fault", "operation": "operator or function"},
    reaction=6,
    clearing=6,
)
_add(
    50892,
    ERROR,
    "{value} is outside the range {low} … {high} of {variable}",
    "{value} liegt außerhalb des Bereichs {low} … {high} von {variable}",
    remedy_en="limit the value, or give the variable a larger type",
    remedy_de="den Wert begrenzen oder der Variablen einen größeren Typ geben",
    parameters={
        "variable": "the variable",
        "value": "the value, rounded",
        "low": "smallest value of its type",
        "high": "largest value of its type",
    },
    reaction=6,
    clearing=6,
)
_add(
    50893,
    ERROR,
    "{value} is not a finite number and cannot be given to {name}",
    "{value} ist keine endliche Zahl und kann {name} nicht zugewiesen werden",
    remedy_en="give a finite number",
    remedy_de="eine endliche Zahl angeben",
    parameters={"name": "the variable", "value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    50900,
    ERROR,
    "the ID {id} belongs to another realtime cycle already",
    "die ID {id} gehört schon einem anderen Echtzeit-Zyklus",
    remedy_en="choose another ID, or delete the other cycle before with #RT CYCLE DELETE",
    remedy_de="eine andere ID wählen oder den anderen Zyklus vorher mit #RT CYCLE DELETE löschen",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50939,
    ERROR,
    "the realtime cycles take too long: {steps} elementary instructions, time is for {limit}",
    "die Echtzeit-Zyklen dauern zu lange: {steps} Elementar-Anweisungen, Zeit ist für {limit}",
    remedy_en="shorten cycle {cycle} or others, or raise rt_cycles.max_duration (P-CHAN-00425)",
    remedy_de="Zyklus {cycle} oder andere kürzen, rt_cycles.max_duration (P-CHAN-00425) erhöhen",
    parameters={
        "cycle": "cycle at fault",
        "steps": "instructions so far",
        "limit": "instructions for which the share of the tick lasts",
    },
    reaction=6,
    clearing=6,
)
_add(
    50942,
    ERROR,
    "{function} cannot be handed to the PLC: all {slots} places of the interface are taken",
    "{function} kann der SPS nicht übergeben werden: alle {slots} Plätze der Schnittstelle belegt",
    remedy_en="let the PLC acknowledge in every tick, or output fewer functions",
    remedy_de="die SPS in jedem Takt quittieren lassen oder weniger Funktionen ausgeben",
    parameters={"function": "the function", "slots": "places of the realtime section"},
    reaction=6,
    clearing=6,
)
_add(
    50943,
    ERROR,
    "{function} is one function too many in this tick: the interface holds {slots}",
    "{function} ist in diesem Takt eine Funktion zu viel: die Schnittstelle fasst {slots}",
    remedy_en="spread the functions over several ticks",
    remedy_de="die Funktionen auf mehrere Takte verteilen",
    parameters={"function": "the function", "slots": "places of the realtime section"},
    reaction=6,
    clearing=6,
)
_add(
    900410,
    NOTE,
    "there is no realtime cycle with this ID: nothing to delete",
    "es gibt keinen Echtzeit-Zyklus mit dieser ID: nichts zu löschen",
    remedy_en="",
    remedy_de="",
)
_add(
    900411,
    NOTE,
    "the realtime cycle does not run: HOLD has no effect",
    "der Echtzeit-Zyklus läuft nicht: HOLD bewirkt nichts",
    remedy_en="",
    remedy_de="",
)
_add(
    900412,
    NOTE,
    "the realtime cycle is not held: CONTINUE has no effect",
    "der Echtzeit-Zyklus ist nicht angehalten: CONTINUE bewirkt nichts",
    remedy_en="",
    remedy_de="",
)
_add(
    900413,
    NOTE,
    "a realtime cycle with scope BLOCK ended with the program without having run",
    "ein Echtzeit-Zyklus mit Gültigkeit BLOCK endete mit dem Programm, ohne gelaufen zu sein",
    remedy_en="",
    remedy_de="",
)
_add(
    900420,
    ERROR,
    "the block does not begin where the axes stand",
    "der Satz beginnt nicht dort, wo die Achsen stehen",
    remedy_en="let the decoder read the positions anew before, with #FLUSH WAIT or #CHANNEL INIT",
    remedy_de="den Dekoder die Positionen vorher neu lesen lassen: #FLUSH WAIT, #CHANNEL INIT",
    reaction=6,
    clearing=6,
)

# --- command line, files, stimuli, PLC -----------------------------------------------------------

_add(
    900500,
    ERROR,
    "{file} does not exist",
    "{file} gibt es nicht",
    remedy_en="Check the path; it is relative to the folder in which nctakt runs.",
    remedy_de="Den Pfad prüfen; er gilt ab dem Ordner, in dem nctakt läuft.",
    parameters={"file": "the path as it was given"},
)
_add(
    900501,
    ERROR,
    "{file} is a folder; a file is needed here",
    "{file} ist ein Ordner; hier wird eine Datei gebraucht",
    remedy_en="Name a file in the folder.",
    remedy_de="Eine Datei aus dem Ordner nennen.",
    parameters={"file": "the path as it was given"},
)
_add(
    900502,
    ERROR,
    "{folder} is no folder",
    "{folder} ist kein Ordner",
    remedy_en="Name the folder that holds the machine's lists.",
    remedy_de="Den Ordner mit den Listen der Maschine nennen.",
    parameters={"folder": "the path as it was given"},
)
_add(
    900503,
    ERROR,
    "{file} cannot be read: {reason}",
    "{file} kann nicht gelesen werden: {reason}",
    remedy_en="Check the rights of the file, and whether it is complete.",
    remedy_de="Die Rechte der Datei prüfen, und ob sie vollständig ist.",
    parameters={"file": "the path as it was given", "reason": "what the system says"},
)
_add(
    900504,
    ERROR,
    "standard input ('-') is named more than once",
    "die Standardeingabe ('-') ist mehrfach genannt",
    remedy_en="Name '-' once; further programs need files.",
    remedy_de="'-' einmal nennen; weitere Programme brauchen Dateien.",
)
_add(
    900506,
    ERROR,
    "{file}: the end of the name says no trace format",
    "{file}: die Endung nennt kein Format für Aufzeichnungen",
    remedy_en="Give the file the suffix {suffixes}.",
    remedy_de="Der Datei eine dieser Endungen geben: {suffixes}.",
    parameters={"file": "the path as it was given", "suffixes": "the suffixes that are known"},
)
_add(
    900507,
    ERROR,
    "{file} cannot be written: {reason}",
    "{file} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder that exists, with the right to write and room on the disk.",
    remedy_de="Einen vorhandenen Ordner mit Schreibrecht und freiem Platz wählen.",
    parameters={"file": "the path as it was given", "reason": "what the system says"},
)
_add(
    900508,
    ERROR,
    "{file} is no trace that nctakt has written",
    "{file} ist keine Aufzeichnung von nctakt",
    remedy_en="Name a file that nctakt run --trace made.",
    remedy_de="Eine Datei nennen, die nctakt run --trace geschrieben hat.",
    parameters={"file": "the path as it was given"},
)
_add(
    900510,
    ERROR,
    "'{text}' is no time",
    "'{text}' ist keine Zeit",
    remedy_en="Write a number from 0 on with us, ms, s or min, such as 1500us or 1.5ms; "
    "a number alone means seconds.",
    remedy_de="Eine Zahl ab 0 mit us, ms, s oder min schreiben, etwa 1500us oder 1.5ms; "
    "eine Zahl allein bedeutet Sekunden.",
    parameters={"text": "the time as it was given"},
)
_add(
    900511,
    ERROR,
    "'{text}' does not give a value to a variable",
    "'{text}' gibt keiner Variablen einen Wert",
    remedy_en="Write NAME=VALUE, such as V.E.VALUE=5.",
    remedy_de="NAME=WERT schreiben, etwa V.E.VALUE=5.",
    parameters={"text": "what was given"},
)
_add(
    900512,
    ERROR,
    "{name}: '{value}' is no value",
    "{name}: '{value}' ist kein Wert",
    remedy_en="Write a number, TRUE or FALSE.",
    remedy_de="Eine Zahl, TRUE oder FALSE schreiben.",
    parameters={"name": "the variable", "value": "the value as it was given"},
)
_add(
    900520,
    ERROR,
    "{file} has no class with a method cycle(self, hli)",
    "{file} hat keine Klasse mit einer Methode cycle(self, hli)",
    remedy_en="Define one class whose method cycle is called after each tick.",
    remedy_de="Eine Klasse definieren, deren Methode cycle nach jedem Takt aufgerufen wird.",
    parameters={"file": "the PLC's file"},
)
_add(
    900521,
    ERROR,
    "{file} has several classes with a method cycle: {names}",
    "{file} hat mehrere Klassen mit einer Methode cycle: {names}",
    remedy_en="Keep one; put an underscore in front of the names of the others.",
    remedy_de="Eine behalten; den Namen der anderen einen Unterstrich voranstellen.",
    parameters={"file": "the PLC's file", "names": "the classes"},
)
_add(
    900522,
    ERROR,
    "the PLC's file fails while it is loaded: {reason}\n{traceback}",
    "die Datei der SPS scheitert beim Laden: {reason}\n{traceback}",
    remedy_en="Correct the file at the line that stands last.",
    remedy_de="Die Datei an der zuletzt genannten Zeile berichtigen.",
    parameters={"reason": "the exception", "traceback": "the way to it, in the user's files"},
)
_add(
    900523,
    ERROR,
    "the PLC fails after tick {tick}: {reason}\n{traceback}",
    "die SPS scheitert nach Takt {tick}: {reason}\n{traceback}",
    remedy_en="Correct the PLC's file at the line that stands last.",
    remedy_de="Die Datei der SPS an der zuletzt genannten Zeile berichtigen.",
    parameters={
        "tick": "the tick that had just been run",
        "reason": "the exception",
        "traceback": "the way to it, in the user's files",
    },
)
_add(
    900530,
    ERROR,
    "the realtime part is not compiled here, so --compiled cannot be had",
    "der Echtzeit-Teil ist hier nicht übersetzt, --compiled ist nicht möglich",
    remedy_en="Install nctakt where a C compiler is present, or leave --compiled out.",
    remedy_de="nctakt mit einem C-Compiler installieren oder --compiled weglassen.",
)
_add(
    900531,
    NOTE,
    "the realtime part is not compiled here; the results are the same, it takes longer",
    "der Echtzeit-Teil ist hier nicht übersetzt; die Ergebnisse sind gleich, es dauert länger",
    remedy_en="Install nctakt where a C compiler is present.",
    remedy_de="nctakt mit einem C-Compiler installieren.",
)

# The lines of the diagnosis data of realtime cycles; what is information there is a note here.

_HIDE_INFO_EN = "V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data."
_HIDE_INFO_DE = "V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus."
_HIDE_ACTION_EN = "V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data."
_HIDE_ACTION_DE = "V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus."
_CYCLE = {"cycle": "the cycle's ID, or # and a number when it has none"}

_add(
    900550,
    NOTE,
    "Realtime cycle manager was initialised",
    "Echtzeit-Zyklen-Manager wurde initialisiert",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
)
_add(
    900551,
    NOTE,
    "Realtime cycle manager: {count} cycles",
    "Echtzeit-Zyklen-Manager: {count} Zyklen",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters={"count": "how many cycles there are"},
)
_add(
    900552,
    NOTE,
    "Cycle {cycle} was created with {scope} validity",
    "Zyklus {cycle} mit Gueltigkeit {scope} wurde angelegt",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters={**_CYCLE, "scope": "BLOCK, PROG or GLOBAL"},
)
_add(
    900553,
    NOTE,
    "Cycle {cycle} was started",
    "Zyklus {cycle} wurde gestartet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900554,
    NOTE,
    "Cycle {cycle} was put on hold",
    "Zyklus {cycle} wurde angehalten",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900555,
    NOTE,
    "Cycle {cycle} was continued",
    "Zyklus {cycle} wurde fortgesetzt",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900556,
    NOTE,
    "The actions of cycle {cycle} were aborted",
    "Die Aktionen von Zyklus {cycle} wurden abgebrochen",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900557,
    NOTE,
    "Cycle {cycle} ended with its validity",
    "Zyklus {cycle} endete mit seiner Gueltigkeit",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900558,
    NOTE,
    "Cycle {cycle} was deleted",
    "Zyklus {cycle} wurde geloescht",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900559,
    NOTE,
    "Cycle {cycle} was ended by a reset",
    "Zyklus {cycle} wurde durch einen Reset beendet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900560,
    NOTE,
    "Cycle {cycle} was ended by an error",
    "Zyklus {cycle} wurde durch einen Fehler beendet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900561,
    NOTE,
    "Cycle {cycle}: the branch in line {line} runs",
    "Zyklus {cycle}: der Zweig in Zeile {line} laeuft",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={**_CYCLE, "line": "the line of the branch"},
)
_add(
    900562,
    NOTE,
    "Cycle {cycle}: {variable} = {value}",
    "Zyklus {cycle}: {variable} = {value}",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={**_CYCLE, "variable": "the variable's name", "value": "its new value"},
)
_add(
    900563,
    NOTE,
    "Cycle {cycle}: {function} was put out, number {sequence} of the tick",
    "Zyklus {cycle}: {function} wurde ausgegeben, Nummer {sequence} im Takt",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={
        **_CYCLE,
        "function": "the M or H function",
        "sequence": "its number within the tick, from 1",
    },
)
_add(
    900540,
    ERROR,
    "there is no variable {name}",
    "es gibt keine Variable {name}",
    remedy_en="see the machine's variables list for the names",
    remedy_de="die Namen stehen in der Variablenliste der Maschine",
    parameters={"name": "the name"},
)
_add(
    900541,
    ERROR,
    "there is no variable {name}",
    "es gibt keine Variable {name}",
    remedy_en="did you mean {nearest}?",
    remedy_de="war {nearest} gemeint?",
    parameters={"name": "the name", "nearest": "the nearest known name"},
)
_add(
    900542,
    ERROR,
    "{name} belongs to the controller and cannot be set from outside",
    "{name} gehört der Steuerung und kann nicht von außen gesetzt werden",
    remedy_en="set V.E or V.CH variables; write V.RT* variables in a program or a realtime cycle",
    remedy_de="V.E- oder V.CH-Variablen setzen; V.RT* in Programm oder Echtzeit-Zyklus schreiben",
    parameters={"name": "the name"},
)
_add(
    900543,
    ERROR,
    "{name} of type {type} does not take the value {value}",
    "{name} vom Typ {type} nimmt den Wert {value} nicht",
    remedy_en="give a number to a number, a text to a text",
    remedy_de="einer Zahl eine Zahl geben, einem Text einen Text",
    parameters={"name": "the variable", "type": "its type", "value": "the value"},
)
_add(
    900544,
    ERROR,
    "there is no signal {name}",
    "es gibt kein Signal {name}",
    remedy_en="did you mean {nearest}?",
    remedy_de="war {nearest} gemeint?",
    parameters={"name": "the name", "nearest": "the nearest known name"},
)
