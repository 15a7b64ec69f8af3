# SPDX-License-Identifier: MIT
"""Methods of which one works at a time, whoever calls them.

In: a method of an object with an ``OneAtATime`` as ``turn``. Out: the same, which raises
``Failure`` (901005) while another of them works: in another thread, or around it in a PLC.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Concatenate, ParamSpec, Protocol, Self, TypeVar

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.controller import CONTROLLER_IS_BUSY

_P = ParamSpec("_P")
_T = TypeVar("_T")


class OneAtATime:
    """Is entered by one at a time; raises ``Failure`` for the second one."""

    def __init__(self) -> None:
        self._free = [True]

    def __enter__(self) -> Self:
        try:
            self._free.pop()  # one step for all threads
        except IndexError:
            raise Failure(diagnostic(CONTROLLER_IS_BUSY)) from None
        return self

    def __exit__(self, *_: object) -> None:
        self._free.append(True)


class _HasTurn(Protocol):
    turn: OneAtATime


_Owner = TypeVar("_Owner", bound=_HasTurn)


def alone(
    method: Callable[Concatenate[_Owner, _P], _T],
) -> Callable[Concatenate[_Owner, _P], _T]:
    """Let a method work only while no other one of its object does."""

    @functools.wraps(method)
    def guarded(owner: _Owner, /, *words: _P.args, **named: _P.kwargs) -> _T:
        with owner.turn:
            return method(owner, *words, **named)

    return guarded
