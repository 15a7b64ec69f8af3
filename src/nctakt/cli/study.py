# SPDX-License-Identifier: MIT
"""``nctakt study``: many runs of one program, each measured and checked.

In: a plan (TOML), or a program with ``--each-tick`` and ``--expect``. Out: on standard output how
many runs met the expectations, the span of each measure, the failed runs with the command that
makes each of them, the strip of an each-tick study; with ``--out`` a file with a row per run. Exit
codes: 0 all runs met all expectations, 1 some did not or Ctrl-C, 2 wrong usage.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, locale_language, option
from nctakt.cli.common.options import TRUST_OPTION, table_options
from nctakt.cli.common.terminal import complain_notes, print_diagnostics
from nctakt.run.options import RunOption, accepted_by

if TYPE_CHECKING:
    from nctakt.studies.rows.folder_store import FolderStore
    from nctakt.studies.rows.results import Part, StreamedRows
    from nctakt.studies.rows.row_store import RowStore
    from nctakt.studies.searching.search_runs import SearchRuns
    from nctakt.studies.study import Study, StudyResult

_T = TypeVar("_T")

#: Ending of the file with the rows while they are made, after the name of the results.
ROWS = ".rows"

#: The run options of a program without a plan; in a plan they are entries.
_OF_PROGRAM = tuple(row for row in accepted_by("study") if "plan" in row.front_ends)


@described(
    "study",
    summary=Text(
        "Make many runs of a program and check each.",
        "Viele Läufe eines Programms ausführen und prüfen.",
    ),
    text=Text(
        "Make the runs of a plan, or inject a value at each tick of a program. "
        '"report PLAN RESULTS" makes the page of --report of runs that are finished.',
        "Die Läufe eines Plans ausführen oder in jedem Takt eines Programms einen Wert "
        'einspielen. "report PLAN ERGEBNISSE" erzeugt die Seite von --report aus fertigen '
        "Läufen.",
    ),
    codes=(
        Text("all runs met all expectations", "alle Läufe erfüllten alle Erwartungen"),
        Text("some did not, or Ctrl-C", "einige nicht, oder Strg-C"),
    ),
    examples=(
        "nctakt study plan.toml --out results.parquet",
        "nctakt study plan.toml --out results.parquet --resume",
        "nctakt study report plan.toml results.parquet --report results.html",
        "nctakt study plan.toml --part 3/10 --out results",
        "nctakt study plan.toml --cover --sample 2000 --corpus plan.corpus",
        'nctakt study part.nc --set V.E.LIMIT=5 --each-tick "V.E.STOP=1 for 20 ms" \\',
        '    --expect "Z.ACS.ACT_POS < 50 within 100 ms"',
    ),
)
@click.argument("files", metavar="FILE", nargs=-1, required=True)
@option(
    "--each-tick",
    metavar="NAME=VALUE",
    text=Text(
        "Inject a value at each tick of the run.", "In jedem Takt des Laufs einen Wert einspielen."
    ),
)
@option(
    "--expect",
    multiple=True,
    metavar="TEXT",
    text=Text("Expect this of each run.", "Dies von jedem Lauf erwarten."),
)
@table_options("study")
@TRUST_OPTION
@option(
    "--out",
    metavar="FILE",
    group="files",
    text=Text(
        "Write a row per run: .parquet, .csv or .jsonl.",
        "Eine Zeile je Lauf schreiben: .parquet, .csv oder .jsonl.",
    ),
)
@option(
    "--report",
    metavar="FILE",
    group="files",
    text=Text(
        "Write a page (.html) with pictures of the results.",
        "Eine Seite (.html) mit Bildern der Ergebnisse schreiben.",
    ),
)
@option(
    "--resume",
    is_flag=True,
    group="files",
    text=Text(
        "Make only the runs that --out does not have yet.",
        "Nur die Läufe ausführen, die --out noch nicht hat.",
    ),
)
@option(
    "-j",
    "--processes",
    type=click.IntRange(1),
    metavar="N",
    text=Text(
        "How many processes make runs [default: one per core].",
        "Wie viele Prozesse Läufe ausführen [Vorgabe: einer je Kern].",
    ),
)
@option(
    "--scheduler",
    metavar="ADDRESS",
    text=Text(
        "Make the runs on a Dask cluster: tcp://…",
        "Die Läufe auf einem Dask-Cluster ausführen: tcp://…",
    ),
)
@option(
    "--upload",
    multiple=True,
    metavar="FILE",
    text=Text(
        "Send a module, a wheel (.whl) or another file to the workers of --scheduler.",
        "Ein Modul, ein Wheel (.whl) oder eine andere Datei an die Worker von --scheduler senden.",
    ),
)
@option(
    "--sample",
    type=click.IntRange(1),
    metavar="N",
    text=Text("Choose points at random.", "Punkte zufällig wählen."),
)
@option(
    "--only",
    type=click.IntRange(0),
    metavar="N",
    text=Text("Make only this run, counted from 0.", "Nur diesen Lauf ausführen, ab 0 gezählt."),
)
@option(
    "--part",
    metavar="I/N",
    text=Text(
        "Make the runs of part I of N; --out is the folder for its file.",
        "Die Läufe von Teil I von N ausführen; --out ist der Ordner für seine Datei.",
    ),
)
@option(
    "--record",
    metavar="FOLDER",
    group="files",
    text=Text(
        "Write a tape of each failed run, at most 100, for nctakt replay.",
        "Ein Band jedes nicht bestandenen Laufs schreiben, höchstens 100, für replay.",
    ),
)
@option(
    "--cover",
    is_flag=True,
    text=Text(
        "Look for inputs until every branch of a cycle has run.",
        "Eingaben suchen, bis jeder Zweig eines Zyklus gelaufen ist.",
    ),
)
@option(
    "--corpus",
    metavar="FILE",
    group="files",
    text=Text(
        "With --cover: begin with the inputs of this file, and add those that were good.",
        "Mit --cover: mit den Eingaben dieser Datei beginnen und die guten ergänzen.",
    ),
)
@option(
    "--shrink",
    is_flag=True,
    text=Text(
        "Find the smallest change that makes a run fail.",
        "Die kleinste Änderung finden, mit der ein Lauf nicht besteht.",
    ),
)
@option(
    "--yes",
    is_flag=True,
    text=Text(
        "Start even what takes more than an hour.",
        "Auch beginnen, was mehr als eine Stunde dauert.",
    ),
)
def command(files: tuple[str, ...], **words: Any) -> int:
    """Make runs."""
    if len(files) != 1 and (files[0] != "report" or len(files) != 3):
        raise click.UsageError("one plan or program, or: report PLAN RESULTS")
    try:
        words["language"] = words["language"] or _language_of_project(files[-2:])
        return _study(files[0], words) if len(files) == 1 else _report(*files[1:], words)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, words["language"] or locale_language())
        return EXIT_USAGE


def _language_of_project(files: Sequence[str]) -> Language:
    """Return the language of the project around a plan or a program; raises ``Failure``."""
    from nctakt.files.access import FileAccess  # noqa: PLC0415 - as below
    from nctakt.project.project_file import project_around  # noqa: PLC0415

    project = project_around(files, FileAccess())
    return (project and project.language) or locale_language()


def _study(file: str, words: dict[str, Any]) -> int:
    """Make the runs; raises ``Failure`` for unusable inputs."""
    from nctakt.cli.results.study_progress import StudyProgress  # noqa: PLC0415 - needs the controller

    _check_words(file, words)
    part = _part(words)
    study = _read(file, words)
    if words["cover"] and study.plan.is_schedule:
        raise click.UsageError("--cover needs a program: a schedule has no realtime cycles")
    finds = bool(study.plan.goals) and words["only"] is None
    if words["cover"]:
        _refuse(words, "--cover searches", ("part", "shrink"))
    elif finds:
        _refuse(words, "a plan with find searches", ("part", "shrink"))
    if part is not None:
        _make_folder(Path(words["out"]).parent)
    _check_files(study, file, words)
    _report_unchanged(study, words)
    if words["cover"]:
        return _cover(study, words)
    if finds:
        return _find(study, file, words)
    size, only = study.plan.size, words["only"]
    if only is not None and only >= size:
        raise click.UsageError(f"--only: the study has the runs 0 to {size - 1}")
    numbers = range(size) if only is None else range(only, only + 1)
    numbers = numbers if part is None else part.runs(size)
    due = numbers.stop - numbers.start  # more than len() can count
    count = min(words["processes"] or os.cpu_count() or 1, max(due // 20, 1))
    progress = StudyProgress(
        due,
        is_shown=not words["quiet"] and sys.stderr.isatty(),
        language=words["language"],
    )
    if not words["yes"]:
        progress.check_size(study, count)
    store = None if words["out"] is None else _results(study, words)
    try:
        result = study.run(
            processes=count,
            numbers=numbers,
            store=store,
            executor=_executor(words, store),
            on_rows=progress.add,
        )
        progress.close()
        if words["out"] is not None and not _is_folder(words):
            result.save(words["out"], is_part=part is not None)
        _show(study, result, file, words)
        print_diagnostics(progress.crashed(), words["language"])
        is_met = bool(result)
    except (KeyboardInterrupt, Failure) as error:
        progress.close()
        return _interrupted(error, due, store, words)
    if store is not None:
        store.remove()
    return EXIT_RAN if is_met else EXIT_NC_ERROR


def _show(study: Study, result: StudyResult, file: str, words: dict[str, Any]) -> None:
    """Show the summary, with ``--shrink`` the smallest change that breaks a run; write the report.

    Raises ``Failure`` for files that cannot be written.
    """
    from nctakt.cli.results.study_commands import commands_of, picture_of  # noqa: PLC0415 - as above
    from nctakt.cli.results.study_summary import shrunk_lines, summary  # noqa: PLC0415 - as above

    commands = commands_of(study, result, file, words)
    repeated = study.without_shown_effect(result)
    if words["report"] is not None:
        from nctakt.files.output import write_file  # noqa: PLC0415 - few studies have one

        page = result.report(words["language"], commands, picture_of(study, words), repeated)
        write_file(words["report"], page)
    for line in summary(study, result, file, commands, words["language"]):
        click.echo(line)
    _report_without_effect(result.without_effect, words)
    _report_no_effect_shown(repeated, words)
    if words["shrink"] and result.first_broken(1):
        for line in shrunk_lines(study, result, words["language"]):
            click.echo(line)


def _report_unchanged(study: Study, words: dict[str, Any]) -> None:
    """Warn of an unchanged run that fails already (901942)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - as above
    from nctakt.messages.commands.studies import UNCHANGED_RUN_BROKEN  # noqa: PLC0415

    if study.nominal is not None and study.nominal.broken:
        found = diagnostic(UNCHANGED_RUN_BROKEN, broken=study.nominal.broken)
        print_diagnostics([found], words["language"])


