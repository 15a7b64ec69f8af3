# SPDX-License-Identifier: MIT
"""The values of a channel list -> the parameters of a channel.

In: checked values. Out: ``ChannelParameters``. The axis lists of the channel's axes are found when
all lists have been read (``machine.py``).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.technology_functions import (
    INTERNAL_M_FUNCTIONS,
    SPINDLE_FUNCTION_KEYS,
    TechnologyFunction,
    process_time_us,
    split,
    technology_functions,
)
from nctakt.lists.format.controller_numbers import bound_number
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.couplings import ListedCouplings, listed_couplings
from nctakt.lists.machine.dynamic_weights import DynamicWeights, dynamic_weights
from nctakt.lists.machine.measuring import ChannelMeasuring, channel_measuring
from nctakt.lists.machine.tool_selection import ToolSelection, tool_selection
from nctakt.lists.machine.transformations.kinematic_lists import transformations
from nctakt.lists.machine.transformations.kinematics import Transformations
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    PARAMETER_OUT_OF_RANGE,
    PATH_GIVEN_TWICE,
    UNKNOWN_PARAMETER_VALUE,
)
from nctakt.messages.machines.machine import (
    CYCLE_DURATION_ABOVE_TICK,
    DESCRIBED_COUNT_MISMATCH,
    INVALID_AXIS_NAME,
    SLOPE_NOT_SIMULATED,
    UNKNOWN_MAIN_SPINDLE,
)


@dataclass(frozen=True, slots=True)
class GearRanges:
    """The ranges of speeds in 1/min by gear step from 1 on, in the order of their search.

    ``is_automatic``: the speed chooses the step (P-CHAN-00004).
    """

    is_automatic: bool
    ranges: Mapping[int, tuple[float, float]]


@dataclass(frozen=True, slots=True)
class ListedGears:
    """``is_enabled``: P-CHAN-00052. ``ranges`` by the logical number of a spindle."""

    is_enabled: bool
    ranges: Mapping[int, GearRanges]


def listed_gears(values: Values) -> ListedGears:
    """Return the settings of a channel list for the gear steps of its spindles."""
    return ListedGears(
        values.flag("main_spindle_gear_change"),
        {
            values.integer("spindel[].log_achs_nr", index): _ranges(values, index)
            for index in values.indices("spindel[]")
        },
    )


def _ranges(values: Values, index: int) -> GearRanges:
    table = "spindel[].range_table[]"
    stages = list(values.indices(table, index))
    if values.integer("spindel[].range_way", index) == 1:
        stages.reverse()
    ranges = {
        stage + 1: (
            float(values.integer(f"{table}.min_speed", index, stage)),
            float(values.integer(f"{table}.max_speed", index, stage)),
        )
        for stage in stages
    }
    used = {stage: limits for stage, limits in ranges.items() if limits[1] > 0.0}
    return GearRanges(values.flag("spindel[].autom_range", index), used)


@dataclass(frozen=True, slots=True)
class ListedFeedGroup:
    """The group that F refers to without ``#FGROUP``: names of axes, none: the linear ones.

    ``is_weakest``: the weakest axis of each block.
    """

    axes: frozenset[str]
    is_weakest: bool


def listed_feed_group(values: Values) -> ListedFeedGroup:
    """Return the settings of a channel list for the axes of the feed."""
    return ListedFeedGroup(
        frozenset(
            values.text("gruppe[].achse[].bezeichnung", 0, index)
            for index in values.indices("gruppe[].achse[]", 0)
            if values.flag("gruppe[].achse[].default_feed_axis", 0, index)
        ),
        values.flag("feed_to_weakest_axis"),
    )


#: Before which blocks single block stops (P-CHAN-00015).
ONLY_MOTIONS, EFFECTIVE_BLOCKS, ALL_LINES = -1, 0, 1

MAIN_PROGRAM_BIT, SUBPROGRAM_BIT = 1, 2
MM_PER_MINUTE_FACTOR = 100.0
#: Groups of G functions with a start value in the channel list (P-CHAN-00063).
MOTION_GROUP, PLANE_GROUP, UNIT_GROUP, DIMENSION_GROUP, CENTRE_GROUP = 0, 4, 12, 14, 23
#: The permitted start values of the groups that nctakt knows.
G_GROUPS: dict[int, tuple[int, ...]] = {
    MOTION_GROUP: (0, 1, 2, 3, 4),
    PLANE_GROUP: (17, 18, 19),
    UNIT_GROUP: (70, 71),
    DIMENSION_GROUP: (90, 91),
    CENTRE_GROUP: (161, 162),
}
#: The defaults of the controller at program start.
BUILT_IN_G_FUNCTIONS: dict[int, int] = {
    MOTION_GROUP: 0,
    PLANE_GROUP: 17,
    UNIT_GROUP: 71,
    DIMENSION_GROUP: 90,
    CENTRE_GROUP: 162,
}
#: G functions that each have a parameter for their program; the first of those that share one.
CYCLE_FUNCTIONS = range(80, 90)
FIRST_NUMBERED_CYCLE = 800
#: The limits of the path, by their keywords in ``#VECTOR LIMIT``.
PATH_LIMITS = {
    "VEL": "vector.velocity",
    "ACC": "vector.acceleration",
    "DEC": "vector.deceleration",
    "RADIAL_ACC": "vector.radial_acceleration",
}
#: The slopes of P-CHAN-00071 that are not simulated.
OTHER_SLOPES = {2: "SIN2", 3: "HSC"}


@dataclass(frozen=True, slots=True)
class NamedAxis:
    """An axis of the channel as named in its list."""

    name: str
    logical_number: int


@dataclass(frozen=True, slots=True)
class Spindle:
    """A spindle of the channel.

    ``name`` addresses it in programs: the main spindle has the main spindle's name, whatever
    ``list_name`` (P-CHAN-00007) says. ``plc_controlled``: the PLC turns it. ``functions``: its
    ``s``, ``m3``, ``m4``, ``m5``, ``m19``.
    """

    name: str
    list_name: str
    logical_number: int
    is_main: bool
    plc_controlled: bool
    functions: Mapping[str, TechnologyFunction]


@dataclass(frozen=True, slots=True)
class ProgramPath:
    """A folder with NC programs; ``type`` is a set of bits (P-CHAN-00403)."""

    folder: str
    type: int
    priority: int

    @property
    def has_main_programs(self) -> bool:
        """Whether main programs are searched in the folder."""
        return bool(self.type & MAIN_PROGRAM_BIT)

    @property
    def has_subprograms(self) -> bool:
        """Whether subprograms are searched in the folder."""
        return bool(self.type & SUBPROGRAM_BIT)


@dataclass(frozen=True, slots=True)
class ProgramStart:
    """The state at program start.

    ``feed_mm_min`` 0: the first feed block needs an F. ``feed_unit_mm_min``: mm/min that F1 means
    (P-CHAN-00108). ``g_functions``: group -> G number, the built-in ones included.
    ``slope_profile``: 0 trapezoid, 1 jerk-limited; 2 sine square and 3 HSC count as 1.
    """

    feed_mm_min: float
    feed_unit_mm_min: float
    g_functions: Mapping[int, int]
    slope_profile: int


@dataclass(frozen=True, slots=True)
class RealtimeCycleLimits:
    """The limits of realtime cycles: P-CHAN-00406, 00407, 00480, 00425, 00426, 00427."""

    enable: bool
    memory_bytes: int
    buffers: int
    max_duration_pct: int
    cont_steps: int
    max_steps: int


@dataclass(frozen=True, slots=True)
class ImplicitPrograms:
    """Subprograms that run without a call; empty: none. ``g``: G function -> program."""

    program_start: str
    program_end: str
    m6: str
    g: Mapping[int, str]

    @property
    def names(self) -> tuple[str, ...]:
        """All these programs, each once."""
        all_names = (self.program_start, self.program_end, self.m6, *self.g.values())
        return tuple(dict.fromkeys(name for name in all_names if name))


@dataclass(frozen=True, slots=True)
class CentreTolerance:
    """Tolerances of the centre of an arc: P-CHAN-00059 and P-CHAN-00060; both apply."""

    distance_mm: float
    share_of_radius: float

    def allowed_mm(self, radius_mm: float) -> float:
        """Return the maximum shift of the centre of an arc, mm."""
        return min(self.distance_mm, self.share_of_radius * radius_mm)


#: The parts of a coordinate system, as entries name them: along and about the main axes.
_SYSTEM_COMPONENTS = (
    "translation.t1", "translation.t2", "translation.t3",
    "rotation.a1", "rotation.a2", "rotation.a3",
)  # fmt: skip
#: The second axis of an effector's coordinate system: its plane's name -> the main axes in it.
_EFFECTOR_PLANES = {"XY": (0, 1), "ZX": (2, 0), "YZ": (1, 2)}


@dataclass(frozen=True, slots=True)
class ListedSystems:
    """Six components (mm, degrees) by name in upper case, P-CHAN-00490 … 496.

    ``is_rotation_fixed``: P-CHAN-00393. ``has_own_offsets``: P-CHAN-00397. ``effector_plane``: the
    axes of P-CHAN-00050; ``has_first_effector_axis``: X of ``#ECS`` lies in it, not Y.
    """

    systems: Mapping[str, tuple[float, ...]]
    is_rotation_fixed: bool
    has_own_offsets: bool
    effector_plane: tuple[int, int]
    has_first_effector_axis: bool


def _listed_systems(values: Values) -> ListedSystems:
    """Return the coordinate systems of a channel list; those without a name do not count.

    Of two paths in a channel the first counts.
    """
    systems = {}
    for index in values.indices("coordinate_system.def[]"):
        name = values.text("coordinate_system.def[].id", index).upper()
        keys = [f"coordinate_system.def[].path[].{component}" for component in _SYSTEM_COMPONENTS]
        components = tuple(values.real(key, index, 0) for key in keys)
        if name:
            systems[name] = components
    return ListedSystems(
        systems,
        values.flag("coordinate_system.rotation_mode_fixed"),
        values.flag("coordinate_system.axes_offsets_layer_specific"),
        _EFFECTOR_PLANES[values.text("mach_plane_of_2nd_ecs_ax").upper()],
        values.text("kind_of_2nd_ecs_ax").upper() == "X",
    )


@dataclass(frozen=True, slots=True)
class ChannelParameters:
    """The parameters of a channel list.

    ``m_functions`` and ``h_functions``: number -> function, only those that are defined.
    ``path_limits``: those of ``#VECTOR LIMIT ON`` without a value, by keyword: mm/min, and mm/s²
    with ``path_limits_per_s``, else mm/min². ``context_*``: P-CHAN-00409 … 00411. ``c_axis_name``:
    P-CHAN-00010, of the axis of #CAX. ``single_block``: P-CHAN-00015. ``awaits_idle_axes``:
    P-CHAN-00451, whether a block also waits for an independent axis that it need not move.
    ``lead_blocks``: P-CHAN-00274, for functions that go out early.
    """

    axes: tuple[NamedAxis, ...]
    spindles: tuple[Spindle, ...]
    m_functions: Mapping[int, TechnologyFunction]
    h_functions: Mapping[int, TechnologyFunction]
    program_paths: tuple[ProgramPath, ...]
    implicit_programs: ImplicitPrograms
    program_start: ProgramStart
    exact_stop_after_g00: bool
    allows_corners: bool
    hsc_deviation_mm: float
    hsc_angle_deg: float
    max_override_pct: float
    realtime_cycles: RealtimeCycleLimits
    channel_variables_bytes: int
    residual_path_mm: float
    edge_across_blocks: bool
    looks_for_damage: bool
    centre_tolerance: CentreTolerance
    tool_selection: ToolSelection
    path_limits: Mapping[str, float]
    path_limits_per_s: bool
    context_geo: int
    context_sda: int
    context_com: int
    transformations: Transformations
    measuring: ChannelMeasuring
    keeps_listed_limits: bool
    awaits_idle_axes: bool
    c_axis_name: str
    feed_group: ListedFeedGroup
    dynamic_weights: DynamicWeights
    coordinate_systems: ListedSystems
    gears: ListedGears
    couplings: ListedCouplings
    single_block: int
    lead_blocks: int

    @property
    def blocks_ahead(self) -> int:
        """Number of blocks that must be queued for functions output early, 0: none."""
        functions = (*self.m_functions.values(), *self.h_functions.values())
        return self.lead_blocks if any(function.lead for function in functions) else 0

    @property
    def spindle_names(self) -> tuple[str, ...]:
        """The names of spindles in programs; that of the list is also one of the main spindle."""
        names = [spindle.name for spindle in self.spindles]
        listed = [spindle.list_name for spindle in self.spindles if spindle.list_name]
        return tuple(dict.fromkeys([*names, *listed]))

    def function(self, letter: str, number: int) -> TechnologyFunction:
        """Return a defined function; T is the same function for all tools."""
        if letter == "T":
            assert self.tool_selection.output is not None
            return self.tool_selection.output
        return (self.m_functions if letter == "M" else self.h_functions)[number]


def channel_parameters(values: Values, collector: Collector) -> ChannelParameters:
    """Return the values of a channel list (over those of the defaults list)."""
    axes, spindles = _axes(values, collector), _spindles(values, collector)
    names = {*(axis.name for axis in axes), *(spindle.name for spindle in spindles)}
    return ChannelParameters(
        axes,
        spindles,
        technology_functions(values, "m", names, collector, INTERNAL_M_FUNCTIONS),
        technology_functions(values, "h", names, collector),
        _program_paths(values, collector),
        _implicit_programs(values),
        _program_start(values, collector),
        values.flag("exact_stop_after_g00"),
        not values.flag("disable_chamfers_roundings"),
        values.real("hsc.bspline.path_deviation") / 10_000,
        values.real("hsc.bspline.max_angle") / 10_000,
        values.integer("max_vb_override") / 10,
        _realtime_cycles(values, collector),
        values.integer("configuration.decoder.v_ch_memory"),
        values.integer("kasto_residual_path") / 10_000,
        values.flag("kasto_multi_block"),
        values.flag("implicit_contour_masking"),
        CentreTolerance(
            values.real("mittelpkt_diff") / 10_000, values.integer("mittelpkt_faktor") / 1000
        ),
        tool_selection(values, collector),
        {name: values.real(key) for name, key in PATH_LIMITS.items()},
        values.text("vector.acc_dec_unit") == "MM_S2",
        values.integer("schedule.context.geo"),
        values.integer("schedule.context.sda"),
        values.integer("schedule.context.com"),
        transformations(values, len(axes), collector),
        channel_measuring(values),
        values.flag("range_check_prog_soft_limits"),
        values.integer("mode_implicite_sync_indp_asyn_axis") == 1,
        values.text("default_ax_name_of_spindle"),
        listed_feed_group(values),
        dynamic_weights(values, collector),
        _listed_systems(values),
        listed_gears(values),
        listed_couplings(values, collector),
        values.integer("einzelschrittmodus"),
        values.integer("m_h_pre_outp_nbr_block"),
    )


def _realtime_cycles(values: Values, collector: Collector) -> RealtimeCycleLimits:
    max_duration_pct = values.integer("rt_cycles.max_duration")
    if max_duration_pct > 100:
        values.report(
            collector,
            CYCLE_DURATION_ABOVE_TICK,
            ("rt_cycles.max_duration",),
            value=max_duration_pct,
        )
    return RealtimeCycleLimits(
        values.flag("configuration.rt_cycles.enable"),
        values.integer("configuration.rt_cycles.memory"),
        values.integer("configuration.rt_cycles.buffers"),
        max_duration_pct,
        values.integer("rt_cycles.cont_steps"),
        values.integer("rt_cycles.max_steps"),
    )


def _counted(
    values: Values, count_key: tuple[str, *tuple[int, ...]], entries: int, collector: Collector
) -> int:
    """Return the number of elements: the list's own number if it has one, else all named ones."""
    if not values.is_set(*count_key):
        return entries
    count = values.integer(*count_key)
    if count != entries:
        name = with_indices(count_key[0], tuple(count_key[1:]))
        values.report(
            collector, DESCRIBED_COUNT_MISMATCH, count_key, key=name, count=count, found=entries
        )
    return min(count, entries)


