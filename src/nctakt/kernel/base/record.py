# SPDX-License-Identifier: MIT
"""What the realtime part records: rows of signals, events, probes of conditions.

Each of the three is a block of typed memory that the tick appends to and Python empties between two
calls of ``Kernel.run``. Before a tick there must be room for all that it can record
(``has_room``), else ``run`` returns: nothing is ever lost. Every signal is a cell of the memory, so
a row is a copy of the chosen cells.

Event row, ``EVENT_WIDTH`` floats: tick, kind + 256 * channel, source ID, subject, a, b; channel 0
is that of a machine with one, or none. Probe row, ``PROBE_WIDTH``
floats: tick, 2 * probe number + truth, left operand, right operand. Where series are recorded,
there are rows in which a series of evaluations (``kind`` 0) or of run-throughs of a body (1) begins
after a tick without: tick, -1 - (2 * probe number + kind), the tick behind the last one of the
series before (-1: none), 0.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_index

EVENT_WIDTH = 6
CHANNEL_CODE_WIDTH = 256
PROBE_WIDTH = 4

# Kinds of events; behind each what subject, a and b hold.
CREATED = 1  # serial of the cycle, scope
STARTED = 2  # serial
HELD = 3  # serial
CONTINUED = 4  # serial
ABORTED = 5  # serial
ENDED = 6  # serial, reason (the ENDED_BY numbers)
FIRED = 7  # serial; the source is the branch
WRITTEN = 8  # serial (0: the decoder), cell, new value
TECHNOLOGY_RT = 9  # serial, number of the function (negative: H), number within the tick
TECHNOLOGY = 10  # 0, number of the function (negative: H)
MESSAGE = 11  # number of the text (subject)
ERROR = 12  # serial (0: the path), message ID, detail; the source is the statement
PROGRAM_END = 13  # number of the program (subject)
NOTICE = 14  # serial, message ID: diagnosis level 2
USER_ERROR = 15  # serial (0: the program), ID, RC
USER_VALUE = 16  # serial, keyword, value
USER_TEXT = 17  # serial, keyword, number of the text
AXIS_BEGUN = 20  # serial (0: the PLC), axis, target; endless: -1 - axis, direction
AXIS_ENDED = 21  # serial, axis, MOTION_DONE …
AXIS_CHANGED = 22  # serial, axis, MOTION_HELD …
SPINDLE = 18  # serial (0: the program), 100 * spindle + M, revolutions per minute
SPINDLE_REACHED = 19  # serial, spindle
SPINDLE_POSITION = 36  # serial, spindle, degrees
FROZEN = 40  # serial, number of the variable's text, value; the source is the access
BLOCK = 25  # number of the block, tick in which it was decoded
WAIT = 26  # reason, cell; the source is what waits
LOOP = 42  # LOOP_BEGUN …; the source is the loop
PROBED = 44  # nothing, what is left of the block behind the joint
FIXED_STOP = 43  # axis, position; the source is its command
RETRACED = 41  # RETRACE_BACKWARD …; the source is the block
PAUSED = 31  # nothing; the source is what waits
STARVED = 47  # nothing; the source is the last command that was taken
FED = 48  # ticks for which the queue was empty
OVERFLOW = 49  # number of the thread

ENDED_BY_SCOPE = 0
ENDED_BY_DELETE = 1
ENDED_BY_RESET = 2
ENDED_BY_ERROR = 3

LOOP_BEGUN = 0
LOOP_SKIPPED = 1
LOOP_LEFT = 2

RETRACE_BACKWARD = 0
RETRACE_FORWARD = 1
RETRACE_START = 2
RETRACE_FRONT = 3

MOTION_DONE = 0
MOTION_ABORTED = 1
MOTION_FAILED = 2

MOTION_HELD = 0
MOTION_CONTINUED = 1
MOTION_STOPPED = 2


class Record:
    """Rows, events and probes of the ticks since they were last taken.

    ``memory`` is the machine's; ``signals`` (``select``) are the cells that a row holds.
    """

    def __init__(
        self,
        memory: bytearray,
        *,
        row_capacity: int = 4096,
        event_capacity: int = 8192,
        probe_capacity: int = 8192,
    ) -> None:
        self.cells = memoryview(memory).cast("d")
        self.row_capacity = row_capacity
        self.select([])
        self.event_capacity = event_capacity
        self.events = memoryview(bytearray(8 * EVENT_WIDTH * event_capacity)).cast("d")
        self.event_count = 0
        self.probe_capacity = probe_capacity
        self.probes = memoryview(bytearray(8 * PROBE_WIDTH * probe_capacity)).cast("d")
        self.probe_count = 0
        self.tick = 0
        self.channel_code = 0
        self.records_writes = False
        self.records_series = False

    def select(self, signals: list[int]) -> None:
        """The cells that a row holds from now on; rows that were not taken are dropped."""
        for cell in signals:
            check_index(cell, len(self.cells), "cell")
        self.signal_count = len(signals)
        self.signals = memoryview(bytearray(8 * max(1, len(signals)))).cast("q")
        for i, cell in enumerate(signals):
            self.signals[i] = cell
        self.rows = memoryview(bytearray(8 * max(1, self.row_capacity * len(signals)))).cast("d")
        self.row_count = 0

    def take_row(self) -> None:
        """Copy the signals' cells as the row of this tick."""
        base = self.row_count * self.signal_count
        for i in range(self.signal_count):
            self.rows[base + i] = self.cells[self.signals[i]]
        self.row_count += 1

    def event(self, kind: int, source: int, subject: int, a: float, b: float) -> None:
        """Append an event of this tick; that there is room was seen before the tick began."""
        base = self.event_count * 6
        self.events[base] = self.tick
        self.events[base + 1] = kind + self.channel_code
        self.events[base + 2] = source
        self.events[base + 3] = subject
        self.events[base + 4] = a
        self.events[base + 5] = b
        self.event_count += 1

    # One method a kind, so that each number stands in one place: a module constant would be a
    # Python object in the tick.

    def created(self, source: int, serial: int, scope: int) -> None:
        """A realtime cycle was defined."""
        self.event(1, source, serial, scope, 0.0)

    def started(self, source: int, serial: int) -> None:
        """A realtime cycle was started."""
        self.event(2, source, serial, 0.0, 0.0)

    def held(self, source: int, serial: int) -> None:
        """A realtime cycle was held."""
        self.event(3, source, serial, 0.0, 0.0)

    def continued(self, source: int, serial: int) -> None:
        """A held realtime cycle goes on."""
        self.event(4, source, serial, 0.0, 0.0)

    def aborted(self, source: int, serial: int) -> None:
        """The actions of a realtime cycle were aborted."""
        self.event(5, source, serial, 0.0, 0.0)

    def ended(self, source: int, serial: int, reason: int) -> None:
        """A realtime cycle has ended, for one of the ENDED_BY reasons."""
        self.event(6, source, serial, reason, 0.0)

    def fired(self, source: int, serial: int) -> None:
        """The body of an ``$IF`` runs, and did not run in the tick before."""
        self.event(7, source, serial, 0.0, 0.0)

    def written(self, source: int, serial: int, cell: int, value: float) -> None:
        """A variable has a new value; only where writes are recorded."""
        if self.records_writes:
            self.event(8, source, serial, cell, value)

    def technology_rt(self, source: int, serial: int, function: int, sequence: int) -> None:
        """A function of a realtime cycle went to the HLI."""
        self.event(9, source, serial, function, sequence)

    def technology(self, source: int, function: int, has_value: bool, value: int) -> None:
        """A function of the main program went to the HLI, perhaps with a value."""
        self.event(10, source, has_value, function, value)

    def message(self, source: int, number: int) -> None:
        """A ``#MSG`` of the main program is due."""
        self.event(11, source, number, 0.0, 0.0)

    def error(self, source: int, serial: int, message: int, detail: float) -> None:
        """A fault of a realtime cycle or of the path; ``message`` is its number."""
        self.event(12, source, serial, message, detail)

    def program_end(self, source: int, program: int) -> None:
        """The end of a main program was taken."""
        self.event(13, source, program, 0.0, 0.0)

    def notice(self, source: int, serial: int, message: int) -> None:
        """Something without effect that may be a mistake: diagnosis level 2."""
        self.event(14, source, serial, message, 0.0)

    def axis_begun(self, source: int, serial: int, axis: int, target: float) -> None:
        """An independent motion has begun; an endless one tells -1 - axis and its direction."""
        self.event(20, source, serial, axis, target)

    def axis_ended(self, source: int, serial: int, axis: int, how: int) -> None:
        """An independent motion is done, aborted or has failed (MOTION_DONE …)."""
        self.event(21, source, serial, axis, how)

    def axis_changed(self, source: int, serial: int, axis: int, what: int) -> None:
        """An independent motion is held, goes on, or was braked to a stand (MOTION_HELD …)."""
        self.event(22, source, serial, axis, what)

    def frozen(self, source: int, serial: int, name: int, value: float) -> None:
        """An asynchronous variable became a constant of a realtime cycle (RC-302)."""
        self.event(40, source, serial, name, value)

    def block(self, source: int, number: int, decoded_tick: int) -> None:
        """A block of the main program is carried out; it was decoded in ``decoded_tick``."""
        self.event(25, source, number, decoded_tick, 0.0)

    def wait(self, source: int, reason: int, cell: int) -> None:
        """The channel is emptied, for a reason of ``decoder/state/commands.py``."""
        self.event(26, source, reason, cell, 0.0)

    def paused(self, source: int) -> None:
        """Single block has stopped the channel in front of a block."""
        self.event(31, source, 0, 0.0, 0.0)

    def starved(self, source: int) -> None:
        """The queue is empty: what stands behind this command is not decoded yet."""
        self.event(47, source, 0, 0.0, 0.0)

    def fed(self, source: int, ticks: int) -> None:
        """The queue was empty for so many ticks, and is not any more."""
        self.event(48, source, ticks, 0.0, 0.0)

    def overflow(self, thread: int) -> None:
        """A thread of the schedule is still busy when it is due again."""
        self.event(49, 0, thread, 0.0, 0.0)

    def loop(self, source: int, how: int) -> None:
        """A realtime loop is entered, passed over or left (LOOP_BEGUN …)."""
        self.event(42, source, how, 0.0, 0.0)

    def fixed_stop(self, source: int, axis: int, position: float) -> None:
        """An axis has found its fixed stop."""
        self.event(43, source, 0, axis, position)

    def probe_found(self, source: int, delta: float) -> None:
        """The probe of the edge banding has found the edge."""
        self.event(44, source, 0, delta, 0.0)

    def retraced(self, source: int, how: int) -> None:
        """The path walks over its history, or has come to one of its ends (RETRACE_BACKWARD …)."""
        self.event(41, source, how, 0.0, 0.0)

    def user_error(self, source: int, serial: int, identity: float, reaction: float) -> None:
        """An ``#ERROR``; its values are told behind it."""
        self.event(15, source, serial, identity, reaction)

    def user_value(self, source: int, serial: int, code: int, value: float) -> None:
        """A value of the ``#ERROR`` before it."""
        self.event(16, source, serial, code, value)

    def user_text(self, source: int, serial: int, code: int, text: int) -> None:
        """A text of the ``#ERROR`` before it."""
        self.event(17, source, serial, code, text)

    def spindle(self, source: int, serial: int, spindle: int, function: int, rpm: float) -> None:
        """A spindle has got a job."""
        self.event(18, source, serial, 100 * spindle + function, rpm)

    def spindle_reached(self, source: int, serial: int, spindle: int) -> None:
        """A spindle's job is done."""
        self.event(19, source, serial, spindle, 0.0)

    def spindle_position(self, source: int, serial: int, spindle: int, position: float) -> None:
        """The position of the job before it."""
        self.event(36, source, serial, spindle, position)

    def probe(self, number: int, truth: int, left: float, right: float) -> None:
        """Append a change of a condition's truth."""
        base = self.probe_count * 4
        self.probes[base] = self.tick
        self.probes[base + 1] = 2 * number + truth
        self.probes[base + 2] = left
        self.probes[base + 3] = right
        self.probe_count += 1

    def series(self, number: int, kind: int, next_tick: int) -> None:
        """Append the begin of a series of evaluations or run-throughs, where that is asked for."""
        if self.records_series:
            base = self.probe_count * 4
            self.probes[base] = self.tick
            self.probes[base + 1] = -1 - (2 * number + kind)
            self.probes[base + 2] = next_tick
            self.probes[base + 3] = 0.0
            self.probe_count += 1

    def has_room(self, events: int, probes: int) -> int:
        """Whether a tick that records at most so many events and probes fits."""
        if self.signal_count > 0 and self.row_count >= self.row_capacity:
            return 0
        if self.event_count + events > self.event_capacity:
            return 0
        return 1 if self.probe_count + probes <= self.probe_capacity else 0

    def reserve(self, events: int, probes: int) -> None:
        """Make the empty buffers large enough for a tick with so many events and probes."""
        if events > self.event_capacity and self.event_count == 0:
            self.event_capacity = 2 * events
            self.events = memoryview(bytearray(8 * EVENT_WIDTH * self.event_capacity)).cast("d")
        if probes > self.probe_capacity and self.probe_count == 0:
            self.probe_capacity = 2 * probes
            self.probes = memoryview(bytearray(8 * PROBE_WIDTH * self.probe_capacity)).cast("d")

    def take_rows(self) -> bytes:
        """The rows recorded since the last call, row after row of float64."""
        taken = bytes(memoryview(self.rows)[: self.row_count * self.signal_count])
        self.row_count = 0
        return taken

    def take_events(self) -> bytes:
        """The events recorded since the last call, ``EVENT_WIDTH`` float64 each."""
        taken = bytes(memoryview(self.events)[: self.event_count * EVENT_WIDTH])
        self.event_count = 0
        return taken

    def take_probes(self) -> bytes:
        """The probe rows recorded since the last call, ``PROBE_WIDTH`` float64 each."""
        taken = bytes(memoryview(self.probes)[: self.probe_count * PROBE_WIDTH])
        self.probe_count = 0
        return taken
