# SPDX-License-Identifier: MIT
"""All that reaches a run from outside, tick by tick.

In: values of variables and of the operator's panel, acknowledgements of functions and spindle jobs,
motions of single axes requested by a PLC, writes of a PLC in another process into the image of the
HLI, selected programs; now, or planned for a tick (stimuli, a tape). Out: the values latched by the
next tick (RC-002), in the order of arrival. A listener gets all of them, some ticks later: nothing
else is needed to repeat a run.
"""

from __future__ import annotations

import weakref
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.tape import INPUT_NOT_POSSIBLE
from nctakt.run.access.input_words import API, WRITE

if TYPE_CHECKING:
    from nctakt.kernel.kernel import Kernel
    from nctakt.kernel.tick.channel import Channel
    from nctakt.run.access.image_inputs import ImageInputs
    from nctakt.run.access.shared_image import SharedImage
    from nctakt.run.access.variable_access import VariableAccess

#: The kinds of inputs, besides ``WRITE``.
ACKNOWLEDGE, ACKNOWLEDGE_SPINDLE, AXIS = "ack", "ack_spindle", "axis"
IMAGE, SELECT = "image", "select"
#: Decisions of a schedule on a real clock: a channel had this many further commands decoded, a
#: thread was still busy when it was due, the tick was lost.
DECODED, OVERFLOWED, LOST = "decoded", "overflowed", "lost"

#: Sources of inputs, besides ``API``; ``HLI``: a PLC in another process, ``FMU``: a coupled
#: simulation, ``SCHEDULE``: a real clock.
STIMULI, PLC, HLI, FMU, SCHEDULE = "stimuli", "plc", "hli", "fmu", "schedule"

#: The order of the sources within a tick, by the first word of their names: tape and stimuli, PLCs,
#: simulations coupled to them, the servers, persons; others come last. If two write the same value,
#: the later one wins.
SOURCE_ORDER = (
    SCHEDULE,
    STIMULI,
    HLI,
    PLC,
    FMU,
    "automatic",
    "ads",
    "opcua",
    "mqtt",
    "page",
    "debugger",
    API,
)

#: A tick that no run reaches.
NEVER = 1 << 62


#: Cells that wait for the listener: a tick that has more begins nothing new with them.
_MAX_NOTED = 5000


#: Cells of an input.
INPUT_WIDTH = 5


class Input(NamedTuple):
    """An input that ``tick`` latches; ``values`` are the arguments of the method for its kind."""

    tick: int
    source: str
    kind: str
    values: tuple[float | str | bool, ...]


def in_order(planned: Input) -> tuple[int, int]:
    """Return the key by which inputs are sorted: tick, then source; arrival decides the rest."""
    return planned.tick, _ranks.get(planned.source.partition(" ")[0], len(_ranks))


_ranks = {source: rank for rank, source in enumerate(SOURCE_ORDER)}


#: Inputs in the order of their arrival, in five cells each: tick, source, kind; name and value of a
#: write, otherwise the values and nothing. A PLC writes in each tick, and the garbage collector
#: would scan lists of objects again and again.
Cells = list[Any]

#: Takes inputs.
InputListener = Callable[[Cells], None]


def unpack(cells: Cells) -> list[Input]:
    """Return the inputs of cells."""
    found = []
    for at in range(0, len(cells), INPUT_WIDTH):
        tick, source, kind, values, value = cells[at : at + INPUT_WIDTH]
        found.append(Input(tick, source, kind, (values, value) if kind == WRITE else values))
    return found


def pack(inputs: Iterable[Input]) -> Cells:
    """Return inputs as cells."""
    cells: Cells = []
    for one in inputs:
        values = one.values if one.kind == WRITE else (one.values, None)
        cells += (one.tick, one.source, one.kind, *values)
    return cells


def _no_image() -> None:
    """Return no image: none has been attached."""


