# Written by a build from the C types of the realtime part.
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.axis_motions cimport AxisMotions
from nctakt.kernel.axes.c_axis cimport CAxis
from nctakt.kernel.axes.coordinates cimport Offsets
from nctakt.kernel.axes.coordinates cimport Turns
from nctakt.kernel.axes.couplings cimport Couplings
from nctakt.kernel.axes.cutting_speeds cimport CuttingSpeeds
from nctakt.kernel.axes.spindle_limits cimport SpindleLimits
from nctakt.kernel.axes.spindle_overrides cimport SpindleOverrides
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.axes.trajectory cimport Trajectories
from nctakt.kernel.axes.transformations cimport Transformations
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.base.timers cimport Timers
from nctakt.kernel.cycles.actions cimport FeedMemory
from nctakt.kernel.cycles.branches cimport Reaction
from nctakt.kernel.cycles.branches cimport IfOnce
from nctakt.kernel.cycles.branches cimport IfEdge
from nctakt.kernel.cycles.branches cimport IfAlways
from nctakt.kernel.cycles.conditions cimport Condition
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.cycles cimport RealtimeCycle
from nctakt.kernel.cycles.cycles cimport CycleManager
from nctakt.kernel.cycles.instructions cimport Counted
from nctakt.kernel.kernel cimport ChannelLane
from nctakt.kernel.kernel cimport Kernel
from nctakt.kernel.kinematics.maps cimport KinematicMaps
from nctakt.kernel.kinematics.orientation cimport Orientation
from nctakt.kernel.path.arc_limits cimport ArcLimits
from nctakt.kernel.path.arc_speed cimport ArcSpeed
from nctakt.kernel.path.backward cimport BackwardMotion
from nctakt.kernel.path.corner cimport Corner
from nctakt.kernel.path.corner_rounding cimport CornerRounding
from nctakt.kernel.path.edge_probe cimport EdgeProbe
from nctakt.kernel.path.fixed_stops cimport FixedStops
from nctakt.kernel.path.goal cimport Goal
from nctakt.kernel.path.history cimport History
from nctakt.kernel.path.jerk_lookahead cimport JerkLookAhead
from nctakt.kernel.path.jerk_profile cimport JerkProfile
from nctakt.kernel.path.lookahead cimport LookAhead
from nctakt.kernel.path.override cimport Overrides
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.path.path_axes cimport PathAxes
from nctakt.kernel.path.segment_limits cimport SegmentLimits
from nctakt.kernel.path.threads cimport Threads
from nctakt.kernel.path.tool_life cimport ToolLife
from nctakt.kernel.path.touch_probe cimport TouchProbe
from nctakt.kernel.path.transformed_limits cimport TransformedLimits
from nctakt.kernel.path.trapezoid_profile cimport TrapezoidProfile
from nctakt.kernel.plc.axis_requests cimport AxisRequests
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.plc.technology_slots cimport Section
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.tick.axis_exchange cimport AxisExchange
from nctakt.kernel.tick.block_scope cimport BlockScope
from nctakt.kernel.tick.channel cimport Channel
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.command_execution cimport CommandExecutor
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.kernel.tick.loop_body cimport LoopBody
from nctakt.kernel.tick.signals cimport SignalBoard
from nctakt.kernel.tick.single_block cimport SingleBlock
from nctakt.kernel.tick.tool_lives cimport ToolLives
def copy_Axes(Axes source, Axes target):
    pass
    target.first_cell = source.first_cell
    target.count = source.count
    target.has_lag = source.has_lag
    target.is_late = source.is_late
    target.has_stops = source.has_stops
    target.has_moved = source.has_moved
    target.is_shifted = source.is_shifted
def arrays_of_Axes(Axes part):
    return (part.cells, part.command, part.lag_d, part.lag_kept, part.lag_alone, part.lag_gained, part.followed, part.drive_d, part.unsent, part.target, part.modulo_low, part.modulo_range, part.on_path, part.independent, part.override_mode, part.override_pct, part.max_override_pct, part.independent_pct, part.stop_low, part.stop_high, part.actual, part.shown_command, part.shown_actual, part.shown_target, )
def copy_AxisMotions(AxisMotions source, AxisMotions target):
    pass
    target.count = source.count
    target.cycle_time_us = source.cycle_time_us
    target.forgiven_t = source.forgiven_t
    target.active_count = source.active_count
    target.fault_count = source.fault_count
    target.reported_count = source.reported_count
    target.requested_axis = source.requested_axis
    target.has_exchanged = source.has_exchanged
    target.source = source.source
    target.serial = source.serial
    target.failed_count = source.failed_count
    target.ring_size = source.ring_size
