# SPDX-License-Identifier: MIT
"""A session <-> a tape: a session can be replayed, and a recorded run opened as a session.

In: the setup and the inputs of a branch, a path; or a tape. Out: the file that ``nctakt replay``
takes; or the setup of a session that has the tape's inputs and needs no PLC.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.tape import TAPE_CHANGES_LISTS, TAPE_FILES_CHANGED
from nctakt.messages.connections.session import TAPE_NEEDS_SCHEDULE
from nctakt.plc.loading import load_plcs
from nctakt.run.access.inputs import Input
from nctakt.run.access.tape import Tape, TapeWriter, changed_files, name_on_tape, read_tape
from nctakt.run.controller import Controller
from nctakt.run.options import RunKeywords
from nctakt.run.plcs.realtime_plc import is_structured
from nctakt.run.program_loader import NcText, name_of
from nctakt.run.tape_words import (
    options_of_words,
    plcs_of,
    word_of_plcs,
    words_of,
    words_of_run,
)
from nctakt.session.schedules import schedule_of_setup
from nctakt.session.setup import Setup


def save_tape(path: str | Path, setup: Setup, inputs: Sequence[Input], ticks: int) -> None:
    """Write the tape of a branch up to tick ``ticks``, for which its run is repeated.

    Raises ``Failure`` for a file that cannot be written.
    """
    access = FileAccess([Path(folder) for folder in setup.folders])
    has_plc = has_called_plc(setup)
    texts = {one.name: one.text for one in programs_of(setup) if isinstance(one, NcText)}
    for program in programs_of(setup):
        if not isinstance(program, NcText):
            access.note(program)
    controller = Controller(setup.machine, schedule_of_setup(setup, access), access)
    replayed = Tape({}, texts, has_plc, tuple(inputs), {}, ticks, "", {})
    with OutputFile(path, "tape", access) as file:
        writer = TapeWriter(file.write, words_of_setup(setup), texts, has_plc)
        options: RunKeywords = {
            **setup.options,
            "at": (),
            "signals": None,
            "ticks": ticks,
            "memory_trace": False,
            "blocks": True,
            "sinks": (writer,),
            "record": writer.note,
            "replay": replayed,
            "plc": load_plcs([one for one in setup.plcs if is_structured(one)]),
        }
        channels = {number: own for number, own in setup.programs.items() if number > 1}
        run = controller.run(*setup.programs.get(1, ()), channels=channels, **options)
        state = "interrupted" if run.state == "limit" else run.state
        files = {name_on_tape(one): one for one in access.read_files}
        writer.finish(state, controller.tick, files)


def programs_of(setup: Setup) -> list[str | Path | NcText]:
    """Return the programs of all channels."""
    return [program for own in setup.programs.values() for program in own]


def words_of_setup(setup: Setup) -> dict[str, Any]:
    """Return the words of the command that runs the same as the setup."""
    words = words_of_run(
        {**setup.options, "ticks": None, "blocks": True},
        programs=[name_of(program) for program in setup.programs.get(1, ())],
        others=[
            [str(number), name_of(program)]
            for number, own in setup.programs.items()
            if number > 1
            for program in own
        ],
        machine=None if setup.machine is None else str(setup.machine),
        rtconf=setup.rtconf,
        load=setup.load,
        system=setup.system,
        confined=[str(folder) for folder in setup.folders],
    )
    return {**words, "plc": word_of_plcs([str(one) for one in setup.plcs])}


def has_called_plc(setup: Setup) -> bool:
    """Return whether a PLC outside the tick acknowledges: a tape has its actions."""
    return not (setup.acknowledges and all(map(is_structured, setup.plcs)))


def read_setup(path: str | Path, folders: Sequence[str | Path] = (), *, anyway: bool) -> Setup:
    """Return the setup of the run on a tape; it has no PLC, but the PLC's inputs.

    It reaches the files in ``folders``, by default those of the folder of the tape. Raises
    ``Failure`` for a tape that cannot be read (901070 …), that names others (902024), that needs a
    schedule (901149), or whose programs or lists have changed (901073), unless it is to run
    ``anyway``.
    """
    folders = [Path(folder) for folder in folders]
    tape = read_tape(Path(path), FileAccess(folders))
    folders = folders or [Path(path).parent]
    words = words_of(tape, str(path))
    changed = changed_files(tape, FileAccess(folders))
    if changed and not anyway:
        raise Failure(diagnostic(TAPE_FILES_CHANGED, files=", ".join(changed)))
    plcs = plcs_of(tape)
    if tape.lists:
        raise Failure(diagnostic(TAPE_CHANGES_LISTS, files=", ".join(tape.lists)))
    if words["rtconf"] is not None:
        raise Failure(diagnostic(TAPE_NEEDS_SCHEDULE, list=words["rtconf"]))
    programs: dict[int, list[str | Path | NcText]] = {1: []}
    named = [(1, name) for name in words["programs"]]
    named += [(int(number), name) for number, name in words["others"]]
    for number, name in named:
        program = NcText(name, tape.texts[name]) if name in tape.texts else name
        programs.setdefault(number, []).append(program)
    return Setup(
        programs,
        words["machine"],
        acknowledges=not tape.has_plc,
        folders=folders,
        inputs=tape.inputs,
        is_replay=True,
        options=options_of_words(words),
        plc=plcs,
    )
