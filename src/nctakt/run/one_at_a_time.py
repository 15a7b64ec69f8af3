# SPDX-License-Identifier: MIT
"""Methods that only one thread at a time may run.

In: a method of an object with an ``OneAtATime`` as ``turn``. Out: the same method, which raises
``Failure`` (901005) while another thread runs one of them. The thread itself may call them again,
for example from a PLC.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from typing import Concatenate, ParamSpec, Protocol, Self, TypeVar

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.controller import CONTROLLER_IS_BUSY

_P = ParamSpec("_P")
_T = TypeVar("_T")


class OneAtATime:
    """A context of one thread at a time; raises ``Failure`` (901005) for a second one."""

    def __init__(self) -> None:
        self._lock = threading.RLock()

    def __enter__(self) -> Self:
        if not self._lock.acquire(blocking=False):
            raise Failure(diagnostic(CONTROLLER_IS_BUSY))
        return self

    def __exit__(self, *_: object) -> None:
        self._lock.release()


class _HasTurn(Protocol):
    turn: OneAtATime


_Owner = TypeVar("_Owner", bound=_HasTurn)


def alone(
    method: Callable[Concatenate[_Owner, _P], _T],
) -> Callable[Concatenate[_Owner, _P], _T]:
    """Let a method run only while no other thread runs one of the same object."""

    @functools.wraps(method)
    def guarded(owner: _Owner, /, *words: _P.args, **keywords: _P.kwargs) -> _T:
        with owner.turn:
            return method(owner, *words, **keywords)

    return guarded
