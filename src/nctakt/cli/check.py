# SPDX-License-Identifier: MIT
"""``nctakt check``: all diagnostics of programs, lists and folders, without a run.

In: files and folders, the programs' machine, the selected messages, the format. Out: the findings
in that format (standard output, or a file), and the exit code. Mistakes in the words of the command
line go to standard error.
"""

from __future__ import annotations

import contextlib
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Severity, Text
from nctakt.base.failure import Failure
from nctakt.checking.check import CheckResult, check_files
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.file_options import read_standard_input
from nctakt.cli.common.help import described, locale_language, option
from nctakt.cli.common.options import IGNORE_OPTION, STRICT_OPTION, WATCH_OPTION, table_options
from nctakt.cli.common.settings import maybe_watched
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.cli.findings.formats import as_github, as_json, as_text, closing_line
from nctakt.cli.findings.sarif import as_sarif
from nctakt.cli.findings.selection import Selection, read_selection
from nctakt.cli.schedules.schedule_options import RTCONF_OPTIONS, with_options
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.machine import load_machine
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, Convention, RtconfOptions
from nctakt.messages import diagnostic
from nctakt.messages.commands.checking import (
    CHECKED_FOR_DEMO_MACHINE,
    CHECKED_FOR_MACHINE_OF_FILE,
    NOTHING_NAMED_TO_CHECK,
)
from nctakt.messages.files import STDIN_NAMED_TWICE
from nctakt.project.machine_choice import MachineChoice, machine_of_environment
from nctakt.project.project_file import project_around
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

_STANDARD_INPUT = "-"

#: A folder without a name, as usage lines have it.
_FOLDER = Text("FOLDER", "ORDNER")


@dataclass(frozen=True, slots=True)
class Options:
    """The words of the command line with the settings of the project; ``None``: not given."""

    paths: tuple[str, ...]
    machine: str | None
    root: str | None
    format: Literal["text", "json", "github", "sarif"]
    language: Language
    select: tuple[str, ...]
    ignore: tuple[str, ...]
    strict: bool
    effects: bool
    verbose: bool
    quiet: bool
    output: str | None
    system: str
    convention: Convention
    functions: tuple[str, ...]
    confined: tuple[str, ...]


@described(
    "check",
    summary=Text("Find mistakes without a run.", "Fehler ohne einen Lauf finden."),
    text=Text(
        "Check NC programs, lists and folders of both.",
        "NC-Programme, Listen und Ordner mit beiden prüfen.",
    ),
    codes=(
        Text("no error (--strict: no warning either)", "kein Fehler (--strict: keine Warnung)"),
        Text("errors", "Fehler"),
    ),
    notes=Text(
        "A file that ends with .lis is a list, any other a program; '-' is a program from standard "
        "input. Folders are searched with all folders in them; a start-up list is checked together "
        "with all lists that it names.",
        "Eine Datei, die auf .lis endet, ist eine Liste, jede andere ein Programm; '-' ist ein "
        "Programm von der Standardeingabe. Ordner werden mit allen Ordnern darin durchsucht; eine "
        "Hochlaufliste wird mit allen Listen geprüft, die sie nennt.",
    ),
    examples=(
        "nctakt check part.nc",
        "nctakt check . --machine lists --format sarif --output nctakt.sarif",
        "nctakt check . --ignore 9002,22000-22099 --strict",
    ),
)
@click.argument("paths", metavar="FILE|FOLDER...", nargs=-1)
@table_options("check")
@option(
    "--format",
    type=click.Choice(["text", "json", "github", "sarif"]),
    default="text",
    group="files",
    text=Text("Format of the findings [default: text].", "Form der Befunde [Vorgabe: text]."),
)
@option(
    "--select",
    metavar="ID,...",
    multiple=True,
    text=Text("Report only these messages.", "Nur diese Meldungen ausgeben."),
)
@IGNORE_OPTION
@with_options(*RTCONF_OPTIONS)
@STRICT_OPTION
@option(
    "--effects",
    is_flag=True,
    text=Text(
        "List each entry without effect that would change a run.",
        "Jeden Eintrag ohne Wirkung nennen, der einen Lauf ändern würde.",
    ),
)
@option(
    "--verbose",
    is_flag=True,
    text=Text("List each list entry without effect.", "Jeden Listeneintrag ohne Wirkung nennen."),
)
@option(
    "--output",
    metavar="FILE",
    group="files",
    text=Text("Write the findings to a file.", "Die Befunde in eine Datei schreiben."),
)
@WATCH_OPTION
def command(**words: Any) -> int:
    """Check files."""
    return maybe_watched(words, words["paths"], lambda access: _checked(dict(words), access))