def _axes(values: Values, collector: Collector) -> tuple[NamedAxis, ...]:
    indices = values.indices("gruppe[].achse[]", 0)
    count = _counted(values, ("gruppe[].achs_anzahl", 0), len(indices), collector)
    axes: list[NamedAxis] = []
    for index in indices[:count]:
        name = values.text("gruppe[].achse[].bezeichnung", 0, index)
        key = ("gruppe[].achse[].bezeichnung", 0, index)
        if not _is_usable(name, "ABCQUVWXYZ") or any(axis.name == name for axis in axes):
            values.report(
                collector,
                INVALID_AXIS_NAME,
                key,
                key=with_indices(key[0], (0, index)),
                value=name or "–",
            )
            continue
        axes.append(NamedAxis(name, values.integer("gruppe[].achse[].log_achs_nr", 0, index)))
    return tuple(axes)


def _is_usable(name: str, first: str) -> bool:
    """Return whether a name is a letter of axes, then letters, digits and underscores."""
    return bool(name) and name[0] in first and name.isascii() and name.replace("_", "a").isalnum()


def _spindles(values: Values, collector: Collector) -> tuple[Spindle, ...]:
    main_number = values.integer("main_spindle_ax_nr")
    main_name = values.text("main_spindle_name")
    indices = values.indices("spindel[]")
    count = _counted(values, ("spdl_anzahl",), len(indices), collector)
    spindles: list[Spindle] = []
    for index in indices[:count]:
        number = values.integer("spindel[].log_achs_nr", index)
        list_name = values.text("spindel[].bezeichnung", index)
        is_main = number == main_number != 0
        name = main_name if is_main else list_name
        if not _is_usable(name, "S") or any(spindle.name == name for spindle in spindles):
            key = ("spindel[].bezeichnung", index)
            path = with_indices(key[0], (index,))
            values.report(collector, INVALID_AXIS_NAME, key, key=path, value=name or "–")
            continue
        plc_controlled = values.flag("spindel[].plc_control", index)
        functions = {
            key: _spindle_function(values, key, index, collector) for key in SPINDLE_FUNCTION_KEYS
        }
        spindles.append(Spindle(name, list_name, number, is_main, plc_controlled, functions))
    if main_number and not any(spindle.is_main for spindle in spindles):
        values.report(collector, UNKNOWN_MAIN_SPINDLE, ("main_spindle_ax_nr",), logical=main_number)
    return tuple(spindles)


