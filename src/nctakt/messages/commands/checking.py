# SPDX-License-Identifier: MIT
"""Messages about the inputs of ``nctakt check``."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

NOTHING_TO_CHECK = warning(
    900580,
    en="{folder} contains nothing that can be checked",
    de="{folder} enthält nichts, was geprüft werden kann",
    remedy_en="Programs in folders end with {suffixes}, lists with .lis; name other files "
    "individually.",
    remedy_de="Programme in Ordnern enden mit {suffixes}, Listen mit .lis; andere Dateien einzeln "
    "nennen.",
    suffixes=("the suffixes of programs", "die Endungen von Programmen"),
)
NOTHING_NAMED_TO_CHECK = error(
    901066,
    en="no file or folder was named, and no project file says what to check",
    de="es wurde weder eine Datei noch ein Ordner angegeben, und keine Projektdatei sagt, was zu "
    "prüfen ist",
    remedy_en='Name them (nctakt check .), or write paths = ["programs"] in nctakt.toml.',
    remedy_de='Sie angeben (nctakt check .) oder paths = ["programme"] in nctakt.toml schreiben.',
)
NOTES_OF_LISTS = note(
    902936,
    en="notes about the lists of the machine: {count}",
    de="Hinweise zu den Listen der Maschine: {count}",
    remedy_en="nctakt check {folder} shows them.",
    remedy_de="nctakt check {folder} zeigt sie.",
    count=("the number of these notes", "die Anzahl dieser Hinweise"),
)
NOT_A_TEXT_FILE = error(
    900581,
    en="{file} is not a text file",
    de="{file} ist keine Textdatei",
    remedy_en="Name NC programs and ASCII lists.",
    remedy_de="NC-Programme und ASCII-Listen nennen.",
)
FILE_ENCRYPTED = note(
    900582,
    known_as=(21686,),
    en="{file} is encrypted and cannot be checked",
    de="{file} ist verschlüsselt und kann nicht geprüft werden",
    remedy_en="Check the program from which it was made.",
    remedy_de="Das Programm prüfen, aus dem die Datei entstanden ist.",
)
LIST_CHECKED_ALONE = note(
    900583,
    en="this list is checked alone, as {kind}",
    de="diese Liste wird für sich geprüft, als {kind}",
    remedy_en="Check the machine folder to check how several lists fit together.",
    remedy_de="Den Maschinenordner prüfen, um das Zusammenspiel mehrerer Listen zu prüfen.",
    kind=("the kind of list", "die Art der Liste"),
)
LIST_KIND_NOT_RECOGNISED = note(
    900584,
    en="no known kind of list has such entries; the list is not checked",
    de="keine bekannte Art von Liste hat solche Einträge; die Liste wird nicht geprüft",
    remedy_en="Known kinds: {kinds}",
    remedy_de="Bekannte Arten: {kinds}",
    kinds=("the kinds of lists", "die Arten von Listen"),
)
CHECKED_FOR_DEMO_MACHINE = note(
    900585,
    en="programs are checked for the demo machine",
    de="Programme werden für die Demo-Maschine geprüft",
    remedy_en="--machine {folder} checks them for yours.",
    remedy_de="--machine {folder} prüft sie für die eigene.",
    folder=("a machine folder", "ein Maschinenordner"),
)
NO_MESSAGE_SELECTED = error(
    900586,
    en="'{text}' selects no message",
    de="'{text}' wählt keine Meldung aus",
    remedy_en="Write numbers (22009), prefixes (9002) or ranges (22000-22099), separated by "
    "commas.",
    remedy_de="Nummern (22009), Nummernanfänge (9002) oder Bereiche (22000-22099) durch Kommas "
    "getrennt angeben.",
    text=("the word as it was given", "das Wort, wie angegeben"),
)
CHECKED_FOR_MACHINE_OF_FILE = note(
    900815,
    en="programs are checked for the machine of {file}",
    de="Programme werden für die Maschine von {file} geprüft",
    remedy_en="--machine FOLDER checks them for another machine.",
    remedy_de="--machine ORDNER prüft sie für eine andere.",
    file=(
        "the start-up list that lies in their folder, or above it",
        "die Hochlaufliste in ihrem Ordner oder darüber",
    ),
)
SUPPRESSION_UNUSED = warning(
    901182,
    en="this comment suppresses nothing: line {line} has no finding {number}",
    de="dieser Kommentar unterdrückt nichts: Zeile {line} hat keinen Befund {number}",
    remedy_en="Remove the number, or write the comment in the line of the finding.",
    remedy_de="Die Nummer entfernen oder den Kommentar in die Zeile des Befunds schreiben.",
    number=("the number in the comment", "die Nummer im Kommentar"),
    line=("the line that the comment applies to", "die Zeile, für die der Kommentar gilt"),
)
SUPPRESSION_WITHOUT_REASON = warning(
    901183,
    en="this comment suppresses {number} without a reason",
    de="dieser Kommentar unterdrückt {number} ohne Begründung",
    remedy_en="Write the reason after the number: ; nctakt: ignore {number} the PLC waits.",
    remedy_de="Den Grund hinter die Nummer schreiben: ; nctakt: ignore {number} die SPS wartet.",
    number=("the number in the comment", "die Nummer im Kommentar"),
)
SUPPRESSED_ERROR = warning(
    901184,
    en="{number} is an error here; comments suppress only warnings and notes",
    de="{number} ist hier ein Fehler; Kommentare unterdrücken nur Warnungen und Hinweise",
    remedy_en="Correct the program: with an error it cannot run.",
    remedy_de="Das Programm berichtigen: mit einem Fehler kann es nicht laufen.",
    number=("the number in the comment", "die Nummer im Kommentar"),
)
INVALID_SUPPRESSION = warning(
    901185,
    en="'{text}' is not an instruction that nctakt knows in comments",
    de="'{text}' ist keine Anweisung, die nctakt in Kommentaren kennt",
    remedy_en="Write ; nctakt: ignore NUMBER REASON with the number of a message, such as 900243.",
    remedy_de="; nctakt: ignore NUMMER GRUND mit der Nummer einer Meldung schreiben, etwa 900243.",
    text=("the text of the comment", "der Text des Kommentars"),
)
