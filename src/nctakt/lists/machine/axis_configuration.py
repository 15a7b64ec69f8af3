# SPDX-License-Identifier: MIT
"""The values of an axis list -> one axis, in natural units.

In: checked values. Out: ``AxisConfiguration``: mm, mm/s, mm/s² for linear axes, degrees, °/s, °/s²
for rotary axes and spindles; ``type`` decides, so that these fields have no unit in their names.
Contradicting limits are reported and corrected.
"""

from __future__ import annotations

import enum
from math import inf

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values
from nctakt.lists.machine.couplings import AxisGantry, axis_gantry
from nctakt.lists.machine.measuring import AxisMeasuring, axis_measuring
from nctakt.messages import Collector
from nctakt.messages.machines.machine import (
    AXIS_BEYOND_LIMIT,
    FEED_FORWARD_ON_AND_OFF,
    LIMIT_TOLERANCE_TOO_LARGE,
    MODULO_RANGE_EMPTY,
    SOFTWARE_LIMITS_SWAPPED,
    UNKNOWN_GEAR_STEP,
)

_POSITION_UNITS = 10_000
_SPEED_UNITS = 1_000


@dataclass(frozen=True, slots=True)
class AxisHoming:
    """Homing of a simulated axis, in mm or degrees and mm/s or degrees/s.

    ``distance``: signed, from where it is to the zero pulse; ``position``: its position there.
    """

    is_allowed: bool = True
    distance: float = -0.001
    speed: float = 16.666
    position: float = 0.0


def axis_homing(values: Values) -> AxisHoming:
    """Return how an axis is homed.

    A simulated axis starts on its cam: it leaves it against the direction of P-AXIS-00158, and
    without a cam it moves in that direction.
    """
    number = values.integer("kenngr.getriebe_stufe")
    steps = sorted({0, *values.indices("getriebe[]")})
    step = next((i for i in steps if values.integer("getriebe[].nummer", i) == number), 0)
    distance = values.integer("antr.simu.rpf_weg_bis_nip") / _POSITION_UNITS
    is_positive = values.flag("kenngr.ref_richt")
    if not values.flag("kenngr.ref_ohne_nocken"):
        is_positive = not is_positive
    if values.flag("kenngr.homing_without_zero_pulse"):
        distance = 0.0
    low, high = (values.integer(f"getriebe[].{name}", step) for name in ("vb_reflow", "vb_refmax"))
    return AxisHoming(
        values.text("kenngr.homing.homing_type") != "DISABLED",
        distance if is_positive else -distance,
        min(low, high) / _SPEED_UNITS,
        values.integer("getriebe[].pos_refpkt", step) / _POSITION_UNITS,
    )


#: Positions of the lists (0.1 µm, 1e-4°) per mm or degree.
POSITION_UNITS = 10_000
#: Speeds of the lists (µm/s, 1e-3°/s) per mm/s or °/s.
SPEED_UNITS = 1_000
#: The largest limit with its tolerance, in units of the lists.
MAX_SGN32 = 2**31 - 1
_MODULO_BIT = 0x4
_MODULO_LINEAR_BIT = 0x400
#: The bit of P-AXIS-00015 for the face axis of a lathe.
_FACE_BIT = 0x40
#: The bit of P-AXIS-00015 for an axis that #FACE and #CYL can turn a part with.
_C_AXIS_BIT = 0x200


class AxisType(enum.Enum):
    """The type of an axis (P-AXIS-00018)."""

    LINEAR = "ACHSTYP_TRANSLATOR"
    ROTARY = "ACHSTYP_ROTATOR"
    SPINDLE = "ACHSTYP_SPINDEL"


@dataclass(frozen=True, slots=True)
class TrapezoidSlope:
    """Accelerations below and above a changeover speed (lslope_profil)."""

    low: float
    high: float
    changeover_speed: float

    def acceleration(self, top_speed: float, limit: float) -> float:
        """Return the acceleration that never exceeds the two stages up to ``top_speed``.

        nctakt's trapezoid has one acceleration per motion. It is that of stage 1 if the changeover
        speed is at least ``top_speed``, else the minimum of both; ``limit`` (a_max) bounds it.
        """
        stages = self.low if self.changeover_speed >= top_speed else min(self.low, self.high)
        return min(stages, limit)


