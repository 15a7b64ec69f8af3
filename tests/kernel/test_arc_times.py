# SPDX-License-Identifier: MIT
"""Arcs at the limits of the axes, beside the best that these allow: within 3 % (MO-2, MO-3).

A block's end is rounded up to a tick. The axes' limits are unequal as well, and kept (MO-1).
"""

from __future__ import annotations

import math
import shutil
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from support.best_times import Way, best_time
from support.kernel_rig import ACCELERATION, DEMO, RAPID

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller, NcText

SIGNALS = [f"{name}.ACS.ACT_POS" for name in "XYZ"]
RADII = ((0.5, 500.0), (1.0, 50.0), (5.0, 100.0), (5.0, 500.0), (20.0, 300.0), (100.0, 450.0))


@pytest.fixture(scope="module")
def machines(tmp_path_factory: pytest.TempPathFactory) -> dict[float, Machine]:
    """The demo machine, and it with a share of the limits for Y."""
    return {share: machine(tmp_path_factory.mktemp("m"), share) for share in (1.0, 0.5, 0.2)}


def machine(folder: Path, share: float) -> Machine:
    """The demo machine with a share of speed and acceleration for Y."""
    shutil.copytree(DEMO.folder, folder / "machine")
    axis = folder / "machine" / "achs_mds2.lis"
    limits = (
        f"\ngetriebe[0].dynamik.a_max {int(ACCELERATION * share)}"
        f"\ngetriebe[0].dynamik.vb_max {int(RAPID * 1000 * share)}\nEnde"
    )
    axis.write_text(axis.read_text("utf-8").replace("\nEnde", limits), "utf-8")
    return load_machine(folder / "machine")


def seconds(one: Machine, share: float, program: str) -> float:
    """How long a program takes; speed and acceleration of each axis hold in each tick."""
    run = Controller(one).run(NcText("p.nc", program + "\nM30"), signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    for name, part in zip(SIGNALS, (1.0, share, 1.0), strict=True):
        places = np.asarray(run.trace[name])
        speed = np.diff(np.concatenate([[0.0] * 2, places, places[-1:]])) * 1000
        assert np.abs(speed).max() <= RAPID * part * (1 + 1e-9)
        assert np.abs(np.diff(speed)).max() <= ACCELERATION / 1000 * part * (1 + 1e-6) + 1e-6
    return (run.ticks - 1) / 1000


def spiral(radius: float) -> Way:
    """Half circles, each greater by three tenths of the first one."""
    way = Way()
    for i in range(8):
        way.arc(radius * (1 + 0.3 * i) * (-1) ** i, 0, 180)
    return way


def bends(radius: float) -> Way:
    """An S of half circles to the right and to the left."""
    way = Way()
    for i in range(6):
        way.arc(radius, 0, -180 * (-1) ** i)
    return way


def short_arcs(radius: float) -> Way:
    """A spiral of 40 arcs of 11° whose radii grow by 5 % of the first one."""
    way, heading = Way(), 0.0
    for i in range(40):
        grown = radius * (1 + 0.05 * i)
        way.arc(-math.sin(heading) * grown, math.cos(heading) * grown, 11.0)
        heading += math.radians(11.0)
    return way


def shapes(radius: float) -> dict[str, Way]:
    """Paths with arcs of a radius, from rest to rest."""
    r, c = radius, radius * math.sqrt(0.5)
    return {
        "circle": Way().arc(-r, 0, 360),
        "quarter": Way().arc(-r, 0, 90),
        "quarter from 45°": Way().arc(-c, -c, 90),
        "20° from 45°": Way().arc(-c, -c, 20),
        "between lines": Way().line(3 * r, 0).arc(0, r, 180).line(-3 * r, 0),
        "rounded corner": Way().line(3 * r, 0).arc(0, r, 90).line(0, 3 * r),
        "helix": Way().arc(0, r, 360, r / 2).arc(0, r, 360, r / 2),
        "S": bends(r),
        "spiral": spiral(r),
        "spiral of short arcs": short_arcs(r),
    }


@pytest.mark.nightly
@pytest.mark.parametrize("share", [1.0, 0.2])
@pytest.mark.parametrize(("radius", "feed"), RADII)
def test_arcs_take_hardly_longer_than_the_optimum(
    machines: dict[float, Machine], share: float, radius: float, feed: float
) -> None:
    """Within 3 % and a tick, whether feed, speed or acceleration of an axis is the limit."""
    speeds = (RAPID, RAPID * share, RAPID)
    accelerations = (ACCELERATION, ACCELERATION * share, ACCELERATION)
    for name, way in shapes(radius).items():
        found = seconds(machines[share], share, way.program(feed))
        best = best_time(way, feed, speeds, accelerations)
        assert 0.998 * best <= found <= 1.03 * best + 0.001, (name, found, best)


def test_where_an_arc_begins_does_not_matter(machines: dict[float, Machine]) -> None:
    """Arcs of 10° to 350°, from any direction, left and right, each within 3 %."""
    limits = ((RAPID,) * 3, (ACCELERATION,) * 3)
    for begin, angle in product(range(0, 360, 150), (10.0, -40.0, 130.0, -350.0)):
        x, y = 3 * math.cos(math.radians(begin)), 3 * math.sin(math.radians(begin))
        way = Way().arc(-x, -y, angle)
        found = seconds(machines[1.0], 1.0, way.program(200.0))
        assert found <= 1.03 * best_time(way, 200.0, *limits) + 0.001, (begin, angle)
