# SPDX-License-Identifier: MIT
"""``--record`` and ``nctakt replay``: the words of a run to and from a tape.

In: the options of a run, a tape. Out: a writer for ``--record``; for ``replay`` the options of the
recorded run, and the changes since.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.cli.common.help import locale_language
from nctakt.cli.common.options import split_words
from nctakt.cli.common.request import STANDARD_INPUT, STANDARD_INPUT_NAME, Options, Request
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.tape import (
    REPLAY_AGREES,
    REPLAY_DIFFERS,
    REPLAY_NOT_COMPARED,
    TAPE_FILES_CHANGED,
)
from nctakt.project.project_file import OWN_NAME, PYTHON_NAME, project_around
from nctakt.run.access.tape import Tape, TapeComparison, TapeWriter, changed_files, name_on_tape
from nctakt.run.plcs.realtime_plc import has_called_plc, is_structured
from nctakt.run.program_loader import NcText
from nctakt.run.tape_words import KEPT, plcs_of, word_of_plcs, words_of

if TYPE_CHECKING:
    from nctakt.files.output import OutputFile


def start_tape(options: Options, request: Request, file: OutputFile) -> TapeWriter:
    """Return the writer of ``--record``."""
    words = {
        option.word: options.run[option.name]
        if option.name in options.run
        else getattr(options, option.word)
        for option in KEPT
    }
    words["programs"] = [_tape_word(program) for program in options.programs]
    words["others"] = [(number, _tape_word(program)) for number, program in options.others]
    programs = (*request.programs, *(one for own in request.channels.values() for one in own))
    texts = {one.name: one.text for one in programs if isinstance(one, NcText)}
    words["plc"] = word_of_plcs(options.plcs)
    has_plc = has_called_plc(request.plc)
    return TapeWriter(file.write, words, texts, has_plc)


def _tape_word(program: str) -> str:
    return STANDARD_INPUT_NAME if program == STANDARD_INPUT else program


def inputs_of_run(options: Options, access: FileAccess) -> Iterator[tuple[str, Path]]:
    """Yield the programs and lists that a run has read, each with its name on a tape."""
    for path in access.read_files:
        is_plc = str(path) in options.plcs and not is_structured(path)
        is_fmu = options.fmu is not None and path == options.fmu.file
        if path.name in (OWN_NAME, PYTHON_NAME) or is_plc or is_fmu:
            continue
        yield name_on_tape(path), path


def options_of(tape: Tape, name: str, words: Mapping[str, Any], access: FileAccess) -> Options:
    """Return the options of a recorded run with the words of ``replay``.

    Language and signals that are not named are those of its project; its other settings are on the
    tape. Raises ``Failure`` (901070) for a tape whose words do not belong to a run.
    """
    recorded = words_of(tape, name)
    names = [*recorded["programs"], *(program for _, program in recorded["others"])]
    project = project_around([one for one in names if one not in tape.texts], access)
    run, others = split_words({**recorded, **words})
    given = {
        **others,
        "run": run,
        "language": words["language"] or (project and project.language) or locale_language(),
        "project_signals": project and project.signals,
    }
    return Options(**given, plcs=plcs_of(tape), tape=tape)


def check_unchanged(tape: Tape, access: FileAccess, *, anyway: bool) -> list[Diagnostic]:
    """Return a warning (901073) for changed files with ``--anyway``, else raise ``Failure``.

    Raises ``Failure`` (902024) as well for files that ``access`` does not admit.
    """
    changed = changed_files(tape, access)
    if not changed:
        return []
    found = diagnostic(TAPE_FILES_CHANGED, files=", ".join(changed))
    if not anyway:
        raise Failure(found)
    return [replace(found, is_lenient=True)]


def verdict(comparison: TapeComparison | None, ticks: int, cycle_time_us: int) -> Diagnostic:
    """Return whether the events were those of the tape, and the first difference (901074).

    ``None``: the tape has none to compare with (901531).
    """
    if comparison is None:
        return diagnostic(REPLAY_NOT_COMPARED, ticks=ticks)
    if comparison.first is None:
        return diagnostic(REPLAY_AGREES, ticks=ticks)
    tick, events = comparison.first
    time = str(Time(tick * cycle_time_us))
    return diagnostic(REPLAY_DIFFERS, tick=tick, time=time, events=events or NOTHING)
