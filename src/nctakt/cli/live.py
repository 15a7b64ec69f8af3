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
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN
from nctakt.cli.common.help import described, option
from nctakt.cli.common.log_options import LogWords, log_options, opened_log
from nctakt.cli.common.options import (
    MODE_OPTION,
    PACE_OPTION,
    RETAIN_OPTION,
    TRUST_OPTION,
    table_options,
    take_words,
)
from nctakt.cli.common.request import STANDARD_INPUT, Options, Request, read_request
from nctakt.cli.common.retaining import RetainedSession
from nctakt.cli.common.running import choose_mode, run_programs, shown_from, start_controller
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import LOG_NOT_SHOWN
from nctakt.messages.connections.live import PAGE_HAS_REFUSED, PAGE_NEEDS_FILES

if TYPE_CHECKING:
    from nctakt.comparison.overlay import LoggedCurve
    from nctakt.debugger.server import PortServer
    from nctakt.live.document import Document
    from nctakt.live.shared import SharedSession
    from nctakt.session.session import Session

#: The machine time after which a run on the page ends where the project has no limit.
_LONGEST = "24 h"


@described(
    "live",
    summary=Text(
        "Show a run on a page in the browser.", "Einen Lauf auf einer Seite im Browser zeigen."
    ),
    text=Text(
        "Show a run on a page in the browser: play, pause, step, go back, edit, set variables.",
        "Einen Lauf auf einer Seite im Browser zeigen: abspielen, anhalten, schrittweise gehen, "
        "zurückgehen, ändern, Variablen setzen.",
    ),
    codes=(Text("ended by Ctrl-C or SIGTERM", "beendet durch Strg-C oder SIGTERM"), None),
    notes=Text(
        "The page is for this computer alone, unless --host names another address; then its own "
        "address holds a token, which is printed once.",
        "Die Seite ist nur für diesen Rechner da, außer --host nennt eine andere Adresse; dann "
        "enthält ihre Adresse ein Token, das einmal ausgegeben wird.",
    ),
    examples=(
        "nctakt live part.nc --open",
        "nctakt live part.nc --machine lists --plc cell.py --lang de",
        "nctakt live part.nc --host 0.0.0.0 --port 9000",
        "nctakt live part.nc --log scope.csv --tolerance 0.05",
    ),
)
@table_options("live")
@TRUST_OPTION
@PACE_OPTION
@RETAIN_OPTION
@option(
    "--record",
    "tape",
    metavar="FILE",
    group="files",
    text=Text(
        "Record the inputs of the last run for nctakt replay.",
        "Die Eingaben des letzten Laufs für nctakt replay aufzeichnen.",
    ),
)
@option(
    "--log",
    metavar="FILE",
    text=Text(
        "Lay a machine's log over the run, as nctakt compare does.",
        "Ein Log der Maschine über den Lauf legen, wie nctakt compare.",
    ),
)
@log_options
@option(
    "--host",
    default="127.0.0.1",
    metavar="ADDRESS",
    text=Text("Address of the page.", "Adresse der Seite."),
)
@option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8765,
    metavar="N",
    text=Text(
        "Port of the page, 0: a free one [default: 8765].",
        "Port der Seite, 0: ein freier [Vorgabe: 8765].",
    ),
)
@option(
    "--dap",
    "debug_port",
    type=click.IntRange(0, 65535),
    metavar="N",
    text=Text(
        "Let debuggers attach at this port of this computer, 0: a free one, which is printed.",
        "Debugger dürfen sich an diesem Port dieses Rechners verbinden, 0: ein freier, der "
        "ausgegeben wird.",
    ),
)
@option(
    "--embed",
    "is_embedded",
    is_flag=True,
    text=Text(
        "Let an editor show the page in one of its panels.",
        "Ein Editor darf die Seite in einem seiner Fenster zeigen.",
    ),
)
@option(
    "--open",
    "opens_browser",
    is_flag=True,
    text=Text("Open the page in the browser.", "Die Seite im Browser öffnen."),
)
@MODE_OPTION
def command(**words: Any) -> int:
    """Show a run on a page."""
    has_log = words["log"] is not None
    log = take_words(words, LogWords)
    live_words = take_words(words, Words)
    if has_log:
        live_words = replace(live_words, log=log)
    return carry_out(
        words,
        lambda options, access: show_page(options, access, live_words),
    )