def arrays_of_AxisMotions(AxisMotions part):
    return (part.enabled, part.low, part.high, part.listed_low, part.listed_high, part.is_homing, part.limit_v, part.limit_a, part.limit_j, part.kind, part.held, part.owner, part.serials, part.sources, part.goal, part.end, part.commanded_v, part.direction, part.next_kind, part.next_owner, part.next_serial, part.next_source, part.next_value, part.next_v, part.next_direction, part.next_held, part.speed, part.acceleration, part.last_direction, part.planned_v, part.start_d, part.ticks, part.fault, part.failed, part.arrived, part.in_channel, part.closed, )
def copy_CAxis(CAxis source, CAxis target):
    pass
    target.axis = source.axis
    target.spindle = source.spindle
    target.last = source.last
    target.is_active = source.is_active
def arrays_of_CAxis(CAxis part):
    return ()
def copy_Offsets(Offsets source, Offsets target):
    pass
    target.count = source.count
def arrays_of_Offsets(Offsets part):
    return (part.values, part.program, part.origin, )
def copy_Turns(Turns source, Turns target):
    pass
    target.active = source.active
def arrays_of_Turns(Turns part):
    return (part.second, part.third, part.matrix, )
def copy_Couplings(Couplings source, Couplings target):
    pass
    target.axis_count = source.axis_count
    target.count = source.count
    target.fixed_count = source.fixed_count
    target.watched_count = source.watched_count
def arrays_of_Couplings(Couplings part):
    return (part.slave, part.master, part.factor, part.slave_begin, part.master_begin, part.allowed_d, part.closed, )
def copy_CuttingSpeeds(CuttingSpeeds source, CuttingSpeeds target):
    pass
    target.active_count = source.active_count
    target.rapid_cell = source.rapid_cell
def arrays_of_CuttingSpeeds(CuttingSpeeds part):
    return (part.surface_v, part.face_axis, part.centre_d, part.limit_v, )
def copy_SpindleLimits(SpindleLimits source, SpindleLimits target):
    pass
    target.count = source.count
def arrays_of_SpindleLimits(SpindleLimits part):
    return (part.speed_v, part.acceleration_a, part.jerk_j, part.low_v, part.step, part.own_v, part.own_a, part.tool_low_v, part.tool_v, part.tool_a, part.bound_v, part.bound_a, part.bound_j, )
def copy_SpindleOverrides(SpindleOverrides source, SpindleOverrides target):
    pass
    target.first_cell = source.first_cell
def arrays_of_SpindleOverrides(SpindleOverrides part):
    return (part.cells, part.programmed_v, part.acted_pct, part.highest_pct, part.is_ignored, )
def copy_Spindles(Spindles source, Spindles target):
    pass
    target.first_cell = source.first_cell
    target.count = source.count
    target.first_number = source.first_number
    target.cycle_t = source.cycle_t
    target.issued = source.issued
    target.version = source.version
    target.active_count = source.active_count
def arrays_of_Spindles(Spindles part):
    return (part.cells, part.is_plc, part.position, part.speed_v, part.acceleration, part.mode, part.begin_position, part.begin_tick, part.commanded_v, part.commanded_position, part.direction, part.function, part.is_open, part.is_held, part.owner, part.source, part.serial, part.taken_tick, part.plc_state, part.done_tick, part.job, part.reached_v, part.laps, )
def copy_Trajectories(Trajectories source, Trajectories target):
    pass
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.acceleration_a = source.acceleration_a
    target.top_v = source.top_v
    target.limit_a = source.limit_a
    target.limit_j = source.limit_j
    target.from_v = source.from_v
    target.from_a = source.from_a
    target.middle_v = source.middle_v
    target.middle_a = source.middle_a
    target.slowest_v = source.slowest_v
    target.slowest_peak2 = source.slowest_peak2
    target.first_peak2 = source.first_peak2
    target.sign = source.sign
    target.cruise_t = source.cruise_t
    target.first_t = source.first_t
    target.hold_t = source.hold_t
    target.last_t = source.last_t
    target.peak_a = source.peak_a
    target.first_j = source.first_j
    target.row = source.row
    target.count = source.count
    target.end_t = source.end_t
    target.end_d = source.end_d
    target.end_v = source.end_v
    target.goal_v = source.goal_v
    target.side = source.side
def arrays_of_Trajectories(Trajectories part):
    return (part.rows, )
def copy_Transformations(Transformations source, Transformations target):
    pass
    target.active_count = source.active_count
    target.named = source.named
    target.joint_count = source.joint_count
    target.target_number = source.target_number
