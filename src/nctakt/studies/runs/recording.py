# SPDX-License-Identifier: MIT
"""A run of a study in a file that shows it again: a tape, or a list and a load.

In: a runner and the values of a run. Out: files, and the command that shows the run from them. A
tape has the whole run, including everything for which ``nctakt run`` has no option: actions of the
PLC, parameters that the lists do not have, other numbers in the program.
"""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Language
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile, write_file
from nctakt.project.project_file import OWN_NAME, PYTHON_NAME
from nctakt.run.access.tape import TapeWriter, name_on_tape
from nctakt.run.options import merged
from nctakt.run.plcs.realtime_plc import is_structured
from nctakt.run.tape_words import word_of_plcs, words_of_run
from nctakt.studies.plans.changed_lists import changed_texts
from nctakt.studies.plans.changed_schedule import ScheduleFiles
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.inputs import RunInputs, inputs_of
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.schedule_runner import DURATION, ScheduleRunner
from nctakt.studies.runs.study_runner import StudyRunner

#: The load of a recorded run whose plan has none.
_LOAD = Path("load.toml")


def record_run(runner: StudyRunner, point: Sequence[Value], path: Path) -> str:
    """Write the files of a run; return the command that shows it.

    ``path``: of the tape; list and load of a schedule are next to it, with their own suffixes.
    Raises ``Failure`` like the run, and for files that cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    if isinstance(runner, ScheduleRunner):
        return _write_schedule(runner, point, path)
    inputs = inputs_of(runner.plan, point, runner.cycle_time_us)
    with OutputFile(path, "--record", _inputs(runner)) as file:
        tape = TapeWriter(
            file.write,
            _words(runner.plan, inputs),
            _texts(runner, inputs),
            bool(inputs.faults) or not all(map(is_structured, runner.plan.plcs)),
            _lists(runner, inputs),
        )
        run = runner.begin(inputs, tape=tape).finish().outcome.run
        tape.finish(run.state, run.ticks, _files(runner))
    return shlex.join(["nctakt", "replay", str(path), *_roots(path, _files(runner))])


def picture_of_run(runner: StudyRunner, point: Sequence[Value], language: Language) -> bytes | None:
    """Return a picture of a run as the bytes of a PNG file; raises ``Failure`` like the run.

    ``None`` for a schedule, and without matplotlib.
    """
    if isinstance(runner, ScheduleRunner):
        return None
    inputs = inputs_of(runner.plan, point, runner.cycle_time_us)
    run = runner.begin(inputs, blocks=True, why=True, draws=True).finish().outcome.run
    return None if run.drawer is None else run.drawer().png(run, language)


def _roots(tape: Path, files: Mapping[str, Path]) -> list[str]:
    """Return the options that let a tape reach its files where they are not in its folder."""
    access = FileAccess([tape.parent])
    outside = [file for file in files.values() if not access.admits(file)]
    if not outside:
        return []
    working_folder = FileAccess(["."])
    folders = (
        ["."]
        if all(map(working_folder.admits, (tape, *outside)))
        else [*dict.fromkeys(str(file.parent) for file in (*outside, tape))]
    )
    return [word for folder in folders for word in ("--root", folder)]


def _inputs(runner: StudyRunner) -> FileAccess:
    """Return the files of a study, which no run may overwrite."""
    access, plan = FileAccess(), runner.plan
    access.note_all(runner.access)
    for path in plan.files:
        access.note(path)
    return access


def _write_schedule(runner: ScheduleRunner, point: Sequence[Value], path: Path) -> str:
    plan = runner.plan
    text, load = runner.texts(point)
    words = ["nctakt", "schedule", "simulate", str(path.with_suffix(".lis"))]
    access = _inputs(runner)
    write_file(words[-1], text, "--record", access)
    if load is not None:
        words += ["--load", str(path.with_suffix(".toml"))]
        write_file(words[-1], load, "--record", access)
    words += ["--os", plan.system, "--duration", str(plan.until or DURATION).replace(" ", "")]
    return shlex.join(words)


def _words(plan: Plan, inputs: RunInputs) -> dict[str, Any]:
    """Return the options of the run, as ``nctakt run`` has them."""
    changes = inputs.schedule
    load = changes.load or plan.load or (_LOAD if changes.entries else None)
    words = words_of_run(
        merged(plan.options, {"set": inputs.assignments}),
        programs=[str(plan.program)],
        others=[],
        machine=None if plan.machine is None else str(plan.machine),
        rtconf=None if plan.rtconf is None else str(changes.rtconf or plan.rtconf),
        load=None if load is None else str(load),
        system=None if plan.rtconf is None else plan.system,
        confined=[],
    )
    return {**words, "plc": word_of_plcs(list(map(str, plan.plcs)))}


def _texts(runner: StudyRunner, inputs: RunInputs) -> dict[str, str]:
    """Return the program if it is not that of its file."""
    if runner.plan.text is None and not inputs.program_variables:
        return {}
    return {str(runner.plan.program): runner.text_with(inputs.program_variables)}


def _lists(runner: StudyRunner, inputs: RunInputs) -> dict[str, str]:
    """Return the lists that are not those of their files."""
    lists = changed_texts(runner.machine, inputs.parameters)
    changes, plan = inputs.schedule, runner.plan
    if plan.rtconf is not None and (changes.parameters or changes.entries):
        files = ScheduleFiles(plan.rtconf, plan.load, plan.system)
        text, load = files.texts(changes, runner.access)
        lists[changes.rtconf or plan.rtconf] = text
        if load is not None:
            lists[changes.load or plan.load or _LOAD] = load
    return {name_on_tape(path): text for path, text in lists.items()}


def _files(runner: StudyRunner) -> dict[str, Path]:
    """Return the programs and lists that the run has read, by their names on a tape."""
    own = (OWN_NAME, PYTHON_NAME)
    called = [path for path in runner.plan.plcs if not is_structured(path)]
    files = [path for path in runner.access.read_files if path.name not in own]
    return {name_on_tape(path): path for path in files if path not in called}
