# SPDX-License-Identifier: MIT
"""ADS on the wire, without a socket: symbols, handles, sums, objects, variables (AD-1 … AD-6)."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable
from ipaddress import ip_network
from struct import pack, unpack, unpack_from

import pytest
from support.ads_wire import (
    CLIENT,
    Bench,
    bench,
    by_name,
    data_of,
    notification,
    number_of,
    read,
    read_write,
    request,
    result,
    write,
)
from support.insides import handles_of, kept_items

from nctakt.servers.address import is_within, read_network
from nctakt.servers.ads import clients, limits, notifications, symbols
from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import Command, Error, Group, State
from nctakt.servers.ads.data import Item, Leaf
from nctakt.servers.ads.frames import HEADER, FrameError, FrameReader, read_net_id, shown_net_id

VARIABLES, SIGNALS = 0x4040, 0x4043
DECODER = 0x122301


def with_bench(act: Callable[[Bench], Awaitable[None]], **words: object) -> list[str]:
    """Let something happen to a server; the lines of its log."""

    async def live() -> list[str]:
        async with bench(**words) as found:
            await act(found)
            return found.log

    return asyncio.run(live())


def test_frames_are_whole_however_the_bytes_come() -> None:
    """Cut at every place and joined as they like, the same bytes give the same frames (AD-1)."""
    frames = [read(0x4040, 8 * number, number, invoke=number) for number in range(5)]
    data = b"".join(frames)
    whole = list(FrameReader().feed(data))
    assert [one.invoke_id for one in whole] == list(range(5))
    for width in (1, 2, 7, 37, 38, 51):
        reader = FrameReader()
        pieces = [data[at : at + width] for at in range(0, len(data), width)]
        assert [one for piece in pieces for one in reader.feed(piece)] == whole
    assert whole[0].encode() == frames[0]


@pytest.mark.parametrize(
    "head",
    [
        pack("<HI", 1, 32),
        pack("<HI", 0, 31),
        pack("<HI", 0, 0xFFFFFFFF) + bytes(32),
        HEADER.pack(0, 32, CLIENT, 1, CLIENT, 1, 2, 4, 0xFFFFFFFF, 0, 1),
        HEADER.pack(0, 0x80000000, CLIENT, 1, CLIENT, 1, 2, 4, 0x80000000 - 32, 0, 1),
    ],
)
def test_bytes_that_are_no_frame_are_refused_by_their_head(head: bytes) -> None:
    """A length up to 2^32 is refused before anything is kept for it."""
    with pytest.raises(FrameError):
        list(FrameReader().feed(head))


def test_the_longest_frame_is_taken_and_one_byte_more_is_not() -> None:
    """The limit of a frame, and one beyond."""
    frame = write(0x4040, 0, bytes(100))
    assert len(list(FrameReader(len(frame)).feed(frame))) == 1
    with pytest.raises(FrameError):
        list(FrameReader(len(frame) - 1).feed(frame))


def test_net_ids_are_six_numbers() -> None:
    """A NetId as text and back; anything else is none."""
    assert shown_net_id(read_net_id("5.1.204.160.1.1") or b"") == "5.1.204.160.1.1"
    assert [read_net_id(text) for text in ("1.2.3.4.5", "1.2.3.4.5.256", "a", "")] == [None] * 4


def test_a_written_value_is_read_after_the_tick_that_latches_it() -> None:
    """What a client writes others see with the frame after its tick, and not before (RC-002)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        handle = number_of(await found.ask(one, wire, by_name("v.e.count")))
        get = read(Group.VALUE_BY_HANDLE, handle, 4)
        assert number_of(await found.ask(one, wire, get)) == 0
        put = write(Group.VALUE_BY_HANDLE, handle, pack("<I", 77))
        assert result(await found.ask(one, wire, put)) == 0
        assert number_of(await found.ask(one, wire, get)) == 0
        found.session.advance()
        await asyncio.sleep(0)
        assert number_of(await found.ask(one, wire, get)) == 77
        assert found.session.sources == ["ads 10.0.0.9.1.1:33000"]

    with_bench(act)