def _spindle_function(
    values: Values, key: str, index: int, collector: Collector
) -> TechnologyFunction:
    synchronisation, modifiers = split(values.names(f"spindel[].{key}_synch", index), "NO_SYNCH")
    number = int(key[1:]) if len(key) > 1 else 0
    at = (f"spindel[].{key}_prozess_zeit", index)
    time_us = process_time_us(values, at, synchronisation, collector)
    return TechnologyFunction(number, synchronisation, modifiers, time_us, "")


def _program_paths(values: Values, collector: Collector) -> tuple[ProgramPath, ...]:
    """Return the folders with programs in the order of the search: by priority, then as listed.

    Reported: one number of two folders (20771), one priority of two of a type (20707).
    """
    _check_paths(values, collector)
    paths = [
        ProgramPath(
            values.text("path[].dir", index),
            values.integer("path[].type", index),
            values.integer("path[].priority", index),
        )
        for index in values.indices("path[]")
        if values.text("path[].dir", index)
    ]
    return tuple(sorted(paths, key=lambda path: path.priority))


def _check_paths(values: Values, collector: Collector) -> None:
    before: list[int] = []
    for index in values.indices("path[]"):
        for name in ("id", "priority"):
            key = (f"path[].{name}", index)
            own = values.given(*key)
            for other in before:
                first = values.given(key[0], other)
                if own is None or first is None or own.value != first.value:
                    continue
                types = values.integer("path[].type", index), values.integer("path[].type", other)
                if name == "id" or types[0] & types[1]:
                    values.report(
                        collector,
                        PATH_GIVEN_TWICE,
                        key,
                        key=with_indices(key[0], (index,)),
                        value=str(own.value),
                        other=f"path[{other}]",
                    )
                    break
        before.append(index)


