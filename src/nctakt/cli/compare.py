# SPDX-License-Identifier: MIT
"""``nctakt compare``: lay a machine's log over the run of its program.

In: a log, programs, machine, a mapping of columns to signals, tolerances. Out: how far both are
apart, and where. Exit code 1 if a signal leaves its tolerance.
"""

from __future__ import annotations

import contextlib
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Severity, Text
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.help import described, option
from nctakt.cli.common.log_options import LogWords, log_options, opened_log
from nctakt.cli.common.options import FORMAT_OPTION, take_words
from nctakt.cli.common.request import Options, Request, read_request
from nctakt.cli.common.running import (
    TIMES_NOTE,
    choose_mode,
    exit_code,
    run_options,
    run_programs,
    schedule_of,
    shown_from,
    start_controller,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.files.new_folder import check_new_folder, write_new_folder
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import SHARE_NOT_WRITTEN

if TYPE_CHECKING:
    from nctakt.comparison.comparison import Comparison
    from nctakt.lists.machine.machine import Machine
    from nctakt.proposals.changes import Change
    from nctakt.proposals.nearer import Proposals
    from nctakt.results.run import Run

_CODES = (
    Text("the run is within the tolerances", "der Lauf liegt innerhalb der Toleranzen"),
    Text(
        "a signal leaves its tolerance, or the program fails",
        "ein Signal verlässt seine Toleranz, oder das Programm scheitert",
    ),
)


@described(
    "compare",
    summary=Text(
        "Lay a machine's log over a run.", "Das Log einer Maschine mit einem Lauf vergleichen."
    ),
    text=Text(
        "Run NC programs and show how far a log of the machine deviates from them, and in "
        "which block.",
        "NC-Programme ausführen und zeigen, wie weit ein Log der Maschine davon abweicht und "
        "in welchem Satz.",
    ),
    codes=_CODES,
    notes=Text(
        "The log is text: an export of TwinCAT Scope, a trace of nctakt, or a table with names and "
        f"times. {TIMES_NOTE.en}",
        "Das Log ist Text: ein Export von TwinCAT Scope, eine Aufzeichnung von nctakt "
        f"oder eine Tabelle mit Namen und Zeiten. {TIMES_NOTE.de}",
    ),
    examples=(
        "nctakt compare scope.csv part.nc --machine mill",
        "nctakt compare scope.csv part.nc --tolerance 0.05 --tolerance S.SPEED=20",
        "nctakt compare scope.csv part.nc --map scope.toml --offset 1.25s --drift 40",
        'nctakt compare scope.csv part.nc --align "V.E.GATE rises"',
        "nctakt compare scope.csv part.nc --propose",
        "nctakt compare scope.csv part.nc --share for_nctakt",
    ),
)
@click.argument("log")
@run_options("compare")
@FORMAT_OPTION
@log_options
@option(
    "--plot",
    "picture",
    metavar="FILE",
    group="files",
    text=Text("Draw both curves: .svg or .png.", "Beide Kurven zeichnen: .svg oder .png."),
)
@option(
    "--propose",
    "proposes",
    is_flag=True,
    text=Text(
        "Run again with single changes of lists and override, and name those that come nearer.",
        "Mit einzelnen Änderungen von Listen und Override wieder ausführen und nennen, was näher "
        "kommt.",
    ),
)
@option(
    "--share",
    metavar="FOLDER",
    group="files",
    text=Text(
        "Write what helps to make nctakt more exact, without names and texts, into a new folder.",
        "Was hilft, nctakt genauer zu machen, ohne Namen und Texte, in einen neuen Ordner "
        "schreiben.",
    ),
)
@option(
    "--yes",
    is_flag=True,
    text=Text(
        "Write the folder of --share; without it only what it would hold is shown.",
        "Den Ordner von --share schreiben; ohne dies wird nur gezeigt, was er enthielte.",
    ),
)
def command(picture: str | None, **words: Any) -> int:
    """Compare."""
    own = take_words(words, LogWords)
    said = {name: words.pop(name) for name in ("proposes", "share", "yes")}
    return carry_out(words, lambda options, access: _compare(options, access, own, picture, **said))


def _compare(
    options: Options,
    access: FileAccess,
    words: LogWords,
    picture: str | None,
    proposes: bool,
    share: str | None,
    yes: bool,
) -> int:
    """Run, compare and report; raises ``Failure`` for invalid options and logs."""
    choose_mode(options)
    from nctakt.comparison.comparison import compare  # noqa: PLC0415 - the mode is chosen before
    from nctakt.comparison.deviations import DRAWN, SHARED  # noqa: PLC0415
    from nctakt.comparison.recorded import RecordedColumns  # noqa: PLC0415
    from nctakt.proposals.changes import OVERRIDE  # noqa: PLC0415
    from nctakt.proposals.nearer import Search  # noqa: PLC0415

    _check_outputs(picture, share)
    words.read_limits()
    request = read_request(options, access)
    controller = start_controller(options, access)
    log = opened_log(words, controller, access)
    with contextlib.ExitStack() as files:
        file = (
            None if picture is None else files.enter_context(OutputFile(picture, "--plot", access))
        )
        request = replace(request, signals=log.signals)
        columns = RecordedColumns()
        run = run_programs(options, request, controller, sinks=[columns], blocks=True)
        if run is None:
            return EXIT_NC_ERROR
        print_diagnostics(run.diagnostics, options.language, shown_from(options))
        comparison = compare(
            log.log,
            run,
            columns,
            log.pairs,
            log.limits,
            log.given,
            kept=SHARED if share is not None else DRAWN if file is not None else 0,
        )
        if file is not None:
            _draw(file, comparison, options)
    lowest = Severity.ERROR if options.quiet else Severity.NOTE
    print_diagnostics(comparison.diagnostics, options.language, lowest)
    proposals = None
    if proposes:
        again = partial(_run_again, options, access, controller.machine, log.signals)
        override = float((request.options["set"] or {}).get(OVERRIDE, 100.0))
        search = Search(comparison, log.pairs, again, log.given)
        proposals = search.proposals(controller.machine, override)
    _show(options, comparison, proposals)
    if share is not None:
        _share(options, access, comparison, request, controller.machine, share, writes=yes)
    return max(exit_code(options, run), EXIT_RAN if comparison.is_within else EXIT_NC_ERROR)


def _check_outputs(picture: str | None, share: str | None) -> None:
    """Raise ``Failure`` for a picture and a folder that cannot be written."""
    from nctakt.plots.picture import check_drawing  # noqa: PLC0415 - loads matplotlib

    if picture is not None:
        check_drawing(picture)
    if share is not None:
        check_new_folder(Path(share))


def _run_again(
    options: Options,
    access: FileAccess,
    machine: Machine,
    signals: tuple[str, ...],
    change: Change,
    value: float,
) -> Run | None:
    """Return the run with a change; ``None`` if it is not possible."""
    from nctakt.proposals.changes import changed_run  # noqa: PLC0415 - as above

    request = replace(read_request(options, access), signals=signals)  # its own PLC
    schedule = schedule_of(options, access)
    return changed_run(machine, schedule, access, request, change, value)


def _share(
    options: Options,
    access: FileAccess,
    comparison: Comparison,
    request: Request,
    machine: Machine,
    folder: str,
    *,
    writes: bool,
) -> None:
    """Show the content of the folder, and write it; raises ``Failure``."""
    from nctakt.comparison.sharing.share import SharedRun, share_lines, share_of  # noqa: PLC0415

    channels = {1: request.programs, **request.channels}
    share = share_of(comparison, SharedRun(machine, channels, request.options, options.run), access)
    if options.form == "text":
        for line in ("", *share_lines(share, folder, options.language)):
            click.echo(line)
    print_diagnostics(share.findings, options.language, shown_from(options))
    if writes:
        write_new_folder(Path(folder), {name: text.encode() for name, text in share.files.items()})
    else:
        print_diagnostics([diagnostic(SHARE_NOT_WRITTEN, folder=folder)], options.language)


def _draw(file: OutputFile, comparison: Comparison, options: Options) -> None:
    from nctakt.comparison.picture import (  # noqa: PLC0415 - loads matplotlib
        write_comparison_picture,
    )

    file.fill(lambda path: write_comparison_picture(comparison, path, options.language))


def _show(options: Options, comparison: Comparison, proposals: Proposals | None) -> None:
    from nctakt.cli.findings.json_documents import as_json, run_document  # noqa: PLC0415 - as above
    from nctakt.comparison.report import comparison_document, comparison_text  # noqa: PLC0415
    from nctakt.proposals.report import proposals_document, proposals_text  # noqa: PLC0415

    if options.form == "json":
        document = comparison_document(comparison)
        if proposals is not None:
            document["proposals"] = proposals_document(proposals)
        text = as_json(run_document(comparison.run, options.language, comparison=document))
    else:
        text = comparison_text(comparison, ", ".join(options.programs), options.language)
        if proposals is not None:
            text += "\n" + proposals_text(proposals, options.language)
    show_at_the_end(lambda file: print(text, end="", file=file))
