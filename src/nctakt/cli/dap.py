# SPDX-License-Identifier: MIT
"""``nctakt dap``: the debugger of editors, over the Debug Adapter Protocol.

In: requests of an editor, on standard input or at a port of this computer. Out: answers and events.
"""

from __future__ import annotations

import contextlib
from typing import Any

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, locale_language, option
from nctakt.cli.common.options import TRUST_OPTION, table_option
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.run.options import BY_NAME


@described(
    "dap",
    summary=Text("Debug programs from an editor.", "Programme aus einem Editor debuggen."),
    text=Text(
        "Debug programs from an editor: breakpoints in blocks and cycles, steps back in time.",
        "Programme aus einem Editor debuggen: Haltepunkte in Sätzen und Zyklen, Schritte zurück in "
        "der Zeit.",
    ),
    codes=(Text("ended, or the client has gone", "beendet, oder der Client ist gegangen"), None),
    notes=Text(
        "Editors start it themselves; docs/debugger.md has the configurations of VS Code and "
        "Neovim. Without --port it speaks over standard input and output. A client at the port "
        "gives the token that is printed, and kept in a file of this user; with --confine a launch "
        "needs none. Ctrl-C and SIGTERM end it.",
        "Editoren starten es selbst; docs/debugger.md enthält die Konfigurationen von VS Code und "
        "Neovim. Ohne --port spricht es über Standardein- und -ausgabe. Ein Client am Port gibt "
        "das Token an, das ausgegeben wird und in einer Datei dieses Benutzers liegt; mit "
        "--confine braucht ein Start keines. Strg-C und SIGTERM beenden es.",
    ),
    examples=("nctakt dap", "nctakt dap --port 4711"),
)
@option(
    "--port",
    type=click.IntRange(0, 65535),
    metavar="N",
    text=Text(
        "Serve editors at this port of this computer, 0: a free one, which is printed.",
        "Editoren an diesem Port dieses Rechners bedienen, 0: ein freier, der ausgegeben wird.",
    ),
)
@table_option(BY_NAME["confine"])
@TRUST_OPTION
@table_option(BY_NAME["language"])
def command(port: int | None, confined: tuple[str, ...], **words: Any) -> int:
    """Debug programs."""
    from nctakt.debugger.server import PortServer, serve_pipe  # noqa: PLC0415 - seldom needed

    language: Language = words["language"] or locale_language()
    if port is None:
        with contextlib.suppress(KeyboardInterrupt):  # as below
            serve_pipe(folders=confined, language=language)
        return EXIT_RAN
    try:
        server = PortServer(port, folders=confined, language=language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE
    try:
        for line in server.endpoint.lines():
            click.echo(line)
        if server.endpoint.warning is not None:
            print_diagnostics([server.endpoint.warning], language)
        with contextlib.suppress(KeyboardInterrupt):  # the way to end it
            server.serve()
    finally:
        server.close()
    return EXIT_RAN
