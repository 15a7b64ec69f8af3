"""Tests in Python, for what comments in a program cannot express."""

import pytest

from nctakt import Controller, RunNc

CROSSING = "../programs/crossing.nc"


def test_m100_comes_as_soon_as_x_passes_200(run_nc: RunNc) -> None:
    run = run_nc(CROSSING)
    assert run.ended
    assert run.fired(cycle=17, line=5)
    assert run.m_function(100).at == pytest.approx(0.463)
    assert run.m_function(100).count == 1
    assert run.axis("X").position_at(0.463) == pytest.approx(200.25)
    assert run.axis("X").end_position == 500
    assert not run.m_function(101)


@pytest.mark.parametrize("override", [25, 50, 100])
def test_at_any_override_m100_comes_after_200_mm(run_nc: RunNc, override: int) -> None:
    run = run_nc(CROSSING, set={"HLI.OVERRIDE": override})
    assert 200 < run.axis("X").position_at(run.m_function(100).at) <= 200.5


def test_a_held_feed_delays_the_arrival(run_nc: RunNc, controller: Controller) -> None:
    run = run_nc(CROSSING, at=[("0.5s", "HLI.FEED_HOLD", 1), ("2s", "HLI.FEED_HOLD", 0)])
    assert run.ended
    assert run.axis("X").position_at(1.9) == run.axis("X").position_at(1.0)
    assert run.duration > 2
    assert controller.read("V.E.COUNT") == 1
