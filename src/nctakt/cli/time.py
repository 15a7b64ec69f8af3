# SPDX-License-Identifier: MIT
"""``nctakt time``: where the machining time of programs goes, and the limit of each block.

In: programs, machine, values of variables at times, limits. Out: tables on standard output, files
for other tools. Exit codes as of ``nctakt run``.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import Text
from nctakt.cli import EXIT_NC_ERROR
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import FORMAT_OPTION
from nctakt.cli.common.request import Options, Request, read_request
from nctakt.cli.common.running import (
    RUN_CODES,
    TIMES_NOTE,
    choose_mode,
    exit_code,
    run_options,
    schedule_of,
    shown_from,
    start_controller,
    with_limit_error,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import (
    InterruptRequest,
    ProgressBar,
    print_diagnostics,
    show_at_the_end,
)
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.run.access.stimuli import read_stimulus

if TYPE_CHECKING:
    from nctakt.lists.machine.machine import Machine
    from nctakt.results.run import Run
    from nctakt.run.controller import Controller
    from nctakt.run.options import RunKeywords
    from nctakt.timing.entries import TimeAccount
    from nctakt.timing.what_if import Variant


@described(
    "time",
    summary=Text("Show where the machining time goes.", "Zeigen, wo die Bearbeitungszeit bleibt."),
    text=Text(
        "Run NC programs and show where their time goes and what limits each block.",
        "NC-Programme ausführen und zeigen, wo ihre Zeit bleibt und was jeden Satz begrenzt.",
    ),
    codes=RUN_CODES,
    notes=Text(
        "Each tick belongs to one block and one cause; all sums are those of the run. What cannot "
        f'be known is called "not known". {TIMES_NOTE.en}',
        "Jeder Takt gehört zu einem Satz und einer Ursache; alle Summen sind die des Laufs. Was "
        f'sich nicht wissen lässt, heißt "nicht bekannt". {TIMES_NOTE.de}',
    ),
    examples=(
        "nctakt time part.nc",
        "nctakt time part.nc --machine mill --what-if",
        "nctakt time part.nc --flame part.speedscope.json --csv part.csv --plot part.svg",
    ),
)
@run_options("time")
@FORMAT_OPTION
@option(
    "--what-if",
    is_flag=True,
    text=Text(
        "Run again with each limit of the machine doubled.",
        "Noch einmal laufen lassen, je eine Grenze der Maschine verdoppelt.",
    ),
)
@option(
    "--csv",
    "table",
    metavar="FILE",
    group="files",
    text=Text("Write all times as CSV.", "Alle Zeiten als CSV schreiben."),
)
@option(
    "--flame",
    metavar="FILE",
    group="files",
    text=Text(
        "Write a flame graph for speedscope (.json).",
        "Ein Flammendiagramm für speedscope schreiben (.json).",
    ),
)
@option(
    "--plot",
    "picture",
    metavar="FILE",
    group="files",
    text=Text(
        "Draw the slowest blocks: .svg or .png.", "Die langsamsten Sätze zeichnen: .svg oder .png."
    ),
)
def command(
    what_if: bool, table: str | None, flame: str | None, picture: str | None, **words: Any
) -> int:
    """Report where the time goes."""
    names = {"--csv": table, "--flame": flame, "--plot": picture}
    files = {option: name for option, name in names.items() if name is not None}
    return carry_out(words, lambda options, access: _time(options, access, files, what_if))


def _time(options: Options, access: FileAccess, names: dict[str, str], asks_what_if: bool) -> int:
    """Run, write the files and report; raises ``Failure`` for invalid options."""
    choose_mode(options)
    from nctakt.timing.what_if import what_if  # noqa: PLC0415 - the mode is chosen before

    if "--plot" in names:
        from nctakt.plots.picture import check_drawing  # noqa: PLC0415 - as above

        check_drawing(names["--plot"])
    request = read_request(options, access)
    controller = start_controller(options, access)

    def rerun(machine: Machine, values: Mapping[str, float]) -> Run:
        from nctakt.run.controller import Controller  # noqa: PLC0415 - the mode is chosen before

        again = (
            request
            if options.plc is None and options.fmu is None
            else read_request(options, access)
        )
        other = Controller(machine, schedule_of(options, access), access)
        changed: RunKeywords = {
            **request.options,
            "plc": again.plc,
            "fmu": again.fmu,
            "set": {**(request.options["set"] or {}), **values},
            "memory_trace": False,
        }
        return other.run(*request.programs, channels=request.channels, **changed)

    with contextlib.ExitStack() as stack:
        files = {
            option: stack.enter_context(OutputFile(name, option, access))
            for option, name in names.items()
        }
        account = _account(options, request, controller)
        if account is None:
            return EXIT_NC_ERROR
        variants: list[Variant] = []
        if asks_what_if and account.run.ticks:
            variants = what_if(
                account.run, controller.machine, rerun, has_override=_has_override(request)
            )
        if account.run.ticks:
            _write(files, account, options)
    run = with_limit_error(options, account.run)
    print_diagnostics(run.diagnostics, options.language, shown_from(options))
    text = _report(options, replace(account, run=run), variants)
    show_at_the_end(lambda file: print(text, end="", file=file))
    is_cut_off = any(one.state == "interrupted" for one in variants)
    return EXIT_NC_ERROR if is_cut_off else exit_code(options, run)


def _has_override(request: Request) -> bool:
    """Return whether a PLC, an FMU or a value from outside may set the operator's override."""
    names = [*(request.options["set"] or {})]
    names += [read_stimulus(one).name for one in request.options["at"]]
    has_partner = request.plc is not None or request.fmu is not None
    return has_partner or any(name.upper().endswith("HLI.OVERRIDE") for name in names)