@dataclass(frozen=True, slots=True)
class Words:
    """The words that only this command has; ``has_tour``: the page has that of the demo cell."""

    host: str
    port: int
    debug_port: int | None
    is_embedded: bool
    opens_browser: bool
    acknowledge: bool
    pace: str
    tape: str | None
    log: LogWords | None = None
    has_tour: bool = False


def _check_tape(live_words: Words, access: FileAccess) -> None:
    """Raise ``Failure`` if the tape is one of the inputs, or cannot be written."""
    if live_words.tape is not None:
        with OutputFile(live_words.tape, "--record", access):
            pass


def _share(
    opener: Callable[[str | None, bool], Session],
    documents: Mapping[int, list[Document]],
    live_words: Words,
    curves: Sequence[LoggedCurve],
    plcs: Sequence[str],
) -> SharedSession:
    """Return the session for browsers, with the first program; raises ``Failure``."""
    from nctakt.live.shared import SharedSession  # noqa: PLC0415 - as in ``show_page``

    channel = next(iter(documents))
    return SharedSession(
        opener,
        documents[channel][0].file,
        acknowledges=not live_words.acknowledge,
        channel=channel,
        logged=curves,
        plcs=[Path(one) for one in plcs],
        transformed=documents[channel][0].checker.transformed,
    )


def show_page(options: Options, access: FileAccess, live_words: Words) -> int:
    """Open the session and serve the page; raises ``Failure`` for unusable inputs.

    Ctrl-C ends it, also before there is a page.
    """
    try:
        page = _opened(options, access, live_words)
    except KeyboardInterrupt:
        return EXIT_RAN
    from nctakt.live import server  # noqa: PLC0415 - seldom needed
    from nctakt.live.texts import Texts  # noqa: PLC0415 - the mode is chosen before

    refused: Counter[Text] = Counter()
    shared = page.shared
    with contextlib.ExitStack() as ends:
        ends.callback(shared.close)
        if live_words.debug_port is not None:
            ends.callback(_let_attach(shared, live_words.debug_port, options).close)
        with contextlib.suppress(KeyboardInterrupt):
            server.serve(
                shared,
                page.documents,
                Texts(options.language),
                page.address,
                shown=server.Shown(
                    bool(options.plcs),
                    live_words.has_tour,
                    live_words.opens_browser,
                    live_words.is_embedded,
                ),
                announce=click.echo,
                reports=server.Reports(
                    lambda found: print_diagnostics([found], options.language),
                    lambda _, reason: refused.update([reason]),
                ),
            )
        if refused and not options.quiet:
            print_diagnostics([_refusals(refused, options.language)], options.language)
        if live_words.tape is not None:
            shared.session.save(live_words.tape)
        if page.kept is not None:
            page.kept.keep()
    return EXIT_RAN


@dataclass(frozen=True, slots=True)
class _Page:
    """What a page shows, before it is served; ``kept``: the values that outlive the session."""

    shared: SharedSession
    documents: Mapping[int, list[Document]]
    address: tuple[str, int]
    kept: RetainedSession | None


def _opened(options: Options, access: FileAccess, live_words: Words) -> _Page:
    """Return the session with its programs; raises ``Failure`` for unusable inputs."""
    from nctakt.live import server  # noqa: PLC0415 - seldom needed

    server.check_library()
    if STANDARD_INPUT in (*options.programs, *(program for _, program in options.others)):
        raise Failure(diagnostic(PAGE_NEEDS_FILES))
    choose_mode(options)
    from nctakt.live.document import Checker, Document  # noqa: PLC0415 - the mode is chosen before

    request = read_request(options, access)
    if options.machine_note is not None and not options.quiet:
        print_diagnostics([options.machine_note], options.language)
    address = live_words.host, server.usable_port(live_words.host, live_words.port)
    _check_tape(live_words, access)
    folders = options.confined or _folders_of(options)
    checker = Checker(options.machine, folders)
    documents = {
        number: [Document(str(program), checker) for program in programs]
        for number, programs in {1: request.programs, **request.channels}.items()
        if programs
    }
    curves = [] if live_words.log is None else _compared_curves(options, access, live_words.log)
    kept = None
    if options.retain is not None:
        kept = RetainedSession(options.retain, options.plcs, access, options.language)
    open_session = _session_opener(options, request, live_words, documents, folders, kept)
    shared = _share(open_session, documents, live_words, curves, options.plcs)
    return _Page(shared, documents, address, kept)


