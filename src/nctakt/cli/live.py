# SPDX-License-Identifier: MIT
"""``nctakt live``: a session on a page in the browser.

In: programs, machine, PLC, address. Out: the address of the page (standard output), diagnostics
(standard error). It ends at Ctrl-C and SIGTERM.
"""

from __future__ import annotations

import contextlib
import threading
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN
from nctakt.cli.file_options import CONFINE_OPTION
from nctakt.cli.language import language_option
from nctakt.cli.request import STANDARD_INPUT, Options, Request, read_request
from nctakt.cli.running import choose_mode
from nctakt.cli.settings import carry_out
from nctakt.cli.start_options import FROM_BLOCK_OPTION, FROM_LINE_OPTION, TRUST_OPTION
from nctakt.cli.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.live import PAGE_HAS_REFUSED, PAGE_NEEDS_FILES

if TYPE_CHECKING:
    from nctakt.debugger.server import PortServer
    from nctakt.live.document import Document
    from nctakt.live.shared import SharedSession
    from nctakt.session.session import Session

#: The machine time after which a run on the page ends where the project has no limit.
_LONGEST = "24 h"

_EPILOG = """\b
The page is for this computer alone, unless --host names another address; then
its own address holds a token, which is printed once.
Exit codes: 0 ended by Ctrl-C or SIGTERM, 2 wrong usage or unusable input, 3 an error of
nctakt's own.

\b
  nctakt live part.nc --open
  nctakt live part.nc --machine lists --plc cell.py --lang de
  nctakt live part.nc --host 0.0.0.0 --port 9000
"""


@click.command("live", epilog=_EPILOG, short_help="Show a run on a page in the browser.")
@click.argument("programs", metavar="PROGRAM...", nargs=-1)
@click.option(
    "--channel",
    "others",
    metavar="N PROGRAM",
    nargs=2,
    multiple=True,
    help="Run a program in channel N at the same time; may be repeated.",
)
@click.option(
    "--machine",
    metavar="DIR",
    help="Folder with the machine's lists, demo or demo5 [default: the project's, else the one "
    "around the program, else demo].",
)
@click.option("--plc", metavar="FILE.py", help="A class of yours that plays the PLC.")
@TRUST_OPTION
@click.option(
    "--set",
    "assignments",
    metavar="NAME=VALUE",
    multiple=True,
    help="Set a variable before the first tick.",
)
@click.option(
    "--at",
    "stimuli",
    metavar="TIME NAME=VALUE",
    nargs=2,
    multiple=True,
    help="Set a variable at a time of the run.",
)
@FROM_LINE_OPTION
@FROM_BLOCK_OPTION
@click.option(
    "--wait-for-start", is_flag=True, help="START on the page begins each program (HLI.START)."
)
@click.option(
    "--acknowledge", is_flag=True, help="M and H functions wait for you to acknowledge them."
)
@click.option(
    "--pace",
    type=click.Choice(["slice", "tick"]),
    default="slice",
    help="On the wall clock: 10 ms of ticks together, or each at its own time [default: slice].",
)
@click.option(
    "--record", "tape", metavar="FILE", help="Record the inputs of the last run for nctakt replay."
)
@click.option("--host", default="127.0.0.1", metavar="ADDRESS", help="Address of the page.")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8765,
    metavar="N",
    help="Port of the page, 0: a free one [default: 8765].",
)
@click.option(
    "--dap",
    "debug_port",
    type=click.IntRange(0, 65535),
    metavar="N",
    help="Let debuggers attach at this port of this computer, 0: a free one, which is printed.",
)
@click.option(
    "--embed", "is_embedded", is_flag=True, help="Let an editor show the page in one of its panels."
)
@click.option("--open", "opens_browser", is_flag=True, help="Open the page in the browser.")
@CONFINE_OPTION
@language_option("Language of the page and of diagnostics [default: en].", None)
@click.option("--quiet", is_flag=True, help="No notes and no warnings.")
@click.option(
    "--compiled/--plain",
    default=None,
    help="The realtime part compiled or as plain Python [default: compiled if it is built].",
)
def command(
    host: str,
    port: int,
    debug_port: int | None,
    is_embedded: bool,
    opens_browser: bool,
    acknowledge: bool,
    pace: str,
    tape: str | None,
    **words: Any,
) -> int:
    """Show a run on a page in the browser: play, pause, step, go back, edit, set variables."""
    shown = is_embedded, opens_browser
    own = _Words((host, port), debug_port, *shown, acknowledge, pace, tape)

    def show(options: Options, access: FileAccess) -> int:
        return _show(options, access, own)

    given = {**words, "ticks": None, "until": None, "after": "0"}
    return carry_out(given, show)


@dataclass(frozen=True, slots=True)
class _Words:
    """The words that only this command has."""

    address: tuple[str, int]
    debug_port: int | None
    is_embedded: bool
    opens_browser: bool
    acknowledge: bool
    pace: str
    tape: str | None


