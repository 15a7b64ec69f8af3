# SPDX-License-Identifier: MIT
"""The operator's side of one channel: commands, latched at the start of a tick (MO-6).

Each value has a cell (``cells.PANEL_OVERRIDE`` …). Whatever acts as the PLC writes the commands'
cells between two ticks; the tick works with the copies that ``latch`` has made. START and RESET are
keys: the tick that takes one writes 0. START waits while a reset lasts: an operator who presses
both in turn need not know which tick comes between them.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes
from nctakt.kernel.base.bounds import check_cells, check_range


class Panel:
    """Override, feed hold, single block, START, RESET, backward motion of a channel, and its lamps.

    ``is_armed``: a program is selected and waits for START. ``is_running``: a program runs.
    ``is_paused``: single block has stopped the channel before a block, or the program has (M00).
    ``is_step_locked``: single block has no effect; ``step_resolution``: it stops at multiples of
    this block number, 0: at all. ``start_taken`` and ``reset_taken`` leave the rest to Python.
    ``turns_back``: backward motion is commanded, and was not in the tick before. ``is_watched``:
    the PLC sends a sign of life; ``silent_ticks``: since the last one. ``is_quiet``: the tick
    before has found no command but the override.
    """

    def __init__(self, memory: bytearray, first_cell: int) -> None:
        check_cells(first_cell, cells.PANEL_CELLS, memory)
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.is_armed = False
        self.is_running = False
        self.is_paused = False
        self.is_released = False
        self.is_step_locked = False
        self.step_resolution = 0
        self.block_line = -1
        self.block_moves = False
        self.start_taken = False
        self.reset_taken = False
        self.silent_ticks = 0
        self.is_quiet = False
        self.words = memoryview(memory).cast("q")
        self.backward_motion = False
        self.cells[first_cell + cells.PANEL_OVERRIDE] = 100.0
        self.cells[first_cell + cells.PANEL_SEARCH_PASS] = 1.0
        self.latch()

    # --- Python's side, between two ticks -------------------------------------------------------

    def put(self, command: int, value: float) -> None:
        """Write a command, ``cells.PANEL_OVERRIDE`` … ``cells.PANEL_SEARCH_PASS``."""
        check_range(command, cells.PANEL_OVERRIDE, cells.PANEL_SEARCH_PASS, "command of the panel")
        self.cells[self.first_cell + command] = value

    def arm(self, is_armed: bool) -> None:
        """Select a program that waits for START, or none."""
        self.is_armed = is_armed
        self.cells[self.first_cell + cells.PANEL_ARMED] = is_armed

    def show_size(self, blocks: int) -> None:
        """Show how many blocks fit into the history of the path."""
        self.cells[self.first_cell + cells.PANEL_HISTORY_SIZE] = blocks

    def begin_program(self) -> None:
        """Begin a program: its first block needs no further START."""
        self.is_running = True
        self.start_taken = False
        self.is_paused = False
        self.is_step_locked = False
        self.step_resolution = 0
        self.is_released = True
        self.block_line = -1
        self.block_moves = False

    def end_program(self) -> None:
        """End the program, which is over or was given up."""
        self.is_running = False

    def accept_reset(self) -> None:
        """Accept RESET once the program is aborted; raise ``ValueError`` without one."""
        if not self.reset_taken:
            raise ValueError("no tick has taken RESET")
        self.reset_taken = False

    # --- the tick -------------------------------------------------------------------------------

    def latch(self) -> None:
        """Latch the commands at the start of a tick."""
        cell = self.first_cell
        self.override_pct = max(self.cells[cell + cells.PANEL_OVERRIDE], 0.0)
        pressed = 0
        for key in range(cells.PANEL_FEED_HOLD, cells.PANEL_SEARCH_TYPE):
            pressed |= self.words[cell + key]
        if pressed == 0 and self.is_quiet:
            return
        self.is_quiet = pressed == 0
        self.feed_hold = self.cells[cell + cells.PANEL_FEED_HOLD] != 0.0
        is_single = self.cells[cell + cells.PANEL_SINGLE_BLOCK] != 0.0
        self.single_block = is_single and not self.is_step_locked
        self.start_pressed = self.cells[cell + cells.PANEL_START] != 0.0
        self.reset_pressed = self.cells[cell + cells.PANEL_RESET] != 0.0
        self.plc_present = self.cells[cell + cells.PANEL_PLC_PRESENT] != 0.0
        is_backward = self.cells[cell + cells.PANEL_BACKWARD_MOTION] != 0.0
        self.turns_back = is_backward and not self.backward_motion
        self.backward_motion = is_backward
        self.probe = self.cells[cell + cells.PANEL_PROBE] != 0.0
        self.optional_stop = self.cells[cell + cells.PANEL_OPTIONAL_STOP] != 0.0
        if self.reset_pressed:
            self.cells[cell + cells.PANEL_RESET] = 0.0
            self.reset_taken = True
        self.is_watched = self.cells[cell + cells.PANEL_WATCHDOG] != 0.0
        self.silent_ticks = self.silent_ticks + 1 if self.is_watched else 0
        if self.cells[cell + cells.PANEL_ALIVE] != 0.0:
            self.cells[cell + cells.PANEL_ALIVE] = 0.0
            self.silent_ticks = 0

    def lock_step(self, is_locked: bool) -> None:
        """Let single block have no effect from here on, or again (``#SINGLE STEP``)."""
        is_single = self.cells[self.first_cell + cells.PANEL_SINGLE_BLOCK] != 0.0
        self.is_step_locked = is_locked
        self.single_block = is_single and not is_locked

    def take_start(self, can_start: int) -> None:
        """Take START: continue where the channel has stopped, else the selected program."""
        self.cells[self.first_cell + cells.PANEL_START] = 0.0
        if self.is_paused:
            self.is_paused = False
            self.is_released = True
        elif self.is_armed and can_start and not self.is_running:
            self.is_armed = False
            self.start_taken = True

    def permits_block(self, line: int, moves_axis: bool, is_started: bool) -> int:
        """Return whether a command may be taken: single block stops before each block.

        A block is a line of a program; a line that moves or dwells again is another block. A block
        that the path has already begun (``is_started``) continues, and so does a command without a
        line: the program's end.
        """
        if self.is_same_block(line, moves_axis):
            self.block_moves = self.block_moves or moves_axis
            return 1
        if self.holds_back(line, moves_axis, is_started):
            return 0
        self.is_released = False
        self.block_line = line
        self.block_moves = moves_axis
        return 1

    def holds_back(self, line: int, moves_axis: bool, is_started: bool) -> int:
        """Return whether single block stops before a command, which then waits for START."""
        if self.is_same_block(line, moves_axis):
            return 0
        if self.single_block and not self.is_released and not is_started:
            self.is_paused = True
            return 1
        return 0

    def is_same_block(self, line: int, moves_axis: bool) -> int:
        """Return whether a command belongs to the present block, or to none."""
        if line == 0 and not moves_axis:
            return 1
        return line == self.block_line and not (moves_axis and self.block_moves)

    def stop_for_program(self, is_optional: bool) -> int:
        """Stop at M00, or at M01 if the operator asks for it; return whether it stops."""
        if not is_optional or self.optional_stop:
            self.is_paused = True
        return self.is_paused

    def publish(self, state: int, message: int) -> None:
        """Publish the lamps at the end of a tick: ``state`` and the ID of the error."""
        cell = self.first_cell
        if state == codes.CHANNEL_READY and self.is_running:
            state = codes.CHANNEL_RUNNING
        if message != 0 and self.cells[cell + cells.PANEL_ERROR] == 0.0:
            self.cells[cell + cells.PANEL_ERROR_SERIAL] += 1.0
        self.cells[cell + cells.PANEL_STATE] = state
        self.cells[cell + cells.PANEL_PAUSED] = self.is_paused
        self.cells[cell + cells.PANEL_ARMED] = self.is_armed
        self.cells[cell + cells.PANEL_ERROR] = message

    def show_loop(self, is_inside: bool) -> None:
        """Show whether the path is in a realtime loop."""
        self.cells[self.first_cell + cells.PANEL_INSIDE_RT_LOOP] = is_inside

    def show_history(self, state: int, blocks: int) -> None:
        """Show the state of the walk (``codes.AT_FRONT`` …) and the blocks in the history."""
        self.cells[self.first_cell + cells.PANEL_RETRACE] = state
        self.cells[self.first_cell + cells.PANEL_HISTORY] = blocks

    def show_life(self, time_t: float, distance_d: float) -> None:
        """Show how many seconds and mm the tool has worked."""
        self.cells[self.first_cell + cells.PANEL_TOOL_TIME] = time_t
        self.cells[self.first_cell + cells.PANEL_TOOL_DISTANCE] = distance_d

    def send_life(self, serial: int, tool: int, time_t: float, distance_d: float) -> None:
        """Show the tool life that is sent, with its running number."""
        self.cells[self.first_cell + cells.PANEL_LIFE_SERIAL] = serial
        self.cells[self.first_cell + cells.PANEL_LIFE_TOOL] = tool
        self.cells[self.first_cell + cells.PANEL_LIFE_TIME] = time_t
        self.cells[self.first_cell + cells.PANEL_LIFE_DISTANCE] = distance_d
