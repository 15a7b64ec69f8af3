# SPDX-License-Identifier: MIT
"""The time of one channel: called after each tick, it returns the tick's purpose.

In: the channel between two ticks. Out: runs of ticks with the same purpose. A tick belongs to the
block that is current at its end, or that has ended in it without another one.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.kernel import rows
from nctakt.run.causes.wait_reasons import awaited
from nctakt.run.channel_run import ChannelRun
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.timing.entries import Limit, Phase, TimeKind
from nctakt.timing.limits import PathLimits


@dataclass(frozen=True, slots=True)
class TickPurpose:
    """The purpose of a tick: source number and N number of its block, the tool, the rest."""

    source: int
    number: int
    tool: int
    kind: TimeKind
    phase: Phase
    limit: Limit


@dataclass(slots=True)
class Interval:
    """Successive ticks with one purpose."""

    purpose: TickPurpose
    first_tick: int
    ticks: int


class ChannelClock:
    """The time of the channel ``index``, from 0, whose programs are those of ``run``."""

    def __init__(
        self,
        machine: AssembledMachine,
        index: int,
        run: ChannelRun,
        line_of: Callable[[int], Text],
    ) -> None:
        self._machine = machine
        self._index = index
        self._run = run
        self._channel = machine.channels[index]
        self._limits = PathLimits(machine, index, line_of)
        self._awaited: dict[tuple[str, int, int], Text] = {}
        self._speed_v = self._channel.path.speed_v
        self._used = self._channel.path.used
        self._was_active = self._channel.path.is_active
        self._was_running = run.is_running
        self.intervals: list[Interval] = []

    def end_tick(self, tick: int) -> None:
        """Note the purpose of the tick ``tick``, which has just ended."""
        purpose = self._purpose()
        path = self._channel.path
        self._speed_v, self._used, self._was_active = path.speed_v, path.used, path.is_active
        self._was_running = self._run.is_running
        if self.intervals and self.intervals[-1].purpose == purpose:
            self.intervals[-1].ticks += 1
        else:
            self.intervals.append(Interval(purpose, tick, 1))

    def _purpose(self) -> TickPurpose:
        path = self._channel.path
        is_in_block = path.is_active or self._was_active or path.used != self._used
        word, source, detail = self._channel.waits.reason()
        if word and path.speed_v == 0.0 == self._speed_v and not self._has_passed():
            return self._waiting(word, source, detail)
        if not is_in_block:
            if self._was_running:
                return self._standing(source, "commands", Limit("none"))
            return self._standing(0, "idle", Limit("none"))
        row = path.current_segment()
        if row[rows.KIND] == rows.DWELL:
            return self._of_block(row, "dwell", "standing", Limit("programmed"))
        if path.is_retracing:
            return self._of_block(row, "backward", "constant", Limit("unknown"))
        phase, limit = self._limits.of_tick(row, self._speed_v, path.speed_v)
        has_changed = path.used != self._used or not path.is_active
        if phase == "braking" and has_changed and self._was_active:
            limit = self._last_limit() or limit
        is_rapid = row[rows.MOTION] == rows.RAPID_MOTION
        return self._of_block(row, "rapid" if is_rapid else "feed", phase, limit)

    def _last_limit(self) -> Limit | None:
        """Return the goal for which the path braked in the last tick, ``None`` if it did not."""
        last = self.intervals[-1].purpose if self.intervals else None
        return last.limit if last is not None and last.phase == "braking" else None

    def _has_passed(self) -> bool:
        """Return whether a block has ended in the tick."""
        path = self._channel.path
        return not path.is_active and (self._was_active or path.used != self._used)

    def _waiting(self, word: str, source: int, detail: int) -> TickPurpose:
        key = word, source, detail
        if key not in self._awaited:
            self._awaited[key] = self._awaited_text(word)
        return self._standing(source, "wait", Limit("wait", self._awaited[key]))

    def _awaited_text(self, word: str) -> Text:
        """Return the reason why a program waits, without its start."""
        if word == "signal":
            number = self._channel.signals.awaited()[0]
            return Text(f"signal {number}", f"Signal {number}")
        if word == "exchange":
            return Text("an axis of another channel", "eine Achse eines anderen Kanals")
        text = awaited(self._machine, self._index, self._run)
        return Text(word, word) if text is None else text

    def _standing(self, source: int, kind: TimeKind, limit: Limit) -> TickPurpose:
        return TickPurpose(source, 0, self._tool(), kind, "standing", limit)

    def _of_block(
        self, row: list[float], kind: TimeKind, phase: Phase, limit: Limit
    ) -> TickPurpose:
        source, number = int(row[rows.SOURCE]), int(row[rows.BLOCK_NUMBER])
        return TickPurpose(source, number, self._tool(), kind, phase, limit)

    def _tool(self) -> int:
        """Return the number of the latest T word, 0 without one."""
        in_force = self._machine.registry.modal(self._channel.executor.modal)
        return 0 if in_force is None else in_force.tool
