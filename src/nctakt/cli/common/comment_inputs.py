# SPDX-License-Identifier: MIT
"""Inputs in the comments of programs (``; given: …``), which count in tests only.

In: the programs of a command, its options. Out: for each program a note that says so, with the
options that give the same values.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.long_text import is_long
from nctakt.base.text import decode_text, split_lines
from nctakt.cli.common.request import Options, Request
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import GIVEN_IN_TESTS_ONLY
from nctakt.run.access.stimuli import assignment_text

if TYPE_CHECKING:
    from nctakt.testing.expectations import Script


def report_unused_inputs(options: Options, request: Request) -> None:
    """Show which values from comments the options do not give, unless asked to be quiet."""
    if not options.quiet:
        print_diagnostics(_unused_inputs(options, request), options.language)


def _unused_inputs(options: Options, request: Request) -> Iterator[Diagnostic]:
    """Yield a note for each program whose values from comments the options do not give."""
    if options.tape is not None or options.run["set"] or options.run["at"]:
        return
    programs = (*request.programs, *(one for many in request.channels.values() for one in many))
    for program in dict.fromkeys(one for one in programs if isinstance(one, Path)):
        script = _script_of(program)
        if script is not None and (words := _options(script)):
            count = len(script.assignments) + len(script.stimuli)
            yield diagnostic(
                GIVEN_IN_TESTS_ONLY, file=program, count=count, options=shlex.join(words)
            )


def _script_of(program: Path) -> Script | None:
    """Return the inputs in the comments of a program; ``None`` for one as long as CAM's."""
    if not program.is_file():
        return None
    with program.open("rb") as file:
        text = "" if is_long(file) else decode_text(file.read()).text
    if "given" not in text.lower():  # most programs: modules for tests are not loaded
        return None
    from nctakt.nc.source import Source  # noqa: PLC0415
    from nctakt.testing.expectations import is_script, parse_script  # noqa: PLC0415

    lines = split_lines(text)
    numbers = [number for number, line in enumerate(lines, 1) if is_script(line)]
    return parse_script(Source(str(program), lines), [], numbers)


def _options(script: Script) -> list[str]:
    """Return the options that give the values of the comments."""
    words = []
    for name, value in script.assignments.items():
        words += ["--set", assignment_text(name, value)]
    for stimulus in script.stimuli:
        time = str(stimulus.time).replace(" ", "")
        words += ["--at", time, assignment_text(stimulus.name, stimulus.value)]
    return words
