# SPDX-License-Identifier: MIT
"""``nctakt demo``: a handling cell on a page in the browser, with a guided tour.

In: the programs and the PLC of ``nctakt.live.demo``, the machine ``cell``. Out: as ``nctakt live``.
The programs are copied for the time of the page: anything saved there is gone afterwards.
"""

from __future__ import annotations

import contextlib
import shutil
import tempfile

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_USAGE
from nctakt.cli.common.file_options import file_access
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import language_option, split_words
from nctakt.cli.common.request import Options
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.cli.live import Words, show_page
from nctakt.lists.machine.files import DEMO_FOLDER

#: The machine of the cell; it shares lists with the others.
MACHINE = DEMO_FOLDER.parent / "cell"

#: Where the programs and the PLC are, and their names.
CELL = DEMO_FOLDER.parent.parent / "live" / "demo"
_PROGRAM, _OTHER, _PLC = "mill.nc", "loader.nc", "cell.st"

#: The area before the gate: free, occupied when the mill asks, free again.
AREA = "V.E.AREA_FREE"
STIMULI = (("3.5s", f"{AREA}=0"), ("3.9s", f"{AREA}=1"))


@described(
    "demo",
    summary=Text(
        "Show a cell in the browser, with a guided tour.",
        "Eine Zelle im Browser zeigen, mit einem Rundgang.",
    ),
    text=Text(
        "Show a handling cell in the browser, with a guided tour: two channels, five axes, a "
        "spindle, a gate and its PLC. Why does the gate not open?",
        "Eine Zelle im Browser zeigen, mit einem Rundgang: zwei Kanäle, fünf Achsen, eine Spindel, "
        "ein Tor und seine SPS. Warum geht das Tor nicht auf?",
    ),
    codes=(Text("ended by Ctrl-C or SIGTERM", "beendet durch Strg-C oder SIGTERM"), None),
    notes=Text(
        "Programs that are changed on the page are gone when it ends.",
        "Auf der Seite geänderte Programme sind mit ihrem Ende verloren.",
    ),
    examples=("nctakt demo", "nctakt demo --lang de", "nctakt demo --no-open --port 9000"),
)
@option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    metavar="N",
    text=Text(
        "Port of the page, 0: a free one [default: 0].",
        "Port der Seite, 0: ein freier [Vorgabe: 0].",
    ),
)
@option(
    "--no-open",
    "stays_closed",
    is_flag=True,
    text=Text(
        "Only print the address of the page.",
        "Nur die Adresse der Seite ausgeben.",
    ),
)
@language_option()
def command(port: int, stays_closed: bool, language: Language) -> int:
    """Show the cell on a page."""
    own = Words(
        "127.0.0.1", port, None, False, not stays_closed, False, "slice", None, has_tour=True
    )
    try:
        with tempfile.TemporaryDirectory(prefix="nctakt-demo-") as folder, contextlib.chdir(folder):
            return show_page(_options(language), file_access(()), own)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _options(language: Language) -> Options:
    """Return the options of the cell's run; its programs and its PLC are copied to here."""
    for name in (_PROGRAM, _OTHER, _PLC):
        shutil.copyfile(CELL / name, name)
    run, _ = split_words({"assignments": (f"{AREA}=1",), "stimuli": STIMULI})
    return Options(
        programs=(_PROGRAM,),
        others=(("2", _OTHER),),
        machine=str(MACHINE),
        plcs=(_PLC,),
        run=run,
        language=language,
        compiled=None,
        confined=(".", str(MACHINE.parent)),
    )
