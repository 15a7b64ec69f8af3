# SPDX-License-Identifier: MIT
"""Clients that break rules of OPC UA, vanish, or read nothing: the others and the session go on."""

from __future__ import annotations

import asyncio
import contextlib
import os
import random
import socket
import struct
import time
from dataclasses import replace
from datetime import timedelta
from typing import ClassVar

import pytest
from support.insides import is_writing, send_unasked

pytest.importorskip("asyncua", reason="needs the extra [opcua]")

from asyncua import ua
from support.opcua_client import patient_client
from support.served import Served, until

from nctakt.base.failure import Failure
from nctakt.servers.notices import ServerNotice
from nctakt.servers.opcua.alarms import notice_text
from nctakt.servers.opcua.clients.monitoring import Item
from nctakt.servers.opcua.clients.security import MAX_FAILURES, PASSWORD, Security
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.model.companion import BINARY_SCHEMA
from nctakt.servers.opcua.values import Sample

pytestmark = pytest.mark.slow

CHANNEL = "ns=3;s=CncChannelList.1"

#: Broken conversations; 10,000 by NCTAKT_SEEDS.
SEEDS = int(os.environ.get("NCTAKT_SEEDS", "150"))


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """A server with small limits, whose session runs at the speed of the clock."""
    limits = Limits(
        connections=30,
        sessions=8,
        subscriptions=14,
        subscriptions_per_session=3,
        items_per_subscription=20,
        message_bytes=1 << 20,
        unsent_bytes=1 << 16,
        nodes_per_call=200,
        activation_s=1.0,
        history_nodes=5,
        history_rows=100,
        history_part=10,
    )
    one = Served(tmp_path_factory.mktemp("served"), limits=limits)
    one.session.play(1.0)
    yield one
    one.close()


@contextlib.asynccontextmanager
async def connected(served):
    """A client with its session, once there is room for one more."""

    async def connect():
        with contextlib.suppress(ua.UaError, OSError, asyncio.TimeoutError):
            client = patient_client(served.url)
            await client.connect()
            return client
        return None

    client = await until(connect)
    try:
        yield client
    finally:
        with contextlib.suppress(Exception):
            await client.disconnect()


async def is_well(served):
    """Let a new client read, and the session go on."""
    async with connected(served) as client:
        node = client.get_node(f"{CHANNEL}.Id")
        assert await node.read_value() == 1
    tick = served.session.tick
    await until(lambda: served.session.tick > tick)
    assert served.session.is_playing


async def raw(served):
    """Return reader and writer of a bare connection."""
    host, _, port = served.url.removeprefix("opc.tcp://").rstrip("/").rpartition(":")
    return await asyncio.open_connection(host, int(port))


def hello(served):
    """A Hello as the library writes it."""
    url = served.url.encode()
    body = struct.pack("<IIIIII", 0, 65535, 65535, 0, 0, len(url)) + url
    return b"HELF" + struct.pack("<I", 8 + len(body)) + body


def open_channel():
    """An OpenSecureChannel without security, as it is defined."""
    policy = b"http://opcfoundation.org/UA/SecurityPolicy#None"
    head = struct.pack("<I", 0) + struct.pack("<i", len(policy)) + policy
    head += struct.pack("<ii", -1, -1) + struct.pack("<II", 1, 1)
    request = struct.pack("<BBH", 1, 0, 446) + b"\0\0" + struct.pack("<qII", 0, 1, 0)
    request += struct.pack("<i", -1) + struct.pack("<I", 0) + b"\0\0\0"
    request += struct.pack("<IIIi", 0, 0, 1, -1) + struct.pack("<I", 60000)
    body = head + request
    return b"OPNF" + struct.pack("<I", 8 + len(body)) + body


async def send(served, content):
    """Send bytes; return what the server answers until it is silent or closes."""
    reader, writer = await raw(served)
    answer = b""
    with contextlib.suppress(OSError, asyncio.TimeoutError):
        writer.write(content)
        await writer.drain()
        answer = await asyncio.wait_for(reader.read(4096), 0.2)
    writer.close()
    return answer


