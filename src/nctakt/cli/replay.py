# SPDX-License-Identifier: MIT
"""``nctakt replay``: a recorded run again, from its inputs, without the PLC.

In: a tape of ``nctakt run --record``, files to write. Out: the output of ``nctakt run``, byte for
byte, and whether the events were the same. Exit codes as ``nctakt run``; 1 also where they were
not.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_USAGE
from nctakt.cli.common.file_options import file_access
from nctakt.cli.common.help import described, locale_language, option
from nctakt.cli.common.options import FORMAT_OPTION, MODE_OPTION, table_options, with_file_options
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.cli.run import run_with
from nctakt.files.access import FileAccess


@described(
    "replay",
    summary=Text(
        "Repeat a recorded run without its PLC.", "Einen aufgezeichneten Lauf ohne SPS wiederholen."
    ),
    text=Text(
        "Repeat a run that nctakt run --record has recorded.",
        "Einen Lauf wiederholen, den nctakt run --record aufgezeichnet hat.",
    ),
    codes=(
        Text(
            "it ran and the events were the recorded ones",
            "er lief, und die Ereignisse waren die aufgezeichneten",
        ),
        Text(
            "an NC error, other events, or Ctrl-C", "ein NC-Fehler, andere Ereignisse oder Strg-C"
        ),
    ),
    notes=Text(
        "A replay runs in the folder in which the run was recorded. A tape reaches the files of "
        "its own folder; --root names others.",
        "Eine Wiederholung läuft in dem Ordner, in dem der Lauf aufgezeichnet wurde. Ein Band "
        "erreicht die Dateien seines Ordners; --root nennt andere.",
    ),
    examples=(
        "nctakt run part.nc --plc cell.py --record run.tape",
        "nctakt replay run.tape --trace out.csv",
    ),
)
@click.argument("tape", metavar="TAPE")
@option(
    "--anyway",
    is_flag=True,
    text=Text(
        "Replay although programs or lists have changed since.",
        "Wiederholen, obwohl sich Programme oder Listen seitdem geändert haben.",
    ),
)
@FORMAT_OPTION
@table_options("replay")
@with_file_options
@option(
    "--root",
    "--confine",
    "confined",
    metavar="FOLDER",
    multiple=True,
    type=click.Path(exists=True, file_okay=False),
    text=Text(
        "Folder whose files the tape may name; may be repeated [default: the tape's].",
        "Ordner, dessen Dateien das Band nennen darf; mehrfach möglich [Vorgabe: der des Bands].",
    ),
)
@MODE_OPTION
def command(tape: str, anyway: bool, **words: Any) -> int:
    """Repeat a recorded run."""
    language: Language = words["language"] or locale_language()
    try:
        return _replay(tape, anyway, words)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _replay(name: str, anyway: bool, words: dict[str, Any]) -> int:
    """Read the tape and run; raises ``Failure`` for unusable inputs."""
    from nctakt.base import mode  # noqa: PLC0415 - the mode is chosen before the imports below

    if words["compiled"] is False:
        mode.use_plain()
    from nctakt.cli.common.tapes import check_unchanged, options_of  # noqa: PLC0415 - as above
    from nctakt.run.access.tape import path_of, read_tape  # noqa: PLC0415

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
