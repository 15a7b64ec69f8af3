# SPDX-License-Identifier: MIT
"""Trees of the realtime part that are kept from run to run, with the state that they begin with.

In: objects that have a tree, by a key that contains everything that the tree depends on. Out: the
same, with the state of its tree put back. Only one run at a time may have them.
"""

from __future__ import annotations

from collections.abc import Hashable

from nctakt.base.held_objects import held_objects
from nctakt.kernel.state import KeptNumbers, ObjectCopies

#: Trees that are kept; then all are forgotten.
MAX_KEPT = 64


class KeptTrees:
    """Objects that have a tree, by what the tree depends on."""

    def __init__(self) -> None:
        self._kept: dict[Hashable, tuple[object, KeptNumbers]] = {}

    def find(self, key: Hashable) -> object | None:
        """Return the object kept with this key, in its state then; ``None`` if there is none."""
        kept = self._kept.get(key)
        if kept is None:
            return None
        found, numbers = kept
        numbers.put_back()
        return found

    def keep(self, key: Hashable, owner: object, tree: object) -> None:
        """Keep the owner of a tree that has not run yet.

        Objects named in the key by their identity must live as long as the owner.
        """
        if len(self._kept) == MAX_KEPT:
            self._kept.clear()
        self._kept[key] = owner, ObjectCopies(list(held_objects(tree, "nctakt.kernel.")))