def _account(options: Options, request: Request, controller: Controller) -> TimeAccount | None:
    """Return where the time went; ``None`` if the user's PLC failed, which has been reported."""
    from nctakt.cli.common.comment_inputs import report_unused_inputs  # noqa: PLC0415 - as below
    from nctakt.plc.error import PlcError  # noqa: PLC0415 - the mode is chosen before
    from nctakt.timing.account import account_for  # noqa: PLC0415

    report_unused_inputs(options, request)
    bar = ProgressBar()

    def show_progress(tick: int, limit: int | None) -> None:
        interrupt.check()
        bar.update(tick, limit)

    programs = {1: request.programs, **request.channels}
    try:
        with InterruptRequest() as interrupt:
            keywords: RunKeywords = {
                **request.options,
                "plc": request.plc,
                "fmu": request.fmu,
                "on_progress": show_progress,
            }
            return account_for(controller, programs, **keywords)
    except PlcError as failure:
        bar.hide()
        print_diagnostics(failure.diagnostics, options.language)
        return None
    finally:
        bar.hide()


def _write(files: dict[str, OutputFile], account: TimeAccount, options: Options) -> None:
    from nctakt.timing.exports import as_csv, as_speedscope  # noqa: PLC0415 - as above

    if "--csv" in files:
        files["--csv"].write(as_csv(account, options.language))
    if "--flame" in files:
        files["--flame"].write(as_speedscope(account, options.language))
    if "--plot" in files:
        from nctakt.timing.picture import write_time_picture  # noqa: PLC0415 - loads matplotlib

        files["--plot"].fill(lambda path: write_time_picture(account, path, options.language))


def _report(options: Options, account: TimeAccount, variants: list[Variant]) -> str:
    from nctakt.cli.findings.json_documents import as_json, run_document  # noqa: PLC0415 - as above
    from nctakt.results.summary import headline  # noqa: PLC0415
    from nctakt.timing.table import time_text, what_if_text  # noqa: PLC0415

    language = options.language
    if options.form == "json":
        times = [
            {"purpose": one, "ticks": ticks, "time_us": account.us(ticks)}
            for one, ticks in account.by(lambda purpose: purpose).items()
        ]
        return as_json(run_document(account.run, language, times=times, what_if=variants))
    text = f"{headline(account.run, language, None)}\n"
    if account.run.ticks:
        text += f"\n{time_text(account, language)}"
    if variants:
        text += f"\n{what_if_text(variants, language)}"
    return text
