# SPDX-License-Identifier: MIT
"""The modal state after an exchange of axes: what a program said of an axis goes with it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from nctakt.decoder.state.modal_state import ModalState

_Value = TypeVar("_Value")


def follow(state: ModalState, moved: Mapping[int, int]) -> None:
    """Let the values by axis follow their axes; ``moved``: old indices -> new ones.

    Those of axes that the channel has given are lost.
    """
    state.limits.weights = _moved(state.limits.weights, moved)
    state.feed.axis_overrides = _moved(state.feed.axis_overrides, moved)
    if state.feed.group is not None:
        state.feed.group = state.feed.group.after_exchange(moved)
    state.software_limits.programmed = _moved(state.software_limits.programmed, moved)
    state.measuring.measured = _moved(state.measuring.measured, moved)
    state.frame.factors = _moved(state.frame.factors, moved)
    state.path.contour.point = _moved(state.path.contour.point, moved)
    state.feed_forward.weights = _moved(state.feed_forward.weights, moved)
    state.wcs = _moved(state.wcs, moved)
    state.mcs = _moved(state.mcs, moved)
    if state.tool.length_axis is not None:
        axis, sign = state.tool.length_axis
        state.tool.length_axis = (moved[axis], sign) if axis in moved else None


def _moved(values: Mapping[int, _Value], moved: Mapping[int, int]) -> dict[int, _Value]:
    return {moved[axis]: value for axis, value in values.items() if axis in moved}
