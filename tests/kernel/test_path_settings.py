# SPDX-License-Identifier: MIT
"""``#VECTOR LIMIT``, ``#SLOPE``, ``#SET SLOPE PROFIL`` and ``#CONTOUR MODE`` (language 2.1, 2.4).

The demo machine (MO-15): 500 mm/s, 4000 mm/s², tick 1 ms.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.kernel_rig import DEMO

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

SIGNALS = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "BLOCK"]


def run(text: str) -> Run:
    """The run of a program."""
    return Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, ticks=100_000)


def places(text: str) -> np.ndarray:
    """The positions of X and Y after each tick."""
    done = run(text)
    assert done.trace is not None
    assert done.errors == ()
    return np.array([done.trace[name] for name in SIGNALS[:2]]).T


def ticks(text: str, number: int = 9) -> int:
    """How long the block with this number lasts."""
    done = run(text)
    assert done.trace is not None
    return int((np.asarray(done.trace["BLOCK"]) == number).sum())


MM_M2 = 3600.0


@pytest.mark.parametrize(
    ("command", "motion", "speed", "acceleration"),
    [
        (f"#VECTOR LIMIT ON [ACC={1000 * MM_M2}]", "G01", 500.0, 1000.0),
        (f"#VECTOR LIMIT ON [DEC={1000 * MM_M2} ACC={2000 * MM_M2}]", "G01", 500.0, 1000.0),
        ("#VECTOR LIMIT ON [VEL=6000]", "G01", 100.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]", "G00", 100.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000 FEED]", "G00", 500.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000 RAPID]", "G00", 100.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]\n#VECTOR LIMIT OFF [VEL]", "G01", 500.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]\n#VECTOR LIMIT OFF [ACC]", "G01", 100.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]\n#VECTOR LIMIT OFF", "G01", 500.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]\n#VECTOR LIMIT OFF ALL", "G01", 500.0, 4000.0),
        # Those of the list are far above the axes' (P-CHAN-00002, 00090).
        ("#VECTOR LIMIT ON ALL", "G01", 500.0, 4000.0),
        ("#VECTOR LIMIT ON [VEL=6000]\n#VECTOR LIMIT ON [VEL]", "G01", 500.0, 4000.0),
    ],
)
def test_vector_limit_limits_the_path(
    command: str, motion: str, speed: float, acceleration: float
) -> None:
    """A way of 300 mm takes 300/v + v/a from rest to rest (207477899)."""
    time_s = 300.0 / speed + speed / acceleration
    if speed * speed / acceleration > 300.0:
        time_s = 2.0 * math.sqrt(300.0 / acceleration)
    text = f"F60000\n{command}\nN9 {motion} G60 X300\nM30"
    assert ticks(text) == math.ceil(time_s * 1000 - 1e-6)


def test_the_radial_acceleration_limits_the_speed_on_arcs() -> None:
    """On r = 20 mm 500 mm/s² allow 100 mm/s: v = √(a·r)."""
    found = places(f"#VECTOR LIMIT ON [RADIAL_ACC={500 * MM_M2}]\nG03 X0 Y0 I20 F30000\nM30")
    speed = np.linalg.norm(np.diff(found, axis=0), axis=1) * 1000
    assert speed.max() == pytest.approx(100.0, rel=1e-3)


@pytest.mark.parametrize(
    ("command", "like"),
    [
        ("#SLOPE [TYPE=SIN2]", "#SLOPE [TYPE=TRAPEZ]"),
        ("#SLOPE [TYPE=HSC NO_OPT=1]", "#SLOPE [TYPE=TRAPEZ]"),
        ("#SET SLOPE PROFIL [1]", "#SLOPE [TYPE=TRAPEZ]"),
        ("#SET SLOPE PROFIL [3, 0, 1]", "#SLOPE [TYPE=TRAPEZ]"),
        ("#SET SLOPE PROFIL [0]", "#SLOPE [TYPE=STEP]"),
        ("#SLOPE [TYPE=TRAPEZ]\n#SET SLOPE PROFIL", "#SLOPE [TYPE=STEP]"),
    ],
)
def test_old_and_smoother_slopes(command: str, like: str) -> None:
    """0 … 3 are STEP, TRAPEZ, SIN2, HSC (207190411); the smoother ones take TRAPEZ's time."""
    text = "{}\nN9 G01 G60 X100 F30000\nM30"
    assert ticks(text.format(command)) == ticks(text.format(like))


