# SPDX-License-Identifier: MIT
"""``nctakt run``: run NC programs in turn on a machine and report the results.

In: programs, machine, values of variables at times, limits, files to write. Out: the programs'
messages as they come and a summary (standard output), diagnostics (standard error), the files, and
the exit code. All mistakes in the options are reported before a file is written or a tick is run.
"""

from __future__ import annotations

import contextlib
import dataclasses
import time
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Severity, Text
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import FORMAT_OPTION, RETAIN_OPTION, WATCH_OPTION, with_file_options
from nctakt.cli.common.plotting import Drawings
from nctakt.cli.common.request import Options, Request, read_request
from nctakt.cli.common.retaining import with_retained
from nctakt.cli.common.running import (
    RUN_CODES,
    TIMES_NOTE,
    choose_mode,
    exit_code,
    print_findings,
    run_options,
    run_programs,
    start_controller,
    with_limit_error,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import (
    message_line,
    print_diagnostics,
    saved_message,
    show_at_the_end,
)
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import NO_DIAGNOSIS_DATA

if TYPE_CHECKING:
    from collections.abc import Sequence

    from nctakt.base.diagnostics import Diagnostic
    from nctakt.lists.machine.machine import Machine
    from nctakt.results.report import DiagnosisSink
    from nctakt.results.run import ProgramMessage, Run
    from nctakt.results.trace.sinks import Sink
    from nctakt.run.access.tape import TapeComparison, TapeWriter
    from nctakt.run.controller import Controller


@described(
    "run",
    summary=Text("Run NC programs one after another.", "NC-Programme nacheinander ausführen."),
    text=Text(
        "Run NC programs one after another on the same controller ('-': standard input).",
        "NC-Programme nacheinander auf derselben Steuerung ausführen ('-': Standardeingabe).",
    ),
    codes=RUN_CODES,
    notes=TIMES_NOTE,
    examples=(
        "nctakt run part.nc",
        "nctakt run part.nc --set V.E.VALUE=5 --at 1.5ms V.E.VALUE=-1",
        "nctakt run part.nc --trace out.csv --signals X.ACS.ACT_POS,BLOCK",
        "nctakt run - < part.nc",
    ),
)
@run_options("run")
@FORMAT_OPTION
@with_file_options
@option(
    "--hli",
    metavar="NAME",
    group="machine",
    text=Text(
        "Share the HLI; a PLC in another process answers.",
        "Das HLI teilen; eine SPS in einem anderen Prozess antwortet.",
    ),
)
@option(
    "--record",
    metavar="FILE",
    group="files",
    text=Text(
        "Record all inputs for nctakt replay.",
        "Alle Eingaben für nctakt replay aufzeichnen.",
    ),
)
@RETAIN_OPTION
@WATCH_OPTION
def command(**words: Any) -> int:
    """Run programs."""
    return carry_out(words, run_with)


def run_with(options: Options, access: FileAccess) -> int:
    """Prepare, run and report, also a run from a tape; raises ``Failure`` for invalid options."""
    choose_mode(options)
    request = read_request(options, access)
    controller = start_controller(options, access)
    with contextlib.ExitStack() as files:

        def open_file(option: str, path: str | None) -> OutputFile | None:
            """Return a file to write, ``None`` without the option."""
            return None if path is None else files.enter_context(OutputFile(path, option, access))

        drawings = Drawings(options, controller, open_file)
        sinks = _open_trace(open_file("--trace", options.trace))
        messages = open_file("--messages", options.messages)
        report = open_file("--diagnosis", options.diagnosis)
        log = open_file("--error-log", options.error_log)
        if log is not None:
            sinks.append(_error_log(controller, log))
        diagnosis = [] if report is None else _diagnosis(controller)
        listeners = [*sinks, *diagnosis]
        if options.hli is not None:
            from nctakt.cli.common.hli_partner import connect_partner  # noqa: PLC0415 - seldom needed

            partner = connect_partner(options, options.hli, controller, files)
            request = dataclasses.replace(request, plc=partner)
        options, request, write_retained = with_retained(options, request, access, files)
        tape = _Taping(options, request, open_file("--record", options.record))
        listeners = drawings.sinks([*listeners, *tape.sinks], request)
        request = drawings.request(request)
        begin_s = time.perf_counter()
        run = _run_controller(options, request, controller, listeners, messages, tape, drawings)
        tape.finish(run, controller, access)
        write_retained()
        wall_s = time.perf_counter() - begin_s
        diagnostics = () if run is None else run.diagnostics
        if report is not None:
            report.write(_diagnosis_text(controller, diagnosis, options, diagnostics))
        if run is not None:
            drawings.draw(run)
    if run is None:
        return EXIT_NC_ERROR
    return max(_report(options, run, controller.machine, wall_s), tape.report(run))


class _Taping:
    """The tape that a run is recorded on, and the one that it is replayed from."""

    def __init__(self, options: Options, request: Request, file: OutputFile | None) -> None:
        self._options = options
        self.writer: TapeWriter | None = None
        self._comparison: TapeComparison | None = None
        self.sinks: list[Sink] = []
        if file is not None:
            from nctakt.cli.common.tapes import start_tape  # noqa: PLC0415 - seldom needed

            self.writer = start_tape(options, request, file)
            self.sinks.append(self.writer)
        if options.tape is not None and options.tape.has_checksums:
            from nctakt.run.access.tape import TapeComparison  # noqa: PLC0415 - as above

            self._comparison = TapeComparison(options.tape)
            self.sinks.append(self._comparison)

    def finish(self, run: Run | None, controller: Controller, access: FileAccess) -> None:
        """Write the last line of the recorded tape."""
        if self.writer is not None:
            from nctakt.cli.common.tapes import inputs_of_run  # noqa: PLC0415 - as above

            files = dict(inputs_of_run(self._options, access))
            self.writer.finish("broken" if run is None else run.state, controller.tick, files)

    def report(self, run: Run) -> int:
        """Report whether a replay had the recorded events; return the exit code."""
        if self._options.tape is None:
            return EXIT_RAN
        from nctakt.cli.common.tapes import verdict  # noqa: PLC0415 - as above

        lowest = Severity.WARNING if self._options.quiet else Severity.NOTE
        found = verdict(self._comparison, run.ticks, run.cycle_time_us)
        print_diagnostics([found], self._options.language, lowest)
        has_differed = self._comparison is not None and self._comparison.first is not None
        return EXIT_NC_ERROR if has_differed else EXIT_RAN


def _open_trace(file: OutputFile | None) -> list[Sink]:
    """Return the sink of ``--trace``."""
    from nctakt.results.trace.sinks import MF4, PARQUET, file_sink  # noqa: PLC0415 - the mode is chosen before

    if file is not None and file.name.lower().endswith(PARQUET):
        from nctakt.results.trace.arrow import ParquetSink  # noqa: PLC0415 - as above

        return [ParquetSink(file)]
    if file is not None and file.name.lower().endswith(MF4):
        from nctakt.results.trace.measurement import Mf4Sink  # noqa: PLC0415 - as above

        return [Mf4Sink(file)]
    return [] if file is None else [file_sink(file)]


def _error_log(controller: Controller, file: OutputFile) -> Sink:
    """Return a sink that writes the user's errors; the file is empty without any."""
    from nctakt.results.user_errors import UserErrorLog  # noqa: PLC0415 - as above

    file.write("")
    return UserErrorLog(controller.machine.user_texts, file.write)


def _diagnosis(controller: Controller) -> list[DiagnosisSink]:
    """Return sinks for the diagnosis data of each channel with realtime cycles (P-CHAN-00406)."""
    from nctakt.results.report import DiagnosisReport, DiagnosisSink  # noqa: PLC0415 - as above

    sinks: list[DiagnosisSink] = []
    for channel in controller.machine.channels:
        if channel.parameters.realtime_cycles.enable:
            report = DiagnosisReport(channel.number)
            report.initialised(controller.tick * controller.cycle_time_us, 0)
            sinks.append(DiagnosisSink(report))
    return sinks


def _diagnosis_text(
    controller: Controller,
    sinks: Sequence[DiagnosisSink],
    options: Options,
    diagnostics: Sequence[Diagnostic],
) -> str:
    """Return the diagnosis data of all channels, each by its present level (RC-603)."""
    if not sinks and not options.quiet:
        print_diagnostics([diagnostic(NO_DIAGNOSIS_DATA)], options.language)
    reports = [sink.report for sink in sinks]
    return "\n".join(
        report.render(
            float(controller.read(f"CH{report.channel}.V.RTG.CYCLES.DIAG_LEVEL")),
            options.language,
            diagnostics,
        )
        for report in reports
    )


def _run_controller(
    options: Options,
    request: Request,
    controller: Controller,
    sinks: list[Sink],
    messages: OutputFile | None,
    tape: _Taping,
    drawings: Drawings,
) -> Run | None:
    """Return the result of the run; its messages are shown and saved as they come."""

    def show_message(message: ProgramMessage) -> None:
        if options.form == "text":
            click.echo(message_line(message))
        if messages is not None:
            messages.write(saved_message(message))

    if messages is not None:
        messages.write("")
    return run_programs(
        options,
        request,
        controller,
        sinks=sinks,
        on_message=show_message,
        record=None if tape.writer is None else tape.writer.note,
        is_drawn=drawings.are_wanted,
        condition_signals=drawings.draws_conditions,
    )


def _report(options: Options, run: Run, machine: Machine, wall_s: float) -> int:
    """Show diagnostics and summary; return the exit code."""
    from nctakt.results.summary import print_summary  # noqa: PLC0415 - the mode is chosen before

    run = with_limit_error(options, run)
    if options.form == "json":
        from nctakt.cli.findings.json_documents import as_json, run_document  # noqa: PLC0415

        text = as_json(run_document(run, options.language))
        show_at_the_end(lambda file: print(text, end="", file=file))
        return exit_code(options, run)
    lowest = Severity.WARNING if options.quiet else Severity.NOTE
    print_findings(run, machine, options.language, lowest)
    if not options.quiet:
        show_at_the_end(lambda file: print_summary(run, file, options.language, wall_s))
    return exit_code(options, run)
