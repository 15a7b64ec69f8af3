# SPDX-License-Identifier: MIT
"""A ``Segment`` of an ordinary block, filled field by field.

The constructor of a frozen dataclass would take as long as decoding the block.
"""

from __future__ import annotations

from nctakt.decoder.state.queued.commands import Command, Segment, Tilt
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.nc.fast import raw_nodes

_SOURCE = Command.__dict__["source"]
_NUMBER = Command.__dict__["number"]
_START = Segment.__dict__["start"]
_TARGET = Segment.__dict__["target"]
_MOTION = Segment.__dict__["motion"]
_FEED = Segment.__dict__["feed"]
_EXACT_STOP = Segment.__dict__["exact_stop"]
_DEVIATION = Segment.__dict__["deviation"]
_LIMITS_JERK = Segment.__dict__["limits_jerk"]
_ARC = Segment.__dict__["arc"]
_MODIFIERS = Segment.__dict__["modifiers"]
_CONTINUES_BLOCK = Segment.__dict__["continues_block"]
_CURVE = Segment.__dict__["curve"]
_TILT = Segment.__dict__["tilt"]


def segment(
    source: int,
    number: int,
    start: list[float],
    target: list[float],
    motion: int,
    feed: float,
    exact_stop: bool,
    deviation: float,
    limits_jerk: bool,
    arc: tuple[float, ...] | None,
    modifiers: FeedModifiers | None,
    tilt: Tilt | None,
) -> Segment:
    """Return the segment of a whole block."""
    node: Segment = raw_nodes.new_node(Segment, 0)
    raw_nodes.set_field(_SOURCE, node, source)
    raw_nodes.set_field(_NUMBER, node, number)
    raw_nodes.set_field(_START, node, tuple(start))
    raw_nodes.set_field(_TARGET, node, tuple(target))
    raw_nodes.set_field(_MOTION, node, motion)
    raw_nodes.set_field(_FEED, node, feed)
    raw_nodes.set_field(_EXACT_STOP, node, exact_stop)
    raw_nodes.set_field(_DEVIATION, node, deviation)
    raw_nodes.set_field(_LIMITS_JERK, node, limits_jerk)
    raw_nodes.set_field(_ARC, node, arc)
    raw_nodes.set_field(_MODIFIERS, node, modifiers)
    raw_nodes.set_field(_CONTINUES_BLOCK, node, False)
    raw_nodes.set_field(_CURVE, node, None)
    raw_nodes.set_field(_TILT, node, tilt)
    return node
