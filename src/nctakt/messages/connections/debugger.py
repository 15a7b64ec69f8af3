# SPDX-License-Identifier: MIT
"""Messages of the debugger: its protocol, breakpoints, limits."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

FILE_CHANGED_IN_RUN = warning(
    902969,
    en="{file} has changed on disk, from this line on: lines of the run are those of its old text",
    de="{file} ist ab dieser Zeile auf der Platte geändert: Zeilen des Laufs sind die des alten "
    "Textes",
    remedy_en="Start again to run the new text.",
    remedy_de="Neu starten, damit der neue Text läuft.",
    file=("the file", "die Datei"),
)
NOT_A_HEADER = error(
    901220,
    en='this is not the header of a message: "{text}"',
    de='das ist kein Nachrichtenkopf: "{text}"',
    remedy_en="Each message begins with Content-Length: N and an empty line.",
    remedy_de="Jede Nachricht beginnt mit Content-Length: N und einer Leerzeile.",
    text=("the bytes", "die Bytes"),
)
MESSAGE_TOO_LONG = error(
    901221,
    en="a message of {count} bytes is longer than {limit}",
    de="eine Nachricht von {count} Byte ist länger als {limit}",
    remedy_en="Send shorter messages.",
    remedy_de="Kürzere Nachrichten senden.",
    count=("its length", "ihre Länge"),
)
NOT_A_MESSAGE = error(
    901222,
    en="a message is not a JSON object: {reason}",
    de="eine Nachricht ist kein JSON-Objekt: {reason}",
    remedy_en="Messages are requests of the Debug Adapter Protocol.",
    remedy_de="Nachrichten sind Anfragen des Debug Adapter Protocol.",
    reason=("what is wrong", "was falsch ist"),
)
UNKNOWN_REQUEST = error(
    901223,
    en="the debugger does not know the request {command}",
    de="der Debugger kennt die Anfrage {command} nicht",
    remedy_en="Send only requests that the answer to initialize announces.",
    remedy_de="Nur Anfragen senden, die die Antwort auf initialize ankündigt.",
    command=("the request", "die Anfrage"),
)
WRONG_ARGUMENT = error(
    901224,
    en="{name} must be {expected}",
    de="{name} muss {expected} sein",
    remedy_en="docs/debugger-setup.md explains the settings of a launch configuration.",
    remedy_de="docs/debugger-setup.md erklärt die Einstellungen einer Startkonfiguration.",
    name=("the argument", "das Argument"),
)
NOT_LAUNCHED = error(
    901225,
    en="{command} needs a program that has been launched",
    de="{command} braucht ein gestartetes Programm",
    remedy_en="Send launch or attach first.",
    remedy_de="Zuerst launch oder attach senden.",
    command=("the request", "die Anfrage"),
)
RUN_IS_ON = error(
    901226,
    en="{command} is only possible while the run is stopped",
    de="{command} ist nur möglich, solange der Lauf steht",
    remedy_en="Pause the run first.",
    remedy_de="Den Lauf zuerst anhalten.",
    command=("the request", "die Anfrage"),
)
TOO_MANY_REQUESTS = error(
    901227,
    en="{limit} requests are already waiting",
    de="es warten schon {limit} Anfragen",
    remedy_en="Wait for answers before you send more requests.",
    remedy_de="Antworten abwarten, bevor weitere Anfragen kommen.",
)
REQUEST_CANCELLED = note(
    901228,
    en="cancelled",
    de="abgebrochen",
    remedy_en="Ask again if you need it.",
    remedy_de="Bei Bedarf noch einmal fragen.",
)
NOT_IN_THE_RUN = error(
    901229,
    en="{file} is not a program of this run",
    de="{file} ist kein Programm dieses Laufs",
    remedy_en="Launch it, or call it from the program that runs.",
    remedy_de="Es starten oder vom laufenden Programm aus aufrufen.",
)
NO_LINE_TO_STOP_AT = error(
    901230,
    en="there is no block from line {line} on",
    de="ab Zeile {line} gibt es keinen Satz",
    remedy_en="Set the breakpoint at a block, or at a branch of a realtime cycle.",
    remedy_de="Den Haltepunkt auf einen Satz oder einen Zweig eines Echtzeit-Zyklus setzen.",
)
NOT_A_HIT_CONDITION = error(
    901231,
    en="this is not a hit condition: {text}",
    de="das ist keine Trefferbedingung: {text}",
    remedy_en="Write 5 (from the fifth time on), == 5, > 5, <= 5, or % 5 (each fifth time).",
    remedy_de="Schreibweisen: 5 (ab dem fünften Mal), == 5, > 5, <= 5, % 5 (jedes fünfte Mal).",
)
CHANGES_NEEDS_A_BRANCH = error(
    901232,
    en='"changes" belongs to a branch of a realtime cycle, or to an assignment in it',
    de='"changes" gehört zu einem Zweig eines Echtzeit-Zyklus oder zu einer Zuweisung darin',
    remedy_en="Leave it out here, or set a data breakpoint on a variable.",
    remedy_de="Es hier weglassen oder einen Datenhaltepunkt auf eine Variable setzen.",
)
DECODER_VARIABLE = error(
    901233,
    en="{name} belongs to the decoder, which works ahead of the ticks: it is read-only",
    de="{name} gehört zum Dekoder, der den Takten vorausläuft: nur lesbar",
    remedy_en="Set a V.E or V.CH variable, or a value of the HLI.",
    remedy_de="Eine Variable V.E oder V.CH oder einen Wert des HLI setzen.",
)
UNKNOWN_REFERENCE = error(
    901234,
    en="{what} {number} is unknown or no longer valid",
    de="{what} {number} ist unbekannt oder nicht mehr gültig",
    remedy_en="Ask for the numbers again: they are valid until the run continues.",
    remedy_de="Die Nummern neu anfordern: sie gelten, bis der Lauf weitergeht.",
    what=("what it is the number of", "wessen Nummer es ist"),
)
UNKNOWN_CONSOLE_COMMAND = error(
    901235,
    en="this is neither a command of the console nor an expression: {text}",
    de="das ist weder ein Befehl der Konsole noch ein Ausdruck: {text}",
    remedy_en="Type help for the commands.",
    remedy_de="Mit help die Befehle ansehen.",
)
NEVER_HELD = note(
    901236,
    en="it has not happened before",
    de="das ist bisher nicht vorgekommen",
    remedy_en="The session stays where it is.",
    remedy_de="Die Sitzung bleibt, wo sie ist.",
)
PROGRAM_WITH_ERRORS = error(
    901237,
    en="{program} has errors and does not run; the first: {first}",
    de="{program} hat Fehler und läuft nicht; der erste: {first}",
    remedy_en="The debug console shows all of them.",
    remedy_de="Die Debug-Konsole zeigt alle.",
    program=("the program", "das Programm"),
    first=("its first error", "sein erster Fehler"),
)
NO_LIVE_PAGE = error(
    901238,
    en="no nctakt live answers at port {port}: {reason}",
    de="an Port {port} antwortet kein nctakt live: {reason}",
    remedy_en="Start nctakt live with --dap PORT, and attach to that port.",
    remedy_de="nctakt live mit --dap PORT starten und diesen Port angeben.",
)
UNREADABLE_VALUE_TEXT = error(
    901239,
    en="this is not a value: {text}",
    de="das ist kein Wert: {text}",
    remedy_en='Write a number, TRUE, FALSE or a text in quotes: "A1".',
    remedy_de='Eine Zahl, TRUE, FALSE oder einen Text in Anführungszeichen schreiben: "A1".',
)

NOT_RESTARTED = error(
    902570,
    en="only a program on the path of a channel can be restarted",
    de="neu beginnen kann nur ein Programm auf der Bahn eines Kanals",
    remedy_en="Choose a frame of a channel, not of its decoder.",
    remedy_de="Einen Aufruf eines Kanals wählen, nicht seines Dekoders.",
)
NO_INSTRUCTIONS = error(
    902571,
    en="there are no instructions at {reference}",
    de="bei {reference} stehen keine Anweisungen",
    remedy_en="Ask for the address of a frame of a realtime cycle that exists now.",
    remedy_de="Nach der Adresse eines Aufrufs eines vorhandenen Echtzeit-Zyklus fragen.",
    reference=("the address", "die Adresse"),
)
GOTO_NEEDS_LAUNCH = error(
    902572,
    en="a program that the debugger has not started cannot be restarted at another block",
    de="ein Programm, das der Debugger nicht gestartet hat, kann nicht an einem anderen Satz neu "
    "beginnen",
    remedy_en="Launch it with fromLine instead.",
    remedy_de="Es stattdessen mit fromLine starten.",
)

NO_VALUE = error(
    901926,
    en="{text} has no value here: {reason}",
    de="{text} hat hier keinen Wert: {reason}",
    remedy_en="Ask again where it has one, or for another expression.",
    remedy_de="Dort fragen, wo es einen hat, oder einen anderen Ausdruck abfragen.",
    text=("what was asked for", "das Gefragte"),
    reason=("why there is none", "warum es keinen gibt"),
)