def arrays_of_Transformations(Transformations part):
    return (part.active, part.gathered, part.mapped, part.near, part.tips, part.joint_axes, part.joint_members, part.joint_mapped, part.mapped_targets, )
def copy_Record(Record source, Record target):
    pass
    target.signals = source.signals
    target.rows = source.rows
    target.events = source.events
    target.probes = source.probes
    target.signal_count = source.signal_count
    target.row_capacity = source.row_capacity
    target.row_count = source.row_count
    target.event_capacity = source.event_capacity
    target.event_count = source.event_count
    target.probe_capacity = source.probe_capacity
    target.probe_count = source.probe_count
    target.tick = source.tick
    target.channel = source.channel
    target.records_writes = source.records_writes
    target.records_series = source.records_series
    target.records_answers = source.records_answers
def arrays_of_Record(Record part):
    return (part.cells, part.signals, )
def copy_Timers(Timers source, Timers target):
    pass
    target.first_cell = source.first_cell
    target.cycle_time_us = source.cycle_time_us
def arrays_of_Timers(Timers part):
    return (part.cells, part.is_running, part.started_tick, part.elapsed_ticks, )
def copy_FeedMemory(FeedMemory source, FeedMemory target):
    pass
    target.speed_v = source.speed_v
def arrays_of_FeedMemory(FeedMemory part):
    return ()
def copy_Reaction(Reaction source, Reaction target):
    pass
    target.count = source.count
    target.first_tick = source.first_tick
    target.next_tick = source.next_tick
    target.last_run = source.last_run
def arrays_of_Reaction(Reaction part):
    return ()
def copy_IfOnce(IfOnce source, IfOnce target):
    pass
    target.is_done = source.is_done
def arrays_of_IfOnce(IfOnce part):
    return ()
def copy_IfEdge(IfEdge source, IfEdge target):
    pass
    target.was_true = source.was_true
def arrays_of_IfEdge(IfEdge part):
    return ()
def copy_IfAlways(IfAlways source, IfAlways target):
    pass
    target.is_latched = source.is_latched
def arrays_of_IfAlways(IfAlways part):
    return ()
def copy_Condition(Condition source, Condition target):
    pass
    target.probe = source.probe
    target.truth = source.truth
    target.next_tick = source.next_tick
    target.was_ever_true = source.was_ever_true
    target.nearest = source.nearest
    target.nearest_left = source.nearest_left
    target.nearest_right = source.nearest_right
    target.nearest_tick = source.nearest_tick
def arrays_of_Condition(Condition part):
    return ()
def copy_Context(Context source, Context target):
    pass
    target.max_open_actions = source.max_open_actions
    target.tick = source.tick
    target.serial = source.serial
    target.run = source.run
    target.owner = source.owner
    target.fault = source.fault
    target.user_reaction = source.user_reaction
    target.fault_source = source.fault_source
    target.fault_a = source.fault_a
    target.fault_b = source.fault_b
    target.steps = source.steps
    target.check_at = source.check_at
    target.max_steps = source.max_steps
    target.cont_steps = source.cont_steps
    target.budget_steps = source.budget_steps
def arrays_of_Context(Context part):
    return (part.cells, )
def copy_RealtimeCycle(RealtimeCycle source, RealtimeCycle target):
    pass
    target.slot = source.slot
    target.next_tick = source.next_tick
    target.runs = source.runs
    target.serial = source.serial
    target.probe = source.probe
    target.events = source.events
    target.probes = source.probes
    target.size = source.size
def arrays_of_RealtimeCycle(RealtimeCycle part):
    return ()
def copy_CycleManager(CycleManager source, CycleManager target):
    pass
    target.first_owner = source.first_owner
    target.capacity = source.capacity
    target.memory_limit = source.memory_limit
    target.memory_used = source.memory_used
    target.loaded = list(source.loaded)
    target.loaded_count = source.loaded_count
    target.root = source.root
    target.latest_start = source.latest_start
    target.running_count = source.running_count
    target.armed_count = source.armed_count
    target.in_block_count = source.in_block_count
    target.ended_count = source.ended_count
    target.events_bound = source.events_bound
    target.probes_bound = source.probes_bound
def arrays_of_CycleManager(CycleManager part):
    return (part.state, part.identity, part.scope, part.source, part.serial, part.reusable, part.restarts, part.started_tick, part.block, part.size, part.moves_on, part.order, )
def copy_Counted(Counted source, Counted target):
    pass
    target.source = source.source
    target.cost = source.cost