@pytest.mark.nightly
def test_broken_messages_do_no_harm(served):
    """Truncated, flipped, random bytes; lengths up to 2^32."""
    conversation = hello(served) + open_channel()
    chance = random.Random(1)

    def broken(index):
        content = bytearray(conversation)
        kind = index % 4
        if kind == 0:
            return bytes(content[: chance.randrange(len(content))])
        if kind == 1:
            for _ in range(chance.randrange(1, 9)):
                content[chance.randrange(len(content))] ^= 1 << chance.randrange(8)
        elif kind == 2:
            at = chance.randrange(len(content) - 4)
            content[at : at + 4] = struct.pack("<I", chance.choice((0, 7, 8, 1 << 31, 0xFFFFFFFF)))
        else:
            content = bytearray(chance.randbytes(chance.randrange(1, 400)))
        return bytes(content)

    async def work():
        assert (await send(served, hello(served))).startswith(b"ACKF")
        for first in range(0, SEEDS, 10):
            await asyncio.gather(*(send(served, broken(first + one)) for one in range(10)))
        await is_well(served)

    asyncio.run(work())
    assert served.refusals()


def test_a_storm_of_connections_and_idle_ones(served):
    """More than the limit are closed; those that open no session are closed after a while."""

    async def work():
        async with connected(served) as client:
            storm = [asyncio.create_task(raw(served)) for _ in range(60)]
            pairs = [pair for pair in await asyncio.gather(*storm)]
            assert await client.get_node(f"{CHANNEL}.Id").read_value() == 1
            for reader, _ in pairs:
                assert await asyncio.wait_for(reader.read(1), 20) == b""
            for _, writer in pairs:
                writer.close()
        await is_well(served)

    asyncio.run(work())
    assert any("connections" in reason for reason in served.refusals())


def test_limits_of_sessions_subscriptions_and_items_are_reported(served):
    """Each by its status; what is there already goes on."""

    async def work():
        async with connected(served) as client:
            subscriptions = [await client.create_subscription(50, None) for _ in range(3)]
            with pytest.raises(ua.uaerrors.BadTooManySubscriptions):
                await client.create_subscription(50, None)
            node = client.get_node(f"{CHANNEL}.Signals.BLOCK")
            items = await subscriptions[0].subscribe_data_change([node] * 25)
            refused = [one for one in items if isinstance(one, ua.StatusCode)]
            assert [one.name for one in refused] == ["BadTooManyMonitoredItems"] * 5
            with pytest.raises(ua.uaerrors.BadTooManyOperations):
                await client.read_values([node] * 201)
            clients = []
            with pytest.raises((ua.uaerrors.BadTooManySessions, ConnectionError)):
                for _ in range(9):
                    clients.append(patient_client(served.url))
                    await clients[-1].connect()
            for one in clients:
                with contextlib.suppress(Exception):
                    await one.disconnect()
            assert await node.read_value() is not None
        await is_well(served)

    asyncio.run(work())


def test_who_has_vanished_makes_room(served):
    """Sessions that wait for their clients go where others need their places, the oldest first."""

    async def vanish(number):
        client = patient_client(served.url)
        await client.connect()
        await client.create_subscription(50, None)
        session = served.endpoint.server.iserver.client_sessions[-1]
        client.uaclient.protocol.transport.abort()
        with contextlib.suppress(Exception):
            await client.disconnect()
        await until(lambda: session.left_s is not None)
        return session

    async def work():
        server = served.endpoint.server.iserver
        await until(lambda: not server.client_sessions)
        async with connected(served) as client:
            gone = [await vanish(number) for number in range(7)]
            assert len(server.client_sessions) == 8
            others = []
            for _ in range(3):
                others.append(patient_client(served.url))
                await others[-1].connect()  # at once
            assert [one for one in gone if one in server.client_sessions] == gone[3:]
            assert len(served.endpoint.subscriptions.subscriptions) == 4
            assert await client.get_node(f"{CHANNEL}.Id").read_value() == 1
            for other in others:
                await other.disconnect()
            served.host.loop.call_soon_threadsafe(lambda: [server.make_room() for _ in gone])
        await is_well(served)

    asyncio.run(work())
    assert "its connection is gone, and its place was needed" in served.refusals()


