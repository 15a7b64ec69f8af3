# SPDX-License-Identifier: MIT
"""Orders of a client on ADS: block search, a program to work through, zero offsets (AD-4, AD-5)."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from struct import pack, unpack

import pytest
from support.ads_wire import Bench, bench, data_of, number_of, read, read_write, result, write

from nctakt.servers.ads.codes import Error

CHANNEL, DECODER = 0x120101, 0x122301


def with_bench(act: Callable[[Bench], Awaitable[None]]) -> None:
    """Run ``act`` with a server."""

    async def live() -> None:
        async with bench() as found:
            await act(found)

    asyncio.run(live())


@pytest.mark.parametrize("offset", ["w", "r"])
def test_block_search_is_ordered_by_the_numbers_of_the_controller(offset: str) -> None:
    """0x49 the kind, 0x5F the N number, 0x60 the pass; 0x61, 0x77, 0x78 show them."""
    numbers = {"w": (0x49, 0x5F, 0x60), "r": (0x61, 0x77, 0x78)}[offset]

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        for number, data in ((0x5F, pack("<I", 120)), (0x60, pack("<I", 3)), (0x49, pack("<H", 4))):
            put = write(CHANNEL, number, data, port=553)
            assert result(await found.ask(one, wire, put)) == 0
        found.session.advance()
        shown = []
        for number, size in zip(numbers, (2, 4, 4), strict=True):
            answer = await found.ask(one, wire, read(CHANNEL, number, size, port=553))
            shown.append(int.from_bytes(data_of(answer), "little"))
        assert shown == [4, 120, 3]
        assert found.session.written["HLI.SEARCH_TYPE"] == 4

    with_bench(act)


@pytest.mark.parametrize("kind", [1, 3, 5, 65535])
def test_a_search_that_is_not_simulated_is_refused(kind: int) -> None:
    """By the place in the file, by the block counter, to the program's end."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        put = write(CHANNEL, 0x49, pack("<H", kind), port=553)
        assert result(await found.ask(one, wire, put)) == Error.PARAMETER
        assert "HLI.SEARCH_TYPE" not in found.session.written
        assert any("902850" in line for line in found.log)

    with_bench(act)


def test_a_job_selects_its_program_and_starts_it() -> None:
    """Writing the name of its program triggers it; reset is triggered by any value."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        put = write(CHANNEL, 0x30F, b"part.nc\0", port=553)
        assert result(await found.ask(one, wire, put)) == 0
        assert found.session.selected == [("part.nc", 1)]
        assert found.session.written["HLI.START"] == 1
        put = write(CHANNEL, 0x311, bytes(4), port=553)
        assert result(await found.ask(one, wire, put)) == 0
        assert found.session.written["HLI.RESET"] == 1
        for name in (b"\0", b"x" * 257):
            put = write(CHANNEL, 0x30F, name, port=553)
            assert result(await found.ask(one, wire, put)) in (Error.PARAMETER, Error.SIZE)

    with_bench(act)


def test_zero_offsets_by_the_handle_of_the_decoder() -> None:
    """The handle of V.G.NP[1].V is the offset: an SGN32 of 0.1 µm for each axis of the channel."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()

        async def ask(offset: int, data: bytes, size: int = 64) -> bytes:
            asked = read_write(DECODER, offset, size, data, port=552)
            return data_of(await found.ask(one, wire, asked))

        handle = int.from_bytes(await ask(0x46, b"V.G.NP[1].V\0"), "little")
        put = write(DECODER, handle, pack("<4i", 125000, -1, 0, 7), port=552)
        assert result(await found.ask(one, wire, put)) == 0
        found.session.advance()
        for answer in (
            data_of(await found.ask(one, wire, read(DECODER, handle, 16, port=552))),
            await ask(0x47, pack("<II", handle, 0)),
            await ask(0x48, b"V.G.NP[1].V\0"),
        ):
            assert unpack("<4i", answer) == (125000, -1, 0, 7)
        assert unpack("<i", await ask(0x48, b"v.g.np[1].v.A\0")) == (7,)
        put = write(DECODER, 0x4A, b"V.G.NP[1].V.Y\0" + pack("<i", 30), port=552)
        assert result(await found.ask(one, wire, put)) == 0
        put = write(DECODER, 0x49, pack("<IIIi", handle, 1, 2, 44), port=552)
        assert result(await found.ask(one, wire, put)) == 0
        found.session.advance()
        assert unpack("<4i", await ask(0x48, b"V.G.NP[1].V\0")) == (125000, 30, 44, 7)
        assert unpack("<6I", await ask(0x4C, b"V.G.NP[1].V\0")) == (handle, 6, 2, 4, 1, 4)

    with_bench(act)


@pytest.mark.parametrize(
    ("request_", "code"),
    [
        (read_write(DECODER, 0x48, 64, b"V.G.NP[97].V\0", port=552), Error.SYMBOL),
        (read_write(DECODER, 0x48, 64, b"V.G.NP[1].V.Q\0", port=552), Error.SYMBOL),
        (read_write(DECODER, 0x47, 64, pack("<II", 0x4061, 0), port=552), Error.SYMBOL),
        (read_write(DECODER, 0x47, 64, pack("<III", 0x4001, 1, 4), port=552), Error.OFFSET),
        (read(DECODER, 0x4061, 16, port=552), Error.OFFSET),
        (read(DECODER, 0x4001, 8, port=552), Error.SIZE),
        (write(DECODER, 0x4001, bytes(20), port=552), Error.SIZE),
        (write(DECODER, 0x4001, bytes(3), port=552), Error.SIZE),
        (write(DECODER, 0x4001, b"", port=552), Error.SIZE),
    ],
)
def test_zero_offsets_that_are_not_there(request_: bytes, code: Error) -> None:
    """G54 … are 0 … 96; another axis, another length."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        assert result(await found.ask(one, wire, request_)) == code

    with_bench(act)


def test_the_tool_in_force_is_asked_of_the_session() -> None:
    """Interpolation, 0x1C: the latest T; 0 before the first block."""

    async def act(found: Bench) -> None:
        one, wire = found.connect()
        answer = await found.ask(one, wire, read(0x121301, 0x1C, 4, port=551))
        assert number_of(answer) == 0

    with_bench(act)