def arrays_of_Counted(Counted part):
    return ()
def copy_ChannelLane(ChannelLane source, ChannelLane target):
    pass
    target.number = source.number
def arrays_of_ChannelLane(ChannelLane part):
    return ()
def copy_Kernel(Kernel source, Kernel target):
    pass
    target.ends_deadlock = source.ends_deadlock
    target.is_stopped = source.is_stopped
    target.tick = source.tick
    target.input_count = source.input_count
    target.input_capacity = source.input_capacity
    target.input_cells = source.input_cells
    target.input_words = source.input_words
def arrays_of_Kernel(Kernel part):
    return (part.words, part.input_cells, part.input_words, )
def copy_KinematicMaps(KinematicMaps source, KinematicMaps target):
    pass
    target.axis_count = source.axis_count
    target.capacity = source.capacity
    target.used = source.used
    target.values = source.values
    target.x = source.x
    target.y = source.y
    target.z = source.z
def arrays_of_KinematicMaps(KinematicMaps part):
    return (part.values, part.columns, part.linear, part.between, part.near_between, )
def copy_Orientation(Orientation source, Orientation target):
    pass
    target.first = source.first
    target.second = source.second
    target.other_first = source.other_first
    target.other_second = source.other_second
    target.x = source.x
    target.y = source.y
    target.z = source.z
def arrays_of_Orientation(Orientation part):
    return ()
def copy_ArcLimits(ArcLimits source, ArcLimits target):
    pass
    target.count = source.count
    target.room = source.room
    target.max_v = source.max_v
    target.max_a = source.max_a
    target.pieces = source.pieces
    target.first_a = source.first_a
    target.second_a = source.second_a
    target.outer_a = source.outer_a
    target.outer_v = source.outer_v
def arrays_of_ArcLimits(ArcLimits part):
    return (part.max_v, part.max_a, part.first_parts, part.second_parts, part.first_curvatures, part.second_curvatures, part.caps, part.keeps, part.ends, )
def copy_ArcSpeed(ArcSpeed source, ArcSpeed target):
    pass
    target.prepared_v = source.prepared_v
    target.next_feed_v = source.next_feed_v
    target.max_end_v = source.max_end_v
    target.surveyed_v = source.surveyed_v
    target.surveyed_target_v = source.surveyed_target_v
def arrays_of_ArcSpeed(ArcSpeed part):
    return (part.highs, part.lows, )
def copy_BackwardMotion(BackwardMotion source, BackwardMotion target):
    pass
    target.stage = source.stage
    target.stage_d = source.stage_d
    target.plan_d = source.plan_d
    target.offset_t = source.offset_t
    target.ticks = source.ticks
    target.factor = source.factor
    target.is_single = source.is_single
    target.is_blocked = source.is_blocked
    target.was_paused = source.was_paused
    target.was_released = source.was_released
    target.fault = source.fault
    target.has_failed = source.has_failed
    target.fault_source = source.fault_source
    target.entered = source.entered
def arrays_of_BackwardMotion(BackwardMotion part):
    return ()
def copy_Corner(Corner source, Corner target):
    pass
    target.centripetal_share = source.centripetal_share
    target.last_centripetal_share = source.last_centripetal_share
    target.last_length = source.last_length
    target.last_deviation = source.last_deviation
    target.last_part = source.last_part
    target.last_bend = source.last_bend
    target.corner_v = source.corner_v
    target.last_corner_v = source.last_corner_v
    target.is_rounded = source.is_rounded
    target.last_is_rounded = source.last_is_rounded
    target.is_bent = source.is_bent
    target.last_is_bent = source.last_is_bent
def arrays_of_Corner(Corner part):
    return (part.entering, part.leaving, part.entering_curve, part.leaving_curve, part.steps, part.shares, part.turns, part.unused, )
def copy_CornerRounding(CornerRounding source, CornerRounding target):
    pass
    target.width = source.width
def arrays_of_CornerRounding(CornerRounding part):
    return (part.row, part.spare, )
def copy_EdgeProbe(EdgeProbe source, EdgeProbe target):
    pass
    target.cell = source.cell
    target.phase = source.phase
    target.source = source.source
    target.function = source.function
    target.ticks = source.ticks
    target.has_value = source.has_value
    target.value = source.value
    target.residual_d = source.residual_d
    target.joint_d = source.joint_d
def arrays_of_EdgeProbe(EdgeProbe part):
    return (part.cells, )
def copy_FixedStops(FixedStops source, FixedStops target):
    pass
    target.count = source.count
    target.detected_count = source.detected_count
