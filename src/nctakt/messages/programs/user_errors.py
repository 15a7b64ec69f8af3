# SPDX-License-Identifier: MIT
"""Messages about ``#ERROR``."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

USER_ERROR_WITHOUT_ID = error(
    21171,
    classes=(0, 0),
    known_as=(900280,),
    en="#ERROR has no ID",
    de="#ERROR hat keine ID",
    remedy_en="Give the number of the error: #ERROR [ID=1 RC=2]",
    remedy_de="Die Nummer des Fehlers angeben: #ERROR [ID=1 RC=2]",
)
USER_ERROR_TEXT_TOO_LONG = error(
    900281,
    known_as=(20723,),
    en="a text of #ERROR can have at most {longest} characters",
    de="ein Text von #ERROR kann höchstens {longest} Zeichen haben",
    remedy_en="Shorten the text, or put it in the file named by error_text_user_of_id "
    "(P-STUP-00169).",
    remedy_de="Den Text kürzen oder in die Datei schreiben, die error_text_user_of_id "
    "(P-STUP-00169) nennt.",
    longest=("the maximum number of characters", "die größte Anzahl von Zeichen"),
)
INVALID_USER_TEXT_LINE = warning(
    900468,
    en="{file}, line {line}: not a number from 1 to 1000 with the text of a user error; ignored",
    de="{file}, Zeile {line}: keine Nummer von 1 bis 1000 mit dem Text eines Anwenderfehlers; "
    "ignoriert",
    remedy_en="Each line contains the number, a blank or tab, and the text.",
    remedy_de="Jede Zeile enthält die Nummer, ein Leerzeichen oder einen Tabulator und den Text.",
    line=("the line in the file", "die Zeile in der Datei"),
)
USER_TEXTS_MISSING = warning(
    296010,
    known_as=(900469,),
    en="the file with the texts of user errors does not exist: {path}",
    de="die Datei mit den Texten der Anwenderfehler gibt es nicht: {path}",
    remedy_en="Correct error_text_user_of_id (P-STUP-00169); user errors are reported without "
    "texts.",
    remedy_de="error_text_user_of_id (P-STUP-00169) berichtigen; Anwenderfehler werden ohne Text "
    "gemeldet.",
    path=("the path as the list has it", "der Pfad, wie er in der Liste steht"),
)
INVALID_USER_ERROR_ID = error(
    21171,
    known_as=(900460,),
    en="{value} is not a valid ID of #ERROR: IDs are whole numbers from 1 to 1000",
    de="{value} ist keine gültige ID von #ERROR: IDs sind ganze Zahlen von 1 bis 1000",
    remedy_en="Give #ERROR an ID from 1 to 1000.",
    remedy_de="#ERROR eine ID von 1 bis 1000 geben.",
    classes=(6, 6),
)
INVALID_USER_ERROR_RC = error(
    21173,
    known_as=(900461,),
    en="{value} is not a valid RC of #ERROR: 0 warns, 1 to 6 stop until a reset, 7 until a restart",
    de="{value} ist kein gültiger RC von #ERROR: 0 warnt, 1 bis 6 halten bis zum Reset an, 7 bis "
    "zum Neustart",
    remedy_en="Give #ERROR a whole RC from 0 to 7.",
    remedy_de="#ERROR einen ganzzahligen RC von 0 bis 7 geben.",
    classes=(6, 6),
)
INVALID_USER_ERROR_MID = error(
    900462,
    en="{value} is not a valid MID of #ERROR: it distinguishes errors with one ID, a whole number "
    "above 0",
    de="{value} ist keine gültige MID von #ERROR: sie unterscheidet Fehler einer ID, ganzzahlig "
    "und über 0",
    remedy_en="Give #ERROR a MID of at least 1, or none.",
    remedy_de="#ERROR eine MID ab 1 geben oder keine.",
)
USER_WARNING = warning(
    900463,
    en="user warning {said} ({values})",
    de="Anwenderwarnung {said} ({values})",
    remedy_en="The program has raised it with #ERROR and RC=0; the program continues.",
    remedy_de="Das Programm hat sie mit #ERROR und RC=0 gemeldet; es läuft weiter.",
    said=(
        "the number of the user error, with its text if there is one",
        "die Nummer des Anwenderfehlers, mit seinem Text, falls vorhanden",
    ),
    values=("the values given by the program", "die vom Programm angegebenen Werte"),
    classes=(1, 1),
)
USER_ERROR = error(
    900464,
    en="user error {said} ({values})",
    de="Anwenderfehler {said} ({values})",
    remedy_en="The program has raised it with #ERROR; a reset clears it.",
    remedy_de="Das Programm hat ihn mit #ERROR gemeldet; ein Reset löscht ihn.",
    said=(
        "the number of the user error, with its text if there is one",
        "die Nummer des Anwenderfehlers, mit seinem Text, falls vorhanden",
    ),
    values=("the values given by the program", "die vom Programm angegebenen Werte"),
    classes=(6, 3),
)
FATAL_USER_ERROR = error(
    900465,
    en="fatal user error {said} ({values})",
    de="fataler Anwenderfehler {said} ({values})",
    remedy_en="The program has raised it with #ERROR and RC=7; only a restart of the controller "
    "clears it.",
    remedy_de="Das Programm hat ihn mit #ERROR und RC=7 gemeldet; nur ein Neustart der Steuerung "
    "löscht ihn.",
    said=(
        "the number of the user error, with its text if there is one",
        "die Nummer des Anwenderfehlers, mit seinem Text, falls vorhanden",
    ),
    values=("the values given by the program", "die vom Programm angegebenen Werte"),
    classes=(6, 7),
)
STOPPED_BY_FATAL_USER_ERROR = error(
    900466,
    en="no program can be started: a fatal user error (#ERROR with RC=7) has stopped the channel",
    de="es kann kein Programm starten: ein fataler Anwenderfehler (#ERROR mit RC=7) hat den Kanal "
    "angehalten",
    remedy_en="Restart the controller: a reset does not clear this error.",
    remedy_de="Die Steuerung neu starten: ein Reset löscht diesen Fehler nicht.",
)
