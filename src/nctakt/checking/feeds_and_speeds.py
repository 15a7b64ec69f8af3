# SPDX-License-Identifier: MIT
"""Blocks without a feed, and speeds beyond those of a spindle.

In: the blocks of a program with the facts certain there. Out: the facts after them, and the errors
of a run (20008, 900905) if they are certain.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from nctakt.base.diagnostics import Span
from nctakt.checking.path_facts import Facts
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axes.spindles import SPINDLE_SPEED_LIMITED
from nctakt.messages.programs.decoder import NO_FEED_ACTIVE
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Block, Number, Word
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ARCS,
    CUTTING_SPEED,
    FEED_PER_MINUTE,
    FEED_PER_REVOLUTION,
    FEED_SHARE,
    GEAR_STEP,
    INVERSE_TIME_FEED,
    LINE,
    NO_SPINDLE_OVERRIDE,
    SPINDLE_LIMIT,
    THREADS,
    group_of,
)
from nctakt.nc.vocabulary.spindle_commands import split

#: Modes of F that have no value at the start of a program, regardless of the channel list.
_WITHOUT_START = frozenset((INVERSE_TIME_FEED, FEED_PER_REVOLUTION, FEED_SHARE))
#: G functions with which S is not a speed that the spindle takes over.
_OTHER_SPEEDS = frozenset((CUTTING_SPEED, SPINDLE_LIMIT, GEAR_STEP, NO_SPINDLE_OVERRIDE, *THREADS))


def begin_program(facts: Facts, channel: ChannelParameters) -> None:
    """Note the facts at the start of a main program."""
    start = channel.program_start
    functions = start.g_functions.values()
    in_force = {group_of(function): function for function in functions}
    facts.feed_mode = in_force.get(Group.FEED, FEED_PER_MINUTE)
    facts.lacking_feeds = _WITHOUT_START
    if start.feed_mm_min == 0.0:
        facts.lacking_feeds |= {FEED_PER_MINUTE}
    facts.is_cutting = in_force.get(Group.CUTTING) == CUTTING_SPEED


def note_feed(block: Block, facts: Facts) -> None:
    """Note that a block gives an F in the present mode."""
    if not any(isinstance(word, Word) and word.name == "F" for word in block.words):
        return
    if facts.feed_mode is None or facts.lacking_feeds is None:
        facts.lacking_feeds = None
    else:
        facts.lacking_feeds -= {facts.feed_mode}


def check_feed(span: Span, facts: Facts, findings: Findings) -> None:
    """Report a block that certainly moves with feed and has none; once for each mode."""
    if facts.motion not in (LINE, *ARCS) or not facts.lacking_feeds:
        return
    if facts.feed_mode in facts.lacking_feeds:
        facts.lacking_feeds -= {facts.feed_mode}
        findings.report(NO_FEED_ACTIVE, span)


def allows_speeds(functions: Collection[int], facts: Facts) -> bool:
    """Return whether S of a block is certainly a speed that its spindle takes over."""
    return facts.is_cutting is False and _OTHER_SPEEDS.isdisjoint(functions)


def check_speeds(
    block: Block,
    channel: ChannelParameters,
    limits: Mapping[str, float],
    findings: Findings,
    *,
    has_main: bool,
) -> None:
    """Warn of constant speeds beyond ``limits``, the highest speeds of spindles in 1/min.

    ``has_main``: the main spindle is certainly that of the channel list.
    """
    commands, _ = split(block.words, channel.spindle_names)
    for command in commands:
        speed = command.speed
        if not isinstance(speed, Number):
            continue
        for spindle in channel.spindles:
            is_meant = has_main and spindle.is_main and not command.name
            if is_meant or command.name in (spindle.name, spindle.list_name):
                limit = limits.get(spindle.name)
                if limit is not None and speed.value > limit * (1.0 + 1e-9):
                    findings.report(
                        SPINDLE_SPEED_LIMITED,
                        speed.span,
                        spindle=spindle.name,
                        limit=limit,
                        speed=speed.value,
                    )
                break