def test_handles_belong_to_connection_net_id_and_port() -> None:
    """Neither another connection nor another client of the same one can use a handle (0x710)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        other, other_wire = found.connect()
        handle = number_of(await found.ask(one, wire, by_name("V.E.COUNT")))
        get = read(Group.VALUE_BY_HANDLE, handle, 4)
        assert result(await found.ask(one, wire, get)) == 0
        assert result(await found.ask(other, other_wire, get)) == Error.SYMBOL
        neighbour = read(Group.VALUE_BY_HANDLE, handle, 4, source=33001)
        assert result(await found.ask(one, wire, neighbour)) == Error.SYMBOL
        release = write(Group.RELEASE_HANDLE, 0, pack("<I", handle))
        assert result(await found.ask(one, wire, release)) == 0
        assert result(await found.ask(one, wire, get)) == Error.SYMBOL
        assert result(await found.ask(one, wire, release)) == Error.SYMBOL

    with_bench(act)


MISTAKES = [
    (read(0x9999, 0, 4), Error.GROUP),
    (read(VARIABLES, 0xFFFFFFF0, 4), Error.OFFSET),
    (read(VARIABLES, 0, 3), Error.SIZE),
    (read(VARIABLES, 0, 0xFFFFFFFF), Error.SIZE),
    (read(VARIABLES, 0, 0), Error.SIZE),
    (request(Command.READ, b"short"), Error.SIZE),
    (request(Command.WRITE, b""), Error.SIZE),
    (by_name("V.E.NOTHING"), Error.SYMBOL),
    (write(SIGNALS, 0, bytes(8)), Error.ACCESS),
    (write(0x123301, 0x10B, bytes(1)), Error.ACCESS),
    (notification(VARIABLES, 0, 8, mode=9), Error.PARAMETER),
    (request(Command.DELETE_NOTIFICATION, pack("<I", 5)), Error.NOTIFICATION_HANDLE),
    (request(Command.WRITE_CONTROL, pack("<HHI", 15, 0, 0)), Error.PARAMETER),
    (request(Command.WRITE_CONTROL, pack("<HHI", State.STOP, 9, 0)), Error.PARAMETER),
    (request(Command.WRITE_CONTROL, pack("<HHI", State.LOAD, 9, 0)), Error.PARAMETER),
    (request(Command.WRITE_CONTROL, pack("<HHI", State.LOAD, 1, 9) + b"a.nc"), Error.SIZE),
    (read_write(Group.SUM_READ, 0xFFFFFFFF, 8, b""), Error.PARAMETER),
    (read_write(Group.SUM_READ, 2, 8, bytes(12)), Error.SIZE),
    (read_write(Group.SUM_WRITE, 1, 4, pack("<III", 0x4040, 0, 0xFFFFFFFF)), Error.SIZE),
    (read(0x123301, 0x99, 4), Error.OFFSET),
    (read(0x1233FF, 0, 4), Error.GROUP),
    (read_write(DECODER, 0x47, 8, pack("<II", 99999, 0)), Error.SYMBOL),
    (read_write(DECODER, 0x47, 8, pack("<II", 1, 0xFFFFFFFF)), Error.SIZE),
    (read_write(DECODER, 0x46, 4, b"V" * 300 + b"\0"), Error.SIZE),
    (request(99), Error.COMMAND_UNKNOWN),
    (read(VARIABLES, 0, 8, port=12345), Error.PORT_UNKNOWN),
]


def test_what_cannot_be_answered_has_its_error() -> None:
    """Each mistake has the number that TwinCAT's clients know (AD-1), and is in the log."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        for asked, error in MISTAKES:
            assert result(await found.ask(one, wire, asked)) == error, (asked, error)
            assert not wire.is_closed
            assert result(await found.ask(one, wire, read(VARIABLES, 0, 8))) == 0

    reasons = [json.loads(line).get("reason", "") for line in with_bench(act)]
    assert {f"{error:#x}" for _, error in MISTAKES} <= {one.split()[0] for one in reasons if one}


