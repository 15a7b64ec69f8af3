# SPDX-License-Identifier: MIT
"""Trees of the realtime part that are kept from run to run, with the state that they begin with.

In: what has a tree, by a key that says all that the tree depends on. Out: the same, with the state
of its tree put back. Only one run at a time may have them.
"""

from __future__ import annotations

from collections.abc import Hashable

from nctakt.base.held_objects import held_objects
from nctakt.kernel.state import KeptNumbers, ObjectCopies

#: Trees that are kept; then all are forgotten.
MAX_KEPT = 64


class KeptTrees:
    """What has a tree, by what the tree depends on."""

    def __init__(self) -> None:
        self._kept: dict[Hashable, tuple[object, KeptNumbers]] = {}

    def find(self, key: Hashable) -> object | None:
        """Return what was kept with this key, as it was then; ``None`` if there is nothing."""
        kept = self._kept.get(key)
        if kept is None:
            return None
        found, numbers = kept
        numbers.put_back()
        return found

    def keep(self, key: Hashable, owner: object, tree: object) -> None:
        """Keep the owner of a tree that has not run yet.

        What the key names by its identity has to live as long as the owner.
        """
        if len(self._kept) == MAX_KEPT:
            self._kept.clear()
        self._kept[key] = owner, ObjectCopies(list(held_objects(tree, "nctakt.kernel.")))
