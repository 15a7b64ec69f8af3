# SPDX-License-Identifier: MIT
"""M and H functions of the main program: when they go out, and for what the program waits.

The synchronisation type of the channel list (P-CHAN-00041, P-CHAN-00027) decides. All functions of
a block that go out at the same moment do so before anything is waited for. Two types wait later
than their block: MVS_SLM before the next motion with feed, MVS_SLP at ``#EXPL SYN``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.commands import Command
from nctakt.lists.declared.technology_functions import TechnologyFunction

#: Types that go out before the motion of their block, and those that do so behind it. A measuring
#: event is over with the motion at the latest.
_BEFORE = ("MOS", "MOS_TS", "MVS_SVS", "MVS_SNS", "MVS_SLM", "MVS_SLP")
_AFTER = ("MNS_SNS", "MNE_SNS")
#: Types that are waited for before the motion of their block, and behind it.
_AWAITED_BEFORE = ("MVS_SVS",)
_AWAITED_AFTER = ("MVS_SNS", "MNS_SNS", "MNE_SNS")


def process_ticks(function: TechnologyFunction, cycle_time_us: int) -> int:
    """Ticks that a function takes (P-CHAN-00040, P-CHAN-00026), a begun one is a whole one."""
    tenths = round(10 * function.process_time_us)
    return -(-tenths // (10 * cycle_time_us))


@dataclass(frozen=True, slots=True)
class BlockFunction:
    """A function of a block: when it goes out and is waited for, and the commands of both."""

    synchronisation: str
    output: Command
    wait: Command


class TechnologyOutputs:
    """The functions of one program, with those that are still to be waited for."""

    def __init__(self) -> None:
        self._late: dict[str, list[BlockFunction]] = {"MVS_SLM": [], "MVS_SLP": []}

    def before_motion(self, functions: Sequence[BlockFunction]) -> Iterator[Command]:
        """What happens before the motion of the block with these functions."""
        for function in functions:
            if function.synchronisation in _BEFORE:
                yield function.output
            if function.synchronisation in self._late:
                self._late[function.synchronisation].append(function)
        yield from _awaits(functions, _AWAITED_BEFORE)

    def after_motion(self, functions: Sequence[BlockFunction]) -> Iterator[Command]:
        """What happens behind the motion of the block."""
        for function in functions:
            if function.synchronisation in _AFTER:
                yield function.output
        yield from _awaits(functions, _AWAITED_AFTER)

    @property
    def awaits_feed(self) -> bool:
        """Whether the next motion with feed waits for something."""
        return bool(self._late["MVS_SLM"])

    def take_measuring(self, functions: list[BlockFunction]) -> BlockFunction | None:
        """The function that goes out where an edge is found, taken away from the others."""
        for function in functions:
            if function.synchronisation == "MNE_SNS":
                functions.remove(function)
                return function
        return None

    def before_feed(self) -> Iterator[Command]:
        """A motion with feed begins: MVS_SLM is due."""
        return self._settle("MVS_SLM")

    def explicit_synchronisation(self) -> Iterator[Command]:
        """``#EXPL SYN``: MVS_SLP is due."""
        return self._settle("MVS_SLP")

    def _settle(self, synchronisation: str) -> Iterator[Command]:
        """Wait for what went out under a type that waits late."""
        due = self._late[synchronisation]
        self._late[synchronisation] = []
        for function in due:
            yield function.wait


def _awaits(
    functions: Sequence[BlockFunction], synchronisations: Sequence[str]
) -> Iterator[Command]:
    for function in functions:
        if function.synchronisation in synchronisations:
            yield function.wait