def arrays_of_FixedStops(FixedStops part):
    return (part.active, part.detected, part.needed, part.ticks, part.sources, part.limit_d, part.min_ticks, part.from_part, part.to_part, )
def copy_Goal(Goal source, Goal target):
    pass
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.acceleration_a = source.acceleration_a
    target.jerk_j = source.jerk_j
    target.kind = source.kind
    target.carried_a = source.carried_a
    target.carried_j = source.carried_j
def arrays_of_Goal(Goal part):
    return ()
def copy_History(History source, History target):
    pass
    target.number = source.number
    target.front_number = source.front_number
    target.front_map = source.front_map
    target.max_stretch = source.max_stretch
    target.stretch_end = source.stretch_end
    target.limit_a = source.limit_a
    target.limit_j = source.limit_j
    target.rounding_a = source.rounding_a
    target.rounding_j = source.rounding_j
def arrays_of_History(History part):
    return (part.foreign, part.stretch, part.goal_row, )
def copy_JerkLookAhead(JerkLookAhead source, JerkLookAhead target):
    pass
    target.width = source.width
    target.capacity = source.capacity
    target.blocks = source.blocks
def arrays_of_JerkLookAhead(JerkLookAhead part):
    return ()
def copy_JerkProfile(JerkProfile source, JerkProfile target):
    pass
    target.tick_t = source.tick_t
    target.acceleration_a = source.acceleration_a
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.left_t = source.left_t
    target.rest_d = source.rest_d
    target.ends_in_time = source.ends_in_time
    target.stands_at_end = source.stands_at_end
    target.own_j = source.own_j
def arrays_of_JerkProfile(JerkProfile part):
    return ()
def copy_LookAhead(LookAhead source, LookAhead target):
    pass
    target.blocks = source.blocks
    target.width = source.width
    target.capacity = source.capacity
def arrays_of_LookAhead(LookAhead part):
    return (part.spare, )
def copy_Overrides(Overrides source, Overrides target):
    pass
    target.max_pct = source.max_pct
    target.operator_pct = source.operator_pct
    target.cycle_pct = source.cycle_pct
    target.total_pct = source.total_pct
def arrays_of_Overrides(Overrides part):
    return ()
def copy_Path(Path source, Path target):
    pass
    target.cycle_time_t = source.cycle_time_t
    target.cycle_time_us = source.cycle_time_us
    target.width = source.width
    target.history_size = source.history_size
    target.ring_size = source.ring_size
    target.used = source.used
    target.oldest = source.oldest
    target.front = source.front
    target.is_retracing = source.is_retracing
    target.is_front_over = source.is_front_over
    target.serial = source.serial
    target.is_active = source.is_active
    target.is_dwell = source.is_dwell
    target.dwell_ticks = source.dwell_ticks
    target.pieces = source.pieces
    target.stage = source.stage
    target.stage_end_d = source.stage_end_d
    target.factor = source.factor
    target.common_factor = source.common_factor
    target.unoverridden_factor = source.unoverridden_factor
    target.planned_factor = source.planned_factor
    target.covered_d = source.covered_d
    target.plan_d = source.plan_d
    target.speed_v = source.speed_v
    target.limit_v = source.limit_v
    target.offset_t = source.offset_t
    target.ticks = source.ticks
    target.left_t = source.left_t
    target.is_single = source.is_single
def arrays_of_Path(Path part):
    return (part.ends, part.positions, )
def copy_PathAxes(PathAxes source, PathAxes target):
    pass
    target.count = source.count
    target.room = source.room
    target.moved_count = source.moved_count
    target.refused_axis = source.refused_axis
    target.row = source.row
    target.direction = source.direction
    target.slot = source.slot
def arrays_of_PathAxes(PathAxes part):
    return (part.members, part.moved, part.unmapped, part.near, part.standing, )
def copy_SegmentLimits(SegmentLimits source, SegmentLimits target):
    pass
    target.count = source.count
    target.room = source.room
    target.max_factor = source.max_factor
    target.tick_t = source.tick_t
    target.has_jerk_limit = source.has_jerk_limit
    target.is_reduced = source.is_reduced
    target.rounded_part = source.rounded_part
    target.max_bend = source.max_bend
    target.has_changed = source.has_changed
def arrays_of_SegmentLimits(SegmentLimits part):
    return (part.linear, part.rapid_v, part.max_v, part.rapid_a, part.feed_a, part.rapid_slope_a, part.feed_slope_a, part.rapid_j, part.feed_j, part.direction, part.unused, part.listed_v, part.listed_a, part.kept_rapid_a, part.kept_feed_a, part.kept_rapid_slope_a, part.kept_feed_slope_a, part.kept_rapid_j, part.kept_feed_j, part.vector, )
