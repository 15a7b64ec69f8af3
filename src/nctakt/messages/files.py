# SPDX-License-Identifier: MIT
"""Messages about files that are read and written."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

FILE_MISSING = error(
    900500,
    en="{file} does not exist",
    de="{file} gibt es nicht",
    remedy_en="Check the path; it is relative to the folder in which nctakt is run.",
    remedy_de="Den Pfad prüfen; er gilt relativ zum Ordner, in dem nctakt läuft.",
)
MISSPELT_FILE = error(
    902941,
    en="{file} does not exist",
    de="{file} gibt es nicht",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
FOLDER_INSTEAD_OF_FILE = error(
    900501,
    en="{file} is a folder; a file is needed here",
    de="{file} ist ein Ordner; hier wird eine Datei gebraucht",
    remedy_en="Name a file in the folder.",
    remedy_de="Eine Datei aus dem Ordner nennen.",
)
NOT_A_REGULAR_FILE = error(
    901483,
    en="{file} is not a regular file but a pipe, a socket or a device",
    de="{file} ist keine reguläre Datei, sondern eine Pipe, ein Socket oder ein Gerät",
    remedy_en="Name a regular file: reading anything else may never end.",
    remedy_de="Eine reguläre Datei nennen: Anderes zu lesen endet vielleicht nie.",
)
NEITHER_FOLDER_NOR_LIST = error(
    900502,
    en="{folder} is neither a folder nor a list",
    de="{folder} ist weder ein Ordner noch eine Liste",
    remedy_en="Name the folder that holds the machine's lists, or its start-up list.",
    remedy_de="Den Ordner mit den Listen der Maschine nennen, oder ihre Hochlaufliste.",
)
FILE_NOT_READABLE = error(
    900503,
    en="{file} cannot be read: {reason}",
    de="{file} kann nicht gelesen werden: {reason}",
    remedy_en="Check the access rights of the file, and whether it is complete.",
    remedy_de="Die Zugriffsrechte der Datei prüfen, und ob sie vollständig ist.",
)
STDIN_NAMED_TWICE = error(
    900504,
    en="standard input ('-') is named more than once",
    de="die Standardeingabe ('-') ist mehrfach angegeben",
    remedy_en="Name '-' once; further programs need files.",
    remedy_de="'-' einmal nennen; weitere Programme brauchen Dateien.",
)
TEXT_CHANGED = error(
    901900,
    en="{file} has been changed while it was in use",
    de="{file} wurde geändert, während es in Gebrauch war",
    remedy_en="Start again; do not change a program in use, or save it under another name.",
    remedy_de="Neu beginnen; ein Programm in Gebrauch nicht ändern oder unter anderem Namen "
    "speichern.",
    cause_en="A program of more than 1 MB is not kept in memory: its lines are read when they are "
    "due.",
    cause_de="Ein Programm von mehr als 1 MB steht nicht im Speicher: seine Zeilen werden gelesen, "
    "wenn sie an der Reihe sind.",
)
UNKNOWN_TRACE_FORMAT = error(
    900506,
    en="{file}: the suffix is not a known trace format",
    de="{file}: die Endung nennt kein bekanntes Format für Aufzeichnungen",
    remedy_en="Use one of these suffixes: {suffixes}.",
    remedy_de="Eine dieser Endungen verwenden: {suffixes}.",
    suffixes=("the known suffixes", "die bekannten Endungen"),
)
FILE_NOT_WRITABLE = error(
    900507,
    en="{file} cannot be written: {reason}",
    de="{file} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose an existing folder with write permission and free space.",
    remedy_de="Einen vorhandenen Ordner mit Schreibrecht und freiem Platz wählen.",
)
NO_WORKING_DIRECTORY = error(
    902925,
    en="the folder in which nctakt was started does not exist any more",
    de="der Ordner, in dem nctakt gestartet wurde, existiert nicht mehr",
    remedy_en="Change to a folder that exists.",
    remedy_de="In einen vorhandenen Ordner wechseln.",
)
NOT_A_TRACE = error(
    900508,
    en="{file} is not a trace written by nctakt",
    de="{file} ist keine Aufzeichnung von nctakt",
    remedy_en="Name a file written by nctakt run --trace.",
    remedy_de="Eine Datei nennen, die nctakt run --trace geschrieben hat.",
)
OUTPUT_IS_READ = error(
    900913,
    en="{option} would overwrite {file}, which is an input",
    de="{option} würde {file} überschreiben, das eine Eingabe ist",
    remedy_en="Choose another name for the output.",
    remedy_de="Für die Ausgabe einen anderen Namen wählen.",
    cause_en="Links and other spellings of the path lead to the same file.",
    cause_de="Verknüpfungen und andere Schreibweisen des Pfads führen zur selben Datei.",
    option=("the option that names the output", "die Option, die die Ausgabe nennt"),
)
OUTPUTS_ARE_ONE_FILE = error(
    900914,
    en="{option} and {other} would write to the same file, {file}",
    de="{option} und {other} würden in dieselbe Datei schreiben: {file}",
    remedy_en="Choose a separate file for each of them.",
    remedy_de="Für jede eine eigene Datei wählen.",
    option=("the option that names the output", "die Option, die die Ausgabe nennt"),
    other=("the other output", "die andere Ausgabe"),
)
FILE_TOO_LONG = error(
    900915,
    en="{file} is too large to be read at once: more than {limit} bytes",
    de="{file} ist zu groß, um auf einmal gelesen zu werden: mehr als {limit} Byte",
    remedy_en="Name a text file; a long program can be read if it is a regular file with lines.",
    remedy_de="Eine Textdatei angeben; ein langes Programm ist lesbar, wenn es eine gewöhnliche "
    "Datei mit Zeilen ist.",
    cause_en="Lists, pipes, devices and lines that belong together are read at once.",
    cause_de="Listen, Pipes, Geräte und zusammengehörige Zeilen werden auf einmal gelesen.",
    limit=("the limit in bytes", "die Grenze in Byte"),
)
FILE_OUTSIDE = error(
    900917,
    en="{file} is not read: it is outside {folders}",
    de="{file} wird nicht gelesen: es liegt außerhalb von {folders}",
    remedy_en="Only files in these folders may be read (--confine); move the file there.",
    remedy_de="Nur Dateien in diesen Ordnern dürfen gelesen werden (--confine); die Datei dorthin "
    "verschieben.",
    folders=("the folders that may be read", "die Ordner, die gelesen werden dürfen"),
)
OUTPUT_CUT_OFF = note(
    900918,
    en="{file} contains the part written until then",
    de="{file} enthält, was bis dahin geschrieben wurde",
    remedy_en="The file can be read up to its last complete line.",
    remedy_de="Die Datei ist bis zur letzten vollständigen Zeile lesbar.",
)
OUTPUT_IN_USE = error(
    900919,
    en="{file} is being written by another run",
    de="{file} wird gerade von einem anderen Lauf geschrieben",
    remedy_en="Wait until it ends, or choose another name.",
    remedy_de="Dessen Ende abwarten oder einen anderen Namen wählen.",
)
FOLDER_INSTEAD_OF_PROGRAM = error(
    901015,
    en="{folder} is a folder; a program is a file",
    de="{folder} ist ein Ordner; ein Programm ist eine Datei",
    remedy_en="To run a program on the machine of a folder: nctakt run part.nc --machine {folder}",
    remedy_de="Ein Programm auf der Maschine eines Ordners ausführen: nctakt run part.nc "
    "--machine {folder}",
    cause_en="A machine folder holds the lists of a machine (nctakt new writes one); programs run "
    "on that machine.",
    cause_de="Ein Maschinenordner enthält die Listen einer Maschine (nctakt new schreibt einen); "
    "Programme laufen auf dieser Maschine.",
)
BYTE_ORDER_MARK = warning(
    21798,
    en="the file begins with a byte order mark: the controller expects plain text",
    de="die Datei beginnt mit einer Byte-Reihenfolge-Marke: die Steuerung erwartet reinen Text",
    remedy_en="Save the program as ASCII, or as UTF-8 without the mark.",
    remedy_de="Das Programm als ASCII oder als UTF-8 ohne die Marke speichern.",
    cause_en="nctakt reads the file anyway.",
    cause_de="nctakt liest die Datei trotzdem.",
)
