# SPDX-License-Identifier: MIT
"""``nctakt coverage``: the branches of realtime cycles that ran, in one run or in many together.

In: programs, machine, values, limits as for ``nctakt run``; files with the counts of earlier runs.
Out: on standard output the sum of all as a table, as source lines with their counts, as JSON or as
LCOV; with ``--data`` the sum in that file. Exit codes as of ``nctakt run``, and 1 if fewer branches
ran than ``--fail-under`` demands.
"""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.help import NumberRange, described, option
from nctakt.cli.common.request import Options, read_request
from nctakt.cli.common.running import (
    RUN_CODES,
    TIMES_NOTE,
    choose_mode,
    exit_code,
    run_options,
    run_programs,
    shown_from,
    start_controller,
    with_limit_error,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.coverage import (
    COUNT_INTERRUPTED,
    COUNT_LIMITED,
    COVERAGE_BELOW_MINIMUM,
    COVERAGE_COUNTS_DROPPED,
    INVALID_COVERAGE_DATA,
    NOTHING_TO_COVER,
)

if TYPE_CHECKING:
    from nctakt.results.coverage import Coverage


@described(
    "coverage",
    summary=Text("Count the branches of cycles that ran.", "Durchlaufene Zweige zählen."),
    text=Text(
        "Run NC programs and count the branches of their realtime cycles.",
        "NC-Programme ausführen und die Zweige ihrer Echtzeit-Zyklen zählen.",
    ),
    codes=(
        RUN_CODES[0],
        Text(
            f"{RUN_CODES[1].en}, or fewer branches ran than --fail-under demands",
            f"{RUN_CODES[1].de}, oder es liefen weniger Zweige, als --fail-under verlangt",
        ),
    ),
    notes=Text(
        "For each branch: the number of ticks in which its condition was evaluated, true and "
        f"false, and its body ran. Without a program only earlier runs count. {TIMES_NOTE.en}",
        "Zu jedem Zweig: in wie vielen Takten seine Bedingung ausgewertet wurde, wahr und falsch "
        f"war und sein Rumpf lief. Ohne Programm zählen nur frühere Läufe. {TIMES_NOTE.de}",
    ),
    examples=(
        "nctakt coverage part.nc --set V.E.VALUE=5",
        "nctakt coverage part.nc --data all.json --format source",
        "nctakt coverage --merge a.json --merge b.json --format lcov",
    ),
)
@run_options("coverage")
@option(
    "--format",
    "form",
    type=click.Choice(["text", "source", "json", "lcov"]),
    default="text",
    group="files",
    text=Text(
        "A table, the source with counts, or a file for other tools [default: text].",
        "Eine Tabelle, der Quelltext mit Zahlen oder eine Datei für andere Werkzeuge [Vorgabe: "
        "text].",
    ),
)
@option(
    "--data",
    metavar="FILE",
    text=Text(
        "Add the earlier runs in this file, and save the sum in it.",
        "Die früheren Läufe in dieser Datei hinzunehmen und die Summe darin speichern.",
    ),
)
@option(
    "--merge",
    multiple=True,
    metavar="FILE",
    text=Text("Add the runs in this file.", "Die Läufe in dieser Datei hinzunehmen."),
)
@option(
    "--fail-under",
    "minimum",
    type=NumberRange(0, 100),
    metavar="PERCENT",
    text=Text(
        "Exit code 1 if a smaller share of the branches ran.",
        "Rückgabewert 1, wenn ein kleinerer Teil der Zweige lief.",
    ),
)
def command(
    form: str, data: str | None, merge: tuple[str, ...], minimum: float | None, **words: Any
) -> int:
    """Count branches."""
    return carry_out(
        words, lambda options, access: _cover(options, access, form, data, merge, minimum)
    )


def _cover(
    options: Options,
    access: FileAccess,
    form: str,
    data: str | None,
    merge: tuple[str, ...],
    minimum: float | None,
) -> int:
    """Read, run, add and report; raises ``Failure`` for invalid options."""
    choose_mode(options)
    from nctakt.results.coverage_files import as_json  # noqa: PLC0415 - the mode is chosen before

    if not options.programs and not options.others and data is None and not merge:
        raise Failure(diagnostic(NOTHING_TO_COVER))
    before = [_read(file, access) for file in merge]
    if data is not None and Path(data).exists():
        before.insert(0, _read(data, access, is_replaced=True))
    with contextlib.ExitStack() as files:
        output = None
        if data is not None:
            output = files.enter_context(OutputFile(data, "--data", access))
        code, ran = _run(options, access)
        if code and ran is None:
            return code
        total = _sum([*before, *(() if ran is None else (ran,))], options.language)
        if output is not None:
            output.write(as_json(total))
    show_at_the_end(lambda file: print(_shown(total, form, options.language), end="", file=file))
    if minimum is not None and total.percent < minimum:
        percent = f"{int(10 * total.percent) / 10:g}"  # rounded down
        message = diagnostic(COVERAGE_BELOW_MINIMUM, percent=percent, minimum=f"{minimum:g}")
        print_diagnostics([message], options.language)
        return EXIT_NC_ERROR
    return code


def _read(path: str, access: FileAccess, *, is_replaced: bool = False) -> Coverage:
    """Return the coverage in a file; raises ``Failure`` for another file."""
    from nctakt.results.coverage_files import from_json  # noqa: PLC0415 - as above

    try:
        text = access.read_bytes(Path(path), is_replaced=is_replaced).decode("utf-8")
    except UnicodeDecodeError as error:
        raise Failure(diagnostic(INVALID_COVERAGE_DATA, file=path)) from error
    return from_json(path, text)


def _run(options: Options, access: FileAccess) -> tuple[int, Coverage | None]:
    """Return the exit code and the coverage of the run, ``None`` without programs."""
    if not options.programs and not options.others:
        return EXIT_RAN, None
    request = read_request(options, access)
    run = run_programs(options, request, start_controller(options, access), why=True)
    if run is None:
        return EXIT_NC_ERROR, None
    run = with_limit_error(options, run)
    print_diagnostics(run.diagnostics, options.language, shown_from(options))
    cut_short = {"interrupted": COUNT_INTERRUPTED, "limit": COUNT_LIMITED}.get(run.state)
    if cut_short is not None:
        found = diagnostic(cut_short, time=str(Time(run.virtual_time_us)))
        print_diagnostics([found], options.language)
    return exit_code(options, run), run.coverage if run.ticks else None


def _sum(parts: list[Coverage], language: Language) -> Coverage:
    """Return the sum; counts dropped since a program has changed are reported."""
    from nctakt.results.coverage import Coverage  # noqa: PLC0415 - the mode is chosen before

    total = Coverage()
    for part in parts:
        outdated = total.outdated_by(part)
        print_diagnostics(
            [diagnostic(COVERAGE_COUNTS_DROPPED, file=file) for file in outdated], language
        )
        total = total.plus(part)
    return total


def _shown(coverage: Coverage, form: str, language: Language) -> str:
    from nctakt.results.coverage_files import as_json, as_lcov  # noqa: PLC0415 - as above
    from nctakt.results.coverage_text import CoverageText  # noqa: PLC0415

    if form == "json":
        return as_json(coverage)
    if form == "lcov":
        return as_lcov(coverage)
    text = CoverageText(coverage, language)
    return text.source() if form == "source" else text.table()
