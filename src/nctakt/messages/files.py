# SPDX-License-Identifier: MIT
"""Messages about files that are read and written."""

from __future__ import annotations

from nctakt.messages.catalogue import error

FILE_MISSING = error(
    900500,
    en="{file} does not exist",
    de="{file} gibt es nicht",
    remedy_en="Check the path; it is relative to the folder in which nctakt runs.",
    remedy_de="Den Pfad prüfen; er gilt ab dem Ordner, in dem nctakt läuft.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
)
FOLDER_INSTEAD_OF_FILE = error(
    900501,
    en="{file} is a folder; a file is needed here",
    de="{file} ist ein Ordner; hier wird eine Datei gebraucht",
    remedy_en="Name a file in the folder.",
    remedy_de="Eine Datei aus dem Ordner nennen.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
)
NEITHER_FOLDER_NOR_LIST = error(
    900502,
    en="{folder} is neither a folder nor a list",
    de="{folder} ist weder ein Ordner noch eine Liste",
    remedy_en="Name the folder that holds the machine's lists, or its start-up list.",
    remedy_de="Den Ordner mit den Listen der Maschine nennen, oder ihre Hochlaufliste.",
    folder=("the path as it was given", "der Pfad, wie angegeben"),
)
FILE_NOT_READABLE = error(
    900503,
    en="{file} cannot be read: {reason}",
    de="{file} kann nicht gelesen werden: {reason}",
    remedy_en="Check the rights of the file, and whether it is complete.",
    remedy_de="Die Rechte der Datei prüfen, und ob sie vollständig ist.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
    reason=("what the system says", "was das System sagt"),
)
STDIN_NAMED_TWICE = error(
    900504,
    en="standard input ('-') is named more than once",
    de="die Standardeingabe ('-') ist mehrfach genannt",
    remedy_en="Name '-' once; further programs need files.",
    remedy_de="'-' einmal nennen; weitere Programme brauchen Dateien.",
)
UNKNOWN_TRACE_FORMAT = error(
    900506,
    en="{file}: the end of the name says no trace format",
    de="{file}: die Endung nennt kein Format für Aufzeichnungen",
    remedy_en="Give the file the suffix {suffixes}.",
    remedy_de="Der Datei eine dieser Endungen geben: {suffixes}.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
    suffixes=("the suffixes that are known", "die bekannten Endungen"),
)
FILE_NOT_WRITABLE = error(
    900507,
    en="{file} cannot be written: {reason}",
    de="{file} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder that exists, with the right to write and room on the disk.",
    remedy_de="Einen vorhandenen Ordner mit Schreibrecht und freiem Platz wählen.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
    reason=("what the system says", "was das System sagt"),
)
NOT_A_TRACE = error(
    900508,
    en="{file} is no trace that nctakt has written",
    de="{file} ist keine Aufzeichnung von nctakt",
    remedy_en="Name a file that nctakt run --trace made.",
    remedy_de="Eine Datei nennen, die nctakt run --trace geschrieben hat.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
)