def _checked(words: dict[str, Any], access: FileAccess) -> int:
    """Complete the words and check; the exit code. A ``Failure`` is shown."""
    language: Language = words["language"] or locale_language()
    try:
        project = project_around(words["paths"], access)
        if project is not None:
            language = words["language"] or project.language or language
            words["paths"] = words["paths"] or tuple(str(path) for path in project.paths)
        return _check(Options(**{**words, "language": language}), access)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _check(options: Options, access: FileAccess) -> int:
    """Run the check and report; raises ``Failure`` for invalid options."""
    if not options.paths:
        raise Failure(diagnostic(NOTHING_NAMED_TO_CHECK))
    selection = read_selection(options.select, options.ignore)
    if options.paths.count(_STANDARD_INPUT) > 1:
        raise Failure(diagnostic(STDIN_NAMED_TWICE))
    named = options.machine
    from_environment = None if named is not None else machine_of_environment()
    if from_environment is not None:
        named = str(from_environment.path)
    machine = _machine(options, named, access)
    with contextlib.ExitStack() as files:
        output = None
        if options.output is not None:
            for path in options.paths:
                access.note(path)
            output = files.enter_context(OutputFile(options.output, "--output", access))
        return _report(options, selection, machine, from_environment, output)


def _report(
    options: Options,
    selection: Selection,
    machine: AssembledMachine,
    from_environment: MachineChoice | None,
    output: OutputFile | None,
) -> int:
    """Run the check, report and return the exit code."""
    inputs = [_standard_input() if path == _STANDARD_INPUT else path for path in options.paths]
    is_named = options.machine is not None or from_environment is not None
    checked = check_files(
        inputs,
        machine,
        detail=_detail(options),
        root=None if options.root is None else Path(options.root),
        for_all=is_named,
        rtconf=_rtconf_options(options),
    )
    lowest = Severity.WARNING if options.quiet else Severity.NOTE
    result = _selected(checked, selection, lowest)
    if from_environment is not None:
        result = replace(result, settings=(from_environment,))
    text = _text_of(result, options)
    closing = _closing(result, selection, options)
    if output is None:
        _show(text + closing if options.format == "text" else text)
    else:
        output.write(click.unstyle(text))
        output.close()
        _show(closing)
    return _exit_code(result, strict=options.strict)


def _detail(options: Options) -> Detail:
    if options.verbose:
        return "all"
    return "effects" if options.effects else "summary"


def _machine(options: Options, folder: str | None, access: FileAccess) -> AssembledMachine:
    """Return the machine of the programs; mistakes in its lists are reported as well."""
    configuration = load_machine(
        folder, root=options.root, rtconf=_rtconf_options(options), access=access
    )
    print_diagnostics(configuration.diagnostics, options.language, Severity.ERROR)
    return AssembledMachine(configuration, access, has_history=False)


def _rtconf_options(options: Options) -> RtconfOptions:
    return RtconfOptions(PROFILES[options.system], options.convention, options.functions)


def _standard_input() -> NcText:
    return NcText("<stdin>", read_standard_input())


def _selected(checked: CheckResult, selection: Selection, lowest: Severity) -> CheckResult:
    """Return the result with the selected findings only."""
    findings = tuple(
        finding
        for finding in checked.findings
        if selection.includes(finding.diagnostic) and finding.diagnostic.severity >= lowest
    )
    return replace(checked, findings=findings)


def _text_of(result: CheckResult, options: Options) -> str:
    root, language = Path.cwd(), options.language
    match options.format:
        case "json":
            return as_json(result, language, root)
        case "github":
            return as_github(result, language, root)
        case "sarif":
            return as_sarif(result, language, root)
    return as_text(result, language)


def _closing(result: CheckResult, selection: Selection, options: Options) -> str:
    """Return the closing lines: the machine if the user named none, the sums."""
    if options.quiet:
        return ""
    remarks = [diagnostic(CHECKED_FOR_MACHINE_OF_FILE, file=file) for file in result.around]
    remarks += [note for remark in result.settings if (note := remark.note()) is not None]
    if options.machine is None and not result.settings and result.uses_default:
        folder: str | Text = result.machines[0] if len(result.machines) == 1 else _FOLDER
        remarks.append(diagnostic(CHECKED_FOR_DEMO_MACHINE, folder=folder))
    lines = [remark.render(options.language) for remark in remarks if selection.includes(remark)]
    return "".join(f"{line}\n" for line in (*lines, closing_line(result, options.language)))


def _show(text: str) -> None:
    show_at_the_end(lambda file: click.echo(text, file=file, nl=False))


def _exit_code(result: CheckResult, *, strict: bool) -> int:
    if not result.files:
        return EXIT_USAGE
    errors = result.count(Severity.ERROR) + (result.count(Severity.WARNING) if strict else 0)
    return EXIT_NC_ERROR if errors else EXIT_RAN
