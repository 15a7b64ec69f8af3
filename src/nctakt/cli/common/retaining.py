# SPDX-License-Identifier: MIT
"""``--retain FILE``: values that a PLC retains from one run or session to the next (ST-406).

The values of the file are set before the first tick as by ``--set``, so that they are on a tape,
too; a ``--set`` of the same variable counts. After the run the file holds its last values.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from nctakt.cli.common.request import Options, Request
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile, write_file
from nctakt.run.access.stimuli import assignment_text

if TYPE_CHECKING:
    from contextlib import ExitStack

    from nctakt.base.diagnostics import Language
    from nctakt.session.session import Session


def with_retained(
    options: Options, request: Request, access: FileAccess, files: ExitStack
) -> tuple[Options, Request, Callable[[], None]]:
    """Return both with the values of the file of ``--retain``, and its writer for after the run.

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
    given = {**values, **(request.options["set"] or {})}
    words = tuple(assignment_text(*one) for one in given.items())
    return (
        replace(options, run={**options.run, "set": words}),
        replace(request, options={**request.options, "set": given}),
        lambda: file.write(retained_text(plcs)),
    )


class RetainedSession:
    """Values that successive sessions retain for the next one.

    Raises ``Failure`` as ``with_retained``.
    """

    def __init__(
        self, path: str, plcs: Sequence[str], access: FileAccess, language: Language
    ) -> None:
        with OutputFile(path, "--retain", access):  # no input, and can be written
            pass
        self._path = path
        self._plcs = plcs
        self._language = language
        self._session: Session | None = None
        self.values()

    def values(self) -> Mapping[str, float | str]:
        """Return the initial values of the next session; those of the last one are saved first."""
        from nctakt.plc.loading import load_plcs  # noqa: PLC0415 - the mode is chosen before
        from nctakt.plc.retained import plcs_that_retain, read_retained  # noqa: PLC0415 - as above

        self.keep()
        plcs = plcs_that_retain(load_plcs(self._plcs))  # their files may have been saved
        values, warnings = read_retained(self._path, plcs, FileAccess())
        print_diagnostics(warnings, self._language)
        return values

    def follow(self, session: Session) -> None:
        """Keep the values of this session from now on."""
        self._session = session

    def keep(self) -> None:
        """Write the values of the session where it is."""
        if self._session is not None:
            write_file(self._path, self._session.retained(), "--retain")


def _nothing() -> None:
    """Write no file."""
