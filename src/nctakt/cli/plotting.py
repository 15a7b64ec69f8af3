# SPDX-License-Identifier: MIT
"""``nctakt run --plot``: the signals for the picture, and the picture.

In: the options of the command, the controller before its run. Out: the signals and sinks of the
run, then the file.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.cli.request import Options, Request

if TYPE_CHECKING:
    from nctakt.run.controller import Controller
    from nctakt.trace.sinks import Sink


class Plot:
    """The picture of a run; raises ``Failure`` if it cannot be drawn (900635, 900634)."""

    def __init__(self, options: Options, controller: Controller) -> None:
        # numpy and matplotlib are loaded only for a picture
        from nctakt.plots import motion, picture  # noqa: PLC0415
        from nctakt.trace.recorded import MemorySink  # noqa: PLC0415 - the mode is chosen before

        assert options.plot is not None
        picture.check_picture(options.plot)
        self._options = options
        self._controller = controller
        self._axes = controller.channel_axes
        self._defaults = controller.default_signals
        self._signals = motion.signals([axis.name for axis in self._axes])
        self._sink = MemorySink()

    def request(self, request: Request) -> Request:
        """Return the request with the picture's signals after the requested ones."""
        signals = self._defaults if request.signals is None else request.signals
        further = (name for name in self._signals if name not in signals)
        return dataclasses.replace(request, signals=(*signals, *further))

    def sinks(self, sinks: Sequence[Sink], request: Request) -> list[Sink]:
        """Return the sinks of the run; the given ones only get the requested signals."""
        from nctakt.trace.columns import FirstColumns  # noqa: PLC0415 - as above

        signals = self._defaults if request.signals is None else request.signals
        return [*(FirstColumns(sink, len(signals)) for sink in sinks), self._sink]

    def draw(self, path: Path) -> None:
        """Write the file; raises ``OSError``."""
        from nctakt.plots import motion, picture  # noqa: PLC0415 - as above

        title = ", ".join(Path(program).name for program in self._options.programs)
        curves = motion.motion_of(
            self._sink.trace, self._axes, limits_jerk=self._controller.has_limited_jerk
        )
        picture.write_picture(curves, path, title, self._options.language)
