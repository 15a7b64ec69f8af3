# SPDX-License-Identifier: MIT
"""Sum commands: many requests in one, each with its own error (AD-3).

In: the number and the bytes of the parts. Out: the bytes of their answers. A command that only
reads symbols is prepared once for a client: the next sum command with the same bytes takes one step
for all parts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from struct import Struct
from typing import NamedTuple

from nctakt.servers.ads.access import Access
from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import AdsError, Error, Group
from nctakt.servers.ads.data import Item, Leaf, Readable
from nctakt.servers.ads.frames import Frame
from nctakt.servers.ads.limits import MAX_ANSWER, MAX_PARTS
from nctakt.servers.store import Scalar

_PART = Struct("<III")
_READ_WRITE_PART = Struct("<IIII")
_NUMBER = Struct("<I")
_RESULT = Struct("<II")
_NOTIFICATION_BYTES = 40


class Part(NamedTuple):
    """A part of a sum command: its address, the bytes that it wants, its data."""

    group: int
    offset: int
    size: int
    data: bytes = b""

    @classmethod
    def reads(cls, count: int, data: bytes) -> list[Part]:
        """Return the parts of a sum read; raises ``AdsError``."""
        _check(count, len(data) == count * _PART.size)
        parts = [cls(*words) for words in _PART.iter_unpack(data)]
        if sum(part.size for part in parts) + 8 * count > MAX_ANSWER:
            raise AdsError(Error.SIZE, "the answer would be too long")
        return parts

    @classmethod
    def writes(cls, count: int, data: bytes) -> list[Part]:
        """Return the parts of a sum write; raises ``AdsError``."""
        heads = count * _PART.size
        _check(count, len(data) >= heads)
        found, at = [], heads
        for group, offset, size in _PART.iter_unpack(data[:heads]):
            found.append(cls(group, offset, size, data[at : at + size]))
            at += size
        _check(count, at == len(data))
        return found

    @classmethod
    def read_writes(cls, count: int, data: bytes) -> list[Part]:
        """Return the parts of a sum read-write; raises ``AdsError``."""
        heads = count * _READ_WRITE_PART.size
        _check(count, len(data) >= heads)
        found, at = [], heads
        for group, offset, size, length in _READ_WRITE_PART.iter_unpack(data[:heads]):
            found.append(cls(group, offset, size, data[at : at + length]))
            at += length
        _check(count, at == len(data))
        if sum(part.size for part in found) + 8 * count > MAX_ANSWER:
            raise AdsError(Error.SIZE, "the answer would be too long")
        return found


def _check(count: int, is_whole: bool) -> None:
    if count > MAX_PARTS:
        raise AdsError(Error.PARAMETER, f"{count} parts, more than {MAX_PARTS}")
    if not is_whole:
        raise AdsError(Error.SIZE, f"the data of {count} parts is not whole")


def read_parts(access: Access, client: Client, group: int, count: int, data: bytes) -> bytes:
    """Return the answer to a sum read; raises ``AdsError`` and ``Missing``."""
    plan = client.plans.get(data) if group == Group.SUM_READ else None
    if plan is not None:
        return access.value(plan)
    parts = Part.reads(count, data)
    found: list[tuple[Error, Readable | None]] = []
    for part in parts:
        try:
            found.append((Error.NONE, access.resolve(client, *part[:3])))
        except AdsError as error:
            access.log_refusal(client, error)
            found.append((error.code, None))
    items = [item for _, item in found if item is not None]
    if group == Group.SUM_READ and len(items) == len(parts):
        plan = _joined(items, parts)
        if plan is not None:
            client.keep_plan(data, plan)
            return access.value(plan)
    access.check_present(name for item in items for name in item.names)
    values = [b"" if item is None else access.value(item) for _, item in found]
    if group == Group.SUM_READ:
        heads = [_NUMBER.pack(error) for error, _ in found]
        values = [one.ljust(part.size, b"\0") for one, part in zip(values, parts, strict=True)]
    else:
        heads = [
            _RESULT.pack(error, len(one)) for (error, _), one in zip(found, values, strict=True)
        ]
    return b"".join((*heads, *values))


def _joined(items: Sequence[Readable], parts: Sequence[Part]) -> Item | None:
    """Return one item for the answer to a sum read, if all parts are symbols."""
    leaves: list[Leaf] = []
    at = len(parts) * _NUMBER.size
    for item, part in zip(items, parts, strict=True):
        if not isinstance(item, Item):
            return None
        leaves += [replace(leaf, offset=at + leaf.offset) for leaf in item.leaves]
        at += part.size
    return Item(leaves, at) if leaves else None


async def write_parts(access: Access, client: Client, count: int, data: bytes) -> bytes:
    """Return the errors of a sum write, whose values are all latched by the same tick."""
    errors: list[Error] = []
    writes: list[dict[str, Scalar]] = []
    for part in Part.writes(count, data):
        try:
            decode = partial(access.decode, client, part.group, part.offset, part.data)
            writes.append(await access.present(decode))
            errors.append(Error.NONE)
        except AdsError as error:
            access.log_refusal(client, error)
            writes.append({})
            errors.append(error.code)
    together = {name: value for values in writes for name, value in values.items()}
    if together:
        refused = await access.write_values(client, together)
        if refused == Error.PARAMETER:  # one of them: each one separately shows which
            for index, values in enumerate(writes):
                if values:
                    errors[index] = await access.write_values(client, values)
        elif refused:
            errors = [
                refused if values else error for error, values in zip(errors, writes, strict=True)
            ]
    return b"".join(map(_NUMBER.pack, errors))


async def add_parts(
    access: Access, client: Client, frame: Frame, group: int, count: int, data: bytes
) -> bytes:
    """Return the answers to a sum command that adds or deletes notifications."""
    is_adding = group == Group.SUM_ADD_NOTIFICATION
    width = _NOTIFICATION_BYTES if is_adding else _NUMBER.size
    _check(count, len(data) == count * width)
    answers = []
    for at in range(0, len(data), width):
        part = data[at : at + width]
        try:
            if is_adding:
                answers.append(await access.present(partial(_added, access, client, frame, part)))
            else:
                access.notifier.delete(client, *_NUMBER.unpack(part))
                answers.append(_NUMBER.pack(0))
        except AdsError as error:
            access.log_refusal(client, error)
            answers.append(_RESULT.pack(error.code, 0) if is_adding else _NUMBER.pack(error.code))
    return b"".join(answers)


def _added(access: Access, client: Client, frame: Frame, part: bytes) -> bytes:
    handle = access.notify(client, frame, part)
    return _RESULT.pack(0, handle)
