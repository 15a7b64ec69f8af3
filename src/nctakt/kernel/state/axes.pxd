# SPDX-License-Identifier: MIT
# C types of axes.py.
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.axis_motions cimport AxisMotions
from nctakt.kernel.axes.c_axis cimport CAxis
from nctakt.kernel.axes.coordinates cimport Offsets, Turns
from nctakt.kernel.axes.couplings cimport Couplings
from nctakt.kernel.axes.cutting_speeds cimport CuttingSpeeds
from nctakt.kernel.axes.spindle_limits cimport SpindleLimits
from nctakt.kernel.axes.spindle_overrides cimport SpindleOverrides
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.axes.trajectory cimport Trajectories
from nctakt.kernel.axes.transformations cimport Transformations
from nctakt.kernel.kinematics.maps cimport KinematicMaps
from nctakt.kernel.kinematics.orientation cimport Orientation

cpdef copy_axes(Axes source, Axes target)
cpdef tuple arrays_of_axes(Axes part)
cpdef copy_axis_motions(AxisMotions source, AxisMotions target)
cpdef tuple arrays_of_axis_motions(AxisMotions part)
cpdef copy_offsets(Offsets source, Offsets target)
cpdef tuple arrays_of_offsets(Offsets part)
cpdef copy_turns(Turns source, Turns target)
cpdef tuple arrays_of_turns(Turns part)
cpdef copy_couplings(Couplings source, Couplings target)
cpdef tuple arrays_of_couplings(Couplings part)
cpdef copy_c_axis(CAxis source, CAxis target)
cpdef copy_spindles(Spindles source, Spindles target)
cpdef tuple arrays_of_spindles(Spindles part)
cpdef copy_cutting_speeds(CuttingSpeeds source, CuttingSpeeds target)
cpdef tuple arrays_of_cutting_speeds(CuttingSpeeds part)
cpdef tuple arrays_of_spindle_overrides(SpindleOverrides part)
cpdef copy_spindle_limits(SpindleLimits source, SpindleLimits target)
cpdef tuple arrays_of_spindle_limits(SpindleLimits part)
cpdef copy_trajectories(Trajectories source, Trajectories target)
cpdef tuple arrays_of_trajectories(Trajectories part)
cpdef copy_transformations(Transformations source, Transformations target)
cpdef tuple arrays_of_transformations(Transformations part)
cpdef copy_kinematic_maps(KinematicMaps source, KinematicMaps target)
cpdef tuple arrays_of_kinematic_maps(KinematicMaps part)
cpdef copy_orientation(Orientation source, Orientation target)
