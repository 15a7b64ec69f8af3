# SPDX-License-Identifier: MIT
"""The protocol, with an answer to each malformed message.

In: messages of an editor, as JSON. Out: an error to the sender, or none if the message has no ID;
the texts of errors have no traceback. pygls itself only writes such messages to its log, and a
client that waits for its answer would wait forever.
"""

from __future__ import annotations

import logging
from concurrent.futures import Future
from typing import Any, NamedTuple

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.protocol import LanguageServerProtocol

#: Maximum length of an error that quotes the message.
_LONGEST_TEXT = 200


class Refused(JsonRpcException):
    """A request that is answered with the reason why it cannot be done."""

    CODE = types.LSPErrorCodes.RequestFailed


class _Malformed(NamedTuple):
    """A malformed message; ``identity``: its ID, ``is_awaited``: it has one."""

    identity: str | int | None
    is_awaited: bool
    error: JsonRpcException


class TolerantProtocol(LanguageServerProtocol):
    """Answers malformed messages, and refused ones, with the reason alone."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        logging.getLogger("pygls").setLevel(logging.CRITICAL + 1)  # its log has tracebacks

    def structure_message(self, data: dict[str, Any]) -> Any:
        try:
            if "jsonrpc" in data and not isinstance(data.get("method", ""), str):
                raise _invalid("the method is no text")
            return super().structure_message(data)
        except JsonRpcException as error:
            identity = data.get("id")
            is_known = isinstance(identity, str | int) and not isinstance(identity, bool)
            return _Malformed(identity if is_known else None, "id" in data, error)
        except (TypeError, ValueError, RecursionError) as error:
            return _Malformed(None, True, _invalid(error))

    def handle_message(self, message: Any) -> None:
        if isinstance(message, _Malformed):
            if message.is_awaited:
                self.answer(message.identity, message.error)
        elif hasattr(message, "jsonrpc"):
            super().handle_message(message)
        else:
            self.answer(None, _invalid("no message of the protocol"))

    def _send_response(
        self,
        msg_id: str | int,
        result: Any | None = None,
        error: types.ResponseError | None = None,
    ) -> None:
        if error is not None:
            error.data = None  # a traceback
        super()._send_response(msg_id, result, error)

    def answer(self, identity: str | int | None, error: JsonRpcException) -> None:
        """Send an error; ``identity``: that of the request, ``None`` if it cannot be read."""
        shown = {"code": error.code, "message": error.message[:_LONGEST_TEXT]}
        # A dictionary: an object of the library would leave out an ID that is null.
        self._send_data({"jsonrpc": self.VERSION, "id": identity, "error": shown})

    def _send_handler_result(self, future: Future[Any], *, msg_id: str | int) -> None:
        error = None if future.cancelled() else future.exception()
        if isinstance(error, Refused):
            self._send_response(msg_id, error=error.to_response_error())
        else:
            super()._send_handler_result(future, msg_id=msg_id)


def unreadable(error: Exception) -> JsonRpcException:
    """Return the error of a body that is not JSON."""
    return JsonRpcException(f"Parse error: {error}", types.ErrorCodes.ParseError)


def _invalid(reason: object) -> JsonRpcException:
    return JsonRpcException(f"Invalid request: {reason}", types.ErrorCodes.InvalidRequest)
