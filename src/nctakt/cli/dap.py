# SPDX-License-Identifier: MIT
"""``nctakt dap``: the debugger of editors, over the Debug Adapter Protocol.

In: requests of an editor, on standard input or at a port of this computer. Out: answers and events.
"""

from __future__ import annotations

import contextlib
from typing import Any

import click

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.file_options import CONFINE_OPTION
from nctakt.cli.language import language_option
from nctakt.cli.start_options import TRUST_OPTION
from nctakt.cli.terminal import print_diagnostics

_EPILOG = """\b
Editors start it themselves; docs/debugger.md has the configurations of VS Code
and Neovim. Without --port it speaks over standard input and output. A client at
the port gives the token that is printed, and kept in a file of this user; with
--confine a launch needs none. Ctrl-C and SIGTERM end it.
Exit codes: 0 ended, or the client has gone, 2 wrong usage or an unusable port, 3 an error
of nctakt's own.

\b
  nctakt dap
  nctakt dap --port 4711
"""


@click.command("dap", epilog=_EPILOG, short_help="Debug programs from an editor.")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    metavar="N",
    help="Serve editors at this port of this computer, 0: a free one, which is printed.",
)
@CONFINE_OPTION
@TRUST_OPTION
@language_option("Language of texts and diagnostics [default: the editor's].", None)
def command(port: int | None, confined: tuple[str, ...], **words: Any) -> int:
    """Debug programs from an editor: breakpoints in blocks and cycles, steps back in time."""
    from nctakt.debugger.server import PortServer, serve_pipe  # noqa: PLC0415 - seldom needed

    language: Language = words["language"] or "en"
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
        for line in server.door.lines():
            click.echo(line)
        if server.door.warning is not None:
            print_diagnostics([server.door.warning], language)
        with contextlib.suppress(KeyboardInterrupt):  # the way to end it
            server.serve()
    finally:
        server.close()
    return EXIT_RAN
