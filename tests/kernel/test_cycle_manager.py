# SPDX-License-Identifier: MIT
"""The life of realtime cycles: each management command in each state, slots, room for 256."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest
from support.kernel_rig import DEMO, Rig, controller_with

from nctakt.kernel import codes, rows
from nctakt.kernel.cycles.cycles import RealtimeCycle
from nctakt.kernel.cycles.instructions import Statement
from nctakt.run.controller import Controller, NcText

START, HOLD, CONTINUE, ABORT, DELETE = 1, 2, 3, 4, 5
ID = 7


class Managed(Rig):
    """A rig with one cycle that is brought into a state; what a command does to it is read off."""

    def __init__(self, scope: int, *, starts: bool = True) -> None:
        super().__init__()
        self.made = RealtimeCycle(Statement(), 1, 3, 0)
        self.slot = self.channel.manager.load(self.made, ID, scope, 0)
        self.channel.queue.put([rows.DEFINE_CYCLE, 0, 0, self.slot, starts])

    def command(self, action: int) -> None:
        """Append a management command for the cycle."""
        self.channel.queue.put([rows.CONTROL_CYCLE, 0, 0, action, ID])

    def events(self) -> list[tuple[int, float]]:
        """Kind and first value of the events of one more tick."""
        self.machine.reserve()
        self.machine.kernel.run(1)
        events = self.machine.record.take_events()
        self.machine.record.take_probes()
        unpacked = struct.iter_unpack(f"={rows.EVENT_WIDTH}d", events)
        return [(int(row[rows.EVENT_KIND]), row[rows.EVENT_A]) for row in unpacked]

    @property
    def state(self) -> int:
        """The state of the cycle's slot."""
        return self.channel.manager.state_of(self.slot)


def unknown() -> Managed:
    """No cycle has the ID any more."""
    rig = Managed(codes.PROG_SCOPE)
    rig.run(1)
    rig.command(DELETE)
    rig.run(1)
    return rig


def defined(scope: int = codes.PROG_SCOPE) -> Managed:
    """Defined, never started."""
    rig = Managed(scope, starts=False)
    rig.run(1)
    return rig


def armed() -> Managed:
    """Scope BLOCK, before its block."""
    rig = Managed(codes.BLOCK_SCOPE)
    rig.run(1)
    return rig


def running(scope: int = codes.PROG_SCOPE) -> Managed:
    """Running, with a block if that is its scope."""
    rig = Managed(scope)
    if scope == codes.BLOCK_SCOPE:
        rig.dwell(1000)
    rig.run(1)
    return rig


def held(scope: int = codes.PROG_SCOPE) -> Managed:
    """Held while it ran."""
    rig = Managed(scope)
    rig.run(1)
    rig.command(HOLD)
    rig.run(1)
    return rig


STATES = {
    "unknown": unknown,
    "defined": defined,
    "defined BLOCK": lambda: defined(codes.BLOCK_SCOPE),
    "armed": armed,
    "running": running,
    "running GLOBAL": lambda: running(codes.GLOBAL_SCOPE),
    "held": held,
    "held GLOBAL": lambda: held(codes.GLOBAL_SCOPE),
    "held before its block": lambda: held(codes.BLOCK_SCOPE),
}

NO_CYCLE = [(rows.EVENT_ERROR, 50858.0)]
STARTED = [(rows.EVENT_STARTED, 0.0)]
ABORTED = [(rows.EVENT_ABORTED, 0.0)]
DELETED = [(rows.EVENT_ENDED, float(rows.ENDED_BY_DELETE))]

#: What a command does in a state: the events, and the state afterwards.
EFFECTS = {
    ("unknown", START): (NO_CYCLE, codes.ENDED),
    ("unknown", HOLD): (NO_CYCLE, codes.ENDED),
    ("unknown", CONTINUE): (NO_CYCLE, codes.ENDED),
    ("unknown", ABORT): (NO_CYCLE, codes.ENDED),
    ("unknown", DELETE): ([(rows.EVENT_NOTICE, 900410.0)], codes.ENDED),
    ("defined", START): (STARTED, codes.RUNNING),
    ("defined BLOCK", START): (STARTED, codes.ARMED),
    ("armed", START): (STARTED, codes.ARMED),
    ("armed", HOLD): ([(rows.EVENT_HELD, 0.0)], codes.HELD),
    ("running", START): (STARTED, codes.RUNNING),
    ("running", HOLD): ([(rows.EVENT_HELD, 0.0)], codes.HELD),
    ("running GLOBAL", HOLD): ([(rows.EVENT_HELD, 0.0)], codes.HELD),
    ("held", START): (STARTED, codes.RUNNING),
    ("held", CONTINUE): ([(rows.EVENT_CONTINUED, 0.0)], codes.RUNNING),
    ("held GLOBAL", CONTINUE): ([(rows.EVENT_CONTINUED, 0.0)], codes.RUNNING),
    ("held before its block", CONTINUE): ([(rows.EVENT_CONTINUED, 0.0)], codes.ARMED),
    ("held before its block", START): (STARTED, codes.ARMED),
}


