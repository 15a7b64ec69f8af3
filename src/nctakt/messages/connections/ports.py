# SPDX-License-Identifier: MIT
"""Messages about the ports of debuggers and editors: addresses and tokens."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

PORT_NOT_USABLE = error(
    901920,
    en="nctakt cannot listen at {host}, port {port}: {reason}",
    de="nctakt kann nicht an {host}, Port {port} lauschen: {reason}",
    remedy_en="End the program that uses the port, or name another one: 0 takes a free one.",
    remedy_de="Das Programm am Port beenden oder einen anderen nennen: 0 nimmt einen freien.",
    host=("the address", "die Adresse"),
    port=("the port", "der Port"),
    reason=("the system's reason", "der Grund des Systems"),
)
TOKEN_NEEDED = error(
    901921,
    en="{request} at a port needs the token of the command that listens there",
    de="{request} an einem Port braucht das Token des Kommandos, das dort lauscht",
    remedy_en="Give what the command has printed: docs/debugger-setup.md, docs/editor-setup.md.",
    remedy_de="Angeben, was das Kommando zeigt: docs/debugger-setup.md, docs/editor-setup.md.",
    request=("the request", "die Anfrage"),
)
WRONG_TOKEN = error(
    901922,
    en="the token is not the one of the command that listens here",
    de="das Token ist nicht das des Kommandos, das hier lauscht",
    remedy_en="Take the one that was printed: each start of the command has another one.",
    remedy_de="Das angezeigte nehmen: Jeder Start des Kommandos hat ein anderes.",
)
PORT_IS_FULL = error(
    901923,
    en="this port serves at most {limit} clients, half of them without a token",
    de="dieser Port bedient höchstens {limit} Clients, die Hälfte davon ohne Token",
    remedy_en="End a client, or start the command again at another port.",
    remedy_de="Einen Client beenden oder das Kommando an einem anderen Port noch einmal starten.",
    limit=("the limit", "die Grenze"),
)
TOKEN_NOT_WRITTEN = warning(
    901924,
    en="the token is in no file: {reason}",
    de="das Token steht in keiner Datei: {reason}",
    remedy_en="Give clients the one that is printed.",
    remedy_de="Den Clients das angezeigte geben.",
    reason=("the system's reason", "der Grund des Systems"),
)