@dataclass(frozen=True, slots=True)
class JerkSlope:
    """Accelerations and ramp times of the jerk-limited slope (``slope_profil``).

    Jerk = acceleration / ramp time. Ramp times in µs, in the order: acceleration builds up, fades,
    deceleration builds up, fades.
    """

    acceleration: float
    deceleration: float
    rapid_acceleration: float
    ramp_times_us: tuple[int, int, int, int]
    rapid_ramp_time_us: int

    @property
    def min_acceleration(self) -> float:
        """The acceleration that never exceeds those of feed, braking and rapid."""
        return min(self.acceleration, self.deceleration, self.rapid_acceleration)

    @property
    def jerk(self) -> float:
        """The jerk that never exceeds that of any ramp; 0 if no ramp takes time."""
        up, down, brake, release = self.ramp_times_us
        longest_us = max(up, down, brake, release, self.rapid_ramp_time_us)
        return self.min_acceleration / (longest_us / 1e6) if longest_us > 0 else 0.0


@dataclass(frozen=True, slots=True)
class AxisDynamics:
    """Limits of one gear step; ``kv``, the gain of the position control, in 1/s.

    ``change_position``: where the axis is while the gear changes (P-AXIS-00078).
    """

    gear_number: int
    max_speed: float
    rapid_speed: float
    max_acceleration: float
    feed_slope: TrapezoidSlope
    rapid_slope: TrapezoidSlope
    jerk_slope: JerkSlope
    shortest_ramp_time_us: int
    kv: float
    modulo_low: float
    modulo_high: float
    change_position: float

    @property
    def feed_acceleration(self) -> float:
        """Acceleration and deceleration of feed and independent motions, trapezoid."""
        return self.feed_slope.acceleration(self.max_speed, self.max_acceleration)

    @property
    def rapid_acceleration(self) -> float:
        """Acceleration and deceleration of rapid motions, trapezoid."""
        return self.rapid_slope.acceleration(self.rapid_speed, self.max_acceleration)

    @property
    def smooth_accelerations(self) -> tuple[float, float]:
        """Acceleration of rapid motions and of feed with the jerk-limited slope."""
        slope = self.jerk_slope
        feed = min(slope.acceleration, slope.deceleration, self.max_acceleration)
        return (min(slope.rapid_acceleration, self.max_acceleration), feed)

    @property
    def smooth_jerks(self) -> tuple[float, float]:
        """Jerk of rapid motions and of feed, by the slowest ramp."""
        rapid, feed = self.smooth_accelerations
        shortest_us = max(self.shortest_ramp_time_us, 1)
        rapid_us = max(self.jerk_slope.rapid_ramp_time_us, shortest_us)
        return (
            rapid * 1e6 / rapid_us,
            feed * 1e6 / max(*self.jerk_slope.ramp_times_us, shortest_us),
        )


#: The kinds of feed-forward control that contain that of the velocity.
_VELOCITY_MODES = frozenset(("VEL", "ADD_VEL"))


@dataclass(frozen=True, slots=True)
class FeedForward:
    """The share of the command speed that bypasses the position control where it is on.

    ``is_permanent``: it is on without G135.
    """

    share: float = 0.0
    is_permanent: bool = False

    @property
    def permanent_share(self) -> float:
        """The share at start-up."""
        return self.share if self.is_permanent else 0.0


@dataclass(frozen=True, slots=True)
class AxisConfiguration:
    """One axis; ``dynamics`` are those of the gear step that is active after start-up.

    ``is_modulo``: positions repeat every ``modulo_range``, and there are no software limits.
    ``override_mode``: P-AXIS-00491. ``ignores_channel_hold``: P-AXIS-00540. ``max_override_pct``:
    P-AXIS-00109. ``follows_exactly``: actual position = command position (P-AXIS-00096).
    ``obstacle``: position that the axis cannot pass, in mm or degrees; 0: none. ``file``: the list
    that describes the axis. ``is_face``: it is the face axis of a lathe, whose position is a
    radius; ``is_c_axis``: the C axis of a lathe (both P-AXIS-00015). ``absolute_diameters``,
    ``relative_diameters``: the effect of G51 on its positions and distances (P-AXIS-00058, 00059).
    ``mode``: all of P-AXIS-00015. ``filter_type``: of its FIR filter, 0 none. ``gears``: the
    dynamics of all gear steps. ``checks_tool_speed``: P-AXIS-00474. ``gantry``: the axis that it
    follows permanently.
    """

    logical_number: int
    name: str
    type: AxisType
    is_modulo: bool
    enable_single_axis: bool
    override_mode: int
    max_override_pct: float
    software_limit_low: float
    software_limit_high: float
    optimised_schedule: bool
    follows_exactly: bool
    obstacle: float
    feed_forward: FeedForward
    dynamics: AxisDynamics
    file: str
    is_face: bool = False
    is_c_axis: bool = False
    absolute_diameters: bool = False
    relative_diameters: bool = False
    mode: int = 1
    measuring: AxisMeasuring = AxisMeasuring()
    homing: AxisHoming = AxisHoming()
    filter_type: int = 0
    gears: tuple[AxisDynamics, ...] = ()
    checks_tool_speed: bool = False
    gantry: AxisGantry = AxisGantry()
    ignores_channel_hold: bool = False

    @property
    def is_linear(self) -> bool:
        """Whether lengths are mm; otherwise they are degrees."""
        return self.type is AxisType.LINEAR

    @property
    def modulo_range(self) -> float:
        """Length of the modulo range, 0 for an axis without one."""
        if not self.is_modulo:
            return 0.0
        return self.dynamics.modulo_high - self.dynamics.modulo_low

    @property
    def reachable(self) -> tuple[float, float]:
        """The software limits, or the modulo range."""
        if self.is_modulo:
            return self.dynamics.modulo_low, self.dynamics.modulo_high
        return self.software_limit_low, self.software_limit_high

    @property
    def rapid_speed(self) -> float:
        """Speed of G00, never above ``max_speed``."""
        return self.dynamics.rapid_speed

    @property
    def max_speed(self) -> float:
        """Highest speed of any motion."""
        return self.dynamics.max_speed

    @property
    def max_acceleration(self) -> float:
        """The acceleration of all motions of the axis, trapezoid: the minimum of both."""
        return min(self.dynamics.feed_acceleration, self.dynamics.rapid_acceleration)

    @property
    def kv(self) -> float:
        """Gain of the position control in 1/s; without effect if ``follows_exactly``."""
        return self.dynamics.kv


