# SPDX-License-Identifier: MIT
"""``nctakt run --plot``, ``--vcd``, ``--fst``, ``--perfetto``: their recordings, and the files.

In: the options of the command, the controller before its run. Out: the signals and sinks of the
run, then the files.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.cli.common.request import Options, Request

if TYPE_CHECKING:
    from nctakt.files.output import OutputFile
    from nctakt.results.run import Run
    from nctakt.results.trace.sinks import Sink
    from nctakt.run.controller import Controller


class Drawings:
    """The files that show a run; raises ``Failure`` if one of them cannot be drawn.

    ``open_file`` returns the file of an option. Without a file they change nothing.
    """

    def __init__(
        self,
        options: Options,
        controller: Controller,
        open_file: Callable[[str, str | None], OutputFile | None],
    ) -> None:
        names = {
            "plot": options.plot,
            "vcd": options.vcd,
            "fst": options.fst,
            "perfetto": options.perfetto,
        }
        paths = {kind: path for kind, path in names.items() if path is not None}
        self._options = options
        self._default_signals: Sequence[str] = ()
        self._signals: Sequence[str] = ()
        self._chosen: Sequence[str] | None = None
        self._files: dict[str, OutputFile] = {}
        if not paths:
            return
        # numpy and matplotlib are loaded only for a picture
        from nctakt.plots.drawer import check_file  # noqa: PLC0415

        for kind, path in paths.items():
            check_file(kind, path)
        for kind, path in paths.items():
            file = open_file(f"--{kind}", path)
            assert file is not None
            self._files[kind] = file
        self._default_signals = controller.default_signals
        self._signals = controller.motion_signals

    @property
    def are_wanted(self) -> bool:
        """Whether there is any file."""
        return bool(self._files)

    @property
    def draws_conditions(self) -> bool:
        """Whether the pictures show the signals of conditions, since none were chosen."""
        return self.are_wanted and self._chosen is None

    def request(self, request: Request) -> Request:
        """Return the request with the signals of pictures after the requested ones."""
        self._chosen = request.signals
        if not self._files:
            return request
        signals = self._default_signals if request.signals is None else request.signals
        further = (name for name in self._signals if name not in signals)
        return dataclasses.replace(request, signals=(*signals, *further))

    def sinks(self, sinks: Sequence[Sink], request: Request) -> list[Sink]:
        """Return sinks that get only the requested signals, and events as without pictures."""
        from nctakt.results.trace.sinks import BLOCK_EVENTS, first_columns  # noqa: PLC0415 - the mode is chosen before

        if not self._files:
            return list(sinks)
        signals = self._default_signals if request.signals is None else request.signals
        hides = () if self._options.run["blocks"] else BLOCK_EVENTS
        return [first_columns(sink, len(signals), hides) for sink in sinks]

    def draw(self, run: Run) -> None:
        """Write the files; raises ``Failure``."""
        if not self._files:
            return
        assert run.drawer is not None
        drawer, language, chosen = run.drawer(), self._options.language, self._chosen
        writers: dict[str, Callable[[Path], None]] = {
            "plot": lambda path: drawer.plot(run, path, chosen, language),
            "vcd": lambda path: drawer.write_vcd(run, path),
            "fst": lambda path: drawer.write_fst(run, path),
            "perfetto": lambda path: drawer.write_perfetto(run, path, language),
        }
        for kind, file in self._files.items():
            file.fill(writers[kind])
