# SPDX-License-Identifier: MIT
"""Messages about the live page: its library, its address, its program."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning
from nctakt.messages.extras import install_command

LIVE_LIBRARY_MISSING = error(
    901160,
    en="nctakt live needs the library NiceGUI, which is not installed",
    de="nctakt live braucht die Bibliothek NiceGUI, die nicht installiert ist",
    remedy_en=f"Install it: {install_command('live')}",
    remedy_de=f"Installieren: {install_command('live')}",
)
ADDRESS_NOT_USABLE = error(
    901161,
    en="the page cannot listen on {host}, port {port}: {reason}",
    de="die Seite kann nicht an {host}, Port {port} lauschen: {reason}",
    remedy_en="End the program that uses the port, or name another port: --port 0 takes a free "
    "one.",
    remedy_de="Das Programm am Port beenden oder einen anderen nennen: --port 0 nimmt einen "
    "freien.",
    host=("the address", "die Adresse"),
)
PROGRAM_CHANGED_ON_DISK = error(
    901162,
    en="{file} has changed on disk since the page read it, so it was not saved",
    de="{file} wurde auf der Platte geändert, seit die Seite es gelesen hat; es wurde nicht "
    "gespeichert",
    remedy_en="Copy your changes, then reload the page: it shows the current file.",
    remedy_de="Eigene Änderungen kopieren, dann die Seite neu laden: sie zeigt die jetzige Datei.",
    file=("the program", "das Programm"),
)
PAGE_NEEDS_FILES = error(
    901318,
    en="the page shows and saves programs in files, not one from standard input",
    de="die Seite zeigt und speichert Programme in Dateien, keines von der Standardeingabe",
    remedy_en="Save the program to a file, and name that.",
    remedy_de="Das Programm in einer Datei speichern und diese nennen.",
)
MESSAGE_NOT_READABLE = warning(
    901317,
    en="the page could not handle what a browser sent: {reason}",
    de="die Seite konnte nicht verarbeiten, was ein Browser gesendet hat: {reason}",
    remedy_en="The run continues. If it happens again after a reload, please report it with "
    "NCTAKT_DEBUG=1.",
    remedy_de="Der Lauf geht weiter. Kommt es nach dem Neuladen wieder, bitte mit NCTAKT_DEBUG=1 "
    "melden.",
)
RUN_NOT_SAVED = error(
    902700,
    en="the page cannot save the run as {kind}: {reason}",
    de="die Seite kann den Lauf nicht als {kind} speichern: {reason}",
    remedy_en="Save the tape, and write the file with nctakt replay, which reports more.",
    remedy_de="Das Band speichern und die Datei mit nctakt replay schreiben, das mehr meldet.",
    kind=("the kind of file", "die Art der Datei"),
    reason=("why not", "warum nicht"),
)
SESSION_IS_SHARED = error(
    901475,
    en="the page shares this run with other clients, so it cannot restart it",
    de="die Seite teilt diesen Lauf mit anderen Clients, daher kann sie ihn nicht neu beginnen",
    remedy_en="Save the program; it runs when it is selected again.",
    remedy_de="Das Programm speichern; es läuft, wenn es erneut angewählt wird.",
)
PAGE_HAS_REFUSED = note(
    902040,
    en="the page has refused requests and connections, {count} in all: {reasons}",
    de="die Seite hat Anfragen und Verbindungen abgelehnt, zusammen {count}: {reasons}",
    remedy_en="If they were yours: open the address that was printed, in a separate window.",
    remedy_de="Waren es eigene, die ausgegebene Adresse in einem eigenen Fenster öffnen.",
    count=("how many", "wie viele"),
    reasons=("the reasons, each with how often it came", "die Gründe, je mit ihrer Anzahl"),
)
