# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): the axes that F refers to, as long as no program chooses others."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

FEED_GROUPS = (
    Parameter(
        "P-CHAN-00011",
        "gruppe[0..0].achse[0..31].default_feed_axis",
        ValueType.BOOLEAN,
        False,
        Text(
            "The axis belongs to the group that F refers to, without #FGROUP",
            "Die Achse gehört zur Gruppe, auf die sich F ohne #FGROUP bezieht",
        ),
    ),
    Parameter(
        "P-CHAN-00096",
        "feed_to_weakest_axis",
        ValueType.BOOLEAN,
        False,
        Text(
            "F refers to the weakest axis of each block, as with #FGROUP WAXIS",
            "F bezieht sich auf die schwächste Achse jedes Satzes, wie bei #FGROUP WAXIS",
        ),
    ),
)
