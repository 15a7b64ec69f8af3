# SPDX-License-Identifier: MIT
"""The log of a slice: the same whether its rows come one by one or many at once."""

from __future__ import annotations

import random

import pytest
from support.event_rows import Names, row
from support.random_seeds import each_seed

from nctakt.kernel import rows
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import EventDecoder
from nctakt.session import tick_log
from nctakt.session.tick_log import TickLog


@each_seed(30, 30)
def test_chunks_do_not_show(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Latest events, what is left out, blocks and their number, with a new begin on the way."""
    monkeypatch.setattr(tick_log, "MAX_EVENTS", 12)
    monkeypatch.setattr(tick_log, "MAX_UNREAD", random.Random(seed).choice((0, 5, 40)))
    chance = random.Random(seed)
    kinds = rows.EVENT_BLOCK, rows.EVENT_STARTED, rows.EVENT_HELD
    found = [row(chance.choice(kinds), 1, tick=tick // 2) for tick in range(chance.randint(1, 90))]
    since = chance.randint(0, len(found)) // 2
    seen = []
    for largest in (1, 30):
        decoder, log, part = EventDecoder(1000, Names()), TickLog(), found
        log.begin(since)
        while part:
            count = chance.randint(1, largest)
            log.events(EventChunk(decoder, b"".join(part[:count])))
            part = part[count:]
        blocks, count = dict(log.blocks), log.block_count
        events, left_out = log.take()
        seen.append(([(str(one), one.tick) for one in events], left_out, blocks, count))
        assert log.take() == ([], 0)
    assert seen[0] == seen[1]
    kept = [one for one in range(len(found)) if one // 2 >= since]
    assert [tick for _, tick in seen[0][0]] == [one // 2 for one in kept[-12:]]
    assert seen[0][1] == max(0, len(kept) - 12)
