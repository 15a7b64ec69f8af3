# SPDX-License-Identifier: MIT
"""The segments that a program decodes to, and where they go in the plane."""

from __future__ import annotations

from collections.abc import Generator
from math import atan2, cos, dist, hypot, pi, radians, sin

import pytest

from nctakt.base.diagnostics import Severity
from nctakt.decoder.program import ProgramDecoder
from nctakt.decoder.state.queued.commands import Answer, Command, Segment
from nctakt.nc.outline import ProgramText
from nctakt.run import queue_feeder
from nctakt.run.controller import Controller, NcText

Point = tuple[float, float]
#: From a place to another one, about a centre by degrees, or in a line.
Way = tuple[Point, Point, Point | None, float]


def decoded(text: str, patch: pytest.MonkeyPatch) -> tuple[list[Segment], list[int]]:
    """The segments of a run on the demo machine, and the numbers of its errors."""
    return reported(text, patch)[:2]


def reported(text: str, patch: pytest.MonkeyPatch) -> tuple[list[Segment], list[int], list[int]]:
    """The segments of a run on the demo machine, the numbers of its errors and warnings."""
    seen: list[Segment] = []

    class Watched(ProgramDecoder):
        def decode(self, program: ProgramText, members: list[int]) -> Generator[Command, Answer]:
            commands = super().decode(program, members)
            answer: Answer = None
            while True:
                try:
                    command = commands.send(answer)
                except StopIteration:
                    return
                if isinstance(command, Segment):
                    seen.append(command)
                answer = yield command

    patch.setattr(queue_feeder, "ProgramDecoder", Watched)
    run = Controller().run(NcText("p.nc", text + "M30\n"), signals=[])
    warnings = [one.id for one in run.diagnostics if one.severity is Severity.WARNING]
    return seen, [one.id for one in run.errors], warnings


def way(segment: Segment, plane: tuple[int, int] = (0, 1)) -> Way:
    """What a segment does in the plane."""
    first, second = plane
    start = (segment.start[first], segment.start[second])
    end = (segment.target[first], segment.target[second])
    if segment.arc is None:
        return (start, end, None, 0.0)
    return (start, end, (segment.arc[2], segment.arc[3]), segment.arc[4])


def places(one: Way, count: int = 20) -> list[Point]:
    """Places on a way, from its start to its end."""
    start, end, centre, angle = one
    found = []
    for number in range(count + 1):
        share = number / count
        if centre is None:
            found.append(
                (start[0] + (end[0] - start[0]) * share, start[1] + (end[1] - start[1]) * share)
            )
            continue
        turned = radians(angle) * share
        x, y = start[0] - centre[0], start[1] - centre[1]
        found.append(
            (
                centre[0] + x * cos(turned) - y * sin(turned),
                centre[1] + x * sin(turned) + y * cos(turned),
            )
        )
    return found


def distance(place: Point, one: Way) -> float:
    """How far a place is from a way."""
    start, end, centre, angle = one
    ends = min(dist(place, start), dist(place, end))
    if centre is None:
        x, y = end[0] - start[0], end[1] - start[1]
        share = ((place[0] - start[0]) * x + (place[1] - start[1]) * y) / (x * x + y * y)
        if not 0.0 < share < 1.0:
            return ends
        return dist(place, (start[0] + x * share, start[1] + y * share))
    begin = atan2(start[1] - centre[1], start[0] - centre[0])
    here = atan2(place[1] - centre[1], place[0] - centre[0])
    turned = (here - begin) % (2 * pi) if angle > 0.0 else (begin - here) % (2 * pi)
    if turned > abs(radians(angle)):
        return ends
    radius = hypot(start[0] - centre[0], start[1] - centre[1])
    return abs(dist(place, centre) - radius)