def axis_configuration(values: Values, collector: Collector) -> AxisConfiguration:
    """Return the axis of the values of its list (over those of the defaults list)."""
    type_ = AxisType(values.text("kenngr.achs_typ"))
    mode = values.integer("kenngr.achs_mode")
    modulo_bit = _MODULO_LINEAR_BIT if type_ is AxisType.LINEAR else _MODULO_BIT
    steps = sorted({0, *values.indices("getriebe[]")})
    gears = tuple(_dynamics(values, step, collector) for step in steps)
    is_modulo = bool(mode & modulo_bit) or type_ is AxisType.SPINDLE
    low, high = (-inf, inf) if is_modulo else _software_limits(values, collector)
    return AxisConfiguration(
        values.integer("kopf.achs_nr"),
        values.text("kopf.log_achs_name"),
        type_,
        is_modulo,
        values.flag("kenngr.enable_single_axis"),
        values.integer("kenngr.indp_override_mode"),
        values.integer("kenngr.max_vb_override") / 10,
        low,
        high,
        values.flag("lr_param.field_bus_allows_optimized_schedule"),
        values.flag("antr.simu.ist_gleich_soll"),
        0.0 if is_modulo else values.integer("antr.simu.fixed_stop") / POSITION_UNITS,
        _feed_forward(values, collector),
        _active_gear(values, gears, collector),
        values.file,
        bool(mode & _FACE_BIT),
        bool(mode & _C_AXIS_BIT),
        values.flag("kenngr.durchm_prog_abs"),
        values.flag("kenngr.durchm_prog_rel"),
        mode,
        axis_measuring(values),
        axis_homing(values),
        values.integer("vib_guard.type"),
        gears,
        values.flag("kenngr.check_spindle_speed_in_tool_range"),
        axis_gantry(values),
        values.integer("kenngr.indp_feedhold_mode") == 1,
    )


def _feed_forward(values: Values, collector: Collector) -> FeedForward:
    """Return the feed-forward control of an axis; off forever outweighs on forever."""
    is_permanent = values.flag("vorsteuer.default_active")
    is_disabled = values.flag("vorsteuer.global_disable")
    if is_permanent and is_disabled:
        values.report(collector, FEED_FORWARD_ON_AND_OFF, ("vorsteuer.global_disable",))
    if is_disabled or not _VELOCITY_MODES.intersection(values.names("vorsteuer.vorsteuerung")):
        return FeedForward()
    share = values.integer("vorsteuer.vs_v_faktor") / values.integer("vorsteuer.vs_v_nenner")
    return FeedForward(share, is_permanent)