def _report_without_effect(names: Sequence[str], words: dict[str, Any]) -> None:
    """Warn of dimensions that changed nothing (901941)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - as above
    from nctakt.messages.commands.studies import DIMENSION_WITHOUT_EFFECT  # noqa: PLC0415

    found = [diagnostic(DIMENSION_WITHOUT_EFFECT, name=name) for name in names]
    print_diagnostics(found, words["language"])


def _report_no_effect_shown(repeated: Sequence[tuple[str, int]], words: dict[str, Any]) -> None:
    """Warn of dimensions of random points that changed nothing where that was tried (902061)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - as above
    from nctakt.messages.commands.studies import NO_EFFECT_SHOWN  # noqa: PLC0415

    found = [diagnostic(NO_EFFECT_SHOWN, name=name, count=count) for name, count in repeated]
    print_diagnostics(found, words["language"])


def _part(words: dict[str, Any]) -> Part | None:
    """Return the requested part, whose file is then ``--out``.

    Raises ``click.UsageError`` for a wrong one.
    """
    if words["part"] is None:
        return None
    from nctakt.studies.rows.results import SUFFIXES, parse_part  # noqa: PLC0415

    part = parse_part(words["part"])
    if part is None:
        raise click.UsageError("--part: I/N, as 3/10; I from 1 to N")
    if words["only"] is not None:
        raise click.UsageError("--part and --only: both say which runs are made")
    if words["out"] is None or Path(words["out"]).suffix in SUFFIXES:
        raise click.UsageError("--part needs --out FOLDER, into which each part writes its file")
    words["out"] = str(part.file(Path(words["out"])))
    return part