def expected(name: str, action: int, before: int) -> tuple[list[tuple[int, float]], int]:
    """The table's entry, else: ABORT is reported, DELETE ends, all others only give a notice."""
    if (name, action) in EFFECTS:
        return EFFECTS[(name, action)]
    if action == START:
        return STARTED, codes.RUNNING
    if action == HOLD:
        return [(rows.EVENT_NOTICE, 900411.0)], before
    if action == CONTINUE:
        return [(rows.EVENT_NOTICE, 900412.0)], before
    return (ABORTED, before) if action == ABORT else (DELETED, codes.ENDED)


@pytest.mark.parametrize("action", [START, HOLD, CONTINUE, ABORT, DELETE])
@pytest.mark.parametrize("name", STATES)
def test_every_command_in_every_state(name: str, action: int) -> None:
    """Each command does what RC-111 says in each state of a cycle, and runs it or not."""
    rig = STATES[name]()
    before = rig.state
    events, after = expected(name, action, before)
    rig.command(action)
    assert rig.events() == events
    assert rig.state == after
    runs = rig.made.runs
    rig.run(3)
    assert rig.made.runs - runs == (3 if after == codes.RUNNING else 0)
    assert bool(rig.channel.executor.is_stopped) is (events == NO_CYCLE)


@pytest.mark.parametrize(("action", "waits"), [(HOLD, True), (DELETE, True), (ABORT, False)])
def test_hold_and_delete_wait_for_the_first_run(action: int, waits: bool) -> None:
    """HOLD and DELETE are not taken in the tick in which the cycle was started (RC-004)."""
    rig = Managed(codes.PROG_SCOPE)
    rig.command(action)
    first = rig.events()
    assert (len(first) == 2) is waits
    assert rig.made.runs == 1
    assert len(rig.events()) == (1 if waits else 0)


def test_a_block_cycle_with_def_is_armed_by_each_start() -> None:
    """With DEF each START arms it for one block; held before it, it waits again (RC-105)."""
    rig = Managed(codes.BLOCK_SCOPE, starts=False)
    for ticks in (3, 5):
        rig.command(START)
        rig.dwell(ticks)
        rig.run_to_the_end()
    rig.dwell(4)
    rig.run_to_the_end()
    assert rig.made.runs == 8
    assert rig.state == codes.DEFINED


def test_a_block_cycle_held_in_its_block_ends_with_it() -> None:
    """A block that passes ends the cycle that was held in it, whether it runs or not."""
    controller = Controller(DEMO)
    run = controller.run(
        NcText(
            "p.nc",
            "#RT CYCLE [ID=1 SCOPE=BLOCK]\nV.E.COUNT += 1\n#RT CYCLE END\n"
            "G04 X0.003\n#RT CYCLE HOLD [ID=1]\nG04 X0.002\n#RT CYCLE CONTINUE [ID=1]\nM30",
        )
    )
    assert controller.read("V.E.COUNT") == 3
    assert [found.id for found in run.errors] == [50858]


def test_end_of_program_ends_what_is_local() -> None:
    """M30 ends BLOCK and PROG cycles in each state, GLOBAL ones live on (RC-105 … RC-107)."""
    rig = Rig()
    made = {
        scope: rig.cycle(scope, identity=scope + 1)
        for scope in (codes.BLOCK_SCOPE, codes.PROG_SCOPE, codes.GLOBAL_SCOPE)
    }
    rig.run(1)
    rig.channel.queue.put([rows.PROGRAM_END, 0, 0, 0])
    rig.run(1)
    assert rig.channel.executor.program_ended
    rig.channel.accept_end()
    rig.run(5)
    assert [
        made[scope].runs for scope in (codes.BLOCK_SCOPE, codes.PROG_SCOPE, codes.GLOBAL_SCOPE)
    ] == [0, 1, 7]
    assert rig.channel.manager.running_count == 1
    assert rig.channel.manager.armed_count == 0


def test_a_reset_keeps_global_cycles_with_their_states() -> None:
    """In a reset no cycle runs; PROG cycles are deleted, GLOBAL ones run on after it (RC-007)."""
    rig = Rig()
    local, everywhere = rig.cycle(codes.PROG_SCOPE, 1), rig.cycle(codes.GLOBAL_SCOPE, 2)
    rig.segment(200.0)
    rig.run(300)
    rig.channel.request_reset()
    while rig.channel.executor.is_resetting:
        rig.run(1)
    assert (local.runs, everywhere.runs) == (300, 300)
    assert len(rig.x) > 400
    rig.run(10)
    assert (local.runs, everywhere.runs) == (300, 310)


