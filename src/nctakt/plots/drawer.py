# SPDX-License-Identifier: MIT
"""Draws a run: pictures, VCD, Perfetto; used by ``Run.plot`` and options of the command line.

In: a run with its trace, the axes of its machine, the lines of its programs. Out: a file. A method
that writes raises ``OSError``, one that checks ``Failure``.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Language, Span
from nctakt.base.failure import Failure
from nctakt.files.fst import check_fst
from nctakt.files.vcd import check_vcd
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.messages import diagnostic
from nctakt.messages.commands.pictures import RUN_NOT_RECORDED, SIGNAL_NOT_RECORDED, WRONG_SUFFIX
from nctakt.plots.picture import (
    check_picture,
    has_matplotlib,
    png_of,
    write_picture,
)
from nctakt.plots.run_perfetto import write_run_perfetto
from nctakt.plots.run_vcd import write_run_fst, write_run_vcd
from nctakt.plots.scene import Scene, scene_of
from nctakt.results.run import Run
from nctakt.results.timelines.timeline import Timeline
from nctakt.results.timelines.timeline_events import timeline_of
from nctakt.results.trace.recorded import Trace

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Drawer:
    """Draws runs of one machine.

    ``axes``: those of the first channel; ``limits_jerk``: its path had the jerk-limited slope;
    ``line_at`` returns the source line of a place.
    """

    def __init__(
        self,
        axes: Sequence[AxisConfiguration],
        line_at: Callable[[Span], str],
        *,
        limits_jerk: bool,
    ) -> None:
        self._axes = axes
        self._line_at = line_at
        self._limits_jerk = limits_jerk

    def plot(self, run: Run, path: Path, signals: Sequence[str] | None, language: Language) -> None:
        """Draw a picture; ``signals`` instead of the motion of the axes."""
        write_picture(self._scene(run, signals, language), path, language)

    def figure(self, run: Run, signals: Sequence[str] | None, language: Language) -> Figure:
        """Return a picture as a figure of matplotlib."""
        from nctakt.plots.shown_figure import figure_of  # noqa: PLC0415 - loads matplotlib

        return figure_of(self._scene(run, signals, language), language)

    def png(self, run: Run, language: Language = "en") -> bytes | None:
        """Return a picture as the bytes of a file; ``None`` without matplotlib."""
        if not has_matplotlib():
            return None
        return png_of(self._scene(run, None, language), language)

    def _scene(self, run: Run, signals: Sequence[str] | None, language: Language) -> Scene:
        return scene_of(
            _trace(run),
            self._timeline(run),
            self._axes,
            limits_jerk=self._limits_jerk,
            chosen=signals,
            title=", ".join(Path(program).name for program in run.programs),
            language=language,
        )

    def write_vcd(self, run: Run, path: Path) -> None:
        """Write a VCD file."""
        write_run_vcd(self._timeline(run, idle=True), _trace(run), path)

    def write_fst(self, run: Run, path: Path) -> None:
        """Write an FST file."""
        write_run_fst(self._timeline(run, idle=True), _trace(run), path)

    def write_perfetto(self, run: Run, path: Path, language: Language) -> None:
        """Write a file for Perfetto."""
        write_run_perfetto(self._timeline(run, idle=True), _trace(run), path, language)

    def detached(self, run: Run) -> Callable[[], Drawer]:
        """Return a maker of this run's drawer that needs no controller, in any process."""
        spans = {event.span for event in run.events if event.span is not None}
        lines = {(span.file, span.line): self._line_at(span) for span in spans}
        return functools.partial(_detached, tuple(self._axes), lines, self._limits_jerk)

    def _timeline(self, run: Run, *, idle: bool = False) -> Timeline:
        return timeline_of(
            run.events,
            run.why,
            cycle_time_us=run.cycle_time_us,
            first_tick=run.first_tick,
            ticks=run.ticks,
            line_at=self._line_at,
            idle=idle,
        )

    def check_file(self, kind: str, file: str) -> None:
        """Raise ``Failure`` for a file that cannot be of this kind."""
        check_file(kind, file)

    def check_run(self, run: Run, signals: Sequence[str] | None = None) -> None:
        """Raise ``Failure`` without a trace (901091) and for signals that it lacks (901092)."""
        if run.trace is None:
            raise Failure(diagnostic(RUN_NOT_RECORDED))
        for name in signals or ():
            if name not in run.trace:
                raise Failure(diagnostic(SIGNAL_NOT_RECORDED, name=name))


def _detached(
    axes: Sequence[AxisConfiguration], lines: Mapping[tuple[str, int], str], limits_jerk: bool
) -> Drawer:
    """Return a drawer that knows these source lines by file and number."""
    return Drawer(axes, lambda span: lines.get((span.file, span.line), ""), limits_jerk=limits_jerk)


#: The suffixes of traces for other viewers.
_SUFFIXES = {"vcd": ".vcd", "fst": ".fst", "perfetto": ".json"}


def check_file(kind: str, file: str) -> None:
    """Raise ``Failure`` for a file that cannot be one of ``plot``, ``vcd``, ``fst``, ``perfetto``.

    For another suffix (900635, 901090) and where a library is missing (900634).
    """
    if kind == "plot":
        check_picture(file)
        return
    suffix = _SUFFIXES[kind]
    if Path(file).suffix.lower() != suffix:
        raise Failure(diagnostic(WRONG_SUFFIX, file=file, option=f"--{kind}", suffix=suffix))
    if kind == "vcd":
        check_vcd()
    elif kind == "fst":
        check_fst()


def _trace(run: Run) -> Trace:
    assert run.trace is not None  # ``check_run`` was asked before
    return run.trace
