# SPDX-License-Identifier: MIT
"""``#MEAS``, and the words of measuring blocks (G100, G106).

In: the tree of a command or a block. Out: diagnostics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.messages.path.measuring import (
    CONTINUATION_WITHOUT_MEASURING,
    PROBE_CHOICE_WITHOUT_EFFECT,
)
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS, INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item
from nctakt.nc.meaning.path import Form
from nctakt.nc.meaning.words import MEASURING_MODE
from nctakt.nc.tree import (
    Block,
    Bracket,
    BracketCommand,
    Expression,
    HashCommand,
    Keyword,
    Number,
    Word,
)
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.functions import (
    ANY_ARCS,
    INTERRUPTIBLE,
    MEASURING,
    MEASURING_CONTINUES,
    THREADS,
)

#: Second words of ``#MEAS`` that are used alone.
_ALONE = ("DEFAULT", "PREPARE")
#: Sources and edges of the signal (P-AXIS-00516, P-AXIS-00518).
_SIGNALS = (
    "DRIVE_TYPE_DEFAULT",
    "PLC",
    "FIXED_STOP",
    "DRIVE",
    "PLC_EXT_LATCH_CONTROL",
    "PLC_FIRST_EVENT",
    "PLC_TIMESTAMP",
    "EXT_PROBE_WITH_DRIVE",
)
_EDGES = ("POS", "NEG")
_FORM = Form(
    numbers=("TYPE", "ERR_NO_SIGNAL", "SIMU_OFFSET", "AXNR", "INPUT"),
    names={"SIGNAL": _SIGNALS, "EDGE": _EDGES},
)
#: Keywords that choose among probes; there is only one.
_CHOICES = ("AX", "AXNR", "INPUT", "SIGNAL")


def check_meas(
    command: HashCommand, axes: Sequence[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check ``#MEAS``; return false for another command."""
    words = [word.name for word in command.words]
    if words[0] != "MEAS":
        return False
    arguments = command.arguments
    bracket = arguments[0] if len(arguments) == 1 else None
    items = bracket.items if isinstance(bracket, Bracket) else ()
    if words == MEASURING_MODE:
        is_right = not arguments or (len(items) == 1 and isinstance(items[0], Expression))
    elif len(words) == 1:
        is_right = bool(items)
    else:
        is_right = len(words) == 2 and words[1] in _ALONE and not arguments
    if not is_right:
        forms = forms_of("#MEAS")
        findings.report(
            INVALID_COMMAND_FORM, command.span, command="#" + " ".join(words), forms=forms
        )
        return True
    form = replace(_FORM, names={**_FORM.names, "AX": tuple(axes)})
    for item in items:
        if words == MEASURING_MODE:
            assert isinstance(item, Expression)
            values.value(item)
        else:
            check_item(form, "#MEAS", item, values, findings)
            if isinstance(item, Keyword) and item.name in _CHOICES:
                findings.report_each(PROBE_CHOICE_WITHOUT_EFFECT, item.span, word=item.name)
    return True


def check_measuring_block(block: Block, findings: Findings) -> None:
    """Report G106 without G100, and G100 or G310 with another motion than a line."""
    functions = {
        round(word.value.value): word
        for word in block.words
        if isinstance(word, Word) and word.name == "G" and isinstance(word.value, Number)
    }
    if MEASURING_CONTINUES in functions and MEASURING not in functions:
        span = functions[MEASURING_CONTINUES].span
        findings.report(CONTINUATION_WITHOUT_MEASURING, span)
    others: tuple[int, ...] = (*ANY_ARCS, *THREADS)
    for measuring in (MEASURING, INTERRUPTIBLE):
        for function in others if measuring in functions else ():
            if function in functions:
                span, word = functions[function].span, f"G{function:02}"
                findings.report(EXCLUSIVE_WORDS, span, word=word, other=f"G{measuring}")
        for stop in block.words if measuring in functions else ():
            if isinstance(stop, BracketCommand) and _is_fixed_stop(stop):
                written = f"{stop.name}[FIXED_STOP]"
                findings.report(EXCLUSIVE_WORDS, stop.span, word=written, other=f"G{measuring}")
        others = (*others, MEASURING)


def _is_fixed_stop(command: BracketCommand) -> bool:
    first = command.items[0] if command.items else None
    return isinstance(first, Keyword) and first.name == "FIXED_STOP"
