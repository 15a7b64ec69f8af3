# SPDX-License-Identifier: MIT
"""Access of a client: values at addresses, names, handles, notifications (AD-3, AD-4).

In: a client, group, offset, data. Out: bytes from the latest values, values to write. Mistakes
raise ``AdsError``, values not available yet ``Missing``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from struct import Struct, pack
from typing import TypeVar

from nctakt.base.failure import Failure, error_text
from nctakt.nc.vocabulary.variables import strings
from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import AdsError, Error, Group, State, Transmission
from nctakt.servers.ads.data import Fixed, Readable
from nctakt.servers.ads.frames import Frame
from nctakt.servers.ads.limits import MAX_ANSWER
from nctakt.servers.ads.notifications import Notifier
from nctakt.servers.ads.object_values import STATE_VIEW, TICK
from nctakt.servers.ads.objects import ADDRESS, Objects
from nctakt.servers.ads.symbols import SymbolTable
from nctakt.servers.ads.uploads import Uploads, handle_description, symbol_entry, type_entry
from nctakt.servers.host import Busy, Host
from nctakt.servers.store import Scalar

_T = TypeVar("_T")

#: The name of the protocol in log and tape.
ENDPOINT = "ads"

_ADDRESS = Struct("<III")
_NOTIFICATION = Struct("<IIIIII16x")
_NUMBER = Struct("<I")
_RESULT = Struct("<II")


#: Constants of a running server: version of the symbols; its state, running.
_CONSTANT: dict[int, bytes] = {Group.VERSION: b"\1", Group.DEVICE_DATA: pack("<HH", State.RUN, 0)}


#: G53 has no zero offset; G54 … G59 are the groups 1 … 6.
_NO_ZERO_OFFSET, _ZERO_OFFSETS = 53, range(53, 60)


class Missing(Exception):
    """Values that are not here yet; ``names``: theirs."""

    def __init__(self, names: Iterable[str]) -> None:
        super().__init__()
        self.names = tuple(names)


class Access:
    """Symbols, objects and notifications of one machine, for all clients."""

    def __init__(self, host: Host, notifier: Notifier) -> None:
        self._host = host
        self.notifier = notifier
        self.symbols = SymbolTable(host.machine, host.catalogue, host.programs)
        self.objects = Objects(host.catalogue, self.symbols.interface.areas)
        self._uploads = Uploads(self.symbols)
        self._once: Mapping[str, Scalar] | None = None
        self._infos: dict[int, Callable[[], bytes]] = {
            Group.UPLOAD: lambda: self._uploads.symbols,
            Group.UPLOAD_INFO: self._uploads.info,
            Group.UPLOAD_INFO_2: self._uploads.info_2,
            Group.TYPE_UPLOAD: lambda: self._uploads.types,
        }

    def log_refusal(self, client: Client, error: AdsError) -> None:
        """Log a refusal."""
        name = f"{error.code.value:#x} {error.kind}"
        self._host.log.refuse(ENDPOINT, client.name, name, detail=error.reason)

    # --- reading ---------------------------------------------------------------------------------

    def read(self, client: Client, group: int, offset: int, size: int) -> bytes:
        """Return the bytes that a client reads; raises ``AdsError`` and ``Missing``."""
        info = self._infos.get(group)
        if info is not None:
            data = info()
            if len(data) > size:
                raise AdsError(Error.SIZE, f"{size} bytes are too few for {len(data)}")
            return data
        if size > MAX_ANSWER:
            raise AdsError(Error.SIZE, f"{size} bytes")
        return self.value(self.resolve(client, group, offset, size))

    async def fetch(self, names: Iterable[str], read: Callable[[], _T]) -> _T:
        """Return a reader of values that were missing and are now available.

        Where too many are borrowed they are here for this once. Raises ``AdsError``.
        """
        store = self._host.store
        viewed = [name for name in names if name.startswith(STATE_VIEW)]
        try:
            if viewed:
                return await self._view_once([*names], read)
            if store.can_borrow(names):
                await store.subscribe(names, is_borrowing=True)
                return read()
            listed = list(names)
            values = await self._host.ask(self._host.session.read, *listed)
        except Failure as failure:
            raise AdsError(Error.NOT_READY, error_text(failure)) from failure
        self._once = {**store.values, **dict(zip(listed, values, strict=True))}
        try:
            return read()
        finally:
            self._once = None

    async def _view_once(self, names: Sequence[str], read: Callable[[], _T]) -> _T:
        """Return a reader of values without a signal, and of others, all of the same tick."""
        signals = [name for name in names if not name.startswith(STATE_VIEW)]
        state_view = await self._host.ask(self._host.session.state_view, *signals)
        found: dict[str, Scalar] = dict(zip(signals, state_view.values, strict=True))
        found[TICK] = float(state_view.tick)
        for number, channel in enumerate(state_view.channels, 1):
            in_force = channel.in_force
            found[f"{STATE_VIEW}{number}.feed"] = 1000.0 * channel.programmed_mm_s
            found[f"{STATE_VIEW}{number}.tool"] = float(0 if in_force is None else in_force.tool)
            function = _NO_ZERO_OFFSET if in_force is None else in_force.zero_offset
            if function in _ZERO_OFFSETS:
                found[f"{STATE_VIEW}{number}.zero_offset"] = float(function - _NO_ZERO_OFFSET)
        self._once = {**self._host.store.values, **found}
        try:
            return read()
        except Missing:  # of G159 only the function is known
            raise AdsError(Error.SERVICE, "the group that G159 has selected is not known") from None
        finally:
            self._once = None

    @property
    def _values(self) -> Mapping[str, Scalar]:
        return self._host.store.values if self._once is None else self._once

    async def release(self) -> None:
        """Release values that were not read for a while and that no notification sends."""
        read = dict.fromkeys(
            name for item in self.symbols.used_items() for name in item.names
        )  # called once: each call returns what was read since the last

        def used() -> Iterable[str]:
            sent = (name for item in self.notifier.items() for name in item.names)
            return {**read, **dict.fromkeys(sent)}

        await self._host.store.keep_borrowed(used)

    def value(self, item: Readable) -> bytes:
        """Return the bytes of values; raises ``Missing``."""
        try:
            return item.read(self._values)
        except KeyError:
            raise Missing(item.names) from None

    def check_present(self, names: Iterable[str]) -> None:
        """Raise ``Missing`` unless all values are here."""
        absent = [name for name in names if name not in self._values]
        if absent:
            raise Missing(absent)

    def resolve(self, client: Client, group: int, offset: int, size: int) -> Readable:
        """Return the item at an address; raises ``AdsError``."""
        if group == Group.VALUE_BY_HANDLE:
            symbol = client.symbol(offset)
            group, offset = symbol.group, symbol.offset
            size = min(size, symbol.type.size_bytes)
        if self.symbols.has_group(group):
            return self.symbols.item(group, offset, size)
        if self.objects.has_group(group):
            item = self.objects.item(group, offset, size)
            if size < item.size_bytes:
                raise AdsError(Error.SIZE, f"{size} bytes are too few for {item.size_bytes}")
            return item
        data = _CONSTANT.get(group)
        if data is None:
            raise AdsError(Error.GROUP, f"group {group:#x}")
        if not data[offset : offset + size]:
            raise AdsError(Error.OFFSET, f"nothing begins at {group:#x}, {offset:#x}")
        return Fixed(data[offset : offset + size])

    async def present(self, read: Callable[[], _T]) -> _T:
        """Return a reader of values, once they are available; raises ``AdsError``."""
        try:
            return read()
        except Missing as missing:
            names = missing.names
        return await self.fetch(names, read)

    def read_write(self, client: Client, group: int, offset: int, size: int, data: bytes) -> bytes:
        """Return the answer to a request with data; raises ``AdsError`` and ``Missing``."""
        match group:
            case Group.HANDLE_BY_NAME:
                symbol = self.symbols.find(_name(data))
                handle = _NUMBER.pack(client.open_handle(symbol))
                described = handle + handle_description(symbol)
                return described if len(described) <= size else handle
            case Group.VALUE_BY_NAME:
                symbol = self.symbols.find(_name(data))
                item = self.symbols.item(symbol.group, symbol.offset, symbol.type.size_bytes)
                return self.value(item)
            case Group.INFO_BY_NAME:
                symbol = self.symbols.find(_name(data))
                return _ADDRESS.pack(symbol.group, symbol.offset, symbol.type.size_bytes)
            case Group.INFO_BY_NAME_EX:
                return symbol_entry(self.symbols.find(_name(data)))[:size]
            case Group.TYPE_BY_NAME:
                return type_entry(self.symbols.find_type(_name(data)))
        if self.objects.has_group(group) and self.objects.attribute_of(group) == ADDRESS:
            if len(data) != 8:
                raise AdsError(Error.SIZE, "channel and axis are 8 bytes")
            channel, axis = _RESULT.unpack(data)
            return _RESULT.pack(*self.objects.address(group, offset, channel, axis))
        if not data:
            return self.read(client, group, offset, size)
        raise AdsError(Error.GROUP, f"group {group:#x}")

    # --- writing --------------------------------------------------------------------------------

    def decode(self, client: Client, group: int, offset: int, data: bytes) -> dict[str, Scalar]:
        """Return the values that a client writes; a handle is released. Raises ``AdsError``."""
        if group == Group.RELEASE_HANDLE:
            if len(data) != _NUMBER.size:
                raise AdsError(Error.SIZE, "a handle is 4 bytes")
            client.release(*_NUMBER.unpack(data))
            return {}
        if group == Group.VALUE_BY_HANDLE:
            symbol = client.symbol(offset)
            group, offset = symbol.group, symbol.offset
        if self.symbols.has_group(group):
            data = self.symbols.padded(group, offset, data)
        if self.objects.has_group(group):  # each knows which lengths it takes
            return self.objects.item(group, offset, len(data)).write(data)
        return self.resolve(client, group, offset, len(data)).write(data)

    async def write_values(self, client: Client, values: dict[str, Scalar]) -> Error:
        """Write values; return once a tick has latched them, or why they are refused."""
        try:
            tick = await self._host.write(values, ENDPOINT, client.name)
        except Busy:
            return Error.BUSY
        except Failure:
            return Error.PARAMETER
        await self._host.latched(tick)
        return Error.NONE

    # --- notifications --------------------------------------------------------------------------

    def notify(self, client: Client, frame: Frame, data: bytes) -> int:
        """Add a notification; return its handle. Raises as ``read``."""
        if len(data) != _NOTIFICATION.size:
            raise AdsError(Error.SIZE, f"a notification is {_NOTIFICATION.size} bytes")
        group, offset, size, mode, _, cycle = _NOTIFICATION.unpack(data)
        if mode not in frozenset(Transmission):
            raise AdsError(Error.PARAMETER, f"transmission {mode}")
        item = self.resolve(client, group, offset, size)
        if any(name.startswith(STATE_VIEW) for name in item.names):
            raise AdsError(Error.SERVICE, "what no signal tells is read, and not notified")
        self.value(item)
        handle = self.notifier.add(
            client,
            item,
            (frame.target_id, frame.target_port),
            cycle_units=cycle,
            sends_changes=mode in (Transmission.ON_CHANGE, Transmission.CLIENT_ON_CHANGE),
        )
        client.begins.append(handle)
        return handle


def _name(data: bytes) -> str:
    """Return the name in bytes, with or without its zero byte."""
    return strings.decode(data).strip()
