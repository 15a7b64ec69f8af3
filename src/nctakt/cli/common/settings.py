# SPDX-License-Identifier: MIT
"""Completes the words of a command: missing ones come from environment and project file.

In: the words as click gives them. Out: ``Options`` with machine, PLC and language, and the exit
code of the command that is carried out with them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_USAGE
from nctakt.cli.common.file_options import file_access
from nctakt.cli.common.help import locale_language
from nctakt.cli.common.options import split_words
from nctakt.cli.common.request import STANDARD_INPUT, Options
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import FMU_NOT_RUN, PLC_NOT_RUN
from nctakt.project.run_settings import FmuUse, Named, RunSettings, run_settings
from nctakt.run.access.stimuli import assignment_text


def carry_out(
    words: dict[str, Any],
    action: Callable[[Options, FileAccess], int],
    *,
    runs_code: bool = True,
    fmu_use: FmuUse | None = None,
) -> int:
    """Carry out a command that runs programs; its exit code. A ``Failure`` is shown.

    ``runs_code``: also the project's PLC; without it only one named by the words. ``fmu_use``: use
    of the project's FMU, by default according to the command's options.
    """
    paths = [*words["programs"], *(program for _, program in words["others"])]
    return maybe_watched(
        words,
        paths,
        lambda access: _carry_out(words, action, access, runs_code=runs_code, fmu_use=fmu_use),
    )


def maybe_watched(
    words: dict[str, Any], paths: Sequence[str], carry_out: Callable[[FileAccess], int]
) -> int:
    """Carry out a command, with ``--watch`` again and again; its exit code."""

    def open_access() -> FileAccess:
        return file_access(words["confined"])

    if not words.pop("watch", False):
        return carry_out(open_access())
    from nctakt.cli.common.watching import watch  # noqa: PLC0415 - seldom needed

    language: Language = words["language"] or locale_language()
    try:
        return watch(carry_out, open_access, paths, language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _carry_out(
    words: dict[str, Any],
    action: Callable[[Options, FileAccess], int],
    access: FileAccess,
    *,
    runs_code: bool,
    fmu_use: FmuUse | None,
) -> int:
    language: Language = words["language"] or locale_language()
    settings: RunSettings | None = None
    try:
        settings = _settings(words, access, fmu_use, runs_code=runs_code)
        options = _completed(words, settings)
        language = options.language
        project = settings.project
        if not (runs_code or words["plc"] or words["quiet"]) and project and project.plcs:
            files = ", ".join(map(str, project.plcs))
            print_diagnostics([diagnostic(PLC_NOT_RUN, plc=files)], language)
        fmu = None if runs_code or settings.fmu or project is None else project.fmu
        if fmu is not None and fmu.file is not None and not words["quiet"]:
            print_diagnostics([diagnostic(FMU_NOT_RUN, fmu=str(fmu.file))], language)
        return action(options, access)
    except Failure as failure:
        found = failure if settings is None else settings.placed(failure)
        print_diagnostics(found.diagnostics, language)
        return EXIT_USAGE


def _settings(
    words: dict[str, Any],
    access: FileAccess,
    fmu_use: FmuUse | None,
    *,
    runs_code: bool,
) -> RunSettings:
    """Return the settings of the words; raises ``Failure`` where these are wrong."""
    if fmu_use is None:
        fmu_use = ("run" if runs_code else "leave_out") if "fmu" in words else "refuse"
    programs = [*words["programs"], *(program for _, program in words["others"])]
    files = [Path(program) for program in programs if program != STANDARD_INPUT]
    named = Named(
        machine=words["machine"],
        plcs=words["plc"],
        has_plc=words.get("hli") is not None or not runs_code,
        fmu=words.get("fmu"),
        fmu_use=fmu_use,
        isolates=words.pop("isolates", False),
        values=[text.partition("=")[0].strip() for text in words["assignments"]],
        until=words.get("until"),
        is_limited=words.get("ticks") is not None,
    )
    return run_settings(files, access, named)


def _completed(words: dict[str, Any], settings: RunSettings) -> Options:
    """Return the words with the settings."""
    run, others = split_words(words)
    del others["plc"]
    run["set"] = (
        *(assignment_text(*one) for one in settings.values.items()),
        *run["set"],
    )
    if "until" in words:
        run["until"] = None if settings.until is None else str(settings.until)
    given = {
        **others,
        "run": run,
        "language": words["language"] or settings.language or locale_language(),
        "plcs": tuple(map(str, settings.plcs)),
        "fmu": settings.fmu,
        "machine_note": settings.machine_note,
        "project_signals": settings.signals,
    }
    if words["machine"] is None and settings.machine is not None:
        given["machine"] = str(settings.machine)
    return Options(**given)
