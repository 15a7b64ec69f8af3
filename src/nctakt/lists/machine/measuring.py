# SPDX-License-Identifier: MIT
"""Measuring with a touch probe in the values of axis lists and channel lists."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values

#: The types of measuring (P-CHAN-00057).
FIRST_TYPE, LAST_TYPE = 1, 7

_POSITION_UNITS = 10_000
_SPEED_UNITS = 1_000
#: Modes of P-AXIS-00112: when the simulated probe of an axis touches.
AT_POSITION, AFTER_CYCLES, AT_REST_PCT, ALL_AT_TARGET, ONE_AT_TARGET, AT_OBJECT = range(1, 7)


@dataclass(frozen=True, slots=True)
class AxisMeasuring:
    """Measuring with one axis, in mm or degrees and mm/s or degrees/s.

    ``takes_part``: P-AXIS-00118. ``speed`` and ``overtravel`` are those of type 2. ``simulation``:
    the mode of the simulated probe where the list gives P-AXIS-00112, else 0: the signal is
    HLI.PROBE alone. ``first``, ``second``: its parameters 1 and 2 in the units of the list.
    ``finds_stops``: P-AXIS-00330, type 7; at a fixed stop command and actual position differ by
    more than ``stop_lag`` (0: not given) for ``stop_us``, or ``stop_ticks``.
    """

    takes_part: bool = False
    speed: float = 16.666
    overtravel: float = 0.0
    simulation: int = 0
    first: int = 0
    second: int = 0
    finds_stops: bool = False
    stop_lag: float = 0.0
    stop_us: int = 0
    stop_ticks: int = 0


@dataclass(frozen=True, slots=True)
class ChannelMeasuring:
    """Measuring in a channel; ``type``: P-CHAN-00057.

    ``shortens_travel``: measuring motions end at software limits. ``adds_radius``: values as
    programmed are those of the workpiece, not of the centre of the probe. ``of_all_axes``: not of
    the programmed axes alone, where a coordinate system is active.
    """

    type: int
    needs_signal: bool
    needs_fixed_stop: bool
    may_be_pressed: bool
    needs_travel: bool
    shortens_travel: bool = False
    adds_radius: bool = True
    of_all_axes: bool = False


def axis_measuring(values: Values) -> AxisMeasuring:
    """Return the settings of an axis list for measuring."""
    mode = "meas_simu.meas_simu_mode"
    simulation = values.integer(mode)
    return AxisMeasuring(
        values.flag("kenngr.messachse"),
        values.integer("kenngr.vb_messen") / _SPEED_UNITS,
        values.integer("kenngr.mess_offset") / _POSITION_UNITS,
        simulation if values.is_set(mode) else 0,
        values.integer("meas_simu.parameter1"),
        values.integer("meas_simu.parameter2"),
        values.flag("kenngr.meas_signal_fixed_stop"),
        _stop_lag(values),
        values.integer("kenngr.measure.fixed_stop_detect.min_time")
        or values.integer("antr.fixed_stop.detect.min_time"),
        values.integer("kenngr.fixed_stop_nbr_cycles"),
    )


def _stop_lag(values: Values) -> float:
    """Return the lag at a fixed stop: P-AXIS-00774, else 00769, else 00331."""
    for name in ("kenngr.measure.fixed_stop_detect", "antr.fixed_stop.detect"):
        lag = values.integer(f"{name}.pos_lag_limit")
        if lag >= 0:
            return lag / _POSITION_UNITS
    return values.integer("kenngr.fixed_stop_pos_lag_limit") / _POSITION_UNITS


def channel_measuring(values: Values) -> ChannelMeasuring:
    """Return the settings of a channel list for measuring."""
    return ChannelMeasuring(
        values.integer("messtyp"),
        values.flag("meas_error_no_signal"),
        not values.flag("meas_fixed_stop_no_error"),
        values.flag("meas_allow_actuated_probe"),
        values.flag("meas_error_no_move_path"),
        values.flag("meas_soft_limit_move_path"),
        not values.flag("meas_pcs_value_no_probe_radius"),
        values.flag("meas_all_axes"),
    )
