# SPDX-License-Identifier: MIT
"""``#ECS``: coordinates along the tool; public manuals: page 208508555, P-CHAN-00031, 00050."""

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

DEMO5 = Path(__file__).parents[2] / "src/nctakt/machines/demo5"
SIGNALS = [f"{axis}.MCS.ACT_POS" for axis in "XYZ"]


ROOT = 75.0**0.5


def run(folder: Path, *lines: str, channel: Sequence[str] = ()) -> Run:
    """A run of these lines on demo5 with these entries of the channel list."""
    machine = load_machine(
        changed_machine({"sda_mds1.lis": list(channel)}, folder / "machine", DEMO5)
    )
    return perform("\n".join([*lines, "M30"]), Controller(machine), signals=SIGNALS)


def way(folder: Path, word: str, *head: str, channel: Sequence[str] = ()) -> list[float]:
    """The way of the tip by a relative word in the system."""
    lines = [*head, "#ECS ON", "#TIME 1.5", f"G91 G01 {word} F6000"]
    found = run(folder, *lines, channel=channel)
    assert numbers(found) == []
    assert found.trace is not None
    tip = np.array([found.trace[name] for name in SIGNALS]).T
    return list(tip[-1] - tip[-1000])


@pytest.mark.parametrize(
    ("rotary", "x", "y", "z"),
    [
        ("A0 C0", (10, 0, 0), (0, 10, 0), (0, 0, 10)),
        ("A30 C0", (10, 0, 0), (0, ROOT, 5), (0, -5, ROOT)),
        ("A30 C90", (0, 10, 0), (-ROOT, 0, 5), (5, 0, ROOT)),
    ],
)
def test_the_third_axis_is_along_the_tool(
    tmp_path: Path, rotary: str, x: tuple[float, ...], y: tuple[float, ...], z: tuple[float, ...]
) -> None:
    """A turns the tool about X, C then about Z; X stays horizontal, Y goes upward as the tool."""
    head = (f"G00 {rotary} Z100", "#TRAFO ON")
    for name, expected in zip("XYZ", (x, y, z), strict=True):
        assert way(tmp_path / name, f"{name}10", *head) == pytest.approx(expected, abs=1e-6)


def test_the_axis_that_the_list_puts_into_a_plane(tmp_path: Path) -> None:
    """P-CHAN-00031: Y stays horizontal, X goes upward; P-CHAN-00050: X in YZ, Y to X's side."""
    head = ("G00 A30 Z100", "#TRAFO ON")
    y = ["kind_of_2nd_ecs_ax Y"]
    assert way(tmp_path / "a", "Y10", *head, channel=y) == pytest.approx((-10, 0, 0), abs=1e-6)
    assert way(tmp_path / "b", "X10", *head, channel=y) == pytest.approx((0, ROOT, 5), abs=1e-6)
    yz = ["mach_plane_of_2nd_ecs_ax yz"]
    assert way(tmp_path / "c", "X10", *head, channel=yz) == pytest.approx((0, -ROOT, -5), abs=1e-6)
    assert way(tmp_path / "d", "Y10", *head, channel=yz) == pytest.approx((10, 0, 0), abs=1e-6)


def test_without_a_transformation(tmp_path: Path) -> None:
    """The selected kinematic says how the tool is oriented; X, Y and Z go along it."""
    found = way(tmp_path, "Z10", "G00 A30 Z100", "#KIN ID [91]")
    assert found == pytest.approx((0, -5, ROOT), abs=1e-6)


def test_it_ends_and_has_arcs(tmp_path: Path) -> None:
    """A circle across the tool; after #ECS OFF Z is that of the machine."""
    found = run(
        tmp_path,
        "G00 A30 Z100",
        "#TRAFO ON",
        "#ECS ON",
        "G91 G17 G02 I10 F6000",
        "#ECS OFF",
        "#TIME 1.5",
        "G01 Z10",
    )
    assert numbers(found) == []
    assert found.trace is not None
    tip = np.array([found.trace[name] for name in SIGNALS]).T
    assert tip[-1] - tip[-1000] == pytest.approx((0, 0, 10), abs=1e-6)
    away = tip - tip[-1000]
    far = away[np.argmax(np.linalg.norm(away[500:-1000], axis=1)) + 500]
    assert far == pytest.approx((20, 0, 0), abs=1e-2)


@pytest.mark.parametrize(
    ("lines", "number"),
    [
        ("#TRAFO ON\n#CS ON [1,2,3]\n#ECS ON", 901893),
        ("#TRAFO ON\n#ECS ON\n#ECS ON", 901893),
        ("#TRAFO ON\n#ECS ON\n#CS ON [1,2,3]", 901893),
        ("#TRAFO ON\n#ECS ON\n#CS DEF [1] [1,2,3]\n#ECS OFF\n#CS ON [1]\n#ECS OFF", 20824),
        ("#ECS DEF [1,2,3]", 900233),
        ("#ECS ON [1]", 900233),
        ("#MCS ON\n#ECS ON", 901760),
    ],
)
def test_what_cannot_be(tmp_path: Path, lines: str, number: int) -> None:
    """Each with its own diagnostic."""
    assert numbers(run(tmp_path, lines)) == [number]
