# SPDX-License-Identifier: MIT
"""Comments that make a program a test -> expectations that no run could meet.

In: the inputs and expectations of each checked program, the machine, whether there is a PLC whose
variables the check does not know. Out: diagnostics about names that the machine does not have,
files that are not there, and firings in lines where no realtime cycle has a branch.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import NO_BRANCH_IN_LINE
from nctakt.project.project_file import find_project
from nctakt.project.run_settings import DEFAULT_PLC
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.testing.expectations import Expectation, Script
from nctakt.testing.named_files import missing_files

#: Names that only the machine has, whichever PLC it is connected to.
_OF_MACHINE = re.compile(r"(CH\d+\.)?V\.", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class ScriptedProgram:
    """A program with its expected firings, the lines of its branches, and its calls."""

    path: Path
    firings: Sequence[Expectation]
    branch_lines: frozenset[int]
    called: Sequence[Path]
    is_complete: bool


def impossible_inputs(
    script: Script, program: Path, machine: AssembledMachine, access: FileAccess
) -> Iterator[Diagnostic]:
    """Yield the mistakes in files and names in the comments of a program.

    Names are not judged where the comments name another machine, files not for a text without a
    folder.
    """
    if program.is_file():
        yield from missing_files(script, program.parent, access)
    values = {**script.assignments, **{one.name: one.value for one in script.stimuli}}
    expected = [one for one in script.expectations if one.kind in ("value", "log")]
    if script.machine is not None or not (values or expected):
        return
    has_plc = _has_plc(script, program, access)
    for given in script.givens:
        if given.kind == "value" and (not has_plc or _OF_MACHINE.match(given.name)):
            try:
                machine.access.check(given.name, values[given.name])
            except Failure as failure:
                yield from _with_places(script, failure)
    signals = machine.signals()
    for one in expected:
        is_known = one.name in signals or f"{one.name}.ACS.ACT_POS" in signals
        if not is_known and (not has_plc or _OF_MACHINE.match(one.name)):
            yield from _with_places(script, Failure(machine.unknown_signal(one.name)))


def _with_places(script: Script, failure: Failure) -> Iterator[Diagnostic]:
    """Yield the findings with a place in the comments; the note about the machine comes once."""
    return (found for found in script.placed(failure).diagnostics if found.span is not None)


def _has_plc(script: Script, program: Path, access: FileAccess) -> bool:
    """Return whether there is a PLC or model whose variables are not known."""
    if any(name != DEFAULT_PLC for name in script.plcs):
        return True
    try:
        project = find_project(program, access)
    except Failure:  # reported with the choice of the program's machine
        return True
    if project is None:
        return False
    return project.fmu is not None or bool(project.plcs and not script.plcs)


def impossible_firings(programs: Sequence[ScriptedProgram]) -> Iterator[Diagnostic]:
    """Yield 900663 for each firing in a line where neither program nor called file has a branch.

    A line of a program that calls a missing file is not judged.
    """
    by_path = {one.path: one for one in programs}
    for program in programs:
        reached = _reached(program, by_path)
        if not program.firings or not all(one.is_complete for one in reached):
            continue
        lines = sorted(set[int]().union(*(one.branch_lines for one in reached)))
        known = ", ".join(map(str, lines)) or NOTHING
        for firing in program.firings:
            position = firing.position
            if firing.about not in lines and position is not None:
                yield diagnostic(
                    NO_BRANCH_IN_LINE,
                    position.span,
                    position.source_line,
                    line=firing.about,
                    known=known,
                )


def _reached(
    program: ScriptedProgram, by_path: Mapping[Path, ScriptedProgram]
) -> list[ScriptedProgram]:
    """Return a program and all files that it calls, also by others."""
    found: dict[Path, ScriptedProgram] = {program.path: program}
    waiting = [program]
    while waiting:
        for path in waiting.pop().called:
            if path in by_path and path not in found:
                found[path] = by_path[path]
                waiting.append(by_path[path])
    return list(found.values())
