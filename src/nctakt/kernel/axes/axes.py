# SPDX-License-Identifier: MIT
"""The machine's axes: command, actual and target position, and the values that cycles read.

Arrays over the axes, since the tick walks over all of them. Each axis has cells in the memory
(``cells.py``): positions in ACS, MCS, PCS and IPO (RC-304). PCS differs by the offsets in
``coordinates.py``.

The simulated drive (MO-10): an axis follows its command at once (MO-15), or with the lag of a
position control whose gain is kv, of which feed-forward takes a share: the following error e obeys
de/dt = (1 - share) * command speed - kv * e. With the command's speed constant within a tick that
is solved exactly.

With ``is_late`` a drive gets each command one tick later: the order STANDARD of P-RTCF-00018 first
puts out the results of the previous tick.

Command and target of a modulo axis run on over the range while it moves; the cells show them within
it. The cells of an axis are written where its positions are others than those shown last
(``shown_…``), and where the systems have changed (``is_shifted``).

``on_path``: which axes the current block moves, ``independent`` which ones move on their own
(MO-13); ``independent_pct`` is the override of the latter (RC-305), ``plc_factor`` the PLC's
multiplier for it (MC_SetOverride). ``on_path``, ``independent``, ``command`` and ``target`` have
one element more, for places of a channel without an axis (``path_axes.py``). So has ``locked``: the
axes that a PLC does not release, which brake and stay at rest. Code that changes something on which
an axis' override depends increments ``override_version``.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes.coordinates import Offsets, Turns
from nctakt.kernel.axes.couplings import Couplings
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_cells, check_index, check_size


class Axes:
    """``count`` axes whose cells begin at ``first_cell``."""

    def __init__(self, memory: bytearray, first_cell: int, count: int) -> None:
        check_size(count, "number of axes")
        check_cells(first_cell, cells.AXIS_CELLS * count, memory)
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.count = count
        self.command = doubles(count + 1)
        self.has_lag = False
        self.is_late = False
        self.lag_d = doubles(count)
        self.lag_kept = doubles(count)
        self.lag_alone = doubles(count)
        self.lag_gained = doubles(count)
        self.followed = doubles(count)
        self.drive_d = doubles(count)
        self.unsent = doubles(count)
        self.target = doubles(count + 1)
        self.modulo_low = doubles(count)
        self.modulo_range = doubles(count)
        self.on_path = integers(count + 1)
        self.independent = integers(count + 1)
        self.override_mode = integers(count)
        self.ignores_hold = integers(count)
        self.override_pct = doubles(count)
        self.max_override_pct = doubles(count)
        self.independent_pct = doubles(count)
        self.plc_factor = doubles(count)
        for i in range(count):
            self.override_pct[i] = 100.0
            self.max_override_pct[i] = 100.0
            self.independent_pct[i] = 100.0
            self.plc_factor[i] = 1.0
        self.locked = integers(count + 1)
        self.locked_count = 0
        self.override_version = 0
        self.has_stops = False
        self.stop_low = doubles(count)
        self.stop_high = doubles(count)
        for i in range(count):
            self.stop_low[i] = -1e300
            self.stop_high[i] = 1e300
        self.offsets = Offsets(count)
        self.turns = Turns(count)
        self.transformations = Transformations(count)
        self.couplings = Couplings(count)
        self.actual = doubles(count)
        self.shown_command = doubles(count)
        self.shown_actual = doubles(count)
        self.shown_target = doubles(count)
        self.is_shifted = True
        self.has_moved = True

    def begin_tick(self) -> None:
        """Set the CYCLE overrides back to 100 % (RC-305)."""
        for i in range(self.count):
            self.cells[self.cell_of(i) + cells.AXIS_OVERRIDE_VEL_CYCLE] = 100.0

    def cell_of(self, i: int) -> int:
        """Return the first cell of an axis."""
        return self.first_cell + i * cells.AXIS_CELLS

    def follow_masters(self) -> None:
        """Put all slaves where their masters' commands have them (``couplings.py``)."""
        for k in range(self.couplings.count - 1, -1, -1):
            i = self.couplings.slave[k]
            master = self.couplings.master[k]
            command = self.couplings.follow(k, self.command[master])
            self.target[i] = self.couplings.follow(k, self.target[master])
            state = codes.STANDSTILL
            if command != self.command[i]:
                self.command[i] = command
                self.has_moved = True
                state = codes.SYNCHRONIZED_MOTION
            self.show_state(i, state)

    def is_askew(self, k: int) -> int:
        """Return whether the actual positions of a pair differ too much."""
        actual = self.actual_position(self.couplings.slave[k])
        return self.couplings.is_askew(k, actual, self.actual_position(self.couplings.master[k]))

    def couple(self, queue: memoryview[float], row: int) -> None:
        """Let an axis follow another one from here on, or no longer."""
        slave = int(queue[row + rows.COUPLED_AXIS])
        master = int(queue[row + rows.COUPLED_TO])
        if master < 0:
            self.couplings.uncouple(slave)
            return
        self.couplings.couple(
            slave,
            master,
            queue[row + rows.COUPLED_BY],
            queue[row + rows.COUPLED_WITHIN],
            self.command[slave],
            self.command[master],
        )

    def follow(self) -> None:
        """Advance the drives by a tick, where any has a lag or gets its commands late."""
        for i in range(self.count):
            if self.lag_kept[i] > 0.0 or self.is_late:
                sent = self.command[i]
                if self.is_late:
                    sent = self.unsent[i]
                    self.unsent[i] = self.command[i]
                step = self.distance(i, self.followed[i], sent)
                self.followed[i] = sent
                if step != 0.0 or self.drive_d[i] != 0.0:
                    lag = self.lag_kept[i] * self.drive_d[i] + self.lag_gained[i] * step
                    self.drive_d[i] = lag if lag > 1e-9 or lag < -1e-9 else 0.0
                    self.has_moved = True
                self.lag_d[i] = self.drive_d[i] + self.distance(i, sent, self.command[i])

    def distance(self, i: int, begin: float, end: float) -> float:
        """Return the distance between two commands; on a modulo axis the shorter way round."""
        if self.modulo_range[i] > 0.0:
            half = 0.5 * self.modulo_range[i]
            return arithmetic.within(end - begin, 0.0 - half, self.modulo_range[i])
        return end - begin

    def publish(self) -> None:
        """Write the positions that cycles, decoder and trace read."""
        if not self.has_moved:
            return
        self.has_moved = False
        for i in range(self.count):
            command = self.command[i]
            actual = command - self.lag_d[i]
            if self.has_stops:
                actual = self.actual_position(i)
            is_shown = command == self.shown_command[i] and actual == self.shown_actual[i]
            if self.is_shifted or not is_shown or self.target[i] != self.shown_target[i]:
                self.shown_command[i] = command
                self.shown_actual[i] = actual
                self.shown_target[i] = self.target[i]
                self.publish_axis(i, command, actual, self.target[i])
        self.is_shifted = False
        if self.transformations.active_count > 0:
            for i in range(self.count):
                if self.transformations.active[i] > 0:
                    self.publish_tip(self.transformations.active[i], i)
        if self.turns.active > 0:
            for i in range(self.count):
                if self.turns.second[i] > 0:
                    self.publish_turned(i)

    def publish_axis(self, i: int, command: float, actual: float, target: float) -> None:
        """Write the positions of an axis in all systems, of a modulo axis within its range."""
        cell = self.cell_of(i)
        distance_to_go = target - command
        if self.modulo_range[i] > 0.0:
            command = arithmetic.within(command, self.modulo_low[i], self.modulo_range[i])
            actual = arithmetic.within(actual, self.modulo_low[i], self.modulo_range[i])
            target = arithmetic.within(target, self.modulo_low[i], self.modulo_range[i])
        self.cells[cell + cells.AXIS_ACS_ACT_POS] = command
        self.cells[cell + cells.AXIS_ACS_CUR_POS] = actual
        self.cells[cell + cells.AXIS_ACS_CMD_POS] = target
        self.publish_system(cell + cells.AXIS_MCS_ACT_POS, command, actual, target, distance_to_go)
        self.publish_system(cell + cells.AXIS_IPO_ACT_POS, command, actual, target, distance_to_go)
        shift = self.offsets.program[i]
        cell += cells.AXIS_PCS_ACT_POS
        self.publish_system(cell, command - shift, actual - shift, target - shift, distance_to_go)

    def publish_tip(self, number: int, slot: int) -> None:
        """Write the positions of the axes of map ``number`` in MCS, IPO and PCS."""
        self.transformations.map_forward(number, self.command, codes.TIP_OF_COMMAND)
        self.transformations.keep_direction(number, slot)
        self.transformations.map_targets(number, self.target)
        if self.has_lag or self.has_stops:
            for i in range(self.count):
                self.actual[i] = self.actual_position(i)
            self.transformations.map_forward(number, self.actual, codes.TIP_OF_ACTUAL)
        else:
            self.transformations.copy_tip(codes.TIP_OF_COMMAND, codes.TIP_OF_ACTUAL)
        for k in range(self.transformations.joint_count):
            if not self.transformations.joint_mapped[k]:
                continue
            i = self.transformations.joint_members[k]
            command = self.transformations.tip(codes.TIP_OF_COMMAND, k)
            actual = self.transformations.tip(codes.TIP_OF_ACTUAL, k)
            target = self.transformations.tip(codes.TIP_OF_TARGET, k)
            cell = self.cell_of(i)
            rest = target - command
            self.publish_system(cell + cells.AXIS_MCS_ACT_POS, command, actual, target, rest)
            self.publish_system(cell + cells.AXIS_IPO_ACT_POS, command, actual, target, rest)
            shift = self.offsets.program[i]
            cell += cells.AXIS_PCS_ACT_POS
            self.publish_system(cell, command - shift, actual - shift, target - shift, rest)

    def transform(self, slot: int, number: int) -> None:
        """Let map ``number`` be active in a channel, 0: none; no axis moves (MO-8)."""
        self.transformations.activate(slot, number)
        self.is_shifted = True
        self.has_moved = True
        self.publish()

    def publish_turned(self, i: int) -> None:
        """Write PCS of the three axes of a turned system by its inverse matrix."""
        j = self.turns.second[i] - 1
        k = self.turns.third[i] - 1
        for cell in range(cells.SYSTEM_CELLS):
            x = self.cells[self.cell_of(i) + cells.AXIS_MCS_ACT_POS + cell]
            y = self.cells[self.cell_of(j) + cells.AXIS_MCS_ACT_POS + cell]
            z = self.cells[self.cell_of(k) + cells.AXIS_MCS_ACT_POS + cell]
            if cell != cells.SYSTEM_DIST_TO_GO:
                x -= self.offsets.outer(i)
                y -= self.offsets.outer(j)
                z -= self.offsets.outer(k)
            self.publish_inside(i, i, 0, cell, x, y, z)
            self.publish_inside(i, j, 1, cell, x, y, z)
            self.publish_inside(i, k, 2, cell, x, y, z)

    def publish_inside(
        self, i: int, axis: int, column: int, cell: int, x: float, y: float, z: float
    ) -> None:
        """Write one coordinate in PCS; the distance to go has no offset."""
        first = rows.MATRIX_SIZE * i + column
        second = first + rows.MATRIX_SIDE
        third = second + rows.MATRIX_SIDE
        value = self.turns.matrix[first] * x + self.turns.matrix[second] * y
        value += self.turns.matrix[third] * z
        if cell != cells.SYSTEM_DIST_TO_GO:
            value -= self.offsets.inner(axis)
        self.cells[self.cell_of(axis) + cells.AXIS_PCS_ACT_POS + cell] = value

    def actual_position(self, i: int) -> float:
        """Actual position: lags the command, never beyond an obstacle."""
        actual = self.command[i] - self.lag_d[i]
        if self.has_stops:
            actual = max(min(actual, self.stop_high[i]), self.stop_low[i])
        return actual

    def publish_system(
        self, cell: int, command: float, actual: float, target: float, distance_to_go: float
    ) -> None:
        """Write command, actual and target position and distance to go in one system."""
        self.cells[cell + cells.SYSTEM_ACT_POS] = command
        self.cells[cell + cells.SYSTEM_CUR_POS] = actual
        self.cells[cell + cells.SYSTEM_CMD_POS] = target
        self.cells[cell + cells.SYSTEM_DIST_TO_GO] = distance_to_go

    def publish_override(self, i: int, operator_pct: float, is_held: int) -> None:
        """Publish the override of an axis in independent motion, in percent (P-AXIS-00491).

        ``is_held``: the channel is on feed hold, which stops the motion unless P-AXIS-00540 leaves
        that to the feed hold of the axis itself.
        """
        cell = self.cell_of(i)
        pct = operator_pct
        if self.override_mode[i] == codes.LOWER_OVERRIDE:
            pct = min(pct, self.override_pct[i])
        elif self.override_mode[i] == codes.OWN_OVERRIDE:
            pct = self.override_pct[i]
        cycle_pct = self.cells[cell + cells.AXIS_OVERRIDE_VEL_CYCLE]
        pct = min(pct * cycle_pct / 100.0, self.max_override_pct[i])
        if self.locked[i]:
            pct = 0.0
        self.independent_pct[i] = 0.0 if is_held and not self.ignores_hold[i] else pct
        pct *= self.plc_factor[i]
        if pct != self.cells[cell + cells.AXIS_OVERRIDE_VEL_TOTAL]:
            self.cells[cell + cells.AXIS_OVERRIDE_VEL_TOTAL] = arithmetic.round_half_even(pct)

    def show_state(self, i: int, state: int) -> None:
        """Publish the PLCopen state of an axis (``single_axes.py``)."""
        self.cells[self.cell_of(i) + cells.AXIS_STATE] = state

    def set_offset(self, axis: int, kind: int, value: float) -> None:
        """Set an offset of an axis: its positions in PCS differ from now on (MO-8)."""
        self.offsets.set(axis, kind, value)
        self.is_shifted = True
        self.has_moved = True
        self.publish()

    def set_origin(self, axis: int, value: float) -> None:
        """Set the origin of the program's coordinate system on an axis (``#CS``, MO-8)."""
        self.offsets.set_origin(axis, value)
        self.is_shifted = True
        self.has_moved = True
        self.publish()

    def execute(self, queue: memoryview[float], row: int, kind: int) -> None:
        """Set offset, origin or turn of a system: the cycles of this tick see it (MO-8).

        Or a coupling, or feed-forward control.
        """
        if kind == rows.COUPLE:
            self.couple(queue, row)
        elif kind == rows.FEED_FORWARD:
            self.feed_forward(int(queue[row + rows.FED_AXIS]), queue[row + rows.FED_SHARE])
        elif kind == rows.SET_TURN:
            self.turn(queue, row)
        elif kind == rows.SET_ORIGIN:
            axis = int(queue[row + rows.ORIGIN_AXIS])
            self.set_origin(axis, queue[row + rows.ORIGIN_VALUE])
        else:
            axis = int(queue[row + rows.OFFSET_AXIS])
            offset = int(queue[row + rows.OFFSET_KIND])
            self.set_offset(axis, offset, queue[row + rows.OFFSET_VALUE])

    def turn(self, queue: memoryview[float], row: int) -> None:
        """Turn the program's coordinate system as the command at ``row`` says (MO-8)."""
        self.turns.set(queue, row)
        self.is_shifted = True
        self.has_moved = True
        self.publish()

    def publish_all(self) -> None:
        """Publish all positions before the first tick."""
        self.is_shifted = True
        self.has_moved = True
        self.publish()

    def shift(self, index: int, kind: int, value: float) -> None:
        """Set an offset before the first tick; raise ``ValueError`` for an unknown axis or kind."""
        check_index(index, self.count, "axis")
        check_index(kind, codes.OFFSET_KINDS, "kind of offset")
        self.set_offset(index, kind, value)

    def set_modulo(self, index: int, low: float, full: float) -> None:
        """Let the positions of an axis repeat after ``full`` mm or degrees (P-AXIS-00015)."""
        check_index(index, self.count, "axis")
        self.modulo_low[index] = low
        self.modulo_range[index] = full

    def set_stop(self, index: int, position: float) -> None:
        """Put an obstacle at ``position``, relative to an axis at 0 (MO-12)."""
        check_index(index, self.count, "axis")
        self.has_stops = True
        if position > 0.0:
            self.stop_high[index] = position
        else:
            self.stop_low[index] = position

    def set_lag(self, index: int, kept: float, gained: float) -> None:
        """Let an axis lag: the share of the error that a tick keeps, and the amount it adds.

        Without feed-forward control."""
        check_index(index, self.count, "axis")
        self.lag_kept[index] = kept
        self.lag_alone[index] = gained
        self.lag_gained[index] = gained
        self.has_lag = True

    def feed_forward(self, index: int, share: float) -> None:
        """Set the share of the command speed that bypasses the position control of an axis."""
        self.lag_gained[index] = self.lag_alone[index] * (1.0 - share)

    def send_late(self) -> None:
        """Delay each command of the drives by a tick (P-RTCF-00018); before the first tick."""
        self.has_lag = True
        self.is_late = True

    def lock(self, index: int, is_locked: bool) -> None:
        """Let the PLC take an axis its releases from the next tick on, or give them to it."""
        check_index(index, self.count, "axis")
        self.locked_count += (1 if is_locked else 0) - self.locked[index]
        self.locked[index] = 1 if is_locked else 0
        self.override_version += 1

    def is_locked(self, index: int) -> bool:
        """Return whether the PLC has taken an axis its releases."""
        check_index(index, self.count, "axis")
        return self.locked[index] != 0

    def set_override(
        self, index: int, mode: int, max_pct: float, *, ignores_hold: bool = False
    ) -> None:
        """Set override mode and highest override in percent (P-AXIS-00491, P-AXIS-00109).

        ``ignores_hold``: the channel's feed hold does not stop the axis (P-AXIS-00540).
        """
        check_index(index, self.count, "axis")
        self.ignores_hold[index] = ignores_hold
        self.override_mode[index] = mode
        self.max_override_pct[index] = max_pct
        self.override_version += 1

    def refer(self, axis: int, position: float) -> None:
        """Declare the axis' present place to be this position (G74); nothing moves."""
        shift = position - self.command[axis]
        self.command[axis] = position
        self.target[axis] = position
        self.followed[axis] += shift
        self.unsent[axis] += shift
        for k in range(self.couplings.fixed_count):
            if self.couplings.master[k] == axis:
                self.refer(self.couplings.slave[k], self.couplings.follow(k, position))
        self.has_moved = True
        self.publish()

    def set_gantry(self, index: int, master: int, allowed_d: float, offset: float) -> None:
        """Let an axis follow ``master`` forever, at a distance of ``offset`` (P-AXIS-00070, 00073).

        ``allowed_d``: how far their actual positions may differ (P-AXIS-00072), 0: no limit.
        """
        self.couplings.fix(index, master, allowed_d, offset)
        self.set_position(index, self.command[master] + offset)

    def positions(self) -> list[float]:
        """Command positions of all axes in ACS, in mm or degrees."""
        return [self.command[i] for i in range(self.count)]

    def set_position(self, index: int, position: float) -> None:
        """Set one axis to a position without a motion, before the first tick."""
        check_index(index, self.count, "axis")
        self.put_at(index, position)
        self.publish_all()

    def put_at(self, index: int, position: float) -> None:
        """Set one axis, which is at rest, to a position without a motion."""
        self.command[index] = position
        self.followed[index] = position
        self.unsent[index] = position
        self.drive_d[index] = 0.0
        self.lag_d[index] = 0.0
        self.target[index] = position
        for k in range(self.couplings.fixed_count):
            if self.couplings.master[k] == index:
                self.put_at(self.couplings.slave[k], self.couplings.follow(k, position))