# --- room ---------------------------------------------------------------------------------------

LOOP = """V.E.COUNT = 0
$FOR P1 = 1, {count}, 1
  #RT CYCLE [SCOPE=BLOCK]
    $IF ONCE TRUE
      V.E.COUNT += 1
    $ENDIF
  #RT CYCLE END
  G04 X0.001
$ENDFOR
M30"""


def test_a_thousand_block_cycles_run_through() -> None:
    """Slots of ended cycles are used again: 1,000 definitions in a loop, each runs once."""
    controller = Controller(DEMO)
    run = controller.run(NcText("p.nc", LOOP.format(count=1000)))
    assert run.state == "ended"
    assert run.ticks == 1001
    assert controller.read("V.E.COUNT") == 1000
    assert [event.kind for event in run.events].count("created") == 1000
    assert [one.instances for one in run.cycles] == [1000]


def many(count: int, scope: str = "PROG") -> str:
    """This many cycles that count their first run."""
    one = f"#RT CYCLE [SCOPE={scope}]\n$IF ONCE TRUE\nV.E.COUNT += 1\n$ENDIF\n#RT CYCLE END\n"
    return one * count


#: Room for far more cycles than there are slots (P-CHAN-00407).
MEMORY = "configuration.rt_cycles.memory 1000000"


@pytest.mark.parametrize(("count", "errors"), [(255, []), (256, []), (257, [50877])])
def test_there_is_room_for_256_living_cycles(tmp_path: Path, count: int, errors: list[int]) -> None:
    """The 257th living cycle is 50877; all before it have started."""
    controller = controller_with(tmp_path, MEMORY)
    run = controller.run(NcText("p.nc", many(count) + "G04 X0.01\nM30"))
    assert [found.id for found in run.errors] == errors
    assert controller.read("V.E.COUNT") == min(count, 256)
    assert run.state == ("error" if errors else "ended")


def test_the_decoder_waits_for_slots_of_blocks_that_still_run(tmp_path: Path) -> None:
    """200 cycles of one block and 200 of the next: none is lost, none comes before its block."""
    controller = controller_with(tmp_path, MEMORY)
    text = (
        f"{many(200, 'BLOCK')}N10 G04 X0.05\n{many(200, 'BLOCK')}N20 G04 X0.05\nN30 G04 X0.001\nM30"
    )
    run = controller.run(NcText("p.nc", text))
    assert run.errors == ()
    assert controller.read("V.E.COUNT") == 400
    assert run.trace is not None
    second = int(run.trace["BLOCK"].tolist().index(20.0))
    fired = [event.tick for event in run.events if event.kind == "fired"]
    assert sorted(set(fired)) == [0, second]
    assert fired.count(0) == fired.count(second) == 200


def test_a_slot_is_free_again_when_its_cycle_is_deleted(tmp_path: Path) -> None:
    """A full house, one DELETE, and the next definition fits."""
    text = many(255) + "#RT CYCLE [ID=1 SCOPE=PROG]\n#RT CYCLE END\nG04 X0.001\n"
    text += "#RT CYCLE DELETE [ID=1]\n" + many(1) + "G04 X0.001\nM30"
    controller = controller_with(tmp_path, MEMORY)
    assert controller.run(NcText("p.nc", text)).errors == ()
    assert controller.read("V.E.COUNT") == 256


def test_a_program_that_was_given_up_leaves_no_slot_behind(tmp_path: Path) -> None:
    """What an aborted program had loaded ahead is free for the next one (RC-007)."""
    controller = controller_with(tmp_path, MEMORY)
    broken = many(10) + "G04 X0.1\n" + many(240)
    for _ in range(3):
        run = controller.run(NcText("a.nc", broken + "G04 X[1 / V.E.ASYNC]\nM30"))
        assert run.state == "error"
        assert run.errors[-1].id == 20396
    controller.write("V.E.COUNT", 0)
    assert controller.run(NcText("b.nc", many(256) + "G04 X0.001\nM30")).state == "ended"
    assert controller.read("V.E.COUNT") == 256


def test_an_id_can_be_used_again_after_its_cycle() -> None:
    """Define, delete, define with the same ID, a hundred times over."""
    body = (
        "$FOR P1 = 1, 100, 1\n#RT CYCLE [ID=5 SCOPE=PROG]\nV.E.COUNT += 1\n#RT CYCLE END\n"
        "#RT CYCLE DELETE [ID=5]\n$ENDFOR\nM30"
    )
    controller = Controller(DEMO)
    assert controller.run(NcText("p.nc", body)).errors == ()
    assert controller.read("V.E.COUNT") >= 100
