# SPDX-License-Identifier: MIT
"""The values of a session's nodes, shared by all clients, whether monitored or read once.

In: frames of the host's store, answers of the session. Out: samples and data values. Only monitored
names are subscribed; values that are only read are requested at that moment.
"""

from __future__ import annotations

import asyncio
import struct
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from asyncua import ua

from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure, error_text
from nctakt.servers.clock import MachineClock
from nctakt.servers.host import Host
from nctakt.servers.opcua.clients.publishing import now_units
from nctakt.servers.opcua.library import AddressSpace, variant_to_binary
from nctakt.servers.opcua.values import Live, Sample, ValueSnapshot
from nctakt.session.listening import Frame

#: Maximum age of the data about realtime cycles and channels, in seconds.
_VIEW_AGE_S = 0.02

#: Ticks whose blocks are remembered: frames that come during a request to the session.
_REMEMBERED = 1000

#: How long values still come after the last client has stopped watching them, in seconds.
_RELEASE_S = 1.0


class LiveSpace:
    """The address space with those nodes whose values are the session's; ``live``: by their IDs."""

    def __init__(self, space: AddressSpace, host: Host, clock: MachineClock) -> None:
        self.space = space
        self.clock = clock
        self.live: dict[ua.NodeId, Live] = {}
        self._host = host
        self._watched: dict[int, tuple[Live, int]] = {}
        self._latest = ValueSnapshot(0, {}, {})
        self._viewed = ValueSnapshot(0, {}, {})
        self._viewed_s = -1.0
        self._blocks: deque[tuple[int, Mapping[int, Span]]] = deque(maxlen=_REMEMBERED)
        host.store.listen(self._remember)
        self._asking: asyncio.Task[None] | None = None
        self._unheld: list[str] = []
        self._releasing: asyncio.Task[None] | None = None

    def add(self, node: ua.NodeId, live: Live) -> None:
        """Let a node show a value of the session."""
        self.live[node] = live

    def remove(self, node: ua.NodeId) -> None:
        """Remove a node."""
        self.live.pop(node, None)

    # --- monitored values -----------------------------------------------------------------------

    async def watch(self, lives: Sequence[Live]) -> ValueSnapshot:
        """Subscribe the values of these nodes for one more watcher.

        Return a moment that has them.
        """
        names: list[str] = []
        for live in lives:
            count = self._watched.get(id(live), (live, 0))[1]
            self._watched[id(live)] = live, count + 1
            if count == 0:
                names += live.names
        try:
            await self._host.store.hold(names)
        except Failure as failure:
            self.report(failure)
        return await self.refresh(lives)

    def unwatch(self, live: Live) -> None:
        """Remove one watcher of a node."""
        _, count = self._watched.get(id(live), (live, 0))
        if count > 1:
            self._watched[id(live)] = live, count - 1
        elif self._watched.pop(id(live), None) is not None:
            self._unheld += live.names
            if self._releasing is None:
                self._releasing = asyncio.get_running_loop().create_task(self._release())

    async def _release(self) -> None:
        """Unsubscribe unwatched values: all at once, a little later."""
        await asyncio.sleep(_RELEASE_S)
        self._releasing = None
        names, self._unheld = self._unheld, []
        try:
            await self._host.store.release(names)
        except Failure as failure:
            self.report(failure)

    def _remember(self, frame: Frame) -> None:
        self._blocks.append((frame.tick, frame.blocks))

    async def refresh(self, lives: Sequence[Live]) -> ValueSnapshot:
        """Return a moment for nodes that somebody watches.

        It is the latest; if cycles and channels are needed, that of their latest request.
        """
        store = self._host.store
        if not any(live.needs_state_view for live in lives):
            if store.values is not self._latest.values or store.tick != self._latest.tick:
                blocks = {} if store.frame is None else store.frame.blocks
                self._latest = ValueSnapshot(store.tick, store.values, blocks)
            return self._latest
        loop = asyncio.get_running_loop()
        for _ in range(2):  # the second time for nodes that were not yet watched the first time
            is_fresh = loop.time() - self._viewed_s < _VIEW_AGE_S
            values = self._viewed.values
            if is_fresh and all(name in values for live in lives for name in live.names):
                break
            if self._asking is None:
                self._asking = loop.create_task(self._request_view())
            await asyncio.shield(self._asking)
        return self._viewed

    async def _request_view(self) -> None:
        names = dict.fromkeys(name for live, _ in self._watched.values() for name in live.names)
        try:
            self._viewed = await self._view_once(names)
        except Failure:
            return  # the session has ended; the last values stay
        finally:
            self._asking = None
        self._viewed_s = asyncio.get_running_loop().time()

    async def _view_once(self, names: Iterable[str]) -> ValueSnapshot:
        """Ask the session for a moment with cycles and channels; raises ``Failure``."""
        asked_for = list(names)
        state_view = await self._host.ask(self._host.session.state_view, *asked_for)
        values = dict(zip(asked_for, state_view.values, strict=True))
        known = (blocks for tick, blocks in reversed(self._blocks) if tick <= state_view.tick)
        return ValueSnapshot(state_view.tick, values, next(known, {}), state_view)

    def sample(self, live: Live, moment: ValueSnapshot) -> Sample:
        """Return the value of a monitored node at a moment."""
        return live.sample(moment, self.clock, now_units())

    def report(self, error: Exception) -> None:
        """Log an error."""
        self._host.log.error("opcua", reason=error_text(error) or repr(error))

    # --- values that are read once --------------------------------------------------------------

    async def read(self, lives: Sequence[Live]) -> ValueSnapshot:
        """Return the moment at which to read these nodes, all of the same tick."""
        names = dict.fromkeys(name for live in lives for name in live.names)
        needs_state_view = any(live.needs_state_view for live in lives)
        try:
            if needs_state_view or not self._host.store.has(names):
                return await self._view_once(names)
        except Failure:
            pass  # the session has ended; what was seen last stays
        return await self.refresh(lives)

    # --- fixed values and attributes ------------------------------------------------------------

    def check_attribute(self, node: ua.NodeId, attribute: int) -> int:
        """Return why an attribute cannot be monitored as a status; 0 if it can."""
        data = self.space.get(node)
        codes = ua.StatusCodes
        if data is None:
            return int(codes.BadNodeIdUnknown)
        found = data.attributes.get(ua.AttributeIds(attribute)) if 0 < attribute < 28 else None
        if found is None:
            return int(codes.BadAttributeIdInvalid)
        if attribute == ua.AttributeIds.EventNotifier:
            notifier = found.value.Value.Value if found.value is not None else 0
            return 0 if notifier & 1 else int(codes.BadNotSupported)
        return 0

    def fixed_sample(self, node: ua.NodeId, attribute: int) -> Sample:
        """Return the value of an attribute that is not the session's."""
        shown = self.space.read_attribute_value(node, ua.AttributeIds(attribute))
        return sample_of(shown, now_units())


def sample_of(shown: Any, time_units: int) -> Sample:
    """Return a data value of the library as a sample."""
    status = int(shown.StatusCode.value) if shown.StatusCode is not None else 0
    times = struct.pack("<qq", time_units, time_units)
    if shown.Value is None:
        wire = b"\x0e" + struct.pack("<I", status) + times
        return Sample(None, status, b"", wire)
    content = bytes(variant_to_binary(shown.Value))
    return Sample(
        shown.Value.Value, status, content, b"\x0f" + content + struct.pack("<I", status) + times
    )
