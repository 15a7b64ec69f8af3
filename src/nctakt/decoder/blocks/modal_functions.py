# SPDX-License-Identifier: MIT
"""Effects of modal G functions, a method for each modal group; later blocks find them in the state.

In: the functions of a block, in their order. Out: changes of ``state/modal_state.py``.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import Span
from nctakt.decoder import tilted_motions
from nctakt.decoder.blocks.edge_banding import switch_edge_banding
from nctakt.decoder.blocks.frames.frame_commands import FrameCommands
from nctakt.decoder.blocks.frames.rotating_planes import check_function
from nctakt.decoder.blocks.path.feed_ramps import FeedRamps
from nctakt.decoder.blocks.path.splines import SplineWords
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.cutting import DIAMETERS_WITHOUT_EFFECT
from nctakt.messages.path.tools import G238_DURING_COMPENSATION, PLANE_CHANGE_DURING_COMPENSATION
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ABSOLUTE,
    ABSOLUTE_CENTRE,
    APPROACH_INNER_CORNER,
    CIRCULAR_TRANSITIONS,
    COMPENSATION_OFF,
    CONTOUR_FEED,
    CONTOURING_ON,
    DEPART_WITHOUT_MOTION,
    DIAMETER_ON,
    EXACT_STOP_ON,
    FEED_FORWARD_ON,
    INCH,
    MASKING_ON,
    THREAD_CUTTING,
    group_of,
)


class ModalFunctions:
    """Executes the modal functions of one program."""

    def __init__(
        self, values: Values, frame: FrameCommands, ramps: FeedRamps, splines: SplineWords
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._frame = frame
        self._methods: dict[Group | None, Callable[[int, Span], None]] = {
            Group.MOTION: self._motion,
            Group.FEED_ADAPTATION: self._feed_adaptation,
            Group.PLANE: self._plane,
            Group.TRANSITION: self._transition,
            Group.COMPENSATION: self._compensation,
            Group.UNIT: self._unit,
            Group.DIMENSION: self._dimension,
            Group.FEED: self._feed,
            Group.DIAMETER: self._diameter,
            Group.EDGE_BANDING: self._edge_banding,
            Group.APPROACH: self._approach,
            Group.MASKING: self._masking,
            Group.ARC_CENTRE: self._arc_centre,
            Group.SPLINE: splines.switch,
            Group.CONTOURING: self._contouring,
            Group.EXACT_STOP: self._exact_stop,
            Group.CORNER_DECELERATION: ramps.switch,
            Group.FEED_FORWARD: self._feed_forward,
        }

    def execute(self, function: int, span: Span) -> None:
        """Execute a G function; ignore one that acts only in its block, or on its words."""
        method = self._methods.get(group_of(function))
        if method is not None:
            method(function, span)

    def _motion(self, function: int, span: Span) -> None:
        check_function(self._values, function, span)
        self._state.motion = function
        if function != THREAD_CUTTING:
            self._state.thread.offset = 0.0

    def _feed_adaptation(self, function: int, _span: Span) -> None:
        self._state.path.compensation.adapts_feed = function == CONTOUR_FEED

    def _plane(self, function: int, span: Span) -> None:
        check_function(self._values, function, span)
        self._frame.leave_plane(function, span)
        path = self._state.path
        if path.compensation.is_active and function != path.plane:
            self._values.fail(
                PLANE_CHANGE_DURING_COMPENSATION, span, word=f"G{function}", plane=path.plane
            )
        path.plane = function

    def _transition(self, function: int, _span: Span) -> None:
        self._state.path.compensation.by_arc = function == CIRCULAR_TRANSITIONS

    def _compensation(self, function: int, _span: Span) -> None:
        """Process G40; G41 and G42 need the other words of their block."""
        if function == COMPENSATION_OFF:
            self._end_compensation()

    def _end_compensation(self) -> None:
        """Switch compensation off; after G239 the program continues from the tool's position."""
        compensation = self._state.path.compensation
        compensation.side = 0
        if compensation.has_left_path and compensation.approach == DEPART_WITHOUT_MOTION:
            path, positions = self._state.path, self._state.positions
            end = dict(zip(path.plane_axes, compensation.end, strict=True))
            self._state.positions = tilted_motions.moved_in_plane(
                positions, end, self._environment, path.plane
            )

    def _unit(self, function: int, _span: Span) -> None:
        self._state.inch = function == INCH

    def _dimension(self, function: int, _span: Span) -> None:
        self._state.absolute = function == ABSOLUTE

    def _feed(self, function: int, _span: Span) -> None:
        self._state.feed.feed_mode = function

    def _diameter(self, function: int, span: Span) -> None:
        """Process G51 and G52; warn where the lists of all face axes rule out diameters."""
        self._state.path.has_diameters = function == DIAMETER_ON
        face = [axis for axis in self._environment.axes if axis.is_face]
        if function == DIAMETER_ON and face:
            if not any(axis.absolute_diameters or axis.relative_diameters for axis in face):
                self._values.warn(DIAMETERS_WITHOUT_EFFECT, span, axis=face[0].name)

    def _edge_banding(self, function: int, span: Span) -> None:
        switch_edge_banding(self._values, function, span)

    def _approach(self, function: int, span: Span) -> None:
        compensation = self._state.path.compensation
        if compensation.is_active and function != compensation.mode:
            if APPROACH_INNER_CORNER in (function, compensation.mode):
                self._values.fail(G238_DURING_COMPENSATION, span, word=f"G{function}")
        compensation.mode = function
        if compensation.is_left:
            self._end_compensation()

    def _masking(self, function: int, _span: Span) -> None:
        self._state.path.compensation.masks = function == MASKING_ON

    def _arc_centre(self, function: int, _span: Span) -> None:
        self._state.path.absolute_centre = function == ABSOLUTE_CENTRE

    def _contouring(self, function: int, _span: Span) -> None:
        self._state.path.contouring = function == CONTOURING_ON

    def _exact_stop(self, function: int, _span: Span) -> None:
        self._state.path.exact_stop = function == EXACT_STOP_ON

    def _feed_forward(self, function: int, _span: Span) -> None:
        self._state.feed_forward.switch(is_on=function == FEED_FORWARD_ON)
