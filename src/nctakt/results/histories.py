# SPDX-License-Identifier: MIT
"""The histories of realtime cycles and their conditions in a run, as data.

Built by ``probe_log.py`` from the rows of the realtime part, read by ``reasons.py`` and
``why_text.py``. Ticks count from the controller's start (RC-001). Bounds keep the memory constant
over a long run: ``left_out`` is the number of older entries that were dropped.
"""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.cycles.builder import FrozenValue
from nctakt.nc.check.cycles.branches import BranchWord

#: The reason why a cycle or the body of a branch did not run.
#:
#: Of a cycle: ``undefined`` its definition was not executed; ``unstarted`` no START; ``waiting``
#: for the block of scope BLOCK; ``held``; ``ended``; ``stopped`` by the fault of another cycle in
#: this tick; ``reset`` while the channel was reset.
#:
#: Of a branch: ``cycle`` its cycle did not run; ``outer`` the branch around it did not run;
#: ``earlier`` a branch before it in the same ``$IF`` ran; ``false`` its condition was false; ``no
#: rise`` an EDGE whose condition had been true before; ``done`` a ONCE that has run; ``fault`` an
#: error ended its cycle before; ``forgotten`` the history does not reach back that far.
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
    """Consecutive ticks, first and last included."""

    first_tick: int
    last_tick: int


@dataclass(frozen=True, slots=True)
class Times:
    """The ticks in which something happened, as series in their order, the newest ``SERIES_KEPT``.

    ``ticks`` is the number of all ticks, including those of the ``left_out`` older series.
    """

    series: tuple[Series, ...] = ()
    ticks: int = 0
    left_out: int = 0

    def holds(self, tick: int) -> bool | None:
        """Return whether it happened in this tick; ``None`` if that was dropped."""
        if self.left_out and tick < self.series[0].first_tick:
            return None
        return any(series.first_tick <= tick <= series.last_tick for series in self.series)


@dataclass(frozen=True, slots=True)
class Change:
    """A change of a condition to true or false, or its first evaluation (since START).

    ``left`` and ``right`` are the compared values; a condition without a comparison has its value
    and 0.5 (RC-202).
    """

    tick: int
    truth: bool
    left: float
    right: float


@dataclass(frozen=True, slots=True)
class Nearest:
    """The first evaluation in which a condition that never changed came nearest to changing.

    ``distance`` is the difference of the compared values. For ``&&`` and ``||``, which compare
    none, it measures how far their operands are from it, so that runs can be compared.
    """

    tick: int
    left: float
    right: float
    distance: float


@dataclass(frozen=True, slots=True)
class Reason:
    """The reason why a cycle or a branch did not run; the fields in use depend on ``kind``.

    ``tick``: since which or at which tick. ``span``: the responsible command. ``branch``: the
    responsible branch, by its index in the cycle. ``change``: the last change of the condition.
    ``nearest``: its evaluation nearest to true. ``ended_by``: the end of the cycle. ``cycle``: the
    reason of the cycle, for the kind ``cycle``. ``number``: of the error.
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
    """A step in a cycle's life: ``span`` is the command; ``number`` the number of an error.

    The kind ``living`` marks a cycle that an earlier run of the controller began.
    """

    tick: int
    kind: LifeKind
    span: Span | None = None
    ended_by: EndedBy = ""
    number: int = 0


#: Operators of conditions whose sides are not numbers.
WITHOUT_VALUES = ("&&", "||", "text")


@dataclass(frozen=True, slots=True)
class ConditionHistory:
    """A condition, or an operand of its ``&&`` or ``||``.

    ``operator`` is that of the comparison, ``&&`` or ``||``, empty for a single value, ``text`` for
    a comparison of texts. ``changes`` are its changes of truth, the newest ``CHANGES_KEPT``.
    ``was_true``: its truth before the run, ``None`` without one. ``nearest`` to true: ``None`` if
    it was true once or never evaluated; ``nearest_to_false``: ``None`` if it was false once.
    ``true_ticks`` and ``false_ticks`` count the evaluations of the whole run by their result; an
    evaluation aborted by an error has none.
    """

    text: str = ""
    operator: str = ""
    changes: tuple[Change, ...] = ()
    changes_left_out: int = 0
    was_true: bool | None = None
    nearest: Nearest | None = None
    true_ticks: int = 0
    false_ticks: int = 0
    nearest_to_false: Nearest | None = None


@dataclass(frozen=True, slots=True)
class BranchHistory:
    """One branch of a cycle; the condition of ``$ELSE`` is empty.

    ``text`` is its source line without surrounding blanks. ``outer`` and ``earlier`` are indices
    of the cycle's branches. ``parts`` are the operands of ``&&`` and ``||`` in the condition.
    ``evaluated`` are the ticks in which the condition was evaluated, ``bodies`` those in which the
    body ran; ``became_true``: how often it ran and had not run in the run-through before.
    ``frozen`` are the asynchronous values in the condition (RC-302). ``commands`` are the
    statements of the body outside of inner branches.
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
    became_true: int = 0


@dataclass(frozen=True, slots=True)
class CycleHistory:
    """A realtime cycle of the run, or a definition that the run did not reach (``life`` empty).

    ``name`` is its ID, ``#1`` without one, empty for an unreached definition. ``lines`` are those
    outside all branches. ``stops`` are faults of other cycles in whose tick it may not have run:
    tick, position and number. ``shown`` are the indices of the selected branches. ``end_line`` is
    the line of its ``#RT CYCLE END``.
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