def test_an_error_of_our_own_has_an_answer_and_the_next_request_too() -> None:
    """No one waits forever, and no one is informed of success."""

    async def act(found: Bench) -> None:
        def fail(_: object) -> list[int]:
            raise RuntimeError("broken")

        one, wire = found.connect()
        found.session.write_each = fail  # type: ignore[assignment]
        answer = await found.ask(one, wire, write(VARIABLES, 0, bytes(8)))
        assert (answer.error, answer.data) == (Error.INTERNAL, b"")
        assert result(await found.ask(one, wire, read(VARIABLES, 0, 8))) == 0

    assert "request" in [json.loads(line)["event"] for line in with_bench(act)]


def test_who_is_not_permitted_gets_the_error_of_symbols_and_is_logged_once() -> None:
    """A NetId that is not in the list: 0x710, reported once (AD-6)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        for _ in range(3):
            answer = await found.ask(one, wire, read(VARIABLES, 0, 8))
            assert answer.error == Error.SYMBOL

    lines = [json.loads(line) for line in with_bench(act, permitted=[bytes(6)])]
    assert [one["client"] for one in lines if one["event"] == "refused"] == ["10.0.0.9.1.1:33000"]


def test_a_connection_from_elsewhere_ends_before_anything_is_read_whatever_its_net_id() -> None:
    """The address of the socket decides (10.0.0.9), not the NetId that a client states."""

    async def elsewhere(found: Bench) -> None:
        one, wire = found.connect()
        assert wire.is_closed
        one.data_received(read(VARIABLES, 0, 8))
        assert not wire.sent
        assert not found.endpoint.connections

    async def permitted(found: Bench) -> None:
        one, wire = found.connect()
        assert (await found.ask(one, wire, read(VARIABLES, 0, 8))).error == 0

    networks = [ip_network("10.0.0.0/29"), ip_network("::/0")]
    lines = [json.loads(line) for line in with_bench(elsewhere, networks=networks)]
    assert [one["client"] for one in lines if one["event"] == "refused"] == ["10.0.0.9"]
    with_bench(permitted, networks=[ip_network("10.0.0.8/29")])


@pytest.mark.parametrize(
    ("address", "is_in"),
    [
        ("10.0.0.9", True),
        ("::ffff:10.0.0.9", True),  # as reported by a socket of both families
        ("10.0.1.9", False),
        ("fe80::1%eth0", True),
        ("fe81::1", False),
        ("", False),
    ],
)
def test_addresses_lie_in_networks(address: str, is_in: bool) -> None:
    """Both families, and what sockets say of them."""
    networks = [read_network("--ads-from", text) for text in ("10.0.0.9", "fe80::/16")]
    assert is_within(address, networks) is is_in


def test_sum_commands_answer_each_part_and_write_into_one_tick() -> None:
    """Sum read, write and read-write: errors part by part, one input of the session (AD-6)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        info = data_of(
            await found.ask(one, wire, read_write(Group.INFO_BY_NAME, 0, 12, b"V.E.COUNT\0"))
        )
        group, count, _ = unpack("<III", info)
        flag = unpack_from(
            "<I",
            data_of(
                await found.ask(one, wire, read_write(Group.INFO_BY_NAME, 0, 12, b"V.E.FLAG\0"))
            ),
            4,
        )[0]
        parts = pack("<IIIIIIIII", group, count, 4, 0x9999, 0, 4, group, flag, 1)
        put = read_write(Group.SUM_WRITE, 3, 12, parts + pack("<II", 5, 0) + b"\1")
        answer = data_of(await found.ask(one, wire, put))
        assert unpack("<III", answer) == (0, Error.GROUP, 0)
        assert found.session.sources == ["ads 10.0.0.9.1.1:33000"]
        found.session.advance()
        await asyncio.sleep(0)
        get = read_write(Group.SUM_READ, 3, 21, parts)
        for _ in range(2):
            answer = data_of(await found.ask(one, wire, get))
            assert unpack("<IIIIIB", answer) == (0, Error.GROUP, 0, 5, 0, 1)
        good = pack("<IIIIII", group, count, 4, group, flag, 1)
        for _ in range(2):  # the second from what was worked out
            answer = data_of(await found.ask(one, wire, read_write(Group.SUM_READ, 2, 13, good)))
            assert unpack("<IIIB", answer) == (0, 0, 5, 1)
        extended = data_of(await found.ask(one, wire, read_write(Group.SUM_READ_EX, 3, 99, parts)))
        assert unpack("<IIIIIIIB", extended) == (0, 4, Error.GROUP, 0, 0, 1, 5, 1)
        names = [b"V.E.COUNT\0", b"nothing\0"]
        heads = b"".join(pack("<IIII", Group.HANDLE_BY_NAME, 0, 4, len(name)) for name in names)
        both = read_write(Group.SUM_READ_WRITE, 2, 99, heads + b"".join(names))
        answer = data_of(await found.ask(one, wire, both))
        assert unpack_from("<IIII", answer) == (0, 4, Error.SYMBOL, 0)

    with_bench(act)