def _make_folder(path: Path) -> None:
    """Make the folder of a part; raises ``Failure`` (900507)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - as above
    from nctakt.messages.files import FILE_NOT_WRITABLE  # noqa: PLC0415

    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or str(error)
        found = diagnostic(FILE_NOT_WRITABLE, file=path.as_posix(), reason=reason)
        raise Failure(found) from error


def _check_words(file: str, words: dict[str, Any]) -> None:
    """Raise ``click.UsageError`` for options that would have no effect."""
    if words["resume"] and words["out"] is None:
        raise click.UsageError("--resume needs --out, with the results to continue from")
    if words["upload"] and words["scheduler"] is None:
        raise click.UsageError("--upload needs --scheduler: this machine has the files")
    if words["corpus"] is not None and not words["cover"]:
        raise click.UsageError("--corpus needs --cover: it keeps the inputs that reach branches")
    if not _is_plan(file):
        return
    given = {"--each-tick": words["each_tick"], "--expect": words["expect"]}
    given |= {row.option: words[row.word] for row in _OF_PROGRAM}
    for name, value in given.items():
        if value:
            raise click.UsageError(f"{name} belongs to a program; a plan has it as an entry")


def _refuse(words: dict[str, Any], reason: str, names: Sequence[str]) -> None:
    """Raise ``click.UsageError`` for options that would have no effect."""
    for name in names:
        if words[name]:
            raise click.UsageError(f"{reason}: --{name} would have no effect")


def _check_files(study: Study, file: str, words: dict[str, Any]) -> None:
    """Check the outputs; raises ``Failure`` as ``_check_outputs``."""
    outputs = {name: words[name] for name in ("out", "report", "corpus")}
    if _is_folder(words):
        outputs["out"] = None  # its parts have their own names
    _check_outputs(study, [file], outputs)


def _check_outputs(study: Study, inputs: list[str], outputs: dict[str, str | None]) -> None:
    """Raise ``Failure`` before any run for outputs that are inputs or cannot be written."""
    from nctakt.files.access import FileAccess  # noqa: PLC0415 - as above
    from nctakt.files.output import check_outputs  # noqa: PLC0415 - as above
    from nctakt.studies.runs.plan_files import files_of  # noqa: PLC0415 - as above

    named = {f"--{option}": name for option, name in outputs.items() if name is not None}
    if not named:
        return
    access, needed = FileAccess(), files_of(study.plan)
    for path in (*map(Path, inputs), *needed.files, *needed.modules.files):
        access.note(path)
    check_outputs(named, access)


def _is_plan(file: str) -> bool:
    return Path(file).suffix.casefold() == ".toml"


def _report(plan: str, results: str, words: dict[str, Any]) -> int:
    """Write the report of runs that are finished."""
    from nctakt.cli.results.study_commands import shown_rows  # noqa: PLC0415 - as above
    from nctakt.files.output import write_file  # noqa: PLC0415
    from nctakt.messages import diagnostic  # noqa: PLC0415
    from nctakt.messages.commands.studies import OTHER_PLAN  # noqa: PLC0415
    from nctakt.studies.rows.results import read_rows  # noqa: PLC0415
    from nctakt.studies.study import Study, StudyResult  # noqa: PLC0415

    study = Study(plan)
    rows: StreamedRows
    if "://" in results or Path(results, "_study.json").exists():
        from nctakt.studies.rows.part_folder import PartFolder, RowsOfFolder  # noqa: PLC0415

        rows = RowsOfFolder(PartFolder(results, study.plan, dict(study.runner.units)))
    else:
        is_folder = Path(results).is_dir()
        rows = _rows_of_parts(results, words) if is_folder else read_rows(Path(results))
    names = {dimension.name for dimension in study.plan.dimensions}
    names |= {measure.name for measure in study.plan.measures}
    if rows and not names <= set(rows[0]):
        raise Failure(diagnostic(OTHER_PLAN, folder=results))
    target = words["report"] or str(Path(results.rpartition("://")[2]).with_suffix(".html"))
    _check_outputs(study, [plan, results], {"report": target})
    result = StudyResult(study.plan, rows, study.nominal, study.runner.units)
    shown = shown_rows(study, result, plan, words)
    write_file(target, result.report(words["language"], shown.command, shown.picture))
    return EXIT_RAN


def _rows_of_parts(folder: str, words: dict[str, Any]) -> StreamedRows:
    """Return the rows of the parts in a folder; report missing ones (902535)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - as above
    from nctakt.messages.commands.studies import NO_PARTS, PARTS_MISSING  # noqa: PLC0415
    from nctakt.studies.rows.results import RowsOfParts  # noqa: PLC0415

    rows = RowsOfParts(Path(folder))
    if len(rows.counts) != 1:
        counts = ", ".join(map(str, rows.counts)) or "–"
        raise Failure(diagnostic(NO_PARTS, folder=folder, counts=counts))
    if rows.missing:
        names = ", ".join(map(str, rows.missing[:20]))
        found = diagnostic(PARTS_MISSING, folder=folder, names=names)
        print_diagnostics([found], words["language"])
    return rows


