# SPDX-License-Identifier: MIT
"""A controller in Python: steps by time, and its end."""

from __future__ import annotations

from datetime import timedelta

import pytest

from nctakt import Controller, Failure, NcText

PROGRAM = NcText("part.nc", "G01 X100 F6000\nM30")


@pytest.mark.parametrize(
    ("step", "ticks"),
    [("20 ms", 20), ("20.1 ms", 21), ("7 ticks", 7), (timedelta(milliseconds=5), 5), (3, 3)],
)
def test_a_step_may_be_a_time(step: int | str | timedelta, ticks: int) -> None:
    """RC-001: the ticks that begin within it; a tick of the demo machine lasts 1 ms."""
    controller = Controller()
    controller.start(PROGRAM)
    assert controller.step(step).ticks == ticks
    assert controller.tick == ticks


def test_a_step_that_is_no_time() -> None:
    """Refused as any other time."""
    with pytest.raises(Failure):
        Controller().step("20 parsecs")


def test_the_interface_image_is_closed_with_the_controller() -> None:
    """``with Controller()`` lets go of the shared memory, whatever happens in it."""
    with Controller() as controller:
        image = controller.interface_image()
        assert not image.is_closed
    assert image.is_closed
