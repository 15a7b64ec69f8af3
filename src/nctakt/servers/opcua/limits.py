# SPDX-License-Identifier: MIT
"""The limits of the server; clients learn of them in ServerCapabilities and by status codes."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class Limits:
    """How much clients can have at once, together or each."""

    connections: int = 200
    sessions: int = 100
    subscriptions: int = 500
    subscriptions_per_session: int = 50
    items: int = 50_000
    items_per_subscription: int = 5_000
    queue_size: int = 1_000
    unacknowledged: int = 20
    publish_requests: int = 50
    nodes_per_call: int = 10_000
    history_nodes: int = 100
    history_rows: int = 10_000
    history_part: int = 500
    unsent_bytes: int = 16 * 1024 * 1024
    message_bytes: int = 4 * 1024 * 1024
    min_interval_ms: float = 10.0
    default_interval_ms: float = 50.0
    max_interval_ms: float = 3_600_000.0
    activation_s: float = 10.0
    entering_s: float = 2.0
    silence_s: float = 30.0

    def interval_ms(self, requested: float) -> float:
        """Return the interval that a client gets: as requested, in steps of the shortest one."""
        if not requested > 0.0:  # not a number, either
            return self.default_interval_ms
        step = self.min_interval_ms
        bounded = min(max(step, requested), self.max_interval_ms)
        return round(bounded / step) * step