def test_notifications_carry_the_time_of_their_tick_and_end_with_their_client() -> None:
    """Cyclic ones at their distance, the others on change; FILETIMEs by machine time (AD-3)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        info = await found.ask(one, wire, read_write(Group.INFO_BY_NAME, 0, 12, b"V.E.COUNT\0"))
        group, offset, size = unpack("<III", data_of(info))
        await found.ask(one, wire, read(group, offset, size))
        for mode, cycle in ((3, 100_000), (4, 0)):
            asked = notification(group, offset, size, mode, cycle)
            assert result(await found.ask(one, wire, asked)) == 0
        await asyncio.sleep(0.05)
        wire.answers()
        moments = []
        for tick in range(1, 41):
            found.session.written["V.E.COUNT"] = tick // 20
            found.session.advance()
            await asyncio.sleep(0)
            for frame in wire.answers():
                _, stamps, moment, samples, _, _, value = unpack_from("<IIQIIII", frame.data)
                assert (stamps, samples) == (1, 1)
                moments.append((tick, moment, value))
        cyclic = [one for one in moments if one[0] % 10 == 0]
        assert {tick for tick, _, _ in moments} == {10, 20, 30, 40}
        assert [value for tick, _, value in cyclic if tick == 20] == [1, 1]
        begin = moments[0][1] - 10 * 10_000
        assert all(moment - begin == tick * 10_000 for tick, moment, _ in moments)
        clock = found.host.clock  # FILETIME counts from 1601, which was 134,774 days before 1970
        assert begin // 10 == clock.unix_us(0) + 134_774 * 86_400 * 1_000_000
        assert len(found.endpoint.service.notifier) == 2
        one.connection_lost(None)
        assert len(found.endpoint.service.notifier) == 0
        found.session.advance(20)
        await asyncio.sleep(0)
        assert not wire.sent

    with_bench(act)


def test_objects_describe_themselves_to_who_knows_nothing() -> None:
    """Element 0 is the number of elements, its name that of the instance (AD-4)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()

        async def get(group: int, offset: int) -> bytes:
            return data_of(await found.ask(one, wire, read(group, offset, 255, port=553)))

        assert await get(0x123401, 0) == b"channel 1\0"
        names = []
        for group in found.endpoint.service.access.objects.groups():
            count = int.from_bytes(await get(group, 0), "little")
            names.append((await get(group + 0x100, 0))[:-1].decode())
            for element in range(1, count + 1):
                if result(await found.ask(one, wire, read(group, element, 255, port=553))):
                    continue  # a number without an element, or one that is refused
                size = int.from_bytes(await get(group + 0x300, element), "little")
                assert len(await get(group, element)) == size
                assert (await get(group + 0x200, element)).isascii()
                assert (await get(group + 0x500, element))[0] in (0, 1)
        assert names[:4] == [
            "position control",
            "interpolation 1",
            "decoder 1",
            "channel 1",
        ]
        assert await get(0x123401, 0x10000) == b"X\0"
        assert await get(0x123701, 0x10100) == b"0.1 um\0"
        ask = read_write(0x123901, 0x100, 8, pack("<II", 1, 2), port=553)
        assert unpack("<II", data_of(await found.ask(one, wire, ask))) == (0x123301, 0x20100)
        ask = read_write(0x123901, 0x100, 8, pack("<II", 9, 2), port=553)
        assert unpack("<II", data_of(await found.ask(one, wire, ask))) == (0, 0)
        assert await get(0x120200, 0x10002) == await get(0x123301, 0x10100)
        assert await get(0x20200, 0x10002) == await get(0x120201, 2)

    with_bench(act)