def test_who_has_become_silent_makes_room(served, monkeypatch):
    """Eight clients that hold their connections and say nothing: who was silent first goes.

    One that has asked within the time stays, and so do all while it is not over.
    """
    server = served.endpoint.server.iserver

    async def work():
        await until(lambda: not server.client_sessions)
        async with contextlib.AsyncExitStack() as stack:
            silent = [await stack.enter_async_context(connected(served)) for _ in range(8)]
            sessions = list(server.client_sessions)
            newcomer = patient_client(served.url)
            with pytest.raises((ua.uaerrors.BadTooManySessions, ConnectionError)):
                await newcomer.connect()
            monkeypatch.setattr(server, "limits", replace(server.limits, silence_s=0.5))
            for client in silent[1:]:
                await asyncio.sleep(0.1)
                await client.get_node(f"{CHANNEL}.Id").read_value()
            assert await silent[-1].get_node(f"{CHANNEL}.Id").read_value() == 1
            await stack.enter_async_context(connected(served))
            assert sessions[0] not in server.client_sessions
            assert sessions[-1] in server.client_sessions
            with pytest.raises((ua.UaError, ConnectionError)):
                await silent[0].get_node(f"{CHANNEL}.Id").read_value()
        monkeypatch.undo()
        await is_well(served)

    asyncio.run(work())
    assert "its client asks for nothing, and its place was needed" in served.refusals()


def test_a_newcomer_finds_a_subscription_where_others_hold_all(served):
    """The oldest one of the client that has most goes, and that client is informed."""

    class Reported:
        statuses: ClassVar[list] = []

        def status_change_notification(self, status):
            self.statuses.append(status.Status.name)

    async def work():
        held = served.endpoint.subscriptions.subscriptions
        await until(lambda: not held)
        async with contextlib.AsyncExitStack() as stack:
            for count in (3, 3, 3, 3, 2):
                client = await stack.enter_async_context(connected(served))
                for _ in range(count):
                    await client.create_subscription(50, Reported())
            oldest = next(iter(held))
            newcomer = await stack.enter_async_context(connected(served))
            await newcomer.create_subscription(50, Reported())
            assert len(held) == 14
            assert oldest not in held
            await until(lambda: Reported.statuses == ["BadTooManySubscriptions"])
        await is_well(served)

    asyncio.run(work())
    assert "its oldest subscription ends: others have less" in served.refusals()


def test_who_asks_later_learns_that_a_subscription_has_ended(served):
    """A subscription that ends while its client asks for nothing says so at the next request."""

    async def work():
        held = served.endpoint.subscriptions.subscriptions
        await until(lambda: not held)
        async with contextlib.AsyncExitStack() as stack:
            silent = await stack.enter_async_context(connected(served))
            asking = silent.uaclient.session
            asking.ensure_publish_loop = lambda: None
            parameters = ua.CreateSubscriptionParameters(50, 10_000, 5_000, 0, True, 0)
            created = [await asking.create_subscription(parameters, None) for _ in range(3)]
            numbers = [one.SubscriptionId for one in created]
            for count in (2, 2, 2, 2, 2, 1):
                client = await stack.enter_async_context(connected(served))
                for _ in range(count):
                    await client.create_subscription(50, None)
            newcomer = await stack.enter_async_context(connected(served))
            await newcomer.create_subscription(50, None)
            assert numbers[0] not in held
            assert set(numbers[1:]) <= held.keys()
            reported = {}
            for _ in numbers:
                response = (await asking.publish([])).Parameters
                reported[response.SubscriptionId] = [
                    part.Status.name for part in response.NotificationMessage.NotificationData
                ]
            assert reported == {
                numbers[0]: ["BadTooManySubscriptions"],
                numbers[1]: [],
                numbers[2]: [],
            }
        await is_well(served)

    asyncio.run(work())


