# SPDX-License-Identifier: MIT
"""``nctakt run --retain FILE``: what a PLC keeps from one run to the next (ST-406).

The values of the file are set before the first tick as by ``--set``, so that they are on a tape,
too; a ``--set`` of the same variable counts. After the run the file holds its last values.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from nctakt.cli.common.request import Options, Request
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.run.access.stimuli import assignment_text

if TYPE_CHECKING:
    from contextlib import ExitStack


def with_retained(
    options: Options, request: Request, access: FileAccess, files: ExitStack
) -> tuple[Options, Request, Callable[[], None]]:
    """Return both with what the file of ``--retain`` sets, and what writes it after the run.

    Raises ``Failure`` without a PLC in Structured Text, and for a file that cannot be read or
    written.
    """
    if options.retain is None:
        return options, request, _nothing
    from nctakt.plc.retained import (  # noqa: PLC0415 - a plain run has no PLC
        plcs_that_retain,
        read_retained,
        retained_text,
    )

    plcs = plcs_that_retain(request.plc)
    values, warnings = read_retained(options.retain, plcs, access)
    print_diagnostics(warnings, options.language)
    file = files.enter_context(OutputFile(options.retain, "--retain", access))
    words = (*(assignment_text(*one) for one in values.items()), *options.run["set"])
    given = {**values, **(request.options["set"] or {})}
    return (
        replace(options, run={**options.run, "set": words}),
        replace(request, options={**request.options, "set": given}),
        lambda: file.write(retained_text(plcs)),
    )


def _nothing() -> None:
    """Write no file."""
