# SPDX-License-Identifier: MIT
"""nctakt: a virtual CNC controller that runs NC programs with realtime cycles tick by tick.

    from nctakt import Controller, NcText

    program = NcText("part.nc", '''
    #RT CYCLE [ID=1 SCOPE=PROG]
      $IF ONCE V.RTA.ACS.ACT_POS.X > 40
        M100
      $ENDIF
    #RT CYCLE END
    G01 X100 F6000
    M30
    ''')
    controller = Controller()  # the built-in machine; Controller("folder") is that of a folder
    run = controller.run(program, set={"V.E.VALUE": 5}, at=[("20 ms", "V.E.TRIGGER", 1)])
    print(run.state, run.technology[0])

Programs and what comes of them
    ``Controller``         one machine: runs programs, or goes tick by tick
    ``NcText``             a program given as text
    ``Session``            a run that continues, stops and goes back on request
    ``Stimulus``           a variable that gets a value at a time of a run
    ``Study``              many runs of one program: varied, measured, checked
    ``Run``                the result of a run
    ``check``              findings in programs, lists and folders, without a run
    ``Diagnostic``         a finding: number, place, text, remedy
    ``Failure``            raised for what cannot be used; carries diagnostics

Machines
    ``load_machine``       the folder with the lists of a machine -> ``Machine``
    ``Machine``            what the lists say, immutable; ``Controller(machine)`` builds it

The PLC on the other side of the interface
    ``Plc``                to derive from; methods are marked with ``at``, ``on``, ``when``
    ``at``                 call a method at a time of the run
    ``on``                 call a method with each of these functions: ``@on("M100")``
    ``when``               call a method each time that a condition becomes true
    ``after``              acknowledge functions late: ``acknowledge = after("20 ms")``
    ``only``               acknowledge these functions and no others
    ``ALL``, ``NONE``      acknowledge every function, or none: ``acknowledge = NONE``
    ``run_up``             acknowledge a spindle's job when its speed is reached
    ``HliView``            the interface that its methods get: ``def each_tick(self, hli: HliView)``
    ``ToolData``           the data of a tool, by which ``Plc.tool_data`` answers a D
    ``ToolRequest``        what it is asked for
    ``Function``           an M, H or T function that waits for its acknowledgement
    ``SpindleJob``         a job of a spindle that the PLC turns

Scheduling lists (rtconf.lis)
    ``open_schedule``      a list and its load -> what gives a controller its time
    ``simulate_schedule``  simulate it without a controller

A time is a text with a unit (``"1.5 s"``, ``"20 ms"``, ``"1500us"``, ``"2 min"``, ``"1 h"``,
``"300 ticks"``), a number of seconds or a ``datetime.timedelta``; a name that ends in ``_us``
holds microseconds. Tests with pytest use the fixtures ``machine``, ``controller``, ``run_nc`` and
``study``; ``RunNc`` and ``RunStudy`` are the types of the last two.

These names, those of ``nctakt.plc`` (function blocks such as ``MC_MoveAbsolute``) and of
``nctakt.hli`` (the interface byte by byte) are public. Everything else is private to the project
and may move or change at any time.
"""

from nctakt.base.lazy_names import import_when_used
from nctakt.base.version import __version__ as __version__

TYPE_CHECKING = False  # type checkers know better, and importing typing takes longer than this
if TYPE_CHECKING:
    from nctakt.base.diagnostics import Diagnostic
    from nctakt.base.failure import Failure
    from nctakt.checking.python_check import check
    from nctakt.lists.machine.machine import Machine, load_machine
    from nctakt.plc.policies import ALL, NONE, after, only, run_up
    from nctakt.plc.public_types import Function, HliView, SpindleJob
    from nctakt.plc.script import Plc, at, on, when
    from nctakt.plc.tool_manager import ToolData, ToolRequest
    from nctakt.results.run import Run
    from nctakt.run.access.stimuli import Stimulus
    from nctakt.run.controller import Controller
    from nctakt.run.program_loader import NcText
    from nctakt.schedule.open_schedule import open_schedule, simulate_schedule
    from nctakt.session.session import Session
    from nctakt.studies.fixture import RunStudy
    from nctakt.studies.study import Study
    from nctakt.testing.queries import RunNc

__all__ = [
    "ALL",
    "NONE",
    "Controller",
    "Diagnostic",
    "Failure",
    "Function",
    "HliView",
    "Machine",
    "NcText",
    "Plc",
    "Run",
    "RunNc",
    "RunStudy",
    "Session",
    "SpindleJob",
    "Stimulus",
    "Study",
    "ToolData",
    "ToolRequest",
    "after",
    "at",
    "check",
    "load_machine",
    "on",
    "only",
    "open_schedule",
    "run_up",
    "simulate_schedule",
    "when",
]

#: The module of each public name; it is imported when the name is first used.
_MODULES = {
    "ALL": "nctakt.plc.policies",
    "NONE": "nctakt.plc.policies",
    "Controller": "nctakt.run.controller",
    "Diagnostic": "nctakt.base.diagnostics",
    "Failure": "nctakt.base.failure",
    "Function": "nctakt.plc.public_types",
    "HliView": "nctakt.plc.public_types",
    "Machine": "nctakt.lists.machine.machine",
    "NcText": "nctakt.run.program_loader",
    "Plc": "nctakt.plc.script",
    "Run": "nctakt.results.run",
    "RunNc": "nctakt.testing.queries",
    "RunStudy": "nctakt.studies.fixture",
    "Session": "nctakt.session.session",
    "SpindleJob": "nctakt.plc.public_types",
    "Stimulus": "nctakt.run.access.stimuli",
    "Study": "nctakt.studies.study",
    "ToolData": "nctakt.plc.tool_manager",
    "ToolRequest": "nctakt.plc.tool_manager",
    "after": "nctakt.plc.policies",
    "at": "nctakt.plc.script",
    "check": "nctakt.checking.python_check",
    "load_machine": "nctakt.lists.machine.machine",
    "on": "nctakt.plc.script",
    "only": "nctakt.plc.policies",
    "open_schedule": "nctakt.schedule.open_schedule",
    "run_up": "nctakt.plc.policies",
    "simulate_schedule": "nctakt.schedule.open_schedule",
    "when": "nctakt.plc.script",
}


__getattr__ = import_when_used(globals(), _MODULES)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
