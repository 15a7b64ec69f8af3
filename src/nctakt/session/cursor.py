# SPDX-License-Identifier: MIT
"""The place of a session within the last tick that it has run: before a statement of its PLC.

A tick is never split: the session is after it. A copy of its controller from before that tick
reruns it up to the statement, is inspected, and is discarded; so going back is the same as going
on. In: the stops looked for. Out: the place, its calls and its variables.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.plc_debugging import NO_STRUCTURED_TEXT, PLC_HAS_STOPPED
from nctakt.plc.stepping.shown import PlcValue
from nctakt.session.history.timeline import Timeline
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.statements import PlcPlace
from nctakt.session.stops import StopAt

#: A number that no statement of a tick reaches.
END = 1 << 59

#: Where a step ends: at the next statement, at one of this call or of one around it, around it.
Step = Literal["into", "over", "out"]

#: Any statement, and any fault of the PLC.
ANY = StopAt("statement")
FAULT = StopAt("fault")


@dataclass(frozen=True, slots=True)
class Passed:
    """The statements of a tick: their sources, and how many calls are open at them."""

    sources: Sequence[int]
    depths: Sequence[int]

    def met(self, stop: StopAt, meant: Sequence[int], number: int) -> tuple[int, int]:
        """Return the first statement after a number, and the last before it, of a stop; 0: none."""
        depth = stop.max_depth or END
        held = [
            index
            for index, (source, own) in enumerate(zip(self.sources, self.depths, strict=True), 1)
            if own <= depth and (not meant or source in meant)
        ]
        after = next((one for one in held if one > number), 0)
        return after, next((one for one in reversed(held) if one < number), 0)


class Cursor:
    """The place within the last tick; ``statement`` is ``None`` after it.

    It moves with the session: callers that move the session call ``leave`` first.
    """

    def __init__(self, timeline: Timeline) -> None:
        self._timeline = timeline
        self._base: RemoteEngine | None = None
        self._halted: RemoteEngine | None = None
        self._passed: Passed | None = None
        self._sources: dict[tuple[StopAt, ...], list[list[int]]] = {}
        self.statement: PlcPlace | None = None

    def leave(self) -> None:
        """Be after the last tick."""
        self._release_halted()
        if self._base is not None:
            self._base.close()
            self._base = None
        self.statement = None

    def _release_halted(self) -> None:
        if self._halted is not None and self._halted is not self._timeline.live:
            self._halted.close()
        self._halted = None

    # --- within the tick

    def next_in_tick(self, stops: Sequence[StopAt]) -> list[int]:
        """Go to the next statement of this tick at which one of some stops holds.

        Returns which of them do there; if none does, it does not move.
        """
        return self._move(stops, is_back=False)

    def last_in_tick(self, stops: Sequence[StopAt]) -> list[int]:
        """Go to the last statement before this one in this tick; returns as ``next_in_tick``."""
        return self._move(stops, is_back=True)

    def first_in_tick(self, stops: Sequence[StopAt]) -> list[int]:
        """Go to the first statement of this tick at which one of some stops holds."""
        return self._move(stops, is_back=False, number=0)

    def _move(
        self, stops: Sequence[StopAt], *, is_back: bool, number: int | None = None
    ) -> list[int]:
        if self._timeline.tick < 1 or not stops:
            return []
        if number is None:
            number = END if self.statement is None else self.statement.number or END
        if number == END and not is_back:
            return []
        met = self._met(stops, number)
        found = [last if is_back else first for first, last in met]
        numbers = [one for one in found if one]
        if not numbers:
            return []
        nearest = max(numbers) if is_back else min(numbers)
        self._halt(nearest)
        return [index for index, one in enumerate(found) if one == nearest]

    def _met(self, stops: Sequence[StopAt], number: int) -> list[tuple[int, int]]:
        base = self._before_the_tick()
        if self._passed is not None and not any(stop.only_if for stop in stops):
            asked = tuple(stops)
            if asked not in self._sources:
                self._sources[asked] = base.ask("statement_sources", asked)
            meant = zip(stops, self._sources[asked], strict=True)
            return [self._passed.met(stop, own, number) for stop, own in meant]
        engine = base.copy()
        try:
            met = engine.ask("statements_met", tuple(stops), number, number)
            return cast("list[tuple[int, int]]", met)
        finally:
            engine.close()

    def _before_the_tick(self) -> RemoteEngine:
        """Return the controller before the tick that the session has run last."""
        tick = self._timeline.tick - 1
        if self._base is None or self._base.tick != tick:
            self.leave()
            self._base = self._timeline.inside()
            self._base.ask("watch_statements")  # once, for all copies of it
            self._passed = self._all_passed(self._base)
        return self._base

    def _all_passed(self, base: RemoteEngine) -> Passed | None:
        """Return the statements of the tick; ``None`` if it has too many to be kept."""
        engine = base.copy()
        try:
            passed: tuple[list[int], list[int]] | None = engine.ask("statements_passed")
        finally:
            engine.close()
        return None if passed is None else Passed(*passed)

    def _halt(self, number: int) -> None:
        engine = self._before_the_tick().copy()
        try:
            halted = cast("PlcPlace | None", engine.ask("halt", number))
        except BaseException:
            engine.close()
            raise
        self._release_halted()
        self._halted, self.statement = engine, halted

    def enter_fault(self) -> bool:
        """Go to where a fault has stopped the PLC; return whether one has."""
        failed = cast("PlcPlace | None", self._timeline.live.ask("plc_fault"))
        if failed is not None:
            self._release_halted()
            self._halted, self.statement = self._timeline.live, failed
        return failed is not None

    def sought(self, step: Step) -> StopAt:
        """Return the stop at which a step from here ends; raises ``Failure`` (902810, 902818)."""
        if not self._timeline.description.plc_lines:
            raise Failure(diagnostic(NO_STRUCTURED_TEXT, what="step"))
        depth = 0 if self.statement is None else len(self.statement.frames)
        if step == "into" or depth == 0:
            return ANY
        return StopAt("statement", max_depth=max(1, depth if step == "over" else depth - 1))

    def check_goes_on(self) -> None:
        """Raise ``Failure`` (902818) where a fault has stopped the PLC."""
        if self.statement is not None and self.statement.fault is None:
            return
        if self._timeline.live.ask("plc_fault") is not None:
            raise Failure(diagnostic(PLC_HAS_STOPPED))

    # --- looking

    def look(self, request: str, *words: Any) -> Any:
        """Return the answer of the controller at this place; after a tick the session's."""
        engine = self._timeline.live if self._halted is None else self._halted
        return engine.ask("look_inside", request, *words)

    def value(self, text: str, level: int | None = 0) -> PlcValue:
        """Return the value of a path or an expression in a call; raises ``Failure``."""
        return cast("PlcValue", self.look("value", level, text))
