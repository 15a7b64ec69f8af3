# SPDX-License-Identifier: MIT
"""Code that runs after the last cycle: FB_exit of all instances (ST-405)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from nctakt.kernel.st.calls import Call as CallNode
from nctakt.kernel.st.steps import Evaluate, Step
from nctakt.st.types import ArrayType, BlockType, Pou, Section, Storage, StructType, Type, Variable

if TYPE_CHECKING:
    from nctakt.translation.body import Routines
    from nctakt.translation.locations import Location

_EXIT = "fb_exit"


def exits_of(project: Routines, location: Location, sought: Type) -> Iterator[Step]:
    """Yield the calls of FB_exit for a variable's instances, in the reverse order of its start.

    An instance: the derived block's, its base's, then those of its members, the last one first.
    """
    if isinstance(sought, ArrayType):
        count = sought.size // max(sought.element.size, 1) if _has_exit(sought.element) else 0
        for number in reversed(range(count)):
            part = location.member(number * sought.element.size, sought.element)
            yield from exits_of(project, part, sought.element)
    elif isinstance(sought, StructType):
        for one in reversed(sought.members.values()):
            part = location.member(one.offset, one.type, one.bit)
            yield from exits_of(project, part, one.type)
    elif isinstance(sought, BlockType):
        yield from _exits_of_instance(project, location, sought.pou)


def _exits_of_instance(project: Routines, location: Location, block: Pou) -> Iterator[Step]:
    for pou in block.bases():
        method = pou.methods.get(_EXIT)
        if method is not None:
            routine, shared = project.routine(method), project.shared_bytes(method)
            call = CallNode(
                routine, location.address(), shared, Step(), Step(), False, method.start
            )
            yield Evaluate(call, method.start, 1)
    for one in reversed(block.members.values()):
        if _is_held(one):
            yield from exits_of(project, location.member(one.offset, one.type), one.type)


def _has_exit(sought: Type) -> bool:
    if isinstance(sought, ArrayType):
        return _has_exit(sought.element)
    if isinstance(sought, StructType):
        return any(_has_exit(one.type) for one in sought.members.values())
    if not isinstance(sought, BlockType):
        return False
    return any(_EXIT in pou.methods for pou in sought.pou.bases()) or any(
        _is_held(one) and _has_exit(one.type) for one in sought.pou.members.values()
    )


def _is_held(variable: Variable) -> bool:
    return variable.storage is Storage.INSTANCE and variable.section is not Section.IN_OUT