def _cover(study: Study, words: dict[str, Any]) -> int:
    """Show which branches the points of a plan reach; exit code 1 if they miss any."""
    from nctakt.cli.results.study_summary import cover_lines  # noqa: PLC0415 - as above
    from nctakt.messages import diagnostic  # noqa: PLC0415
    from nctakt.messages.commands.studies import IMPOSSIBLE_RUNS  # noqa: PLC0415

    budget = words["sample"] or len(study)
    reached = _search(study, words, budget, lambda runs: study.cover(budget, words["corpus"], runs))
    if isinstance(reached, int):
        return reached
    for line in cover_lines(study, reached, words["record"], words["language"]):
        click.echo(line)
    if reached.failed:
        found = diagnostic(IMPOSSIBLE_RUNS, count=reached.failed)
        print_diagnostics([*reached.failure, found], words["language"])
    return EXIT_RAN if reached.is_whole else EXIT_NC_ERROR


def _find(study: Study, file: str, words: dict[str, Any]) -> int:
    """Answer the goals of a plan; exit code 1 if one of them has no answer."""
    from nctakt.cli.results.study_summary import answer_lines  # noqa: PLC0415 - as above

    budget = sum(max(goal.budget, 1) for goal in study.plan.goals)
    answers = _search(study, words, budget, study.find)
    if isinstance(answers, int):
        return answers
    for answer in answers:
        for line in answer_lines(study, answer, file, words["record"], words["language"]):
            click.echo(line)
        if answer.finding is not None:
            print_diagnostics([answer.finding], words["language"])
        _report_without_effect(answer.without_effect, words)
    return EXIT_NC_ERROR if any(answer.finding for answer in answers) else EXIT_RAN


