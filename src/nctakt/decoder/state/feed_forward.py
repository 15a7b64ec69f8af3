# SPDX-License-Identifier: MIT
"""Feed-forward control as a program has set it."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field


@dataclass(slots=True)
class FeedForwardState:
    """``is_on``: G135; ``weights``: factors of G136 by axis index, else 1.

    ``is_due``: the drives do not know it yet.
    """

    is_on: bool = False
    weights: dict[int, float] = field(default_factory=dict)
    is_due: bool = False

    def switch(self, *, is_on: bool) -> None:
        """Switch it on or off."""
        self.is_on = is_on
        self.is_due = True
