# SPDX-License-Identifier: MIT
"""Coupled axes in the values of channel and axis lists."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.coupling_lists import (
    LISTED_PAIR_OF_ONE_AXIS,
    LISTED_PAIR_WITHOUT_AXIS,
    LISTED_SLAVE_IS_MASTER,
    LISTED_SLAVE_TWICE,
)

#: The pairs that a coupling group can have.
MAX_PAIRS = 15

_GROUP = "synchro_data.koppel_gruppe[]"
_PAIR = "synchro_data.koppel_gruppe[].paar[]"
_MASTER = f"{_PAIR}.log_achs_nr_master"
_SLAVE = f"{_PAIR}.log_achs_nr_slave"
_POSITION_UNITS = 10_000


@dataclass(frozen=True, slots=True)
class ListedPair:
    """A pair of group 0: logical numbers of axes, or of spindles."""

    slave: int
    master: int
    is_spindle: bool


@dataclass(frozen=True, slots=True)
class ListedCouplings:
    """The settings of a channel list for coupled axes.

    ``after_reset``: axes coupled then are coupled again (P-CHAN-00104), ``after_end``: also after
    the end of a program (P-CHAN-00105).
    """

    pairs: tuple[ListedPair, ...]
    after_reset: bool
    after_end: bool


@dataclass(frozen=True, slots=True)
class AxisGantry:
    """The axis that another follows permanently, by its logical number, 0: none; mm or degrees.

    ``allowed_d``: how far actual positions may differ, 0: no limit. ``offset``: the position
    relative to the master's.
    """

    master: int = 0
    allowed_d: float = 0.0
    offset: float = 0.0


def axis_gantry(values: Values) -> AxisGantry:
    """Return the axis that an axis follows by its list."""
    return AxisGantry(
        values.integer("kenngr.gantry_ax_nr"),
        values.integer("kenngr.gantry_max_diff_resetable") / _POSITION_UNITS,
        values.integer("kenngr.gantry_offset") / _POSITION_UNITS,
    )


def listed_couplings(values: Values, collector: Collector) -> ListedCouplings:
    """Return the pairs of group 0; each wrong one is reported and left out."""
    pairs: list[ListedPair] = []
    indices = values.indices(_PAIR, 0) if 0 in values.indices(_GROUP) else ()
    for index in indices:
        pair = ListedPair(
            values.integer(_SLAVE, 0, index),
            values.integer(_MASTER, 0, index),
            values.integer(f"{_PAIR}.mode", 0, index) == 1,
        )
        if not (pair.slave or pair.master):
            continue
        message = _mistake(pair, pairs)
        if message is None:
            pairs.append(pair)
            continue
        key = _SLAVE if values.is_set(_SLAVE, 0, index) else _MASTER
        values.report(
            collector, message, (key, 0, index), index=index, slave=pair.slave, master=pair.master
        )
    return ListedCouplings(
        tuple(pairs),
        values.flag("synchro_data.restore_coupling_after_reset"),
        values.flag("synchro_data.preserve_coupling_after_prog_end"),
    )


def _mistake(pair: ListedPair, others: list[ListedPair]) -> Message | None:
    if not pair.slave or not pair.master:
        return LISTED_PAIR_WITHOUT_AXIS
    if pair.slave == pair.master:
        return LISTED_PAIR_OF_ONE_AXIS
    if any(pair.slave == other.slave for other in others):
        return LISTED_SLAVE_TWICE
    if any(pair.slave == other.master or pair.master == other.slave for other in others):
        return LISTED_SLAVE_IS_MASTER
    return None
