# SPDX-License-Identifier: MIT
"""The past of signals for clients: between two times, or at certain times.

In: requests with times, which are those of ticks. Out: values, a limited number in one answer for
all its nodes; the rest by continuation points. The session reruns its past for it, in short parts
with the requests of other clients between them, and does not move.
"""

from __future__ import annotations

import asyncio
import json
from datetime import UTC, datetime
from typing import Any

from asyncua import ua

from nctakt.base.failure import Failure
from nctakt.servers.host import Host
from nctakt.servers.opcua.library import ServiceError
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.values import Live


class History:
    """Answers requests for the past."""

    def __init__(self, space: LiveSpace, host: Host, limits: Limits) -> None:
        self._space = space
        self._host = host
        self._limits = limits
        self._turn = asyncio.Lock()

    async def read(self, params: ua.HistoryReadParameters) -> list[ua.HistoryReadResult]:
        """Return the past of each node of a request; raises ``ServiceError`` for too many nodes."""
        details = params.HistoryReadDetails
        if len(params.NodesToRead or ()) > self._limits.history_nodes:
            raise ServiceError(ua.StatusCodes.BadTooManyOperations)
        results = []
        left = self._limits.history_rows
        for request in params.NodesToRead or ():
            result = ua.HistoryReadResult()
            try:
                status = await self._read_one(details, request, left, result)
                if isinstance(result.HistoryData, ua.HistoryData):
                    left -= len(result.HistoryData.DataValues)
            except Failure:
                status = int(ua.StatusCodes.BadNoData)
            result.StatusCode = ua.StatusCode(status)
            results.append(result)
        return results

    async def _read_one(self, details: Any, request: Any, left: int, result: Any) -> int:
        """Read the past of a node, ``left`` values at most; return the status."""
        codes = ua.StatusCodes
        live = self._space.live.get(request.NodeId)
        if live is None or not live.signal:
            known = request.NodeId in self._space.space
            return int(codes.BadHistoryOperationUnsupported if known else codes.BadNodeIdUnknown)
        if request.IndexRange:
            return int(codes.BadIndexRangeInvalid)
        if isinstance(details, ua.ReadRawModifiedDetails) and not details.IsReadModified:
            return await self._raw(details, request.ContinuationPoint, live, left, result)
        if isinstance(details, ua.ReadAtTimeDetails):
            return await self._at_times(details.ReqTimes or [], live, left, result)
        return int(codes.BadHistoryOperationUnsupported)

    # --- between two times ----------------------------------------------------------------------

    async def _raw(
        self, details: Any, point: bytes | None, live: Live, left: int, result: Any
    ) -> int:
        codes = ua.StatusCodes
        latest = max(0, self._host.session.tick)
        begin, end = _given(details.StartTime), _given(details.EndTime)
        if sum(one is None for one in (begin, end)) + (not details.NumValuesPerNode) > 1:
            return int(codes.BadInvalidTimestampArgument)
        is_backward = begin is None or (end is not None and end < begin)
        early, late = (end, begin) if is_backward else (begin, end)
        clock = self._space.clock
        first = None if early is None else clock.tick_at(early)
        last = None if late is None else clock.tick_at(late, is_end=True)
        low = max(0, 0 if first is None else first)
        high = min(latest, latest if last is None else last + 1)
        if point:
            try:
                low, high = _point(point, low, high)
            except ValueError:
                return int(codes.BadContinuationPointInvalid)
        count = min(details.NumValuesPerNode or left, left, high - low)
        if low >= high:
            result.HistoryData = ua.HistoryData()
            return int(codes.GoodNoData)
        if is_backward:
            part, rest = (high - count, high), (low, high - count)
        else:
            part, rest = (low, low + count), (low + count, high)
        values = await self._look(live, *part)
        if is_backward:
            values.reverse()
        data = ua.HistoryData()
        data.DataValues = values
        result.HistoryData = data
        is_enough = details.NumValuesPerNode and count >= details.NumValuesPerNode
        if rest[0] < rest[1] and not is_enough:
            result.ContinuationPoint = json.dumps(rest).encode()
        return 0

    async def _look(self, live: Live, first: int, end: int) -> list[ua.DataValue]:
        """Return the values after the ticks of a stretch, one for each tick.

        At most one part of all requests waits for the session: a write comes before the next one.
        """
        look, step = self._host.session.look, self._limits.history_part
        values: list[ua.DataValue] = []
        for begin in range(first, end, step):
            stop = min(end, begin + step)
            async with self._turn:
                every, cells = await self._host.ask(look, begin, stop, [live.signal], stop - begin)
            values += [
                self._value(live, float(cell), begin + index * every)
                for index, cell in enumerate(cells)
            ]
        return values

    def _value(self, live: Live, number: float, tick: int) -> ua.DataValue:
        moment = self._space.clock.time(tick)
        return ua.DataValue(
            Value=ua.Variant(live.cast(number * live.factor), live.kind),
            StatusCode=ua.StatusCode(),
            SourceTimestamp=moment,
            ServerTimestamp=moment,
        )

    # --- at certain times -----------------------------------------------------------------------

    async def _at_times(self, times: list[datetime], live: Live, left: int, result: Any) -> int:
        if len(times) > left:
            return int(ua.StatusCodes.BadTooManyOperations)
        latest = self._host.session.tick
        data = ua.HistoryData()
        for moment in times:
            given = _given(moment)
            tick = -1 if given is None else self._space.clock.tick_at(given)
            if not 0 <= tick < latest:
                status = ua.StatusCode(ua.StatusCodes.BadNoData)
                data.DataValues.append(ua.DataValue(StatusCode=status, SourceTimestamp=moment))
            else:
                data.DataValues += await self._look(live, tick, tick + 1)
        result.HistoryData = data
        return 0


def _given(moment: datetime | None) -> datetime | None:
    """Return a time of a request with its zone; ``None`` for one that is not given."""
    if moment is None or moment.year <= 1601:
        return None
    return moment if moment.tzinfo is not None else moment.replace(tzinfo=UTC)


def _point(content: bytes, low: int, high: int) -> tuple[int, int]:
    """Return the stretch of a continuation point; raises ``ValueError`` if it is not one."""
    found = json.loads(content)
    fits = isinstance(found, list) and len(found) == 2 and all(type(one) is int for one in found)
    if not fits or not low <= found[0] <= found[1] <= high:
        raise ValueError(content)
    return found[0], found[1]
