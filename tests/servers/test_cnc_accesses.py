# SPDX-License-Identifier: MIT
"""Each access that a public client library makes, or a help page names, on ADS (AD-4).

``cnc_accesses.tsv`` has them: by a symbol, by a name of the list, or at a port, group and offset.
"""

from __future__ import annotations

import asyncio
from pathlib import Path
from struct import unpack_from

from support.ads_wire import Bench, bench, by_name, data_of, number_of, read, result, write

from nctakt.servers.ads.codes import Group
from nctakt.servers.ads.objects import object_rows

ROOT = Path(__file__).parents[2]
RECORD = 84


def accesses() -> list[tuple[str, str, str, str, int]]:
    """The lines of the table."""
    lines = (Path(__file__).parent / "cnc_accesses.tsv").read_text("utf-8").splitlines()[2:]
    words = (line.split("\t") for line in lines)
    return [(by, group, offset, access, int(size)) for by, group, offset, access, size in words]


def documented() -> str:
    """The table of what is refused, in the documentation."""
    text = (ROOT / "docs" / "ads-objects.md").read_text("utf-8")
    return text.partition("| refused with 0x703 | why |")[2].partition("\n\n")[0]


def is_documented(name: str) -> bool:
    """Whether the documentation says why it is refused."""
    starts = [word[:-2] for word in documented().replace(",", " ").split() if word.endswith("…`")]
    return f"`{name}`" in documented() or f"`{name}".startswith(tuple(starts))


def test_the_documentation_names_what_is_refused_with_its_reason() -> None:
    lines = documented().splitlines()
    for row in object_rows():
        if row.refused:
            assert any(f"`{row.name}`" in one and row.refused in one for one in lines), row.name


async def listed(found: Bench) -> dict[str, tuple[int, int, int, bool]]:
    """Length, group, offset, whether it can be written, of each object by its name."""
    one, wire = found.connect()
    count = number_of(await found.ask(one, wire, read(0x130100, 0, 4, port=553)))
    data = data_of(await found.ask(one, wire, read(0x130100, 1, RECORD * count, port=553)))
    assert len(data) == RECORD * count
    objects = {}
    for at in range(0, len(data), RECORD):
        _, size, is_writable, _, group, offset = unpack_from("<IIHHII", data, at)
        name = data[at + 20 : at + 52].rstrip(b"\0").decode()
        assert name not in objects, name
        objects[name] = size, group, offset, bool(is_writable)
    return objects


def test_each_access_has_its_length_or_is_refused_by_name() -> None:
    """Reads and writes with zeros; what is refused is in docs/ads-objects.md."""
    names = {(row.class_, row.number): row for row in object_rows()}
    classes = {
        0x120100: ("platform", ""),
        0x120101: ("channel", "channel_axis"),
        0x120200: ("", "axis"),
        0x120300: ("", "position_axis"),
        0x121301: ("ipo", "ipo_axis"),
        0x123301: ("hld", ""),
    }

    async def live() -> None:
        async with bench() as found:
            one, wire = found.connect()
            objects = await listed(found)
            for by, group, offset, access, size in accesses():
                if by == "symbol":
                    handle = number_of(await found.ask(one, wire, by_name(group)))
                    where, length = (int(Group.VALUE_BY_HANDLE), handle), size
                    port = 851
                elif by == "name":
                    if group not in objects:
                        assert is_documented(group), group
                        continue
                    length, *rest = objects[group]
                    where, port = (int(rest[0]), int(rest[1])), 553
                    assert size in (0, length), group
                else:
                    where, length, port = (int(group, 16), int(offset, 16)), size, int(by)
                    axis, number = divmod(where[1], 0x10000)
                    row = names.get((classes[where[0]][axis > 0], number))
                    assert row is not None, (group, offset)
                    if row.refused:
                        assert result(await found.ask(one, wire, read(*where, 999, port=port)))
                        continue
                answer = await found.ask(one, wire, read(*where, length or 999, port=port))
                assert result(answer) == 0, (group, offset, hex(result(answer)))
                assert length in (0, len(data_of(answer))), (group, offset)
                if "w" in access and (length or by != "symbol"):
                    data = bytes(length or len(data_of(answer)))
                    if group == "mc_plco_move_path_file_name_w":  # which names a program
                        data = b"part.nc".ljust(length, b"\0")
                    put = write(*where, data, port=port)
                    assert result(await found.ask(one, wire, put)) == 0, (group, offset)

    asyncio.run(live())