def _compared_curves(options: Options, access: FileAccess, words: LogWords) -> list[LoggedCurve]:
    """Return the curves of a log, compared with those of a starting run; raises ``Failure``.

    The run ends with the log at the latest.
    """
    from nctakt.comparison.comparison import compare  # noqa: PLC0415 - the mode is chosen before
    from nctakt.comparison.deviations import SHOWN  # noqa: PLC0415 - as above
    from nctakt.comparison.overlay import left_out, logged_curves  # noqa: PLC0415 - as above
    from nctakt.comparison.recorded import RecordedColumns  # noqa: PLC0415 - as above

    quiet = replace(options, machine_note=None)
    controller = start_controller(quiet, access)
    opened = opened_log(words, controller, access)
    samples = opened.log.read([pair.column for pair in opened.pairs])
    begin = min(one.first_us for one in samples)
    end = max(one.last_us for one in samples)
    request = replace(read_request(quiet, access), signals=opened.signals)  # its own PLC
    if request.options["until"] is None:
        request.options["until"] = f"{int(end - begin) + 1}us"
    columns = RecordedColumns()
    run = run_programs(quiet, request, controller, sinks=[columns], blocks=True)
    if run is None or run.errors:
        number = run.errors[0].number if run is not None and run.errors else ""
        print_diagnostics(
            [diagnostic(LOG_NOT_SHOWN, log=words.log, number=number)], options.language
        )
        return []
    found = compare(
        opened.log,
        run,
        columns,
        opened.pairs,
        opened.limits,
        opened.given,
        kept=SHOWN,
    )
    diagnostics = [*found.diagnostics, *left_out(found)]
    print_diagnostics(diagnostics, options.language, shown_from(options))
    return logged_curves(found)


def _session_opener(
    options: Options,
    request: Request,
    live_words: Words,
    documents: Mapping[int, Sequence[Document]],
    folders: Sequence[str],
    kept: RetainedSession | None,
) -> Callable[[str | None, bool], Session]:
    """Return a function that opens a session of the documents, with values retained before.

    It is called with the program of channel 1, ``None`` for all, and whether the PLC acknowledges
    automatically.
    """
    from nctakt.run.program_loader import NcText  # noqa: PLC0415 - the mode is chosen before
    from nctakt.session.session import Session  # noqa: PLC0415 - as above

    given = request.session_options
    given["until"] = given["until"] or _LONGEST

    def open_session(program: str | None, acknowledges: bool) -> Session:
        texts = {
            number: [
                NcText(document.file, document.text)
                for document in opened
                if number > 1 or program in (None, document.file)
            ]
            for number, opened in documents.items()
        }
        if kept is not None:
            given["set"] = {**kept.values(), **(request.options["set"] or {})}
        session = Session(
            channels=texts,
            machine=options.machine,
            plc=options.plcs,
            acknowledges=acknowledges,
            folders=folders,
            pace=live_words.pace,
            **given,
        )
        if kept is not None:
            kept.follow(session)
        return session

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
    for line in server.endpoint.lines():
        click.echo(f"dap {line}")
    if server.endpoint.warning is not None:
        print_diagnostics([server.endpoint.warning], options.language)
    return server


def _folders_of(options: Options) -> tuple[str, ...]:
    """Return the folders whose files the page may read: of the programs and of the machine."""
    programs = (*options.programs, *(program for _, program in options.others))
    folders = {str(Path(program).parent): None for program in programs}
    if options.machine is not None:
        machine = Path(machine_folder(options.machine))
        folders[str(machine if machine.is_dir() else machine.parent)] = None
    return tuple(folders)
