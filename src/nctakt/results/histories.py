# SPDX-License-Identifier: MIT
"""What realtime cycles and their conditions did in a run, as data.

Made by ``probe_log.py`` from what the realtime part recorded, read by ``reasons.py`` and
``why_text.py``. Ticks count from the controller's start (RC-001). Bounds keep memory constant over
a long run: where one was reached, ``left_out`` says how much older was dropped.
"""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.cycles.builder import FrozenValue
from nctakt.nc.check.branches import BranchWord

#: Why a branch's body, or a cycle, did not run.
#:
#: Of a cycle: ``undefined`` its definition was not taken; ``unstarted`` no START; ``waiting`` for
#: the block of scope BLOCK; ``held``; ``ended``; ``stopped`` by the fault of another cycle in this
#: tick; ``reset`` while the channel was reset.
#:
#: Of a branch: ``cycle`` its cycle did not run; ``outer`` the branch around it did not run;
#: ``earlier`` a branch before it in the same ``$IF`` ran; ``false`` its condition was false;
#: ``no rise`` an EDGE whose condition was true before already; ``done`` a ONCE that has run;
#: ``fault`` its cycle was ended by an error before; ``forgotten`` too long ago to be known.
ReasonKind = Literal[
    "undefined",
    "unstarted",
    "waiting",
    "held",
    "ended",
    "stopped",
    "reset",
    "cycle",
    "outer",
    "earlier",
    "false",
    "no rise",
    "done",
    "fault",
    "forgotten",
]

LifeKind = Literal["living", "created", "started", "held", "continued", "ended"]
EndedBy = Literal["", "scope", "program", "delete", "reset", "error"]


@dataclass(frozen=True, slots=True)
class Series:
    """Consecutive ticks, both ends included."""

    first_tick: int
    last_tick: int


@dataclass(frozen=True, slots=True)
class Times:
    """In which ticks something happened: series in their order, the newest ``SERIES_KEPT``.

    ``ticks`` is the number of all ticks, those of the ``left_out`` older series included.
    """

    series: tuple[Series, ...] = ()
    ticks: int = 0
    left_out: int = 0

    def holds(self, tick: int) -> bool | None:
        """Whether it happened in that tick; ``None`` where that was dropped."""
        if self.left_out and tick < self.series[0].first_tick:
            return None
        return any(one.first_tick <= tick <= one.last_tick for one in self.series)


@dataclass(frozen=True, slots=True)
class Change:
    """A condition became true or false, or was evaluated for the first time (since START).

    ``left`` and ``right`` are what it compared; a condition that compares nothing has its value and
    0.5 (RC-202).
    """

    tick: int
    truth: bool
    left: float
    right: float


@dataclass(frozen=True, slots=True)
class Nearest:
    """The evaluation in which a condition that was never true came nearest to it, the first such.

    ``distance`` is that of the two sides.
    """

    tick: int
    left: float
    right: float
    distance: float


@dataclass(frozen=True, slots=True)
class Reason:
    """Why something did not run; which fields are meant depends on ``kind``.

    ``tick``: since when or at which tick. ``span``: the command that did it. ``branch``: the branch
    that is to blame, by its position in the cycle. ``change``: what the condition saw last.
    ``nearest``: what it saw when it came nearest. ``ended_by``: what ended the cycle. ``cycle``:
    for ``cycle`` why it did not run. ``number``: of the error.
    """

    kind: ReasonKind
    tick: int | None = None
    span: Span | None = None
    branch: int | None = None
    change: Change | None = None
    nearest: Nearest | None = None
    ended_by: EndedBy = ""
    cycle: Reason | None = None
    number: int = 0


@dataclass(frozen=True, slots=True)
class LifeEvent:
    """One step in a cycle's life: ``span`` is the command; ``number`` that of an error.

    ``living`` stands for what an earlier run of the controller had begun.
    """

    tick: int
    kind: LifeKind
    span: Span | None = None
    ended_by: EndedBy = ""
    number: int = 0


@dataclass(frozen=True, slots=True)
class ConditionHistory:
    """A condition, or a part of one that ``&&`` or ``||`` combines.

    ``operator`` is that of the comparison, ``&&`` or ``||``, empty for a value alone. ``changes``
    are its changes of truth, the newest ``CHANGES_KEPT``. ``was_true``: its truth before the run,
    ``None`` when it had none. ``nearest``: ``None`` if it was true once or never evaluated.
    ``true_ticks`` and ``false_ticks`` count the evaluations of the whole run by what they gave; one
    that an error broke off gave nothing.
    """

    text: str = ""
    operator: str = ""
    changes: tuple[Change, ...] = ()
    changes_left_out: int = 0
    was_true: bool | None = None
    nearest: Nearest | None = None
    true_ticks: int = 0
    false_ticks: int = 0


@dataclass(frozen=True, slots=True)
class BranchHistory:
    """One branch of a cycle; the condition of ``$ELSE`` is empty.

    ``text`` is its source line without blanks around. ``outer`` and ``earlier`` are positions
    in the cycle's branches. ``parts`` are what ``&&`` and ``||`` combine in the condition. In the
    ticks ``evaluated`` the condition was, in the ticks ``bodies`` the body ran. ``frozen`` are the
    asynchronous values in the condition (RC-302). ``commands`` are the statements of the body that
    stand in no further branch.
    """

    span: Span
    lines: tuple[int, ...]
    text: str
    word: BranchWord
    frequency: str
    outer: int | None
    earlier: tuple[int, ...]
    condition: ConditionHistory = ConditionHistory()
    parts: tuple[ConditionHistory, ...] = ()
    evaluated: Times = Times()
    bodies: Times = Times()
    frozen: tuple[FrozenValue, ...] = ()
    commands: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class CycleHistory:
    """One realtime cycle of the run, or a definition that the run did not reach (``life`` empty).

    ``name`` is its ID, ``#1`` without one, empty for an unreached definition. ``lines`` are those
    that stand in no branch. ``stops`` are faults of other cycles in whose tick it may not have run:
    tick, place and number. ``shown`` are the branches that were asked for. ``end_line`` is that of
    its ``#RT CYCLE END``.
    """

    name: str
    scope: str
    span: Span
    end_line: int
    lines: tuple[int, ...]
    text: str
    branches: tuple[BranchHistory, ...]
    shown: tuple[int, ...]
    life: tuple[LifeEvent, ...] = ()
    life_left_out: int = 0
    runs: Times = Times()
    stops: tuple[LifeEvent, ...] = ()