def copy_Threads(Threads source, Threads target):
    pass
    target.state = source.state
    target.is_cutting = source.is_cutting
    target.was_cut = source.was_cut
    target.spindle = source.spindle
    target.angle = source.angle
    target.turn = source.turn
    target.length_d = source.length_d
    target.delay_t = source.delay_t
    target.source = source.source
    target.fault = source.fault
def arrays_of_Threads(Threads part):
    return ()
def copy_ToolLife(ToolLife source, ToolLife target):
    pass
    target.cycle_time_us = source.cycle_time_us
    target.counts_rapid = source.counts_rapid
    target.is_counted = source.is_counted
    target.has_moved = source.has_moved
    target.time_t = source.time_t
    target.distance_d = source.distance_d
    target.time_factor = source.time_factor
    target.distance_factor = source.distance_factor
    target.begin_t = source.begin_t
    target.ticks = source.ticks
    target.begin_d = source.begin_d
    target.from_d = source.from_d
    target.counted_d = source.counted_d
    target.tool = source.tool
    target.basic = source.basic
def arrays_of_ToolLife(ToolLife part):
    return ()
def copy_TouchProbe(TouchProbe source, TouchProbe target):
    pass
    target.is_seeking = source.is_seeking
    target.is_braking = source.is_braking
    target.has_touched = source.has_touched
    target.source = source.source
    target.touch_part = source.touch_part
    target.ticks = source.ticks
    target.touch_level = source.touch_level
    target.continues = source.continues
    target.is_needed = source.is_needed
def arrays_of_TouchProbe(TouchProbe part):
    return (part.values, )
def copy_TransformedLimits(TransformedLimits source, TransformedLimits target):
    pass
    target.count = source.count
    target.room = source.room
    target.transformations = source.transformations
    target.rapid_v = source.rapid_v
    target.max_v = source.max_v
    target.rapid_a = source.rapid_a
    target.feed_a = source.feed_a
    target.rapid_slope_a = source.rapid_slope_a
    target.feed_slope_a = source.feed_slope_a
    target.rapid_j = source.rapid_j
    target.feed_j = source.feed_j
    target.free_a = source.free_a
    target.free_j = source.free_j
    target.turn = source.turn
    target.steps = source.steps
    target.is_even = source.is_even
    target.plane_axis = source.plane_axis
def arrays_of_TransformedLimits(TransformedLimits part):
    return (part.linear, part.rapid_v, part.max_v, part.rapid_a, part.feed_a, part.rapid_slope_a, part.feed_slope_a, part.rapid_j, part.feed_j, part.near, part.point, part.start, part.target, part.samples, part.result, part.first, part.second, part.third, part.entering, part.leaving, part.entering_curve, part.leaving_curve, )
def copy_TrapezoidProfile(TrapezoidProfile source, TrapezoidProfile target):
    pass
    target.first_t = source.first_t
    target.first_a = source.first_a
    target.first_d = source.first_d
    target.start_v = source.start_v
    target.cruise_t = source.cruise_t
    target.cruise_v = source.cruise_v
    target.cruise_d = source.cruise_d
    target.last_a = source.last_a
    target.duration_t = source.duration_t
    target.length_d = source.length_d
    target.end_v = source.end_v
    target.is_endless = source.is_endless
def arrays_of_TrapezoidProfile(TrapezoidProfile part):
    return ()
def copy_AxisRequests(AxisRequests source, AxisRequests target):
    pass
    target.capacity = source.capacity
    target.posted = source.posted
    target.latched = source.latched
def arrays_of_AxisRequests(AxisRequests part):
    return (part.kind, part.axis, part.value, part.speed_v, part.mode, part.direction, part.answer, )
def copy_Panel(Panel source, Panel target):
    pass
    target.first_cell = source.first_cell
    target.override_pct = source.override_pct
    target.feed_hold = source.feed_hold
    target.single_block = source.single_block
    target.plc_present = source.plc_present
    target.start_pressed = source.start_pressed
    target.reset_pressed = source.reset_pressed
    target.is_armed = source.is_armed
    target.is_running = source.is_running
    target.is_paused = source.is_paused
    target.is_released = source.is_released
    target.is_step_locked = source.is_step_locked
    target.step_resolution = source.step_resolution
    target.backward_motion = source.backward_motion
    target.turns_back = source.turns_back
    target.probe = source.probe
    target.optional_stop = source.optional_stop
    target.block_line = source.block_line
    target.block_moves = source.block_moves
    target.start_taken = source.start_taken
    target.reset_taken = source.reset_taken
