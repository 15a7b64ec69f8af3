# SPDX-License-Identifier: MIT
"""The methods that clients call: select a program, START, stop, RESET; acknowledge an alarm.

In: a call of a client. Out: its result, a status and for mistakes a text in the client's language.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

from asyncua import ua

from nctakt.base.failure import Failure
from nctakt.servers.host import Busy, Host, Key
from nctakt.servers.opcua.alarms import Alarms
from nctakt.servers.opcua.clients.client import Client
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.nodes import Nodes, standard
from nctakt.servers.opcua.space.machine_space import MachineSpace

#: Calls a method with its arguments; returns a status, and output arguments.
Method = Callable[[Client, list[Any]], Awaitable[tuple[int, list[ua.Variant]]]]

#: Methods of alarms in namespace 0: Acknowledge, AddComment, both ways to ask for all again.
_ACKNOWLEDGE, _ADD_COMMENT, _REFRESH, _REFRESH_ITEM = 9111, 9029, 3875, 12912

_TEXT = ua.VariantType.LocalizedText


class Methods:
    """The methods of channels and alarms."""

    def __init__(self, nodes: Nodes, machine: MachineSpace, host: Host, alarms: Alarms) -> None:
        self._host = host
        self._alarms = alarms
        self._own: dict[tuple[ua.NodeId, ua.NodeId], tuple[tuple[ua.VariantType, ...], Method]] = {}
        for number, channel in machine.channels.items():
            path = str(channel.Identifier)
            for name, kinds, method in (
                ("SelectProgram", (ua.VariantType.String,), self._selecting(number)),
                ("Start", (), self._pressing("start", number)),
                ("Stop", (), self._pressing("hold", number)),
                ("Continue", (), self._pressing("go_on", number)),
                ("Reset", (), self._pressing("reset", number)),
            ):
                node = nodes.add_method(
                    machine.id(f"{path}.{name}"),
                    machine.name(name),
                    inputs=[_argument("Program")] if kinds else [],
                    outputs=[_argument("Reason", 21)],
                )
                nodes.refer(channel, refs.HAS_COMPONENT, node)
                self._own[channel, node] = kinds, method

    async def call(self, session: Client, request: ua.CallMethodRequest) -> Any:
        """Call a method of a client's request; return its result."""
        result = ua.CallMethodResult()
        arguments = request.InputArguments or []
        own = self._own.get((request.ObjectId, request.MethodId))
        codes = ua.StatusCodes
        if own is not None:
            kinds, method = own
        elif request.MethodId in _STANDARD:
            kinds = _STANDARD[request.MethodId]
            method = self._standard(request)
        else:
            status = (
                codes.BadMethodInvalid
                if request.ObjectId in session.aspace
                else codes.BadNodeIdUnknown
            )
            result.StatusCode = ua.StatusCode(status)
            return result
        if len(arguments) != len(kinds):
            few = len(arguments) < len(kinds)
            status = codes.BadArgumentsMissing if few else codes.BadTooManyArguments
            result.StatusCode = ua.StatusCode(status)
            return result
        fits = [
            one.VariantType == kind and not one.is_array
            for one, kind in zip(arguments, kinds, strict=True)
        ]
        if not all(fits):
            result.StatusCode = ua.StatusCode(codes.BadInvalidArgument)
            result.InputArgumentResults = [
                ua.StatusCode(0 if fit else codes.BadTypeMismatch) for fit in fits
            ]
            return result
        status, result.OutputArguments = await method(session, [one.Value for one in arguments])
        result.StatusCode = ua.StatusCode(status)
        result.InputArgumentResults = [ua.StatusCode() for _ in arguments]
        return result

    # --- channels -------------------------------------------------------------------------------

    def _selecting(self, number: int) -> Method:
        async def select(session: Client, words: list[Any]) -> tuple[int, list[ua.Variant]]:
            program = str(words[0] or "")
            return await _done(session, self._host.select(program, number, "opcua", session.client))

        return select

    def _pressing(self, key: Key, number: int) -> Method:
        async def press(session: Client, _: list[Any]) -> tuple[int, list[ua.Variant]]:
            return await _done(session, self._host.press(key, number, "opcua", session.client))

        return press

    # --- alarms ---------------------------------------------------------------------------------

    def _standard(self, request: ua.CallMethodRequest) -> Method:
        async def call(session: Client, words: list[Any]) -> tuple[int, list[ua.Variant]]:
            number = request.MethodId.Identifier
            if number == _REFRESH:
                return self._alarms.refresh(session, words[0], None), []
            if number == _REFRESH_ITEM:
                return self._alarms.refresh(session, words[0], words[1]), []
            event_id, comment = words
            is_acknowledged = number == _ACKNOWLEDGE
            return (
                self._alarms.answer(
                    session, request.ObjectId, event_id, comment, is_acknowledged=is_acknowledged
                ),
                [],
            )

        return call


_STANDARD = {
    standard(_ACKNOWLEDGE): (ua.VariantType.ByteString, _TEXT),
    standard(_ADD_COMMENT): (ua.VariantType.ByteString, _TEXT),
    standard(_REFRESH): (ua.VariantType.UInt32,),
    standard(_REFRESH_ITEM): (ua.VariantType.UInt32, ua.VariantType.UInt32),
}


def _argument(name: str, data_type: int = 12) -> ua.Argument:
    return ua.Argument(Name=name, DataType=standard(data_type), ValueRank=-1)


async def _done(session: Client, command: Awaitable[None]) -> tuple[int, list[ua.Variant]]:
    """Return the result of a command: for a refused one the reason in the client's language."""
    reason, status = "", 0
    try:
        await command
    except Failure as failure:
        found = failure.diagnostics[0]
        reason = f"{found.id}: {found.text(session.language)}"
        status = int(ua.StatusCodes.BadRequestNotAllowed)
    except Busy:
        status = int(ua.StatusCodes.BadTooManyOperations)
    return status, [ua.Variant(ua.LocalizedText(reason, session.language), _TEXT)]