def _show(options: Options, access: FileAccess, own: _Words) -> int:
    """Open the session and serve the page; raises ``Failure`` for what cannot be used."""
    from nctakt.live.server import check_library, serve, usable_port  # noqa: PLC0415 - seldom

    check_library()
    if STANDARD_INPUT in (*options.programs, *(program for _, program in options.others)):
        raise Failure(diagnostic(PAGE_NEEDS_FILES))
    choose_mode(options)
    from nctakt.live.document import Checker, Document  # noqa: PLC0415 - the mode is chosen before
    from nctakt.live.shared import SharedSession  # noqa: PLC0415 - as above
    from nctakt.live.texts import Texts  # noqa: PLC0415

    request = read_request(options, access)
    if options.machine_note is not None and not options.quiet:
        print_diagnostics([options.machine_note], options.language)
    host, port = own.address[0], usable_port(*own.address)
    if own.tape is not None:
        with OutputFile(own.tape, "--record", access):
            pass  # it is none of the inputs, and can be written
    folders = options.confined or _folders_of(options)
    checker = Checker(options.machine, folders)
    documents = {
        number: [Document(str(program), checker) for program in programs]
        for number, programs in {1: request.programs, **request.channels}.items()
        if programs
    }

    refused: Counter[Text] = Counter()
    channel = next(iter(documents))
    file = documents[channel][0].file
    open_session = _session_opener(options, request, own, documents, folders)
    shared = SharedSession(open_session, file, acknowledges=not own.acknowledge, channel=channel)
    with contextlib.ExitStack() as ends:
        ends.callback(shared.close)
        if own.debug_port is not None:
            ends.callback(_let_attach(shared, own.debug_port, options).close)
        with contextlib.suppress(KeyboardInterrupt):  # the way to end it
            serve(
                shared,
                documents,
                Texts(options.language),
                (host, port),
                has_plc=options.plc is not None,
                opens_browser=own.opens_browser,
                is_embedded=own.is_embedded,
                tell=click.echo,
                tell_error=lambda found: print_diagnostics([found], options.language),
                refused=lambda _, reason: refused.update([reason]),
            )
        if refused and not options.quiet:
            print_diagnostics([_refusals(refused, options.language)], options.language)
        if own.tape is not None:
            shared.session.save(own.tape)
    return EXIT_RAN


def _session_opener(
    options: Options,
    request: Request,
    own: _Words,
    documents: Mapping[int, Sequence[Document]],
    folders: Sequence[str],
) -> Callable[[str | None, bool], Session]:
    """Return what opens a session of the documents as they are.

    It is called with the program of channel 1, ``None`` for all, and whether the PLC acknowledges
    by itself.
    """
    from nctakt.run.program_loader import NcText  # noqa: PLC0415 - the mode is chosen before
    from nctakt.session.session import Session  # noqa: PLC0415 - as above

    def open_session(program: str | None, acknowledges: bool) -> Session:
        texts = {
            number: [
                NcText(document.file, document.text)
                for document in opened
                if number > 1 or program in (None, document.file)
            ]
            for number, opened in documents.items()
        }
        return Session(
            channels=texts,
            machine=options.machine,
            plc=options.plc,
            set=request.assignments,
            at=request.stimuli,
            until=request.until or _LONGEST,
            wait_for_start=options.wait_for_start,
            acknowledges=acknowledges,
            folders=folders,
            pace=own.pace,
            from_line=options.from_line,
            from_block=options.from_block,
        )

    return open_session


def _refusals(refused: Counter[Text], language: Language) -> Diagnostic:
    """Return the note of how many requests were refused, by their reasons."""
    words = (f"{count} × {reason.get(language)}" for reason, count in refused.items())
    return diagnostic(PAGE_HAS_REFUSED, count=refused.total(), reasons=", ".join(words))


def _let_attach(shared: SharedSession, port: int, options: Options) -> PortServer:
    """Let debuggers attach to the page's session; raises ``Failure`` if the port is taken."""
    from nctakt.debugger.server import PortServer  # noqa: PLC0415 - seldom needed

    server = PortServer(
        port, folders=options.confined, language=options.language, session=lambda: shared.session
    )
    threading.Thread(target=server.serve, name="nctakt dap", daemon=True).start()
    for line in server.door.lines():
        click.echo(f"dap {line}")
    if server.door.warning is not None:
        print_diagnostics([server.door.warning], options.language)
    return server


def _folders_of(options: Options) -> tuple[str, ...]:
    """Return the folders whose files the page may read: of the programs and of the machine."""
    programs = (*options.programs, *(program for _, program in options.others))
    folders = {str(Path(program).parent): None for program in programs}
    if options.machine is not None:
        machine = Path(machine_folder(options.machine))
        folders[str(machine if machine.is_dir() else machine.parent)] = None
    return tuple(folders)