def test_variables_of_the_decoder_class_by_name_and_handle() -> None:
    """Number, description, handle, value, arrays as a whole, axis variables (AD-5)."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()

        async def ask(offset: int, data: bytes, size: int = 2048) -> bytes:
            asked = read_write(DECODER, offset, size, data, port=552)
            return data_of(await found.ask(one, wire, asked))

        count = int.from_bytes(await ask(0x44, b"V.E\0"), "little")
        names = []
        for index in range(count):
            described = await ask(0x45, pack("<I", index) + b"V.E\0")
            dimensions = unpack_from("<I", described, 16)[0]
            names.append(described[20 + 4 * dimensions : -1].decode())
        assert names[0] == "V.E.VALUE"
        assert "V.E.LEVEL_1_A[2].LEVEL_2_A[1].LIST" in names
        handle = int.from_bytes(await ask(0x46, b"V.E.LIST\0"), "little")
        assert unpack("<6I", await ask(0x4C, b"V.E.LIST\0")) == (handle, 8, 2, 8, 1, 10)
        put = write(DECODER, 0x49, pack("<IIId", handle, 1, 3, 2.5), port=552)
        assert result(await found.ask(one, wire, put)) == 0
        put = write(DECODER, 0x4A, b"V.E.LIST[4]\0" + pack("<d", 3.5), port=552)
        assert result(await found.ask(one, wire, put)) == 0
        found.session.advance()
        await asyncio.sleep(0)
        whole = unpack("<10d", await ask(0x47, pack("<II", handle, 0)))
        assert whole[3:5] == (2.5, 3.5)
        assert unpack("<d", await ask(0x48, b"V.E.LIST[3]\0")) == (2.5,)
        assert len(await ask(0x48, b"V.E.LIST\0")) == 80
        assert unpack("<d", await ask(0x10005, b"V.RTA.ACS.ACT_POS\0")) == (0.0,)
        put = write(DECODER, 0x10006, b"V.RTA.ACS.ACT_POS\0" + bytes(8), port=552)
        assert result(await found.ask(one, wire, put)) == Error.ACCESS
        for name in (b"V.P.NOTHING\0", b"V.A.ABS.X\0"):  # no program is open
            missing = read_write(DECODER, 0x48, 8, name, port=552)
            assert result(await found.ask(one, wire, missing)) == Error.SYMBOL
        assert int.from_bytes(await ask(0x44, b"V.A\0"), "little") > 10
        assert unpack("<5I", await ask(0x4C, b"V.A.ABS.X\0"))[1:] == (8, 1, 8, 0)

    with_bench(act)


def test_limits_hold_at_their_number(monkeypatch: pytest.MonkeyPatch) -> None:
    """Handles, notifications, clients of a connection, connections: the limit, and one more."""
    monkeypatch.setattr("nctakt.servers.ads.clients.MAX_HANDLES", 2)
    monkeypatch.setattr("nctakt.servers.ads.notifications.MAX_NOTIFICATIONS", 2)
    monkeypatch.setattr("nctakt.servers.ads.server.MAX_CLIENTS", 2)
    monkeypatch.setattr("nctakt.servers.ads.server.MAX_CONNECTIONS", 2)
    assert limits.MAX_HANDLES > 2

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        found.connect()
        _, refused = found.connect()
        assert refused.is_closed
        assert not wire.is_closed
        opened = [result(await found.ask(one, wire, by_name("V.E.COUNT"))) for _ in range(3)]
        assert opened == [0, 0, Error.NO_HANDLES]
        added = [
            result(await found.ask(one, wire, notification(VARIABLES, 0, 8))) for _ in range(3)
        ]
        assert added == [0, 0, Error.NO_HANDLES]
        asked = [read(VARIABLES, 0, 8, source=source) for source in (1, 2)]
        assert [result(await found.ask(one, wire, one_)) for one_ in asked] == [0, Error.BUSY]

    with_bench(act)


def test_a_newcomer_gets_a_notification_where_others_hold_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The oldest one of the connection with most of them goes, and its client is informed."""
    monkeypatch.setattr(notifications, "MAX_ALL_NOTIFICATIONS", 5)
    monkeypatch.setattr(clients, "MAX_CONNECTION_HANDLES", 2)

    async def act(found: Bench) -> None:
        greedy, its = found.connect()
        other, wire = found.connect()
        for source in (1, 1, 2, 2, 2):
            request = notification(VARIABLES, 0, 8, source=source)
            assert result(await found.ask(greedy, its, request)) == 0
        notifier = found.endpoint.service.notifier
        oldest = handles_of(notifier)[0]
        for _ in range(2):
            assert result(await found.ask(other, wire, notification(VARIABLES, 0, 8))) == 0
        assert result(await found.ask(other, wire, notification(VARIABLES, 0, 8))) == (
            Error.NO_HANDLES
        )
        assert len(notifier) == 5
        assert oldest not in handles_of(notifier)
        empty = pack("<II", oldest, 0)
        assert empty in bytes(its.sent)
        greedy.end("it goes")
        assert len(notifier) == 2
        opened = [result(await found.ask(other, wire, by_name("V.E.COUNT"))) for _ in range(3)]
        assert opened == [0, 0, Error.NO_HANDLES]

    with_bench(act)


