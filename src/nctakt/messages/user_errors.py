# SPDX-License-Identifier: MIT
"""Messages of ``#ERROR`` (900280 … 900281, 900460 … 900469)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900280,
    ERROR,
    "#ERROR has no ID",
    "#ERROR hat keine ID",
    remedy_en="Give it the number of the error: #ERROR [ID=1 RC=2]",
    remedy_de="Die Nummer des Fehlers angeben: #ERROR [ID=1 RC=2]",
)
_add(
    900281,
    ERROR,
    "a text of #ERROR has at most {longest} characters",
    "ein Text von #ERROR hat höchstens {longest} Zeichen",
    remedy_en="Shorten the text, or put it into the file of error_text_user_of_id (P-STUP-00169).",
    remedy_de="Den Text kürzen oder ihn in die Datei von error_text_user_of_id (P-STUP-00169) "
    "schreiben.",
    parameters={"longest": "the most characters"},
)
_add(
    900468,
    WARNING,
    "{file}, line {line}: no number of a user error from 1 to 1000 with its text; left out",
    "{file}, Zeile {line}: keine Nummer eines Anwenderfehlers von 1 bis 1000 mit ihrem Text; "
    "entfällt",
    remedy_en="Each line holds the number, a blank or tabulator, the text.",
    remedy_de="Jede Zeile enthält die Nummer, ein Leerzeichen oder einen Tabulator, den Text.",
    parameters={"file": "the file", "line": "the line in the file"},
)
_add(
    900469,
    WARNING,
    "the file with the texts of user errors is not there: {path}",
    "die Datei mit den Texten der Anwenderfehler fehlt: {path}",
    remedy_en="Correct error_text_user_of_id (P-STUP-00169); user errors are told without texts.",
    remedy_de="error_text_user_of_id (P-STUP-00169) berichtigen; Anwenderfehler werden ohne Text "
    "gemeldet.",
    parameters={"path": "the path as the list has it"},
)
_add(
    900460,
    ERROR,
    "{value} is no ID of #ERROR: IDs are whole numbers from 1 to 1000",
    "{value} ist keine ID von #ERROR: IDs sind ganze Zahlen von 1 bis 1000",
    remedy_en="Give #ERROR an ID from 1 to 1000.",
    remedy_de="#ERROR eine ID von 1 bis 1000 geben.",
    parameters={"value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    900461,
    ERROR,
    "{value} is no RC of #ERROR: 0 warns, 1 to 6 stop until a reset, 7 until a restart",
    "{value} ist kein RC von #ERROR: 0 warnt, 1 bis 6 halten bis zum Reset an, 7 bis zum Neustart",
    remedy_en="Give #ERROR a whole RC from 0 to 7.",
    remedy_de="#ERROR einen ganzzahligen RC von 0 bis 7 geben.",
    parameters={"value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    900462,
    ERROR,
    "{value} is no MID of #ERROR: it tells errors of one ID apart and is a whole number above 0",
    "{value} ist keine MID von #ERROR: sie unterscheidet Fehler einer ID und ist ganz und größer 0",
    remedy_en="Give #ERROR a MID from 1 on, or none.",
    remedy_de="#ERROR eine MID ab 1 geben oder keine.",
    parameters={"value": "the value"},
)
_add(
    900463,
    WARNING,
    "user warning {said} ({values})",
    "Anwender-Warnung {said} ({values})",
    remedy_en="The program has raised it with #ERROR and RC=0; it goes on.",
    remedy_de="Das Programm hat sie mit #ERROR und RC=0 gemeldet; es läuft weiter.",
    parameters={
        "said": "the user's number, with its text where there is one",
        "values": "the values that the program gives",
    },
    reaction=1,
    clearing=1,
)
_add(
    900464,
    ERROR,
    "user error {said} ({values})",
    "Anwenderfehler {said} ({values})",
    remedy_en="The program has raised it with #ERROR; a reset clears it.",
    remedy_de="Das Programm hat ihn mit #ERROR gemeldet; ein Reset behebt ihn.",
    parameters={
        "said": "the user's number, with its text where there is one",
        "values": "the values that the program gives",
    },
    reaction=6,
    clearing=3,
)
_add(
    900465,
    ERROR,
    "fatal user error {said} ({values})",
    "fataler Anwenderfehler {said} ({values})",
    remedy_en="The program has raised it with #ERROR and RC=7; only a restart of the controller "
    "clears it.",
    remedy_de="Das Programm hat ihn mit #ERROR und RC=7 gemeldet; nur ein Neustart der Steuerung "
    "behebt ihn.",
    parameters={
        "said": "the user's number, with its text where there is one",
        "values": "the values that the program gives",
    },
    reaction=6,
    clearing=7,
)
_add(
    900466,
    ERROR,
    "no program can be started: a fatal user error (#ERROR with RC=7) has stopped the channel",
    "kein Programm kann gestartet werden: ein fataler Anwenderfehler (#ERROR mit RC=7) hat den "
    "Kanal angehalten",
    remedy_en="Restart the controller: a reset does not clear this error.",
    remedy_de="Die Steuerung neu starten: ein Reset behebt diesen Fehler nicht.",
)
