# SPDX-License-Identifier: MIT
"""The cycle manager: loaded realtime cycles, their life, and their run-through in each tick.

RC-102 … RC-114, RC-505. Python fills a slot ahead of time (``load``); the command queue names the
slot, the tick arms it; dead slots are freed between runs (``free_ended``). The data for the tick's
decisions is in arrays over the slots, the code it runs in a tree of groups of four in creation
order.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_index, check_range, check_size
from nctakt.kernel.base.record import Record
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.instructions import Statement


class RunThrough:
    """Base, and null object, of a node that the manager runs in a tick."""

    def run_through(self, manager: CycleManager, context: Context) -> int:
        """Run the node; return 1 if a fault stops the cycles of this tick, else 0."""
        return 0


class Group(RunThrough):
    """Four nodes in order."""

    def __init__(
        self, first: RunThrough, second: RunThrough, third: RunThrough, fourth: RunThrough
    ) -> None:
        self.first = first
        self.second = second
        self.third = third
        self.fourth = fourth

    def run_through(self, manager: CycleManager, context: Context) -> int:
        if self.first.run_through(manager, context):
            return 1
        if self.second.run_through(manager, context):
            return 1
        if self.third.run_through(manager, context):
            return 1
        return self.fourth.run_through(manager, context)


class RealtimeCycle(RunThrough):
    """A loaded realtime cycle.

    ``serial`` names it in events; ``events`` and ``probes`` bound what one run-through can record.
    ``probe`` is its number in the probe rows, ``next_tick`` the tick after its last run-through.
    ``size`` is its share of the memory of P-CHAN-00407, in bytes.
    """

    def __init__(
        self, body: Statement, serial: int, events: int, probes: int, size: int = 0
    ) -> None:
        self.body = body
        self.size = size
        self.serial = serial
        self.events = events
        self.probes = probes
        self.probe = 0
        self.slot = -1
        self.runs = 0
        self.next_tick = -1

    def run_through(self, manager: CycleManager, context: Context) -> int:
        if manager.state[self.slot] != codes.RUNNING:
            return 0
        if manager.restarts[self.slot]:
            manager.restarts[self.slot] = 0
            self.body.restart()
        if self.next_tick != context.tick:
            context.record.series(self.probe, rows.PROBE_EVALUATED, self.next_tick)
        self.next_tick = context.tick + 1
        self.runs += 1
        context.serial = self.serial
        context.owner = manager.first_owner + self.slot
        context.run = self.runs
        if self.body.run(context):
            manager.fail(self.slot, context)
            return 1
        return 0


class CycleManager:
    """The realtime cycles of one channel; at most ``capacity`` slots."""

    def __init__(
        self, record: Record, single_axes: SingleAxes, first_owner: int, capacity: int = 256
    ) -> None:
        check_size(capacity, "number of slots")
        self.record = record
        self.spindles = Spindles(bytearray(8), 0, 0, record, 1000)
        self.single_axes = single_axes
        self.first_owner = first_owner
        self.capacity = capacity
        self.state = integers(capacity)
        self.identity = integers(capacity)
        self.scope = integers(capacity)
        self.source = integers(capacity)
        self.serial = integers(capacity)
        self.reusable = integers(capacity)
        self.restarts = integers(capacity)
        self.started_tick = integers(capacity)
        self.block = integers(capacity)
        self.size = integers(capacity)
        self.moves_on = integers(capacity)
        self.memory_limit = 1 << 62
        self.memory_used = 0
        self.loaded: list[RealtimeCycle] = []
        self.order = integers(capacity)
        self.loaded_count = 0
        self.root = RunThrough()
        self.latest_start = -1
        self.running_count = 0
        self.armed_count = 0
        self.in_block_count = 0
        self.ended_count = 0
        self.events_bound = 0
        self.probes_bound = 0

    # --- Python's side, between two runs --------------------------------------------------------

    def free_slot(self) -> int:
        """Slot for another cycle, -1 if all are taken."""
        for slot in range(self.capacity):
            if self.state[slot] == codes.EMPTY:
                return slot
        return -1

    def load(
        self,
        cycle: RealtimeCycle,
        identity: int,
        scope: int,
        source: int,
        moves_on: bool = False,
    ) -> int:
        """Fill a slot; return its number, or -1 if none is free. ``identity`` 0: no ID.

        ``moves_on``: END_ACTION is MOVE_CONT (RC-110).
        """
        check_range(scope, codes.BLOCK_SCOPE, codes.GLOBAL_SCOPE, "scope")
        slot = self.free_slot()
        if slot < 0:
            return -1
        self.state[slot] = codes.LOADED
        self.identity[slot] = identity
        self.scope[slot] = scope
        self.source[slot] = source
        self.serial[slot] = cycle.serial
        self.size[slot] = cycle.size
        self.moves_on[slot] = moves_on
        self.reusable[slot] = 0
        self.restarts[slot] = 0
        self.started_tick[slot] = -1
        cycle.slot = slot
        self.loaded.append(cycle)
        self.arrange()
        return slot

    def free_ended(self) -> list[RealtimeCycle]:
        """Empty the slots of ended cycles and return the cycles."""
        self.ended_count = 0
        ended = [cycle for cycle in self.loaded if self.state[cycle.slot] == codes.ENDED]
        if ended:
            self.loaded = [cycle for cycle in self.loaded if self.state[cycle.slot] != codes.ENDED]
            for cycle in ended:
                self.state[cycle.slot] = codes.EMPTY
            self.arrange()
        return ended

    def drop_undefined(self) -> None:
        """Drop cycles whose definition was never executed: their program was aborted."""
        for cycle in self.loaded:
            if self.state[cycle.slot] == codes.LOADED:
                self.state[cycle.slot] = codes.ENDED

    def arrange(self) -> None:
        """Arrange the loaded cycles in order of creation: tree of groups, and their slots."""
        level: list[RunThrough] = list(self.loaded)
        nothing = RunThrough()
        while len(level) > 1:
            level += [nothing] * ((4 - len(level) % 4) % 4)
            level = [Group(*level[i : i + 4]) for i in range(0, len(level), 4)]
        self.root = level[0] if level else nothing
        self.loaded_count = len(self.loaded)
        for index, cycle in enumerate(self.loaded):
            self.order[index] = cycle.slot
        self.events_bound = sum(cycle.events for cycle in self.loaded)
        self.probes_bound = sum(cycle.probes for cycle in self.loaded)

    def state_of(self, slot: int) -> int:
        """State of a slot; raise ``ValueError`` for an unknown one."""
        check_index(slot, self.capacity, "slot")
        return self.state[slot]

    # --- the tick -------------------------------------------------------------------------------

    def find(self, identity: int) -> int:
        """Slot of the living cycle with this ID, -1 without one."""
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.identity[slot] == identity and self.is_alive(slot):
                return slot
        return -1

    def is_alive(self, slot: int) -> int:
        """Return whether a cycle is defined and has not ended."""
        return 1 if codes.DEFINED <= self.state[slot] <= codes.HELD else 0

    def enter(self, slot: int, state: int) -> None:
        """Change a slot's state and keep the counts."""
        before = self.state[slot]
        if before == codes.RUNNING:
            self.running_count -= 1
        self.armed_count -= self.awaits_block(slot)
        self.state[slot] = state
        if self.block[slot] != 0 and state not in (codes.RUNNING, codes.HELD):
            self.block[slot] = 0
            self.in_block_count -= 1
        if state == codes.RUNNING:
            self.running_count += 1
        self.armed_count += self.awaits_block(slot)
        if state in (codes.DEFINED, codes.ENDED):
            self.spindles.leave(self.serial[slot])
        if state == codes.ENDED:
            self.ended_count += 1
            if before != codes.LOADED:
                self.memory_used -= self.size[slot]

    def awaits_block(self, slot: int) -> int:
        """Return whether a started or held cycle with scope BLOCK still waits for its block."""
        if self.scope[slot] != codes.BLOCK_SCOPE or self.block[slot] != 0:
            return 0
        return 1 if self.state[slot] in (codes.ARMED, codes.HELD) else 0

    def define(self, slot: int, starts: int, tick: int) -> int:
        """Define a cycle; return 0, or the refusing message (RC-102, RC-108, RC-504)."""
        if self.identity[slot] > 0 and self.find(self.identity[slot]) >= 0:
            self.enter(slot, codes.ENDED)
            return 50900
        if self.memory_used + self.size[slot] > self.memory_limit:
            self.enter(slot, codes.ENDED)
            return 50857 if self.size[slot] > self.memory_limit else 50855
        self.memory_used += self.size[slot]
        self.record.event(
            rows.EVENT_CREATED, self.source[slot], self.serial[slot], self.scope[slot]
        )
        self.enter(slot, codes.DEFINED)
        self.reusable[slot] = 0 if starts else 1
        if starts:
            self.start(slot, tick, self.source[slot])
        return 0

    def refused_value(self, slot: int, message: int) -> int:
        """Value that a refused definition asked for: its ID, or its bytes of memory."""
        return self.identity[slot] if message == 50900 else self.size[slot]

    def start(self, slot: int, tick: int, source: int) -> None:
        """Start a cycle; one with scope BLOCK waits for the next block (RC-105, RC-111)."""
        self.restarts[slot] = 1
        self.started_tick[slot] = tick
        self.latest_start = tick
        self.spindles.resume(self.serial[slot], tick)
        self.single_axes.resume(self.first_owner + slot)
        self.record.event(rows.EVENT_STARTED, source, self.serial[slot])
        is_armed = self.scope[slot] == codes.BLOCK_SCOPE
        self.enter(slot, codes.ARMED if is_armed else codes.RUNNING)

    def started_this_tick(self, identity: int, tick: int) -> int:
        """Return whether the cycle with this ID was started in this tick (RC-004)."""
        if self.latest_start != tick:
            return 0
        slot = self.find(identity)
        return 1 if slot >= 0 and self.started_tick[slot] == tick else 0

    def has_started_this_tick(self, tick: int) -> int:
        """Return whether a cycle that M30 deletes was started in this tick (RC-004)."""
        if self.latest_start != tick:
            return 0
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.is_alive(slot) and self.scope[slot] != codes.GLOBAL_SCOPE:
                if self.started_tick[slot] == tick:
                    return 1
        return 0

    def control(self, action: int, identity: int, tick: int, source: int) -> int:
        """Carry out ``codes.CONTROL_START`` …; return 0, or the refusing message (RC-111)."""
        slot = self.find(identity)
        if slot < 0:
            if action == codes.CONTROL_DELETE:
                self.record.event(rows.EVENT_NOTICE, source, 0, 900410)
                return 0
            return 50858
        if action == codes.CONTROL_START:
            self.start(slot, tick, source)
        elif action == codes.CONTROL_HOLD:
            self.hold(slot, source)
        elif action == codes.CONTROL_CONTINUE:
            self.resume(slot, source)
        elif action == codes.CONTROL_ABORT:
            self.record.event(rows.EVENT_ABORTED, source, self.serial[slot])
            self.spindles.abort(self.serial[slot], tick)
            self.abort_actions(slot)
        else:
            self.enter(slot, codes.ENDED)
            self.record.event(rows.EVENT_ENDED, source, self.serial[slot], rows.ENDED_BY_DELETE)
            self.end_actions(slot)
        return 0

    def hold(self, slot: int, source: int) -> None:
        """Stop running a cycle and keep its states; its motions brake (HOLD, RC-111)."""
        if self.state[slot] in (codes.ARMED, codes.RUNNING):
            self.enter(slot, codes.HELD)
            self.record.event(rows.EVENT_HELD, source, self.serial[slot])
            self.spindles.hold(self.serial[slot], self.record.tick)
            self.single_axes.hold(self.first_owner + slot)
        else:
            self.record.event(rows.EVENT_NOTICE, source, self.serial[slot], 900411)

    def resume(self, slot: int, source: int) -> None:
        """Run a held cycle again; before its block it waits again (CONTINUE, RC-111)."""
        if self.state[slot] == codes.HELD:
            is_armed = self.scope[slot] == codes.BLOCK_SCOPE and self.block[slot] == 0
            self.enter(slot, codes.ARMED if is_armed else codes.RUNNING)
            self.record.event(rows.EVENT_CONTINUED, source, self.serial[slot])
            self.spindles.resume(self.serial[slot], self.record.tick)
            self.single_axes.resume(self.first_owner + slot)
        else:
            self.record.event(rows.EVENT_NOTICE, source, self.serial[slot], 900412)

    def enter_block(self, serial: int) -> None:
        """Let armed cycles run with the block that was just taken.

        A cycle that is held before its block still belongs to that block (RC-105).
        """
        if self.armed_count == 0:
            return
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.awaits_block(slot):
                self.armed_count -= 1
                self.block[slot] = serial
                self.in_block_count += 1
                if self.state[slot] == codes.ARMED:
                    self.enter(slot, codes.RUNNING)

    def change_block(self, before: int, serial: int) -> None:
        """Move the cycles of block ``before`` to the block ``serial``, which continues it."""
        if self.in_block_count == 0:
            return
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.block[slot] == before:
                self.block[slot] = serial

    def leave_blocks(self, serial: int) -> None:
        """End the BLOCK cycles of other blocks than ``serial`` (0: of all blocks)."""
        if self.in_block_count == 0:
            return
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.block[slot] != 0 and self.block[slot] != serial:
                self.end(slot, rows.ENDED_BY_SCOPE)

    def end(self, slot: int, reason: int) -> None:
        """End a cycle; one with DEF and scope BLOCK can be started again (RC-105)."""
        self.record.event(rows.EVENT_ENDED, self.source[slot], self.serial[slot], reason)
        again = self.reusable[slot] and self.scope[slot] == codes.BLOCK_SCOPE
        self.enter(slot, codes.DEFINED if again else codes.ENDED)
        self.end_actions(slot)

    def end_actions(self, slot: int) -> None:
        """Treat the motions of an ended cycle, held ones too, by END_ACTION (RC-110)."""
        if self.moves_on[slot]:
            self.single_axes.resume(self.first_owner + slot)
        self.single_axes.end_owner(self.first_owner + slot, self.moves_on[slot])

    def abort_actions(self, slot: int) -> None:
        """Brake the motions of a cycle at the axes' limits, and end them."""
        self.single_axes.abort(self.first_owner + slot, 0)

    def end_program(self) -> None:
        """Delete BLOCK and PROG cycles at M30 (RC-105, RC-106)."""
        self.delete_local(rows.ENDED_BY_SCOPE)

    def reset(self) -> None:
        """Delete BLOCK and PROG cycles; GLOBAL ones keep their states (RC-007)."""
        self.delete_local(rows.ENDED_BY_RESET)

    def delete_local(self, reason: int) -> None:
        """Delete all cycles that do not outlive the program."""
        for index in range(self.loaded_count):
            slot = self.order[index]
            if self.is_alive(slot) and self.scope[slot] != codes.GLOBAL_SCOPE:
                source, serial = self.source[slot], self.serial[slot]
                if self.state[slot] == codes.ARMED and reason == rows.ENDED_BY_SCOPE:
                    self.record.event(rows.EVENT_NOTICE, source, serial, 900413)
                if self.state[slot] != codes.DEFINED:
                    self.record.event(rows.EVENT_ENDED, source, serial, reason)
                self.enter(slot, codes.ENDED)
                self.end_actions(slot)

    def run_cycles(self, context: Context) -> int:
        """Run all active cycles once, in order of creation; return 1 after a fault (RC-112)."""
        if self.running_count == 0:
            return 0
        return self.root.run_through(self, context)

    def fail(self, slot: int, context: Context) -> None:
        """Record the fault, end the cycle at fault and abort its motions (RC-505)."""
        source, serial = context.fault_source, self.serial[slot]
        self.record.event(rows.EVENT_ERROR, source, serial, context.fault, context.fault_a)
        self.enter(slot, codes.ENDED)
        self.record.event(rows.EVENT_ENDED, self.source[slot], serial, rows.ENDED_BY_ERROR)
        self.abort_actions(slot)