def test_wrong_items_and_foreign_subscriptions_are_refused(served):
    """Unknown nodes, attributes, filters; the subscription of somebody else."""

    async def work():
        async with connected(served) as client, connected(served) as other:
            subscription = await client.create_subscription(50, None)
            foreign = await other.create_subscription(50, None)

            async def status(node, attribute=13, filter_=None, number=None):
                item = ua.MonitoredItemCreateRequest()
                item.ItemToMonitor = ua.ReadValueId(ua.NodeId.from_string(node), attribute)
                item.RequestedParameters.Filter = filter_
                request = ua.CreateMonitoredItemsParameters()
                request.SubscriptionId = number or subscription.subscription_id
                request.ItemsToCreate = [item]
                (answer,) = await client.uaclient.create_monitored_items(request)
                return answer.StatusCode.name

            assert await status("ns=3;s=nothing") == "BadNodeIdUnknown"
            assert await status(f"{CHANNEL}.Id", 1000) == "BadAttributeIdInvalid"
            assert await status(f"{CHANNEL}", 13) == "BadAttributeIdInvalid"
            deadband = ua.DataChangeFilter(ua.DataChangeTrigger.StatusValue, 1, -1.0)
            name = f"{CHANNEL}.ActFeedrate"
            assert await status(name, filter_=deadband) == "BadDeadbandFilterInvalid"
            assert await status(f"{CHANNEL}.ActProgramName", filter_=deadband) == (
                "BadFilterNotAllowed"
            )
            with pytest.raises(ua.uaerrors.BadSubscriptionIdInvalid):
                await status(name, number=foreign.subscription_id)
        await is_well(served)

    asyncio.run(work())


def test_a_client_that_vanishes_in_a_write_leaves_nothing(served):
    """The write acts or does not; its session and its subscriptions go."""

    async def work():
        for _ in range(5):
            async with connected(served) as client:
                task = asyncio.create_task(client.get_node(f"{CHANNEL}.V.E.VALUE").write_value(1.0))
                await asyncio.sleep(0)
                client.uaclient.protocol.transport.abort()
                with contextlib.suppress(Exception, asyncio.CancelledError):
                    await task
        await is_well(served)
        server = served.endpoint.server.iserver
        await until(lambda: not server.client_sessions)

    asyncio.run(work())


def test_who_reads_nothing_is_disconnected(served):
    """A client that asks and asks without reading holds no memory and no other client."""

    async def work():
        async with connected(served) as client, connected(served) as quick:
            protocol = client.uaclient.protocol
            protocol.transport.pause_reading()
            own = protocol.transport.get_extra_info("socket")
            own.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)  # little waits on the way
            schema = ua.ReadValueId(ua.NodeId(BINARY_SCHEMA, 2), ua.AttributeIds.Value)
            request = ua.ReadRequest()
            request.Parameters.NodesToRead = [schema] * 200  # more than 300 kB in one response
            node = quick.get_node(f"{CHANNEL}.Id")

            async def ask():
                with contextlib.suppress(Exception):
                    send_unasked(protocol, request)
                assert await node.read_value() == 1
                return any("read its responses" in one for one in served.refusals())

            await until(ask, 60)
            protocol.transport.abort()
        await is_well(served)

    asyncio.run(work())


