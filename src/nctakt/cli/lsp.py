# SPDX-License-Identifier: MIT
"""``nctakt lsp``: the language server for editors, over standard streams or TCP.

In: the messages of an editor. Out: answers and findings. It ends with the editor, or at Ctrl-C and
SIGTERM.
"""

from __future__ import annotations

import gc

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import language_option
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.messages import diagnostic
from nctakt.messages.connections.editor import EDITOR_LIBRARY_MISSING


@described(
    "lsp",
    summary=Text("Serve an editor (language server).", "Einen Editor bedienen (Sprachserver)."),
    text=Text(
        "Check, explain, complete and format programs and lists in an editor.",
        "Programme und Listen in einem Editor prüfen, erklären, ergänzen und formatieren.",
    ),
    codes=(Text("ended", "beendet"), None),
    notes=Text(
        "Editors start it by themselves and speak with it over its standard streams; "
        "docs/editor-setup.md has the few lines that each needs. --tcp waits for one editor at an "
        "address instead, which gives the token that is printed, and kept in a file of this user. "
        "Ctrl-C and SIGTERM end it.",
        "Editoren starten es selbst und sprechen über seine Standardströme mit ihm; "
        "docs/editor-setup.md enthält die wenigen Zeilen, die jeder braucht. --tcp wartet "
        "stattdessen an einer Adresse auf einen Editor, der das Token angibt, das ausgegeben "
        "wird und in einer Datei dieses Benutzers liegt. Strg-C und SIGTERM beenden es.",
    ),
    examples=("nctakt lsp", "nctakt lsp --tcp 2087 --lang de"),
)
@option(
    "--stdio",
    is_flag=True,
    text=Text(
        "Speak over the standard streams [default].", "Über die Standardströme sprechen [Vorgabe]."
    ),
)
@option(
    "--tcp",
    "port",
    type=click.IntRange(0, 65535),
    metavar="PORT",
    text=Text(
        "Wait for an editor at this port, 0: a free one, which is printed.",
        "An diesem Port auf einen Editor warten, 0: ein freier, der ausgegeben wird.",
    ),
)
@option(
    "--host",
    default="127.0.0.1",
    metavar="ADDRESS",
    text=Text("Address of the port.", "Adresse des Ports."),
)
@language_option()
def command(stdio: bool, port: int | None, host: str, language: Language) -> int:
    """Serve an editor."""
    gc.disable()  # imported modules stay
    try:
        try:
            import pygls  # noqa: F401, PLC0415 - only this command needs it
        except ImportError as error:
            raise Failure(diagnostic(EDITOR_LIBRARY_MISSING)) from error
        from nctakt.editor import entrance  # noqa: PLC0415 - as above
        from nctakt.editor.display import presentation  # noqa: PLC0415 - as above
        from nctakt.editor.server import Server  # noqa: PLC0415

        server = Server(language)
        presentation.register(server)
        gc.freeze()
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE
    finally:
        gc.enable()
    if port is None or stdio:
        entrance.serve_streams(server)
        return EXIT_RAN
    try:
        entrance.serve_port(
            server, host, port, click.echo, lambda found: print_diagnostics([found], language)
        )
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE
    return EXIT_RAN