def _implicit_programs(values: Values) -> ImplicitPrograms:
    return ImplicitPrograms(
        values.text("start_init_prog_file"),
        values.text("final_prog_file"),
        values.text("m6_prog_file"),
        {number: name for number, name in _programs_of_g_functions(values) if name},
    )


def _programs_of_g_functions(values: Values) -> Iterator[tuple[int, str]]:
    """Yield G80 … G89 (P-CHAN-00160 … 00169), then G800 and the following (P-CHAN-00187)."""
    for number in CYCLE_FUNCTIONS:
        yield number, values.text(program_parameter(number))
    for index in values.indices("g800_prog_file[]"):
        yield FIRST_NUMBERED_CYCLE + index, values.text("g800_prog_file[]", index)


def program_parameter(number: int) -> str:
    """Return the name of the parameter with the program of a G function."""
    if number in CYCLE_FUNCTIONS:
        return f"g{number}_prog_file"
    return f"g800_prog_file[{number - FIRST_NUMBERED_CYCLE}]"


def _program_start(values: Values, collector: Collector) -> ProgramStart:
    factor = values.real("prog_start.feedrate_factor")
    if factor <= 0:
        # -1 means "not configured" and is not a defect.
        if factor != -1:
            values.report(
                collector,
                PARAMETER_OUT_OF_RANGE,
                ("prog_start.feedrate_factor",),
                bound_number("P-CHAN-00108", factor, is_above=False),
                key="prog_start.feedrate_factor",
                value=factor,
                range=f"0.1 … {MM_PER_MINUTE_FACTOR}",
                default=MM_PER_MINUTE_FACTOR,
            )
        factor = MM_PER_MINUTE_FACTOR
    profile = values.integer("prog_start.slope.profile")
    if profile in OTHER_SLOPES:
        key = ("prog_start.slope.profile",)
        values.report(
            collector, SLOPE_NOT_SIMULATED, key, value=profile, name=OTHER_SLOPES[profile]
        )
    return ProgramStart(
        values.real("prog_start.feedrate"),
        MM_PER_MINUTE_FACTOR / factor,
        _g_functions(values, collector),
        profile,
    )


def _g_functions(values: Values, collector: Collector) -> dict[int, int]:
    functions = dict(BUILT_IN_G_FUNCTIONS)
    for group in values.indices("prog_start.g_gruppe[]"):
        number = values.integer("prog_start.g_gruppe[].nr", group)
        if number == -1:
            continue
        allowed = G_GROUPS.get(group)
        if allowed is not None and number not in allowed:
            key = ("prog_start.g_gruppe[].nr", group)
            values.report(
                collector,
                UNKNOWN_PARAMETER_VALUE,
                key,
                key=with_indices(key[0], (group,)),
                value=number,
                names=", ".join(str(number) for number in allowed),
                default=-1,
            )
            continue
        functions[group] = number
    return functions
