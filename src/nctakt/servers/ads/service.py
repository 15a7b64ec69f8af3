# SPDX-License-Identifier: MIT
"""Requests of ADS -> answers: from the latest values, or as writes of the host (AD-1 … AD-6).

In: a client, a frame. Out: the data of the answer, at once if all values are available; else
something to wait for. It knows no socket. All values of one request are of the same tick, and the
writes of one sum command are latched by the same tick.
"""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Iterable
from functools import partial
from struct import Struct, pack
from struct import error as StructError
from typing import Any

from nctakt.base.failure import Failure
from nctakt.base.version import __version__
from nctakt.nc.vocabulary.variables import strings
from nctakt.servers.ads.access import ENDPOINT, Access, Missing
from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import AdsError, Command, Error, Group, Port, State
from nctakt.servers.ads.decoder_variables import DecoderVariables
from nctakt.servers.ads.frames import Frame
from nctakt.servers.ads.notifications import Notifier
from nctakt.servers.ads.sums import Part, add_parts, read_parts, write_parts
from nctakt.servers.host import Host, Key
from nctakt.servers.store import Scalar

#: The name of the protocol in log and tape.

#: How long after the answer the first value of a notification comes, in seconds.
FIRST_S = 0.01

_ADDRESS = Struct("<III")
_READ_WRITE = Struct("<IIII")
_NOTIFICATION = Struct("<IIIIII16x")
_NUMBER = Struct("<I")
_RESULT = Struct("<II")
_CONTROL = Struct("<HHI")

#: The future to await if values are missing, or a write is on its way.
Later = Coroutine[Any, Any, bytes]

_PORTS = frozenset(Port)

_KEYS: dict[int, tuple[Key, ...]] = {
    State.RUN: ("go_on", "start"),
    State.START: ("go_on", "start"),
    State.STOP: ("hold",),
    State.RESET: ("reset",),
}


