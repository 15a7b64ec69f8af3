# SPDX-License-Identifier: MIT
"""The operator's side of one channel: what is commanded, latched at the start of a tick (MO-6).

Each value has a cell from ``first_cell`` on, in the order of ``hli/layout.py`` (``PANEL`` with the
commands, then ``LAMPS``). Whoever plays the PLC writes the commands' cells between two ticks; the
tick works with the copies that ``latch`` has made. START and RESET are keys: the tick that finds
one pressed takes it and writes 0.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range

# Commands, as rows of the table.
OVERRIDE = 0
FEED_HOLD = 1
SINGLE_BLOCK = 2
START = 3
RESET = 4
PLC_PRESENT = 5
BACKWARD_MOTION = 6
PROBE = 7
OPTIONAL_STOP = 8


class Panel:
    """Override, feed hold, single block, START, RESET, backward motion of a channel, and its lamps.

    ``is_armed``: a program is selected and waits for START. ``is_running``: a program runs.
    ``is_paused``: single block has stopped the channel in front of a block, or the program has
    (M00). ``start_taken`` and ``reset_taken`` tell Python what it has to do. ``turns_back``:
    backward motion is commanded, and was not in the tick before.
    """

    def __init__(self, memory: bytearray, first_cell: int) -> None:
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.is_armed = False
        self.is_running = False
        self.is_paused = False
        self.is_released = False
        self.block_line = -1
        self.block_moves = False
        self.start_taken = False
        self.reset_taken = False
        self.backward_motion = False
        self.cells[first_cell] = 100.0
        self.latch()

    # --- Python's side, between two ticks -------------------------------------------------------

    def put(self, row: int, value: float) -> None:
        """Write the command in this row of the table."""
        check_range(row, OVERRIDE, OPTIONAL_STOP, "command of the panel")
        self.cells[self.first_cell + row] = value

    def arm(self, is_armed: bool) -> None:
        """A program is selected and waits for START, or no longer."""
        self.is_armed = is_armed
        self.cells[self.first_cell + 11] = is_armed

    def show_size(self, blocks: int) -> None:
        """So many blocks fit into the history of the path."""
        self.cells[self.first_cell + 16] = blocks

    def begin_program(self) -> None:
        """A program has begun: its first block needs no START of its own."""
        self.is_running = True
        self.start_taken = False
        self.is_paused = False
        self.is_released = True
        self.block_line = -1
        self.block_moves = False

    def end_program(self) -> None:
        """The program is over or was given up."""
        self.is_running = False

    def accept_reset(self) -> None:
        """Python has given up the program that RESET has broken off."""
        if not self.reset_taken:
            raise ValueError("no tick has taken RESET")
        self.reset_taken = False

    # --- the tick -------------------------------------------------------------------------------

    def latch(self) -> None:
        """Start of a tick: the commands of now are in force."""
        base = self.first_cell
        self.override_pct = max(self.cells[base], 0.0)
        self.feed_hold = self.cells[base + 1] != 0.0
        self.single_block = self.cells[base + 2] != 0.0
        self.start_pressed = self.cells[base + 3] != 0.0
        self.reset_pressed = self.cells[base + 4] != 0.0
        self.plc_present = self.cells[base + 5] != 0.0
        self.turns_back = self.cells[base + 6] != 0.0 and not self.backward_motion
        self.backward_motion = self.cells[base + 6] != 0.0
        self.probe = self.cells[base + 7] != 0.0
        self.optional_stop = self.cells[base + 8] != 0.0
        if self.start_pressed:
            self.cells[base + 3] = 0.0
        if self.reset_pressed:
            self.cells[base + 4] = 0.0
            self.reset_taken = True

    def take_start(self, can_start: int) -> None:
        """START: on from where the channel has stopped, else the program that is selected."""
        if self.is_paused:
            self.is_paused = False
            self.is_released = True
        elif self.is_armed and can_start and not self.is_running:
            self.is_armed = False
            self.start_taken = True

    def lets_go(self, line: int, moves: bool, is_begun: bool) -> int:
        """Whether a command may be taken: single block stops in front of each block.

        A block is a line of a program; one that moves or dwells again is another one. What the
        path has begun already (``is_begun``) goes on, and so does what has no line: the program's
        end.
        """
        if line == 0 and not moves:
            return 1
        if line == self.block_line and not (moves and self.block_moves):
            self.block_moves = self.block_moves or moves
            return 1
        if self.single_block and not self.is_released and not is_begun:
            self.is_paused = True
            return 0
        self.is_released = False
        self.block_line = line
        self.block_moves = moves
        return 1

    def stop_for_program(self, is_optional: bool) -> int:
        """M00, or M01 where the operator asks for it: whether the channel waits for START."""
        if not is_optional or self.optional_stop:
            self.is_paused = True
        return self.is_paused

    def publish(self, state: int, message: int) -> None:
        """End of a tick: the lamps. ``state`` 2 error, 3 reset, else 0; ID of the error."""
        base = self.first_cell
        if state == 0 and self.is_running:
            state = 1
        self.cells[base + 9] = state
        self.cells[base + 10] = self.is_paused
        self.cells[base + 11] = self.is_armed
        self.cells[base + 12] = message

    def show_loop(self, is_inside: bool) -> None:
        """The path is in a realtime loop, or no longer."""
        self.cells[self.first_cell + 15] = is_inside

    def show_history(self, retrace: int, blocks: int) -> None:
        """How the path walks over its history (0 not at all), and the blocks that are in it."""
        self.cells[self.first_cell + 13] = retrace
        self.cells[self.first_cell + 14] = blocks
