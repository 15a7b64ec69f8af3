# SPDX-License-Identifier: MIT
"""Programs decoded into the queue, for tests that compare two ways of decoding."""

from __future__ import annotations

import struct

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.run import program_loader
from nctakt.run.controller import Controller, NcText
from nctakt.run.queue_feeder import QueueFeeder
from support.insides import machine_of

Rows = tuple[list[bytes], list[Diagnostic]]


def rows(content: str, high_water: int = 100_000, *, marks: bool = False) -> Rows:
    """The queue of a program that is decoded up to its end or to where it waits.

    ``marks``: with a mark for each block.
    """
    controller = Controller()
    found = controller.diagnostics
    try:
        loaded = program_loader.load(NcText("p.nc", content), machine_of(controller), found)
    except Failure as failure:
        return [], failure.diagnostics
    feed = QueueFeeder(machine_of(controller), loaded, found.append, marks_blocks=marks)
    feed.high_water = high_water
    channel = machine_of(controller).channels[0]
    feed.refill()
    queued = [channel.queue.command(index) for index in range(channel.queue.queued())]
    return [struct.pack(f"{len(row)}d", *row) for row in queued], found
