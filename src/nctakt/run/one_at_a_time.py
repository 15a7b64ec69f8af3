# SPDX-License-Identifier: MIT
"""Methods that only one thread may run at a time.

In: a method of an object with an ``OneAtATime`` as ``turn``. Out: the same method, which raises
``Failure`` (901005) while another thread runs one of them. The thread itself may call them again,
for example from a PLC.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from typing import Concatenate, ParamSpec, Protocol, TypeVar

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.controller import CONTROLLER_IS_BUSY

_P = ParamSpec("_P")
_T = TypeVar("_T")


class OneAtATime:
    """A lock held by one thread at a time; ``begin`` comes before a method, ``end`` after it."""

    def __init__(self) -> None:
        lock = threading.RLock()
        self.begin = functools.partial(lock.acquire, False)  # as a keyword it is slower
        self.end = lock.release


class _HasTurn(Protocol):
    turn: OneAtATime


_Owner = TypeVar("_Owner", bound=_HasTurn)


def alone(
    method: Callable[Concatenate[_Owner, _P], _T],
) -> Callable[Concatenate[_Owner, _P], _T]:
    """Let a method run only while no other thread runs one of the same object."""

    @functools.wraps(method)
    def guarded(owner: _Owner, /, *words: _P.args, **keywords: _P.kwargs) -> _T:
        turn = owner.turn
        if not turn.begin():
            raise Failure(diagnostic(CONTROLLER_IS_BUSY))
        try:
            return method(owner, *words, **keywords)
        finally:
            turn.end()

    return guarded