def arrays_of_Panel(Panel part):
    return (part.cells, )
def copy_Section(Section source, Section target):
    pass
    target.slot_count = source.slot_count
    target.last_slot = source.last_slot
    target.issued_in_tick = source.issued_in_tick
    target.taken_count = source.taken_count
    target.issued = source.issued
    target.version = source.version
def arrays_of_Section(Section part):
    return (part.state, part.function, part.sequence, part.tick, part.serial, part.value, part.done, )
def copy_Hli(Hli source, Hli target):
    pass
    target.acknowledges_itself = source.acknowledges_itself
def arrays_of_Hli(Hli part):
    return ()
def copy_AxisExchange(AxisExchange source, AxisExchange target):
    pass
    target.is_waiting = source.is_waiting
    target.source = source.source
    target.since = source.since
def arrays_of_AxisExchange(AxisExchange part):
    return (part.awaited, )
def copy_BlockScope(BlockScope source, BlockScope target):
    pass
    target.serial = source.serial
    target.position = source.position
    target.source = source.source
    target.has_moved = source.has_moved
    target.lingers = source.lingers
    target.passed_source = source.passed_source
def arrays_of_BlockScope(BlockScope part):
    return ()
def copy_Channel(Channel source, Channel target):
    pass
    target.first_cell = source.first_cell
    target.is_at_fixed_stop = source.is_at_fixed_stop
    target.total_pct = source.total_pct
    target.low_water = source.low_water
    target.decoder_open = source.decoder_open
    target.wants_slot = source.wants_slot
    target.answer = source.answer
    target.answer_ready = source.answer_ready
    target.is_reset_due = source.is_reset_due
    target.is_paced = source.is_paced
    target.starved_since = source.starved_since
    target.has_warned_of_wait = source.has_warned_of_wait
    target.has_warned_of_spindle = source.has_warned_of_spindle
def arrays_of_Channel(Channel part):
    return (part.cells, )
def copy_ChannelSignals(ChannelSignals source, ChannelSignals target):
    pass
    target.number = source.number
    target.named = source.named
    target.is_decoder_waiting = source.is_decoder_waiting
    target.awaited_number = source.awaited_number
    target.awaited_senders = source.awaited_senders
    target.may_overtake = source.may_overtake
    target.awaited_source = source.awaited_source
    target.waiting_since = source.waiting_since
    target.blocked_since = source.blocked_since
    target.awaits_tick = source.awaits_tick
def arrays_of_ChannelSignals(ChannelSignals part):
    return ()
def copy_CommandExecutor(CommandExecutor source, CommandExecutor target):
    pass
    target.first_cell = source.first_cell
    target.modal = source.modal
    target.waiting = source.waiting
    target.taken_source = source.taken_source
    target.program_ended = source.program_ended
    target.error_pending = source.error_pending
    target.error_detail = source.error_detail
    target.axis_state = source.axis_state
    target.error_message = source.error_message
    target.is_looping = source.is_looping
    target.is_skipping = source.is_skipping
    target.is_between = source.is_between
    target.is_stopped = source.is_stopped
    target.is_fatal = source.is_fatal
    target.is_resetting = source.is_resetting
def arrays_of_CommandExecutor(CommandExecutor part):
    return (part.cells, part.characters, )
def copy_CommandQueue(CommandQueue source, CommandQueue target):
    pass
    target.width = source.width
    target.capacity = source.capacity
    target.rows = source.rows
    target.head = source.head
    target.tail = source.tail
    target.timed_count = source.timed_count
    target.started = source.started
    target.last_segment = source.last_segment
    target.transformation = source.transformation
def arrays_of_CommandQueue(CommandQueue part):
    return (part.rows, part.end_row, )
def copy_LoopBody(LoopBody source, LoopBody target):
    pass
    target.width = source.width
    target.rows = source.rows
    target.count = source.count
    target.is_open = source.is_open
    target.is_complete = source.is_complete
    target.ends_at_standstill = source.ends_at_standstill
def arrays_of_LoopBody(LoopBody part):
    return (part.rows, )
def copy_SignalBoard(SignalBoard source, SignalBoard target):
    pass
    target.count = source.count
    target.received_mask = source.received_mask
    target.taken_sender = source.taken_sender
    target.taken_tick = source.taken_tick
    target.blocking = source.blocking
    target.has_waited = source.has_waited
def arrays_of_SignalBoard(SignalBoard part):
    return (part.number, part.sender, part.receiver, part.remaining, part.level, part.tick, part.mask, part.values, part.received, )