def test_who_asks_for_no_publishing_keeps_the_latest(served):
    """A slow reader's queue has its size, the latest values and a mark; its subscription ends."""

    async def work():
        async with connected(served) as client:
            parameters = ua.CreateSubscriptionParameters(
                RequestedPublishingInterval=10,
                RequestedLifetimeCount=3,
                RequestedMaxKeepAliveCount=1,
                PublishingEnabled=True,
            )
            protocol = client.uaclient.protocol
            request = ua.CreateSubscriptionRequest()
            request.Parameters = parameters
            data = await protocol.send_request(request)
            answer = ua.ua_binary.struct_from_binary(ua.CreateSubscriptionResponse, data)
            number = answer.Parameters.SubscriptionId
            known = served.endpoint.subscriptions.subscriptions
            assert number in known
            await until(lambda: number not in known)
        await is_well(served)

    asyncio.run(work())


def test_a_deadband_lets_a_number_follow_a_value_that_is_none():
    """The distance to a value that is no number is not within any deadband."""
    item = Item(1, 1, ua.NodeId(1), 13, 2, 10, True, 10.0, deadband=0.5)
    samples = [
        Sample(value, 0, struct.pack("<d", value), bytes(30))
        for value in (5.0, 5.25, float("nan"), 5.0)
    ]
    assert [item.look(sample) for sample in samples] == [True, False, True, True]


POSITION = ua.NodeId.from_string("ns=3;s=CncAxisList.X.PosDirect.ActPos")


async def read_past(client, served, ticks, points):
    """Read the first ticks of the session of one node for each continuation point."""
    clock = served.host.clock
    details = ua.ReadRawModifiedDetails()
    details.IsReadModified = False
    details.StartTime, details.EndTime = clock.time(0), clock.time(ticks - 1)
    params = ua.HistoryReadParameters()
    params.HistoryReadDetails = details
    for point in points:
        request = ua.HistoryReadValueId()
        request.NodeId, request.ContinuationPoint = POSITION, point
        params.NodesToRead.append(request)
    return await client.uaclient.history_read(params)


def test_an_answer_of_the_past_is_bounded_for_all_its_nodes(served):
    """As many values as the limit in one answer; the rest by continuation points."""

    async def work():
        await until(lambda: served.session.tick > 100)
        async with connected(served) as client:
            points, counts, answers = [None] * 3, [0] * 3, 0
            while any(one is not False for one in points):
                asked = [index for index, one in enumerate(points) if one is not False]
                found = await read_past(client, served, 80, [points[index] for index in asked])
                sizes = [len(one.HistoryData.DataValues) for one in found]
                assert sum(sizes) <= 100
                for index, one, size in zip(asked, found, sizes, strict=True):
                    assert one.StatusCode.is_good()
                    counts[index] += size
                    points[index] = one.ContinuationPoint or False
                answers += 1
            assert (counts, answers) == ([80] * 3, 3)
            with pytest.raises(ua.uaerrors.BadTooManyOperations):
                await read_past(client, served, 80, [None] * 6)
            params = ua.HistoryReadParameters()
            params.HistoryReadDetails = ua.ReadAtTimeDetails()
            start = served.host.clock.time(0)
            params.HistoryReadDetails.ReqTimes = [start + timedelta(seconds=1)] * 101
            request = ua.HistoryReadValueId()
            request.NodeId = POSITION
            params.NodesToRead = [request]
            (answer,) = await client.uaclient.history_read(params)
            assert answer.StatusCode.name == "BadTooManyOperations"
        await is_well(served)

    asyncio.run(work())


def test_a_write_comes_between_the_parts_of_a_long_past(served, monkeypatch):
    """The session runs the past again in parts; a write waits for one of them at most."""
    look, write_each, done = served.session.look, served.session.write_each, []

    def looked(first, end, *words):
        limit_s = time.monotonic() + 60
        while not done and not is_writing(served.host) and time.monotonic() < limit_s:
            time.sleep(0.001)
        done.append(end - first)
        return look(first, end, *words)

    def written(requests):
        done.append("write")
        return write_each(requests)

    monkeypatch.setattr(served.session, "look", looked)
    monkeypatch.setattr(served.session, "write_each", written)

    async def work():
        await until(lambda: served.session.tick > 100)
        async with connected(served) as client, connected(served) as other:
            node = other.get_node(f"{CHANNEL}.V.E.VALUE")
            await asyncio.gather(read_past(client, served, 100, [None]), node.write_value(0.0))

    asyncio.run(work())
    assert done.count(10) == 10
    assert done.index("write") <= 1