def test_what_is_remembered_of_sum_commands_is_bounded() -> None:
    """The largest ones are remembered one at a time."""
    client = Client(CLIENT, 1, lambda _: None)
    leaf = Leaf("V.E.COUNT", "UNS08", 0, 1, is_writable=True)
    large = Item([leaf], 1)
    large.leaves = (leaf,) * 65_536
    for number in range(10):
        client.keep_plan(bytes((number,)), large)
        assert len(client.plans) <= 3
    assert bytes((9,)) in client.plans


def test_what_is_remembered_of_large_ranges_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ranges that are read once are forgotten: all together have this many values at most."""
    monkeypatch.setattr(symbols, "MAX_KEPT", 25)

    async def act(found: Bench) -> None:
        table = found.endpoint.service.access.symbols
        start = table.symbols["V.E.LIST"]
        for count in range(1, 11):
            item = table.item(start.group, start.offset, 8 * count)
            assert len(item.leaves) == count
            kept = kept_items(table)
            assert item in kept
            assert sum(len(one.leaves) for one in kept) <= 25

    with_bench(act)


def test_who_does_not_take_notifications_is_disconnected() -> None:
    """A client that reads nothing loses its connection, and no other one does."""

    async def act(found: Bench) -> None:
        slow, slow_wire = found.connect()
        quick, wire = found.connect()
        for connection, its in ((slow, slow_wire), (quick, wire)):
            await found.ask(connection, its, notification(VARIABLES, 0, 8, 3))
        slow_wire.unread = limits.MAX_UNREAD + 1
        found.session.advance()
        await asyncio.sleep(0.05)
        assert slow_wire.is_closed
        assert not wire.is_closed
        found.session.advance()
        await asyncio.sleep(0)
        assert wire.answers()
        quick.pause_writing()
        assert wire.is_paused
        quick.resume_writing()
        assert not wire.is_paused

    with_bench(act)


def test_values_that_nobody_reads_any_more_are_let_go(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading all there is once costs the session nothing forever; beyond a limit it is asked."""
    monkeypatch.setattr("nctakt.servers.store.MAX_BORROWED", 12)

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        store, access = found.host.store, found.endpoint.service.access
        (first,) = access.symbols.item(VARIABLES, 0, 8).names
        found.session.written[first] = 3.0
        assert data_of(await found.ask(one, wire, read(VARIABLES, 0, 8))) == pack("<d", 3)
        assert len(store.values) == 1
        await found.ask(one, wire, notification(VARIABLES, 0, 8, 3))
        for symbol in access.symbols.symbols.values():
            get = read(symbol.group, symbol.offset, symbol.type.size_bytes)
            assert result(await found.ask(one, wire, get)) == 0, symbol
        assert len(store.values) <= 12
        await access.release()
        await access.release()
        await asyncio.sleep(0)
        assert set(store.values) == {first}
        get = read_write(Group.VALUE_BY_NAME, 0, 80, b"V.E.LIST\0")
        assert data_of(await found.ask(one, wire, get)) == bytes(80)

    with_bench(act)
