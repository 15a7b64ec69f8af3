# SPDX-License-Identifier: MIT
"""``--record`` and ``nctakt replay``: the words of a run to and from a tape.

In: the options of a run, a tape. Out: a writer for ``--record``; for ``replay`` the options of the
recorded run, and what has changed since.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.cli.request import Options, Request
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.tape import (
    INVALID_TAPE,
    REPLAY_AGREES,
    REPLAY_DIFFERS,
    TAPE_FILES_CHANGED,
)
from nctakt.project.project_file import OWN_NAME, PYTHON_NAME
from nctakt.run.program_loader import NcText
from nctakt.run.tape import Tape, TapeComparison, TapeWriter, digest_of

if TYPE_CHECKING:
    from nctakt.files.output import OutputFile

#: Prefix of the files of built-in machines on a tape.
_OWN_MARK = "nctakt:"
_OWN_FOLDER = Path(__file__).parent.parent

#: The options of a run that a tape keeps, and whether their value fits.
_WORDS: Mapping[str, Callable[[Any], bool]] = {
    "programs": lambda value: _is_list_of(value, str),
    "others": lambda value: (
        isinstance(value, list) and all(_is_list_of(one, str) and len(one) == 2 for one in value)
    ),
    "machine": lambda value: isinstance(value, str | None),
    "root": lambda value: isinstance(value, str | None),
    "assignments": lambda value: _is_list_of(value, str),
    "ticks": lambda value: isinstance(value, int | None) and not isinstance(value, bool),
    "until": lambda value: isinstance(value, str | None),
    "after": lambda value: isinstance(value, str),
    "skip": lambda value: isinstance(value, str),
    "wait_for_start": lambda value: isinstance(value, bool),
    "blocks": lambda value: isinstance(value, bool),
    "rtconf": lambda value: isinstance(value, str | None),
    "load": lambda value: isinstance(value, str | None),
    "system": lambda value: isinstance(value, str | None),
    "confined": lambda value: _is_list_of(value, str),
}


def _is_list_of(value: object, kind: type) -> bool:
    return isinstance(value, list) and all(isinstance(one, kind) for one in value)


def start_tape(options: Options, request: Request, file: OutputFile) -> TapeWriter:
    """Return the writer of ``--record``."""
    words = {name: getattr(options, name) for name in _WORDS}
    programs = (*request.programs, *(one for own in request.channels.values() for one in own))
    texts = [one.text for one in programs if isinstance(one, NcText)]
    return TapeWriter(file.write, words, texts[0] if texts else None, request.plc is not None)


def inputs_of_run(options: Options, access: FileAccess) -> Iterator[tuple[str, Path]]:
    """Yield the programs and lists that a run has read, each with its name on a tape."""
    for path in access.read_files:
        if path.name in (OWN_NAME, PYTHON_NAME) or str(path) == options.plc:
            continue
        absolute = path.absolute()
        if absolute.is_relative_to(_OWN_FOLDER):
            yield f"{_OWN_MARK}{absolute.relative_to(_OWN_FOLDER).as_posix()}", path
        else:
            yield path.as_posix(), path


def changed_files(tape: Tape) -> list[str]:
    """Return the files of a tape that are not as they were when it was recorded."""
    return [name for name, digest in tape.digests.items() if digest_of(_path(name)) != digest]


def _path(name: str) -> Path:
    if name.startswith(_OWN_MARK):
        return _OWN_FOLDER / name.removeprefix(_OWN_MARK)
    return Path(name)


def options_of(tape: Tape, name: str, words: Mapping[str, Any]) -> Options:
    """Return the options of a recorded run with the words of ``replay``.

    Raises ``Failure`` (901070) for a tape whose words are none of a run.
    """
    for key, fits in _WORDS.items():
        if not fits(tape.words.get(key, NOTHING_GIVEN)):
            raise Failure(diagnostic(INVALID_TAPE, reason=f"{name}: {key}"))
    recorded = {key: _immutable(tape.words[key]) for key in _WORDS}
    if tape.state not in ("ended", "error", "limit", "reset"):
        recorded["ticks"] = tape.ticks
    given = {**recorded, **words, "confined": (*recorded["confined"], *words["confined"])}
    return Options(**given, stimuli=(), plc=None, tape=tape)


#: Fits none of the options.
NOTHING_GIVEN = object()


def _immutable(value: Any) -> Any:
    return tuple(map(_immutable, value)) if isinstance(value, list) else value


def check_unchanged(tape: Tape, *, anyway: bool) -> list[Diagnostic]:
    """Return a warning (901073) for changed files with ``--anyway``, else raise ``Failure``."""
    changed = changed_files(tape)
    if not changed:
        return []
    found = diagnostic(TAPE_FILES_CHANGED, files=", ".join(changed))
    if not anyway:
        raise Failure(found)
    return [replace(found, is_lenient=True)]


def verdict(comparison: TapeComparison, ticks: int, cycle_time_us: int) -> Diagnostic:
    """Return whether the events were those of the tape, and the first difference (901074)."""
    if comparison.first is None:
        return diagnostic(REPLAY_AGREES, ticks=ticks)
    tick, events = comparison.first
    time = str(Time(tick * cycle_time_us))
    return diagnostic(REPLAY_DIFFERS, tick=tick, time=time, events=events or NOTHING)