def copy_SingleBlock(SingleBlock source, SingleBlock target):
    pass
    target.only_motions = source.only_motions
def arrays_of_SingleBlock(SingleBlock part):
    return ()
def copy_ToolLives(ToolLives source, ToolLives target):
    pass
    target.sent = source.sent
    target.omits_zero = source.omits_zero
def arrays_of_ToolLives(ToolLives part):
    return ()
COPIERS = {Axes: copy_Axes, AxisMotions: copy_AxisMotions, CAxis: copy_CAxis, Offsets: copy_Offsets, Turns: copy_Turns, Couplings: copy_Couplings, CuttingSpeeds: copy_CuttingSpeeds, SpindleLimits: copy_SpindleLimits, SpindleOverrides: copy_SpindleOverrides, Spindles: copy_Spindles, Trajectories: copy_Trajectories, Transformations: copy_Transformations, Record: copy_Record, Timers: copy_Timers, FeedMemory: copy_FeedMemory, Reaction: copy_Reaction, IfOnce: copy_IfOnce, IfEdge: copy_IfEdge, IfAlways: copy_IfAlways, Condition: copy_Condition, Context: copy_Context, RealtimeCycle: copy_RealtimeCycle, CycleManager: copy_CycleManager, Counted: copy_Counted, ChannelLane: copy_ChannelLane, Kernel: copy_Kernel, KinematicMaps: copy_KinematicMaps, Orientation: copy_Orientation, ArcLimits: copy_ArcLimits, ArcSpeed: copy_ArcSpeed, BackwardMotion: copy_BackwardMotion, Corner: copy_Corner, CornerRounding: copy_CornerRounding, EdgeProbe: copy_EdgeProbe, FixedStops: copy_FixedStops, Goal: copy_Goal, History: copy_History, JerkLookAhead: copy_JerkLookAhead, JerkProfile: copy_JerkProfile, LookAhead: copy_LookAhead, Overrides: copy_Overrides, Path: copy_Path, PathAxes: copy_PathAxes, SegmentLimits: copy_SegmentLimits, Threads: copy_Threads, ToolLife: copy_ToolLife, TouchProbe: copy_TouchProbe, TransformedLimits: copy_TransformedLimits, TrapezoidProfile: copy_TrapezoidProfile, AxisRequests: copy_AxisRequests, Panel: copy_Panel, Section: copy_Section, Hli: copy_Hli, AxisExchange: copy_AxisExchange, BlockScope: copy_BlockScope, Channel: copy_Channel, ChannelSignals: copy_ChannelSignals, CommandExecutor: copy_CommandExecutor, CommandQueue: copy_CommandQueue, LoopBody: copy_LoopBody, SignalBoard: copy_SignalBoard, SingleBlock: copy_SingleBlock, ToolLives: copy_ToolLives, }
ARRAYS = {Axes: arrays_of_Axes, AxisMotions: arrays_of_AxisMotions, Offsets: arrays_of_Offsets, Turns: arrays_of_Turns, Couplings: arrays_of_Couplings, CuttingSpeeds: arrays_of_CuttingSpeeds, SpindleLimits: arrays_of_SpindleLimits, SpindleOverrides: arrays_of_SpindleOverrides, Spindles: arrays_of_Spindles, Trajectories: arrays_of_Trajectories, Transformations: arrays_of_Transformations, Record: arrays_of_Record, Timers: arrays_of_Timers, Context: arrays_of_Context, CycleManager: arrays_of_CycleManager, Kernel: arrays_of_Kernel, KinematicMaps: arrays_of_KinematicMaps, ArcLimits: arrays_of_ArcLimits, ArcSpeed: arrays_of_ArcSpeed, Corner: arrays_of_Corner, CornerRounding: arrays_of_CornerRounding, EdgeProbe: arrays_of_EdgeProbe, FixedStops: arrays_of_FixedStops, History: arrays_of_History, LookAhead: arrays_of_LookAhead, Path: arrays_of_Path, PathAxes: arrays_of_PathAxes, SegmentLimits: arrays_of_SegmentLimits, TouchProbe: arrays_of_TouchProbe, TransformedLimits: arrays_of_TransformedLimits, AxisRequests: arrays_of_AxisRequests, Panel: arrays_of_Panel, Section: arrays_of_Section, AxisExchange: arrays_of_AxisExchange, Channel: arrays_of_Channel, CommandExecutor: arrays_of_CommandExecutor, CommandQueue: arrays_of_CommandQueue, LoopBody: arrays_of_LoopBody, SignalBoard: arrays_of_SignalBoard, }
