# SPDX-License-Identifier: MIT
"""The door through which everything reaches a run from outside, tick by tick.

In: values of variables and of the operator's panel, acknowledgements of functions and spindle jobs,
motions of single axes that a PLC requests; now, or planned for a tick (stimuli, a tape). Out: what
the next tick latches (RC-002), in the order of arrival. A listener learns of each input: it is all
that a run needs to be repeated.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.tape import INPUT_NOT_POSSIBLE

if TYPE_CHECKING:
    from nctakt.kernel.kernel import Kernel
    from nctakt.kernel.tick.channel import Channel
    from nctakt.run.variable_access import VariableAccess

#: The kinds of inputs.
WRITE, ACKNOWLEDGE, ACKNOWLEDGE_SPINDLE, AXIS = "write", "ack", "ack_spindle", "axis"

#: Where inputs come from.
API, STIMULI, PLC = "api", "stimuli", "plc"

#: A tick that no run reaches.
NEVER = 1 << 62


class Input(NamedTuple):
    """An input that ``tick`` latches; ``values`` are the arguments of the method for its kind."""

    tick: int
    source: str
    kind: str
    values: tuple[float | str | bool, ...]


class Inputs:
    """The inputs of one machine; ``listener`` is called with each of them."""

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
        self.listener: Callable[[Input], None] | None = None

    # --- planned inputs -------------------------------------------------------------------------

    def plan(self, inputs: Iterable[Input]) -> None:
        """Replace the planned inputs; they come in the order of their ticks."""
        self._planned = deque(inputs)

    def add(self, inputs: Iterable[Input]) -> None:
        """Plan further inputs, each behind those of its tick that are planned already."""
        self._planned = deque(sorted([*self._planned, *inputs], key=lambda planned: planned.tick))

    def check(self, planned: Input) -> None:
        """Raise ``Failure`` for a name or a value that this machine does not take (901077)."""
        # The kernel is there when there are inputs to check; words for a run come before it.
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
            case _:
                raise Failure(self._impossible(planned))

    def _impossible(self, planned: Input) -> Diagnostic:
        found = f"{planned.kind} {', '.join(map(str, planned.values))}"
        return diagnostic(INPUT_NOT_POSSIBLE, tick=planned.tick, input=found)

    def apply_due(self) -> int:
        """Apply the planned inputs of the coming tick; return the tick of the next planned one."""
        planned = self._planned
        while planned and planned[0].tick <= self._kernel.tick:
            self._apply(planned.popleft())
        return planned[0].tick if planned else NEVER

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
            case "axis":
                kind, axis, position, speed, mode, direction = values
                self.request_axis(
                    int(kind), int(axis), float(position), float(speed), int(mode), int(direction)
                )

    # --- inputs now -----------------------------------------------------------------------------

    def write(self, name: str, value: float | bool | str, source: str = API) -> None:
        """Write a variable or an operator's value; raises ``Failure`` for a wrong one."""
        self._access.write(name, value)
        self._tell(source, WRITE, name, value if isinstance(value, str) else float(value))

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
        self._tell(PLC, ACKNOWLEDGE, channel, is_realtime, slot, serial, name)

    def acknowledge_spindle(self, channel: int, index: int, serial: int, name: str) -> None:
        """Acknowledge a spindle job as done; otherwise as ``acknowledge``."""
        spindles = self._channels[channel].context.spindles
        if not spindles.acknowledge(index, serial):
            self._report_stale(name)
        self._tell(PLC, ACKNOWLEDGE_SPINDLE, channel, index, serial, name)

    def request_axis(
        self, kind: int, axis: int, value: float, speed: float, mode: int, direction: int
    ) -> int:
        """Request a motion of a single axis; return its owner's number, 0 if there is no room."""
        owner = self._kernel.requests.post(kind, axis, value, speed, mode, direction)
        if owner:
            self._tell(PLC, AXIS, kind, axis, float(value), float(speed), mode, direction)
        return owner

    def _tell(self, source: str, kind: str, *values: float | str | bool) -> None:
        if self.listener is not None:
            self.listener(Input(self._kernel.tick, source, kind, values))
