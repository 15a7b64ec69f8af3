# SPDX-License-Identifier: MIT
"""``nctakt replay``: a recorded run again, from its inputs, without the PLC.

In: a tape of ``nctakt run --record``, files to write. Out: what ``nctakt run`` tells, byte for
byte, and whether the events were the same. Exit codes as ``nctakt run``; 1 also where they were
not.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_USAGE
from nctakt.cli.file_options import file_access
from nctakt.cli.language import language_option
from nctakt.cli.plotting import with_drawing_options
from nctakt.cli.run import run_with
from nctakt.cli.running import FORMAT_OPTION
from nctakt.cli.terminal import print_diagnostics
from nctakt.files.access import FileAccess

_EPILOG = """\b
A replay runs in the folder in which the run was recorded. A tape reaches the
files of its own folder; --root names others.
Exit codes: 0 it ran and the events were the recorded ones, 1 an NC error,
interrupted by Ctrl-C or other events, 2 wrong usage or unusable input, 3 an
error of nctakt's own.

\b
  nctakt run part.nc --plc cell.py --record run.tape
  nctakt replay run.tape --trace out.csv
"""


@click.command("replay", epilog=_EPILOG, short_help="Repeat a recorded run without its PLC.")
@click.argument("tape", metavar="TAPE")
@click.option(
    "--anyway", is_flag=True, help="Replay although programs or lists have changed since."
)
@FORMAT_OPTION
@click.option("--trace", metavar="FILE", help="Record each tick: .csv, .jsonl or .parquet.")
@click.option("--signals", metavar="NAME,...", help="The signals to record and to draw.")
@with_drawing_options
@click.option("--diagnosis", metavar="FILE", help="Write the realtime cycles' diagnosis data.")
@click.option("--messages", metavar="FILE", help="Write the programs' messages to a file as well.")
@click.option("--error-log", metavar="FILE", help="Write the user errors (#ERROR) to a file.")
@click.option(
    "--root",
    "--confine",
    "confined",
    metavar="DIR",
    multiple=True,
    type=click.Path(exists=True, file_okay=False),
    help="Folder whose files the tape may name; may be repeated [default: the tape's].",
)
@language_option("Language of diagnostics, summary and diagnosis data [default: en].", None)
@click.option("--quiet", is_flag=True, help="No summary and no notes.")
@click.option(
    "--compiled/--plain",
    default=None,
    help="The realtime part compiled or as plain Python [default: compiled where it is built].",
)
def command(tape: str, anyway: bool, **words: Any) -> int:
    """Repeat a run that nctakt run --record has recorded."""
    language: Language = words["language"] or "en"
    try:
        return _replay(tape, anyway, words)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _replay(name: str, anyway: bool, words: dict[str, Any]) -> int:
    """Read the tape and run; raises ``Failure`` for what cannot be used."""
    from nctakt.base import mode  # noqa: PLC0415 - the mode is chosen before the imports below

    if words["compiled"] is False:
        mode.use_plain()
    from nctakt.cli.tapes import check_unchanged, options_of  # noqa: PLC0415 - as above
    from nctakt.run.tape import path_of, read_tape  # noqa: PLC0415

    words["confined"] = words["confined"] or (str(Path(name).parent),)
    access, of_tape = file_access(words["confined"]), FileAccess()
    tape = read_tape(Path(name), of_tape)
    access.note_all(of_tape)
    changed = check_unchanged(tape, access, anyway=anyway)
    for list_name, text in tape.lists.items():
        access.replace(path_of(list_name), text.encode("utf-8"))
    options = options_of(tape, name, words, access)
    print_diagnostics(changed, options.language)
    return run_with(options, access)
