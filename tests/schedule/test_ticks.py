# SPDX-License-Identifier: MIT
"""The schedule beside the ticks of a controller: shares of time, worked out by hand.

NC cycles of 1000 µs, GEO takes 100, suspension comes at 750. Tick k is GEO's call in NC cycle
k + 1; its share is what the decoder had between the call before and this one.
"""

from __future__ import annotations

from typing import Any

import pytest

from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.messages import Collector
from nctakt.schedule.assemble import assemble
from nctakt.schedule.load import read_load
from nctakt.schedule.simulation.ticks import Share, ThreadRoles, TickSchedule

LIST = """\
interrupt_source 3
external_object_name nctakt
cycle_time 1000
time_slice 250
windows_time 250
thread[0].name GEO
thread[0].cycle 1000
thread[0].priority 115
thread[0].function[0].name task_int
thread[1].name BACKGROUND
thread[1].cycle 1000
thread[1].priority 105
thread[1].function[0].name task_rnd
"""
EXTERNAL = "external_thread[0].semaphore_name plc\nexternal_thread[0].cycle 1000\n"


def scheduled(
    *lines: str,
    task_rnd: object = 600,
    further: str = "",
    system: str = "rtx",
    every: int = 1,
    plc: int | None = None,
) -> TickSchedule:
    """The schedule of a list with further lines and a load."""
    load = f"[functions]\ntask_int = 100\ntask_rnd = {task_rnd}\ntask_com = 200\n{further}"
    text = LIST + "\n".join(lines) + "\nEnd\n"
    collector = Collector()
    options = RtconfOptions(PROFILES[system])
    configuration = load_rtconf("rtconf.lis", text.encode(), collector, options)
    model = assemble(configuration, read_load("l", load, collector), options.profile, collector)
    return TickSchedule(model, ThreadRoles(every, (0,), (((1,), (0,)),), plc))


def shares(count: int, *lines: str, **load: Any) -> list[Share]:
    """Its first shares."""
    schedule = scheduled(*lines, **load)
    return [schedule.next_share() for _ in range(count)]