@pytest.mark.parametrize(
    ("mode", "distance"),
    [
        # A parabola over a corner of 90° passes it at h·√2/4: h = 4·d/√2.
        ("DEV PATH_DEV=1", 4.0 / math.sqrt(2.0)),
        ("PTP PATH_DEV=1", 4.0 / math.sqrt(2.0)),
        ("AUTO_DEV PATH_DEV=1", 4.0 / math.sqrt(2.0)),
        ("DIST PRE_DIST=5 POST_DIST=5", 5.0),
        ("DIST PRE_DIST=90 POST_DIST=90", 25.0),
        ("DIST PRE_DIST=90 POST_DIST=90 REMAIN_PART=20", 20.0),
        ("DIST_SOFT PATH_DIST=4", 4.0),
        ("DIST_SOFT PATH_DIST=-1", 0.0),
        ("DIST_MASTER SYM_DIST=4", 4.0),
        ("DIST_MASTER SYM_DIST=-1", 0.0),
        ("POS PRE_DIST=3 POST_DIST=3", 3.0),
        ("POS PRE_DIST=0 POST_DIST=0", 0.0),
        ("DEV PATH_DEV=1 MAX_ANGLE=80", 0.0),
        ("DEV PATH_DEV=1 MAX_ANGLE=100", 4.0 / math.sqrt(2.0)),
    ],
)
@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
def test_contour_modes_round_at_their_distance(mode: str, distance: float, slope: str) -> None:
    """The corner of two lines of 50 mm at (50, 0) is left at its distance (475164939 ff.)."""
    text = f"#SLOPE [TYPE={slope}]\n#CONTOUR MODE [{mode}]\nG261\nG01 X50 F600\nY50\nM30"
    found = places(text)
    off = np.abs(found[:, 0] - 50.0) + np.abs(found[:, 1])
    is_between = (found[:, 1] > 1e-9) & (found[:, 0] < 50.0 - 1e-9)
    if slope == "TRAPEZ":
        if "DEV=1" in mode and distance:
            distance *= 1.5  # a smoother curve: h = 6·d/√2
        distance = min(distance, 0.49 * 50.0)
    if distance == 0.0:
        assert not is_between.any()
        return
    begin = 50.0 - found[is_between, 0].min()
    assert begin == pytest.approx(distance, abs=0.02)
    corner = np.linalg.norm(found - (50.0, 0.0), axis=1).min()
    assert corner == pytest.approx(
        distance * math.sqrt(2.0) / (4.0 if slope == "STEP" else 6.0), abs=0.02
    )
    assert off.min() > 0.0


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("#VECTOR LIMIT ON [VEL=0]", 21205),
        ("#VECTOR LIMIT ON [ACC=-1]", 21206),
        ("P1 = 0\n#VECTOR LIMIT ON [DEC=P1]", 21546),
        ("#VECTOR LIMIT ON", 900233),
        ("#SET SLOPE PROFIL [4]", 21304),
        ("#CONTOUR MODE [DIST PRE_DIST=0]", 21401),
        ("#CONTOUR MODE [POS]\n#CONTOUR MODE [DIST]\n#CONTOUR MODE [PRE_DIST=0]", 21401),
        ("#CONTOUR MODE [DIST PRE_DIST=1 X10]", 900706),
        ("#CONTOUR MODE [POS PRE_DIST=1 A10]", 900706),
        ("#CONTOUR MODE [POS PRE_DIST=-1]", 21401),
        ("#CONTOUR MODE [DIST_MASTER SYM_DIST=0]", 21401),
        ("P1 = 0\n#CONTOUR MODE [DIST POST_DIST=P1]", 21401),
        ("#CONTOUR MODE [DEV DIST]", 900210),
        ("#CONTOUR MODE [AUTO_VEL]", 900706),
        ("G261\n#CONTOUR MODE [DIST_SOFT]", 120698),
        ("#CONTOUR MODE [DIST_SOFT]\nG261\n#CONTOUR MODE [DEV]", 120698),
        ("#CONTOUR MODE [DEV PRE_ACTION POST_ACTION]", 900210),
        ("#CONTOUR MODE [DEV REMAIN_PART=150]", 901870),
        ("P1 = -1\n#CONTOUR MODE [DEV MAX_ANGLE=P1]", 901870),
    ],
)
def test_mistakes_have_their_numbers(text: str, number: int) -> None:
    """Limits are above 0, slopes known, modes those that are simulated."""
    done = run(f"{text}\nM30")
    assert [error.id for error in done.errors] == [number]


