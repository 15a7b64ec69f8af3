# SPDX-License-Identifier: MIT
"""``#ANG``: lines by their angle; what their blocks may not have (MO-4)."""

from __future__ import annotations

from collections.abc import Collection

from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.path.contour_lines import ANGLE_DURING_ARC
from nctakt.messages.path.shapes import CORNER_OFF
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.path import ANGLE_WORD
from nctakt.nc.tree import Block, Word
from nctakt.nc.vocabulary.functions import ANY_ARCS


def check_contour_line(
    block: Block, functions: Collection[float], channel: ChannelParameters, findings: Findings
) -> None:
    """Check the word of an angle beside the G functions of its block."""
    span = next(
        word.span for word in block.words if isinstance(word, Word) and word.name == ANGLE_WORD
    )
    if not channel.allows_corners:
        findings.report(CORNER_OFF, span, word=ANGLE_WORD)
    for function in ANY_ARCS:
        if function in functions:
            findings.report(ANGLE_DURING_ARC, span, function=function)