def decoding(found: list[Share]) -> list[int]:
    """The decoder's time of each share in µs."""
    return [share.decoding[0] // 1000 for share in found]


def test_only_the_calls_of_the_decoder_count() -> None:
    """P-RTCF-00012: task_com in the same thread takes its time, which is no time of the decoder."""
    com = "thread[1].function[1].name task_com"
    assert decoding(shares(3, com, task_rnd=400)) == [400, 400, 400]
    before = ["thread[1].function[0].name task_com", "thread[1].function[1].name task_rnd"]
    assert decoding(shares(3, *before, task_rnd=400)) == [400, 400, 400]


def test_calls_per_cycle() -> None:
    """P-RTCF-00013: two calls of 300 µs."""
    calls = "thread[1].function[0].calls_per_cycle 2"
    assert decoding(shares(3, calls, task_rnd=300)) == [600, 600, 600]


def test_a_thread_of_each_third_nc_cycle() -> None:
    """P-RTCF-00009: the NC cycles 0, 3, 6, which come before the ticks 0, 3, 6."""
    assert decoding(shares(7, "thread[1].cycle 3000")) == [600, 0, 0, 600, 0, 0, 600]


def test_suspended_decoder() -> None:
    """P-RTCF-00004: 1000 µs are 100 … 750 of one cycle and 100 … 450 of the next one.

    There it is due again while it is busy: the NC cycles 1 and 3, ticks 0 and 2.
    """
    found = shares(4, task_rnd=1000)
    assert decoding(found) == [650, 350, 650, 350]
    assert [share.overflows for share in found] == [(1,), (), (1,), ()]
    assert not any(share.is_lost for share in found)


def test_without_windows_time() -> None:
    """P-RTCF-00004 0: 1000 µs are 900 and 100."""
    assert decoding(shares(4, "windows_time 0", task_rnd=1000)) == [900, 100, 900, 100]


def test_a_decoder_before_the_interpolation() -> None:
    """P-RTCF-00010: on VxWorks 105 comes before 115; what it does before GEO begins is in time.

    1200 µs: 0 … 750 of NC cycle 0, 0 … 450 of cycle 1, where GEO begins at 450.
    """
    assert decoding(shares(4, task_rnd=1200, system="vxworks")) == [450, 750, 450, 750]


def test_a_processor_of_its_own() -> None:
    """P-RTCF-00015: on CPU 2 the decoder begins with GEO, so nothing of it is in time for GEO."""
    cpus = "[machine]\ncpus = 2\n"
    assert decoding(shares(3, "thread[1].cpu 2", task_rnd=700, further=cpus)) == [700, 700, 700]


def test_overheads_are_no_time_of_the_decoder() -> None:
    """GEO 0 … 115, then 15 µs for switching and activation, then 620 up to the suspension."""
    costs = "[overheads]\nswitch = 10\nactivation = 5\n"
    assert decoding(shares(1, task_rnd=700, further=costs)) == [620]


def test_times_of_a_list() -> None:
    """Calls take the times of the list in turn."""
    assert decoding(shares(4, task_rnd=[100, 200, 300])) == [100, 200, 300, 100]


def test_an_interpolation_of_two_nc_cycles() -> None:
    """P-RTCF-00009: a tick is a call of task_int; the decoder is called twice for it."""
    assert decoding(shares(3, "thread[0].cycle 2000", every=2)) == [1200, 1200, 1200]


@pytest.mark.parametrize(("priority", "calls"), [(110, [1, 1, 1]), (120, [1, 1, 1])])
def test_a_plc_after_or_before_the_interpolation(priority: int, calls: list[int]) -> None:
    """P-RTCF-00007: one call between two ticks, whichever comes first."""
    further = f"[external.plc]\ntime = 50\npriority = {priority}\n"
    found = shares(3, EXTERNAL, further=further, plc=2)
    assert [share.plc_calls for share in found] == calls


def test_a_plc_that_takes_longer_than_a_cycle() -> None:
    """Its wake-ups wait, as those of a semaphore: 1500 µs each after GEO and before BACKGROUND.

    It has 900 µs of each NC cycle, so it ends after 1500 of 1800, 3000 of 3600, 4500 of 4500 (with
    the interrupt, which still is the cycle before) and 6000 of 6300: in the cycles 1, 3, 4 and 6.
    """
    further = "[external.plc]\ntime = 1500\npriority = 110\n"
    found = shares(6, EXTERNAL, further=further, plc=2)
    assert [share.plc_calls for share in found] == [1, 0, 1, 1, 0, 1]


def test_a_lost_tick() -> None:
    """GEO takes 100 and 1600 µs in turn; NC cycle 2 is due while that of cycle 1 is busy: tick 1.

    100, then 1000 … 2600; cycle 3: 3000 … 3100, cycle 4: 4000 … 5600, so cycle 5 is tick 4.
    """
    load = '"thread[0].function[0]" = [100, 1600]\n'
    found = shares(6, task_rnd=10, further=load)
    assert [share.is_lost for share in found] == [False, True, False, False, True, False]


@pytest.mark.parametrize("every", [1, 2])
@pytest.mark.parametrize("prepared", [0, 1])
def test_windows_is_counted_over_the_ticks_that_were(every: int, prepared: int) -> None:
    """GEO takes 100 and 900 µs in turn: every second cycle leaves Windows 100 of its 250 µs.

    Cycle 0 lies before tick 0; the ticks begin with cycle 1, of 900 µs. One more tick may be
    prepared than was run. With two NC cycles a tick the call is only in every second cycle.
    """
    lines = () if every == 1 else ("thread[0].cycle 2000",)
    schedule = scheduled(
        *lines, task_rnd=10, every=every, further='"thread[0].function[0]" = [100, 900]\n'
    )
    for _ in range(5 + prepared):
        schedule.next_share()
    numbers = schedule.simulation(5)
    assert numbers.cycles == 5 * every
    assert [one.violated for one in numbers.windows] == [3, 3]
    assert numbers.windows[0].culprits == (3, 0)
