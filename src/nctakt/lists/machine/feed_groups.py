# SPDX-License-Identifier: MIT
"""The axes that F refers to in the values of channel lists."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values


@dataclass(frozen=True, slots=True)
class ListedFeedGroup:
    """The group that F refers to without ``#FGROUP``: names of axes, none: the linear ones.

    ``is_weakest``: the weakest axis of each block.
    """

    axes: frozenset[str]
    is_weakest: bool


def listed_feed_group(values: Values) -> ListedFeedGroup:
    """Return what a channel list says about the axes of the feed."""
    return ListedFeedGroup(
        frozenset(
            values.text("gruppe[].achse[].bezeichnung", 0, index)
            for index in values.indices("gruppe[].achse[]", 0)
            if values.flag("gruppe[].achse[].default_feed_axis", 0, index)
        ),
        values.flag("feed_to_weakest_axis"),
    )
