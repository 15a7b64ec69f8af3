# SPDX-License-Identifier: MIT
"""Measuring type 7: G100 to a fixed stop; ``docs/conformance/measuring.md`` says what is decided.

Public manuals: page 206202891; P-AXIS-00330 … 332, 769, 770, 774, 775, P-CHAN-00266. In the machine
X and Y meet an obstacle at 8 mm, and lag by speed over gain.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.decided import numbers, perform
from support.run_folders import changed_machine

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller

STOP = (
    "kenngr.messachse 1",
    "kenngr.meas_signal_fixed_stop 1",
    "kenngr.fixed_stop_pos_lag_limit 20000",
    "kenngr.fixed_stop_nbr_cycles 3",
    "antr.simu.fixed_stop 80000",
)
FREE = STOP[:-1]
SHOWN = '#MSG ["%.3f %.0f %.3f", V.A.MESS.X, V.A.MERF.X, V.A.ABS.X]'


def run(
    folder: Path,
    *lines: str,
    x: Sequence[str] = STOP,
    y: Sequence[str] = FREE,
    channel: Sequence[str] = (),
) -> Run:
    """A run of these lines with measuring type 7, with these entries of the lists."""
    changes = {
        "achs_mds1.lis": [*x, "antr.simu.ist_gleich_soll 1"],
        "achs_mds2.lis": [*y, "antr.simu.ist_gleich_soll 1"],
        "sda_mds1.lis": ["messtyp 7", *channel],
    }
    machine = load_machine(changed_machine(changes, folder / "machine"))
    signals = ["X.ACS.ACT_POS", "X.ACS.CUR_POS", "Y.ACS.ACT_POS"]
    return perform("\n".join([*lines, "M30"]), Controller(machine), signals=signals)


def test_it_ends_at_the_stop(tmp_path: Path) -> None:
    """206202891: the actual position is the value; the rest of the way is dropped."""
    found = run(tmp_path, "G100 X50 F600", SHOWN, "G01 X1 F600", '#MSG ["%.3f", V.A.ABS.X]')
    assert numbers(found) == []
    value, signal, position = map(float, found.messages[0].text.split())
    assert (value, signal) == (8.0, 1.0)
    assert 10.0 < position < 11.0
    assert found.messages[1].text == "1.000"
    assert found.trace is not None
    assert max(found.trace["X.ACS.CUR_POS"]) == 8.0


def test_one_axis_is_enough(tmp_path: Path) -> None:
    """The motion ends as soon as one of its axes is at a stop."""
    found = run(tmp_path, "G100 X50 Y100 F600", '#MSG ["%.3f %.3f", V.A.MESS.X, V.A.MESS.Y]')
    assert numbers(found) == []
    x, y = map(float, found.messages[0].text.split())
    assert x == 8.0
    assert 20.0 < y < 22.0


def test_the_lag_holds_for_some_time(tmp_path: Path) -> None:
    """P-AXIS-00332, P-AXIS-00770, P-AXIS-00775: the command is that much farther."""
    ends = []
    entries: Sequence[Sequence[str]] = (
        (),
        ("antr.fixed_stop.detect.min_time 103000",),
        (
            "antr.fixed_stop.detect.min_time 103000",
            "kenngr.measure.fixed_stop_detect.min_time 203000",
        ),
    )
    for number, extra in enumerate(entries):
        found = run(tmp_path / str(number), "G100 X50 F600", x=[*STOP, *extra])
        assert found.trace is not None
        ends.append(float(found.trace["X.ACS.ACT_POS"][-1]))
    assert np.diff(ends) == pytest.approx([1.0, 1.0], abs=0.011)


def test_the_lag_of_measuring_comes_first(tmp_path: Path) -> None:
    """P-AXIS-00774, else P-AXIS-00769, else P-AXIS-00331."""
    ends = []
    entries: Sequence[Sequence[str]] = (
        (),
        ("antr.fixed_stop.detect.pos_lag_limit 30000",),
        (
            "antr.fixed_stop.detect.pos_lag_limit 30000",
            "kenngr.measure.fixed_stop_detect.pos_lag_limit 10000",
        ),
    )
    for number, extra in enumerate(entries):
        found = run(tmp_path / str(number), "G100 X50 F600", x=[*STOP, *extra])
        assert found.trace is not None
        ends.append(float(found.trace["X.ACS.ACT_POS"][-1]))
    assert np.diff(ends) == pytest.approx([1.0, -2.0], abs=0.011)


def test_without_a_stop(tmp_path: Path) -> None:
    """P-CHAN-00266: it is an error, or the motion goes to its target."""
    assert numbers(run(tmp_path / "a", "G100 X50 F6000", x=FREE)) == [901700]
    none = "meas_fixed_stop_no_error 1"
    found = run(tmp_path / "b", "G100 X50 F6000", SHOWN, x=FREE, channel=[none])
    assert numbers(found) == []
    assert found.messages[0].text.split()[1:] == ["0", "50.000"]


@pytest.mark.parametrize(
    "x",
    [STOP[:1] + STOP[2:], STOP[:2] + STOP[3:], (*STOP, "antr.fixed_stop.detect.pos_lag_limit 0")],
)
def test_axes_need_their_entries(tmp_path: Path, x: Sequence[str]) -> None:
    """Without P-AXIS-00330 or a lag each lag of the drive would be a stop: 901701."""
    assert numbers(run(tmp_path, "G100 X50 F600", x=x)) == [901701]
