# SPDX-License-Identifier: MIT
"""``nctakt new``: a machine folder to begin with.

In: the name of a folder that does not exist or is empty, a language. Out: the demo machine's lists
in it, each parameter explained in that language; what to do next on standard output.
"""

from __future__ import annotations

from pathlib import Path

import click

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.terminal import print_diagnostics
from nctakt.files.output import write_file
from nctakt.machines.commented import commented_lists
from nctakt.messages import diagnostic
from nctakt.messages.folders import FOLDER_NOT_EMPTY, FOLDER_NOT_WRITABLE, LISTS_WRITTEN

_EPILOG = """\b
  nctakt new mymachine
  nctakt check mymachine
  nctakt run part.nc --machine mymachine
"""


@click.command("new", epilog=_EPILOG, short_help="Write a machine folder to begin with.")
@click.argument("folder", metavar="DIR")
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "de"]),
    default="en",
    help="Language of the lists' comments.",
)
def command(folder: str, language: Language) -> int:
    """Write the lists of a machine with four axes and three spindles, with comments."""
    lists = commented_lists(language)
    try:
        _write(Path(folder), lists)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE
    told = diagnostic(LISTS_WRITTEN, folder=folder, count=len(lists))
    click.echo(told.text(language))
    click.echo(f"  {told.remedy(language)}")
    return EXIT_RAN


def _write(folder: Path, lists: dict[str, str]) -> None:
    """Write the lists; ``Failure`` where the folder is in use or cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise Failure(diagnostic(FOLDER_NOT_EMPTY, folder=str(folder)))
        for name, text in lists.items():
            write_file(folder / name, text)
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(FOLDER_NOT_WRITABLE, folder=str(folder), reason=reason)) from error