@pytest.mark.parametrize(
    ("command", "deviation"),
    [
        ("#HSC ON [BSPLINE PATH_DEV=0.5]", 0.5),
        ("#HSC ON", 0.2),
        ("#HSC [BSPLINE PATH_DEV=1]\n#HSC ON", 1.0),
        ("#HSC ON [OPMODE=1 CONTERROR=0.3]", 0.3),
        ("#HSC ON [OPMODE=2]", 0.1),
        ("#HSC ON [BSPLINE PATH_DEV=0]", 0.0),
        ("#HSC ON [BSPLINE PATH_DEV=0.5]\n#HSC OFF", 0.0),
        ("#HSC ON [SURFACE PATH_DEV=0.5 TRACK_DEV=1]", 0.5),
        ("#HSC [SURFACE]\n#HSC ON [PATH_DEV 0.6]", 0.6),
        ("P1 = 0.3\n#HSC ON[PATH_DEV[P1 + 0.1]]", 0.4),
        ("#HSC ON [BSPLINE PATH_DEV=0.5 MAX_ANGLE=80]", 0.0),
        ("#HSC ON [BSPLINE PATH_DEV=0.5 MAX_ANGLE=100]", 0.5),
        ("#HSC ON [BSPLINE PATH_DEV=0.5 MAX_ANGLE=80]\n#HSC [MAX_ANGLE=0]", 0.5),
        ("#HSC ON [SURFACE PATH_DEV=0.5 MAX_ANGLE=80]\n#HSC OFF\nG261", 1.0),
    ],
)
@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
def test_hsc_keeps_the_tolerance(command: str, deviation: float, slope: str) -> None:
    """Pages 207308683, 207278475: the path passes corners within PATH_DEV or CONTERROR."""
    found = places(f"#SLOPE [TYPE={slope}]\n{command}\nG01 F6000 X40\nY40\nM30")
    nearest = np.hypot(found[:, 0] - 40.0, found[:, 1]).min()
    assert nearest <= deviation + 0.2 if deviation else nearest < 1e-6
    if deviation > 0.1:  # below that, TRAPEZ stops sooner than it rounds
        assert nearest >= 0.8 * deviation


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("#HSC ON [OPMODE=1]\n#HSC [OPMODE=2]\n", 901625),
        ("#HSC ON\n#HSC [OPMODE=1]\n", 901625),
        ("#HSC ON [OPMODE=3]\n", 901626),
        ("#HSC ON [BSPLINE PATH_DEV=-1]\n", 901626),
        ("#HSC ON\nG01 F600 X1\n#FLUSH\nX2\n", 20651),
        ("#HSC ON\nG01 F600 X1\nG151\nX2\nX3 Y1\nX4\nG150\n", 120255),
        ("#HSC ON [SURFACE]\n#HSC [BSPLINE]\n", 901625),
        ("#HSC ON [BSPLINE SURFACE]\n", 900210),
        ("#HSC ON [BSPLINE MAX_ANGLE=-1]\n", 901626),
        ("#HSC ON [PATH_DEV P1=5]\n", 20797),
        ("#HSC ON [BSPLINE PATH_DEV]\n", 900208),
    ],
)
def test_mistakes_of_hsc(text: str, number: int) -> None:
    """Each has a number."""
    assert [found.id for found in run(text + "M30").errors][:1] == [number]


def test_hsc_is_reported_once() -> None:
    """Note 901551, and one for each keyword without effect."""
    done = run("#HSC ON [BSPLINE PATH_DEV=0.1 MERGE=1]\n#HSC OFF\n#HSC ON\nM30")
    assert [found.id for found in done.diagnostics] == [901551, 901551]