def _software_limits(values: Values, collector: Collector) -> tuple[float, float]:
    """Return the software limits of an axis, which is at 0 at start-up.

    The tolerance (P-AXIS-00179) widens them for that place, not for commands. Reported: limits that
    are swapped, an axis beyond them, a sum of limit and tolerance beyond 32 bits.
    """
    low = values.integer("kenngr.swe_neg")
    high = values.integer("kenngr.swe_pos")
    if low >= high:
        values.report(collector, SOFTWARE_LIMITS_SWAPPED, ("kenngr.swe_neg",), low=low, high=high)
        low, high = min(low, high), max(low, high)
    tolerance = _tolerance(values, low, high, collector)
    if not low - tolerance <= 0 <= high + tolerance:
        key = "kenngr.swe_pos" if high < 0 else "kenngr.swe_neg"
        values.report(
            collector,
            AXIS_BEYOND_LIMIT,
            (key,),
            axis=values.text("kopf.log_achs_name") or values.integer("kopf.achs_nr"),
            limit=(high if high < 0 else low) / POSITION_UNITS,
            tolerance=tolerance / POSITION_UNITS,
        )
    return low / POSITION_UNITS, high / POSITION_UNITS


def _tolerance(values: Values, low: int, high: int, collector: Collector) -> int:
    """Return the tolerance of the software limits, as large as 32 bits allow."""
    tolerance = values.integer("kenngr.swe_toleranz")
    maximum = min(MAX_SGN32 - high, low + MAX_SGN32 + 1)
    if tolerance > maximum:
        values.report(
            collector,
            LIMIT_TOLERANCE_TOO_LARGE,
            ("kenngr.swe_toleranz",),
            value=tolerance,
            limit=high if high + tolerance > MAX_SGN32 else low,
            maximum=maximum,
        )
    return min(tolerance, maximum)


def _active_gear(
    values: Values, gears: tuple[AxisDynamics, ...], collector: Collector
) -> AxisDynamics:
    number = values.integer("kenngr.getriebe_stufe")
    for gear in gears:
        if gear.gear_number == number:
            return gear
    used = gears[0].gear_number
    values.report(
        collector, UNKNOWN_GEAR_STEP, ("kenngr.getriebe_stufe",), number=number, used=used
    )
    return gears[0]


def _dynamics(values: Values, step: int, collector: Collector) -> AxisDynamics:
    gear = "getriebe[]"
    limits = f"{gear}.dynamik"
    # The first gear step is number 1 unless its list says otherwise (P-AXIS-00135).
    number = values.integer(f"{gear}.nummer", step) or (1 if step == 0 else 0)
    max_speed = values.integer(f"{limits}.vb_max", step) / SPEED_UNITS
    rapid_speed = values.integer(f"{gear}.vb_eilgang", step) / SPEED_UNITS
    max_acceleration = float(values.integer(f"{limits}.a_max", step))
    modulo_low, modulo_high = _modulo(values, step, collector)
    return AxisDynamics(
        number,
        max_speed,
        min(rapid_speed, max_speed),
        max_acceleration,
        _trapezoid(values, step, "a_stufe_1", "a_stufe_2", "vb_stufe_1_2"),
        _trapezoid(values, step, "a_grenz_stufe_1", "a_grenz_stufe_2", "vb_grenz_stufe_1_2"),
        _jerk(values, step),
        values.integer(f"{limits}.tr_min", step),
        values.integer(f"{gear}.kv", step) / 100,
        modulo_low,
        modulo_high,
        values.integer(f"{gear}.getr_schalt_pos", step) / POSITION_UNITS,
    )


def _modulo(values: Values, step: int, collector: Collector) -> tuple[float, float]:
    low = values.integer("getriebe[].modulou", step)
    high = values.integer("getriebe[].moduloo", step)
    if high <= low:
        values.report(
            collector, MODULO_RANGE_EMPTY, ("getriebe[].moduloo", step), low=low, high=high
        )
        low, high = 0, 360 * POSITION_UNITS
    return low / POSITION_UNITS, high / POSITION_UNITS


def _trapezoid(values: Values, step: int, low: str, high: str, changeover: str) -> TrapezoidSlope:
    prefix = "getriebe[].lslope_profil"
    return TrapezoidSlope(
        float(values.integer(f"{prefix}.{low}", step)),
        float(values.integer(f"{prefix}.{high}", step)),
        values.integer(f"{prefix}.{changeover}", step) / SPEED_UNITS,
    )


def _jerk(values: Values, step: int) -> JerkSlope:
    prefix = "getriebe[].slope_profil"
    return JerkSlope(
        float(values.integer(f"{prefix}.a_beschl", step)),
        float(values.integer(f"{prefix}.a_brems", step)),
        float(values.integer(f"{prefix}.a_grenz", step)),
        (
            values.integer(f"{prefix}.tr_beschl_zu", step),
            values.integer(f"{prefix}.tr_beschl_ab", step),
            values.integer(f"{prefix}.tr_brems_zu", step),
            values.integer(f"{prefix}.tr_brems_ab", step),
        ),
        values.integer(f"{prefix}.tr_grenz", step),
    )
