# SPDX-License-Identifier: MIT
"""The words of a program's block: which exist, what may stand together (nc-programs, RC-403).

In: a block of the main program or a subprogram, not of a realtime cycle. Out: diagnostics. Behind
it each block is one that the decoder can run: axis words of the channel with a value, at most one
G function of a group, F, M and H functions of the channel list with constant numbers.
"""

from __future__ import annotations

from difflib import get_close_matches

from nctakt.lists.channel_configuration import ChannelParameters
from nctakt.nc import support
from nctakt.nc.check_values import ValueChecker
from nctakt.nc.findings import Findings
from nctakt.nc.support import Answer, Entry
from nctakt.nc.syntax import (
    AxisWord,
    Block,
    BlockWord,
    BracketCommand,
    Expression,
    Keyword,
    Number,
    StringWord,
    Word,
)

_NUMBERED = ("G", "M", "H")
#: M functions that end a subprogram.
_SUBPROGRAM_ENDS = (17, 29)


class WordChecker:
    """Checks blocks of one channel."""

    def __init__(
        self, channel: ChannelParameters, values: ValueChecker, findings: Findings
    ) -> None:
        self._channel = channel
        self._values = values
        self._findings = findings
        self.axes = tuple(axis.name for axis in channel.axes)
        self.spindles = tuple(spindle.name for spindle in channel.spindles)

    def block(self, block: Block, *, in_subprogram: bool = False) -> None:
        """One block; ``in_subprogram``: M17 and M29 end it."""
        self._values.line(*_expressions(block))
        if _dwell(block) is not None:
            self._dwell_block(block)
            return
        seen: dict[str, None] = {}
        groups: dict[str, str] = {}
        for word in block.words:
            match word:
                case AxisWord():
                    self._axis(word, seen)
                case Word():
                    self._word(word, seen, groups, in_subprogram)
                case BracketCommand():
                    self.bracket(word)
                case StringWord():
                    self._findings.answer(support.form('"NAME"'), word.span)
        self._exact_stop(block)

    # --- axes, feed ------------------------------------------------------------------------------

    def _axis(self, word: AxisWord, seen: dict[str, None]) -> None:
        if word.name not in self.axes:
            self.unknown(word)
        elif not self._needs_value(word):
            return
        elif self._once(word, word.name, seen) and word.value is not None:
            self._values.value(word.value)

    def unknown(self, word: BlockWord) -> None:
        """Report a word that is neither of the language nor an axis or spindle of the channel."""
        assert isinstance(word, AxisWord | Word | BracketCommand)
        names = [*self.axes, *self.spindles, "G", "M", "H", "F", "N"]
        near = get_close_matches(word.name, names, 1)
        self._findings.report(
            900203,
            word.span,
            word=self._findings.written(word.span),
            axes=", ".join(self.axes) or "–",
            nearest=near[0] if near else "–",
        )

    def _needs_value(self, word: AxisWord | Word) -> bool:
        if word.value is not None:
            return True
        self._findings.report(900208, word.span, word=word.name)
        return False

    def _once(self, word: BlockWord, name: str, seen: dict[str, None]) -> bool:
        if name in seen:
            self._findings.report(900209, word.span, word=name)
            return False
        seen[name] = None
        return True

    def _word(
        self,
        word: Word,
        seen: dict[str, None],
        groups: dict[str, str],
        in_subprogram: bool,
    ) -> None:
        if word.name in _NUMBERED:
            self._numbered(word, groups, in_subprogram)
            return
        entry = support.answer_word(word.name)
        if word.name in self.spindles:
            entry = support.answer_word("S")
        if entry is None:
            self.unknown(word)
        elif entry.answer is not Answer.SIMULATED:
            self._findings.answer(entry, word.span, self._findings.written(word.span))
        elif self._needs_value(word) and self._once(word, word.name, seen):
            assert word.value is not None
            self._values.value(word.value)

    # --- G, M, H ---------------------------------------------------------------------------------

    def number(self, word: Word) -> int | None:
        """The number of a G, M or H function, or the report why there is none."""
        value = word.value
        if value is None:
            self._needs_value(word)
        elif not isinstance(value, Number):
            written = self._findings.written(word.span)
            self._findings.answer(support.form("M[P1]"), word.span, written)
        elif not value.value.is_integer() or value.value < 0:
            self._findings.report(900204, word.span, word=f"{word.name}{value.value:g}")
        else:
            return int(value.value)
        return None

    def _numbered(self, word: Word, groups: dict[str, str], in_subprogram: bool) -> None:
        number = self.number(word)
        if number is None:
            return
        if word.name == "G":
            self._g(word, number, groups)
        elif word.name == "M" and number in _SUBPROGRAM_ENDS and in_subprogram:
            return
        else:
            self._technology(word, number)

    def _g(self, word: Word, number: int, groups: dict[str, str]) -> None:
        entry = support.answer_g(number)
        if entry is None:
            self._findings.report(900204, word.span, word=f"G{number}")
            return
        self._findings.answer(entry, word.span)
        if entry.answer is Answer.REFUSED:
            return
        if word.additional is not None or word.arguments:
            self._findings.report(900212, word.span, word=entry.name)
        if entry.group:
            other = groups.setdefault(entry.group, entry.name)
            if other != entry.name:
                self._findings.report(900210, word.span, word=entry.name, other=other)

    def _technology(self, word: Word, number: int) -> None:
        entry = self._technology_entry(word.name, number)
        name = f"{word.name}{number:02}"
        if entry is None:
            key = f"{word.name.lower()}_synch[{number}]"
            self._findings.report(900205, word.span, word=name, key=key)
        elif word.additional is not None or word.arguments:
            written = self._findings.written(word.span)
            self._findings.answer(support.form("M110=130"), word.span, written)
        else:
            self._findings.answer(entry, word.span, name)

    def _technology_entry(self, letter: str, number: int) -> Entry | None:
        if letter == "H":
            return support.answer_h(number, self._channel.h_functions)
        if number == 6 and self._channel.implicit_programs.m6:
            return support.answer_word("L")
        return support.answer_m(number, self._channel.m_functions)

    # --- other words -----------------------------------------------------------------------------

    def bracket(self, command: BracketCommand) -> None:
        """``X[INDP …]``, ``S2[…]``, ``M17[MAIN]``."""
        name = command.name
        if name in self.axes:
            single = any(isinstance(i, Keyword) and i.name == "INDP" for i in command.items)
            form = "X[INDP …]" if single else "X[…]"
            shown = f"{name}[INDP]" if single else f"{name}[…]"
        elif name in self.spindles:
            form, shown = "S2[…]", f"{name}[…]"
        elif name in ("M", "M17", "M29"):
            form, shown = "M17[…]", f"{name}[…]"
        else:
            self.unknown(command)
            return
        self._findings.answer(support.form(form), command.span, shown)

    def _exact_stop(self, block: Block) -> None:
        stop = next((word for word in block.words if _is_g(word, 60)), None)
        if stop is not None and not any(isinstance(word, AxisWord) for word in block.words):
            self._findings.report(20003, stop.span)

    def _dwell_block(self, block: Block) -> None:
        """``G04`` with its time: ``G04 X0.5``, ``G04 0.5``; revolutions are refused."""
        dwell = _dwell(block)
        assert dwell is not None
        others = [word for word in block.words if word is not dwell]
        times: list[Expression] = [] if dwell.additional is None else [dwell.additional]
        wrong = bool(dwell.arguments)
        for word in others:
            if isinstance(word, AxisWord) and word.name == "X" and word.value is not None:
                times.append(word.value)
            elif isinstance(word, Word) and word.name == "S" and len(others) == 1:
                self._findings.answer(support.form("G04 S"), dwell.span)
                return
            else:
                wrong = True
        if wrong or len(times) != 1:
            self._findings.report(900211, dwell.span)
        for time in times:
            self._values.value(time)


def _is_g(word: BlockWord, number: int) -> bool:
    return (
        isinstance(word, Word)
        and word.name == "G"
        and isinstance(word.value, Number)
        and word.value.value == number
    )


def _dwell(block: Block) -> Word | None:
    """The G04 of a block."""
    for word in block.words:
        if _is_g(word, 4):
            assert isinstance(word, Word)
            return word
    return None


def _expressions(block: Block) -> list[Expression]:
    """The values of a block's words."""
    found: list[Expression] = []
    for word in block.words:
        if isinstance(word, Word | AxisWord) and word.value is not None:
            found.append(word.value)
        if isinstance(word, Word) and word.additional is not None:
            found.append(word.additional)
    return found