class Service:
    """Answers the requests of all clients; ``notifier``: their notifications."""

    def __init__(self, host: Host, notifier: Notifier) -> None:
        self._host = host
        self.notifier = notifier
        self.access = Access(host, notifier)
        self._variables = DecoderVariables(host)
        self._answers: dict[int, Callable[[Client, Frame], bytes | Later]] = {
            Command.DEVICE_INFO: self._device_info,
            Command.READ: self._read,
            Command.WRITE: self._write,
            Command.READ_STATE: self._read_state,
            Command.WRITE_CONTROL: self._write_control,
            Command.ADD_NOTIFICATION: self._add_notification,
            Command.DELETE_NOTIFICATION: self._delete_notification,
            Command.READ_WRITE: self._read_write,
        }

    def answer(self, client: Client, frame: Frame) -> bytes | Later:
        """Return the data of the answer to a request, or a future for it.

        Raises ``AdsError`` for a request with a wrong header; other mistakes are answers.
        """
        answer = self._answers.get(frame.command)
        if answer is None:
            raise AdsError(Error.COMMAND_UNKNOWN, f"command {frame.command}")
        if frame.target_port not in _PORTS:
            raise AdsError(Error.PORT_UNKNOWN, f"port {frame.target_port}")
        try:
            return answer(client, frame)
        except AdsError as error:
            return self._refused(client, frame.command, error)
        except Missing as missing:
            return self._after_subscribing(client, frame, missing.names)

    def _refused(self, client: Client, command: int, error: AdsError) -> bytes:
        self.access.log_refusal(client, error)
        has_length = command in (Command.READ, Command.READ_WRITE, Command.ADD_NOTIFICATION)
        return _RESULT.pack(error.code, 0) if has_length else _NUMBER.pack(error.code)

    async def _after_subscribing(self, client: Client, frame: Frame, names: Iterable[str]) -> bytes:
        """Wait until the values of a request are available, then answer it."""
        try:
            answer = await self.access.fetch(names, partial(self.answer, client, frame))
        except AdsError as error:
            return self._refused(client, frame.command, error)
        return answer if isinstance(answer, bytes) else await answer

    # --- device ---------------------------------------------------------------------------------

    def _device_info(self, client: Client, frame: Frame) -> bytes:
        major, minor, *_ = (*(int(part) for part in __version__.split(".")[:2]), 0)
        return pack("<IBBH16s", 0, major, minor, 0, b"nctakt CNC")

    def _read_state(self, client: Client, frame: Frame) -> bytes | Later:
        if frame.target_port in (Port.SYSTEM, Port.PLC):
            return pack("<IHH", 0, State.RUN, 0)
        names = [self._panel(1, name) for name in ("STATE", "FEED_HOLD")]
        self.access.check_present(names)
        state, is_held = (self._host.store.values[name] for name in names)
        found = {2.0: State.ERROR, 3.0: State.RESET}.get(float(state), State.RUN)
        if found is State.RUN and is_held:
            found = State.STOP
        return pack("<IHH", 0, found, int(state))

    def _panel(self, channel: int, name: str) -> str:
        prefix = f"CH{channel}." if len(self._host.machine.channels) > 1 else ""
        return f"{prefix}HLI.{name}"

    def _write_control(self, client: Client, frame: Frame) -> bytes | Later:
        if len(frame.data) < _CONTROL.size:
            raise AdsError(Error.SIZE, "write control is too short")
        state, channel, size = _CONTROL.unpack_from(frame.data)
        keys = _KEYS.get(state)
        if (keys is None and state != State.LOAD) or frame.target_port == Port.SYSTEM:
            raise AdsError(Error.PARAMETER, f"state {state} cannot be commanded")
        count = len(self._host.machine.channels)
        if channel > count:
            raise AdsError(Error.PARAMETER, f"there is no channel {channel}")
        if keys is None:
            data = frame.data[_CONTROL.size :]
            if size != len(data):
                raise AdsError(Error.SIZE, f"{len(data)} bytes for {size}")
            return self._select(client, strings.decode(data), max(channel, 1))
        channels = [channel] if channel else list(range(1, count + 1))
        return self._press(client, keys, channels)

    async def _press(self, client: Client, keys: tuple[Key, ...], channels: list[int]) -> bytes:
        values: dict[str, Scalar] = {}
        for channel in channels:
            for key in keys:
                values.update(self._host.key_value(key, channel))
        return _NUMBER.pack(await self.access.write_values(client, values))

    async def _select(self, client: Client, program: str, channel: int) -> bytes:
        """Select a program file; one that is refused is logged with the reason."""
        try:
            await self._host.select(program, channel, ENDPOINT, client.name)
        except Failure:
            return _NUMBER.pack(Error.PARAMETER)
        return _NUMBER.pack(0)

    # --- reading --------------------------------------------------------------------------------

    def _read(self, client: Client, frame: Frame) -> bytes:
        try:
            group, offset, size = _ADDRESS.unpack(frame.data)
        except StructError:
            raise AdsError(Error.SIZE, "a read is 12 bytes") from None
        data = self.access.read(client, group, offset, size)
        return _RESULT.pack(0, len(data)) + data

    # --- writing --------------------------------------------------------------------------------

    def _write(self, client: Client, frame: Frame) -> bytes | Later:
        data = frame.data
        if len(data) < _ADDRESS.size:
            raise AdsError(Error.SIZE, "a write has at least 12 bytes")
        group, offset, size = _ADDRESS.unpack_from(data)
        data = data[_ADDRESS.size :]
        if size != len(data):
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {size}")
        if self._variables.writes(group, offset):
            return self._variable_write(client, group, offset, data)
        values = self.access.decode(client, group, offset, data)
        return self._written(client, values) if values else _NUMBER.pack(0)

    async def _variable_write(self, client: Client, group: int, offset: int, data: bytes) -> bytes:
        try:
            values = self._variables.decode(group, offset, data)
        except AdsError as error:
            return self._refused(client, Command.WRITE, error)
        return await self._written(client, values)

    async def _written(self, client: Client, values: dict[str, Scalar]) -> bytes:
        return _NUMBER.pack(await self.access.write_values(client, values))

    # --- reading and writing --------------------------------------------------------------------

    def _read_write(self, client: Client, frame: Frame) -> bytes | Later:
        if len(frame.data) < _READ_WRITE.size:
            raise AdsError(Error.SIZE, "a read-write has at least 16 bytes")
        group, offset, size, length = _READ_WRITE.unpack_from(frame.data)
        data = frame.data[_READ_WRITE.size :]
        if length != len(data):
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {length}")
        match group:
            case Group.SUM_READ | Group.SUM_READ_EX | Group.SUM_READ_EX_2:
                answer = read_parts(self.access, client, group, offset, data)
                return self._result(answer, len(answer) if group != Group.SUM_READ else size)
            case Group.SUM_WRITE:
                return self._later(client, size, write_parts(self.access, client, offset, data))
            case Group.SUM_READ_WRITE:
                parts = Part.read_writes(offset, data)
                return self._later(client, size, self._read_write_parts(client, parts))
            case Group.SUM_ADD_NOTIFICATION | Group.SUM_DELETE_NOTIFICATION:
                added = add_parts(self.access, client, frame, group, offset, data)
                return self._later(client, size, added)
        if self._variables.answers(group, offset):
            return self._later(client, size, self._variables.answer(group, offset, data))
        return self._result(self.access.read_write(client, group, offset, size, data), size)

    async def _later(self, client: Client, size: int, answer: Coroutine[Any, Any, bytes]) -> bytes:
        try:
            return self._result(await answer, size)
        except AdsError as error:
            return self._refused(client, Command.READ_WRITE, error)

    def _result(self, data: bytes, size: int) -> bytes:
        if len(data) > size:
            raise AdsError(Error.SIZE, f"{size} bytes are too few for {len(data)}")
        return _RESULT.pack(0, len(data)) + data

    async def _read_write_parts(self, client: Client, parts: list[Part]) -> bytes:
        """Return the answers to the parts of a sum command, each with its own error."""
        heads, bodies = [], []
        for part in parts:
            try:
                if self._variables.answers(part.group, part.offset):
                    data = await self._variables.answer(part.group, part.offset, part.data)
                else:
                    data = await self.access.present(partial(self.access.read_write, client, *part))
                if len(data) > part.size:
                    raise AdsError(Error.SIZE, f"{part.size} bytes are too few")
                heads.append(_RESULT.pack(0, len(data)))
                bodies.append(data)
            except AdsError as error:
                self.access.log_refusal(client, error)
                heads.append(_RESULT.pack(error.code, 0))
        return b"".join((*heads, *bodies))

    # --- notifications --------------------------------------------------------------------------

    def _add_notification(self, client: Client, frame: Frame) -> bytes:
        handle = self.access.notify(client, frame, frame.data)
        return _RESULT.pack(0, handle)

    def begin_notifications(self, client: Client) -> None:
        """Send the first values of new notifications after the answer with the handles.

        A moment later: clients take a notification only once they have read its handle.
        """
        handles, client.begins = client.begins, []
        if handles:
            self._host.loop.call_later(FIRST_S, self._begin, client, handles)

    def _begin(self, client: Client, handles: list[int]) -> None:
        for handle in handles:
            self.notifier.begin(client, handle, self._host.store.values, self._host.store.tick)

    def _delete_notification(self, client: Client, frame: Frame) -> bytes:
        if len(frame.data) != _NUMBER.size:
            raise AdsError(Error.SIZE, "a handle is 4 bytes")
        self.notifier.delete(client, *_NUMBER.unpack(frame.data))
        return _NUMBER.pack(0)

    def forget(self, client: Client) -> None:
        """Forget a client: its notifications end."""
        self.notifier.forget(client)
        client.handles.clear()
