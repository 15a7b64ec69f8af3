# SPDX-License-Identifier: MIT
"""M, H and T functions of the main program: when they are output, and when they are awaited.

The synchronisation type of the channel list decides (P-CHAN-00041, P-CHAN-00027, P-CHAN-00086). All
functions of a block for the same moment are output before any is awaited. Two types are awaited
after their block: MVS_SLM before the next motion with feed, MVS_SLP at ``#EXPL SYN``. Four types
go out before the path comes to their block (``kernel/tick/early_outputs.py``).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.commands import AwaitAcknowledge, Command, TechnologyOutput
from nctakt.decoder.values.variables import Values
from nctakt.hli.function_codes import code_of
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.messages.programs.checked_blocks import WORD_VALUE_OUT_OF_RANGE
from nctakt.nc.meaning.words import MAX_VALUE, MIN_VALUE
from nctakt.nc.tree import Word

#: The lead of a type that is output before the path reaches its block.
LEAD_KINDS = {
    "MEP_SVS": codes.LEAD_DISTANCE,
    "MEP_MOS": codes.LEAD_DISTANCE,
    "MET_SVS": codes.LEAD_TIME_TO_REST,
    "MET_MOS": codes.LEAD_TIME,
}
#: Types that are output before the motion of their block, and after it. A measuring
#: event is over with the motion at the latest.
_BEFORE = ("MOS", "MOS_TS", "MVS_SVS", "MVS_SNS", "MVS_SLM", "MVS_SLP", *LEAD_KINDS)
_AFTER = ("MNS_SNS", "MNE_SNS")
#: Types that are awaited before the motion of their block, and after it.
_AWAITED_BEFORE = ("MVS_SVS", "MEP_SVS", "MET_SVS")
_AWAITED_AFTER = ("MVS_SNS", "MNS_SNS", "MNE_SNS")
#: Types that are awaited, be it after their block.
AWAITED = frozenset((*_AWAITED_BEFORE, *_AWAITED_AFTER, "MVS_SLM", "MVS_SLP"))


def process_ticks(function: TechnologyFunction, cycle_time_us: int) -> int:
    """Return the duration of a function in ticks, rounded up (P-CHAN-00040, P-CHAN-00026)."""
    tenths = round(10 * function.process_time_us)
    return -(-tenths // (10 * cycle_time_us))


@dataclass(frozen=True, slots=True)
class BlockFunction:
    """A function of a block: its synchronisation type, and the commands that output and await
    it.
    """

    synchronisation: str
    output: Command
    wait: Command


def block_function(
    values: Values, word: Word, function: TechnologyFunction, extra: float | None, block: int
) -> BlockFunction:
    """Return the function of the word ``M110`` or ``M110=130``; ``extra`` is its value."""
    environment = values.environment
    plc_value = None if extra is None else _plc_value(values, word, function.number, extra)
    source = environment.source_id(word.span)
    code = code_of(word.name, function.number)
    ticks = process_ticks(function, environment.cycle_time_us)
    lead_kind = LEAD_KINDS.get(function.synchronisation, 0)
    output = TechnologyOutput(source, block, code, ticks, plc_value, function.lead, lead_kind)
    return BlockFunction(function.synchronisation, output, AwaitAcknowledge(source, block, code))


def tool_function(
    values: Values, span: Span, number: int, function: TechnologyFunction, block: int
) -> BlockFunction:
    """Return T as a function of its block (P-CHAN-00086)."""
    source = values.environment.source_id(span)
    code = code_of("T", number)
    output = TechnologyOutput(source, block, code, 0)
    return BlockFunction(function.synchronisation, output, AwaitAcknowledge(source, block, code))


def _plc_value(values: Values, word: Word, number: int, value: float) -> int:
    """Return the value that a function passes to the PLC, a signed 32-bit integer."""
    whole = int(arithmetic.round_half_even(value))
    if not MIN_VALUE <= whole <= MAX_VALUE:
        values.fail(
            WORD_VALUE_OUT_OF_RANGE,
            word.span,
            word=f"{word.name}{number}",
            value=whole,
            minimum=MIN_VALUE,
            maximum=MAX_VALUE,
        )
    return whole


class TechnologyOutputs:
    """The functions of one program, including those still to be awaited."""

    def __init__(self) -> None:
        self._late: dict[str, list[BlockFunction]] = {"MVS_SLM": [], "MVS_SLP": []}

    def before_motion(self, functions: Sequence[BlockFunction]) -> Iterator[Command]:
        """Yield the commands before the motion of the block."""
        for function in functions:
            if function.synchronisation in _BEFORE:
                yield function.output
            if function.synchronisation in self._late:
                self._late[function.synchronisation].append(function)
        yield from _awaits(functions, _AWAITED_BEFORE)

    def after_motion(self, functions: Sequence[BlockFunction]) -> Iterator[Command]:
        """Yield the commands after the motion of the block."""
        for function in functions:
            if function.synchronisation in _AFTER:
                yield function.output
        yield from _awaits(functions, _AWAITED_AFTER)

    @property
    def awaits_feed(self) -> bool:
        """Whether the next motion with feed must wait."""
        return bool(self._late["MVS_SLM"])

    def take_measuring(self, functions: list[BlockFunction]) -> BlockFunction | None:
        """Remove and return the function that is output at an edge."""
        for function in functions:
            if function.synchronisation == "MNE_SNS":
                functions.remove(function)
                return function
        return None

    def before_feed(self) -> Iterator[Command]:
        """Yield the waits of MVS_SLM before a motion with feed."""
        return self._settle("MVS_SLM")

    def explicit_synchronisation(self) -> Iterator[Command]:
        """Yield the waits of MVS_SLP at ``#EXPL SYN``."""
        return self._settle("MVS_SLP")

    def _settle(self, synchronisation: str) -> Iterator[Command]:
        """Yield the pending waits of a type."""
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
