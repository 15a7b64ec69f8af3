# SPDX-License-Identifier: MIT
"""``nctakt new``: a machine folder to start from, or a machine's lists in the other format.

In: the name of a new or empty folder, a language, a format, optionally the folder of a machine.
Out: the lists of that machine or of the demo machine in the folder, each parameter explained in the
language; the next steps on standard output.
"""

from __future__ import annotations

import shlex
from pathlib import Path

import click

from nctakt.base.diagnostics import Language, Severity, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import language_option, table_option
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.new_folder import write_new_folder
from nctakt.lists.machine.files import ListSearch
from nctakt.lists.machine.machine import DEFAULT_CYCLE_TIME_US, load_machine
from nctakt.lists.writing.commented import commented_lists
from nctakt.lists.writing.conversion import Conversion, convert_lists
from nctakt.lists.writing.list_writer import ListFormat
from nctakt.lists.writing.xae_project import lists_of_project, project_in
from nctakt.messages import diagnostic
from nctakt.messages.machines.folders import (
    ENTRIES_AS_COMMENTS,
    LISTS_KEPT_IN_ASCII,
    LISTS_WRITTEN,
    PROJECT_LISTS_AS_THEY_ARE,
    PROJECT_TICK,
)
from nctakt.run.options import BY_NAME

#: Maximum number of entries without a form in XML in a message.
_NAMED_ENTRIES = 5


@described(
    "new",
    summary=Text(
        "Write a machine folder to start from.", "Einen Maschinenordner als Anfang schreiben."
    ),
    text=Text(
        "Write the lists of a machine with four axes and three spindles, with comments.",
        "Die Listen einer Maschine mit vier Achsen und drei Spindeln schreiben, mit Kommentaren.",
    ),
    codes=(Text("the lists are written", "die Listen sind geschrieben"), None),
    notes=Text(
        "Of a TwinCAT project the lists in the .tsproj itself are taken as they are; a CNC in .xti "
        "files is refused, and NC programs and rtconf.lis are not in a project.",
        "Aus einem TwinCAT-Projekt werden die Listen in der .tsproj selbst unverändert genommen; "
        "eine CNC in .xti-Dateien wird abgelehnt, NC-Programme und rtconf.lis sind nicht darin.",
    ),
    examples=(
        "nctakt new mymachine",
        "nctakt check mymachine",
        "nctakt run part.nc --machine mymachine",
        "nctakt new readable --from machine --format ascii",
        "nctakt new mill --from Project.tsproj",
    ),
)
@click.argument("folder", metavar="FOLDER")
@option(
    "--from",
    "--like",
    "source",
    metavar="FOLDER",
    text=Text(
        "Write the lists of this machine, of demo5, or of a TwinCAT project (.tsproj) instead.",
        "Stattdessen die Listen dieser Maschine, von demo5 oder eines TwinCAT-Projekts (.tsproj).",
    ),
)
@table_option(BY_NAME["root"])
@option(
    "--format",
    "list_format",
    type=click.Choice(["ascii", "xml"]),
    default="ascii",
    text=Text("Format of the lists [default: ascii].", "Form der Listen [Vorgabe: ascii]."),
)
@language_option()
@table_option(BY_NAME["quiet"])
def command(
    folder: str,
    source: str | None,
    root: str | None,
    list_format: ListFormat,
    language: Language,
    quiet: bool,
) -> int:
    """Write lists."""
    cycle_us: float | None = None
    try:
        if source is None:
            lists = commented_lists(language, list_format)
        elif (project := project_in(Path(source))) is not None:
            for said, is_given in (("--root", root), ("--format xml", list_format == "xml")):
                if is_given:
                    raise Failure(diagnostic(PROJECT_LISTS_AS_THEY_ARE, option=said))
            taken = lists_of_project(project, FileAccess())
            lists, cycle_us = taken.files, taken.cycle_us
        else:
            lists = _converted(source, root, Conversion(list_format, language))
        write_new_folder(Path(folder), lists)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE
    if quiet:
        return EXIT_RAN
    written = diagnostic(LISTS_WRITTEN, folder=shlex.quote(folder), count=len(lists))
    click.echo(written.text(language))
    click.echo(f"  {written.remedy(language)}")
    if cycle_us is not None and cycle_us != DEFAULT_CYCLE_TIME_US:
        tick = diagnostic(PROJECT_TICK, cycle=f"{cycle_us:g}", default=DEFAULT_CYCLE_TIME_US)
        print_diagnostics([tick], language)
    return EXIT_RAN


def _converted(source: str, root: str | None, conversion: Conversion) -> dict[str, bytes]:
    """Return the lists of the machine in ``source``; report its errors and omitted entries."""
    access = FileAccess()
    machine = load_machine(source, root=root, access=access)
    print_diagnostics(machine.diagnostics, conversion.language, Severity.ERROR)
    folder = Path(source) if Path(source).is_dir() else None
    search = ListSearch(machine.lists[0][1], access, folder, None if root is None else Path(root))
    lists = convert_lists(machine, search, access, conversion)
    if lists.unknown:
        names = ", ".join(lists.unknown[:_NAMED_ENTRIES])
        more = " …" if len(lists.unknown) > _NAMED_ENTRIES else ""
        warning = diagnostic(ENTRIES_AS_COMMENTS, count=len(lists.unknown), names=names + more)
        print_diagnostics([warning], conversion.language)
    if lists.in_ascii:
        note = diagnostic(LISTS_KEPT_IN_ASCII, files=", ".join(lists.in_ascii))
        print_diagnostics([note], conversion.language)
    return dict(lists.files)
