# SPDX-License-Identifier: MIT
"""A PLC in Python in the loop of ticks: called when it is due, and in no other tick.

In: the PLC, a machine. Out: ticks, with the PLC's call after each of them, or only after those with
an event that it has declared to wait for. Its calls come after everything else that Python does for
the same tick.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from nctakt.hli.function_codes import function_name
from nctakt.run.plcs.plc_view import PlcView, WatchedPlc

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import AnyPlc, Declaration
    from nctakt.run.realtime.assembly import AssembledMachine

#: Maximum number of ticks until the listener of inputs gets the PLC's writes in them.
_TICKS_OF_NOTES = 1_000


class PlcWithBlocks(WatchedPlc):
    """A PLC in Python, if there is one, then the blocks that Python carries out for others."""

    def __init__(self, plc: AnyPlc | None, blocks: Sequence[Callable[[PlcView], None]]) -> None:
        self._plc = plc
        self._blocks = blocks

    def cycle(self, hli: PlcView) -> None:
        """Call them after a tick."""
        if self._plc is not None:
            self._plc.cycle(hli)
        for block in self._blocks:
            block(hli)


class PlcPlayer:
    """A PLC on the channels of a machine; its calls pass its exceptions on."""

    def __init__(self, plc: AnyPlc, machine: AssembledMachine) -> None:
        machine.kernel.calls.stop()
        self._plc = plc
        self._machine = machine
        self._kernel = machine.kernel
        self._watched = plc if isinstance(plc, WatchedPlc) else WatchedPlc()
        self._call = self._watched.each_call() or plc.cycle
        self._declaration: Declaration | None = None
        self._view = PlcView(machine)

    def bound(self, ticks: int) -> int:
        """Return how many of these ticks may run until the listener of inputs has its turn."""
        inputs = self._machine.inputs
        if inputs.has_image:
            return 1  # writes of another process are noted tick by tick
        return min(ticks, _TICKS_OF_NOTES) if inputs.has_listener else ticks

    def run(self, ticks: int) -> int:
        """Run ticks as ``Kernel.run``, with the calls that nothing else comes before."""
        self._follow()
        if self._declaration is None:
            return int(self._guarded(self._kernel.run_calling, ticks, self._call, self._view))
        self._kernel.calls.is_noting = self._machine.inputs.has_listener
        return self._kernel.run(ticks)

    def finish(self) -> None:
        """Call the PLC if it is due after the ticks that ``run`` has run."""
        calls, declared = self._kernel.calls, self._declaration
        if self._kernel.is_plc_due:
            self._guarded(self._call if declared is None else declared.call, self._view)
            self._follow()
            if self._declaration is not None:
                calls.next_tick = self._declaration.next_call(self._view)
                calls.answer(self._view.tick)
        if declared is not None and calls.answer_count > 0:
            self._note_answers()

    def cycle(self) -> None:
        """Call the PLC where a schedule says when."""
        self._plc.cycle(self._view)

    def _follow(self) -> None:
        """Let the realtime part watch for the events that the PLC waits for now."""
        declared = self._watched.declaration(self._view)
        if declared is not self._declaration:
            self._declaration = declared
            if declared is not None:
                slots = self._machine.channels[0].hli, self._machine.channels[0].context.spindles
                self._kernel.calls.watch(*slots, list(declared.whens), declared.delays)

    def _note_answers(self) -> None:
        """Note the functions that the realtime part has acknowledged for the PLC."""
        slots, inputs = self._machine.channels[0].hli, self._machine.inputs
        for section in (slots.program, slots.realtime):
            for slot, function, _, _, serial in section.answered():
                is_realtime, name = section is slots.realtime, function_name(function)
                inputs.note_acknowledged(0, is_realtime, slot, serial, name)
        self._kernel.calls.answer_count = 0

    def _guarded(self, function: Callable[..., Any], *words: object) -> Any:
        """Call a function of the PLC; its exceptions become ``WatchedPlc.failure``."""
        try:
            return function(*words)
        except (Exception, SystemExit) as error:  # the user's code may raise anything
            failure = self._watched.failure(error, self._view)
            if failure is error:
                raise
            raise failure from error
