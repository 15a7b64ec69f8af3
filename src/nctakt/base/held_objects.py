# SPDX-License-Identifier: MIT
"""All objects of some modules that an object holds, through any other of them."""

from __future__ import annotations

import gc
from collections.abc import Iterator

#: Containers in which objects are.
_CONTAINERS = (dict, list, tuple)


def held_objects(root: object, package: str) -> Iterator[object]:
    """Yield ``root`` and each object that it holds, once; ``package``: begin of their modules."""
    seen = {id(root)}
    waiting = [root]
    while waiting:
        one = waiting.pop()
        if not isinstance(one, _CONTAINERS):
            yield one
        for held in gc.get_referents(one):
            is_held = isinstance(held, _CONTAINERS) or type(held).__module__.startswith(package)
            if is_held and id(held) not in seen:
                seen.add(id(held))
                waiting.append(held)
