# SPDX-License-Identifier: MIT
# C types of path.py.
cimport cython
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

cpdef copy_arc_limits(ArcLimits source, ArcLimits target)
cpdef tuple arrays_of_arc_limits(ArcLimits part)
cpdef copy_arc_speed(ArcSpeed source, ArcSpeed target)
cpdef tuple arrays_of_arc_speed(ArcSpeed part)
cpdef copy_backward_motion(BackwardMotion source, BackwardMotion target)
cpdef copy_corner(Corner source, Corner target)
cpdef tuple arrays_of_corner(Corner part)
cpdef tuple arrays_of_corner_rounding(CornerRounding part)
cpdef copy_edge_probe(EdgeProbe source, EdgeProbe target)
cpdef copy_threads(Threads source, Threads target)
cpdef tuple arrays_of_edge_probe(EdgeProbe part)
cpdef copy_fixed_stops(FixedStops source, FixedStops target)
cpdef tuple arrays_of_fixed_stops(FixedStops part)
cpdef copy_goal(Goal source, Goal target)
cpdef copy_history(History source, History target)
cpdef tuple arrays_of_history(History part)
cpdef copy_jerk_look_ahead(JerkLookAhead source, JerkLookAhead target)
cpdef copy_jerk_profile(JerkProfile source, JerkProfile target)
cpdef copy_look_ahead(LookAhead source, LookAhead target)
cpdef tuple arrays_of_look_ahead(LookAhead part)
cpdef copy_overrides(Overrides source, Overrides target)
cpdef copy_tool_life(ToolLife source, ToolLife target)
cpdef copy_path(Path source, Path target)
cpdef tuple arrays_of_path(Path part)
cpdef copy_path_axes(PathAxes source, PathAxes target)
cpdef tuple arrays_of_path_axes(PathAxes part)
cpdef copy_segment_limits(SegmentLimits source, SegmentLimits target)
cpdef tuple arrays_of_segment_limits(SegmentLimits part)
cpdef copy_touch_probe(TouchProbe source, TouchProbe target)
cpdef tuple arrays_of_touch_probe(TouchProbe part)
cpdef copy_transformed_limits(TransformedLimits source, TransformedLimits target)
cpdef tuple arrays_of_transformed_limits(TransformedLimits part)
cpdef copy_trapezoid_profile(TrapezoidProfile source, TrapezoidProfile target)
@cython.locals(count=Py_ssize_t)
cpdef tuple history_of_path(Path path)