class Inputs:
    """The inputs of one machine."""

    def __init__(
        self,
        kernel: Kernel,
        channels: Sequence[Channel],
        access: VariableAccess,
        report_stale: Callable[[str], None],
    ) -> None:
        self._kernel = kernel
        self._channels = channels
        self._access = access
        self._report_stale = report_stale
        self._planned: deque[Input] = deque()
        self._listener: InputListener | None = None
        self._notes = access.notes
        self.on_select: Callable[[int, str], None] | None = None
        self.on_schedule: Callable[[str, tuple[int, ...]], None] | None = None
        self._image: Callable[[], SharedImage | None] = _no_image
        self._image_changes: tuple[int, list[tuple[str, str]]] = (-1, [])

    # --- the image of the HLI -------------------------------------------------------------------

    def attach(self, image: SharedImage) -> None:
        """Note the writes of a PLC in another process into this image, or repeat them."""
        self._image = weakref.ref(image)

    @property
    def _image_inputs(self) -> ImageInputs | None:
        image = self._image()
        return None if image is None or image.is_closed else image.inputs

    def _note_image(self) -> None:
        """Note the PLC's writes since the latest tick, each change once."""
        written, tick = self._image_inputs, self._kernel.tick
        changes = [] if written is None else written.changes()
        known = self._image_changes[1] if self._image_changes[0] == tick else []
        self._image_changes = tick, changes
        for change in changes:
            if change not in known:
                self._forward(HLI, IMAGE, *change)

    @property
    def has_image(self) -> bool:
        """Whether another process may write into an image of the HLI."""
        return self._image is not _no_image

    # --- the listener ---------------------------------------------------------------------------

    def listen(self, listener: InputListener | None) -> None:
        """Report the inputs to this listener, or to none, from now on."""
        self.hand_over()
        self._listener = listener
        self._notes.is_listening = listener is not None

    def hand_over(self) -> None:
        """Hand the inputs since the last time to the listener."""
        notes = self._notes
        if notes.cells and self._listener is not None:
            noted, notes.cells = notes.cells, []
            self._listener(noted)

    @property
    def are_silent(self) -> bool:
        """Whether nothing is planned and there is no listener."""
        return self._listener is None and not self._planned

    @property
    def has_listener(self) -> bool:
        """Whether somebody listens."""
        return self._listener is not None

    # --- planned inputs -------------------------------------------------------------------------

    def plan(self, inputs: Iterable[Input]) -> None:
        """Replace the planned inputs; they come in the order of their ticks."""
        self._planned = deque(inputs)

    def add(self, inputs: Iterable[Input]) -> None:
        """Plan further inputs, each after those of its tick and source."""
        self._planned = deque(sorted([*self._planned, *inputs], key=in_order))

    def check_all(self, inputs: Sequence[Input]) -> None:
        """Raise ``Failure`` unless these can be applied in turn.

        They come after the inputs planned for their tick: a semaphore is checked with the data
        written before it.
        """
        names = [str(one.values[0]) for one in inputs if one.kind == WRITE and one.values]
        with self._access.draft(names):
            tick = inputs[0].tick if inputs else 0
            for planned in self._planned if names else ():
                if planned.kind == WRITE and planned.tick <= tick:
                    with suppress(Failure):  # it is reported when it is applied
                        self.check(planned)
            for one in inputs:
                self.check(one)

    def check(self, planned: Input) -> None:
        """Raise ``Failure`` for a name or a value that this machine does not take (901077)."""
        # The kernel exists when there are inputs to check; words for a run come before it.
        from nctakt.kernel.plc.technology_slots import SLOT_COUNT  # noqa: PLC0415

        match planned.kind, planned.values:
            case "write", (str() as name, value):
                self._access.check(name, value)
            case "ack", (int() as channel, bool(), int() as slot, int(), str()) if (
                0 <= channel < len(self._channels) and 0 <= slot < SLOT_COUNT
            ):
                pass
            case "ack_spindle", (int() as channel, int() as index, int(), str()) if (
                0 <= channel < len(self._channels)
                and 0 <= index < self._channels[channel].context.spindles.count
            ):
                pass
            case "decoded", (int() as channel, int() as steps) if (
                0 <= channel < len(self._channels) and steps >= 0
            ):
                pass
            case ("overflowed", (int() as thread,)) if thread >= 0:
                pass
            case "lost", ():
                pass
            case "select", (int() as channel, str()) if 0 <= channel < len(self._channels):
                pass
            case "image", (str() as name, str() as digits) if self._fits_image(name, digits):
                pass
            case _:
                raise Failure(self._impossible(planned))

    def _fits_image(self, name: str, digits: str) -> bool:
        written = self._image_inputs
        if written is None:
            return False
        try:
            written.check(name, digits)
        except ValueError:
            return False
        return True

    def _impossible(self, planned: Input) -> Diagnostic:
        found = f"{planned.kind} {', '.join(map(str, planned.values))}"
        return diagnostic(INPUT_NOT_POSSIBLE, tick=planned.tick, input=found)

    def apply_due(self) -> int:
        """Apply the planned inputs of the coming tick; return the tick of the next planned one."""
        if len(self._notes.cells) >= _MAX_NOTED:
            self.hand_over()
        planned = self._planned
        while planned and planned[0].tick <= self._kernel.tick:
            self._apply(planned.popleft())
        if self._listener is not None and self.has_image:
            self._note_image()
        return planned[0].tick if planned else NEVER

    @property
    def next_tick(self) -> int:
        """The tick of the next planned input, ``NEVER`` without one."""
        return self._planned[0].tick if self._planned else NEVER

    def _apply(self, planned: Input) -> None:
        """Apply a planned input; raises ``Failure`` (901077) where this machine cannot take it."""
        try:
            self._repeat(planned)
        except (IndexError, OverflowError, ValueError) as error:
            raise Failure(self._impossible(planned)) from error

    def _repeat(self, planned: Input) -> None:
        values = planned.values
        match planned.kind:
            case "write":
                name, value = values
                self.write(str(name), value, planned.source)
            case "ack":
                channel, is_realtime, slot, serial, name = values
                self.acknowledge(int(channel), bool(is_realtime), int(slot), int(serial), str(name))
            case "ack_spindle":
                channel, index, serial, name = values
                self.acknowledge_spindle(int(channel), int(index), int(serial), str(name))
            case "select":
                channel, name = values
                self.select(int(channel), str(name), planned.source)
            case "image":
                name, digits = values
                written = self._image_inputs
                if written is None:
                    raise ValueError(name)
                written.put(str(name), str(digits))
            case "decoded" | "overflowed" | "lost":
                self.schedule(planned.kind, *map(int, values))
            case "axis":
                kind, axis, position, speed, mode, direction = values
                self.request_axis(
                    int(kind), int(axis), float(position), float(speed), int(mode), int(direction)
                )

    # --- inputs now -----------------------------------------------------------------------------

    def write(self, name: str, value: float | bool | str, source: str = API) -> None:
        """Write a variable or an operator's value; raises ``Failure`` for a wrong one."""
        self._access.write(name, value, source)

    def select(self, channel: int, name: str, source: str = API) -> None:
        """Select the program file of this name for a channel, counted from 0."""
        if not 0 <= channel < len(self._channels):
            raise ValueError(channel)
        self._forward(source, SELECT, channel, name)
        if self.on_select is not None:
            self.on_select(channel, name)

    def schedule(self, kind: str, *values: int) -> None:
        """Let the schedule of the coming tick have this, as a real clock has decided it."""
        self._forward(SCHEDULE, kind, *values)
        if self.on_schedule is not None:
            self.on_schedule(kind, values)

    def acknowledge(
        self, channel: int, is_realtime: bool, slot: int, serial: int, name: str
    ) -> None:
        """Acknowledge a function; a warning (900671) is reported if it no longer waits.

        Raises ``ValueError`` for an unknown slot.
        """
        if channel < 0:
            raise ValueError(channel)
        hli = self._channels[channel].hli
        section = hli.realtime if is_realtime else hli.program
        if not section.acknowledge(slot, serial):
            self._report_stale(name)
        self.note_acknowledged(channel, is_realtime, slot, serial, name)

    def note_acknowledged(
        self, channel: int, is_realtime: bool, slot: int, serial: int, name: str
    ) -> None:
        """Note a function that the realtime part has acknowledged for a PLC."""
        self._forward(PLC, ACKNOWLEDGE, channel, is_realtime, slot, serial, name)

    def acknowledge_spindle(self, channel: int, index: int, serial: int, name: str) -> None:
        """Acknowledge a spindle job as done; otherwise as ``acknowledge``."""
        if channel < 0:
            raise ValueError(channel)
        spindles = self._channels[channel].context.spindles
        if not spindles.acknowledge(index, serial):
            self._report_stale(name)
        self._forward(PLC, ACKNOWLEDGE_SPINDLE, channel, index, serial, name)

    def request_axis(
        self, kind: int, axis: int, value: float, speed: float, mode: int, direction: int
    ) -> int:
        """Request a motion of a single axis; return its owner's number, 0 if there is no room."""
        owner = self._kernel.requests.post(kind, axis, value, speed, mode, direction)
        if owner:
            self._forward(PLC, AXIS, kind, axis, float(value), float(speed), mode, direction)
        return owner

    def _forward(self, source: str, kind: str, *values: float | str | bool) -> None:
        self._notes.add(source, kind, values, None)
