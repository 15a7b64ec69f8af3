# SPDX-License-Identifier: MIT
"""Fair shares: when all places are taken, the client with most makes room for one with less.

In: how many places each client has. Out: whose oldest place goes, if any. A client that takes all
of them keeps no one out, and a client that has no more than the others loses nothing.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import TypeVar

_Client = TypeVar("_Client", bound=Hashable)


def greediest(
    counts: Mapping[_Client, int], newcomer: _Client, requested: int = 1
) -> _Client | None:
    """Return who has most places, if more than a newcomer would have with those it asks for."""
    if not counts:
        return None
    holder = max(counts, key=lambda client: counts[client])
    return holder if counts[holder] > counts.get(newcomer, 0) + requested else None