def _search(
    study: Study, words: dict[str, Any], budget: int, search: Callable[[SearchRuns], _T]
) -> _T | int:
    """Return the result of a search of at most ``budget`` runs, or the exit code if interrupted.

    Raises ``Failure`` as ``search_with_rows`` if no rows are kept.
    """
    from nctakt.cli.results.study_commands import search_with_rows  # noqa: PLC0415 - as above

    store = None if words["out"] is None else _results(study, words, searches=True)
    try:
        found = search_with_rows(study, store, words, search)
    except (KeyboardInterrupt, Failure) as error:
        return _interrupted(error, budget, store, words)
    if store is not None:
        store.remove()
    return found


def _executor(words: dict[str, Any], store: RowStore | FolderStore | None) -> Any:
    """Return the maker of runs on a cluster; ``None``: this machine."""
    address = words["scheduler"]
    if address is None:
        return None
    from nctakt.studies.workers.cluster import rows_of_cluster  # noqa: PLC0415 - as above

    uploads = [Path(name) for name in words["upload"]]
    writer = None if store is None else store.folder
    return lambda plan, numbers: rows_of_cluster(plan, numbers, address, uploads, writer)


def _interrupted(
    error: KeyboardInterrupt | Failure,
    size: int,
    store: RowStore | FolderStore | None,
    words: dict[str, Any],
) -> int:
    """Say why a study has ended early, and how many runs are kept; raise if there are none."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - few studies are interrupted
    from nctakt.messages.commands.studies import STUDY_INTERRUPTED  # noqa: PLC0415

    if store is None:
        raise error
    store.close()
    found = diagnostic(STUDY_INTERRUPTED, count=len(store.done), size=size, folder=store.name)
    if isinstance(error, Failure):
        print_diagnostics([*error.diagnostics, found], words["language"])
        return EXIT_USAGE
    complain_notes(error)
    print_diagnostics([found], words["language"])
    return EXIT_NC_ERROR


def _is_folder(words: dict[str, Any]) -> bool:
    """Return whether ``--out`` names a folder of parts."""
    from nctakt.studies.rows.part_folder import is_folder  # noqa: PLC0415 - as above

    return words["out"] is not None and is_folder(words["out"])


def _results(
    study: Study, words: dict[str, Any], *, searches: bool = False
) -> RowStore | FolderStore:
    """Return the store for the rows of ``--out``."""
    purpose = "cover" if words["cover"] else ""
    if not _is_folder(words):
        return _store(study, words, purpose)
    from nctakt.studies.rows import folder_store  # noqa: PLC0415 - as above
    from nctakt.studies.rows.part_folder import PartFolder  # noqa: PLC0415

    units, covers = dict(study.runner.units), words["cover"]
    folder = PartFolder(words["out"], study.plan, units, covers=covers)
    return folder_store.FolderStore(
        folder,
        study.plan,
        resumes=words["resume"],
        purpose=purpose,
        gathered=folder_store.GATHERED_OF_SEARCH if searches else folder_store.GATHERED,
    )


def _store(study: Study, words: dict[str, Any], purpose: str) -> RowStore:
    from nctakt.studies.rows.results import check_target  # noqa: PLC0415 - as above
    from nctakt.studies.rows.row_store import RowStore  # noqa: PLC0415

    check_target(Path(words["out"]))
    path = Path(words["out"] + ROWS)
    return RowStore(path, study.plan, resumes=words["resume"], purpose=purpose)


def _entry(row: RunOption, words: Any) -> Any:
    """Return the entry of a plan that the words of an option say; raises ``Failure``."""
    match row.name:
        case "set":
            return row.kind.from_words(words)
        case "at":
            return [list(pair) for pair in words]
        case "skip":
            return list(row.kind.from_words(words))
    return words


def _read(file: str, words: dict[str, Any]) -> Study:
    """Return the study of a plan's file, or of a program with ``--each-tick``."""
    from nctakt.studies.study import Study  # noqa: PLC0415 - as above

    changes: dict[str, Any] = {}
    if words["sample"] is not None:
        changes = {"method": "random", "count": words["sample"]}
    if _is_plan(file):
        return Study(file, **changes)
    entries: dict[str, Any] = {"program": file, "expect": list(words["expect"]), **changes}
    entries |= {row.name: _entry(row, words[row.word]) for row in _OF_PROGRAM if words[row.word]}
    if words["each_tick"] is not None:
        from nctakt.studies.runs.each_tick import injection_table  # noqa: PLC0415 - as above

        entries["vary"] = [injection_table(words["each_tick"])]
    return Study(**entries)
