# SPDX-License-Identifier: MIT
"""Truncated and bit-flipped frames, floods, clients that vanish: no other client suffers.

10^4 frames, ``NCTAKT_SEEDS=1000000`` makes 10^6.
"""

from __future__ import annotations

import asyncio
import random
from collections.abc import Iterator
from struct import pack

from support.ads_wire import (
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
from support.random_seeds import all_seeds

from nctakt.servers.ads.codes import Command, Group, State
from nctakt.servers.ads.frames import HEADER

#: Frames of a client's conversation between two looks at the other client.
STRETCH = 250


def conversation(handle: int) -> list[bytes]:
    """What a client with one handle says: each command, group and class of objects once."""
    parts = pack("<IIIIII", 0x4040, 0, 8, Group.VALUE_BY_HANDLE, handle, 4)
    names = b"".join(pack("<IIII", Group.HANDLE_BY_NAME, 0, 4, 9) for _ in range(2))
    return [
        request(Command.DEVICE_INFO),
        request(Command.READ_STATE, port=553),
        request(Command.WRITE_CONTROL, pack("<HHI", State.STOP, 1, 0), port=551),
        by_name("V.E.COUNT"),
        read(Group.VALUE_BY_HANDLE, handle, 4),
        write(Group.VALUE_BY_HANDLE, handle, pack("<I", 7)),
        read(Group.UPLOAD_INFO, 0, 8),
        read(Group.UPLOAD_INFO_2, 0, 24),
        read_write(Group.INFO_BY_NAME_EX, 0, 300, b"V.E.LIST\0"),
        read_write(Group.TYPE_BY_NAME, 0, 3000, b"LEVEL_1\0"),
        read_write(Group.VALUE_BY_NAME, 0, 300, b"V.E.TEXT\0"),
        read(0x4040, 0, 8),
        read(0x123301, 0x10100, 4, port=553),
        read(0x123401, 0, 99, port=553),
        read_write(0x123901, 0x100, 8, pack("<II", 1, 2), port=553),
        read(0x120201, 1, 4, port=553),
        read_write(0x122301, 0x45, 300, pack("<I", 3) + b"V.E\0", port=552),
        read_write(0x122301, 0x47, 300, pack("<III", 12, 1, 2), port=552),
        read_write(0x122301, 0x48, 300, b"V.E.LIST[3]\0", port=552),
        write(0x122301, 0x4A, b"V.E.LIST[3]\0" + bytes(8), port=552),
        read_write(Group.SUM_READ, 2, 20, parts),
        read_write(Group.SUM_READ_EX, 2, 99, parts),
        read_write(Group.SUM_WRITE, 2, 8, parts + bytes(12)),
        read_write(Group.SUM_READ_WRITE, 2, 99, names + b"V.E.SYNC\0V.E.FLAG\0"),
        notification(0x4040, 0, 8, 3, 20_000),
        notification(Group.VALUE_BY_HANDLE, handle, 4),
        request(Command.DELETE_NOTIFICATION, pack("<I", 1)),
        write(Group.RELEASE_HANDLE, 0, pack("<I", 0)),
    ]


def damaged(frames: list[bytes], rng: random.Random) -> bytes:
    """A frame that was cut, flipped, stretched, or has a number at a limit."""
    frame = bytearray(rng.choice(frames))
    match rng.randrange(5):
        case 0:
            del frame[rng.randrange(len(frame)) :]
        case 1:
            for _ in range(rng.randint(1, 4)):
                bit = rng.randrange(8 * len(frame))
                frame[bit // 8] ^= 1 << bit % 8
        case 2:
            at = rng.randrange(max(1, len(frame) - 4))
            frame[at : at + 4] = pack("<I", rng.choice((0, 1, 0x7FFFFFFF, 1 << 31, 0xFFFFFFFF)))
        case 3:
            frame += rng.choice(frames)[: rng.randrange(40)]
        case 4:  # the lengths of the frame are in order, those inside are not
            cut = HEADER.size + rng.randrange(len(frame) - HEADER.size + 1)
            body = bytes(frame[HEADER.size : cut])
            words = list(HEADER.unpack_from(frame))
            words[1], words[8] = 32 + len(body), len(body)
            frame = bytearray(HEADER.pack(*words) + body)
    return bytes(frame)


def test_damaged_frames_crash_nothing_and_hit_no_other_client() -> None:
    """Whatever a client sends, it is answered, refused or disconnected; the others continue."""
    seeds = all_seeds(4_000, 4_000)

    async def live() -> None:
        failures: list[object] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, one: failures.append(one))
        async with bench() as found:
            other, other_wire = found.connect()
            other_handle = number_of(await found.ask(other, other_wire, by_name("V.E.SHORT")))
            get = read(Group.VALUE_BY_HANDLE, other_handle, 2)
            assert result(await found.ask(other, other_wire, get)) == 0
            one, wire = found.connect()
            handle = number_of(await found.ask(one, wire, by_name("V.E.COUNT")))
            frames = conversation(handle)
            for frame in frames:
                assert result(await found.ask(one, wire, frame)) in (0, 0x710, 0x714), frame
            for number, seed in enumerate(seeds):
                one.data_received(damaged(frames, random.Random(seed)))
                if wire.is_closed:
                    one.connection_lost(None)
                    one, wire = found.connect()
                    handle = number_of(await found.ask(one, wire, by_name("V.E.COUNT")))
                    frames = conversation(handle)
                if number % STRETCH == 0:
                    found.session.advance()
                    await asyncio.sleep(0)
                    assert data_of(await found.ask(other, other_wire, get)) == bytes(2)
                    del wire.sent[:]
            one.connection_lost(None)
            await asyncio.sleep(0.05)
            assert data_of(await found.ask(other, other_wire, get)) == bytes(2)
            assert len(found.endpoint.connections) == 1
            assert len(found.endpoint.service.notifier) == 0
            assert len(found.log) < len(seeds) / 10
        assert failures == []

    asyncio.run(live())


def test_a_storm_of_connections_leaves_nothing_behind() -> None:
    """A thousand clients come, open handles and notifications, and vanish in a write."""

    async def live() -> None:
        failures: list[object] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, one: failures.append(one))
        async with bench() as found:
            info = read_write(Group.INFO_BY_NAME, 0, 12, b"V.E.COUNT\0")
            other, other_wire = found.connect()
            await found.ask(other, other_wire, info)
            for number in range(1000):
                one, _ = found.connect()
                one.data_received(by_name("V.E.COUNT") + notification(0x4040, 0, 8, 3))
                handle = 1 if number % 2 else 0xFFFFFFFF
                one.data_received(write(Group.VALUE_BY_HANDLE, handle, pack("<I", number)))
                one.data_received(write(0x4040, 0, bytes(8))[: 40 + number % 20])
                one.data_received(write(0x4040, 0, bytes(8)) if number % 3 else b"")
                one.connection_lost(None)
            await asyncio.sleep(0.05)
            assert result(await found.ask(other, other_wire, info)) == 0
            assert len(found.endpoint.connections) == 1
            assert len(found.endpoint.service.notifier) == 0
        assert failures == []

    asyncio.run(live())


def test_a_flood_of_requests_is_read_no_faster_than_it_can_be_answered() -> None:
    """With too many writes on their way nothing more is read; then it goes on."""

    async def live() -> None:
        async with bench() as found:
            one, wire = found.connect()
            for asked in floods():
                one.data_received(asked)
            assert wire.is_paused
            for _ in range(1000):
                await asyncio.sleep(0.001)
                if not wire.is_paused:
                    break
            assert not wire.is_paused
            assert len(wire.answers()) >= 50

    asyncio.run(live())


def floods() -> Iterator[bytes]:
    """Many writes at once."""
    for number in range(300):
        yield write(0x4040, 0, bytes(8), invoke=number)
