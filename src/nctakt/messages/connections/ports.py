# SPDX-License-Identifier: MIT
"""Messages about the ports of debuggers and editors: addresses and tokens."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

PORT_NOT_USABLE = error(
    901920,
    en="nctakt cannot listen on {host}, port {port}: {reason}",
    de="nctakt kann nicht an {host}, Port {port} lauschen: {reason}",
    remedy_en="End the program that uses the port, or name another port: 0 takes a free one.",
    remedy_de="Das Programm am Port beenden oder einen anderen nennen: 0 nimmt einen freien.",
    host=("the address", "die Adresse"),
    port=("the port", "der Port"),
    reason=("the system's reason", "der Grund des Systems"),
)
TOKEN_NEEDED = error(
    901921,
    en="{request} on a port needs the token of the command that listens there",
    de="{request} an einem Port braucht das Token des Befehls, der dort lauscht",
    remedy_en="Give the token that the command has printed: docs/debugger-setup.md, "
    "docs/editor-setup.md.",
    remedy_de="Das Token angeben, das der Befehl ausgibt: docs/debugger-setup.md, "
    "docs/editor-setup.md.",
    request=("the request", "die Anfrage"),
)
WRONG_TOKEN = error(
    901922,
    en="this is not the token of the command that listens here",
    de="das ist nicht das Token des Befehls, der hier lauscht",
    remedy_en="Use the token that was printed: each start of the command makes a new one.",
    remedy_de="Das ausgegebene Token verwenden: jeder Start des Befehls erzeugt ein neues.",
)
PORT_IS_FULL = error(
    901923,
    en="this port serves at most {limit} clients, half of them without a token",
    de="dieser Port bedient höchstens {limit} Clients, die Hälfte davon ohne Token",
    remedy_en="End a client, or start the command again on another port.",
    remedy_de="Einen Client beenden oder den Befehl an einem anderen Port noch einmal starten.",
    limit=("the limit", "die Grenze"),
)
TOKEN_NOT_WRITTEN = warning(
    901924,
    en="the token could not be written to a file: {reason}",
    de="das Token ließ sich nicht in eine Datei schreiben: {reason}",
    remedy_en="Give clients the token that is printed.",
    remedy_de="Den Clients das ausgegebene Token geben.",
    reason=("the system's reason", "der Grund des Systems"),
)