def test_who_has_written_reads_what_was_written(served):
    """A write is answered once a tick has latched it."""

    async def work():
        async with connected(served) as client:
            node = client.get_node(f"{CHANNEL}.V.E.VALUE")
            for value in (0.125, 0.25, 0.375, 0.5, 0.0):
                await node.write_value(value)
                assert await node.read_value() == value

    asyncio.run(work())


def test_values_cycles_and_channels_of_a_moment_are_of_one_tick(served, monkeypatch):
    """The session goes on while it is looked at; the moment is that of the look all the same."""
    host, state_view, looks = served.host, served.session.state_view, []

    def looked(*names):
        found = state_view(*names)
        limit_s = time.monotonic() + 60
        while host.store.tick < found.tick + 5 and time.monotonic() < limit_s:
            host.loop.call_soon_threadsafe(host.store.receive, later(found.tick + 5))
            time.sleep(0.001)
        looks.append((found, names))
        return found

    def later(tick):
        return replace(host.store.frame, tick=tick, values=dict.fromkeys(host.store.values, -1.0))

    async def moments():
        space = served.endpoint.space
        watched = [live for live in space.live.values() if live.needs_state_view or live.signal][
            :20
        ]
        watched += [live for live in space.live.values() if live.needs_state_view][:2]
        first = await space.watch(watched)
        second = await space.read(watched)
        for live in watched:
            space.unwatch(live)
        return first, second

    monkeypatch.setattr(served.session, "state_view", looked)
    found = asyncio.run_coroutine_threadsafe(moments(), host.loop).result(60)
    for moment in found:
        names, own = next((names, own) for own, names in looks if own is moment.state_view)
        assert moment.tick == own.tick
        assert moment.values == dict(zip(names, own.values, strict=True))
        assert moment.values


def test_wrong_passwords_lock_their_own_address_alone(tmp_path):
    """Ten wrong ones lock an address, of IPv6 its network; other clients notice nothing."""
    security = Security(tmp_path)
    password = (tmp_path / PASSWORD).read_text("utf-8").strip()
    for address in ("192.0.2.1", "2001:db8::1"):
        for _ in range(MAX_FAILURES):
            assert not security.is_user("operator", "wrong", address)
        assert not security.is_user("operator", password, address)
    for address in ("::ffff:192.0.2.1", "2001:db8::2"):
        assert not security.is_user("operator", password, address)
    for address in ("192.0.2.2", "2001:db8:0:1::1"):
        assert security.is_user("operator", password, address)


def test_what_the_session_tells_is_german_for_german_clients():
    """Kind and particulars in both languages."""
    reported = [
        notice_text(ServerNotice("ended", 1, "error")),
        notice_text(ServerNotice("stopped", 1, "V.E.COUNT > 3")),
        notice_text(ServerNotice("refused", 1, "no", text_de="nein")),
    ]
    assert [one.en for one in reported] == ["ended: error", "stopped: V.E.COUNT > 3", "refused: no"]
    assert [one.de for one in reported] == [
        "Ende: Fehler",
        "angehalten: V.E.COUNT > 3",
        "abgelehnt: nein",
    ]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_in_a_served_folder_is_refused(served):
    """Reading it would never end (901483); the session goes on."""
    os.mkfifo(served.folder / "pipe.nc")
    with pytest.raises(Failure) as caught:
        served.session.select(served.folder / "pipe.nc")
    assert caught.value.diagnostics[0].id == 901483
    asyncio.run(is_well(served))
