# SPDX-License-Identifier: MIT
"""The manual's two example lists, typed anew, and how the tests make models of lists."""

from __future__ import annotations

from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.messages import Collector
from nctakt.schedule.assemble import assemble
from nctakt.schedule.load import ASSUMED, read_load
from nctakt.schedule.model import Model, Rules

HEAD = """\
# *****
#
# *****
# RTX [0; 127] 127 highest
# VXWORKS [0; 255] 0 highest
# INTIME [0; 255] 0 highest
#
"""
TIMES = """\
cycle_time 2000 # Cycle time in micro s
time_slice 500
windows_time 500 # 0 turned off
#
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115 # HIGHEST
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[0].function[0].calls_per_cycle 1
thread[0].function[0].trace_bit 1
#
thread[1].name BACKGROUND_
thread[1].cycle 2000
thread[1].priority 105 # NORMAL
thread[1].error_on_overflow 0
thread[1].function[0].name task_rnd
thread[1].function[0].calls_per_cycle 1
thread[1].function[0].trace_bit 2
"""
DRIVER = """\
#
thread[2].name MMI_DRIVER
thread[2].cycle 6000
thread[2].priority 95 # LOWEST
thread[2].error_on_overflow 0
thread[2].function[0].name task_mmi_driver
thread[2].function[0].calls_per_cycle 1
thread[2].function[0].trace_bit 0
"""
COMMUNICATION = """\
#
thread[3].name COM
thread[3].cycle 4000
thread[3].priority 90
thread[3].error_on_overflow 0
thread[3].function[0].name task_com
thread[3].function[0].calls_per_cycle 1
thread[3].function[0].trace_bit 4
"""
MOVED = """\
thread[1].function[1].name task_com
thread[1].function[1].calls_per_cycle 1
thread[1].function[1].trace_bit 4
"""
EXTERNAL = """\
#
external_thread[0].semaphore_name external_sps
external_thread[0].cycle 2000
#
End
"""
EXAMPLE_1 = (
    f"{HEAD}interrupt_source 2 # 1: internal timer, 2: IRQ, 3: Semaphore\n"
    f"{TIMES}{DRIVER}{COMMUNICATION}{EXTERNAL}"
)
EXAMPLE_2 = (
    f"{HEAD}interrupt_source 2 # 1 == internal timer, 2 == external\n"
    f"{TIMES}{MOVED}{DRIVER}"
    + "# task_com repositioned to thread[1]:\n"
    + "".join(f"# {line}\n" for line in COMMUNICATION.splitlines()[1:])
    + EXTERNAL
)


def german(text: str) -> str:
    """An example list as the German manual has it."""
    return (
        text.replace("internal timer", "internal Timer")
        .replace("Cycle time in micro s", "Zykluszeit in micro s")
        .replace("repositioned to thread[1]", "nach thread[1] verlagert")
        .replace("\nEnd\n", "\nEnde\n")
    )


TIGHT = {
    "task_int": 400,
    "task_rnd": 700,
    "task_mmi_driver": 300,
    "task_com": 250,
    "external_sps": 200,
}
TABLE = RtconfOptions(convention="table")


def configure(text: str, options: RtconfOptions = TABLE) -> RtconfConfiguration:
    """The configuration of a list."""
    return load_rtconf("rtconf.lis", text.encode(), Collector(), options)


def load_text(times: dict[str, int], priority: int = 110, extra: str = "") -> str:
    """A load file with constant times; ``extra`` is in front."""
    functions = "".join(
        f"{name} = {time}\n" for name, time in times.items() if name != "external_sps"
    )
    external = f"[external.external_sps]\ntime = {times['external_sps']}\npriority = {priority}\n"
    return f"{extra}\n[functions]\n{functions}{external}"


def make(
    text: str,
    load: str | None,
    *,
    os: str = "rtx",
    convention: str = "table",
    rules: Rules | None = None,
) -> tuple[Model, list[int]]:
    """The model of a list and a load file, and what was found on the way from the load on."""
    profile = PROFILES[os]
    assert convention in ("auto", "table", "field")
    options = RtconfOptions(profile=profile, convention=convention)
    collector = Collector()
    loaded = ASSUMED if load is None else read_load("load.toml", load, collector)
    model = assemble(configure(text, options), loaded, profile, collector, rules=rules or Rules())
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return model, [found.id for found in collector.diagnostics]


def change(text: str, **values: object) -> str:
    """A list with other values of some basic parameters."""
    lines = text.splitlines()
    for key, value in values.items():
        place = next(i for i, line in enumerate(lines) if line.startswith(f"{key} "))
        lines[place] = f"{key} {value}"
    return "\n".join(lines) + "\n"


def with_line(text: str, *lines: str) -> str:
    """A list with further lines before its end; of two for one parameter the last counts."""
    return text.replace("\nEnd\n", "\n" + "\n".join(lines) + "\nEnd\n")
