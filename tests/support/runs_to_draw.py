# SPDX-License-Identifier: MIT
"""Runs that record all that pictures show."""

from __future__ import annotations

from typing import Any

from nctakt.plots.motion import signals
from nctakt.results.run import Run
from nctakt.results.timelines.timeline import Timeline
from nctakt.results.timelines.timeline_events import timeline_of
from nctakt.run.controller import Controller, NcText

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
$IF ONCE V.RTA.ACS.ACT_POS.X > 5
M100
$ENDIF
$IF V.RTA.ACS.ACT_POS.X > 8 && V.E.COUNT == 0
V.RTG.OVERRIDE.VEL.CYCLE = 50
$ENDIF
#RT CYCLE END
N10 G00 X20 Y5
N20 G01 X10 Y10 Z5 F6000
N30 M101
N40 #MSG ["done"]
M30
"""


def drawn(text: str = PART, **options: Any) -> Run:
    """A run on the demo machine."""
    controller = Controller()
    names = signals([axis.name for axis in controller.channel_axes])
    given: dict[str, Any] = {"signals": names, "blocks": True, "why": True}
    given |= {"condition_signals": True, **options}
    return controller.run(NcText("part.nc", text), **given)


def timeline(run: Run) -> Timeline:
    """The timeline of a run whose program nobody looks up."""
    return timeline_of(
        run.events,
        run.why,
        cycle_time_us=run.cycle_time_us,
        first_tick=run.first_tick,
        ticks=run.ticks,
        line_at=lambda span: f"line {span.line}",
    )
